"""Strokes and words of a DXF file: lines, polylines, blocks inside blocks, texts."""

from __future__ import annotations

import cmath
import math
from pathlib import Path
from typing import Any

from planes.check.strokes import Sketch, Words
from planes.wording import PlanesError
from planes.words import Phrase

_MM = {0: 1.0, 1: 25.4, 2: 304.8, 4: 1.0, 5: 10.0, 6: 1000.0, 8: 25.4e-6, 13: 1e-3, 14: 100.0}
MOST = 60_000


def read_dxf(path: str | Path) -> Sketch:
    """The strokes of a file's model space in mm. :class:`PlanesError` where it is not a DXF."""
    try:
        from ezdxf import recover
        from ezdxf.lldxf.const import DXFError
    except ImportError:
        raise PlanesError(Phrase("check_needs", what="ezdxf")) from None
    try:
        document, _ = recover.readfile(str(path))
    except (OSError, DXFError, ValueError, UnicodeError) as error:
        raise PlanesError(Phrase("check_dxf", file=str(path), why=str(error)[:80])) from None
    scale = _MM.get(int(document.header.get("$INSUNITS", 0)), 1.0)
    return _sketch(document, scale, str(path))


def _sketch(document: Any, scale: float, file: str) -> Sketch:
    from ezdxf import disassemble

    found = Sketch(file)
    for count, entity in enumerate(disassemble.recursive_decompose(document.modelspace())):
        if count > MOST:
            break
        try:
            _entity(found, entity, scale)
        except (ValueError, AttributeError, TypeError):
            continue
    return found


def _entity(found: Sketch, entity: Any, scale: float) -> None:
    """One entity, if it is straight or a text."""
    match entity.dxftype():
        case "LINE":
            found.add([_z(entity.dxf.start, scale), _z(entity.dxf.end, scale)])
        case "LWPOLYLINE":
            points = [_z(p, scale) for p in entity.get_points("xy")]
            found.add(points, bool(entity.closed))
        case "POLYLINE":
            found.add([_z(v.dxf.location, scale) for v in entity.vertices], bool(entity.is_closed))
        case "LEADER":
            found.add([_z(v, scale) for v in entity.vertices])
        case "SOLID":
            places = [_z(p, scale) for p in entity.vertices()]
            middle = sum(places) / len(places)
            found.arrows.append(max(places, key=lambda z: abs(z - middle)))
        case "TEXT":
            along = cmath.rect(1, math.radians(entity.dxf.get("rotation", 0.0)))
            _words(found, entity.plain_text(), _z(entity.dxf.insert, scale), entity.dxf.height * scale, along)
        case "MTEXT":
            along = cmath.rect(1, math.radians(entity.get_rotation()))
            height = entity.dxf.char_height * scale
            below = height if entity.dxf.get("attachment_point", 1) < 4 else 0.0
            _words(found, entity.plain_text(), _z(entity.dxf.insert, scale) - 1j * along * below, height, along)


def _words(found: Sketch, text: str, place: complex, height: float, along: complex) -> None:
    if text.strip() and len(text) <= 40:
        found.words.append(Words(text.strip(), place, height, 0.7 * height * len(text.strip()), along))


def _z(p: Any, scale: float) -> complex:
    return complex(float(p[0]), float(p[1])) * scale
