"""Lines that were rubbed out and are still seen: all along much lighter than the lines they hang together with."""

from __future__ import annotations

from collections.abc import Sequence

import numpy

from planes.check.vision.drawn_lines import on
from planes.check.vision.line_fitting import Fitted
from planes.check.vision.picture import Flat

GHOST = 0.4  # of a line's darkness: what is lighter was rubbed out
LONG_MM = 12.0  # of lines that are held against each other
TOUCH_MM, STEP_MM = 6.0, 0.7
ASIDE_MM, MIDDLE_MM = 1.6, 0.3  # how far aside paper is seen, and how wide a line's middle is
MOSTLY = 0.75  # of a line's length that is no darker: a vector upon a long construction line is


def remaining(flat: Flat, lines: Sequence[Fitted]) -> list[Fitted]:
    """The lines that were not rubbed out."""
    long = [(x, _darkness(flat, x)) for x in lines if x.length > LONG_MM]
    gone = [x for x, dark in long if any(dark < GHOST * other and _touching(x, y) for y, other in long)]
    return [x for x in lines if all(x is not g for g in gone)]


def _darkness(flat: Flat, line: Fitted) -> float:
    """How much darker a line is than the paper beside it, where it is darker than for the most part."""
    s = numpy.arange(line.low, line.high, STEP_MM)
    across = 1j * numpy.linspace(-ASIDE_MM, ASIDE_MM, 17)
    local = (line.at(s)[:, None] + line.direction(s)[:, None] * across - flat.corner) * flat.scale
    h, w = flat.grey.shape
    down, aside = (h - local.imag).astype(int).clip(0, h - 1), local.real.astype(int).clip(0, w - 1)
    grey = flat.grey[down, aside].astype(float)
    middle = numpy.median(numpy.sort(grey[:, abs(across) < MIDDLE_MM], axis=1)[:, :2], axis=1)
    return float(numpy.quantile(1 - middle / numpy.quantile(grey, 0.9, axis=1).clip(1), MOSTLY))


def _touching(one: Fitted, two: Fitted) -> bool:
    """Whether one line comes to the other, or it to the one."""
    return any(on(b, z, TOUCH_MM, TOUCH_MM) for a, b in ((one, two), (two, one)) for z in a.ends)
