"""The marks of whole sheets against kept listings, and read back from each format within 0.05 mm."""

from __future__ import annotations

import io
import os
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from functools import lru_cache

import numpy as np
import pypdfium2
import pytest
import shapely
from pypdfium2 import raw

from render.files import dxf, pdf, svg
from render.files.dxf_entities import CHARACTERS_NOT_IN_FONT, LEAST_PROSE_LETTERS
from render.paper.ink import arrow_parts, is_circle, visible_marks
from render.paper.marks import Arc, Arrow, Line, Shape, Text, move_mark
from render.paper.typeset import lay_out_text, plain_text
from tests.helpers.listings import GOLDEN, difference, listing
from tests.helpers.sheets import sheet

KEPT = {"six-link-1": ("six-link", 1), "six-link-2": ("six-link", 2), "kind-5-rpp": ("kind-5-rpp", None)}
NEAR_MM = 0.05
MM = 25.4 / 72


@pytest.mark.few(1)
@pytest.mark.parametrize("name", list(KEPT))
def test_the_marks_are_the_kept_ones(name):
    scene, number = KEPT[name]
    found = listing(sheet(scene, number=number))
    path = GOLDEN / f"{name}.txt"
    if os.environ.get("GOLDEN") == "write":
        path.write_text(found, encoding="utf-8")
    kept = path.read_text(encoding="utf-8")
    assert found == kept, difference(kept, found) + "\nif that is meant: GOLDEN=write python -m pytest " + __file__


def test_a_difference_is_read_at_a_glance():
    found = sheet("kind-2-rrp")
    kept = listing(found)
    at, arrow = next((k, m) for k, m in enumerate(found.marks) if isinstance(m, Arrow))
    other = replace(found, marks=(*found.marks[:at], move_mark(arrow, 0.02 + 0j), *found.marks[at + 1 :]))
    told = difference(kept, listing(other))
    assert told.startswith("1 lines are gone, 1 are new")
    assert len(told.splitlines()) == 5


# reading back


def corners(marks):
    """Where ink must be found: ends of lines, shafts and heads of arrows, corners of shapes."""
    found = []
    for mark in marks:
        if isinstance(mark, (Line, Shape)):
            found += mark.points
        elif isinstance(mark, Arrow):
            shaft, head = arrow_parts(mark)
            found += [*shaft, *head]
    return found


def letters(marks):
    return [z for m in marks if isinstance(m, Text) for stroke in lay_out_text(m).strokes for z in stroke]


def farthest(wanted, found):
    """How far the wanted place with the most distant neighbour is from what was read."""
    tree = shapely.STRtree(shapely.points(np.real(found), np.imag(found)))
    places = shapely.points(np.real(wanted), np.imag(wanted))
    return tree.query_nearest(places, return_distance=True, all_matches=False)[1].max()


def agree(one, other):
    """Each place of either list within 0.05 mm of one of the other."""
    return max(farthest(one, other), farthest(other, one)) < NEAR_MM


def of_svg(data, height):
    """Points of all straight paths, centres with radii of circles, and texts with their places."""
    root = ElementTree.parse(io.BytesIO(data)).getroot()
    points, texts = [], []
    for element in root.iter():
        tag = element.tag.rpartition("}")[2]
        if tag == "path" and "A" not in element.get("d"):
            numbers = list(map(float, re.findall(r"-?[\d.]+", element.get("d"))))
            points += [complex(x, height - y) for x, y in zip(numbers[::2], numbers[1::2], strict=True)]
        elif tag == "text":
            x, y = map(float, re.findall(r"-?[\d.]+", element.get("transform"))[:2])
            texts.append(("".join(s.text or "" for s in element), complex(x, height - y)))
    return points, texts


@lru_cache(maxsize=8)
def of_pdf(data):
    """Points of the straight paths of a page, and where its pieces of text begin."""
    document = pypdfium2.PdfDocument(data)
    page = document[0]
    points, starts = [], []
    for item in page.get_objects(max_depth=3):
        a = item.get_matrix()
        if item.type == raw.FPDF_PAGEOBJ_TEXT:
            starts.append(complex(a.e, a.f) * MM)
        elif item.type == raw.FPDF_PAGEOBJ_PATH:
            points += path_points(item.raw, a)
    page.close()
    document.close()
    return points, starts


def path_points(path, a):
    """The points of a path without curves, in mm of the page."""
    import ctypes

    found = []
    x, y = ctypes.c_float(), ctypes.c_float()
    for k in range(raw.FPDFPath_CountSegments(path)):
        segment = raw.FPDFPath_GetPathSegment(path, k)
        if raw.FPDFPathSegment_GetType(segment) == raw.FPDF_SEGMENT_BEZIERTO:
            return []
        raw.FPDFPathSegment_GetPoint(segment, x, y)
        found.append(complex(a.a * x.value + a.c * y.value + a.e, a.b * x.value + a.d * y.value + a.f) * MM)
    return found


def flat(z):
    return complex(z[0], z[1])


def of_dxf(data):
    """Points of lines, polylines and filled shapes; circles; texts and attributes with the places they are set by.

    Blocks are taken apart, as deep as they go.
    """
    import ezdxf
    from ezdxf.disassemble import recursive_decompose

    entities = list(recursive_decompose(ezdxf.read(io.StringIO(data.decode())).modelspace()))
    of = {
        kind: [e for e in entities if e.dxftype() == kind]
        for kind in ("LINE", "LWPOLYLINE", "SOLID", "CIRCLE", "TEXT", "MTEXT", "ATTRIB")
    }
    points = [flat(z) for e in of["LINE"] for z in (e.dxf.start, e.dxf.end)]
    points += [flat(z) for e in of["LWPOLYLINE"] for z in e.get_points()]
    points += [flat(z) for e in of["SOLID"] for z in e.vertices()]
    circles = [(flat(e.dxf.center), e.dxf.radius) for e in of["CIRCLE"]]
    return points, circles, [set_by(e) for e in of["TEXT"] + of["MTEXT"] + of["ATTRIB"]]


def set_by(entity):
    """The letters of a text with the place that holds it: its beginning, or its middle where it is centred."""
    if entity.dxftype() == "MTEXT":
        return all_letters(entity.plain_text()), "MTEXT", flat(entity.dxf.insert)
    kind, first, _ = entity.get_placement()
    return all_letters(entity.dxf.text), kind.name, flat(first)


def all_letters(text):
    """In no order: what is stacked is read in either."""
    return sorted(c for c in text if c not in " ^/")


ALIKE = ["six-link", "kind-2-rrp", "kind-4-prp", "vectors"]


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ALIKE)
def test_svg_has_everything_where_the_marks_are(name):
    found = sheet(name)
    points, texts = of_svg(svg.write(found.marks, found.size, found.title), found.size[1])
    assert farthest([*corners(found.marks), *letters(found.marks)], points) < NEAR_MM
    wanted = [lay_out_text(m) for m in found.marks if isinstance(m, Text)]
    assert sorted(t for t, _ in texts) == sorted("".join(r.text for r in laid.runs) for laid in wanted if laid.runs)
    assert agree([laid.origin for laid in wanted if laid.runs], [z for _, z in texts])


@pytest.mark.few(0)
@pytest.mark.parametrize("name", ALIKE)
def test_pdf_has_everything_where_the_marks_are(name):
    found = sheet(name)
    points, starts = of_pdf(pdf.write(found.marks, found.size, found.title))
    assert farthest([*corners(found.marks), *letters(found.marks)], points) < NEAR_MM
    assert agree(
        [lay_out_text(m).origin for m in found.marks if isinstance(m, Text) and lay_out_text(m).plain_text], starts
    )


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ALIKE)
def test_dxf_has_everything_where_the_marks_are(name):
    found = sheet(name)
    points, circles, texts = of_dxf(dxf.write(found.marks, found.size, found.title))
    cut = visible_marks(found.marks)
    assert farthest(corners(cut), points) < NEAR_MM
    for arc in (m for m in cut if isinstance(m, Arc) and is_circle(m)):
        assert any(abs(c - arc.centre) < NEAR_MM and abs(r - arc.radius) < NEAR_MM for c, r in circles)
    for mark in (m for m in found.marks if isinstance(m, Text) and not CHARACTERS_NOT_IN_FONT & set(m.text)):
        laid, turn = lay_out_text(mark), np.exp(1j * np.radians(mark.turn_deg))
        foot = laid.origin + {"start": 0.0, "middle": 0.5, "end": 1.0}[mark.anchor] * laid.width * turn
        in_pieces = len(laid.runs) > 1 and len(plain_text(mark.text)) > LEAST_PROSE_LETTERS
        for run in laid.runs if in_pieces else laid.runs[:1]:
            at = laid.origin + run.at * turn
            centred = at + run.width / 2 * turn  # of empty cells alone
            held = {"CENTER": centred, "FIT": at, "LEFT": at, "MTEXT": foot}
            said = all_letters(run.text.strip() if in_pieces else laid.plain_text)
            assert any(t == said and abs(z - held[kind]) < NEAR_MM for t, kind, z in texts), laid.plain_text


@pytest.mark.slow
def test_the_formats_agree_with_each_other():
    found = sheet("six-link")
    of_screen, _ = of_svg(svg.write(found.marks, found.size, found.title), found.size[1])
    of_paper, _ = of_pdf(pdf.write(found.marks, found.size, found.title))
    assert agree(of_screen, of_paper)
