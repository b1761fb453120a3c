"""The forces of a cylinder across a hinge: its own plan and that of the link it turns.

Its transverse force comes from moments about its near hinge. Its axial force comes from moments of the far link about
the braced hinge, where nothing else is unknown. Then its polygon is closed, and that of the far link.
"""

from planes.plans.assur.groups import Brace, Pair
from planes.plans.force.loads import Force, force_name
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import Rubs, settled
from planes.plans.position.bodies import SCHEME, on_scheme
from planes.words.names import POLE, at, end_of, force_plan


class BraceForces:
    """The plans of a driving cylinder and of the link on its far side."""

    def __init__(self, statics: Statics, hinge: Pair, brace: Brace) -> None:
        self.statics, self.hinge, self.brace = statics, hinge, brace
        self.bodies, self.draft = statics.bodies, statics.bodies.draft
        links = self.bodies.mechanism.links
        self.plans = force_plan(*(x for x in links if x in brace.halves)), force_plan(hinge.link)
        self.couples = {x: list(statics.acting.couples[x]) for x in (*brace.halves, hinge.link)}

    def draw(self) -> None:
        for plan in self.plans:
            self.draft.pole(plan)
        s, pairs, driver = self.statics, (self.brace.far, self.brace.near, self.hinge), self.bodies.mechanism.drive.link
        rubs = settled(self, lambda s: BraceForces(s, self.hinge, self.brace), pairs)
        ends = self.polygon()
        for pair, plan in zip(pairs, (self.plans[0], *self.plans), strict=True):
            reaction = s.react(pair, plan, *ends[pair], rubs.grips.get(pair))
            if pair == self.hinge:
                continue
            s.hand_over(reaction, pair.other)
            if pair.joins(driver):
                s.hand_over(reaction, driver)

    def rub(self, rubs: Rubs) -> None:
        """Apply the friction couples of hinges to the cylinder and the far link."""
        for link, couples in self.couples.items():
            couples += rubs.couples(link)

    def polygon(self) -> dict[Pair, tuple[str, str]]:
        """Draw both polygons: the cylinder's, closed by the reaction of its near hinge, and that of the far link,
        closed by the reaction of the braced hinge."""
        s, (near, far), (plan, last) = self.statics, self.brace.halves, self.plans
        along, across = self.held()
        pushing = [along, across, *s.acting.forces[far], *s.acting.forces[near]]
        end = self.closed(plan, pushing, force_name(near, self.brace.near.other))
        held = at(plan, POLE), at(plan, end_of(across.name))
        far_reaction = Reaction(force_name(far, self.brace.far.other), plan, *held, self.brace.far)
        own = [*s.acting.forces[self.hinge.link], s.as_force(far_reaction, self.hinge.link)]
        last_end = self.closed(last, own, force_name(self.hinge.link, self.hinge.other))
        return {
            self.brace.far: held,
            self.brace.near: (at(plan, end), at(plan, POLE)),
            self.hinge: (at(last, last_end), at(last, POLE)),
        }

    def held(self) -> tuple[Force, Force]:
        """The reaction of the far hinge on the cylinder: its transverse and axial components."""
        d, s, (near, far) = self.draft, self.statics, (self.brace.near.point, self.brace.far.point)
        half, other = self.brace.far.link, self.brace.far.other
        line, length = d.ray(SCHEME, near, far), d.measure(f"l_{near}{far}", on_scheme(near), on_scheme(far))
        forces = [f for x in self.brace.halves for f in s.acting.forces[x]]
        couples = [c for x in self.brace.halves for c in self.couples[x]]
        name, pin = force_name(half, other), on_scheme(far)
        terms = s.moment_terms(on_scheme(near), forces, couples, -1.0, length)
        d.balance(f"{name}^t", on_scheme(near), self.brace.halves, terms, length)
        across = Force(f"{name}^t", half, f"{name}^t", d.square(line), pin, "tangential")
        back = force_name(other, half)
        pushed = Force(f"{back}^t", other, f"{name}^t", d.reversed(across.along), pin, "tangential")
        about = on_scheme(self.hinge.point)
        arm = d.arm(f"{name}^n", pin, line, about, half)
        terms = s.moment_terms(about, [*s.acting.forces[other], pushed], self.couples[other], 1.0, arm)
        d.balance(f"{name}^n", about, (other,), terms, arm)
        return Force(f"{name}^n", half, f"{name}^n", line, pin, "tangential"), across

    def closed(self, plan: str, forces: list[Force], name: str) -> str:
        """Lay off the known forces; the closing vector gets that name and starts from the label given."""
        chain, end = self.statics.laid(plan, forces)
        self.draft.close(plan, chain, name, end)
        return end
