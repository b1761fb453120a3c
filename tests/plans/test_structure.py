"""Pairs, freedom, redundant constraints, groups of five kinds in any order, and refusals that name the links."""

from __future__ import annotations

import random
import re
import tracemalloc
from collections.abc import Callable
from itertools import combinations
from typing import Any

import pytest
from hypothesis import given, settings

from planes.plans.assur.analysis import analyse_structure
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import DYAD_KIND_NAMES
from planes.plans.assur.structure import Structure
from planes.plans.assur.unsolvable import Joint, degree_of_freedom_of_links, find_unsolvable_links
from planes.plans.quantities import Quantity
from planes.scene import loads
from planes.solving import solve
from planes.words.errors import SceneError, StructureError
from tests.diagrams.test_degenerate import chain
from tests.helpers import ROOT
from tests.helpers.counting import at_most
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


LOOSE_CHAIN = """\
planes: 1
frame: {points: {O: [0, 0], P: [1, 0], Q: [1.2, 0.3]}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.3}}
  3: {points: {B: 0, C: 0.3}}
  4: {points: {C: 0, D: 0.3}}
  5: {points: {D: 0, P: 0.2, Q: [0.4, 0.1]}}
drive: {link: 1, phi: 40}
"""
"""W = 1, link 5 held twice, links 2, 3 and 4 loose: as many links and pairs as a closed contour has."""


def structure(text: str) -> Structure:
    scene = loads(text)
    assert scene.mechanism
    return analyse_structure(scene.mechanism, "scene.yaml")


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
    assert (s.W, s.q, s.structural_formula) == (1, 1 - 18 + 20, f"I(0;1) -> II({';'.join(links)})")
    (group,) = s.groups
    assert (group.pair_letters, group.kind, group.links) == (kind, DYAD_KIND_NAMES.index(kind) + 1, links)
    assert len(s.pairs) == 4 and s.pairs[0] == s.drive_pair and s.driver == "1"


def test_a_crank_alone_has_no_groups() -> None:
    s = structure("planes: 1\nframe: {points: {A: [0, 0]}}\nlinks: {1: {points: {A: 0}}}\ndrive: {link: 1, phi: 0}\n")
    assert (s.W, s.q, s.structural_formula, s.groups) == (1, 0, "I(0;1)", ())


def test_groups_stand_in_the_order_they_attach() -> None:
    s = structure(SHEARS)
    assert s.structural_formula == "I(0;1) -> II(2;3) -> II(4;5)"
    assert [g.pair_letters for g in s.groups] == ["RRP", "PRP"]
    assert (s.W, s.q) == (1, 1 - 30 + 35)
    assert s.groups[1].first_outer.other == "2" and s.groups[1].last_outer.other == "0"


def test_a_hinge_of_three_links_is_two_pairs() -> None:
    text = FOUR_BAR.replace(
        "assembly", "  4: {points: {C: 0, E: 0.3}}\n  5: {points: {E: 0, F: 0.2}}\nassembly"
    ).replace("D: [0.4, 0]", "D: [0.4, 0], F: [0.6, 0.4]")
    s = structure(text)
    assert s.structural_formula == "I(0;1) -> II(2;3) -> II(4;5)"
    hinges = [p for p in s.pairs if p.point == "C"]
    assert [(p.link, p.other) for p in hinges] == [("3", "2"), ("4", "2")]


def test_two_groups_on_one_hinge_of_the_frame() -> None:
    s = structure(
        FOUR_BAR.replace("assembly", "  4: {points: {C: 0, E: 0.3}}\n  5: {points: {E: 0, A: 0.2}}\nassembly")
    )
    assert [p.other for p in s.pairs if p.point == "A"] == ["0", "0"]
    assert s.structural_formula == "I(0;1) -> II(2;3) -> II(4;5)"


@pytest.mark.slow
@settings(max_examples=120)
@given(mechanisms(most=3, loads=False))
def test_groups_of_random_chains_are_those_they_were_made_of(case: Case) -> None:
    s = structure(to_yaml(case.scene))
    assert s.W == 1
    assert s.q == 1 - 6 * len(case.scene["links"]) + 5 * len(s.pairs)
    assert 2 * len(s.pairs) == 3 * len(case.scene["links"]) - 1
    made = {frozenset((i, j)): kind for kind, i, j in case.groups}
    assert {frozenset(g.links): g.pair_letters for g in s.groups} == made
    assert [frozenset(g) for g in case.solution.groups] == [frozenset(g.links) for g in s.groups]
    assert {(p.link, p.other) for p in s.pairs} == set(case.solution.reactions)
    done = {"0", s.driver}
    for g in s.groups:
        assert {g.first, g.last} == set(g.links) and g.links == tuple(x for x in case.scene["links"] if x in g.links)
        for pair, link in ((g.first_outer, g.first), (g.last_outer, g.last)):
            assert pair.has_link(link) and pair.other_link_of_pair(link) in done
        assert g.inner.has_link(g.first) and g.inner.has_link(g.last)
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


CLASS_THREE = """\
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


def test_class_three_names_its_basic_link_and_leads() -> None:
    s = structure(CLASS_THREE)
    (group,) = s.groups
    assert isinstance(group, Triad) and s.class_two_groups == ()
    assert (group.basic, [lead.link for lead in group.leads], group.pair_letters) == ("3", ["2", "4", "5"], "RR-RR-RR")
    assert (s.W, s.q, s.structural_formula) == (1, 6, "I(0;1) -> III(2;3;4;5)")
    assert s.json()["groups"] == [
        {
            "links": ["2", "3", "4", "5"],
            "class": 3,
            "order": 3,
            "basic": "3",
            "leads": ["2", "4", "5"],
            "name": "RR-RR-RR",
        }
    ]


CONTOUR = """\
planes: 1
frame: {points: {A: [0, 0], E: [1, 0]}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.3, D: [0.1, 0.2]}}
  3: {points: {C: 0, G: 0.3}}
  4: {points: {G: 0, E: 0.3, K: [0.1, 0.2]}}
  5: {points: {K: 0, D: 0.3}}
drive: {link: 1, phi: 0}
"""


def test_class_four_names_its_contour() -> None:
    found = analyse_structure(loads(CONTOUR).mechanism)
    assert found.structural_formula == "I(0;1) -> IV(2;3;4;5)"
    wanted = {"class": 4, "order": 2, "contour": ["2", "3", "4", "5"], "outer": ["2", "4"], "name": "RR-RRRR"}
    assert found.groups[0].json() == {"links": ["2", "3", "4", "5"], **wanted}


def test_a_contour_that_slides_names_its_pairs() -> None:
    text = CONTOUR.replace("5: {points: {K: 0, D: 0.3}}", "5: {points: {K: 0}, slides: d}")
    text = text.replace("D: [0.1, 0.2]}}", "D: [0.1, 0.2]}, guides: {d: {through: D, angle: 30}}}")
    assert [g.pair_letters for g in analyse_structure(loads(text).mechanism).groups] == ["RR-RRPR"]


def test_a_contour_may_hang_on_two_guides() -> None:
    text = CONTOUR.replace("E: [1, 0]}}", "E: [1, 0]}, guides: {x-x: {y: 0}}}").replace("G: 0, E: 0.3, K", "G: 0, K")
    text = text.replace("K: [0.1, 0.2]}}", "K: [0.1, 0.2]}, slides: x-x}")
    text = text.replace("{A: 0, B: 0.1}}", "{A: 0, B: 0.1}, guides: {u: {through: B, angle: 40}}}")
    text = text.replace("2: {points: {B: 0, C: 0.3, D: [0.1, 0.2]}}", "2: {points: {C: 0, D: [0.1, 0.2]}, slides: u}")
    assert [g.pair_letters for g in analyse_structure(loads(text).mechanism).groups] == ["PP-RRRR"]


def test_too_much_freedom_and_too_little_tell_the_pairs() -> None:
    loose = refusal(FOUR_BAR.replace("{D: 0, C: 0.3}", "{D: 0, G: 0.3}"))
    assert "the mechanism has W = 3·3 - 2·3 = 3, but one drive needs W = 1; a link or a pair is missing" in loose
    assert "A of links 0, 1; D of links 0, 3; B of links 1, 2" in loose
    held = refusal(FOUR_BAR.replace("{B: 0, C: 0.3}", "{B: 0, C: 0.3, D: 0.4}"))
    assert "W = 3·3 - 2·5 = -1, but one drive needs W = 1; it has 2 constraint(s) too many: check" in held
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
        ("{link: 2, phi: 0}", "needs exactly one hinge on the frame, but it is joined to the frame by: none"),
        ("{link: 3, phi: 0}", "one hinge on the frame, but it is joined to the frame by: guide x-x (a sliding pair)"),
        ("{link: 3, s: 0.1}", None),
    ],
)
def test_the_driver_needs_one_fitting_pair_with_the_frame(drive: str, says: str | None) -> None:
    text = SLIDER.replace("{link: 1, phi: 30, omega: 10}", drive)
    if says:
        assert says in refusal(text)
    else:
        assert structure(text).structural_formula == "I(0;3) -> II(1;2)"


def test_a_driver_with_two_hinges_on_the_frame_is_refused() -> None:
    text = SHEARS.replace("{A: [0, 0]}", "{A: [0, 0], Z: [1, 1]}").replace("{A: 0, B: 0.1}", "{A: 0, B: 0.1, Z: 1}")
    text = text.replace("  5: {points: {H: 0}, slides: y}", "  5: {points: {H: 0}}")
    assert "needs exactly one hinge on the frame, but it is joined to the frame by: hinge A, hinge Z" in refusal(text)


def test_s_needs_a_guide() -> None:
    with pytest.raises(SceneError, match="link 1 slides on no straight guide"):
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
    assert said.startswith("scene.yaml:5: ") and "links 2, 3 have 1 pair(s) too many" in said


# what holds a mechanism up, and how much work it is to say so


def ring(sides: int) -> str:
    """A crank and one group of a ring of links, each on a leg: none of them can be solved without all the others."""
    pivots = ", ".join(f"D{k}: [{k}, 1]" for k in range(1, sides))
    rows = ["  1: {points: {A: 0, D0: 0.1}}\n"]
    for k in range(sides):
        rows.append(f"  T{k}: {{points: {{R{k}: 0, R{(k + 1) % sides}: 1, L{k}: [0.5, 0.5]}}}}\n")
        rows.append(f"  P{k}: {{points: {{D{k}: 0, L{k}: 1}}}}\n")
    text = f"planes: 1\nframe: {{points: {{A: [0, 0], {pivots}}}}}\nlinks:\n{''.join(rows)}"
    return text + "drive: {link: 1, phi: 0}\n"


@pytest.mark.slow
def test_a_large_group_is_refused_with_work_as_links_squared() -> None:
    counts = []
    for sides in (10, 20, 40):
        with at_most(3_000_000) as made:
            said = refusal(ring(sides))
        assert f"links {', '.join(f'T{k}, P{k}' for k in range(sides))} form an Assur group of a high class" in said
        counts.append(made[0])
    assert counts[1] < 4.5 * counts[0] and counts[2] < 4.5 * counts[1]


def test_of_two_groups_the_smaller_is_named() -> None:
    large, small = ring(5), ring(3)
    for name in ("T", "P", "D", "R", "L"):
        small = re.sub(rf"\b{name}(\d)", rf"{name.lower()}\1", small)
    links = small.partition("links:\n")[2].partition("drive")[0].partition("\n")[2]
    pivots = small.partition("A: [0, 0], ")[2].partition("}")[0]
    text = large.replace("A: [0, 0],", f"A: [0, 0], d0: [9, 9], {pivots},").replace("drive", links + "drive")
    assert "links t0, p0, t1, p1, t2, p2 form an Assur group" in refusal(text)


@pytest.mark.parametrize("seed", range(60))
def test_links_named_as_over_constrained_or_as_one_group_are_so(seed: int) -> None:
    rng = random.Random(seed)
    links = [str(k) for k in range(rng.choice((4, 4, 6)))]
    joints: list[Joint] = []
    while 2 * sum(joint.pairs_among_links(links) for joint in joints) < 3 * len(links):
        some = rng.sample(links, rng.choice((1, 2, 2, 2, 3)))
        joint = Joint(tuple(some), len(some) == 1 or rng.random() < 0.2)
        if 2 * sum(j.pairs_among_links(links) for j in (*joints, joint)) <= 3 * len(links):
            joints.append(joint)
    parts = [c for size in range(1, len(links) + 1) for c in combinations(links, size)]
    least = min(degree_of_freedom_of_links(part, joints) for part in parts)
    named = find_unsolvable_links(links, joints)
    assert (degree_of_freedom_of_links(named, joints) < 0) == (least < 0)
    if least == 0 and named:
        closed = [part for part in parts if degree_of_freedom_of_links(part, joints) == 0]
        assert named in closed and not any(set(part) < set(named) and len(part) > 2 for part in closed)


def star(dyads: int) -> str:
    """A crank with so many dyads on its one hinge."""
    pivots = ", ".join(f"D{k}: [0.3, {0.001 * k:.3f}]" for k in range(dyads))
    rows = [
        f"  c{k}: {{points: {{B: 0, C{k}: 0.3}}}}\n  d{k}: {{points: {{D{k}: 0, C{k}: 0.25}}}}\n" for k in range(dyads)
    ]
    sides = ", ".join(f"C{k}: left" for k in range(dyads))
    return (
        f"planes: 1\nframe: {{points: {{A: [0, 0], {pivots}}}}}\nlinks:\n  1: {{points: {{A: 0, B: 0.1}}}}\n"
        f"{''.join(rows)}assembly: {{{sides}}}\ndrive: {{link: 1, phi: 60}}\n"
    )


def shuffled(text: str) -> str:
    """The scene with its links in another order."""
    before, rest = text.split("links:\n")
    rows, after = rest.split("assembly")
    lines = rows.splitlines(keepends=True)
    random.Random(5).shuffle(lines)
    return f"{before}links:\n{''.join(lines)}assembly{after}"


@pytest.mark.parametrize("make", [chain, lambda n: chain(n, backwards=True), lambda n: shuffled(chain(n)), star])
def test_structure_of_any_order_takes_work_as_links_squared_at_most(make: Callable[[int], str]) -> None:
    counts = []
    for dyads in (10, 25, 50, 100):  # 21, 51, 101, 201 links
        mechanism = loads(make(dyads)).mechanism
        assert mechanism
        with at_most(120_000) as made:
            assert len(analyse_structure(mechanism).groups) == dyads
        counts.append(made[0] / (2 * dyads + 1) ** 2)
    assert max(counts) == counts[0]


@pytest.mark.slow
@pytest.mark.parametrize("kinds", [["RRR"], list(KINDS)])
def test_all_plans_of_a_chain_take_work_and_memory_as_its_links(kinds: list[str]) -> None:
    calls, sizes = [], []
    for dyads in (10, 25):
        case = make(random.Random(1), kinds * (dyads // len(kinds)), sliding=False)
        scene = loads(to_yaml(case.scene))
        assert solve(scene).positions  # its names are kept for the next time
        tracemalloc.start()
        assert solve(scene).positions
        sizes.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
        with at_most(1_000_000) as made:
            assert solve(loads(to_yaml(case.scene))).positions
        calls.append(made[0])
    assert calls[1] < 3 * calls[0] and sizes[1] < 3 * sizes[0] and sizes[1] < 10e6


def test_two_rods_in_one_hinge_of_the_base_are_no_contour() -> None:
    """They are one body with the basic link then: the figure is a triangle that nothing turns in."""
    tray = (ROOT / "samples" / "class-four" / "tray.yaml").read_text(encoding="utf-8")
    mechanism = loads(tray, "s.yaml").mechanism
    assert mechanism and [group.level for group in analyse_structure(mechanism).groups] == ["IV"]
    mechanism = loads(tray.replace("5: {points: {D: 0,", "5: {points: {B: 0,"), "s.yaml").mechanism
    with pytest.raises(StructureError, match="links 2, 3, 4, 5 form an Assur group of a high class"):
        assert mechanism and analyse_structure(mechanism)


@pytest.mark.parametrize(("one", "two"), [("F_12", "F_21"), ("F_21", "F_12")])
def test_a_reaction_of_the_other_link_is_reversed_whichever_comes_first(one: str, two: str) -> None:
    assert Quantity(one, (), "reactions", two).is_reversed and not Quantity(one, (), "reactions", one).is_reversed
    assert not Quantity(one, (), "loads", two).is_reversed


def test_a_loose_chain_beside_a_link_held_twice_is_no_contour() -> None:
    assert "links 5 have 1 pair(s) too many (W = -1)" in refusal(LOOSE_CHAIN)


def test_a_link_that_nothing_holds_has_no_pairs() -> None:
    alone = refusal(LOOSE_CHAIN[: LOOSE_CHAIN.index("  1:")] + "  1: {points: {A: 0}}\ndrive: {link: 1, phi: 40}\n")
    assert "W = 3·1 - 2·0 = 3" in alone and "(pairs: none)" in alone
