"""Graphical differentiation by chords and integration by a pole: drawn exactly they are the quotients and sums they
stand for; the scale formulas hold; the error falls with the sections as it should; a pencil errs as pencils do."""

from __future__ import annotations

from itertools import pairwise

import numpy as np
import pytest

from planes.diagrams.graphical import Construction, differentiate_graphically, integrate_graphically
from planes.diagrams.graphical_text import both_graphical_constructions, constructions_report, diagram_readings
from planes.diagrams.motion import Motion, motion_of_driven_link
from planes.drafting.drawing import draw_program
from planes.drafting.instruments import Exact, Pencil
from planes.drafting.steps import Carry, Through
from planes.drafting.steps.crossings import Cross
from planes.scene import loads
from planes.words.errors import PlanesError
from tests.diagrams.test_diagrams import ROCKER, crank, plans_from


def motion(text: str = "", sections: int = 12) -> Motion:
    return motion_of_driven_link(plans_from(text or crank(0.03)), sections)


def measured(c: Construction, rank: int) -> np.ndarray:
    stage = next(s for s in c.stages if s.rank == rank)
    return np.array([float(v) for v in c.measured_values(c.draw_construction(), stage)])


@pytest.mark.parametrize("pole", [None, 20.0, 37.5])
@pytest.mark.parametrize("sections", [12, 24])
def test_chords_drawn_exactly_are_quotients_of_differences(sections: int, pole: float | None) -> None:
    m = motion(sections=sections)
    c, step = differentiate_graphically(m, pole), m.time[1] - m.time[0]
    place = np.array(m.ends[0])
    first = np.diff(place) / step
    assert measured(c, 1)[1:] == pytest.approx(first, rel=1e-11)
    before = np.concatenate(([first[-1]], first))
    assert measured(c, 2) == pytest.approx(np.diff(before) / step, rel=1e-9, abs=1e-9 * np.abs(first).max() / step)


@pytest.mark.parametrize("pole", [None, 20.0])
def test_a_pole_integrates_by_the_ordinates_of_the_middles(pole: float | None) -> None:
    m = motion()
    c, step = integrate_graphically(m, pole), m.time[1] - m.time[0]
    velocity = np.concatenate(([0.0], np.cumsum(np.array(m.middles[2]) * step))) + m.ends[1][0]
    assert measured(c, 1) == pytest.approx(velocity, rel=1e-11, abs=1e-12 * np.abs(velocity).max())
    place = np.concatenate(([0.0], np.cumsum((velocity[1:] + velocity[:-1]) / 2 * step)))
    assert measured(c, 0) == pytest.approx(place, rel=1e-10, abs=1e-12 * np.abs(place).max())


def test_scales_follow_from_the_pole_distance() -> None:
    """In mm per unit μ_v = H·μ_s/μ_t; in units per mm that is μ_v = μ_s/(H·μ_t)."""
    for c in (differentiate_graphically(motion()), integrate_graphically(motion())):
        for one, two in pairwise(c.stages):
            pole = two.pole_mm if c.kind == "differentiation" else one.pole_mm
            assert pole
            up = (
                two.mu * c.time_scale / (pole * one.mu)
                if c.kind == "differentiation"
                else one.mu * c.time_scale / (pole * two.mu)
            )
            assert up == pytest.approx(1.0, rel=1e-13)
            if c.kind == "differentiation":
                inverse = (1 / one.mu) / (pole * (1 / c.time_scale))
                assert 1 / two.mu == pytest.approx(inverse, rel=1e-13)


def test_it_is_drawn_by_a_draughtsmans_steps() -> None:
    """Chords are directions through two marks, ordinates are carried: no step computes a difference."""
    c = differentiate_graphically(motion())
    kinds = {type(s).__name__ for s in c.construction_program.steps}
    assert kinds <= {"Put", "Aim", "Turn", "LayOff", "Similar", "Through", "Cross", "Carry", "Measure"}
    assert sum(isinstance(s, Through) for s in c.construction_program.steps) == 24
    assert sum(isinstance(s, Cross) for s in c.construction_program.steps) == 24
    assert sum(isinstance(s, Carry) for s in c.construction_program.steps) >= 24
    drawing = c.draw_construction()
    for k in range(12):
        chord = drawing[f"diagram:s:{k + 1}"] - drawing[f"diagram:s:{k}"]
        ray = drawing[f"diagram:v:h{k}½"] - drawing["diagram:v:P"]
        assert (ray * chord.conjugate()).imag == pytest.approx(0, abs=1e-9 * abs(ray) * abs(chord))
        assert ray.real == pytest.approx(c.stages[1].pole_mm, rel=1e-12)


@pytest.mark.parametrize("text", [crank(), crank(0.05, -12.0), ROCKER])
def test_the_error_of_chords_falls_as_the_square_of_the_section(text: str) -> None:
    worst = [
        [r.largest_method_error for r in diagram_readings(differentiate_graphically(motion(text, n)))[1:]]
        for n in (24, 48)
    ]
    for coarse, fine in zip(*worst, strict=True):
        assert 3.3 < coarse / fine < 4.7
    assert worst[1][0] < 0.01


def test_exact_values_are_those_of_a_uniform_turn() -> None:
    """With ε₁ the acceleration of the scene has v_q·ε₁ more; diagrams over time are of a uniform turn."""
    m = motion(crank(0.0, 20.0, 300.0))
    f = np.radians(m.angles)
    assert np.array(m.ends[2])[0] == pytest.approx(-400 * (0.1 + 0.01 / 0.35) * np.cos(f[0]), rel=1e-9)
    assert m.closed and m.angles[-1] - m.angles[0] == pytest.approx(360)
    back = motion(crank(0.0, -20.0))
    assert back.time[-1] > 0 and back.angles[-1] < back.angles[0]


def test_a_pencil_errs_and_the_same_pencil_errs_the_same() -> None:
    c = differentiate_graphically(motion())
    stage = c.stages[1]
    exact = np.array(c.measured_values(c.draw_construction(Exact()), stage), float)
    one, two, other = (
        np.array(c.measured_values(c.draw_construction(Pencil(seed=s)), stage), float) for s in (1, 1, 2)
    )
    assert (one == two).all() and (one != other).any()
    size = np.abs(exact).max()
    assert 0.002 < np.abs(one - exact).max() / size < 0.3
    fine = np.array(c.measured_values(c.draw_construction(Pencil(0.015, 0.015, 0.05)), stage), float)
    assert np.abs(fine - exact).max() < np.abs(one - exact).max()
    spread = diagram_readings(c)[1].pencil
    assert 0.002 < max(spread) / size < 0.1


def test_a_mechanism_that_stops_is_differentiated_over_its_working_range() -> None:
    c = both_graphical_constructions(loads(ROCKER.replace("B: 0.1}", "B: 0.5}"), "scene.yaml"), 12)[0]
    assert not c.motion.closed and abs(c.motion.angles[-1] - c.motion.angles[0]) < 180
    assert len(c.stages[1].points) == 12 and len(c.stages[2].points) == 11


def test_refusals() -> None:
    for text, sections, pole, words in (
        (crank(omega=0.0), 12, None, "the driver must turn, with omega not zero"),
        (crank(), 5, None, "5 sections cannot be used: take from 6 to 72"),
        (crank(), 12, 0.5, "a pole distance of 0.5 mm cannot be used: take from 1 to 500 mm"),
    ):
        with pytest.raises(PlanesError, match=words):
            both_graphical_constructions(loads(text, "scene.yaml"), sections, pole)


def test_the_report_names_scales_and_errors() -> None:
    both = both_graphical_constructions(loads(crank(0.03), "scene.yaml"), 12, 30.0)
    text = constructions_report(both, "ru")
    assert all(t in text for t in ("методом хорд", "μ_v = H·μ_s/μ_t", "H = 30 мм", "наибольшая погрешность"))
    assert "μ_v = μ_a·μ_t/H" in constructions_report(both, "en") and "largest error" in constructions_report(both, "en")
    assert draw_program(both[0].construction_program, both[0].draft.given)["diagram:a:0"]
