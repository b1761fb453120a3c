"""Lines of mathematics as outlines, typeset by matplotlib's own engine; the same in HTML and in PDF."""

from __future__ import annotations

from functools import lru_cache

from matplotlib.font_manager import FontProperties
from matplotlib.textpath import TextPath, text_to_path

from render.charts.strokes import Picture, Stroke, pieces_of

INK = "#000000"


@lru_cache(maxsize=2000)
def formula(tex: str, size: float = 11.0) -> Picture:
    """A formula at a letter size in points."""
    prop = FontProperties(family="DejaVu Serif", size=size, math_fontfamily="dejavuserif")
    text = f"${tex}$"
    width, height, depth = text_to_path.get_text_width_height_descent(text, prop, True)
    path = TextPath((0, 0), text, size=size, prop=prop)
    pad = 1.0
    moved = path.transformed(_shift(pad, depth + pad))
    return Picture(width + 2 * pad, height + 2 * pad, [Stroke(pieces_of(moved), fill=INK)], depth + pad)


def _shift(x: float, y: float):  # type: ignore[no-untyped-def]
    from matplotlib.transforms import Affine2D

    return Affine2D().translate(x, y)
