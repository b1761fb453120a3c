"""A line of text with indices, laid out as pen strokes in mm of the sheet.

``v_{CB}`` lowers, ``a^{n}`` raises; both after one base are stacked: ``a_{CB}^{n}``.  Nothing else is markup: a bare
``_`` or ``^`` is drawn literally.
"""

import cmath
import math
import re
from collections.abc import Iterator, Sequence
from functools import lru_cache

from planes.words.frozen import frozen, replace
from render.paper import lettering, outlines
from render.paper.boxes import Box, box_around_letters, box_around_lines
from render.paper.letters import split_indices
from render.paper.marks import Face, Polyline, Text, current_face
from render.paper.style import (
    INDEX_DROP_RATIO,
    INDEX_GAP_RATIO,
    INDEX_HEIGHT_RATIO,
    INDEX_RISE_RATIO,
    LEAST_LETTER_MM,
    LETTER_GAP_RATIO,
    WORD_GAP_RATIO,
)

_OPENED_INDEX_PATTERN = re.compile(r"[_^]\{")


@frozen
class Run:
    """A piece of plain text of one height: ``at`` from the left end of the text's base line, unturned, mm."""

    text: str
    at: complex
    height: float
    width: float


@frozen
class LaidText:
    """A laid-out text: ``strokes`` in sheet mm.

    ``pens`` holds the width of every stroke and ``width`` is the length of the ink, in mm; ``origin`` is the left end
    of the base line on the sheet and ``turn_deg`` its direction.  In an installed font the strokes are closed outlines
    with pens of zero width, to be ``filled`` together by the non-zero rule.
    """

    strokes: tuple[Polyline, ...]
    pens: tuple[float, ...]
    width: float
    runs: tuple[Run, ...]
    origin: complex
    turn_deg: float
    filled: bool = False

    @property
    def plain_text(self) -> str:
        """The text without markup, for reading aloud or searching."""
        return " ".join("".join(run.text for run in self.runs).split())

    def strokes_by_pen_width(self) -> list[tuple[float, list[Polyline]]]:
        """The strokes in groups of one pen width in mm: the letters, then the indices."""
        groups: dict[float, list[Polyline]] = {}
        for pen, stroke in zip(self.pens, self.strokes, strict=True):
            groups.setdefault(pen, []).append(stroke)
        return list(groups.items())


@frozen
class Indexed:
    """A base with its lower and upper index."""

    base: str
    lower: str = ""
    upper: str = ""


def text_box_corners(text: Text) -> Polyline:
    """The four corners of a text's ink after its anchor and its rotation, counter-clockwise; all in one place without
    ink."""
    _, y0, _, y1 = _ink_bounds(text.text, text.height, text.face, text.narrow)
    origin, turn, x0, x1 = _base_line_of_text(text)
    corners = (complex(x0, y0), complex(x1, y0), complex(x1, y1), complex(x0, y1))
    return tuple(origin + z * turn for z in corners)


def _base_line_of_text(text: Text) -> tuple[complex, complex, float, float]:
    """The start of a text mark's base line, its direction, and the interval of ink along it."""
    x0, _, x1, _ = _ink_bounds(text.text, text.height, text.face, text.narrow)
    shift = {"start": -x0, "middle": -(x0 + x1) / 2, "end": -x1}[text.anchor]
    turn = cmath.rect(1, math.radians(text.turn_deg)) if text.turn_deg else 1 + 0j
    return text.place + shift * turn, turn, x0, x1


@lru_cache(maxsize=1000)  # of a sheet: a PNG is drawn as strokes and as SVG
def lay_out_text(text: Text) -> LaidText:
    """Strokes and runs of a text mark after its anchor and its rotation."""
    runs = _lay_out_runs(text.text, text.height, text.face)
    inked = _pen_widths_and_strokes(runs, text.face, text.narrow)
    runs = tuple(_narrow_run(run, text.narrow) for run in runs)
    origin, turn, x0, x1 = _base_line_of_text(text)
    return LaidText(
        strokes=tuple(tuple([origin + z * turn for z in line]) for _, line in inked),
        pens=tuple(pen for pen, _ in inked),
        width=x1 - x0,
        runs=runs,
        origin=origin,
        turn_deg=text.turn_deg,
        filled=bool(text.face.font),
    )


def ink_bounds(text: str, height_mm: float) -> tuple[float, float, float, float]:
    """Bounds (x0, y0, x1, y1) in mm of the ink of a marked-up text from the left end of its base line."""
    return _ink_bounds(text, height_mm, current_face())


def ink_width(text: str, height_mm: float) -> float:
    """Width in mm of the ink of a marked-up text."""
    x0, _, x1, _ = ink_bounds(text, height_mm)
    return x1 - x0


def wrap_text(text: str | Sequence[str], width: float, height_mm: float) -> list[str]:
    """A sentence, or its unbreakable parts, in lines within a given width in mm."""
    lines: list[str] = []
    for word in text.split() if isinstance(text, str) else text:
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and ink_width(longer, height_mm) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines


def overbar_interval(text: str, height_mm: float, rise: float) -> tuple[float, float]:
    """The interval, in mm from the left end of the base line, of a bar ``rise`` mm above a text."""
    face = current_face()
    lean = lettering.SLANT_SHEAR * min(rise, 0.7 * height_mm) if face.slanted else 0.0
    return lean, lean + _run_width(text, height_mm, face)


def plain_text(text: str) -> str:
    """The text without the markup of its indices."""
    return "".join(part.base + part.lower + part.upper for part in bases_with_indices(text))


def bases_with_indices(text: str) -> list[Indexed]:
    """Bases, each with the indices that follow it."""
    parts: list[dict[str, str]] = []
    for piece in split_indices(text):
        side = {"sub": "lower", "sup": "upper"}.get(piece.shift, "base")
        if side == "base" or not parts or parts[-1].get(side):
            parts.append({"base": ""})
        parts[-1][side] = piece.text
    bases = [Indexed(**part) for part in parts]
    for part in bases:
        if _OPENED_INDEX_PATTERN.search(part.base):
            raise ValueError(f"in the text {text!r} an index opened with '_{{' or '^{{' is not closed")
    return bases


def _blank_width_ratios(text: str, face: Face) -> tuple[float, float]:
    """Width over height of the blanks before and after the ink, which lettering leaves out."""
    before = len(text) - len(text.lstrip())
    after = len(text) - len(text.rstrip()) if text.strip() else 0
    blank = outlines.space_width(face.font) if face.font else WORD_GAP_RATIO
    return before * blank, after * blank


def _run_width(text: str, height: float, face: Face) -> float:
    """Width in mm of the ink of a run, as if upright."""
    if face.font:
        return outlines.line_ink_width(text, height, face.font)
    return lettering.line_ink_width(text, height)


def _run_strokes(run: Run, face: Face) -> Iterator[tuple[float, Polyline]]:
    """Pens and strokes of a run in place; a slanted one leans about the base line of the whole text."""
    if not face.font:
        lines = lettering.letter_strokes(run.text, run.height, face.slanted)
        for pen, line in zip(lettering.stroke_pen_widths(run.text, run.height), lines, strict=True):
            yield pen, tuple([run.at + z for z in line])
        return
    shear = lettering.SLANT_SHEAR if face.slanted else 0.0
    for line in outlines.line_contours(run.text, run.height, face.font):
        yield 0.0, tuple([run.at + complex(z.real + shear * z.imag, z.imag) for z in line])


_Inked = tuple[tuple[float, Polyline], ...]


@lru_cache(maxsize=8192)
def _lay_out_runs(text: str, height: float, face: Face) -> tuple[Run, ...]:
    """The runs of a text from the left end of its base line, unturned."""
    if not 0 < height < math.inf:
        raise ValueError(f"the text {text!r} needs a letter height above 0 mm, not {height}")
    runs = []
    x = 0.0
    gap = 0.0
    for part in bases_with_indices(text):
        before, after = (height * blank for blank in _blank_width_ratios(part.base, face))
        x += before or gap
        if part.base.strip():
            runs.append(Run(part.base, complex(x, 0), height, _run_width(part.base, height, face)))
            x += runs[-1].width
        gap = after or LETTER_GAP_RATIO * height
        if part.lower or part.upper:
            x = _set_indices(part, x + (after or (INDEX_GAP_RATIO * height if runs else 0.0)), height, face, runs)
            gap = LETTER_GAP_RATIO * height
    return tuple(runs)


def _narrow_run(run: Run, narrow: float) -> Run:
    """A run with its width multiplied."""
    return replace(run, at=complex(narrow * run.at.real, run.at.imag), width=narrow * run.width)


@lru_cache(maxsize=2048)
def _pen_widths_and_strokes(runs: tuple[Run, ...], face: Face, narrow: float) -> _Inked:
    """Pens with their strokes, all with their width multiplied."""
    inked = (stroke for run in runs for stroke in _run_strokes(run, face))
    if narrow == 1.0:
        return tuple(inked)
    return tuple((pen, tuple([complex(narrow * z.real, z.imag) for z in line])) for pen, line in inked)


@lru_cache(maxsize=16384)
def _ink_bounds(text: str, height: float, face: Face, narrow: float = 1.0) -> Box:
    """Bounds of the ink with half of its pen."""
    runs = _lay_out_runs(text, height, face)
    if face.font:
        return box_around_lines((line, pen / 2) for pen, line in _pen_widths_and_strokes(runs, face, narrow))
    boxes = ((lettering.character_boxes(run.text, run.height, face.slanted), run.at) for run in runs)
    sides = [box_around_letters(letters, at, narrow) for letters, at in boxes]
    left, low, right, top = zip(*sides or [(0.0,) * 4], strict=True)
    return min(left), min(low), max(right), max(top)


def _set_indices(part: Indexed, x: float, height: float, face: Face, runs: list[Run]) -> float:
    """Set the indices of a base at x; returns the x at the end of the wider one. They lean with a slanted base."""
    size = min(height, max(INDEX_HEIGHT_RATIO * height, LEAST_LETTER_MM))
    ends = [x]
    for index, level in ((part.lower, -INDEX_DROP_RATIO), (part.upper, INDEX_RISE_RATIO)):
        if index.strip():
            lean = lettering.SLANT_SHEAR * level * height if face.slanted else 0.0
            runs.append(Run(index, complex(x + lean, level * height), size, _run_width(index, size, face)))
            ends.append(x + runs[-1].width)
    return max(ends)
