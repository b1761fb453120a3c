"""Form 1 of ГОСТ 2.104 as data: lines, words and cells of the title block and of the columns around the frame, in mm.

The title block stands in the lower right corner of the frame; graphs 19–23 outside its left side from the lower
corner up, 24 and 25 from the upper corner down, each a column of words 5 mm wide and one of values 7 mm wide; graph 26,
the designation upside down, in the upper left corner of the field.  (It would stand on end in the upper right one of
an upright sheet above A4; the formats here lie, but for A4.)
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import Literal

LEFT, EDGE = 20.0, 5.0  # margins of the frame: left, all others
BLOCK = (185.0, 55.0)  # the title block
TOP_CELL = (70.0, 14.0)  # graph 26

Segment = tuple[complex, complex, Literal["thick", "thin"]]


@dataclass(frozen=True)
class Cell:
    """A cell from its lower left corner (x, y), ``letter`` mm the height of letters it is meant for.

    ``anchor`` says where its text stands, ``turn_deg`` how it is turned: 0, 90 (read from the right) or 180.
    """

    x: float
    y: float
    width: float
    height: float
    letter: float = 2.5
    anchor: Literal["start", "middle"] = "middle"
    turn_deg: float = 0.0

    def at(self, x: float, y: float) -> Cell:
        """The same cell with the origin of its form at a place."""
        return replace(self, x=self.x + x, y=self.y + y)


_THICK = (
    ((0, 0), (0, 55)),
    ((0, 55), (185, 55)),
    ((0, 30), (65, 30)),
    ((0, 35), (65, 35)),
    ((7, 30), (7, 55)),
    ((17, 0), (17, 55)),
    ((40, 0), (40, 55)),
    ((55, 0), (55, 55)),
    ((65, 0), (65, 55)),
    ((65, 15), (185, 15)),
    ((65, 40), (185, 40)),
    ((135, 0), (135, 40)),
    ((135, 20), (185, 20)),
    ((135, 35), (185, 35)),
    ((150, 20), (150, 40)),
    ((155, 15), (155, 20)),
    ((167, 20), (167, 40)),
)
_THIN = (*(((0, y), (65, y)) for y in (5, 10, 15, 20, 25, 40, 45, 50)), ((140, 20), (140, 35)), ((145, 20), (145, 35)))
_WORDS: dict[str, Cell] = {
    "Изм.": Cell(0, 30, 7, 5),
    "Лист": Cell(7, 30, 10, 5),
    "№ докум.": Cell(17, 30, 23, 5),
    "Подп.": Cell(40, 30, 15, 5),
    "Дата": Cell(55, 30, 10, 5),
    "Лит.": Cell(135, 35, 15, 5),
    "Масса": Cell(150, 35, 17, 5),
    "Масштаб": Cell(167, 35, 18, 5),
}
_ROLES: dict[str, tuple[float, str]] = {
    "student": (25, "Разраб."),
    "teacher": (20, "Пров."),
    "tech": (15, "Т. контр."),
    "person": (10, ""),
    "checked": (5, "Н. контр."),
    "approved": (0, "Утв."),
}
"""Who signs: the row's y, the word of its role. The row without one is the scene's to name."""
_COLUMNS = (
    ("change", 0.0, 7.0),
    ("sheet", 7.0, 10.0),
    ("document", 17.0, 23.0),
    ("sign", 40.0, 15.0),
    ("date", 55.0, 10.0),
)
_PLAIN: dict[str, Cell] = {
    "role": Cell(0, 10, 17, 5, 2.5, "start"),
    "designation": Cell(65, 40, 120, 15, 7.0),
    "title": Cell(65, 15, 70, 25, 5.0),
    "material": Cell(65, 0, 70, 15, 5.0),
    "letter_1": Cell(135, 20, 5, 15, 3.5),
    "letter_2": Cell(140, 20, 5, 15, 3.5),
    "letter_3": Cell(145, 20, 5, 15, 3.5),
    "mass": Cell(150, 20, 17, 15, 5.0),
    "scale": Cell(167, 20, 18, 15, 5.0),
    "sheet": Cell(145, 15, 10, 5),
    "sheets": Cell(170, 15, 15, 5),
    "company": Cell(135, 0, 50, 15, 5.0),
}
_SHEETS = {"Лист": Cell(135, 15, 10, 5, 2.5, "start"), "Листов": Cell(155, 15, 15, 5, 2.5, "start")}
LOWER = (
    ("inventory", "Инв. № подл.", 25.0),
    ("inventory_accepted", "Подп. и дата", 35.0),
    ("replaces", "Взам. инв. №", 25.0),
    ("duplicate", "Инв. № дубл.", 25.0),
    ("duplicate_accepted", "Подп. и дата", 35.0),
)
"""Graphs 19–23 from the lower corner up: key, word, height."""
UPPER = (("reference", "Справ. №", 60.0), ("first_use", "Перв. примен.", 60.0))
"""Graphs 24 and 25, the last at the upper corner."""
WORD_WIDE, VALUE_WIDE = 5.0, 7.0  # the two columns of graphs 19–25
REVISIONS = 4  # rows of changes, written from the lowest up

ENGLISH = {
    "Изм.": "Rev.",
    "Лист": "Sheet",
    "№ докум.": "Doc. No.",
    "Подп.": "Sign.",
    "Дата": "Date",
    "Разраб.": "Drawn",
    "Пров.": "Checked",
    "Т. контр.": "Tech.",
    "Н. контр.": "Norm.",
    "Утв.": "Appr.",
    "Лит.": "Lit.",
    "Масса": "Mass",
    "Масштаб": "Scale",
    "Листов": "Sheets",
    "Инв. № подл.": "Inv. No. orig.",
    "Подп. и дата": "Sign. and date",
    "Взам. инв. №": "Repl. inv. No.",
    "Инв. № дубл.": "Inv. No. dupl.",
    "Справ. №": "Ref. No.",
    "Перв. примен.": "First used in",
    "Копировал": "Copied",
    "Формат": "Format",
}

_PROMPTS: dict[str, tuple[str, str]] = {
    "role": ("характер работы (10)", "role (10)"),
    "student": ("разработал (11)", "drawn by (11)"),
    "teacher": ("проверил (11)", "checked by (11)"),
    "tech": ("технологический контроль (11)", "process check (11)"),
    "person": ("фамилия (11)", "name (11)"),
    "checked": ("нормоконтроль (11)", "standards check (11)"),
    "approved": ("утвердил (11)", "approved by (11)"),
    "designation": ("обозначение (2)", "designation (2)"),
    "title": ("наименование (1)", "title (1)"),
    "material": ("материал (3)", "material (3)"),
    "letter": ("литера (4)", "stage (4)"),
    "mass": ("масса (5)", "mass (5)"),
    "scale": ("масштаб (6)", "scale (6)"),
    "sheet": ("номер листа (7)", "sheet (7)"),
    "sheets": ("листов (8)", "sheets (8)"),
    "company": ("организация (9)", "organisation (9)"),
    "revision": ("изменение", "revision"),
    "sign": ("подпись (12)", "signature (12)"),
    "date": ("дата (13)", "date (13)"),
    "inventory": ("инв. № подл. (19)", "inv. No. of the original (19)"),
    "inventory_accepted": ("подп. и дата (20)", "signature and date (20)"),
    "replaces": ("взам. инв. № (21)", "replaces inv. No. (21)"),
    "duplicate": ("инв. № дубл. (22)", "inv. No. of the duplicate (22)"),
    "duplicate_accepted": ("подп. и дата (23)", "signature and date (23)"),
    "reference": ("справ. № (24)", "reference No. (24)"),
    "first_use": ("перв. примен. (25)", "first used in (25)"),
    "designation_turned": ("обозначение (26)", "designation (26)"),
    "copied": ("копировал (31)", "copied by (31)"),
    "format": ("формат (32)", "format (32)"),
    "change": ("изм. (14)", "change (14)"),
    "document": ("№ докум. (16)", "document No. (16)"),
}

Size = tuple[float, float]


def prompt(key: str, lang: str) -> str:
    """What a cell is called when a person is asked to fill it, with the number of its graph."""
    index = 1 if lang == "en" else 0
    if key in _PROMPTS:
        return _PROMPTS[key][index]
    first, *rest = key.split("_")
    return ", ".join([_PROMPTS[first][index], *(_PROMPTS[w][index] if w in _PROMPTS else w for w in rest)])


def lines(size: Size) -> Iterator[Segment]:
    """Every line of the form but the frame itself, on a sheet of that width × height."""
    corner = complex(size[0] - EDGE - BLOCK[0], EDGE)
    for a, b in _THICK:
        yield corner + complex(*a), corner + complex(*b), "thick"
    for a, b in _THIN:
        yield corner + complex(*a), corner + complex(*b), "thin"
    for bottom, rows in ((EDGE, LOWER), (upper_bottom(size), UPPER)):
        yield from _strip(bottom, [high for _, _, high in rows])
    top, right = size[1] - EDGE, LEFT + TOP_CELL[0]
    yield complex(LEFT, top - TOP_CELL[1]), complex(right, top - TOP_CELL[1]), "thick"
    yield complex(right, top - TOP_CELL[1]), complex(right, top), "thick"


def _strip(bottom: float, heights: list[float]) -> Iterator[Segment]:
    """Lines of a column of graphs beside the frame."""
    left, top = LEFT - WORD_WIDE - VALUE_WIDE, bottom + sum(heights)
    for x in (left, left + WORD_WIDE):
        yield complex(x, bottom), complex(x, top), "thick"
    for k in range(len(heights) + 1):
        y = bottom + sum(heights[:k])
        yield complex(left, y), complex(LEFT, y), "thick"


def upper_bottom(size: Size) -> float:
    """Where graph 24 begins: the upper column hangs from the upper corner of the frame."""
    return size[1] - EDGE - sum(high for _, _, high in UPPER)


def words(size: Size) -> Iterator[tuple[str, Cell]]:
    """The words the form has of itself, each with its cell."""
    x, y = size[0] - EDGE - BLOCK[0], EDGE
    for word, cell in (*_WORDS.items(), *_SHEETS.items()):
        yield word, cell.at(x, y)
    for low, word in _ROLES.values():
        if word:
            yield word, Cell(0, low, 17, 5, 2.5, "start").at(x, y)
    for (_, word, _), cell in _beside(size, LEFT - WORD_WIDE - VALUE_WIDE, WORD_WIDE):
        yield word, cell
    yield "Копировал", Cell(x + 65, 0, 30, EDGE, 2.5, "start")
    yield "Формат", Cell(x + 135, 0, 15, EDGE, 2.5, "start")


def cells(size: Size) -> dict[str, Cell]:
    """The cells a person fills, by name, on a sheet of that width × height."""
    x, y = size[0] - EDGE - BLOCK[0], EDGE
    found = dict(_PLAIN)
    for key, (low, _) in _ROLES.items():
        found[key] = Cell(17, low, 23, 5, 2.5, "start")
        found[f"{key}_sign"], found[f"{key}_date"] = Cell(40, low, 15, 5), Cell(55, low, 10, 5)
    for k in range(REVISIONS):
        for name, left, wide in _COLUMNS:
            found[f"revision_{k + 1}_{name}"] = Cell(left, 35 + 5 * k, wide, 5)
    found = {key: cell.at(x, y) for key, cell in found.items()}
    for (key, _, _), cell in _beside(size, LEFT - VALUE_WIDE, VALUE_WIDE):
        found[key] = replace(cell, letter=3.5)
    top = size[1] - EDGE - TOP_CELL[1]
    found["designation_turned"] = Cell(LEFT, top, *TOP_CELL, 7.0, "middle", 180.0)
    found["copied"] = Cell(x + 95, 0, 40, EDGE, 2.5, "start")
    found["format"] = Cell(x + 150, 0, 35, EDGE, 2.5, "start")
    return found


def _beside(size: Size, x: float, wide: float) -> Iterator[tuple[tuple[str, str, float], Cell]]:
    """Rows of the columns beside the frame with their cells of one width."""
    for y, rows in ((EDGE, LOWER), (upper_bottom(size), UPPER)):
        for row in rows:
            yield row, Cell(x, y, wide, row[2], 2.5, "middle", 90.0)
            y += row[2]


def word(text: str, lang: str) -> str:
    """A word of the form in a language."""
    return ENGLISH.get(text, text) if lang == "en" else text
