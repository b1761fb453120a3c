"""Single-stroke drawing lettering after ГОСТ 2.304, type B (pen width d = h/10), in millimetres.

Text becomes pen paths, so that it looks the same on every device and in every file format.  A size h is
the height of the capitals from edge to edge; draw the paths with round ends and their ``pens``: PEN · h
except for raised and lowered characters.  Small letters are 7/10 h high, letters are 2/10 h apart (half of
that where both neighbours are open, as in ГА), words 6/10 h.  Slanted lettering is the upright one
sheared to 75°.

The letters are in ``glyphs.json`` on the grid of ГОСТ 2.304, type B: one cell is the pen width d, a capital fills
ten rows.  A point is the centre of a cell, so a capital runs from row 0 to row 9, a small letter to row 6, a descender
to row -3, signs of operation are about row 4, brackets reach from row -1.7 to row 10.3; columns are counted to the
right.  A path is a list of words:

    x,y              straight line to the point (after the start or after ``|``: pen set down there)
    hx,y             quarter oval to the point, leaving level and arriving upright
    vx,y             quarter oval to the point, leaving upright and arriving level
    cx,y x,y x,y     cubic Bézier curve: two handles and the end point
    |                pen up
    ox,y,x,y         closed oval between two corners
    .x,y             dot
    @A or @A,dx,dy   the strokes of another glyph, moved by dx, dy
"""

import json
import math
import unicodedata
from collections.abc import Iterator
from functools import lru_cache
from itertools import pairwise
from pathlib import Path

from render.paper.marks import Polyline

PEN_WIDTH_RATIO = 0.1  # pen width over letter height
LETTER_GAP_PENS = 2.0  # clear distance of letters, in pen widths
WORD_GAP_PENS = 6.0  # clear distance of words, in pen widths
SLANT_SHEAR = 1 / math.tan(math.radians(75))  # shear of the slanted lettering
SMALL_CHARACTER_RATIO = 0.7  # size of raised and lowered characters, and of their pen
_GLYPH_TABLES: dict[str, dict[str, str]] = json.loads(Path(__file__).with_name("glyphs.json").read_text("utf-8"))
GLYPH_PATHS = {char: path for table in _GLYPH_TABLES.values() for char, path in table.items()}
SAME_SHAPED_CHARACTERS = dict(
    zip(
        "АВЕІЈКМНОРЅСТХаеіјорѕсухΑΒΕΖΗΙΚΜΝΟΡΤΥΧοΓΠΦκµϕ∆∙⋅‧ʼ∼⟂‑‐―",
        "ABEIJKMHOPSCTXaeijopscyxABEZHIKMNOPTYXoГПФкμφΔ···’~⊥--—",
        strict=True,
    )
)
"""Characters drawn exactly like another one: look-alikes of the alphabets and duplicate signs."""
SHIFTED_CHARACTERS = {
    **{c: (base, 4.5) for c, base in zip("⁰¹²³⁴⁵⁶⁷⁸⁹ⁿ⁻⁺⁽⁾", "0123456789n−+()", strict=True)},
    "°": ("○", 6.5),
    **{c: (base, -3.0) for c, base in zip("₀₁₂₃₄₅₆₇₈₉ₙ₋₊₍₎", "0123456789n−+()", strict=True)},
}
"""Raised and lowered characters: the character repeated at ``SMALL`` size and its shift in d."""
_MISSING_GLYPH_PATH = "0,0 0,6 4,6 4,0 0,0"
_OVAL_HANDLE_RATIO = 0.6  # handle of a quarter oval: 0.552 gives an ellipse, more is squarer
_DOT_PATH_RADIUS = 0.2  # radius of the pen's path in a dot, in d
NARROW_SPACES = "\u2009\u202f\u2006\u200a"
_IGNORED_CHARACTERS = "\u00ad\u200b\u200d\u2060\ufeff"


def _parse_point(word: str) -> complex:
    x, y = word.split(",")
    return complex(float(x), float(y))


def bezier_points(a: complex, b: complex, c: complex, e: complex, tolerance: float) -> list[complex]:
    """Points of a Bézier curve after its start, extremes of x and y included."""
    bend = max(abs(a - 2 * b + c), abs(b - 2 * c + e))
    n = max(3, math.ceil(math.sqrt(0.75 * bend / tolerance)))
    at = {k / n for k in range(1, n)}
    p = b - a
    q = c - b
    r = e - c
    for u, v, w in ((p.real, q.real, r.real), (p.imag, q.imag, r.imag)):
        aa = u - 2 * v + w
        bb = v - u
        root = v * v - u * w
        if abs(aa) < 1e-9:
            roots = [-u / (2 * bb)] if abs(bb) > 1e-9 else []
        else:
            roots = [(-bb + s * math.sqrt(root)) / aa for s in (1, -1)] if root > 0 else []
        for t in roots:
            if 0.02 < t < 0.98:
                at = {s for s in at if abs(s - t) > 0.25 / n} | {t}
    second = q - p
    third = r - 2 * q + p
    return [a + t * (3 * p + t * (3 * second + t * third)) for t in sorted(at)] + [e]


def _quarter_oval_points(a: complex, e: complex, level: bool, tolerance: float) -> list[complex]:
    corner = complex(e.real, a.imag) if level else complex(a.real, e.imag)
    return bezier_points(a, a + _OVAL_HANDLE_RATIO * (corner - a), e + _OVAL_HANDLE_RATIO * (corner - e), e, tolerance)


def _oval_path(x0: float, y0: float, x1: float, y1: float) -> str:
    """Path of a closed oval, with short straight sides if it is taller than wide."""
    x = (x0 + x1) / 2
    half = 0.25 * max(0.0, y1 - y0 - (x1 - x0))
    low = (y0 + y1) / 2 - half
    high = (y0 + y1) / 2 + half
    return f"{x},{y0} h{x1},{low} {x1},{high} v{x},{y1} h{x0},{high} {x0},{low} v{x},{y0}"


def _glyph_polylines(path: str, tolerance: float) -> Iterator[Polyline]:
    """Polylines of a glyph's path, in d, cell centres."""
    line: list[complex] = []
    words = iter(path.split())
    for word in words:
        kind = word[0]
        if kind in "|o@." and line:
            yield tuple(line)
            line = []
        if kind == "o":
            yield from _glyph_polylines(_oval_path(*map(float, word[1:].split(","))), tolerance)
        elif kind == "@":
            shift = _parse_point(word[3:] or "0,0")
            yield from (tuple(z + shift for z in part) for part in _glyph_polylines(GLYPH_PATHS[word[1]], tolerance))
        elif kind == ".":
            yield tuple(_parse_point(word[1:]) + _DOT_PATH_RADIUS * 1j ** (k / 2) for k in range(9))
        elif kind == "c":
            line += bezier_points(
                line[-1], _parse_point(word[1:]), _parse_point(next(words)), _parse_point(next(words)), tolerance
            )
        elif kind in "hv":
            line += _quarter_oval_points(line[-1], _parse_point(word[1:]), kind == "h", tolerance)
        elif kind != "|":
            line.append(_parse_point(word))
    if line:
        yield tuple(line)


def _character_size(char: str) -> float:
    """The relative size of a character and of its pen."""
    return SMALL_CHARACTER_RATIO if char in SHIFTED_CHARACTERS else 1.0


@lru_cache(maxsize=4096)
def _glyph_width_and_paths(char: str, fineness: int, slant: bool) -> tuple[float, tuple[Polyline, ...]]:
    """Ink width and pen paths of a character in d, ink from x = 0, base line y = 0."""
    base, rise = SHIFTED_CHARACTERS.get(char, (char, 0.0))
    size = _character_size(char)
    lines = list(
        _glyph_polylines(GLYPH_PATHS.get(SAME_SHAPED_CHARACTERS.get(base, base), _MISSING_GLYPH_PATH), 0.2 / fineness)
    )
    across = [z.real for line in lines for z in line]
    left = min(across)
    right = max(across)
    edge = complex(0.5 * size, 0.5 * size + rise)
    moved = [[size * (z - left) + edge for z in line] for line in lines]
    shear = SLANT_SHEAR if slant else 0.0
    return size * (right - left + 1), tuple(
        tuple(complex(z.real + shear * z.imag, z.imag) for z in line) for line in moved
    )


@lru_cache(maxsize=512)
def _ink_extents_by_row(char: str) -> dict[int, tuple[float, float]]:
    """Leftmost and rightmost ink per row of the grid, in d."""
    rows: dict[int, list[float]] = {}
    half = 0.5 * _character_size(char)
    for line in _glyph_width_and_paths(char, 5, False)[1]:
        for a, b in pairwise(line):
            n = max(1, math.ceil(2 * abs(b - a)))
            for z in (a + (b - a) * k / n for k in range(n + 1)):
                rows.setdefault(round(z.imag), []).append(z.real)
    return {row: (min(x) - half, max(x) + half) for row, x in rows.items()}


@lru_cache(maxsize=16384)
def _letter_gap(left: str, right: str) -> float:
    """Clear distance of two neighbours in d: 2, or 1 where the ink is still 2 apart (ГА, ТА, AV)."""
    if left in SHIFTED_CHARACTERS or right in SHIFTED_CHARACTERS:
        return LETTER_GAP_PENS / 2
    if left.isdigit() and right.isdigit():
        return LETTER_GAP_PENS
    width = _glyph_width_and_paths(left, 5, False)[0]
    other = _ink_extents_by_row(right)
    near = (
        width - high + other[row + k][0]
        for row, (_, high) in _ink_extents_by_row(left).items()
        for k in (-1, 0, 1)
        if row + k in other
    )
    if min(near, default=math.inf) >= LETTER_GAP_PENS / 2:
        return LETTER_GAP_PENS / 2
    return LETTER_GAP_PENS


def _clean_text(text: str) -> str:
    return "".join(c for c in unicodedata.normalize("NFC", text) if c not in _IGNORED_CHARACTERS).strip()


@lru_cache(maxsize=4096)
def _line_width_and_places(text: str) -> tuple[float, tuple[tuple[str, float], ...]]:
    """Total width in d and the place of every character."""
    x = 0.0
    blank = 0.0
    last = ""
    placed = []
    for char in _clean_text(text):
        if char.isspace():
            blank += WORD_GAP_PENS / 2 if char in NARROW_SPACES else WORD_GAP_PENS
            continue
        if last:
            x += blank or _letter_gap(last, char)
        placed.append((char, x))
        x = x + _glyph_width_and_paths(char, 5, False)[0]
        blank = 0.0
        last = char
    return x, tuple(placed)


@lru_cache(maxsize=2048)
def letter_strokes(text: str, height_mm: float, slant: bool = False) -> tuple[Polyline, ...]:
    """Pen paths of one line of text as polylines x + iy in mm.

    The origin is the left end of the base line (left edge of the first letter's ink, lower edge of the capitals), y is
    up.  ``height_mm`` is the height of the capitals including the pen width.  Curves are flattened to within 0.02 mm.
    Leading and trailing blanks draw nothing.  A character without a glyph is drawn as an open box.
    """
    if not 0 < height_mm < math.inf:
        raise ValueError(f"letter height must be a positive number of mm, not {height_mm!r}")
    d = height_mm * PEN_WIDTH_RATIO
    fineness = max(2, math.ceil(height_mm))
    paths = (
        (x, line)
        for char, x in _line_width_and_places(text)[1]
        for line in _glyph_width_and_paths(char, fineness, slant)[1]
    )
    return tuple(tuple([(z + x) * d for z in line]) for x, line in paths)


Extent = tuple[float, float, float, float, float]


@lru_cache(maxsize=4096)
def _character_box(char: str, fineness: int, slant: bool) -> Extent:
    """Left, low, right and top of the pen path of a character in d, and half the width of its pen."""
    z = [z for line in _glyph_width_and_paths(char, fineness, slant)[1] for z in line]
    x = [one.real for one in z]
    y = [one.imag for one in z]
    return min(x), min(y), max(x), max(y), 0.5 * _character_size(char)


def character_boxes(text: str, height_mm: float, slant: bool = False) -> list[Extent]:
    """Left, low, right and top of the pen path of every character of one line of text, and half the width of its pen,
    in mm."""
    d = height_mm * PEN_WIDTH_RATIO
    fineness = max(2, math.ceil(height_mm))
    every = ((x, _character_box(char, fineness, slant)) for char, x in _line_width_and_places(text)[1])
    return [((x + left) * d, low * d, (x + right) * d, top * d, half * d) for x, (left, low, right, top, half) in every]


@lru_cache(maxsize=2048)
def stroke_pen_widths(text: str, height_mm: float) -> tuple[float, ...]:
    """Width in mm of the pen of each of the strokes: thinner in raised and lowered characters."""
    d = height_mm * PEN_WIDTH_RATIO
    return tuple(
        _character_size(char) * d
        for char, _ in _line_width_and_places(text)[1]
        for _ in _glyph_width_and_paths(char, 5, False)[1]
    )


def line_ink_width(text: str, height_mm: float) -> float:
    """Width in mm of the ink of a line of upright text, from edge to edge, without a gap after it."""
    return _line_width_and_places(text)[0] * PEN_WIDTH_RATIO * height_mm
