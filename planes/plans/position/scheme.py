"""The scheme: the frame, the driver in its position, and the groups in the order of attachment."""

from planes.plans.assur.basic_chains import BasicChain
from planes.plans.assur.basic_links import Triad
from planes.plans.assur.groups import Group
from planes.plans.position.bodies import SCHEME, Bodies, Body, BodyPoint
from planes.plans.position.braces import place_braced
from planes.plans.position.contour_scheme import place_contour
from planes.plans.position.driven_positions import place_driven
from planes.plans.position.positions import PLACERS, place_slider
from planes.plans.position.slid_groups import BaseAside, place_slid
from planes.plans.position.triads import place_chain, place_triad
from planes.scene.mechanism import FRAME
from planes.words.names import POLE, Meaning

APART = 1e-9  # relative: two points of a link closer than this coincide, and do not show its rotation


def place_all(b: Bodies) -> None:
    """Draw the scheme: the frame, the driver in its position, the groups in the order of attachment."""
    b.draft.pole(SCHEME)
    frame = b.mechanism.frame
    for name, place in frame.points.items():
        b.draft.put(SCHEME, name, place)
    b.known[FRAME] = Body(frame, BodyPoint(POLE, POLE), "", FRAME)
    if not b.structure.inner_drive:
        _place_driver(b)
    for group in b.structure.groups:
        if isinstance(group, Group):
            braced = place_braced if group.brace else place_driven
            (braced if group.drive else PLACERS[group.kind])(b, group)
            if stands(b, group):
                b.standing |= {*group.links}
                for link in group.links:
                    b.known[link].root = FRAME
        elif isinstance(group, Triad):
            (place_slid if group.slid else place_triad)(b, group)
        elif isinstance(group, BasicChain):
            place_chain(b, group)
        elif group.slid:
            BaseAside(b, group).place()
        else:
            place_contour(b, group)


def stands(b: Bodies, g: Group) -> bool:
    """Whether both links of a dyad have hinges on fixed links; then they are fixed too."""
    if g.drive or any(pair.kind == "P" for pair in g.pairs):
        return False
    return {g.first_outer.mate(g.first), g.last_outer.mate(g.last)} <= b.standing


def _place_driver(b: Bodies) -> None:
    drive, pair = b.mechanism.drive, b.structure.drive_pair
    link = b.mechanism.links[drive.link]
    if drive.rotates:
        axis = b.draft.aim(f"x_{link.name}", drive.position, Meaning("own", link.name))
        body = Body(link, BodyPoint(pair.point, pair.point), axis, link.name)
        b.place_points(body)
        second = _second_point(b, pair.point)
        if second:
            body.ref, body.rigid = (body.base, BodyPoint(second, second)), True
        return
    mark, direction = b.line(pair, FRAME)
    first = link.first_point
    counted = Meaning("guide", pair.guide, first)
    start = b.shifted(f"{first}°s", counted, mark, direction, b.offset(pair, link.name, first))
    b.draft.lay_off(SCHEME, first, start, direction, b.draft.give(drive.given, drive.position))
    place_slider(b, pair, link.name, first, direction)


def _second_point(b: Bodies, pivot: str) -> str | None:
    """The driver's point that starts the plans: one shared with another link, else any away from the pivot."""
    link = b.mechanism.links[b.mechanism.drive.link]
    centre = link.points[pivot]
    away = [p for p, z in link.points.items() if abs(z - centre) > APART * (abs(z) + abs(centre))]
    shared = [p for p in away if any(p in x.points for x in b.mechanism.links.values() if x is not link)]
    return next(iter(shared + away), None)
