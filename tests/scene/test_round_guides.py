"""Guides along a circle: what slides on one moves as the link that turns about its centre."""

from __future__ import annotations

import pytest

from planes import solve
from planes.documents.sheets import sheet_of
from planes.scene import Scene, loads
from planes.words.errors import SceneError
from render.paper.marks import Arc, Text

ARC = """\
planes: 1
frame: {{points: {{O: [0, 0]{points}}}, guides: {{arc: {guide}}}}}
links:
  1: {{points: {{O: 0, A: 0.1}}}}
  2: {{points: {{A: 0, B: 0.3}}, mass: 2}}
  3: {{points: {{B: 0{more}}}, slides: {slides}, mass: 1.5, inertia: 0.01}}
assembly: {{B: left}}
drive: {{link: 1, phi: {phi}, omega: 10, epsilon: 4}}
loads: [{{link: 3, point: B, force: 100, direction: 200}}]
gravity: 9.81
"""
ROD = ARC.replace(", guides: {{arc: {guide}}}", "").replace(", slides: {slides}", "")


def arc(guide: str = "{centre: [0.3, 0], radius: 0.2}", slides: str = "arc", phi: float = 40, more: str = "") -> Scene:
    return loads(ARC.format(guide=guide, slides=slides, phi=phi, points="", more=more))


def rod(phi: float = 40, far: str = "{x: 0, y: 0.2}", more: str = "") -> Scene:
    return loads(ROD.format(phi=phi, points=", K: [0.3, 0]", more=f", K: [0, 0.2]{more}"))


@pytest.mark.parametrize("phi", [10.0, 40.0, 75.0, 110.0])
def test_a_slider_on_an_arc_moves_as_a_link_about_its_centre(phi: float) -> None:
    one, other = solve(arc(phi=phi)), solve(rod(phi))
    assert one.v["B"] == pytest.approx(other.v["B"], abs=1e-13) and one.a["B"] == pytest.approx(other.a["B"], abs=1e-11)
    assert one.omega == pytest.approx(other.omega, abs=1e-12)
    assert one.value("M_1") == pytest.approx(other.value("M_1"), rel=1e-11)
    assert abs(one.r["B"] - 0.3) == pytest.approx(0.2, abs=1e-14)


def test_its_axis_runs_along_the_arc_with_the_centre_on_the_left() -> None:
    found = solve(arc(more=", D: 0.05"))
    along = found.r["D"] - found.r["B"]
    assert ((0.3 - found.r["B"]) / along).real == pytest.approx(0.0, abs=1e-12)
    assert ((0.3 - found.r["B"]) / along).imag > 0


def test_an_offset_brings_it_nearer_to_the_centre() -> None:
    found = solve(arc(slides="{guide: arc, offset: 0.02}"))
    assert abs(found.r["B"] - 0.3) == pytest.approx(0.18, abs=1e-14)


def test_a_scene_is_written_back_and_read_the_same() -> None:
    scene = arc()
    assert loads(scene.to_yaml()).mechanism == scene.mechanism


def test_the_centre_has_a_letter_of_its_own_and_the_scheme_shows_the_arc() -> None:
    sheet = sheet_of(arc(), None, "en")
    assert "K" in {m.text for m in sheet.marks if isinstance(m, Text)}
    assert any(isinstance(m, Arc) and m.radius > 30 and abs(m.end_deg - m.start_deg) < 180 for m in sheet.marks)


@pytest.mark.parametrize(
    ("guide", "why"),
    [
        ("{centre: [0.3, 0]}", "radius"),
        ("{x: 0.1, radius: 0.2}", "guide arc has a radius and no centre"),
        ("{centre: [0.3, 0], radius: 0.2, angle: 3}", "guide arc is an arc about its centre and has no angle"),
        ("{centre: [0.3, 0], radius: -0.2}", "radius of guide arc cannot be negative"),
        ("{centre: [0.3, 0], radius: 0}", "guide arc has radius 0"),
        ("{centre: Z, radius: 0.2}", "Z"),
        ("{centre: [0.3, 0], x: 0.2}", "centre"),
    ],
)
def test_what_cannot_be_meant_is_one_sentence(guide: str, why: str) -> None:
    with pytest.raises(SceneError, match=why) as error:
        arc(guide)
    assert "scene.yaml:" in str(error.value)


def test_the_centre_is_not_among_the_slider_s_own_points() -> None:
    text = ARC.format(guide="{centre: K, radius: 0.2}", slides="arc", phi=40, points=", K: [0.3, 0]", more=", K: 0.2")
    with pytest.raises(SceneError, match="link 3 slides on the arc arc and has its centre"):
        loads(text)
