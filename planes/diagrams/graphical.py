"""Graphical differentiation by chords and integration by a pole, as programs of steps drawn by any instrument.

The abscissa is the time t of a uniform turn, divided into equal sections. Differentiation: rays parallel to the chords
of the curve are drawn from a pole P at the distance H to the left of the origin; the intercept of a ray on the axis of
ordinates is carried to the middle of its section. Similar triangles give the scale: with μ in mm per unit μ_v =
H·μ_s/μ_t, with μ in units per mm μ_v = μ_s/(H·μ_t). Integration is the reverse: the ordinate of the middle of a section
is carried to the axis, and a parallel to the ray from P through it continues the curve over the section.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

from planes.diagrams.motion import Motion
from planes.drafting.draft import Draft
from planes.drafting.drawing import Drawing, draw_program
from planes.drafting.instruments import Instrument
from planes.drafting.program import Program
from planes.drafting.steps import Carry, LayOff, Put, Similar, Through, Turn
from planes.drafting.steps.crossings import Cross
from planes.drafting.tools import Things
from planes.geometry.arithmetic import Real
from planes.words.frozen import frozen
from planes.words.names import Mark, PlanId
from planes.words.units import standard_mu

TIME_AXIS_LENGTH_MM = 156.0  # length of the whole turn on the time axis
LARGEST_ORDINATE_MM = 42.0  # the largest ordinate of a diagram
ROUND_POLE_DISTANCES_MM = (10.0, 12.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0)
TIME_AXIS_DIRECTION = "→"
ORDINATE_AXIS_DIRECTION = "↑"
TIME_SCALE_NAME = "mu_t"
PAPER_SCALE_NAME = "mu_paper"


@frozen
class Stage:
    """One diagram of a construction: its ``rank`` (0 position, 1 velocity, 2 acceleration), μ (mm per SI unit), its
    pole distance (None: no pole), and its points: (half sections from the start, label)."""

    plan: PlanId
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
    def time_scale(self) -> float:
        """The scale of time, mm per second."""
        return TIME_AXIS_LENGTH_MM / (self.motion.time[-1] - self.motion.time[0])

    @cached_property
    def construction_program(self) -> Program:
        """The steps, checked."""
        return Program(tuple(self.draft.steps.values()))

    def draw_construction(self, instrument: Instrument | None = None, more: Things | None = None) -> Drawing:
        """The construction drawn with an instrument, by default exactly."""
        return draw_program(self.construction_program, {**self.draft.given, **(more or {})}, instrument)

    def exact_values(self, stage: Stage) -> list[float]:
        """The true values at the points of a diagram, SI."""
        m = self.motion
        ends = self.motion.ends[stage.rank]
        halves = (half for half, _ in stage.points)
        return [m.middles[stage.rank][half // 2 % m.section_count] if half % 2 else ends[half // 2] for half in halves]

    def measured_values(self, drawing: Drawing, stage: Stage) -> list[Real]:
        """The measured values at the points of a diagram, SI."""
        return [drawing[_reading_name(stage.plan, label)] for _, label in stage.points]

    # the quantity

    def __post_init__(self) -> None:
        """The two directions of all axes, and the length of a second."""
        d = self.draft
        d.draw_direction_at_angle(TIME_AXIS_DIRECTION, 0.0)
        d.draw_direction_at_angle(ORDINATE_AXIS_DIRECTION, 90.0)
        d.add_step(Turn("←", TIME_AXIS_DIRECTION, 2))
        d.add_given(TIME_SCALE_NAME, self.time_scale)
        d.add_given(PAPER_SCALE_NAME, 1.0)

    def draw_axes_and_pole(self, plan: PlanId, mu: float, pole_mm: float | None) -> None:
        """The origin of a diagram, and its pole."""
        d = self.draft
        d.add_step(Put(plan.mark("o")))
        d.add_given(plan.mu_name, mu)
        d.add_step(
            LayOff(
                *plan.marks("t", "o"),
                TIME_AXIS_DIRECTION,
                d.add_given("t_whole", self.motion.time[-1]),
                TIME_SCALE_NAME,
            )
        )
        if pole_mm is not None:
            d.add_step(LayOff(*plan.marks("P", "o"), "←", d.add_given(f"H_{plan}", pole_mm), PAPER_SCALE_NAME))

    def foot_on_axis(self, plan: PlanId, half: int) -> Mark:
        """The point of the axis at so many half sections from the origin: the axis is divided into equal parts."""
        part = self.draft.add_given(f"part_{half}", complex(half / (2 * self.motion.section_count)))
        return self.draft.draw_mark(Similar(*plan.marks(f"t{half}", "o"), plan.mark("t"), part))

    def read_ordinate(self, plan: PlanId, half: int, label: str) -> None:
        """Read the ordinate of a point."""
        self.draft.measure_segment(
            _reading_name(plan, label), self.foot_on_axis(plan, half), plan.mark(label), ORDINATE_AXIS_DIRECTION
        )

    def lay_off_curve_point(self, plan: PlanId, half: int, label: str, value: float) -> None:
        """A point of a given curve."""
        name = self.draft.add_given(f"y_{plan}_{label}", value)
        self.draft.add_step(
            LayOff(plan.mark(label), self.foot_on_axis(plan, half), ORDINATE_AXIS_DIRECTION, name, plan.mu_name)
        )

    def lay_off_diagram(self, stage: Stage, values: Sequence[float]) -> None:
        """The diagram of a given curve, its points each laid off and read."""
        for (half, label), value in zip(stage.points, values, strict=True):
            self.lay_off_curve_point(stage.plan, half, label, value)
            self.read_ordinate(stage.plan, half, label)
        self.stages.append(stage)

    def read_drawn_diagram(self, stage: Stage) -> None:
        """A diagram whose points are drawn already, each read."""
        for half, label in stage.points:
            self.read_ordinate(stage.plan, half, label)
        self.stages.append(stage)

    def carry_ordinate(self, plan: PlanId, source: Mark, half: int, label: str) -> None:
        """A point above a foot, at the height of a mark on the axis of ordinates: the ordinate carried with
        dividers."""
        self.draft.add_step(Carry(plan.mark(label), self.foot_on_axis(plan, half), plan.mark("o"), source))


def _reading_name(plan: PlanId, label: str) -> str:
    return f"read_{plan}_{label}"


def differentiate_graphically(motion: Motion, pole_mm: float | None = None) -> Construction:
    """The position differentiated twice by chords: velocities at the middles of sections, accelerations at their
    ends."""
    c = Construction(motion, "differentiation")
    place = motion.ends[0]
    plan = PlanId("diagram", "s")
    mu = standard_mu(max(place) - min(place), LARGEST_ORDINATE_MM)
    c.draw_axes_and_pole(plan, mu, None)
    points = tuple((2 * k, str(k)) for k in range(motion.section_count + 1))
    c.lay_off_diagram(Stage(plan, 0, mu, None, points, True), [value - place[0] for value in place])
    for rank, nxt in ((1, PlanId("diagram", "v")), (2, PlanId("diagram", "a"))):
        _draw_derivative_diagram(c, nxt, rank, pole_mm)
    return c


def _draw_derivative_diagram(c: Construction, plan: PlanId, rank: int, pole_mm: float | None) -> None:
    """The next diagram: rays parallel to the chords, their intercepts carried to the middles between points."""
    d = c.draft
    before = c.stages[-1]
    source = c.stages[-1].plan
    steepest = max(abs(b - a) for a, b in pairwise(c.exact_values(before))) / (c.motion.time[1] - c.motion.time[0])
    pole = pole_mm or _longest_pole_distance(steepest, c.time_scale, before.mu)
    mu = before.mu * pole / c.time_scale
    c.draw_axes_and_pole(plan, mu, pole)
    made = []
    for (one, first), (two, second) in pairwise(before.points):
        half = (one + two) // 2
        label = _point_label((one + two) // 2)
        chord = d.add_step(Through(*source.marks(f"{first}–{second}", first), source.mark(second)))
        d.add_step(Cross(*plan.marks(f"h{label}", "P"), chord, plan.mark("o"), ORDINATE_AXIS_DIRECTION))
        c.carry_ordinate(plan, plan.mark(f"h{label}"), half, label)
        made.append((half, label))
    if c.motion.closed and rank == 1:  # the last middle again, one turn earlier: the chord over the start needs it
        half = -1
        c.carry_ordinate(plan, plan.mark(f"h{made[-1][1]}"), half, _point_label(half))
        made.insert(0, (half, _point_label(half)))
    c.read_drawn_diagram(Stage(plan, rank, mu, pole, tuple(made), False))


def _point_label(half: int) -> str:
    """Labels of points: whole sections by their number, middles by a half: 3, 3½."""
    if half % 2 == 0:
        return str(half // 2)
    if half < 0:
        return "−½"
    return f"{half // 2}½"


def _longest_pole_distance(steepest: float, mu_t: float, mu: float) -> float:
    """The longest round pole distance with which the steepest ray still fits its diagram."""
    longest = LARGEST_ORDINATE_MM / max(steepest * mu / mu_t, 1e-300)
    return max([h for h in ROUND_POLE_DISTANCES_MM if h <= longest], default=ROUND_POLE_DISTANCES_MM[0])


def integrate_graphically(motion: Motion, pole_mm: float | None = None) -> Construction:
    """The acceleration integrated twice, from rest at the start: velocities, then positions at the ends of sections."""
    c = Construction(motion, "integration")
    values = motion.middles[2]
    plan = PlanId("diagram", "a")
    mu = standard_mu(max(map(abs, values)), LARGEST_ORDINATE_MM)
    pole = pole_mm or _shortest_pole_distance(c, mu, motion.ends[1])
    c.draw_axes_and_pole(plan, mu, pole)
    middles = tuple((half, _point_label(half)) for half in range(1, 2 * motion.section_count, 2))
    c.lay_off_diagram(Stage(plan, 2, mu, pole, middles, True), values)
    _draw_integral_diagram(c, middles, PlanId("diagram", "v"), 1, motion.ends[1][0])
    plan = PlanId("diagram", "v")
    mu = c.stages[-1].mu
    for k, (_, label) in enumerate(middles):
        c.draft.add_step(
            Similar(*plan.marks(label, str(k)), plan.mark(str(k + 1)), c.draft.add_given("half", 0.5 + 0j))
        )
    second = pole_mm or _shortest_pole_distance(c, mu, [s - motion.ends[0][0] for s in motion.ends[0]])
    name = c.draft.add_given(f"H_{plan}", second)
    c.draft.add_step(LayOff(*plan.marks("P", "o"), "←", name, PAPER_SCALE_NAME))
    c.stages[-1] = Stage(plan, 1, mu, second, c.stages[-1].points, False)
    _draw_integral_diagram(c, middles, PlanId("diagram", "s"), 0)
    return c


def _shortest_pole_distance(c: Construction, mu: float, sums: Sequence[float]) -> float:
    """The shortest round pole distance with which the integral fits its diagram."""
    least = max(map(abs, sums)) * mu * c.time_scale / LARGEST_ORDINATE_MM
    return min([h for h in ROUND_POLE_DISTANCES_MM if h >= least], default=math.ceil(least / 10.0) * 10.0)


def _draw_integral_diagram(
    c: Construction, middles: Sequence[tuple[int, str]], plan: PlanId, rank: int, start: float = 0.0
) -> None:
    """The integral of a diagram: over each section a parallel to the ray through the ordinate of its middle."""
    d = c.draft
    before = c.stages[-1]
    source = c.stages[-1].plan
    assert before.pole_mm
    mu = before.mu * c.time_scale / before.pole_mm
    c.draw_axes_and_pole(plan, mu, None)
    c.lay_off_curve_point(plan, 0, "0", start)
    end = plan.mark("0")
    made = [(0, "0")]
    for k, (half, label) in enumerate(middles):
        d.add_step(Carry(*source.marks(f"h{label}", "o"), c.foot_on_axis(source, half), source.mark(label)))
        ray = d.add_step(Through(source.mark(f"P–{label}"), *source.marks("P", f"h{label}")))
        end = d.draw_mark(
            Cross(plan.mark(str(k + 1)), end, ray, c.foot_on_axis(plan, 2 * k + 2), ORDINATE_AXIS_DIRECTION)
        )
        made.append((2 * k + 2, str(k + 1)))
    c.read_drawn_diagram(Stage(plan, rank, mu, None, tuple(made), False))
