"""Single marks as the DXF entities a draughtsman would use: lines, arcs, solids, hatches and texts."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

from render.files.writer import Lines, Writer, dashes_of
from render.paper.ink import arc_dashes, is_circle
from render.paper.marks import Arc, Face, Text
from render.paper.style import pen, weight
from render.paper.typeset import layout

if TYPE_CHECKING:
    from ezdxf.layouts import BaseLayout

BLACK, GREY = 7, 8  # colours of the AutoCAD index; 7 is black on white paper
SLIM = 0.4  # width over height of a character whose own font would be distorted, were it fitted to its ink
NARROWED = 0.85  # of letters that are not fitted: other fonts are wider than our lettering
OBLIQUE_DEG = 15.0  # from upright: lettering at 75°


def xy(z: complex) -> tuple[float, float]:
    """A place as the two numbers of a file."""
    return round(z.real, 6), round(z.imag, 6)


def style_name(face: Face) -> str:
    """The text style of a face."""
    name = "".join(c if c.isalnum() or c in " -_" else "_" for c in face.family) if face.font else "GOST"
    return f"{name} slanted" if face.slanted else name


class Entities(Writer):
    """Adds marks to a space or a block; ``layers`` names the line style each layer has of itself.

    With no ``layers`` (in a block) every mark says its own.  ``lettered``: letters drawn as lines.
    """

    def __init__(self, space: BaseLayout, layers: Mapping[str, str] | None = None, lettered: bool = False) -> None:
        self.space, self.layers, self.drawn_letters = space, layers or {}, lettered

    def looks(self, style: str, layer: str, dashes: Sequence[float] = ()) -> dict[str, object]:
        """Layer of a mark; line type, its stretch and line weight (hundredths of a mm) where they are not its layer's.

        ``dashes`` is the pattern fitted to the mark's length; a mark too short for it is solid.
        """
        used, own = pen(style), self.layers.get(layer)
        found: dict[str, object] = {"layer": layer.upper()}
        solid = not dashes
        if own is None or solid != (not pen(own).pattern) or (not solid and own != style):
            found["linetype"] = "Continuous" if solid else style.upper()
        if not solid:
            found["ltscale"] = round(dashes[0] / used.pattern[0], 6)
        if own is None or weight(pen(own).width) != weight(used.width):
            found["lineweight"] = weight(used.width)
        return found

    def strokes(self, lines: Lines, style: str, layer: str, closed: bool = False) -> None:
        """Straight lines or polylines."""
        looks = self.looks(style, layer, dashes_of(lines, style, closed))
        for points in lines:
            if len(points) == 2:
                self.space.add_line(xy(points[0]), xy(points[1]), dxfattribs=looks)
            else:
                self.space.add_lwpolyline([xy(z) for z in points], close=closed, dxfattribs=looks)

    def arc(self, arc: Arc) -> None:
        """A circle, an arc, or a filled disc."""
        looks = self.looks(arc.style, arc.layer, arc_dashes(arc))
        if is_circle(arc):
            self.space.add_circle(xy(arc.centre), arc.radius, dxfattribs=looks)
            if arc.fill == "ink":
                fill = self.space.add_hatch(color=BLACK, dxfattribs={"layer": arc.layer.upper()})
                fill.paths.add_edge_path().add_arc(xy(arc.centre), arc.radius, 0, 360)
        else:
            self.space.add_arc(xy(arc.centre), arc.radius, arc.start_deg, arc.end_deg, dxfattribs=looks)

    def filled(self, points: Sequence[complex], colour: str, layer: str) -> None:
        """A filled polygon: of three corners a solid, else a hatch."""
        if len(points) == 3:
            self.space.add_solid([xy(z) for z in points], dxfattribs={"layer": layer.upper()})
            return
        fill = self.space.add_hatch(color=BLACK, dxfattribs={"layer": layer.upper()})
        fill.paths.add_polyline_path([xy(z) for z in points], is_closed=True)

    def text(self, text: Text) -> None:
        """Every run of a text as a TEXT fitted between its ends, but for 1, l and other slim letters by themselves; or
        the lettering itself."""
        if self.drawn_letters:
            self.lettering(text)
            return
        from ezdxf.enums import TextEntityAlignment as Align

        laid = layout(text)
        turn = cmath.rect(1, math.radians(laid.turn_deg))
        for run in laid.runs:
            start, said = laid.origin + run.at * turn, run.text.strip()
            entity = self.space.add_text(said, dxfattribs=text_looks(text, run.height))
            if run.width > SLIM * run.height * len(said):
                entity.set_placement(xy(start), xy(start + run.width * turn), Align.FIT)
                continue
            entity.set_placement(xy(start), align=Align.LEFT)
            entity.dxf.rotation = laid.turn_deg
            entity.dxf.width = 1.0 if text.face.font else NARROWED

    def lettering(self, text: Text) -> None:
        """A text as the strokes of its letters, or their filled outlines where it is in a font."""
        laid = layout(text)
        if laid.filled and laid.strokes:  # one hatch with holes
            fill = self.space.add_hatch(color=BLACK, dxfattribs={"layer": text.layer.upper(), "hatch_style": 0})
            for line in laid.strokes:
                fill.paths.add_polyline_path([xy(z) for z in line[:-1]], is_closed=True)
            return
        for stroke, width in zip(laid.strokes, laid.pens, strict=True):
            looks = {"layer": text.layer.upper(), "linetype": "Continuous", "lineweight": weight(width)}
            self.space.add_lwpolyline([xy(z) for z in stroke], dxfattribs=looks)


def text_looks(text: Text, height: float) -> dict[str, object]:
    """Layer, style, height and slant of a text."""
    found: dict[str, object] = {"layer": text.layer.upper(), "style": style_name(text.face), "height": height}
    return found | ({"oblique": OBLIQUE_DEG} if text.face.slanted else {})
