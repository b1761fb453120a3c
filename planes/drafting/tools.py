"""The instrument at work: the operations that steps and the runner ask of it."""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any

from planes.geometry.arithmetic import Arithmetic, Point, Real, Shape, Truth
from planes.words import Phrase, Told
from planes.words.errors import PlanFailure
from planes.words.lettering import line_in_words, name_in_words
from planes.words.names import UNIT_OF_PLAN, plan_of_scale

FAILED_MARK_PLACE = complex("nan+nanj")  # placeholder for a failed mark of many drawings
Step = Any  # of planes.drafting.steps: a step knows the tool that draws it
Thing = Real | Point  # a mark (mm), a direction, or a value (SI): of one drawing, or of many
Env = dict[str, Thing]  # objects by name
Things = Mapping[str, Thing]  # the same, to be read


class AskedFor(dict[str, Thing]):
    """Stands for missing objects, each equal to 1; its keys are the names that were asked for."""

    def __missing__(self, name: str) -> Thing:
        return self.setdefault(name, 1.0)


@dataclass
class Tool:
    """An instrument at work on one drawing, or on an array of ``many``: it marks exactly, records how sharply lines
    meet, and raises (one) or masks (many) failures."""

    ar: Arithmetic
    many: bool = False
    slack: float = 4e-15  # relative: arcs that miss by less are taken to touch
    flat: float = 2e-15  # sharpness at or below which two lines count as parallel
    still: float = 2e-14  # relative: a speed at or below this is a standstill
    doubt_mm: float = 0.0  # marks no farther apart than this may be one mark
    plans: int = 12  # plans drawn in succession, each with the results of those before, until they agree
    settled: float = 0.01  # the change allowed in the last of them is the root of the rounding error
    shape: Shape = ()  # shape of a simultaneous drawing; () for one
    sharpness: dict[str, Real] = field(default_factory=dict)
    notes: list[tuple[str, object, Truth]] = field(default_factory=list)
    failures: list[tuple[str, object, Truth, dict[str, Real]]] = field(default_factory=list)

    def given_in_tool_type(self, value: Thing) -> Thing:
        """A given number or place in the instrument's type."""
        return value

    def draw_by_other_steps(self, step: Step, way: Sequence[Step], things: Env) -> Thing:
        """Draw a step by the steps of ``way`` into ``things``; returns its own result, whatever entries they leave."""
        thing = None
        for one in way:
            before = len(self.failures)
            thing = self.draw(one, things)
            if self.failures:
                thing = self.mask_failed_results(thing, one, before)
            things[one.makes] = thing
        return thing

    def draw(self, step: Step, things: Env) -> Thing:
        """The result itself."""
        return self.spread_over_drawings(step.draw(things, self))

    def spread_over_drawings(self, thing: Any) -> Any:
        """Constants in the shape of the simultaneous drawing, so that no constant reaches a method of an array."""
        if not self.shape or getattr(thing, "shape", None) == self.shape:
            return thing
        return self.ar.repeat_for_positions(thing, self.shape)

    def mask_failed_results(self, thing: Thing, step: Step, before: int) -> Thing:
        """The result of a step for many drawings, NaN in those that failed since there were ``before`` failures."""
        for _, _, ok, _ in self.failures[before:]:
            thing = self.ar.where(ok, thing, math.nan if step.kind == "value" else FAILED_MARK_PLACE)
        return thing

    def mark(self, place: Point) -> Point:
        """A mark on the paper: exact, or off by a pencil's width."""
        return place

    def transfer_direction(self, direction: Point) -> Point:
        """A direction transferred to where it is needed."""
        return direction

    def read_length(self, length_mm: Real) -> Real:
        """A length read from the ruler."""
        return length_mm

    def record_sharpness(self, name: str, sharpness: Real) -> None:
        """Record how sharply the lines meet at a mark."""
        self.sharpness[name] = sharpness

    def tool_without_errors(self) -> "Tool":
        """A tool that draws aside, without the errors of hand and ruler; its failures count as failures of this one."""
        limits = self.slack, self.flat, self.still
        return Tool(
            self.ar,
            self.many,
            *limits,
            plans=self.plans,
            settled=self.settled,
            shape=self.shape,
            failures=self.failures,
        )

    def fail_unless(self, ok: Truth, step: object, reason: str, **numbers: Real) -> None:
        """Fail where ``ok`` is false: one position raises, many are masked with their reason."""
        if not self.many:
            if not ok:
                raise PlanFailure(
                    reason, **names_for_step_sentence(step), **{k: float(abs(v)) for k, v in numbers.items()}
                )
        elif not (ok := self.spread_over_drawings(ok)).all():
            self.failures.append((reason, step, ok, numbers))

    def prefer_other_leads_unless(self, ok: Truth, step: object, reason: str) -> None:
        """Where ``ok`` is false, other plans are sharper: a loop over positions switches to them, a drawing
        continues."""

    def warn_unless(self, ok: Truth, step: object, reason: str) -> None:
        """Warn where ``ok`` is false."""
        if not (self.spread_over_drawings(ok).all() if self.many else ok):
            self.notes.append((reason, step, ok))


def names_for_step_sentence(step: Step) -> dict[str, Told]:
    """The names that a sentence about the step may use; ``line`` and ``other_line`` are the crossed lines."""
    named = {f.name: value for f in fields(step) if isinstance(value := getattr(step, f.name), str)}
    words = {name: name_in_words(value) for name, value in named.items()}
    for line, along, start in (("line", "along", "start"), ("other_line", "across", "other")):
        if along in named and start in named:
            words[line] = line_in_words(named[along], getattr(step, start))
    if "mu" in named:
        words["unit"] = Phrase(UNIT_OF_PLAN.get(plan_of_scale(named["mu"]), "units"))
    return words
