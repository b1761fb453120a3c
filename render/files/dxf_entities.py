"""Single marks as the DXF entities of a draughtsman: lines, arcs, solids, hatches and texts."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Mapping, Sequence
from dataclasses import replace
from itertools import cycle, pairwise
from typing import TYPE_CHECKING, Literal

import shapely
from shapely.ops import substring

from render.files.writer import Lines, Writer, fitted_dashes
from render.paper.ink import arc_dashes, is_circle
from render.paper.lettering import PEN_WIDTH_RATIO
from render.paper.marks import Arc, Face, Text
from render.paper.style import INDEX_HEIGHT_RATIO, dxf_line_weight, pen_of_style
from render.paper.typeset import Indexed, LaidText, Run, bases_with_indices, lay_out_text, plain_text

if TYPE_CHECKING:
    from ezdxf.entities import Hatch
    from ezdxf.layouts import BaseLayout

# colours of the AutoCAD index; 7 is black on white paper, 251 is as dark as construction lines
BLACK_INDEX = 7
GREY_INDEX = 251
MOST_SLIM_RATIO = 0.4  # width over height of a character that would be distorted in a font if fitted to its ink
NARROWED_WIDTH_FACTOR = 0.85  # width factor of letters that are not fitted: other fonts are wider than our lettering
OBLIQUE_DEG = 15.0  # from upright: lettering at 75°
# LibreCAD takes the name of a style for its font, and has this one of ГОСТ 2.304
LETTERING_STYLE_NAME = "lc_opengost-br"
LINE_TYPE_OF_STYLE = {
    "axis": "DASHDOT2",
    "phantom": "DIVIDE2",
    "dash": "DASHED2",
}  # LibreCAD knows line types by their names
ARROW_BLOCK = "ARROW"
LETTERS_BLOCK = "LETTERS"
PATH_BLOCK = "PATH"
LENGTH_TOLERANCE_MM = 1e-6
LEAST_PROSE_LETTERS = 40  # letters in a text that is no label
Lettered = Literal["text", "pieces", "strokes"]
"""The form of a text: whole; with its indices as separate texts; or the lettering itself, drawn by lines."""
CHARACTERS_NOT_IN_FONT = frozenset("→←↔↑↓")  # characters missing in its font
_BASE_LINE_ATTACHMENTS = {
    "start": (7, 0.0),
    "middle": (8, 0.5),
    "end": (9, 1.0),
}  # attachment point of an MTEXT on its base line


def rounded_xy(z: complex) -> tuple[float, float]:
    """A place as two numbers for a file."""
    return round(z.real, 6), round(z.imag, 6)


def text_style_name(face: Face) -> str:
    """The text style of a face."""
    if not face.font:
        return LETTERING_STYLE_NAME
    name = "".join(c if c.isalnum() or c in " -_" else "_" for c in face.family)
    return f"{name} slanted" if face.slanted else name


def mtext_with_indices(text: str) -> str:
    """A text with the codes for raised and lowered indices in an MTEXT or a dimension."""

    def said(p: Indexed) -> str:
        base = re.sub(r"[\\{}]", r"\\\g<0>", p.base).replace("^", "^ ")
        upper, lower = (re.sub(r"[\\{};/#]", r"\\\g<0>", index) for index in (p.upper, p.lower))
        return base + (f"{{\\H{INDEX_HEIGHT_RATIO}x;\\S{upper}^ {lower};}}" if upper or lower else "")

    return "".join(map(said, bases_with_indices(text)))


class Entities(Writer):
    """Adds marks to a space or a block; ``layers`` are the line styles of the layers.

    Without ``layers`` (in a block) every mark states its own.  ``lettered``: the form of texts.
    """

    def __init__(self, space: BaseLayout, layers: Mapping[str, str] | None = None, lettered: Lettered = "text") -> None:
        self.space = space
        self.layers = layers or {}
        self.lettered = lettered
        self.written: dict[Text, str] = {}  # blocks of letters

    def mark_attributes(self, style: str, layer: str, dashes: Sequence[float] = ()) -> dict[str, object]:
        """The layer of a mark; its line type, scale and line weight (hundredths of a mm) where they differ from the
        layer's.

        ``dashes`` is the pattern fitted to the mark's length; a mark too short for it is solid.
        """
        used = pen_of_style(style)
        own = self.layers.get(layer)
        looks: dict[str, object] = {"layer": layer.upper()}
        solid = not dashes
        if own is None or solid != (not pen_of_style(own).pattern) or (not solid and own != style):
            looks["linetype"] = "Continuous" if solid else LINE_TYPE_OF_STYLE[style]
        if not solid:
            looks["ltscale"] = round(dashes[0] / used.pattern[0], 6)
        if own is None or dxf_line_weight(pen_of_style(own).width) != dxf_line_weight(used.width):
            looks["lineweight"] = dxf_line_weight(used.width)
        return looks

    def write_strokes(self, lines: Lines, style: str, layer: str, closed: bool = False) -> None:
        """Straight lines or polylines."""
        dashes = fitted_dashes(lines, style, closed)
        looks = self.mark_attributes(style, layer, dashes)
        for points in lines:
            if dashes and min(abs(b - a) for a, b in pairwise(points)) < dashes[0]:
                self._write_dashed_path(points, dashes, looks | {"linetype": "Continuous"})
            elif len(points) == 2:
                self.space.add_line(rounded_xy(points[0]), rounded_xy(points[1]), dxfattribs=looks)
            else:
                self.space.add_lwpolyline([rounded_xy(z) for z in points], close=closed, dxfattribs=looks)

    def _write_dashed_path(self, points: Sequence[complex], dashes: Sequence[float], looks: dict[str, object]) -> None:
        """A dashed path as a block of its dashes: LibreCAD restarts its line type at every corner, so that short sides
        become solid."""
        if self.layers:
            name, block = self._new_block(PATH_BLOCK)
            block._write_dashed_path(points, dashes, looks)
            self.space.add_blockref(name, (0, 0), dxfattribs={"layer": looks["layer"]})
            return
        path = shapely.LineString([(z.real, z.imag) for z in points])
        begins = 0.0
        for long, drawn in zip(cycle(dashes), cycle((True, False))):
            if begins >= path.length - LENGTH_TOLERANCE_MM:
                return
            if drawn:
                piece = substring(path, begins, min(begins + long, path.length))
                self.space.add_lwpolyline([rounded_xy(complex(x, y)) for x, y in piece.coords], dxfattribs=looks)
            begins += long

    def write_arc(self, arc: Arc) -> None:
        """A circle, an arc, or a filled disc."""
        looks = self.mark_attributes(arc.style, arc.layer, arc_dashes(arc))
        if is_circle(arc):
            self.space.add_circle(rounded_xy(arc.centre), arc.radius, dxfattribs=looks)
            if arc.fill == "ink":
                fill = self._add_fill(arc.layer, arc.centre)
                fill.paths.add_edge_path().add_arc(rounded_xy(arc.centre), arc.radius, 0, 360)
        else:
            self.space.add_arc(rounded_xy(arc.centre), arc.radius, arc.start_deg, arc.end_deg, dxfattribs=looks)

    def write_filled_polygon(self, points: Sequence[complex], colour: str, layer: str) -> None:
        """A filled polygon: a triangle is an arrowhead, which is a block; others are hatches."""
        if len(points) == 3:
            self._write_arrowhead(points, layer.upper())
            return
        fill = self._add_fill(layer, points[0])
        fill.paths.add_polyline_path([rounded_xy(z) for z in points], is_closed=True)

    def _add_fill(self, layer: str, seed: complex, **looks: int) -> Hatch:
        """A filled area. It ends with its seed: FreeCAD does not know seeds, and skips the next entity if one ends with
        a 0."""
        fill = self.space.add_hatch(color=BLACK_INDEX, dxfattribs={"layer": layer.upper(), **looks})
        fill.set_seed_points([rounded_xy(seed)])
        return fill

    def _write_arrowhead(self, points: Sequence[complex], layer: str) -> None:
        """An arrowhead: filled, and with an outline for programs without filled shapes."""
        tip, one, other = points
        back = (one + other) / 2
        name, share, looks = scaled_block(ARROW_BLOCK, abs(tip - back), abs(one - other))
        if name not in self.space.doc.blocks:
            block = self.space.doc.blocks.new(name)
            corners = [(0, 0), (-1, share / 2), (-1, -share / 2)]
            block.add_solid(corners, dxfattribs={"layer": "0"})
            block.add_lwpolyline(corners, close=True, dxfattribs={"layer": "0", "lineweight": 0})
        looks |= {"layer": layer, "rotation": math.degrees(cmath.phase(tip - back))}
        self.space.add_blockref(name, rounded_xy(tip), dxfattribs=looks)

    def draw_text(self, text: Text) -> None:
        """A text as a TEXT fitted between its ends, except 1, l and other narrow single letters; with indices as an
        MTEXT, or in fitted pieces if it is a line of prose, since the width of an MTEXT depends on its font; or the
        lettering itself, for characters that LibreCAD would not show."""
        laid = lay_out_text(text)
        if self.lettered == "strokes" or CHARACTERS_NOT_IN_FONT & set(text.text):
            self.write_lettering(text)
        elif len(laid.runs) > 1 and (self.lettered == "pieces" or len(plain_text(text.text)) > LEAST_PROSE_LETTERS):
            for run in laid.runs:
                self._write_plain_text(text, laid, run)
        elif len(laid.runs) > 1:
            foot, part = _BASE_LINE_ATTACHMENTS[text.anchor]
            held = laid.origin + cmath.rect(part * laid.width, math.radians(laid.turn_deg))
            looks = text_attributes(text, text.height, "char_height") | {"insert": rounded_xy(held), "width": 0}
            looks |= {"rotation": laid.turn_deg, "attachment_point": foot, "rect_width": round(laid.width, 6)}
            self.space.add_mtext(mtext_with_indices(text.text.strip()), dxfattribs=looks)
        elif laid.runs:
            self._write_plain_text(text, laid, laid.runs[0])

    def _write_plain_text(self, text: Text, laid: LaidText, run: Run) -> None:
        """A text without indices, or a part of one."""
        from ezdxf.enums import TextEntityAlignment as Align

        turn = cmath.rect(1, math.radians(laid.turn_deg))
        start = laid.origin + run.at * turn
        said = run.text.strip()
        entity = self.space.add_text(said, dxfattribs=text_attributes(text, run.height))
        if run.width > MOST_SLIM_RATIO * run.height * len(said) or text.narrow < 1:
            entity.set_placement(rounded_xy(start), rounded_xy(start + run.width * turn), Align.FIT)
            return
        entity.set_placement(rounded_xy(start), align=Align.LEFT)
        entity.dxf.rotation = laid.turn_deg
        entity.dxf.width = 1.0 if text.face.font else NARROWED_WIDTH_FACTOR

    def write_lettering(self, text: Text) -> None:
        """A text as the strokes of its letters, or their filled outlines if it is in a font: in a space one block,
        which moves as a whole and is a single object for programs that are slow with thousands."""
        if not self.layers:  # already in a block
            self._write_letters(text)
            return
        level = replace(text, place=0j, turn_deg=0.0, name="")
        if level not in self.written:
            self.written[level], block = self._new_block(LETTERS_BLOCK)
            block._write_letters(level)
        looks = {"layer": text.layer.upper(), "rotation": text.turn_deg}
        self.space.add_blockref(self.written[level], rounded_xy(text.place), dxfattribs=looks)

    def _new_block(self, kind: str) -> tuple[str, Entities]:
        """A new block with its name, to be drawn in."""
        blocks = self.space.doc.blocks
        name = f"{kind}_{len(blocks)}"
        return name, Entities(blocks.new(name))

    def _write_letters(self, text: Text) -> None:
        laid = lay_out_text(text)
        if laid.filled and laid.strokes:  # one hatch with holes
            fill = self._add_fill(text.layer, text.place, hatch_style=0)
            for line in laid.strokes:
                fill.paths.add_polyline_path([rounded_xy(z) for z in line[:-1]], is_closed=True)
            return
        for stroke, width in zip(laid.strokes, laid.pens, strict=True):
            looks = {"layer": text.layer.upper(), "linetype": "Continuous", "lineweight": dxf_line_weight(width)}
            self.space.add_lwpolyline([rounded_xy(z) for z in stroke], dxfattribs=looks)


def scaled_block(name: str, long: float, wide: float) -> tuple[str, float, dict[str, object]]:
    """The block of a sign of that size in mm, one for each ratio of width to length, and its scale, equal in both
    directions: some programs know no other."""
    share = round(wide / long, 3)
    return f"{name}_{1000 * share:.0f}", share, dict.fromkeys(("xscale", "yscale", "zscale"), round(long, 6))


def text_attributes(text: Text, height: float, called: str = "height") -> dict[str, object]:
    """Layer, style and height of a text, and the pen width for fonts that need one."""
    looks = {
        "layer": text.layer.upper(),
        "style": text_style_name(text.face),
        "lineweight": dxf_line_weight(PEN_WIDTH_RATIO * height),
    }
    if text.face.slanted and called == "height":  # others take it from their style
        looks["oblique"] = OBLIQUE_DEG
    return looks | {called: height}
