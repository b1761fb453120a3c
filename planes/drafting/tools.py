"""The instrument at work: what a step asks of it, and what the runner does."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import Any

from planes.geometry.arithmetic import Arithmetic, Point, Real, Truth
from planes.words import Phrase, Told
from planes.words.errors import PlanFailure
from planes.words.lettering import line_in_words, name_in_words
from planes.words.units import UNIT

NOWHERE = complex("nan+nanj")  # the mark of a drawing of many that could not be drawn
Step = Any  # of planes.drafting.steps: a step knows the tool that draws it
Thing = Real | Point  # a mark (mm), a direction, or a value (SI): of one drawing, or of many
Env = dict[str, Thing]  # things by name


class AskedFor(dict[str, Thing]):
    """Stands for things that are not there yet, every one of them 1: its keys are those that were asked for."""

    def __missing__(self, name: str) -> Thing:
        return self.setdefault(name, 1.0)


@dataclass
class Tool:
    """An instrument at work on one drawing, or on an array of ``many``: it marks exactly, remembers how sharply lines
    met, and raises (one) or masks (many) what cannot be drawn."""

    ar: Arithmetic
    many: bool = False
    slack: float = 4e-15  # relative: arcs that miss by less are taken to touch
    flat: float = 2e-15  # sharpness at or below which two lines count as parallel
    still: float = 2e-14  # relative: a speed at or below this is a standstill
    doubt_mm: float = 0.0  # marks no farther apart than this may be one mark
    plans: int = 12  # drawn one after another, each with what those before lead to, until nothing changes
    settled: float = 0.01  # what the last of them may change, to the root of what rounding makes
    shape: tuple[int, ...] = ()  # of what is drawn at once; () for one
    sharpness: dict[str, Real] = field(default_factory=dict)
    notes: list[tuple[str, object, Truth]] = field(default_factory=list)
    failures: list[tuple[str, object, Truth, dict[str, Real]]] = field(default_factory=list)

    def given(self, value: Thing) -> Thing:
        """A given number or place as the instrument's own."""
        return value

    def make(self, step: Step, way: Sequence[Step], things: Env) -> Thing:
        """Draw a step by those of ``way`` into ``things``; what it has made, whatever is left there instead."""
        thing = None
        for one in way:
            before = len(self.failures)
            thing = self.draw(one, things)
            if self.failures:
                thing = self.masked(thing, one, before)
            things[one.makes] = thing
        return thing

    def draw(self, step: Step, things: Env) -> Thing:
        """The thing itself."""
        return self.spread(step.draw(things, self))

    def spread(self, thing: Any) -> Any:
        """What does not depend on what moves, in the shape of what is drawn at once: no constant reaches an array's
        method."""
        if not self.shape or getattr(thing, "shape", None) == self.shape:
            return thing
        return self.ar.spread(thing, self.shape)

    def masked(self, thing: Thing, step: Step, before: int) -> Thing:
        """What a step made of many drawings, NaN in those that failed since there were ``before`` failures."""
        for _, _, ok, _ in self.failures[before:]:
            thing = self.ar.where(ok, thing, math.nan if step.kind == "value" else NOWHERE)
        return thing

    def mark(self, place: Point) -> Point:
        """A mark made on the paper: exact, or off by a pencil's width."""
        return place

    def ray(self, direction: Point) -> Point:
        """A direction carried to where it is needed."""
        return direction

    def read(self, length_mm: Real) -> Real:
        """A length read off the ruler."""
        return length_mm

    def sharpen(self, name: str, sharpness: Real) -> None:
        """Remember how sharply the lines met at a mark."""
        self.sharpness[name] = sharpness

    def calm(self) -> "Tool":
        """A tool that draws aside, without the errors of hand and ruler; what it fails at, this one does."""
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

    def require(self, ok: Truth, step: object, reason: str, **numbers: Real) -> None:
        """Fail where ``ok`` is false: one position raises, many are masked with their reason."""
        if not self.many:
            if not ok:
                raise PlanFailure(reason, **names_of(step), **{k: float(abs(v)) for k, v in numbers.items()})
        elif not (ok := self.spread(ok)).all():
            self.failures.append((reason, step, ok, numbers))

    def prefer(self, ok: Truth, step: object, reason: str) -> None:
        """Where ``ok`` is false other plans draw the same better: a loop of positions is told, a drawing goes on."""

    def note(self, ok: Truth, step: object, reason: str) -> None:
        """Warn where ``ok`` is false."""
        if not (self.spread(ok).all() if self.many else ok):
            self.notes.append((reason, step, ok))


def names_of(step: Step) -> dict[str, Told]:
    """The names a sentence about the step may use; ``line`` and ``other_line`` are what it crosses."""
    named = {f.name: value for f in fields(step) if isinstance(value := getattr(step, f.name), str)}
    words = {name: name_in_words(value) for name, value in named.items()}
    for line, along, start in (("line", "along", "start"), ("other_line", "across", "other")):
        if along in named and start in named:
            words[line] = line_in_words(named[along], named[start])
    if "mu" in named:
        words["unit"] = Phrase(UNIT.get(named["mu"].removeprefix("mu_"), "units"))
    return words
