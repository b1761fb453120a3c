"""Results of a position that cannot be judged by hand drawing, so close to a dead point."""

from collections.abc import Iterator

from planes.check.grading.figures import quantity_figure
from planes.check.grading.handwork import Hand
from planes.check.grading.written_numbers import true_value_and_sigma
from planes.drafting.skill import STUDENT_SKILL, is_near_dead_point
from planes.plans.quantities import MOTION_GROUPS
from planes.solving import Position

RATE_KEYS = ("v", "a", "omega", "epsilon")


def unreliable_rate_names(position: Position) -> Iterator[str]:
    """The names of rates that drawing errors make unreliable; a check of them agrees."""
    asked = [f.quantity for f in position.found if f.quantity.group in MOTION_GROUPS and f.quantity.key in RATE_KEYS]
    needs = [n for q in asked for n in q.needed_names]
    plans = position.plans
    hand = Hand(
        plans.program.cut_to_names(needs),
        {**plans.given, **position.scales, **plans.drive_givens_at(position.at)},
        STUDENT_SKILL,
        {},
    )
    for quantity in asked:
        if is_near_dead_point(*true_value_and_sigma(quantity_figure(quantity.name, quantity, 0.0), hand)):
            yield quantity.name
