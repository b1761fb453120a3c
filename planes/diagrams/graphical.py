"""Graphical differentiation by chords and integration by a pole, as programs of steps drawn by any instrument.

The abscissa is the time t of a uniform turn, divided into equal sections. Differentiation: rays parallel to the chords
of the curve are drawn from a pole P at the distance H to the left of the origin; the intercept of a ray on the axis of
ordinates is carried to the middle of its section. Similar triangles give the scale: with μ in mm per unit μ_v =
H·μ_s/μ_t, with μ in units per mm μ_v = μ_s/(H·μ_t). Integration is the reverse: the ordinate of the middle of a section
is carried to the axis, and a parallel to the ray from P through it continues the curve over the section.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

from planes.diagrams.motion import Motion
from planes.drafting.draft import Draft
from planes.drafting.drawing import Drawing, run
from planes.drafting.instruments import Instrument
from planes.drafting.program import Program
from planes.drafting.steps import Carry, LayOff, Put, Similar, Through, Turn
from planes.drafting.steps.crossings import Cross
from planes.geometry.arithmetic import Point, Real
from planes.words.frozen import frozen
from planes.words.names import at, mu_of
from planes.words.units import standard_mu

WIDE_MM = 156.0  # length of the whole turn on the time axis
TALL_MM = 42.0  # the largest ordinate of a diagram
POLES_MM = (10.0, 12.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0)
RIGHT, UP = "→", "↑"
TIME, PAPER = "mu_t", "mu_paper"


@frozen
class Stage:
    """One diagram of a construction: its ``rank`` (0 position, 1 velocity, 2 acceleration), μ (mm per SI unit), its
    pole distance (None: no pole), and its points: (half sections from the start, label)."""

    plan: str
    rank: int
    mu: float
    pole_mm: float | None
    points: tuple[tuple[int, str], ...]
    given: bool


@dataclass
class Construction:
    """A drawing program with its givens and diagrams in drawing order."""

    motion: Motion
    kind: str  # "differentiation" or "integration"
    draft: Draft = field(default_factory=Draft)
    stages: list[Stage] = field(default_factory=list)

    @property
    def mu_t(self) -> float:
        """The scale of time, mm per second."""
        return WIDE_MM / (self.motion.time[-1] - self.motion.time[0])

    @cached_property
    def program(self) -> Program:
        """The steps, checked."""
        return Program(tuple(self.draft.steps.values()))

    def drawn(self, instrument: Instrument | None = None, more: Mapping[str, Point] | None = None) -> Drawing:
        """The construction drawn with an instrument, by default exactly."""
        return run(self.program, {**self.draft.given, **(more or {})}, instrument)

    def exact(self, stage: Stage) -> list[float]:
        """The true values at the points of a diagram, SI."""
        m, ends = self.motion, self.motion.ends[stage.rank]
        halves = (half for half, _ in stage.points)
        return [m.middles[stage.rank][half // 2 % m.sections] if half % 2 else ends[half // 2] for half in halves]

    def measured(self, drawing: Drawing, stage: Stage) -> list[Real]:
        """The measured values at the points of a diagram, SI."""
        return [drawing[_value(stage.plan, label)] for _, label in stage.points]

    # the quantity

    def __post_init__(self) -> None:
        """The two directions of all axes, and the length of a second."""
        d = self.draft
        d.aim(RIGHT, 0.0)
        d.aim(UP, 90.0)
        d.step(Turn("←", RIGHT, 2))
        d.give(TIME, self.mu_t)
        d.give(PAPER, 1.0)

    def axes(self, plan: str, mu: float, pole_mm: float | None) -> None:
        """The origin of a diagram, and its pole."""
        d = self.draft
        d.step(Put(at(plan, "o")))
        d.give(mu_of(plan), mu)
        d.step(LayOff(at(plan, "t"), at(plan, "o"), RIGHT, d.give("t_whole", self.motion.time[-1]), TIME))
        if pole_mm is not None:
            d.step(LayOff(at(plan, "P"), at(plan, "o"), "←", d.give(f"H_{plan}", pole_mm), PAPER))

    def foot(self, plan: str, half: int) -> str:
        """The point of the axis at so many half sections from the origin: the axis is divided into equal parts."""
        part = self.draft.give(f"part_{half}", complex(half / (2 * self.motion.sections)))
        return self.draft.step(Similar(at(plan, f"t{half}"), at(plan, "o"), at(plan, "t"), part))

    def measure(self, plan: str, half: int, label: str) -> None:
        """Read the ordinate of a point."""
        self.draft.measure(_value(plan, label), self.foot(plan, half), at(plan, label), UP)

    def lay_off(self, plan: str, half: int, label: str, value: float) -> None:
        """A point of a given curve."""
        name = self.draft.give(f"y_{plan}_{label}", value)
        self.draft.step(LayOff(at(plan, label), self.foot(plan, half), UP, name, mu_of(plan)))

    def laid(self, stage: Stage, values: Sequence[float]) -> None:
        """The diagram of a given curve, its points each laid off and read."""
        for (half, label), value in zip(stage.points, values, strict=True):
            self.lay_off(stage.plan, half, label, value)
            self.measure(stage.plan, half, label)
        self.stages.append(stage)

    def constructed(self, stage: Stage) -> None:
        """A diagram whose points are drawn already, each read."""
        for half, label in stage.points:
            self.measure(stage.plan, half, label)
        self.stages.append(stage)

    def carried(self, plan: str, source: str, half: int, label: str) -> None:
        """A point above a foot, at the height of a mark on the axis of ordinates: the ordinate carried with
        dividers."""
        self.draft.step(Carry(at(plan, label), self.foot(plan, half), at(plan, "o"), source))


def _value(plan: str, label: str) -> str:
    return f"read_{plan}_{label}"


def differentiated(motion: Motion, pole_mm: float | None = None) -> Construction:
    """The position differentiated twice by chords: velocities at the middles of sections, accelerations at their
    ends."""
    c = Construction(motion, "differentiation")
    place, plan = motion.ends[0], "diagram:s"
    mu = standard_mu(max(place) - min(place), TALL_MM)
    c.axes(plan, mu, None)
    points = tuple((2 * k, str(k)) for k in range(motion.sections + 1))
    c.laid(Stage(plan, 0, mu, None, points, True), [value - place[0] for value in place])
    for rank, nxt in ((1, "diagram:v"), (2, "diagram:a")):
        _derived(c, nxt, rank, pole_mm)
    return c


def _derived(c: Construction, plan: str, rank: int, pole_mm: float | None) -> None:
    """The next diagram: rays parallel to the chords, their intercepts carried to the middles between points."""
    d, before, source = c.draft, c.stages[-1], c.stages[-1].plan
    steepest = max(abs(b - a) for a, b in pairwise(c.exact(before))) / (c.motion.time[1] - c.motion.time[0])
    pole = pole_mm or _pole(steepest, c.mu_t, before.mu)
    mu = before.mu * pole / c.mu_t
    c.axes(plan, mu, pole)
    made = list[tuple[int, str]]()
    for (one, first), (two, second) in pairwise(before.points):
        half, label = (one + two) // 2, _label((one + two) // 2)
        chord = d.step(Through(f"{source}:{first}–{second}", at(source, first), at(source, second)))
        d.step(Cross(at(plan, f"h{label}"), at(plan, "P"), chord, at(plan, "o"), UP))
        c.carried(plan, at(plan, f"h{label}"), half, label)
        made.append((half, label))
    if c.motion.closed and rank == 1:  # the last middle again, one turn earlier: the chord over the start needs it
        half = -1
        c.carried(plan, at(plan, f"h{made[-1][1]}"), half, _label(half))
        made.insert(0, (half, _label(half)))
    c.constructed(Stage(plan, rank, mu, pole, tuple(made), False))


def _label(half: int) -> str:
    """Labels of points: whole sections by their number, middles by a half: 3, 3½."""
    return str(half // 2) if half % 2 == 0 else "−½" if half < 0 else f"{half // 2}½"


def _pole(steepest: float, mu_t: float, mu: float) -> float:
    """The longest round pole distance with which the steepest ray still fits its diagram."""
    longest = TALL_MM / max(steepest * mu / mu_t, 1e-300)
    return max([h for h in POLES_MM if h <= longest], default=POLES_MM[0])


def integrated(motion: Motion, pole_mm: float | None = None) -> Construction:
    """The acceleration integrated twice, from rest at the start: velocities, then positions at the ends of sections."""
    c = Construction(motion, "integration")
    values, plan = motion.middles[2], "diagram:a"
    mu = standard_mu(max(map(abs, values)), TALL_MM)
    pole = pole_mm or _level(c, mu, motion.ends[1])
    c.axes(plan, mu, pole)
    middles = tuple((half, _label(half)) for half in range(1, 2 * motion.sections, 2))
    c.laid(Stage(plan, 2, mu, pole, middles, True), values)
    _summed(c, middles, "diagram:v", 1, motion.ends[1][0])
    plan, mu = "diagram:v", c.stages[-1].mu
    for k, (_, label) in enumerate(middles):
        c.draft.step(Similar(at(plan, label), at(plan, str(k)), at(plan, str(k + 1)), c.draft.give("half", 0.5 + 0j)))
    second = pole_mm or _level(c, mu, [s - motion.ends[0][0] for s in motion.ends[0]])
    name = c.draft.give(f"H_{plan}", second)
    c.draft.step(LayOff(at(plan, "P"), at(plan, "o"), "←", name, PAPER))
    c.stages[-1] = Stage(plan, 1, mu, second, c.stages[-1].points, False)
    _summed(c, middles, "diagram:s", 0)
    return c


def _level(c: Construction, mu: float, sums: Sequence[float]) -> float:
    """The shortest round pole distance with which the integral fits its diagram."""
    least = max(map(abs, sums)) * mu * c.mu_t / TALL_MM
    return min([h for h in POLES_MM if h >= least], default=math.ceil(least / 10.0) * 10.0)


def _summed(c: Construction, middles: Sequence[tuple[int, str]], plan: str, rank: int, start: float = 0.0) -> None:
    """The integral of a diagram: over each section a parallel to the ray through the ordinate of its middle."""
    d, before, source = c.draft, c.stages[-1], c.stages[-1].plan
    assert before.pole_mm
    mu = before.mu * c.mu_t / before.pole_mm
    c.axes(plan, mu, None)
    c.lay_off(plan, 0, "0", start)
    end = at(plan, "0")
    made = [(0, "0")]
    for k, (half, label) in enumerate(middles):
        d.step(Carry(at(source, f"h{label}"), at(source, "o"), c.foot(source, half), at(source, label)))
        ray = d.step(Through(f"{source}:P–{label}", at(source, "P"), at(source, f"h{label}")))
        end = d.step(Cross(at(plan, str(k + 1)), end, ray, c.foot(plan, 2 * k + 2), UP))
        made.append((2 * k + 2, str(k + 1)))
    c.constructed(Stage(plan, rank, mu, None, tuple(made), False))
