"""Formats of ГОСТ 2.301, the frame 20/5/5/5 and the title block, form 1 of ГОСТ 2.104 (185 × 55 mm), as marks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from render.labels.footprints import Bounds
from render.marks import Line, Mark, Text
from render.typeset import extent

FORMATS: dict[str, tuple[float, float]] = {
    "A4": (210.0, 297.0),
    "A3": (420.0, 297.0),
    "A2": (594.0, 420.0),
    "A1": (841.0, 594.0),
}
"""Width × height in mm; A4 stands, the larger ones lie."""

LEFT, EDGE = 20.0, 5.0
BLOCK = (185.0, 55.0)

_THICK = (
    ((0, 0), (0, 55)), ((0, 55), (185, 55)), ((0, 30), (65, 30)), ((0, 35), (65, 35)), ((7, 30), (7, 55)),
    ((17, 0), (17, 55)), ((40, 0), (40, 55)), ((55, 0), (55, 55)), ((65, 0), (65, 55)), ((65, 15), (185, 15)),
    ((65, 40), (185, 40)), ((135, 0), (135, 40)), ((135, 20), (185, 20)), ((135, 35), (185, 35)),
    ((150, 20), (150, 40)), ((155, 15), (155, 20)), ((167, 20), (167, 40)),
)  # fmt: skip
_THIN = (
    *(((0, y), (65, y)) for y in (5, 10, 15, 20, 25, 40, 45, 50)),
    ((140, 20), (140, 35)),
    ((145, 20), (145, 35)),
)

_LABELS: tuple[tuple[str, float, float, float, float, str], ...] = (
    ("Изм.", 0, 30, 7, 5, "middle"), ("Лист", 7, 30, 10, 5, "middle"), ("№ докум.", 17, 30, 23, 5, "middle"),
    ("Подп.", 40, 30, 15, 5, "middle"), ("Дата", 55, 30, 10, 5, "middle"), ("Разраб.", 0, 25, 17, 5, "start"),
    ("Пров.", 0, 20, 17, 5, "start"), ("Т. контр.", 0, 15, 17, 5, "start"), ("Н. контр.", 0, 5, 17, 5, "start"),
    ("Утв.", 0, 0, 17, 5, "start"), ("Лит.", 135, 35, 15, 5, "middle"), ("Масса", 150, 35, 17, 5, "middle"),
    ("Масштаб", 167, 35, 18, 5, "middle"),
)  # fmt: skip
_ENGLISH = {
    "Изм.": "Rev.", "Лист": "Sheet", "№ докум.": "Doc. No.", "Подп.": "Sign.", "Дата": "Date", "Разраб.": "Drawn",
    "Пров.": "Checked", "Т. контр.": "Tech.", "Н. контр.": "Norm.", "Утв.": "Appr.", "Лит.": "Lit.",
    "Масса": "Mass", "Масштаб": "Scale", "Листов": "Sheets",
}  # fmt: skip
_CELLS: dict[str, tuple[float, float, float, float, float, str]] = {
    "student": (17, 25, 23, 5, 2.5, "start"),
    "date": (55, 25, 10, 5, 2.5, "middle"),
    "teacher": (17, 20, 23, 5, 2.5, "start"),
    "checked": (17, 5, 23, 5, 2.5, "start"),
    "approved": (17, 0, 23, 5, 2.5, "start"),
    "designation": (65, 40, 120, 15, 7.0, "middle"),
    "title": (65, 15, 70, 25, 5.0, "middle"),
    "material": (65, 0, 70, 15, 5.0, "middle"),
    "letter": (140, 20, 5, 15, 3.5, "middle"),
    "mass": (150, 20, 17, 15, 5.0, "middle"),
    "scale": (167, 20, 18, 15, 5.0, "middle"),
    "sheet": (135, 15, 20, 5, 2.5, "start"),
    "sheets": (155, 15, 30, 5, 2.5, "start"),
    "company": (135, 0, 50, 15, 5.0, "middle"),
}  # x, y, width, height, letter height, where the text stands
_SIZES = (7.0, 5.0, 3.5, 2.5)


@dataclass(frozen=True)
class Paper:
    """A sheet of a format; the field is inside its frame."""

    name: str

    @property
    def size(self) -> tuple[float, float]:
        """Width and height in mm."""
        return FORMATS[self.name]

    @property
    def field(self) -> Bounds:
        """The inside of the frame."""
        return LEFT, EDGE, self.size[0] - EDGE, self.size[1] - EDGE

    @property
    def block(self) -> Bounds:
        """Where the title block stands: in the lower right corner."""
        right = self.size[0] - EDGE
        return right - BLOCK[0], EDGE, right, EDGE + BLOCK[1]

    def marks(self, cells: Mapping[str, str], lang: str = "ru") -> tuple[Mark, ...]:
        """Frame and filled title block."""
        x0, y0, x1, y1 = self.field
        frame = Line((complex(x0, y0), complex(x1, y0), complex(x1, y1), complex(x0, y1)), "frame", "frame", True)
        corner = complex(self.block[0], self.block[1])
        return (frame, *title_block(corner, cells, lang))


def title_block(corner: complex, cells: Mapping[str, str], lang: str = "ru") -> tuple[Mark, ...]:
    """Form 1 with its lower left corner at a place; unknown cells are left out."""
    marks: list[Mark] = []
    for lines, style in ((_THICK, "thick"), (_THIN, "thin")):
        for (xa, ya), (xb, yb) in lines:
            marks.append(Line((corner + complex(xa, ya), corner + complex(xb, yb)), style, "frame"))
    for text, x, y, w, h, anchor in _LABELS:
        marks += _fitted(_word(text, lang), corner, (x, y, w, h), 2.5, anchor)
    for key, text in cells.items():
        if key in _CELLS and text:
            x, y, w, h, letter, anchor = _CELLS[key]
            marks += _fitted(text, corner, (x, y, w, h), letter, anchor)
    return tuple(marks)


def _word(text: str, lang: str) -> str:
    return _ENGLISH.get(text, text) if lang == "en" else text


def sheet_number(lang: str, word: str, value: str) -> str:
    """«Лист 1» in its cell."""
    return f"{_word(word, lang)} {value}".strip()


def _fitted(text: str, corner: complex, cell: Bounds, letter: float, anchor: str) -> list[Mark]:
    """A text in its cell, on several lines or in smaller letters where it is long."""
    x, y, w, h = cell
    sizes = [s for s in _SIZES if s <= letter] or [letter]
    lines, size = _lines(text, w - 1.6, h, sizes)
    high = 1.6 * size
    top = y + h / 2 + (len(lines) - 1) * high / 2 - size / 2
    marks: list[Mark] = []
    for k, line in enumerate(lines):
        left = x + w / 2 if anchor == "middle" else x + 0.9
        place = corner + complex(left, top - k * high)
        marks.append(Text(line, place, _shrunk(line, size, w - 1.2), "middle" if anchor == "middle" else "start"))
    return marks


def _lines(text: str, width: float, height: float, sizes: list[float]) -> tuple[list[str], float]:
    """The text broken between words at the largest letter height at which it fits the cell."""
    for size in sizes:
        lines = _broken(text, width, size)
        fits = all(_wide(line, size) <= width for line in lines)
        if fits and len(lines) * 1.6 * size - 0.6 * size <= height - 0.8:
            return lines, size
    return [text], sizes[-1]


def _broken(text: str, width: float, size: float) -> list[str]:
    lines: list[str] = []
    for word in text.split():
        longer = f"{lines[-1]} {word}" if lines else word
        if lines and _wide(longer, size) <= width:
            lines[-1] = longer
        else:
            lines.append(word)
    return lines or [""]


def _wide(text: str, size: float) -> float:
    x0, _, x1, _ = extent(text, size)
    return x1 - x0


def _shrunk(text: str, size: float, width: float) -> float:
    wide = _wide(text, size)
    return size if wide <= width else size * width / wide
