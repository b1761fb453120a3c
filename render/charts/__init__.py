"""Charts: curves over an axis, as strokes. Colours are distinct in grey and for the colour-blind, dashes for
everybody."""

import io
import re
from pathlib import Path
from typing import Any

from matplotlib import rc_context
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.layout_engine import TightLayoutEngine
from matplotlib.ticker import FuncFormatter, MultipleLocator

from planes.scene import files
from planes.solving.document import Chart
from planes.words import Lang
from render.charts.strokes import Picture, StrokeRenderer
from render.paper.letters import with_minus_and_decimal_sign

POINTS_PER_MM = 72 / 25.4
CURVE_LOOKS = (
    ("#000000", "-"),
    ("#c1440e", "--"),
    ("#1f5fa8", "-."),
    ("#2f7d32", ":"),
    ("#7a3b8f", (0, (8, 2))),
    ("#777777", "-"),
)
CHART_STYLE: Any = {
    "font.family": "DejaVu Sans",
    "font.size": 8.0,
    "axes.linewidth": 0.7,
    "lines.linewidth": 1.3,
    "axes.grid": True,
    "grid.linewidth": 0.4,
    "grid.color": "#cccccc",
    "legend.frameon": False,
    "mathtext.fontset": "dejavusans",
    "axes.unicode_minus": True,
    "path.simplify": False,
}
FILE_CHART_STYLE = {**CHART_STYLE, "font.size": 9.0, "svg.hashsalt": "planes", "svg.fonttype": "path"}


def draw_chart(shown: Chart, width_mm: float, lang: Lang) -> Picture:
    """Draw a chart."""
    width = width_mm * POINTS_PER_MM
    height = shown.height_mm * POINTS_PER_MM
    with rc_context(CHART_STYLE):
        figure = Figure(figsize=(width / 72, height / 72), dpi=72, layout=TightLayoutEngine(pad=0.4))
        plot = figure.add_subplot()
        for c in shown.curves:
            colour, dashes = CURVE_LOOKS[c.style % len(CURVE_LOOKS)]
            plot.plot(c.x, c.y, color=colour, linestyle=dashes, label=c.label or None)
        _set_up_axes(plot, shown, lang)
        for x, y, text in shown.notes:
            plot.plot([x], [y], "o", color="#000000", markersize=2.5)
            annotate_beside(plot, text, (x, y), (3, 3), fontsize=7)
        renderer = StrokeRenderer(width, height)
        figure.draw(renderer)
    return renderer.picture


def annotate_beside(plot: Axes, text: str, place: tuple[float, float], by: tuple[float, float], **looks: Any) -> None:
    """Words at a distance of so many points from a place."""
    plot.annotate(text, place, by, textcoords="offset points", **looks)


def _set_up_axes(plot: Axes, axes: Chart, lang: Lang) -> None:
    plot.set_xlabel(axes.x)
    plot.set_ylabel(axes.y)
    plot.axhline(0.0, color="#000000", linewidth=0.6, zorder=1)
    if axes.equal:
        plot.axvline(0.0, color="#000000", linewidth=0.6, zorder=1)
        plot.margins(0.08)
        plot.set_aspect("equal", adjustable="datalim")
    else:
        low = min(float(min(c.x)) for c in axes.curves)
        high = max(float(max(c.x)) for c in axes.curves)
        plot.set_xlim(low, high)
    if axes.ticks:
        plot.xaxis.set_major_locator(MultipleLocator(axes.ticks))
    formatter = FuncFormatter(lambda v, _: with_minus_and_decimal_sign(f"{v:.6g}", lang))
    plot.xaxis.set_major_formatter(formatter)
    plot.yaxis.set_major_formatter(formatter)
    if any(c.label for c in axes.curves):
        plot.legend(loc="upper left", bbox_to_anchor=(1.0, 1.0), handlelength=3.2)


METADATA_OF_SUFFIX = {".png": {"Software": None}, ".svg": {"Date": None}, ".pdf": {"CreationDate": None}}
GENERATED_NAME_PATTERN = re.compile(
    rb"\b[pmh][0-9a-f]{10}\b"
)  # of a clip, a marker or a hatch: varies with the last bit


def save_figure(figure: Figure, path: Path) -> None:
    """Write a figure; names within an SVG are numbered by us, so that rounding of the layout does not change them."""
    kind = path.suffix.lower()
    out = io.BytesIO()
    figure.savefig(out, format=kind[1:], metadata=METADATA_OF_SUFFIX[kind])
    data = out.getvalue()
    names = dict[bytes, bytes]()
    if kind == ".svg":
        data = GENERATED_NAME_PATTERN.sub(lambda m: names.setdefault(m[0], b"n%d" % (len(names) + 1)), data)
    files.save_bytes(data, path)
