"""A blank to draw a plan on: a sheet with corner marks a camera finds, the frame, the pole, μ and the title."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from render.paper.marks import Line, Mark, Shape, Text

LETTER = 5.0


def compose(
    size_mm: tuple[float, float],
    squares: Iterable[tuple[complex, Sequence[Sequence[bool]], float]],
    pole: complex,
    texts: Sequence[str],
) -> list[Mark]:
    """The marks of a blank. ``squares`` are (centre, black cells from the top row, side in mm)."""
    w, h = size_mm
    frame = (20 + 5j, complex(w - 5, 5), complex(w - 5, h - 5), complex(20, h - 5))
    out: list[Mark] = [Line(frame, "thin", "frame", True)]
    for centre, cells, side in squares:
        out += _square(centre, cells, side)
    out += [Line((pole - d, pole + d), "thin", "plan") for d in (2 + 0j, 2j)]
    out.append(Text("p", pole + complex(-5, -6), LETTER, name="p"))
    for k, text in enumerate(texts):
        out.append(Text(text, complex(38, h - 14 - 7.5 * k), 3.5 if k else LETTER))
    return out


def _square(centre: complex, cells: Sequence[Sequence[bool]], side: float) -> list[Mark]:
    """A corner mark as runs of black cells."""
    step = side / len(cells)
    corner = centre + complex(-side, side) / 2
    out: list[Mark] = []
    for r, row in enumerate(cells):
        c = 0
        while c < len(row):
            end = c
            while end < len(row) and row[end]:
                end += 1
            if end > c:
                out.append(_box(corner + complex(c * step, -(r + 1) * step), (end - c) * step, step))
            c = max(end, c + 1)
    return out


def _box(z: complex, width: float, height: float) -> Shape:
    over = 0.02  # no hair of white between two boxes
    return Shape((z - 1j * over, z + width - 1j * over, z + complex(width, height), z + 1j * height), "frame")
