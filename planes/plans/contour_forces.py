"""The force plan of a group of class IV: the forces along its two rods by a false supposition, then closed polygons.

Moments of the basic link with its rods about its outer hinge, and of the base about its own, leave two unknowns, the
forces along the rods. First the second rod is supposed to bear nothing along itself: the first equation then gives the
first rod's force, as it is supposed. The second equation with that gives what the second rod really bears, its arm
being what its force and that which it calls forth in the first rod have together. Then the first is found again.
"""

from dataclasses import replace

from planes.drafting.draft import Moments
from planes.drafting.equations import Equation, Term
from planes.drafting.steps.crossings import DropFalse
from planes.drafting.steps.reckoning import Drop, Product
from planes.plans.bodies import SCHEME
from planes.plans.contours import Contour
from planes.plans.groups import Lead, Pair
from planes.plans.loads import Couple, Force, force_name
from planes.plans.reactions import Statics, chain_of
from planes.scene.mechanism import FRAME
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import POLE, Meaning, at, force_plan, label_of, mu_of, parts_of


class _Rod:
    """A rod: what acts on it, the part of its reaction from the base across it, and the line of the other part."""

    def __init__(self, statics: Statics, lead: Lead) -> None:
        b, d = statics.bodies, statics.bodies.draft
        self.lead, self.loads = lead, list(statics.acting.forces[lead.link])
        self.couples = list(statics.acting.couples[lead.link])
        self.key, self.point = force_name(lead.link, lead.outer.mate(lead.link)), at(SCHEME, lead.outer.point)
        self.back = force_name(lead.outer.mate(lead.link), lead.link)
        self.line = d.ray(SCHEME, lead.outer.point, lead.inner.point)
        length = b.length(b.mechanism.links[lead.link], lead.outer.point, lead.inner.point)
        about = at(SCHEME, lead.inner.point)
        products, shown = statics.moment_terms(about, self.loads, self.couples, 1.0, length)
        name = d.total(f"{self.key}^t", products)
        d.moments.append(Moments(lead.inner.point, (lead.link,), shown, name, length))
        self.across = Force(name, lead.link, name, d.square(self.line), self.point, "tangential")

    def along(self, size: str) -> Force:
        """A force along it, on it from the base."""
        return Force(size, self.lead.link, size, self.line, self.point, "tangential")


class ContourForces:
    """The plan of one contour."""

    def __init__(self, statics: Statics, group: Contour) -> None:
        self.statics, self.group, self.bodies, self.draft = statics, group, statics.bodies, statics.bodies.draft
        self.plan = force_plan(*group.links)
        for pair in group.pairs:
            if rubbing := self.bodies.mechanism.rubs(pair.point, pair.link, pair.other):
                where = self.bodies.mechanism.where
                line = where.get(("friction", rubbing), where.get(("friction",)))
                raise SceneError(
                    Phrase("triad_friction", pair=rubbing, level=group.level, links=group.links), self.bodies.file, line
                )

    def draw(self) -> None:
        d, g = self.draft, self.group
        d.pole(self.plan)
        one, two = (_Rod(self.statics, lead) for lead in self.bodies.leads[g.basic])
        both = self.along(one, two)
        acting = self.statics.acting.forces
        runs = [one.loads, [one.across, both[0]], [both[1], two.across], two.loads, list(acting[g.basic])]
        ends, chain = [POLE], list[Term]()
        for run in runs:
            chain += chain_of(run, ends[-1])
            ends.append(chain[-1].end if chain else POLE)
        for term in chain:
            d.lay(self.plan, term)
        basic, base = (force_name(x, pair.mate(x)) for x, pair in zip((g.basic, g.base), g.outer[::-1], strict=True))
        d.conclude(Equation(self.plan, ((*chain, Term(basic, ends[-1], POLE)), ())))
        loads = chain_of(list(acting[g.base]), ends[1])
        for term in loads:
            d.lay(self.plan, term)
        last = loads[-1].end if loads else ends[1]
        handed = [Term(rod.back, a, b, drawn=True) for rod, a, b in ((two, ends[3], ends[2]), (one, ends[2], ends[1]))]
        d.conclude(Equation(self.plan, ((*handed, *loads, Term(base, last, ends[3])), ())))
        for rod, outer, inner in (
            (one, (ends[1], ends[2]), (ends[2], POLE)),
            (two, (ends[2], ends[3]), (ends[4], ends[2])),
        ):
            self.react(rod.lead.outer, rod.lead.link, outer)
            self.react(rod.lead.inner, rod.lead.link, inner)
        self.react(g.outer[0], g.base, (last, ends[3]))
        self.react(g.outer[1], g.basic, (ends[-1], POLE))

    def along(self, one: _Rod, two: _Rod) -> tuple[Force, Force]:
        """The forces along both rods, on them from the base."""
        d, g = self.draft, self.group
        pivot, hinge = (at(SCHEME, pair.point) for pair in g.outer)
        arms = [self.arm(one, hinge, (one, two)), self.arm(two, hinge), self.arm(one, pivot), self.arm(two, pivot)]
        basic = [g.basic, *(rod.lead.link for rod in (one, two))]
        forces = [f for x in basic for f in self.statics.acting.forces[x]] + [one.across, two.across]
        couples = [c for x in basic for c in self.statics.acting.couples[x]]
        supposed = one.along(self.moments(f"{one.key}^I", hinge, basic, forces, couples, -1.0, arms[0]))
        reduced = [Product(1.0, ((arms[3], 1),)), Product(-1.0, ((arms[1], 1), (arms[2], 1), (arms[0], -1)))]
        arm = d.total(f"h_{two.key}^0", reduced, Meaning("arm", two.key, pivot, g.base))
        own, acting = [g.base], self.statics.acting
        pushed = [self.handed(one.across, one), self.handed(supposed, one), self.handed(two.across, two)]
        loads = [*acting.forces[g.base], *pushed]
        second = two.along(self.moments(f"{two.key}^n", pivot, own, loads, acting.couples[g.base], 1.0, arm))
        first = self.moments(f"{one.key}^n", hinge, basic, [*forces, second], couples, -1.0, arms[0])
        return one.along(first), second

    def arm(self, rod: _Rod, about: str, choice: tuple[_Rod, _Rod] | None = None) -> str:
        """The arm of a rod's line about an outer hinge."""
        d, name = self.draft, f"h_{rod.key}^n_{label_of(about)}"
        own = name, rod.point, rod.line, about, mu_of(SCHEME)
        means = Meaning("arm", rod.key, about, self.group.basic)
        if choice is None:
            return d.step(Drop(*own, means=means))
        lines = [x for r in choice for x in (r.line, d.ray(SCHEME, self.group.outer[1].point, r.lead.inner.point))]
        leaning = replace(means, of=self.group.basic)
        return d.step(DropFalse(*own, lines=(lines[0], lines[1], lines[2], lines[3]), means=leaning))

    def moments(
        self, name: str, about: str, links: list[str], forces: list[Force], couples: list[Couple], sign: float, arm: str
    ) -> str:
        """What an equation of moments about a hinge gives."""
        products, shown = self.statics.moment_terms(about, forces, couples, sign, arm)
        found = self.draft.total(name, products)
        self.draft.moments.append(Moments(label_of(about), tuple(links), shown, found, arm))
        return found

    def handed(self, force: Force, rod: _Rod) -> Force:
        """A force on a rod as the base feels it, reversed."""
        part = parts_of(force.name)[2]
        return replace(force, name=f"{rod.back}^{part}", link=self.group.base, along=self.draft.reversed(force.along))

    def react(self, pair: Pair, link: str, ends: tuple[str, str]) -> None:
        """A reaction on a link by the ends of its segment, handed on to what the group hangs on."""
        start, end = (at(self.plan, label) for label in (ends if link == pair.link else ends[::-1]))
        found = self.statics.react(pair, self.plan, start, end)
        if pair in self.group.outer and pair.mate(link) != FRAME:
            self.statics.hand_over(found, pair.mate(link))
