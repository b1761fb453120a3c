"""Strokes and words of a DXF file: lines, polylines, nested blocks, arrowheads, texts; no dimensions."""

import cmath
import io
import math
from collections.abc import Iterable, Iterator
from itertools import count
from pathlib import Path
from typing import Any

from planes.check.reading.arrowheads import head_of, settle, tapered
from planes.check.reading.opened import MB, contents, too_many
from planes.check.reading.parts import breadth, joined, without_letters
from planes.check.reading.strokes import ROUND_MM, Arrowhead, ReadDrawing
from planes.check.reading.written import Words
from planes.words.errors import guarded

_MM = {0: 1.0, 1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0, 8: 25.4e-6, 13: 1e-3, 14: 100.0}
LARGEST = 12 * MB
MOST = 60_000  # entities, including blocks
DEEPEST = 30  # nesting depth of blocks
FILLINGS = ("SOLID", "TRACE", "HATCH")
MEASURES = ("DIMENSION", "ARC_DIMENSION", "LARGE_RADIAL_DIMENSION", "TOLERANCE", "VIEWPORT")  # no vectors


def read_dxf(path: str | Path) -> ReadDrawing:
    """The strokes of a file's model space in mm, or of its sheets if that is empty.

    :class:`PlanesError` if it is not a DXF.
    """
    from ezdxf import recover

    data = contents(path, LARGEST)
    with guarded("check_dxf", path):
        document, _ = recover.read(io.BytesIO(data))
        scale = _MM.get(int(document.header.get("$INSUNITS", 0)), 1.0)
        for space in (document.modelspace(), *(s for s in document.layouts if s.name != "Model")):
            drawing = _sketch(document, space, scale, str(path))
            if drawing.strokes:
                break
    return drawing


def _sketch(document: Any, space: Any, scale: float, file: str) -> ReadDrawing:
    drawing = ReadDrawing(file)
    for entity in _seen(document, space, file):
        try:
            _entity(drawing, entity, scale)
        except (ValueError, AttributeError, TypeError, IndexError, ZeroDivisionError):
            continue
    drawing.words = joined(drawing.words)
    without_letters(drawing)
    settle(drawing)
    return drawing


def _seen(document: Any, space: Any, file: str) -> Iterator[Any]:
    """The visible entities, with blocks expanded; all are counted, visible or not."""
    unseen, passed = {x.dxf.name.casefold() for x in document.layers if x.is_off() or x.is_frozen()}, count(1)

    def counted(entities: Iterable[Any]) -> Iterator[Any]:
        for entity in entities:
            if next(passed) > MOST:
                raise too_many(file, "elements", MOST)
            yield entity

    def held(entities: Iterable[Any], depth: int) -> Iterator[Any]:
        for entity in counted(entities):
            kind, layer = entity.dxftype(), entity.dxf.get("layer", "0").casefold()
            if kind in MEASURES or layer in unseen or entity.dxf.get("invisible", 0):
                continue
            if kind != "INSERT":
                yield entity
            elif depth < DEEPEST:
                for one in counted(entity.multi_insert() if entity.mcount > 1 else (entity,)):
                    parts, drawn_once = one.virtual_entities(), _outlined(entity.block())
                    yield from held((p for p in parts if not drawn_once or p.dxftype() not in FILLINGS), depth + 1)
                    yield from (a for a in one.attribs if not a.is_invisible)

    return held(space, 0)


def _outlined(block: Any) -> bool:
    """Whether a block is one figure and its filling: a head, to be counted once."""
    kinds = [e.dxftype() for e in block] if block is not None and len(block) == 2 else []
    return sum(kind in FILLINGS for kind in kinds) == 1


def _entity(drawing: ReadDrawing, entity: Any, scale: float) -> None:
    """One entity, if it is straight, a head or a text."""
    match entity.dxftype():
        case "LINE":
            drawing.add([_z(entity.dxf.start, scale), _z(entity.dxf.end, scale)])
        case "CIRCLE" if entity.dxf.radius * scale <= ROUND_MM:
            drawing.rounds.append((_z(entity.ocs().to_wcs(entity.dxf.center), scale), entity.dxf.radius * scale))
        case "LWPOLYLINE" | "POLYLINE":
            _polyline(drawing, entity, scale)
        case "LEADER":
            tip, *before = places = [_z(v, scale) for v in entity.vertices]
            drawing.add(places)
            if entity.dxf.get("has_arrowhead", 1) and before and tip != before[0]:
                drawing.heads.append(Arrowhead(tip, (tip - before[0]) / abs(tip - before[0])))
        case "SOLID" | "TRACE":
            drawing.heads += filter(None, [head_of([_z(p, scale) for p in entity.wcs_vertices()])])
        case "HATCH":
            drawing.heads += filter(None, [head_of(_boundary(entity, path, scale)) for path in entity.paths])
        case "TEXT" | "ATTRIB":
            _text(drawing, entity, scale)
        case "MTEXT":
            along = cmath.rect(1, math.radians(entity.get_rotation()))
            below, across = divmod(entity.dxf.get("attachment_point", 1) - 1, 3)
            height, text = entity.dxf.char_height * scale, _told(entity.text)
            width = entity.dxf.get("rect_width", 0.0) * scale or height * breadth(text)
            corner = complex(width * across, height * (2 - below)) / 2
            drawing.write(Words(text, _z(entity.dxf.insert, scale) - along * corner, height, width, along))


def _told(text: str) -> str:
    """The words of an MTEXT; of two indices the lower one first, as names are written."""
    from ezdxf.tools.text import MTextParser, TokenType

    def said(token: Any) -> str:
        match token.type:
            case TokenType.WORD:
                return str(token.data)
            case TokenType.STACK:
                upper, lower, between = token.data
                return f"{lower}{upper}" if between == "^" else f"{upper}{between}{lower}"
            case TokenType.NEW_PARAGRAPH:
                return "\n"
        return " "

    return "".join(said(t) for t in MTextParser(text))


def _polyline(drawing: ReadDrawing, entity: Any, scale: float) -> None:
    """A polyline: one or more vectors, perhaps with heads, or a hollow head."""
    if entity.dxftype() == "LWPOLYLINE":
        points, closed = [_z(p, scale) for p in entity.vertices_in_wcs()], bool(entity.closed)
        rows = [tuple(w) for w in entity.get_points("seb")]
    else:
        points, closed = [_z(p, scale) for p in entity.points_in_wcs()], bool(entity.is_closed)
        rows = [tuple(v.dxf.get(k, 0.0) for k in ("start_width", "end_width", "bulge")) for v in entity.vertices]
    if head := head_of(points) if closed or (len(points) > 3 and abs(points[0] - points[-1]) < 1e-6) else None:
        drawing.heads.append(head)
        return
    if any(row[2] for row in rows):  # arcs are no vectors
        ring = [*points, points[0]] if closed else points
        for a, b, row in zip(ring, ring[1:], rows, strict=False):
            if not row[2]:
                drawing.add([a, b])
        return
    if not closed and len(points) > 1:
        points, heads = tapered(points, [(w[0], w[1]) for w in rows])
        drawing.heads += heads
    drawing.add(points, closed)


def _boundary(entity: Any, path: Any, scale: float) -> list[complex]:
    """Corners of a hatched figure."""
    if hasattr(path, "vertices"):
        corners = [(v[0], v[1]) for v in path.vertices]
    else:
        corners = [edge.start for edge in path.edges if hasattr(edge, "start")]
    return [_z(entity.ocs().to_wcs((x, y, 0)), scale) for x, y, *_ in corners]


def _text(drawing: ReadDrawing, entity: Any, scale: float) -> None:
    """A line of text: the position of its lower left corner depends on its alignment."""
    along = cmath.rect(1, math.radians(entity.dxf.get("rotation", 0.0)))
    across, up = entity.dxf.get("halign", 0), entity.dxf.get("valign", 0)
    fitted = entity.dxf.get("align_point") if across in (3, 5) else None
    placed = entity.dxf.get("align_point") if (across or up) and across not in (3, 5) else None
    at = entity.ocs().to_wcs(placed if placed is not None else entity.dxf.insert)
    height, text = entity.dxf.height * scale, entity.plain_text()
    width = height * breadth(text)
    if fitted is not None:  # between two points
        span = _z(fitted, scale) - _z(entity.dxf.insert, scale)
        width, along = abs(span) or width, span / abs(span) if span else along
    back = {1: 0.5, 2: 1.0, 4: 0.5}.get(across, 0.0) if placed is not None else 0.0
    down = {2: 0.5, 3: 1.0}.get(up, 0.5 if across == 4 else 0.0) if placed is not None else 0.0
    drawing.write(Words(text, _z(at, scale) - along * complex(width * back, height * down), height, width, along))


def _z(p: Any, scale: float) -> complex:
    return complex(float(p[0]), float(p[1])) * scale
