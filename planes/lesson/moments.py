"""The words of a moment equation: its terms with their arms and numbers, without zero terms."""

import math
from functools import partial, reduce
from typing import Any

from planes.drafting.drawing import Drawing
from planes.drafting.equations import Moments
from planes.drafting.steps.reckoning import Calculate, Product
from planes.geometry.listed import Listed, greater_or_nan, map_elementwise
from planes.lesson.formulas import signed_moment_terms, value_slot
from planes.lesson.free_bodies import links_phrase
from planes.lesson.rows import Row
from planes.lesson.steps import Names
from planes.words import Phrase
from planes.words.names import NameTuple, name_without_plan, split_value_name

ZERO_TERM_SHARE = 1e-9  # of the largest term: below this it is zero
# always written without a sign; other magnitudes are in bars where a value has a sign
UNSIGNED_ARM_LETTERS = ("h", "H")


def moment_words(m: Moments, step: Calculate, cycle: Drawing) -> tuple[str, Names, NameTuple]:
    """The key of the sentence, its contents, and the forces in it."""
    dropped = vanishing_terms(step, cycle)
    terms = tuple(name for i, (name, _) in enumerate(m.terms) if i not in dropped)
    without = [
        f"⟨{name}⟩" for name, arm in m.terms if m.links != ("lever",) and passes_through_moment_point(arm, cycle)
    ]
    through = Phrase("lesson_through", forces=", ".join(without)) if without else ""
    links = Phrase("lesson_lever_of") if m.links == ("lever",) else links_phrase(m.links, ", ")
    names = {"about": name_without_plan(m.about), "links": links, "through": through}
    if len(dropped) == len(step.terms):
        force = step.means.of if step.means else m.unknown
        return "moments_none" if step.means else "moments_zero", {**names, "force": force}, (force,)
    # every term is divided by the arm of the unknown; a magnitude that stands for a force has its name on this link
    over = next((name for name, power in step.terms[0].factors if power == -1), "")
    forces = {term.factors[0][0]: force for (force, _), term in zip(m.terms, step.terms, strict=False)}

    def size(name: str) -> str:
        bar = (
            "∣"
            if split_value_name(name)[0] not in UNSIGNED_ARM_LETTERS and any(x < 0 for x in as_positions(cycle[name]))
            else ""
        )
        return f"{bar}⟨{forces.get(name, name)}⟩{bar}"

    reaction = m.unknown if over and over == m.arm else ""  # along the force; a couple counter-clockwise
    letters, numbers = signed_moment_terms(step, size, over, m.arm, dropped, reaction)
    head = f"⟨{m.unknown}⟩ · ⟨{over}⟩" if over else ""
    found_here = over if over in cycle.program.result_names else ""  # an arm that exists in every position
    row = Row(m.unknown, letters, numbers, value_slot(m.unknown, "a" if reaction else "v"), "moments", head, found_here)
    return "moments", {**names, "rows": (row,)}, (*terms, m.unknown) if m.arm else terms


def vanishing_terms(step: Calculate, cycle: Drawing) -> frozenset[int]:
    """The terms that vanish beside the largest, in every position."""
    sizes = [_term_magnitude(term, cycle) for term in step.terms]
    most = ZERO_TERM_SHARE * reduce(partial(map_elementwise, greater_or_nan), sizes, 0.0)
    return frozenset(i for i, size in enumerate(sizes) if as_positions((size <= most) | (most != most)).all())


def passes_through_moment_point(arm: str, cycle: Drawing) -> bool:
    """Whether a force passes through the moment point in every position: its arm is zero there."""
    known = [x for x in as_positions(abs(cycle[arm])) if math.isfinite(x)] if arm else []
    return bool(known) and max(known) <= ZERO_TERM_SHARE


def as_positions(thing: Any) -> Listed:
    """A value for many positions, from one of either shape."""
    return thing if isinstance(thing, Listed) else Listed([thing])


def _term_magnitude(term: Product, cycle: Drawing) -> Any:
    """The magnitude of a term, before its division."""
    return abs(math.prod((cycle[name] ** power for name, power in term.factors if power > 0), start=term.coefficient))
