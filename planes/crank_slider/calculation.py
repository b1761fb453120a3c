"""The whole calculation of a scene, in the order of the text."""

import math

import numpy as np

from planes.crank_slider.forces import (
    CycleForces,
    CycleWork,
    Replacement,
    classical_forces,
    forces_over_cycle,
    replacement_masses,
    work_over_cycle,
)
from planes.crank_slider.given import Given
from planes.crank_slider.kinematics import (
    DrawnRodMotion,
    EngineCycle,
    RodMotion,
    draw_cycle_plans,
    largest_magnitude,
    largest_relative_difference,
    motion_by_coordinates,
    motion_by_instant_centre,
    rod_inclination,
)
from planes.crank_slider.reading import read_given_data
from planes.crank_slider.rod import PinStrength, RodStrength, pin_strength, rod_strength
from planes.crank_slider.shaft import (
    Balance,
    Fatigue,
    Section,
    Supports,
    balance_rotating_masses,
    bearing_reactions,
    dangerous_sections,
    fatigue_of_section,
)
from planes.geometry.arrays import Array
from planes.scene import Scene
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.frozen import frozen
from planes.words.names import NumbersByName


@frozen
class Agreement:
    """The largest differences of two methods over the cycle, relative to ωr, ω²r, ω, ω², and to the largest force."""

    velocity: NumbersByName
    acceleration: NumbersByName
    omega: NumbersByName
    epsilon: NumbersByName
    forces: float
    torque: float
    lever: float
    work: float


@frozen
class Calculation:
    """All results. A part left out of the scene is None."""

    scene: Scene
    given: Given
    motion: EngineCycle
    pressure: Array
    points: RodMotion
    plane: RodMotion
    forces: CycleForces
    simple: CycleForces
    parts: Replacement
    work: CycleWork
    agreement: Agreement
    balance: Balance | None
    supports: Supports | None
    sections: dict[str, Section]
    fatigue: tuple[Fatigue, ...]
    rod: RodStrength | None
    pin: PinStrength | None

    def at(self, phi_deg: float) -> int:
        """The step of the cycle nearest to a crank angle."""
        return int(np.abs(self.motion.phi_deg - phi_deg).argmin())

    def angle(self, phi_deg: float) -> float:
        """The crank angle of that step, degrees."""
        return float(self.motion.phi_deg[self.at(phi_deg)])

    def steps(self, end: int) -> range:
        """The steps up to the given one that are written out: every 30°."""
        return range(0, end, max(1, round(30 / self.given.step_deg)))

    @property
    def turn(self) -> slice:
        """The steps of the first whole turn, both ends included."""
        return slice(0, round(360.0 / self.given.step_deg) + 1)


def engine_cycle_and_pressure(given: Given) -> tuple[EngineCycle, Array]:
    """The cycle: angles, ω, ε, gas force; and the absolute pressure, Pa."""
    d = given.indicator
    shape = given.shape
    turned = np.linspace(0.0, d.cycle_deg, round(d.cycle_deg / given.step_deg) + 1)
    phi_deg = d.start_deg + turned
    phi = np.radians(phi_deg)
    path = (shape.r + shape.l - shape.r * np.cos(phi) - shape.l * np.cos(rod_inclination(shape, phi))) / (2 * shape.r)
    pressure = d.pressure(turned, np.clip(path, 0.0, 1.0))
    speed = given.speed
    wave = speed.waves * (phi - math.radians(speed.phase_deg))
    omega = shape.omega * (1 + speed.unevenness / 2 * np.sin(wave))
    epsilon = omega * shape.omega * speed.unevenness / 2 * speed.waves * np.cos(wave)
    return EngineCycle(phi_deg, omega, epsilon, (pressure - given.ambient) * math.pi / 4 * given.bore**2), pressure


def calculate(scene: Scene) -> Calculation:
    """Read the scene and calculate all its chapters."""
    given = read_given_data(scene)
    shape = given.shape
    motion, pressure = engine_cycle_and_pressure(given)
    points = motion_by_coordinates(shape, motion)
    plane = motion_by_instant_centre(shape, motion)
    _check_friction(scene, given, motion)
    drawn = draw_cycle_plans(scene, shape, motion)
    forces = forces_over_cycle(shape, motion, plane)
    done = work_over_cycle(shape, motion, plane, forces, given.bore, given.allowed_unevenness)
    weights = given.counterweights
    level = balance_rotating_masses(shape, given.shaft, weights, motion, drawn) if given.shaft and weights else None
    held = bearing_reactions(shape, given.shaft, weights, level, forces) if given.shaft else None
    cut = dangerous_sections(shape, given.shaft, held) if given.shaft and held else {}
    rod = given.rod
    pin = given.pin
    steels = given.materials
    result = Calculation(
        scene=scene,
        given=given,
        motion=motion,
        pressure=pressure,
        points=points,
        plane=plane,
        forces=forces,
        simple=classical_forces(shape, motion, plane),
        parts=replacement_masses(shape),
        work=done,
        agreement=_agreement_of_methods(given, points, plane, drawn, forces, done),
        balance=level,
        supports=held,
        sections=cut,
        fatigue=_fatigue_of_sections(given, cut),
        rod=rod_strength(shape, motion, plane, forces, rod, steels["rod"]) if rod else None,
        pin=pin_strength(motion, forces, pin, steels["piston_pin"]) if pin else None,
    )
    _check_not_overstressed(result)
    return result


def _check_friction(scene: Scene, given: Given, motion: EngineCycle) -> None:
    locked = given.shape.f * np.abs(np.tan(rod_inclination(given.shape, motion.phi))) >= 1.0
    if locked.any():
        phi = float(motion.phi_deg[locked.argmax()])
        raise SceneError(Phrase("cs_locked", phi=phi, f=given.shape.f), scene.file)


def _fatigue_of_sections(given: Given, cut: dict[str, Section]) -> tuple[Fatigue, ...]:
    shaft = given.shaft
    if shaft is None:
        return ()
    steel = given.materials["shaft"]
    k = given.concentration
    rounds = {"journal_A": "journal", "crankpin": "crankpin", "journal_B": "journal"}
    return tuple(
        fatigue_of_section(cut[name], getattr(shaft, round_key), steel, k[round_key])
        for name, round_key in rounds.items()
    )


def _check_not_overstressed(c: Calculation) -> None:
    """A part stressed beyond its strength breaks: that is an error, not a result."""
    stresses = [(s.name, float(s.equivalent.max()), "shaft") for s in c.sections.values()]
    if c.rod:
        stresses.append(("rod", c.rod.sigma, "rod"))
    if c.pin:
        stresses.append(("piston_pin", c.pin.equivalent, "piston_pin"))
    for part, stress, key in stresses:
        steel = c.given.materials[key]
        if stress > steel.strength:
            line = c.scene.where.get(("crank_slider", key))
            words = Phrase("cs_thin_stress", part=Phrase(f"cs_{part}"), stress=stress, strength=steel.strength)
            raise SceneError(words, c.scene.file, line)


def _agreement_of_methods(
    given: Given, points: RodMotion, plane: RodMotion, drawn_plans: DrawnRodMotion, f: CycleForces, done: CycleWork
) -> Agreement:
    w = given.shape.omega
    r = given.shape.r
    ways = {"points_plane": (points, plane), "points_plans": (points, drawn_plans), "plane_plans": (plane, drawn_plans)}
    velocity = {k: largest_relative_difference(a.v, b.v, w * r) for k, (a, b) in ways.items()}
    acceleration = {k: largest_relative_difference(a.a, b.a, w**2 * r) for k, (a, b) in ways.items()}
    omega = {k: largest_magnitude(a.omega - b.omega) / w for k, (a, b) in ways.items()}
    epsilon = {k: largest_magnitude(a.epsilon - b.epsilon) / w**2 for k, (a, b) in ways.items()}
    own = f.on_pin, -f.on_rod_at_b, f.N, f.on_crank_from_frame
    drawn = (
        -drawn_plans.on_rod_from_crank,
        drawn_plans.on_slider_from_rod,
        drawn_plans.push,
        drawn_plans.on_crank_from_frame,
    )
    forces = max(largest_magnitude(a - b) for a, b in zip(own, drawn, strict=True)) / max(map(largest_magnitude, own))
    top = largest_magnitude(f.torque) or 1.0
    torque, lever = (largest_magnitude(one - drawn_plans.torque) / top for one in (f.torque, drawn_plans.lever))
    of_work = abs(done.torque - done.gas - done.friction) / max(abs(done.gas), abs(done.torque), 1e-300)
    return Agreement(velocity, acceleration, omega, epsilon, forces, torque, lever, of_work)
