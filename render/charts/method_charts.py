"""Charts of methods: speed against accuracy with its front, errors on the way to a limit, and turning curves."""

from collections.abc import Iterable, Mapping, Sequence
from itertools import cycle
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from planes.accuracy.methods import Method, front
from planes.accuracy.stability import Approach
from planes.accuracy.turning import Turning
from planes.words import Lang, say
from render.charts import OF_FILES, beside, save
from render.charts.turning_chart import draw_turning

INK = ("#000000", "#1f5fa8", "#c1440e", "#2f7d32", "#7a3b8f", "#8a6d00", "#777777", "#0f8b8d", "#d0307a")
Look = tuple[int, str, Any]
LOOK: dict[str, Look] = {  # of a method: colour, marker, dashes
    "method_scalar": (0, "o", "-"),
    "method_batch": (1, "s", (0, (4, 2))),
    "method_compiled": (2, "D", (0, (1, 1.5))),
    "method_single": (3, "v", "-"),
    "method_newton": (4, "^", "-"),
    "method_differences": (5, "P", "-"),
    "method_digits": (6, "X", "-"),
    "method_pencil": (6, "_", "-"),
}
OTHERS = (7, "<", "--"), (8, ">", "--")  # of programs by others, in turn
FLOOR = 1e-17  # errors below the last place of a double are drawn here
LEADER = {"arrowstyle": "-", "color": "#888888", "linewidth": 0.6}  # to words that stand far from their mark
NONSENSE = 1e6  # errors so many times the truth are not drawn: the method is lost


def draw(
    path: Path,
    title: str,
    spots: list[Method],
    seconds: str,
    way: Approach | None,
    axis: str,
    names: Mapping[str, str],
    lang: Lang,
    turn: tuple[Turning, str] | None = None,
) -> None:
    """The charts side by side, in a file by its suffix; ``seconds`` says what was timed, and on which machine,
    ``axis`` what the distances to a limit are, ``names`` what its methods are called; ``turn`` the turning curves and
    what their drive is called."""
    count = 1 + (way is not None) + (turn is not None)
    with rc_context(OF_FILES):
        figure = Figure(figsize=(8.0 if count == 1 else 6.3 * count, 5.6), dpi=150, layout="constrained")
        figure.suptitle(title, fontsize=10.5)
        plots = figure.subplots(1, count, squeeze=False)[0]
        _speed(plots[0], spots, seconds, lang)
        if way is None:
            plots[0].set_title(say("chart_no_limit" if turn is None else "chart_speed", lang), fontsize=10)
        else:
            _stability(plots[1], way, axis, names, lang)
        if turn:
            draw_turning(plots[-1], *turn, lang)
        save(figure, path)


def looks_of(keys: Iterable[str]) -> dict[str, Look]:
    """Colour, marker and dashes of each method."""
    others = cycle(OTHERS)
    return {key: LOOK.get(key) or next(others) for key in dict.fromkeys(keys)}


def _speed(plot: Axes, spots: list[Method], seconds: str, lang: Lang) -> None:
    plot.set(xscale="log", yscale="log", xlabel=seconds, ylabel=say("chart_error", lang))
    plot.set_title(say("chart_speed", lang), fontsize=10)
    steps = [(m.seconds, m.error) for m in front(spots)]
    looks: dict[str, Any] = {"color": "#bbbbbb", "linewidth": 5, "solid_capstyle": "round", "zorder": 1}
    plot.plot(*zip(*steps, strict=True), label=say("chart_front", lang), **looks)
    looked = looks_of(m.key for m in spots)
    for m in spots:
        colour, marker, _ = looked[m.key]
        plot.plot([m.seconds], [m.error], marker, color=INK[colour], markersize=7 if marker != "_" else 9, zorder=3)
    low, high = min(m.seconds for m in spots), max(m.seconds for m in spots)
    plot.set_xlim(low / 3, high * 60)
    plot.set_ylim(min(m.error for m in spots) / 20, 30)
    _label(plot, [m for m in spots if m.key != "method_pencil"], lang)
    _label_pencils(plot, [m for m in spots if m.key == "method_pencil"], lang)
    plot.legend(loc="upper left")


def _label(plot: Axes, spots: Sequence[Method], lang: Lang) -> None:
    """Names beside the marks, each as near as it can stand without touching another mark or name."""
    marks = [plot.transData.transform((m.seconds, m.error)) * 72 / plot.figure.dpi for m in spots]
    taken = [(x - 6, y, x + 6) for x, y in marks]
    for (x, y), m in sorted(zip(marks, spots, strict=True), key=lambda pair: (pair[1].error, pair[1].seconds)):
        words = m.name(lang)
        shift = next(d for d in OFFSETS if _free((x + 9, y + d, x + 12 + 5.2 * len(words)), taken))
        taken.append((x + 9, y + shift, x + 12 + 5.2 * len(words)))
        line = LEADER if abs(shift) > 6 else None
        beside(plot, words, (m.seconds, m.error), (9, shift), va="center", fontsize=8.5, arrowprops=line)


OFFSETS = [0.0] + [side * 6.5 * k for k in range(2, 60) for side in (1, -1)]


def _free(box: tuple[float, float, float], taken: Sequence[tuple[float, float, float]]) -> bool:
    left, y, right = box
    return all(abs(y - b) >= 12 or right < a or c < left for a, b, c in taken)


def _label_pencils(plot: Axes, pencils: Sequence[Method], lang: Lang) -> None:
    """One name for all pencils, and the sheets of the largest and the smallest error."""
    if not pencils:
        return
    right = max(m.seconds for m in pencils)
    worst, best = max(pencils, key=lambda m: m.error), min(pencils, key=lambda m: m.error)
    text = say("chart_pencils", lang, worst=worst.number, best=best.number)
    beside(plot, text, (right, (worst.error * best.error) ** 0.5), (10, 0), va="center", fontsize=8.5)


def _stability(plot: Axes, way: Approach, axis: str, names: Mapping[str, str], lang: Lang) -> None:
    plot.set(xscale="log", yscale="log", xlabel=axis, ylabel=say("chart_at", lang))
    plot.set_title(say(f"chart_{way.limit.kind}", lang), fontsize=10)
    d = way.distances
    plot.plot(d, way.sharpness, color="#777777", linestyle="-.", linewidth=1.0, label=say("chart_sharpness", lang))
    plot.fill_between(d, FLOOR, [min(c, 1e6) for c in way.claim], color="#e8e8e8", zorder=0)
    plot.plot(d, way.claim, color="#999999", linewidth=2.0, label=say("chart_claim", lang), zorder=1)
    looked = looks_of(way.errors)
    for key, errors in way.errors.items():
        colour, marker, dashes = looked[key]
        shown = [max(e, FLOOR) if e < NONSENSE else float("nan") for e in errors]
        wide = {"method_scalar": 1.8, "method_batch": 1.6, "method_compiled": 1.6}.get(key, 1.0)
        looks: dict[str, Any] = {"color": INK[colour], "marker": marker, "linestyle": dashes, "linewidth": wide}
        plot.plot(d, shown, markersize=3.5, label=names[key], **looks)
    plot.set_xlim(max(d) * 2, min(d) / 2)
    plot.set_ylim(FLOOR / 3, 1e7)
    plot.figure.legend(*plot.get_legend_handles_labels(), loc="outside lower center", ncols=5, fontsize=8.5)
