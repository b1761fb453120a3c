"""Lines that were rubbed out and are still seen: much lighter than the lines they hang together with."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy

from planes.check.vision.image.picture import Flat
from planes.check.vision.strokes.line_fitting import Fitted
from planes.check.vision.strokes.meeting import on
from planes.geometry.arrays import Array, Booleans

GHOST = 0.4  # of a line's darkness: what is lighter was rubbed out
LONG_MM = 12.0  # of lines that are held against each other, and of what is rubbed out of a line
TOUCH_MM, STEP_MM = 6.0, 0.7
ASIDE_MM, MIDDLE_MM = 1.6, 0.3  # how far aside paper is seen, and how wide a line's middle is
PART, MOSTLY = 11, 0.75  # places of a line by which a part of it is judged, and the share that is no darker


def remaining(flat: Flat, lines: Sequence[Fitted]) -> list[Fitted]:
    """The lines, and parts of them, that were not rubbed out."""
    long = [x for x in lines if x.length > LONG_MM]
    parts = {id(x): _darkness(flat, x) for x in long}
    mostly = {id(x): float(numpy.quantile(parts[id(x)], MOSTLY)) for x in long}
    found: list[Fitted] = []
    for x in lines:
        pairs = ((other, ((x, other), (other, x))) for other in long)
        met = (y for y, both in pairs if any(on(b, z, TOUCH_MM, TOUCH_MM) for a, b in both for z in a.ends))
        usual = max((mostly[id(other)] for other in met), default=0.0)
        found += _left(x, parts[id(x)] > GHOST * usual) if id(x) in parts else [x]
    return found


def _left(line: Fitted, dark: Booleans) -> Iterator[Fitted]:
    """What is left of a line of which these parts are dark."""
    firm = numpy.flatnonzero(dark)
    if len(firm):
        low, high = line.low + STEP_MM * firm[0], line.low + STEP_MM * (firm[-1] + PART)
        cut = [low - line.low > LONG_MM, line.high - high > LONG_MM]
        clear = [free and not short for free, short in zip(line.clear, cut, strict=True)]
        heads = [h for h in line.heads if not ((cut[0] and h.s < low) or (cut[1] and h.s > high))]
        low, high = low if cut[0] else line.low, high if cut[1] else line.high
        yield replace(line, low=low, high=high, clear=clear, heads=heads)


def _darkness(flat: Flat, line: Fitted) -> Array:
    """How much darker than the paper beside it a line is for the most part of each of its parts."""
    s = numpy.arange(line.low, line.high, STEP_MM)
    across = 1j * numpy.linspace(-ASIDE_MM, ASIDE_MM, 17)
    local = (line.at(s)[:, None] + line.direction(s)[:, None] * across - flat.corner) * flat.scale
    h, w = flat.grey.shape
    down, aside = (h - local.imag).astype(int).clip(0, h - 1), local.real.astype(int).clip(0, w - 1)
    grey = flat.grey[down, aside].astype(float)
    middle = numpy.sort(grey[:, abs(across) < MIDDLE_MM], axis=1)[:, :2].mean(axis=1)
    dark = 1 - middle / numpy.quantile(grey, 0.9, axis=1).clip(1)
    found: Array = numpy.quantile(numpy.lib.stride_tricks.sliding_window_view(dark, PART), MOSTLY, axis=1)
    return found
