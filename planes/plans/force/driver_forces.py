"""The force plan of the primary mechanism: the frame's reaction and the balancing load."""

from planes.drafting.equations import Equation, Term
from planes.drafting.steps.settling import Fed
from planes.plans.force.hinges import grip_of
from planes.plans.force.loads import Force, force_name
from planes.plans.force.reactions import Statics, meet_with_friction
from planes.plans.position.bodies import on_scheme
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import POLE, Meaning, at, force_plan


class DriverForces:
    """The primary mechanism: the frame's reaction and the balancing moment (or force)."""

    def __init__(self, statics: Statics) -> None:
        self.statics, self.bodies, self.draft = statics, statics.bodies, statics.bodies.draft
        self.link = self.bodies.mechanism.drive.link
        self.pair = self.bodies.structure.drive_pair
        self.plan = force_plan(self.link)
        self.forces = statics.acting.forces[self.link]
        self.couples = statics.acting.couples[self.link]

    def draw(self) -> None:
        """Draw the driver's polygon and find the balancing load."""
        self.draft.pole(self.plan)
        balance = self.turning if self.pair.kind == "R" else self.sliding
        balance(*self.statics.laid(self.plan, self.forces), force_name(self.link, self.pair.other))

    def turning(self, terms: tuple[Term, ...], start: str, key: str) -> None:
        """F_10 closes the polygon; the balancing moment by moments about the pivot."""
        self.draft.close(self.plan, terms, key, start)
        ends = at(self.plan, start), at(self.plan, POLE)
        if grip := grip_of(self.statics.acting, self.pair):
            self.draft.step(Fed(grip.couple, grip.factor, self.draft.measure(f"|{key}|", *ends)))
        self.statics.react(self.pair, self.plan, *ends, grip)
        about, couples = on_scheme(self.pair.point), [*self.couples, *([grip.on(self.link)] if grip else ())]
        moments = self.statics.moment_terms(about, self.forces, couples, -1.0)
        self.statics.balancing = self.draft.balance(f"M_{self.link}", about, (self.link,), moments)
        if balance := self.bodies.mechanism.drive.balance:
            self.by_force(*balance, start, key)

    def by_force(self, point: str, angle: float, start: str, key: str) -> None:
        """The same by a force at a point of the driver: the moment over its arm, and the reaction that goes with it."""
        d, name, where = self.draft, f"Fb_{self.link}", self.bodies.mechanism.where.get(("drive", "balance"))
        if grip_of(self.statics.acting, self.pair):
            raise SceneError(Phrase("balance_rubs", point=self.pair.point), self.bodies.file, where)
        along = d.turn(f"∠{name}", self.bodies.known[self.link].axis, angle, Meaning("given", name))
        arm = self.statics.arm(
            Force(name, self.link, name, along, on_scheme(point), "load"), on_scheme(self.pair.point)
        )
        self.statics.balancing_force = d.product(name, **{self.statics.balancing: 1, arm: -1})
        end = d.lay_off(self.plan, name, at(self.plan, start), along, name, Meaning("load", name, link=self.link))
        d.show(self.plan, start, name, name)
        d.show(self.plan, name, POLE, f"{key}^b")
        self.statics.beside_force = f"{key}^b", end, at(self.plan, POLE)

    def sliding(self, terms: tuple[Term, ...], start: str, key: str) -> None:
        """The guide's reaction meets the balancing force, which acts along the guide."""
        guide = f"∥{self.pair.guide}"
        normal = self.draft.square(guide)
        reaction = Term(key, start, key, None, normal, normal)
        force = Term(f"Fb_{self.link}", POLE, key, None, guide, guide, sign=-1)
        if self.pair.guide in self.bodies.mechanism.friction:
            leant = meet_with_friction(self.statics.acting, self.plan, [reaction, force], key, [self.pair])
            self.draft.conclude(Equation(self.plan, ((*terms, leant[key]), (force,))))
        else:
            self.draft.meet(self.plan, terms, reaction, force)
        self.statics.balancing = force.name
        guide_reaction = self.statics.react(self.pair, self.plan, at(self.plan, start), at(self.plan, key))
        self.statics.seat(guide_reaction, self.link, self.bodies.foot(self.pair), self.forces, self.couples)
