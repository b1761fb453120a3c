"""Several blanks on one picture: each is found, however far off it lies; of one that is seen in part that is said."""

from pathlib import Path

import numpy as np
import pytest

pytest.importorskip("cv2")
import cv2

from planes.check.fiducials import MARK_SIDE_MM, SHEET_MM, corner_mark_cells, corner_mark_centres
from planes.check.vision.image.decoding import load
from planes.check.vision.image.picture import find_sheets, flatten
from planes.check.vision.image.several import group_marks_by_sheet, may_show_more_marks
from planes.documents.class_sorting import preview_sheet
from planes.geometry.arrays import Greys
from planes.words.errors import PlanesError

PX = 4.0  # to a mm
FAR = [(250, 100), (1000, 30), (1000, 800), (270, 700)]  # upper left, upper right, lower right, lower left


def sheet(without: tuple[int, ...] = ()) -> Greys:
    """A blank's marks on paper, some under thumbs."""
    out = np.full((int(SHEET_MM[1] * PX), int(SHEET_MM[0] * PX)), 235, np.uint8)
    for number, z in enumerate(corner_mark_centres(SHEET_MM)):
        if number not in without:
            side = int(MARK_SIDE_MM * PX)
            mark = cv2.resize(
                np.where(corner_mark_cells(number), 25, 235).astype(np.uint8), (side, side), interpolation=0
            )
            x, y = int(z.real * PX) - side // 2, int((SHEET_MM[1] - z.imag) * PX) - side // 2
            out[y : y + side, x : x + side] = mark
    return out


def pictured(near: Greys, far: Greys | None) -> Greys:
    """One sheet above another that is seen aslant from farther off, on a dark table, in soft focus and grain."""
    (h, w), table = near.shape, np.full((near.shape[0] + 60, near.shape[1] + 100), 60, np.uint8)
    below = table.copy()
    table[30 : 30 + h, 50 : 50 + w] = near
    if far is not None:
        warp = cv2.getPerspectiveTransform(
            np.array([(0, 0), (w, 0), (w, h), (0, h)], np.float32), np.array(FAR, np.float32)
        )
        below = cv2.warpPerspective(far, warp, below.shape[::-1], dst=below, borderMode=cv2.BORDER_TRANSPARENT)
    whole = cv2.GaussianBlur(np.vstack([table, below]), (0, 0), 1.0)
    return np.clip(whole + np.random.default_rng(5).normal(0, 4, whole.shape), 0, 255).astype(np.uint8)


def test_corner_marks_are_told_by_their_sheets() -> None:
    """Two sheets seen aslant, one under the other, a corner of the first under a thumb; and a mark of neither."""

    def seen(number: int, at: complex) -> tuple[int, object]:
        corners = [
            corner_mark_centres(SHEET_MM)[number] + MARK_SIDE_MM / 2 * z for z in (-1 + 1j, 1 + 1j, 1 - 1j, -1 - 1j)
        ]
        places = ((z + at) * 1.1j / (1 + 0.0005 * (z + at).imag) for z in corners)
        return number, np.array([(z.real, -z.imag) for z in places])

    upper = [seen(number, 225j + 4) for number in (0, 2, 3)]
    lower = [seen(number, 0j) for number in (3, 1, 0, 2)]
    seen_sheets = group_marks_by_sheet([upper[0], lower[0], seen(1, 500 + 500j), *lower[1:], *upper[1:]])
    found = seen_sheets.sheets
    assert seen_sheets.stray == 1 and sorted(sorted(sheet) for sheet in found) == [[0, 1, 2, 3], [0, 2, 3]]
    assert all(any(quad is one for _, one in upper) for quad in min(found, key=len).values())


def test_a_blank_farther_off_is_found_beside_a_near_one() -> None:
    """The outlines of some of its marks are smaller than a lone sheet's, by the picture's size."""
    grey = pictured(sheet(), sheet())
    found = find_sheets(grey)
    outlines = [cv2.arcLength(quad, True) / max(grey.shape) for one in found.sheets for quad in one.values()]
    assert [sorted(one) for one in found.sheets] == [[0, 1, 2, 3]] * 2 and found.stray == 0
    assert min(outlines) < 0.07, "the far sheet is near enough for any look"


def test_a_blank_none_of_whose_marks_are_seen_at_first_is_looked_for() -> None:
    """A first look that gives one whole sheet ends only where there is no room for another."""
    far = cv2.resize(sheet(), None, fx=0.35, fy=0.35, interpolation=cv2.INTER_AREA)
    small = np.full_like(sheet(), 60)
    small[200 : 200 + far.shape[0], 500 : 500 + far.shape[1]] = far
    grey = np.vstack([sheet(), small])
    assert [sorted(one) for one in find_sheets(grey).sheets] == [[0, 1, 2, 3]] * 2
    alone = group_marks_by_sheet([(n, q) for n, q in find_sheets(sheet()).sheets[0].items()])
    assert not may_show_more_marks(alone, sheet().size) and may_show_more_marks(alone, grey.size)


@pytest.mark.slow
def test_a_blank_seen_in_part_is_said(tmp_path: Path) -> None:
    """In the notes of the one that is read, and as a row of its own of a class; never in silence."""
    file, grey = tmp_path / "two.png", pictured(sheet(), sheet(without=(0, 3)))
    cv2.imwrite(str(file), grey)
    flat = flatten(grey)
    assert flat is not None and [(n.key, n.parts["count"]) for n in flat.notes] == [("check_blank_in_part", 2)]
    assert preview_sheet(str(file)).blanks == 2 and len(find_sheets(load(file, 0).grey).sheets) == 1
    with pytest.raises(PlanesError) as error:
        load(file, 1)
    assert error.value.phrase.key == "check_blank_in_part"
    assert find_sheets(pictured(sheet(), None)).sheet_count == 1
