"""The scheme of a group with an inner drive: two links with a cylinder or a motor between them are drawn as one link
whose length, between its two hinges, is given by the drive; or as a slider whose hinge moves along a line shifted by
the drive."""

from collections.abc import Callable

from planes.drafting.equations import Equation
from planes.drafting.steps import Carry, Image
from planes.drafting.steps.crossings import Touch
from planes.drafting.steps.reckoning import SenseOf, SizeOf
from planes.plans.assur.groups import Group, Pair
from planes.plans.position.asides import Aside, aside_of, reach_of, slid, turned
from planes.plans.position.bodies import SCHEME, Bodies, Body, BodyPoint, on_scheme
from planes.plans.position.positions import (
    chain_held,
    chain_to,
    moving_name,
    place_held,
    place_slider,
    rigid_body,
    side_of,
)
from planes.words.frozen import frozen
from planes.words.names import Meaning, label_of


@frozen
class Way:
    """The tie of the driven hinge: a ``length`` from the mark ``start``, or a line ``along``."""

    start: str
    length: str = ""
    along: str = ""


def place_driven(b: Bodies, g: Group) -> None:
    """The two links of a drive and the one they move, by the same arcs and lines (засечки) as a dyad with those
    hinges."""
    way, place = driven_way(b, g)
    place_reached(b, g, way)
    place()


def driven_way(b: Bodies, g: Group, start: str = "") -> tuple[Way, Callable[[], None]]:
    """The drive's tie of the hinge it moves, drawn aside (from ``start``, where the fixed hinge does not exist yet);
    and the function that draws its links once the hinges exist."""
    assert g.drive
    aside, pair, hinge = aside_of(b, g, start), g.drive, g.inner.point
    if pair.kind == "R":
        return led_aside(aside, g, *turned(aside, pair, hinge))
    if g.hung[0][1].kind == "P":
        return led_aside(aside, g, "", slid(aside, pair, hinge))
    pivot = aside.base
    ends = (pivot, hinge) if g.held == pair.other else (hinge, pivot)
    reach, offset, length = cylinder(aside, pair, ends, pivot)

    def place() -> None:
        means, marks = Meaning("along", pair.guide), (on_scheme(ends[0]), on_scheme(ends[1]))
        way = b.draft.step(SenseOf(f"way_{pair.guide}", reach))
        line = b.draft.step(Touch(f"∥{pair.guide}", *marks, offset, "mu_position", way, means=means))
        ref = BodyPoint(pivot, pivot), BodyPoint(hinge, moving_name(b, pair.guide, hinge, g.held))
        b.place_points(Body(aside.link, ref[0], b.axis_along(pair, g.held, line), g.held, ref))
        place_slider(b, pair, pair.mate(g.held), hinge, line)

    return Way(on_scheme(pivot), length), place


def led_aside(aside: Aside, g: Group, motor: str, end: str) -> tuple[Way, Callable[[], None]]:
    """The same for a hinge whose mark aside is ``end``; a ``motor`` leads to it, or none."""
    b, (_, pair) = aside.bodies, g.hung[0]
    if pair.kind == "P":
        return Way(end, along=b.line(pair, pair.mate(g.held))[1]), lambda: place_sliding(aside, g, end, motor)
    length = b.draft.measure(f"l_{aside.base}{g.inner.point}", aside.start, end)
    return Way(on_scheme(aside.base), length), lambda: place_elbow(aside, g, motor, end)


def place_reached(b: Bodies, g: Group, way: Way) -> None:
    """The hinge between the stopped drive, as one link, and the link it moves."""
    hinge, (link, pair) = g.inner.point, g.hung[1]
    chains = {g.held: chain_to(hinge, label_of(way.start), way.length or None, way.along or None)}
    chains[link] = chain_held(b, link, pair, hinge)
    one, two = (chains[x] for x in (g.links if g.kind == 1 else (g.first, g.last)))
    b.draft.draw(Equation(SCHEME, (one, two), f"r_{hinge}", None if g.kind == 4 else side_of(b, hinge, g)))
    place_held(b, link, pair, hinge, chains[link][-1].direction)


def place_sliding(aside: Aside, g: Group, end: str, motor: str) -> None:
    """The links of a drive that slides on the frame: the auxiliary figure is shifted so that its hinge comes to
    ``end``. A ``motor`` turns the other link; a cylinder turns neither."""
    b, pair, hinge = aside.bodies, g.drive, g.inner.point
    assert pair
    mate, root = pair.mate(g.held), b.known[g.hung[0][1].mate(g.held)].root
    b.draft.step(Carry(on_scheme(aside.base), on_scheme(hinge), end, aside.start))
    spot = BodyPoint(hinge, moving_name(b, pair.guide, hinge, g.held))
    b.place_points(Body(aside.link, BodyPoint(aside.base, aside.base), aside.axis, root, moving=spot))
    place_held(b, mate, pair, hinge, None if motor else b.direction_from(pair, g.held, aside.axis))


def place_elbow(aside: Aside, g: Group, turning: str, end: str) -> None:
    """Two links with a motor in the hinge between them, by similarity with the auxiliary figure: there the motor is at
    ``turning``, and their other hinge at ``end``."""
    b, pivot, hinge = aside.bodies, aside.base, g.inner.point
    assert g.drive
    start, motor = on_scheme(pivot), g.drive.point
    shape = (aside.start, turning), (aside.start, end), (start, on_scheme(hinge))
    b.draft.step(Image(on_scheme(motor), start, *shape))
    body = rigid_body(b, g.held, pivot, motor)
    b.place_points(body)
    under = BodyPoint(hinge, moving_name(b, "", hinge, g.held))
    body.ref, body.rigid = (BodyPoint(pivot, pivot), under), False
    b.place_points(rigid_body(b, g.drive.mate(g.held), motor, hinge))


def cylinder(aside: Aside, pair: Pair, ends: tuple[str, str], pivot: str) -> tuple[str, str | None, str]:
    """The distances between a cylinder's hinges, of the guide's link and of the slider, along the guide and across it,
    and directly, from the auxiliary figure (the ``pivot`` is one of them): names of values, SI."""
    b, d = aside.bodies, aside.bodies.draft
    reach, offset = reach_of(b, pair, ends)
    name = f"l_{pivot}{ends[1 - ends.index(pivot)]}"
    if offset is None:
        return reach, None, d.step(SizeOf(name, reach))
    helper = Meaning("guide", pair.guide)
    reached = d.lay_off(SCHEME, f"{pivot}°{pair.guide}", aside.start, aside.axis, reach, helper)
    end = d.lay_off(SCHEME, f"{pivot}⊥{pair.guide}′", reached, d.square(aside.axis), offset, helper)
    return reach, offset, d.measure(name, aside.start, end)
