"""Balancing and strength of the integrated calculation against numbers worked by hand."""

from __future__ import annotations

import dataclasses
import math

import numpy as np
import pytest

from planes.crank_slider.given import Concentration, PistonPin, Shaft
from planes.crank_slider.parts import RoundPart, Shank, Web, make_material, steel_by_name, torsion_factor
from planes.crank_slider.rod import beam_moment_at, pin_strength
from planes.crank_slider.shaft import (
    Section,
    bearing_reactions,
    combined_safety_factor,
    dangerous_sections,
    fatigue_of_section,
    moment_diagrams,
)
from tests.helpers.crank_slider_scenes import SAMPLE, calculated, changed

BAR = Shaft(0.3, 0.1, 0.05, RoundPart(0.05), RoundPart(0.04), Web(0.06, 0.03), 2.0, 3.0, 0.02)


def loads(c, out: float, t: float):
    """The forces of a calculation with one given load on the crank pin."""
    one = np.ones(1)
    return dataclasses.replace(c.forces, K=-out * one, T=t * one)


def test_two_counterweights_balance_the_rotating_masses():
    """m_R = 1.1 + 2.6·0.03/0.06 + 1.8·0.7 = 3.66 kg. m₁ + m₂ = 3.66·0.06/0.07 = 3.13714 kg, halves of it for a = b.
    Φ_R = 3.66·188.5²·0.06 = 7802.9 N.
    """
    b = calculated().balance
    assert b.rotating == pytest.approx(3.66)
    assert b.needed == (pytest.approx(1.56857, abs=1e-5), pytest.approx(1.56857, abs=1e-5))
    assert b.force == pytest.approx(7802.88, abs=0.01)
    assert abs(b.residual_force) < 1e-9 and abs(b.residual_moment) < 1e-9


def test_counterweights_at_unequal_distances():
    """Span 0.2, load 0.12 from B, webs 0.05 from the bearings: a = 0.2 − 0.12 − 0.05 = 0.03, b = 0.12 − 0.05 = 0.07.
    m₁·a = m₂·b and m₁ + m₂ = 3.13714: m₁ = 3.13714·0.7 = 2.196, m₂ = 0.94114.
    """
    c = calculated(changed(("pin_from_B: 0.1", "pin_from_B: 0.12"), ("webs: 0.058", "webs: 0.05")))
    assert (c.balance.left, c.balance.right) == (pytest.approx(0.03), pytest.approx(0.07))
    assert c.balance.needed == (pytest.approx(2.196), pytest.approx(0.94114, abs=1e-5))


def test_chosen_masses_leave_a_force_and_a_moment():
    """m₁ = 1.5, m₂ = 1.7 at R = 0.07, a = b = 0.042: force (3.2·0.07 − 3.66·0.06)·188.5² = 156.34 N,
    moment (1.7 − 1.5)·0.042·0.07·188.5² = 20.893 N·m.
    """
    b = calculated(changed(("{radius: 0.07}", "{radius: 0.07, masses: [1.5, 1.7]}"))).balance
    assert b.residual_force == pytest.approx((0.224 - 0.2196) * 188.5**2)
    assert b.residual_moment == pytest.approx(20.893, abs=1e-3)
    assert [x.name for x in b.cases] == ["none", "rotating", "chosen", "part"]


def test_first_order_forces_with_and_without_counterweights():
    """m_tr = 1.4 + 0.54 = 1.94 kg, m_tr·r·ω² = 4135.95 N. Bare: 7802.88 + 4135.95 along, 7802.88 across; balanced:
    4135.95 along, none across; with half of m_tr: half along, half across. Harmonics of the true force agree exactly.
    """
    cases = {x.name: x for x in calculated().balance.cases}
    for name, one, two in (("none", 11938.84, 7802.88), ("rotating", 4135.95, 0.0), ("part", 2067.98, 2067.98)):
        assert cases[name].along == pytest.approx(one, abs=0.01)
        assert cases[name].across == pytest.approx(two, abs=0.01)
    assert cases["none"].second == pytest.approx(4135.95 * 0.06 / 0.21, rel=0.03)  # λ alone, higher powers dropped


def test_bearings_and_moments_of_the_broken_bar():
    """L = 0.3, n = 0.1, m = 0.05, r = 0.06, ω = 188.5; pin 6000 N outwards, 3000 N along its motion, no counterweights.

    Φ = ½(2·0.06 + 3·0.02)·188.5² = 3197.9 N on each web. A′ = Φ + 6000·0.1/0.3 = 5197.9,
    B′ = 6000 + 2·3197.9 − 5197.9 = 7197.9; A″ = 1000, B″ = 2000. Moments at the pin, 0.2 from A:
    A′·0.2 − Φ·0.15 = 559.9, from the other side B′·0.1 − Φ·0.05 = 559.9; A″·0.2 = 200; torsion
    A″·0.06 = 60. Journal B: B′·0.05 = 359.9, 2000·0.05 = 100, 3000·0.06 = 180.
    """
    c = calculated()
    s = bearing_reactions(c.given.shape, BAR, None, None, loads(c, 6000.0, 3000.0))
    web = 0.09 * 188.5**2
    assert s.web == pytest.approx(web)
    assert s.A1[0] == pytest.approx(web + 2000.0)
    assert s.B1[0] == pytest.approx(6000 + web - 2000.0)
    assert (s.A2[0], s.B2[0]) == (pytest.approx(1000.0), pytest.approx(2000.0))
    cut = dangerous_sections(c.given.shape, BAR, s)
    pin, journal = cut["crankpin"], cut["journal_B"]
    assert pin.bending_z[0] == pytest.approx(0.1 * s.B1[0] - 0.05 * web)
    assert (pin.bending_y[0], pin.torsion[0]) == (pytest.approx(200.0), pytest.approx(60.0))
    assert journal.torsion[0] == pytest.approx(180.0)
    _, z, _, torque = moment_diagrams(BAR, cut, 0)
    assert z[3] == pytest.approx(pin.bending_z[0])
    assert torque[-1] == pytest.approx(180.0)


def test_stress_of_a_round_section_by_the_third_theory():
    """d = 40 mm: W = π·40³/32 = 6283.2 mm³. M = √(300² + 400²) = 500 N·m: σ = 79.577 MPa; M_t = 200 N·m:
    τ = 200e3/(2·6283.2) = 15.915 MPa; σ_eq = √(79.577² + 4·15.915²) = 85.707 MPa.
    """
    c, one = calculated(), np.ones(1)
    s = dataclasses.replace(c.supports, A1=one, A2=one, B1=one, B2=one, out=one, T=one)
    name = Section(
        "x",
        300 * one,
        400 * one,
        200 * one,
        np.hypot(300, 400) / RoundPart(0.04).modulus * 1e-6 * one,
        200 / (2 * RoundPart(0.04).modulus) * 1e-6 * one,
    )
    assert RoundPart(0.04).modulus * 1e9 == pytest.approx(6283.19, abs=0.01)
    assert name.equivalent[0] == pytest.approx(85.707, abs=1e-3)
    cut = dangerous_sections(c.given.shape, BAR, s)["crankpin"]
    assert cut.sigma[0] == pytest.approx(math.hypot(cut.bending_z[0], cut.bending_y[0]) / 6283.19e-9 * 1e-6, rel=1e-6)


def test_sections():
    """Hollow 60/20: W = π·60³/32·(1 − 1/81) = 20943.9 mm³. I 34 × 24, flanges and web 6: F = 2·24·6 + 22·6 = 420 mm²,
    J = (24·34³ − 18·22³)/12 = 62636 mm⁴, J across = (2·6·24³ + 22·6³)/12 = 14220 mm⁴. Square bar in torsion: α = 0.208.
    """
    assert RoundPart(60, 20).modulus == pytest.approx(20944, abs=1)
    shank = Shank(34, 24, 6, 6)
    assert (shank.area, shank.inertia, shank.inertia_across) == (420, pytest.approx(62636), pytest.approx(14220))
    assert Shank(34, 24, 17, 24).inertia == pytest.approx(24 * 34**3 / 12)
    assert (torsion_factor(1.0), torsion_factor(2.25)) == (0.208, pytest.approx(0.252))


def test_fatigue_of_a_journal_by_hand():
    """Steel 45: σ₋₁ = 0.43·600 = 258, τ₋₁ = 149.64, ψ_σ = 0.14, ψ_τ = 0.07. d = 40 mm. M_z goes between 0 and 400 N·m,
    the rest is still: at θ = 0 σ from 0 to 63.66, σ_a = σ_m = 31.831 MPa. k/ε = 1.9/0.8 = 2.375:
    n_σ = 258/(2.375·31.831 + 0.14·31.831) = 3.2228. M_t between −100 and 300: τ_a = 200e3/12566.4 = 15.915,
    τ_m = 7.958; k/ε = 2: n_τ = 149.64/(31.831 + 0.557) = 4.6203; n = 3.2228·4.6203/√(3.2228² + 4.6203²) = 2.6433.
    """
    z, t, none = np.array([0.0, 400.0]), np.array([-100.0, 300.0]), np.zeros(2)
    section = Section("journal_B", z, none, t, z / 6283.19e-9 * 1e-6, np.abs(t) / 12566.4e-9 * 1e-6)
    found = fatigue_of_section(section, RoundPart(0.04), steel_by_name("45"), Concentration(1.9, 1.6, 0.8, 0.8))
    assert (found.sigma_a, found.sigma_m) == (pytest.approx(31.831, abs=1e-3), pytest.approx(31.831, abs=1e-3))
    assert (found.tau_a, found.tau_m) == (pytest.approx(15.915, abs=1e-3), pytest.approx(7.958, abs=1e-3))
    assert found.n_sigma == pytest.approx(3.2228, abs=2e-4)
    assert found.n_tau == pytest.approx(4.6203, abs=2e-4)
    assert found.n == pytest.approx(2.6433, abs=2e-4)
    assert combined_safety_factor(3.0, math.inf) == 3.0


def test_the_worst_point_of_the_edge_is_found():
    """A load that turns with the section's 45° line bends it there and back: the worst point is at 45°."""
    z = np.array([300.0, -300.0])
    section = Section("crankpin", z, z, 0 * z, np.abs(z), 0 * z)
    found = fatigue_of_section(section, RoundPart(0.04), steel_by_name("45"), Concentration(1.0, 1.0, 1.0, 1.0))
    assert found.angle_deg % 180 == 45
    assert found.sigma_a == pytest.approx(300 * math.sqrt(2) / 6283.19e-9 * 1e-6, rel=1e-5)


def test_bending_of_the_rod_by_its_own_inertia():
    """Even load q: q·l²/8 in the middle; a triangle from 0 to q: q·l²/(9√3), at l/√3 from its lighter end."""
    x = np.linspace(0, 2.0, 20001)
    assert beam_moment_at(5.0, 5.0, x, 2.0).max() == pytest.approx(5 * 4 / 8)
    assert beam_moment_at(0.0, 5.0, x, 2.0).max() == pytest.approx(5 * 4 / (9 * math.sqrt(3)), rel=1e-8)
    assert x[beam_moment_at(0.0, 5.0, x, 2.0).argmax()] == pytest.approx(2 / math.sqrt(3), abs=1e-4)


def test_buckling_of_a_short_and_of_a_slender_rod():
    """40Х: σ_y = 785, E = 2.1e5: the parabola meets Euler at Λ = π√(2·2.1e5/785) = 72.667, where both are σ_y/2.
    The shank: i = √(62636/420) = 12.212 mm, Λ = 210/12.212 = 17.196; σ_cr = 785(1 − 785·17.196²/(4π²·2.1e5)) = 763.0.
    """
    rod = calculated().rod
    assert rod.limit == pytest.approx(72.667, abs=1e-3)
    assert rod.planes[0].slenderness == pytest.approx(17.196, abs=1e-3)
    assert rod.planes[0].critical == pytest.approx(763.0, abs=0.1)
    slender = calculated(SAMPLE.split("crank_slider:")[0].replace("l: 0.21", "l: 1.2") + _lightly()).rod.planes[0]
    assert slender.euler and slender.critical == pytest.approx(math.pi**2 * 2.1e5 / slender.slenderness**2)


def _lightly() -> str:
    text = SAMPLE[SAMPLE.index("crank_slider:") :]
    start, end = text.index("  # коленчатый вал"), text.index("  # стержень шатуна")
    return (text[:start] + text[end:]).split("  fatigue:")[0].replace("shaft: 45, ", "")


def test_the_piston_pin_as_a_beam():
    """P = 20 kN, d = 30, bore 18 (α = 0.6), pin 80, bush 34, gap 38 mm.
    Halves: bush P/2 at 34/4 = 8.5 mm from the middle; boss, a triangle on (80 − 38)/2 = 21 mm falling
    outwards, P/2 at 19 + 21/3 = 26 mm: M = 10·(26 − 8.5) = 175 N·m.
    W = π·30³/32·(1 − 0.1296) = 2307.2 mm³: σ = 75.85 MPa. τ = 0.85·P(1 + α + α²)/((1 − α⁴)d²) = 42.5 MPa.
    q = 20000/(30·34) = 19.6 and 20000/(30·42) = 15.9 MPa.
    """
    c, one = calculated(), np.ones(1)
    m = dataclasses.replace(c.motion, phi_deg=one)
    pin = PistonPin(RoundPart(0.03, 0.018), 0.08, 0.034, 0.038)
    p = pin_strength(m, dataclasses.replace(c.forces, on_rod_at_b=20000.0 * one + 0j), pin, steel_by_name("20Х"))
    assert p.moment == pytest.approx(175.0)
    assert p.sigma == pytest.approx(75.85, abs=0.01)
    assert p.tau == pytest.approx(0.85 * 20000 * 1.96 / (0.8704 * 900), rel=0.002)
    assert (p.bush, p.boss) == (pytest.approx(19.608, abs=1e-3), pytest.approx(15.873, abs=1e-3))
    assert p.n == pytest.approx(635 / (2 * p.tau))


def test_steels():
    assert steel_by_name("40X").name == "40Х"  # Latin letters that look the same
    assert steel_by_name("99") is None
    own = make_material("x", 800, 600, True, fatigue=390, torsion=220)
    assert (own.fatigue, own.fatigue_torsion) == (390, 220)
    assert steel_by_name("40Х").fatigue == pytest.approx(0.35 * 980 + 120)
