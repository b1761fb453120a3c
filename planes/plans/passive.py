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

from planes.drafting.drawing import run
from planes.drafting.instruments import InLists
from planes.geometry.listed import Listed
from planes.scene.mechanism import FRAME, Assembly, Link, Mechanism
from planes.words.errors import PlanesError, SceneError
from planes.words.names import at

Stated = TypeVar("Stated", bound=Any)  # the plans of a mechanism
NEAR_DEG, NEAR = 20.0, 0.1  # how far the driver is moved either way, relative to the mechanism's size if it slides
PLACES = 21  # driver positions on either side where the distances are checked
LEAST = 5  # of them, those at which the mechanism must assemble
SAME = 1e-9  # relative to the mechanism's size
MOST, TRIED = 2, 40  # passive links left out together, and how many such choices are tried


def without_passive(mechanism: Mechanism, freedom: int, stated: Callable[[Mechanism], Stated]) -> Stated | None:
    """The plans of a mechanism of W = ``freedom`` without its passive links, as ``stated`` states them; None where it
    has none. Each link removed adds one freedom."""
    links = [link for link in reversed(list(mechanism.links.values())) if _may_go(mechanism, link)]
    count = 1 - freedom
    for gone in islice(combinations(links, count), TRIED) if 0 < count <= MOST else ():
        for plans in _assembled(_without(mechanism, gone), stated):
            if all(_held(plans, link) for link in gone):
                named = replace(plans.structure, passive=tuple(link.name for link in gone))
                return replace(plans, structure=named, passive=gone)
    return None


def _assembled(mechanism: Mechanism, stated: Callable[[Mechanism], Stated]) -> Iterator[Stated]:
    """The plans in every assembly of the groups for which the scene gives none: the link left out would decide."""
    try:
        yield stated(mechanism)
    except SceneError as error:
        for offer in error.parts.get("offers", ()):
            said = {offer.parts["key"]: Assembly(order=offer.parts["word"])}
            yield from _assembled(replace(mechanism, assembly={**mechanism.assembly, **said}), stated)
    except PlanesError:
        return


def _may_go(mechanism: Mechanism, link: Link) -> bool:
    """Whether a link only holds: two pairs, no mass, no load, no guide on it."""
    loaded = any(link.name == load.link for load in mechanism.loads)
    held = len(list(_hinges(mechanism, link))) + bool(link.slides)
    on_frame = link.slides is None or mechanism.owner(link.slides.guide) == FRAME
    idle = not (link.mass or link.inertia or link.guides or loaded)
    return idle and held == 2 and on_frame and link.name != mechanism.drive.link


def _hinges(mechanism: Mechanism, link: Link) -> Iterator[str]:
    """The points of a link shared with other links."""
    others = [x for x in mechanism.bodies if x is not link]
    return (p for p in link.points if any(p in x.points for x in others))


def _without(mechanism: Mechanism, gone: Sequence[Link]) -> Mechanism:
    """The mechanism without some links, and without the assemblies of points that go with them."""
    links = {name: x for name, x in mechanism.links.items() if x not in gone}
    points = {p for x in (mechanism.frame, *links.values()) for p in x.points}
    kept = {name: how for name, how in mechanism.assembly.items() if name in points or name not in mechanism.names}
    return replace(mechanism, links=MappingProxyType(links), assembly=MappingProxyType(kept))


def _held(plans: Any, link: Link) -> bool:
    """Whether the distance held by a link stays constant without it."""
    drive, points = plans.drive, [p for p in link.points if p in plans.mechanism.names]
    if len(points) != (1 if link.slides else 2):  # it is attached to another link left out
        return False
    program = plans.program.sliced([at("position", p) for p in points])
    reach = NEAR_DEG if drive.rotates else NEAR * plans.reach
    held = False
    for side in (1.0, -1.0):  # a dead point, beyond which the assembly changes, may be near
        values = Listed(drive.position + side * reach * k / (PLACES - 1) for k in range(PLACES))
        drawn = run(program, {**plans.given, "mu_position": 1.0, plans.drive_given: values}, InLists())
        apart = [x for x in _off(plans.mechanism, link, [drawn[at("position", p)] for p in points]) if x == x]
        held |= len(apart) >= LEAST and max(map(abs, apart)) <= SAME * plans.reach
    return held


def _off(mechanism: Mechanism, link: Link, spots: Sequence[Listed]) -> Listed:
    """The error of the distance that a link held."""
    if link.slides:
        guide = mechanism.guide(link.slides.guide)
        along = cmath.rect(1.0, math.radians(guide.angle_deg))
        return ((spots[0] - guide.through) * along.conjugate()).imag - (link.slides.offset or 0.0)
    one, other = (link.points[p] for p in link.points if p in mechanism.names)
    return abs(spots[1] - spots[0]) - abs(other - one)
