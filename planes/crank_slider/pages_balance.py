"""The chapter of balancing."""

from __future__ import annotations

import numpy as np

from planes.crank_slider.balance import Balance
from planes.crank_slider.calculation import Calculation
from planes.crank_slider.pages import ChapterWriter
from planes.solving.document import Chart, PlottedLine

KN = 1e-3


def write_balance(w: ChapterWriter, c: Calculation) -> None:
    """Rotating masses, counterweights, first-order forces."""
    b, shaft, weights = c.balance, c.given.shaft, c.given.counterweights
    if b is None or shaft is None or weights is None:
        return
    s, t = c.given.shape, w.tex
    w.head("h_balancing", 1)
    w.text("b_rotating")
    w.formula(
        rf"m_R=m_{{k1}}+m_{{k2}}\frac{{\rho}}{{r}}+m_A={t(shaft.pin_mass)}+{t(shaft.web_mass)}\cdot"
        rf"\frac{{{t(shaft.web_radius)}}}{{{t(s.r)}}}+{t(b.of_rod)}={t(b.rotating)}[kg]"
    )
    w.formula(rf"\Phi_R=m_R\,\omega^2r={t(b.rotating)}\cdot{t(s.omega)}^2\cdot{t(s.r)}={t(b.force)}[N]", "27")
    w.text("b_conditions")
    w.formula(r"m_1+m_2=m_R\frac{r}{R_§cw§},\quad m_1a=m_2b", "28, 29")
    w.formula(
        rf"m_1=\frac{{m_Rr}}{{R_§cw§}}\cdot\frac{{b}}{{a+b}}="
        rf"\frac{{{t(b.rotating)}\cdot{t(s.r)}}}{{{t(weights.radius)}}}"
        rf"\cdot\frac{{{t(b.right)}}}{{{t(b.left + b.right)}}}={t(b.needed[0])}[kg],\quad m_2={t(b.needed[1])}[kg]",
        "30",
    )
    w.text("b_chosen", one=b.chosen[0], two=b.chosen[1], force=abs(b.residual_force), moment=abs(b.residual_moment))
    w.text("b_first", mass=b.translating)
    _cases(w, c, b)


def _cases(w: ChapterWriter, c: Calculation, b: Balance) -> None:
    weights = c.given.counterweights
    assert weights is not None
    names = {x.name: w.say(f"w_{x.name}", part=weights.translating) for x in b.cases}
    rows = []
    for x in b.cases:
        pairs = zip((x.along, x.across, x.second), x.expected, strict=True)
        found = [f"{_kn(w, a, b.force)} ({_kn(w, e, b.force)})" for a, e in pairs]
        rows.append((names[x.name], w.number(x.static_moment), *found))
    w.table("t_first", [w.say(k) for k in ("c_weights", "c_static", "c_along", "c_across", "c_second")], rows)
    w.text("b_second")
    closed = [(x.name, np.append(x.curve, x.curve[0]) * KN) for x in b.cases]
    curves = tuple(PlottedLine(z.real, z.imag, names[name], i) for i, (name, z) in enumerate(closed))
    w.figure("f_shaking", Chart(w.say("x_along"), w.say("y_across"), curves, equal=True, height_mm=90))


def _kn(w: ChapterWriter, force: float, near: float) -> str:
    return w.number(force * KN, near=near * KN)
