"""A table as marks: a head, rows between thin lines, numbers of one unit aligned by their decimal signs."""

import re
from collections.abc import Sequence
from itertools import groupby

from planes.words.frozen import frozen
from render.paper.marks import Arc, Line, Mark, Shape, Text
from render.paper.style import arrowhead_corners as ink_head
from render.paper.symbols import Marks, unit_vector
from render.paper.typeset import ink_bounds, ink_width

Row = Sequence[str]
TEXT_RULE_GAP_MM = 0.65  # least distance of a text from the lines above and beneath it
MOST_ROWS_PER_COLUMN = 18  # of a table in one column
_NUMBER_PATTERN = re.compile(r"([−-]?\d+)(?:[.,]\d*)?(?:·10.*)?[↺↻]?$")
_SENSE_SIGNS = {"↺": 1.0, "↻": -1.0}


@frozen
class TableGrid:
    """A table under construction: letters of ``letter`` mm, the head's names in the first row; where it is ``spanned``
    a cell extends down over empty ones."""

    letter: float = 3.5
    spanned: bool = False

    def drawn_marks(self, head: Row, rows: Sequence[Row]) -> Marks:
        """The marks of a table with its upper left corner at the origin."""
        lines = [head, *rows] if any(head) else list(rows)
        high, drop = self.row_height_and_base(lines)
        pad = 0.5 * self.letter
        columns = [self.aligned_left_edges([row[k] for row in lines], any(head)) for k in range(len(lines[0]))]
        widths = [
            max(x + self.cell_width(row[k]) for x, row in zip(left, lines, strict=True)) + 2 * pad
            for k, left in enumerate(columns)
        ]
        edges = [sum(widths[:k]) for k in range(len(widths) + 1)]
        marks = list[Mark]()
        for level in range(len(lines) + 1):
            style = "rule" if level == 1 and any(head) else "thin"
            row = lines[level] if self.spanned and 1 < level < len(lines) else head
            shut = [k for k, cell in enumerate(row) if cell or row is head]
            for _, run in groupby(enumerate(shut), key=lambda two: two[1] - two[0]):
                ks = [k for _, k in run]
                ends = complex(edges[ks[0]], -level * high), complex(edges[ks[-1] + 1], -level * high)
                marks.append(Line(ends, style, "table"))
        for edge in edges:
            marks.append(Line((complex(edge, 0), complex(edge, -len(lines) * high)), "thin", "table"))
        for level, row in enumerate(lines):
            base = -(level + 0.5) * high - drop
            for k, cell in enumerate(row):
                marks += self.cell_marks(cell, complex(edges[k] + pad + columns[k][level], base))
        return tuple(marks)

    def aligned_left_edges(self, column: Row, alike: bool) -> list[float]:
        """The left edges of a column's texts: numbers of one unit aligned by their decimal signs, others centred."""
        wide = list(map(self.cell_width, column))
        whole_parts = [
            ink_width(m[1], self.letter) if alike and (m := _NUMBER_PATTERN.match(cell)) else 0.0 for cell in column
        ]
        most = max(whole_parts)
        block = max((most - x + w for x, w in zip(whole_parts, wide, strict=True) if x), default=0.0)
        room = max(block, *wide)
        return [(room - block) / 2 + most - x if x else (room - w) / 2 for x, w in zip(whole_parts, wide, strict=True)]

    def row_height_and_base(self, lines: Sequence[Row]) -> tuple[float, float]:
        """Height of the rows: two letters, more where indices would come near a line; the base line beneath their
        middle."""
        boxes = [ink_bounds(cell.rstrip("↺↻"), self.letter) for row in lines for cell in row]
        low = min(b[1] for b in boxes)
        top = max(b[3] for b in boxes)
        high = max(2.0 * self.letter, top - low + 2 * TEXT_RULE_GAP_MM)
        return high, min(max(0.35 * self.letter, top + TEXT_RULE_GAP_MM - high / 2), high / 2 - TEXT_RULE_GAP_MM + low)

    def cell_width(self, cell: str) -> float:
        """Width of a cell's ink."""
        return ink_width(cell.rstrip("↺↻"), self.letter) + (self.letter * 1.5 if cell[-1:] in _SENSE_SIGNS else 0.0)

    def cell_marks(self, cell: str, left: complex) -> Marks:
        """A text at a place, followed by a curved arrow for a sense of rotation."""
        sense = _SENSE_SIGNS.get(cell[-1:])
        text = cell.rstrip("↺↻")
        if sense is None:
            return (Text(text, left, self.letter),) if text.strip() else ()
        radius = 0.48 * self.letter
        turn = left + self.cell_width(cell) - radius + 0.5j * self.letter
        low, high = (-60.0, 180.0) if sense > 0 else (0.0, 240.0)
        tip = turn + radius * unit_vector(high if sense > 0 else low)
        head = ink_head(tip, -1j, 0.5 * self.letter, 0.3 * self.letter)
        return (Text(text, left, self.letter), Arc(turn, radius, low, high, "thin", "table"), Shape(head, "table"))


def fold_long_table(head: Row, rows: Sequence[Row]) -> tuple[Row, list[Row]]:
    """A long table in two or more columns side by side."""
    columns = -(-len(rows) // MOST_ROWS_PER_COLUMN)
    if columns < 2:
        return head, list(rows)
    high = -(-len(rows) // columns)
    parts = [[*rows[k * high : (k + 1) * high]] for k in range(columns)]
    parts[-1] += [[""] * len(head)] * (high - len(parts[-1]))
    return [*head] * columns, [[cell for row in line for cell in row] for line in zip(*parts, strict=True)]
