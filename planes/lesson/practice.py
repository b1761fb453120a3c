"""Practice: what a reader draws and calculates in a lesson, and where each mistake of the catalogue puts a mark.

The variants of the catalogue are drawn on the lesson's tape, so a page knows their places for any given numbers.
"""

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import cached_property
from hashlib import sha256

from planes.check.grading.prepared_plan import known_plans
from planes.check.grading.variants import Variant
from planes.drafting.drawing import Drawing
from planes.drafting.steps import Image, LayOff, Similar, Turn
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Choose
from planes.drafting.tools import Env, Things
from planes.geometry.arrays import Floats
from planes.lesson.choices import CHOICE_KINDS, Choices
from planes.lesson.formulas import in_lesson_languages, sentence_in_lesson_languages
from planes.lesson.frame import CENTRES_CHAPTER, Frame
from planes.lesson.reckoning import displayed_name
from planes.lesson.scheme import moment_arms
from planes.words import Phrase, sentence_table
from planes.words.frozen import frozen
from planes.words.names import Mark, NamesByName, NameTriple, NumbersByName, letter_of
from planes.words.records import Json

Progress = Callable[[int, int], None]
LEAST_VECTOR_MM = 2.0  # shorter vectors are not asked for
LEAST_NONZERO_VALUE = 1e-7  # a smaller value is zero
SENTENCE_PLACEHOLDERS = [
    "mark",
    "line",
    "other",
    "value",
    "ratio",
    "start",
    "end",
    "guide",
    "normal",
    "force",
    "gap",
    "vector",
    "which",
]
VALUE_MISTAKE_SENTENCES = {
    m: f"mistake_{m}" for m in ("mm_for_value", "mu_inverted", "omega_without_mu_l", "sense_wrong")
}
SENSE_PREFIX = "↺"
MOMENT_LETTERS = ("M", "MI")
LENGTH_MISTAKE_SENTENCES = {m: f"lesson_{m}" for m in ("value_for_mm", "value_over_mu")}
"""Errors of calculation: in values, in lengths laid off."""
JUDGING_TOLERANCES: Json = {
    "fits_mm": 1.0,
    "fits_share": 0.01,
    "least_mm": 0.5,
    "number_share": 0.03,
    "ruler_mm": 0.5,
    "fresh": 0.12,
    "swing": 40.0,
    "draws": 200,
}
"""How answers are judged, in a page and where a code is read again: the tolerance of a mark, of its plan's size, but at
least that of a hand; of a number; of a ruler reading, which also sets the smallest plan. Then the range of fresh
numbers, and the attempts to draw them."""
CONSTRUCTED_STEP_TYPES = Cross | CrossArc | CrossArcs | Choose | Similar | Image


@frozen
class Practice(Choices):
    """The items of one lesson; ``values`` are its numbers by the names in slots."""

    given: Things
    values: NumbersByName
    spans: Mapping[str, NameTriple]

    def practice_items(self) -> list[Json]:
        """The questions, in the order of the lesson: choices (:class:`Choices`), the known data of an equation's
        vectors (``known``), a sense (``sense``), numbers (``number``), marks (``mark``)."""
        asked = set()
        items = []
        for k, f in enumerate(self.frames):
            for kind, name in self.questions_of_frame(f):
                question = kind, displayed_name(str(name))
                if question in asked:
                    continue
                asked.add(question)
                more = (
                    self.options_of_choice(kind, name, k)
                    if kind in CHOICE_KINDS
                    else self.number_question(str(name), kind)
                )
                if more is not None:
                    items.append({"frame": k, "kind": kind, "what": name, **more})
        return items

    def number_question(self, name: str, kind: str) -> Json:
        """The scale at which the number of a question is measured, and whether its sign is asked too."""
        own: Json = {"mu": self.scale_of_measured_number(name)} if kind == "number" else {}
        if own and letter_of(name) in MOMENT_LETTERS:
            return own | {"signed": True}
        return own

    def questions_of_frame(self, f: Frame) -> Iterator[tuple[str, str | int]]:
        """The kinds and names of the questions that a frame allows."""
        if f.chapter == CENTRES_CHAPTER:
            return
        if f.key == "free_body":
            yield "order", f.plan
            yield "reason", f.plan
        if f.equation is not None and f.plan == "velocity":
            yield "first", f.equation
        if f.equation is not None and f.plan != "position" and known_data_digits(self.equations[f.equation]):
            yield "known", f.equation
        mark = f.makes[0] if f.makes and f.key != "fixed" and self.can_be_drawn(f.makes[0]) else ""
        if f.turns and abs(self.values.get(f.turns["rate"], 0.0)) > LEAST_NONZERO_VALUE:
            yield "sense", f.turns["rate"]
        for how, name in f.numbers:
            given = {name, f"{name}_given"} & {*self.plans.given}
            if how in ("v", "a") and not given and abs(self.values.get(name, 0.0)) > LEAST_NONZERO_VALUE:
                yield "number", name
        if (
            f.moments is not None
            and (sense := f"{SENSE_PREFIX}{self.plans.moments[f.moments].unknown}") in self.turning
        ):
            yield "sense", sense
        if mark and f.plan in known_plans(self.plans) and f.plan.mu_name in self.given:
            yield "mu", f.plan
        if mark:
            yield "mark", mark

    @cached_property
    def turning(self) -> dict[str, Floats]:
        """The sense in which each tangential reaction turns its link about the moment point, if it does."""
        return {n: z for n, z in self.tangential_moments(self.drawing).items() if abs(z) > LEAST_NONZERO_VALUE}

    def tangential_moments(self, drawn: Drawing) -> Env:
        """The moments of tangential reactions on paper, in a drawing: plus is counter-clockwise."""
        senses = {}
        for moment, equation in zip(self.plans.moments, moment_arms(self.plans), strict=True):
            for f in equation["forces"]:
                if f["name"] == moment.unknown and f["foot"] is None and f["mark"] in drawn:
                    lever = drawn[f["mark"]] - drawn[equation["about"]]
                    senses[f"{SENSE_PREFIX}{f['name']}"] = (lever.conjugate() * drawn[f["along"]]).imag * drawn[
                        f["size"]
                    ]
        return senses

    def can_be_drawn(self, mark: Mark) -> bool:
        """Whether a reader can draw a mark."""
        step = self.plans.program.steps_by_result[mark]
        if isinstance(step, LayOff):
            return bool(abs(self.drawing[mark] - self.drawing[step.start]) >= LEAST_VECTOR_MM)
        return isinstance(step, CONSTRUCTED_STEP_TYPES)

    def scale_of_measured_number(self, name: str) -> str:
        """The scale of the plan that a number is measured on, "" for a computed one."""
        step = self.plans.program.steps_by_result.get(name)
        if name in self.spans:
            return self.spans[name][2]
        return getattr(step, "mu", None) or ""

    @property
    def practice_id(self) -> str:
        """Eight letters that distinguish this practice from those of other scenes."""
        free = sorted({*self.plans.given} - {*self.plans.reckoned})
        content = [(item["kind"], item["what"]) for item in self.practice_items()], free
        return sha256(repr(content).encode()).hexdigest()[:8]

    def named_directions(self) -> NamesByName:
        """Directions of the drawing for a set square, each with the line that names it."""
        lines_of_directions: NamesByName = {}
        for step in self.plans.program.steps:
            for name in (getattr(step, "along", ""), getattr(step, "across", "")):
                own = self.base_direction(name or "")
                means = self.plans.means.get(own)
                line = means and own in self.drawing and (means.line_name or means.written_action)
                if line and own not in lines_of_directions and line not in lines_of_directions.values():
                    lines_of_directions[own] = line
        return lines_of_directions

    def base_direction(self, direction: str) -> str:
        """The direction to which a perpendicular was drawn, or the direction itself."""
        step = self.plans.program.steps_by_result.get(direction)
        if isinstance(step, Turn) and step.quarter and not step.angle:
            return step.of
        return direction

    def mistake_at_mark(self, variant: Variant, mark: Mark) -> Json:
        """A mistake at a mark, with the names in the order of its sentence."""
        along = getattr(self.plans.program.steps_by_result[mark], "along", "")
        line = self.plans.means[along].line_name if along else ""
        names = {"mark": variant.blames, "line": line, **variant.about}
        parts = (names.get(part, "") for part in sentence_placeholders(f"mistake_{variant.mistake}"))
        names_said = [in_lesson_languages(p.told) if isinstance(p, Phrase) else str(p).lstrip("°") for p in parts]
        return {"m": variant.mistake, "at": mark, "names": names_said}


def mistake_sentences(slips: Sequence[Json]) -> Json:
    """The sentences of the possible mistakes, with placeholders for names, and the contents of these in order."""
    keys = {slip["m"]: f"mistake_{slip['m']}" for slip in slips} | VALUE_MISTAKE_SENTENCES | LENGTH_MISTAKE_SENTENCES
    places = {part: f"{{{part}}}" for part in SENTENCE_PLACEHOLDERS}
    return {
        m: {"said": sentence_in_lesson_languages(key, **places), "parts": sentence_placeholders(key)}
        for m, key in keys.items()
    }


def sentence_placeholders(key: str) -> list[str]:
    """The placeholders of a sentence."""
    used = set(re.findall(r"{(\w+)", sentence_table("en")[key]))
    return [part for part in SENTENCE_PLACEHOLDERS if part in used]


def known_data_digits(equation: Json) -> str:
    """The known data of each vector of an equation, a digit each, in the order of the terms; that of the sum if all
    else is known."""
    total = equation["total"]
    if not total:
        return ""
    terms = [t for side in equation["sides"] for t in side] + [total] * bool(total["known"])
    return "".join(str(t["known"]) for t in terms if t["action"] != "=0")


def revealed_values(frame: Frame) -> list[str]:
    """The values that a question about a number reveals: those of its sentence except its own, unless that is the only
    one."""
    values = sorted({*frame.needed_values})
    if len(values) == 1:
        return values
    return [n for n in values if n not in frame.terms[:1]]
