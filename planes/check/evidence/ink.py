"""Ink on a flat picture: its light made even, printed marks taken out, and how dark any place of the sheet is."""

import numpy

from planes.check.evidence.contrast import inked
from planes.check.fiducials import INSET_MM, SIDE_MM, Square, squares
from planes.check.vision.image.opencv import cv, pieces, shrunk
from planes.check.vision.image.picture import Flat
from planes.geometry.arrays import Array, Booleans, Complexes, Greys, Indices
from planes.words.frozen import frozen, replace

LETTER_MM = 7.5  # smaller separate marks of ink are letters
DARK = 0.4  # of a line's darkness: less is paper, a grid's line, or a line rubbed out
LIGHT = 0.3  # of a line's darkness: is paper
PENCIL = 75  # the grey of a line's middle
PAPER = 255 - LIGHT * (255 - PENCIL)  # the grey at which paper (with a grid or what was rubbed out) ends
EDGE = PAPER - DARK * (PAPER - PENCIL)  # and at which ink begins
RIM_MM = 0.35  # about a place where the darkest ink is looked for
WHITE = 250  # the grey of paper in even light
TITLE_MM = INSET_MM[1] + SIDE_MM / 2 + 2  # a blank's title stands between its upper marks
PRINTED, FULL = 0.6, 0.2  # of paper's grey, what is printed; the share of a code that is black
FRAME_MM = (21.5, 8.5)  # how much of a sheet is its frame: at the left, and at the other edges


@frozen
class Ink:
    """A sheet's ink: in ``even`` lines are all as dark, and it is 255 where there is none but lines may be."""

    flat: Flat
    even: Greys
    dark: Greys  # how much darker than paper the picture is

    @property
    def mask(self) -> Greys:
        """Where there is ink: ones and zeros, a pixel each."""
        return (self.even < EDGE).astype(numpy.uint8)

    def darkest(self, z: Complexes) -> Array:
        """How much darker than paper the picture is about places in mm, at the most."""
        wide = round(2 * RIM_MM * self.flat.scale) | 1
        dark, local = cv().dilate(self.dark, numpy.ones((wide, wide), numpy.uint8)), (z - self.flat.corner)
        h, w = dark.shape
        down = (h - local.imag * self.flat.scale).clip(0, h - 1).astype(int)
        held: Array = dark[down, (local.real * self.flat.scale).clip(0, w - 1).astype(int)].astype(float)
        return held


def ink_of(flat: Flat) -> Ink:
    """The ink of a flat picture, without letters and printed marks."""
    dark = darkness(flat)
    shares, followed = inked(dark, flat.scale, 255 - PENCIL, TITLE_MM * (flat.by == "marks"))
    every = Ink(flat, 255 - shares, dark)
    labels, sizes = _pieces(flat, every.mask | followed)
    return replace(every, even=numpy.where(_spread((sizes >= LETTER_MM)[labels]), every.even, 255))


def darkness(flat: Flat) -> Greys:
    """How much darker than paper the picture is, as if the light were the same everywhere."""
    even = cv().divide(flat.grey, light_of(flat), scale=float(WHITE))
    even = cv().GaussianBlur(even, (0, 0), 0.8)
    if flat.by in ("marks", "frame"):
        _whiten_printed(flat, even)
    dark: Greys = WHITE - numpy.minimum(even, WHITE)
    return dark


def light_of(flat: Flat) -> Greys:
    """The picture as if nothing were drawn on its paper."""
    cv2 = cv()
    light = cv2.dilate(shrunk(flat.grey, 0.25), numpy.ones((7, 7), numpy.uint8))
    light = cv2.GaussianBlur(light, (0, 0), 0.7 * flat.scale)
    paper: Greys = cv2.resize(light, flat.grey.shape[::-1], interpolation=cv2.INTER_LINEAR)
    return paper


def _pieces(flat: Flat, mask: Greys) -> tuple[Indices, Array]:
    """Separate pieces of ink: the number of each pixel's, and how large each is below a blank's title, mm (0: no
    ink)."""
    labels, stats = pieces(mask)
    sizes, title = numpy.maximum(stats[:, 2], stats[:, 3]), round(TITLE_MM * flat.scale)
    for k in numpy.flatnonzero(stats[:, 1] < title) if flat.by == "marks" else ():
        left, top, width, height, _ = stats[k]
        below = labels[title : top + height, left : left + width] == k
        sizes[k] = max(len(below), numpy.ptp(numpy.flatnonzero(below.any(axis=0)))) if below.any() else 0
    sizes[0] = 0
    return labels, sizes / flat.scale


def _spread(where: Booleans) -> Booleans:
    """The places, and those around them where ink fades."""
    wider: Greys = cv().dilate(where.astype(numpy.uint8), numpy.ones((9, 9), numpy.uint8))
    return wider > 0


def printed_on(flat: Flat) -> list[Square]:
    """Squares of a sheet on which a mark is printed; whether there is a code, it shows itself."""
    if flat.by != "marks":
        return []
    *marks, (z, reach) = squares(flat.size_mm)
    (left, low), (right, top) = (flat.px(z + by * reach * (1 + 1j)) for by in (-1, 1))
    box = flat.grey[max(int(top), 0) : int(low), int(left) : int(right)]
    black = (box < PRINTED * numpy.quantile(box, 0.9)).mean()
    return [*marks, (z, reach)] if black > FULL else marks


def _whiten_printed(flat: Flat, even: Greys) -> None:
    """Paint over the corner marks, the frame and what lies outside of it."""
    for z, reach in printed_on(flat):
        (x, y), r = flat.px(z), reach * flat.scale
        cv().rectangle(even, (int(x - r), int(y - r)), (int(x + r), int(y + r)), 255, -1)
    left, other = (int(mm * flat.scale) for mm in FRAME_MM)
    even[:other], even[-other:] = 255, 255
    even[:, :left], even[:, -other:] = 255, 255
