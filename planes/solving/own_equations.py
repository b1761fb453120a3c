"""The user's vector equations for a mechanism, compared with its plans: their results, whether they close, and for one
that does not the simplest correction: a vector left out, a superfluous, reversed or exchanged one."""

import cmath
import math
from collections.abc import Iterable, Iterator, Mapping
from itertools import permutations
from typing import Any

from planes.drafting.drawing import Drawing
from planes.plans import Plans
from planes.plans.measuring import polar_json
from planes.scene.vector_equations import SideTerm, VectorEquation
from planes.words import Lang, Phrase, say
from planes.words.errors import SceneError, list_valid_choices
from planes.words.frozen import frozen
from planes.words.names import UNIT_OF_PLAN, Mark, NumbersByName, split_value_name
from planes.words.read_off import read_off_text
from planes.words.records import Json
from planes.words.units import number_text

CLOSED_GAP_RATIO = 1e-9  # of the largest vector: the gap below which an equation holds
# of velocity and acceleration equations: these vectors are most often forgotten
COMPONENT_LETTERS = ("n", "t", "k", "r")


@frozen
class OwnEquation:
    """One equation in one position: its result (``name`` and ``value``), or its ``gap`` with the ``change`` that would
    close it; ``unit`` is the key of both."""

    equation: VectorEquation
    unit: str
    name: str = ""
    value: complex = 0j
    gap: float = 0.0
    change: Phrase | None = None

    @property
    def is_closed(self) -> bool:
        """Whether it holds."""
        return bool(self.name) or self.gap == 0.0

    def sentence_in_language(self, lang: Lang) -> str:
        """The sentence about it, in a language."""
        unit = say(self.unit, lang)
        if self.name:
            angle = number_text(math.degrees(cmath.phase(self.value)), lang, 4)
            return say(
                "own_gives", lang, name=self.name, value=read_off_text(abs(self.value), lang), unit=unit, angle=angle
            )
        return self.closing_fault_in_words(lang) or say("own_closes", lang)

    def closing_fault_in_words(self, lang: Lang) -> str:
        """By how much it does not close, and why; "" where it does."""
        if self.is_closed:
            return ""
        gap = say("own_gap", lang, gap=read_off_text(self.gap, lang), unit=say(self.unit, lang))
        return f"{gap}: {self.change.told(lang)}" if self.change else gap

    def json(self) -> Json:
        """The equation as in the JSON."""
        own: Json = {"text": self.equation.text, "closes": self.is_closed}
        if self.name:
            return own | {"gives": {self.name: polar_json(self.value)}}
        return own | {"gap": self.gap, "change": self.change.told("en") if self.change else None}


def check_own_equations(
    plans: Plans, drawing: Drawing, scales: NumbersByName, equations: Iterable[VectorEquation], file: str
) -> Iterator[OwnEquation]:
    """Each equation, in the order of the file; the result of one is known to those after it. Raises :class:`SceneError`
    where a vector does not belong to the mechanism, or two vectors of an equation are unknown."""
    known = dict(mechanism_vectors(plans, drawing, scales))
    for equation in equations:
        terms = [(t.name, sign * t.times) for sign, side in _signed_side_terms(equation) for t in side]
        new = [name for name, _ in terms if name not in known]
        if len(new) > 1 or (new and len(terms) == 1):
            valid = list_valid_choices(new[-1], known)
            raise SceneError(Phrase("own_unknown", text=equation.text, name=new[-1], valid=valid), file, equation.line)
        unit = UNIT_OF_PLAN.get(plan_kind_of_vector(terms[0][0]), "N")
        if new:
            name = new[0]
            known[name] = -sum(k * known[n] for n, k in terms if n != name) / dict(terms)[name]
            yield OwnEquation(equation, unit, name, known[name])
        else:
            yield _checked_equation(equation, unit, terms, known)


def _signed_side_terms(equation: VectorEquation) -> Iterator[tuple[float, tuple[SideTerm, ...]]]:
    """Both outer sides; of a chain of equal sides the first minus the last."""
    yield 1.0, equation.sides[0]
    yield -1.0, equation.sides[-1]


def plan_kind_of_vector(name: str) -> str:
    """The plan that the letter of a vector shows."""
    return {"v": "velocity", "a": "acceleration"}.get(split_value_name(name)[0], "force")


def mechanism_vectors(plans: Plans, drawing: Drawing, scales: NumbersByName) -> Iterator[tuple[str, complex]]:
    """Every vector of the mechanism by name: of points, of one point relative to another, components as on its plans,
    forces on links, reactions from either side."""

    def between(start: str, end: Mark) -> complex:
        return complex(drawing[end] - drawing[start]) / scales[end.plan.mu_name]

    for letter, kind in (("v", "velocity"), ("a", "acceleration")):
        marks = ((p, getattr(m, kind)) for p, m in plans.points.items())
        there = {p: mark for p, mark in marks if mark in drawing}
        yield from ((f"{letter}_{p}{q}", between(there[q], there[p])) for p, q in permutations(there, 2))
        yield from ((f"{letter}_{p}", between(mark.plan.pole, mark)) for p, mark in there.items())
    for plan in (p for p in plans.plan_names if p.kind in ("velocity", "acceleration", "force")):
        for s in plans.segments_on(plan):
            if all(e in drawing for e in s.ends):
                yield s.name, between(*s.ends)
    for f in plans.acting.every:
        if f.size in drawing and f.along in drawing:
            yield f.name, float(drawing[f.size]) * complex(drawing[f.along])
    for r in (r for r in plans.reactions.values() if r.start in drawing and r.end in drawing):
        force = between(r.start, r.end)
        yield from ((name, force if name == r.key else -force) for name in r.both_reaction_names)


def _checked_equation(
    equation: VectorEquation, unit: str, terms: list[tuple[str, float]], known: Mapping[str, complex]
) -> OwnEquation:
    """An equation with known vectors only."""
    left = sum(k * known[n] for n, k in terms)
    most = max(abs(k * known[n]) for n, k in terms)
    if abs(left) <= CLOSED_GAP_RATIO * most:
        return OwnEquation(equation, unit)
    change = next(_closing_changes(terms, left, known, CLOSED_GAP_RATIO * most), None)
    return OwnEquation(equation, unit, gap=abs(left), change=change)


def _closing_changes(
    terms: list[tuple[str, float]], left: complex, known: Mapping[str, complex], slack: float
) -> Iterator[Phrase]:
    """Changes that would close an equation, the likeliest first."""
    there = dict(terms)
    kind = plan_kind_of_vector(terms[0][0])
    others = [n for n, z in known.items() if plan_kind_of_vector(n) == kind and n not in there and abs(z) > slack]
    others.sort(
        key=lambda n: (
            COMPONENT_LETTERS.index(split_value_name(n)[2])
            if split_value_name(n)[2] in COMPONENT_LETTERS
            else len(COMPONENT_LETTERS)
        )
    )
    missing = [n for n in others if min(abs(left + known[n]), abs(left - known[n])) <= slack]
    yield from (Phrase("own_missing", name=n) for n in missing if split_value_name(n)[2])
    for name, times in terms:
        if abs(left - 2 * times * known[name]) <= slack:
            yield Phrase("own_turned", name=name)
        if abs(left - times * known[name]) <= slack:
            yield Phrase("own_extra", name=name)
    pairs = sorted(((name, other) for name in there for other in others), key=lambda pair: _vector_unlikeness(*pair))
    for name, other in pairs:
        if abs(left - there[name] * (known[name] - known[other])) <= slack:
            yield Phrase("own_other", name=name, other=other)
    yield from (Phrase("own_missing", name=n) for n in missing)


def _vector_unlikeness(name: str, other: str) -> tuple[bool, int]:
    """How unlike two vectors are: an absolute and a relative one; points they do not share."""
    one = split_value_name(name)[1]
    two = split_value_name(other)[1]
    return len(one) != len(two), -len({*one} & {*two})


def own_equation_rows(p: Any, own: tuple[tuple[VectorEquation, ...], str], lang: Lang) -> list[tuple[str, str]]:
    """The equations of a scene, with its file, as rows of a table of a position: each with its sentence."""
    equations, file = own if "equations" in p.results else ((), "")
    return [
        (e.equation.text, e.sentence_in_language(lang))
        for e in check_own_equations(p.plans, p.drawing, p.scales, equations, file)
    ]
