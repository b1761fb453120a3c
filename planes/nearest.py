"""Where the method works again: the value of the drive nearest to one at which it fails."""

from __future__ import annotations

from planes.drawing import run
from planes.plans import Plans
from planes.scales import unit_scales
from planes.wording import PlanFailure

FINEST, GROWTH, HALVINGS = 0.01, 1.5, 12  # degrees; a sliding driver searches in thousandths of its reach


def works(plans: Plans, value: float) -> bool:
    """Whether every step can be drawn at this value of the drive."""
    try:
        run(plans.program, {**plans.given, **unit_scales(plans), plans.drive_given: value})
    except (PlanFailure, OverflowError, ZeroDivisionError):
        return False
    return True


def nearest(plans: Plans, value: float) -> float | None:
    """The nearest value that works, found by widening steps to either side and then halving; None if there is none."""
    turning = plans.mechanism.drive.kind == "phi"
    far = 180.0 if turning else 4 * max((abs(v) for k, v in plans.given.items() if k.startswith("l_")), default=1.0)
    step = FINEST * far / 180.0
    before = 0.0
    while step <= far:
        for side in (1.0, -1.0):
            if works(plans, value + side * step):
                offset = side * step
                return value + (edge(plans, value, side * before, offset, HALVINGS) if before else offset)
        before, step = step, step * GROWTH
    return None


def edge(plans: Plans, value: float, bad: float, good: float, halvings: int) -> float:
    """The end of the working range between two offsets from a value, on its working side: an offset too."""
    for _ in range(halvings):
        middle = (bad + good) / 2
        if works(plans, value + middle):
            good = middle
        else:
            bad = middle
    return good
