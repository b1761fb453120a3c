"""Signs recognised among marks, inserted in a DXF as a draughtsman would: hinges, supports, sliders and points as
blocks, dimensions as dimensions."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from itertools import combinations, pairwise
from typing import TYPE_CHECKING

from planes.geometry.plane import direction_between
from planes.words.frozen import frozen
from render.files.dxf_entities import Entities, mtext_with_indices, rounded_xy, scaled_block
from render.paper import symbols
from render.paper.ink import is_circle
from render.paper.marks import Arc, Arrow, Line, Mark, Size, Text
from render.paper.style import DOT_RADIUS_MM, HINGE_LEG_LENGTH_MM, HINGE_RADIUS_MM

if TYPE_CHECKING:
    from ezdxf.document import Drawing
    from ezdxf.layouts import BlockLayout

_SAME_PLACE_MM = 1e-3
_MOST_SUPPORT_REACH_MM = 4 * HINGE_LEG_LENGTH_MM  # largest distance of a support's parts from its hinge
_MOST_TEXT_DISTANCE_MM = 3.0  # largest distance of a dimension's text from the point between its arrows

HINGE_BLOCK = "HINGE"
SUPPORT_BLOCK = "SUPPORT"
SLIDER_BLOCK = "SLIDER"
POINT_BLOCK = "POINT"


@frozen
class Sign:
    """The place of a block: its name, base point and rotation, the length and width of a slider, and the marks it
    replaces."""

    name: str
    at: complex
    turn_deg: float
    size: Size
    layer: str
    marks: tuple[Mark, ...]


def insert_signs(document: Drawing, marks: Sequence[Mark]) -> list[Mark]:
    """Insert the signs recognised among the marks as blocks; returns the remaining marks."""
    space = document.modelspace()
    gone = set()
    for sign in recognise_signs(marks):
        name, share, scales = (
            scaled_block(SLIDER_BLOCK, *sign.size) if sign.name == SLIDER_BLOCK else (sign.name, 1.0, {})
        )
        if name not in document.blocks:
            _draw_sign_block(document.blocks.new(name), sign.name, share)
        looks = {"layer": sign.layer.upper(), "rotation": sign.turn_deg, **scales}
        space.add_blockref(name, rounded_xy(sign.at), dxfattribs=looks)
        gone |= {id(mark) for mark in sign.marks}
    return [mark for mark in marks if id(mark) not in gone]


def _draw_sign_block(block: BlockLayout, name: str, share: float) -> None:
    """The marks of a sign about its base point; ``share`` is a slider's width over its length."""
    own = {
        HINGE_BLOCK: (Arc(0j, HINGE_RADIUS_MM),),
        SUPPORT_BLOCK: symbols.fixed_hinge(0j),
        POINT_BLOCK: symbols.dot(0j),
        SLIDER_BLOCK: symbols.block(0j, 0.0, (1.0, share))[1:],
    }
    Entities(block).write_marks(own[name])
    for entity in block:
        if entity.dxf.layer == "SCHEME":
            entity.dxf.layer = "0"  # on the layer of its insert


def recognise_signs(marks: Sequence[Mark]) -> Iterator[Sign]:
    """The signs whose marks are complete and uncut."""
    lines = [m for m in marks if isinstance(m, Line) and m.layer in ("scheme", "hatch")]
    for mark in marks:
        if isinstance(mark, Line):
            yield from _recognise_slider(mark)
        elif isinstance(mark, Arc) and is_circle(mark) and mark.layer == "scheme":
            if mark.fill == "ink" and abs(mark.radius - DOT_RADIUS_MM) < _SAME_PLACE_MM and mark.style == "thin":
                yield Sign(POINT_BLOCK, mark.centre, 0.0, (1.0, 1.0), mark.layer, (mark,))
            elif mark.fill == "none" and abs(mark.radius - HINGE_RADIUS_MM) < _SAME_PLACE_MM and mark.style == "thick":
                yield _recognise_support(mark, lines) or Sign(
                    HINGE_BLOCK, mark.centre, 0.0, (1.0, 1.0), mark.layer, (mark,)
                )


def _recognise_slider(line: Line) -> Iterator[Sign]:
    """A closed rectangle of the scheme."""
    if not line.closed or len(line.points) != 4 or line.layer != "scheme" or line.style != "thick":
        return
    sides = [b - a for a, b in pairwise((*line.points, line.points[0]))]
    if abs(sides[0] + sides[2]) > _SAME_PLACE_MM or abs((sides[0] * sides[1].conjugate()).real) > _SAME_PLACE_MM:
        return
    turn = math.degrees(cmath.phase(sides[0]))
    yield Sign(SLIDER_BLOCK, sum(line.points) / 4, turn, (abs(sides[0]), abs(sides[1])), line.layer, (line,))


def _recognise_support(hinge: Arc, lines: Iterable[Line]) -> Sign | None:
    """The support of this hinge, if all of its strokes are there."""
    near = [m for m in lines if len(m.points) == 2 and abs(m.points[0] - hinge.centre) < _MOST_SUPPORT_REACH_MM]
    legs = [
        m for m in near if abs(abs(m.points[0] - hinge.centre) - hinge.radius) < _SAME_PLACE_MM and m.style == "thick"
    ]
    for one, two in combinations(legs, 2):
        down = one.points[1] + two.points[1] - 2 * hinge.centre
        if abs(abs(down) - 2 * HINGE_LEG_LENGTH_MM) > _SAME_PLACE_MM:
            continue
        angle = math.degrees(cmath.phase(1j * down))
        wanted = [m for m in symbols.fixed_hinge(hinge.centre, angle) if isinstance(m, Line)]
        present = [next((m for m in near if _is_same_line(m, w)), None) for w in wanted]
        if None not in present:
            strokes = tuple(m for m in present if m)
            return Sign(SUPPORT_BLOCK, hinge.centre, angle, (1.0, 1.0), hinge.layer, (hinge, *strokes))
    return None


def _is_same_line(one: Line, other: Line) -> bool:
    places = zip(one.points, other.points, strict=True)
    return (one.style, one.layer) == (other.style, other.layer) and all(abs(a - b) < _SAME_PLACE_MM for a, b in places)


# dimensions

DIMENSION_STYLE_NAME = "GOST"  # the style of dimensions
# measured along its line, with its picture in a separate block, and its text in place
_LINEAR_DIMENSION_FLAGS = 32 + 128


def insert_dimensions(document: Drawing, marks: Sequence[Mark]) -> list[Mark]:
    """Insert every size written between two arrows of the layer "dimension" that start from one place, drawn in
    succession, as a DIMENSION that looks as drawn; returns the remaining marks.

    Its text is the one with its middle beside that place; lines of that layer across a tip are its extension lines.
    """
    arrows = [m for m in marks if isinstance(m, Arrow) and m.layer == "dimension"]
    texts = [m for m in marks if isinstance(m, Text) and m.anchor == "middle"]
    gone = set[int]()
    lines = [m for m in marks if isinstance(m, Line) and m.layer == "dimension" and len(m.points) == 2]
    for one, other in pairwise(arrows):
        if not _arrows_point_apart(one, other) or gone & {id(one), id(other)}:
            continue
        said = [m for m in texts if abs(m.place - one.start) < _MOST_TEXT_DISTANCE_MM and id(m) not in gone]
        said = sorted(said, key=lambda m: abs(m.place - one.start))[:1]
        across = [next((m for m in lines if _is_extension_line(m, arrow)), None) for arrow in (one, other)]
        _insert_dimension(document, (one, other), across, said)
        gone |= {id(m) for m in (one, other, *across, *said)}
    return [mark for mark in marks if id(mark) not in gone]


def _arrows_point_apart(one: Arrow, other: Arrow) -> bool:
    """Whether two arrows point in opposite directions from one place."""
    a = one.end - one.start
    b = other.end - other.start
    turned = b * a.conjugate()
    return (
        abs(one.start - other.start) < _SAME_PLACE_MM and turned.real < 0 and abs(turned.imag) < _SAME_PLACE_MM * abs(a)
    )


def _is_extension_line(line: Line, arrow: Arrow) -> bool:
    """Whether a line is perpendicular to an arrow and passes its tip."""
    along = direction_between(arrow.start, arrow.end)
    a, b = ((z - arrow.end) / along for z in line.points)
    return abs(a.real) < _SAME_PLACE_MM and abs(b.real) < _SAME_PLACE_MM and a.imag * b.imag < 0


def _insert_dimension(
    document: Drawing, arrows: tuple[Arrow, Arrow], across: Sequence[Line | None], said: Sequence[Text]
) -> None:
    """The entity, and the block with its picture."""
    picture = document.blocks.new_anonymous_block(type_char="D")
    Entities(picture).write_marks([*arrows, *filter(None, across), *said])
    tips = [arrow.end for arrow in arrows]
    one, other = (
        max(line.points, key=lambda z: abs(z - tip)) if line else tip for tip, line in zip(tips, across, strict=True)
    )
    middle = next((m.place + 0.5j * m.height * symbols.unit_vector(m.turn_deg) for m in said), arrows[0].start)
    places = {"defpoint": tips[1], "defpoint2": one, "defpoint3": other, "text_midpoint": middle}
    looks = {
        "layer": "DIMENSION",
        "dimstyle": DIMENSION_STYLE_NAME,
        "dimtype": _LINEAR_DIMENSION_FLAGS,
        "geometry": picture.name,
    }
    texts = {
        "text": "".join(mtext_with_indices(m.text) for m in said) or " ",
        "actual_measurement": abs(tips[0] - tips[1]),
    }
    looks["angle"] = math.degrees(cmath.phase(tips[1] - tips[0]))
    document.modelspace().new_entity(
        "DIMENSION", {**looks, **texts, **{key: rounded_xy(z) for key, z in places.items()}}
    )
