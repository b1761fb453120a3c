"""Marks -> DXF by ezdxf: real millimetres, layers by meaning, ГОСТ line types and widths, text as text.

Lines are really cut under hinges and sliders, so nothing needs a white mask.  Every run of text is fitted between
the ends of its own lettering, so it is as wide as drawn in whatever font the reader's program puts.  The same marks
give the same bytes.
"""

from __future__ import annotations

import cmath
import io
import math
from collections.abc import Iterable, Sequence
from importlib import import_module
from pathlib import Path
from typing import Any

from render.cutting import uncovered
from render.ink import arrow_parts, checked, hatch_strokes, is_circle, save
from render.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.style import LAYERS, PENS, pen
from render.typeset import layout

FONT = "isocpeur.ttf"
STYLE = "GOST"
BLACK, GREY = 7, 8  # colours of the AutoCAD index; 7 is black on white paper


def write(
    marks: Iterable[Mark], size_mm: tuple[float, float], title: str, path: str | Path | None = None, *, lang: str = "ru"
) -> bytes:
    """The sheet as a DXF file (R2010) in millimetres, 1:1; also written to ``path`` if one is given."""
    ezdxf: Any = import_module("ezdxf")
    fixed = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        document = ezdxf.new("R2010", units=4)
        _tables(document)
        document.header["$MEASUREMENT"] = 1
        document.header["$EXTMIN"], document.header["$EXTMAX"] = (0, 0, 0), (*size_mm, 0)
        document.ezdxf_metadata()["TITLE"] = title
        drawing = _Drawing(document.modelspace())
        for mark in uncovered(checked(marks, size_mm)):
            drawing.mark(mark)
        out = io.StringIO()
        document.write(out)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = fixed
    return save(out.getvalue().encode(), path)


def _tables(document: Any) -> None:
    """Line types, layers and the text style."""
    for name, used in PENS.items():
        if used.pattern:
            parts = [part if k % 2 == 0 else -part for k, part in enumerate(used.pattern)]
            document.linetypes.add(name.upper(), [sum(used.pattern), *parts], description=name)
    for layer in LAYERS:
        document.layers.add(layer.upper(), color=GREY if layer == "construction" else BLACK)
    document.styles.add(STYLE, font=FONT)


class _Drawing:
    """Adds marks to the model space."""

    def __init__(self, space: Any) -> None:
        self.space = space

    def mark(self, mark: Mark) -> None:
        """One mark as the entities a draughtsman would use."""
        if isinstance(mark, Line):
            self.line(mark.points, mark.style, mark.layer, mark.closed)
        elif isinstance(mark, Arc):
            self.arc(mark)
        elif isinstance(mark, Arrow):
            shaft, head = arrow_parts(mark)
            self.line(shaft, mark.style, mark.layer)
            if head:
                self.filled(head, mark.layer)
        elif isinstance(mark, Shape):
            self.filled(mark.points, mark.layer)
        elif isinstance(mark, Hatch):
            for stroke in hatch_strokes(mark):
                self.line(stroke, "thin", mark.layer)
        else:
            self.text(mark)

    def looks(self, style: str, layer: str) -> dict[str, Any]:
        """Layer, line type and line weight (hundredths of a mm) of a mark."""
        used = pen(style)
        dashed = style.upper() if used.pattern else "Continuous"
        return {"layer": layer.upper(), "linetype": dashed, "lineweight": round(100 * used.width)}

    def line(self, points: Sequence[complex], style: str, layer: str, closed: bool = False) -> None:
        """A straight line or a polyline."""
        looks = self.looks(style, layer)
        if len(points) == 2:
            self.space.add_line(*map(_xy, points), dxfattribs=looks)
        else:
            self.space.add_lwpolyline([_xy(z) for z in points], close=closed, dxfattribs=looks)

    def arc(self, arc: Arc) -> None:
        """A circle, an arc, or a filled disc."""
        looks = self.looks(arc.style, arc.layer)
        if is_circle(arc):
            self.space.add_circle(_xy(arc.centre), arc.radius, dxfattribs=looks)
            if arc.fill == "ink":
                fill = self.space.add_hatch(color=BLACK, dxfattribs={"layer": arc.layer.upper()})
                fill.paths.add_edge_path().add_arc(_xy(arc.centre), arc.radius, 0, 360)
        else:
            self.space.add_arc(_xy(arc.centre), arc.radius, arc.start_deg, arc.end_deg, dxfattribs=looks)

    def filled(self, points: Sequence[complex], layer: str) -> None:
        """A filled polygon: of three corners a solid, else a hatch."""
        if len(points) == 3:
            self.space.add_solid([_xy(z) for z in points], dxfattribs={"layer": layer.upper()})
            return
        fill = self.space.add_hatch(color=BLACK, dxfattribs={"layer": layer.upper()})
        fill.paths.add_polyline_path([_xy(z) for z in points], is_closed=True)

    def text(self, text: Text) -> None:
        """Every run of a text as a TEXT fitted between its ends."""
        from ezdxf.enums import TextEntityAlignment

        laid = layout(text)
        turn = cmath.rect(1, math.radians(laid.turn_deg))
        for run in laid.runs:
            start = laid.origin + run.at * turn
            looks = {"layer": text.layer.upper(), "style": STYLE, "height": run.height}
            entity = self.space.add_text(run.text.strip(), dxfattribs=looks)
            entity.set_placement(_xy(start), _xy(start + run.width * turn), TextEntityAlignment.FIT)


def _xy(z: complex) -> tuple[float, float]:
    return round(z.real, 6), round(z.imag, 6)
