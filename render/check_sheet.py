"""A person's plan over the right one, and what was found in it: a sheet for printing."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from render.marks import Arc, Arrow, Line, Mark, Text

Vector = tuple[complex, complex]
ROW = 6.5
COLUMNS = (0.0, 25.0, 66.0, 100.0)
VERDICT_STYLE = {"wrong": 2.2, "follows": 1.4, "right": 1.0}


def compose(
    size_mm: tuple[float, float], pole: complex, own: Sequence[Vector], true: Sequence[Vector],
    marks: Mapping[str, tuple[complex, str]], title: str, sentence: Sequence[str], rows: Sequence[Sequence[str]],
) -> list[Mark]:  # fmt: skip
    """Marks of the sheet: the true plan thin, the person's thick, wrong marks ringed, the table of steps beneath."""
    w, h = size_mm
    frame = (20 + 5j, complex(w - 5, 5), complex(w - 5, h - 5), complex(20, h - 5))
    out: list[Mark] = [Line(frame, "thin", "frame", True)]
    out += [Arrow(a + pole, b + pole, "construction", "construction") for a, b in true if abs(b - a) > 0.2]
    out += [Arrow(a + pole, b + pole, "thick", "plan") for a, b in own if abs(b - a) > 0.2]
    for name, (z, verdict) in marks.items():
        if verdict != "right":
            out.append(Arc(z + pole, VERDICT_STYLE.get(verdict, 1.0), style="thick" if verdict == "wrong" else "thin",
                           layer="result"))  # fmt: skip
        out.append(Text(name, z + pole + 1.6 + 1.6j, 3.5))
    out.append(Text("p", pole + complex(-4, -5), 3.5))
    out.append(Text(title, complex(25, h - 14), 5.0))
    out += [Text(line, complex(25, h - 22 - 6 * k), 3.5) for k, line in enumerate(sentence)]
    top = 12 + ROW * len(rows)
    for k, row in enumerate(rows):
        for x, cell in zip(COLUMNS, row, strict=False):
            out.append(Text(cell, complex(25 + x, top - ROW * k), 3.5, layer="table"))
    return out


def wrapped(text: str, length: int = 88) -> list[str]:
    """A sentence in lines of some length."""
    lines, line = [], ""
    for word in text.split():
        if line and len(line) + len(word) + 1 > length:
            lines.append(line)
            line = ""
        line = f"{line} {word}".strip()
    return [*lines, line] if line else lines
