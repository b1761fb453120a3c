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
from planes.plans.position.bodies import SCHEME, Bodies, Body, BodyPoint, TrackChoice, on_scheme
from planes.plans.position.driven_positions import driven_way
from planes.plans.position.positions import on_line, place_slider, rigid_body
from planes.plans.position.reckoned import OwnPlace, difference, reckoned
from planes.scene.mechanism import Link
from planes.words.names import Meaning, mu_of

Holds = tuple[Hold, ...]
Cut = tuple[Holds, SeriesGuess, str, str]  # what cuts the tracks of a basic link


def place_triad(b: Bodies, g: Triad) -> None:
    """Draw the basic link where its track is cut, and the leads."""
    d, link = b.draft, b.mechanism.links[g.basic]
    one, two, three = (hold_of(b, g.basic, lead) for lead in g.leads)
    hinges = [lead.inner.point for lead in reversed(g.leads) if lead.inner.kind == "R"] or [link.first_point]
    key = hinges[0]
    cut = cut_of(b, g, key, (one, two, three))
    for p in hinges:
        d.step(CutTrack(on_scheme(p), local_of(b, link, p), *cut))
    if len(hinges) > 1:
        b.place_points(rigid_body(b, g.basic, hinges[0], hinges[1]))
    else:
        axis = d.step(CutTurn(f"x_{g.basic}", local_of(b, link, key), *cut, means=Meaning("own", g.basic)))
        b.place_points(Body(link, BodyPoint(key, key), axis, g.basic))
    for lead in g.leads:
        place_lead(b, g.basic, lead)


def first_reached(b: Bodies, g: Contour) -> str:
    """The point of a basic link that is drawn first: preferably a hinge with a lead."""
    hinges = (lead.inner.point for lead in g.leads if lead.inner.kind == "R")
    return next(hinges, b.mechanism.links[g.basic].first_point)


def cut_of(b: Bodies, g: Tracked, key: str, holds: Holds) -> Cut:
    """The cut of a basic link's tracks, its assembly still to be chosen; ``key`` is the point that decides."""
    d, drive = b.draft, b.mechanism.drive
    middle, half, size = (
        d.give(f"{what}_{g.basic}", value) for what, value in (("middle", 0.0), ("half", 1.0), ("size", 1.0))
    )
    place, turn = d.give(f"track_{g.basic}_0", 0j), d.give(f"turning_{g.basic}_0", 0.0)
    guess = SeriesGuess(drive.given, drive.rotates, middle, half, size, (place,), ((turn,),))
    side = d.give(f"sense_{g.basic}", 1.0)
    b.choices.append(TrackChoice(key, g, holds, guess, side))
    return holds, guess, mu_of(SCHEME), side


def place_lead(b: Bodies, basic: str, lead: Lead) -> None:
    """A lead drawn from the basic link."""
    outer, inner = lead.outer, lead.inner
    if place := b.placers.get(lead):
        place()
    elif lead.name == "RR":
        b.place_points(rigid_body(b, lead.link, outer.point, inner.point))
    elif outer.kind == "P":
        place_slider(b, outer, lead.link, inner.point, on_line(b, outer, lead.link, inner.point)[1])
    else:
        along = b.direction_from(inner, basic, b.known[basic].axis)
        place_slider(b, inner, lead.link, outer.point, along)


def hold_of(b: Bodies, basic: str, lead: Lead, hinge: str | None = None) -> Hold:
    """The tie of a lead on the basic link, from its outer ``hinge`` (from the auxiliary figure, where that is drawn
    aside)."""
    d, link, outer, inner = b.draft, b.mechanism.links[basic], lead.outer, lead.inner
    place = hinge or on_scheme(outer.point)
    if inner.kind == "R":
        local = local_of(b, link, inner.point)
        if lead.drive:
            way, b.placers[lead] = driven_way(b, lead.moving(basic), hinge or "")
            return (
                Hold("arc", local, place, way.length) if way.length else Hold("line", local, way.start, "", way.along)
            )
        if outer.kind == "R":
            length = b.length(b.mechanism.links[lead.link], outer.point, inner.point)
            return Hold("arc", local, place, length)
        start, along = on_line(b, outer, lead.link, inner.point)
        return Hold("line", local, on_scheme(start), "", along)
    first = link.first_point
    offset = difference(b.offset(inner, lead.link, outer.point), b.offset(inner, basic, first))
    beside = Meaning("offset", outer.point, first)
    reach = "" if offset is None else d.reckon(f"e_{outer.point}{first}", offset, beside)
    turn = d.reckon(f"guide_{inner.guide}_{basic}", b.own_angle(inner, basic))
    return Hold("guide", local_of(b, link, first), place, reach, turn)


def local_of(b: Bodies, link: Link, point: str) -> str:
    """The place of a point on its link."""
    return b.draft.reckon(f"at_{point}_{link.name}", reckoned(b.shape, "place", OwnPlace(link.name, point)))


def place_chain(b: Bodies, g: BasicChain) -> None:
    """Draw the basic links where their tracks are cut, and the leads."""
    origins = [g.hinges[max(k - 1, 0)].point for k in range(len(g.basics))]
    pins = [local_of(b, b.mechanism.links[x], pin) for x, pin in zip(g.basics, origins, strict=True)]
    holds = [
        replace(hold_of(b, basic, lead), link=k, hinge=pins[k])
        for k, basic in enumerate(g.basics)
        for lead in g.sides[k]
    ]
    for hinge, (k, _) in list(zip(g.hinges, g.joined, strict=True))[1:]:
        holds.append(Hold("hinge", local_of(b, b.mechanism.links[g.basics[k]], hinge.point), link=k, hinge=pins[k]))
    cut = cut_of(b, g, origins[0], tuple(holds))
    b.leads |= dict.fromkeys(g.basics, (*g.leads, *g.joints))
    for k, pin in enumerate(origins[1:], 1):
        b.draft.step(CutTrack(on_scheme(pin), pins[k], *cut, link=k, hinge=pins[k]))
    for k in range(len(g.basics)):
        _place_basic(b, g, k, origins[k], pins[k], cut)
    for basic, side in zip(g.basics, g.sides, strict=True):
        for lead in side:
            place_lead(b, basic, lead)


def _place_basic(b: Bodies, g: BasicChain, k: int, pin: str, local: str, cut: Cut) -> None:
    """One basic link from its hinge, by another point where its track is cut, or along its axis."""
    basic, link = g.basics[k], b.mechanism.links[g.basics[k]]
    others = [lead.inner.point for lead in g.sides[k] if lead.inner.kind == "R"]
    others += [h.point for h in g.hinges if h.joins(basic) and h.point != pin]
    if others:
        if on_scheme(others[0]) not in b.draft.steps:  # a hinge with the next basic link is one
            b.draft.step(CutTrack(on_scheme(others[0]), local_of(b, link, others[0]), *cut, link=k, hinge=local))
        b.place_points(rigid_body(b, basic, pin, others[0]))
    else:
        axis = b.draft.step(CutTurn(f"x_{basic}", local, *cut, link=k, hinge=local, means=Meaning("own", basic)))
        b.place_points(Body(link, BodyPoint(pin, pin), axis, basic))
