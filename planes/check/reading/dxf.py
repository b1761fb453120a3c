"""Strokes and words of a DXF file: lines, polylines, nested blocks, arrowheads, texts; no dimensions."""

import cmath
import io
import math
from collections.abc import Iterable, Iterator
from itertools import count
from pathlib import Path
from typing import Any

from planes.check.reading.arrowheads import arrowhead_from_figure, assign_arrowheads, split_off_tapered_heads
from planes.check.reading.opened import MB, read_bounded_bytes, too_many_error
from planes.check.reading.parts import merge_word_pieces, remove_letter_strokes, text_width_in_heights
from planes.check.reading.strokes import LARGEST_POINT_RADIUS_MM, Arrowhead, ReadDrawing
from planes.check.reading.written import Words
from planes.geometry.plane import direction_between
from planes.words.errors import reporting_library_errors

_MM_PER_UNIT = {0: 1.0, 1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0, 8: 25.4e-6, 13: 1e-3, 14: 100.0}
LARGEST_DXF_BYTES = 12 * MB
MOST_ENTITIES = 60_000  # entities, including blocks
MOST_BLOCK_DEPTH = 30  # nesting depth of blocks
FILLING_TYPES = ("SOLID", "TRACE", "HATCH")
# height of a text's place on it, by its alignment: at its foot, its foot, its middle, its top, its middle
UP = 0.0, 0.0, 0.5, 1.0, 0.5
DIMENSION_TYPES = ("DIMENSION", "ARC_DIMENSION", "LARGE_RADIAL_DIMENSION", "TOLERANCE", "VIEWPORT")  # no vectors


def read_dxf(path: str | Path) -> ReadDrawing:
    """The strokes of a file's model space in mm, or of its sheets if that is empty.

    :class:`PlanesError` if it is not a DXF.
    """
    from ezdxf import recover

    data = read_bounded_bytes(path, LARGEST_DXF_BYTES)
    with reporting_library_errors("check_dxf", path):
        document, _ = recover.read(io.BytesIO(data))
        scale = _MM_PER_UNIT.get(int(document.header.get("$INSUNITS", 0)), 1.0)
        for space in (document.modelspace(), *(s for s in document.layouts if s.name != "Model")):
            drawing = _read_space(document, space, scale, str(path))
            if drawing.strokes:
                break
    return drawing


def _read_space(document: Any, space: Any, scale: float, file: str) -> ReadDrawing:
    drawing = ReadDrawing(file)
    for entity in _visible_entities(document, space, file):
        try:
            _add_entity(drawing, entity, scale)
        except (ValueError, AttributeError, TypeError, IndexError, ZeroDivisionError):
            continue
    drawing.words = merge_word_pieces(drawing.words)
    remove_letter_strokes(drawing)
    assign_arrowheads(drawing)
    return drawing


def _visible_entities(document: Any, space: Any, file: str) -> Iterator[Any]:
    """The visible entities, with blocks expanded; all are counted, visible or not."""
    unseen, passed = {x.dxf.name.casefold() for x in document.layers if x.is_off() or x.is_frozen()}, count(1)

    def counted(entities: Iterable[Any]) -> Iterator[Any]:
        for entity in entities:
            if next(passed) > MOST_ENTITIES:
                raise too_many_error(file, "elements", MOST_ENTITIES)
            yield entity

    def held(entities: Iterable[Any], depth: int) -> Iterator[Any]:
        for entity in counted(entities):
            kind = entity.dxftype()
            layer = entity.dxf.get("layer", "0").casefold()
            if kind in DIMENSION_TYPES or layer in unseen or entity.dxf.get("invisible", 0):
                continue
            if kind != "INSERT":
                yield entity
            elif depth < MOST_BLOCK_DEPTH:
                for one in counted(entity.multi_insert() if entity.mcount > 1 else (entity,)):
                    parts = one.virtual_entities()
                    drawn_once = _is_filled_figure(entity.block())
                    yield from held((p for p in parts if not drawn_once or p.dxftype() not in FILLING_TYPES), depth + 1)
                    yield from (a for a in one.attribs if not a.is_invisible)

    return held(space, 0)


def _is_filled_figure(block: Any) -> bool:
    """Whether a block is one figure and its filling: a head, to be counted once."""
    kinds = [e.dxftype() for e in block] if block is not None and len(block) == 2 else []
    return sum(kind in FILLING_TYPES for kind in kinds) == 1


def _add_entity(drawing: ReadDrawing, entity: Any, scale: float) -> None:
    """One entity, if it is straight, a head or a text."""
    match entity.dxftype():
        case "LINE":
            drawing.add_polyline([_scaled_point(entity.dxf.start, scale), _scaled_point(entity.dxf.end, scale)])
        case "CIRCLE" if entity.dxf.radius * scale <= LARGEST_POINT_RADIUS_MM:
            drawing.rounds.append(
                (_scaled_point(entity.ocs().to_wcs(entity.dxf.center), scale), entity.dxf.radius * scale)
            )
        case "LWPOLYLINE" | "POLYLINE":
            _add_polyline(drawing, entity, scale)
        case "LEADER":
            tip, *before = places = [_scaled_point(v, scale) for v in entity.vertices]
            drawing.add_polyline(places)
            if entity.dxf.get("has_arrowhead", 1) and before and tip != before[0]:
                drawing.heads.append(Arrowhead(tip, direction_between(before[0], tip)))
        case "SOLID" | "TRACE":
            drawing.heads += filter(
                None, [arrowhead_from_figure([_scaled_point(p, scale) for p in entity.wcs_vertices()])]
            )
        case "HATCH":
            from ezdxf.path import from_hatch

            straight = (path.control_vertices() for path in from_hatch(entity) if not path.has_curves)
            drawing.heads += filter(
                None, (arrowhead_from_figure([_scaled_point(p, scale) for p in corners]) for corners in straight)
            )
        case "TEXT" | "ATTRIB" | "MTEXT":
            _add_text(drawing, entity, scale)


def _mtext_words(text: str) -> str:
    """The words of an MTEXT; of two indices the lower one first, as names are written."""
    from ezdxf.tools.text import MTextParser, TokenType

    def said(token: Any) -> str:
        match token.type:
            case TokenType.WORD:
                return str(token.data)
            case TokenType.STACK:
                upper, lower, between = token.data
                if between == "^":
                    return f"{lower}{upper}"
                return f"{upper}{between}{lower}"
            case TokenType.NEW_PARAGRAPH:
                return "\n"
        return " "

    return "".join(said(t) for t in MTextParser(text))


def _add_polyline(drawing: ReadDrawing, entity: Any, scale: float) -> None:
    """A polyline: one or more vectors, perhaps with heads, or a hollow head."""
    if entity.dxftype() == "LWPOLYLINE":
        points = [_scaled_point(p, scale) for p in entity.vertices_in_wcs()]
        closed = bool(entity.closed)
        rows = [tuple(w) for w in entity.get_points("seb")]
    else:
        points = [_scaled_point(p, scale) for p in entity.points_in_wcs()]
        closed = bool(entity.is_closed)
        rows = [tuple(v.dxf.get(k, 0.0) for k in ("start_width", "end_width", "bulge")) for v in entity.vertices]
    if (
        head := arrowhead_from_figure(points)
        if closed or (len(points) > 3 and abs(points[0] - points[-1]) < 1e-6)
        else None
    ):
        drawing.heads.append(head)
        return
    if any(row[2] for row in rows):  # arcs are no vectors
        ring = [*points, points[0]] if closed else points
        for a, b, row in zip(ring, ring[1:], rows, strict=False):
            if not row[2]:
                drawing.add_polyline([a, b])
        return
    if not closed and len(points) > 1:
        points, heads = split_off_tapered_heads(points, [(w[0], w[1]) for w in rows])
        drawing.heads += heads
    drawing.add_polyline(points, closed)


def _add_text(drawing: ReadDrawing, entity: Any, scale: float) -> None:
    """A text: the position of its lower left corner depends on its alignment."""
    from ezdxf.tools.text import unified_alignment

    across, up = unified_alignment(entity)
    back = complex(across / 2, UP[up])
    if entity.dxftype() == "MTEXT":
        at = entity.dxf.insert
        turn = entity.get_rotation()
        height = entity.dxf.char_height
        text = _mtext_words(entity.text)
        width = entity.dxf.get("rect_width", 0.0) * scale
        span = 0j
    else:
        _, at, end = entity.get_placement()
        at = entity.ocs().to_wcs(at)
        turn = entity.dxf.rotation
        height = entity.dxf.height
        text = entity.plain_text()
        span = 0j if end is None else _scaled_point(end - at, scale)  # between two points
        width = abs(span)
        back = back if end is None else 0j
    height *= scale
    width = width or height * text_width_in_heights(text)
    along = span / abs(span) if span else cmath.rect(1, math.radians(turn))
    corner = along * complex(width * back.real, height * back.imag)
    drawing.add_text(Words(text, _scaled_point(at, scale) - corner, height, width, along))


def _scaled_point(p: Any, scale: float) -> complex:
    return complex(float(p[0]), float(p[1])) * scale
