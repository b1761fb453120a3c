"""Friction in pairs. The reaction in a hinge is tangent to the friction circle: it has a couple against the rotation.

The radius of the friction circle is that of the pin times the coefficient of friction (on a circular guide, the guide's
radius times the sine of the angle of friction). The couple of a group's hinge is the reaction times that radius, but
the reaction is known only after the plan is drawn with the couple: plans are drawn in succession until they agree. The
same holds, in groups of class III, for the force of friction on a guide, by the normal force.
"""

from planes.drafting.draft import Draft
from planes.drafting.steps.reckoning import Product, Sense, SenseBetween
from planes.drafting.steps.settling import Fed, Settle
from planes.plans.assur.groups import Pair
from planes.plans.force.loads import Acting, Couple, name_of_force
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen
from planes.words.names import Meaning, NamePair


@frozen
class Grip:
    """Friction in a hinge: the names of its couple on the link of the pair, and of the ratio of couple to reaction."""

    pair: Pair
    couple: str
    factor: str

    def couple_on_link(self, link: str) -> Couple:
        """Its couple on one of the two links."""
        return Couple(self.couple, link, self.couple, 1 if link == self.pair.link else -1, True)


def hinge_friction(acting: Acting, pair: Pair) -> Grip | None:
    """The friction of a hinge; None where there is none, or where its links never turn relative to each other."""
    b = acting.bodies
    d = b.draft
    name = b.mechanism.journal_key_of_hinge(pair.point, pair.link, pair.other) if pair.kind == "R" else None
    roots = [b.known[x].root for x in (pair.link, pair.other)]
    if name is None or roots[0] == roots[1]:
        return None
    key = name_of_force(pair.link, pair.other)
    journal = b.mechanism.journals[name]
    circle = d.add_given(f"rho_{name}", journal.friction_circle_radius, Meaning("circle", name))
    for field in ((), ("coefficient",), ("radius",)):
        d.record_law(circle, b.mechanism.laws.get(("friction", name, *field)))
    rates = [("", "") if root == FRAME else (acting.motion.spin(root), acting.turning(root, False)) for root in roots]
    sense = d.add_step(SenseBetween(f"turns_{key}", *rates[0], *rates[1]))
    signed = zip((1.0, -1.0), rates, strict=True)
    d.add_sum(acting.motion.spin(key), [Product(sign, ((rate, 1),)) for sign, (rate, _) in signed if rate])
    return Grip(pair, f"MT_{key}", d.add_product(f"ρ_{key}", -1.0, **{circle: 1, sense: 1}))


@frozen
class Slip:
    """Friction on a guide: the names of its force along the guide, on the sliding link, and of its ratio to the normal
    force."""

    force: str
    factor: str


def guide_friction(acting: Acting, pair: Pair) -> Slip | None:
    """The friction of a guide; None where there is none."""
    if pair.kind != "P" or pair.guide not in acting.bodies.mechanism.friction:
        return None
    key = name_of_force(pair.link, pair.other)
    factor = dict.fromkeys(friction_and_sliding_direction(acting, pair), 1)
    return Slip(f"T_{key}", acting.bodies.draft.add_product(f"f_{pair.link}", -1.0, **factor))


def friction_and_sliding_direction(acting: Acting, pair: Pair) -> NamePair:
    """The coefficient of friction of a guide, and the direction in which the link slides along it."""
    d = acting.bodies.draft
    m = acting.bodies.mechanism
    reading = acting.motion.slides[pair.link]
    coefficient = d.add_given(f"f_{pair.guide}", m.friction[pair.guide])
    d.record_law(coefficient, m.laws.get(("friction", pair.guide)))
    return coefficient, d.add_step(
        Sense(f"slides_{pair.link}", *reading.ends, reading.along, tuple(acting.motion.driven))
    )


def settle_friction_values(acting: Acting, fed: tuple[Fed, ...], trial: Draft) -> None:
    """Settle the values ``fed`` to a plan, so that the plan drawn in ``trial`` reproduces them by the magnitudes of its
    reactions."""
    d = acting.bodies.draft
    needed = {f.size for f in fed}
    steps = []
    for step in reversed([s for name, s in trial.steps.items() if name not in d.steps]):
        if step.makes in needed:
            needed.update(name for name, _ in step.input_names())
            steps.append(step)
    for f in fed:
        d.add_step(Settle(f.makes, tuple(reversed(steps)), fed))
