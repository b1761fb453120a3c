"""Hodographs and paths on the charts of a cycle: curves in the plane with equal axes, their positions numbered."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from matplotlib.axes import Axes

from planes.geometry.arrays import Complexes
from planes.words import say
from planes.words.lettering import Naming, lettered_curve
from planes.words.names import index_of, letter_of
from render.charts import beside, leader
from render.paper.letters import number, with_unit

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
    ink += [] if path else [0j]
    if not path:
        plot.plot([0], [0], "+", color="#000000", markersize=9, zorder=4)
    _square(plot, loop, naming, path, ink)
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
        looks: dict[str, Any] = {
            "ha": "center",
            "va": "center",
            "fontsize": 8,
            "arrowprops": leader(abs(shift), 12, 0.5),
        }
        beside(plot, str(k), (z.real, z.imag), (shift.real, shift.imag), **looks)


_OFFSETS = [r * cmath.rect(1, math.pi / 6 * k) for r in (8, 14, 20) for k in range(12)]


def _room(z: complex, ink: Sequence[complex], taken: Sequence[complex]) -> float:
    """How far a number stands from the curve (7 points are enough) and from other numbers (11 are)."""
    near = min((abs(z - other) for other in ink), default=99.0)
    beside = min((abs(z - other) for other in taken), default=99.0)
    return min(near, 7.0) + min(beside, 11.0)


def _square(plot: Axes, loop: Loop, naming: Naming, path: bool, ink: Sequence[complex]) -> None:
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
