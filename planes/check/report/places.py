"""Small pictures of a drawing, and of each wrong place next to the right construction."""

import base64
import io
from collections.abc import Iterable, Sequence
from itertools import islice

from planes.check.grading.grading import Grading
from planes.check.grading.paper import Box
from planes.check.outcome import Outcome
from planes.check.report.shown import Vector, point_coordinates, shown_plans, true_marks
from planes.geometry.plane import bounding_corners
from planes.words.names import POLE_LABEL
from planes.words.records import Json

MOST_PLACES = 3  # maximum number of wrong places shown of a drawing
WINDOW_HALF_SIZES_MM = (18.0, 90.0)  # minimum and maximum half size of a window around a wrong place
THUMBNAIL_SIDE_PX, PLACE_PICTURE_SIDE_PX, JPEG_QUALITY, THUMBNAIL_MARGIN_MM = 170, 320, 62, 12.0


def wrong_places(outcome: Outcome) -> list[Json]:
    """Windows around the places where a drawing goes wrong, the first one first."""
    if outcome.grading is None or outcome.verdict != "wrong":
        return []
    return list(islice(_place_windows(outcome, outcome.grading), MOST_PLACES))


def _place_windows(outcome: Outcome, grading: Grading) -> Iterable[Json]:
    shown = shown_plans(outcome)
    paper = outcome.paper
    kind = outcome.bench.kind
    truth = true_marks(outcome)
    if kind == "force":  # there its order is free, and a step leads to the right position
        truth = {n: b for n, z in shown.marks.items() for a, b in shown.next if a == z}
    wrong = [m.label for m, verdict in grading.verdicts.items() if verdict == "wrong"]
    for name in dict.fromkeys([outcome.first_wrong or "", *wrong]):
        places = [z for z in (shown.marks.get(name), truth.get(name)) if z is not None]
        if name == POLE_LABEL or not places:
            continue
        middle = sum(places) / len(places)
        apart = max(abs(z - places[0]) for z in places)
        reach = min(max(WINDOW_HALF_SIZES_MM[0], 0.75 * apart + 6), WINDOW_HALF_SIZES_MM[1])
        box = middle.real - reach, middle.imag - reach, middle.real + reach, middle.imag + reach
        yield {
            "name": name,
            "box": [round(v, 2) for v in box],
            "at": point_coordinates(places[0], 2),
            "picture": jpeg_data_address(crop_picture(paper.picture, paper.box, box)),
            "strokes": _vector_coordinates(_strokes_near_box(paper.strokes, box)),
            "own": _vector_coordinates(shown.own),
            "true": _vector_coordinates(shown.true),
            "next": _vector_coordinates(shown.next),
            "lines": kind == "position",
        }


def _vector_coordinates(all_: Iterable[Vector]) -> list[list[float]]:
    return [[*point_coordinates(a, 2), *point_coordinates(b, 2)] for a, b in all_]


def _strokes_near_box(strokes: Iterable[Vector], box: Box) -> list[Vector]:
    """Strokes that may be visible in a window."""
    left, lower, right, upper = box

    def shows(stroke: Vector) -> bool:
        low, high = bounding_corners(stroke)
        return low.real <= right and high.real >= left and low.imag <= upper and high.imag >= lower

    return [*filter(shows, strokes)]


def jpeg_data_address(data: bytes) -> str:
    """A JPEG as a data address."""
    if data:
        return f"data:image/jpeg;base64,{base64.b64encode(data).decode()}"
    return ""


def thumbnail_jpeg(outcome: Outcome | None, small: bytes) -> bytes:
    """A small picture (JPEG) of a drawing: the part with its plan, if read, else ``small``; b"" without a picture."""
    if not outcome or not outcome.paper.picture:
        return _cropped_jpeg(small, None, THUMBNAIL_SIDE_PX) if small else b""
    paper = outcome.paper
    ends = [z for v in shown_plans(outcome).own for z in v]
    if len(ends) < 2:
        return _cropped_jpeg(paper.picture, None, THUMBNAIL_SIDE_PX)
    low, high = bounding_corners(ends)
    box = (
        low.real - THUMBNAIL_MARGIN_MM,
        low.imag - THUMBNAIL_MARGIN_MM,
        high.real + THUMBNAIL_MARGIN_MM,
        high.imag + THUMBNAIL_MARGIN_MM,
    )
    return crop_picture(paper.picture, paper.box, box, THUMBNAIL_SIDE_PX)


def crop_picture(picture: bytes, lies: Box | None, box: Box, longest: int = PLACE_PICTURE_SIDE_PX) -> bytes:
    """The part of a picture in a window, ``lies`` being the picture's position (mm from the pole)."""
    if not picture or lies is None:
        return b""
    x0, y0, x1, y1 = lies
    part = ((box[0] - x0) / (x1 - x0), (y1 - box[3]) / (y1 - y0), (box[2] - x0) / (x1 - x0), (y1 - box[1]) / (y1 - y0))
    return _cropped_jpeg(picture, [min(max(share, -1.0), 2.0) for share in part], longest)  # marks may be anywhere


def _cropped_jpeg(picture: bytes, part: Sequence[float] | None, longest: int) -> bytes:
    from PIL import Image

    with Image.open(io.BytesIO(picture), formats=("JPEG",)) as opened:
        shown = opened.convert("L")
    if part:
        w, h = shown.size
        left, top, right, low = (round(share * size) for share, size in zip(part, (w, h, w, h), strict=True))
        out = Image.new("L", (max(right - left, 1), max(low - top, 1)), 255)
        out.paste(shown, (-left, -top))
        shown = out
    shown.thumbnail((longest, longest))
    written = io.BytesIO()
    shown.save(written, "JPEG", quality=JPEG_QUALITY)
    return written.getvalue()
