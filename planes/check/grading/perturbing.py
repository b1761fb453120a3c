"""Drawing and ruler errors one at a time: a drawing made in many columns, each with a single error.

Column 0 of every mark, direction and value has no error; column k has only the k-th error, of one standard deviation.
So the differences between a run's columns are its first-order derivatives times the sizes of the errors.
"""

import math
from collections.abc import Iterable, Mapping, Sequence

import numpy

from planes.drafting.skill import Skill
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Many, Point, Real

_ERRORS_PER_STEP_KIND = {"mark": 8, "value": 2, "direction": 1}  # errors of a step by kind: marks, rays, readings


SHARED_ERRORS_NAME = "shared"  # name of the errors shared by all marks


def error_columns(steps: Iterable[Step], read: Iterable[str], shared: int = 0) -> tuple[dict[str, int], int]:
    """The first error column of every step, of every name read with an error and of shared errors; the column count."""
    columns = {}
    width = 1
    drawn = ((s.makes, _ERRORS_PER_STEP_KIND[s.kind]) for s in steps if s.kind in _ERRORS_PER_STEP_KIND)
    for name, count in (*drawn, *((f"read {n}", 2) for n in read), (SHARED_ERRORS_NAME, shared)):
        columns[name] = width
        width += count
    return columns, width


class Nudged(Tool):
    """A tool that makes each error in a separate column."""

    def __init__(self, skill: Skill, columns: Mapping[str, int], width: int) -> None:
        super().__init__(Many(), True)
        self.skill = skill
        self.columns = columns
        self.width = width
        self.at = 0
        self.end = 0

    def draw_by_other_steps(self, step: Step, way: Sequence[Step], things: Env) -> Point:
        """The errors of all steps on the way are those of the step they make."""
        self.at = self.columns.get(step.makes, 0)
        self.end = self.at + 8 if self.at else 0
        return super().draw_by_other_steps(step, way, things)

    def spread_over_drawings(self, value: Point) -> Point:
        """The value as an array over all columns, ready for errors."""
        return numpy.array(numpy.broadcast_to(value, (self.width,)))

    def _next_column(self) -> int:
        self.at += 1
        return self.at - 1

    def mark(self, place: Point) -> Point:
        if self.at + 2 > self.end:
            return place
        out = self.spread_over_drawings(place + 0j)
        out[self._next_column()] += self.skill.point_mm
        out[self._next_column()] += 1j * self.skill.point_mm
        return out

    def transfer_direction(self, direction: Point) -> Point:
        if self.at + 1 > self.end:
            return direction
        out = self.spread_over_drawings(direction + 0j)
        angle = math.radians(self.skill.ray_deg)
        out[self._next_column()] *= (1 + 1j * angle) / abs(1 + 1j * angle)
        return out

    def read_length(self, length_mm: Real) -> Real:
        if self.at + 1 > self.end:
            return length_mm
        out = self.spread_over_drawings(length_mm + 0.0)
        out[self._next_column()] += self.skill.ruler_mm
        return out

    def read_mark_with_errors(
        self, name: str, place: complex, error_mm: float, shared: Sequence[complex] = ()
    ) -> Point:
        """A mark read from a person's drawing, with its individual and its shared reading errors."""
        out = self.spread_over_drawings(complex(place))
        column = self.columns[f"read {name}"]
        out[column] += error_mm
        out[column + 1] += 1j * error_mm
        out[self.columns[SHARED_ERRORS_NAME] : self.columns[SHARED_ERRORS_NAME] + len(shared)] += shared
        return out
