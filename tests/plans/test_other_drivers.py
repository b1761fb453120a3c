"""Which other driver makes a mechanism of a higher class a lower one: found, said, and true of it."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations, pairwise

import pytest

from planes.cli import main
from planes.plans import structure_of
from planes.plans.assur.analysis import analyse_structure
from planes.scene import load, loads
from planes.scene.mechanism import Drive, Mechanism
from planes.words.errors import StructureError
from tests.helpers import ROOT

SAMPLES = (
    *(f"class-three/{n}" for n in ("guide", "press", "rods", "slider", "stephenson", "truss")),
    "class-four/tray",
)
CHAIN = """\
planes: 1
frame: {points: {O: [0, 0], E: [0.5, 0.3], F: [0.9, -0.3], G: [1.3, 0.2]}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.3}}
  3: {points: {B: 0, C: [0.2, 0.1]}, guides: {d: {through: [0.2, -0.12], angle: 50}}}
  4: {points: {E: 0, C: 0.25}}
  5: {slides: d, points: {D: 0, H: [0.3, 0], J: [0.2, 0.1]}}
  6: {points: {F: 0, H: 0.25}}
  7: {points: {G: 0, J: 0.3}}
drive: {link: 1, phi: 60, omega: 10}
"""


def mechanism(sample: str) -> Mechanism:
    found = load(str(ROOT / "samples" / f"{sample}.yaml")).mechanism
    assert found
    return found


def pairs(m: Mechanism) -> list[tuple[str, str]]:
    """The pairs of links, each by the two it joins."""
    holders: dict[str, list[str]] = {}
    for link in (m.frame, *m.links.values()):
        for point in link.points:
            holders.setdefault(point, []).append(link.name)
    slides = [(x.name, m.owner_of_guide(x.slides.guide)) for x in m.links.values() if x.slides]
    return [(a, b) for held in holders.values() for a, b in pairwise(held)] + slides


def heaviest(m: Mechanism, driver: str) -> int:
    """The links of the largest group, another way: each time the smallest set that is fixed on what is solved."""
    joined, solved, most = pairs(m), {m.frame.name, driver}, 0
    while left := [x for x in m.links if x not in solved]:
        for size in range(1, len(left) + 1):
            some = next((c for c in combinations(left, size) if fixed(set(c), solved, joined)), None)
            if some:
                solved, most = solved | set(some), max(most, size)
                break
    return most


def fixed(some: set[str], solved: set[str], joined: list[tuple[str, str]]) -> bool:
    inside = sum(bool({a, b} & some) and {a, b} <= some | solved for a, b in joined)
    return 3 * len(some) == 2 * inside


@pytest.mark.parametrize("sample", SAMPLES)
def test_drivers_found_are_those_with_which_smaller_groups_come_off(sample: str) -> None:
    m = mechanism(sample)
    grounded = {a if b == m.frame.name else b for a, b in pairs(m) if m.frame.name in (a, b)} - {m.drive.link}
    assert heaviest(m, m.drive.link) == 4
    two = {w.driver for w in structure_of(m).ways if w.mechanism_class == "II"}
    assert two == {link for link in grounded if heaviest(m, link) == 2}
    for way in structure_of(m).ways:
        slides = (m.links[way.driver].name, m.frame.name) in pairs(m) and m.links[way.driver].slides
        on_frame = slides and m.owner_of_guide(slides.guide) == m.frame.name
        again = analyse_structure(replace(m, drive=Drive(way.driver, "s" if on_frame else "phi", 0.0)))
        assert (again.structural_formula, again.mechanism_class) == (way.structural_formula, way.mechanism_class)


def test_a_contour_becomes_of_class_three() -> None:
    (way,) = structure_of(mechanism("class-four/tray")).ways
    assert (way.driver, way.structural_formula) == ("3", "I(0;3) -> III(1;2;4;5)")


def test_of_class_two_nothing_is_said() -> None:
    assert structure_of(mechanism("six-link")).ways == ()


def test_a_refused_chain_is_told_the_drivers_that_serve() -> None:
    m = loads(CHAIN).mechanism
    assert m
    with pytest.raises(StructureError) as caught:
        structure_of(m)
    said = str(caught.value)
    assert "link 6, I(0;6) -> II(5;7) -> II(3;4) -> II(1;2); link 7" in said
    for driver in "467":
        assert analyse_structure(replace(m, drive=replace(m.drive, link=driver))).class_index == (driver == "4")


@pytest.mark.parametrize("lang", ["ru", "en", "uk", "be"])
def test_it_is_printed_in_every_language(lang: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["structure", str(ROOT / "samples" / "class-three" / "press.yaml"), "--lang", lang]) == 0
    said = capsys.readouterr().out
    assert "I(0;4) -> II(3;5) -> II(1;2)" in said and "I(0;5) -> II(3;4) -> II(1;2)" in said
