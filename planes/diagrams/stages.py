"""What a graphical construction starts from and is made of: a motion in equal sections, and one diagram of it."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Motion:
    """A uniform motion over one turn: ``time`` (s) at the ends of the sections, ``closed`` if it comes back.

    ``ends`` and ``middles`` hold for each rank (0 place, 1 velocity, 2 acceleration) the exact values at the ends and
    at the middles of the sections, SI (an angle in radians); ``curves`` the same over a dense time, for drawing.
    """

    link: str
    slides: bool
    angles: tuple[float, ...]
    time: tuple[float, ...]
    closed: bool
    ends: tuple[tuple[float, ...], ...]
    middles: tuple[tuple[float, ...], ...]
    dense_time: tuple[float, ...]
    curves: tuple[tuple[float, ...], ...]

    @property
    def sections(self) -> int:
        """How many sections the turn is divided into."""
        return len(self.time) - 1


@dataclass(frozen=True)
class Stage:
    """One diagram of a construction: its ``rank`` (0 place, 1 velocity, 2 acceleration), μ (mm per SI unit), the
    distance of its pole (None: it has none), and its points: (half sections from the start, label)."""

    plan: str
    rank: int
    mu: float
    pole_mm: float | None
    points: tuple[tuple[int, str], ...]
    given: bool
