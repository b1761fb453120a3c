"""The plan for each equation of a scene of vectors: the one named there, else by the letters of its vectors, or by the
unit of μ. Names of vectors do not give links: P_1 of a truss is a load at a node."""

import re

from planes.scene import Scene
from planes.scene.vector_equations import VectorEquation
from planes.scene.vectors import Statement
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import NamesByName, PlanId
from planes.words.units import PLAN_WITH_SAME_UNIT

_VECTOR_LETTERS_BY_PLAN = {"contour": r"[rl]_", "velocity": "v_", "acceleration": "a_", "force": r"[FRGINTPQΦФ][_\d]"}


def plans_of_equations(scene: Scene, statement: Statement) -> dict[tuple[int, str], PlanId]:
    """The plan of every equation, by its line and text. :class:`SceneError` where its vectors are of two kinds, or μ
    fits none of them."""
    asked = {v: k for k, v in PLAN_WITH_SAME_UNIT.items() if k in _VECTOR_LETTERS_BY_PLAN}.get(
        statement.quantity or "", statement.quantity
    )
    plans = {}
    for e in statement.equations:
        kind = _plan_kind_of_equation(scene, e) or asked or "vectors"
        plans[e.line, e.text] = _named_force_plan(scene, e, kind) if e.plan else PlanId(kind)
    kinds = {plan.kind for plan in plans.values()}
    if asked and asked not in kinds:
        equation = statement.equations[0]
        kind = PLAN_WITH_SAME_UNIT.get(kind := plans[equation.line, equation.text].kind, kind)
        details = {"plan": Phrase(f"scale_{kind}"), "units": Phrase(f"units_{kind}")}
        raise SceneError(
            Phrase("vectors_mu", name=equation.vector_names[0], **details), scene.file, scene.where.get(("mu",))
        )
    return plans


def _plan_kind_of_equation(scene: Scene, e: VectorEquation) -> str:
    """The plan that the letters of an equation show; "" where they show none."""
    first: NamesByName = {}
    for name in e.vector_names:
        kind = next((kind for kind, letters in _VECTOR_LETTERS_BY_PLAN.items() if re.match(letters, name)), "")
        first.setdefault(kind, name)
    kinds = [kind for kind in first if kind]
    if len(kinds) > 1:
        one, other = kinds[:2]
        details = {k: Phrase(f"scale_{PLAN_WITH_SAME_UNIT.get(v, v)}") for k, v in (("one", one), ("other", other))}
        raise SceneError(
            Phrase("vectors_mixed", name=first[one], other_name=first[other], **details), scene.file, e.line
        )
    return kinds[0] if kinds else ""


def _named_force_plan(scene: Scene, e: VectorEquation, kind: str) -> PlanId:
    """The force plan that an equation names."""
    if kind != "force":
        raise SceneError(Phrase("equation_plan", plan=e.plan, text=e.text), scene.file, e.line)
    return e.plan
