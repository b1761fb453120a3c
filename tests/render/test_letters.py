"""Names are lettered by one rule, on a sheet and on a page, whatever the points of a scene are called."""

from __future__ import annotations

import json
from functools import cache
from typing import Any

import pytest

from planes.lesson.data import lesson_data
from planes.plans import plans_of
from planes.plans.measuring import scene_lettering
from planes.scene import Scene, loads
from planes.words.naming import Naming
from render.page.lesson_page import whole_lesson_page
from render.paper.letters import lettered_pieces, sentence_html
from tests.helpers import ROOT
from tests.helpers.lessons import brought

RRP = (ROOT / "samples" / "kind-2-rrp.yaml").read_text(encoding="utf-8").replace("frame:\n", "frame:\n  number: 6\n")
ROD = "{points: {B: 0, C: l_BC"
ODD = RRP.replace(ROD, "{points: {B: 0, C10: l_BC").replace("{points: {C: 0}", "{points: {C10: 0}")
ODD = ODD.replace("point: C,", "point: C10,").replace("{C: ahead}", "{C10: ahead}")


@cache
def scene_of(text: str) -> Scene:
    return loads(text, "s.yaml")


def naming(text: str) -> Naming:
    scene = scene_of(text)
    assert scene.mechanism is not None
    return Naming("ru", **scene_lettering(scene, plans_of(scene.mechanism)))


@cache
def written(text: str) -> dict[str, Any]:
    """The letters a lesson's page brings along."""
    return json.loads(brought(whole_lesson_page(lesson_data(scene_of(text)), "ru"))["letters"])  # type: ignore[no-any-return]


@pytest.mark.parametrize(
    ("text", "name", "lettered"),
    [
        (RRP, "v_C", "v_{C}"),
        (RRP, "v_CC0", "v_{CC6}"),
        (RRP, "a_CC0", "a_{CC6}"),
        (ODD, "v_C10", "v_{C10}"),
        (ODD, "a_C10", "a_{C10}"),
        (ODD, "a_C10B^n", "a_{C10B}^{n}"),
        (ODD, "v_C10C100", "v_{C10C106}"),
        (ODD, "F_30", "F_{36}"),
    ],
)
def test_a_point_may_end_with_a_nought_and_the_frame_has_its_number(text: str, name: str, lettered: str) -> None:
    assert naming(text).lettered_vector(name) == lettered


@pytest.mark.parametrize("text", [RRP, ODD, RRP.replace("planes: 1\n", "planes: 1\nsheet: {reactions: from-on}\n")])
def test_a_page_letters_as_the_sheet_does(text: str) -> None:
    equations = lesson_data(scene_of(text))["equations"]
    own, names = naming(text), {term["name"] for e in equations for side in e["sides"] for term in side}
    assert len(names) > 20
    for name in names:
        assert written(text)["ru"][name] == [[p.text, p.shift] for p in lettered_pieces(f"⟨{name}⟩", own)]


def test_only_the_balancing_load_differs_by_the_language() -> None:
    told = written(RRP)
    assert {*told["en"]} <= {"M_1", "MZ_1"} and len(told["ru"]) > 20


@pytest.mark.parametrize(
    ("told", "shown"),
    [
        ("F_21t: it is reversed", "<i>F</i><i><sub>21</sub></i><i><sup>t</sup></i>: it is reversed"),
        ("Not seen: a, s5 and c'.", "Not seen: <i>a</i>, <i>s</i><i><sub>5</sub></i> and <i>c′</i>."),
        ("a similar figure, v_CB < 2", "a similar figure, <i>v</i><i><sub>CB</sub></i> &lt; 2"),
        ("(-o report.html) or --mark c'=x,y (px)", "(<+-o report.html+>) or <+--mark c&#x27;=x,y+> (px)"),
        (
            "mark,x_mm,y_mm; force-2-3, y-y, --plan, IMG_002.jpg",
            "mark,x_mm,y_mm; force-2-3, y-y, <+--plan+>, IMG_002.jpg",
        ),
        ("again: s5.jpg, c.pdf.", 'again: <a href="s5.html">s5.jpg</a>, c.pdf.'),
    ],
)
def test_a_plain_sentence_has_its_names_lettered_and_its_commands_whole(told: str, shown: str) -> None:
    shown = shown.replace("<+", '<span class="command">').replace("+>", "</span>")
    names = ["a", "c", "c'", "s5", "F_21t"]
    assert sentence_html(told, names, Naming("en"), "acceleration", {"s5.jpg": "s5.html"}) == shown


def test_a_vector_to_a_point_of_the_frame_is_the_points_own() -> None:
    naming = Naming(grounded=["v_BB0", "a_S2S20", "v_BE"])
    assert [*map(naming.own_vector_name, ("v_BB0", "a_S2S20", "v_BE", "v_CB"))] == ["v_B", "a_S2", "v_BE", "v_CB"]
    assert naming.retell_in_typed_names("I_2, F_21: wrong", ["I_2", "F_21"]) == "Φ_2, F_21: wrong"
