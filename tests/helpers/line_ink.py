"""The ink of a vector drawing, as on a sheet of paper."""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy

from planes.check.evidence.sheet_ink import CLEAR_LINE_DARKNESS, PX_PER_MM, SheetInk
from planes.check.vision.image.opencv import cv, resize_by_factor
from planes.geometry.arrays import Greys

SOFT_PX = 2  # line width


def drawn(strokes: Iterable[tuple[complex, complex]], rim_mm: float = 30.0) -> SheetInk:
    """The ink of a vector drawing, mm, including heads."""
    lines = [*strokes]
    ends = numpy.array([z for line in lines for z in line])
    low = complex(ends.real.min(), ends.imag.min()) - rim_mm * (1 + 1j)
    size = complex(ends.real.max(), ends.imag.max()) + rim_mm * (1 + 1j) - low
    page: Greys = numpy.zeros([2 * math.ceil(mm * PX_PER_MM) for mm in (size.imag, size.real)], numpy.uint8)
    for line in lines:
        ends_px = (32 * PX_PER_MM * (z - low) for z in line)
        px = [(round(z.real) - 8, 16 * len(page) - round(z.imag) - 8) for z in ends_px]
        cv().line(page, *px, 255, SOFT_PX, cv().LINE_AA, 4)
    small = resize_by_factor(page, 0.5)
    return SheetInk((small / CLEAR_LINE_DARKNESS).astype(numpy.float32), low, len(small) / PX_PER_MM)
