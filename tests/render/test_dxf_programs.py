"""DXF in programs people draw with: what LibreCAD shows of a sheet, and what FreeCAD takes of it."""

from __future__ import annotations

import json
import shutil
import subprocess
from itertools import pairwise

import numpy as np
import pypdfium2
import pytest

from render.files import dxf
from render.paper.ink import arrow_parts
from render.paper.marks import Arc, Arrow, Line, Text
from render.paper.typeset import lay_out_text
from tests.helpers.sheets import sheet

NEAR_MM = 0.6  # a letter's neighbour is farther off
DPI = 127.0


def needs(*programs: str):
    """Marks a test as one of programs that may be missing."""
    missing = [p for p in programs if shutil.which(p) is None]
    return pytest.mark.skipif(bool(missing), reason=f"not installed here, so not tried: {', '.join(missing)}")


def seen_in_librecad(data: bytes, folder, name: str):
    """The ink of a drawing as LibreCAD prints it on its own paper."""
    (folder / f"{name}.dxf").write_bytes(data)
    run = ["xvfb-run", "-a", "librecad", "dxf2pdf", "-a", "-m", f"{name}.dxf"]
    subprocess.run(run, cwd=folder, check=True, capture_output=True, timeout=120)
    page = pypdfium2.PdfDocument(folder / f"{name}.pdf")[0]
    return np.asarray(page.render(scale=DPI / 72).to_pil().convert("L")) < 160


def kept(wanted, shown) -> float:
    """How much of the one ink is near ink of the other."""
    import cv2

    high, wide = (min(a, b) for a, b in zip(wanted.shape, shown.shape, strict=True))
    blank = (~shown[:high, :wide]).astype(np.uint8)
    far = cv2.distanceTransform(blank, cv2.DIST_L2, cv2.DIST_MASK_PRECISE) * 25.4 / DPI
    return float(np.mean(far[wanted[:high, :wide]] < NEAR_MM))


@pytest.mark.slow
@needs("librecad", "xvfb-run")
def test_librecad_shows_the_letters_of_the_title_block(tmp_path):
    """Cyrillic and Greek texts and the cells are where their strokes are; in another style's font they are not."""
    found = sheet("kind-2-rrp", student="Иванов И. И.", designation="ТММ.01.02.000", title="Механизм с углом φ и ω")
    block = found.paper.title_block
    marks = [m for m in found.marks if m.layer == "frame" and isinstance(m, Text)]
    marks = [m for m in marks if m.place.real > block[0] and m.height >= 2.5]
    corner = Line((0j, complex(*found.size)), "thin")  # both drawings of one extent
    strokes = seen_in_librecad(dxf.write([corner, *marks], found.size, "t", text="strokes"), tmp_path, "strokes")
    written = dxf.write([corner, *marks], found.size, "t")
    assert kept(strokes, seen_in_librecad(written, tmp_path, "text")) > 0.9
    unknown = written.replace(b"lc_opengost-br", b"another")
    assert kept(strokes, seen_in_librecad(unknown, tmp_path, "unknown")) < 0.8


@pytest.mark.slow
@needs("librecad", "xvfb-run")
@pytest.mark.parametrize("length", [14, 60])
@pytest.mark.parametrize("style", ["axis", "dash", "phantom"])
def test_librecad_breaks_lines_that_are_broken(style, length, tmp_path):
    """Even the pieces of an axis beside a slider."""
    edges = [Line((0j, 100 + 0j), "thin", "table"), Line((100j, 100 + 100j), "thin", "table")]
    layer = "axis" if style == "axis" else "scheme"
    line = Line((20 + 50j, 20 + length + 50j), style, layer)
    ink = seen_in_librecad(dxf.write([*edges, line], (100, 100), "t"), tmp_path, "line")
    row = ink[ink.shape[0] // 2 - 3 : ink.shape[0] // 2 + 4].any(axis=0)
    seen = np.flatnonzero(row)
    assert seen[-1] - seen[0] > 0.85 * length * DPI / 25.4
    assert (np.diff(seen) > 0.4 * DPI / 25.4).sum() >= length // 12


FREECAD = """
import json, FreeCAD, Import
FreeCAD.ParamGet("User parameter:BaseApp/Preferences/Mod/Draft").SetBool("dxftext", True)  # not asked: no texts
Import.readDXF("sheet.dxf", "sheet")
every = FreeCAD.ActiveDocument.Objects
shapes = [o.Shape for o in every if hasattr(o, "Shape")]
heads = [[[v.X, v.Y] for v in s.Vertexes] for s in shapes if len(s.Edges) == 3]
with open("seen.json", "w") as out:
    json.dump([[" ".join(o.LabelText) for o in every if hasattr(o, "LabelText")], heads], out)
    print(file=out)
    json.dump(sum(e.Length for s in shapes for e in s.Edges if s.BoundBox.XMax < 0), out)
"""


@pytest.mark.slow
@needs("freecadcmd")
def test_freecad_takes_every_text_every_arrowhead_and_what_follows_a_dot(tmp_path):
    found = sheet("kind-2-rrp", student="Иванов И. И.")
    left = [Arc(-30 + 10j, 1.0, style="thin", fill="ink"), Line((-60 + 0j, -40 + 0j, -40 + 30j), "thin")]
    (tmp_path / "sheet.dxf").write_bytes(dxf.write([*found.marks, *left], found.size, found.title))
    (tmp_path / "read.py").write_text(FREECAD)
    subprocess.run(["freecadcmd", "read.py"], cwd=tmp_path, check=True, capture_output=True, timeout=120)
    (texts, heads), long = map(json.loads, (tmp_path / "seen.json").read_text().splitlines())
    assert abs(long - 2 * np.pi - 50.0) < 1e-3
    assert {"Иванов И. И.", "Исходные данные"} <= set(texts)
    tips = [complex(x, y) for head in heads for x, y in head]
    wanted = [arrow_parts(m)[1] for m in found.marks if isinstance(m, Arrow)]
    assert sum(map(bool, wanted)) > 10
    for corner in (z for head in wanted for z in head):
        assert min(abs(corner - z) for z in tips) < 0.01


COUNTED = """
import json, FreeCAD, Import
Import.readDXF("sheet.dxf", "sheet")
shapes = [o.Shape for o in FreeCAD.ActiveDocument.Objects]
with open("seen.json", "w") as out:
    json.dump([len(shapes), sum(e.Length for s in shapes for e in s.Edges)], out)
"""


@pytest.mark.slow
@needs("freecadcmd")
def test_freecad_takes_letters_drawn_by_lines_as_one_thing_a_text(tmp_path):
    found = sheet("kind-2-rrp", student="Иванов И. И.")
    texts = [m for m in found.marks if isinstance(m, Text) and m.layer != "frame"]
    (tmp_path / "sheet.dxf").write_bytes(dxf.write(texts, found.size, found.title, text="strokes"))
    (tmp_path / "count.py").write_text(COUNTED)
    subprocess.run(["freecadcmd", "count.py"], cwd=tmp_path, check=True, capture_output=True, timeout=120)
    count, long = json.loads((tmp_path / "seen.json").read_text())
    pieces = [abs(b - a) for m in texts for stroke in lay_out_text(m).strokes for a, b in pairwise(stroke)]
    assert count <= len(texts) and len(pieces) > 10 * len(texts)
    assert abs(long / sum(pieces) - 1) < 1e-3
