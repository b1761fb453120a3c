"""The plan for each equation of a scene of vectors: the one named there, else by the letters of its vectors, or by the
unit of μ. Names of vectors do not give links: P_1 of a truss is a load at a node."""

import re

from planes.scene import Scene
from planes.scene.vector_equations import VectorEquation
from planes.scene.vectors import Statement
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import kind_of
from planes.words.units import ALIKE

_LETTERS = {"contour": r"[rl]_", "velocity": "v_", "acceleration": "a_", "force": r"[FRGINTPQΦФ][_\d]"}


def plans_of_equations(scene: Scene, statement: Statement) -> dict[tuple[int, str], str]:
    """The plan of every equation, by its line and text. :class:`SceneError` where its vectors are of two kinds, or μ
    fits none of them."""
    asked = {v: k for k, v in ALIKE.items() if k in _LETTERS}.get(statement.quantity or "", statement.quantity)
    plans = {}
    for e in statement.equations:
        kind = _kind(scene, e) or asked or "vectors"
        plans[e.line, e.text] = _named(scene, e, kind) if e.plan else kind
    kinds = {kind_of(plan) for plan in plans.values()}
    if asked and asked not in kinds:
        equation = statement.equations[0]
        kind = ALIKE.get(kind := kind_of(plans[equation.line, equation.text]), kind)
        details = {"plan": Phrase(f"scale_{kind}"), "units": Phrase(f"units_{kind}")}
        raise SceneError(Phrase("vectors_mu", name=equation.names[0], **details), scene.file, scene.where.get(("mu",)))
    return plans


def _kind(scene: Scene, e: VectorEquation) -> str:
    """The plan that the letters of an equation show; "" where they show none."""
    first: dict[str, str] = {}
    for name in e.names:
        kind = next((kind for kind, letters in _LETTERS.items() if re.match(letters, name)), "")
        first.setdefault(kind, name)
    kinds = [kind for kind in first if kind]
    if len(kinds) > 1:
        one, other = kinds[:2]
        details = {k: Phrase(f"scale_{ALIKE.get(v, v)}") for k, v in (("one", one), ("other", other))}
        raise SceneError(
            Phrase("vectors_mixed", name=first[one], other_name=first[other], **details), scene.file, e.line
        )
    return kinds[0] if kinds else ""


def _named(scene: Scene, e: VectorEquation, kind: str) -> str:
    """The force plan that an equation names."""
    if kind != "force":
        raise SceneError(Phrase("equation_plan", plan=e.plan, text=e.text), scene.file, e.line)
    return e.plan
