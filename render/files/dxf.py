"""Marks -> DXF by ezdxf: real millimetres, layers by meaning, ГОСТ line types and widths, text as text.

Lines are really cut under hinges and sliders, so nothing needs a white mask.  Hinges, supports, sliders and points
are blocks, and so is the form with its cells as attributes, to be filled in the reader's program.  Every run of text
is fitted between the ends of its own lettering, so it is as wide as drawn in whatever font that program puts;
``text="strokes"`` draws the lettering itself instead.  The same marks give the same bytes.
"""

from __future__ import annotations

import cmath
import io
import math
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from itertools import combinations, pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from planes.words import Lang, say
from render.files.dxf_entities import GREY, NARROWED, OBLIQUE_DEG, Entities, style_name, text_looks, xy
from render.paper import form1, symbols
from render.paper.ink import checked, is_circle, uncovered
from render.paper.marks import Arc, Face, Line, Mark, Text
from render.paper.style import DOT_MM, HINGE_MM, LAYERS, LEG_MM, PENS, pen, weight
from render.paper.typeset import plain

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.entities import Insert
    from ezdxf.layouts import BlockLayout

OWN_FONT = "isocpeur.ttf"  # a single-stroke font with Cyrillic letters that AutoCAD brings; others put a like one
Lettered = Literal["text", "strokes"]
LAYER_STYLES = dict.fromkeys(map(str, LAYERS), "thin") | {
    "construction": "construction",
    "axis": "axis",
    "frame": "frame",
    "scheme": "thick",
    "force": "thick",
    "result": "result",
}
"""The line type and width of each layer; a mark says its own only where it differs."""


def write(
    marks: Iterable[Mark], size_mm: tuple[float, float], title: str, *, lang: Lang = "ru", text: Lettered = "text"
) -> bytes:
    """The sheet as a DXF file (R2010) in millimetres, 1:1."""
    import ezdxf

    fixed = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        document = ezdxf.new("R2010", units=4)
        held = checked(marks, size_mm)
        _tables(document, held, lang)
        document.header["$MEASUREMENT"] = document.header["$LWDISPLAY"] = 1
        document.modelspace().reset_extents((0, 0, 0), (*size_mm, 0))
        document.modelspace().reset_limits((0, 0), size_mm)
        document.header["$EXTMIN"], document.header["$EXTMAX"] = (0, 0, 0), (*size_mm, 0)
        document.header["$TEXTSTYLE"] = style_name(Face())
        document.set_modelspace_vport(1.1 * size_mm[1], (size_mm[0] / 2, size_mm[1] / 2))
        document.ezdxf_metadata()["TITLE"] = title
        _fill(document, held, size_mm, lang, text == "strokes")
        for kind in sorted(document.entitydb.dxf_types_in_use()):
            document.classes.add_class(kind)  # left to itself the library takes them as they fall out of a set
        out = io.StringIO()
        document.write(out)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = fixed
    return out.getvalue().encode()


def _fill(document: Drawing, marks: tuple[Mark, ...], size: tuple[float, float], lang: Lang, strokes: bool) -> None:
    """The form as one block, known signs as blocks, the rest as they are."""
    form = [m for m in marks if m.layer == "frame"]
    filled = any(isinstance(m, Text) for m in form)
    rest = insert_signs(document, uncovered(m for m in marks if not (filled and m.layer == "frame")))
    if filled:
        insert_form(document, form, size, lang, strokes)
    Entities(document.modelspace(), LAYER_STYLES, strokes).all(rest)


def _tables(document: Drawing, marks: Iterable[Mark], lang: Lang) -> None:
    """Line types, layers and the styles of the texts."""
    for name, used in PENS.items():
        if used.pattern:
            parts = [part if k % 2 == 0 else -part for k, part in enumerate(used.pattern)]
            document.linetypes.add(name.upper(), [sum(used.pattern), *parts], description=say(f"line_{name}", lang))
    for layer in LAYERS:
        used, name = pen(LAYER_STYLES[layer]), LAYER_STYLES[layer].upper()
        made = document.layers.add(
            layer.upper(),
            color=GREY if layer == "construction" else 7,
            linetype=name if used.pattern else "Continuous",
            lineweight=weight(used.width),
        )
        made.description = say(f"layer_{layer}", lang)
    for face in dict.fromkeys([Face(), *(m.face for m in marks if isinstance(m, Text))]):
        if (name := style_name(face)) not in document.styles:
            style = document.styles.add(name, font=Path(face.font).name if face.font else OWN_FONT)
            style.dxf.oblique = OBLIQUE_DEG if face.slanted else 0.0
            if face.font:
                style.set_extended_font_data(face.family)


# hinges, supports, sliders and points found among the marks

_SAME_MM = 1e-3
_REACH_MM = 4 * LEG_MM  # no part of a support is farther from its hinge

HINGE, SUPPORT, SLIDER, POINT, FORM = "HINGE", "SUPPORT", "SLIDER", "POINT", "FORM_1"


@dataclass(frozen=True)
class Sign:
    """A block's place: its name, base point, turn and scales along its own axes, and the marks it stands for."""

    name: str
    at: complex
    turn_deg: float
    scale: tuple[float, float]
    layer: str
    marks: tuple[Mark, ...]


def insert_signs(document: Drawing, marks: Sequence[Mark]) -> list[Mark]:
    """Insert the signs found among the marks as blocks; what is left of the marks."""
    space, gone = document.modelspace(), set[int]()
    for sign in signs(marks):
        if sign.name not in document.blocks:
            _define(document.blocks.new(sign.name), sign.name)
        looks = {"layer": sign.layer.upper(), "rotation": sign.turn_deg}
        looks |= {"xscale": sign.scale[0], "yscale": sign.scale[1]}
        space.add_blockref(sign.name, xy(sign.at), dxfattribs=looks)
        gone |= {id(mark) for mark in sign.marks}
    return [mark for mark in marks if id(mark) not in gone]


def _define(block: BlockLayout, name: str) -> None:
    """The marks of a sign about its own base point."""
    corner = 0.5 + 0.5j
    square = Line(tuple(corner * 1j**k for k in range(4)), closed=True)
    own: dict[str, Sequence[Mark]] = {
        HINGE: (Arc(0j, HINGE_MM),),
        SUPPORT: symbols.fixed_hinge(0j),
        SLIDER: (square,),
        POINT: symbols.dot(0j),
    }
    Entities(block).all(own[name])
    for entity in block:
        if entity.dxf.layer == "SCHEME":
            entity.dxf.layer = "0"  # it lies on the layer of its insert


def signs(marks: Sequence[Mark]) -> Iterator[Sign]:
    """The signs whose marks are all there, uncut."""
    lines = [m for m in marks if isinstance(m, Line) and m.layer in ("scheme", "hatch")]
    for mark in marks:
        if isinstance(mark, Line):
            yield from _slider(mark)
        elif isinstance(mark, Arc) and is_circle(mark) and mark.layer == "scheme":
            if mark.fill == "ink" and abs(mark.radius - DOT_MM) < _SAME_MM and mark.style == "thin":
                yield Sign(POINT, mark.centre, 0.0, (1.0, 1.0), mark.layer, (mark,))
            elif mark.fill == "none" and abs(mark.radius - HINGE_MM) < _SAME_MM and mark.style == "thick":
                yield _support(mark, lines) or Sign(HINGE, mark.centre, 0.0, (1.0, 1.0), mark.layer, (mark,))


def _slider(line: Line) -> Iterator[Sign]:
    """A closed rectangle of the scheme."""
    if not line.closed or len(line.points) != 4 or line.layer != "scheme" or line.style != "thick":
        return
    sides = [b - a for a, b in pairwise((*line.points, line.points[0]))]
    if abs(sides[0] + sides[2]) > _SAME_MM or abs((sides[0] * sides[1].conjugate()).real) > _SAME_MM:
        return
    turn = math.degrees(cmath.phase(sides[0]))
    yield Sign(SLIDER, sum(line.points) / 4, turn, (abs(sides[0]), abs(sides[1])), line.layer, (line,))


def _support(hinge: Arc, lines: Iterable[Line]) -> Sign | None:
    """The support whose hinge this is, if every stroke of one is there."""
    near = [m for m in lines if len(m.points) == 2 and abs(m.points[0] - hinge.centre) < _REACH_MM]
    legs = [m for m in near if abs(abs(m.points[0] - hinge.centre) - hinge.radius) < _SAME_MM and m.style == "thick"]
    for one, two in combinations(legs, 2):
        down = one.points[1] + two.points[1] - 2 * hinge.centre
        if abs(abs(down) - 2 * LEG_MM) > _SAME_MM:
            continue
        angle = math.degrees(cmath.phase(1j * down))
        wanted = [m for m in symbols.fixed_hinge(hinge.centre, angle) if isinstance(m, Line)]
        found = [next((m for m in near if _alike(m, w)), None) for w in wanted]
        if None not in found:
            strokes: tuple[Mark, ...] = tuple(m for m in found if m)
            return Sign(SUPPORT, hinge.centre, angle, (1.0, 1.0), hinge.layer, (hinge, *strokes))
    return None


def _alike(one: Line, other: Line) -> bool:
    places = zip(one.points, other.points, strict=True)
    return (one.style, one.layer) == (other.style, other.layer) and all(abs(a - b) < _SAME_MM for a, b in places)


def insert_form(document: Drawing, marks: Sequence[Mark], size: tuple[float, float], lang: Lang, strokes: bool) -> None:
    """Frame, title block and side columns as one block, each cell an attribute to be edited, the empty ones too.

    Cells lettered in strokes are no attributes.
    """
    block = document.blocks.new(FORM)
    insert = document.modelspace().add_blockref(FORM, (0, 0), dxfattribs={"layer": "FRAME"})
    entities = Entities(block, lettered=strokes)
    filled: dict[str, list[Text]] = {}
    for mark in marks:
        if isinstance(mark, Text) and mark.name.startswith("cell ") and not strokes:
            filled.setdefault(mark.name.removeprefix("cell "), []).append(mark)
        else:
            entities.mark(mark)
    face = next(m.face for m in marks if isinstance(m, Text))
    for key, cell in ({} if strokes else form1.cells(size)).items():
        for k, text in enumerate(filled.get(key) or [_empty(cell, f"cell {key}", face)]):
            tag = key.upper() + (f"_LINE_{k + 1}" if k else "")
            _attribute(block, insert, tag, form1.prompt(key, lang), text)


def _empty(cell: form1.Cell, name: str, face: Face) -> Text:
    """A text with nothing in it, where one would stand."""
    turn = cmath.rect(1, math.radians(cell.turn_deg))
    wide = cell.height if cell.turn_deg % 180 else cell.width
    across = 0.0 if cell.anchor == "middle" else 1.0 - wide / 2
    place = complex(cell.x + cell.width / 2, cell.y + cell.height / 2) + (across - 0.5j * cell.letter) * turn
    return Text("", place, cell.letter, cell.anchor, cell.turn_deg, "frame", name, face)


def _attribute(block: BlockLayout, insert: Insert, tag: str, prompt: str, text: Text) -> None:
    """A cell's definition in the block and its value at the insert, about the same place."""
    from ezdxf.enums import TextEntityAlignment

    align = TextEntityAlignment.CENTER if text.anchor == "middle" else TextEntityAlignment.LEFT
    narrowed = {} if text.face.font else {"width": NARROWED}
    looks = text_looks(text, text.height) | {"rotation": text.turn_deg} | narrowed
    define = block.add_attdef(tag, text="", dxfattribs={**looks, "prompt": prompt})
    value = insert.add_attrib(tag, plain(text.text), dxfattribs=looks)
    for entity in (define, value):
        entity.set_placement(xy(text.place), align=align)
