"""The chart of turning curves: the drive across, a length up, the curves, and how many assemblies each region has."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MultipleLocator

from planes.accuracy.turning import Turning
from planes.geometry.arrays import Array, Booleans, Indices
from planes.words import Lang, say
from render.charts import LOOKS

LEAST = 0.01  # of the grid: a region that is smaller is not lettered
DARK = 0.11  # how much darker two more assemblies make a region


def draw_turning(plot: Axes, found: Turning, axis: str, lang: Lang) -> None:
    """Regions in grey with their number of assemblies, the curves between them, and where the scene stands."""
    low, high = found.values[0], found.values[-1]
    plot.set(xlim=(low, high), ylim=(found.lengths[0], found.lengths[-1]), yscale="log", xlabel=axis)
    plot.set_ylabel(say("chart_turning_length", lang, name=found.name))
    plot.set_title(say("chart_turning" if found.whole else "chart_turning_part", lang, name=found.name), fontsize=9.5)
    plot.grid(visible=False)
    shade = 1 - DARK * found.count / 2
    plot.pcolormesh(found.values, found.lengths, shade, cmap="gray", vmin=0.0, vmax=1.0, zorder=0, rasterized=True)
    for k, curve in enumerate(found.curves):
        colour, _ = LOOKS[(k + 1) % len(LOOKS)]
        plot.plot(*_broken(curve.values, curve.lengths, low, high), color=colour, linewidth=1.6)
    for i, j in _regions(found.count):
        plot.text(found.values[i], found.lengths[j], f"{found.count[j, i]}", ha="center", va="center", fontsize=8.5)
    value, length = found.here
    plot.plot([(value - low) % (high - low) + low], [length], "o", color="#000000", markersize=4)
    plot.minorticks_off()
    if high - low == 360:
        plot.xaxis.set_major_locator(MultipleLocator(60))
    ticks = np.round(np.geomspace(found.lengths[0], found.lengths[-1], 7), 3)
    plot.set_yticks(ticks, [f"{t:.3g}" for t in ticks])


def _broken(values: Array, lengths: Array, low: float, high: float) -> tuple[Array, Array]:
    """A curve brought into the chart's turn of the drive, broken where it goes over its edge."""
    inside = (values - low) % (high - low) + low
    inside = np.where((values < low) | (values > high), inside, values)
    cuts = np.flatnonzero(abs(np.diff(inside)) > (high - low) / 2) + 1
    return np.insert(inside, cuts, np.nan), np.insert(lengths, cuts, np.nan)


def _regions(count: Indices) -> list[tuple[int, int]]:
    """The deepest cell of every region of the grid where the number of assemblies is the same."""
    found = []
    for number in np.unique(count):
        left = count == number
        while left.sum() > LEAST * count.size:
            deepest = left
            while (inner := _shrunk(deepest)).any():
                deepest = inner
            j, i = np.argwhere(deepest)[len(np.argwhere(deepest)) // 2]
            region = np.zeros_like(left)
            region[j, i] = True
            if _filled(region, left).sum() > LEAST * count.size:
                found.append((int(i), int(j)))
            left = left & ~_filled(region, left)
    return found


def _shrunk(region: Booleans) -> Booleans:
    """Without its rim."""
    wide = np.pad(region, 1)
    return wide[1:-1, 1:-1] & wide[2:, 1:-1] & wide[:-2, 1:-1] & wide[1:-1, 2:] & wide[1:-1, :-2]


def _filled(seed: Booleans, within: Booleans) -> Booleans:
    """All that hangs together with the seed."""
    while True:
        wide = np.pad(seed, 1)
        grown = wide[1:-1, 1:-1] | wide[2:, 1:-1] | wide[:-2, 1:-1] | wide[1:-1, 2:] | wide[1:-1, :-2]
        grown = grown & within
        if (grown == seed).all():
            return seed
        seed = grown
