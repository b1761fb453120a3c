"""Position plans of dyads, each by arcs and lines (засечки), as vector equations for the drafting core."""

from planes.drafting.equations import Equation, Term
from planes.drafting.steps.crossings import Touch
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.contours import Contour
from planes.plans.assur.groups import Group, Pair
from planes.plans.position.bodies import SCHEME, AssemblyChoice, Bodies, Body, BodyPoint, on_scheme
from planes.plans.position.reckoned import OwnPlace, angle_deg, difference
from planes.scene.mechanism import Link
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import POLE, Meaning, label_of


def chain_to(name: str, start: str, length: str | None = None, along: str | None = None) -> tuple[Term, Term]:
    """The chain pole–start–end: the end on an arc, or somewhere along a line."""
    on = Term(f"{start}{name}", start, name, length, along, length or along or "")
    return Term(f"r_{start}", POLE, start, drawn=True), on


def on_line(b: Bodies, pair: Pair, link: str, point: str) -> tuple[str, str]:
    """Label of a mark, and direction, of the line along which a point of ``link`` moves in a solved pair."""
    mark, direction = b.line(pair, pair.mate(link))
    beside = Meaning("guide", pair.guide, point)
    shifted = b.shifted(f"{point}°{pair.guide}", beside, mark, direction, b.offset(pair, link, point))
    return label_of(shifted), direction


def side_of(b: Bodies, key: str, group: Group | Triad | Contour) -> str:
    """Name of the ±1 that chooses between the two assemblies of a group."""
    name = b.draft.give(f"side_{key}", 1.0)
    b.choices.append(AssemblyChoice(name, key, group))
    return name


def meet(
    b: Bodies, key: str, group: Group | Triad | Contour, ends: tuple[tuple[Term, ...], tuple[Term, ...]], label: str
) -> None:
    """Draw the point that both ends of a group reach, on the chosen side unless both move along lines."""
    one, two = ends
    side = None if one[-1].direction and two[-1].direction else side_of(b, key, group)
    b.draft.draw(Equation(SCHEME, ends, f"r_{label}", side))


def two_hinges(b: Bodies, name: str, one: str, two: str) -> Link:
    """Two hinges of a link in different places (:class:`SceneError` where there are none)."""
    link = b.mechanism.link(name)
    if link.points[one] == link.points[two]:
        line = b.mechanism.where.get(("links", name), b.mechanism.where.get(("links",)))
        raise SceneError(Phrase("hinges_coincide", link=name, one=one, two=two), b.file, line)
    return link


def rigid_body(b: Bodies, name: str, one: str, two: str) -> Body:
    """A link known by two of its points; its x axis is drawn from them."""
    link = two_hinges(b, name, one, two)
    angle = angle_deg(b.shape, OwnPlace(name, one), OwnPlace(name, two))
    axis = b.draft.turn(f"x_{name}", b.draft.ray(SCHEME, one, two), -angle, Meaning("own", name))
    spots = BodyPoint(one, one), BodyPoint(two, two)
    return Body(link, spots[0], axis, name, spots, rigid=True)


def _place_hinged(b: Bodies, g: Group) -> None:
    """RRR, RRP and PRP: each link reaches the inner hinge on an arc about a pivot or along a guide."""
    hinge = g.inner.point
    one, two = (chain_held(b, link, pair, hinge) for link, pair in g.hangs)
    meet(b, hinge, g, (one, two), hinge)
    for (link, pair), (*_, on) in zip(g.hangs, (one, two), strict=True):
        place_held(b, link, pair, hinge, on.direction)


def chain_held(b: Bodies, link: str, pair: Pair, hinge: str) -> tuple[Term, Term]:
    """The chain to a new hinge of a link: about the link's other hinge, or along its guide."""
    if pair.kind == "R":
        return chain_to(hinge, pair.point, b.length(b.mechanism.link(link), pair.point, hinge))
    start, direction = on_line(b, pair, link, hinge)
    return chain_to(hinge, start, along=direction)


def place_held(b: Bodies, link: str, pair: Pair, hinge: str, direction: str | None) -> None:
    """A link known by a hinge and by its other hinge, or by the ``direction`` of its guide."""
    if direction:
        place_slider(b, pair, link, hinge, direction)
    else:
        b.place_points(rigid_body(b, link, pair.point, hinge))


def place_slider(b: Bodies, pair: Pair, name: str, base: str, direction: str) -> None:
    """A link that cannot turn against its solved mate, known by one point."""
    axis = b.axis_along(pair, name, direction)
    root = b.known[pair.mate(name)].root
    b.place_points(Body(b.mechanism.link(name), BodyPoint(base, base), axis, root))


def _place_rpr(b: Bodies, g: Group) -> None:
    one, two, pair = g.first_outer.point, g.last_outer.point, g.inner
    offset = difference(b.offset(pair, g.first, one), b.offset(pair, g.last, two))
    given = None if offset is None else b.draft.reckon(f"e_{one}{two}", offset, Meaning("offset", one, two))
    side = b.reach.way if b.reach and b.structure.is_drive(g) else side_of(b, pair.guide, g)
    ends = on_scheme(two), on_scheme(one)
    means = Meaning("along", pair.guide)
    direction = b.draft.step(Touch(f"∥{pair.guide}", *ends, given, "mu_position", side, means=means))
    ref = BodyPoint(two, two), BodyPoint(one, moving_name(b, pair.guide, one, g.last))
    b.place_points(Body(b.mechanism.link(g.last), ref[0], b.axis_along(pair, g.last, direction), g.last, ref))
    place_slider(b, pair, g.first, one, direction)


def moving_name(b: Bodies, guide: str, point: str, link: str) -> str:
    """Name of the point of ``link`` that coincides with ``point``: the letter given with the guide, or "H2"."""
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
    shifted = label_of(b.shifted(f"{point}°{g.inner.guide}", beside, on_scheme(hinge), inner, apart))
    chains = chain_to(point, start, along=direction), chain_to(point, shifted, along=inner)
    b.draft.draw(Equation(SCHEME, chains, f"r_{point}"))
    root = b.known[g.last_outer.mate(g.last)].root
    reached = BodyPoint(hinge, moving_name(b, g.inner.guide, hinge, g.last))
    b.place_points(Body(b.mechanism.link(g.last), BodyPoint(point, point), axis, root, moving=reached))
    place_slider(b, g.inner, g.first, hinge, inner)


PLACERS = {1: _place_hinged, 2: _place_hinged, 3: _place_rpr, 4: _place_hinged, 5: _place_rpp}
