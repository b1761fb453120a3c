"""A scene, its sketch, and the scene that is written of it; numbers written back where the text has them."""

import json
import math
import random
from pathlib import Path
from typing import Any

import pytest

from planes.scene import load, loads
from planes.studio.answers import answer_to_message
from planes.studio.numbers_back import changeable_numbers, text_with_numbers
from planes.studio.sketch_texts import text_of_changed_sketch
from planes.studio.sketches import sketch_of
from planes.words import available_languages
from planes.words.errors import PlanesError
from tests.sample_oracle import SAMPLES

SCENES = [
    p
    for p in sorted(SAMPLES.rglob("*.yaml"))
    if "\nlinks:" in p.read_text("utf-8") and p.stem != "three-basic-links"  # searched: seconds each time it is read
]
QUICK = [p for p in SCENES if not p.parent.name.startswith(("class", "mixtures"))]
NEW = 3e-4  # m: as fine as a sketch is written, through the links of a group
APART: list[tuple[str, dict[str, bool]]] = [("lesson", {}), ("practice", {}), ("lesson", {"all": True})]
HARD = ("three-basic-links", "two-basic-links", "truss")  # whose assemblies move far with little


@pytest.mark.few(5, slow=20)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_a_sketch_is_written_as_the_scene_it_was_made_of(path: Path) -> None:
    """From nothing, or into the text it came from, which stays as it is to the last letter."""
    text = path.read_text("utf-8")
    sketch = sketch_of(loads(text))
    assert text_of_changed_sketch(text, sketch).text == text
    again = sketch_of(loads(text_of_changed_sketch("", sketch).text))
    apart = max(math.dist(z, sketch["points"][p]) for p, z in again["points"].items())
    assert apart < NEW * (20 if path.stem in HARD else 1)
    assert again["links"].keys() == sketch["links"].keys() and again["drive"] == sketch["drive"]


@pytest.mark.few(3, slow=13)
@pytest.mark.parametrize("path", QUICK, ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_a_number_a_hand_sets_is_that_of_the_text(path: Path) -> None:
    """One number after another, three of each scene: the text says it, and the scene has it."""
    text, draw = path.read_text("utf-8"), random.Random(path.stem)
    home = changeable_numbers(text)
    tried = 0
    for name in draw.sample(sorted(home), len(home)):
        value = float(f"{home[name] * 1.02 or 0.0:.4g}")
        if tried == 3 or not value or value == home[name]:
            continue
        try:
            edited = text_with_numbers(text, {name: value})
        except PlanesError:
            continue  # a number that another one of the text makes, or a place where nothing assembles
        tried += 1
        now = changeable_numbers(edited.text)
        assert math.isclose(now[name], value, rel_tol=2e-4), (name, value, now[name])
        assert len(edited.lines) == 1 and len(edited.text.splitlines()) == len(text.splitlines())
    assert tried


def test_a_hinge_that_is_dragged_changes_the_numbers_that_place_it() -> None:
    """The six-link's rocker hinge D goes up: the parameter c_1 says so, and comments and all others stay."""
    text = (SAMPLES / "six-link.yaml").read_text("utf-8")
    sketch = sketch_of(loads(text))
    sketch["points"]["D"][1] += 0.02
    edited = text_of_changed_sketch(text, sketch)
    assert changeable_numbers(edited.text)["place_D.y"] == pytest.approx(-0.25)
    assert "c_1: 0.25" in edited.text and edited.text.count("#") == text.count("#")


def test_a_link_that_is_added_is_written_and_the_others_stay() -> None:
    text = (SAMPLES / "six-link.yaml").read_text("utf-8")
    sketch = sketch_of(loads(text))
    sketch["fixed"].append("K")
    sketch["points"] |= {"K": [0.3, 0.0], "M": [0.2, 0.2]}
    sketch["links"] |= {"6": {"points": ["C", "M"], "slides": None, "centre": None}}
    sketch["links"] |= {"7": {"points": ["K", "M"], "slides": None, "centre": None}}
    found = loads(text_of_changed_sketch(text, sketch).text)
    assert {*found.mechanism.links} == {*"1234567"} if found.mechanism else False
    now = sketch_of(found)["points"]
    assert math.dist(now["M"], [0.2, 0.2]) < NEW and math.dist(now["H"], sketch["points"]["H"]) < NEW


def ask(what: str, text: str, **more: Any) -> Any:
    return answer_to_message({"id": 1, "ask": what, "text": text, "lang": "en", **more})


def test_what_is_wrong_has_its_place_and_what_would_be_right() -> None:
    text = (SAMPLES / "six-link.yaml").read_text("utf-8")
    (found,) = ask("lesson", text.replace("slides: CL", "slides: CLL"))["problems"]
    line = text.splitlines().index(next(x for x in text.splitlines() if "slides: CL" in x)) + 1
    assert found["line"] == line and found["help"][0]["to"] == "CL"
    (open_,) = ask("lesson", text.replace("assembly: {C: right}", "assembly: {}"))["problems"]
    assert [h["path"] for h in open_["help"]] == [("assembly", "C")] * 2
    assert {h["value"] for h in open_["help"]} == {"left", "right"} and all("sketch" in h for h in open_["help"])
    told = ask("put", text.replace("assembly: {C: right}", "assembly: {}"), path=("assembly", "C"), value="right")
    assert ask("lesson", told["text"])["problems"] == []
    (bare,) = ask("lesson", text.replace("drive: {link: 1, phi: phi_1, omega: -20, epsilon: 80}", ""))["problems"]
    assert bare["help"][0]["act"] == "drive"


@pytest.mark.parametrize("text", ["", "planes: 1", "{", "a: [1", "- 1", "planes: 1\nlinks: 3", "\0", "x" * 300_000])
@pytest.mark.parametrize("what", ["lesson", "sketch", "drawn", "numbers", "put", "append", "leave out", "nothing"])
def test_whatever_is_sent_is_answered_with_a_sentence(what: str, text: str) -> None:
    sketch = sketch_of(load(SAMPLES / "six-link.yaml"))
    more = {"sketch": sketch, "numbers": {"l_BC": 1.0}, "path": ["links", "1", "mass"], "value": "1"}
    for lang in available_languages("studio"):
        found = answer_to_message({"id": 7, "ask": what, "text": text, "lang": lang, **more})
        assert found["id"] == 7 and ("text" in found or all(p["said"] and p["line"] for p in found["problems"]))


def test_a_new_part_leaves_the_others_as_written() -> None:
    """A tool on the six-link's rod: one point of a line is new; parameters, comments, drive and assembly stay."""
    text = (SAMPLES / "six-link.yaml").read_text("utf-8")
    sketch = sketch_of(loads(text))
    sketch["points"]["T"] = [-0.5, 0.1]
    sketch["links"]["2"]["points"].append("T")
    now = text_of_changed_sketch(text, sketch).text.splitlines()
    changed = [(a, b) for a, b in zip(text.splitlines(), now, strict=True) if a != b]
    assert len(changed) == 1 and changed[0][1].startswith(changed[0][0].partition("}")[0] + ", T: [")


def test_a_mechanism_goes_through_a_state_that_is_none() -> None:
    """A link removed and drawn again: what the sketch before says keeps the text of all others."""
    text = (SAMPLES / "six-link.yaml").read_text("utf-8")
    full = sketch_of(loads(text))
    less = json.loads(json.dumps(full))
    del less["links"]["5"]
    told = answer_to_message({"ask": "drawn", "text": text, "sketch": less})
    assert told["problems"] and "slides: y-y" not in told["text"] and "C: l_BC" in told["text"]
    again = json.loads(json.dumps(less))
    again["links"]["5"] = full["links"]["5"]
    told = answer_to_message({"ask": "drawn", "text": told["text"], "sketch": again, "was": less})
    assert not told["problems"] and "C: l_BC" in told["text"] and "phi: phi_1, omega: -20" in told["text"]


@pytest.mark.parametrize(
    ("name", "value", "typed", "line"),
    [
        ("l_AB", 0.31, "310*0.001", "l_AB: 310*0.001,"),
        ("omega_1", -120 * math.pi / 30, "-120*pi/30", "omega: -120*pi/30,"),
        ("l_AB", 0.3, "2*(0.1+0.05)", "l_AB: 2*(0.1+0.05),"),
        ("place_D.x", -0.24, "-24*0.01", "x_D: -24*0.01,"),
        ("l_AB", 0.31, "320*0.001", "l_AB: 0.31,"),
    ],
)
def test_a_number_is_written_in_the_figures_that_were_typed(name: str, value: float, typed: str, line: str) -> None:
    """Where they are that number; a later change by hand keeps the unit."""
    text = (SAMPLES / "kind-1-rrr.yaml").read_text("utf-8").replace("x_D: -0.24", "x_D: -0.25")
    now = answer_to_message({"ask": "numbers", "text": text, "numbers": {name: value}, "said": {name: typed}})["text"]
    assert line in now and changeable_numbers(now)[name] == pytest.approx(value, rel=1e-4)
    if line.endswith("*0.001,"):
        assert "l_AB: 315*0.001," in text_with_numbers(now, {"l_AB": 0.315}).text


def test_a_lesson_with_its_practice_apart_is_the_whole_lesson() -> None:
    """What comes apart, laid over the lesson without it, is what a page of its own has."""
    text = (SAMPLES / "kind-2-rrp.yaml").read_text("utf-8")
    first, more, full = (answer_to_message({"ask": ask, "text": text, **kind})["data"] for ask, kind in APART)
    assert first["pending"] and not first["slips"] and not first["practice"] and len(str(first)) < len(str(full))
    assert {k: v for k, v in {**first, **more}.items() if k != "pending"} == full


def test_a_load_goes_with_the_part_it_acts_on() -> None:
    """Of four loads those stay that still have their link and their point."""
    text = (SAMPLES / "kind-1-rrr.yaml").read_text("utf-8")
    sketch = sketch_of(loads(text))
    del sketch["links"]["3"]
    sketch["links"]["2"]["points"].remove("E")
    del sketch["points"]["E"]
    told = answer_to_message({"ask": "drawn", "text": text, "sketch": sketch})
    assert told["problems"] and "moment: 12" not in told["text"] and "point: E" not in told["text"]
