"""Diagrams of a cycle with matplotlib: curves over the driver's place, hodographs and paths, positions 0…12 numbered.

Axes as ГОСТ draws them: the quantity and its unit stand at the end of the axis, which ends in an arrow; the zero line
is the axis of the driver's angle, in degrees.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from textwrap import fill
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planes.diagrams.extremes import Extreme
from planes.geometry.arrays import Array, Complexes
from planes.words import Lang, say
from planes.words.lettering import Naming, lettered_curve
from planes.words.names import index_of, letter_of
from planes.words.units import number
from render.charts import LOOKS, OF_FILES, beside, leader, save
from render.paper.letters import with_unit

WIDE = 7.2  # inches
TALL = 1.9  # of one pair of axes
MARGIN = 0.17  # beneath the lowest ordinate, for the number there


@dataclass(frozen=True)
class Panel:
    """Curves on the same axes: each a name, runs of (places, values), and the extremes that are marked."""

    unit: str
    place: bool  # of a place, whose zero need not be seen
    curves: Sequence[tuple[str, Sequence[tuple[Array, Array]], Sequence[Extreme]]]


@dataclass(frozen=True)
class DriveAxis:
    """The axis of the driver: whether it turns, its number, the ends and the places of the numbered positions."""

    turning: bool
    link: str
    start: float
    end: float
    stations: Array


def draw(
    path: Path, title: str, panels: Sequence[Panel], loops: Sequence[Loop], axis: DriveAxis, naming: Naming
) -> None:
    """All of it on one figure, in a file by its suffix."""
    rows = math.ceil(len(loops) / 2)
    heights = ([TALL * len(panels) + 0.5] if panels else []) + ([SQUARE * rows] if loops else [])
    with rc_context(OF_FILES | {"axes.grid": False}):
        figure = Figure(figsize=(WIDE, sum(heights) + 0.45), dpi=150, layout="constrained")
        figure.suptitle(fill(title, 64), fontsize=11)
        parts: Any = figure.subfigures(len(heights), 1, height_ratios=heights, squeeze=False)[:, 0] if heights else []
        if panels:
            plots = parts[0].subplots(len(panels), 1, squeeze=False, sharex=True)[:, 0]
            for k, (plot, panel) in enumerate(zip(plots, panels, strict=True)):
                _panel(plot, panel, axis, naming, k == 0, k == len(panels) - 1)
        if loops:
            squares = parts[-1].subplots(rows, min(2, len(loops)), squeeze=False).ravel()
            for plot, loop in zip(squares, loops, strict=False):
                draw_loop(plot, loop, naming)
            for plot in squares[len(loops) :]:
                plot.set_axis_off()
        save(figure, path)


def _panel(plot: Axes, panel: Panel, axis: DriveAxis, naming: Naming, first: bool, last: bool) -> None:
    lang = naming.lang
    many = len(panel.curves) > 1
    for k, (name, runs, marked) in enumerate(panel.curves):
        colour, dashes = LOOKS[k % len(LOOKS)]
        for j, (x, y) in enumerate(runs):
            label = math_text(lettered_curve(name, naming)) if many and j == 0 else None
            plot.plot(x, y, color=colour, linestyle=dashes, label=label, zorder=3)
        for (x, y), (x2, y2) in pairwise(runs):
            plot.plot([x[-1], x2[0]], [y[-1], y2[0]], color=colour, linestyle=(0, (3, 2)), linewidth=0.8, zorder=2)
        if not many:
            _extremes(plot, marked, axis, lang)
    for x in axis.stations:
        plot.axvline(x, color="#bbbbbb", linewidth=0.5, zorder=0)
    _frame(plot, panel, axis, naming)
    for k, x in enumerate(axis.stations if first else ()):  # the numbers of the positions, along the upper edge
        beside(plot, str(k), (x, 1), (0, 5), xycoords=plot.get_xaxis_transform(), ha="center", fontsize=8.5)
    if last:
        _degrees(plot, axis, lang)
    if many:
        plot.legend(loc="upper right", ncols=len(panel.curves), fontsize=9)


def _degrees(plot: Axes, axis: DriveAxis, lang: Lang) -> None:
    """The driver's angles along the lower edge."""
    where: dict[str, Any] = {"xycoords": plot.get_xaxis_transform(), "va": "top"}
    for x in axis.stations:
        told = round(float(x), 1 if axis.turning else 3)
        told = told % 360.0 if axis.end - axis.start > 359 else told  # an angle within one turn
        beside(plot, number(told, lang), (x, 0), (0, -3), ha="center", fontsize=8.5, **where)
    letter = math_text(f"{'φ' if axis.turning else 's'}_{{{axis.link}}}")
    text = with_unit(letter, "°" if axis.turning else "m", lang)
    beside(plot, text, (axis.end, 0), (0, -16), ha="right", fontsize=10, **where)


def _frame(plot: Axes, panel: Panel, axis: DriveAxis, naming: Naming) -> None:
    """Arrows at the ends of the axes, the quantity at the upper one."""
    low, high = plot.get_ylim()
    afar = low > 0 or high < 0  # a place counted from afar: its axis stands beneath it
    low, high = (low, high) if afar and panel.place else (min(low, 0.0), max(high, 0.0))
    reach = high - low
    plot.set_ylim(low - MARGIN * reach, high + 0.3 * reach)
    plot.set_xlim(axis.start, axis.end + 0.03 * (axis.end - axis.start))
    for side in ("top", "right"):
        plot.spines[side].set_visible(False)
    zero = 0.0 if low <= 0 <= high else low - MARGIN * reach
    plot.spines["bottom"].set_position(("data", zero))
    plot.tick_params(axis="x", length=0, labelbottom=False)
    arrow: dict[str, Any] = {"clip_on": False, "color": "#000000", "markersize": 4.5, "zorder": 4}
    plot.plot(1, zero, ">", transform=plot.get_yaxis_transform(), **arrow)
    plot.plot(0, 1, "^", transform=plot.transAxes, **arrow)
    names = ", ".join(math_text(lettered_curve(name, naming)) for name, _, _ in panel.curves)
    told = with_unit(names, panel.unit, naming.lang)
    beside(plot, told, (0, 1), (7, -2), xycoords="axes fraction", va="top", fontsize=10)
    plot.yaxis.set_major_formatter(lambda v, _: number(float(f"{v:.6g}"), naming.lang))
    plot.locator_params(axis="y", nbins=5)


def _extremes(plot: Axes, marked: Sequence[Extreme], axis: DriveAxis, lang: Lang) -> None:
    """Dots with the values, the greatest above its dot and the least beneath."""
    size = max((abs(m.value) for m in marked), default=0.0)
    for e in marked:
        x = e.place
        while x < axis.start - 1e-9 and axis.turning:
            x += 360.0
        top = e.value == max(m.value for m in marked)
        plot.plot([x], [e.value], "o", color="#000000", markersize=3, zorder=5)
        right = x > axis.start + 0.9 * (axis.end - axis.start)
        text = number(e.value if abs(e.value) > 1e-9 * size else 0.0, lang)
        sides = {"ha": "right" if right else "left", "va": "bottom" if top else "top"}
        beside(plot, text, (x, e.value), (-4 if right else 4, 4 if top else -4), **sides, fontsize=8, zorder=6)


SQUARE = 3.6  # of a hodograph


@dataclass(frozen=True)
class Loop:
    """A hodograph or a path: complex places run by run, and those of the numbered positions."""

    name: str
    unit: str
    runs: Sequence[Complexes]
    stations: Complexes
    closed: bool = True


def math_text(text: str) -> str:
    """A name for matplotlib to set."""
    return f"${text}$"


def draw_loop(plot: Axes, loop: Loop, naming: Naming) -> None:
    """A curve in the plane, the pole of a hodograph at the origin, positions numbered."""
    path = letter_of(loop.name) == "r"
    runs = [*loop.runs, loop.runs[0][:1]] if loop.closed else loop.runs
    for run in loop.runs:
        plot.plot(run.real, run.imag, color="#000000", zorder=3)
    for one, two in pairwise(runs):
        ends = [one[-1].real, two[0].real], [one[-1].imag, two[0].imag]
        plot.plot(*ends, color="#000000", linewidth=0.8, linestyle=(0, (3, 2)), zorder=2)
    ink = [complex(z) for run in loop.runs for z in run[::4] if z == z]
    if not path:
        ink.append(0j)
        plot.plot([0], [0], "+", color="#000000", markersize=9, zorder=4)
    _square_axes(plot, loop, naming, path, ink)
    _stations(plot, loop, ink)


def _stations(plot: Axes, loop: Loop, ink: Sequence[complex]) -> None:
    """Dots and numbers of the positions, each number where it touches neither the curve nor another number."""
    (low, high), points = plot.get_xlim(), SQUARE * 72 * 0.72
    scale = points / (high - low)  # points of paper per unit
    places = [z * scale for z in ink]
    taken: list[complex] = []
    dots: list[complex] = []
    for k, z in enumerate(loop.stations):
        if z != z or any(abs(z - other) * scale < 0.5 for other in dots):
            continue
        dots.append(z)
        plot.plot([z.real], [z.imag], "o", color="#000000", markersize=2.8, zorder=4)
        offsets = [d * (1.3 if k > 9 else 1.0) for d in _OFFSETS]
        shift = max(offsets, key=lambda d: _room(z * scale + d, places, taken) - 0.15 * abs(d))
        taken.append(z * scale + shift)
        led = leader(abs(shift), 12, 0.5)
        place, by = (z.real, z.imag), (shift.real, shift.imag)
        beside(plot, str(k), place, by, ha="center", va="center", fontsize=8, arrowprops=led)


_OFFSETS = [r * cmath.rect(1, math.pi / 6 * k) for r in (8, 14, 20) for k in range(12)]


def _room(z: complex, ink: Sequence[complex], taken: Sequence[complex]) -> float:
    """How far a number stands from the curve (7 points are enough) and from other numbers (11 are)."""
    near = min((abs(z - other) for other in ink), default=99.0)
    apart = min((abs(z - other) for other in taken), default=99.0)
    return min(near, 7.0) + min(apart, 11.0)


def _square_axes(plot: Axes, loop: Loop, naming: Naming, path: bool, ink: Sequence[complex]) -> None:
    """Equal scales along both axes, and what they are."""
    lang = naming.lang
    name = index_of(loop.name) if path else lettered_curve(loop.name, naming)
    key = "chart_path" if path else "chart_hodograph"
    plot.set_title(say(key, lang, name=math_text(naming.point(name) if path else name)), fontsize=10)
    plot.set_xlabel(with_unit(math_text("x"), loop.unit, lang))
    plot.set_ylabel(with_unit(math_text("y"), loop.unit, lang))
    xs, ys = [z.real for z in ink] or [0.0], [z.imag for z in ink] or [0.0]
    half = 0.6 * max(max(xs) - min(xs), max(ys) - min(ys)) or 1.0
    x, y = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
    plot.set(xlim=(x - half, x + half), ylim=(y - half, y + half))
    plot.set_aspect("equal")
    plot.grid(True, linewidth=0.4, color="#dddddd")
    for ax in (plot.xaxis, plot.yaxis):
        ax.set_major_formatter(lambda v, _: number(float(f"{v:.6g}"), lang))
    plot.locator_params(nbins=5)
