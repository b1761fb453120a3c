"""The choices in practice: a plan's scale, the group that comes next for forces and why, the equation written first.

A choice is data: the options, each with the reason why it is wrong, or none if it is right; a scale is judged by the
size of the plan.
"""

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from planes.drafting.drawing import Drawing
from planes.drafting.steps import LayOff
from planes.lesson.formulas import LESSON_LANGS, in_brackets, in_lesson_languages, sentence_in_lesson_languages
from planes.lesson.frame import Frame
from planes.lesson.free_bodies import FreeBodies, links_phrase
from planes.plans import Plans
from planes.plans.scales import largest_fitting_scale
from planes.words.frozen import frozen
from planes.words.names import UNIT_OF_PLAN, VELOCITY_PLAN, Mark, NumbersByName, PlanId
from planes.words.records import Json

CHOICE_KINDS = ("mu", "order", "reason", "first")
OFFERED_SCALE_RATIOS = (0.1, 0.4, 1.0, 2.5, 10.0)
"""The scales offered, relative to that of the lesson: too large and too small both ways, and acceptable ones."""
MOST_LATER_EQUATIONS = 2  # equations of later groups offered beside the current one
FIRST_GROUP_REASONS = ("last", "driver", "moved", "heavy")
"""Reasons why a group comes first for forces: the first is right."""


@frozen
class Choices:
    """The choices of one lesson; ``fit_mm`` is the size of each kind of plan on the paper."""

    plans: Plans
    drawing: Drawing
    frames: Sequence[Frame]
    equations: Sequence[Json]
    fit_mm: NumbersByName

    def options_of_choice(self, kind: str, what: Any, frame: int) -> Json | None:
        """The options of a choice, by its kind; None where there is nothing to choose."""
        if kind == "mu":
            return self.scale_options(what, self.frames[frame])
        if not self.plans.has_mechanism:
            return None
        if kind == "first":
            return self.first_equation_options(what, frame)
        if kind == "order":
            return self.link_order_options(what)
        return self.first_link_reason_options(what)

    def scale_options(self, plan: PlanId, frame: Frame) -> Json | None:
        """Scales of the standard series about that of the lesson, the marks that give the size of the plan, and the
        vector laid off first; None where no given length leads to the first mark asked for."""
        first = self.plans.program.steps_by_result[frame.makes[0]]
        long = (getattr(first, "length", "") or getattr(first, "radius", "")) if plan == "position" else ""
        if not long and not isinstance(first, LayOff):
            return None
        own = complex(self.drawing[plan.mu_name]).real
        offered = sorted({largest_fitting_scale(plan, 1.0, own * times) for times in OFFERED_SCALE_RATIOS})
        others = {plan.pole, *self.plans.program.trial_marks}
        shown = [
            s.makes
            for s in self.plans.program.mark_steps_by_plan[plan]
            if not s.is_outside_plan and s.makes not in others
        ]
        kind = plan.kind
        return {
            "offered": [{"value": mu} for mu in offered],
            "marks": shown,
            "most": self.fit_mm[kind],
            "name": long or next(iter(frame.terms), first.label),
            "unit": sentence_in_lesson_languages(UNIT_OF_PLAN.get(kind, "one_unit")),
        }

    @cached_property
    def reactions_awaited(self) -> dict[PlanId, dict[str, set[str]]]:
        """By force plan the plans it waits for, and the reactions that each of them gives."""
        bodies = FreeBodies(self.plans, self.drawing)
        waits = {plan: dict[str, set[str]]() for plan in self.plans.force_plans}
        for plan, giving in waits.items():
            for f in bodies.known_forces(plan):
                for r in self.plans.reactions.values():
                    if f["name"] in r.both_reaction_names and r.plan != plan:
                        giving.setdefault(r.plan, set()).add(f["name"])
        return waits

    def link_order_options(self, plan: PlanId) -> Json | None:
        """The links whose forces are still unknown, where some of them must wait: a group of one polygon each."""
        driver = self.plans.structure.driver
        group_links = [set(g.all_links) for g in self.plans.structure.groups]
        if any(p.links != (driver,) and set(p.links) not in group_links for p in self.plans.force_plans):
            return None
        left = self.plans.force_plans[self.plans.force_plans.index(plan) :]
        names = {p: sorted(n for q in left for n in self.reactions_awaited[p].get(q, ())) for p in left}
        if not any(names.values()):
            return None
        return {
            "offered": [
                {"value": p, "said": in_lesson_languages(links_phrase(p.links).told), **self.too_early_reason(names[p])}
                for p in sorted(left)
            ]
        }

    def too_early_reason(self, names: Sequence[str]) -> Json:
        """Why links come too early: forces on them are still unknown."""
        forces = in_brackets(names)
        if names:
            return {"why": sentence_in_lesson_languages("lesson_choice_early", forces=forces)}
        return {}

    def first_link_reason_options(self, plan: PlanId) -> Json | None:
        """Why the first links come first."""
        if plan != self.plans.force_plans[0] or not self.link_order_options(plan):
            return None
        why = {"why": sentence_in_lesson_languages("why_free_body_first")}
        wrong = dict.fromkeys(FIRST_GROUP_REASONS[1:], why)
        return {
            "offered": [
                {"value": key, "said": sentence_in_lesson_languages(f"lesson_choice_{key}"), **wrong.get(key, {})}
                for key in sorted(FIRST_GROUP_REASONS)
            ]
        }

    def first_equation_options(self, index: int, frame: int) -> Json | None:
        """Velocity equations; those that begin with a known vector can be written first."""
        own = [e for e in self.equations if e["plan"] == "velocity" and e["total"]]
        equation = self.equations[index]
        if equation not in own:
            return None
        made = {m for f in self.frames[:frame] for m in f.makes} | {VELOCITY_PLAN.pole}
        later = [e for e in own if self.equations.index(e) > index]
        offered = {text: self.unknown_vector_reason(term, made) for text, term in sums_of_equation(equation)}
        offered |= self.unlinked_point_option(equation, made)
        waiting = [
            (text, why)
            for e in later
            for text, term in sums_of_equation(e)[:1]
            if (why := self.unknown_vector_reason(term, made))
        ]
        offered |= dict(waiting[:MOST_LATER_EQUATIONS])
        if not any(offered.values()) or all(offered.values()):
            return None
        return {
            "offered": [{"value": t, "said": dict.fromkeys(LESSON_LANGS, t), **offered[t]} for t in sorted(offered)]
        }

    def unknown_vector_reason(self, term: Json, made: set[Mark]) -> Json:
        """Why an equation that begins with a vector cannot be written yet; empty where it can."""
        if term["action"] == "=0" or term["at"] in made:
            return {}
        return {"why": sentence_in_lesson_languages("lesson_choice_unknown", name=term["name"])}

    def unlinked_point_option(self, equation: Json, made: set[Mark]) -> dict[str, Json]:
        """The unknown point by a known one that is on none of its links."""
        links = self.plans.mechanism.links
        point = next((p for p in self.plans.points if f"v_{p}" == equation["total"]["name"]), "")
        together = {p for x in links.values() if point in x.points for p in x.points}
        own = {*links[self.plans.drive.link].points}
        for other in sorted(own - together) if together else ():
            if self.plans.points[other].velocity in made or other in self.plans.mechanism.frame.points:
                text = f"⟨v_{point}⟩ = ⟨v_{other}⟩ + ⟨v_{point}{other}⟩"
                why = sentence_in_lesson_languages(
                    "lesson_choice_unlinked", one=point, two=other, name=f"v_{point}{other}"
                )
                return {text: {"why": why}}
        return {}


def sums_of_equation(equation: Json) -> list[tuple[str, Json]]:
    """The equation by each of its sides that is a sum, with the first vector of that side."""
    sums = []
    for side in equation["sides"]:
        if len(side) > 1:
            signed = (f"{'−' if t['minus'] else '+'} ⟨{t['name']}⟩" for t in side)
            sums.append((f"⟨{equation['total']['name']}⟩ = {' '.join(signed).removeprefix('+ ')}", side[0]))
    return sums
