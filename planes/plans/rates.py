"""Plans of rates: every group in its order; triads by Assur's special points.

The lines of two leads of a basic link cross in its special point S. A lead lets its point move across its own line
alone, and S moves about that point across the same line: so of S both leads say in which direction its relative
velocity lies, v_S = v_E + (⊥ of the first) = v_F + (⊥ of the second); then the third lead's point is found from S. Of
accelerations the normal and Coriolis parts join in.
"""

from dataclasses import replace

from planes.drafting.equations import Term
from planes.drafting.steps import Turn
from planes.drafting.steps.crossings import CrossLeads
from planes.plans.basic_links import Triad
from planes.plans.bodies import SCHEME, BodyPoint
from planes.plans.contour_rates import ContourRates
from planes.plans.groups import Group
from planes.plans.kinematics import Rates
from planes.plans.legs import Leg, lead_leg
from planes.plans.slid_triads import SlidRates
from planes.words.names import Meaning, at, parts_of


def draw_rates(r: Rates) -> None:
    """The plan: the driver, then every group, then every point of every link."""
    for group in r.bodies.structure.groups:
        if isinstance(group, Triad) and not group.slid and any(lead.drive for lead in group.leads):
            _Triad(r, group).meet()  # its special point is found on the scheme before the plan is begun
    r.start()
    for group in r.bodies.structure.groups:
        if isinstance(group, Group):
            r.dyad(group)
        elif isinstance(group, Triad):
            (SlidRates if group.slid else _Triad)(r, group).draw()
        else:
            ContourRates(r, group).draw()


class _Triad:
    """The rates of one triad."""

    def __init__(self, r: Rates, g: Triad) -> None:
        self.rates, self.group, self.bodies, self.draft = r, g, r.bodies, r.bodies.draft
        self.legs = [lead_leg(r.bodies, g.basic, lead) for lead in r.bodies.leads[g.basic]]
        name = r.bodies.special(g.basic)
        self.special = BodyPoint(name, name)

    def draw(self) -> None:
        r, (one, two, three) = self.rates, self.legs
        s, body = self.special, self.bodies.known[self.group.basic]
        self.meet()
        r.solve(s.name, self.to_special(one), self.to_special(two), ())
        body.ref, body.moving, body.rigid = (s, three.new), three.new, False
        turning = self.about_special(three)
        r.solve(three.new.name, r.chain(turning), r.chain(three), (turning, three))
        for leg in (one, two):
            self.read(leg)
        for link in self.group.whole:
            r.show_points(link)

    def meet(self) -> None:
        """The special point, where the lines of two leads cross."""
        (a, along), (b, across), (c, beside) = ((at(SCHEME, leg.new.place), self.line(leg)) for leg in self.legs)
        met = CrossLeads(at(SCHEME, self.special.place), a, along, b, across, third=c, third_along=beside)
        self.draft.step(replace(met, means=Meaning("special", self.group.basic)))

    def line(self, leg: Leg) -> str:
        """The line of a lead, across what its point may do."""
        if leg.pair is None:
            return self.draft.ray(SCHEME, leg.known.place, leg.new.place)
        return self.draft.square(leg.along)

    def to_special(self, leg: Leg) -> tuple[Term, ...]:
        """The terms from the pole by what a lead hangs on to S; both tangential parts are one."""
        r, s = self.rates, self.special.name
        *known, last = r.chain(leg)
        symbol, part = s + leg.symbol.removeprefix((leg.spot or leg.new).name), parts_of(last.name)[2]
        if r.quick:
            known.append(self.towards(leg, last.start))
        name = f"{r.letter}{symbol}" + (f"^{part}" if part else "")
        return (*known, replace(last, name=name, start=known[-1].end, end=r.label(s)))

    def towards(self, leg: Leg, start: str) -> Term:
        """The normal acceleration of S about the lead's point, ω² l, laid off from ``start``."""
        s, new, d = self.special.place, leg.new, self.draft
        length = d.measure(f"l_{s}{new.place}", at(SCHEME, s), at(SCHEME, new.place))
        name = f"a_{s}{new.name}"
        value = d.product(f"{name}^n", **{f"omega_{self.group.basic}": 2, length: 1})
        ray = d.ray(SCHEME, s, new.place)
        along = d.step(Turn(f"{s}→{new.place}", ray, 0, means=Meaning("towards", s, new.place)))
        normal = Meaning("normal", s, new.name)
        return Term(f"{name}^n", start, f"n_{s}{new.name}", length=value, direction=along, action=along, means=normal)

    def about_special(self, leg: Leg) -> Leg:
        """How the third lead's point goes about S with the basic link."""
        s, new, d = self.special, leg.new, self.draft
        ray = d.ray(SCHEME, s.place, new.place)
        length = d.measure(f"l_{new.place}{s.place}", at(SCHEME, new.place), at(SCHEME, s.place))
        means = Meaning("towards", new.place, s.place)
        towards = d.step(Turn(f"{new.place}→{s.place}", ray, 2, means=means))
        return Leg(
            new,
            s,
            self.group.basic,
            symbol=new.name + s.name,
            along=d.square(ray),
            length=length,
            towards=towards,
            turns=self.group.basic,
        )

    def read(self, leg: Leg) -> None:
        """The point of a lead that met in S, by similarity, and what is read off the lead."""
        r = self.rates
        r.image(self.group.basic, leg.new)
        last, end = r.chain(leg)[-1], r.label(leg.new.name)
        self.draft.measure(last.name, at(r.plan, last.start), at(r.plan, end), last.direction)
        self.draft.show(r.plan, last.start, end, last.name)
        r.conclude(leg)
