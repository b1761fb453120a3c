"""The chapter of strength: rod and piston pin; the summary."""

from __future__ import annotations

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.given import PistonPin
from planes.crank_slider.pages import ChapterWriter
from planes.crank_slider.rod import PinStrength, RodStrength
from planes.crank_slider.sections import Shank


def write_rod(w: ChapterWriter, c: Calculation) -> None:
    """The rod, the piston pin."""
    if c.rod is not None and c.given.rod is not None:
        _rod(w, c, c.rod, c.given.rod)
    if c.pin is not None and c.given.pin is not None:
        _pin(w, c, c.pin, c.given.pin)


def _rod(w: ChapterWriter, c: Calculation, r: RodStrength, of: Shank) -> None:
    t, need = w.tex, c.given.limits.buckling
    steel = c.given.materials["rod"]
    w.head("h_rod")
    w.text("s_rod", area=of.area * 1e6, modulus=of.modulus * 1e9, phi_c=r.squeezed_deg, phi_p=r.pulled_deg)
    w.formula(
        rf"\sigma_§c§=\frac{{S_§max§}}{{F}}=\frac{{{t(r.squeezed)}}}{{{t(of.area * 1e6)}}}={t(r.sigma_c)}[MPa],\quad"
        rf"\sigma_§tens§=\frac{{{t(r.pulled)}}}{{{t(of.area * 1e6)}}}={t(r.sigma_p)}[MPa]"
    )
    w.text("s_whip", phi=r.bending_deg)
    w.formula(
        rf"M_§b§={t(r.bending)}[N·m],\quad\sigma_§b§=\frac{{M_§b§}}{{W}}="
        rf"\frac{{{t(r.bending * 1e3)}}}{{{t(of.modulus * 1e9)}}}={t(r.sigma_b)}[MPa]"
    )
    w.text("s_rod_sum", phi=r.sigma_deg)
    w.formula(
        rf"\sigma={t(r.sigma)}[MPa],\quad n=\frac{{\sigma_§Y§}}{{\sigma}}="
        rf"\frac{{{t(steel.yields)}}}{{{t(r.sigma)}}}={t(r.n)}"
    )
    w.text("s_buckling", limit=r.limit)
    rows = [
        (w.say(f"b_plane_{i}"), *(w.number(v) for v in (b.mu, b.slenderness, b.critical, r.sigma_c, b.n)))
        for i, b in enumerate(r.planes)
    ]
    cr, sq = w.say("sub_cr"), w.say("sub_c")
    w.table("t_buckling", [w.say("c_plane"), "μ", "Λ", f"σ_{{{cr}}}", f"σ_{{{sq}}}", "n"], rows)
    w.text("s_n_ok" if min(b.n for b in r.planes) >= need else "s_n_bad", need=need)


def _pin(w: ChapterWriter, c: Calculation, p: PinStrength, of: PistonPin) -> None:
    t, mm, limits = w.tex, 1e3, c.given.limits
    d, ratio = of.section.d * mm, of.section.bore / of.section.d
    w.head("h_pin")
    w.text("s_pin", force=p.force, phi=p.force_deg)
    w.formula(
        rf"M=\frac{{P}}{{2}}\left(\frac{{l_p+2b}}{{6}}-\frac{{l_§bush§}}{{4}}\right)=\frac{{{t(p.force)}}}{{2}}\left("
        rf"\frac{{{t(of.length)}+2\cdot{t(of.gap)}}}{{6}}-\frac{{{t(of.bush)}}}{{4}}\right)={t(p.moment)}[N·m]"
    )
    w.text("s_pin_stress", ratio=ratio)
    w.formula(
        rf"\sigma=\frac{{32M}}{{\pi d^3(1-\alpha^4)}}=\frac{{32\cdot{t(p.moment * 1e3)}}}{{\pi\cdot{t(d)}^3(1"
        rf"-{t(ratio)}^4)}}={t(p.sigma)}[MPa],"
    )
    w.formula(
        rf"\tau=\frac{{4}}{{3}}\cdot\frac{{P}}{{2F}}\cdot\frac{{1+\alpha+\alpha^2}}{{1+\alpha^2}}=\frac{{4}}{{3}}\cdot"
        rf"\frac{{{t(p.force)}}}{{2\cdot{t(of.section.area * 1e6)}}}\cdot"
        rf"\frac{{{t(1 + ratio + ratio**2)}}}{{{t(1 + ratio**2)}}}={t(p.tau)}[MPa]"
    )
    w.text("s_pin_sum", stress=p.equivalent, n=p.n)
    w.formula(
        rf"q_§bush§=\frac{{P}}{{d\,l_§bush§}}=\frac{{{t(p.force)}}}{{{t(d)}\cdot{t(of.bush * mm)}}}={t(p.bush)}[MPa],"
        rf"\quadq_§boss§=\frac{{P}}{{d\,(l_p-b)}}=\frac{{{t(p.force)}}}{{{t(d)}\cdot{t((of.length - of.gap) * mm)}}}="
        rf"{t(p.boss)}[MPa]"
    )
    holds = p.bush <= limits.bush_mpa and p.boss <= limits.boss_mpa
    w.text("s_pressure_ok" if holds else "s_pressure_bad", bush=limits.bush_mpa, boss=limits.boss_mpa)


def write_summary(w: ChapterWriter, c: Calculation) -> None:
    """Every check in one table, and every error of the source text in another."""
    w.head("h_summary", 1)
    rows = [
        (
            w.say(f"c_{name}"),
            w.number(found),
            (w.number(low) + " ≤ " if low is not None else "")
            + "…"
            + (" ≤ " + w.number(high) if high is not None else ""),
            w.say("yes" if ok else "no"),
        )
        for name, found, low, high, ok in checks(c)
    ]
    if rows:
        w.table("t_summary", [w.say(k) for k in ("c_check", "c_found", "c_needed", "c_verdict")], rows)
    numbers = {
        "3": "(3)",
        "5": "(5), (7)",
        "20": "(20), (21)",
        "22": "(22)",
        "24": "(24)–(26)",
        "32": "(31), (32)",
        "35": "(35)",
    }
    w.table(
        "t_wrong",
        [w.say("c_formula"), w.say("c_error")],
        [(number, w.say(f"e_{key}")) for key, number in numbers.items()],
    )


def checks(c: Calculation) -> list[tuple[str, float, float | None, float | None, bool]]:
    """Name, value found, bounds, whether it holds."""
    g, found = c.given.limits, []

    def add(name: str, value: float, low: float | None, high: float | None = None) -> None:
        found.append((name, value, low, high, (low is None or value >= low) and (high is None or value <= high)))

    if c.sections:
        add(
            "static_shaft",
            c.given.materials["shaft"].yields / max(float(s.equivalent.max()) for s in c.sections.values()),
            g.static,
        )
        add("fatigue_shaft", min(f.n for f in c.fatigue), *g.fatigue)
    if c.rod:
        add("rod_static", c.rod.n, g.static)
        add("rod_buckling", min(b.n for b in c.rod.planes), g.buckling)
    if c.pin:
        add("pin_static", c.pin.n, g.static)
        add("pin_bush", c.pin.bush, None, g.bush_mpa)
        add("pin_boss", c.pin.boss, None, g.boss_mpa)
    return found
