"""The scheme of basic links hinged to each other: their hinges, and a point of each, where their tracks are cut."""

from dataclasses import replace

from planes.drafting.steps.tracks import CutTrack, CutTurn, Hold
from planes.plans.assur.basic_chains import BasicChain
from planes.plans.position.bodies import SCHEME, Bodies, Body, BodyPoint
from planes.plans.position.positions import rigid_body
from planes.plans.position.triads import Cut, cut_of, hold_of, local_of, place_lead
from planes.words.names import Meaning, at


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
        b.draft.step(CutTrack(at(SCHEME, pin), pins[k], *cut, link=k, hinge=pins[k]))
    for k in range(len(g.basics)):
        _place_basic(b, g, k, origins[k], pins[k], cut)
    for basic, side in zip(g.basics, g.sides, strict=True):
        for lead in side:
            place_lead(b, basic, lead)


def _place_basic(b: Bodies, g: BasicChain, k: int, pin: str, local: str, cut: Cut) -> None:
    """One basic link from its hinge, by another point of it where its track is cut, or along its axis."""
    basic, link = g.basics[k], b.mechanism.links[g.basics[k]]
    others = [lead.inner.point for lead in g.sides[k] if lead.inner.kind == "R"]
    others += [h.point for h in g.hinges if h.joins(basic) and h.point != pin]
    if others:
        if at(SCHEME, others[0]) not in b.draft.steps:  # a hinge with the next one is
            b.draft.step(CutTrack(at(SCHEME, others[0]), local_of(b, link, others[0]), *cut, link=k, hinge=local))
        b.place_points(rigid_body(b, basic, pin, others[0]))
    else:
        axis = b.draft.step(CutTurn(f"x_{basic}", local, *cut, link=k, hinge=local, means=Meaning("own", basic)))
        b.place_points(Body(link, BodyPoint(pin, pin), axis, basic))
