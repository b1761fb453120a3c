"""Several blanks on one picture: assigns corner marks to sheets."""

from collections.abc import Sequence

import numpy

from planes.check.fiducials import MARK_SIDE_MM, corner_mark_centres
from planes.geometry.arrays import Array
from planes.words.frozen import frozen

# tolerance of a mark predicted from another, seen obliquely; other sheets' marks are 200 mm off
PREDICTED_MARK_TOLERANCE_MM = 90.0
LEAST_MARKS_PER_SHEET = 3  # marks that determine the position of a sheet
# of the area between a sheet's marks: another sheet, smaller if more distant, fits in as much
OTHER_SHEET_AREA_RATIO = 1.0

SheetMarks = dict[int, Array]  # the corners of a sheet's marks by their numbers
Found = tuple[int, Array]  # the number of a mark, and its corners in pixels, clockwise from the upper left


@frozen
class SheetsSeen:
    """The marks of each sheet by their numbers, sheets in reading order; of a single sheet all, however few."""

    sheets: list[SheetMarks]
    stray: int = 0  # marks of other sheets, too few to locate these

    @property
    def partial_sheet_mark_count(self) -> int:
        """The marks of a partly visible sheet: at least two, since a single one may be false."""
        return self.stray if self.stray > 1 else 0

    @property
    def sheet_count(self) -> int:
        """The number of sheets, including a partly visible one."""
        return len(self.sheets) + bool(self.partial_sheet_mark_count)


def group_marks_by_sheet(marks: Sequence[Found]) -> SheetsSeen:
    """Marks by their sheets."""
    if len({number for number, _ in marks}) == len(marks):
        return SheetsSeen([dict(marks)] if marks else [])
    left = list(marks)
    sheets = []
    while left:
        taken = _marks_of_same_sheet(left[0], left[1:])
        if len(taken) >= LEAST_MARKS_PER_SHEET:
            sheets.append(dict(taken))
        else:
            taken = left[:1]
        left = [one for one in left if not any(one is other for other in taken)]
    return SheetsSeen(sorted(sheets, key=_reading_order_key), len(marks) - sum(map(len, sheets)))


def may_show_more_marks(seen: SheetsSeen, picture: float) -> bool:
    """Whether a picture of this area (px²) may show more marks.

    The known ones are too few for their sheet, or leave room for another sheet.
    """
    if seen.stray or any(len(sheet) < LEAST_MARKS_PER_SHEET for sheet in seen.sheets):
        return True
    areas = [_sheet_area_px2(sheet) for sheet in seen.sheets]
    return picture - sum(areas) > OTHER_SHEET_AREA_RATIO * min(areas)


def _sheet_area_px2(sheet: SheetMarks) -> float:
    """The area between a sheet's marks, px²; for three marks, twice their triangle."""
    x, y = numpy.array([sheet[number].mean(axis=0) for number in sorted(sheet)]).T
    area = abs(x @ numpy.roll(y, 1) - y @ numpy.roll(x, 1)) / 2
    return float(area if len(sheet) > LEAST_MARKS_PER_SHEET else 2 * area)


def _marks_of_same_sheet(seed: Found, marks: Sequence[Found]) -> list[Found]:
    """A mark, and those at the positions predicted from it."""
    marks_of_sheet = [seed]
    for number in range(len(corner_mark_centres())):
        near = [(_prediction_error_mm(seed, one), k) for k, one in enumerate(marks) if one[0] == number != seed[0]]
        off, k = min(near, default=(PREDICTED_MARK_TOLERANCE_MM, 0))
        if off < PREDICTED_MARK_TOLERANCE_MM:
            marks_of_sheet.append(marks[k])
    return marks_of_sheet


def _prediction_error_mm(seed: Found, other: Found) -> float:
    """The distance of a mark from the position predicted by another of its sheet, mm."""
    corners = seed[1] @ numpy.array([1, 1j])
    right = (corners[[1, 2]] - corners[[0, 3]]).mean()
    up = (corners[[0, 1]] - corners[[3, 2]]).mean()
    by = (corner_mark_centres()[other[0]] - corner_mark_centres()[seed[0]]) / MARK_SIDE_MM
    there = corners.mean() + by.real * right + by.imag * up
    seen = (other[1] @ numpy.array([1, 1j])).mean()
    return float(abs(seen - there) / max(abs(right), abs(up), 1e-9) * MARK_SIDE_MM)


def _reading_order_key(sheet: SheetMarks) -> tuple[float, float]:
    """A sort key for sheets side by side, or one below the other."""
    x, y = numpy.mean([quad.mean(axis=0) for quad in sheet.values()], axis=0).tolist()
    side = max(float(numpy.ptp(numpy.concatenate([*sheet.values()]), axis=0).min()), 1.0)
    return round(y / side), x
