"""Elements of an SVG file: read within bounds, and their shapes as straight pieces."""

import re
from collections.abc import Iterator
from contextlib import suppress
from xml.etree import ElementTree
from xml.parsers import expat

from fontTools.pens.recordingPen import RecordingPen
from fontTools.svgLib.path.parser import parse_path

from planes.check.reading.opened import file_error, too_many_error
from planes.check.reading.svg_css import number_attribute
from planes.words.errors import reporting_library_errors
from planes.words.frozen import frozen

MOST_ELEMENTS = 60_000  # elements
MOST_ELEMENT_DEPTH = 200
NAMESPACE_PREFIX = re.compile(r"^[^:]*:")  # of a tag or an attribute
CIRCLE_TOLERANCE = 0.05  # tolerance of a circle's radii and of the gap between its ends, relative to its size
STRAIGHT_CURVE_TOLERANCE = 0.01  # a curve closer than this to its chord is a line


def parse_xml_tree(data: bytes, file: str) -> ElementTree.Element:
    """The root element; tags lose their prefixes, declared or not (FreeCAD's is not).

    :class:`PlanesError` if it is no XML, holds entities, which may grow without bound, or too many elements.
    """
    builder, parser, count, depth = ElementTree.TreeBuilder(), expat.ParserCreate(), 0, 0

    def start(tag: str, attributes: dict[str, str]) -> None:
        nonlocal count, depth
        count = count + 1
        depth = depth + 1
        if count > MOST_ELEMENTS or depth > MOST_ELEMENT_DEPTH:
            raise too_many_error(
                file,
                "elements" if count > MOST_ELEMENTS else "levels",
                MOST_ELEMENTS if count > MOST_ELEMENTS else MOST_ELEMENT_DEPTH,
            )
        link = next((said for name, said in attributes.items() if NAMESPACE_PREFIX.sub("", name) == "href"), "")
        builder.start(NAMESPACE_PREFIX.sub("", tag), {"href": link, **attributes})

    def end(tag: str) -> None:
        nonlocal depth
        depth -= 1
        builder.end(NAMESPACE_PREFIX.sub("", tag))

    def entity(*_: object) -> None:
        raise file_error("check_svg_entities", file)

    parser.buffer_text = True
    parser.StartElementHandler = start
    parser.EndElementHandler = end
    parser.CharacterDataHandler = builder.data
    parser.EntityDeclHandler = entity
    with reporting_library_errors("check_svg", file):
        parser.Parse(data, True)
        return builder.close()


@frozen
class Subpath:
    """A part of a path drawn without lifting the pen: its vertices, and which of its pieces are straight."""

    corners: list[complex]
    straight: list[bool]
    closed: bool

    @property
    def circle(self) -> tuple[complex, float] | None:
        """Centre and radius, if it consists of curves only and surrounds its centre."""
        ring = self.corners[:-1]
        if (
            any(self.straight)
            or len(ring) < 2
            or abs(self.corners[-1] - ring[0]) >= CIRCLE_TOLERANCE * abs(ring[1] - ring[0])
        ):
            return None
        middle = sum(ring) / len(ring)
        radii = [abs(z - middle) for z in ring]
        if max(radii) < (1 + CIRCLE_TOLERANCE) * min(radii):
            return (middle, max(radii))
        return None

    def straight_polylines(self) -> Iterator[tuple[list[complex], bool]]:
        """Its straight polylines, and whether they are closed; curves are skipped."""
        line = self.corners[:1]
        for place, straight in zip(self.corners[1:], self.straight, strict=True):
            if straight:
                line.append(place)
                continue
            if len(line) > 1:
                yield line, False
            line = [place]
        if len(line) > 1:
            yield line, self.closed or (len(line) > 3 and line[0] == line[-1])


def read_subpaths(e: ElementTree.Element) -> Iterator[Subpath]:
    """The parts of a line, a polyline, a polygon or a path, as far as it can be read."""
    pen, corners, straight = RecordingPen(), [], list[bool]()

    def arc_to(*arc: object) -> None:
        pen.value.append(("arcTo", arc[-1:]))  # only the end of an arc

    pen.arcTo = arc_to
    with suppress(ValueError, LookupError, TypeError, ArithmeticError):
        parse_path(_path_description(e), pen)
    for name, points in (*pen.value, ("endPath", ())):
        places = [complex(*p) for p in points]
        if name == "moveTo":
            corners = places
            straight = []
        elif places:
            straight.append(name == "lineTo" or (name != "arcTo" and _is_straight_curve(corners[-1], places)))
            corners.append(places[-1])
        elif len(corners) > 1:
            back = name == "closePath" and straight[-1] and corners[0] == corners[-1]  # the closing line is implied
            yield Subpath(corners[: -1 if back else None], straight[: -1 if back else None], name == "closePath")
            corners = []


def _path_description(e: ElementTree.Element) -> str:
    """The path description of an equivalent shape."""
    if e.tag == "path":
        return e.get("d") or ""
    if e.tag == "line":
        return "M{} {}L{} {}".format(*(number_attribute(e, k) for k in ("x1", "y1", "x2", "y2")))
    return f"M{e.get('points')}" + "Z" * (e.tag == "polygon")


def _is_straight_curve(at: complex, places: list[complex]) -> bool:
    """Whether a curve's handles lie on its chord."""
    chord = places[-1] - at
    return abs(chord) > 0 and all(abs(((z - at) / chord).imag) < STRAIGHT_CURVE_TOLERANCE for z in places[:-1])
