"""Moment equations of a lesson in words: letters, numbers, and what comes out; terms that are nothing left out."""

from __future__ import annotations

import numpy

from planes.drafting.draft import Moments
from planes.drafting.drawing import Drawing
from planes.drafting.steps.reckoning import Calculate, Product
from planes.lesson.formulas import sides, unit, value
from planes.lesson.steps import Names
from planes.words import Lang, say
from planes.words.names import lettered

NOISE = 1e-9  # of the largest term: nothing


def moment_words(m: Moments, step: Calculate, cycle: Drawing) -> tuple[str, Names, tuple[str, ...]]:
    """The key of the sentence, what it says, and the forces it is about."""
    dropped = nothing(step, cycle)
    terms = tuple(name for i, (name, _) in enumerate(m.terms) if i not in dropped)
    names: Names = {"about": lettered(m.about), "links": lambda lang: _links(m, lang)}
    if len(dropped) == len(step.terms):
        force = step.means.of if step.means else m.unknown
        return "moments_none", {**names, "force": force}, (force,)
    # every term is divided by the arm of what is sought; a size that stands for a force has its name on this link
    over = next((name for name, power in step.terms[0].factors if power == -1), "")
    forces = {term.factors[0][0]: force for (force, _), term in zip(m.terms, step.terms, strict=False)}
    letters, numbers = sides(step, lambda name: forces.get(name, name), over, dropped)
    found, lead = f"⟨{m.unknown}⟩", f"; ⟨{m.unknown}⟩" if over else ""
    more: Names = {
        "head": f"{found} · ⟨{over}⟩" if over else found,
        "letters": letters,
        "numbers": numbers,
        "result": lambda lang: f"{lead} = {value(m.unknown)} {unit(m.unknown, lang)}",
    }
    return "moments", {**names, **more}, (*terms, m.unknown) if m.arm else terms


def nothing(step: Calculate, cycle: Drawing) -> frozenset[int]:
    """Which terms are nothing beside the largest, in every position."""
    sizes = [_largest(term, cycle) for term in step.terms]
    most = NOISE * max(sizes, default=0.0)
    return frozenset(i for i, size in enumerate(sizes) if size <= most)


def _largest(term: Product, cycle: Drawing) -> float:
    """How large a term becomes, but for what it is divided by."""
    above = [numpy.asarray(cycle[name], float) ** power for name, power in term.factors if power > 0]
    sizes = abs(term.coefficient * numpy.prod(numpy.broadcast_arrays(1.0, *above), axis=0))
    return float(numpy.max(sizes, initial=0.0, where=numpy.isfinite(sizes)))


def _links(m: Moments, lang: Lang) -> str:
    if m.links == ("lever",):
        return say("lesson_lever_of", lang)
    return say("lesson_link" if len(m.links) == 1 else "lesson_links", lang, links=", ".join(m.links))
