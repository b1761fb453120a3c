"""A mechanism built in Python is the one its file says, and is refused as a file is."""

from __future__ import annotations

import pydoc
import re

import pytest

import planes
from planes.solving.building import Linkage
from tests.helpers import ROOT


def slider_crank() -> Linkage:
    engine = Linkage("Slider-crank", gravity=9.81, l_OA=0.1)
    engine.fix(O=(0, 0)).guide("x-x", y=0)
    engine.link(1, O=0, A="l_OA").link(2, A=0, B=0.35, S2=0.12j, centre="S2", mass=2, inertia=0.03)
    engine.link(3, B=0, slides="x-x", mass=3).assemble(B="ahead").drive(1, phi=60, omega=20)
    return engine.load(3, "B", force=500, against="motion").friction({"x-x": 0.1}).scales(velocity="30 mm/(m/s)")


def test_it_solves_and_its_parameters_change() -> None:
    built = slider_crank()
    crank = planes.solve(built.scene())
    assert crank.v["A"] == pytest.approx(20j * 0.1 * complex(0.5, 3**0.5 / 2), rel=1e-14)
    assert abs(planes.solve(built.scene(l_OA=0.12)).v["A"]) == pytest.approx(2.4, rel=1e-14)


def test_its_file_says_the_same() -> None:
    built = slider_crank()
    here, again = planes.solve(built.scene()), planes.solve(planes.loads(built.to_yaml()))
    assert again.results == here.results
    assert "friction: {x-x: 0.1}" in built.to_yaml() and "S2: [0.0, 0.12]" in built.to_yaml()


def test_what_cannot_be_meant_is_a_sentence_that_names_the_part_and_no_line_of_a_file() -> None:
    built = slider_crank().load(3, "B", force=1, along="y-y")
    with pytest.raises(planes.PlanesError, match=r"^<Slider-crank>: along of load 2 cannot be \"y-y\"; valid: motion$"):
        built.scene()
    built = slider_crank()
    built.parts["gravity"] = 98.1
    (doubt,) = built.scene().doubts
    assert re.match("<Slider-crank>: gravity", doubt.told())


def test_an_open_assembly_and_a_missing_link_are_refused_before_anything_is_solved() -> None:
    built = slider_crank()
    built.parts["assembly"].clear()
    with pytest.raises(planes.PlanesError, match="two ways"):
        built.scene()
    with pytest.raises(planes.PlanesError, match=r"^<Linkage>: .*link"):
        Linkage().fix(O=(0, 0)).link(1, O=0, A=0.1).link(2, A=0, B=1).drive(1, phi=0).scene()
    with pytest.raises(planes.PlanesError, match=r'^guide g: there is no link "7"; valid: 1$'):
        Linkage().link(1, O=0).guide("g", link=7, y=0)


def test_a_point_given_as_none_is_refused() -> None:
    built = Linkage("x").fix(O=(0, 0)).link(1, O=0, A=None).drive(1, phi=60)
    with pytest.raises(planes.PlanesError, match=r"A"):
        built.scene()


@pytest.mark.parametrize(
    ("word", "near"), [("masss", "mass"), ("centr", "centre"), ("slide", "slides"), ("inerta", "inertia")]
)
def test_a_misspelt_word_is_no_point_and_a_link_is_given_once(word: str, near: str) -> None:
    with pytest.raises(planes.PlanesError, match=f"no {word}; did you mean {near}"):
        Linkage("x").link(1, O=0, **{word: 2})
    with pytest.raises(planes.PlanesError, match="link 1 has been added already"):
        Linkage("x").link(1, O=0).link("1", A=0)


def test_a_room_is_reached_through_the_verb_of_its_name() -> None:
    import planes.check.reading as reading
    import planes.lesson.practice as practice

    assert reading.__name__ == "planes.check.reading" and practice.__name__ == "planes.lesson.practice"
    scene = planes.load(ROOT / "samples" / "kind-1-rrr.yaml")
    assert callable(planes.check) and planes.lesson(scene)
    assert planes.check is planes.check and "check(scene: " in pydoc.render_doc(planes.check, renderer=pydoc.plaintext)
    assert planes.check.__doc__ and "drawing" in planes.check.__doc__
