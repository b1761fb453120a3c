"""Pins with friction, and guides along a circle, in the independent check: Newton's iteration on all equations."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

Vector = NDArray[np.float64]


@dataclass(frozen=True)
class Grip:
    """The couple of a pin per newton of its force: ``column`` of the equations; unknowns ``at`` and ``at + 1``.

    The unknowns are the components of the force.
    """

    at: int
    column: Vector


def place(value: Any) -> complex:
    """A point's local coordinate in any of the three notations."""
    if isinstance(value, Mapping):
        return cmath.rect(float(value["r"]), math.radians(float(value["angle"])))
    return complex(*map(float, value)) if isinstance(value, (list, tuple)) else complex(float(value))


def radius_of(scene: Mapping[str, Any], point: str, *links: str) -> float:
    """The ratio of the friction couple at a point to the force there, m."""
    said = scene.get("friction") or {}
    for name in links:
        if (found := circle_of(scene, name)) and found[1] == point:
            tangent = float(said.get(found[0], 0.0))  # N and T = tangent N in the contact; T turns, at the full radius
            return found[2] * tangent / math.sqrt(1.0 + tangent**2)
    entry = said.get(point)
    return float(entry["coefficient"]) * float(entry["radius"]) if isinstance(entry, Mapping) else 0.0


def circle_of(scene: Mapping[str, Any], link: str) -> tuple[str, str, float] | None:
    """The round guide on which a link slides: its name, its centre, its radius."""
    slides = scene["links"].get(link, {}).get("slides")
    name = str(slides["guide"] if isinstance(slides, Mapping) else slides)
    for body in (scene["frame"], *scene["links"].values()):
        if "radius" in (guide := (body.get("guides") or {}).get(name, {})):
            return name, str(guide["centre"]), float(guide["radius"])
    return None


def without_circles(scene: Mapping[str, Any]) -> dict[str, Any]:
    """The scene with sliders on a circle holding its centre, to the left of their direction of sliding."""
    links = {}
    for name, link in scene["links"].items():
        links[name] = link
        if found := circle_of(scene, name):
            slides = link["slides"] if isinstance(link["slides"], Mapping) else {}
            first = place(next(iter(link["points"].values())))
            back = cmath.rect(found[2] - float(slides.get("offset", 0)), -math.radians(float(slides.get("angle", 0))))
            centre = first + 1j * back
            points = {**link["points"], found[1]: [centre.real, centre.imag]}
            links[name] = {**{k: v for k, v in link.items() if k != "slides"}, "points": points}

    def straight(body: Mapping[str, Any]) -> dict[str, Any]:
        lines = {k: v for k, v in (body.get("guides") or {}).items() if "radius" not in v}
        return {**body, "guides": lines}

    return {**scene, "frame": straight(scene["frame"]), "links": {k: straight(v) for k, v in links.items()}}


def with_pins(a: Vector, b: Vector, grips: list[Grip]) -> Vector | None:
    """a x + column |force of the pin| for every pin = b; None if Newton's iteration does not converge."""
    x = np.linalg.solve(a, b)
    for _ in range(60):
        left, slope = b - a.astype(np.longdouble) @ x, a.copy()
        for g in grips:
            force = math.hypot(*x[g.at : g.at + 2])
            left = left - g.column * force
            for k in (g.at, g.at + 1):
                slope[:, k] += g.column * (x[k] / force if force else 0.0)
        step = np.linalg.solve(slope, left.astype(float))
        x = x + step
        if np.max(np.abs(step)) <= 1e-15 * np.max(np.abs(x)):
            return np.asarray(x)
    return np.asarray(x) if np.max(np.abs(step)) <= 1e-12 * np.max(np.abs(x)) else None
