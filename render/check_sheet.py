"""A person's plan over the right one, the table of its steps and what was found in it: a sheet for printing."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from render.labels import Label, place
from render.marks import Arc, Arrow, Line, Mark, Text, moved
from render.typeset import extent
from render.views.tables import Grid

Vector = tuple[complex, complex]
LEFT, EDGE, GAP = 20.0, 5.0, 5.0  # margins of the sheet, mm, and the room between its parts
SMALL, LETTER, TITLE = 2.5, 3.5, 5.0
LINE = 6.5
RING = {"wrong": 2.4, "follows": 1.6}
REDUCTIONS = (1.0, 2.0, 2.5, 4.0, 5.0, 10.0, 20.0, 50.0, 100.0)


@dataclass(frozen=True)
class Overlay:
    """What is drawn: places in mm from the pole, names as they are lettered, words in the sheet's language.

    ``lines`` tells that the vectors are links of a scheme; ``next`` leads from a wrong mark to where the person's own
    marks lead.
    """

    own: Sequence[Vector]
    true: Sequence[Vector]
    next: Sequence[Vector]
    marks: Mapping[str, tuple[complex, str]]  # lettered name -> place and verdict
    along: Mapping[str, Vector]  # lettered names of vectors
    pole: str
    title: str
    sentence: str
    head: Sequence[str]
    rows: Sequence[Sequence[str]]
    legend: tuple[str, str, str]
    reduced: str  # "drawn at 1 : {n}"
    lines: bool = False


def compose(size_mm: tuple[float, float], sheet: Overlay) -> list[Mark]:
    """Marks of the sheet: title and sentence on top, the table at the right, the drawing in the rest."""
    w, h = size_mm
    corners = (complex(LEFT, EDGE), complex(w - EDGE, EDGE), complex(w - EDGE, h - EDGE), complex(LEFT, h - EDGE))
    out: list[Mark] = [Line(corners, "thick", "frame", True)]
    table = Grid(SMALL).drawn(sheet.head, sheet.rows) if sheet.rows else ()
    wide = max((z.real for m in table if isinstance(m, Line) for z in m.points), default=0.0)
    out.append(Text(sheet.title, complex(LEFT + GAP, h - EDGE - GAP - TITLE), TITLE))
    said = wrapped(sheet.sentence, w - LEFT - EDGE - 2 * GAP, LETTER)
    top = h - EDGE - GAP - TITLE - GAP
    out += [Text(line, complex(LEFT + GAP, top - LINE * k - LETTER), LETTER) for k, line in enumerate(said)]
    top -= LINE * len(said) + GAP
    out += [moved(m, complex(w - EDGE - GAP - wide, top)) for m in table]
    right = w - EDGE - GAP - (wide + GAP if table else 0.0)
    low = EDGE + GAP + 2 * LINE
    out += _legend(sheet, complex(LEFT + GAP, EDGE + GAP))
    return out + _drawing(sheet, (LEFT + GAP, low, right, top))


def _drawing(sheet: Overlay, field: tuple[float, float, float, float]) -> list[Mark]:
    """The plans, as large as they are, or reduced to fit."""
    x0, y0, x1, y1 = field
    places = [0j, *(z for v in (*sheet.own, *sheet.true) for z in v), *(z for z, _ in sheet.marks.values())]
    places = [z for z in places if math.isfinite(abs(z))]
    low = complex(min(z.real for z in places), min(z.imag for z in places))
    high = complex(max(z.real for z in places), max(z.imag for z in places))
    room = complex(x1 - x0 - 24, y1 - y0 - 16)  # letters stand about the drawing
    need = max((high - low).real / room.real, (high - low).imag / room.imag)
    reduction = next((n for n in REDUCTIONS if n >= need), need)
    shift = complex(x0 + x1, y0 + y1) / 2 - (low + high) / 2 / reduction

    def at(z: complex) -> complex:
        return z / reduction + shift

    out: list[Mark] = [_stroke(sheet, at(a), at(b), "dash") for a, b in sheet.true if abs(b - a) > 0.2]
    strokes: list[Mark] = [_stroke(sheet, at(a), at(b), "thick") for a, b in sheet.own if abs(b - a) > 0.2]
    strokes += [Line((at(a), at(b)), "thin", "construction") for a, b in sheet.next]
    strokes += [Arc(at(b), 0.8, style="thin", layer="construction") for _, b in sheet.next]
    rings: list[Mark] = [Arc(at(z), RING[v], style="thick" if v == "wrong" else "thin", layer="result")
                         for z, v in sheet.marks.values() if v in RING]  # fmt: skip
    labels = [Label(n, at(z), LETTER, clear=RING.get(v, 0.5)) for n, (z, v) in sheet.marks.items()
              if n not in sheet.along]  # fmt: skip
    labels += [Label(n, (at(a), at(b)), LETTER) for n, (a, b) in sheet.along.items() if abs(b - a) > 0.2]
    labels.append(Label(sheet.pole, at(0j), LETTER, priority=1))
    out += [*strokes, *rings, *place(labels, [*strokes, *rings], field, out).marks]
    if reduction > 1:
        out.append(Text(sheet.reduced.format(n=f"{reduction:.3g}"), complex(x1, y0 - LINE), LETTER, "end"))
    return out


def over_picture(sheet: Overlay, corner: complex) -> dict[str, list[Mark]]:
    """The same over a picture whose lower left corner is at ``corner``, mm from the pole: marks by their colour."""

    def shifted(vectors: Sequence[Vector], style: str) -> list[Mark]:
        return [_stroke(sheet, a - corner, b - corner, style) for a, b in vectors if abs(b - a) > 0.2]

    rings: list[Mark] = [Arc(z - corner, RING["wrong"]) for z, v in sheet.marks.values() if v == "wrong"]
    labels = [Label(n, z - corner, LETTER, clear=1.0) for n, (z, _) in sheet.marks.items() if n not in sheet.along]
    labels += [Label(n, (a - corner, b - corner), LETTER) for n, (a, b) in sheet.along.items() if abs(b - a) > 0.2]
    own = shifted(sheet.own, "thin")
    return {
        "#1f7a3d": shifted(sheet.true, "dash"),
        "#a35c00": [Line((a - corner, b - corner), "dash", "construction") for a, b in sheet.next],
        "#163a70": [*own, *place(labels, [*own, *rings]).marks],
        "#b3201a": rings,
    }


def _stroke(sheet: Overlay, a: complex, b: complex, style: str) -> Mark:
    return Line((a, b), style, "plan") if sheet.lines else Arrow(a, b, style, "plan")


def _legend(sheet: Overlay, corner: complex) -> list[Mark]:
    """What the kinds of lines mean."""
    out: list[Mark] = []
    for name, style in zip(sheet.legend, ("thick", "dash", "thin"), strict=True):
        if style == "thin" and not sheet.next:
            continue
        out.append(Line((corner + LETTER * 0.5j, corner + 12 + LETTER * 0.5j), style, "text"))
        out.append(Text(name, corner + 14, LETTER))
        x0, _, x1, _ = extent(name, LETTER)
        corner += 14 + x1 - x0 + 8
    return out


def wrapped(text: str, width: float, letter: float) -> list[str]:
    """A sentence in lines no wider than so many mm."""
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and extent(longer, letter)[2] <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines
