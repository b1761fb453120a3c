"""Where a head ends upon a line that runs on: its strokes lie one upon the other, and what goes on is lighter."""

from dataclasses import replace

import numpy

from planes.check.vision.strokes.ink import Ink
from planes.check.vision.strokes.line_fitting import Fitted, Tip

STEP_MM, ASIDE_MM = 0.05, 0.2  # along the way, and how far to either side of it the ink is looked at
NEAR_MM, FAR_MM = 0.1, 0.4  # from an edge, between which the ink on either side is held against the other's
REACH_MM, SOFT_MM = 1.0, 0.5  # how far from where a tip seems to be, at the most and commonly
LEAST = 0.2  # of the darkest ink about, by how much a line is lighter past a head
SIGMA_MM = 0.15  # of a tip told so
CAP_MM = 0.4  # half of a pencil's line, at the most


def ending(ink: Ink, tip: complex, way: complex, width: float) -> complex | None:
    """The tip of a head about a place, pointing a (unit) way, by where its ink ends, or that of a line as wide as its
    own which it ends at; None where what goes on there is as dark."""
    margin = REACH_MM + FAR_MM
    s = numpy.arange(-margin, margin + STEP_MM / 2, STEP_MM)
    t = numpy.linspace(-ASIDE_MM, ASIDE_MM, 5)
    dark = ink.raw(tip + way * (s[:, None] + 1j * t[None, :])).mean(axis=1)
    count, gap = round((FAR_MM - NEAR_MM) / STEP_MM) + 1, round(NEAR_MM / STEP_MM)
    mean = numpy.convolve(dark, numpy.full(count, 1 / count), "valid")  # of so many in a row, from each on
    at = numpy.arange(round(FAR_MM / STEP_MM), len(s) - round(FAR_MM / STEP_MM))
    drop = (mean[at - gap - count + 1] - mean[at + gap]) / max(float(dark.max()), 1.0)
    beyond = s[at] - min(width / 2, CAP_MM)
    k = int((drop * numpy.exp(-0.5 * (beyond / SOFT_MM) ** 2)).argmax())
    return tip + way * float(beyond[k]) if drop[k] > LEAST else None


def sharpened(ink: Ink, line: Fitted, tip: Tip) -> Tip:
    """The tip of a head upon a line that runs on, or among others: where its ink ends, if that is seen."""
    way = tip.sign * line.direction(tip.s)
    edge = ending(ink, tip.z, way, line.width)
    return replace(tip, s=line.local(edge)[0], z=edge, sigma=SIGMA_MM) if edge is not None else tip
