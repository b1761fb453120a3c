"""The words of the steps of a scene of vectors: given, computed, divided, unknown."""

import math
from cmath import phase
from collections import defaultdict
from functools import partial

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Image, LayOff, Put, Similar, Step
from planes.drafting.steps.crossings import CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.lesson.rows import calculation_row
from planes.lesson.steps import StepWords, Words
from planes.plans import Plans
from planes.words import Phrase, Told, Written, sentence_table
from planes.words.names import name_without_plan
from planes.words.units import number_text


class StatedWords(StepWords):
    """Finds the words of the steps of one drawing of stated vectors."""

    def words_of_step(self, step: Step) -> Words:
        key, reason, names = self.words_by_kind(step)
        figure = self.plans.figure
        said = figure.said.get(step.makes) if figure else None
        if not figure or said is None:
            return key, reason, names
        strings = (x.name for x in figure.strokes if x.kind == "string" and x.end == step.makes)
        return said if f"lesson_{said}" in sentence_table("en") else key, said, {**names, "name": next(strings, "")}

    def words_by_kind(self, step: Step) -> Words:
        """The words of a step by its kind alone."""
        key, reason, names = super().words_of_step(step)
        if isinstance(step, Put):
            return key, "pole_stated", names
        if isinstance(step, CrossArc | CrossArcs):
            return ("arcs_stated" if key == "arcs" else key), f"{key}_stated", names
        return key, reason, names

    def action_words(self, direction: str) -> Told | Written:
        """A line of action; for a given angle the angle."""
        action = super().action_words(direction)
        if action:
            return action
        angle = round(math.degrees(phase(complex(self.drawing[direction]))), 1) + 0.0
        return Written(lambda lang: f"∠{number_text(angle, lang)}°")

    def similar_figure_words(self, step: Similar) -> Words:
        ratio = complex(self.drawing[step.ratio])
        turned = abs(ratio.imag) > 1e-9 * abs(ratio)
        first = name_without_plan(step.start)
        second = name_without_plan(step.end)
        size, angle = (abs(ratio), math.degrees(phase(ratio))) if turned else (ratio.real, 0.0)
        ratio_written, angle_written = (Written(partial(number_text, value)) for value in (size, angle))
        names = {"first": first, "second": second, "ratio": ratio_written, "angle": angle_written}
        return ("turned_stated" if turned else "similar_stated"), "alike_stated", names

    def image(self, step: Image) -> Words:
        vectors = {ends: f"⟨{n}⟩" for n, ends in self.plans.vectors.items()}
        names = {"start": name_without_plan(step.start), "own": vectors[step.of], "whole": vectors[step.like]}
        return (
            "image_stated",
            "alike_stated",
            {**names, "first": name_without_plan(step.image[0]), "second": name_without_plan(step.image[1])},
        )

    def direction_reason(self, term: Term, name: str, kind: str) -> Phrase:
        said = super().direction_reason(term, name, kind)
        line = self.plans.means[term.direction or ""].line_name
        known = kind != "force" and said.key in sentence_table("en") and not term.name.startswith(line)
        return said if known else Phrase("why_line", **said.parts)

    def lay_off_words(self, step: LayOff) -> Words:
        key, reason, names = super().lay_off_words(step)
        source = self.made.get(step.length)
        if isinstance(source, Measure):
            return "carried_stated", "reckoned", names
        if isinstance(source, Calculate):
            named = {**names, "rows": (calculation_row(source, self.laid_off_vector(step)),)}
            return "lay_off", reason if step.quantity_represented in ("normal", "coriolis") else "reckoned", named
        return key, "stated" if key == "given" else reason, names


def equations_by_last_mark(plans: Plans) -> dict[str, list[Equation]]:
    """The equations by the mark that completes all their unknowns on the paper."""
    order = {step.makes: k for k, step in enumerate(plans.program.steps)}
    solved_at = defaultdict[str, list[Equation]](list)
    for e in plans.equations:
        ends = {e.plan.mark(label) for t in e.all_terms for label in (t.start, t.end)} - {e.plan.pole}
        if ends and ends <= order.keys():
            solved_at[max(ends, key=order.__getitem__)].append(e)
    return solved_at
