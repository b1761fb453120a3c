"""Turning curves: against closed forms, and of class III and IV against exact counts on both sides."""

from __future__ import annotations

import math

import numpy as np
import pytest

from planes.accuracy.turning import Turning, length_turning_curves, turning_of_nearest_length
from planes.accuracy.variation import alterable_given_names
from planes.drafting.drawing import draw_program
from planes.drafting.steps.tracks import CutTrack
from planes.geometry.arithmetic import Arithmetic
from planes.geometry.tracks import Tie
from planes.plans import Plans, plans_of
from planes.scene import load, loads
from planes.words.names import SCHEME_PLAN
from tests.helpers import ROOT
from tests.plans.test_basic_chains import counted as both_counted
from tests.plans.test_triad_assemblies import counted

SLIDER = """
planes: 1
frame: {points: {A: [0, 0]}, guides: {x-x: {y: 0.02}}}
links:
  1: {points: {A: 0, B: 0.1}}
  2: {points: {B: 0, C: 0.12}}
  3: {points: {C: 0}, slides: x-x}
assembly: {C: ahead}
drive: {link: 1, phi: 60, omega: 10}
"""
FOUR_BAR = """
planes: 1
frame: {points: {A: [0, 0], D: [0.4, 0]}}
links:
  1: {points: {A: 0, B: 0.15}}
  2: {points: {B: 0, C: 0.3}}
  3: {points: {D: 0, C: 0.25}}
assembly: {C: left}
drive: {link: 1, phi: 60, omega: 10}
"""
SLOTTED = """
planes: 1
frame: {points: {A: [0, 0], D: [0.3, 0]}}
links:
  1: {points: {A: 0, B: 0.2}}
  2: {points: {B: 0}, slides: {guide: d, offset: 0.15}}
  3: {points: {D: 0}, guides: {d: {through: D, angle: 0}}}
assembly: {d: ahead}
drive: {link: 1, phi: 60, omega: 10}
"""


def stated(text: str) -> Plans:
    mechanism = loads(text).mechanism
    assert mechanism
    return plans_of(mechanism)


def sample(name: str) -> Plans:
    mechanism = load(str(ROOT / "samples" / f"{name}.yaml")).mechanism
    assert mechanism
    return plans_of(mechanism)


def every(found: Turning) -> np.ndarray:
    """All places of all curves: radians and lengths."""
    values = np.radians(np.concatenate([c.values for c in found.curves]))
    return np.array([values, np.concatenate([c.lengths for c in found.curves])])


def reached(found: Turning, phi: np.ndarray, lengths: np.ndarray) -> np.ndarray:
    """How far places are from the curves' chords, radians and logarithms of lengths."""
    best = np.full(len(phi), math.inf)
    for curve in found.curves:
        x, y = np.radians(curve.values), np.log(curve.lengths)
        for turn in (-2 * math.pi, 0.0, 2 * math.pi):
            dense = np.linspace(0, len(x) - 1, 20 * len(x))
            k = np.arange(len(x))
            line = np.interp(dense, k, x) + turn + 1j * np.interp(dense, k, y)
            best = np.minimum(best, abs(line[:, None] - (phi + 1j * np.log(lengths))).min(axis=0))
    return best


@pytest.mark.slow
def test_the_rod_of_a_slider_crank() -> None:
    """The crank's end is as far from the guide as the rod is long."""
    found = length_turning_curves(stated(SLIDER), "l_BC")
    phi, rods = every(found)
    assert abs(rods - abs(0.1 * np.sin(phi) - 0.02)).max() < 1e-12
    phi = np.linspace(0, 2 * math.pi, 400, endpoint=False)
    rods = abs(0.1 * np.sin(phi) - 0.02)
    inside = (rods > 0.0601) & (rods < 0.2399)
    assert inside.sum() > 100 and reached(found, phi[inside], rods[inside]).max() < 0.003


@pytest.mark.slow
@pytest.mark.parametrize(("name", "length"), [("l_BC", 0.3), ("l_DC", 0.25)])
def test_the_rod_and_the_rocker_of_a_four_bar(name: str, length: float) -> None:
    """Rod and rocker are stretched, or folded, on the line from crank pin to bearing."""
    found, other = length_turning_curves(stated(FOUR_BAR), name), 0.55 - length
    phi, lengths = every(found)
    diagonal = np.abs(0.4 - 0.15 * np.exp(1j * phi))
    missed = np.min([abs(diagonal - lengths - other), abs(diagonal - abs(lengths - other))], axis=0)
    assert missed.max() < 1e-12
    around = np.linspace(0, 2 * math.pi, 400, endpoint=False)
    diagonal = np.abs(0.4 - 0.15 * np.exp(1j * around))
    for lengths in (diagonal - other, other - diagonal, other + diagonal):
        inside = (lengths > length / 1.99) & (lengths < length * 1.99)
        assert not inside.any() or reached(found, around[inside], lengths[inside]).max() < 0.003


def test_the_crank_of_a_slotted_lever_beside_whose_bearing_the_slider_passes() -> None:
    """The circle that the guide touches goes through the crank's pin."""
    found = length_turning_curves(stated(SLOTTED), "l_AB")
    phi, cranks = every(found)
    assert abs(np.abs(0.3 - cranks * np.exp(1j * phi)) - 0.15).max() < 1e-12


def ties_at(plans: Plans, name: str, phi: float, length: float) -> list[Tie]:
    """The leads of the basic link at an angle of the crank and a length of a rod."""
    step = next(s for s in plans.program.steps if isinstance(s, CutTrack))
    program = plans.program.cut_to_names([n for hold in step.holds for n, _ in hold.input_names()])
    given = {**plans.given, SCHEME_PLAN.mu_name: 1.0, plans.drive_given_name: phi, name: length}
    things = draw_program(program, given).things
    return [hold.lead_tie(things, 1.0, Arithmetic()) for hold in step.holds]


ALTERED = {"class-three/rods": "l_FD", "class-three/press": "l_AB", "class-three/stephenson": "l_AB"}


@pytest.mark.slow
@pytest.mark.parametrize("name", list(ALTERED))
def test_two_assemblies_meet_on_a_curve_of_class_three(name: str) -> None:
    """Counted exactly on both sides: there are two more on one of them; and between the curves their number stands."""
    plans, length = sample(name), ALTERED[name]
    found = length_turning_curves(plans, length)
    assert found.curves
    for curve in found.curves:
        for k in range(3, len(curve.values) - 3, 17):
            x, y = np.radians(curve.values), np.log(curve.lengths)
            across = 1j * complex(x[k + 1] - x[k - 1], y[k + 1] - y[k - 1])
            across *= 1e-5 / abs(across)
            sides = [(x[k] + s * across.real, y[k] + s * across.imag) for s in (1, -1)]
            one, two = (counted(ties_at(plans, length, math.degrees(a), math.exp(b))) for a, b in sides)
            assert abs(one - two) == 2, (k, one, two)
    rng = np.random.default_rng(1)
    for _ in range(60):
        j, i = rng.integers(len(found.lengths)), rng.integers(len(found.values))
        assert counted(ties_at(plans, length, found.values[i], found.lengths[j])) == found.count[j, i]


@pytest.mark.slow
def test_none_is_left_out_of_class_three() -> None:
    """Along lines of one length the exact count changes where a curve is crossed, and nowhere else."""
    plans = sample("class-three/stephenson")
    found = length_turning_curves(plans, "l_AB")
    for length in (0.21, 0.3, 0.42, 0.55, 0.68):
        angles = np.linspace(0.5, 360.5, 121)
        counts = [counted(ties_at(plans, "l_AB", a, length)) for a in angles]
        changes = sum(abs(a - b) // 2 for a, b in zip(counts[1:], counts, strict=False))
        crossed = sum(int(((c.lengths[1:] > length) != (c.lengths[:-1] > length)).sum()) for c in found.curves)
        assert crossed >= changes and (crossed - changes) % 2 == 0


@pytest.mark.slow
def test_the_length_altered_the_least_is_taken() -> None:
    plans = sample("class-three/rods")
    found = turning_of_nearest_length(
        plans, alterable_given_names(plans, [n for n in plans.program.given_names if n in plans.link_lengths])
    )
    assert found and found.name == "l_FD" and found.whole
    assert turning_of_nearest_length(stated(FOUR_BAR), []) is None


@pytest.mark.slow
def test_basic_links_in_a_chain_are_counted_on_both_sides_of_their_curves() -> None:
    """All over the field as by exact elimination, and two more, or fewer, beyond a curve."""
    plans = sample("class-three/two-basic-links")
    found, rng = length_turning_curves(plans, "l_AB"), np.random.default_rng(3)
    assert found.whole and len(found.curves) == 3
    for _ in range(80):
        j, i = rng.integers(len(found.lengths)), rng.integers(len(found.values))
        assert both_counted(ties_at(plans, "l_AB", found.values[i], found.lengths[j])) == found.count[j, i]
    for curve in found.curves:
        x, y = np.radians(curve.values), np.log(curve.lengths)
        for k in range(3, len(x) - 3, 11):
            across = 1j * complex(x[k + 1] - x[k - 1], y[k + 1] - y[k - 1])
            across *= 1e-5 / abs(across)
            sides = [(x[k] + s * across.real, y[k] + s * across.imag) for s in (1, -1)]
            one, two = (both_counted(ties_at(plans, "l_AB", math.degrees(a), math.exp(b))) for a, b in sides)
            assert abs(one - two) == 2, (k, one, two)
