"""The scheme: the frame, the driver in its position, and the groups in the order of attachment."""

from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group
from planes.plans.position.bodies import Bodies, Body, BodyPoint
from planes.plans.position.braces import place_braced
from planes.plans.position.contour_scheme import place_contour
from planes.plans.position.driven_positions import place_driven_links
from planes.plans.position.positions import PLACERS_BY_DYAD_KIND, place_slider
from planes.plans.position.slid_groups import BaseAside, place_slid_triad
from planes.plans.position.triads import place_basic_chain, place_triad
from planes.scene.mechanism import FRAME
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Meaning

COINCIDENT_POINTS_RATIO = 1e-9  # relative: two points of a link closer than this coincide, and do not show its rotation


def draw_scheme(b: Bodies) -> None:
    """Draw the scheme: the frame, the driver in its position, the groups in the order of attachment."""
    b.draft.draw_pole(SCHEME_PLAN)
    frame = b.mechanism.frame
    for name, place in frame.points.items():
        b.draft.draw_given_mark(SCHEME_PLAN, name, place)
    b.known[FRAME] = Body(frame, BodyPoint(POLE_LABEL, POLE_LABEL), "", FRAME)
    if not b.structure.has_inner_drive:
        _place_driver(b)
    for group in b.structure.groups:
        if isinstance(group, Group):
            braced = place_braced if group.brace else place_driven_links
            (braced if group.drive else PLACERS_BY_DYAD_KIND[group.kind])(b, group)
            if has_only_fixed_hinges(b, group):
                b.standing |= {*group.links}
                for link in group.links:
                    b.known[link].root = FRAME
        elif isinstance(group, Triad):
            (place_slid_triad if group.is_on_slides else place_triad)(b, group)
        elif isinstance(group, BasicChain):
            place_basic_chain(b, group)
        elif group.is_on_slides:
            BaseAside(b, group).draw_base_and_basic_link()
        else:
            place_contour(b, group)


def has_only_fixed_hinges(b: Bodies, g: Group) -> bool:
    """Whether both links of a dyad have hinges on fixed links; then they are fixed too."""
    if g.drive or any(pair.kind == "P" for pair in g.pairs):
        return False
    return {g.first_outer.other_link_of_pair(g.first), g.last_outer.other_link_of_pair(g.last)} <= b.standing


def _place_driver(b: Bodies) -> None:
    drive = b.mechanism.drive
    pair = b.structure.drive_pair
    link = b.mechanism.links[drive.link]
    if drive.rotates:
        axis = b.draft.draw_direction_at_angle(f"x_{link.name}", drive.position, Meaning("own", link.name))
        body = Body(link, BodyPoint(pair.point, pair.point), axis, link.name)
        b.draw_missing_points(body)
        second = _second_driver_point(b, pair.point)
        if second:
            body.ref = (body.base, BodyPoint(second, second))
            body.rigid = True
        return
    mark, direction = b.guide_mark_and_direction(pair, FRAME)
    first = link.first_point
    counted = Meaning("guide", pair.guide, first)
    start = b.shifted_mark(f"{first}°s", counted, mark, direction, b.point_offset_from_guide(pair, link.name, first))
    b.draft.lay_off(SCHEME_PLAN, first, start, direction, b.draft.add_given(drive.coordinate_name, drive.position))
    place_slider(b, pair, link.name, first, direction)


def _second_driver_point(b: Bodies, pivot: str) -> str | None:
    """The driver's point that starts the plans: one shared with another link, else any away from the pivot."""
    link = b.mechanism.links[b.mechanism.drive.link]
    centre = link.points[pivot]
    away = [p for p, z in link.points.items() if abs(z - centre) > COINCIDENT_POINTS_RATIO * (abs(z) + abs(centre))]
    shared = [p for p in away if any(p in x.points for x in b.mechanism.links.values() if x is not link)]
    return next(iter(shared + away), None)
