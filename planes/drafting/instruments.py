"""Instruments that draw a program: exactly, or with a pencil's error; each with its arithmetic and tolerances.

Accuracy of hand drawings: 77 values of 18 published solutions, careful drafting 0.15 mm, 0.15°, ruler 0.25 mm.
"""

import math
import random
from dataclasses import dataclass, field
from functools import reduce
from typing import Any, Protocol

from planes.drafting.skill import DRAUGHTSMAN_SKILL, RULER_RESOLUTION_MM
from planes.drafting.tools import Env, Step, Tool
from planes.geometry.arithmetic import Arithmetic, Many, Point, Real, Shape
from planes.geometry.listed import ListArithmetic
from planes.words.frozen import frozen

DRAUGHTSMEN_COUNT = 200  # draughtsmen who draw a plan to show the scatter of results
SHAKEN_ROUNDING_RATIO = 1000 * 2.0**-52


class Instrument(Protocol):
    """A drawing instrument: it makes a fresh tool for one drawing, or for arrays of ``many``."""

    def tool(self, many: bool) -> Tool: ...


def _arithmetic_for(many: bool) -> Arithmetic:
    return Many() if many else Arithmetic()


@frozen
class Exact:
    """An instrument with no error but rounding."""

    def tool(self, many: bool) -> Tool:
        return Tool(_arithmetic_for(many), many)


@frozen
class InLists:
    """No error but rounding, many positions in lists of Python numbers (:mod:`planes.geometry.listed`): slower than
    numpy, and independent of it. The drawings are not proved."""

    def tool(self, many: bool) -> Tool:
        return Tool(ListArithmetic() if many else Arithmetic(), many)


def is_exact(instrument: Instrument | None) -> bool:
    """Whether rounding is the only error; no instrument means the exact one."""
    return instrument is None or isinstance(instrument, Exact)


@frozen
class Pencil:
    """A draughtsman's errors: standard deviations of marks, ``point_mm``, and of transferred directions, ``ray_deg``;
    readings are rounded to ``ruler_mm``. The same ``seed`` gives the same errors."""

    point_mm: float = DRAUGHTSMAN_SKILL.point_mm
    ray_deg: float = DRAUGHTSMAN_SKILL.ray_deg
    ruler_mm: float = RULER_RESOLUTION_MM
    seed: int = 1

    def tool(self, many: bool) -> Tool:
        errors = _Errors(self.seed, many)
        return _PencilTool(
            Many() if many else Arithmetic(), many, doubt_mm=6 * self.point_mm, pencil=self, errors=errors
        )


@frozen
class Shaken:
    """A draughtsman whose every mark, direction and reading is off by a thousand roundings: a difference he cannot see
    is beyond doubles too."""

    seed: int = 1

    def tool(self, many: bool) -> Tool:
        return _ShakenTool(_arithmetic_for(many), many, errors=_Errors(self.seed, many))


class _Errors:
    """Normal errors: one, or an array with one for each simultaneous drawing."""

    def __init__(self, seed: int, many: bool) -> None:
        if many:
            import numpy

            self.array: Any = numpy.random.default_rng(seed)
        self.one = random.Random(seed)

    def normal(self, shape: Shape) -> Real:
        if shape:
            return self.array.standard_normal(shape)
        return self.one.gauss(0.0, 1.0)

    def place_errors(self, shape: Shape) -> Point:
        """Errors of a place: to the right, then upwards."""
        return self.normal(shape) + 1j * self.normal(shape)


@dataclass
class _PencilTool(Tool):
    pencil: Pencil = field(default_factory=Pencil)
    errors: _Errors = field(default_factory=lambda: _Errors(1, False))

    def mark(self, place: Point) -> Point:
        return place + self.pencil.point_mm * self.errors.place_errors(self.shape)

    def transfer_direction(self, direction: Point) -> Point:
        angle = math.radians(self.pencil.ray_deg) * self.errors.normal(self.shape)
        return direction * (1 + 1j * angle) / abs(1 + 1j * angle)

    def read_length(self, length_mm: Real) -> Real:
        ruler = self.pencil.ruler_mm
        if self.many:
            import numpy

            return numpy.round(length_mm / ruler) * ruler
        return round(length_mm / ruler) * ruler


@dataclass
class _ShakenTool(Tool):
    errors: _Errors = field(default_factory=lambda: _Errors(1, False))
    reach: Real = 0.0  # the farthest mark a step draws from: marks near the pole have the same rounding error

    def draw(self, step: Step, things: Env) -> Any:
        self.reach = reduce(self.ar.maximum, (abs(things[n]) for n, kind in step.input_names() if kind == "mark"), 0.0)
        return super().draw(step, things)

    def mark(self, place: Point) -> Point:
        return place + SHAKEN_ROUNDING_RATIO * self.ar.maximum(abs(place), self.reach) * self.errors.place_errors(
            self.shape
        )

    def transfer_direction(self, direction: Point) -> Point:
        return direction * (1 + 1j * SHAKEN_ROUNDING_RATIO * self.errors.normal(self.shape))

    def read_length(self, length_mm: Real) -> Real:
        return length_mm * (1 + SHAKEN_ROUNDING_RATIO * self.errors.normal(self.shape))
