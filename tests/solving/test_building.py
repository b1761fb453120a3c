"""A mechanism built in Python is the one its file says, and is refused as a file is."""

from __future__ import annotations

import math
import pydoc
import re
import warnings
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import planes
from planes.cli import main
from planes.solving.building import Linkage
from planes.words import available_languages
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


def other_numbers(value: Any, kind: Callable[[Any], Any]) -> Any:
    """Everything that is given in a linkage, with its numbers in another type."""
    if isinstance(value, dict):
        return {key: other_numbers(one, kind) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [other_numbers(one, kind) for one in value]
    return kind(value) if isinstance(value, int | float | complex) else value


@pytest.mark.parametrize(
    "kind", [np.asarray, np.array, lambda z: np.asarray(z)[()], lambda z: Fraction(z) if isinstance(z, float) else z]
)
def test_numbers_of_other_libraries_are_numbers(kind: Callable[[Any], Any]) -> None:
    built, other = slider_crank(), slider_crank()
    other.parts = other_numbers(other.parts, kind)
    assert planes.loads(other.to_yaml()).mechanism == planes.loads(built.to_yaml()).mechanism
    bar = Linkage("x").fix(O=np.zeros(2), D=(np.float32(0.5), np.int8(0))).link(1, O=0, A=np.float64(0.125))
    bar.link(np.int64(2), A=0, B=np.array([0.5, 0.0])).link(3, D=0, B=0.25).assemble(B={"near": np.array([0.5, 0.25])})
    assert planes.solve(bar.drive(np.int64(1), phi=np.int64(60), omega=np.float32(3))).omega[1] == 3
    for wrong in (math.nan, np.float64("inf"), object(), {1, 2}):
        with pytest.raises(planes.PlanesError, match=r"^<x>: point B of link 2: \"?[^.]"):
            Linkage("x").fix(O=0).link(2, O=0, B=wrong).drive(2, phi=1).scene()


def test_what_cannot_be_meant_is_a_sentence_that_names_the_part_and_no_line_of_a_file() -> None:
    built = slider_crank().load(3, "B", force=1, along="y-y")
    with pytest.raises(planes.PlanesError, match=r"^<Slider-crank>: along of load 2 cannot be \"y-y\"; valid: motion$"):
        built.scene()
    built = slider_crank()
    built.parts["gravity"] = 98.1
    with pytest.warns(UserWarning, match=r"^<Slider-crank>: gravity is 98.1"):
        built.scene()


def four_bar(unit: float = 1.0, mass: float = 2.0, rocker: float = 0.3) -> Linkage:
    built = Linkage("Four-bar").fix(O=(0, 0), D=(0.4 * unit, 0)).link(1, O=0, A=0.1 * unit, mass=mass)
    return built.link(2, A=0, B=0.4 * unit).link(3, D=0, B=rocker * unit).assemble(B="left").drive(1, phi=60, omega=3)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"unit": 1000.0}, "link 3 is 300 m long: lengths are in metres; if millimetres are meant, divide by 1000"),
        ({"mass": 2000.0}, "link 1 has a mass of 2000 kg and is 0.1 m long: masses are in kilograms; if grams"),
    ],
)
def test_numbers_in_what_seem_other_units_are_doubted_in_python_as_on_the_command_line(
    given: dict[str, float], said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.warns(UserWarning) as warned:
        four_bar(**given).scene()
    text = four_bar(**given).to_yaml()
    assert any(said in str(one.message) and one.filename == __file__ for one in warned)
    with pytest.warns(UserWarning) as warned:
        planes.loads(text)
    assert any(said in str(one.message) for one in warned)
    (tmp_path / "four-bar.yaml").write_text(text, "utf-8")
    assert main(["structure", str(tmp_path / "four-bar.yaml"), "--lang", "en"]) == 0
    assert f"warning: {tmp_path / 'four-bar.yaml'}:" in (told := capsys.readouterr().err) and said in told
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        four_bar().scene()


def test_a_negative_length_is_refused_in_python_as_on_the_command_line() -> None:
    with pytest.raises(
        planes.PlanesError, match=r"^<Four-bar>: the length DB of link 3 cannot be negative, but is -0.3"
    ):
        four_bar(rocker=-0.3).scene()
    text = four_bar().to_yaml()
    with pytest.raises(planes.PlanesError, match=r"^a.yaml:[0-9]+: the length DB of link 3 cannot be negative"):
        planes.loads(text.replace("0.3", "-0.3"), "a.yaml")
    with pytest.raises(planes.PlanesError, match=r"r of point B of link 3 cannot be negative"):
        planes.loads(text.replace("B: 0.3", "B: {r: -0.3, angle: 10}"), "a.yaml")


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


@pytest.mark.parametrize(
    ("call", "word", "near"),
    [("load", "forse", "force"), ("drive", "angle", ""), ("drive", "omga", "omega"), ("guide", "angel", "angle")],
)
def test_a_misspelt_keyword_of_any_call_is_a_sentence(call: str, word: str, near: str) -> None:
    with pytest.raises(planes.PlanesError, match=rf"^{call}\(\) has no {word}; valid: .*{near}"):
        getattr(Linkage("x").link(1, O=0), call)(1, **{word: 3})


def test_a_room_is_reached_through_the_verb_of_its_name() -> None:
    import planes.check.reading as reading
    import planes.lesson.practice as practice

    assert reading.__name__ == "planes.check.reading" and practice.__name__ == "planes.lesson.practice"
    scene = planes.load(ROOT / "samples" / "kind-1-rrr.yaml")
    assert callable(planes.check) and planes.lesson(scene)
    assert planes.check is planes.check and "check(scene: " in pydoc.render_doc(planes.check, renderer=pydoc.plaintext)
    assert planes.check.__doc__ and "drawing" in planes.check.__doc__


def _open() -> planes.Linkage:
    return planes.Linkage("Open").fix(O=(0, 0), D=(0.4, 0)).link(1, O=0, A=0.1).link(2, A=0, B=0.4).link(3, D=0, B=0.3)


@pytest.mark.parametrize(
    ("build", "said"),
    [
        (lambda: _open().drive(1, phi=30), 'assemble({"B": "left"}) for B at'),
        (lambda: _open().drive(1, phi=30).assemble(B="ahead"), 'valid: "left", "right" or {"near": [x, y]}'),
        (lambda: _open().drive(1, phi=30).assemble(C="left"), 'assemble(): there is no point or guide "C"'),
        (lambda: _open().drive(1, phi=30).assemble(B={"near": [9, 9]}), 'assemble({"B": {"near": ['),
        (lambda: _open().assemble(B="left"), "there is no drive yet; add it: drive(1, phi=30, omega=10)"),
        (lambda: planes.Linkage("Open"), "add it: fix(O=(0, 0))"),
        (lambda: _open().assemble(B="left").drive(1, phi=30).friction(B=0.1), 'friction({"B": {"coefficient": 0.1'),
        (lambda: _open().assemble(B="left").drive(1, phi=30).load(3, "B", force=3), 'along="motion"'),
        (lambda: _open().link(0, A=0).assemble(B="left").drive(1, phi=30), "give its points to fix()"),
    ],
)
def test_refusals_of_what_was_built_in_python_show_calls(build: Callable[[], planes.Linkage], said: str) -> None:
    """No line of a file is shown to somebody who has none, in whichever language."""
    linkage = build()
    with pytest.raises(planes.PlanesError) as refused:
        linkage.scene()
    assert said in str(refused.value)
    for lang in available_languages("structure"):
        told = refused.value.told(lang)
        assert not re.search(r"(assembly|drive|frame|friction|find|links): |\bkey\b|ключ", told), told
    with pytest.raises(planes.PlanesError) as refused:
        planes.loads(linkage.to_yaml(), "a.yaml") and planes.solve(planes.loads(linkage.to_yaml(), "a.yaml"))
    assert said not in str(refused.value)


def test_an_unknown_result_is_not_looked_for_under_a_key_of_a_file() -> None:
    scene = _open().assemble(B="left").drive(1, phi=30).scene()
    with pytest.raises(planes.PlanesError, match=r"^there is no quantity v_X; valid"):
        planes.cycle(scene, ["v_X"])
