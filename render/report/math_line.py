"""A formula for a PDF: letters of embedded fonts where mathtext puts them; it can be searched and copied."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import TYPE_CHECKING, Any

from matplotlib.font_manager import FontProperties
from matplotlib.mathtext import MathTextParser

from render.files.pdf import register_font

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas


@dataclass(frozen=True)
class MathLine:
    """``letters`` are font, size, letter and place, ``bars`` corner, width and height, from the left of the base line;
    points."""

    width: float
    height: float
    depth: float
    letters: tuple[tuple[str, float, str, float, float], ...]
    bars: tuple[tuple[float, float, float, float], ...]

    def draw(self, canvas: Canvas) -> None:
        """Draw with the lower left corner in the origin."""
        canvas.setFillColorRGB(0, 0, 0)  # the head of a page is grey
        canvas.translate(0, self.depth)
        for font, size, letter, x, y in self.letters:
            canvas.setFont(register_font(Path(font).stem, Path(font)), size)
            canvas.drawString(x, y, letter)
        for x, y, width, height in self.bars:
            canvas.rect(x, y, width, height, stroke=0, fill=1)


@lru_cache(maxsize=2000)
def math_line(tex: str, size: float) -> MathLine:
    """A formula at a letter size in points."""
    face = FontProperties(family="DejaVu Serif", size=size, math_fontfamily="dejavuserif")
    made: Any = MathTextParser("path").parse(f"${tex}$", 72, face)
    letters = (
        (font.fname, float(size), chr(code), x, y) for font, size, code, *_, x, y in made.glyphs
    )  # five or six, by the version
    bars = tuple((float(x), float(y), float(w), float(h)) for x, y, w, h in made.rects)
    return MathLine(made.width, made.height, made.depth, tuple(letters), bars)


def break_formula(parts: Sequence[str], size: float, width: float) -> list[MathLine]:
    """A formula in lines of that width, broken at its signs, which the next line repeats (ГОСТ 7.32-2017, 6.8.2)."""
    line = math_line("".join(parts), size)
    if line.width <= width:
        return [line]
    lines = [""]
    room = width
    for part in parts:
        need = math_line(f"{{}}{part}", size).width  # its sign stands between two terms
        if lines[-1] and need > room:
            lines[-1] += part[0] if part[0] in "=+-" else ""
            lines = [*lines, ""]
            room = width
        lines[-1] += part
        room -= need
    return [math_line(text, size) for text in lines]
