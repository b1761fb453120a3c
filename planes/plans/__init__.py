"""From a mechanism to all its plans, stated in one program."""

from dataclasses import replace

from planes.drafting.draft import Draft
from planes.drafting.drawing import proved
from planes.drafting.program import Program
from planes.drafting.steps.reckoning import Protractor
from planes.plans.assur.analysis import analyse
from planes.plans.assur.structure import Structure
from planes.plans.force.following import LawValues
from planes.plans.force.lever import draw_lever
from planes.plans.force.loads import Acting
from planes.plans.force.reactions import Statics
from planes.plans.force.statics import draw_forces
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.rates import draw_rates
from planes.plans.other_leads import Restating, fitting
from planes.plans.passive import without_passive
from planes.plans.passive_motion import LinkValues
from planes.plans.position.assembly import resolve
from planes.plans.position.bodies import SCHEME, Bodies, Body
from planes.plans.position.scheme import place_all
from planes.plans.proving import proofs_of
from planes.plans.record import STILL, Plans, PointMarks, sliced, with_passive
from planes.scene.mechanism import FRAME, Law, Mechanism
from planes.words import Phrase, Written
from planes.words.errors import ProgramError, SceneError, StructureError
from planes.words.names import at, mu_of

__all__ = ["STILL", "Plans", "PointMarks", "plans_of", "sliced", "structure_of"]


def plans_of(mechanism: Mechanism, file: str = "") -> Plans:
    """State every plan of a mechanism. Raises :class:`StructureError` or :class:`SceneError` where that is impossible.

    However few results are used later, all proofs are checked here: one that fails in the scene's own position is a
    :class:`Contradiction`.
    """
    try:
        structure = analyse(mechanism, file)
    except StructureError as error:
        freedom = error.parts.get("freedom")
        if isinstance(freedom, int) and (plans := without_passive(mechanism, freedom, plans_of)):
            return with_passive(plans)
        raise
    try:
        plans = _state(mechanism, structure, file)
    except ProgramError as error:
        raise SceneError(error.phrase, file, mechanism.where.get(("links",))) from None
    proved(plans.program, {**plans.given, **{mu_of(plan): 1.0 for plan in plans.drawn}})
    return plans


def structure_of(mechanism: Mechanism, file: str = "") -> Structure:
    """The structure alone, without passive links. Raises :class:`StructureError` where there is none."""
    try:
        return analyse(mechanism, file)
    except StructureError:
        return plans_of(mechanism, file).structure


def _state(mechanism: Mechanism, structure: Structure, file: str) -> Plans:
    bodies = Bodies(mechanism, structure, Draft(), file)
    place_all(bodies)
    resolve(bodies)
    restating = Restating(bodies, _stated)
    stated: Plans = restating.plans(bodies.leads)
    return fitting(replace(stated, restating=restating), mechanism.drive.position)


def _stated(bodies: Bodies) -> Plans:
    """All plans, for a given scheme."""
    mechanism, draft = bodies.mechanism, bodies.draft
    velocity, acceleration = Rates(bodies, "velocity"), Rates(bodies, "acceleration")
    at_rest = mechanism.drive.velocity == 0
    motion = Rates(bodies, "motion") if at_rest else velocity
    for rates in (velocity, acceleration, *([motion] if at_rest else [])):
        draw_rates(rates)
    acting = Acting(bodies, motion, acceleration, LawValues(bodies, velocity, acceleration))
    acting.gather()
    statics = Statics(bodies, acting)
    draw_forces(statics)
    zhukovsky = draw_lever(statics)
    placed = ((name, bodies.known[name]) for name in (FRAME, *mechanism.links))
    links = {name: _link_values(draft, body, velocity, acceleration) for name, body in placed}
    proofs = proofs_of(statics, velocity, acceleration, zhukovsky)
    points = {p: PointMarks(at(SCHEME, p), velocity.mark(p), acceleration.mark(p)) for p in mechanism.names}
    program = Program(tuple(draft.steps.values()), proofs)
    return Plans(
        mechanism=mechanism,
        structure=bodies.structure,
        leads=bodies.leads,
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
        balancing_force=statics.balancing_force,
        beside_force=statics.beside_force,
        zhukovsky=zhukovsky,
        acting=acting.loads,
        at_rest=at_rest,
        laws={name: _frozen(mechanism, law, bodies.file) for name, law in draft.laws.items()},
        means=draft.means | {s.makes: s.means for s in program.steps if s.means},
        reckoned=draft.reckoned,
    )


def _frozen(mechanism: Mechanism, law: Law, file: str) -> SceneError:
    """The message about a number valid only at the drive's position in the file."""
    drive, key = mechanism.drive, "table" if "table" in law.path else law.path[-1]
    what = Phrase("part", key=key, what=Phrase("section", name=law.path[0]))
    if law.path[0] == "loads":
        what = Phrase("part", key=key, what=Phrase("load", number=int(law.path[1]) + 1))
    why = Phrase(
        "law_frozen", what=what, parameter=law.parameter, kind=drive.kind, value=Written(f"{drive.position:.10g}")
    )
    return SceneError(why, file, law.line)


def _link_values(draft: Draft, body: Body, velocity: Rates, acceleration: Rates) -> LinkValues:
    if body.link.name == FRAME:
        return LinkValues("", "", "")
    angle = draft.step(Protractor(f"phi_{body.link.name}", body.axis))
    if body.root == FRAME:
        return LinkValues(angle, "", "")
    return LinkValues(angle, velocity.spin(body.root), acceleration.spin(body.root))
