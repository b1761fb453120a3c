"""The chapter of strength: the crankshaft."""

from __future__ import annotations

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.given import Shaft
from planes.crank_slider.pages import ChapterWriter, lines
from planes.crank_slider.shaft import Section, Supports, along
from planes.solving.document import Chart, ShaftSketch

CASES = ("I", "II")


def write_shaft(w: ChapterWriter, c: Calculation) -> None:
    """Materials, then the crankshaft: bearings, diagrams, stresses, fatigue."""
    if not c.given.materials:
        return
    w.head("h_strength", 1)
    _materials(w, c)
    if c.given.shaft is None or c.supports is None:
        return
    _bearings(w, c, c.given.shaft, c.supports)
    _static(w, c)
    _fatigue(w, c)


def cases(c: Calculation) -> tuple[int, int]:
    """The steps of the largest normal and the largest tangential force."""
    return int(np.argmax(np.abs(c.forces.K))), int(np.argmax(np.abs(c.forces.T)))


def _materials(w: ChapterWriter, c: Calculation) -> None:
    w.head("h_material")
    rows = []
    for key, m in c.given.materials.items():
        values = (m.strength, m.yields, m.fatigue, m.fatigue_torsion, m.psi, m.psi_torsion)
        rows.append((w.say(f"p_{key}"), m.name, *map(w.number, values)))
    sigmas = (f"σ_{{{w.say('sub_B')}}}", f"σ_{{{w.say('sub_Y')}}}", "σ_{−1}")
    w.table("t_material", [w.say("c_part"), w.say("c_steel"), *sigmas, "τ_{−1}", "ψ_{σ}", "ψ_{τ}"], rows)
    w.text("s_material")


def _bearings(w: ChapterWriter, c: Calculation, shaft: Shaft, s: Supports) -> None:
    t = w.tex
    w.head("h_shaft")
    w.text("s_shaft")
    weights = c.given.counterweights
    cw = w.say("sub_cw")
    labels = {"load": "N_{c1}, P_{t1}", "web": "Φ", "weight_0": f"Φ_{{1{cw}}}", "weight_1": f"Φ_{{2{cw}}}"}
    radius = weights.radius if weights else c.given.shape.r
    sketch = ShaftSketch(shaft.span, shaft.span - shaft.pin_from_b, shaft.webs, c.given.shape.r, radius, labels)
    w.figure("f_sketch", sketch, a=shaft.left, b=shaft.right)
    w.formula(
        rf"\Phi=\frac{{1}}{{2}}(m_{{k1}}r+m_{{k2}}\rho)\,\omega^2={t(s.web)}[N],\quad"
        rf"\Phi_1=m_1R_§cw§\,\omega^2={t(s.left_weight)}[N],\quad\Phi_2={t(s.right_weight)}[N]"
    )
    w.text("s_reactions")
    w.formulas("bearings")
    w.mistake("m_32")
    k, j = cases(c)
    phi = c.motion.phi_deg
    w.text("s_case", case_k=CASES[0], phi_k=float(phi[k]), case_t=CASES[1], phi_t=float(phi[j]))
    for name, step in zip(CASES, (k, j), strict=True):
        _case(w, c, shaft, s, name, step)


def _case(w: ChapterWriter, c: Calculation, shaft: Shaft, s: Supports, name: str, k: int) -> None:
    t, b = w.tex, w.bracketed
    n, m, span = shaft.pin_from_b, shaft.webs, shaft.span
    out, a1, a2, b1, b2, load = (float(v[k]) for v in (s.out, s.A1, s.A2, s.B1, s.B2, s.T))
    left, right = s.web - s.left_weight, s.web - s.right_weight
    w.text("s_case_at", case=name, phi=float(c.motion.phi_deg[k]))
    w.formula(
        rf"A'=\frac{{{t(left)}\cdot{t(span - m)}+{b(out)}\cdot{t(n)}+{b(right)}\cdot{t(m)}}}{{{t(span)}}}={t(a1)}[N],"
        rf"\quad A''=\frac{{{t(load)}\cdot{t(n)}}}{{{t(span)}}}={t(a2)}[N],"
    )
    w.formula(rf"B'={t(out)}+{b(left)}+{b(right)}-{b(a1)}={t(b1)}[N],\quadB''={t(load)}-{b(a2)}={t(b2)}[N]")
    d = along(c.given.shape, shaft, s, k)
    curves = lines(d.x, {w.say("l_Mz"): d.z, w.say("l_My"): d.y, w.say("l_Mx"): d.torque})
    w.figure("f_moments", Chart(w.say("x_shaft"), w.say("y_Nm"), tuple(curves), height_mm=58), case=name)


def _static(w: ChapterWriter, c: Calculation) -> None:
    limits, steel = c.given.limits, c.given.materials["shaft"]
    w.head("h_static")
    w.text("s_static")
    w.formulas("static")
    steps = dict(zip(CASES, cases(c), strict=True))
    rows = []
    for s in c.sections.values():
        columns = (s.bending_z, s.bending_y, s.torsion, s.sigma, s.tau, s.equivalent)
        for name, k in steps.items():
            rows.append((f"{w.say(f'x_{s.name}')}, {name}", *(w.number(float(v[k])) for v in columns)))
    w.table("t_static", [w.say("c_section"), "M_{z}", "M_{y}", "M_{x}", "σ", "τ", f"σ_{{{w.say('sub_eq')}}}"], rows)
    worst = dangerous(c)
    at = int(np.argmax(worst.equivalent))
    w.text("s_dangerous", section=w.say(f"x_{worst.name}"), phi=float(c.motion.phi_deg[at]), n=limits.static)
    top, allowed, t = float(worst.equivalent[at]), steel.yields / limits.static, w.tex
    sigma, tau = float(worst.sigma[at]), float(worst.tau[at])
    sign = r"\leq" if top <= allowed else ">"
    w.formula(
        rf"\sigma_§eq§=\sqrt{{{t(sigma)}^2+4\cdot{t(tau)}^2}}={t(top)}[MPa]\ {sign}\ [\sigma]="
        rf"\frac{{{t(steel.yields)}}}{{{t(limits.static)}}}={t(allowed)}[MPa]",
        "34",
    )
    w.text("s_ok" if top <= allowed else "s_bad")


def dangerous(c: Calculation) -> Section:
    """The section with the largest stress over the cycle."""
    return max(c.sections.values(), key=lambda s: float(s.equivalent.max()))


def _fatigue(w: ChapterWriter, c: Calculation) -> None:
    low, high = c.given.limits.fatigue
    t = w.tex
    w.head("h_fatigue")
    w.text("s_fatigue")
    w.formulas("fatigue")
    rows = []
    for f in c.fatigue:
        values = (f.angle_deg, f.sigma_a, f.sigma_m, f.tau_a, f.tau_m, f.n_sigma, f.n_tau, f.n)
        rows.append((w.say(f"x_{f.section}"), *map(w.number, values)))
    w.table(
        "t_fatigue",
        [w.say("c_section").partition(",")[0], "θ, °", "σ_{a}", "σ_{m}", "τ_{a}", "τ_{m}", "n_{σ}", "n_{τ}", "n"],
        rows,
    )
    f = min(c.fatigue, key=lambda one: one.n)
    k = c.given.concentration["crankpin" if f.section == "crankpin" else "journal"]
    steel = c.given.materials["shaft"]
    w.text("s_fatigue_at", section=w.say(f"x_{f.section}"))
    w.formula(
        rf"n_\sigma=\frac{{{t(steel.fatigue)}}}{{\frac{{{t(k.k_sigma)}}}{{{t(k.size_sigma)}}}\cdot{t(f.sigma_a)}"
        rf"+{t(steel.psi)}\cdot{t(max(f.sigma_m, 0.0))}}}={t(f.n_sigma)},\quad n={t(f.n)}"
    )
    w.text("s_limits", low=low, high=high)
    w.text("s_fat_low" if f.n < low else "s_fat_high" if f.n > high else "s_fat_ok", n=f.n)
    above = [w.say(f"x_{one.section}") for one in c.fatigue if one.n > high]
    if above and f.n <= high:
        w.text("s_fat_reserve", names=", ".join(above))
    w.mistake("m_eps")
