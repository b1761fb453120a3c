"""Groups of class III: every number against the independent solver, every assembly against an independent count."""

from __future__ import annotations

import random
from itertools import combinations_with_replacement

import pytest

from planes.words.errors import PlanesError
from tests.helpers.comparing import against, balanced, checked, draw, standing
from tests.helpers.mechanisms import KINDS, make
from tests.plans.test_against_oracle import examine

LEADS = ("RR", "PR", "RP")
SLID = ["-".join((*m, "PP")) for m in combinations_with_replacement(LEADS, 2)]
MIXTURES = ["-".join(m) for m in combinations_with_replacement(LEADS, 3)] + SLID


@pytest.mark.few(3)
@pytest.mark.parametrize("leads", MIXTURES)
def test_every_mixture_of_leads_with_loads_on_every_link(leads: str) -> None:
    for seed in range(4):
        rng = random.Random(f"{leads} {seed}")
        examine(make(rng, ["-".join(rng.sample(leads.split("-"), 3))]))


def rubbing(seed: int) -> float | None:
    """The worst number of a mechanism in which hinges and guides rub; None where something stands still."""
    rng = random.Random(f"rubbing {seed}")
    leads = rng.choice(SLID).split("-") if seed % 4 == 1 else [rng.choice(LEADS) for _ in LEADS]
    kinds = ["-".join(leads), *rng.choices(KINDS, k=seed % 2)]
    case = make(rng, kinds[:: rng.choice((1, -1))], friction=seed % 3 > 0, pins=seed % 3 < 2, rest=seed % 7 == 0)
    if standing(case):
        return None
    drawn, wrong = against(case)
    balanced(drawn, seed)
    return max(wrong.values()) * drawn.sharpest


def test_with_friction_in_hinges_and_guides() -> None:
    found = [e for seed in range(9) if (e := rubbing(seed)) is not None]
    assert len(found) > 6 and max(found) <= 1e-11


@pytest.mark.slow
@pytest.mark.parametrize("half", range(2))
def test_more_with_friction_in_hinges_and_guides(half: int) -> None:
    found = [e for seed in range(1000 + 75 * half, 1075 + 75 * half) if (e := rubbing(seed)) is not None]
    assert len(found) > 50 and max(found) <= 1e-9


def test_friction_that_locks_a_group_is_one_sentence() -> None:
    case = make(random.Random("locks"), ["RR-PR-RR"], friction=True, sliding=False)
    locked = {**case.scene, "friction": dict.fromkeys(case.scene["friction"], 50.0)}
    with pytest.raises(PlanesError, match=r"friction T_.* does not settle"):
        draw(locked)


@pytest.mark.slow
def test_after_and_before_dyads() -> None:
    for seed in range(12):
        rng = random.Random(f"chain {seed}")
        kinds = [rng.choice(KINDS), rng.choice(MIXTURES), rng.choice(KINDS)]
        examine(make(rng, kinds[seed % 3 == 0 :]))


@pytest.mark.parametrize(("kind", "seed"), [("RPP", 52), ("RRP", 0)])
def test_a_special_point_is_not_taken_for_a_point_of_a_guide_under_a_slider(kind: str, seed: int) -> None:
    """Both would be called by the letter of a hinge, S, and the name of the basic link."""
    examine(make(random.Random(f"after {kind} {seed}"), ["RR-RR-PR", kind]))


def test_a_link_that_slides_at_both_ends_on_a_driver_of_one_point() -> None:
    """What its turning carries over is laid off from the pivot: by nothing but ω and ε."""
    text = """\
planes: 1
frame: {points: {O: [0, 0], D: [-0.3, 0.4], E: [0.6, 0.5]}}
links:
  1: {points: {O: 0}, guides: {g: {through: [0.1, 0.05], angle: 20}}}
  5: {points: {F: 0}, slides: g, guides: {h: {through: F, angle: 80}}, mass: 2}
  2: {points: {B: [0, 0], C: [0.3, 0]}, slides: {guide: h, angle: 15, offset: 0.02}, mass: 1, inertia: 0.1}
  3: {points: {D: 0, B: 0.35}}
  4: {points: {E: 0, C: 0.4}}
assembly: {B: left}
drive: {link: 1, phi: -75, omega: 10, epsilon: 5}
"""
    drawn, wrong = checked(text)
    assert max(wrong.values()) * drawn.sharpest <= 1e-11


def test_two_leads_that_slide_at_both_ends_are_one_sentence() -> None:
    frame = {"points": {"O": [0, 0], "G": [0.75, -0.32]}, "guides": {"y": {"x": 0.62}}}
    links = {
        "1": {"points": {"O": 0, "A": 0.08}, "slides": "w"},
        "2": {"points": {"G": 0, "B": 0.4}},
        "3": {"points": {"B": 0, "E": 0.3}, "slides": "x", "guides": {"v": {"through": "E", "angle": 70}}},
        "4": {"points": {"F": 0}, "slides": "v", "guides": {"w": {"through": "F", "angle": 30}}},
        "5": {"points": {"D": 0}, "slides": {"guide": "y", "angle": -90}, "guides": {"x": {"y": 0}}},
    }
    with pytest.raises(PlanesError, match=r"leads 4, 5 of a group of class III slide both on the basic link 3"):
        draw({"planes": 1, "frame": frame, "links": links, "drive": {"link": "1", "phi": 40, "omega": 1}})


def test_one_after_another_have_each_its_own_assembly() -> None:
    examine(make(random.Random("two triads"), ["RR-RR-RR", "RR-RR-PR"]))
