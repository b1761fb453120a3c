"""The choices in practice: a plan's scale, the group that comes next for forces and why, the equation written first.

A choice is data: the options, each with the reason why it is wrong, or none if it is right; a scale is judged by the
size of the plan.
"""

from collections.abc import Mapping, Sequence
from functools import cached_property

from planes.drafting.drawing import Drawing
from planes.drafting.steps import LayOff
from planes.lesson.formulas import LANGS, in_both, spoken
from planes.lesson.frame import Frame
from planes.lesson.free_bodies import FreeBodies, links_told
from planes.plans import Plans
from planes.plans.scales import fitting
from planes.words.frozen import frozen
from planes.words.names import POLE, at, kind_of, label_of, links_of, mu_of
from planes.words.records import Json
from planes.words.units import UNIT

CHOICES = ("mu", "order", "reason", "first")
TIMES = (0.1, 0.4, 1.0, 2.5, 10.0)
"""The scales offered, relative to that of the lesson: too large and too small both ways, and acceptable ones."""
LATER = 2  # equations of later groups offered beside the current one
REASONS = ("last", "driver", "moved", "heavy")
"""Reasons why a group comes first for forces: the first is right."""


@frozen
class Choices:
    """The choices of one lesson; ``fit_mm`` is the size of each kind of plan on the paper."""

    plans: Plans
    drawing: Drawing
    frames: Sequence[Frame]
    equations: Sequence[Json]
    fit_mm: Mapping[str, float]

    def offered(self, kind: str, what: str | int, frame: int) -> Json | None:
        """The options of a choice, by its kind; None where there is nothing to choose."""
        if kind == "mu":
            return self.scale(str(what), self.frames[frame])
        if not self.plans.moves:
            return None
        if kind == "first":
            return self.first(int(what), frame)
        return self.order(str(what)) if kind == "order" else self.reason(str(what))

    def scale(self, plan: str, frame: Frame) -> Json | None:
        """Scales of the standard series about that of the lesson, the marks that give the size of the plan, and the
        vector laid off first; None where no given length leads to the first mark asked for."""
        first = self.plans.program.makers[frame.makes[0]]
        long = (getattr(first, "length", "") or getattr(first, "radius", "")) if plan == "position" else ""
        if not long and not isinstance(first, LayOff):
            return None
        own = complex(self.drawing[mu_of(plan)]).real
        offered = sorted({fitting(plan, 1.0, own * times) for times in TIMES})
        others = {at(plan, POLE), *self.plans.program.trials}
        shown = [s.makes for s in self.plans.program.marks[plan] if not s.loose and s.makes not in others]
        kind = kind_of(plan)
        return {
            "offered": [{"value": mu} for mu in offered],
            "marks": shown,
            "most": self.fit_mm[kind],
            "name": long or next(iter(frame.terms), label_of(first.makes)),
            "unit": spoken(UNIT.get(kind, "one_unit")),
        }

    @cached_property
    def waits(self) -> dict[str, dict[str, set[str]]]:
        """By force plan the plans it waits for, and the reactions that each of them gives."""
        bodies = FreeBodies(self.plans, self.drawing)
        waits = {plan: dict[str, set[str]]() for plan in self.plans.forces}
        for plan, giving in waits.items():
            for f in bodies.known(plan):
                for r in self.plans.reactions.values():
                    if f["name"] in r.names and r.plan != plan:
                        giving.setdefault(r.plan, set()).add(f["name"])
        return waits

    def order(self, plan: str) -> Json | None:
        """The links whose forces are still unknown, where some of them must wait: a group of one polygon each."""
        driver, group_links = self.plans.structure.driver, [set(g.whole) for g in self.plans.structure.groups]
        if any(links_of(p) != (driver,) and set(links_of(p)) not in group_links for p in self.plans.forces):
            return None
        left = self.plans.forces[self.plans.forces.index(plan) :]
        names = {p: sorted(n for q in left for n in self.waits[p].get(q, ())) for p in left}
        if not any(names.values()):
            return None
        return {
            "offered": [
                {"value": p, "said": in_both(links_told(links_of(p)).told), **self.early(names[p])}
                for p in sorted(left)
            ]
        }

    def early(self, names: Sequence[str]) -> Json:
        """Why links come too early: forces on them are still unknown."""
        forces = ", ".join(f"⟨{n}⟩" for n in names)
        return {"why": spoken("lesson_choice_early", forces=forces)} if names else {}

    def reason(self, plan: str) -> Json | None:
        """Why the first links come first."""
        if plan != self.plans.forces[0] or not self.order(plan):
            return None
        why = {"why": spoken("why_free_body_first")}
        wrong = dict.fromkeys(REASONS[1:], why)
        return {
            "offered": [
                {"value": key, "said": spoken(f"lesson_choice_{key}"), **wrong.get(key, {})} for key in sorted(REASONS)
            ]
        }

    def first(self, index: int, frame: int) -> Json | None:
        """Velocity equations; those that begin with a known vector can be written first."""
        own = [e for e in self.equations if e["plan"] == "velocity" and e["total"]]
        equation = self.equations[index]
        if equation not in own:
            return None
        made = {m for f in self.frames[:frame] for m in f.makes} | {at("velocity", POLE)}
        later = [e for e in own if self.equations.index(e) > index]
        offered = {text: self.unknown(term, made) for text, term in lines(equation)}
        offered |= self.unlinked(equation, made)
        waiting = [(text, why) for e in later for text, term in lines(e)[:1] if (why := self.unknown(term, made))]
        offered |= dict(waiting[:LATER])
        if not any(offered.values()) or all(offered.values()):
            return None
        return {"offered": [{"value": t, "said": dict.fromkeys(LANGS, t), **offered[t]} for t in sorted(offered)]}

    def unknown(self, term: Json, made: set[str]) -> Json:
        """Why an equation that begins with a vector cannot be written yet; empty where it can."""
        if term["action"] == "=0" or term["at"] in made:
            return {}
        return {"why": spoken("lesson_choice_unknown", name=term["name"])}

    def unlinked(self, equation: Json, made: set[str]) -> dict[str, Json]:
        """The unknown point by a known one that is on none of its links."""
        links = self.plans.mechanism.links
        point = next((p for p in self.plans.points if f"v_{p}" == equation["total"]["name"]), "")
        together = {p for x in links.values() if point in x.points for p in x.points}
        own = {*links[self.plans.drive.link].points}
        for other in sorted(own - together) if together else ():
            if self.plans.points[other].velocity in made or other in self.plans.mechanism.frame.points:
                text = f"⟨v_{point}⟩ = ⟨v_{other}⟩ + ⟨v_{point}{other}⟩"
                why = spoken("lesson_choice_unlinked", one=point, two=other, name=f"v_{point}{other}")
                return {text: {"why": why}}
        return {}


def lines(equation: Json) -> list[tuple[str, Json]]:
    """The equation by each of its sides that is a sum, with the first vector of that side."""
    sums = []
    for side in equation["sides"]:
        if len(side) > 1:
            signed = (f"{'−' if t['minus'] else '+'} ⟨{t['name']}⟩" for t in side)
            sums.append((f"⟨{equation['total']['name']}⟩ = {' '.join(signed).removeprefix('+ ')}", side[0]))
    return sums
