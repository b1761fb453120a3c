"""Faults without overlaps that a teacher would circle on a sheet.

These are small letters, names that read as one word, figures out of the order of the calculation or of their rank, and
coincident forces.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from itertools import combinations

import shapely

from render.labels.footprints import box_around_marks
from render.paper.hues import DETAIL_NAME_SUFFIX
from render.paper.marks import Arrow, Line, Text
from render.paper.typeset import lay_out_text, plain_text, text_box_corners
from render.sheet import Sheet
from render.views import View

LEAST_MM = 1.8  # the smallest letters of ГОСТ 2.304
APART = 0.6  # of a letter between adjacent names
LARGEST_MM = 7.0
AS_LARGE = 1.01  # figures that differ by less are equally large
AT_ONE_MM, FORKED_MM = 0.1, 1.0
BESIDE_MM, ASKEW = 4.0, 0.05  # maximum overlap of two arrows on one line; angle of lines that only cross, radians


def small_letters(sheet: Sheet) -> Iterator[str]:
    """Texts with letters or indices below the smallest of the standard."""
    for text in (m for m in sheet.marks if isinstance(m, Text)):
        if any(run.height < LEAST_MM - 1e-9 for run in lay_out_text(text).runs):
            yield f"{text.text!r} has letters under {LEAST_MM} mm"


def one_word(sheet: Sheet) -> Iterator[str]:
    """Names in a row that read as one word."""
    for view, _, _ in sheet.views:
        yield from _joined([m for m in view.marks if isinstance(m, Text)])


def _joined(texts: Sequence[Text]) -> Iterator[str]:
    signs = {round(m.place.imag, 6) for m in texts if set("=+Σ") & set(m.text)}  # of equations
    named = [m for m in texts if m.name and not m.turn_deg and round(m.place.imag, 6) not in signs]
    boxes = [text_box_corners(m) for m in named]
    tree = shapely.STRtree([shapely.box(b[0].real, b[0].imag, b[2].real, b[2].imag) for b in boxes])
    for i, j in sorted(map(tuple, tree.query(tree.geometries, "dwithin", APART * LARGEST_MM).T.tolist())):
        level = min(boxes[i][2].imag, boxes[j][2].imag) - max(boxes[i][0].imag, boxes[j][0].imag)
        gap, high = boxes[j][0].real - boxes[i][2].real, min(named[i].height, named[j].height)
        if level > high / 2 and 0 < gap < APART * high - 1e-3:
            one, other = plain_text(named[i].text), plain_text(named[j].text)
            yield f"{one!r} and {other!r} read as one word, {gap:.2f} mm apart"


def out_of_order(sheet: Sheet) -> Iterator[str]:
    """Figures before an earlier one, and repeated steps of the calculation."""
    figures = [(v, left, top) for v, left, top in sheet.views if v.figure]
    for (one, x, y), (two, u, v) in combinations(figures, 2):
        if u + two.width < x and v - two.height > y - one.height:
            yield f"{two.key} stands before {one.key}"
    steps = [v.step for v, _, _ in figures]
    again = [s for k, s in enumerate(steps) if s and s in steps[:k] and steps[k - 1] != s]
    yield from (f"the step {s} is begun again" for s in again)


def superposed(sheet: Sheet) -> Iterator[str]:
    """Coincident forces in one view that their numbered ends do not distinguish."""
    for view, _, _ in sheet.views:
        yield from _upon(view)


def _upon(view: View) -> Iterator[str]:
    shown = ("force", "result") if view.key.startswith("force") else ("force",)
    forces = [m for m in view.marks if m.layer in shown and isinstance(m, (Arrow, Line))]
    arrows = [m for m in forces if isinstance(m, Arrow) and m.name]
    parts = [
        m for m in forces if isinstance(m, Line) and m.name.endswith(DETAIL_NAME_SUFFIX)
    ]  # of forces that end outside a detail
    ends = [(m.name, m.start, m.end) for m in arrows] + [(m.name, m.points[0], m.points[1]) for m in parts]
    lines = [shapely.LineString([(z.real, z.imag) for z in (a, b)]) for _, a, b in ends]
    texts = [m for m in view.marks if isinstance(m, Text)]
    numbered = {m.name.removeprefix("value ") for m in texts if re.search(r"\(\d+–\d+\)", m.text)}
    numbered |= {name for name, a, b in ends if any(x in numbered and (a, b) == (d, c) for x, c, d in ends)}
    for (one, a), (two, b) in combinations(zip(ends, lines, strict=True), 2):
        if {one[0].removesuffix(DETAIL_NAME_SUFFIX), two[0].removesuffix(DETAIL_NAME_SUFFIX)} <= numbered or _forked(
            one[1:], two[1:]
        ):
            continue
        turn = (one[2] - one[1]) * (two[2] - two[1]).conjugate()
        if abs(turn.imag) < ASKEW * abs(turn) and a.buffer(0.3).intersection(b).length > BESIDE_MM:
            yield f"{one[0]} and {two[0]} are drawn upon each other in {view.key}"


def _forked(one: Sequence[complex], two: Sequence[complex]) -> bool:
    """Whether two forces start at one corner of a polygon and diverge by more than a millimetre."""
    joined = [(k, j) for k in (0, 1) for j in (0, 1) if abs(one[k] - two[j]) < AT_ONE_MM]
    for k, j in joined:
        a, b = one[1 - k] - one[k], two[1 - j] - two[j]
        reach = min(abs(a), abs(b))
        return abs(a / abs(a) - b / abs(b)) * reach > FORKED_MM
    return False


def longest(view: View) -> float:
    """The longer side of a drawing, without its words; of a force plan without its details."""
    drawn = [m for m in view.marks if not isinstance(m, Text) and m.layer != "text"]
    if view.key.startswith("force"):
        drawn = [m for m in drawn if isinstance(m, Arrow) and not m.name.endswith(DETAIL_NAME_SUFFIX)]
    x0, y0, x1, y1 = box_around_marks(drawn)
    return max(x1 - x0, y1 - y0)


def unsightly(sheet: Sheet) -> list[str]:
    """All of these, except figures out of rank."""
    found = small_letters, one_word, out_of_order, superposed
    return [fault for of_kind in found for fault in of_kind(sheet)]
