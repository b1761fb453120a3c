"""Formats of ГОСТ 2.301, frames with title blocks as marks (ГОСТ 2.104 form 1; ISO 5457 and 7200), and the scene's
texts for their cells."""

import cmath
import math
import re
from bisect import bisect_left
from collections.abc import Mapping, Sequence
from contextlib import AbstractContextManager
from contextvars import ContextVar

from planes.scene import Scene
from planes.words import Lang, say
from planes.words.frozen import field, frozen, replace
from render.labels.footprints import Bounds
from render.paper import form1
from render.paper.form1 import SIDE_CELL_KEYS, Cell, Form
from render.paper.iso7200 import FORMS_BY_NAME
from render.paper.lettering import PEN_WIDTH_RATIO
from render.paper.letters import with_minus_and_decimal_sign
from render.paper.marks import Line, Text, using_setting
from render.paper.symbols import Marks
from render.paper.typeset import ink_width, wrap_text

FORMATS = {
    "A4": (210.0, 297.0),
    "A3": (420.0, 297.0),
    "A2": (594.0, 420.0),
    "A1": (841.0, 594.0),
    "A0": (1189.0, 841.0),
}
"""Width × height in mm; A4 is portrait, the larger ones are landscape."""

_EXTENDED_WIDTHS_MM = {
    297: (630, 841, 1051, 1261, 1471, 1682, 1892),
    420: (891, 1189, 1486, 1783, 2080),
    594: (1261, 1682, 2102),
    841: (1783, 2378),
    1189: (1682, 2523),
}
EXTENDED_FORMATS = {
    f"A{n}x{k}": (max(wide, high), min(wide, high))
    for n, (high, widths) in zip((4, 3, 2, 1, 0), _EXTENDED_WIDTHS_MM.items(), strict=True)
    for k, wide in enumerate(widths, 3 if n else 2)
}
"""The additional formats of ГОСТ 2.301, landscape: A3x3 is three A3 side by side."""

_LETTER_HEIGHTS_MM = (10.0, 7.0, 5.0, 3.5, 2.5, 1.8)  # ГОСТ 2.304; lettering of type B is no lower
_TEXT_SIDE_GAP_MM = 0.9  # from the side of a cell to a text at its left edge
# least distance of a text from the sides of its cell, over the cell's intended letter height
_CELL_CLEARANCE_RATIO = 0.5
_LINE_SPACING_RATIO = 1.6  # line spacing over the letter height
_LEAST_NARROWING = 0.9  # relative: a word is narrowed this far before it gets smaller letters
_WORD_BREAK_PATTERN = re.compile(r"[ \n]+(?!\d)")  # no line begins with a number
# letters of a name that is not divided; the space in it
_MOST_UNDIVIDED_LETTERS = 18
_NO_BREAK_SPACE = "\N{NO-BREAK SPACE}"
_LEAST_HEIGHT_RATIO = 0.7  # of the height of letters in one cell, which differ by a step at most
SENTENCE_SEPARATOR = ".\n"  # between sentences of a cell; each begins a new line if there is room
_LEAST_SIDE_GAP_MM = 0.6  # the least distance of a narrowed text from the sides of its cell


_asked = ContextVar("form", default=form1.GOST_FORM)


def using_form_of_scene(scene: Scene) -> AbstractContextManager[None]:
    """In this context, papers have the frame the scene asks for."""
    return using_setting(_asked, FORMS_BY_NAME[str(scene.sheet.get("frame", form1.GOST_FORM.name))])


@frozen
class Paper:
    """A sheet of a format; the field is inside its frame."""

    name: str
    form: Form = field(default_factory=_asked.get)

    @property
    def size(self) -> tuple[float, float]:
        """Width and height in mm."""
        return (FORMATS | EXTENDED_FORMATS)[self.name]

    @property
    def field(self) -> Bounds:
        """The inside of the frame."""
        edge = self.form.edge
        return self.form.left, edge, self.size[0] - edge, self.size[1] - edge

    @property
    def title_block(self) -> Bounds:
        """The place of the title block: the lower right corner."""
        _, low, right, _ = self.field
        return right - self.form.block[0], low, right, low + self.form.block[1]

    @property
    def occupied_areas(self) -> tuple[Bounds, ...]:
        """Areas of the field not available for views: the title block, and graph 26 in the upper left corner."""
        left, _, _, top = self.field
        wide, high = self.form.top_cell or (0.0, 0.0)
        if high:
            return (self.title_block, (left, top - high, left + wide, top))
        return (self.title_block,)

    def frame_marks(self, cells: Mapping[str, str], lang: Lang = "ru") -> Marks:
        """Frame, title block and the columns beside the frame, with the cells filled."""
        ruled = [Line((a, b), style, "frame") for a, b, style in self.form.lines(self.size)]
        own = [mark for text, cell in self.form.words(self.size, lang) for mark in fit_text_in_cell(text, cell)]
        filled = []
        called = self.name.replace("x", "×")
        said = {**cells, "designation_turned": cells.get("designation", ""), "format": called, "language": lang}
        for key, cell in self.form.cells(self.size).items():
            filled += fit_text_in_cell(said.get(key, ""), cell, f"cell {key}")
        return (replace(frame_line(self.field, "frame"), name=self.form.name), *ruled, *own, *filled)


def frame_line(inside: Bounds, style: str) -> Line:
    """The frame of a sheet."""
    x0, y0, x1, y1 = inside
    return Line((complex(x0, y0), complex(x1, y0), complex(x1, y1), complex(x0, y1)), style, "frame", True)


def fit_text_in_cell(text: str, cell: Cell, name: str = "") -> list[Text]:
    """A text in its cell, wrapped or in smaller letters if it is long, narrowed only if necessary; lines of a cell
    share a name."""
    if not text:
        return []
    wide, high = (cell.height, cell.width) if cell.turn_deg % 180 else (cell.width, cell.height)
    lines, size = _break_to_fit_cell(text, wide, high, cell.letter)
    turn = cmath.rect(1, math.radians(cell.turn_deg))
    middle = cell.middle
    top = (len(lines) - 1) * _LINE_SPACING_RATIO * size / 2 - size / 2
    marks = []
    for k, line in enumerate(lines):
        across = 0.0 if cell.anchor == "middle" else _TEXT_SIDE_GAP_MM - wide / 2
        place = middle + complex(across, top - k * _LINE_SPACING_RATIO * size) * turn
        narrow = min(1.0, (wide - 2 * _LEAST_SIDE_GAP_MM - PEN_WIDTH_RATIO * size) / ink_width(line, size))
        marks.append(
            Text(
                line.replace(_NO_BREAK_SPACE, " "),
                place,
                size,
                cell.anchor,
                cell.turn_deg,
                "frame",
                name,
                narrow=narrow,
            )
        )
    return marks


def _break_to_fit_cell(text: str, wide: float, height: float, letter: float) -> tuple[list[str], float]:
    """The text broken between words at the largest letter height at which it fits the cell, with sentences separate if
    that costs little; if it fits at no height, at the smallest one, divided among as many lines as there is room
    for."""
    sizes = [s for s in _LETTER_HEIGHTS_MM if s <= letter]
    flowing = _largest_fitting_lines([text], wide, height, sizes)
    apart = _largest_fitting_lines(text.split(SENTENCE_SEPARATOR), wide, height, sizes)
    if apart and flowing and apart[1] >= _LEAST_HEIGHT_RATIO * flowing[1]:
        return apart
    return flowing or (_at_most_lines(text, max(1, _line_count(height, sizes[-1])), sizes[-1]), sizes[-1])


def _largest_fitting_lines(
    parts: Sequence[str], wide: float, height: float, sizes: Sequence[float]
) -> tuple[list[str], float] | None:
    """Parts of a text broken between words at the largest of some letter heights at which they fit a cell, a single
    word in a line slightly narrowed; None if they fit at none."""
    width = wide - 2 * max(_CELL_CLEARANCE_RATIO * sizes[0], _LEAST_SIDE_GAP_MM)
    for size in sizes:
        lines = [x for part in parts for x in _even_lines(part, width, size)]
        word = wide - 2 * _LEAST_SIDE_GAP_MM - PEN_WIDTH_RATIO * size
        fits = all(ink_width(x, size) <= (width if " " in x else max(width, word / _LEAST_NARROWING)) for x in lines)
        if fits and _line_count(height, size) >= len(lines):
            return lines, size
    return None


def _even_lines(text: str, width: float, size: float) -> list[str]:
    """A text in as few lines of a width as possible, of roughly equal length."""
    lines = wrap_text(_WORD_BREAK_PATTERN.split(text), width, size)
    if len(lines) > 1:
        return _at_most_lines(text, len(lines), size)
    return lines or [""]


def _at_most_lines(text: str, most: int, size: float) -> list[str]:
    """A text in at most so many lines, the longest as short as possible."""
    halves = range(2 * math.ceil(ink_width(text, size)) + 1)  # in mm, available for the lines
    words = _WORD_BREAK_PATTERN.split(text)
    shortest = bisect_left(halves, True, key=lambda w: len(wrap_text(words, w / 2, size)) <= most)
    return wrap_text(words, halves[shortest] / 2, size)


def _line_count(height: float, size: float) -> int:
    """The number of lines of letters of that height in a cell."""
    return int((height - 0.8 + 0.6 * size) / (_LINE_SPACING_RATIO * size) + 1e-9)


_PEOPLE_CELLS = ("teacher", "tech", "person", "checked", "approved")
_CELLS_NAMED_LIKE_KEYS = (
    *("student", "role", "material", "mass", "copied", *_PEOPLE_CELLS),
    *(f"{person}_date" for person in _PEOPLE_CELLS),
    *SIDE_CELL_KEYS,
)
"""Keys of the scene that are also names of cells."""
_KEYS_OF_COMBINED_CELLS = {
    "student_date": ("date",),
    "scale": ("scale_note",),
    "department": ("department",),
    "document_type": ("document_type",),
    "company": ("company", "university", "department", "group"),
    "owner": ("company", "university", "group"),
}
"""Cells with what the scene says under some keys."""


def cell_texts(scene: Scene, lang: Lang, number: int | None = None) -> dict[str, str]:
    """Texts for the cells of form 1 by name; ``number`` is that of a sheet of a project of two."""
    given = scene.sheet
    said = {key: _value_text(value, lang) for key, value in given.items()}
    texts = {key: said[key] for key in _CELLS_NAMED_LIKE_KEYS if key in said}
    names = {
        key: name.replace(" ", _NO_BREAK_SPACE) if len(name) <= _MOST_UNDIVIDED_LETTERS else name
        for key, name in said.items()
    }
    texts |= {
        cell: " ".join(names[key] for key in keys if said.get(key)) for cell, keys in _KEYS_OF_COMBINED_CELLS.items()
    }
    texts["title"] = said.get("title") or scene.title.get(lang, "")
    if number and "title" not in said:
        texts["title"] = SENTENCE_SEPARATOR.join(filter(None, (texts["title"], say(f"sheet_{number}", lang))))
    texts["designation"] = said.get("designation") or said.get("number", "")
    texts["sheet"] = said.get("sheet", str(number or ""))
    texts["sheets"] = said.get("sheets", "2" if number else "1")
    texts["sheet_of"] = "/".join(texts[key] for key in ("sheet", "sheets") if texts[key])
    letters = given.get("letter", say("study_letter", lang))
    revisions = given.get("revisions")
    for k, letter in enumerate(letters if isinstance(letters, list) else str(letters or "").split(), 1):
        texts[f"letter_{k}"] = _value_text(letter, lang)  # graph 4, filled from its left cell
        texts["status"] = f"{texts.get('status', '')} {texts[f'letter_{k}']}".strip() if "letter" in given else ""
    for k, row in enumerate(revisions if isinstance(revisions, list) else (), 1):  # graphs 14–18, the lowest first
        texts |= {f"revision_{k}_{column}": _value_text(text, lang) for column, text in row.items()}
        texts["revision_last"] = texts.get(f"revision_{k}_change", "")
    return texts


def _value_text(value: object, lang: Lang) -> str:
    if isinstance(value, float):
        return with_minus_and_decimal_sign(f"{value:g}", lang)
    return str(value)
