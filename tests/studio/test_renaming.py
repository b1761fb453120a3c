"""A point or a link under another name: the mechanism stays, and so does every word that is not the name."""

from __future__ import annotations

import random
import re
from pathlib import Path

import pytest

from planes.plans.quantities import quantities_by_name
from planes.scene import loads
from planes.solving import plans_and_requested_results
from planes.solving.of_scene import solve
from planes.studio.answers import answer_to_message
from planes.studio.renaming import text_with_renamed_part
from planes.studio.text_edits import Edited
from planes.words import available_languages
from planes.words.errors import PlanesError
from planes.words.lettering import terminal_spelling
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


@pytest.mark.few(2, slow=20)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_a_mechanism_with_other_names_moves_as_before(path: Path) -> None:
    """Every point and every link renamed, one after another: each of its numbers is the same under its new name."""
    text = now = path.read_text("utf-8")
    mechanism = loads(text).mechanism
    assert mechanism
    points = {p: f"T{k}" for k, p in enumerate(mechanism.point_names)}
    links = {x: f"{k + 31}" for k, x in enumerate(mechanism.links)}
    for kind, names in (("point", points), ("link", links)):
        for name, to in names.items():
            now = text_with_renamed_part(now, kind, name, to).text
    assert re.findall("#.*", now) == re.findall("#.*", text)
    old, new = solve(loads(text)), solve(loads(now))
    assert new.omega == pytest.approx({links[x]: w for x, w in old.omega.items()}, rel=1e-9, abs=1e-12)
    for p, v in old.v.items():
        assert new.v[points[p]] == pytest.approx(v, rel=1e-9, abs=1e-12)
    assert leaves(new.results) == pytest.approx(leaves(old.results), rel=1e-6, abs=1e-9)


def asked_in_letterings(text: str, count: int) -> str:
    """The text with results asked for in the lettering of any sheet: R_63, Φ_2, M_зр, a_CB^τ, in Latin and Cyrillic."""
    text = Edited(text).without_key(("find",)).text
    plans, _ = plans_and_requested_results(loads(text), shown=True)
    known, draw = quantities_by_name(plans), random.Random(7)
    names = plans.default_naming.name_finder(known, poles=False)
    ways = {
        terminal_spelling(way)
        for name in known
        for one in plans.default_naming.other_namings
        for way in one.all_letterings(name)
    }
    ways |= {way.translate(str.maketrans("ABCEKM", "АВСЕКМ")) for way in ways}
    sound = sorted(way for way in ways if names.find_name(way) and re.fullmatch(r"[\w^,]{1,20}", way))
    some = draw.sample(sound, min(count, len(sound)))
    return Edited(text).with_value(("find",), str(some).replace("'", '"')).text


@pytest.mark.few(2, slow=40)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: f"{p.parent.name}-{p.stem}")
def test_results_asked_for_in_any_lettering_follow_their_point(path: Path) -> None:
    """Every point renamed: as many results as before, with the same numbers."""
    text = now = asked_in_letterings(path.read_text("utf-8"), 12)
    mechanism = loads(text).mechanism
    assert mechanism
    for k, point in enumerate(mechanism.point_names):
        now = text_with_renamed_part(now, "point", point, "ZWVUQXYNΔ"[k % 9] + str(k)).text
    old, new = leaves(solve(loads(text)).results), leaves(solve(loads(now)).results)
    assert new == pytest.approx(old, rel=1e-6, abs=1e-9)


@pytest.mark.parametrize(
    ("typed", "now"),
    [
        ("Vc", "v_K"),
        ("v_С", "v_K"),  # Cyrillic
        ("a_CB^τ", "a_KB^t"),
        ("v_c", "v_K"),
        ("F_36", "F_36"),
        ("R_63", "R_63"),
        ("Φ_2", "Φ_2"),
        ("M_зр", "M_зр"),
    ],
)
def test_a_name_typed_in_another_way_is_understood(typed: str, now: str) -> None:
    assert f"find: [{now}]\n" in text_with_renamed_part(f"{SIX}find: [{typed}]\n", "point", "C", "K").text


def test_primed_points_and_links_of_two_digits_are_followed() -> None:
    """A prime belongs to a name; a reaction of link 31 is written with a comma, which is quoted in a list."""
    primed = text_with_renamed_part(f"{SIX}find: [v_C, a_CB^n]\n", "point", "C", "C'").text
    assert "find: [v_C', a_C'B^n]" in primed
    assert "find: [v_K, a_KB^n]" in text_with_renamed_part(primed, "point", "C'", "K").text
    text = text_with_renamed_part(f"{SIX}find: [F_36, F_32]\n", "link", "3", "31").text
    assert 'find: ["F_31,6", "F_31,2"]' in text
    assert leaves(solve(loads(text)).results) == pytest.approx(leaves(solve(loads(f"{SIX}find: [F_36, F_32]")).results))


def test_equations_and_curves_of_the_sheet_follow() -> None:
    """Vectors between points of different links too, which nobody would miss: they would pass for unknown ones."""
    text = f"{SIX}sheet: {{diagrams: [v_H, r_H_x, phi_3], hodographs: [a_H]}}\nequations: [v_HB = v_H - v_B]\n"
    now = text_with_renamed_part(text_with_renamed_part(text, "point", "H", "K").text, "link", "3", "7").text
    assert "diagrams: [v_K, r_K_x, phi_7], hodographs: [a_K]" in now and "[v_KB = v_K - v_B]" in now


def test_a_point_may_have_the_letter_of_a_guides_mark() -> None:
    """Its own mark is then another one, as in any scene with such names."""
    now = text_with_renamed_part(f"{SIX}find: [v_C, a_CB^n]\n", "point", "C", "L").text
    assert solve(loads(now)).v["L"] == solve(loads(SIX)).v["C"]


def test_every_mention_follows_and_nothing_else() -> None:
    """Loads and their laws, masses, what is asked for, equations, friction, assembly; a parameter keeps its name."""
    text = SIX.replace("force: 6000, against: motion", 'force: "3000 + 10*v_H*x_H", direction: 90')
    text += "find: [v_C, a_CB^t, F_32, omega_3]\nfriction: {C: {coefficient: 0.1, radius: 0.01}}\n"
    point = text_with_renamed_part(text, "point", "C", "K").text
    assert (
        "find: [v_K, a_KB^t, F_32, omega_3]" in point and "friction: {K:" in point and "assembly: {K: right}" in point
    )
    assert "through: K" in point and "K: l_BC" in point and "D: 0, K: l_CD" in point
    assert "10*v_T*x_T" in text_with_renamed_part(text, "point", "H", "T").text
    link = text_with_renamed_part(text, "link", "3", "7").text
    assert "find: [v_C, a_CB^t, F_72, omega_7]" in link and "  7: {points: {D: 0" in link
    assert point.count("\n") == text.count("\n") == link.count("\n")


@pytest.mark.parametrize("name", ["B", "y-y", "K L", "", "0"])
@pytest.mark.parametrize("lang", available_languages())
def test_a_name_that_cannot_be_is_refused_in_a_sentence(name: str, lang: str) -> None:
    told = answer_to_message({"ask": "rename", "text": SIX, "lang": lang, "path": ["point", "C"], "value": name})
    assert "text" not in told and len(told["problems"]) == 1 and told["problems"][0]["said"]
    assert name in told["problems"][0]["said"]


def test_a_text_that_is_no_mechanism_yet_is_renamed_too() -> None:
    text = "planes: 1\nframe:\n  points: {A: [0, 0]} # here\nlinks:\n  1: {points: {A: 0, B: 0.1}}\n"
    text += "  2: {points: {B: 0, C: 1}}\n"
    assert text_with_renamed_part(text, "point", "B", "K").text == text.replace("B", "K")
    with pytest.raises(PlanesError, match="Z"):
        text_with_renamed_part(text, "point", "Z", "K")
