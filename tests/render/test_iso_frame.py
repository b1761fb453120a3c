"""The frame of ISO 5457 and the title block of ISO 7200: fields, centring marks, cells, and what fills them."""

from __future__ import annotations

import io
from itertools import combinations

import ezdxf
import pytest

from planes.documents.sheets import sheet_of
from planes.scene import loads
from render.files import dxf
from render.paper import iso7200
from render.paper.marks import Line, Text
from render.paper.typeset import text_box_corners
from render.sheet.frame import FORMATS, Paper
from tests.helpers.conflicts import conflicts
from tests.helpers.scene_texts import SIX_LINK

FIELDS = {"A0": (24, 16), "A1": (16, 12), "A2": (12, 8), "A3": (8, 6), "A4": (4, 6)}  # ISO 5457, table 2
SAID = {
    "company": "Technical University",
    "department": "Applied Mechanics",
    "student": "J. Smith",
    "teacher": "A. Brown",
    "tech": "P. Jones",
    "approved": "R. Green",
    "date": "2026-05-12",
    "title": "Six-bar linkage",
    "designation": "TMM-01-12",
    "scale_note": "'1:4'",
    "document_type": "Force analysis",
    "letter": "Study",
    "revisions": "[{change: B}]",
}


def iso(name: str) -> Paper:
    return Paper(name, iso7200.ISO_FORM)


@pytest.mark.parametrize("name", list(FORMATS))
def test_fields_are_counted_from_the_axes_as_the_standard_has_them(name):
    paper = iso(name)
    (wide, high), (across, down) = paper.size, FIELDS[name]
    named = [m for m in paper.frame_marks({}, "en") if isinstance(m, Text) and m.height == 3.5]
    above = [m.text for m in named if m.place.imag > high - 10]
    right = [m.text for m in sorted(named, key=lambda m: -m.place.imag) if m.place.real > wide - 10]
    assert above == [str(k) for k in range(1, across + 1)]
    assert "".join(right) == "ABCDEFGHJKLMNPQRSTUV"[:down]  # I and O are left out
    assert len(named) == (across + down) * (1 if name == "A4" else 2)
    ticks = [a.real for a, b, _ in iso7200.form_lines(paper.size) if a.imag == high - 10 and b.imag == high - 5]
    assert sorted(x - wide / 2 for x in ticks) == [50.0 * k for k in range(1 - across // 2, across // 2)]


@pytest.mark.parametrize("name", list(FORMATS))
def test_frame_and_centring_marks_stand_where_the_standard_puts_them(name):
    paper = iso(name)
    wide, high = paper.size
    frame = next(m for m in paper.frame_marks({}) if isinstance(m, Line) and m.closed)
    assert set(frame.points) == {
        20 + 10j,
        complex(wide - 10, 10),
        complex(wide - 10, high - 10),
        complex(20, high - 10),
    }
    marks = {(a, b) for a, b, pen in iso7200.form_lines(paper.size) if pen == "thick" and abs(b - a) == 10}
    assert {(a + b) / 2 for a, b in marks} == {
        complex(wide / 2, high - 10),
        complex(wide / 2, 10),
        complex(20, high / 2),
        complex(wide - 10, high / 2),
    }
    assert paper.title_block == (wide - 190, 10, wide - 10, 46)
    assert paper.occupied_areas == (paper.title_block,)


def test_cells_and_their_names_tile_the_title_block():
    size = FORMATS["A3"]
    block = iso("A3").title_block
    cells = [*iso7200.fill_in_cells(size).values(), *(cell for _, cell in iso7200.printed_words(size, "en"))]
    inside = [c for c in cells if c.x >= block[0] and c.x + c.width <= block[2] and c.y >= block[1]]
    inside = [c for c in inside if c.y + c.height <= block[3]]
    assert sum(c.width * c.height for c in inside) == pytest.approx(180 * 36)
    for a, b in combinations(inside, 2):
        apart = (a.x + a.width - b.x, b.x + b.width - a.x, a.y + a.height - b.y, b.y + b.height - a.y)
        assert min(apart) <= 1e-9, (a, b)


def sheet(lang="en", number=None, **settings):
    said = ", ".join(f"{key}: {value}" for key, value in {"frame": "iso", **settings}.items())
    text = SIX_LINK.replace("find:", "# find:").replace("friction:", "# friction:")
    return sheet_of(loads(text + f"\nsheet: {{{said}}}\n"), None, lang, number)


def test_a_scene_fills_the_cells_and_the_views_keep_clear_of_the_frame():
    found = sheet(**SAID)
    cells: dict[str, str] = {}
    for mark in (m for m in found.marks if isinstance(m, Text) and m.name.startswith("cell ")):
        key = mark.name.removeprefix("cell ")
        cells[key] = f"{cells[key]} {mark.text}" if key in cells else mark.text
        cell = iso7200.fill_in_cells(found.size)[key]
        assert mark.height >= 1.8
        for z in text_box_corners(mark):
            assert cell.x < z.real < cell.x + cell.width and cell.y < z.imag < cell.y + cell.height
    assert cells == {
        "owner": "Technical University",
        "department": "Applied Mechanics",
        "student": "J. Smith",
        "teacher": "A. Brown",
        "tech": "P. Jones",
        "approved": "R. Green",
        "student_date": "2026-05-12",
        "title": "Six-bar linkage",
        "designation": "TMM-01-12",
        "scale": "1:4",
        "document_type": "Force analysis",
        "status": "Study",
        "revision_last": "B",
        "language": "en",
        "sheet_of": "1",
        "format": found.paper.name,
    }
    assert conflicts((), [m for m in found.marks if m.layer == "frame"], (0, 0, *found.size)) == ()
    x0, y0, x1, y1 = found.paper.field
    reach = iso7200.CENTRING_MARK_INSIDE_MM
    for one, left, top in found.views:
        assert x0 + reach < left and left + one.width < x1 - reach
        assert y0 + reach < top - one.height and top < y1 - reach


@pytest.mark.slow
def test_sheets_of_a_project_are_numbered_and_russian_ones_are_named_in_russian():
    found = sheet("ru", 2)
    texts = {m.name: m.text for m in found.marks if isinstance(m, Text)}
    assert (texts["cell sheet_of"], texts["cell language"]) == ("2/2", "ru")
    assert "Обозначение" in {m.text for m in found.marks if isinstance(m, Text)}


def test_in_a_dxf_it_is_a_block_of_its_own_with_its_cells():
    marks = iso("A3").frame_marks({"student": "J. Smith"}, "en")
    document = ezdxf.read(io.StringIO(dxf.write(marks, (420, 297), "t", lang="en").decode()))
    (form,) = document.modelspace().query("INSERT")
    assert form.dxf.name == "ISO_7200" and not document.audit().errors
    values = {a.dxf.tag: a.dxf.text for a in form.attribs}
    assert {*values} == {key.upper() for key in iso7200.fill_in_cells((420, 297))} and values["STUDENT"] == "J. Smith"
    assert all(e.dxf.prompt for e in document.blocks["ISO_7200"].query("ATTDEF"))
