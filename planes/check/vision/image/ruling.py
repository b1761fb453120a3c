"""The ruling of a sheet: the squares or lines printed on its paper, counted all over a picture.

A family of equally spaced lines is a wave. In a small window it is the strongest one near the expected period; its
phase, followed from window to window, counts the lines to a fiftieth of their spacing. A drawing is darker than a
ruling, so darkness is clipped: it carries no more information.
"""

import heapq
import math

import numpy

from planes.check.vision.image.opencv import cv, resize_by_factor
from planes.geometry.arrays import Array, Complexes, Greys
from planes.words.frozen import frozen

RULING_PERIOD_PX = 16.0  # of a ruling, in the reduced picture
WINDOW_PX, WINDOW_STEP_PX = 96, 64
PAPER_LIGHT_WINDOW_PX = 21  # neighbourhood for the paper's light
# grey levels, maximum darkness of a ruling and lightness of paper
MOST_RULING_DARKNESS = 12.0
MOST_PAPER_LIGHTNESS = 6.0
MOST_LINE_SLANT = 0.36  # maximum slant of a line: of a sheet that is rotated and seen obliquely
# range of periods relative to the expected one; number of steps
LEAST_RATE_RATIO = 0.72
MOST_RATE_RATIO = 1.38
RATE_STEP_COUNT = 25
MOST_RATE_DEVIATION = 0.13  # maximum deviation of a window's rate from that of the others
LEAST_WAVE_STRENGTH = 5.0  # minimum strength of a wave relative to the usual one of its window
# clear windows, and their share of all: tables and hatchings do not cover a sheet
LEAST_CLEAR_WINDOWS = 16
LEAST_CLEAR_SHARE = 0.35


@frozen
class Wave:
    """A family of lines seen in windows: positions (pixels of the picture), counts, and which are clear."""

    places: Complexes
    counts: Array
    clear: Array


def count_ruling_lines(grey: Greys, period_px: float) -> tuple[Wave | None, Wave | None]:
    """The lines down a picture near this period, counted to the right, and those across, counted downwards.

    None if there are none.
    """
    factor = min(1.0, RULING_PERIOD_PX / period_px)
    seen = (resize_by_factor(grey, factor) if factor < 1 else grey).astype(numpy.float32)
    dark = numpy.clip(
        cv().blur(seen, (PAPER_LIGHT_WINDOW_PX, PAPER_LIGHT_WINDOW_PX)) - seen,
        -MOST_PAPER_LIGHTNESS,
        MOST_RULING_DARKNESS,
    )
    h, w = dark.shape
    at = [
        (y, x) for y in range(0, h - WINDOW_PX + 1, WINDOW_STEP_PX) for x in range(0, w - WINDOW_PX + 1, WINDOW_STEP_PX)
    ]
    if len(at) < LEAST_CLEAR_WINDOWS:
        return None, None
    cuts = numpy.array([dark[y : y + WINDOW_PX, x : x + WINDOW_PX] for y, x in at])
    rim = numpy.hanning(WINDOW_PX + 2)[1:-1].astype(numpy.float32)
    cuts = (cuts - cuts.mean(axis=(1, 2), keepdims=True)) * rim[:, None] * rim
    middles = numpy.array([complex(x, y) + (WINDOW_PX - 1) / 2 * (1 + 1j) for y, x in at])
    places = (middles + (0.5 + 0.5j)) / factor - (0.5 + 0.5j)
    mirrored = middles.imag + 1j * middles.real
    counts = (_line_counts(cuts, middles), _line_counts(cuts.transpose(0, 2, 1), mirrored))
    across, down = (Wave(places, *count) if count else None for count in counts)
    return across, down


def _line_counts(dark: Array, middles: Complexes) -> tuple[Array, Array] | None:
    """The line counts of windows to the right, and which are clear."""
    rates, clear, _ = _strongest_waves(dark, None)
    rates, clear, phases = _strongest_waves(dark, _smooth_rates(middles, rates, clear))
    if (clear > LEAST_WAVE_STRENGTH).sum() < max(LEAST_CLEAR_WINDOWS, LEAST_CLEAR_SHARE * len(clear)):
        return None
    return _unwrapped_phases(middles, rates, clear, phases), clear


def _strongest_waves(dark: Array, near: Complexes | None) -> tuple[Complexes, Array, Array]:
    """The strongest wave in each window, near the rate ``near`` if given.

    It has lines per pixel (to the right and down, as a complex number), strength relative to the usual one, and phase
    in the middle, in lines.
    """
    t = numpy.arange(WINDOW_PX) - (WINDOW_PX - 1) / 2
    across = numpy.linspace(LEAST_RATE_RATIO, MOST_RATE_RATIO, RATE_STEP_COUNT) / RULING_PERIOD_PX
    aslant = numpy.linspace(-MOST_LINE_SLANT, MOST_LINE_SLANT, RATE_STEP_COUNT) / RULING_PERIOD_PX
    ex, ey = (numpy.exp(-2j * math.pi * t[:, None] * f).astype(numpy.complex64) for f in (across, aslant))
    power = numpy.abs(ey.T @ (dark @ ex))
    usual = numpy.median(power, axis=(1, 2)) + 1e-6
    if near is not None:
        off = abs(across[None, None, :] + 1j * aslant[None, :, None] - near[:, None, None])
        power = numpy.where(off < MOST_RATE_DEVIATION / RULING_PERIOD_PX, power, 0.0)
    n = numpy.arange(len(dark))
    best = power.reshape(len(dark), -1).argmax(axis=1)
    i = best // RATE_STEP_COUNT
    j = best % RATE_STEP_COUNT
    fx = across[j] + _peak_offset_in_steps(power, i, j, (0, 1)) * (across[1] - across[0])
    fy = aslant[i] + _peak_offset_in_steps(power, i, j, (1, 0)) * (aslant[1] - aslant[0])
    wx, wy = (numpy.exp(-2j * math.pi * f[:, None] * t).astype(numpy.complex64) for f in (fx, fy))
    phase = numpy.angle(numpy.einsum("ny,nyx,nx->n", wy, dark, wx, optimize=True)) / (2 * math.pi)
    return fx + 1j * fy, power[n, i, j] / usual, phase


def _peak_offset_in_steps(power: Array, i: Array, j: Array, step: tuple[int, int]) -> Array:
    """The position of each window's peak between its neighbours, in steps: the vertex of a parabola."""
    di, dj = step
    n = numpy.arange(len(power))
    last = RATE_STEP_COUNT - 1
    i = numpy.clip(i, di, last - di)
    j = numpy.clip(j, dj, last - dj)
    a, b, c = (power[n, i + k * di, j + k * dj] for k in (-1, 0, 1))
    bend = numpy.minimum(a - 2 * b + c, -1e-9)
    top: Array = numpy.clip((a - c) / (2 * bend), -0.5, 0.5)
    return top


def _smooth_rates(middles: Complexes, rates: Complexes, clear: Array) -> Complexes:
    """The rate at each window, varying smoothly over the picture, fitted to most of the clear ones."""
    base = numpy.stack([numpy.ones(len(middles)), middles.real / 1000, middles.imag / 1000], axis=1)
    weight = numpy.clip(clear - LEAST_WAVE_STRENGTH, 0.01, 10)
    order = numpy.argsort(rates.real)
    share = numpy.cumsum(weight[order])
    fit = numpy.array([rates[order][numpy.searchsorted(share, share[-1] / 2)], 0, 0])
    for k in range(12):
        wide = (0.25 if k < 3 else 0.08) / RULING_PERIOD_PX
        w = weight / (1 + (abs(rates - base @ fit) / wide) ** 2) ** 2
        kept = base[:, : 1 if k < 2 else 3]
        part = numpy.linalg.lstsq(kept * w[:, None] ** 0.5, rates * w**0.5, rcond=None)[0]
        fit = numpy.concatenate([part, numpy.zeros(3 - len(part))])
    out: Complexes = base @ fit
    return out


def _unwrapped_phases(middles: Complexes, rates: Complexes, clear: Array, phases: Array) -> Array:
    """Unwrapped phases, from the clearest window outwards, clear ones first."""
    out = numpy.full(len(middles), math.nan)
    queue = [(0.0, int(clear.argmax()), -1)]
    while queue:
        _, j, i = heapq.heappop(queue)
        if not math.isnan(out[j]):
            continue
        way = middles[j] - middles[i]
        rate = (rates[i] + rates[j]) / 2
        likely = 0.0 if i < 0 else out[i] + rate.real * way.real + rate.imag * way.imag
        out[j] = likely + (phases[j] - likely + 0.5) % 1 - 0.5
        for k in numpy.flatnonzero((abs(middles - middles[j]) < 1.5 * WINDOW_STEP_PX) & numpy.isnan(out)):
            heapq.heappush(queue, (-float(clear[k]), int(k), j))
    return out
