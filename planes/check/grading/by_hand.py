"""Results of a position that cannot be judged by hand drawing, so close to a dead point."""

from collections.abc import Iterator

from planes.check.grading.figures import figure
from planes.check.grading.handwork import Hand
from planes.check.grading.written_numbers import drawn_by
from planes.drafting.skill import HAND, too_near
from planes.plans.quantities import MOTION
from planes.solving import Position

RATES = ("v", "a", "omega", "epsilon")


def unsure(position: Position) -> Iterator[str]:
    """The names of rates that drawing errors make unreliable; a check of them agrees."""
    asked = [f.quantity for f in position.found if f.quantity.group in MOTION and f.quantity.key in RATES]
    needs = [n for q in asked for n in q.needs]
    plans = position.plans
    hand = Hand(plans.program.sliced(needs), {**plans.given, **position.scales, **plans.at(position.at)}, HAND, {})
    for quantity in asked:
        if too_near(*drawn_by(figure(quantity.name, quantity, 0.0), hand)):
            yield quantity.name
