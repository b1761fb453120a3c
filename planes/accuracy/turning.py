"""Turning curves: where motion ends, or two assemblies merge, as one length varies; whole curves, not one path."""

import math

from planes.accuracy.length_field import LengthField
from planes.geometry.arrays import Array, Indices
from planes.plans import Plans
from planes.words.frozen import frozen

# range of factors for the length, and where there is no turning
LENGTH_RANGE_FACTOR = 2.0
WIDEST_LENGTH_RANGE_FACTOR = 6.0


@frozen
class TurningCurve:
    """One curve: the drive's ``values`` (degrees or m) and the ``lengths`` (m) at which a mark turns back."""

    values: Array
    lengths: Array


@frozen
class Turning:
    """The results for one length: the curves, and the number of assemblies on a grid of ``lengths`` (rows) and
    ``values``.

    Groups attached to a group of class III or IV are left out where these are not ``whole``.
    """

    name: str
    here: tuple[float, float]
    curves: tuple[TurningCurve, ...]
    values: Array
    lengths: Array
    count: Indices
    whole: bool


def length_turning_curves(plans: Plans, name: str, times: float = LENGTH_RANGE_FACTOR) -> Turning:
    """The turning curves of a mechanism as the length ``name`` varies."""
    return _turning_from_field(LengthField(plans, name, times))


def _turning_from_field(field: LengthField) -> Turning:
    places = [curve for step in field.steps_with_several_solutions for curve in field.turning_curves_of_step(step)]
    curves = [TurningCurve(field.drive_value(at[:, 0]), field.length_value(at[:, 1])) for at in places]
    here = field.plans.drive.position, field.plans.link_lengths[field.name]
    values = field.drive_value(field.across)
    lengths = field.length_value(field.up)
    return Turning(field.name, here, tuple(curves), values, lengths, field.assembly_counts, field.is_complete)


def turning_of_nearest_length(plans: Plans, names: list[str]) -> Turning | None:
    """The same for the length that needs the least change before a position appears or disappears; None where none does
    within ``WIDEST``."""
    for times in (LENGTH_RANGE_FACTOR, WIDEST_LENGTH_RANGE_FACTOR):
        fields = [LengthField(plans, name, times) for name in names]
        soonest = min(fields, key=lambda f: f.distance_to_count_change, default=None)
        if soonest and soonest.distance_to_count_change < math.inf:
            return _turning_from_field(soonest)
    return None
