"""Marks -> SVG by svgwrite: one user unit is one millimetre, y down; no markers, patterns or fonts needed.

Text is drawn as pen strokes; transparent real text lies over it for searching and copying.  The same marks give the
same bytes.

This is the only module that uses svgwrite. Its authors call it inactive: it no longer changes, nor does SVG 1.1, the
only version used here. It checks every attribute it writes. To replace it, replace this file.
"""

from __future__ import annotations

import base64
import cmath
import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING

from render.files.writer import Lines, Writer, fitted_dashes
from render.paper.ink import arc_dashes, group_by_layer, is_circle, require_finite_marks
from render.paper.marks import Arc, Arrow, Mark, Size, Text
from render.paper.photo import Photo
from render.paper.style import BLACK_COLOUR, CAPITALS_HEIGHT_RATIO, PAPER_COLOUR, pen_of_style
from render.paper.typeset import lay_out_text

if TYPE_CHECKING:
    from svgwrite import Drawing
    from svgwrite.container import Group
    from svgwrite.path import Path

FONT_FAMILIES = "DejaVu Sans, Arial, sans-serif"


def write(marks: Iterable[Mark], size_mm: Size, title: str, *, lang: str = "ru", under: Photo | None = None) -> bytes:
    """The sheet as an SVG file, UTF-8, with a picture ``under`` it."""
    return _Sheet(size_mm, title, lang).file_bytes(require_finite_marks(marks, size_mm), under)


def svg_number(value: float) -> str:
    """A coordinate in mm to the micrometre, without trailing zeros."""
    return f"{value:z.3f}".rstrip("0").rstrip(".")


class _Sheet(Writer):
    """One SVG drawing under construction; marks are added to ``group``."""

    group: Group

    def __init__(self, size_mm: Size, title: str, lang: str) -> None:
        import svgwrite

        self.width, self.height = size_mm
        wide, high = map(svg_number, size_mm)
        self.svg: Drawing = svgwrite.Drawing(size=(f"{wide}mm", f"{high}mm"), viewBox=f"0 0 {wide} {high}", debug=False)
        self.svg.set_desc(title)
        self.svg.attribs.update({"role": "img", "aria-label": title, "xml:lang": lang, "lang": lang})

    def file_bytes(self, marks: Iterable[Mark], under: Photo | None = None) -> bytes:
        """The file with a white background and one group for each layer."""
        self.svg.add(self.svg.rect((0, 0), (svg_number(self.width), svg_number(self.height)), fill=PAPER_COLOUR))
        if under:
            href = "data:image/jpeg;base64," + base64.b64encode(under.data).decode()
            x0, y0, x1, y1 = under.box
            corner = (svg_number(x0), svg_number(self.height - y1))
            size = (svg_number(x1 - x0), svg_number(y1 - y0))
            self.svg.add(self.svg.image(href, corner, size, preserveAspectRatio="none"))
        for layer, held in group_by_layer(marks):
            self.group = self.svg.g(id=layer, fill="none", stroke_linejoin="round", stroke_linecap="round")
            self.write_marks(held)
            self.svg.add(self.group)
        return f'<?xml version="1.0" encoding="UTF-8"?>\n{self.svg.tostring()}\n'.encode()

    def _xy_text(self, z: complex) -> str:
        return f"{svg_number(z.real)} {svg_number(self.height - z.imag)}"

    def _path_data(self, lines: Iterable[Sequence[complex]], closed: bool = False) -> str:
        end = "Z" if closed else ""
        return "".join("M" + "L".join(map(self._xy_text, line)) + end for line in lines)

    def _add_path(self, path: str, style: str, dashes: Sequence[float]) -> Path:
        used = pen_of_style(style)
        looks = {"stroke": used.colour, "stroke_width": svg_number(used.width)}
        if dashes:
            looks |= {"stroke_dasharray": " ".join(map(svg_number, dashes)), "stroke_linecap": "butt"}
        return self.group.add(self.svg.path(d=path, **looks))

    def write_strokes(self, lines: Lines, style: str, layer: str, closed: bool = False) -> None:
        """Polylines as one path."""
        self._add_path(self._path_data(lines, closed), style, fitted_dashes(lines, style, closed))

    def write_filled_polygon(self, points: Sequence[complex], colour: str, layer: str) -> None:
        """A filled polygon."""
        self.group.add(self.svg.path(d=self._path_data([points], closed=True), fill=colour))

    def write_arc(self, arc: Arc) -> None:
        """Two halves of a circle, or an arc."""
        start, half, end = (
            arc.centre + cmath.rect(arc.radius, math.radians(a))
            for a in (arc.start_deg, (arc.start_deg + arc.end_deg) / 2, arc.end_deg)
        )
        r = svg_number(arc.radius)
        legs = half, start if is_circle(arc) else end
        path = f"M{self._xy_text(start)}" + "".join(f"A{r} {r} 0 0 0 {self._xy_text(z)}" for z in legs)
        element = self._add_path(path + ("Z" if is_circle(arc) else ""), arc.style, arc_dashes(arc))
        if arc.fill != "none":
            element["fill"] = PAPER_COLOUR if arc.fill == "paper" else BLACK_COLOUR

    def write_arrow(self, arrow: Arrow) -> None:
        """Shaft and head as a group with the name of the vector."""
        around = self.group
        self.group = self.svg.g(**({"data-name": arrow.name} if arrow.name else {}))
        super().write_arrow(arrow)
        around.add(self.group)
        self.group = around

    def draw_text(self, text: Text) -> None:
        """Strokes, with the text itself over them, transparent."""
        laid = lay_out_text(text)
        if not laid.runs:
            return
        group = self.svg.g(**({"data-name": text.name} if text.name else {}))
        for width, lines in laid.strokes_by_pen_width():
            looks = (
                {"fill": BLACK_COLOUR} if laid.filled else {"stroke": BLACK_COLOUR, "stroke_width": svg_number(width)}
            )
            group.add(self.svg.path(d=self._path_data(lines), **looks))
        turn = f" rotate({svg_number(-laid.turn_deg)})" if laid.turn_deg else ""
        real = self.svg.text(
            "",
            transform=f"translate({self._xy_text(laid.origin)}){turn}",
            fill=BLACK_COLOUR,
            fill_opacity=0,
            font_family=FONT_FAMILIES,
        )
        for run in laid.runs:
            size = svg_number(run.height / CAPITALS_HEIGHT_RATIO)
            x = svg_number(run.at.real)
            y = svg_number(-run.at.imag)
            real.add(self.svg.tspan(run.text, x=[x], y=[y], font_size=size))
        group.add(real)
        self.group.add(group)
