"""From a mechanism to all its plans, stated in one program."""

from dataclasses import replace

from planes.drafting.draft import Draft
from planes.drafting.drawing import refuse_unproved_drawing
from planes.drafting.program import Program
from planes.drafting.steps.reckoning import Protractor
from planes.plans.assur.analysis import analyse_structure
from planes.plans.assur.structure import Structure
from planes.plans.force.following import LawValues
from planes.plans.force.lever import draw_lever
from planes.plans.force.loads import Acting
from planes.plans.force.reactions import Statics
from planes.plans.force.statics import draw_all_force_plans
from planes.plans.motion.kinematics import Rates
from planes.plans.motion.rates import draw_rates_plan
from planes.plans.other_leads import Restating, plans_with_sharp_leads
from planes.plans.passive import plans_without_passive_links
from planes.plans.passive_motion import LinkValues
from planes.plans.position.assembly import choose_assembly_sides
from planes.plans.position.bodies import Bodies, Body
from planes.plans.position.scheme import draw_scheme
from planes.plans.proving import proofs_of
from planes.plans.record import STILL_DRIVE_GIVEN, Plans, PointMarks, plans_cut_to_names, plans_with_passive_links
from planes.scene.mechanism import FRAME, Law, Mechanism
from planes.words import Phrase, Written
from planes.words.errors import ProgramError, SceneError, StructureError
from planes.words.names import ACCELERATION_PLAN, MOTION_PLAN, VELOCITY_PLAN, scheme_mark

__all__ = ["STILL_DRIVE_GIVEN", "Plans", "PointMarks", "plans_cut_to_names", "plans_of", "structure_of"]


def plans_of(mechanism: Mechanism, file: str = "") -> Plans:
    """State every plan of a mechanism. Raises :class:`StructureError` or :class:`SceneError` where that is impossible.

    However few results are used later, all proofs are checked here: one that fails in the scene's own position is a
    :class:`Contradiction`.
    """
    try:
        structure = analyse_structure(mechanism, file)
    except StructureError as error:
        freedom = error.phrase_parts.get("freedom")
        if isinstance(freedom, int) and (plans := plans_without_passive_links(mechanism, freedom, plans_of)):
            return plans_with_passive_links(plans)
        raise
    try:
        plans = _state_mechanism_plans(mechanism, structure, file)
    except ProgramError as error:
        raise SceneError(error.phrase, file, mechanism.where.get(("links",))) from None
    refuse_unproved_drawing(plans.program, {**plans.given, **{plan.mu_name: 1.0 for plan in plans.plan_names}})
    return plans


def structure_of(mechanism: Mechanism, file: str = "") -> Structure:
    """The structure alone, without passive links. Raises :class:`StructureError` where there is none."""
    try:
        return analyse_structure(mechanism, file)
    except StructureError:
        return plans_of(mechanism, file).structure


def _state_mechanism_plans(mechanism: Mechanism, structure: Structure, file: str) -> Plans:
    bodies = Bodies(mechanism, structure, Draft(), file)
    draw_scheme(bodies)
    choose_assembly_sides(bodies)
    restating = Restating(bodies, _plans_for_scheme)
    stated: Plans = restating.plans_with_meeting_leads(bodies.leads)
    return plans_with_sharp_leads(replace(stated, restating=restating), mechanism.drive.position)


def _plans_for_scheme(bodies: Bodies) -> Plans:
    """All plans, for a given scheme."""
    mechanism = bodies.mechanism
    draft = bodies.draft
    velocity = Rates(bodies, VELOCITY_PLAN)
    acceleration = Rates(bodies, ACCELERATION_PLAN)
    at_rest = mechanism.drive.velocity == 0
    motion = Rates(bodies, MOTION_PLAN) if at_rest else velocity
    for rates in (velocity, acceleration, *([motion] if at_rest else [])):
        draw_rates_plan(rates)
    acting = Acting(bodies, motion, acceleration, LawValues(bodies, velocity, acceleration))
    acting.gather_all_loads()
    statics = Statics(bodies, acting)
    draw_all_force_plans(statics)
    zhukovsky = draw_lever(statics)
    placed = ((name, bodies.known[name]) for name in (FRAME, *mechanism.links))
    links = {name: _state_link_values(draft, body, velocity, acceleration) for name, body in placed}
    proofs = proofs_of(statics, velocity, acceleration, zhukovsky)
    points = {p: PointMarks(scheme_mark(p), velocity.mark(p), acceleration.mark(p)) for p in mechanism.point_names}
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
        acting=acting.all_loads,
        at_rest=at_rest,
        laws={name: _fixed_position_message(mechanism, law, bodies.file) for name, law in draft.laws.items()},
        means=draft.means | {s.makes: s.means for s in program.steps if s.means},
        reckoned=draft.reckoned,
    )


def _fixed_position_message(mechanism: Mechanism, law: Law, file: str) -> SceneError:
    """The message about a number valid only at the drive's position in the file."""
    drive = mechanism.drive
    key = "table" if "table" in law.path else law.path[-1]
    what = Phrase("part", key=key, what=Phrase("section", name=law.path[0]))
    if law.path[0] == "loads":
        what = Phrase("part", key=key, what=Phrase("load", number=int(law.path[1]) + 1))
    why = Phrase(
        "law_frozen", what=what, parameter=law.parameter, kind=drive.kind, value=Written(f"{drive.position:.10g}")
    )
    return SceneError(why, file, law.line)


def _state_link_values(draft: Draft, body: Body, velocity: Rates, acceleration: Rates) -> LinkValues:
    if body.link.name == FRAME:
        return LinkValues("", "", "")
    angle = draft.add_step(Protractor(f"phi_{body.link.name}", body.axis))
    if body.root == FRAME:
        return LinkValues(angle, "", "")
    return LinkValues(angle, velocity.spin(body.root), acceleration.spin(body.root))
