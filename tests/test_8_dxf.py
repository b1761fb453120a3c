"""DXF of whole sheets: no audit errors, millimetres, layers by meaning, the same places as the marks."""

from __future__ import annotations

from functools import lru_cache
from pathlib import Path

import pytest

from planes.roof import draw_sheet, sheet_of
from planes.scene import load
from render.cutting import uncovered
from render.marks import Arc, Line, Text
from render.style import LAYERS
from render.typeset import layout

ezdxf = pytest.importorskip("ezdxf")
dxf = pytest.importorskip("render.dxf")

SAMPLES = {path.stem: path for path in sorted((Path(__file__).parent.parent / "samples").glob("*.yaml"))}


@lru_cache(maxsize=8)
def sheet(name):
    return sheet_of(load(SAMPLES[name]), None)


def read(sheet, folder):
    path = folder / "sheet.dxf"
    dxf.write(sheet.marks, sheet.size, sheet.title, path)
    return ezdxf.readfile(path)


@pytest.mark.parametrize("name", ["six-link", "kind-1-rrr", "kind-4-prp", "vectors"])
def test_the_file_has_no_errors_and_is_in_millimetres(name, tmp_path):
    document = read(sheet(name), tmp_path)
    audit = document.audit()
    assert not audit.errors
    assert not audit.fixes
    assert document.units == 4
    used = {e.dxf.layer for e in document.modelspace()}
    assert used <= {layer.upper() for layer in LAYERS} and {"FRAME", "TEXT"} <= used


def test_places_agree_with_the_marks(tmp_path):
    found = sheet("kind-1-rrr")
    space = read(found, tmp_path).modelspace()
    marks = uncovered(found.marks)
    lines = sorted((round(e.dxf.start.x, 2), round(e.dxf.start.y, 2)) for e in space.query("LINE"))
    straight = [m.points[0] for m in marks if isinstance(m, Line) and len(m.points) == 2]
    for z in straight:
        assert any(abs(complex(*at) - z) < 0.05 for at in lines)
    circles = [(complex(e.dxf.center.x, e.dxf.center.y), e.dxf.radius) for e in space.query("CIRCLE")]
    for arc in (m for m in marks if isinstance(m, Arc) and m.end_deg - m.start_deg >= 360):
        assert any(abs(c - arc.centre) < 0.05 and abs(r - arc.radius) < 0.05 for c, r in circles)


def test_text_is_text_fitted_to_its_lettering(tmp_path):
    found = sheet("kind-1-rrr")
    space = read(found, tmp_path).modelspace()
    texts = {(e.dxf.text, round(e.dxf.insert.x, 2), round(e.dxf.insert.y, 2)): e for e in space.query("TEXT")}
    title = next(m for m in found.marks if isinstance(m, Text) and m.text.startswith("План скоростей"))
    run = layout(title).runs[0]
    place = layout(title).origin + run.at
    entity = texts[run.text.strip(), round(place.real, 2), round(place.imag, 2)]
    assert entity.dxf.height == run.height
    assert abs(entity.dxf.align_point.x - entity.dxf.insert.x - run.width) < 1e-4


def test_line_types_and_weights_are_kept(tmp_path):
    space = read(sheet("kind-2-rrp"), tmp_path).modelspace()
    weights = {e.dxf.lineweight for e in space.query("LINE")}
    assert {60, 25, 18} <= weights
    assert any(e.dxf.linetype == "AXIS" for e in space.query("LINE"))


def test_the_same_bytes_twice_and_a_file_by_its_suffix(tmp_path):
    found = sheet("kind-2-rrp")
    one = dxf.write(found.marks, found.size, found.title)
    assert one == dxf.write(found.marks, found.size, found.title)
    draw_sheet(load(SAMPLES["kind-2-rrp"]), None, str(tmp_path / "a.dxf"))
    assert (tmp_path / "a.dxf").read_bytes() == one
