"""The calculation as an object for programs: SI, full precision, stresses and strengths in MPa."""

from __future__ import annotations

import math
from dataclasses import asdict
from typing import Any

import numpy as np

from planes.crank_slider.calculation import Calculation
from planes.crank_slider.misprints import printed
from planes.crank_slider.pages_rod import checks


def as_json(c: Calculation) -> dict[str, Any]:
    """What ``planes crank-slider --json`` prints."""
    found: dict[str, Any] = {
        "planes": 1,
        "scene": c.scene.file,
        "variant": c.scene.variant,
        "agreement": asdict(c.agreement),
        "kinematics": _kinematics(c),
        "replacement": _plain({**asdict(c.parts), "percent": c.parts.percent}),
        "forces": _forces(c),
        "torque": _work(c),
    }
    if c.balance:
        found["balance"] = _balance(c)
    if c.supports:
        found["shaft"] = _shaft(c)
        found["fatigue"] = [_plain(asdict(f)) for f in c.fatigue]
    if c.rod:
        found["rod"] = _plain(asdict(c.rod))
    if c.pin:
        found["piston_pin"] = _plain(asdict(c.pin))
    found["checks"] = [
        {"name": n.removeprefix("c_"), "found": v, "low": low, "high": high, "holds": ok}
        for n, v, low, high, ok in checks(c)
    ]
    found["source_text"] = [
        {
            "phi_deg": float(c.motion.phi_deg[k]),
            "printed": _plain(asdict(printed(c.given.shape, c.motion, c.plane, c.forces, k))),
        }
        for k in map(c.at, c.given.positions)
    ]
    return found


def _plain(value: Any) -> Any:
    """Numbers a program can read; what is not finite becomes null."""
    if isinstance(value, dict):
        return {k: _plain(v) for k, v in value.items()}
    if isinstance(value, list | tuple):
        return [_plain(v) for v in value]
    if isinstance(value, np.ndarray):
        return [_plain(v) for v in value.tolist()]
    if isinstance(value, complex):
        return [value.real, value.imag]
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value


def _kinematics(c: Calculation) -> dict[str, Any]:
    p = c.points
    points = {n: {"r": _plain(p.r[n]), "v": _plain(p.v[n]), "a": _plain(p.a[n])} for n in ("A", "B", "C")}
    return {
        "phi_deg": _plain(c.motion.phi_deg),
        "omega": _plain(c.motion.omega),
        "epsilon": _plain(c.motion.epsilon),
        "points": points,
        "omega_AB": _plain(c.plane.omega),
        "epsilon_AB": _plain(c.plane.epsilon),
    }


def _forces(c: Calculation) -> dict[str, Any]:
    f = c.forces
    return {
        "pressure": _plain(c.pressure),
        "gas": _plain(c.motion.gas),
        **{name: _plain(getattr(f, name)) for name in ("P", "N", "S", "T", "K")},
        "friction": _plain(f.rubbing),
        "F_on_crank_from_rod": _plain(f.on_pin),
        "F_on_crank_from_frame": _plain(f.on_crank_from_frame),
        "M": _plain(f.torque),
    }


def _work(c: Calculation) -> dict[str, Any]:
    return {k: v for k, v in _plain(asdict(c.work)).items() if k != "curve"}


def _balance(c: Calculation) -> dict[str, Any]:
    assert c.balance
    found: dict[str, Any] = _plain(asdict(c.balance))
    for case in found["cases"]:
        del case["curve"]
    return found


def _shaft(c: Calculation) -> dict[str, Any]:
    assert c.supports
    s = c.supports
    sections = {
        x.name: {"sigma": _plain(x.sigma), "tau": _plain(x.tau), "equivalent": _plain(x.equivalent)}
        for x in c.sections.values()
    }
    return {
        "A1": _plain(s.A1),
        "A2": _plain(s.A2),
        "B1": _plain(s.B1),
        "B2": _plain(s.B2),
        "web": s.web,
        "counterweights": [s.left_weight, s.right_weight],
        "sections": sections,
    }
