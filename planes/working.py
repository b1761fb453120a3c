"""How far a driver can move from its place in the scene: a whole turn, or to where the mechanism stops."""

from __future__ import annotations

from dataclasses import dataclass

from planes.nearest import edge, works
from planes.plans import Plans

FULL = 360.0
STEPS = 72  # in which a turn, or the reach of a sliding driver to either side, is looked through
HALVINGS = 16


@dataclass(frozen=True)
class Span:
    """The driver's working range (degrees or metres) about its place; ``whole``: it goes round."""

    start: float
    end: float
    whole: bool = False

    def inner(self, margin: float) -> Span:
        """The range without a part of it at each end, where rates grow without bounds."""
        away = margin * (self.end - self.start)
        return Span(self.start + away, self.end - away)

    def values(self, count: int) -> list[float]:
        """So many values and one more, evenly from end to end."""
        return [self.start + (self.end - self.start) * k / count for k in range(count + 1)]


def span_of(plans: Plans) -> Span:
    """The range about the scene's own place of the drive in which every step can be drawn."""
    drive = plans.mechanism.drive
    turning = drive.kind == "phi"
    lengths = (abs(v) for k, v in plans.given.items() if k.startswith("l_") and isinstance(v, float))
    far = FULL if turning else 2 * max(lengths, default=1.0)
    ahead = _reach(plans, far / STEPS, STEPS)
    if turning and ahead >= FULL:
        return Span(drive.position, drive.position + FULL, True)
    return Span(drive.position - _reach(plans, -far / STEPS, STEPS), drive.position + ahead)


def _reach(plans: Plans, step: float, steps: int) -> float:
    """How far the driver goes in the direction of a step before it stops, at most so many steps."""
    start = plans.mechanism.drive.position
    for k in range(1, steps + 1):
        if not works(plans, start + k * step):
            return abs(edge(plans, start, k * step, (k - 1) * step, HALVINGS))
    return abs(steps * step)
