"""One part of a text changed: everything else stays as it was written."""

import pytest
import yaml

from planes.studio.text_edits import Edited

TEXT = """planes: 1
title: A crank   # said here
parameters: {l_AB: 0.1, phi_1: 50}
links:
  1: {points: {A: 0, B: l_AB}}  # the crank
  2:
    points: {B: 0, C: 0.3}
    mass: 2   # kg
loads:
  - {link: 2, point: C, force: 5, direction: 0}
gravity: 9.81
"""


@pytest.mark.parametrize(
    ("path", "value", "old", "new"),
    [
        (("parameters", "l_AB"), "0.12", "l_AB: 0.1,", "l_AB: 0.12,"),
        (("links", "2", "mass"), "3", "mass: 2 ", "mass: 3 "),
        (("links", "1", "mass"), "3", "B: l_AB}}", "B: l_AB}, mass: 3}"),
        (("links", "2", "inertia"), "1", "mass: 2   # kg\n", "mass: 2   # kg\n    inertia: 1\n"),
        (("links", "2", "points"), "{B: 0, C: 1}", "C: 0.3", "C: 1"),
        (("loads", "0", "force"), "7", "force: 5", "force: 7"),
        (("assembly", "C"), "left", "gravity: 9.81\n", "gravity: 9.81\nassembly: {C: left}\n"),
        (("links", "3"), "{points: {C: 0}}", "# kg\n", "# kg\n  3: {points: {C: 0}}\n"),
    ],
)
def test_a_part_is_put_and_nothing_else_is_touched(path: tuple[str, ...], value: str, old: str, new: str) -> None:
    edited = Edited(TEXT).with_value(path, value)
    assert edited.text == TEXT.replace(old, new, 1) and TEXT.count(old) == 1
    changed = [k for k, line in enumerate(edited.text.splitlines(), 1) if line not in TEXT.splitlines()]
    assert list(edited.lines) == changed


def test_a_part_is_left_out_with_its_line() -> None:
    assert Edited(TEXT).without_key(("links", "2", "mass")).text == TEXT.replace("    mass: 2   # kg\n", "")
    assert Edited(TEXT).without_key(("parameters", "l_AB")).text == TEXT.replace("l_AB: 0.1, ", "")
    assert Edited(TEXT).without_key(("parameters", "phi_1")).text == TEXT.replace(", phi_1: 50", "")
    assert Edited(TEXT).without_key(("loads", "0")).text == TEXT.replace(
        "loads:\n  - {link: 2, point: C, force: 5, direction: 0}\n", ""
    )
    assert Edited(TEXT).without_key(("assembly", "C")).text == TEXT


def test_an_item_is_added_to_a_list_or_makes_one() -> None:
    more = Edited(TEXT).with_item(("loads",), "{link: 1, moment: 4}")
    assert yaml.safe_load(more.text)["loads"][1] == {"link": 1, "moment": 4} and more.text.startswith(TEXT[:200])
    fresh = Edited("planes: 1\n").with_item(("loads",), "{link: 1, moment: 4}")
    assert yaml.safe_load(fresh.text)["loads"] == [{"link": 1, "moment": 4}]
    assert yaml.safe_load(fresh.with_item(("loads",), "{link: 2, moment: 1}").text)["loads"][1]["link"] == 2


def test_an_empty_text_becomes_one() -> None:
    assert yaml.safe_load(Edited("").with_value(("links", "1", "mass"), "2").text) == {"links": {1: {"mass": 2}}}
