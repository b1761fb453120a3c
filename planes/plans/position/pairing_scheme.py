"""The scheme of two basic links hinged to each other: their hinge, and a point of each, where their tracks are cut."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial

from planes.drafting.steps.tracks import CutTrack, CutTurn
from planes.plans.assur.basic_links import Lead
from planes.plans.assur.pairings import Pairing
from planes.plans.position.bodies import SCHEME, Bodies, Body, BodyPoint
from planes.plans.position.positions import rigid_body
from planes.plans.position.triads import cut_of, hold_of, local_of, place_lead
from planes.words.names import Meaning, at


def place_pairing(b: Bodies, g: Pairing) -> None:
    """Draw both basic links where their tracks are cut, and the leads."""
    links, pin = [b.mechanism.links[basic] for basic in g.basics], g.hinge.point
    pins = [local_of(b, link, pin) for link in links]
    placers: dict[Lead, Callable[[], None]] = {}
    holds = tuple(
        replace(hold_of(b, basic, lead, placers), link=k, hinge=pins[k])
        for k, basic in enumerate(g.basics)
        for lead in g.sides[k]
    )
    cut = cut_of(b, g, pin, holds)
    b.draft.step(CutTrack(at(SCHEME, pin), pins[0], *cut, hinge=pins[0]))
    b.leads |= dict.fromkeys(g.basics, (*g.leads, g.joint))
    for k, (basic, link) in enumerate(zip(g.basics, links, strict=True)):
        hinge = next((lead.inner.point for lead in g.sides[k] if lead.inner.kind == "R"), None)
        if hinge:
            b.draft.step(CutTrack(at(SCHEME, hinge), local_of(b, link, hinge), *cut, link=k, hinge=pins[k]))
            b.place_points(rigid_body(b, basic, pin, hinge))
        else:
            own = Meaning("own", basic)
            axis = b.draft.step(CutTurn(f"x_{basic}", pins[k], *cut, link=k, hinge=pins[k], means=own))
            b.place_points(Body(link, BodyPoint(pin, pin), axis, basic))
    for k, basic in enumerate(g.basics):
        for lead in g.sides[k]:
            placers.get(lead, partial(place_lead, b, basic, lead))()
