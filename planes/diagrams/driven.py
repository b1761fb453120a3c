"""The driven link (what a mechanism is there to move, how its place is counted), and the driver's working range: a
whole turn, or to where the mechanism stops."""

from __future__ import annotations

from dataclasses import dataclass

from planes.plans import Plans
from planes.scene.mechanism import FRAME


def driven(plans: Plans) -> tuple[str, bool]:
    """The link that a mechanism drives, and whether it slides on the frame: the last group's."""
    m, group = plans.mechanism, plans.structure.groups[-1]
    for name in (group.last, group.first):
        slides = m.links[name].slides
        if slides and m.owner(slides.guide) == FRAME:
            return name, True
    on_frame = [p for p in plans.structure.pairs if p.joins(FRAME)]
    grounded = [n for n in (group.last, group.first) if any(p.joins(n) for p in on_frame)]
    slid = {n: m.links[n].slides for n in (group.last, group.first)}  # on the driver's guide it only turns with it
    free = [n for n, slides in slid.items() if not slides or m.owner(slides.guide) != m.drive.link]
    return (grounded or free or [group.last])[0], False


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
