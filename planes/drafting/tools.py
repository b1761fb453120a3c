"""What a step asks of the instrument that draws it."""

from __future__ import annotations

from typing import Any, Protocol

from planes.geometry.arithmetic import Arithmetic, Point, Real, Truth

Env = dict[Any, Any]  # name -> mark (mm), direction, or value (SI)


class Tool(Protocol):
    """An instrument at work on one drawing (or on an array of drawings)."""

    ar: Arithmetic
    slack: float  # relative: arcs that miss by less are taken to touch
    flat: float  # sharpness at or below which two lines count as parallel
    still: float  # relative: a speed at or below this is a standstill
    doubt_mm: float  # marks no farther apart than this may be one mark
    sharpness: dict[str, Real]

    def mark(self, place: Point) -> Point:
        """A mark made on the paper: exact, or off by a pencil's width."""
        ...

    def ray(self, direction: Point) -> Point:
        """A direction carried to where it is needed."""
        ...

    def read(self, length_mm: Real) -> Real:
        """A length read off the ruler."""
        ...

    def sharpen(self, name: str, sharpness: Real) -> None:
        """Remember how sharply the lines met at a mark."""
        ...

    def require(self, ok: Truth, step: object, reason: str, **numbers: Real) -> None:
        """Fail where ``ok`` is false: one position raises, many are masked with their reason."""
        ...

    def note(self, ok: Truth, step: object, reason: str) -> None:
        """Warn where ``ok`` is false."""
        ...
