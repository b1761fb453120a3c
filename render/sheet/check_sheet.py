"""Sheets of checking: a student's plan over the correct one with the table of its steps."""

import math
from collections.abc import Mapping, Sequence

from planes.geometry.plane import bounding_corners
from planes.words import Lang
from planes.words.frozen import frozen
from render.labels import Label, place_labels
from render.paper.letters import with_minus_and_decimal_sign
from render.paper.marks import Arc, Arrow, Line, Mark, Text, move_mark
from render.paper.photo import Box, Photo, dark_areas, fade_photo
from render.paper.photo import move_photo as shifted
from render.paper.typeset import ink_width, wrap_text
from render.sheet.frame import frame_line
from render.views.table_grid import TableGrid, fold_long_table

Vector = tuple[complex, complex]
Table = tuple[Sequence[str], Sequence[Sequence[str]]]  # head and rows
LEFT_MARGIN_MM, EDGE_MARGIN_MM, PART_GAP_MM = 20.0, 5.0, 5.0  # margins of the sheet, mm, and the gap between its parts
SMALL_LETTER_MM, USUAL_LETTER_MM, TITLE_LETTER_MM = 2.5, 3.5, 5.0
LINE_PITCH_MM, SMALL_LINE_PITCH_MM = 6.5, 4.6
VERDICT_RING_RADIUS_MM = {"wrong": 2.4, "follows": 1.6}
LEAST_VECTOR_MM = 0.2  # a shorter vector is drawn as a point
PLAN_LINE_STYLES = ("own", "truth", "next")
REDUCTIONS = (1.0, 1.25, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 7.5, 10.0, 15.0, 20.0, 50.0, 100.0)


@frozen
class Overlay:
    """The contents: places in mm from the pole, lettered names, words in the sheet's language.

    ``lines`` says that the vectors are links of a scheme; ``next`` leads from a wrong mark to the place that follows
    from the student's own marks; ``photo`` is the student's picture.
    """

    own: Sequence[Vector]
    true: Sequence[Vector]
    next: Sequence[Vector]
    marks: Mapping[str, tuple[complex, str]]  # lettered name -> place and verdict
    along: Mapping[str, Vector]  # lettered names of vectors
    pole: str
    title: str
    sentence: str
    tables: Sequence[Table]
    legend: Sequence[str]
    reduced: str  # "drawn at 1 : {n}"
    lines: bool = False
    notes: Sequence[str] = ()
    photo: Photo | None = None
    lang: Lang = "ru"

    @property
    def drawn_corners(self) -> tuple[complex, complex]:
        """The corners of everything drawn; for an unreadable picture, its own."""
        ends = [z for v in (*self.own, *self.true, *self.next) for z in v]
        if self.photo and not self.marks:
            x0, y0, x1, y1 = self.photo.box
            ends += [complex(x0, y0), complex(x1, y1)]
        return bounding_corners(z for z in (0j, *ends, *(z for z, _ in self.marks.values())) if math.isfinite(abs(z)))


@frozen
class Fit:
    """The part of the sheet for the drawing, its reduction, and the place of its pole."""

    field: Box
    reduction: float
    pole: complex

    def place_on_sheet(self, z: complex) -> complex:
        """A place of the drawing on the sheet."""
        return z / self.reduction + self.pole


def compose_check_sheet(size_mm: tuple[float, float], sheet: Overlay) -> tuple[list[Mark], Photo | None]:
    """Marks of the sheet, and the picture under them: title and sentence on top, tables where they leave most room."""
    w, h = size_mm
    out: list[Mark] = [frame_line((LEFT_MARGIN_MM, EDGE_MARGIN_MM, w - EDGE_MARGIN_MM, h - EDGE_MARGIN_MM), "thick")]
    said, top = _heading_marks(sheet, w, h)
    tables, size = _table_marks(sheet)
    x0 = LEFT_MARGIN_MM + PART_GAP_MM
    x1 = w - EDGE_MARGIN_MM - PART_GAP_MM
    low = EDGE_MARGIN_MM + PART_GAP_MM + 2 * LINE_PITCH_MM
    room = PART_GAP_MM if tables else 0.0
    beside = fit_plans(sheet, (x0, low, x1 - size.real - room, top)), complex(x1 - size.real, top)
    under = fit_plans(sheet, (x0, low + size.imag + room, x1, top)), complex(x0, low + size.imag)
    chosen, corner = min(beside, under, key=lambda way: way[0].reduction)
    out += [
        *said,
        *(move_mark(m, corner) for m in tables),
        *_line_legend(sheet, complex(x0, EDGE_MARGIN_MM + PART_GAP_MM)),
    ]
    if chosen.reduction > 1:
        text = sheet.reduced.format(n=with_minus_and_decimal_sign(f"{chosen.reduction:.3g}", sheet.lang))
        out.append(Text(text, complex(x1, EDGE_MARGIN_MM + PART_GAP_MM), USUAL_LETTER_MM, "end"))
    photo = fade_photo(shifted(sheet.photo, chosen.reduction, chosen.pole), chosen.field) if sheet.photo else None
    return out + _plan_marks(sheet, chosen, photo), photo


def _heading_marks(sheet: Overlay, w: float, h: float) -> tuple[list[Mark], float]:
    """Title, sentence and notes, and the height where they end."""
    left = LEFT_MARGIN_MM + PART_GAP_MM
    top = h - EDGE_MARGIN_MM - PART_GAP_MM
    out = list[Mark]()
    parts = [
        (sheet.sentence, USUAL_LETTER_MM, LINE_PITCH_MM),
        *((note, SMALL_LETTER_MM, SMALL_LINE_PITCH_MM) for note in sheet.notes),
    ]
    for text, letter, line in [(sheet.title, TITLE_LETTER_MM, 2 * TITLE_LETTER_MM), *parts]:
        for words in wrap_text(text, w - left - EDGE_MARGIN_MM - PART_GAP_MM, letter):
            out.append(Text(words, complex(left, top - letter), letter))
            top -= line
    return out, top - PART_GAP_MM / 2


def _table_marks(sheet: Overlay) -> tuple[list[Mark], complex]:
    """The tables one beneath another, their upper left corner at 0; width and height."""
    out = list[Mark]()
    wide = low = 0.0
    for head, rows in sheet.tables:
        if not rows:
            continue
        drawn = TableGrid(SMALL_LETTER_MM).drawn_marks(*fold_long_table(head, rows))
        places = [z for m in drawn if isinstance(m, Line) for z in m.points]
        start = low - PART_GAP_MM if out else 0.0
        out += [move_mark(m, 1j * start) for m in drawn]
        wide = max(wide, *(z.real for z in places))
        low = start + min(z.imag for z in places)
    return out, complex(wide, -low)


def fit_plans(sheet: Overlay, field: Box) -> Fit:
    """The plans in the middle of a field, at full size, or reduced to fit."""
    x0, y0, x1, y1 = field
    low, high = sheet.drawn_corners
    room = complex(max(x1 - x0 - 24, 10), max(y1 - y0 - 16, 10))  # there are letters around the drawing
    if sheet.photo and not sheet.marks:
        room = complex(max(x1 - x0, 10), max(y1 - y0, 10))
    need = max((high - low).real / room.real, (high - low).imag / room.imag)
    reduction = next((n for n in REDUCTIONS if n >= need - 1e-9), need)
    return Fit(field, reduction, complex(x0 + x1, y0 + y1) / 2 - (low + high) / 2 / reduction)


def _plan_marks(sheet: Overlay, fit: Fit, photo: Photo | None) -> list[Mark]:
    """The plans: the student's own, the correct one, and where the student's marks should have led."""
    own, true, leads = (
        [(fit.place_on_sheet(a), fit.place_on_sheet(b)) for a, b in part]
        for part in (sheet.own, sheet.true, sheet.next)
    )
    marks = {n: (fit.place_on_sheet(z), v) for n, (z, v) in sheet.marks.items()}
    drawn = [*_vector_marks(sheet, own, "own"), *_vector_marks(sheet, true, "truth")]
    drawn += [Line(v, "next", "plan") for v in leads] + [Arc(b, 0.8, style="follows", layer="plan") for _, b in leads]
    drawn += [
        Arc(z, VERDICT_RING_RADIUS_MM[v], style=v, layer="result")
        for z, v in marks.values()
        if v in VERDICT_RING_RADIUS_MM
    ]
    labels = [
        Label(n, z, USUAL_LETTER_MM, clear=VERDICT_RING_RADIUS_MM.get(v, 0.5))
        for n, (z, v) in marks.items()
        if n not in sheet.along
    ]
    labels += [
        Label(n, (fit.place_on_sheet(a), fit.place_on_sheet(b)), USUAL_LETTER_MM)
        for n, (a, b) in sheet.along.items()
        if abs(b - a) > LEAST_VECTOR_MM
    ]
    if (sheet.own or sheet.true) and not sheet.lines:  # a scheme has no pole
        labels.append(Label(sheet.pole, fit.place_on_sheet(0j), USUAL_LETTER_MM, priority=1))
    ink = [*drawn, *(dark_areas(photo, [*own, *true]) if photo else ())]
    return [*drawn, *place_labels(labels, ink, fit.field).marks]


def _vector_marks(sheet: Overlay, vectors: Sequence[Vector], style: str) -> list[Mark]:
    """The vectors, or links of a scheme, that are long enough to see."""
    seen = [(a, b) for a, b in vectors if abs(b - a) > LEAST_VECTOR_MM]
    return [Line(two, style, "plan") if sheet.lines else Arrow(*two, style, "plan") for two in seen]


def _line_legend(sheet: Overlay, corner: complex) -> list[Mark]:
    """What the kinds of lines mean."""
    out = list[Mark]()
    for name, style, shown in zip(sheet.legend, PLAN_LINE_STYLES, (sheet.own, sheet.true, sheet.next), strict=True):
        if shown:
            out.append(Line((corner + USUAL_LETTER_MM * 0.5j, corner + 12 + USUAL_LETTER_MM * 0.5j), style, "text"))
            out.append(Text(name, corner + 14, USUAL_LETTER_MM))
            corner += 14 + ink_width(name, USUAL_LETTER_MM) + 8
    return out
