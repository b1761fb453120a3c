"""The primary mechanism: the driver with what the groups hand to it, the frame's reaction, the balancing load."""

from __future__ import annotations

from planes.drafting.draft import Moments
from planes.drafting.equations import Equation, Term
from planes.plans.bodies import SCHEME
from planes.plans.friction import meet_with_friction
from planes.plans.loads import force_name
from planes.plans.reactions import Statics
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, at, force_plan


class DriverForces:
    """The primary mechanism: the frame's reaction and the balancing moment (or force)."""

    def __init__(self, statics: Statics) -> None:
        self.s, self.b, self.d = statics, statics.b, statics.b.draft
        self.link = self.b.mechanism.drive.link
        self.pair = self.b.structure.drive_pair
        self.plan = force_plan(self.link)
        self.forces = statics.acting.forces[self.link]
        self.couples = statics.acting.couples[self.link]

    def draw(self) -> None:
        """Draw the driver's polygon and find what balances it."""
        self.d.pole(self.plan)
        start, terms = POLE, []
        for f in self.forces:
            terms.append(Term(f.name, start, f.name, f.size, f.along, f.along, means=f.means))
            start = f.name
        for term in terms:
            self.d.lay(self.plan, term)
        key = force_name(self.link, FRAME)
        if self.pair.kind == "R":
            self.turning(tuple(terms), start, key)
        else:
            self.sliding(tuple(terms), start, key)

    def turning(self, terms: tuple[Term, ...], start: str, key: str) -> None:
        """F_10 closes the polygon; the balancing moment by moments about the pivot."""
        self.d.conclude(Equation(self.plan, ((*terms, Term(key, start, POLE)), ())))
        self.s.react(self.pair, self.plan, at(self.plan, start), at(self.plan, POLE))
        about = at(SCHEME, self.pair.point)
        products, shown = self.s.moment_terms(about, self.forces, self.couples, -1.0)
        self.s.balancing = self.d.total(f"M_{self.link}", products)
        self.d.moments.append(Moments(self.pair.point, (self.link,), shown, self.s.balancing, ""))

    def sliding(self, terms: tuple[Term, ...], start: str, key: str) -> None:
        """The guide's reaction crosses the balancing force, which acts along the guide."""
        guide = f"∥{self.pair.guide}"
        normal = self.d.square(guide)
        reaction = Term(key, start, key, None, normal, normal)
        force = Term(f"Fb_{self.link}", POLE, key, None, guide, guide, False, -1)
        if self.pair.guide in self.b.mechanism.friction:
            leant = meet_with_friction(self.s.acting, self.plan, [reaction, force], key, [self.pair])
            self.d.conclude(Equation(self.plan, ((*terms, leant[key]), (force,))))
        else:
            self.d.draw(Equation(self.plan, ((*terms, reaction), (force,))))
        self.s.balancing = force.name
        found = self.s.react(self.pair, self.plan, at(self.plan, start), at(self.plan, key))
        self.s.seat(found, self.link, self.b.foot(self.pair), self.forces, self.couples)
