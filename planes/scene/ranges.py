"""Ranges of the drive's position as a user types them: "30", "0:360:30", "-90"."""

import math
from typing import Any, TypeVar

from planes.geometry.arrays import Array
from planes.scene import Scene
from planes.scene.parameters import require_finite_numbers
from planes.scene.reader import MOST_ANGLE_TURNS
from planes.words import Phrase
from planes.words.errors import PlanesError, SceneError
from planes.words.frozen import frozen

T = TypeVar("T")
Interval = tuple[float, float]  # its least and its greatest number
MOST_POSITIONS_IN_MEMORY = 10_000_000  # positions held in memory at once
MOST_TABLE_POSITIONS = 1_000_000_000  # positions of a table, which is written piece by piece


@frozen
class Span:
    """Evenly spaced values that are never stored, only generated block by block."""

    start: float
    step: float
    count: int

    @property
    def first_and_last(self) -> tuple[float, float]:
        """The first value and the last."""
        return self.start, self.start + self.step * (self.count - 1)

    def __len__(self) -> int:
        return self.count

    def __getitem__(self, part: slice) -> Array:
        import numpy

        first, last, _ = part.indices(self.count)
        values = numpy.arange(first, last, dtype=float)
        values *= self.step
        values += self.start
        return values


def driver_coordinate_asked(scene: Scene, phi: T | None, s: T | None, sign: str = "") -> T | None:
    """Of an angle and a place the one the drive is moved by; the other may not be asked for. ``sign`` stands before
    the names of both."""
    kind = scene.drive.kind if scene.drive else ""
    asked = {"phi": phi, "s": s}
    for option, value in asked.items():
        if value is not None and option != kind:
            why = Phrase("driver_by", kind=sign + kind) if kind else Phrase("no_driver")
            raise PlanesError(Phrase("option_misfit", option=sign + option, file=scene.file, why=why))
    return asked.get(kind)


def drive_positions_asked(scene: Scene, phi: Any, s: Any, several: bool = True) -> Any:
    """Where the drive is asked to be, as :func:`finite` takes it; None where nothing is asked."""
    at = driver_coordinate_asked(scene, phi, s)
    if at is None:
        return None
    return require_finite_numbers(at, "s" if phi is None else "phi", several)


def read_range(text: str, option: str = "--phi") -> list[float]:
    """The values of "a", or of "a:b:step" with b included when it falls on it."""
    span = read_span(text, option)
    _check_count(span.count, MOST_POSITIONS_IN_MEMORY, text, option)
    return [span.start + i * span.step for i in range(span.count)]


def read_span(text: str, option: str = "--phi") -> Span:
    """The same values, however many, without a list of them."""
    parts = text.split(":")
    try:
        numbers = [float(p.replace("−", "-")) for p in parts]
    except ValueError:
        hint = Phrase("decimal_no_comma") if "," in text else ""
        raise SceneError(Phrase("range_not_number", option=option, text=repr(text), hint=hint)) from None
    if len(numbers) not in (1, 3) or not all(map(math.isfinite, numbers)):
        raise SceneError(Phrase("range_parts", option=option, text=repr(text)))
    if len(numbers) == 1:
        return _require_near_angles(Span(numbers[0], 0.0, 1), text, option)
    start, end, step = numbers
    if step == 0 or (end - start) * step < 0:
        raise SceneError(Phrase("range_endless", option=option, text=repr(text), step=step, start=start, end=end))
    steps = (end - start) / step * (1 + 1e-12) + 1e-9
    _check_count(steps, MOST_TABLE_POSITIONS, text, option)
    return _require_near_angles(Span(start, step, math.floor(steps) + 1), text, option)


def _require_near_angles(span: Span, text: str, option: str) -> Span:
    """Refuse angles of so many turns that too few of their digits are left."""
    if option == "--phi" and max(map(abs, span.first_and_last)) > 360.0 * MOST_ANGLE_TURNS:
        raise SceneError(Phrase("range_far", option=option, text=repr(text), most=MOST_ANGLE_TURNS))
    return span


def _check_count(count: float, most: int, text: str, option: str) -> None:
    if count > most:
        count_text = f"{min(count, 1e308):.9g}"
        raise SceneError(Phrase("range_long", option=option, text=repr(text), count=count_text, most=most))
