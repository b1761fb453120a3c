"""Position plans of dyads, each by arcs and lines (засечки), as vector equations for the drafting core."""

from planes.drafting.equations import Chain, Equation, Term
from planes.drafting.steps.crossings import Touch
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.contours import Contour
from planes.plans.assur.groups import Group, Pair
from planes.plans.position.bodies import AssemblyChoice, Bodies, Body, BodyPoint
from planes.plans.position.reckoned import OwnPlace, dimension_difference, direction_between_points
from planes.scene.mechanism import Link
from planes.words import Phrase
from planes.words.errors import SceneError
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Meaning, NamePair, scheme_mark


def chain_through_start(
    name: str, start: str, length: str | None = None, along: str | None = None
) -> tuple[Term, Term]:
    """The chain pole–start–end: the end on an arc, or somewhere along a line."""
    on = Term(f"{start}{name}", start, name, length, along, length or along or "")
    return Term(f"r_{start}", POLE_LABEL, start, drawn=True), on


def line_of_point_in_pair(b: Bodies, pair: Pair, link: str, point: str) -> NamePair:
    """Label of a mark, and direction, of the line along which a point of ``link`` moves in a solved pair."""
    mark, direction = b.guide_mark_and_direction(pair, pair.other_link_of_pair(link))
    beside = Meaning("guide", pair.guide, point)
    shifted = b.shifted_mark(
        f"{point}°{pair.guide}", beside, mark, direction, b.point_offset_from_guide(pair, link, point)
    )
    return shifted.label, direction


def assembly_side_name(b: Bodies, key: str, group: Group | Triad | Contour) -> str:
    """Name of the ±1 that chooses between the two assemblies of a group."""
    name = b.draft.add_given(f"side_{key}", 1.0)
    b.choices.append(AssemblyChoice(name, key, group))
    return name


def draw_meeting_point(
    b: Bodies, key: str, group: Group | Triad | Contour, ends: tuple[Chain, Chain], label: str
) -> None:
    """Draw the point that both ends of a group reach, on the chosen side unless both move along lines."""
    one, two = ends
    side = None if one[-1].direction and two[-1].direction else assembly_side_name(b, key, group)
    b.draft.draw_equation(Equation(SCHEME_PLAN, ends, f"r_{label}", side))


def link_with_two_hinges(b: Bodies, name: str, one: str, two: str) -> Link:
    """Two hinges of a link in different places (:class:`SceneError` where there are none)."""
    link = b.mechanism.link(name)
    if link.points[one] == link.points[two]:
        line = b.mechanism.where.get(("links", name), b.mechanism.where.get(("links",)))
        raise SceneError(Phrase("hinges_coincide", link=name, one=one, two=two), b.file, line)
    return link


def body_by_two_points(b: Bodies, name: str, one: str, two: str) -> Body:
    """A link known by two of its points; its x axis is drawn from them."""
    link = link_with_two_hinges(b, name, one, two)
    angle = direction_between_points(b.link_dimensions, OwnPlace(name, one), OwnPlace(name, two))
    axis = b.draft.draw_turned_direction(
        f"x_{name}", b.draft.direction_between_marks(one, two), -angle, Meaning("own", name)
    )
    spots = BodyPoint(one, one), BodyPoint(two, two)
    return Body(link, spots[0], axis, name, spots, rigid=True)


def _place_hinged_dyad(b: Bodies, g: Group) -> None:
    """RRR, RRP and PRP: each link reaches the inner hinge on an arc about a pivot or along a guide."""
    hinge = g.inner.point
    one, two = (chain_to_new_hinge(b, link, pair, hinge) for link, pair in g.links_with_outer_pairs)
    draw_meeting_point(b, hinge, g, (one, two), hinge)
    for (link, pair), (*_, on) in zip(g.links_with_outer_pairs, (one, two), strict=True):
        place_link_by_hinge(b, link, pair, hinge, on.direction)


def chain_to_new_hinge(b: Bodies, link: str, pair: Pair, hinge: str) -> tuple[Term, Term]:
    """The chain to a new hinge of a link: about the link's other hinge, or along its guide."""
    if pair.kind == "R":
        return chain_through_start(hinge, pair.point, b.given_distance(b.mechanism.link(link), pair.point, hinge))
    start, direction = line_of_point_in_pair(b, pair, link, hinge)
    return chain_through_start(hinge, start, along=direction)


def place_link_by_hinge(b: Bodies, link: str, pair: Pair, hinge: str, direction: str | None) -> None:
    """A link known by a hinge and by its other hinge, or by the ``direction`` of its guide."""
    if direction:
        place_slider(b, pair, link, hinge, direction)
    else:
        b.draw_missing_points(body_by_two_points(b, link, pair.point, hinge))


def place_slider(b: Bodies, pair: Pair, name: str, base: str, direction: str) -> None:
    """A link that cannot turn against its solved mate, known by one point."""
    axis = b.link_axis_from_guide(pair, name, direction)
    root = b.known[pair.other_link_of_pair(name)].root
    b.draw_missing_points(Body(b.mechanism.link(name), BodyPoint(base, base), axis, root))


def _place_rpr_dyad(b: Bodies, g: Group) -> None:
    one = g.first_outer.point
    two = g.last_outer.point
    pair = g.inner
    offset = dimension_difference(
        b.point_offset_from_guide(pair, g.first, one), b.point_offset_from_guide(pair, g.last, two)
    )
    given = None if offset is None else b.draft.add_computed_given(f"e_{one}{two}", offset, Meaning("offset", one, two))
    side = b.reach.way if b.reach and b.structure.is_driving_cylinder(g) else assembly_side_name(b, pair.guide, g)
    ends = SCHEME_PLAN.marks(two, one)
    means = Meaning("along", pair.guide)
    direction = b.draft.add_step(Touch(f"∥{pair.guide}", *ends, given, "mu_position", side, means=means))
    ref = BodyPoint(two, two), BodyPoint(one, coincident_point_name(b, pair.guide, one, g.last))
    b.draw_missing_points(
        Body(b.mechanism.link(g.last), ref[0], b.link_axis_from_guide(pair, g.last, direction), g.last, ref)
    )
    place_slider(b, pair, g.first, one, direction)


def coincident_point_name(b: Bodies, guide: str, point: str, link: str) -> str:
    """Name of the point of ``link`` that coincides with ``point``: the letter given with the guide, or "H2"."""
    name = b.mechanism.guide(guide).mark if guide and b.mechanism.owner_of_guide(guide) == link else None
    taken = {*b.mechanism.point_names, *b.specials.values(), POLE_LABEL}
    here = point, link
    if not name or name in taken or b.coincident.get(name, here) != here:
        name = f"{point}{link}"
        while name in taken or b.coincident.get(name, here) != here:
            point += "_"
            name = f"{point}{link}"
    b.coincident[name] = here
    return name


def _place_rpp_dyad(b: Bodies, g: Group) -> None:
    hinge = g.first_outer.point
    point = b.mechanism.link(g.last).first_point
    start, direction = line_of_point_in_pair(b, g.last_outer, g.last, point)
    axis = b.link_axis_from_guide(g.last_outer, g.last, direction)
    inner = b.guide_direction_from_axis(g.inner, g.last, axis)
    apart = dimension_difference(
        b.point_offset_from_guide(g.inner, g.last, point), b.point_offset_from_guide(g.inner, g.first, hinge)
    )
    beside = Meaning("guide", g.inner.guide, point)
    shifted = b.shifted_mark(f"{point}°{g.inner.guide}", beside, scheme_mark(hinge), inner, apart).label
    chains = chain_through_start(point, start, along=direction), chain_through_start(point, shifted, along=inner)
    b.draft.draw_equation(Equation(SCHEME_PLAN, chains, f"r_{point}"))
    root = b.known[g.last_outer.other_link_of_pair(g.last)].root
    reached = BodyPoint(hinge, coincident_point_name(b, g.inner.guide, hinge, g.last))
    b.draw_missing_points(Body(b.mechanism.link(g.last), BodyPoint(point, point), axis, root, moving=reached))
    place_slider(b, g.inner, g.first, hinge, inner)


PLACERS_BY_DYAD_KIND = {
    1: _place_hinged_dyad,
    2: _place_hinged_dyad,
    3: _place_rpr_dyad,
    4: _place_hinged_dyad,
    5: _place_rpp_dyad,
}
