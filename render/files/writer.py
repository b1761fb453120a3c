"""The common part of file writers, whatever the format: strokes, filled outlines, arcs and texts."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence

from render.paper.ink import arrow_parts, hatch_strokes, length_mm
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.paper.style import BLACK, PAPER, fitted, pen

Lines = Sequence[Sequence[complex]]


class Writer(ABC):
    """Breaks marks down into the four elements that every format must be able to draw."""

    def all(self, marks: Iterable[Mark]) -> None:
        """Every mark, in order."""
        for mark in marks:
            self.mark(mark)

    def mark(self, mark: Mark) -> None:
        """One mark."""
        match mark:
            case Line():
                self.strokes([mark.points], mark.style, mark.layer, mark.closed)
            case Arc():
                self.arc(mark)
            case Arrow():
                self.arrow(mark)
            case Shape():
                self.filled(mark.points, PAPER if mark.fill == "paper" else BLACK, mark.layer)
            case Hatch():
                self.strokes(hatch_strokes(mark), "thin", mark.layer)
            case Text():
                self.text(mark)

    def arrow(self, arrow: Arrow) -> None:
        """Shaft and head."""
        shaft, head = arrow_parts(arrow)
        self.strokes([shaft], arrow.style, arrow.layer)
        if head:
            self.filled(head, pen(arrow.style).colour, arrow.layer)

    @abstractmethod
    def strokes(self, lines: Lines, style: str, layer: str, closed: bool = False) -> None:
        """Polylines in one line type."""

    @abstractmethod
    def arc(self, arc: Arc) -> None:
        """A circle, an arc, or a filled disc."""

    @abstractmethod
    def filled(self, points: Sequence[complex], colour: str, layer: str) -> None:
        """A filled polygon."""

    @abstractmethod
    def text(self, text: Text) -> None:
        """A text, laid out."""


def dashes_of(lines: Lines, style: str, closed: bool = False) -> tuple[float, ...]:
    """The dashes of a line in its style, fitted to its length in mm."""
    return fitted(pen(style).pattern, sum(length_mm(line, closed) for line in lines), closed)
