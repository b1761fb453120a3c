"""The scheme of what is driven from inside: two links with a cylinder or a motor between them are drawn as one link
whose length, between the hinge they hang by and the one they move, the drive gives."""

from collections.abc import Callable
from dataclasses import dataclass

from planes.drafting.equations import Equation
from planes.drafting.steps import Image, Turn
from planes.drafting.steps.crossings import Touch
from planes.drafting.steps.reckoning import Product, SenseOf, SizeOf
from planes.plans.bodies import SCHEME, Bodies, Body, BodyPoint
from planes.plans.groups import Group, Pair
from planes.plans.positions import chain_to, moving_name, on_line, place_slider, rigid_body, side_of
from planes.plans.reckoned import OwnPlace, along, angle_deg, difference, guided, leaning
from planes.words.names import Meaning, at


def place_driven(b: Bodies, g: Group) -> None:
    """The two links of a drive and the one they move: how far apart their hinges are, that is a засечка with it."""
    length, place = driven_length(b, g)
    place_reached(b, g, length)
    place()


def driven_length(b: Bodies, g: Group, start: str = "") -> tuple[str, Callable[[], None]]:
    """How far the hinges of the two links of a drive are apart, which is drawn from the pivot (or from ``start``, where
    that is not there yet); and what draws the links once both hinges are there."""
    assert g.drive
    hinge, pivot = g.inner.point, g.first_outer.point
    if g.drive.kind == "R":
        elbow = _elbow(b, g, g.drive, start or at(SCHEME, pivot))
        return elbow.length, lambda: elbow.place(b)
    pair, ends = g.drive, (pivot, hinge) if g.first == g.drive.other else (hinge, pivot)
    reach, offset, length = cylinder(b, pair, ends, pivot, start)

    def place() -> None:
        means, marks = Meaning("along", pair.guide), (at(SCHEME, ends[0]), at(SCHEME, ends[1]))
        way = b.draft.step(SenseOf(f"way_{pair.guide}", reach))
        along = b.draft.step(Touch(f"∥{pair.guide}", *marks, offset, "mu_position", way, means=means))
        ref = BodyPoint(pivot, pivot), BodyPoint(hinge, moving_name(b, pair.guide, hinge, g.first))
        b.place_points(Body(b.mechanism.link(g.first), ref[0], b.axis_along(pair, g.first, along), g.first, ref))
        place_slider(b, pair, pair.mate(g.first), hinge, along)

    return length, place


def place_reached(b: Bodies, g: Group, length: str) -> None:
    """The hinge between what is driven, with the drive stopped one link of this length, and the link it moves."""
    hinge, pivot = g.inner.point, g.first_outer.point
    chains = {g.first: chain_to(hinge, pivot, length)}
    if g.kind == 1:
        own = b.length(b.mechanism.link(g.last), g.last_outer.point, hinge)
        chains[g.last] = chain_to(hinge, g.last_outer.point, own)
    else:
        start, direction = on_line(b, g.last_outer, g.last, hinge)
        chains[g.last] = chain_to(hinge, start, along=direction)
    one, two = (chains[link] for link in (g.links if g.kind == 1 else (g.first, g.last)))
    b.draft.draw(Equation(SCHEME, (one, two), f"r_{hinge}", side_of(b, hinge, g)))
    if g.kind == 1:
        b.place_points(rigid_body(b, g.last, g.last_outer.point, hinge))
    else:
        place_slider(b, g.last_outer, g.last, hinge, direction)


@dataclass(frozen=True)
class Elbow:
    """Two links with a motor in the hinge between them, drawn aside from the ``pivot``, the first one's axis level: how
    far the ``hinge`` is from the pivot, and the marks there."""

    group: Group
    motor: str
    pivot: str
    hinge: str
    length: str
    aside: tuple[str, str, str]  # the pivot, the motor, the hinge

    def place(self, b: Bodies) -> None:
        """Both links where they are, by similarity with what is drawn aside."""
        g, start, end = self.group, at(SCHEME, self.pivot), at(SCHEME, self.hinge)
        assert g.drive
        centre, motor, hinge = self.aside
        shape = (centre, motor), (centre, hinge), (start, end)
        b.draft.step(Image(at(SCHEME, self.motor), start, *shape))
        first, second = g.first, g.drive.mate(g.first)
        body = rigid_body(b, first, self.pivot, self.motor)
        b.place_points(body)
        under = BodyPoint(self.hinge, moving_name(b, "", self.hinge, first))
        body.ref, body.rigid = (BodyPoint(self.pivot, self.pivot), under), False
        b.place_points(rigid_body(b, second, self.motor, self.hinge))


def _elbow(b: Bodies, g: Group, pair: Pair, start: str) -> Elbow:
    d, drive, second = b.draft, b.mechanism.drive, b.mechanism.link(pair.mate(g.first))
    pivot, motor, hinge = g.first_outer.point, pair.point, g.inner.point
    first, turn = b.mechanism.link(g.first), d.give(f"angle_x_{drive.link}", drive.position)
    if drive.link == g.first:
        turn = d.product(f"-angle_x_{drive.link}", -1.0, **{turn: 1})
    level, helper = d.aim("→", 0.0, Meaning("given", g.first)), Meaning("guide", motor)
    way = angle_deg(b.shape, OwnPlace(g.first, pivot), OwnPlace(g.first, motor))
    one = d.turn(f"→{pivot}{motor}", level, way, Meaning("given", pivot))
    turned = d.step(Turn(f"→{second.name}", level, 0, turn, means=Meaning("given", motor)))
    way = angle_deg(b.shape, OwnPlace(second.name, motor), OwnPlace(second.name, hinge))
    two = d.turn(f"→{motor}{hinge}", turned, way, Meaning("given", motor))
    elbow = d.lay_off(SCHEME, f"{motor}°{pivot}", start, one, b.length(first, pivot, motor), helper)
    end = d.lay_off(SCHEME, f"{hinge}°{pivot}", elbow, two, b.length(second, motor, hinge), helper)
    return Elbow(g, motor, pivot, hinge, d.measure(f"l_{pivot}{hinge}", start, end), (start, elbow, end))


def cylinder(b: Bodies, pair: Pair, ends: tuple[str, str], pivot: str, start: str = "") -> tuple[str, str | None, str]:
    """How far its hinges, of the guide's link and of the slider, are apart along the guide and across it, and as they
    lie, which is drawn aside from the ``start`` on the frame (the ``pivot``): names of values, SI."""
    d, carrier, slider = b.draft, b.mechanism.link(pair.other), b.mechanism.link(pair.link)
    guide, origin = carrier.guides[pair.guide], OwnPlace(carrier.name, guide=pair.guide)
    foot, pin = OwnPlace(slider.name, slider.first_point), OwnPlace(slider.name, ends[1])
    more = difference(
        along(b.shape, foot, pin, -leaning(b.shape, slider.name)),
        along(b.shape, origin, OwnPlace(carrier.name, ends[0]), guided(b.shape, pair.guide)),
    )
    reach = d.give("s", b.mechanism.drive.position)
    if ends != (guide.through_point, slider.first_point):
        apart = ends[1] + ends[0]
        assert more
        own = d.reckon(f"s_{apart}_given", more, Meaning("offset", *ends[::-1]))
        reach = d.total(f"s_{apart}", [Product(1.0, ((reach, 1),)), Product(1.0, ((own, 1),))])
    across = difference(b.offset(pair, slider.name, ends[1]), b.offset(pair, carrier.name, ends[0]))
    name = f"l_{pivot}{ends[1 - ends.index(pivot)]}"
    if across is None:
        return reach, None, d.step(SizeOf(name, reach))
    offset, helper = d.reckon(f"e_{''.join(ends)}", across, Meaning("offset", *ends)), Meaning("guide", pair.guide)
    level = d.aim("→", 0.0, Meaning("given", pair.guide))
    start = start or at(SCHEME, pivot)
    reached = d.lay_off(SCHEME, f"{pivot}°{pair.guide}", start, level, reach, helper)
    end = d.lay_off(SCHEME, f"{pivot}⊥{pair.guide}′", reached, d.square(level), offset, helper)
    return reach, offset, d.measure(name, start, end)
