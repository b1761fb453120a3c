"""Ink on a flat picture: its light made even, printed marks taken out, and how dark any place of the sheet is."""

import statistics
from collections.abc import Sequence
from dataclasses import dataclass

import numpy

from planes.check.evidence.contrast import inked
from planes.check.fiducials import ARM_MM, INSET_MM, SIDE_MM, Square, squares
from planes.check.vision.image.picture import Flat, cv
from planes.geometry.arrays import Array, Booleans, Complexes, Greys, Indices, Points

LETTER_MM = 7.5  # smaller separate marks of ink are letters
SPECK_MM, USUAL_MM, LIKE = 1.5, 3.5, 1.3  # smaller ones are none; their usual size; how much larger one may be
DARK = 0.4  # of a line's darkness: less is paper, a grid's line, or a line rubbed out
LIGHT = 0.3  # of a line's darkness: is paper
PENCIL = 75  # the grey of a line's middle
PAPER = 255 - LIGHT * (255 - PENCIL)  # the grey at which paper (with a grid or what was rubbed out) ends
EDGE = PAPER - DARK * (PAPER - PENCIL)  # and at which ink begins
HEART_MM, RIM_MM = 1.0, 0.35  # about a printed cross's middle, where lines are drawn from; about its arms
WHITE = 250  # the grey of paper in even light
TITLE_MM = INSET_MM[1] + SIDE_MM / 2 + 2  # a blank's title stands between its upper marks
PRINTED, FULL = 0.6, 0.2  # of paper's grey, what is printed; the share of a code that is black
FRAME_MM = (21.5, 8.5)  # how much of a sheet is its frame: at the left, and at the other edges


@dataclass
class Ink:
    """A sheet's ink: in ``even`` lines are all as dark, and it is 255 where there is none but lines may be."""

    flat: Flat
    even: Greys
    whole: Greys  # with what is too small for lines
    dark: Greys  # how much darker than paper the picture is
    printed: list[Square]  # on the sheet: nothing is seen in them
    letters: Booleans | None = None  # where there may be letters, or short vectors

    @property
    def mask(self) -> Greys:
        """Where there is ink: ones and zeros, a pixel each."""
        return (self.even < EDGE).astype(numpy.uint8)

    def at(self, z: Complexes) -> Array:
        """Darkness of places in mm (an array of complex numbers of one or two axes): 0 of paper, 1 of a line."""
        dark: Array = (PAPER - self._sampled(self.even, z, 255)) / (PAPER - PENCIL)
        return dark.clip(0, 1)

    def raw(self, z: Complexes) -> Array:
        """How much darker than paper the picture is at places in mm."""
        return self._sampled(self.dark, z, 0)

    def _sampled(self, picture: Greys, z: Complexes, outside: int) -> Array:
        """A picture's greys at places in mm (an array of one or two axes)."""
        cv2, local = cv(), (z - self.flat.corner) * self.flat.scale
        rows = numpy.atleast_2d(local.real), numpy.atleast_2d(picture.shape[0] - local.imag)
        across, down = (numpy.ascontiguousarray(r, numpy.float32) for r in rows)
        grey = cv2.remap(picture, across, down, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=outside)
        greys: Array = grey.astype(numpy.float32).reshape(numpy.shape(z))
        return greys

    def darkest(self, z: Complexes) -> Array:
        """How much darker than paper the picture is about places in mm, at the most."""
        wide = round(2 * RIM_MM * self.flat.scale) | 1
        dark, local = cv().dilate(self.dark, numpy.ones((wide, wide), numpy.uint8)), (z - self.flat.corner)
        h, w = dark.shape
        down = (h - local.imag * self.flat.scale).clip(0, h - 1).astype(int)
        held: Array = dark[down, (local.real * self.flat.scale).clip(0, w - 1).astype(int)].astype(float)
        return held

    def lettered(self, z: Points) -> Booleans:
        """Whether there may be letters at places in mm (an array of complex numbers)."""
        local = (numpy.atleast_1d(z) - self.flat.corner) * self.flat.scale
        if self.letters is None:
            return numpy.zeros(len(local), bool)
        down = numpy.clip(self.even.shape[0] - local.imag, 0, self.even.shape[0] - 1).astype(int)
        across = numpy.clip(local.real, 0, self.even.shape[1] - 1).astype(int)
        held: Booleans = self.letters[down, across]
        return held

    def bare(self, z: complex, reach: float) -> bool:
        """Whether there is no ink at all in a square about a place, ``reach`` mm to each side."""
        x, y = self.flat.px(z)
        half = reach * self.flat.scale
        part = self.even[max(int(y - half), 0) : max(int(y + half), 0), max(int(x - half), 0) : max(int(x + half), 0)]
        return part.size == 0 or int(part.min()) >= EDGE

    def covered(self, a: complex, b: complex, reach: float = 0.45) -> float:
        """The share of the way from ``a`` to ``b`` along which there is ink, ``reach`` mm to either side."""
        length = abs(b - a)
        if length < 2 * reach:
            return 1.0
        along = numpy.linspace(a, b, max(4, int(length / 0.3)))
        across = 1j * (b - a) / length * numpy.linspace(-reach, reach, 7)
        dark = self.at(along[:, None] + across[None, :]).max(axis=1) > DARK
        return float(dark.mean())


def ink_of(flat: Flat, cross: complex | None = None) -> Ink:
    """The ink of a flat picture, without letters and printed marks; a cross may be printed at a place."""
    printed = printed_on(flat)
    dark = darkness(flat, printed)
    shares, followed = inked(dark, flat.scale, 255 - PENCIL, TITLE_MM * (flat.by == "marks"))
    ink = Ink(flat, 255 - shares, 255 - shares, dark, printed)
    labels, sizes = _pieces(ink, ink.mask | followed)
    ink.even = numpy.where(_spread((sizes >= LETTER_MM)[labels]), ink.whole, 255)
    if cross is not None:
        ink.letters = _joined(ink, cross, [mm for mm in sizes if SPECK_MM < mm < LETTER_MM])
    return ink


def darkness(flat: Flat, printed: Sequence[Square]) -> Greys:
    """How much darker than paper the picture is, as if the light were the same everywhere."""
    even = cv().divide(flat.grey, light_of(flat), scale=float(WHITE))
    even = cv().GaussianBlur(even, (0, 0), 0.8)
    if flat.by in ("marks", "frame"):
        _whiten_printed(flat, even, printed)
    dark: Greys = WHITE - numpy.minimum(even, WHITE)
    return dark


def light_of(flat: Flat) -> Greys:
    """The picture as if nothing were drawn on its paper."""
    cv2 = cv()
    small = cv2.resize(flat.grey, None, fx=0.25, fy=0.25, interpolation=cv2.INTER_AREA)
    light = cv2.dilate(small, numpy.ones((7, 7), numpy.uint8))
    light = cv2.GaussianBlur(light, (0, 0), 0.7 * flat.scale)
    paper: Greys = cv2.resize(light, flat.grey.shape[::-1], interpolation=cv2.INTER_LINEAR)
    return paper


def _joined(ink: Ink, cross: complex, letters: Sequence[float]) -> Booleans:
    """Where there is ink no larger than letters (so large are the others) that but a printed cross joins to lines."""
    mask = ink.mask
    for way in (1, -1, 1j, -1j):  # without the arms; lines are drawn from the cross's middle
        arm = numpy.array([ink.flat.px(cross + way * mm) for mm in (HEART_MM, ARM_MM)]).round().astype(numpy.int32)
        cv().polylines(mask, [arm], False, 0, round(2 * RIM_MM * ink.flat.scale))
    parts, sizes = _pieces(ink, mask)
    return (parts > 0) & (sizes < LIKE * statistics.median(letters or [USUAL_MM]))[parts]


def _pieces(ink: Ink, mask: Greys) -> tuple[Indices, Array]:
    """Separate pieces of ink: the number of each pixel's, and how large each is below a blank's title, mm (0: no
    ink)."""
    _, labels, stats, _ = cv().connectedComponentsWithStats(mask, connectivity=8)
    sizes, title = numpy.maximum(stats[:, 2], stats[:, 3]), round(TITLE_MM * ink.flat.scale)
    for k in numpy.flatnonzero(stats[:, 1] < title) if ink.flat.by == "marks" else ():
        left, top, width, height, _ = stats[k]
        below = labels[title : top + height, left : left + width] == k
        sizes[k] = max(len(below), numpy.ptp(numpy.flatnonzero(below.any(axis=0)))) if below.any() else 0
    sizes[0] = 0
    return labels, sizes / ink.flat.scale


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


def _whiten_printed(flat: Flat, even: Greys, printed: Sequence[Square]) -> None:
    """Paint over the corner marks, the frame and what lies outside of it."""
    for z, reach in printed:
        (x, y), r = flat.px(z), reach * flat.scale
        cv().rectangle(even, (int(x - r), int(y - r)), (int(x + r), int(y + r)), 255, -1)
    left, other = (int(mm * flat.scale) for mm in FRAME_MM)
    even[:other], even[-other:] = 255, 255
    even[:, :left], even[:, -other:] = 255, 255
