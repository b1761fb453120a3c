"""A triad one lead of which slides at both ends: that fixes how its basic link lies, and the two others place it.

The basic link turns as what such a lead slides on does. So what another lead hangs on is moved over, by the vector
from its own point of the basic link to the one that is sought: both leads then reach that one point, as two links of a
dyad do. On plans of rates the moved point goes with what it was moved from, and about that as the basic link turns.
"""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from planes.drafting.equations import Equation, Term
from planes.plans.basic_links import Lead, Triad
from planes.plans.bodies import SCHEME, AssemblyChoice, Bodies, Body, BodyPoint
from planes.plans.carrying import carried
from planes.plans.driven_positions import driven_way
from planes.plans.kinematics import Rates
from planes.plans.legs import Leg, lead_leg, outer_leg
from planes.plans.positions import chain_to, on_line, place_slider
from planes.plans.reckoned import OwnPlace, angle_deg, difference
from planes.plans.triads import place_lead
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, Meaning, at, label_of


def place_slid(b: Bodies, g: Triad) -> None:
    """Draw the basic link where its other leads reach it, as it lies, and the leads."""
    *leads, slid = g.by_slid
    b.leads[g.basic] = (*leads, slid)
    outer, inner, link = slid.outer, slid.inner, b.mechanism.links[g.basic]
    mate = b.known[outer.mate(slid.link)]
    along = b.direction_from(outer, mate.link.name, mate.axis)
    way = b.direction_from(inner, slid.link, b.axis_along(outer, slid.link, along))
    axis = b.axis_along(inner, g.basic, way)
    key = next((lead.inner.point for lead in leads if lead.inner.kind == "R"), link.first_point)
    placers: dict[Lead, Callable[[], None]] = {}
    one, two = (_reaching(b, g.basic, lead, key, axis, placers) for lead in leads)
    side = None if one[-1].direction and two[-1].direction else b.draft.give(f"side_{key}", 1.0)
    if side:
        b.choices.append(AssemblyChoice(side, key, g))
    b.draft.draw(Equation(SCHEME, (one, two), f"r_{key}", side))
    b.place_points(Body(link, BodyPoint(key, key), axis, mate.root))
    for lead in leads:
        placers.get(lead, partial(place_lead, b, g.basic, lead))()
    first = b.mechanism.links[slid.link].first_point
    lines = (on_line(b, pair, slid.link, first) for pair in (outer, inner))
    chains = [chain_to(first, start, along=line) for start, line in lines]
    b.draft.draw(Equation(SCHEME, (chains[0], chains[1]), f"r_{first}"))
    place_slider(b, outer, slid.link, first, along)


def _reaching(
    b: Bodies, basic: str, lead: Lead, key: str, axis: str, placers: dict[Lead, Callable[[], None]]
) -> tuple[Term, Term]:
    """How a lead reaches a point of the basic link that lies along ``axis``; what draws one with a drive inside is put
    among the ``placers``."""
    outer, inner = lead.outer, lead.inner
    if inner.kind == "P":
        along, hinge = b.direction_from(inner, basic, axis), outer.point
        apart = difference(b.offset(inner, basic, key), b.offset(inner, lead.link, hinge))
        beside = Meaning("guide", inner.guide, key)
        start = b.shifted(f"{key}°{inner.guide}", beside, at(SCHEME, hinge), along, apart)
        return chain_to(key, label_of(start), along=along)
    hinge = inner.point
    if lead.drive:
        way, placers[lead] = driven_way(b, lead.moving(basic))
        start = moved_over(b, basic, label_of(way.start), hinge, key, axis)
        return chain_to(key, start, way.length or None, way.along or None)
    if outer.kind == "P":
        start, along = on_line(b, outer, lead.link, hinge)
        return chain_to(key, moved_over(b, basic, start, hinge, key, axis), along=along)
    length = b.length(b.mechanism.links[lead.link], outer.point, hinge)
    return chain_to(key, moved_over(b, basic, outer.point, hinge, key, axis), length)


def moved_over(b: Bodies, basic: str, start: str, hinge: str, key: str, axis: str) -> str:
    """A mark moved over by the vector from one point of the basic link to another."""
    link, d = b.mechanism.links[basic], b.draft
    if link.points[hinge] == link.points[key]:
        return start
    turned = angle_deg(b.shape, OwnPlace(basic, hinge), OwnPlace(basic, key))
    ray = d.turn(f"{hinge}{key}", axis, turned, Meaning("along", hinge, key))
    d.rays[SCHEME, hinge, key] = ray
    label, length = f"{start}°{key}", b.length(link, hinge, key)
    return label_of(d.lay_off(SCHEME, label, at(SCHEME, start), ray, length, Meaning("moved", start, key)))


class SlidRates:
    """The rates of one such triad."""

    def __init__(self, r: Rates, g: Triad) -> None:
        self.rates, self.group, self.bodies, self.draft = r, g, r.bodies, r.bodies.draft
        *leads, self.slid = r.bodies.leads[g.basic]
        self.one, self.two = (lead_leg(r.bodies, g.basic, lead) for lead in leads)

    def draw(self) -> None:
        r, b, slid = self.rates, self.bodies, self.slid
        body, first = b.known[self.group.basic], b.mechanism.links[slid.link].first_point
        body.moving = self.one.new
        r.image(self.two.link, self.two.known)
        moved = self.moved(self.two, self.one.new)
        r.solve(self.one.new.name, r.chain(self.one), r.chain(moved), (self.one, moved))
        r.image(self.group.basic, self.two.new)
        legs = [outer_leg(b, pair, slid.link, BodyPoint(first, first)) for pair in (slid.outer, slid.inner)]
        r.solve(first, r.chain(legs[0]), r.chain(legs[1]), legs)
        for link in self.group.whole:
            r.show_points(link)

    def moved(self, leg: Leg, new: BodyPoint) -> Leg:
        """A leg to another point of the basic link, what it starts from moved over."""
        r, root = self.rates, self.bodies.known[self.bodies.known[self.group.basic].root]
        if root.link.name == FRAME or leg.new == new:
            return replace(leg, new=new)
        name = (leg.known.name if leg.known.name != POLE else leg.new.name) + "°"
        over, start, end = BodyPoint(leg.known.place, name), r.mark(leg.known.name), r.mark(name)
        carried(r, root, start, leg.new, new, end)
        to_known = Term(r.letter + leg.known.name, POLE, label_of(start), drawn=True)
        over_it = Term(f"{r.letter}{new.name}{leg.new.name}", label_of(start), label_of(end), drawn=True)
        self.draft.conclude(Equation(r.plan, ((to_known, over_it), ()), r.letter + name))
        return replace(leg, new=new, known=over)
