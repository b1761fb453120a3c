"""Several blanks on one picture: which of its corner marks are of one sheet."""

from collections.abc import Sequence

import numpy

from planes.check.fiducials import SHEET_MM, SIDE_MM, centres
from planes.geometry.arrays import Array

NEAR_MM = 90.0  # from where one mark of a sheet puts another, seen from aside; those of another sheet are 200 mm off
FEWEST = 3  # marks that tell where a sheet lies

Found = tuple[int, Array]  # the number of a mark, and its corners in pixels, from its upper left one clockwise


def sheets_apart(marks: Sequence[Found]) -> list[dict[int, Array]]:
    """The marks of each sheet by their numbers, sheets as they are read; of one sheet all, however few."""
    if len({number for number, _ in marks}) == len(marks):
        return [dict(marks)] if marks else []
    left, found = list(marks), list[dict[int, Array]]()
    while left:
        beside = _beside(left[0], left[1:])
        found += [dict(beside)] if len(beside) >= FEWEST else []
        taken = beside if len(beside) >= FEWEST else left[:1]
        left = [one for one in left if not any(one is other for other in taken)]
    return sorted(found, key=_in_order)


def _beside(seed: Found, marks: Sequence[Found]) -> list[Found]:
    """A mark, and those that stand where it tells that they should."""
    found = [seed]
    for number in range(len(centres(SHEET_MM))):
        near = [(_off(seed, one), k) for k, one in enumerate(marks) if one[0] == number != seed[0]]
        off, k = min(near, default=(NEAR_MM, 0))
        found += [marks[k]] if off < NEAR_MM else []
    return found


def _off(seed: Found, other: Found) -> float:
    """How far a mark is from where another of its sheet tells, mm."""
    corners = seed[1] @ numpy.array([1, 1j])
    right, up = (corners[[1, 2]] - corners[[0, 3]]).mean(), (corners[[0, 1]] - corners[[3, 2]]).mean()
    by = (centres(SHEET_MM)[other[0]] - centres(SHEET_MM)[seed[0]]) / SIDE_MM
    there = corners.mean() + by.real * right + by.imag * up
    seen = (other[1] @ numpy.array([1, 1j])).mean()
    return float(abs(seen - there) / max(abs(right), abs(up), 1e-9) * SIDE_MM)


def _in_order(sheet: dict[int, Array]) -> tuple[float, float]:
    """Sheets stand beside each other, or one under the other."""
    x, y = numpy.mean([quad.mean(axis=0) for quad in sheet.values()], axis=0).tolist()
    side = max(float(numpy.ptp(numpy.concatenate([*sheet.values()]), axis=0).min()), 1.0)
    return round(y / side), x
