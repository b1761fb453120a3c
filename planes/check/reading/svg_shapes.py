"""Shapes of an SVG file as straight pieces, and how they look: attributes, styles and rules by class."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from itertools import pairwise
from xml.etree import ElementTree

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
ROUND = 0.05  # how unequal the radii of a circle may be, and how far its ends apart, for its size
STRAIGHT = 0.01  # a curve that leaves its chord by less is a line
Looks = dict[str, str]
LOOKS = ("stroke", "fill", "display", "visibility", "marker", "marker-start", "marker-end")


def style_rules(root: ElementTree.Element) -> dict[str, Looks]:
    """Rules of the file's style sheets by their selectors: a class, an element or a name."""
    found: dict[str, Looks] = {}
    for e in root.iter():
        if isinstance(e.tag, str) and e.tag.rpartition("}")[2] == "style":
            text = re.sub(r"/\*.*?\*/", "", "".join(e.itertext())[:200_000], flags=re.DOTALL)
            for rule in text.split("}"):
                selectors, _, body = rule.rpartition("{")
                for selector in selectors.split(","):
                    found.setdefault(selector.strip(), {}).update(_declared(body))
    return found


def _declared(text: str) -> Looks:
    pairs = re.findall(r"([^:;]+):([^;]*)", text)
    return {k.strip(): v.strip() for k, v in pairs if k.strip() in LOOKS}


def looks_of(e: ElementTree.Element, rules: Mapping[str, Looks]) -> Looks:
    """How an element is to look, as far as it says itself."""
    found = {k: v for k in LOOKS if (v := e.get(k))}
    tag = e.tag.rpartition("}")[2] if isinstance(e.tag, str) else ""
    for selector in (tag, *(f".{c}" for c in (e.get("class") or "").split()), f"#{e.get('id')}"):
        found |= rules.get(selector, {})
    return found | _declared(e.get("style") or "")


def number(text: str | None) -> float:
    """A coordinate, whatever unit it names; none is zero."""
    found = re.search(NUMBER, text or "")
    return float(found[0]) if found else 0.0


def outline(e: ElementTree.Element, tag: str) -> Iterator[tuple[list[complex], bool]]:
    """The straight polylines of a shape."""
    if tag == "line":
        x1, y1, x2, y2 = (number(e.get(k)) for k in ("x1", "y1", "x2", "y2"))
        yield [complex(x1, y1), complex(x2, y2)], False
    elif tag in ("polyline", "polygon"):
        v = [float(n) for n in re.findall(NUMBER, e.get("points") or "")]
        points = [complex(x, y) for x, y in zip(v[::2], v[1::2], strict=False)]
        if len(points) > 1:
            yield points, tag == "polygon"
    elif tag == "path":
        for line, closed in path_lines(e.get("d") or ""):
            yield line, closed or (len(line) > 3 and line[0] == line[-1])


def _pieces(d: str) -> Iterator[tuple[str, complex, bool]]:
    """A path piece by piece: its letter, where it ends, and whether it is straight."""
    at = start = 0j
    for letter, inside in re.findall(r"([MmLlHhVvCcSsQqTtAaZz])([^MmLlHhVvCcSsQqTtAaZz]*)", d):
        v = [float(n) for n in re.findall(NUMBER, inside)]
        base = letter.upper()
        if base == "Z":
            at = start
            yield "Z", at, True
            continue
        step = {"M": 2, "L": 2, "T": 2, "H": 1, "V": 1, "C": 6, "S": 4, "Q": 4, "A": 7}[base]
        for k in range(0, len(v) - step + 1, step):
            part, before = v[k : k + step], at
            at = _end(base, part, at, letter.islower())
            begins = base == "M" and k == 0
            start = at if begins else start
            straight = base in "MLHV" or _straight(base, part, before, letter.islower())
            yield "M" if begins else base.replace("M", "L"), at, straight


def path_lines(d: str) -> Iterator[tuple[list[complex], bool]]:
    """The straight pieces of a path; a curve is jumped over, unless it is a line written as a curve."""
    points: list[complex] = []
    for letter, at, straight in _pieces(d):
        if straight and letter not in "MZ":
            points.append(at)
            continue
        if len(points) > 1:
            yield points, letter == "Z"
        points = [at]
    if len(points) > 1:
        yield points, False


def rings(d: str) -> Iterator[list[complex]]:
    """Corners of the closed figures of a path, those between curves too."""
    ring: list[complex] = []
    for letter, at, _ in _pieces(d) if "z" in d or "Z" in d else ():
        if letter == "Z" and len(ring) > 2:
            yield ring
        ring = [at] if letter in "MZ" else ring
        if letter not in "MZ":
            ring.append(at)


def circles(d: str) -> Iterator[tuple[complex, float]]:
    """Middles and radii of the closed figures of a path that are all curve and stand round their middle."""
    ring: list[complex] = []
    curved = True
    for letter, at, _ in (*_pieces(d), ("M", 0j, True)) if re.search("[AaCc]", d) else ():
        if letter not in "MZ":
            ring, curved = [*ring, at], curved and letter not in "LHV"
            continue
        corners = ring[:-1] if len(ring) > 2 and abs(ring[-1] - ring[0]) < ROUND * abs(ring[1] - ring[0]) else []
        middle = sum(corners) / max(len(corners), 1)
        radii = [abs(z - middle) for z in corners]
        if curved and radii and max(radii) < (1 + ROUND) * min(radii):
            yield middle, max(radii)
        ring, curved = [at], True


def _end(base: str, v: list[float], at: complex, relative: bool) -> complex:
    if base == "H":
        return complex(v[0] + (at.real if relative else 0.0), at.imag)
    if base == "V":
        return complex(at.real, v[0] + (at.imag if relative else 0.0))
    return complex(v[-2], v[-1]) + (at if relative else 0j)


def _straight(base: str, v: list[float], at: complex, relative: bool) -> bool:
    """Whether a curve's handles lie on its chord."""
    if base not in "CQ":
        return False
    places = [complex(x, y) + (at if relative else 0j) for x, y in pairwise(v)][::2]
    chord = places[-1] - at
    return abs(chord) > 0 and all(abs(((z - at) / chord).imag) < STRAIGHT for z in places[:-1])
