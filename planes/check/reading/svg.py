"""Strokes and words of an SVG file as written by drawing programs: nested transforms, paths, polylines, symbols."""

import re
from collections.abc import Mapping, Sequence
from pathlib import Path
from xml.etree import ElementTree

from fontTools.misc.transform import Transform

from planes.check.reading.arrowheads import figure_of, settle
from planes.check.reading.opened import LARGEST as LARGEST_PICTURE
from planes.check.reading.opened import MB, contents, too_many
from planes.check.reading.parts import breadth, without_letters
from planes.check.reading.strokes import ROUND_MM, Arrowhead, ReadDrawing
from planes.check.reading.svg_css import MM, OWN, Looks, length, looks_of, number, numbers, ruled, transform_of
from planes.check.reading.svg_shapes import MOST, outlines, tree
from planes.check.reading.written import Words
from planes.geometry.plane import toward
from planes.scene.carried import carried
from planes.words import Phrase
from planes.words.errors import PlanesError

LARGEST = 12 * MB
LETTERS = 50  # of a shape's description that take as long to read as one element
LETTERS_OF_CSS = 10  # the same for CSS not read before
DEEPEST = 60  # nesting depth of groups
DRAWN = ("text", "circle", "line", "polyline", "polygon", "path")
NO_HEADS = ("dot", "circle", "square", "stop", "tick", "distance", "diamond")  # markers that are no arrowheads


def read_svg(path: str | Path) -> ReadDrawing:
    """The strokes of a file in mm, y up. :class:`PlanesError` if it is not an SVG."""
    root = tree(contents(path, LARGEST), str(path))
    if root.tag != "svg":
        raise PlanesError(Phrase("check_svg", file=str(path), why=f"<{root.tag}>"))
    return sketch_of(root, str(path))


def read_carried(path: str | Path) -> ReadDrawing | None:
    """The strokes of the drawing embedded in a PNG written by this program, if any."""
    svg = carried(contents(path, LARGEST_PICTURE), LARGEST)
    return sketch_of(tree(svg, str(path)), str(path)) if svg else None


def sketch_of(root: ElementTree.Element, file: str) -> ReadDrawing:
    """The content of a picture's tree, in mm, y up."""
    named = {e.get("id", ""): e for e in root.iter() if e.get("id")}
    fitted = _fitted(root, [length(root.get(k)) for k in ("width", "height")])
    page = Transform(1, 0, 0, -1).transform(Transform().scale(MM) if fitted is None else fitted)
    reader = _Reader(ReadDrawing(file, mm=lambda z: _at(page, z)), named, ruled(root, file))
    reader.walk(root, page, 0, {})
    without_letters(reader.sketch)
    settle(reader.sketch)
    return reader.sketch


def _fitted(e: ElementTree.Element, sides: Sequence[float]) -> Transform | None:
    """From the units of a picture's view box to those of its sides (if not 0); None without a view box."""
    box = numbers(e.get("viewBox"))
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0):
        return None
    scale = min((a / b for a, b in zip(sides, box[2:], strict=True) if a), default=1.0)
    return Transform().scale(scale).translate(-box[0], -box[1])


def _at(m: Transform, z: complex) -> complex:
    return complex(*m.transformPoint((z.real, z.imag)))


class _Reader:
    """Walks the tree; the attributes of a group apply to all its content."""

    def __init__(
        self, sketch: ReadDrawing, named: dict[str, ElementTree.Element], rules: Mapping[ElementTree.Element, Looks]
    ) -> None:
        self.sketch, self.named, self.rules, self.count, self.said = sketch, named, rules, 0, set[str]()

    def walk(self, e: ElementTree.Element, m: Transform, depth: int, looks: Looks, used: bool = False) -> None:
        new = {e.get(k, "") for k in ("style", "transform")} - self.said
        self.said |= new
        self.count += 1 + sum(map(len, new)) // LETTERS_OF_CSS
        self.count += sum(len(e.get(k, "")) for k in ("d", "points")) // LETTERS
        if self.count > MOST:
            raise too_many(self.sketch.file, "elements", MOST)
        if depth > DEEPEST:
            return
        own = looks_of(e, self.rules)
        m, looks = m.transform(transform_of(own.pop(OWN, ""))), {**looks, **own}
        if looks.get("display") == "none":
            return
        match e.tag:
            case tag if tag in DRAWN and looks.get("visibility") in ("hidden", "collapse"):
                pass  # the content of a hidden group may be visible
            case "use":
                target = self.named.get(e.get("href", "").removeprefix("#"))
                if target is not None and depth < 20:
                    self.walk(target, m.translate(number(e, "x"), number(e, "y")), depth + 1, looks, True)
            case "text":
                self._text(e, m, looks)
            case "circle":
                self._round(m, complex(number(e, "cx"), number(e, "cy")), number(e, "r"))
            case "line" | "polyline" | "polygon" | "path":
                self._shape(e, m, looks)
            case "defs" | "clipPath" | "marker" | "pattern" | "mask":
                pass
            case tag if tag != "symbol" or used:
                if tag == "svg" and depth:  # a nested picture: its position and its units
                    inner = _fitted(e, [number(e, k) for k in ("width", "height")])
                    m = m.translate(number(e, "x"), number(e, "y")).transform(inner or Transform())
                for child in e:
                    self.walk(child, m, depth + 1, looks)

    def _shape(self, e: ElementTree.Element, m: Transform, looks: Looks) -> None:
        stroke, fill = looks.get("stroke", ""), looks.get("fill", "")
        solid = stroke == "none" or (not stroke and fill not in ("", "none"))
        parts = list(outlines(e))
        for circle in (one.circle for one in parts):
            if circle:
                self._round(m, *circle)
        figures = [f for one in parts if one.closed and (f := figure_of([_at(m, z) for z in one.corners]))]
        for points, closed in (line for one in parts for line in one.lines()) if not figures else ():
            places = [_at(m, z) for z in points]
            if figure := figure_of(places, solid) if closed or solid else None:
                figures.append(figure)
            elif not solid:
                self.sketch.add(places, closed)
                self._markers(places, looks)
        for shaft, head in figures:
            self.sketch.heads.append(head)
            self.sketch.add(shaft)

    def _round(self, m: Transform, middle: complex, radius: float) -> None:
        """A small circle."""
        radius *= abs(complex(m.xx, m.xy))
        if 0 < radius <= ROUND_MM:
            self.sketch.rounds.append((_at(m, middle), radius))

    def _markers(self, places: list[complex], looks: Looks) -> None:
        """Markers of a line that are heads."""
        for key, tip, before in (("marker-start", places[0], places[1]), ("marker-end", places[-1], places[-2])):
            named = looks.get(key, looks.get("marker", "none")).lower()
            if named != "none" and tip != before and not any(word in named for word in NO_HEADS):
                self.sketch.heads.append(Arrowhead(tip, toward(before, tip)))

    def _text(self, e: ElementTree.Element, m: Transform, looks: Looks) -> None:
        text = re.sub(r"[ \t\r\n]+", " ", "".join(e.itertext())).strip()
        first = next((c for c in e.iter() if c.get("x")), e)
        m = m.transform(transform_of(first.get("transform") or "")) if first is not e else m
        pieces = [(c, c.text or "") for c in e.iter() if c.get("x") and (c.text or "").strip()]
        if not pieces or "".join("".join(t for _, t in pieces).split()) != text.replace(" ", ""):
            pieces = [(first, text)]
        boxes = [_box(c, t, _size(looks_of(c, self.rules), looks)) for c, t in pieces]
        right, down = complex(m.xx, m.xy), complex(m.yx, m.yy)
        height, along = boxes[0][2] * abs(down), right / abs(right) if abs(right) else 1 + 0j
        width = max(z.real + w - boxes[0][0].real for z, w, _ in boxes) * abs(right)
        back = {"middle": 0.5, "end": 1.0}.get(looks.get("text-anchor", ""), 0.0) * width
        self.sketch.write(Words(text, _at(m, boxes[0][0]) - along * back, height, width, along))


def _size(*said: Looks) -> float:
    """The size of letters, from the first source that gives it."""
    return next((n[0] for looks in said if (n := numbers(looks.get("font-size")))), 12.0)


def _box(e: ElementTree.Element, text: str, size: float) -> tuple[complex, float, float]:
    """The start of a piece of text, its width and its height."""
    width = number(e, "textLength") or 0.73 * size * breadth(text)
    return complex(number(e, "x"), number(e, "y")), width, 0.73 * size
