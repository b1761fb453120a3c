"""The scheme of a triad, or of basic links joined by hinges: a basic link by the tracks of its hinges, or of one hinge
and another point, then each lead from that.

Every lead ties the basic link once: a rod with two hinges by an arc, a slider by its hinge on a line, a link that turns
about a hinge and slides on the basic link by the guide of the basic link.
"""

from dataclasses import replace

from planes.drafting.steps.tracks import CutTrack, CutTurn, Hold, SeriesGuess
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Lead, Triad
from planes.plans.assur.contours import Contour, Tracked
from planes.plans.position.bodies import Bodies, Body, BodyPoint, TrackChoice
from planes.plans.position.driven_positions import tie_and_drawer_of_driven_hinge
from planes.plans.position.positions import body_by_two_points, line_of_point_in_pair, place_slider
from planes.plans.position.reckoned import OwnPlace, dimension_by_way, dimension_difference
from planes.scene.mechanism import Link
from planes.words.names import NO_MARK, SCHEME_PLAN, Mark, Meaning, scheme_mark

Holds = tuple[Hold, ...]
Cut = tuple[Holds, SeriesGuess, str, str]  # what cuts the tracks of a basic link


def place_triad(b: Bodies, g: Triad) -> None:
    """Draw the basic link where its track is cut, and the leads."""
    d = b.draft
    link = b.mechanism.links[g.basic]
    one, two, three = (tie_of_lead(b, g.basic, lead) for lead in g.leads)
    hinges = [lead.inner.point for lead in reversed(g.leads) if lead.inner.kind == "R"] or [link.first_point]
    key = hinges[0]
    cut = cut_of_basic_link_tracks(b, g, key, (one, two, three))
    for p in hinges:
        d.add_step(CutTrack(scheme_mark(p), point_place_on_link(b, link, p), *cut))
    if len(hinges) > 1:
        b.draw_missing_points(body_by_two_points(b, g.basic, key, hinges[1]))
    else:
        axis = d.add_step(
            CutTurn(f"x_{g.basic}", point_place_on_link(b, link, key), *cut, means=Meaning("own", g.basic))
        )
        b.draw_missing_points(Body(link, BodyPoint(key, key), axis, g.basic))
    for lead in g.leads:
        place_lead(b, g.basic, lead)


def first_point_of_basic_link(b: Bodies, g: Contour) -> str:
    """The point of a basic link that is drawn first: preferably a hinge with a lead."""
    hinges = (lead.inner.point for lead in g.leads if lead.inner.kind == "R")
    return next(hinges, b.mechanism.links[g.basic].first_point)


def cut_of_basic_link_tracks(b: Bodies, g: Tracked, key: str, holds: Holds) -> Cut:
    """The cut of a basic link's tracks, its assembly still to be chosen; ``key`` is the point that decides."""
    d = b.draft
    drive = b.mechanism.drive
    middle, half, size = (
        d.add_given(f"{what}_{g.basic}", value) for what, value in (("middle", 0.0), ("half", 1.0), ("size", 1.0))
    )
    place = d.add_given(f"track_{g.basic}_0", 0j)
    turn = d.add_given(f"turning_{g.basic}_0", 0.0)
    guess = SeriesGuess(drive.coordinate_name, drive.rotates, middle, half, size, (place,), ((turn,),))
    side = d.add_given(f"sense_{g.basic}", 1.0)
    b.choices.append(TrackChoice(key, g, holds, guess, side))
    return holds, guess, SCHEME_PLAN.mu_name, side


def place_lead(b: Bodies, basic: str, lead: Lead) -> None:
    """A lead drawn from the basic link."""
    outer = lead.outer
    inner = lead.inner
    if place := b.placers.get(lead):
        place()
    elif lead.pair_letters == "RR":
        b.draw_missing_points(body_by_two_points(b, lead.link, outer.point, inner.point))
    elif outer.kind == "P":
        place_slider(b, outer, lead.link, inner.point, line_of_point_in_pair(b, outer, lead.link, inner.point)[1])
    else:
        along = b.guide_direction_from_axis(inner, basic, b.known[basic].axis)
        place_slider(b, inner, lead.link, outer.point, along)


def tie_of_lead(b: Bodies, basic: str, lead: Lead, hinge: Mark | None = None) -> Hold:
    """The tie of a lead on the basic link, from its outer ``hinge`` (from the auxiliary figure, where that is drawn
    aside)."""
    d = b.draft
    link = b.mechanism.links[basic]
    outer = lead.outer
    inner = lead.inner
    place = hinge or scheme_mark(outer.point)
    if inner.kind == "R":
        local = point_place_on_link(b, link, inner.point)
        if lead.drive:
            way, b.placers[lead] = tie_and_drawer_of_driven_hinge(b, lead.as_inner_driven_dyad(basic), hinge or NO_MARK)
            if way.length:
                return Hold("arc", local, place, way.length)
            return Hold("line", local, way.start, "", way.along)
        if outer.kind == "R":
            length = b.given_distance(b.mechanism.links[lead.link], outer.point, inner.point)
            return Hold("arc", local, place, length)
        start, along = line_of_point_in_pair(b, outer, lead.link, inner.point)
        return Hold("line", local, scheme_mark(start), "", along)
    first = link.first_point
    offset = dimension_difference(
        b.point_offset_from_guide(inner, lead.link, outer.point), b.point_offset_from_guide(inner, basic, first)
    )
    beside = Meaning("offset", outer.point, first)
    reach = "" if offset is None else d.add_computed_given(f"e_{outer.point}{first}", offset, beside)
    turn = d.add_computed_given(f"guide_{inner.guide}_{basic}", b.guide_angle_in_link(inner, basic))
    return Hold("guide", point_place_on_link(b, link, first), place, reach, turn)


def point_place_on_link(b: Bodies, link: Link, point: str) -> str:
    """The place of a point on its link."""
    return b.draft.add_computed_given(
        f"at_{point}_{link.name}", dimension_by_way(b.link_dimensions, "place", OwnPlace(link.name, point))
    )


def place_basic_chain(b: Bodies, g: BasicChain) -> None:
    """Draw the basic links where their tracks are cut, and the leads."""
    origins = [g.hinges[max(k - 1, 0)].point for k in range(len(g.basics))]
    pins = [point_place_on_link(b, b.mechanism.links[x], pin) for x, pin in zip(g.basics, origins, strict=True)]
    holds = [
        replace(tie_of_lead(b, basic, lead), link=k, hinge=pins[k])
        for k, basic in enumerate(g.basics)
        for lead in g.sides[k]
    ]
    for hinge, (k, _) in list(zip(g.hinges, g.basic_links_at_hinges, strict=True))[1:]:
        holds.append(
            Hold("hinge", point_place_on_link(b, b.mechanism.links[g.basics[k]], hinge.point), link=k, hinge=pins[k])
        )
    cut = cut_of_basic_link_tracks(b, g, origins[0], tuple(holds))
    b.leads |= dict.fromkeys(g.basics, g.leads + g.joining_leads)
    for k, pin in enumerate(origins[1:], 1):
        b.draft.add_step(CutTrack(scheme_mark(pin), pins[k], *cut, link=k, hinge=pins[k]))
    for k in range(len(g.basics)):
        _place_basic_link(b, g, k, origins[k], pins[k], cut)
    for basic, side in zip(g.basics, g.sides, strict=True):
        for lead in side:
            place_lead(b, basic, lead)


def _place_basic_link(b: Bodies, g: BasicChain, k: int, pin: str, local: str, cut: Cut) -> None:
    """One basic link from its hinge, by another point where its track is cut, or along its axis."""
    basic = g.basics[k]
    link = b.mechanism.links[basic]
    others = [lead.inner.point for lead in g.sides[k] if lead.inner.kind == "R"]
    others += [h.point for h in g.hinges if h.has_link(basic) and h.point != pin]
    if others:
        if scheme_mark(others[0]) not in b.draft.steps:  # a hinge with the next basic link is one
            b.draft.add_step(
                CutTrack(scheme_mark(others[0]), point_place_on_link(b, link, others[0]), *cut, link=k, hinge=local)
            )
        b.draw_missing_points(body_by_two_points(b, basic, pin, others[0]))
    else:
        axis = b.draft.add_step(CutTurn(f"x_{basic}", local, *cut, link=k, hinge=local, means=Meaning("own", basic)))
        b.draw_missing_points(Body(link, BodyPoint(pin, pin), axis, basic))
