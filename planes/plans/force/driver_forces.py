"""The force plan of the primary mechanism: the frame's reaction and the balancing load."""

from planes.drafting.equations import Chain, Equation, Term
from planes.drafting.steps.settling import Fed
from planes.plans.force.hinges import hinge_friction
from planes.plans.force.loads import Force, name_of_force
from planes.plans.force.reactions import Statics, cross_reactions_with_friction
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import POLE_LABEL, Meaning, PlanId, scheme_mark


class DriverForces:
    """The primary mechanism: the frame's reaction and the balancing moment (or force)."""

    def __init__(self, statics: Statics) -> None:
        self.statics = statics
        self.bodies = statics.bodies
        self.draft = statics.bodies.draft
        self.link = self.bodies.mechanism.drive.link
        self.pair = self.bodies.structure.drive_pair
        self.plan = PlanId("force", self.link)
        self.forces = statics.acting.forces[self.link]
        self.couples = statics.acting.couples[self.link]

    def draw_driver_polygon(self) -> None:
        """Draw the driver's polygon and find the balancing load."""
        self.draft.draw_pole(self.plan)
        balance = self.turning if self.pair.kind == "R" else self.balance_sliding_driver
        balance(*self.statics.lay_off_forces(self.plan, self.forces), name_of_force(self.link, self.pair.other))

    def turning(self, terms: Chain, start: str, key: str) -> None:
        """F_10 closes the polygon; the balancing moment by moments about the pivot."""
        self.draft.draw_closing_vector(self.plan, terms, key, start)
        ends = self.plan.mark(start), self.plan.pole
        if grip := hinge_friction(self.statics.acting, self.pair):
            self.draft.add_step(Fed(grip.couple, grip.factor, self.draft.measure_segment(f"|{key}|", *ends)))
        self.statics.record_reaction(self.pair, self.plan, *ends, grip)
        about = scheme_mark(self.pair.point)
        couples = [*self.couples, *([grip.couple_on_link(self.link)] if grip else ())]
        moments = self.statics.moments_about_mark(about, self.forces, couples, -1.0)
        self.statics.balancing = self.draft.solve_moment_equation(f"M_{self.link}", about, (self.link,), moments)
        if balance := self.bodies.mechanism.drive.balance:
            self.balance_by_force_at_point(*balance, start, key)

    def balance_by_force_at_point(self, point: str, angle: float, start: str, key: str) -> None:
        """The same by a force at a point of the driver: the moment over its arm, and the reaction that goes with it."""
        d = self.draft
        name = f"Fb_{self.link}"
        where = self.bodies.mechanism.where.get(("drive", "balance"))
        if hinge_friction(self.statics.acting, self.pair):
            raise SceneError(Phrase("balance_rubs", point=self.pair.point), self.bodies.file, where)
        along = d.draw_turned_direction(f"∠{name}", self.bodies.known[self.link].axis, angle, Meaning("given", name))
        arm = self.statics.arm_about_mark(
            Force(name, self.link, name, along, scheme_mark(point), "load"), scheme_mark(self.pair.point)
        )
        self.statics.balancing_force = d.add_product(name, **{self.statics.balancing: 1, arm: -1})
        end = d.lay_off(self.plan, name, self.plan.mark(start), along, name, Meaning("load", name, link=self.link))
        d.name_segment(self.plan, start, name, name)
        d.name_segment(self.plan, name, POLE_LABEL, f"{key}^b")
        self.statics.beside_force = f"{key}^b", end, self.plan.pole

    def balance_sliding_driver(self, terms: Chain, start: str, key: str) -> None:
        """The guide's reaction meets the balancing force, which acts along the guide."""
        guide = f"∥{self.pair.guide}"
        normal = self.draft.draw_perpendicular(guide)
        reaction = Term(key, start, key, None, normal, normal)
        force = Term(f"Fb_{self.link}", POLE_LABEL, key, None, guide, guide, sign=-1)
        if self.pair.guide in self.bodies.mechanism.friction:
            leant = cross_reactions_with_friction(self.statics.acting, self.plan, [reaction, force], key, [self.pair])
            self.draft.measure_equation_results(Equation(self.plan, ((*terms, leant[key]), (force,))))
        else:
            self.draft.lay_off_until_meeting(self.plan, terms, reaction, force)
        self.statics.balancing = force.name
        guide_reaction = self.statics.record_reaction(self.pair, self.plan, *self.plan.marks(start, key))
        self.statics.find_slider_couple_and_arm(
            guide_reaction, self.link, self.bodies.foot_on_guide(self.pair), self.forces, self.couples
        )
