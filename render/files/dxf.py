"""Marks -> DXF by ezdxf: real millimetres, layers by meaning, ГОСТ line types and widths, text as text.

Lines are really cut under hinges and sliders, so no white mask is needed.  Hinges, supports, sliders, points and
arrowheads are blocks, and so is the form.  Its empty cells are attributes, to be filled in by the user; filled ones are
texts, since many programs show no attributes, with the attribute hidden beside them.  A text is fitted between the ends
of its lettering, so its width is as drawn in any font; one with indices is one MTEXT; with ``text="pieces"`` its
parts are such fitted texts, with "strokes" the lettering itself is drawn.  The layout is set up for printing at 1:1.
The same marks give the same bytes.
"""

from __future__ import annotations

import cmath
import io
import math
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from planes.drafting.pens import THIN_PEN_HEAD
from planes.words import Lang, say
from render.files.dxf_entities import (
    BLACK_INDEX,
    GREY_INDEX,
    LINE_TYPE_OF_STYLE,
    NARROWED_WIDTH_FACTOR,
    OBLIQUE_DEG,
    Entities,
    Lettered,
    rounded_xy,
    text_attributes,
    text_style_name,
)
from render.files.dxf_signs import DIMENSION_STYLE_NAME, insert_dimensions, insert_signs
from render.paper import form1, style
from render.paper.ink import require_finite_marks, visible_marks
from render.paper.iso7200 import FORMS_BY_NAME
from render.paper.marks import Face, Line, Mark, Size, Text
from render.paper.style import LAYERS_FROM_LOWEST, PEN_BY_STYLE, dxf_line_weight, pen_of_style
from render.paper.typeset import plain_text

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.entities import Insert
    from ezdxf.layouts import BlockLayout

HIDDEN_ATTRIBUTE_FLAG = 1  # flag of an attribute
LETTERING_FONT_FILE = "isocpeur.ttf"  # single-stroke, with Cyrillic letters, from AutoCAD; others substitute
STYLE_OF_LAYER = dict.fromkeys(map(str, LAYERS_FROM_LOWEST), "thin") | {
    "construction": "construction",
    "axis": "axis",
    "frame": "frame",
    "scheme": "thick",
    "force": "thick",
    "result": "result",
}
"""The line type and width of each layer; a mark has its own only where it differs."""


def write(marks: Iterable[Mark], size_mm: Size, title: str, *, lang: Lang = "ru", text: Lettered = "text") -> bytes:
    """The sheet as a DXF file (R2010) in millimetres, 1:1."""
    import ezdxf

    fixed = ezdxf.options.write_fixed_meta_data_for_testing
    ezdxf.options.write_fixed_meta_data_for_testing = True
    try:
        document = ezdxf.new("R2010", units=4)
        held = require_finite_marks(marks, size_mm)
        _define_styles(document, held, lang)
        document.header["$MEASUREMENT"] = document.header["$LWDISPLAY"] = 1
        document.modelspace().reset_extents((0, 0, 0), (*size_mm, 0))
        document.modelspace().reset_limits((0, 0), size_mm)
        document.header["$EXTMIN"] = (0, 0, 0)
        document.header["$EXTMAX"] = (*size_mm, 0)
        document.header["$TEXTSTYLE"] = text_style_name(Face())
        _print_setup(document, size_mm)
        document.set_modelspace_vport(1.1 * size_mm[1], (size_mm[0] / 2, size_mm[1] / 2))
        document.ezdxf_metadata()["TITLE"] = title
        _add_marks(document, held, size_mm, lang, text)
        for kind in sorted(document.entitydb.dxf_types_in_use()):
            document.classes.add_class(kind)  # by default the library writes them in the order of a set
        out = io.StringIO()
        document.write(out)
    finally:
        ezdxf.options.write_fixed_meta_data_for_testing = fixed
    return out.getvalue().encode()


def _add_marks(document: Drawing, marks: tuple[Mark, ...], size: Size, lang: Lang, text: Lettered) -> None:
    """The form as one block, recognised signs as blocks, the rest unchanged."""
    form = [m for m in marks if m.layer == "frame"]
    filled = any(isinstance(m, Text) for m in form)
    rest = insert_signs(document, visible_marks(m for m in marks if not (filled and m.layer == "frame")))
    rest = rest if text == "strokes" else insert_dimensions(document, rest)
    if filled:
        insert_form(document, form, size, lang, text)
    Entities(document.modelspace(), STYLE_OF_LAYER, text).write_marks(rest)


def _define_styles(document: Drawing, marks: Iterable[Mark], lang: Lang) -> None:
    """Line types, layers, and the styles of texts and dimensions."""
    from ezdxf.colors import int2rgb

    for name, used in PEN_BY_STYLE.items():
        if used.pattern:
            parts = [part if k % 2 == 0 else -part for k, part in enumerate(used.pattern)]
            document.linetypes.add(
                LINE_TYPE_OF_STYLE[name], [sum(used.pattern), *parts], description=say(f"line_{name}", lang)
            )
    for layer in LAYERS_FROM_LOWEST:
        used = pen_of_style(STYLE_OF_LAYER[layer])
        made = document.layers.add(
            layer.upper(),
            color=BLACK_INDEX if used.colour == style.BLACK_COLOUR else GREY_INDEX,
            linetype=LINE_TYPE_OF_STYLE[STYLE_OF_LAYER[layer]] if used.pattern else "Continuous",
            lineweight=dxf_line_weight(used.width),
        )
        if used.colour != style.BLACK_COLOUR:
            made.rgb = int2rgb(int(used.colour[1:], 16))
        made.description = say(f"layer_{layer}", lang)
    for face in dict.fromkeys([*(m.face for m in marks if isinstance(m, Text)), Face()]):
        if (name := text_style_name(face)) not in document.styles:
            set_in = document.styles.add(name, font=Path(face.font).name if face.font else LETTERING_FONT_FILE)
            set_in.dxf.oblique = OBLIQUE_DEG if face.slanted else 0.0
            set_in.dxf.width = 1.0 if face.font else NARROWED_WIDTH_FACTOR
            if face.font:
                set_in.set_extended_font_data(face.family)
    looks = {
        "dimtxsty": text_style_name(Face()),
        "dimtxt": 3.5,
        "dimasz": THIN_PEN_HEAD.long,
        "dimexo": 0.0,
        "dimexe": 1.0,
    }
    looks |= {"dimtad": 1, "dimdsep": ord(",")}  # written above the line
    document.dimstyles.new(DIMENSION_STYLE_NAME, dxfattribs=looks).copy_to_header(document)


def _print_setup(document: Drawing, size: Size) -> None:
    """The layout of the paper: its format, no margins, and the whole drawing in true size."""
    paper = document.paperspace("Layout1")
    paper.page_setup(size=size, margins=(0, 0, 0, 0), units="mm", scale=(1, 1))
    middle = (size[0] / 2, size[1] / 2)
    paper.add_viewport(middle, size, middle, size[1], dxfattribs={"layer": "VIEWPORT"})


def insert_form(document: Drawing, marks: Sequence[Mark], size: Size, lang: Lang, text: Lettered) -> None:
    """Frame, title block and side columns as one block, each cell an attribute; a filled cell is also a text.

    Cells lettered in strokes are not attributes.
    """
    form = next(
        (FORMS_BY_NAME[m.name] for m in marks if isinstance(m, Line) and m.name in FORMS_BY_NAME), form1.GOST_FORM
    )
    block = document.blocks.new(form.drawn_as)
    insert = document.modelspace().add_blockref(form.drawn_as, (0, 0), dxfattribs={"layer": "FRAME"})
    strokes = text == "strokes"
    entities = Entities(block, lettered=text)
    written = Entities(document.modelspace(), STYLE_OF_LAYER)
    filled: dict[str, list[Text]] = {}
    for mark in marks:
        if isinstance(mark, Text) and mark.name.startswith("cell ") and not strokes:
            filled.setdefault(mark.name.removeprefix("cell "), []).append(mark)
        else:
            entities.mark(mark)
    face = next(m.face for m in marks if isinstance(m, Text))
    for key, cell in ({} if strokes else form.cells(size)).items():
        for k, said in enumerate(filled.get(key) or [_empty_text(cell, f"cell {key}", face)]):
            tag = key.upper() + (f"_LINE_{k + 1}" if k else "")
            _add_attribute(block, insert, tag, form1.cell_prompt(key, lang), said)
            written.write_marks([said] if said.text else [])


def _empty_text(cell: form1.Cell, name: str, face: Face) -> Text:
    """An empty text at the place of a text."""
    turn = cmath.rect(1, math.radians(cell.turn_deg))
    wide = cell.height if cell.turn_deg % 180 else cell.width
    across = 0.0 if cell.anchor == "middle" else 1.0 - wide / 2
    place = cell.middle + (across - 0.5j * cell.letter) * turn
    return Text("", place, cell.letter, cell.anchor, cell.turn_deg, "frame", name, face)


def _add_attribute(block: BlockLayout, insert: Insert, tag: str, prompt: str, text: Text) -> None:
    """A cell's definition in the block and its value at the insert, at the same place."""
    from ezdxf.enums import TextEntityAlignment

    align = TextEntityAlignment.CENTER if text.anchor == "middle" else TextEntityAlignment.LEFT
    narrowed = {} if text.face.font else {"width": NARROWED_WIDTH_FACTOR}
    looks = text_attributes(text, text.height) | {"rotation": text.turn_deg} | narrowed
    define = block.add_attdef(tag, text="", dxfattribs={**looks, "prompt": prompt})
    value = insert.add_attrib(
        tag, plain_text(text.text), dxfattribs=looks | {"flags": HIDDEN_ATTRIBUTE_FLAG if text.text else 0}
    )
    for entity in (define, value):
        entity.set_placement(rounded_xy(text.place), align=align)
