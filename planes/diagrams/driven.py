"""The driven link: what a mechanism is there to move, and how its place is counted."""

from __future__ import annotations

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
    free = [n for n in (group.last, group.first) if not _turns_with_driver(plans, n)]
    return (grounded or free or [group.last])[0], False


def _turns_with_driver(plans: Plans, name: str) -> bool:
    """Whether a link slides on a guide of the driver, and so only repeats its turning."""
    slides = plans.mechanism.links[name].slides
    return slides is not None and plans.mechanism.owner(slides.guide) == plans.mechanism.drive.link
