"""The links of a group one by one: the equilibrium of a single link, which gives the reaction inside its group."""

from collections.abc import Iterator

from planes.drafting.drawing import Drawing
from planes.drafting.equations import Equation, Term
from planes.plans import Plans
from planes.plans.force.loads import name_of_force
from planes.plans.force.reactions import Reaction
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, NameTuple, PlanId, vector_end_label


@frozen
class LinkApart:
    """A single link: the known forces on it, in the order they are laid off, and the ``force`` that closes their
    polygon; each with its measured segment, and whether that is reversed."""

    link: str
    group: PlanId
    force: str
    known: NameTuple
    reactions: dict[str, tuple[Reaction, bool]]

    @property
    def plan(self) -> PlanId:
        """The plan of this link, at the scale of its group's plan."""
        return PlanId("force", self.link)

    @property
    def polygon(self) -> bool:
        """Whether its polygon has more than two opposite vectors."""
        return len(self.known) > 1

    @property
    def closed_vector_names(self) -> NameTuple:
        """The names of its vectors on the group's plan, where they already form a closed polygon there."""
        own = {n: r.key for n, (r, _) in self.reactions.items() if r.plan == self.group}
        return tuple(own.get(n, n) for n in (self.force, *self.known))

    @property
    def equation(self) -> Equation:
        """The sum of its vectors is zero."""
        ends = [POLE_LABEL, *map(vector_end_label, self.known), POLE_LABEL]
        last = Term(self.force, ends[-2], POLE_LABEL)
        given = (Term(n, a, b, n, n) for n, a, b in zip(self.known, ends, ends[1:], strict=False))
        return Equation(self.plan, ((*given, last), ()))

    def vector_end_marks(self, plans: Plans, drawing: Drawing) -> dict[str, complex] | None:
        """The end marks of its vectors, mm from the pole; None where one is not drawn."""
        marks = {POLE_LABEL: 0j}
        place = 0j
        for name in self.known:
            vector = self._vector_end_mark(name, plans, drawing)
            if vector is None:
                return None
            place += vector
            marks[vector_end_label(name)] = place
        if self._vector_end_mark(self.force, plans, drawing) is not None:
            return marks
        return None

    def _vector_end_mark(self, name: str, plans: Plans, drawing: Drawing) -> complex | None:
        if name in self.reactions:
            r, back = self.reactions[name]
            if r.start not in drawing or r.end not in drawing:
                return None
            return complex((drawing[r.end] - drawing[r.start]) * (-1 if back else 1))
        load = next(f for f in plans.acting.forces[self.link] if f.name == name)
        drawn = load.size in drawing and load.along in drawing
        if drawn:
            return complex(drawing[load.size] * drawing[load.along] * drawing[self.group.mu_name])
        return None


def links_with_own_polygon(plans: Plans, plan: PlanId) -> Iterator[LinkApart]:
    """A link for every reaction inside the group of a force plan: preferably one without another such reaction, and of
    two such links the one with fewer forces."""
    drives = plans.structure.drive_pairs
    links = plan.links
    own = {k: r for k, r in plans.reactions.items() if r.plan == plan}
    inner = {k: r for k, r in own.items() if {r.pair.link, r.pair.other} <= set(links)}

    def apart(r: Reaction, link: str) -> LinkApart:
        here = [x for x in own.values() if x is not r and x.pair.has_link(link)]
        reactions = {name_of_force(link, x.pair.other_link_of_pair(link)): (x, x.pair.link != link) for x in (*here, r)}
        *known, force = reactions
        loads = (f.name for f in plans.acting.forces[link] if f.quantity != "tangential" and f.name not in reactions)
        return LinkApart(link, plan, force, (*known, *loads), reactions)

    shown = {}  # a link that closes two reactions is shown once
    for r in inner.values():
        candidates = [
            apart(r, x) for x in reversed(links) if r.pair.has_link(x) and not any(p.has_link(x) for p in drives)
        ]
        one = min(candidates, key=lambda one: (sum(x.pair.has_link(one.link) for x in inner.values()), len(one.known)))
        shown[one.link] = one
    yield from shown.values()
