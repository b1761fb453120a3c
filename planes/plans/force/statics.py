"""Force plans: one for each group, last attached first, then the primary mechanism.

A group's polygon is one chain p → (F_t, loads of the first link) → E_a → (loads of the last, F_t) → E_b, and one point
X, where the first outer reaction from p, the inner one from E_a and the last outer one from E_b meet. In each of the
five kinds exactly two of these three lines are known, and the third closes the polygon. Table 1 of the BNTU text draws
the kinds with an unloaded link; here any load may act on any link.
"""

from collections.abc import Mapping
from dataclasses import replace

from planes.drafting.equations import Chain, Equation, Term
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group, Pair
from planes.plans.force.basic_link_forces import ChainForces, TriadForces
from planes.plans.force.brace_forces import BraceForces
from planes.plans.force.contour_forces import ContourForces
from planes.plans.force.driver_forces import DriverForces
from planes.plans.force.hinges import Grip
from planes.plans.force.loads import Couple, Force, name_of_force
from planes.plans.force.reactions import Reaction, Statics, cross_reactions_with_friction
from planes.plans.force.rubbing import RubbingPlan, Rubs
from planes.scene.mechanism import FRAME
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Mark, MarkPair, NameTuple, PlanId, scheme_mark, vector_end_label


def draw_all_force_plans(statics: Statics) -> None:
    """Every group from the last to the first, then the driver; a driving cylinder comes after the links it braces."""
    structure = statics.bodies.structure
    for group in (g for g in reversed(structure.groups) if not structure.is_driving_cylinder(g)):
        match group:
            case Group():
                _GroupForces(statics, group).draw_group_force_plan()
            case Triad():
                TriadForces(statics, group).draw()
            case BasicChain():
                ChainForces(statics, group).draw()
            case _:
                ContourForces(statics, group).draw()
    for group in structure.class_two_groups:
        if group.brace:
            BraceForces(statics, group).draw()
    DriverForces(statics).draw_driver_polygon()


class _GroupForces(RubbingPlan):
    """The plan of one group."""

    group: Group

    def __init__(self, statics: Statics, group: Group) -> None:
        super().__init__(statics, group)
        self.plan = PlanId("force", *group.balanced_links)
        acting = statics.acting
        self.loads = {x: [f for part in group.loaded_links(x) for f in acting.forces[part]] for x in group.links}
        self.couples = {x: [c for part in group.loaded_links(x) for c in acting.couples[part]] for x in group.links}
        self.grips: Mapping[Pair, Grip] = {}

    def draw_group_force_plan(self) -> None:
        """The plan, with the friction in hinges if there is any; its reactions are passed on."""
        self.draft.draw_pole(self.plan)
        self.grips = self.settle_friction(self.group.pairs).grips
        self.read_group_reactions(self.polygon())

    def rub(self, rubs: Rubs) -> None:
        """Apply the friction couples of hinges to the links."""
        for link in self.group.links:
            self.couples[link] += [
                c for x in self.group.links_composing(link) for c in rubs.friction_couples_on_link(x)
            ]

    def polygon(self) -> dict[Pair, MarkPair]:
        """Draw the polygon; returns the end marks of each reaction, on the first link of its pair."""
        g = self.group
        plan = self.plan
        head = self.tangential_reaction_by_moments(g.first, g.first_outer) if g.kind in (1, 2, 3) else []
        tail = self.tangential_reaction_by_moments(g.last, g.last_outer) if g.kind == 1 else []
        first, e_a = self.statics.lay_off_forces(plan, head + self.loads[g.first])
        last, e_b = self.statics.lay_off_forces(plan, self.loads[g.last] + tail, e_a)
        name_b = self.reaction_name_on_link(g.last, g.last_outer)
        x = name_b + ("n" if tail else "")
        rays = {
            "first": self.reaction_line_from_mark(g.first_outer, g.first, POLE_LABEL, x, -1, bool(head)),
            "inner": self.reaction_line_from_mark(g.inner, g.first, e_a, x, 1, False),
            "last": self.reaction_line_from_mark(g.last_outer, g.last, e_b, x, 1, bool(tail)),
        }
        self.state_crossing_equations(rays, first, last, x)
        starts = vector_end_label(head[0].name) if head else POLE_LABEL, last[-1].start if tail else e_b
        return {
            g.first_outer: self.reaction_ends_on_first_link(g.first_outer, g.first, *plan.marks(x, starts[0])),
            g.inner: self.reaction_ends_on_first_link(g.inner, g.first, *plan.marks(e_a, x)),
            g.last_outer: self.reaction_ends_on_first_link(g.last_outer, g.last, *plan.marks(starts[1], x)),
        }

    def state_crossing_equations(self, rays: dict[str, Term], first: Chain, last: Chain, x: str) -> None:
        """State the equations of the kind: the two lines that cross at X, and the closing side."""
        kind = self.group.kind
        if kind in (1, 2, 4):
            self.solve((*first, *last, rays["last"]), rays["first"], x)
        elif kind == 3:
            self.solve((*first, rays["inner"]), rays["first"], x)
            first_reaction = Term(rays["first"].name, x, POLE_LABEL, drawn=True)
            self.close_with_last_reaction((first_reaction, *first, *last), rays["last"])
        else:
            on_last = self.reaction_name_on_link(self.group.last, self.group.inner)
            self.solve((*last, rays["last"]), replace(rays["inner"], name=on_last, sign=-1), x)
            self.close_with_last_reaction((*first, replace(rays["inner"], drawn=True)), rays["first"])

    def solve(self, chain: Chain, back: Term, x: str) -> None:
        """Cross two known lines at X; inclined ones by trial."""
        pairs = [p for p in self.group.pairs if p.kind == "P" and p.guide in self.bodies.mechanism.friction]
        if not pairs:
            self.draft.draw_equation(Equation(self.plan, (chain, (back,))))
            return
        leant = cross_reactions_with_friction(self.statics.acting, self.plan, [chain[-1], back], x, pairs)
        drawn = (*chain[:-1], leant.get(chain[-1].name, chain[-1]))
        self.draft.measure_equation_results(Equation(self.plan, (drawn, (leant.get(back.name, back),))))

    def close_with_last_reaction(self, chain: Chain, last: Term) -> None:
        """The remaining reaction closes the polygon: both its length and direction are measured."""
        self.draft.draw_closing_vector(self.plan, chain, last.name, *last.end_marks)

    def reaction_line_from_mark(self, pair: Pair, link: str, start: str, x: str, sign: int, split: bool) -> Term:
        """The line of a reaction on a link through a mark of the polygon (X is its other end)."""
        name = self.reaction_name_on_link(link, pair) + ("^n" if split else "")
        along = self.draft.draw_perpendicular(f"∥{pair.guide}") if pair.kind == "P" else None
        if split:  # along the link: from its outer hinge to the moment point
            ends = (
                (self.group.last_outer.point, pair.point)
                if self.group.kind == 3
                else (pair.point, self.group.inner.point)
            )
            along = self.draft.direction_between_marks(*ends)
        return Term(name, start, x, None, along, along or "", sign=sign)

    def tangential_reaction_by_moments(self, link: str, pair: Pair) -> list[Force]:
        """F^t of an outer hinge: from moments about the inner hinge, or of the whole group about the other one."""
        d = self.draft
        g = self.group
        if g.kind == 3:
            about = g.last_outer.point
            ray = d.direction_between_marks(g.last_outer.point, pair.point)
            sides: NameTuple = (g.first, g.last)
            length = d.measure_segment(f"l_{about}{pair.point}", *SCHEME_PLAN.marks(about, pair.point))
            sign = -1.0
        else:
            about = g.inner.point
            sides = (link,)
            ray = d.direction_between_marks(pair.point, g.inner.point)
            length = self.distance_between_hinges(link, pair.point, about)
            sign = 1.0
        forces = [f for x in sides for f in self.loads[x]]
        couples = [c for x in sides for c in self.couples[x]]
        terms = self.statics.moments_about_mark(scheme_mark(about), forces, couples, sign, length)
        links = tuple(part for x in sides for part in g.loaded_links(x))
        name = d.solve_moment_equation(
            self.reaction_name_on_link(link, pair) + "^t", scheme_mark(about), links, terms, length
        )
        return [Force(name, link, name, d.draw_perpendicular(ray), scheme_mark(pair.point), "tangential")]

    def distance_between_hinges(self, link: str, point: str, about: str) -> str:
        """The distance between the two hinges of a link; for a cylinder, its present length."""
        if self.group.links_composing(link)[1:]:
            return f"l_{point}{about}"
        return self.bodies.given_distance(self.bodies.mechanism.links[link], point, about)

    def reaction_name_on_link(self, link: str, pair: Pair) -> str:
        """The name of a pair's reaction on a link (on the part of it that has the pair)."""
        holder = self.group.link_holding_pair(link, pair)
        return name_of_force(holder, pair.other_link_of_pair(holder))

    def read_group_reactions(self, ends: dict[Pair, MarkPair]) -> None:
        """Read the reactions of the three pairs as segments and the couples of the sliding ones, and pass them on."""
        g = self.group
        reactions = {p: self.statics.record_reaction(p, self.plan, *ends[p], self.grips.get(p)) for p in g.pairs}
        self.seat_sliding_reactions(reactions)
        seated = {p: self.statics.reactions[r.key] for p, r in reactions.items()}
        for link, pair in g.links_with_outer_pairs:
            if pair.other_link_of_pair(link) != FRAME:
                self.statics.pass_reaction_on(seated[pair], pair.other_link_of_pair(link))
        if g.drive:
            self.statics.pass_reaction_on(
                seated[g.inner if g.inner.has_link(g.drive.link) else g.held_link_first_with_pairs[0][1]], g.drive.link
            )

    def reaction_ends_on_first_link(self, pair: Pair, link: str, start: Mark, end: Mark) -> MarkPair:
        """The ends of the reaction on ``link`` from start to end, with the sign for the first link of the pair."""
        if pair.link in self.group.links_composing(link):
            return (start, end)
        return (end, start)

    def seat_sliding_reactions(self, reactions: dict[Pair, Reaction]) -> None:
        """Arms and couples of the sliding pairs, from moments about the hinge of the link."""
        g = self.group
        s = self.statics
        about = scheme_mark(g.inner.point if g.inner.kind == "R" else g.first_outer.point)
        if g.inner.kind == "P":
            seated = s.find_slider_couple_and_arm(
                reactions[g.inner], g.first, about, self.loads[g.first], self.couples[g.first]
            )
            pushed = s.reaction_as_force(seated, g.last)
            sign = 1 if seated.pair.link == g.last else -1
            if g.last_outer.kind == "P":
                couples = [*self.couples[g.last], Couple(seated.moment, g.last, seated.moment, sign, True)]
                s.find_slider_couple_and_arm(
                    reactions[g.last_outer], g.last, about, [*self.loads[g.last], pushed], couples
                )
            return
        for link, pair in g.links_with_outer_pairs:
            if pair.kind == "P":
                s.find_slider_couple_and_arm(reactions[pair], link, about, self.loads[link], self.couples[link])
