"""Pictures as plain paths: matplotlib output (charts, mathematics), kept as strokes for both SVG and PDF.

Units are points, y up. Text is converted to outlines, so a page needs no font and no network.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from html import escape
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.backend_bases import GraphicsContextBase, RendererBase
from matplotlib.colors import to_hex
from matplotlib.font_manager import FontProperties
from matplotlib.path import Path
from matplotlib.textpath import TextPath
from matplotlib.transforms import Affine2D, Transform

from planes.words.frozen import frozen

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

Piece = tuple[str, tuple[float, ...]]  # "M", "L", "C" with coordinates, "Z" with none


@frozen
class Stroke:
    """A path with its pen: ``line`` and ``fill`` are colours (#rrggbb, "" for none)."""

    pieces: tuple[Piece, ...]
    line: str = ""
    width: float = 0.0
    dashes: tuple[float, ...] = ()
    fill: str = ""


@dataclass
class Picture:
    """Strokes on a paper of ``width`` × ``height`` points."""

    width: float
    height: float
    strokes: list[Stroke] = field(default_factory=list)

    def inline_svg(self, label: str) -> str:
        """An inline SVG element; ``label`` is its text for screen readers."""
        body = "".join(_svg_path_element(s, self.height) for s in self.strokes)
        size = f'width="{self.width:.1f}pt" height="{self.height:.1f}pt"'
        box = f'viewBox="0 0 {self.width:.2f} {self.height:.2f}"'
        return f'<svg {size} {box} role="img" aria-label="{escape(label)}">{body}</svg>'

    def draw(self, canvas: Canvas) -> None:
        """Draw on a reportlab canvas, the lower left corner in its origin."""
        for s in self.strokes:
            path = canvas.beginPath()
            for kind, at in s.pieces:
                {"M": path.moveTo, "L": path.lineTo, "C": path.curveTo, "Z": path.close}[kind](*at)
            if s.line:
                canvas.setStrokeColor(s.line)
                canvas.setLineWidth(s.width)
                canvas.setDash(list(s.dashes))
            if s.fill:
                canvas.setFillColor(s.fill)
            canvas.drawPath(path, stroke=int(bool(s.line)), fill=int(bool(s.fill)))
        canvas.setDash()


def _svg_path_element(s: Stroke, height: float) -> str:
    flipped = []
    for kind, at in s.pieces:
        xy = (f"{height - v if i % 2 else v:.2f}".rstrip("0").rstrip(".") for i, v in enumerate(at))
        flipped.append(kind + " ".join(xy))
    looks = f' fill="{s.fill or "none"}"'
    if s.line:
        looks += f' stroke="{s.line}" stroke-width="{s.width:.2f}" stroke-linejoin="round"'
    if s.dashes:
        looks += f' stroke-dasharray="{" ".join(f"{d:.1f}" for d in s.dashes)}"'
    return f'<path d="{"".join(flipped)}"{looks}/>'


def path_pieces(
    path: Path, transform: Transform | None = None, clip: tuple[float, float, float, float] | None = None
) -> tuple[Piece, ...]:
    """A matplotlib path as moves, lines and cubic curves."""
    pieces = []
    x = y = 0.0
    for points, code in path.iter_segments(transform or Affine2D(), simplify=False, clip=clip, curves=True):
        at = tuple(points.tolist())
        if code == Path.CURVE3:
            cx, cy = at[:2]
            ex, ey = at[2:]
            at = (x + 2 / 3 * (cx - x), y + 2 / 3 * (cy - y), ex + 2 / 3 * (cx - ex), ey + 2 / 3 * (cy - ey), ex, ey)
        if code == Path.CLOSEPOLY:
            pieces.append(("Z", ()))
            continue
        pieces.append(({Path.MOVETO: "M", Path.LINETO: "L"}.get(code, "C"), at))
        x, y = at[-2:]
    return tuple(pieces)


class StrokeRenderer(RendererBase):
    """Captures matplotlib's drawing commands as strokes."""

    def __init__(self, width: float, height: float) -> None:
        super().__init__()
        self.picture = Picture(width, height)

    def draw_path(self, gc: GraphicsContextBase, path: Path, transform: Transform, rgbFace: Any = None) -> None:
        """Store one path with its pen."""
        box = gc.get_clip_rectangle()
        clip = None if box is None or rgbFace is not None else tuple[float, float, float, float](box.extents)
        width = gc.get_linewidth()
        _, dashes = gc.get_dashes()
        line = to_hex(gc.get_rgb()) if width > 0 and gc.get_rgb()[3] > 0 else ""
        fill = to_hex(rgbFace) if rgbFace is not None and (len(rgbFace) < 4 or rgbFace[3] > 0) else ""
        kept = tuple(map(float, np.asarray(dashes))) if dashes is not None else ()
        if line or fill:
            self.picture.strokes.append(Stroke(path_pieces(path, transform, clip), line, float(width), kept, fill))

    def draw_text(
        self, gc: GraphicsContextBase, x: float, y: float, s: str, prop: FontProperties, angle: float, *_: Any, **m: Any
    ) -> None:
        """Text as its outlines."""
        path = TextPath((0, 0), s, size=prop.get_size_in_points(), prop=prop)
        placed = Affine2D().rotate_deg(angle).translate(x, y)
        self.picture.strokes.append(Stroke(path_pieces(path, placed), fill=to_hex(gc.get_rgb())))

    def get_canvas_width_height(self) -> tuple[float, float]:
        """The paper in points."""
        return self.picture.width, self.picture.height

    def flipy(self) -> bool:
        """y goes up."""
        return False
