"""Where the method works again: the value of the drive nearest to one at which it fails."""

from __future__ import annotations

from collections.abc import Callable

from planes.drawing import run
from planes.plans import Plans
from planes.scales import unit_scales
from planes.wording import PlanFailure

FINEST, GROWTH, HALVINGS = 0.01, 1.5, 12  # degrees; a sliding driver searches in thousandths of its reach


def trials(plans: Plans) -> Callable[[float], bool]:
    """A test of whether every step can be drawn at a value of the drive."""
    given = {**plans.given, **unit_scales(plans)}

    def works(value: float) -> bool:
        try:
            run(plans.program, {**given, plans.drive_given: value})
        except (PlanFailure, OverflowError, ZeroDivisionError):
            return False
        return True

    return works


def nearest(plans: Plans, value: float) -> float | None:
    """The nearest value that works, found by widening steps to either side and then halving; None if there is none."""
    works, turning = trials(plans), plans.mechanism.drive.kind == "phi"
    far = 180.0 if turning else 4 * max((abs(v) for k, v in plans.given.items() if k.startswith("l_")), default=1.0)
    step = FINEST * far / 180.0
    before = 0.0
    while step <= far:
        for side in (1.0, -1.0):
            if works(value + side * step):
                offset = side * step
                return value + (_edge(works, value, side * before, offset) if before else offset)
        before, step = step, step * GROWTH
    return None


def _edge(works: Callable[[float], bool], value: float, bad: float, good: float) -> float:
    """The end of the working range between two offsets from a value, on its working side: an offset too."""
    for _ in range(HALVINGS):
        middle = (bad + good) / 2
        if works(value + middle):
            good = middle
        else:
            bad = middle
    return good
