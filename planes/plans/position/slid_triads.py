"""A triad one lead of which slides at both ends: that fixes how its basic link lies, and the two others place it.

The basic link turns as what such a lead slides on does. So what another lead hangs on is moved over, by the vector
from its own point of the basic link to the one that is sought: both leads then reach that one point, as two links of a
dyad do.
"""

from planes.drafting.equations import Equation, Term
from planes.plans.assur.basic_links import Lead, Triad
from planes.plans.position.bodies import SCHEME, AssemblyChoice, Bodies, Body, BodyPoint
from planes.plans.position.driven_positions import driven_way
from planes.plans.position.positions import chain_to, on_line, place_slider
from planes.plans.position.reckoned import OwnPlace, angle_deg, difference
from planes.plans.position.triads import place_lead
from planes.words.names import Meaning, at, label_of


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
    one, two = (_reaching(b, g.basic, lead, key, axis) for lead in leads)
    side = None if one[-1].direction and two[-1].direction else b.draft.give(f"side_{key}", 1.0)
    if side:
        b.choices.append(AssemblyChoice(side, key, g))
    b.draft.draw(Equation(SCHEME, (one, two), f"r_{key}", side))
    b.place_points(Body(link, BodyPoint(key, key), axis, mate.root))
    for lead in leads:
        place_lead(b, g.basic, lead)
    first = b.mechanism.links[slid.link].first_point
    lines = (on_line(b, pair, slid.link, first) for pair in (outer, inner))
    chains = [chain_to(first, start, along=line) for start, line in lines]
    b.draft.draw(Equation(SCHEME, (chains[0], chains[1]), f"r_{first}"))
    place_slider(b, outer, slid.link, first, along)


def _reaching(b: Bodies, basic: str, lead: Lead, key: str, axis: str) -> tuple[Term, Term]:
    """How a lead reaches a point of the basic link that lies along ``axis``."""
    outer, inner = lead.outer, lead.inner
    if inner.kind == "P":
        along, hinge = b.direction_from(inner, basic, axis), outer.point
        apart = difference(b.offset(inner, basic, key), b.offset(inner, lead.link, hinge))
        beside = Meaning("guide", inner.guide, key)
        start = b.shifted(f"{key}°{inner.guide}", beside, at(SCHEME, hinge), along, apart)
        return chain_to(key, label_of(start), along=along)
    hinge = inner.point
    if lead.drive:
        way, b.placers[lead] = driven_way(b, lead.moving(basic))
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
