"""Several blanks on one picture: assigns corner marks to sheets."""

from collections.abc import Sequence

import numpy

from planes.check.fiducials import SHEET_MM, SIDE_MM, centres
from planes.geometry.arrays import Array
from planes.words.frozen import frozen

NEAR_MM = 90.0  # tolerance of a mark predicted from another, seen obliquely; other sheets' marks are 200 mm off
FEWEST = 3  # marks that determine the position of a sheet
ROOM = 1.0  # of the area between a sheet's marks: another sheet, smaller if more distant, fits in as much

Found = tuple[int, Array]  # the number of a mark, and its corners in pixels, clockwise from the upper left


@frozen
class SheetsSeen:
    """The marks of each sheet by their numbers, sheets in reading order; of a single sheet all, however few."""

    sheets: list[dict[int, Array]]
    stray: int = 0  # marks of other sheets, too few to locate these

    @property
    def in_part(self) -> int:
        """The marks of a partly visible sheet: at least two, since a single one may be false."""
        return self.stray if self.stray > 1 else 0

    @property
    def parts(self) -> int:
        """The number of sheets, including a partly visible one."""
        return len(self.sheets) + bool(self.in_part)


def sheets_apart(marks: Sequence[Found]) -> SheetsSeen:
    """Marks by their sheets."""
    if len({number for number, _ in marks}) == len(marks):
        return SheetsSeen([dict(marks)] if marks else [])
    left, sheets = list(marks), list[dict[int, Array]]()
    while left:
        beside = _beside(left[0], left[1:])
        sheets += [dict(beside)] if len(beside) >= FEWEST else []
        taken = beside if len(beside) >= FEWEST else left[:1]
        left = [one for one in left if not any(one is other for other in taken)]
    return SheetsSeen(sorted(sheets, key=_in_order), len(marks) - sum(map(len, sheets)))


def leaves_more(seen: SheetsSeen, picture: float) -> bool:
    """Whether a picture of this area (px²) may show more marks.

    The known ones are too few for their sheet, or leave room for another sheet.
    """
    if seen.stray or any(len(sheet) < FEWEST for sheet in seen.sheets):
        return True
    areas = [_area(sheet) for sheet in seen.sheets]
    return picture - sum(areas) > ROOM * min(areas)


def _area(sheet: dict[int, Array]) -> float:
    """The area between a sheet's marks, px²; for three marks, twice their triangle."""
    x, y = numpy.array([sheet[number].mean(axis=0) for number in sorted(sheet)]).T
    area = abs(x @ numpy.roll(y, 1) - y @ numpy.roll(x, 1)) / 2
    return float(area if len(sheet) > FEWEST else 2 * area)


def _beside(seed: Found, marks: Sequence[Found]) -> list[Found]:
    """A mark, and those at the positions predicted from it."""
    marks_of_sheet = [seed]
    for number in range(len(centres(SHEET_MM))):
        near = [(_off(seed, one), k) for k, one in enumerate(marks) if one[0] == number != seed[0]]
        off, k = min(near, default=(NEAR_MM, 0))
        marks_of_sheet += [marks[k]] if off < NEAR_MM else []
    return marks_of_sheet


def _off(seed: Found, other: Found) -> float:
    """The distance of a mark from the position predicted by another of its sheet, mm."""
    corners = seed[1] @ numpy.array([1, 1j])
    right, up = (corners[[1, 2]] - corners[[0, 3]]).mean(), (corners[[0, 1]] - corners[[3, 2]]).mean()
    by = (centres(SHEET_MM)[other[0]] - centres(SHEET_MM)[seed[0]]) / SIDE_MM
    there = corners.mean() + by.real * right + by.imag * up
    seen = (other[1] @ numpy.array([1, 1j])).mean()
    return float(abs(seen - there) / max(abs(right), abs(up), 1e-9) * SIDE_MM)


def _in_order(sheet: dict[int, Array]) -> tuple[float, float]:
    """A sort key for sheets side by side, or one below the other."""
    x, y = numpy.mean([quad.mean(axis=0) for quad in sheet.values()], axis=0).tolist()
    side = max(float(numpy.ptp(numpy.concatenate([*sheet.values()]), axis=0).min()), 1.0)
    return round(y / side), x
