"""A point or a link under another name: the mechanism stays, and so does every word that is not the name."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from planes.scene import loads
from planes.solving.of_scene import solve
from planes.studio.answers import answer
from planes.studio.renaming import renamed
from planes.words import langs
from planes.words.errors import PlanesError
from tests.sample_oracle import SAMPLES

SCENES = [
    p
    for p in sorted(SAMPLES.rglob("*.yaml"))
    if "\nlinks:" in p.read_text("utf-8") and p.stem != "three-basic-links"  # searched: seconds each time it is read
]
SIX = (SAMPLES / "six-link.yaml").read_text("utf-8")


def leaves(thing: object) -> list[float]:
    """Every number of nested tables and lists, in order."""
    if isinstance(thing, dict | list | tuple):
        return [n for one in (thing.values() if isinstance(thing, dict) else thing) for n in leaves(one)]
    return [abs(thing)] if isinstance(thing, float) else []


@pytest.mark.few(4, slow=20)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_a_mechanism_with_other_names_moves_as_before(path: Path) -> None:
    """Every point and every link renamed, one after another: each of its numbers is the same under its new name."""
    text = now = path.read_text("utf-8")
    mechanism = loads(text).mechanism
    assert mechanism
    points = {p: f"T{k}" for k, p in enumerate(mechanism.names)}
    links = {x: f"{k + 31}" for k, x in enumerate(mechanism.links)}
    for kind, names in (("point", points), ("link", links)):
        for name, to in names.items():
            now = renamed(now, kind, name, to).text
    assert re.findall("#.*", now) == re.findall("#.*", text)
    old, new = solve(loads(text)), solve(loads(now))
    assert new.omega == pytest.approx({links[x]: w for x, w in old.omega.items()}, rel=1e-9, abs=1e-12)
    for p, v in old.v.items():
        assert new.v[points[p]] == pytest.approx(v, rel=1e-9, abs=1e-12)
    assert leaves(new.results) == pytest.approx(leaves(old.results), rel=1e-6, abs=1e-9)


def test_every_mention_follows_and_nothing_else() -> None:
    """Loads and their laws, masses, what is asked for, equations, friction, assembly; a parameter keeps its name."""
    text = SIX.replace("force: 6000, against: motion", 'force: "3000 + 10*v_H*x_H", direction: 90')
    text += "find: [v_C, a_CB^t, F_32, omega_3]\nfriction: {C: {coefficient: 0.1, radius: 0.01}}\n"
    point = renamed(text, "point", "C", "K").text
    assert (
        "find: [v_K, a_KB^t, F_32, omega_3]" in point and "friction: {K:" in point and "assembly: {K: right}" in point
    )
    assert "through: K" in point and "K: l_BC" in point and "D: 0, K: l_CD" in point
    assert "10*v_T*x_T" in renamed(text, "point", "H", "T").text
    link = renamed(text, "link", "3", "7").text
    assert "find: [v_C, a_CB^t, F_72, omega_7]" in link and "  7: {points: {D: 0" in link
    assert point.count("\n") == text.count("\n") == link.count("\n")


@pytest.mark.parametrize("name", ["B", "y-y", "K L", "", "0"])
@pytest.mark.parametrize("lang", langs())
def test_a_name_that_cannot_be_is_refused_in_a_sentence(name: str, lang: str) -> None:
    told = answer({"ask": "rename", "text": SIX, "lang": lang, "path": ["point", "C"], "value": name})
    assert "text" not in told and len(told["problems"]) == 1 and told["problems"][0]["said"]
    assert name in told["problems"][0]["said"]


def test_a_text_that_is_no_mechanism_yet_is_renamed_too() -> None:
    text = "planes: 1\nframe:\n  points: {A: [0, 0]} # here\nlinks:\n  1: {points: {A: 0, B: 0.1}}\n"
    text += "  2: {points: {B: 0, C: 1}}\n"
    assert renamed(text, "point", "B", "K").text == text.replace("B", "K")
    with pytest.raises(PlanesError, match="Z"):
        renamed(text, "point", "Z", "K")
