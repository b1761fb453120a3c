"""Form 1 of ГОСТ 2.104: its lines and cells, the columns beside the frame, and what fills them."""

from __future__ import annotations

import cmath
import math
from itertools import combinations

import pytest

from planes.documents.sheets import sheet_of
from planes.scene import loads
from render.paper import form1
from render.paper.marks import Line, Text
from render.paper.typeset import ink_bounds, lay_out_text, text_box_corners
from render.sheet.frame import FORMATS, Paper, fit_text_in_cell
from tests.helpers.conflicts import conflicts
from tests.helpers.scene_texts import SIX_LINK

SIZES = list(FORMATS.values())


def corner(size):
    return complex(size[0] - 5 - 185, 5)


def own_lines(size):
    """Lines of the title block from its lower left corner, with their kinds."""
    at = corner(size)
    inside = [(a - at, b - at, kind) for a, b, kind in form1.form_lines(size) if a.real >= at.real and a.imag <= 60]
    return {(round(a.real), round(a.imag), round(b.real), round(b.imag), kind) for a, b, kind in inside}


def test_the_title_block_has_the_lines_of_the_standard():
    assert own_lines((420, 297)) == {
        (0, 0, 0, 55, "thick"),
        (0, 55, 185, 55, "thick"),
        (0, 30, 65, 30, "thick"),
        (0, 35, 65, 35, "thick"),
        (7, 30, 7, 55, "thick"),
        (17, 0, 17, 55, "thick"),
        (40, 0, 40, 55, "thick"),
        (55, 0, 55, 55, "thick"),
        (65, 0, 65, 55, "thick"),
        (65, 15, 185, 15, "thick"),
        (65, 40, 185, 40, "thick"),
        (135, 0, 135, 40, "thick"),
        (135, 20, 185, 20, "thick"),
        (135, 35, 185, 35, "thick"),
        (150, 20, 150, 40, "thick"),
        (155, 15, 155, 20, "thick"),
        (167, 20, 167, 40, "thick"),
        (140, 20, 140, 35, "thin"),
        (145, 20, 145, 35, "thin"),
        *((0, y, 65, y, "thin") for y in (5, 10, 15, 20, 25, 40, 45, 50)),
    }


@pytest.mark.parametrize("size", SIZES)
def test_no_line_runs_through_a_cell(size):
    lines = list(form1.form_lines(size))
    cells = [*form1.fill_in_cells(size).values(), *(cell for _, cell in form1.printed_words(size, "ru"))]
    for cell in cells:
        for a, b, _ in lines:
            x0, x1 = sorted((a.real, b.real))
            y0, y1 = sorted((a.imag, b.imag))
            apart = (
                x1 <= cell.x + 1e-9,
                x0 >= cell.x + cell.width - 1e-9,
                y1 <= cell.y + 1e-9,
                y0 >= cell.y + cell.height - 1e-9,
            )
            assert any(apart), cell


@pytest.mark.parametrize("size", SIZES)
def test_the_cells_tile_the_form(size):
    """Cells and words cover the block 185 × 55 and the columns of 12 mm beside the frame, and none lies on another."""
    cells = [*form1.fill_in_cells(size).values(), *(cell for _, cell in form1.printed_words(size, "ru"))]
    for a, b in combinations(cells, 2):
        apart = (a.x + a.width - b.x, b.x + b.width - a.x, a.y + a.height - b.y, b.y + b.height - a.y)
        assert min(apart) <= 1e-9, (a, b)
    at = corner(size)
    area = {"block": 0.0, "beside": 0.0}
    for cell in cells:
        if cell.x + cell.width <= 20:
            area["beside"] += cell.width * cell.height
        elif cell.x >= at.real and cell.y >= 5 and cell.y < 60:
            area["block"] += cell.width * cell.height
    assert area == pytest.approx({"block": 185 * 55, "beside": 12 * (145 + 120)})


@pytest.mark.parametrize("name", list(FORMATS))
def test_the_columns_stand_where_the_standard_puts_them(name):
    paper = Paper(name)
    cells, high = form1.fill_in_cells(paper.size), paper.size[1]
    beside = {k: (c.x, c.y, c.width, c.height) for k, c in cells.items() if c.turn_deg == 90}
    assert beside == {
        "inventory": (13, 5, 7, 25),
        "inventory_accepted": (13, 30, 7, 35),
        "replaces": (13, 65, 7, 25),
        "duplicate": (13, 90, 7, 25),
        "duplicate_accepted": (13, 115, 7, 35),
        "reference": (13, high - 125, 7, 60),
        "first_use": (13, high - 65, 7, 60),
    }
    top = cells["designation_turned"]
    assert (top.x, top.y + top.height, top.width, top.height, top.turn_deg) == (20, high - 5, 70, 14, 180)
    assert paper.occupied_areas[1] == (20, high - 19, 90, high - 5)


EVERY = {
    "student": "Иванов И. И.",
    "teacher": "Петров П. П.",
    "tech": "Сидоров С. С.",
    "role": "Консульт.",
    "person": "Кузнецов К. К.",
    "checked": "Норман Н. Н.",
    "approved": "Главный Г. Г.",
    "date": "12.05.26",
    "teacher_date": "13.05.26",
    "checked_date": "14.05.26",
    "approved_date": "15.05.26",
    "tech_date": "16.05.26",
    "person_date": "17.05.26",
    "designation": "ТММ.01.12.000",
    "material": "Сталь 45",
    "mass": "12.5",
    "scale_note": "'1:4'",
    "company": "БНТУ",
    "group": "103518",
    "letter": "[О, О1]",
    "sheet": "1",
    "sheets": "2",
    "inventory": "'12345'",
    "inventory_accepted": "01.06.26",
    "replaces": "'321'",
    "duplicate": "'777'",
    "duplicate_accepted": "01.07.26",
    "reference": "ТММ.01.00.000",
    "first_use": "ТММ.01.12.000 СБ",
    "copied": "Иванова",
    "title": "Шестизвенный рычажный механизм",
    "revisions": "[['1', Зам., АБВ.1-26, '', 01.06.26], {change: '2', document: АБВ.2-26}]",
}


def sheet(lang="ru", **settings):
    said = ", ".join(f"{key}: {value}" for key, value in settings.items())
    text = SIX_LINK.replace("find:", "# find:").replace("friction:", "# friction:")
    return sheet_of(loads(text + f"\nsheet: {{{said}}}\n"), None, lang)


def said_of(found):
    cells = {}
    for mark in found.marks:
        if isinstance(mark, Text) and mark.name.startswith("cell "):
            key = mark.name.removeprefix("cell ")
            cells[key] = f"{cells[key]} {mark.text}" if key in cells else mark.text
    return cells


def test_every_cell_is_filled_from_the_scene_and_fits():
    found = sheet(**EVERY)
    said = said_of(found)
    same = set(EVERY) - {"date", "scale_note", "company", "group", "letter", "revisions", "mass"}
    assert {key: said[key] for key in same} == {key: EVERY[key].strip("'") for key in same}
    assert (said["student_date"], said["scale"], said["company"], said["mass"]) == (
        "12.05.26",
        "1:4",
        "БНТУ 103518",
        "12,5",
    )
    assert (said["letter_1"], said["letter_2"], "letter_3" in said) == ("О", "О1", False)
    assert (said["revision_1_sheet"], said["revision_1_date"], said["revision_2_document"]) == (
        "Зам.",
        "01.06.26",
        "АБВ.2-26",
    )
    assert said["designation_turned"] == said["designation"] == "ТММ.01.12.000"
    assert said["format"] == found.paper.name
    cells = form1.fill_in_cells(found.size)
    for mark in (m for m in found.marks if isinstance(m, Text) and m.name.startswith("cell ")):
        cell = cells[mark.name.removeprefix("cell ")]
        xs, ys = [z.real for z in text_box_corners(mark)], [z.imag for z in text_box_corners(mark)]
        assert cell.x < min(xs) and max(xs) < cell.x + cell.width, mark.text
        assert cell.y < min(ys) and max(ys) < cell.y + cell.height, mark.text
    frame = [m for m in found.marks if m.layer == "frame"]
    assert conflicts((), frame, (0, 0, *found.size)) == ()


def test_graph_26_is_upside_down_and_the_columns_are_read_from_the_right():
    turned = {m.name: m.turn_deg for m in sheet(**EVERY).marks if isinstance(m, Text)}
    assert (turned["cell designation_turned"], turned["cell designation"]) == (180, 0)
    assert turned["cell inventory"] == turned["cell first_use"] == 90


@pytest.mark.slow
def test_words_of_the_form_are_in_the_language_of_the_sheet():
    ru = {m.text for m in sheet().marks if isinstance(m, Text)}
    en = {m.text for m in sheet("en").marks if isinstance(m, Text)}
    for (word, _), (english, _) in zip(
        form1.printed_words((420.0, 297.0), "ru"), form1.printed_words((420.0, 297.0), "en"), strict=True
    ):
        assert word in ru and word not in en, word
        assert english in en, english


@pytest.mark.parametrize("turn", [0, 90, 180])
@pytest.mark.parametrize("text", ["Короткий", "Слово, которое продолжается на следующей строке ячейки", "Ы" * 40])
def test_a_text_is_broken_or_made_smaller_until_it_fits(turn, text):
    wide, high = (70, 25) if turn % 180 == 0 else (25, 70)
    cell = form1.Cell(100, 100, wide, high, 5.0, "middle", turn)
    marks = fit_text_in_cell(text, cell)
    assert " ".join(m.text for m in marks) == text
    heights = {m.height for m in marks}
    assert max(heights) <= 5.0 and (len(text.split()) == 1 or heights <= {5.0, 3.5, 2.5, 1.8})
    for mark in marks:
        for z in text_box_corners(mark):
            assert 100 < z.real < 100 + wide and 100 < z.imag < 100 + high
    if turn == 0 and len(marks) > 1:  # lines are read from the top down
        assert marks[0].place.imag > marks[1].place.imag


def test_a_turned_text_is_the_upright_one_turned_about_its_cell():
    upright = fit_text_in_cell("ТММ.01", form1.Cell(-35, -7, 70, 14, 7.0))
    for turn in (90, 180):
        wide, high = (70, 14) if turn == 180 else (14, 70)
        (mark,) = fit_text_in_cell("ТММ.01", form1.Cell(-wide / 2, -high / 2, wide, high, 7.0, "middle", turn))
        assert abs(mark.place - upright[0].place * cmath.rect(1, math.radians(turn))) < 1e-9


@pytest.mark.parametrize("name", list(FORMATS))
def test_the_frame_is_20_5_5_5(name):
    paper = Paper(name)
    frame = next(m for m in paper.frame_marks({}) if isinstance(m, Line) and m.closed)
    wide, high = paper.size
    assert set(frame.points) == {20 + 5j, complex(wide - 5, 5), complex(wide - 5, high - 5), complex(20, high - 5)}
    assert frame.style == "frame"
    assert ink_bounds(name, 2.5)[2] < 35


def test_words_of_the_form_are_of_the_least_height_for_capitals_and_small_letters():
    """«Изм.» in its 7 mm is the tightest word of the form."""
    words = [m for m in Paper("A3").frame_marks({}) if isinstance(m, Text)]
    assert {m.height for m in words} == {2.5}
    narrowed = {m.text: m.narrow for m in words if m.narrow < 1}
    assert list(narrowed) == ["Изм."] and narrowed["Изм."] > 0.9


LONG = {
    "company": "Белорусский национальный технический университет, кафедра теоретической механики и механики материалов",
    "student": "Константинопольский-Заволжский А. Б.",
    "title": "Шестизвенный кулисно-рычажный механизм долбёжного станка с возвратно-поступательным движением долбяка",
    "first_use": "ТММ.01.12.000 СБ и все исполнения, которые за ним следуют",
    "date": "12 декабря 2026 года",
}


def test_long_names_are_shared_among_lines_and_no_letter_is_off_the_standard_series():
    cells, said = form1.fill_in_cells((420.0, 297.0)), {}
    for key, cell in (("company", "company"), ("student", "student"), ("title", "title"), ("date", "student_date")):
        said[cell] = LONG[key]
    said["first_use"] = LONG["first_use"]
    marks = [m for m in Paper("A3").frame_marks(said) if isinstance(m, Text)]
    assert {m.height for m in marks} <= {1.8, 2.5, 3.5, 5.0, 7.0, 10.0}
    lines = {key: [m for m in marks if m.name == f"cell {key}"] for key in said}
    for key, found in lines.items():
        assert " ".join(m.text for m in found) == said[key]
        cell = cells[key]
        for mark in found:
            xs, ys = [z.real for z in text_box_corners(mark)], [z.imag for z in text_box_corners(mark)]
            assert cell.x < min(xs) and max(xs) < cell.x + cell.width, mark.text
            assert cell.y < min(ys) and max(ys) < cell.y + cell.height, mark.text
    assert len(lines["company"]) > 2 and min(m.narrow for m in lines["company"]) > 0.95
    assert len(lines["student"]) == 1 and 0.45 < lines["student"][0].narrow < 0.9  # 5 mm hold one line


def test_a_short_name_of_a_department_is_not_torn():
    marks = sheet(university="БНТУ", department="Кафедра ТММ", group="М-31").marks
    lines = [m.text for m in marks if isinstance(m, Text) and m.name == "cell company"]
    assert lines == ["БНТУ", "Кафедра ТММ М-31"]


def test_a_narrowed_text_is_as_high_and_so_many_times_as_wide():
    usual, narrowed = (lay_out_text(Text("Пров. v_{CB}", 10 + 10j, 5.0, turn_deg=90, narrow=by)) for by in (1.0, 0.6))
    assert [r.height for r in narrowed.runs] == [r.height for r in usual.runs]
    for one, other in zip(usual.strokes, narrowed.strokes, strict=True):
        for a, b in zip(one, other, strict=True):
            assert (b - 10).real == pytest.approx((a - 10).real)
            assert (b - narrowed.origin).imag == pytest.approx(0.6 * (a - usual.origin).imag)


def test_the_letter_of_a_study_sheet_is_given_unless_the_scene_says_another():
    assert said_of(sheet())["letter_1"] == "У"
    assert "letter_1" not in said_of(sheet(letter="''"))
    assert said_of(sheet(letter="О"))["letter_1"] == "О"


@pytest.mark.parametrize(
    ("lang", "words"),
    [
        ("ru", "Разраб. Листов Масштаб"),
        ("en", "Drawn Sheets Scale"),
        ("uk", "Розроб. Аркушів Масштаб"),
        ("be", "Распр. Лістоў Маштаб"),
    ],
)
def test_the_frame_is_in_the_language_asked_for_whatever_began_the_scene(lang: str, words: str) -> None:
    """A scene with neither language nor frame of its own, as one typed by hand."""
    marks = sheet_of(loads(SIX_LINK), None, lang).marks
    text = {m.text for m in marks if isinstance(m, Text)}
    assert set(words.split()) <= text
