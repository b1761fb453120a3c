"""Boxes around ink, in mm: around lines drawn with a pen, and around letters without drawing them."""

from collections.abc import Iterable, Sequence

import numpy

Box = tuple[float, float, float, float]
"""x0, y0, x1, y1."""


def box_around_lines(lines: Iterable[tuple[Sequence[complex], float]]) -> Box:
    """The box around lines, each with half the width of its pen; of zero size without lines."""
    held = list(lines)
    if not held:
        return 0.0, 0.0, 0.0, 0.0
    z = numpy.array([z for line, _ in held for z in line])
    half = numpy.repeat([half for _, half in held], [len(line) for line, _ in held])
    x = z.real
    y = z.imag
    return float((x - half).min()), float((y - half).min()), float((x + half).max()), float((y + half).max())


def box_around_letters(
    letters: Sequence[tuple[float, float, float, float, float]], at: complex, narrow: float = 1.0
) -> Box:
    """The box around letters with these bounds of the pen path, each with half the width of its pen, moved to a place
    and then stretched in width."""
    return (
        min(narrow * (left + at.real) - half for left, _, _, _, half in letters),
        min(low + at.imag - half for _, low, _, _, half in letters),
        max(narrow * (right + at.real) + half for _, _, right, _, half in letters),
        max(top + at.imag + half for _, _, _, top, half in letters),
    )
