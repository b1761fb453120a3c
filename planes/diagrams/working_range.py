"""A driver's working range: a whole turn, or to where the mechanism stops."""

from __future__ import annotations

from dataclasses import dataclass

FULL = 360.0


@dataclass(frozen=True)
class WorkingRange:
    """The driver's working range (degrees or metres) about its place; ``whole``: it goes round."""

    start: float
    end: float
    whole: bool = False

    def inner(self, margin: float) -> WorkingRange:
        """The range without a part of it at each end, where rates grow without bounds."""
        away = margin * (self.end - self.start)
        return WorkingRange(self.start + away, self.end - away)

    def values(self, count: int) -> list[float]:
        """So many values and one more, evenly from end to end."""
        return [self.start + (self.end - self.start) * k / count for k in range(count + 1)]
