"""Zhukovsky's lever: the velocity plan turned by 90°, loaded with the external forces at the images of their points.

N. E. Zhukovsky's theorem: the moments of the forces about the pole balance, with each couple M replaced by M·ω·μ_v. As
a check it shares the loads and the velocity plan with the force plans, and none of their reactions but friction.
"""

from dataclasses import replace

from planes.drafting.steps import Carry
from planes.drafting.steps.reckoning import Drop, Product
from planes.plans.force.loads import Force
from planes.plans.force.reactions import Statics
from planes.scene.mechanism import FRAME
from planes.words.names import LEVER_PLAN, POLE_LABEL, NamePair


def draw_lever(s: Statics) -> str:
    """Draw the lever and balance it; returns the name of its balancing moment (or force)."""
    acting = s.acting
    b = s.bodies
    drive = b.mechanism.drive
    rate = acting.motion.drive_rate_name
    b.draft.draw_pole(LEVER_PLAN)
    terms = []
    for force in (f for forces in acting.forces.values() for f in forces if f.spot):  # not of a reaction
        arm = _lever_arm(s, force)
        terms.append((force.name, arm, Product(1.0, ((force.size, 1), (arm, 1), (rate, -1)))))
    for link, couples in acting.couples.items():
        root = b.known[link].root
        for couple in couples:
            if root != FRAME and not couple.handed:
                spin = acting.motion.spin(root)
                terms.append((couple.name, spin, Product(-1.0, ((couple.value, 1), (spin, 1), (rate, -1)))))
    for value, speed in friction_and_relative_speeds(s):
        terms.append((value, speed, Product(-1.0, ((value, 1), (speed, 1), (rate, -1)))))
    name = f"{'M' if drive.rotates else 'F'}Z_{drive.link}"
    return b.draft.solve_moment_equation(name, LEVER_PLAN.pole, ("lever",), terms)


def friction_and_relative_speeds(s: Statics) -> list[NamePair]:
    """Names of each friction force along its guide, or couple of its hinge, and of the relative speed there; its power
    is a result."""
    names = []
    for key, reaction in list(s.reactions.items()):
        guide = reaction.pair.guide
        force = reaction.friction
        speed = s.acting.motion.spin(key)
        if guide in s.bodies.mechanism.friction:
            force = f"T_{key}"
            if force not in s.bodies.draft.steps:  # no plan was drawn with it
                force = s.bodies.draft.measure_segment(force, reaction.start, reaction.end, f"∥{guide}")
            speed = s.acting.motion.slides[reaction.pair.link].value
        if force:
            power = s.bodies.draft.add_product(f"PT_{key}", **{force: 1, speed: 1})
            s.reactions[key] = replace(reaction, friction=force, power=power)
            names.append((force, speed))
    return names


def _lever_arm(s: Statics, force: Force) -> str:
    motion = s.acting.motion
    assert force.spot
    label = motion.label(force.spot.name)
    mark = pole = LEVER_PLAN.pole
    if label != POLE_LABEL:
        ends = motion.plan.pole, motion.mark(force.spot.name)
        mark = s.bodies.draft.draw_mark(Carry(LEVER_PLAN.mark(label), mark, *ends, 1))
    return s.bodies.draft.add_step(Drop(f"H_{force.name}", mark, force.along, pole, LEVER_PLAN.mu_name))
