"""Passive constraints: links that repeat a constraint, so the mechanism moves the same without them.

By Chebyshev's count such a mechanism has W < 1; it moves all the same, for the count ignores dimensions (an
ellipsograph with its crank, a double parallelogram). A link of two pairs without loads is passive if the distance it
holds stays constant as the mechanism moves without it, in one of its assemblies.
"""

import cmath
import math
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from itertools import combinations, islice
from types import MappingProxyType
from typing import Any, TypeVar

from planes.drafting.drawing import draw_program
from planes.drafting.instruments import InLists
from planes.geometry.listed import Listed
from planes.scene.mechanism import FRAME, Assembly, Link, Mechanism
from planes.words.errors import PlanesError, SceneError
from planes.words.names import scheme_mark

Stated = TypeVar("Stated", bound=Any)  # the plans of a mechanism
# how far the driver is moved either way, relative to the mechanism's size if it slides
DRIVER_SHIFT_DEG = 20.0
DRIVER_SHIFT_RATIO = 0.1
DRIVER_POSITIONS_EACH_SIDE = 21  # driver positions on either side where the distances are checked
LEAST_ASSEMBLED_POSITIONS = 5  # of them, those at which the mechanism must assemble
DISTANCE_TOLERANCE_RATIO = 1e-9  # relative to the mechanism's size
MOST_PASSIVE_LINKS = 2  # passive links left out together
MOST_PASSIVE_CHOICES = 40  # choices of them that are tried


def plans_without_passive_links(
    mechanism: Mechanism, freedom: int, stated: Callable[[Mechanism], Stated]
) -> Stated | None:
    """The plans of a mechanism of W = ``freedom`` without its passive links, as ``stated`` states them; None where it
    has none. Each link removed adds one freedom."""
    links = [link for link in reversed(list(mechanism.links.values())) if _only_holds(mechanism, link)]
    count = 1 - freedom
    for gone in islice(combinations(links, count), MOST_PASSIVE_CHOICES) if 0 < count <= MOST_PASSIVE_LINKS else ():
        for plans in _plans_in_every_assembly(_mechanism_without_links(mechanism, gone), stated):
            if all(_keeps_distance_without_link(plans, link) for link in gone):
                named = replace(plans.structure, passive=tuple(link.name for link in gone))
                return replace(plans, structure=named, passive=gone)
    return None


def _plans_in_every_assembly(mechanism: Mechanism, stated: Callable[[Mechanism], Stated]) -> Iterator[Stated]:
    """The plans in every assembly of the groups for which the scene gives none: the link left out would decide."""
    try:
        yield stated(mechanism)
    except SceneError as error:
        for offer in error.phrase_parts.get("offers", ()):
            said = {offer.parts["key"]: Assembly(order=offer.parts["word"])}
            yield from _plans_in_every_assembly(replace(mechanism, assembly={**mechanism.assembly, **said}), stated)
    except PlanesError:
        return


def _only_holds(mechanism: Mechanism, link: Link) -> bool:
    """Whether a link only holds: two pairs, no mass, no load, no guide on it."""
    loaded = any(link.name == load.link for load in mechanism.loads)
    held = len(list(_points_shared_with_links(mechanism, link))) + bool(link.slides)
    on_frame = link.slides is None or mechanism.owner_of_guide(link.slides.guide) == FRAME
    idle = not (link.mass or link.inertia or link.guides or loaded)
    return idle and held == 2 and on_frame and link.name != mechanism.drive.link


def _points_shared_with_links(mechanism: Mechanism, link: Link) -> Iterator[str]:
    """The points of a link shared with other links."""
    others = [x for x in mechanism.bodies if x is not link]
    return (p for p in link.points if any(p in x.points for x in others))


def _mechanism_without_links(mechanism: Mechanism, gone: Sequence[Link]) -> Mechanism:
    """The mechanism without some links, and without the assemblies of points that go with them."""
    links = {name: x for name, x in mechanism.links.items() if x not in gone}
    points = {p for x in (mechanism.frame, *links.values()) for p in x.points}
    kept = {
        name: how for name, how in mechanism.assembly.items() if name in points or name not in mechanism.point_names
    }
    return replace(mechanism, links=MappingProxyType(links), assembly=MappingProxyType(kept))


def _keeps_distance_without_link(plans: Any, link: Link) -> bool:
    """Whether the distance held by a link stays constant without it."""
    drive = plans.drive
    points = [p for p in link.points if p in plans.mechanism.point_names]
    if len(points) != (1 if link.slides else 2):  # it is attached to another link left out
        return False
    program = plans.program.cut_to_names([scheme_mark(p) for p in points])
    reach = DRIVER_SHIFT_DEG if drive.rotates else DRIVER_SHIFT_RATIO * plans.longest_link_length
    held = False
    for side in (1.0, -1.0):  # a dead point, beyond which the assembly changes, may be near
        values = Listed(
            drive.position + side * reach * k / (DRIVER_POSITIONS_EACH_SIDE - 1)
            for k in range(DRIVER_POSITIONS_EACH_SIDE)
        )
        drawn = draw_program(program, {**plans.given, "mu_position": 1.0, plans.drive_given_name: values}, InLists())
        apart = [x for x in _distance_error(plans.mechanism, link, [drawn[scheme_mark(p)] for p in points]) if x == x]
        held |= (
            len(apart) >= LEAST_ASSEMBLED_POSITIONS
            and max(map(abs, apart)) <= DISTANCE_TOLERANCE_RATIO * plans.longest_link_length
        )
    return held


def _distance_error(mechanism: Mechanism, link: Link, spots: Sequence[Listed]) -> Listed:
    """The error of the distance that a link held."""
    if link.slides:
        guide = mechanism.guide(link.slides.guide)
        along = cmath.rect(1.0, math.radians(guide.angle_deg))
        return ((spots[0] - guide.through) * along.conjugate()).imag - (link.slides.offset or 0.0)
    one, other = (link.points[p] for p in link.points if p in mechanism.point_names)
    return abs(spots[1] - spots[0]) - abs(other - one)
