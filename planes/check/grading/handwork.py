"""The hand: runs a program on a person's own marks and grades each step by its miss.

Each mark that was read is looked up instead of drawn, so the next step starts from the person's actual mark and one
early mistake is blamed once. A variant of some steps (an assumed mistake) redraws only the steps it affects.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from types import MappingProxyType

import numpy

from planes.check.grading.paper import TakenMarks
from planes.check.grading.perturbing import Nudged, error_columns
from planes.check.grading.variants import Variant
from planes.drafting.drawing import draw_steps
from planes.drafting.program import Program
from planes.drafting.skill import Skill
from planes.drafting.steps import Aim, MarkStep, Same, Step, Turn
from planes.drafting.steps.reckoning import Measure
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Point, Truth
from planes.words.frozen import field, frozen, replace
from planes.words.names import POLE_LABEL, Mark, NumbersByName

LEAST_MARK_ERROR_MM = 0.1  # minimum error of a mark on paper


@frozen
class Miss:
    """The miss of a mark (complex, mm) or a value (real) from the result of its step, with its covariance."""

    off: complex
    cov: tuple[float, float, float]  # xx, xy, yy
    change: Point = field(default=None, compare=False, repr=False)  # contribution of each error of the drawing

    @property
    def sigmas(self) -> float:
        """Mahalanobis distance: the miss in standard deviations, in its direction."""
        xx, xy, yy = self.cov
        x = self.off.real
        y = self.off.imag
        return math.sqrt(max((yy * x * x - 2 * xy * x * y + xx * y * y) / self._area, 0.0))

    @property
    def _area(self) -> float:
        """The determinant of the covariance."""
        xx, xy, yy = self.cov
        return xx * yy - xy * xy

    def tolerance_mm(self, limit: float) -> float:
        """The tolerance in mm in the direction of the miss (if zero: the largest)."""
        sigmas = self.sigmas
        off = abs(self.off)
        return limit * (off / sigmas if sigmas > 1e-9 and off > 1e-9 else self.largest_sigma_mm)

    def with_reading_error(self, error_mm: float) -> Miss:
        """The same with an additional reading error of the mark (in each direction)."""
        xx, xy, yy = self.cov
        return replace(self, cov=(xx + error_mm**2, xy, yy + error_mm**2))

    @property
    def largest_sigma_mm(self) -> float:
        """The largest standard deviation over all directions, mm."""
        xx, xy, yy = self.cov
        return math.sqrt((xx + yy) / 2 + math.hypot((xx - yy) / 2, xy))

    @property
    def mean_sigma_mm(self) -> float:
        """The standard deviation of a circular error of the same area, mm."""
        return math.sqrt(math.sqrt(max(self._area, 0.0)))

    @property
    def log_density(self) -> float:
        """Logarithm of the normal density per mm²."""
        return -0.5 * self.sigmas**2 - math.log(2 * math.pi) - 0.5 * math.log(self._area)


Misses = dict[Mark, Miss]


def needs_protractor(step: Step, given: Env) -> bool:
    """Whether a direction is drawn at an angle that no set square has."""
    return isinstance(step, Aim | Turn) and step.angle is not None and float(given.get(step.angle, 0.0)) % 90 != 0


class Person(Tool):
    """A person's drawing, for any kind of numbers: marks that were ``read`` are looked up, not drawn.

    An angle that no set square has is drawn by protractor; the person's own segment is measured as drawn, and the
    direction determines only its sign.
    """

    own: dict[Mark, Point]  # the person's marks with reading errors
    values: Env  # the given values

    def is_read(self, mark: Mark) -> Truth:
        """Whether a mark is the person's own (the pole is)."""
        return mark in self.own or (mark.label == POLE_LABEL and any(m.plan == mark.plan for m in self.own))

    def without_errors(self, thing: Point) -> Point:
        """An element without drawing and ruler errors."""
        return thing

    def draw(self, step: Step, things: Env) -> Point:
        own = isinstance(step, Measure) and bool(step.along) and self.is_read(step.start) & self.is_read(step.end)
        if not isinstance(step, Measure) or own is False:
            made = step.draw(things, self)
            if needs_protractor(step, self.values):
                return self.transfer_direction(made)
            return made
        way = self.without_errors(things[step.end] - things[step.start])
        along = self.without_errors(things[step.along or ""])
        sign = self.ar.where(way.real * along.real + way.imag * along.imag < 0, -1.0, 1.0)
        lies = sign * replace(step, along=None).draw(things, self)
        if own is True:
            return lies
        return self.ar.where(own, lies, step.draw(things, self))

    def draw_by_other_steps(self, step: Step, way: Sequence[Step], things: Env) -> Point:
        made = super().draw_by_other_steps(step, way, things)
        if isinstance(step, MarkStep) and step.makes in self.own:
            things[step.makes] = self.ar.where(self.is_read(step.makes), self.own[step.makes], made)
        return made


class _Marking(Person, Nudged):
    """A person at work, each error in a separate column."""

    def without_errors(self, thing: Point) -> Point:
        return self.spread_over_drawings(thing + 0j)[0]


def _error_contributions(row: Point) -> Point:
    """The contribution of each error to an element."""
    return numpy.nan_to_num(row[1:] - row[0], nan=0.0, posinf=0.0, neginf=0.0)


class Hand:
    """A program run on a person's marks (``taken``), with the errors of ``skill`` propagated through it."""

    def __init__(
        self,
        program: Program,
        given: Env,
        skill: Skill,
        taken: TakenMarks,
        unsure: NumbersByName = MappingProxyType({}),
    ) -> None:
        self.program = program
        self.taken = taken
        self.given, self.unsure = given, unsure  # a result may be of a given, or need a scale used by no step
        shared = max((len(t.shared) for t in taken.values()), default=0)
        columns, width = error_columns(program.steps, [*taken, *self.unsure], shared)
        self.tool = _Marking(skill, columns, width)
        laid = {step.makes for step in program.steps if isinstance(step, Same)}
        errors = {
            n: max(t.individual_error_mm, skill.point_mm) if n in laid else t.individual_error_mm
            for n, t in taken.items()
        }
        self.tool.own = {n: self.tool.read_mark_with_errors(n, t.place, errors[n], t.shared) for n, t in taken.items()}
        self.tool.values = self.given
        self.things: Env = dict(self.given)
        for name, share in self.unsure.items():  # relative error of an estimated given
            value = self.tool.spread_over_drawings(float(self.things[name]))
            value[columns[f"read {name}"]] *= 1 + share
            self.things[name] = value
        self.made = draw_steps(program.steps, self.things, self.tool)

    def misses(self, marks: Sequence[Mark], made: Env | None = None) -> Misses:
        """The miss of each mark, for the original steps (or those ``made`` by a variant)."""
        made = self.made if made is None else made
        return {m: self.miss(made[m], self.things[m]) for m in marks if m in self.taken and m in made}

    def miss(self, drawn: Point, read: Point) -> Miss:
        """The difference between two arrays of columns."""
        off = self.tool.spread_over_drawings(read - drawn + 0j)
        change = _error_contributions(off)
        floor = LEAST_MARK_ERROR_MM**2
        xx = float(change.real @ change.real) + floor
        yy = float(change.imag @ change.imag) + floor
        return Miss(complex(off[0]), (xx, float(change.real @ change.imag), yy), change)

    def sigma_of_value(self, value: Point) -> float:
        """Standard deviation of a real value."""
        change = _error_contributions(self.tool.spread_over_drawings(numpy.real(value) + 0.0))
        return math.sqrt(float(change @ change))

    def value_without_errors(self, name: str) -> Point:
        """An element of the drawing without its columns."""
        value = self.things[name]
        return value[0].item() if getattr(value, "shape", None) else value

    def redraw_with_variant(self, variant: Variant) -> Env:
        """The person's marks redrawn by the steps that a variant affects, everything else unchanged."""
        return variant.draw_affected_steps(self.program, self.things, self.tool, self.taken)
