"""Moment equations of a lesson in words: letters, numbers, and what comes out; terms that are nothing left out."""

from __future__ import annotations

from typing import Any

from planes.drafting.draft import Moments
from planes.drafting.drawing import Drawing
from planes.drafting.steps.reckoning import Calculate
from planes.lesson.formulas import sides, unit, value
from planes.words import Lang, say
from planes.words.names import lettered

NOISE = 1e-9  # of the largest term: nothing


def moment_words(m: Moments, step: Calculate, cycle: Drawing) -> tuple[str, dict[str, Any], tuple[str, ...]]:
    """The key of the sentence, what it says, and the forces it is about."""
    dropped = nothing(step, cycle)
    terms = tuple(name for i, (name, _) in enumerate(m.terms) if i not in dropped)
    names: dict[str, Any] = {"about": lettered(m.about), "links": lambda lang: _links(m, lang)}
    if len(dropped) == len(step.terms):
        force = step.means.of if step.means else m.unknown
        return "moments_none", {**names, "force": force}, (force,)
    over = _over(step)
    forces = _named(m, step)

    def shown(name: str) -> str:
        return forces.get(name, name)

    letters, numbers = sides(step, shown, over, dropped)
    found = m.unknown
    head = f"⟨{found}⟩" + (f" · ⟨{over}⟩" if over else "")
    lead = f"; ⟨{found}⟩" if over else ""
    told = lambda lang: f"{lead} = {value(found)} {unit(found, lang)}"  # noqa: E731
    more = {"head": head, "letters": letters, "numbers": numbers, "result": told}
    own = (found,) if m.arm else ()
    return "moments", {**names, **more}, (*terms, *own)


def nothing(step: Calculate, cycle: Drawing) -> frozenset[int]:
    """Which terms are nothing beside the largest, in every position."""
    import numpy

    sizes = []
    for term in step.terms:
        product: Any = term.coefficient
        for name, power in term.factors:
            if power > 0:
                product = product * numpy.asarray(cycle[name], float) ** power
        held = numpy.abs(numpy.atleast_1d(product))
        held = held[numpy.isfinite(held)]
        sizes.append(float(held.max()) if len(held) else 0.0)
    largest = max(sizes, default=0.0)
    return frozenset(i for i, size in enumerate(sizes) if size <= NOISE * largest)


def _over(step: Calculate) -> str:
    """The value every term is divided by: the arm of what is sought."""
    for name, power in step.terms[0].factors:
        if power == -1:
            return name
    return ""


def _named(m: Moments, step: Calculate) -> dict[str, str]:
    """Sizes that stand for forces, by the name of the force on this link: |F_42| is F_24."""
    found = {}
    for (force, _), term in zip(m.terms, step.terms, strict=False):
        size = term.factors[0][0]
        found[size] = force
    return found


def _links(m: Moments, lang: Lang) -> str:
    if m.links == ("lever",):
        return say("lesson_lever_of", lang)
    return say("lesson_link" if len(m.links) == 1 else "lesson_links", lang, links=", ".join(m.links))
