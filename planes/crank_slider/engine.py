"""The general plans over the whole cycle: one program, every crank angle at once."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from planes.crank_slider.shape import CrankSliderShape
from planes.drafting.drawing import Drawing, run
from planes.geometry.arrays import Array, Complexes
from planes.plans import Plans, plans_of
from planes.plans.scales import unit_scales
from planes.scene import Scene
from planes.scene.mechanism import Load, Mechanism
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import at


@dataclass(frozen=True)
class EngineCycle:
    """Angle, ω, ε of the crank and the gas force on the piston (N, + towards the crank) at every step of the cycle."""

    phi_deg: Array
    omega: Array
    epsilon: Array
    gas: Array

    @property
    def phi(self) -> Array:
        """φ in radians."""
        return np.radians(self.phi_deg)


@dataclass(frozen=True)
class RodMotion:
    """Places, velocities, accelerations of A, B, C as complex numbers; ω_AB, ε_AB, counter-clockwise positive."""

    r: dict[str, Complexes]
    v: dict[str, Complexes]
    a: dict[str, Complexes]
    omega: Array
    epsilon: Array


@dataclass(frozen=True)
class Found(RodMotion):
    """What the plans give, SI, places from the crank's pivot; a force is on the first-named link.

    ``push`` is the normal push of the guide on the slider, up positive; ``torque`` the moment the crank gives off.
    """

    on_rod_from_crank: Complexes
    on_slider_from_rod: Complexes
    on_slider: Complexes
    on_crank_from_frame: Complexes
    torque: Array
    lever: Array

    @property
    def push(self) -> Array:
        """The guide's normal push on the slider."""
        return self.on_slider.imag


def loaded(mechanism: Mechanism, shape: CrankSliderShape, gas: float = 0.0) -> Mechanism:
    """The mechanism with the gas force on its slider, towards the crank."""
    load = Load(shape.slider, "force", gas, shape.hinge, 180.0)
    return replace(mechanism, loads=(load,))


def follow(scene: Scene, shape: CrankSliderShape, motion: EngineCycle) -> Found:
    """Draw the plans of every position of the cycle."""
    assert scene.mechanism is not None
    plans = plans_of(loaded(scene.mechanism, shape), scene.file)
    moved = {
        plans.drive_given: motion.phi_deg,
        f"omega_{shape.crank}": motion.omega,
        f"epsilon_{shape.crank}": motion.epsilon,
        f"P_{shape.slider}_given": motion.gas,
    }
    drawing = run(plans.program, {**plans.given, **unit_scales(plans), **moved})
    found = _read(plans, drawing, shape, np.shape(motion.phi_deg))
    _check(scene, shape, motion, found)
    return found


def _read(plans: Plans, drawing: Drawing, shape: CrankSliderShape, size: tuple[int, ...]) -> Found:
    def mark(name: str) -> Complexes:
        return np.broadcast_to(np.asarray(drawing[name], complex), size)

    def force(on: str, by: str) -> Complexes:
        r = next(r for r in plans.reactions.values() if {r.pair.link, r.pair.other} == {on, by})
        way = mark(r.end) - mark(r.start)
        return way if r.pair.link == on else -way

    def value(name: str) -> Array:
        return np.broadcast_to(np.asarray(drawing[name], float), size)

    points = {"A": shape.pin, "B": shape.hinge, "C": shape.centre, "S": plans.mechanism.links[shape.crank].mass_centre}
    pivot = mark(at("position", shape.pivot))
    rod = plans.links[shape.rod]
    return Found(
        {k: mark(plans.points[p].position) - pivot for k, p in points.items()},
        {k: mark(plans.points[p].velocity) for k, p in points.items()},
        {k: mark(plans.points[p].acceleration) for k, p in points.items()},
        value(rod.omega),
        value(rod.epsilon),
        force(shape.rod, shape.crank),
        force(shape.slider, shape.rod),
        force(shape.slider, "0"),
        force(shape.crank, "0"),
        -value(plans.balancing),
        -value(plans.zhukovsky),
    )


def _check(scene: Scene, shape: CrankSliderShape, motion: EngineCycle, found: Found) -> None:
    bad = ~np.isfinite(found.torque) | ~np.isfinite(found.r["B"])
    if bad.any():
        phi = float(motion.phi_deg[np.argmax(bad)])
        words = Phrase("cs_locked", phi=phi, f=shape.f) if shape.f else Phrase("cs_engine", phi=phi)
        raise SceneError(words, scene.file)
    if (found.r["B"].real < found.r["A"].real).any():
        raise SceneError(Phrase("cs_behind", point=shape.hinge), scene.file)
