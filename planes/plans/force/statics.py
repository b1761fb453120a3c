"""Force plans: one for each group, last attached first, then the primary mechanism.

A group's polygon is one chain p → (F_t, loads of the first link) → E_a → (loads of the last, F_t) → E_b, and one point
X, where the first outer reaction from p, the inner one from E_a and the last outer one from E_b meet. In each of the
five kinds exactly two of these three lines are known, and the third closes the polygon. Table 1 of the BNTU text draws
the kinds with an unloaded link; here any load may act on any link.
"""

from collections.abc import Mapping
from dataclasses import replace

from planes.drafting.equations import Equation, Term
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group, Pair
from planes.plans.force.basic_link_forces import ChainForces, TriadForces
from planes.plans.force.brace_forces import BraceForces
from planes.plans.force.contour_forces import ContourForces
from planes.plans.force.driver_forces import DriverForces
from planes.plans.force.hinges import Grip
from planes.plans.force.loads import Couple, Force, force_name
from planes.plans.force.reactions import Reaction, Statics, meet_with_friction
from planes.plans.force.rubbing import Rubs, settled
from planes.plans.position.bodies import SCHEME, on_scheme
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, at, end_of, force_plan


def draw_forces(statics: Statics) -> None:
    """Every group from the last to the first, then the driver; a driving cylinder comes after the links it braces."""
    structure = statics.bodies.structure
    for group in (g for g in reversed(structure.groups) if not structure.is_drive(g)):
        match group:
            case Group():
                _GroupForces(statics, group).draw()
            case Triad():
                TriadForces(statics, group).draw()
            case BasicChain():
                ChainForces(statics, group).draw()
            case _:
                ContourForces(statics, group).draw()
    for group in structure.dyads:
        if group.drive and group.brace:
            BraceForces(statics, group.drive, group.brace).draw()
    DriverForces(statics).draw()


class _GroupForces:
    """The plan of one group."""

    def __init__(self, statics: Statics, group: Group) -> None:
        self.statics, self.group, self.bodies, self.draft = statics, group, statics.bodies, statics.bodies.draft
        self.plan = force_plan(*group.balanced)
        acting = statics.acting
        self.loads = {x: [f for part in group.loaded(x) for f in acting.forces[part]] for x in group.links}
        self.couples = {x: [c for part in group.loaded(x) for c in acting.couples[part]] for x in group.links}
        self.grips: Mapping[Pair, Grip] = {}

    def draw(self) -> None:
        """The plan, with the friction in hinges if there is any; its reactions are passed on."""
        self.draft.pole(self.plan)
        self.grips = settled(self, lambda s: _GroupForces(s, self.group), self.group.pairs).grips
        self.read(self.polygon())

    def rub(self, rubs: Rubs) -> None:
        """Apply the friction couples of hinges to the links."""
        for link in self.group.links:
            self.couples[link] += [c for x in self.group.parts(link) for c in rubs.couples(x)]

    def polygon(self) -> dict[Pair, tuple[str, str]]:
        """Draw the polygon; returns the end marks of each reaction, on the first link of its pair."""
        g, plan = self.group, self.plan
        head = self.tangential(g.first, g.first_outer) if g.kind in (1, 2, 3) else []
        tail = self.tangential(g.last, g.last_outer) if g.kind == 1 else []
        first, e_a = self.statics.laid(plan, head + self.loads[g.first])
        last, e_b = self.statics.laid(plan, self.loads[g.last] + tail, e_a)
        name_b = self.name(g.last, g.last_outer)
        x = name_b + ("n" if tail else "")
        rays = {
            "first": self.ray(g.first_outer, g.first, POLE, x, -1, bool(head)),
            "inner": self.ray(g.inner, g.first, e_a, x, 1, False),
            "last": self.ray(g.last_outer, g.last, e_b, x, 1, bool(tail)),
        }
        self.meet(rays, first, last, x)
        starts = end_of(head[0].name) if head else POLE, last[-1].start if tail else e_b
        return {
            g.first_outer: self.on(g.first_outer, g.first, at(plan, x), at(plan, starts[0])),
            g.inner: self.on(g.inner, g.first, at(plan, e_a), at(plan, x)),
            g.last_outer: self.on(g.last_outer, g.last, at(plan, starts[1]), at(plan, x)),
        }

    def meet(self, rays: dict[str, Term], first: tuple[Term, ...], last: tuple[Term, ...], x: str) -> None:
        """State the equations of the kind: the two lines that cross at X, and the closing side."""
        kind = self.group.kind
        if kind in (1, 2, 4):
            self.solve((*first, *last, rays["last"]), rays["first"], x)
        elif kind == 3:
            self.solve((*first, rays["inner"]), rays["first"], x)
            first_reaction = Term(rays["first"].name, x, POLE, drawn=True)
            self.close((first_reaction, *first, *last), rays["last"])
        else:
            on_last = self.name(self.group.last, self.group.inner)
            self.solve((*last, rays["last"]), replace(rays["inner"], name=on_last, sign=-1), x)
            self.close((*first, replace(rays["inner"], drawn=True)), rays["first"])

    def solve(self, chain: tuple[Term, ...], back: Term, x: str) -> None:
        """Cross two known lines at X; inclined ones by trial."""
        pairs = [p for p in self.group.pairs if p.kind == "P" and p.guide in self.bodies.mechanism.friction]
        if not pairs:
            self.draft.draw(Equation(self.plan, (chain, (back,))))
            return
        leant = meet_with_friction(self.statics.acting, self.plan, [chain[-1], back], x, pairs)
        drawn = (*chain[:-1], leant.get(chain[-1].name, chain[-1]))
        self.draft.conclude(Equation(self.plan, (drawn, (leant.get(back.name, back),))))

    def close(self, chain: tuple[Term, ...], last: Term) -> None:
        """The remaining reaction closes the polygon: both its length and direction are measured."""
        self.draft.close(self.plan, chain, last.name, *last.ends)

    def ray(self, pair: Pair, link: str, start: str, x: str, sign: int, split: bool) -> Term:
        """The line of a reaction on a link through a mark of the polygon (X is its other end)."""
        name = self.name(link, pair) + ("^n" if split else "")
        along = self.draft.square(f"∥{pair.guide}") if pair.kind == "P" else None
        if split:  # along the link: from its outer hinge to the moment point
            ends = (
                (self.group.last_outer.point, pair.point)
                if self.group.kind == 3
                else (pair.point, self.group.inner.point)
            )
            along = self.draft.ray(SCHEME, *ends)
        return Term(name, start, x, None, along, along or "", sign=sign)

    def tangential(self, link: str, pair: Pair) -> list[Force]:
        """F^t of an outer hinge: from moments about the inner hinge, or of the whole group about the other one."""
        d, g = self.draft, self.group
        if g.kind == 3:
            about, ray = g.last_outer.point, d.ray(SCHEME, g.last_outer.point, pair.point)
            sides: tuple[str, ...] = (g.first, g.last)
            length, sign = d.measure(f"l_{about}{pair.point}", on_scheme(about), on_scheme(pair.point)), -1.0
        else:
            about, sides, ray = g.inner.point, (link,), d.ray(SCHEME, pair.point, g.inner.point)
            length, sign = self.arm(link, pair.point, about), 1.0
        forces = [f for x in sides for f in self.loads[x]]
        couples = [c for x in sides for c in self.couples[x]]
        terms = self.statics.moment_terms(on_scheme(about), forces, couples, sign, length)
        links = tuple(part for x in sides for part in g.loaded(x))
        name = d.balance(self.name(link, pair) + "^t", on_scheme(about), links, terms, length)
        return [Force(name, link, name, d.square(ray), on_scheme(pair.point), "tangential")]

    def arm(self, link: str, point: str, about: str) -> str:
        """The distance between the two hinges of a link; for a cylinder, its present length."""
        if self.group.parts(link)[1:]:
            return f"l_{point}{about}"
        return self.bodies.length(self.bodies.mechanism.links[link], point, about)

    def name(self, link: str, pair: Pair) -> str:
        """The name of a pair's reaction on a link (on the part of it that has the pair)."""
        holder = self.group.holder(link, pair)
        return force_name(holder, pair.mate(holder))

    def read(self, ends: dict[Pair, tuple[str, str]]) -> None:
        """Read the reactions of the three pairs as segments and the couples of the sliding ones, and pass them on."""
        g = self.group
        reactions = {p: self.statics.react(p, self.plan, *ends[p], self.grips.get(p)) for p in g.pairs}
        self.seat_all(reactions)
        seated = {p: self.statics.reactions[r.key] for p, r in reactions.items()}
        for link, pair in g.hangs:
            if pair.mate(link) != FRAME:
                self.statics.hand_over(seated[pair], pair.mate(link))
        if g.drive:
            self.statics.hand_over(seated[g.inner if g.inner.joins(g.drive.link) else g.hung[0][1]], g.drive.link)

    def on(self, pair: Pair, link: str, start: str, end: str) -> tuple[str, str]:
        """The ends of the reaction on ``link`` from start to end, with the sign for the first link of the pair."""
        return (start, end) if pair.link in self.group.parts(link) else (end, start)

    def seat_all(self, reactions: dict[Pair, Reaction]) -> None:
        """Arms and couples of the sliding pairs, from moments about the hinge of the link."""
        g, s = self.group, self.statics
        about = on_scheme(g.inner.point if g.inner.kind == "R" else g.first_outer.point)
        if g.inner.kind == "P":
            seated = s.seat(reactions[g.inner], g.first, about, self.loads[g.first], self.couples[g.first])
            pushed = s.as_force(seated, g.last)
            sign = 1 if seated.pair.link == g.last else -1
            if g.last_outer.kind == "P":
                couples = [*self.couples[g.last], Couple(seated.moment, g.last, seated.moment, sign, True)]
                s.seat(reactions[g.last_outer], g.last, about, [*self.loads[g.last], pushed], couples)
            return
        for link, pair in g.hangs:
            if pair.kind == "P":
                s.seat(reactions[pair], link, about, self.loads[link], self.couples[link])
