"""The chapters of balancing and of strength; the summary."""

from collections.abc import Iterator, Mapping
from types import SimpleNamespace
from typing import Any

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.pages import KILONEWTONS_PER_NEWTON, ChapterWriter, plotted_lines
from planes.crank_slider.pages_mechanics import record_at_step
from planes.crank_slider.shaft import Section, moment_diagrams
from planes.solving.document import Chart, PlottedLine, ShaftSketch

SOURCE_TEXT_ERRORS = {
    "3": "3",
    "5": "5), (7",
    "20": "20), (21",
    "22": "22",
    "24": "24)–(26",
    "32": "31), (32",
    "35": "35",
}
"""Errors of the source text: the key of the explanation, and the formulas."""


def write_balance(w: ChapterWriter, c: Calculation) -> None:
    """Rotating masses, counterweights, first-order forces."""
    b = c.balance
    weights = c.given.counterweights
    if b is None or weights is None:
        return
    v = SimpleNamespace(b=b, weights=weights, s=c.given.shape, shaft=c.given.shaft, apart=b.left + b.right)
    v.needed_1, v.needed_2 = b.needed
    v.chosen_1, v.chosen_2 = b.chosen
    w.write("balance", v)
    cw = w.say("sub_cw")
    arms = {"a": "a", "b": "b", "r": "r", "R": f"R_{{{cw}}}"}
    masses = {"pin": "m_{R}", "weight_0": f"m_{{1{cw}}}", "weight_1": f"m_{{2{cw}}}"}
    forces = {("pin", "up"): "Φ_{R}", ("weight_0", "down"): f"Φ_{{1{cw}}}", ("weight_1", "down"): f"Φ_{{2{cw}}}"}
    w.figure("f_masses", shaft_sketch(c, masses=masses, forces=forces, sizes=arms))

    def pair(value: float, expected: float) -> str:
        own, other = (
            w.number(force * KILONEWTONS_PER_NEWTON, near=b.force * KILONEWTONS_PER_NEWTON)
            for force in (value, expected)
        )
        return f"{own} ({other})"

    names = {x.name: w.say(f"w_{x.name}", part=weights.translating) for x in b.cases}
    rows = [
        (names[x.name], w.number(x.static_moment), *map(pair, (x.along, x.across, x.second), x.expected))
        for x in b.cases
    ]
    w.table("t_first", w.words("c_weights", "c_static", "c_along", "c_across", "c_second"), rows)
    w.write("shaking", v)
    closed = [(x.name, np.append(x.curve, x.curve[0]) * KILONEWTONS_PER_NEWTON) for x in b.cases]
    curves = tuple(PlottedLine(z.real, z.imag, names[name], i) for i, (name, z) in enumerate(closed))
    w.figure("f_shaking", Chart(w.say("x_along"), w.say("y_across"), curves, equal=True, height_mm=72))


def write_strength(w: ChapterWriter, c: Calculation) -> None:
    """Materials, the crankshaft, the rod, the piston pin."""
    if c.given.materials:
        w.write("strength", c)
        rows = []
        for key, m in c.given.materials.items():
            values = (m.strength, m.yields, m.fatigue, m.fatigue_torsion, m.psi, m.psi_torsion)
            rows.append((w.say(f"p_{key}"), m.name, *values))
        sigmas = (f"σ_{{{w.say('sub_B')}}}", f"σ_{{{w.say('sub_Y')}}}", "σ_{−1}", "τ_{−1}", "ψ_{σ}", "ψ_{τ}")
        w.table("t_material", w.words("c_part", "c_steel") + sigmas, rows)
        w.write("shaft", c)
        if c.given.shaft:
            _write_bearing_reactions(w, c)
            _write_static_strength(w, c)
            _write_fatigue(w, c)
    if c.rod:
        _write_rod_strength(w, c)
    if c.pin:
        _write_pin_strength(w, c)


def worst_load_steps(c: Calculation) -> dict[str, int]:
    """The steps of the largest normal and the largest tangential force."""
    return {"I": int(np.abs(c.forces.K).argmax()), "II": int(np.abs(c.forces.T).argmax())}


def shaft_sketch(c: Calculation, **shown: Mapping[Any, str]) -> ShaftSketch:
    """The crankshaft, with masses, forces or dimensions."""
    shaft = c.given.shaft
    weights = c.given.counterweights
    r = c.given.shape.r
    assert shaft
    low = weights.radius if weights else r
    return ShaftSketch(shaft.span, shaft.span - shaft.pin_from_b, shaft.webs, r, low, **shown)


def _write_bearing_reactions(w: ChapterWriter, c: Calculation) -> None:
    """The bearing reactions, and the moments along the shaft in both cases."""
    shaft = c.given.shaft
    held = c.supports
    cw = w.say("sub_cw")
    assert shaft and held
    weights = {(f"weight_{k}", "down"): f"Φ_{{{k + 1}{cw}}}" for k in (0, 1)}
    webs = {(f"web_{k}", "up"): "Φ" for k in (0, 1)}
    pin = {("pin", "up"): "N_{c1}", ("pin", "across"): "P_{t1}"}
    bearings = {(x, way): f"{x}{sign}" for x in "AB" for way, sign in (("up", "′"), ("across", "″"))}
    sketch = shaft_sketch(c, forces=pin | webs | weights | bearings, sizes=dict(zip("mabnL", "mabnL", strict=True)))
    w.figure("f_sketch", sketch, a=shaft.left, b=shaft.right)
    at = [SimpleNamespace(name=name, phi=c.motion.phi_deg[k]) for name, k in worst_load_steps(c).items()]
    w.write("reactions", SimpleNamespace(held=held, K=at[0], T=at[1]))
    for (name, k), case in zip(worst_load_steps(c).items(), at, strict=True):
        case.held = record_at_step(held, k)
        case.shaft = shaft
        case.to_right = shaft.span - shaft.webs
        case.left = held.web - held.left_weight
        case.right = held.web - held.right_weight
        w.write("case", case)
        x, *moments = moment_diagrams(shaft, c.sections, k)
        curves = plotted_lines(x, dict(zip(w.words("l_Mz", "l_My", "l_Mx"), moments, strict=True)))
        w.figure("f_moments", Chart(w.say("x_shaft"), w.say("y_Nm"), tuple(curves), height_mm=58), case=name)


def _write_static_strength(w: ChapterWriter, c: Calculation) -> None:
    w.write("static", c)
    rows = []
    for s in c.sections.values():
        columns = (s.bending_z, s.bending_y, s.torsion, s.sigma, s.tau, s.equivalent)
        rows += [
            (f"{w.say(f'x_{s.name}')}, {name}", *(x[k] for x in columns)) for name, k in worst_load_steps(c).items()
        ]
    head = (w.say("c_section"), "M_{z}", "M_{y}", "M_{x}", "σ", "τ", f"σ_{{{w.say('sub_eq')}}}")
    w.table("t_static", head, rows)
    worst = most_stressed_section(c)
    limits = c.given.limits
    steel = c.given.materials["shaft"]
    at = int(worst.equivalent.argmax())
    v = SimpleNamespace(limits=limits, steel=steel, worst=record_at_step(worst, at), section=w.say(f"x_{worst.name}"))
    v.phi = c.motion.phi_deg[at]
    v.top = worst.equivalent[at]
    v.allowed = steel.yields / limits.static
    v.holds = v.top <= v.allowed
    v.sign = r"\leq" if v.holds else ">"
    w.write("dangerous", v)


def most_stressed_section(c: Calculation) -> Section:
    """The section with the largest stress over the cycle."""
    return max(c.sections.values(), key=lambda s: float(s.equivalent.max()))


def _write_fatigue(w: ChapterWriter, c: Calculation) -> None:
    rows = []
    for f in c.fatigue:
        values = (f.angle_deg, f.sigma_a, f.sigma_m, f.tau_a, f.tau_m, f.n_sigma, f.n_tau, f.n)
        rows.append((w.say(f"x_{f.section}"), *values))
    signs = ("θ, °", "σ_{a}", "σ_{m}", "τ_{a}", "τ_{m}", "n_{σ}", "n_{τ}", "n")
    w.table("t_fatigue", (w.say("c_section").partition(",")[0], *signs), rows)
    f = min(c.fatigue, key=lambda one: one.n)
    low, high = c.given.limits.fatigue
    k = c.given.concentration["crankpin" if f.section == "crankpin" else "journal"]
    v = SimpleNamespace(f=f, k=k, steel=c.given.materials["shaft"], section=w.say(f"x_{f.section}"), low=low, high=high)
    v.mean = max(f.sigma_m, 0.0)
    v.weak = f.n < low
    v.strong = f.n > high
    v.right = low <= f.n <= high
    v.above = "" if v.strong else ", ".join(w.say(f"x_{one.section}") for one in c.fatigue if one.n > high)
    w.write("fatigue", v)


def _write_rod_strength(w: ChapterWriter, c: Calculation) -> None:
    r = c.rod
    shank = c.given.rod
    assert r and shank
    v = SimpleNamespace(r=r, steel=c.given.materials["rod"], limits=c.given.limits)
    v.area = shank.area * 1e6
    v.modulus = shank.modulus * 1e9
    v.bending = r.bending * 1e3
    w.write("rod", v)
    rows = [(w.say(f"b_plane_{i}"), b.mu, b.slenderness, b.critical, r.sigma_c, b.n) for i, b in enumerate(r.planes)]
    cr, sq = w.words("sub_cr", "sub_c")
    w.table("t_buckling", [w.say("c_plane"), "μ", "Λ", f"σ_{{{cr}}}", f"σ_{{{sq}}}", "n"], rows)
    v.holds = min(b.n for b in r.planes) >= v.limits.buckling
    w.write("buckling", v)


def _write_pin_strength(w: ChapterWriter, c: Calculation) -> None:
    p = c.pin
    pin = c.given.pin
    limits = c.given.limits
    mm = 1e3
    assert p and pin
    ratio = pin.section.bore / pin.section.d
    v = SimpleNamespace(p=p, pin=pin, limits=limits, ratio=ratio, above=1 + ratio + ratio**2, below=1 + ratio**2)
    v.d = pin.section.d * mm
    v.bush = pin.bush * mm
    v.bosses = (pin.length - pin.gap) * mm
    v.area = pin.section.area * 1e6
    v.moment = p.moment * 1e3
    v.holds = p.bush <= limits.bush_mpa and p.boss <= limits.boss_mpa
    w.write("pin", v)


def write_summary(w: ChapterWriter, c: Calculation) -> None:
    """Every check in one table, and every error of the source text in another."""
    w.write("summary", c)
    rows = []
    for name, value, low, high, ok in checks_with_bounds(c):
        bounds = ("" if low is None else f"{w.number(low)} ≤ ", "" if high is None else f" ≤ {w.number(high)}")
        rows.append((w.say(f"c_{name}"), value, "…".join(bounds), w.say("yes" if ok else "no")))
    if rows:
        w.table("t_summary", w.words("c_check", "c_found", "c_needed", "c_verdict"), rows)
    w.table(
        "t_wrong",
        w.words("c_formula", "c_error"),
        [(f"({n})", w.say(f"e_{key}")) for key, n in SOURCE_TEXT_ERRORS.items()],
    )


def checks_with_bounds(c: Calculation) -> Iterator[tuple[str, float, float | None, float | None, bool]]:
    """Name, value found, bounds, whether it passes."""
    for name, value, low, high in _checked_values(c):
        yield name, value, low, high, (low is None or value >= low) and (high is None or value <= high)


def _checked_values(c: Calculation) -> Iterator[tuple[str, float, float | None, float | None]]:
    g = c.given.limits
    if c.sections:
        yield (
            "static_shaft",
            c.given.materials["shaft"].yields / float(most_stressed_section(c).equivalent.max()),
            g.static,
            None,
        )
        yield "fatigue_shaft", min(f.n for f in c.fatigue), *g.fatigue
    if c.rod:
        yield "rod_static", c.rod.n, g.static, None
        yield "rod_buckling", min(b.n for b in c.rod.planes), g.buckling, None
    if c.pin:
        yield "pin_static", c.pin.n, g.static, None
        yield "pin_bush", c.pin.bush, None, g.bush_mpa
        yield "pin_boss", c.pin.boss, None, g.boss_mpa
