"""Instruments that draw a program: exactly, or with a pencil's error; each with its arithmetic and tolerances.

How exact hand drawings are: 77 values of 18 published solutions, careful drafting 0.15 mm, 0.15°, ruler 0.25 mm.
"""

from __future__ import annotations

import math
import random
from dataclasses import dataclass, field, fields
from typing import Any, Protocol

from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic, Many, One, Point, Real, Truth
from planes.words import Told
from planes.words.errors import PlanFailure
from planes.words.things import called, called_line

PENCILS = 200  # how many draughtsmen draw a plan to see how far apart they end
ROUNDINGS = 1000 * 2.0**-52


class Instrument(Protocol):
    """What draws: makes a fresh tool for one drawing, or for arrays of ``many``."""

    def tool(self, many: bool) -> Hand: ...


@dataclass
class Hand:
    """A tool at work: marks exactly, remembers sharpness, raises (one) or masks (many) what cannot be drawn."""

    ar: Arithmetic
    many: bool = False
    slack: float = 4e-15
    flat: float = 2e-15
    still: float = 2e-14
    doubt_mm: float = 0.0
    shape: tuple[int, ...] = ()  # of what is drawn at once; () for one
    sharpness: dict[str, Real] = field(default_factory=dict)
    notes: list[tuple[str, object, Truth]] = field(default_factory=list)
    failures: list[tuple[str, object, Truth, dict[str, Real]]] = field(default_factory=list)

    def given(self, value: Any) -> Any:
        """A given number or place as the instrument's own."""
        return value

    def mark(self, place: Point) -> Point:
        return place

    def ray(self, direction: Point) -> Point:
        return direction

    def read(self, length_mm: Real) -> Real:
        return length_mm

    def sharpen(self, name: str, sharpness: Real) -> None:
        self.sharpness[name] = sharpness

    def require(self, ok: Truth, step: object, reason: str, **numbers: Real) -> None:
        if not self.many:
            if not ok:
                raise PlanFailure(reason, **names_of(step), **{k: float(abs(v)) for k, v in numbers.items()})
        elif not ok.all() if hasattr(ok, "all") else not ok:
            self.failures.append((reason, step, ok, numbers))

    def note(self, ok: Truth, step: object, reason: str) -> None:
        if not (ok.all() if hasattr(ok, "all") else ok):
            self.notes.append((reason, step, ok))


def names_of(step: Any) -> dict[str, Told]:
    """The names a sentence about the step may use; ``line`` and ``other_line`` are what it crosses."""
    named = {f.name: value for f in fields(step) if isinstance(value := getattr(step, f.name), str)}
    found = {name: called(value) for name, value in named.items()}
    for line, along, start in (("line", "along", "start"), ("other_line", "across", "other")):
        if along in named and start in named:
            found[line] = called_line(named[along], named[start])
    return found


@dataclass(frozen=True)
class Exact:
    """No error but rounding: Python's complex for one position, numpy for many."""

    def tool(self, many: bool) -> Hand:
        return Hand(Many() if many else One(), many)


@dataclass(frozen=True)
class Pencil:
    """A draughtsman: a mark off by ``point_mm`` (standard deviation), a carried direction by ``ray_deg``, a reading
    rounded to ``ruler_mm``. The same ``seed`` draws the same errors."""

    point_mm: float = 0.15
    ray_deg: float = 0.15
    ruler_mm: float = 0.5
    seed: int = 1

    def tool(self, many: bool) -> Hand:
        errors = _Errors(self.seed, many)
        return _PencilHand(Many() if many else One(), many, doubt_mm=6 * self.point_mm, pencil=self, errors=errors)


@dataclass(frozen=True)
class Shaken:
    """A draughtsman whose every mark, direction and reading is off by a thousand roundings: what he cannot tell apart,
    doubles cannot be asked to."""

    seed: int = 1

    def tool(self, many: bool) -> Hand:
        return _ShakenHand(Many() if many else One(), many, errors=_Errors(self.seed, many))


class _Errors:
    """Normal errors: one, or an array of one for each drawing made at once."""

    def __init__(self, seed: int, many: bool) -> None:
        if many:
            import numpy

            self.array: Any = numpy.random.default_rng(seed)
        self.one = random.Random(seed)

    def normal(self, shape: tuple[int, ...]) -> Any:
        return self.array.standard_normal(shape) if shape else self.one.gauss(0.0, 1.0)


@dataclass
class _PencilHand(Hand):
    pencil: Pencil = field(default_factory=Pencil)
    errors: _Errors = field(default_factory=lambda: _Errors(1, False))

    def mark(self, place: Point) -> Point:
        error = self.errors.normal(self.shape) + 1j * self.errors.normal(self.shape)
        return place + self.pencil.point_mm * error

    def ray(self, direction: Point) -> Point:
        angle = math.radians(self.pencil.ray_deg) * self.errors.normal(self.shape)
        return direction * (1 + 1j * angle) / abs(1 + 1j * angle)

    def read(self, length_mm: Real) -> Real:
        ruler = self.pencil.ruler_mm
        if self.many:
            import numpy

            return numpy.round(length_mm / ruler) * ruler
        return round(length_mm / ruler) * ruler


@dataclass
class _ShakenHand(Hand):
    errors: _Errors = field(default_factory=lambda: _Errors(1, False))

    def mark(self, place: Point) -> Point:
        return place * (1 + ROUNDINGS * (self.errors.normal(self.shape) + 1j * self.errors.normal(self.shape)))

    def ray(self, direction: Point) -> Point:
        return direction * (1 + 1j * ROUNDINGS * self.errors.normal(self.shape))

    def read(self, length_mm: Real) -> Real:
        return length_mm * (1 + ROUNDINGS * self.errors.normal(self.shape))


_: type[Tool] = Hand
