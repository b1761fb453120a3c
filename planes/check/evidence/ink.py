"""Ink on a rectified picture: lighting evened out, printed marks removed, and the darkness anywhere on the sheet."""

import numpy

from planes.check.evidence.contrast import relative_line_darkness
from planes.check.fiducials import MARK_INSETS_MM, MARK_SIDE_MM, Square, mark_and_code_squares
from planes.check.vision.image.opencv import connected_components, cv, resize_by_factor
from planes.check.vision.image.picture import Flat
from planes.geometry.arrays import Array, Booleans, Complexes, Greys, Indices
from planes.words.frozen import frozen, replace

LARGEST_LETTER_MM = 7.5  # smaller separate pieces of ink are letters
INK_DARKNESS = 0.4  # relative to a line: less is paper, a grid line or an erased line
PAPER_DARKNESS = 0.3  # relative to a line: paper
PENCIL_GREY_LEVEL = 75  # grey level in the middle of a line
PAPER_GREY_LIMIT = 255 - PAPER_DARKNESS * (255 - PENCIL_GREY_LEVEL)  # the limit of paper (with a grid or erased lines)
INK_GREY_LIMIT = PAPER_GREY_LIMIT - INK_DARKNESS * (PAPER_GREY_LIMIT - PENCIL_GREY_LEVEL)  # the limit of ink
DARKEST_INK_RADIUS_MM = 0.35  # search radius of the darkest ink around a point
EVEN_PAPER_GREY_LEVEL = 250  # grey level of paper in even light
TITLE_HEIGHT_MM = MARK_INSETS_MM[1] + MARK_SIDE_MM / 2 + 2  # a blank's title is between its upper marks
PRINTED_GREY_RATIO = 0.6  # relative to paper, printed
CODE_BLACK_SHARE = 0.2  # black share of a code
FRAME_WIDTHS_MM = (21.5, 8.5)  # width of a sheet's frame: at the left, and at the other edges


@frozen
class Ink:
    """The ink of a sheet: in ``even`` all lines are equally dark, with 255 where lines without ink are possible."""

    flat: Flat
    even: Greys
    dark: Greys  # darkness relative to paper

    @property
    def mask(self) -> Greys:
        """Where there is ink: ones and zeros, one per pixel."""
        return (self.even < INK_GREY_LIMIT).astype(numpy.uint8)

    def darkest_around(self, z: Complexes) -> Array:
        """The maximum darkness relative to paper around points in mm."""
        wide = round(2 * DARKEST_INK_RADIUS_MM * self.flat.scale) | 1
        dark = cv().dilate(self.dark, numpy.ones((wide, wide), numpy.uint8))
        local = z - self.flat.corner
        h, w = dark.shape
        down = (h - local.imag * self.flat.scale).clip(0, h - 1).astype(int)
        held: Array = dark[down, (local.real * self.flat.scale).clip(0, w - 1).astype(int)].astype(float)
        return held


def drawing_ink(flat: Flat) -> Ink:
    """The ink of a rectified picture, without letters and printed marks."""
    dark = darkness_over_paper(flat)
    shares, followed = relative_line_darkness(
        dark, flat.scale, 255 - PENCIL_GREY_LEVEL, TITLE_HEIGHT_MM * (flat.by == "marks")
    )
    every = Ink(flat, 255 - shares, dark)
    labels, sizes = _pieces_and_sizes(flat, every.mask | followed)
    return replace(every, even=numpy.where(_widen_to_fading_ink((sizes >= LARGEST_LETTER_MM)[labels]), every.even, 255))


def darkness_over_paper(flat: Flat) -> Greys:
    """The darkness of the picture relative to paper, corrected for uneven light."""
    even = cv().divide(flat.grey, paper_light(flat), scale=float(EVEN_PAPER_GREY_LEVEL))
    even = cv().GaussianBlur(even, (0, 0), 0.8)
    if flat.by in ("marks", "frame"):
        _whiten_printed(flat, even)
    dark: Greys = EVEN_PAPER_GREY_LEVEL - numpy.minimum(even, EVEN_PAPER_GREY_LEVEL)
    return dark


def paper_light(flat: Flat) -> Greys:
    """The picture of the paper without the drawing."""
    cv2 = cv()
    light = cv2.dilate(resize_by_factor(flat.grey, 0.25), numpy.ones((7, 7), numpy.uint8))
    light = cv2.GaussianBlur(light, (0, 0), 0.7 * flat.scale)
    paper: Greys = cv2.resize(light, flat.grey.shape[::-1], interpolation=cv2.INTER_LINEAR)
    return paper


def _pieces_and_sizes(flat: Flat, mask: Greys) -> tuple[Indices, Array]:
    """Separate pieces of ink: the number of each pixel's, and their sizes below a blank's title, mm (0: no ink)."""
    labels, stats = connected_components(mask)
    sizes = numpy.maximum(stats[:, 2], stats[:, 3])
    title = round(TITLE_HEIGHT_MM * flat.scale)
    for k in numpy.flatnonzero(stats[:, 1] < title) if flat.by == "marks" else ():
        left, top, width, height, _ = stats[k]
        below = labels[title : top + height, left : left + width] == k
        sizes[k] = max(len(below), numpy.ptp(numpy.flatnonzero(below.any(axis=0)))) if below.any() else 0
    sizes[0] = 0
    return labels, sizes / flat.scale


def _widen_to_fading_ink(where: Booleans) -> Booleans:
    """The pixels and their surroundings where ink fades."""
    wider: Greys = cv().dilate(where.astype(numpy.uint8), numpy.ones((9, 9), numpy.uint8))
    return wider > 0


def printed_squares(flat: Flat) -> list[Square]:
    """Squares of a sheet with printed marks; a code is detected by its ink."""
    if flat.by != "marks":
        return []
    *marks, (z, reach) = mark_and_code_squares(flat.size_mm)
    (left, low), (right, top) = (flat.mm_to_px(z + by * reach * (1 + 1j)) for by in (-1, 1))
    box = flat.grey[max(int(top), 0) : int(low), int(left) : int(right)]
    black = (box < PRINTED_GREY_RATIO * numpy.quantile(box, 0.9)).mean()
    return [*marks, (z, reach)] if black > CODE_BLACK_SHARE else marks


def _whiten_printed(flat: Flat, even: Greys) -> None:
    """Paints over the corner marks, the frame and the area outside it."""
    for z, reach in printed_squares(flat):
        x, y = flat.mm_to_px(z)
        r = reach * flat.scale
        cv().rectangle(even, (int(x - r), int(y - r)), (int(x + r), int(y + r)), 255, -1)
    left, other = (int(mm * flat.scale) for mm in FRAME_WIDTHS_MM)
    even[:other] = 255
    even[-other:] = 255
    even[:, :left] = 255
    even[:, -other:] = 255
