"""Position plans of dyads, each by засечки, as vector equations for the drafting core."""

from dataclasses import dataclass

from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Image, Turn
from planes.drafting.steps.crossings import Touch
from planes.drafting.steps.reckoning import Product, SenseOf, SizeOf
from planes.plans.bodies import SCHEME, AssemblyChoice, Bodies, Body, BodyPoint
from planes.plans.groups import Group, Pair
from planes.plans.reckoned import HALF, along, angle_deg, difference
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import POLE, Meaning, at, label_of


def _chain(name: str, start: str, length: str | None = None, along: str | None = None) -> tuple[Term, Term]:
    """The chain pole–start–end: the end by compass, or somewhere along a line."""
    on = Term(f"{start}{name}", start, name, length, along, length or along or "")
    return Term(f"r_{start}", POLE, start, drawn=True), on


def on_line(b: Bodies, pair: Pair, link: str, point: str) -> tuple[str, str]:
    """Label of a mark, and direction, of the line that a point of ``link`` runs along in a solved pair."""
    mark, direction = b.line(pair, pair.mate(link))
    beside = Meaning("guide", pair.guide, point)
    shifted = b.shifted(f"{point}°{pair.guide}", beside, mark, direction, b.offset(pair, link, point))
    return label_of(shifted), direction


def _side(b: Bodies, key: str, group: Group) -> str:
    """Name of the ±1 that chooses between the two assemblies of a group."""
    name = b.draft.give(f"side_{key}", 1.0)
    b.choices.append(AssemblyChoice(name, key, group))
    return name


def rigid_body(b: Bodies, name: str, one: str, two: str) -> Body:
    """A link known by two of its points; its x axis is drawn from them."""
    link = b.mechanism.link(name)
    places = link.points[one], link.points[two]
    if places[0] == places[1]:
        line = b.mechanism.where.get(("links", name), b.mechanism.where.get(("links",)))
        raise SceneError(Phrase("hinges_coincide", link=name, one=one, two=two), b.file, line)
    angle, off = angle_deg(*places)
    axis = b.draft.turn(f"x_{name}", b.draft.ray(SCHEME, one, two), -angle, off, Meaning("own", name))
    spots = BodyPoint(one, one), BodyPoint(two, two)
    return Body(link, spots[0], axis, name, spots, rigid=True)


def _place_hinged(b: Bodies, g: Group) -> None:
    """RRR, RRP and PRP: each link reaches the inner hinge about a pivot or along a guide."""
    hinge, legs = g.inner.point, ((g.first_outer, g.first), (g.last_outer, g.last))
    lines = {link: on_line(b, pair, link, hinge) for pair, link in legs if pair.kind == "P"}
    one, two = (
        _chain(hinge, lines[link][0], along=lines[link][1])
        if link in lines
        else _chain(hinge, pair.point, b.length(b.mechanism.link(link), pair.point, hinge))
        for pair, link in legs
    )
    side = None if len(lines) == 2 else _side(b, hinge, g)
    b.draft.draw(Equation(SCHEME, (one, two), f"r_{hinge}", side))
    for pair, link in legs:
        if link in lines:
            place_slider(b, pair, link, hinge, lines[link][1])
        else:
            b.place_points(rigid_body(b, link, pair.point, hinge))


def place_driven(b: Bodies, g: Group) -> None:
    """The two links of a drive and the one they move: how far apart their hinges are, that is a засечка with it."""
    assert g.drive
    hinge, pivot = g.inner.point, g.first_outer.point
    if g.drive.kind == "R":
        elbow = _elbow(b, g, g.drive)
        place_reached(b, g, elbow.length)
        elbow.place(b)
        return
    pair, ends = g.drive, (pivot, hinge) if g.first == g.drive.other else (hinge, pivot)
    reach, offset, length = cylinder(b, pair, ends, pivot)
    place_reached(b, g, length)
    means, marks = Meaning("along", pair.guide), (at(SCHEME, ends[0]), at(SCHEME, ends[1]))
    way = b.draft.step(SenseOf(f"way_{pair.guide}", reach))
    along = b.draft.step(Touch(f"∥{pair.guide}", *marks, offset, "mu_position", way, means=means))
    ref = BodyPoint(pivot, pivot), BodyPoint(hinge, moving_name(b, pair.guide, hinge, g.first))
    b.place_points(Body(b.mechanism.link(g.first), ref[0], b.axis_along(pair, g.first, along), g.first, ref))
    place_slider(b, pair, pair.mate(g.first), hinge, along)


def place_reached(b: Bodies, g: Group, length: str) -> None:
    """The hinge between what is driven, with the drive stopped one link of this length, and the link it moves."""
    hinge, pivot = g.inner.point, g.first_outer.point
    chains = {g.first: _chain(hinge, pivot, length)}
    if g.kind == 1:
        own = b.length(b.mechanism.link(g.last), g.last_outer.point, hinge)
        chains[g.last] = _chain(hinge, g.last_outer.point, own)
    else:
        start, direction = on_line(b, g.last_outer, g.last, hinge)
        chains[g.last] = _chain(hinge, start, along=direction)
    one, two = (chains[link] for link in (g.links if g.kind == 1 else (g.first, g.last)))
    b.draft.draw(Equation(SCHEME, (one, two), f"r_{hinge}", _side(b, hinge, g)))
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
    aside: tuple[str, str]

    def place(self, b: Bodies) -> None:
        """Both links where they are, by similarity with what is drawn aside."""
        g, start, end = self.group, at(SCHEME, self.pivot), at(SCHEME, self.hinge)
        assert g.drive
        shape = (start, self.aside[0]), (start, self.aside[1]), (start, end)
        b.draft.step(Image(at(SCHEME, self.motor), start, *shape))
        first, second = g.first, g.drive.mate(g.first)
        body = rigid_body(b, first, self.pivot, self.motor)
        b.place_points(body)
        under = BodyPoint(self.hinge, moving_name(b, "", self.hinge, first))
        body.ref, body.rigid = (BodyPoint(self.pivot, self.pivot), under), False
        b.place_points(rigid_body(b, second, self.motor, self.hinge))


def _elbow(b: Bodies, g: Group, pair: Pair) -> Elbow:
    d, drive, second = b.draft, b.mechanism.drive, b.mechanism.link(pair.mate(g.first))
    pivot, motor, hinge = g.first_outer.point, pair.point, g.inner.point
    first, turn = b.mechanism.link(g.first), d.give(f"angle_x_{drive.link}", drive.position)
    if drive.link == g.first:
        turn = d.product(f"-angle_x_{drive.link}", -1.0, **{turn: 1})
    level, helper = d.aim("→", 0.0, Meaning("given", g.first)), Meaning("guide", motor)
    ways = angle_deg(first.points[pivot], first.points[motor]), angle_deg(second.points[motor], second.points[hinge])
    one = d.turn(f"→{pivot}{motor}", level, *ways[0], Meaning("given", pivot))
    turned = d.step(Turn(f"→{second.name}", level, 0, turn, means=Meaning("given", motor)))
    two = d.turn(f"→{motor}{hinge}", turned, *ways[1], Meaning("given", motor))
    elbow = d.lay_off(SCHEME, f"{motor}°{pivot}", at(SCHEME, pivot), one, b.length(first, pivot, motor), helper)
    end = d.lay_off(SCHEME, f"{hinge}°{pivot}", elbow, two, b.length(second, motor, hinge), helper)
    return Elbow(g, motor, pivot, hinge, d.measure(f"l_{pivot}{hinge}", at(SCHEME, pivot), end), (elbow, end))


def cylinder(b: Bodies, pair: Pair, ends: tuple[str, str], pivot: str, start: str = "") -> tuple[str, str | None, str]:
    """How far its hinges, of the guide's link and of the slider, are apart along the guide and across it, and as they
    lie, which is drawn aside from the ``start`` on the frame (the ``pivot``): names of values, SI."""
    d, carrier, slider = b.draft, b.mechanism.link(pair.other), b.mechanism.link(pair.link)
    guide, angle = carrier.guides[pair.guide], slider.slides.angle_deg if slider.slides else None
    more = along(slider.points[ends[1]] - slider.points[slider.first_point], -(angle or 0.0))
    more -= along(carrier.points[ends[0]] - guide.through, guide.angle_deg)
    reach = d.give("s", b.mechanism.drive.position)
    if ends != (guide.through_point, slider.first_point):
        apart = ends[1] + ends[0]
        own = d.give(f"s_{apart}_given", more, 8 * HALF * abs(more), Meaning("offset", *ends[::-1]))
        reach = d.total(f"s_{apart}", [Product(1.0, ((reach, 1),)), Product(1.0, ((own, 1),))])
    across = difference(b.offset(pair, slider.name, ends[1]), b.offset(pair, carrier.name, ends[0]))
    name = f"l_{pivot}{ends[1 - ends.index(pivot)]}"
    if across is None:
        return reach, None, d.step(SizeOf(name, reach))
    offset, helper = d.give(f"e_{''.join(ends)}", *across, Meaning("offset", *ends)), Meaning("guide", pair.guide)
    level = d.aim("→", 0.0, Meaning("given", pair.guide))
    start = at(SCHEME, start or pivot)
    foot = d.lay_off(SCHEME, f"{pivot}°{pair.guide}", start, level, reach, helper)
    end = d.lay_off(SCHEME, f"{pivot}⊥{pair.guide}′", foot, d.square(level), offset, helper)
    return reach, offset, d.measure(name, start, end)


def place_slider(b: Bodies, pair: Pair, name: str, base: str, direction: str) -> None:
    """A link that cannot turn against its solved mate, known by one point."""
    axis = b.axis_along(pair, name, direction)
    root = b.known[pair.mate(name)].root
    b.place_points(Body(b.mechanism.link(name), BodyPoint(base, base), axis, root))


def _place_rpr(b: Bodies, g: Group) -> None:
    one, two, pair = g.first_outer.point, g.last_outer.point, g.inner
    offset = difference(b.offset(pair, g.first, one), b.offset(pair, g.last, two))
    given = None if offset is None else b.draft.give(f"e_{one}{two}", *offset, Meaning("offset", one, two))
    side = b.reach.way if b.reach and b.structure.is_drive(g) else _side(b, pair.guide, g)
    ends = at(SCHEME, two), at(SCHEME, one)
    means = Meaning("along", pair.guide)
    direction = b.draft.step(Touch(f"∥{pair.guide}", *ends, given, "mu_position", side, means=means))
    name = moving_name(b, pair.guide, one, g.last)
    ref = BodyPoint(two, two), BodyPoint(one, name)
    b.place_points(Body(b.mechanism.link(g.last), ref[0], b.axis_along(pair, g.last, direction), g.last, ref))
    place_slider(b, pair, g.first, one, direction)


def moving_name(b: Bodies, guide: str, point: str, link: str) -> str:
    """Name of the point of ``link`` that coincides with ``point``: the letter the guide gives it, or "H2"."""
    name = b.mechanism.guide(guide).mark if guide and b.mechanism.owner(guide) == link else None
    taken = {*b.mechanism.names, *b.specials.values(), POLE}
    here = point, link
    if not name or name in taken or b.coincident.get(name, here) != here:
        name = f"{point}{link}"
        while name in taken or b.coincident.get(name, here) != here:
            point += "_"
            name = f"{point}{link}"
    b.coincident[name] = here
    return name


def _place_rpp(b: Bodies, g: Group) -> None:
    hinge, point = g.first_outer.point, b.mechanism.link(g.last).first_point
    start, direction = on_line(b, g.last_outer, g.last, point)
    axis = b.axis_along(g.last_outer, g.last, direction)
    inner = b.direction_from(g.inner, g.last, axis)
    apart = difference(b.offset(g.inner, g.last, point), b.offset(g.inner, g.first, hinge))
    beside = Meaning("guide", g.inner.guide, point)
    shifted = label_of(b.shifted(f"{point}°{g.inner.guide}", beside, at(SCHEME, hinge), inner, apart))
    chains = _chain(point, start, along=direction), _chain(point, shifted, along=inner)
    b.draft.draw(Equation(SCHEME, chains, f"r_{point}"))
    root = b.known[g.last_outer.mate(g.last)].root
    reached = BodyPoint(hinge, moving_name(b, g.inner.guide, hinge, g.last))
    b.place_points(Body(b.mechanism.link(g.last), BodyPoint(point, point), axis, root, moving=reached))
    place_slider(b, g.inner, g.first, hinge, inner)


PLACERS = {1: _place_hinged, 2: _place_hinged, 3: _place_rpr, 4: _place_hinged, 5: _place_rpp}
