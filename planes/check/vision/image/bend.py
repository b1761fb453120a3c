"""The distortion of a picture by its lens and by paper that is not flat, measured on the printed frame.

Four corner marks give only the position and slant of the sheet. The frame's sides are straight on the sheet; if they
appear bent, the lens that straightens them is fitted, and the remainder is attributed to the paper, linearly between
opposite sides.
"""

from dataclasses import dataclass, replace
from typing import Any, TypeVar

import numpy

from planes.check.fiducials import SHEET_MM, Size
from planes.check.vision.image.opencv import sample_greys
from planes.geometry.arrays import Array, Booleans, Complexes, Greys

PX_PER_MM = 8.0  # of a rectified picture
FRAME_LEFT_MM, FRAME_OTHER_SIDES_MM = 20.0, 5.0  # from the sheet's edges to the frame
# search distance of a side from its position, and sampling steps
SIDE_SEARCH_MM = 6.0
ACROSS_SAMPLE_STEP_MM = 0.125
ALONG_SAMPLE_STEP_MM = 2.0
LEAST_BEND_MM = 0.3  # of a side: less is not worth correcting
LEAST_VISIBLE_SIDE_SHARE = 0.6  # minimum visible share of a side
LEAST_LINE_CONTRAST = 8.0  # minimum contrast of a line, in grey levels
MOST_LENS_DISTORTION = 0.25  # of a lens, at a picture's corner

Place = TypeVar("Place", complex, Complexes)


@dataclass
class Bend:
    """A lens centred on a picture, then the view of the sheet (pixels of the rectified picture), then its paper."""

    middle: complex
    half: float  # of the picture's diagonal
    lens: tuple[float, float]
    view: Array
    size_px: Size
    shrink: float = 1.0  # reduction of the picture before it was analysed
    sides: Array | None = None  # outward displacement of the left, right, lower, upper side, px, at even steps

    @classmethod
    def lens_centred_on(cls, shape: tuple[int, ...], lens: float = 0.0) -> "Bend":
        """A lens alone, centred on a picture of this shape (rows, columns)."""
        height, width = shape[:2]
        middle = complex(width, height) / 2
        return cls(middle, abs(middle), (lens, 0.0), numpy.eye(3), (width, height))

    def remove_lens_distortion(self, z: Place) -> Place:
        """Pixels of the picture without lens distortion."""
        d = z - self.middle
        straight: Place = d * self._magnification(d)
        return self.middle + straight

    def apply_lens_distortion(self, z: Place) -> Place:
        """The point where the lens images ``z``."""
        d = z - self.middle
        out = d
        for _ in range(12):
            out = d / self._magnification(out)
        return self.middle + out

    def _magnification(self, off: Place) -> Any:  # one number, or an array of them
        """How much farther from the middle points ``off`` it would be without lens distortion."""
        r2 = (abs(off) / self.half) ** 2
        return 1 + self.lens[0] * r2 + self.lens[1] * r2 * r2

    def paper_displacement(self, z: Place) -> Place:
        """The displacement of a point of the rectified picture by the paper."""
        if self.sides is None:
            return 0 * z
        u = z.real / self.size_px[0]
        v = z.imag / self.size_px[1]
        steps = numpy.linspace(0, 1, self.sides.shape[1])
        shares = zip((v, v, u, u), self.sides, strict=True)
        left, right, upper, lower = (numpy.interp(share, steps, side) for share, side in shares)
        moved: Place = (1 - u) * left + u * right + 1j * ((1 - v) * upper + v * lower)
        return moved

    def to_rectified(self, z: Place) -> Place:
        """The point of the rectified picture for a pixel of the original."""
        place = apply_homography(self.view, self.remove_lens_distortion(z * self.shrink))
        return place - self.paper_displacement(place)

    def to_original(self, z: Place) -> Place:
        """The pixel of the original for a point of the rectified picture."""
        return self.apply_lens_distortion(
            apply_homography(numpy.asarray(numpy.linalg.inv(self.view), float), z + self.paper_displacement(z))
        )


def apply_homography(view: Array, z: Place) -> Place:
    """Points mapped by a homography."""
    w = view[2, 0] * z.real + view[2, 1] * z.imag + view[2, 2]
    x = view[0, 0] * z.real + view[0, 1] * z.imag + view[0, 2]
    place: Place = (x + 1j * (view[1, 0] * z.real + view[1, 1] * z.imag + view[1, 2])) / w
    return place


def measure_distortion(grey: Greys, view: Array) -> Bend | None:
    """The distortion of a picture seen by ``view`` (from its pixels to those of the sheet); None if negligible."""
    size = SHEET_MM[0] * PX_PER_MM, SHEET_MM[1] * PX_PER_MM
    bend = replace(Bend.lens_centred_on(grey.shape), view=view, size_px=size)
    seen = _visible_frame_sides(grey, bend)
    if seen:
        bend.lens = _fit_lens(bend, [z for z, _ in seen])
    return bend if seen else None


def add_paper_distortion(bend: Bend, grey: Greys) -> None:
    """Adds to a lens the remaining distortion by the paper."""
    seen = _visible_frame_sides(grey, bend)
    steps = numpy.linspace(0, 1, 41)
    rows = []
    for (_, off), (a, b) in zip(seen, _frame_side_ends(), strict=True) if seen else ():
        upright = abs((b - a).real) < 1
        along = numpy.linspace(a, b, len(off))
        share = 1 - along.imag / SHEET_MM[1] if upright else along.real / SHEET_MM[0]
        smooth = numpy.polynomial.Polynomial.fit(share, off, 4)
        rows.append(smooth(numpy.clip(steps, share.min(), share.max())) * PX_PER_MM)
    bend.sides = numpy.array(rows) if rows else None


def _frame_side_ends() -> list[tuple[complex, complex]]:
    """The frame's sides, mm, y up: left, right, upper, lower."""
    w, h = SHEET_MM
    low = complex(FRAME_LEFT_MM, FRAME_OTHER_SIDES_MM)
    high = complex(w - FRAME_OTHER_SIDES_MM, h - FRAME_OTHER_SIDES_MM)
    upper = complex(low.real, high.imag)
    lower = complex(high.real, low.imag)
    return [(low, upper), (lower, high), (upper, high), (low, lower)]


def _visible_frame_sides(grey: Greys, bend: Bend) -> list[tuple[Complexes, Array]]:
    """The frame's sides as seen: pixels, and their displacements (mm, in x or down).

    None if some are not visible or if they are straight.
    """

    def px(z: Complexes) -> Complexes:
        return bend.to_original((z.conjugate() + 1j * SHEET_MM[1]) * PX_PER_MM)

    out = []
    for a, b in _frame_side_ends():
        places = a + (b - a) * numpy.linspace(0.03, 0.97, int(abs(b - a) / ALONG_SAMPLE_STEP_MM))
        across = 1.0 if abs((b - a).real) < 1 else -1j
        t = numpy.arange(-SIDE_SEARCH_MM, SIDE_SEARCH_MM + 1e-9, ACROSS_SAMPLE_STEP_MM)
        off, good = _trace_dark_line(sample_greys(grey, px(places[:, None] + across * t)))
        if good.mean() < LEAST_VISIBLE_SIDE_SHARE:
            return []
        smooth = numpy.polynomial.Polynomial.fit(places[good].real + places[good].imag, off[good], 5)
        off = smooth(places.real + places.imag)
        out.append((px(places + across * off), off))
    if max(float(abs(off).max()) for _, off in out) >= LEAST_BEND_MM:
        return out
    return []


def _trace_dark_line(rows: Array) -> tuple[Array, Booleans]:
    """The position, mm, of a thin dark line across each row, continuous from row to row, and the rows that show it."""
    wide = rows.shape[1]
    rim = int(0.75 / ACROSS_SAMPLE_STEP_MM)
    padded = numpy.pad(rows, ((0, 0), (rim, rim)), mode="edge")
    paper = numpy.minimum(padded[:, :wide], padded[:, 2 * rim :])
    dark = numpy.clip(paper - rows, 0, 120)
    best = dark[0].copy()
    back = []
    moves = range(-2, 3)
    for row in dark[1:]:
        wider = numpy.pad(best, 2, constant_values=-1e9)
        shifted = numpy.stack([wider[2 - m : 2 - m + wide] - 2.0 * abs(m) for m in moves])
        choice = shifted.argmax(axis=0)
        back.append(choice)
        best = shifted[choice, numpy.arange(wide)] + row
    path = [int(best.argmax())]
    for choice in reversed(back):
        path.append(path[-1] - moves[choice[path[-1]]])
    at = numpy.array(path[::-1])
    near = numpy.clip(at[:, None] + numpy.arange(-3, 4), 0, wide - 1)
    mass = numpy.take_along_axis(dark, near, axis=1)
    middle = (mass * near).sum(axis=1) / numpy.maximum(mass.sum(axis=1), 1e-6)
    good = numpy.take_along_axis(dark, at[:, None], axis=1)[:, 0] > LEAST_LINE_CONTRAST
    return middle * ACROSS_SAMPLE_STEP_MM - SIDE_SEARCH_MM, good


def _fit_lens(bend: Bend, sides: list[Complexes]) -> tuple[float, float]:
    """The lens that straightens the frame's sides (Gauss-Newton).

    Equal bends of opposite sides are excluded: they are due to the paper.
    """

    def crooked(k: Array) -> Array:
        bend.lens = float(k[0]), float(k[1])
        bows = []
        for side in sides:
            z = bend.remove_lens_distortion(side)
            z = z - z.mean()
            u = numpy.exp(0.5j * numpy.angle((z * z).sum()))
            u = u if ((z[-1] - z[0]) * u.conjugate()).real > 0 else -u
            bows.append((z * u.conjugate()).imag)
        left, right, upper, lower = bows
        return numpy.concatenate([left - right, upper - lower, 2.0 * k / MOST_LENS_DISTORTION])

    k = numpy.zeros(2)
    for _ in range(8):
        left = crooked(k)
        slope = numpy.stack([(crooked(k + d) - left) / 1e-4 for d in 1e-4 * numpy.eye(2)], axis=1)
        k = numpy.clip(k - numpy.linalg.lstsq(slope, left, rcond=None)[0], -MOST_LENS_DISTORTION, MOST_LENS_DISTORTION)
    return float(k[0]), float(k[1])
