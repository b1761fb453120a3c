"""Marks -> DXF by ezdxf: real millimetres, layers by meaning, ГОСТ line types and widths, text as text.

Lines are really cut under hinges and sliders, so nothing needs a white mask.  Hinges, supports, sliders and points
are blocks, and so is the form with its cells as attributes, to be filled in the reader's program.  Every run of text
is fitted between the ends of its own lettering, so it is as wide as drawn in whatever font that program puts;
``text="strokes"`` draws the lettering itself instead.  The same marks give the same bytes.
"""

from __future__ import annotations

import io
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from planes.words import Lang, say
from render.files.dxf_blocks import insert_form, insert_signs
from render.files.dxf_entities import GREY, OBLIQUE_DEG, Entities, style_name
from render.paper.ink import checked, uncovered
from render.paper.marks import Face, Mark, Text
from render.paper.style import LAYERS, PENS, pen, weight

if TYPE_CHECKING:
    from ezdxf.document import Drawing

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
