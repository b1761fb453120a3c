"""Where one vector ends upon another that runs on: a line drawn twice has more ink than one drawn once."""

from collections.abc import Sequence

import numpy

from planes.check.vision.strokes.ink import Ink
from planes.check.vision.strokes.line_fitting import Fitted
from planes.geometry.arrays import Array

STEP_MM, ACROSS_MM = 0.25, 0.1  # along a line, and of a row across it
OWN_MM, BESIDE_MM = 0.8, 1.5  # how far aside a line's ink is, and then that of letters and of other lines
ALIEN = 0.15  # the share of a line's ink that, lying beside it, tells that something else is there
PART_MM, GAP_MM = 6.0, 0.75  # of a line before and after a place that are held against each other; left out between
SEEN = 0.6  # the share of such a part where nothing else is
LESS, RIVAL = 0.2, 0.6  # the logarithm of how much less ink there is beyond; of the most on a line, what may be one
ALONE_MM = 4.0  # between two such places
OVER_MM = 0.5  # σ of a place told so


def ends_upon(ink: Ink, line: Fitted) -> list[tuple[float, int]]:
    """Where vectors end upon a longer line: how far along it, and +1 where its high end has less ink."""
    s = numpy.arange(line.low, line.high, STEP_MM)
    share = _shares(ink, line, s)
    found = [(drop, float(s[k]), sign) for sign in (1, -1) for k, drop in _drops(share[::sign])]
    found = [(drop, x if sign > 0 else line.low + line.high - x, sign) for drop, x, sign in found]
    most = max((drop for drop, _, _ in found), default=0.0)
    return [(x, sign) for drop, x, sign in found if drop > max(LESS, RIVAL * most)]


def _shares(ink: Ink, line: Fitted, s: Array) -> Array:
    """The logarithm of a line's ink at places along it; none (NaN) where something else lies beside it."""
    across = numpy.arange(-BESIDE_MM, BESIDE_MM + ACROSS_MM / 2, ACROSS_MM)
    dark = ink.raw(line.at(s)[:, None] + 1j * line.direction(s)[:, None] * across)
    own = numpy.abs(across) < OWN_MM
    mass, beside = dark[:, own].mean(axis=1), dark[:, ~own].mean(axis=1)
    paper = numpy.median(beside)
    clear = beside - paper < ALIEN * numpy.median(mass)
    found: Array = numpy.where(clear, numpy.log(numpy.maximum(mass - paper, 0.1)), numpy.nan)
    return found


def _drops(share: Array) -> Sequence[tuple[int, float]]:
    """Places in a row from which on there is less than before, and by how much, the foremost first."""
    part, gap, apart = (round(mm / STEP_MM) for mm in (PART_MM, GAP_MM, ALONE_MM))
    if len(share) < 2 * (part + gap):
        return []
    rows = numpy.lib.stride_tricks.sliding_window_view(share, part)
    known = numpy.isfinite(rows).mean(axis=1) > SEEN
    middle = numpy.full(len(rows), numpy.nan)
    middle[known] = numpy.nanmedian(rows[known], axis=1)
    at = numpy.arange(part + gap, len(share) - part - gap + 1)
    drop = numpy.nan_to_num(middle[at - gap - part] - middle[at + gap], nan=0.0)
    found = list[tuple[int, float]]()
    while len(drop) and (most := float(drop.max())) > LESS:
        k = int(drop.argmax())
        drop[max(k - apart, 0) : k + apart + 1] = 0.0
        found.append((_edge(share, int(at[k]), part + gap), most))
    return found


def _edge(share: Array, about: int, reach: int) -> int:
    """From where on there is less, about a place."""
    near = share[about - reach : about + reach]
    high, low = (float(numpy.nanmedian(side)) for side in (near[: reach - 1], near[reach + 1 :]))
    over = numpy.nan_to_num(numpy.abs(near - low) - numpy.abs(near - high))  # how much likelier before than beyond
    return about - reach + int(numpy.cumsum(over).argmax()) + 1
