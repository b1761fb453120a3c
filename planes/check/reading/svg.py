"""Strokes and words of an SVG file as written by drawing programs: nested transforms, paths, polylines, symbols."""

import re
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from xml.etree import ElementTree

from fontTools.misc.transform import Transform

from planes.check.reading.arrowheads import arrow_or_head_from_figure, assign_arrowheads
from planes.check.reading.opened import LARGEST_FILE_BYTES as LARGEST_PICTURE
from planes.check.reading.opened import MB, file_error, read_bounded_bytes, too_many_error
from planes.check.reading.parts import remove_letter_strokes, text_width_in_heights
from planes.check.reading.strokes import LARGEST_POINT_RADIUS_MM, Arrowhead, ReadDrawing
from planes.check.reading.svg_css import (
    MM_PER_PX,
    TRANSFORM_PROPERTY,
    Looks,
    number_attribute,
    parse_numbers,
    parse_transform,
    side_length_mm,
    style_of_element,
    styles_by_element,
)
from planes.check.reading.svg_shapes import MOST_ELEMENTS, parse_xml_tree, read_subpaths
from planes.check.reading.written import Words
from planes.geometry.plane import direction_between
from planes.scene.carried import drawing_in_png

LARGEST_SVG_BYTES = 12 * MB
SHAPE_LETTERS_PER_ELEMENT = 50  # of a shape's description that take as long to read as one element
CSS_LETTERS_PER_ELEMENT = 10  # the same for CSS not read before
MOST_GROUP_DEPTH = 60  # nesting depth of groups
DRAWN_TAGS = ("text", "circle", "line", "polyline", "polygon", "path")
HEADLESS_MARKERS = ("dot", "circle", "square", "stop", "tick", "distance", "diamond")  # markers that are no arrowheads


def read_svg(path: str | Path) -> ReadDrawing:
    """The strokes of a file in mm, y up. :class:`PlanesError` if it is not an SVG."""
    root = parse_xml_tree(read_bounded_bytes(path, LARGEST_SVG_BYTES), str(path))
    if root.tag != "svg":
        raise file_error("check_svg", path, why=f"<{root.tag}>")
    return drawing_from_svg(root, str(path))


def read_embedded_svg(path: str | Path) -> ReadDrawing | None:
    """The strokes of the drawing embedded in a PNG written by this program, if any."""
    svg = drawing_in_png(read_bounded_bytes(path, LARGEST_PICTURE), LARGEST_SVG_BYTES)
    if svg:
        return drawing_from_svg(parse_xml_tree(svg, str(path)), str(path))
    return None


def drawing_from_svg(root: ElementTree.Element, file: str) -> ReadDrawing:
    """The content of a picture's tree, in mm, y up."""
    named = {e.get("id", ""): e for e in root.iter() if e.get("id")}
    fitted = _view_box_transform(root, [side_length_mm(root.get(k)) for k in ("width", "height")])
    page = Transform(1, 0, 0, -1).transform(Transform().scale(MM_PER_PX) if fitted is None else fitted)
    reader = _Reader(ReadDrawing(file, mm=lambda z: _transformed_point(page, z)), named, styles_by_element(root, file))
    reader.read_element(root, page, 0, {})
    remove_letter_strokes(reader.sketch)
    assign_arrowheads(reader.sketch)
    return reader.sketch


def _view_box_transform(e: ElementTree.Element, sides: Sequence[float]) -> Transform | None:
    """From the units of a picture's view box to those of its sides (if not 0); None without a view box."""
    box = parse_numbers(e.get("viewBox"))
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0):
        return None
    scale = min((a / b for a, b in zip(sides, box[2:], strict=True) if a), default=1.0)
    return Transform().scale(scale).translate(-box[0], -box[1])


def _transformed_point(m: Transform, z: complex) -> complex:
    return complex(*m.transformPoint((z.real, z.imag)))


@dataclass
class _Reader:
    """Walks the tree; the attributes of a group apply to all its content."""

    sketch: ReadDrawing
    named: dict[str, ElementTree.Element]
    rules: Mapping[ElementTree.Element, Looks]
    count: int = 0
    said: set[str] = field(default_factory=set)

    def read_element(self, e: ElementTree.Element, m: Transform, depth: int, looks: Looks, used: bool = False) -> None:
        new = {e.get(k, "") for k in ("style", "transform")} - self.said
        self.said |= new
        self.count += 1 + sum(map(len, new)) // CSS_LETTERS_PER_ELEMENT
        self.count += sum(len(e.get(k, "")) for k in ("d", "points")) // SHAPE_LETTERS_PER_ELEMENT
        if self.count > MOST_ELEMENTS:
            raise too_many_error(self.sketch.file, "elements", MOST_ELEMENTS)
        if depth > MOST_GROUP_DEPTH:
            return
        own = style_of_element(e, self.rules)
        m = m.transform(parse_transform(own.pop(TRANSFORM_PROPERTY, "")))
        looks = {**looks, **own}
        if looks.get("display") == "none":
            return
        match e.tag:
            case tag if tag in DRAWN_TAGS and looks.get("visibility") in ("hidden", "collapse"):
                pass  # the content of a hidden group may be visible
            case "use":
                target = self.named.get(e.get("href", "").removeprefix("#"))
                if target is not None and depth < 20:
                    self.read_element(
                        target, m.translate(number_attribute(e, "x"), number_attribute(e, "y")), depth + 1, looks, True
                    )
            case "text":
                self._add_text(e, m, looks)
            case "circle":
                self._add_circle(
                    m, complex(number_attribute(e, "cx"), number_attribute(e, "cy")), number_attribute(e, "r")
                )
            case "line" | "polyline" | "polygon" | "path":
                self._add_shape(e, m, looks)
            case "defs" | "clipPath" | "marker" | "pattern" | "mask":
                pass
            case tag if tag != "symbol" or used:
                if tag == "svg" and depth:  # a nested picture: its position and its units
                    inner = _view_box_transform(e, [number_attribute(e, k) for k in ("width", "height")])
                    m = m.translate(number_attribute(e, "x"), number_attribute(e, "y")).transform(inner or Transform())
                for child in e:
                    self.read_element(child, m, depth + 1, looks)

    def _add_shape(self, e: ElementTree.Element, m: Transform, looks: Looks) -> None:
        stroke = looks.get("stroke", "")
        solid = stroke == "none" or (not stroke and looks.get("fill", "none") not in ("", "none"))
        parts = list(read_subpaths(e))
        for circle in (one.circle for one in parts):
            if circle:
                self._add_circle(m, *circle)
        figures = [
            f
            for one in parts
            if one.closed and (f := arrow_or_head_from_figure([_transformed_point(m, z) for z in one.corners]))
        ]
        for points, closed in (line for one in parts for line in one.straight_polylines()) if not figures else ():
            places = [_transformed_point(m, z) for z in points]
            if figure := arrow_or_head_from_figure(places, solid) if closed or solid else None:
                figures.append(figure)
            elif not solid:
                self.sketch.add_polyline(places, closed)
                self._add_marker_heads(places, looks)
        for shaft, head in figures:
            self.sketch.heads.append(head)
            self.sketch.add_polyline(shaft)

    def _add_circle(self, m: Transform, middle: complex, radius: float) -> None:
        """A small circle."""
        radius *= abs(complex(m.xx, m.xy))
        if 0 < radius <= LARGEST_POINT_RADIUS_MM:
            self.sketch.rounds.append((_transformed_point(m, middle), radius))

    def _add_marker_heads(self, places: list[complex], looks: Looks) -> None:
        """Markers of a line that are heads."""
        for key, tip, before in (("marker-start", places[0], places[1]), ("marker-end", places[-1], places[-2])):
            named = looks.get(key, looks.get("marker", "none")).lower()
            if named != "none" and tip != before and not any(word in named for word in HEADLESS_MARKERS):
                self.sketch.heads.append(Arrowhead(tip, direction_between(before, tip)))

    def _add_text(self, e: ElementTree.Element, m: Transform, looks: Looks) -> None:
        text = re.sub(r"[ \t\r\n]+", " ", "".join(e.itertext())).strip()
        first = next((c for c in e.iter() if c.get("x")), e)
        m = m.transform(parse_transform(first.get("transform") or "")) if first is not e else m
        pieces = [(c, c.text or "") for c in e.iter() if c.get("x") and (c.text or "").strip()]
        if not pieces or "".join("".join(t for _, t in pieces).split()) != text.replace(" ", ""):
            pieces = [(first, text)]
        boxes = [_text_box(c, t, _letter_size(style_of_element(c, self.rules), looks)) for c, t in pieces]
        right = complex(m.xx, m.xy)
        height = boxes[0][2] * abs(complex(m.yx, m.yy))
        along = right / abs(right) if abs(right) else 1 + 0j
        width = max(z.real + w - boxes[0][0].real for z, w, _ in boxes) * abs(right)
        back = {"middle": 0.5, "end": 1.0}.get(looks.get("text-anchor", ""), 0.0) * width
        self.sketch.add_text(Words(text, _transformed_point(m, boxes[0][0]) - along * back, height, width, along))


def _letter_size(*said: Looks) -> float:
    """The size of letters, from the first source that gives it."""
    return next((n[0] for looks in said if (n := parse_numbers(looks.get("font-size")))), 12.0)


def _text_box(e: ElementTree.Element, text: str, size: float) -> tuple[complex, float, float]:
    """The start of a piece of text, its width and its height."""
    width = number_attribute(e, "textLength") or 0.73 * size * text_width_in_heights(text)
    return complex(number_attribute(e, "x"), number_attribute(e, "y")), width, 0.73 * size
