"""Strokes and words of an SVG file as drawing programs write it: nested transforms, paths, polylines, symbols."""

from __future__ import annotations

import re
from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree

from planes.check.reading.arrowheads import head_of, settle
from planes.check.reading.opened import MB, contents, too_many
from planes.check.reading.parts import breadth, without_letters
from planes.check.reading.strokes import ROUND_MM, Arrowhead, ReadDrawing, Words
from planes.check.reading.svg_shapes import NUMBER, Looks, circles, looks_of, number, outline, rings, style_rules
from planes.check.reading.svg_tree import MOST, tree
from planes.words import Phrase
from planes.words.errors import PlanesError

LARGEST = 12 * MB
LETTERS = 50  # of a shape's own description that take as long to read as one element
LONGEST = 200  # letters of a text
_MM = {"mm": 1.0, "cm": 10.0, "in": 25.4, "pt": 25.4 / 72, "pc": 25.4 / 6, "px": 25.4 / 96, "": 25.4 / 96}
DEEPEST = 60  # groups within groups
NO_HEADS = ("dot", "circle", "square", "stop", "tick", "distance", "diamond")  # markers that are no arrowheads
Affine = tuple[complex, complex, complex]  # z -> o + Re(z)·a + Im(z)·b
SAME: Affine = (0j, 1 + 0j, 1j)
_HREF = "{http://www.w3.org/1999/xlink}href"


def read_svg(path: str | Path) -> ReadDrawing:
    """The strokes of a file in mm, y up. :class:`PlanesError` where it is not an SVG."""
    root = tree(contents(path, LARGEST), str(path))
    if _tag(root) != "svg":
        raise PlanesError(Phrase("check_svg", file=str(path), why=f"<{_tag(root)}>"))
    return sketch_of(root, str(path))


def sketch_of(root: ElementTree.Element, file: str) -> ReadDrawing:
    """What a picture's tree holds, in mm, y up."""
    named = {e.get("id", ""): e for e in root.iter() if e.get("id")}
    page = _page(root)
    reader = _Reader(ReadDrawing(file, mm=lambda z: _at(page, z)), named, style_rules(root))
    reader.walk(root, page, 0, {})
    without_letters(reader.sketch)
    settle(reader.sketch)
    return reader.sketch


def _tag(e: ElementTree.Element) -> str:
    return e.tag.rpartition("}")[2] if isinstance(e.tag, str) else ""


def _length(text: str | None) -> float | None:
    match = re.fullmatch(rf"\s*({NUMBER})\s*(mm|cm|in|pt|pc|px|)\s*", text or "")
    return float(match[1]) * _MM[match[2]] if match else None


def _page(root: ElementTree.Element) -> Affine:
    """User units to mm of paper, y turned up."""
    width, height = _length(root.get("width")), _length(root.get("height"))
    box = [float(n) for n in re.findall(NUMBER, root.get("viewBox") or "")]
    if len(box) == 4 and box[2] > 0 and box[3] > 0:
        sides = [a / b for a, b in ((width, box[2]), (height, box[3])) if a]
        scale = min(sides) if sides else 1.0
        return complex(-box[0] * scale, box[1] * scale), scale + 0j, -1j * scale
    scale = _MM["px"]
    return 0j, scale + 0j, -1j * scale


def _then(outer: Affine, inner: Affine) -> Affine:
    """First the inner map, then the outer."""
    o = _at(outer, inner[0])
    return o, _at(outer, inner[1]) - outer[0], _at(outer, inner[2]) - outer[0]


def _at(m: Affine, z: complex) -> complex:
    return m[0] + m[1] * z.real + m[2] * z.imag


def _transform(text: str | None) -> Affine:
    """The ``transform`` attribute."""
    import cmath
    import math

    found = SAME
    for part in (text or "").split(")"):
        name, _, inside = part.strip(" \t\r\n,").partition("(")
        v = [float(n) for n in re.findall(NUMBER, inside)]
        name = name.strip()
        if name == "matrix" and len(v) == 6:
            one: Affine = (complex(v[4], v[5]), complex(v[0], v[1]), complex(v[2], v[3]))
        elif name == "translate" and v:
            one = (complex(v[0], v[1] if len(v) > 1 else 0.0), 1 + 0j, 1j)
        elif name == "scale" and v:
            one = (0j, v[0] + 0j, 1j * (v[1] if len(v) > 1 else v[0]))
        elif name == "rotate" and v:
            u, c = cmath.rect(1, math.radians(v[0])), complex(*v[1:3]) if len(v) > 2 else 0j
            one = (c - c * u, u, 1j * u)
        elif name in ("skewX", "skewY") and v:
            t = math.tan(math.radians(v[0]))
            one = (0j, 1 + 0j, complex(t, 1)) if name == "skewX" else (0j, complex(1, t), 1j)
        else:
            continue
        found = _then(found, one)
    return found


class _Reader:
    """Walks the tree; what a group sets holds for all in it."""

    def __init__(self, sketch: ReadDrawing, named: dict[str, ElementTree.Element], rules: Mapping[str, Looks]) -> None:
        self.sketch, self.named, self.rules, self.count = sketch, named, rules, 0

    def walk(self, e: ElementTree.Element, m: Affine, depth: int, looks: Looks, used: bool = False) -> None:
        tag = _tag(e)
        self.count += 1 + sum(len(e.get(k, "")) for k in ("d", "points", "transform", "style")) // LETTERS
        if self.count > MOST:
            raise too_many(self.sketch.file, "elements", MOST)
        if depth > DEEPEST:
            return
        looks = {**looks, **looks_of(e, self.rules)}
        if looks.get("display") == "none" or looks.get("visibility") in ("hidden", "collapse"):
            return
        m = _then(m, _transform(e.get("transform")))
        if tag == "svg" and depth:
            m = _then(m, _inner(e))
        if tag == "use":
            self._use(e, m, depth, looks)
        elif tag == "text":
            self._text(e, m)
        elif tag == "circle":
            middle = complex(*(number(e.get(k)) for k in ("cx", "cy")))
            self._round(m, middle, number(e.get("r")))
        elif tag in ("line", "polyline", "polygon", "path"):
            self._shape(e, tag, m, looks)
        elif tag not in ("defs", "clipPath", "marker", "pattern", "mask") and (tag != "symbol" or used):
            for child in e:
                self.walk(child, m, depth + 1, looks)

    def _use(self, e: ElementTree.Element, m: Affine, depth: int, looks: Looks) -> None:
        target = self.named.get((e.get("href") or e.get(_HREF) or "").removeprefix("#"))
        if target is not None and depth < 20:
            shift = complex(number(e.get("x")), number(e.get("y")))
            self.walk(target, _then(m, (shift, 1 + 0j, 1j)), depth + 1, looks, True)

    def _shape(self, e: ElementTree.Element, tag: str, m: Affine, looks: Looks) -> None:
        stroke, fill = looks.get("stroke", ""), looks.get("fill", "")
        solid = stroke == "none" or (not stroke and fill not in ("", "none"))
        for middle, radius in circles(e.get("d") or ""):
            self._round(m, middle, radius)
        curved = [h for ring in rings(e.get("d") or "") if (h := head_of([_at(m, z) for z in ring]))]
        if curved:
            self.sketch.heads += curved
            return
        for points, closed in outline(e, tag):
            places = [_at(m, z) for z in points]
            head = head_of(places) if closed or solid else None
            if head:
                self.sketch.heads.append(head)
            elif not solid:
                self.sketch.add(places, closed)
                self._markers(places, looks)

    def _round(self, m: Affine, middle: complex, radius: float) -> None:
        """A small circle."""
        if 0 < radius * abs(m[1]) <= ROUND_MM:
            self.sketch.rounds.append((_at(m, middle), radius * abs(m[1])))

    def _markers(self, places: list[complex], looks: Looks) -> None:
        """Heads a line has by itself."""
        for key, tip, before in (("marker-start", places[0], places[1]), ("marker-end", places[-1], places[-2])):
            named = looks.get(key, looks.get("marker", "none")).lower()
            if named != "none" and tip != before and not any(word in named for word in NO_HEADS):
                self.sketch.heads.append(Arrowhead(tip, (tip - before) / abs(tip - before)))

    def _text(self, e: ElementTree.Element, m: Affine) -> None:
        text = "".join(e.itertext()).strip()
        if not text or len(text) > LONGEST:
            return
        first = next((c for c in e.iter() if c.get("x")), e)
        m = _then(m, _transform(first.get("transform"))) if first is not e else m
        pieces = [c for c in e.iter() if c.get("x") and (c.text or "").strip()] or [first]
        if pieces != [first] and "".join(c.text or "" for c in pieces).replace(" ", "") == text.replace(" ", ""):
            boxes = [_box(c, c.text or "", _size(c, e)) for c in pieces]
        else:
            boxes = [_box(first, text, _size(first, e))]
        height, along = boxes[0][2] * abs(m[2]), m[1] / abs(m[1]) if abs(m[1]) else 1 + 0j
        width = max(x + w - boxes[0][0].real for x, w in ((z.real, w) for z, w, _ in boxes)) * abs(m[1])
        anchor = e.get("text-anchor") or ("middle" if "text-anchor:middle" in (e.get("style") or "") else "start")
        back = {"middle": 0.5, "end": 1.0}.get(anchor, 0.0) * width
        self.sketch.words.append(Words(text, _at(m, boxes[0][0]) - along * back, height, width, along))


def _size(*said: ElementTree.Element) -> float:
    """The size of letters, said by the first that says it."""
    sizes = [c.get("font-size") or (re.search(r"font-size:([^;]+)", c.get("style") or "") or ["", ""])[1] for c in said]
    return next((float(n[0]) for s in sizes if (n := re.findall(NUMBER, s))), 12.0)


def _box(e: ElementTree.Element, text: str, size: float) -> tuple[complex, float, float]:
    """Where a piece of text begins, its width and its height."""
    width = number(e.get("textLength")) or 0.73 * size * breadth(text)
    return complex(number(e.get("x")), number(e.get("y"))), width, 0.73 * size


def _inner(e: ElementTree.Element) -> Affine:
    """A picture within the picture: its place and its own units."""
    shift = complex(number(e.get("x")), number(e.get("y")))
    box = [float(n) for n in re.findall(NUMBER, e.get("viewBox") or "")]
    if len(box) != 4 or not (box[2] > 0 and box[3] > 0):
        return shift, 1 + 0j, 1j
    sides = [number(e.get(k)) / b for k, b in (("width", box[2]), ("height", box[3])) if e.get(k)]
    scale = min(sides) if sides else 1.0
    return shift - scale * complex(box[0], box[1]), scale + 0j, 1j * scale
