"""From a mechanism to all it asks for: one program, its givens, and where each result is read."""

from collections.abc import Container, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from planes.drafting.draft import Draft, Moments, Segment
from planes.drafting.drawing import proved
from planes.drafting.equations import Equation
from planes.drafting.program import Program
from planes.drafting.steps.reckoning import Protractor
from planes.drafting.tools import Thing
from planes.geometry.arithmetic import Real
from planes.plans.assembly import resolve
from planes.plans.bodies import SCHEME, Bodies, Body
from planes.plans.following import LawValues
from planes.plans.kinematics import Rates
from planes.plans.legs import SlideReading
from planes.plans.lever import draw_lever
from planes.plans.loads import Acting, Loads
from planes.plans.passive import without_passive
from planes.plans.passive_motion import LinkValues, values_of
from planes.plans.proving import proofs_of
from planes.plans.rates import draw_rates
from planes.plans.reactions import Reaction, Statics
from planes.plans.scheme import place_all
from planes.plans.statics import draw_forces
from planes.plans.structure import Structure, analyse
from planes.scene.mechanism import FRAME, Law, Link, Mechanism
from planes.words import Phrase
from planes.words.errors import ProgramError, SceneError, StructureError
from planes.words.names import HELPERS, Meaning, at, kind_of, mu_of

STILL = "°still"
"""The given in the place of a drive, where nothing moves."""


@dataclass(frozen=True)
class PointMarks:
    """Where a point stands on the three plans (full names of marks)."""

    position: str
    velocity: str
    acceleration: str


@dataclass(frozen=True, kw_only=True)
class Plans:
    """A mechanism stated, or vectors alone: the whole program and the names of what is measured on it."""

    mechanism: Mechanism
    structure: Structure
    program: Program
    given: Mapping[str, Thing]
    equations: tuple[Equation, ...]
    moments: tuple[Moments, ...]
    segments: tuple[Segment, ...]
    acting: Loads
    means: Mapping[str, Meaning]  # of the names whose makers say so
    off: Mapping[str, float]  # how far off givens may be that are reckoned of the scene's numbers
    points: Mapping[str, PointMarks] = field(default_factory=dict)
    links: Mapping[str, LinkValues] = field(default_factory=dict)
    velocity_slides: Mapping[str, SlideReading] = field(default_factory=dict)
    acceleration_slides: Mapping[str, SlideReading] = field(default_factory=dict)
    reactions: Mapping[str, Reaction] = field(default_factory=dict)
    balancing: str = ""
    zhukovsky: str = ""
    at_rest: bool = False
    laws: Mapping[str, SceneError] = field(default_factory=dict)
    passive: tuple[Link, ...] = ()  # that hold what is held already: the mechanism is stated without them
    vectors: Mapping[str, tuple[str, str]] = field(default_factory=dict)  # stated ones: the marks they run between
    values: Mapping[str, str] = field(default_factory=dict)  # reckoned from them: their names in the program

    @property
    def moves(self) -> bool:
        """Whether there is a mechanism: what moves has other positions."""
        return bool(self.mechanism.links)

    @property
    def drive_given(self) -> str:
        """Name of the given that moves the driver: its angle in degrees, or s in m; one that nothing reads."""
        drive = self.mechanism.drive
        if not self.moves:
            return STILL
        return f"angle_x_{drive.link}" if drive.kind == "phi" else "s"

    def at(self, value: Real, program: Program | None = None, known: Container[str] = ()) -> dict[str, Thing]:
        """The given of the drive at one value or many, for a program that overrides the ``known`` givens.

        :class:`SceneError` where the program reads a number that would have to change with the drive, and cannot.
        """
        moved = value != self.mechanism.drive.position
        if self.laws and (moved.any() if hasattr(moved, "any") else moved):
            cut = program or self.program
            reads = {*cut.givens, *cut.made}
            for name, error in self.laws.items():
                if name in reads and name not in known:
                    raise error
        return {self.drive_given: value}

    @cached_property
    def segments_of(self) -> dict[str, list[Segment]]:
        """The measured segments of each plan."""
        found: dict[str, list[Segment]] = {}
        for segment in self.segments:
            found.setdefault(segment.plan, []).append(segment)
        return found

    def moments_of(self, links: tuple[str, ...]) -> list[Moments]:
        """The moment equations of some links; those of a driver alone stand with no others."""
        alone = (self.structure.driver,)
        return [m for m in self.moments if set(m.links) <= set(links) and (links == alone or m.links != alone)]

    @property
    def helpers(self) -> frozenset[str]:
        """Marks that are drawn and never asked of anybody."""
        return frozenset(n for n, m in self.means.items() if m.quantity in HELPERS)

    @property
    def lengths(self) -> dict[str, float]:
        """The given lengths of the links, m, by name."""
        return {n: abs(v) for n, v in self.given.items() if n in self.means and self.means[n].quantity == "length"}

    @property
    def reach(self) -> float:
        """The longest of them; 1 m where there is none."""
        return max(self.lengths.values(), default=1.0)

    @property
    def drawn(self) -> tuple[str, ...]:
        """Plans in the order they are drawn: position, velocity, acceleration, force:2-3, …, force:1."""
        return tuple(self.program.marks)

    @property
    def forces(self) -> bool:
        """Whether any forces are drawn."""
        return any(kind_of(plan) == "force" for plan in self.drawn)


def plans_of(mechanism: Mechanism, file: str = "") -> Plans:
    """State every plan of a mechanism. :class:`StructureError` or :class:`SceneError` where it cannot be done.

    Whatever is read of the plans, and however little: a proof of theirs that fails in the scene's own position is a
    :class:`Contradiction` here.
    """
    try:
        structure = analyse(mechanism, file)
    except StructureError as error:
        freedom = error.phrase.parts.get("freedom") if isinstance(error.phrase, Phrase) else None
        if isinstance(freedom, int) and (plans := without_passive(mechanism, freedom, plans_of)):
            return _with_passive(plans)
        raise
    try:
        plans = _state(mechanism, structure, file)
    except ProgramError as error:
        raise SceneError(error.phrase, file, mechanism.where.get(("links",))) from None
    proved(plans.program, {**plans.given, **{mu_of(plan): 1.0 for plan in plans.drawn}})
    return plans


def _with_passive(plans: Plans) -> Plans:
    """The plans with the motion of the passive links they are stated without."""
    assert plans.acting.motion
    b = plans.acting.motion.bodies
    links = {**plans.links, **{link.name: values_of(b, link) for link in plans.passive}}
    program = Program(tuple(b.draft.steps.values()), plans.program.proofs)
    return replace(plans, program=program, given=b.draft.given, links=links, means={**plans.means, **b.draft.means})


def structure_of(mechanism: Mechanism, file: str = "") -> Structure:
    """The structure alone, without its passive links. :class:`StructureError` where it has none."""
    try:
        return analyse(mechanism, file)
    except StructureError:
        return plans_of(mechanism, file).structure


def _state(mechanism: Mechanism, structure: Structure, file: str) -> Plans:
    draft = Draft()
    bodies = Bodies(mechanism, structure, draft, file)
    place_all(bodies)
    resolve(bodies)
    velocity, acceleration = Rates(bodies, "velocity"), Rates(bodies, "acceleration")
    at_rest = mechanism.drive.velocity == 0
    motion = Rates(bodies, "motion") if at_rest else velocity
    for rates in (velocity, acceleration, *([motion] if at_rest else [])):
        draw_rates(rates)
    acting = Acting(bodies, motion, acceleration, LawValues(bodies, motion, velocity, acceleration))
    acting.gather()
    statics = Statics(bodies, acting)
    draw_forces(statics)
    zhukovsky = draw_lever(statics)
    links = {name: _link_values(draft, body, velocity, acceleration) for name, body in bodies.known.items()}
    proofs = proofs_of(statics, velocity, acceleration, zhukovsky)
    points = {p: PointMarks(at(SCHEME, p), velocity.mark(p), acceleration.mark(p)) for p in mechanism.names}
    program = Program(tuple(draft.steps.values()), proofs)
    return Plans(
        mechanism=mechanism,
        structure=structure,
        program=program,
        given=draft.given,
        equations=tuple(draft.equations),
        moments=tuple(draft.moments),
        segments=tuple(dict.fromkeys(draft.segments)),
        points=points,
        links=links,
        velocity_slides=velocity.slides,
        acceleration_slides=acceleration.slides,
        reactions=statics.reactions,
        balancing=statics.balancing,
        zhukovsky=zhukovsky,
        acting=acting.loads,
        at_rest=at_rest,
        laws={name: _frozen(mechanism, law, file) for name, law in draft.laws.items()},
        means=draft.means | {s.makes: s.means for s in program.steps if s.means},
        off=draft.off,
    )


def _frozen(mechanism: Mechanism, law: Law, file: str) -> SceneError:
    """What is said of a number that holds where the drive stands in the file alone."""
    drive, key = mechanism.drive, "table" if "table" in law.path else law.path[-1]
    what = Phrase("part", key=key, what=Phrase("section", name=law.path[0]))
    if law.path[0] == "loads":
        what = Phrase("part", key=key, what=Phrase("load", number=int(law.path[1]) + 1))
    why = Phrase("law_frozen", what=what, parameter=law.parameter, kind=drive.kind, value=f"{drive.position:.10g}")
    return SceneError(why, file, law.line)


def _link_values(draft: Draft, body: Body, velocity: Rates, acceleration: Rates) -> LinkValues:
    if body.link.name == FRAME:
        return LinkValues("", "", "")
    angle = draft.step(Protractor(f"phi_{body.link.name}", body.axis))
    if body.root == FRAME:
        return LinkValues(angle, "", "")
    return LinkValues(angle, velocity.spin(body.root), acceleration.spin(body.root))


def sliced(plans: Plans, wanted: list[str]) -> Plans:
    """The same plans with a program that draws only what leads to the wanted names, how the vectors drawn lie, and
    what is measured on it."""
    made = plans.program.sliced(wanted).made
    terms = ((e.plan, t) for e in plans.equations for t in e.terms)
    lying = [t.direction for plan, t in terms if t.direction and {at(plan, t.start), at(plan, t.end)} <= made]
    program = plans.program.sliced([*wanted, *lying])
    segments = tuple(s for s in plans.segments if {at(s.plan, s.start), at(s.plan, s.end)} <= program.made)
    return replace(plans, program=program, segments=segments)
