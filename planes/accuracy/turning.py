"""Turning curves: where motion ends, or two assemblies merge, as one length varies; whole curves, not one path."""

import math

from planes.accuracy.length_field import LengthField
from planes.geometry.arrays import Array, Indices
from planes.plans import Plans
from planes.words.frozen import frozen

TIMES, WIDEST = 2.0, 6.0  # range of factors for the length, and where there is no turning


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


def turning(plans: Plans, name: str, times: float = TIMES) -> Turning:
    """The turning curves of a mechanism as the length ``name`` varies."""
    return _of(LengthField(plans, name, times))


def _of(field: LengthField) -> Turning:
    places = [curve for step in field.steps for curve in field.curves(step)]
    curves = [TurningCurve(field.value(at[:, 0]), field.length(at[:, 1])) for at in places]
    here = field.plans.drive.position, field.plans.lengths[field.name]
    values, lengths = field.value(field.across), field.length(field.up)
    return Turning(field.name, here, tuple(curves), values, lengths, field.count, field.whole)


def turned(plans: Plans, names: list[str]) -> Turning | None:
    """The same for the length that needs the least change before a position appears or disappears; None where none does
    within ``WIDEST``."""
    for times in (TIMES, WIDEST):
        fields = [LengthField(plans, name, times) for name in names]
        soonest = min(fields, key=lambda f: f.gone, default=None)
        if soonest and soonest.gone < math.inf:
            return _of(soonest)
    return None
