"""The forces of a cylinder across a hinge: its own plan and that of the link it turns.

Its transverse force comes from moments about its near hinge. Its axial force comes from moments of the far link about
the braced hinge, where nothing else is unknown. Then its polygon is closed, and that of the far link.
"""

from planes.plans.assur.groups import Group, Pair
from planes.plans.force.loads import Force, name_of_force
from planes.plans.force.reactions import Reaction, Statics
from planes.plans.force.rubbing import RubbingPlan
from planes.words.names import SCHEME_PLAN, MarkPair, PlanId, scheme_mark, vector_end_label


class BraceForces(RubbingPlan):
    """The plans of a driving cylinder and of the link on its far side."""

    def __init__(self, statics: Statics, group: Group) -> None:
        assert group.drive and group.brace
        super().__init__(statics, group)
        self.hinge = hinge = group.drive
        self.brace = brace = group.brace
        links = self.bodies.mechanism.links
        self.plans = PlanId("force", *(x for x in links if x in brace.cylinder_links)), PlanId("force", hinge.link)
        self.couples = {x: list(statics.acting.couples[x]) for x in (*brace.cylinder_links, hinge.link)}

    def draw(self) -> None:
        for plan in self.plans:
            self.draft.draw_pole(plan)
        s = self.statics
        pairs = (self.brace.far, self.brace.near, self.hinge)
        driver = self.bodies.mechanism.drive.link
        rubs = self.settle_friction(pairs)
        ends = self.polygon()
        for pair, plan in zip(pairs, (self.plans[0], *self.plans), strict=True):
            reaction = s.record_reaction(pair, plan, *ends[pair], rubs.grips.get(pair))
            if pair == self.hinge:
                continue
            s.pass_reaction_on(reaction, pair.other)
            if pair.has_link(driver):
                s.pass_reaction_on(reaction, driver)

    def polygon(self) -> dict[Pair, MarkPair]:
        """Draw both polygons: the cylinder's, closed by the reaction of its near hinge, and that of the far link,
        closed by the reaction of the braced hinge."""
        s = self.statics
        near, far = self.brace.cylinder_links
        plan, last = self.plans
        along, across = self.far_hinge_reaction()
        pushing = [along, across, *s.acting.forces[far], *s.acting.forces[near]]
        end = self.close_force_polygon(plan, pushing, name_of_force(near, self.brace.near.other))
        held = plan.pole, plan.mark(vector_end_label(across.name))
        far_reaction = Reaction(name_of_force(far, self.brace.far.other), plan, *held, self.brace.far)
        own = [*s.acting.forces[self.hinge.link], s.reaction_as_force(far_reaction, self.hinge.link)]
        last_end = self.close_force_polygon(last, own, name_of_force(self.hinge.link, self.hinge.other))
        return {
            self.brace.far: held,
            self.brace.near: (plan.mark(end), plan.pole),
            self.hinge: (last.mark(last_end), last.pole),
        }

    def far_hinge_reaction(self) -> tuple[Force, Force]:
        """The reaction of the far hinge on the cylinder: its transverse and axial components."""
        d = self.draft
        s = self.statics
        near = self.brace.near.point
        far = self.brace.far.point
        half = self.brace.far.link
        other = self.brace.far.other
        line = d.direction_between_marks(near, far)
        length = d.measure_segment(f"l_{near}{far}", *SCHEME_PLAN.marks(near, far))
        forces = [f for x in self.brace.cylinder_links for f in s.acting.forces[x]]
        couples = [c for x in self.brace.cylinder_links for c in self.couples[x]]
        name = name_of_force(half, other)
        pin = scheme_mark(far)
        terms = s.moments_about_mark(scheme_mark(near), forces, couples, -1.0, length)
        d.solve_moment_equation(f"{name}^t", scheme_mark(near), self.brace.cylinder_links, terms, length)
        across = Force(f"{name}^t", half, f"{name}^t", d.draw_perpendicular(line), pin, "tangential")
        back = name_of_force(other, half)
        pushed = Force(f"{back}^t", other, f"{name}^t", d.draw_reversed_direction(across.along), pin, "tangential")
        about = scheme_mark(self.hinge.point)
        arm = d.draw_arm(f"{name}^n", pin, line, about, half)
        terms = s.moments_about_mark(about, [*s.acting.forces[other], pushed], self.couples[other], 1.0, arm)
        d.solve_moment_equation(f"{name}^n", about, (other,), terms, arm)
        return Force(f"{name}^n", half, f"{name}^n", line, pin, "tangential"), across

    def close_force_polygon(self, plan: PlanId, forces: list[Force], name: str) -> str:
        """Lay off the known forces; the closing vector gets that name and starts from the label given."""
        chain, end = self.statics.lay_off_forces(plan, forces)
        self.draft.draw_closing_vector(plan, chain, name, end)
        return end
