"""Friction in hinges: the reaction is tangent to the friction circle, that is, it has a couple against the turning.

The radius of the friction circle is that of the pin times the coefficient of friction (on a guide along a circle, the
circle's times the sine of the angle of friction). The couple of a group's hinge is the reaction times that radius, and
the reaction is known once the plan is drawn with the couple: plans are drawn one after another until they settle.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from planes.drafting.draft import Draft
from planes.drafting.steps.reckoning import Product, SenseBetween
from planes.drafting.steps.settling import Fed, Settle
from planes.plans.bodies import Bodies
from planes.plans.groups import Pair
from planes.plans.loads import Acting, Couple, force_name
from planes.plans.reckoned import HALF
from planes.scene.mechanism import FRAME
from planes.words.names import Meaning


@dataclass(frozen=True)
class Grip:
    """What rubs in a hinge: the names of its couple on the link of the pair, of what that is to the reaction, and of
    the speed at which the link turns against the other."""

    pair: Pair
    couple: str
    factor: str
    speed: str

    def on(self, link: str) -> Couple:
        """Its couple on one of the two links."""
        return Couple(self.couple, link, self.couple, 1 if link == self.pair.link else -1, True)


def grip_of(acting: Acting, pair: Pair) -> Grip | None:
    """How a hinge rubs; None where it does not, or where its links never turn against each other."""
    b, d = acting.bodies, acting.bodies.draft
    name, roots = _rubbing(b, pair), [b.known[x].root for x in (pair.link, pair.other)]
    if name is None or roots[0] == roots[1]:
        return None
    key, journal = force_name(pair.link, pair.other), b.mechanism.journals[name]
    circle = d.give(f"rho_{name}", journal.circle, 2 * HALF * journal.circle, Meaning("circle", name))
    for field in ((), ("coefficient",), ("radius",)):
        d.law(circle, b.mechanism.laws.get(("friction", name, *field)))
    rates = [("", "") if root == FRAME else (acting.motion.spin(root), acting.turning(root, False)) for root in roots]
    sense = d.step(SenseBetween(f"turns_{key}", *rates[0], *rates[1]))
    signed = zip((1.0, -1.0), rates, strict=True)
    speed = d.total(acting.motion.spin(key), [Product(sign, ((rate, 1),)) for sign, (rate, _) in signed if rate])
    factor = d.product(f"ρ_{key}", -1.0, **{circle: 1, sense: 1})
    return Grip(pair, f"MT_{key}", factor, speed)


def settle(acting: Acting, grips: Sequence[Grip], sizes: Mapping[str, str], trial: Draft) -> None:
    """The couples with which the plan drawn in ``trial`` gives them again, by the ``sizes`` of its reactions."""
    d = acting.bodies.draft
    fed = tuple(Fed(g.couple, g.factor, sizes[g.couple]) for g in grips)
    needed, steps = {f.size for f in fed}, []
    for step in reversed([s for name, s in trial.steps.items() if name not in d.steps]):
        if step.makes in needed:
            needed.update(name for name, _ in step.reads())
            steps.append(step)
    for g in grips:
        d.step(Settle(g.couple, tuple(reversed(steps)), fed))


def _rubbing(b: Bodies, pair: Pair) -> str | None:
    return b.mechanism.rubs(pair.point, pair.link, pair.other) if pair.kind == "R" else None
