"""Other programs on the same mechanism, for comparison, if installed (the extra ``bench``).

pylinkage computes positions, velocities and accelerations of cranks and of RRR and RRP groups on frame guides by its
compiled path; kinepy computes positions of any group, with velocities and accelerations from differences.
"""

import cmath
import contextlib
import io
import itertools
import math
from collections.abc import Callable, Iterator
from importlib.metadata import version
from importlib.util import find_spec
from typing import Any

import numpy as np

from planes.accuracy.baselines import rates_by_central_differences
from planes.accuracy.comparison import Comparison, OtherProgram, Triple
from planes.plans import Plans
from planes.plans.assur.groups import Group, Pair
from planes.scene.mechanism import FRAME, Mechanism

Near = Callable[[int], dict[str, complex]]
PER_STEP = 1e-3  # rad of the crank, in a timed table


def installed() -> list[OtherProgram]:
    """The installed programs."""
    made = {"pylinkage": _pylinkage, "kinepy": _kinepy}
    return [make(version(name)) for name, make in made.items() if find_spec(name)]


def near_of(bench: Comparison, values: Any) -> Near:
    """The approximate positions of all points, by the number of the position."""
    table = bench.columns_by_loop(values, False)
    rows = {c.name: row for c, row in zip(bench.cycle.columns, table, strict=True)}
    return lambda k: {p: complex(rows[f"r_{p}_x"][k], rows[f"r_{p}_y"][k]) for p in bench.points}


def _pylinkage(number: str) -> OtherProgram:
    def work(bench: Comparison, values: Any) -> Any:
        return bench.columns_from_point_results(pylinkage_at(bench.plans_at, values, near_of(bench, values)))

    def quickest(bench: Comparison, values: Any) -> Callable[[Any], Any]:
        return pylinkage_run(bench.plans, values[0], near_of(bench, values)(0))

    return OtherProgram(f"pylinkage {number}", Pylinkage.can, work, quickest, 100_000)


def _kinepy(number: str) -> OtherProgram:
    def work(bench: Comparison, values: Any) -> Any:
        return bench.columns_from_point_results(kinepy_at(bench.plans_at, values, near_of(bench, values)))

    return OtherProgram(f"kinepy {number}", lambda _: True, work, lambda bench, _: kinepy_run(bench.plans), 10_000)


class Pylinkage:
    """A crank and groups of two links, each point computed from those before it."""

    @staticmethod
    def can(plans: Plans) -> bool:
        """Whether it supports all the groups: RRR, and RRP with the slider's hinge on a guide of the frame."""
        reached = set(plans.mechanism.frame.points) | set(plans.mechanism.links[plans.mechanism.drive.link].points)
        for g in plans.structure.class_two_groups:
            if not (g.kind == 1 or (g.kind == 2 and _on_frame(plans.mechanism, g))):
                return False
            if not {p.point for p in (g.first_outer, g.last_outer) if p.kind == "R"} <= reached:
                return False
            reached.add(g.inner.point)
        return plans.mechanism.drive.kind == "phi"

    def __init__(self, plans: Plans, value: float, near: dict[str, complex], step: float = 0.0) -> None:
        from pylinkage.components import Ground
        from pylinkage.simulation import Linkage

        m = plans.mechanism
        self.plans = plans
        self.named: dict[str, Any] = {p: Ground(z.real, z.imag, name=p) for p, z in m.frame.points.items()}
        self.parts: dict[str, Any] = dict(self.named)
        self.extra: list[Any] = []
        self.step = step  # rad of the crank between positions
        self._cranks(value)
        for g in plans.structure.class_two_groups:
            self._group(g, near[g.inner.point])
        self.linkage = Linkage([*self.named.values(), *self.extra], name="scene")
        for crank in self.cranks:
            self.linkage.set_input_velocity(crank, omega=m.drive.velocity, alpha=m.drive.acceleration)

    def _cranks(self, value: float) -> None:
        from pylinkage.actuators import Crank

        m, pivot = self.plans.mechanism, self.plans.structure.drive_pair.point
        points = m.links[m.drive.link].points
        self.cranks: list[Any] = []
        for name, place in points.items():
            arm = place - points[pivot]
            if name != pivot and arm:
                angle = math.radians(value) + cmath.phase(arm) - self.step  # it steps before it returns
                crank = Crank(self.named[pivot], abs(arm), angular_velocity=self.step, initial_angle=angle)
                self.named[name], self.parts[name] = crank, crank.output
                self.cranks.append(crank)

    def _group(self, g: Group, near: complex) -> None:
        from pylinkage.components import Ground
        from pylinkage.dyads import RRPDyad, RRRDyad

        m, hinge, one = self.plans.mechanism, g.inner.point, g.first_outer.point
        radius = _apart(m, g.first, one, hinge)
        here = {"x": near.real, "y": near.imag, "name": hinge}
        if g.kind == 1:
            two = g.last_outer.point
            other = _apart(m, g.last, two, hinge)
            self.named[hinge] = RRRDyad(self.parts[one], self.parts[two], radius, other, **here)
        else:
            guide = m.guide(g.last_outer.guide)
            along = guide.through + cmath.exp(1j * math.radians(guide.angle_deg))
            ends = [Ground(z.real, z.imag) for z in (guide.through, along)]
            self.extra += ends
            self.named[hinge] = RRPDyad(self.parts[one], *ends, radius, **here)
        self.parts[hinge] = self.named[hinge]

    def run(self, count: int) -> Any:
        """Tables of positions, velocities and accelerations for this number of positions."""
        return self.linkage.step_fast_with_kinematics(count, 1.0)

    def triples(self) -> dict[str, Triple]:
        """Position, velocity and acceleration of every point it knows."""
        found = self.run(1)
        rows = [[complex(*table[0, k]) for table in found] for k in range(len(self.named))]
        return {name: (r, v, a) for name, (r, v, a) in zip(self.named, rows, strict=True)}


def _on_frame(m: Mechanism, g: Group) -> bool:
    slides, link = m.link(g.last).slides, m.link(g.last)
    here = (
        g.last_outer.other_link_of_pair(g.last) == FRAME
        and g.last_outer.link == g.last
        and link.first_point == g.inner.point
    )
    return bool(here and slides and not slides.offset)


def _apart(m: Mechanism, link: str, one: str, two: str) -> float:
    return abs(m.link(link).points[two] - m.link(link).points[one])


class Kinepy:
    """Every link a solid, every pair a joint; signs select one of two assemblies."""

    def __init__(self, plans: Plans) -> None:
        import kinepy

        m = plans.mechanism
        self.system, self.solids = kinepy.System(), {FRAME: 0}
        self.links = {name: self.system.add_solid(f"link {name}") for name in m.links}
        self.solids |= self.links
        joints = [self._joint(m, pair) for pair in plans.structure.pairs]
        self.system.pilot(joints[0])
        self.system.compile()
        self.keys, self.shift = list(self.system._object.signs), _start(m, plans.structure.drive_pair)

    def _joint(self, m: Mechanism, pair: Pair) -> Any:
        one, two = self.solids[pair.other], self.solids[pair.link]
        if pair.kind == "R":
            ends = [m.link(name).points[pair.point] for name in (pair.other, pair.link)]
            return self.system.add_revolute(one, two, *((z.real, z.imag) for z in ends))
        (way, along), (own, first) = _axis(m, pair), _slider(m, pair)
        offset = m.link(pair.link).slides.offset or 0.0  # type: ignore[union-attr]
        beside, aside = (way.conjugate() * along).imag, (own.conjugate() * first).imag - offset
        return self.system.add_prismatic(one, two, cmath.phase(way), beside, cmath.phase(own), aside)

    def places(self, values: Any, points: dict[str, tuple[str, complex]], signs: tuple[int, ...]) -> dict[str, Any]:
        """Positions of points (link, position on it) at values of the drive (rad or m)."""
        self.system.change_signs(dict(zip(self.keys, signs, strict=True)))
        self.system.solve_kinematics(np.array(values, float) + self.shift)
        found = {}
        for name, (link, local) in points.items():
            x, y = self.links[link].get_point((local.real, local.imag))
            found[name] = x + 1j * y
        return found


def _axis(m: Mechanism, pair: Pair) -> tuple[complex, complex]:
    """The guide's direction, and a point on it, in the axes of its link."""
    guide = m.guide(pair.guide)
    return cmath.exp(1j * math.radians(guide.angle_deg)), guide.through


def _slider(m: Mechanism, pair: Pair) -> tuple[complex, complex]:
    """The guide's direction in the axes of the slider, and the slider's first point."""
    link = m.link(pair.link)
    assert link.slides
    return cmath.exp(-1j * math.radians(link.slides.angle_deg or 0.0)), link.points[link.first_point]


def _start(m: Mechanism, pair: Pair) -> float:
    """The offset from the drive's value to that of the joint."""
    if pair.kind == "R":
        return 0.0
    (way, along), (own, first) = _axis(m, pair), _slider(m, pair)
    return (way.conjugate() * along).real - (own.conjugate() * first).real


@contextlib.contextmanager
def _quiet() -> Iterator[None]:
    """In SI units, without printed output."""
    from kinepy import units

    units.set_unit_system(units.SI)
    try:
        with contextlib.redirect_stdout(io.StringIO()), np.errstate(all="ignore"):
            yield
    finally:
        units.set_unit_system(units.DEFAULT_SYSTEM)


def pylinkage_at(at: Callable[[int], Plans], values: Any, near: Near) -> list[dict[str, Triple]]:
    """Triples at every position; ``at`` gives the mechanism, ``near`` the approximate positions of its points."""
    found: list[dict[str, Triple]] = [{} for _ in values]
    for k, value in enumerate(values):
        with contextlib.suppress(ArithmeticError, ValueError, TypeError):
            found[k] = Pylinkage(at(k), float(value), near(k)).triples()
    return found


def kinepy_at(at: Callable[[int], Plans], values: Any, near: Near) -> list[dict[str, Triple]]:
    """The same; velocities and accelerations from its positions a step before and after, by its own method."""
    with _quiet():
        return [_kinepy_one(at(k), float(value), near(k)) for k, value in enumerate(values)]


def _kinepy_one(plans: Plans, value: float, near: dict[str, complex]) -> dict[str, Triple]:
    tool, drive = Kinepy(plans), plans.mechanism.drive
    here = math.radians(value) if drive.kind == "phi" else value
    points = {p: (n, z) for n, x in plans.mechanism.links.items() for p, z in x.points.items() if p in near}

    def tried(signs: tuple[int, ...]) -> dict[str, Any]:
        return tool.places([here - PER_STEP, here, here + PER_STEP], points, signs)

    def off(found: dict[str, Any]) -> float:
        return float(sum(np.nan_to_num(abs(z[1] - near[p]), nan=math.inf) for p, z in found.items()))

    best = min(map(tried, itertools.product((1, -1), repeat=len(tool.keys))), key=off)
    rates = drive.velocity, drive.acceleration, PER_STEP
    return {p: (z[1], *rates_by_central_differences(z[1], z[0], z[2], *rates)) for p, z in best.items()}


def pylinkage_run(plans: Plans, value: float, near: dict[str, complex]) -> Callable[[Any], Any]:
    """As many consecutive positions as there are values, by its fastest method, for timing."""
    tool = Pylinkage(plans, value, near, 1e-4)
    return lambda values: tool.run(len(values))


def kinepy_run(plans: Plans) -> Callable[[Any], Any]:
    """Positions at all values at once, for timing; their differences add almost nothing."""
    with _quiet():
        tool = Kinepy(plans)

    def run(values: Any) -> None:
        with _quiet():
            tool.places(np.radians(values), {}, (1,) * len(tool.keys))

    return run
