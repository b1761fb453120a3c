"""Charts of methods: speed against accuracy with its front, errors on the way to a limit, and turning curves."""

import math
from collections.abc import Iterable, Sequence
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np
from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.ticker import MultipleLocator

from planes.accuracy.methods import Method
from planes.accuracy.stability import Approach
from planes.accuracy.turning import Turning
from planes.geometry.arrays import Array, ArrayPair, Booleans, Indices
from planes.words import Lang, say
from planes.words.names import NamesByName
from render.charts import CURVE_LOOKS, FILE_CHART_STYLE, annotate_beside, save_figure

METHOD_COLOURS = (
    "#000000",
    "#1f5fa8",
    "#c1440e",
    "#2f7d32",
    "#7a3b8f",
    "#8a6d00",
    "#777777",
    "#0f8b8d",
    "#d0307a",
    "#6b4226",
)
Look = tuple[int, str, Any]
LOOK_OF_METHOD: dict[str, Look] = {  # of a method: colour, marker, dashes
    "method_scalar": (0, "o", "-"),
    "method_batch": (1, "s", (0, (4, 2))),
    "method_compiled": (2, "D", (0, (1, 1.5))),
    "method_single": (3, "v", "-"),
    "method_newton": (4, "^", "-"),
    "method_differences": (5, "P", "-"),
    "method_digits": (6, "X", "-"),
    "method_pencil": (6, "_", "-"),
}
LOOKS_OF_OTHER_PROGRAMS = (7, "<", "--"), (8, ">", "--"), (9, "d", "--")  # of other programs, in turn
LEAST_DRAWN_ERROR = 1e-17  # smaller errors than the last place of a double are drawn here
LEADER_LINE_LOOK = {"arrowstyle": "-", "color": "#888888", "linewidth": 0.6}  # to words far from their mark
OUR_METHODS = "method_scalar", "method_batch", "method_compiled"
EQUAL_ACCURACY_FACTOR = 1e3  # factor between errors within which two methods are equally accurate
HALF_DIGITS_ERROR = 1e-8
MOST_DRAWN_ERROR = 10.0  # larger multiples of the true value are not drawn: the method has failed
LEAST_REGION_SHARE = 0.01  # of the grid: a smaller region gets no number
SHADE_OF_TWO_ASSEMBLIES = 0.11  # how much two more assemblies darken a region


def draw_method_charts(
    path: Path,
    title: str,
    spots: list[Method],
    seconds: str,
    way: Approach | None,
    axis: str,
    names: NamesByName,
    lang: Lang,
    turn: tuple[Turning, str] | None = None,
) -> None:
    """Draw the charts side by side, into a file by its suffix; ``seconds`` describes what was timed, and on which
    machine, ``axis`` the distances to a limit, ``names`` its methods; ``turn`` are the turning curves and the name of
    their drive."""
    count = 1 + (way is not None) + (turn is not None)
    with rc_context(FILE_CHART_STYLE):
        figure = Figure(figsize=(8.0 if count == 1 else 6.3 * count, 5.6), dpi=150, layout="constrained")
        figure.suptitle(title, fontsize=10.5)
        plots = figure.subplots(1, count, squeeze=False)[0]
        _draw_speed(plots[0], spots, seconds, lang)
        if way is None:
            plots[0].set_title(say("chart_no_limit" if turn is None else "chart_speed", lang), fontsize=10)
        else:
            draw_approach(plots[1], way, axis, names, lang)
        if turn:
            draw_turning(plots[-1], *turn, lang)
        save_figure(figure, path)


def method_looks(keys: Iterable[str]) -> dict[str, Look]:
    """Colour, marker and dashes of each method."""
    others = cycle(LOOKS_OF_OTHER_PROGRAMS)
    return {key: LOOK_OF_METHOD.get(key) or next(others) for key in dict.fromkeys(keys)}


def _draw_speed(plot: Axes, spots: list[Method], seconds: str, lang: Lang) -> None:
    plot.set(xscale="log", yscale="log", xlabel=seconds, ylabel=say("chart_error", lang))
    plot.set_title(say("chart_speed", lang), fontsize=10)
    pencils, methods = ([m for m in spots if (m.key == "method_pencil") is by_hand] for by_hand in (True, False))
    looked = method_looks(m.key for m in methods)
    for m in methods:
        colour, marker, _ = looked[m.key]
        plot.plot([m.seconds], [m.error], marker, color=METHOD_COLOURS[colour], markersize=7, zorder=3)
    low = min(m.seconds for m in methods)
    high = max(m.seconds for m in methods)
    plot.set_xlim(low / 3, high * 60)
    plot.set_ylim(min(m.error for m in spots) / 200, 10 * max(m.error for m in spots))
    _label_methods(plot, methods, lang)
    _draw_pencil_band(plot, pencils, lang)
    _write_conclusion(plot, conclusion_of_speed(methods, lang))


def _label_methods(plot: Axes, spots: Sequence[Method], lang: Lang) -> None:
    """Names beside the marks, each as near as possible without touching another mark or name."""
    marks = [plot.transData.transform((m.seconds, m.error)) * 72 / plot.figure.dpi for m in spots]
    taken = [(x - 6, y, x + 6) for x, y in marks]
    for (x, y), m in sorted(zip(marks, spots, strict=True), key=lambda pair: (pair[1].error, pair[1].seconds)):
        words = m.name_in_language(lang)
        shift = next(d for d in LABEL_SHIFTS_PT if _is_free((x + 9, y + d, x + 12 + 5.2 * len(words)), taken))
        taken.append((x + 9, y + shift, x + 12 + 5.2 * len(words)))
        line = LEADER_LINE_LOOK if abs(shift) > 6 else None
        annotate_beside(plot, words, (m.seconds, m.error), (9, shift), va="center", fontsize=8.5, arrowprops=line)


LABEL_SHIFTS_PT = [0.0] + [side * 6.5 * k for k in range(2, 60) for side in (1, -1)]


def _is_free(box: tuple[float, float, float], taken: Sequence[tuple[float, float, float]]) -> bool:
    left, y, right = box
    return all(abs(y - b) >= 12 or right < a or c < left for a, b, c in taken)


def _draw_pencil_band(plot: Axes, pencils: Sequence[Method], lang: Lang) -> None:
    """The error of a pencil, whatever its time: from the sheet of the largest error to that of the smallest."""
    if not pencils:
        return
    worst = max(pencils, key=lambda m: m.error)
    best = min(pencils, key=lambda m: m.error)
    plot.axhspan(best.error, worst.error, color="#dddddd", zorder=0)
    text = say("chart_pencils", lang, worst=worst.number, best=best.number)
    left = plot.get_xlim()[0]
    annotate_beside(plot, text, (left, best.error), (6, -3), va="top", fontsize=8.5)


def _write_conclusion(plot: Axes, text: str) -> None:
    """The conclusion from a panel, beneath it."""
    plot.set_xlabel(f"{plot.get_xlabel()}\n\n{text}", fontsize=9)


def power_of_ten(x: float) -> str:
    """The nearest power of ten, as lettered on charts."""
    return f"$10^{{{round(math.log10(x))}}}$"


def two_digit_number(x: float) -> str:
    """Two significant digits, grouped in thousands: 37 000."""
    size = 10 ** max(math.floor(math.log10(x)) - 1, 0)
    if x >= 10:
        return f"{round(x / size) * size:,}".replace(",", "\u2009")
    return f"{x:.2g}"


def conclusion_of_speed(methods: Sequence[Method], lang: Lang) -> str:
    """The time of our fastest method, and its ratio to the nearest other method of the same accuracy."""
    ours = min((m for m in methods if m.key in OUR_METHODS), key=lambda m: m.seconds)
    others = [
        m
        for m in methods
        if m.key not in (*OUR_METHODS, "method_digits") and m.error < EQUAL_ACCURACY_FACTOR * ours.error
    ]
    name = ours.name_in_language(lang)
    facts = {"ns": f"{ours.seconds * 1e9:.2g}", "error": power_of_ten(ours.error), "ours": name[:1].upper() + name[1:]}
    if not others:
        return say("chart_says_alone", lang, **facts)
    near = min(others, key=lambda m: m.seconds)
    return say(
        "chart_says_speed",
        lang,
        other=near.name_in_language(lang),
        times=two_digit_number(near.seconds / ours.seconds),
        **facts,
    )


def conclusion_of_stability(way: Approach, lang: Lang) -> str:
    """The distance to the limit at which half of all digits are left, and whether the claimed error held all the
    way."""
    mine = np.asarray(way.errors["method_scalar"])
    claim = np.asarray(way.claim)
    kept = [d for d, e in zip(way.distances, mine, strict=True) if e < HALF_DIGITS_ERROR]
    held = bool(np.all((mine <= claim) | np.isnan(mine)))
    key = "chart_says_held" if held else "chart_says_not_held"
    return say(key, lang, near=power_of_ten(min(kept, default=max(way.distances))))


def draw_approach(plot: Axes, way: Approach, axis: str, names: NamesByName, lang: Lang) -> None:
    """Errors of every method on the way to a limit, the claimed one as a band."""
    plot.set(xscale="log", yscale="log", xlabel=axis, ylabel=say("chart_at", lang))
    plot.set_title(say(f"chart_{way.limit.kind}", lang), fontsize=10)
    d = way.distances
    plot.plot(d, way.sharpness, color="#777777", linestyle="-.", linewidth=1.0, label=say("chart_sharpness", lang))
    plot.fill_between(d, LEAST_DRAWN_ERROR, [min(c, 1e6) for c in way.claim], color="#e8e8e8", zorder=0)
    plot.plot(d, way.claim, color="#999999", linewidth=2.0, label=say("chart_claim", lang), zorder=1)
    looked = method_looks(way.errors)
    for key, errors in way.errors.items():
        colour, marker, dashes = looked[key]
        shown = [max(e, LEAST_DRAWN_ERROR) if e < MOST_DRAWN_ERROR else float("nan") for e in errors]
        wide = {"method_scalar": 1.8, "method_batch": 1.6, "method_compiled": 1.6}.get(key, 1.0)
        looks = {"color": METHOD_COLOURS[colour], "marker": marker, "linestyle": dashes, "linewidth": wide}
        plot.plot(d, shown, markersize=3.5, label=names[key], **looks)
    plot.set_xlim(max(d) * 2, min(d) / 2)
    shown = [
        e
        for e in (*way.claim, *way.sharpness, *(e for row in way.errors.values() for e in row))
        if e < MOST_DRAWN_ERROR
    ]
    plot.set_ylim(LEAST_DRAWN_ERROR / 3, 10 * max(shown))
    _write_conclusion(plot, conclusion_of_stability(way, lang))
    plot.figure.legend(*plot.get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=8.5)


def draw_turning(plot: Axes, turn: Turning, axis: str, lang: Lang) -> None:
    """Regions in grey with their number of assemblies, the curves between them, and the position of the scene."""
    low = turn.values[0]
    high = turn.values[-1]
    plot.set(xlim=(low, high), ylim=(turn.lengths[0], turn.lengths[-1]), yscale="log", xlabel=axis)
    plot.set_ylabel(say("chart_turning_length", lang, name=turn.name))
    plot.set_title(say("chart_turning" if turn.whole else "chart_turning_part", lang, name=turn.name), fontsize=9.5)
    plot.grid(visible=False)
    shade = 1 - SHADE_OF_TWO_ASSEMBLIES * turn.count / 2
    plot.pcolormesh(turn.values, turn.lengths, shade, cmap="gray", vmin=0.0, vmax=1.0, zorder=0, rasterized=True)
    for k, curve in enumerate(turn.curves):
        colour, _ = CURVE_LOOKS[(k + 1) % len(CURVE_LOOKS)]
        plot.plot(*_break_curve_at_edges(curve.values, curve.lengths, low, high), color=colour, linewidth=1.6)
    for i, j in _deepest_cells(turn.count):
        plot.text(turn.values[i], turn.lengths[j], f"{turn.count[j, i]}", ha="center", va="center", fontsize=8.5)
    value, length = turn.here
    plot.plot([(value - low) % (high - low) + low], [length], "o", color="#000000", markersize=4)
    plot.minorticks_off()
    if high - low == 360:
        plot.xaxis.set_major_locator(MultipleLocator(60))
    ticks = np.round(np.geomspace(turn.lengths[0], turn.lengths[-1], 7), 3)
    plot.set_yticks(ticks, [f"{t:.3g}" for t in ticks])


def _break_curve_at_edges(values: Array, lengths: Array, low: float, high: float) -> ArrayPair:
    """A curve shifted into the chart's turn of the drive, broken where it crosses its edge."""
    inside = (values - low) % (high - low) + low
    inside = np.where((values < low) | (values > high), inside, values)
    cuts = np.flatnonzero(abs(np.diff(inside)) > (high - low) / 2) + 1
    return np.insert(inside, cuts, np.nan), np.insert(lengths, cuts, np.nan)


def _deepest_cells(count: Indices) -> list[tuple[int, int]]:
    """The cell deepest inside each region of the grid with the same number of assemblies."""
    deepest_cells = []
    for number in np.unique(count):
        left = count == number
        while left.sum() > LEAST_REGION_SHARE * count.size:
            deepest = left
            while (inner := _with_neighbour_cells(deepest).all(axis=0)).any():
                deepest = inner
            j, i = np.argwhere(deepest)[len(np.argwhere(deepest)) // 2]
            region = np.zeros_like(left)
            region[j, i] = True
            if _connected_cells(region, left).sum() > LEAST_REGION_SHARE * count.size:
                deepest_cells.append((int(i), int(j)))
            left = left & ~_connected_cells(region, left)
    return deepest_cells


def _with_neighbour_cells(region: Booleans) -> Booleans:
    """Each cell with the four beside it."""
    wide = np.pad(region, 1)
    return np.stack([wide[1:-1, 1:-1], wide[2:, 1:-1], wide[:-2, 1:-1], wide[1:-1, 2:], wide[1:-1, :-2]])


def _connected_cells(seed: Booleans, within: Booleans) -> Booleans:
    """All cells connected with the seed."""
    while True:
        grown = _with_neighbour_cells(seed).any(axis=0) & within
        if (grown == seed).all():
            return seed
        seed = grown
