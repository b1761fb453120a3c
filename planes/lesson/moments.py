"""The words of a moment equation: its terms with their arms and numbers, without zero terms."""

import math
from functools import partial, reduce
from typing import Any

from planes.drafting.drawing import Drawing
from planes.drafting.equations import Moments
from planes.drafting.steps.reckoning import Calculate, Product
from planes.geometry.listed import Listed, each, greater
from planes.lesson.formulas import by_sense, slot
from planes.lesson.free_bodies import links_told
from planes.lesson.rows import Row
from planes.lesson.steps import Names
from planes.words import Phrase
from planes.words.names import lettered, parts_of

NOISE = 1e-9  # of the largest term: below this it is zero
ARMS = ("h", "H")  # always written without a sign; other magnitudes are in bars where a value has a sign


def moment_words(m: Moments, step: Calculate, cycle: Drawing) -> tuple[str, Names, tuple[str, ...]]:
    """The key of the sentence, its contents, and the forces in it."""
    dropped = nothing(step, cycle)
    terms = tuple(name for i, (name, _) in enumerate(m.terms) if i not in dropped)
    without = [f"⟨{name}⟩" for name, arm in m.terms if m.links != ("lever",) and passes(arm, cycle)]
    through = Phrase("lesson_through", forces=", ".join(without)) if without else ""
    links = Phrase("lesson_lever_of") if m.links == ("lever",) else links_told(m.links, ", ")
    names = {"about": lettered(m.about), "links": links, "through": through}
    if len(dropped) == len(step.terms):
        force = step.means.of if step.means else m.unknown
        return "moments_none" if step.means else "moments_zero", {**names, "force": force}, (force,)
    # every term is divided by the arm of the unknown; a magnitude that stands for a force has its name on this link
    over = next((name for name, power in step.terms[0].factors if power == -1), "")
    forces = {term.factors[0][0]: force for (force, _), term in zip(m.terms, step.terms, strict=False)}

    def size(name: str) -> str:
        bar = "∣" if parts_of(name)[0] not in ARMS and any(x < 0 for x in many(cycle[name])) else ""
        return f"{bar}⟨{forces.get(name, name)}⟩{bar}"

    reaction = m.unknown if over and over == m.arm else ""  # along the force; a couple counter-clockwise
    letters, numbers = by_sense(step, size, over, m.arm, dropped, reaction)
    head = f"⟨{m.unknown}⟩ · ⟨{over}⟩" if over else ""
    found_here = over if over in cycle.program.made else ""  # an arm that exists in every position
    row = Row(m.unknown, letters, numbers, slot(m.unknown, "a" if reaction else "v"), "moments", head, found_here)
    return "moments", {**names, "rows": (row,)}, (*terms, m.unknown) if m.arm else terms


def nothing(step: Calculate, cycle: Drawing) -> frozenset[int]:
    """The terms that vanish beside the largest, in every position."""
    sizes = [_size(term, cycle) for term in step.terms]
    most = NOISE * reduce(partial(each, greater), sizes, 0.0)
    return frozenset(i for i, size in enumerate(sizes) if many((size <= most) | (most != most)).all())


def passes(arm: str, cycle: Drawing) -> bool:
    """Whether a force passes through the moment point in every position: its arm is zero there."""
    known = [x for x in many(abs(cycle[arm])) if math.isfinite(x)] if arm else []
    return bool(known) and max(known) <= NOISE


def many(thing: Any) -> Listed:
    """A value for many positions, from one of either shape."""
    return thing if isinstance(thing, Listed) else Listed([thing])


def _size(term: Product, cycle: Drawing) -> Any:
    """The magnitude of a term, before its division."""
    return abs(math.prod((cycle[name] ** power for name, power in term.factors if power > 0), start=term.coefficient))
