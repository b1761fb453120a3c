"""Figures of a report: what the text of each stage asks for is drawn, and pages are filled."""

from __future__ import annotations

import cmath
import io
import math

import pypdfium2
import pytest

from planes.crank_slider.pages import ChapterWriter
from planes.crank_slider.pages_mechanics import draw_plans_at_angle
from planes.crank_slider.report import report_document
from planes.documents.lesson import note_file_contents
from planes.scene import load
from planes.solving.document import Figure, ShaftSketch
from planes.words import Lang
from planes.words.naming import Naming
from render.paper.marks import Arrow, Text
from render.report import render_document
from render.report.figures import DocumentSetter
from render.report.shaft import shaft_view
from render.views.instant_centre import instant_centre_scheme
from tests.helpers import ROOT
from tests.helpers.crank_slider_scenes import SAMPLE, calculated

EMPTY = 0.4  # of a page: no more is left white beneath the last line of one that is not the last


@pytest.mark.parametrize("phi", [30.0, 45.0, 150.0, 200.0, 320.0])
def test_the_instant_centre_is_on_the_crank_and_square_to_the_guide(phi: float) -> None:
    """AP = l cos β / |cos φ| from the pin along the crank (text, formula 5)."""
    c = calculated(SAMPLE)
    _, solved = draw_plans_at_angle(ChapterWriter("en"), c, phi)
    found = instant_centre_scheme(solved, "2", Naming("en"))
    s, mu = c.given.shape, solved.scales["mu_position"]
    beta = math.asin(s.r / s.l * math.sin(math.radians(phi)))
    far = mu * s.l * math.cos(beta) / math.cos(math.radians(phi))
    place = solved.drawing["position:O"] + cmath.rect(mu * s.r + far, math.radians(phi))
    assert found is not None
    names = [m for m in found.marks if isinstance(m, Text) and m.text == "P_{2}"]
    assert len(names) == 1 and abs(names[0].place - place) < 12.0
    lines = [m.points for m in found.marks if getattr(m, "layer", "") == "construction"]
    assert len([ends for ends in lines if min(abs(z - place) for z in ends) < 1e-6]) == 3


def test_no_centre_is_drawn_where_it_is_too_far() -> None:
    _, solved = draw_plans_at_angle(ChapterWriter("en"), calculated(SAMPLE), 90.0)
    assert instant_centre_scheme(solved, "2", Naming("en")) is None


def test_every_force_on_the_shaft_is_an_arrow_of_its_own() -> None:
    blocks = [
        b for b in report_document(calculated(SAMPLE), "ru") if isinstance(b, Figure) and isinstance(b.of, ShaftSketch)
    ]
    masses, loaded = (b.of for b in blocks if isinstance(b.of, ShaftSketch))
    arrows = {m.name for m in shaft_view(loaded).marks if isinstance(m, Arrow)}
    assert arrows >= {"N_{c1}", "P_{t1}", "A′", "A″", "B′", "B″", "Φ", "Φ_{1пр}", "Φ_{2пр}"}
    ways = [
        m.end - m.start for m in shaft_view(loaded).marks if isinstance(m, Arrow) and m.name in ("N_{c1}", "P_{t1}")
    ]
    assert abs((ways[0].conjugate() * ways[1]).imag) > 1.0  # not one line
    assert {"m_{R}", "R_{пр}", "Φ_{R}"} <= {m.text for m in shaft_view(masses).marks if isinstance(m, Text)}


def test_the_mechanism_and_each_link_are_drawn_with_their_forces() -> None:
    loaded = next(
        b for b in report_document(calculated(SAMPLE), "en") if isinstance(b, Figure) and "its loads" in b.caption
    )
    pictures, _ = DocumentSetter(Naming("en")).shown(loaded)
    names = {m.name for p in pictures for m in getattr(p, "marks", ()) if isinstance(m, Arrow)}
    assert {"P_3", "I_3", "I_2", "I_1", "F_30", "F_32", "F_23", "F_21", "F_12", "F_10", "G_1"} <= names


@pytest.mark.few(1)
@pytest.mark.parametrize("lang", ["ru", "en"])
@pytest.mark.parametrize("what", ["report", "note"])
def test_no_page_is_half_empty(what: str, lang: Lang) -> None:
    six_link = load(ROOT / "samples" / "six-link.yaml")
    report = (
        render_document(report_document(calculated(SAMPLE), lang), ".pdf", Naming(lang)) if what == "report" else None
    )
    pages = pypdfium2.PdfDocument(io.BytesIO(report or note_file_contents(six_link, None, ".pdf", lang)))
    first = 0 if what == "report" else 2  # a title page and the contents are as long as they are
    for k in range(first, len(pages) - 1):
        grey = pages[k].render(scale=0.5, grayscale=True).to_numpy()
        body = grey[: int(0.93 * len(grey))] < 200
        last = max(row for row, inked in enumerate(body.any(axis=1)) if inked)
        assert last > (1 - EMPTY) * len(body), k + 1
