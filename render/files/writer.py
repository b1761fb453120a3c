"""The common part of file writers, whatever the format: strokes, filled outlines, arcs and texts."""

from abc import ABC, abstractmethod
from collections.abc import Iterable, Sequence

from render.paper.ink import arrow_parts, hatch_strokes, polyline_length_mm
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.paper.style import BLACK_COLOUR, PAPER_COLOUR, fit_dash_pattern, pen_of_style

Lines = Sequence[Sequence[complex]]


class Writer(ABC):
    """Breaks marks down into the four elements that every format must be able to draw."""

    def write_marks(self, marks: Iterable[Mark]) -> None:
        """Every mark, in order."""
        for mark in marks:
            self.mark(mark)

    def mark(self, mark: Mark) -> None:
        """One mark."""
        match mark:
            case Line():
                self.write_strokes([mark.points], mark.style, mark.layer, mark.closed)
            case Arc():
                self.write_arc(mark)
            case Arrow():
                self.write_arrow(mark)
            case Shape():
                self.write_filled_polygon(
                    mark.points, PAPER_COLOUR if mark.fill == "paper" else BLACK_COLOUR, mark.layer
                )
            case Hatch():
                self.write_strokes(hatch_strokes(mark), "thin", mark.layer)
            case Text():
                self.draw_text(mark)

    def write_arrow(self, arrow: Arrow) -> None:
        """Shaft and head."""
        shaft, head = arrow_parts(arrow)
        self.write_strokes([shaft], arrow.style, arrow.layer)
        if head:
            self.write_filled_polygon(head, pen_of_style(arrow.style).colour, arrow.layer)

    @abstractmethod
    def write_strokes(self, lines: Lines, style: str, layer: str, closed: bool = False) -> None:
        """Polylines in one line type."""

    @abstractmethod
    def write_arc(self, arc: Arc) -> None:
        """A circle, an arc, or a filled disc."""

    @abstractmethod
    def write_filled_polygon(self, points: Sequence[complex], colour: str, layer: str) -> None:
        """A filled polygon."""

    @abstractmethod
    def draw_text(self, text: Text) -> None:
        """A text, laid out."""


def fitted_dashes(lines: Lines, style: str, closed: bool = False) -> tuple[float, ...]:
    """The dashes of a line in its style, fitted to its length in mm."""
    return fit_dash_pattern(
        pen_of_style(style).pattern, sum(polyline_length_mm(line, closed) for line in lines), closed
    )
