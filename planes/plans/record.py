"""The stated plans of a mechanism, or of vectors: one program, its givens, and where each result is read."""

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from planes.drafting.dimensions import Dimension
from planes.drafting.draft import Segment
from planes.drafting.equations import Equation, Moments
from planes.drafting.program import Program
from planes.drafting.tools import Thing, Things
from planes.geometry.arithmetic import Real
from planes.plans.assur.basic_links import Leads
from planes.plans.assur.structure import Structure
from planes.plans.centres import Centre, Check
from planes.plans.extents import TURN_POSITIONS, Size, size_over_turn
from planes.plans.force.loads import Loads
from planes.plans.force.reactions import Reaction
from planes.plans.motion.legs import SlideReading
from planes.plans.other_leads import Restating
from planes.plans.passive_motion import LinkValues, passive_link_values
from planes.plans.position.decimals import AsWritten, Lost
from planes.plans.structures.figure import StaticsFigure
from planes.scene.mechanism import FRAME, Drive, Link, Mechanism
from planes.words.errors import SceneError
from planes.words.frozen import frozen
from planes.words.names import HELPER_MARK_KINDS, SCHEME_PLAN, Mark, MarkPair, Meaning, NameTuple, PlanId, PlanTuple
from planes.words.naming import Naming
from planes.words.records import Json

STILL_DRIVE_GIVEN = "°still"
"""Takes the place of the drive's given where nothing moves."""


@frozen
class PointMarks:
    """The marks of a point on the three plans (full names)."""

    position: Mark
    velocity: Mark
    acceleration: Mark


@dataclass(frozen=True, kw_only=True)
class Plans:
    """A stated mechanism, or vectors alone: the whole program and the names of its measurements."""

    mechanism: Mechanism
    structure: Structure
    program: Program
    given: Things
    equations: tuple[Equation, ...]
    moments: tuple[Moments, ...]
    segments: tuple[Segment, ...]
    acting: Loads
    means: Mapping[str, Meaning]  # meanings of names, where their makers give them
    reckoned: Mapping[str, Dimension] = field(default_factory=dict)  # givens that change with the links' dimensions
    points: Mapping[str, PointMarks] = field(default_factory=dict)
    links: Mapping[str, LinkValues] = field(default_factory=dict)
    velocity_slides: Mapping[str, SlideReading] = field(default_factory=dict)
    acceleration_slides: Mapping[str, SlideReading] = field(default_factory=dict)
    leads: Mapping[str, Leads] = field(default_factory=dict)  # of a basic link: the first two meet in its special point
    restating: Restating | None = None
    reactions: Mapping[str, Reaction] = field(default_factory=dict)
    balancing: str = ""
    balancing_force: str = ""  # on a turning driver, beside the moment
    beside_force: tuple[str, Mark, Mark] | None = None  # the frame's reaction to it by name, and its marks
    zhukovsky: str = ""
    at_rest: bool = False
    laws: Mapping[str, SceneError] = field(default_factory=dict)
    passive: tuple[Link, ...] = ()  # redundant ones: the mechanism is stated without them
    vectors: Mapping[str, MarkPair] = field(default_factory=dict)  # stated ones: their end marks
    values: Mapping[str, str] = field(default_factory=dict)  # computed from them: their names in the program
    figure: StaticsFigure | None = None  # of bodies in equilibrium: the lines beside the marks
    centres: tuple[Centre, ...] = ()  # of links, where requested, and the checks by them
    checks: tuple[Check, ...] = ()
    uncut: "Plans | None" = None  # the plans of the scene, where only some results of them are drawn

    @cached_property
    def default_naming(self) -> Naming:
        """The lettering of these plans where no sheet sets another."""
        return Naming(**self.lettering_basis)

    @property
    def lettering_basis(self) -> Json:
        """The part of the mechanism that sets the lettering: the frame's number, the driver, the vectors that end at a
        point of the frame under a slider."""
        grounded = [name for name, m in self.means.items() if m.quantity == "rate" and m.link == FRAME]
        return {"frame": self.mechanism.frame_number, "driver": self.drive.link, "grounded": grounded}

    def restated_with_leads(self, leads: Mapping[str, Leads]) -> "Plans":
        """The same mechanism, unsliced, with other leads meeting in special points."""
        assert self.restating
        own = self.restating.plans_with_meeting_leads(leads)
        plans = replace(own, restating=self.restating, structure=self.structure, passive=self.passive)
        return plans_with_passive_links(plans) if self.passive else plans

    @cached_property
    def decimal_rounding_errors(self) -> dict[str, Lost]:
        """The difference between the decimals of the scene and their doubles, where known, and its uncertainty; the
        drive's is unknown, since it varies."""
        written = AsWritten(self.mechanism, self.passive)
        named = ((n, z) for n, z in self.given.items() if n != self.drive_given_name)
        return {n: lost for n, z in named if (lost := written.decimal_rounding_error(z, self.reckoned.get(n)))}

    @property
    def drive(self) -> Drive:
        """Its driver."""
        return self.mechanism.drive

    @property
    def has_mechanism(self) -> bool:
        """Whether there is a mechanism: only that has other positions."""
        return self.drive.link != FRAME

    @property
    def depends_on_drive(self) -> bool:
        """Whether anything depends on a drive: a mechanism, or laws of stated vectors and loads."""
        return self.has_mechanism or self.drive.coordinate_name in self.given

    @cached_property
    def drive_given_name(self) -> str:
        """Name of the given that moves the driver: its angle in degrees, or s in m; an unused name without a drive."""
        if self.depends_on_drive:
            return self.drive.coordinate_name
        return STILL_DRIVE_GIVEN

    def drive_givens_at(
        self, value: Real, program: Program | None = None, known: Container[str] = ()
    ) -> dict[str, Thing]:
        """The given of the drive at one position or many, for a program that overrides the ``known`` givens.

        Raises :class:`SceneError` where the program reads a number that would have to change with the drive, and
        cannot.
        """
        moved = value != self.drive.position
        if self.laws and (moved.any() if hasattr(moved, "any") else moved):
            cut = program or self.program
            reads = {*cut.given_names, *cut.result_names}
            for name, error in self.laws.items():
                if name in reads and name not in known:
                    raise error
        return {self.drive_given_name: value}

    @cached_property
    def fixed_points(self) -> frozenset[str]:
        """The points that never move: those of the frame, and of links that have a hinge on it and never turn."""
        fixed = {*self.mechanism.frame.points}
        links = [x for n, x in self.mechanism.links.items() if n in self.links and not self.links[n].omega]
        return frozenset(fixed.union(*(x.points for x in links if fixed & {*x.points} and not x.slides)))

    def segments_on(self, plan: PlanId) -> list[Segment]:
        """The measured segments of a plan."""
        return [s for s in self.segments if s.plan == plan]

    def moment_equations_of_plan(self, links: NameTuple) -> list[Moments]:
        """The moment equations for the plan of some links, or else those of these links alone."""
        plan = PlanId("force", *links)
        plan_of_term = {t.name: e.plan for e in self.equations for t in e.all_terms}
        alone = self.moment_equations_on_links(links)
        return [m for m in self.moments if plan_of_term.get(m.unknown, plan if m in alone else "") == plan]

    def moment_equations_on_links(self, links: NameTuple) -> list[Moments]:
        """The moment equations for forces on some links, or on more where these have no plan."""
        fewer = [f for f in (set(plan.links) for plan in self.force_plans) if f < set(links)]
        return [m for m in self.moments if set(m.links) <= set(links) and not any(set(m.links) <= f for f in fewer)]

    @property
    def auxiliary_marks(self) -> frozenset[str]:
        """Auxiliary marks, which are never asked for."""
        return frozenset(n for n, m in self.means.items() if m.quantity in HELPER_MARK_KINDS)

    @property
    def link_lengths(self) -> dict[str, float]:
        """The given lengths of the links, m, by name."""
        return {n: abs(v) for n, v in self.given.items() if n in self.means and self.means[n].quantity == "length"}

    @property
    def longest_link_length(self) -> float:
        """The longest of them; 1 m where there is none."""
        return max(self.link_lengths.values(), default=1.0)

    @cached_property
    def turn_size(self) -> Size:
        """The size of the scheme over a turn of the driver, or as far as it moves, in m."""
        step = 360.0 / TURN_POSITIONS if self.drive.rotates else self.longest_link_length / TURN_POSITIONS
        given = {**self.given, SCHEME_PLAN.mu_name: 1.0, self.drive_given_name: self.drive.position}
        return size_over_turn(self.program, given, self.drive_given_name, step, self.drive.rotates)

    @property
    def plan_names(self) -> PlanTuple:
        """Plans in drawing order: position, velocity, acceleration, force:2-3, …, force:1."""
        return tuple(self.program.mark_steps_by_plan)

    @property
    def force_plans(self) -> PlanTuple:
        """The force plans in drawing order."""
        return tuple(plan for plan in self.plan_names if plan.is_force)


def plans_with_passive_links(plans: Plans) -> Plans:
    """The plans with the motion of the passive links that were left out."""
    assert plans.acting.motion
    b = replace(plans.acting.motion.bodies, passive=plans.passive)
    links = {**plans.links, **{link.name: passive_link_values(b, link) for link in plans.passive}}
    program = Program(tuple(b.draft.steps.values()), plans.program.proofs)
    means = {**plans.means, **b.draft.means}
    return replace(plans, program=program, given=b.draft.given, links=links, means=means, reckoned=b.draft.reckoned)


def plans_cut_to_names(plans: Plans, wanted: list[str]) -> Plans:
    """The same plans with a program that draws only what the wanted names, the directions of drawn vectors, and their
    measurements need."""
    made = plans.program.cut_to_names(wanted).result_names
    terms = ((e.plan, t) for e in plans.equations for t in e.all_terms)
    lying = [t.direction for plan, t in terms if t.direction and {*plan.marks(t.start, t.end)} <= made]
    program = plans.program.cut_to_names(wanted + lying)
    segments = tuple(s for s in plans.segments if {*s.ends} <= program.result_names)
    return replace(plans, program=program, segments=segments, uncut=plans.uncut or plans)
