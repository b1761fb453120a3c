"""The forces of a cylinder across a hinge: its own plan and that of the link it turns.

Across itself it is held by moments about its near hinge; along itself by moments of the far link about the hinge that
it braces, in which nothing else is unknown. Then its polygon is closed, and that of the far link.
"""

from planes.drafting.draft import Moments
from planes.drafting.equations import Equation, Term
from planes.drafting.steps.reckoning import Drop
from planes.plans.bodies import SCHEME
from planes.plans.groups import Brace, Pair
from planes.plans.loads import Force, force_name
from planes.plans.reactions import Statics, chain_of
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import POLE, Meaning, at, end_of, force_plan, mu_of


class BraceForces:
    """The plans of a cylinder that drives, and of the link on its far side."""

    def __init__(self, statics: Statics, hinge: Pair, brace: Brace) -> None:
        self.statics, self.hinge, self.brace = statics, hinge, brace
        self.bodies, self.draft = statics.bodies, statics.bodies.draft
        for pair in (hinge, brace.near, brace.far):
            self.smooth(pair)

    def smooth(self, pair: Pair) -> None:
        """Refuse friction in a hinge of the brace."""
        m = self.bodies.mechanism
        if rubbing := m.rubs(pair.point, pair.link, pair.other):
            line = m.where.get(("friction", rubbing), m.where.get(("friction",)))
            told = {"pair": rubbing, "one": self.hinge.other, "two": self.hinge.link}
            raise SceneError(Phrase("brace_friction", **told), self.bodies.file, line)

    def draw(self) -> None:
        self.cylinder(*self.held())
        self.far_link()

    def held(self) -> tuple[Force, Force]:
        """The reaction of the far hinge on the cylinder: across it and along it."""
        d, s, (near, far) = self.draft, self.statics, (self.brace.near.point, self.brace.far.point)
        half, other = self.brace.far.link, self.brace.far.other
        line, length = d.ray(SCHEME, near, far), d.measure(f"l_{near}{far}", at(SCHEME, near), at(SCHEME, far))
        forces = [f for x in self.brace.halves for f in s.acting.forces[x]]
        couples = [c for x in self.brace.halves for c in s.acting.couples[x]]
        products, shown = s.moment_terms(at(SCHEME, near), forces, couples, -1.0, length)
        name, pin = force_name(half, other), at(SCHEME, far)
        d.total(f"{name}^t", products)
        d.moments.append(Moments(near, self.brace.halves, shown, f"{name}^t", length))
        across = Force(f"{name}^t", half, f"{name}^t", d.square(line), pin, "tangential")
        back = force_name(other, half)
        pushed = Force(f"{back}^t", other, f"{name}^t", d.reversed(across.along), pin, "tangential")
        about, means = at(SCHEME, self.hinge.point), Meaning("arm", f"{name}^n", at(SCHEME, self.hinge.point), half)
        arm = d.step(Drop(f"h_{name}^n_{self.hinge.point}", pin, line, about, mu_of(SCHEME), means=means))
        forces = [*s.acting.forces[other], pushed]
        products, shown = s.moment_terms(about, forces, s.acting.couples[other], 1.0, arm)
        d.total(f"{name}^n", products)
        d.moments.append(Moments(self.hinge.point, (other,), shown, f"{name}^n", arm))
        return Force(f"{name}^n", half, f"{name}^n", line, pin, "tangential"), across

    def cylinder(self, along: Force, across: Force) -> None:
        """The polygon of the cylinder, closed by the reaction of its near hinge; both are handed on."""
        s, (near, far) = self.statics, self.brace.halves
        plan = force_plan(*(x for x in self.bodies.mechanism.links if x in self.brace.halves))
        loads = [*s.acting.forces[far], *s.acting.forces[near]]
        self.draft.pole(plan)
        chain = chain_of([along, across, *loads], POLE)
        name = force_name(near, self.brace.near.other)
        self.close(plan, chain, name)
        middle, last = at(plan, end_of(across.name)), at(plan, chain[-1].end)
        for pair, start, end in ((self.brace.far, at(plan, POLE), middle), (self.brace.near, last, at(plan, POLE))):
            found = s.react(pair, plan, start, end)
            s.hand_over(found, pair.other)
            if pair.joins(self.bodies.mechanism.drive.link):
                s.hand_over(found, self.bodies.mechanism.drive.link)

    def far_link(self) -> None:
        """The polygon of the far link, closed by the reaction of the hinge that is braced."""
        s, pair = self.statics, self.hinge
        plan = force_plan(pair.link)
        self.draft.pole(plan)
        chain = chain_of(s.acting.forces[pair.link], POLE)
        self.close(plan, chain, force_name(pair.link, pair.other))
        s.react(pair, plan, at(plan, chain[-1].end), at(plan, POLE))

    def close(self, plan: str, chain: tuple[Term, ...], name: str) -> None:
        """Lay the known vectors off; the one of that name closes them."""
        for term in chain:
            self.draft.lay(plan, term)
        self.draft.conclude(Equation(plan, ((*chain, Term(name, chain[-1].end, POLE)), ())))
