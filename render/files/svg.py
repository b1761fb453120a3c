"""Marks -> SVG by svgwrite: one user unit is one millimetre, y down; no markers, patterns or fonts needed.

Text is drawn as pen strokes; transparent real text lies over it for searching and copying.  The same
marks give the same bytes.
"""

from __future__ import annotations

import base64
import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

from planes.scene.files import save
from render.paper.ink import arc_dashes, arrow_parts, by_layer, checked, hatch_strokes, is_circle, length_mm
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.paper.photo import Photo
from render.paper.style import BLACK, CAPITALS, PAPER, fitted, pen
from render.paper.typeset import layout

FONTS = "DejaVu Sans, Arial, sans-serif"


def write(
    marks: Iterable[Mark],
    size_mm: tuple[float, float],
    title: str,
    path: str | Path | None = None,
    *,
    description: str = "",
    lang: str = "ru",
    under: Photo | None = None,
) -> bytes:
    """The sheet as an SVG file, UTF-8, ``under`` it a picture; also written to ``path`` if one is given."""
    return save(_Sheet(size_mm, title, description, lang).drawn(checked(marks, size_mm), under), path)


def inline(marks: Iterable[Mark], size_mm: tuple[float, float], title: str, lang: str = "ru") -> str:
    """The sheet as an SVG element, as a notebook shows it."""
    return write(marks, size_mm, title, lang=lang).decode().partition("?>\n")[2]


def number(value: float) -> str:
    """A coordinate in mm to the micrometre, without idle zeros."""
    return f"{round(value, 3) + 0.0:.3f}".rstrip("0").rstrip(".")


class _Sheet:
    """One SVG drawing in the making."""

    def __init__(self, size_mm: tuple[float, float], title: str, description: str, lang: str) -> None:
        import svgwrite

        self.width, self.height = size_mm
        self.svg: Any = svgwrite.Drawing(
            size=(f"{number(self.width)}mm", f"{number(self.height)}mm"),
            viewBox=f"0 0 {number(self.width)} {number(self.height)}",
            debug=False,
        )
        self.svg.set_desc(title, description or None)
        self.svg.attribs.update({"role": "img", "aria-label": title, "xml:lang": lang, "lang": lang})

    def drawn(self, marks: Iterable[Mark], under: Photo | None = None) -> bytes:
        """The file with a white ground and one group for each layer."""
        self.svg.add(self.svg.rect((0, 0), (number(self.width), number(self.height)), fill=PAPER))
        if under:
            self.svg.add(self._photo(under))
        for layer, held in by_layer(marks):
            group = self.svg.g(id=layer, fill="none", stroke_linejoin="round", stroke_linecap="round")
            for mark in held:
                for element in self._elements(mark):
                    group.add(element)
            self.svg.add(group)
        return f'<?xml version="1.0" encoding="UTF-8"?>\n{self.svg.tostring()}\n'.encode()

    def _photo(self, photo: Photo) -> Any:
        href = "data:image/jpeg;base64," + base64.b64encode(photo.data).decode()
        x0, y0, x1, y1 = photo.box
        corner, size = (number(x0), number(self.height - y1)), (number(x1 - x0), number(y1 - y0))
        return self.svg.image(href, corner, size, preserveAspectRatio="none")

    def _elements(self, mark: Mark) -> list[Any]:
        if isinstance(mark, Line):
            dashes = fitted(pen(mark.style).pattern, length_mm(mark.points, mark.closed), mark.closed)
            return [self._stroke(self._path([mark.points], mark.closed), mark.style, dashes)]
        if isinstance(mark, Arc):
            return [self._arc(mark)]
        if isinstance(mark, Arrow):
            return [self._arrow(mark)]
        if isinstance(mark, Shape):
            return [self._filled(mark.points, PAPER if mark.fill == "paper" else BLACK)]
        if isinstance(mark, Hatch):
            return [self._stroke(self._path(hatch_strokes(mark)), "thin")]
        return self._text(mark)

    def _xy(self, z: complex) -> str:
        return f"{number(z.real)} {number(self.height - z.imag)}"

    def _path(self, lines: Iterable[Sequence[complex]], closed: bool = False) -> str:
        end = "Z" if closed else ""
        return "".join("M" + "L".join(self._xy(z) for z in line) + end for line in lines)

    def _stroke(self, path: str, style: str, dashes: Sequence[float] = ()) -> Any:
        used = pen(style)
        looks: dict[str, Any] = {"stroke": used.colour, "stroke_width": number(used.width)}
        if dashes:
            looks |= {"stroke_dasharray": " ".join(map(number, dashes)), "stroke_linecap": "butt"}
        return self.svg.path(d=path, **looks)

    def _filled(self, points: Sequence[complex], colour: str) -> Any:
        return self.svg.path(d=self._path([points], closed=True), fill=colour)

    def _arc(self, arc: Arc) -> Any:
        start, half, end = (
            arc.centre + arc.radius * complex(math.cos(math.radians(a)), math.sin(math.radians(a)))
            for a in (arc.start_deg, (arc.start_deg + arc.end_deg) / 2, arc.end_deg)
        )
        r = number(arc.radius)
        legs = (half, start) if is_circle(arc) else (half, end)
        path = f"M{self._xy(start)}" + "".join(f"A{r} {r} 0 0 0 {self._xy(z)}" for z in legs)
        element = self._stroke(path + ("Z" if is_circle(arc) else ""), arc.style, arc_dashes(arc))
        if arc.fill != "none":
            element["fill"] = PAPER if arc.fill == "paper" else BLACK
        return element

    def _arrow(self, arrow: Arrow) -> Any:
        group = self.svg.g(**({"data-name": arrow.name} if arrow.name else {}))
        shaft, head = arrow_parts(arrow)
        dashes = fitted(pen(arrow.style).pattern, length_mm(shaft))
        group.add(self._stroke(self._path([shaft]), arrow.style, dashes))
        if head:
            group.add(self._filled(head, pen(arrow.style).colour))
        return group

    def _text(self, text: Text) -> list[Any]:
        laid = layout(text)
        if not laid.runs:
            return []
        group = self.svg.g(**({"data-name": text.name} if text.name else {}))
        for width, lines in laid.by_pen():
            looks = {"fill": BLACK} if laid.filled else {"stroke": BLACK, "stroke_width": number(width)}
            group.add(self.svg.path(d=self._path(lines), **looks))
        turn = f" rotate({number(-laid.turn_deg)})" if laid.turn_deg else ""
        real = self.svg.text(
            "", transform=f"translate({self._xy(laid.origin)}){turn}", fill=BLACK, fill_opacity=0, font_family=FONTS
        )
        for run in laid.runs:
            size = number(run.height / CAPITALS)
            x, y = number(run.at.real), number(-run.at.imag)
            real.add(self.svg.tspan(run.text, x=[x], y=[y], font_size=size))
        group.add(real)
        return [group]
