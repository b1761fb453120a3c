"""Diagrams of a cycle with matplotlib: curves over the driver's place, hodographs and paths, positions 0…12 numbered.

Axes as ГОСТ draws them: the quantity and its unit stand at the end of the axis, which ends in an arrow; the zero line
is the axis of the driver's angle, in degrees.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from textwrap import fill
from typing import Any, Protocol

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planes.geometry.arrays import Array
from planes.words import Lang
from planes.words.lettering import Naming, lettered_curve
from render.charts import LOOKS, STYLE, beside, save
from render.charts.loops import SQUARE, Loop, draw_loop, math_text
from render.paper.letters import number, with_unit

LOOK: Any = {**STYLE, "font.size": 9.0, "svg.hashsalt": "planes", "svg.fonttype": "path", "axes.grid": False}
WIDE = 7.2  # inches
TALL = 1.9  # of one pair of axes
MARGIN = 0.17  # beneath the lowest ordinate, for the number there


class Marked(Protocol):
    @property
    def place(self) -> float: ...
    @property
    def value(self) -> float: ...


@dataclass(frozen=True)
class Panel:
    """Curves on the same axes: each a name, runs of (places, values), and the extremes that are marked."""

    unit: str
    place: bool  # of a place, whose zero need not be seen
    curves: Sequence[tuple[str, Sequence[tuple[Array, Array]], Sequence[Marked]]]


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
    with rc_context(LOOK):
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
        beside(plot, number(_told(x, axis), lang), (x, 0), (0, -3), ha="center", fontsize=8.5, **where)
    letter = math_text(f"{'φ' if axis.turning else 's'}_{{{axis.link}}}")
    text = with_unit(letter, "°" if axis.turning else "m", lang)
    beside(plot, text, (axis.end, 0), (0, -16), ha="right", fontsize=10, **where)


def _told(place: float, axis: DriveAxis) -> float:
    """A place on the axis as it is written: an angle within one turn, to a tenth of a degree."""
    told = round(float(place), 1 if axis.turning else 3)
    return told % 360.0 if axis.end - axis.start > 359 else told


def _frame(plot: Axes, panel: Panel, axis: DriveAxis, naming: Naming) -> None:
    """Arrows at the ends of the axes, the quantity at the upper one."""
    low, high = plot.get_ylim()
    beside = low > 0 or high < 0  # a place counted from afar: its axis stands beneath it
    low, high = (low, high) if beside and panel.place else (min(low, 0.0), max(high, 0.0))
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


def _extremes(plot: Axes, marked: Sequence[Marked], axis: DriveAxis, lang: Lang) -> None:
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
        looks: dict[str, Any] = {
            "ha": "right" if right else "left",
            "va": "bottom" if top else "top",
            "fontsize": 8,
            "zorder": 6,
        }
        beside(plot, text, (x, e.value), (-4 if right else 4, 4 if top else -4), **looks)
