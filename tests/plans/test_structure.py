"""Pairs, freedom, redundant constraints, groups of five kinds in any order, and refusals that name the links."""

from __future__ import annotations

import random
from typing import Any

import pytest
from hypothesis import given, settings

from planes.plans.structure import KIND_NAMES, Structure, analyse
from planes.scene import loads
from planes.words.errors import SceneError, StructureError
from tests.helpers.mechanisms import KINDS, Case, make, mechanisms, to_yaml
from tests.solving.test_failures import CROSS_SLIDE, FOUR_BAR, ROCKER, SLIDER

SHEARS = """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x: {y: -0.3}, y: {x: 0.5}}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.45, E: [0.2, 0.1]}, guides: {g: {through: E, angle: 10}}}
  3: {points: {C: 0}, slides: x}
  4: {points: {H: 0}, slides: g}
  5: {points: {H: 0}, slides: y}
drive: {link: 1, phi: 70}
"""


def structure(text: str) -> Structure:
    scene = loads(text)
    assert scene.mechanism
    return analyse(scene.mechanism, "scene.yaml")


def refusal(text: str) -> str:
    with pytest.raises(StructureError) as caught:
        structure(text)
    return str(caught.value)


@pytest.mark.parametrize(
    "text, kind, links",
    [
        (FOUR_BAR, "RRR", ("2", "3")),
        (SLIDER, "RRP", ("2", "3")),
        (ROCKER, "RPR", ("2", "3")),
        (CROSS_SLIDE, "PRP", ("2", "3")),
    ],
)
def test_one_group(text: str, kind: str, links: tuple[str, str]) -> None:
    s = structure(text)
    assert (s.W, s.q, s.formula) == (1, 1 - 18 + 20, f"I(0;1) -> II({';'.join(links)})")
    (group,) = s.groups
    assert (group.name, group.kind, group.links) == (kind, KIND_NAMES.index(kind) + 1, links)
    assert len(s.pairs) == 4 and s.pairs[0] == s.drive_pair and s.driver == "1"


def test_a_crank_alone_has_no_groups() -> None:
    s = structure("planes: 1\nframe: {points: {A: [0, 0]}}\nlinks: {1: {points: {A: 0}}}\ndrive: {link: 1, phi: 0}\n")
    assert (s.W, s.q, s.formula, s.groups) == (1, 0, "I(0;1)", ())


def test_groups_stand_in_the_order_they_attach() -> None:
    s = structure(SHEARS)
    assert s.formula == "I(0;1) -> II(2;3) -> II(4;5)"
    assert [g.name for g in s.groups] == ["RRP", "PRP"]
    assert (s.W, s.q) == (1, 1 - 30 + 35)
    assert s.groups[1].first_outer.other == "2" and s.groups[1].last_outer.other == "0"


def test_a_hinge_of_three_links_is_two_pairs() -> None:
    text = FOUR_BAR.replace(
        "assembly", "  4: {points: {C: 0, E: 0.3}}\n  5: {points: {E: 0, F: 0.2}}\nassembly"
    ).replace("D: [0.4, 0]", "D: [0.4, 0], F: [0.6, 0.4]")
    s = structure(text)
    assert s.formula == "I(0;1) -> II(2;3) -> II(4;5)"
    hinges = [p for p in s.pairs if p.point == "C"]
    assert [(p.link, p.other) for p in hinges] == [("3", "2"), ("4", "2")]


def test_two_groups_on_one_hinge_of_the_frame() -> None:
    s = structure(
        FOUR_BAR.replace("assembly", "  4: {points: {C: 0, E: 0.3}}\n  5: {points: {E: 0, A: 0.2}}\nassembly")
    )
    assert [p.other for p in s.pairs if p.point == "A"] == ["0", "0"]
    assert s.formula == "I(0;1) -> II(2;3) -> II(4;5)"


@settings(max_examples=120)
@given(mechanisms(most=3, loads=False))
def test_groups_of_random_chains_are_those_they_were_made_of(case: Case) -> None:
    s = structure(to_yaml(case.scene))
    assert s.W == 1
    assert s.q == 1 - 6 * len(case.scene["links"]) + 5 * len(s.pairs)
    assert 2 * len(s.pairs) == 3 * len(case.scene["links"]) - 1
    made = {frozenset((i, j)): kind for kind, i, j in case.groups}
    assert {frozenset(g.links): g.name for g in s.groups} == made
    assert [frozenset(g) for g in case.solution.groups] == [frozenset(g.links) for g in s.groups]
    assert {(p.link, p.other) for p in s.pairs} == set(case.solution.reactions)
    done = {"0", s.driver}
    for g in s.groups:
        assert {g.first, g.last} == set(g.links) and g.links == tuple(x for x in case.scene["links"] if x in g.links)
        for pair, link in ((g.first_outer, g.first), (g.last_outer, g.last)):
            assert pair.joins(link) and pair.mate(link) in done
        assert g.inner.joins(g.first) and g.inner.joins(g.last)
        done |= set(g.links)


@pytest.mark.parametrize("kind", KINDS)
def test_the_order_of_links_in_the_file_does_not_change_the_groups(kind: str) -> None:
    for seed in range(6):
        case = make(random.Random(seed), [kind, "RRR", "RRP"], loads=False)
        names = list(case.scene["links"])
        found = set()
        for shuffle in range(8):
            random.Random(shuffle).shuffle(names)
            scene: dict[str, Any] = {**case.scene, "links": {n: case.scene["links"][n] for n in names}}
            s = structure(to_yaml(scene))
            found.add(frozenset((frozenset(g.links), g.kind) for g in s.groups))
        assert len(found) == 1


def test_class_three_names_its_links() -> None:
    text = """\
planes: 1
frame: {points: {A: [0, 0], E: [1, 0], F: [0, 1]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.3}}
  3: {points: {C: 0, G: 0.3, K: [0.1, 0.2]}}
  4: {points: {G: 0, E: 0.3}}
  5: {points: {K: 0, F: 0.3}}
drive: {link: 1, phi: 0}
"""
    assert refusal(text) == (
        "scene.yaml:5: links 2, 3, 4, 5 form an Assur group of class III or higher, which plans of class II groups "
        "cannot draw: take another link as the driver or change the mechanism"
    )


def test_too_much_freedom_and_too_little_tell_the_pairs() -> None:
    loose = refusal(FOUR_BAR.replace("{D: 0, C: 0.3}", "{D: 0, G: 0.3}"))
    assert "the mechanism has W = 3·3 - 2·3 = 3, one drive needs W = 1; a link or a pair is missing" in loose
    assert "A of links 0, 1; D of links 0, 3; B of links 1, 2" in loose
    held = refusal(FOUR_BAR.replace("{B: 0, C: 0.3}", "{B: 0, C: 0.3, D: 0.4}"))
    assert "W = 3·3 - 2·5 = -1, one drive needs W = 1; it has 2 constraint(s) too many: check" in held
    assert held.startswith("scene.yaml:5: ")
    assert "D of links 0, 2, 3" in held
    slides = refusal(SLIDER.replace("{points: {C: 0}, slides: x-x", "{points: {G: 0}, slides: x-x"))
    assert "3 slides on x-x of 0" in slides


def test_one_part_held_and_another_loose() -> None:
    """W = 1 in all, but links 2 and 3 lock each other while 4 and 5 hang."""
    text = """\
planes: 1
frame: {points: {A: [0, 0], D: [0.4, 0], E: [0, 1]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.3, D: 0.4}}
  3: {points: {D: 0, C: 0.3}}
  4: {points: {E: 0, F: 0.1}}
  5: {points: {F: 0, G: 0.1}}
drive: {link: 1, phi: 0}
"""
    said = refusal(text.replace("F: 0, G: 0.1", "F: 0, B: 0.1"))
    assert "scene.yaml:" in said and "links 2" in said and "too many" in said


def test_three_sliding_pairs_are_refused() -> None:
    text = """\
planes: 1
frame: {points: {A: [0, 0]}, guides: {x: {y: 1}}}
links:
  1: {points: {A: 0}, guides: {g: {y: 0}}}
  2: {points: {C: 0}, slides: g, guides: {h: {x: 0}}}
  3: {points: {E: 0}, slides: h, guides: {k: {x: 0}}}
drive: {link: 1, phi: 30}
"""
    said = refusal(
        text.replace("slides: h, guides: {k: {x: 0}}", "slides: h")
        .replace("1: {points: {A: 0}, guides: {g: {y: 0}}}", "1: {points: {A: 0}, slides: k, guides: {g: {y: 0}}}")
        .replace("slides: h}", "slides: h, guides: {k: {x: 0}}}")
    )
    assert "links 2 and 3" in said and "three sliding pairs" in said and "make one of the pairs a hinge" in said


@pytest.mark.parametrize(
    "drive, says",
    [
        ("{link: 2, phi: 0}", "needs exactly one hinge on the frame, but what joins it to the frame is: none"),
        ("{link: 3, phi: 0}", "one hinge on the frame, but what joins it to the frame is: guide x-x (a sliding pair)"),
        ("{link: 3, s: 0.1}", None),
    ],
)
def test_the_driver_needs_one_fitting_pair_with_the_frame(drive: str, says: str | None) -> None:
    text = SLIDER.replace("{link: 1, phi: 30, omega: 10}", drive)
    if says:
        assert says in refusal(text)
    else:
        assert structure(text).formula == "I(0;3) -> II(1;2)"


def test_a_driver_with_two_hinges_on_the_frame_is_refused() -> None:
    text = SHEARS.replace("{A: [0, 0]}", "{A: [0, 0], Z: [1, 1]}").replace("{A: 0, B: 0.1}", "{A: 0, B: 0.1, Z: 1}")
    text = text.replace("  5: {points: {H: 0}, slides: y}", "  5: {points: {H: 0}}")
    assert "needs exactly one hinge on the frame, but what joins it to the frame is: hinge A, hinge Z" in refusal(text)


def test_s_needs_a_guide_of_the_frame() -> None:
    with pytest.raises(SceneError, match="link 1 slides on no guide of the frame"):
        loads(SLIDER.replace("{link: 1, phi: 30, omega: 10}", "{link: 1, s: 0.1}"))


def test_links_that_share_no_driven_point_are_named() -> None:
    text = """\
planes: 1
frame: {points: {A: [0, 0], D: [1, 0], E: [2, 0]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {D: 0, F: 0.5, G: [0.1, 0.1]}}
  3: {points: {E: 0, F: 0.5, G: [0.1, 0.2]}}
  4: {points: {B: 0, H: 1}}
  5: {points: {H: 0, K: 1}}
drive: {link: 1, phi: 0}
"""
    said = refusal(text)
    assert said.startswith("scene.yaml:5: ") and "links 2, 3 are held by 1 pair(s) too many" in said
