"""Rectifies a picture by the two given ends of a vector, and by its paper, if that shows the view."""

import cmath
import math
from dataclasses import replace

import numpy

from planes.check.vision.image.bend import PX_PER_MM, Bend
from planes.check.vision.image.lens import PHONE_FOCAL_LENGTH, UNKNOWN_TILT, CameraTilt, Lens
from planes.check.vision.image.picture import MOST_SHEET_PX, Flat, rectify_by_scale, remap_picture
from planes.check.vision.image.sheet_view import SheetView, sheet_view, similarity_homography, view_by_tilt
from planes.geometry.arrays import Greys
from planes.words import Phrase, Written
from planes.words.errors import PlanesError

LEAST_ASKEW_DEG, MOST_ASKEW_DEG = 0.5, 4.0  # less is a drawing error, more does not occur in a sheet laid straight
SHORTEST_SCALE_VECTOR_MM = 3.0  # a vector that shows neither scale nor direction
MOST_SIZE_DIFFERENCE = 0.06  # relative size difference at which squares, lines or sheets are not of the usual kind
MOST_DRAWING_ERROR_MM = 1.5  # maximum drawing error of a vector's length
PAPER_REFERENCE_ERRORS = {
    "squares": 0.003,
    "lines": 0.006,
    "edges": 0.006,
}  # relative error of a sheet rectified by ruling or edges
REFERENCES_DRAWN_ALONG = ("squares", "lines")  # followed by people when drawing
LEAST_REPORTED_TILT_DEG = 1.5  # less is not worth reporting
MOST_DISTANCE_FROM_POLE_MM = 420.0  # no drawing is farther from its pole


def rectify_by_two_points(
    grey: Greys,
    pole: complex,
    mark: complex,
    vector: complex,
    name: str = "",
    file_scale: float | None = None,
    held: CameraTilt | None = None,
    focal: float | None = None,
) -> Flat:
    """The picture by the ends of a true vector, the pole and a named mark, in pixels (x right, y down).

    It is rectified and scaled by squares, lines or edges of its paper, or rectified by text; otherwise it is only
    rotated, by no more than a sheet usually lies askew. The scale is that of its paper or file (``file_scale``) if it
    differs from the vector's by no more than a drawing error, or if the vector is too short; otherwise the vector's. A
    photograph of unknown tilt may be assigned a camera tilt (``held``). The focal length may be given (``focal``, in
    the picture's longer sides). The pole becomes the origin.
    """
    short = abs(vector) < SHORTEST_SCALE_VECTOR_MM
    if not (short and file_scale) and (abs(mark - pole) < 10 or not vector):
        raise PlanesError(Phrase("check_points"))
    focal = focal or PHONE_FOCAL_LENGTH
    view = view_by_tilt(grey, held.mirrored(), focal) if held else None
    if not held and not short:
        view = sheet_view(grey, file_scale or abs(mark - pole) / abs(vector), file_scale is not None, focal)
    drawn = view.bend.to_rectified(mark) - view.bend.to_rectified(pole) if view else mark - pole
    paper = view.by if view and view.by in PAPER_REFERENCE_ERRORS else None
    scale, by_file = _choose_scale(
        abs(drawn), abs(vector), 1.0 if paper else file_scale, MOST_SIZE_DIFFERENCE if paper else 1.0
    )
    askew = 0.0 if short else _sheet_rotation_deg(drawn, vector, paper)
    flat = _sheet_from_above(grey, view, pole, scale, askew) if view else rectify_by_scale(grey, scale, pole, askew)
    if askew:
        flat.notes.append(Phrase("check_askew", angle=Written(f"{abs(askew):.1f}")))
    flat.told = (name, abs(vector))
    flat.by_file = by_file
    flat.by_paper = paper is not None and not askew
    flat.aslant = PAPER_REFERENCE_ERRORS[paper] if paper else 0.0
    if not paper and file_scale is None and not short:
        height, width = grey.shape
        far = focal * max(grey.shape) / scale
        known = view.held.mirrored() if view else UNKNOWN_TILT
        flat.lens = Lens(
            flat.sheet_point_of_pixel(complex(width, height) / 2),
            far,
            flat.sheet_point_of_pixel(mark),
            bool(askew),
            known,
        )
    return flat


def _choose_scale(drawn: float, true_mm: float, file_scale: float | None, most: float) -> tuple[float, bool]:
    """Pixels per mm, and whether they are ``file_scale``.

    That is so if a vector of this length differs by no more than a drawing error, and by at most the share ``most``.
    """
    if file_scale is None or true_mm < SHORTEST_SCALE_VECTOR_MM:
        return file_scale or drawn / true_mm, file_scale is not None
    by_file = abs(drawn / true_mm / file_scale - 1) < min(MOST_DRAWING_ERROR_MM / true_mm, most)
    return file_scale if by_file else drawn / true_mm, by_file


def _sheet_rotation_deg(drawn: complex, vector: complex, paper: str | None) -> float:
    """The rotation of a sheet from a vector (y down), degrees.

    0 if its paper shows it, or if it is within a drawing error, or more than that of a sheet laid straight.
    """
    askew = math.degrees(cmath.phase(drawn.conjugate() / vector))
    least = math.degrees(MOST_DRAWING_ERROR_MM / abs(vector)) if paper else LEAST_ASKEW_DEG
    if paper not in REFERENCES_DRAWN_ALONG and least < abs(askew) < MOST_ASKEW_DEG:
        return askew
    return 0.0


def _sheet_from_above(grey: Greys, view: SheetView, pole: complex, scale: float, askew_deg: float) -> Flat:
    """The sheet from straight above by a view (``scale`` of its units per mm), its rotation corrected.

    Only the part within the size of a sheet is kept.
    """
    turn = cmath.rect(PX_PER_MM / scale, math.radians(askew_deg))
    bend = replace(view.bend, view=similarity_homography(turn) @ view.bend.view)
    low, high = _content_box(grey, bend, bend.to_rectified(pole))
    bend.view = similarity_homography(1.0, -low) @ bend.view
    size = round((high - low).real), round((high - low).imag)
    if math.prod(size) > MOST_SHEET_PX:
        raise PlanesError(Phrase("check_points"))
    at = bend.to_rectified(pole)
    flat = Flat(remap_picture(grey, bend, size), PX_PER_MM, -complex(at.real, size[1] - at.imag) / PX_PER_MM, "points")
    flat.bend = bend
    if view.tilt_deg > LEAST_REPORTED_TILT_DEG:
        flat.notes.append(Phrase(f"check_aside_{view.by}", angle=Written(f"{view.tilt_deg:.0f}")))
    return flat


def _content_box(grey: Greys, bend: Bend, pole: complex) -> tuple[complex, complex]:
    """The box of a picture's content on its sheet, pixels of the rectified one, limited to a sheet around the pole."""
    height, width = grey.shape
    share = numpy.linspace(0, 1, 9)
    far = MOST_DISTANCE_FROM_POLE_MM * PX_PER_MM
    seen = bend.to_rectified(width * share[:, None] + 1j * height * share)
    xs = seen.real.clip(pole.real - far, pole.real + far)
    ys = seen.imag.clip(pole.imag - far, pole.imag + far)
    return complex(xs.min(), ys.min()), complex(xs.max(), ys.max())
