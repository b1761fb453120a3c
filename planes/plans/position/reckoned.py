"""What is reckoned of a scene's numbers before anything is drawn, each with how far off it may be: a decimal is off by
half of the last place of the double that stands for it, and so is every operation. And how it is reckoned, so that it
is again where a link's dimensions are changed.
"""

import math
from collections.abc import Iterable
from typing import NamedTuple, Protocol

from planes.drafting.dimensions import Dimension
from planes.geometry.arithmetic import Arithmetic, Point, Real
from planes.scene.mechanism import FRAME, Link, Mechanism

ARITHMETIC = Arithmetic()
HALF = 2.0**-53  # of a last place, at most, relative to the number


class OwnPlace(NamedTuple):
    """A place on a link, in its own axes: a point, or where a guide of it runs through."""

    link: str
    point: str = ""
    guide: str = ""


class Dimensions(Protocol):
    """The dimensions of links: places in their own axes (m), angles (degrees)."""

    def place(self, spot: OwnPlace) -> Point: ...
    def angle(self, guide: str) -> Real: ...
    def lean(self, slider: str) -> Real: ...
    def offset(self, slider: str) -> Real: ...


class SceneDimensions:
    """The dimensions as a scene has them."""

    def __init__(self, mechanism: Mechanism, passive: Iterable[Link] = ()) -> None:
        self.links = {FRAME: mechanism.frame, **mechanism.links, **{link.name: link for link in passive}}
        self.mechanism = mechanism

    def place(self, spot: OwnPlace) -> complex:
        """A place of a link in its own axes, m."""
        link = self.links[spot.link]
        return link.guides[spot.guide].through if spot.guide else link.points[spot.point]

    def angle(self, guide: str) -> float:
        """The direction of a guide in the axes of its link, degrees."""
        return self.mechanism.guide(guide).angle_deg

    def lean(self, slider: str) -> float:
        """How far the axes of a slider are turned from its guide, degrees."""
        slides = self.links[slider].slides
        return (slides.angle_deg if slides else None) or 0.0

    def offset(self, slider: str) -> float:
        """How far to the left of its guide a slider's first point lies, m."""
        slides = self.links[slider].slides
        return (slides.offset if slides else None) or 0.0


def difference(a: Dimension | None, b: Dimension | None) -> Dimension | None:
    """a - b, where None is a nothing that stays nothing."""
    if b is None:
        return a
    if a is None:
        return -b
    one, other = a.value, b.value
    off = a.off + b.off + (HALF * (abs(one) + 2 * abs(other)) if one and other else 0.0)
    return Dimension(one - other, off, lambda shape, ar: a.by(shape, ar) - b.by(shape, ar), ("difference", a.of, b.of))


def own(shape: SceneDimensions, p: OwnPlace) -> Dimension:
    """The place of a point on its link."""
    return Dimension(complex(shape.place(p)), 0.0, lambda shape, ar: shape.place(p), ("own", p))


def guided(shape: SceneDimensions, guide: str) -> Dimension:
    """The direction of a guide on its link, degrees."""
    return Dimension(shape.angle(guide), 0.0, lambda shape, ar: shape.angle(guide), ("guided", guide))


def leaning(shape: SceneDimensions, slider: str) -> Dimension:
    """How far the axes of a slider are turned from its guide, degrees."""
    return Dimension(shape.lean(slider), 0.0, lambda shape, ar: shape.lean(slider), ("leaning", slider))


def aside(shape: SceneDimensions, slider: str) -> Dimension:
    """How far to the left of its guide a slider's first point lies."""
    return Dimension(shape.offset(slider), 0.0, lambda shape, ar: shape.offset(slider), ("aside", slider))


def distance(shape: SceneDimensions, p: OwnPlace, q: OwnPlace) -> Dimension:
    """The distance of two points."""
    one, two = shape.place(p), shape.place(q)
    way = two - one
    off = _apart(one, two) + (2 * HALF * abs(way) if way.real and way.imag else 0.0)
    return Dimension(abs(way), off, lambda shape, ar: abs(shape.place(q) - shape.place(p)), ("distance", p, q))


def angle_deg(shape: SceneDimensions, p: OwnPlace, q: OwnPlace) -> Dimension:
    """The direction from one point to another, degrees."""
    one, two = shape.place(p), shape.place(q)
    return Dimension(
        *_direction(one, two), lambda shape, ar: ar.angle_deg(shape.place(q) - shape.place(p)), ("angle", p, q)
    )


def along(shape: SceneDimensions, p: OwnPlace, q: OwnPlace, way: Dimension) -> Dimension:
    """How far from one point to another it goes in a direction."""
    one, two = shape.place(p), shape.place(q)
    found, off = ((two - one) * ARITHMETIC.cis_deg(-way.value)).real, _apart(one, two) + _turned(two - one, way)

    def by(shape: Dimensions, ar: Arithmetic) -> Real:
        return ((shape.place(q) - shape.place(p)) * ar.cis_deg(-way.by(shape, ar))).real

    return Dimension(found, off, by, ("along", p, q, way.of))


def ratio(shape: SceneDimensions, p: OwnPlace, q: OwnPlace, r: OwnPlace) -> Dimension:
    """(p - q) / (r - q): how a point stands to two others."""
    one, two, three = (shape.place(spot) for spot in (p, q, r))
    found, base = (one - two) / (three - two), abs(three - two)
    rounded = 6 if one.imag or two.imag or three.imag else 1
    off = (_apart(one, two) + abs(found) * _apart(three, two)) / base + rounded * HALF * abs(found)

    def by(shape: Dimensions, ar: Arithmetic) -> Point:
        return (shape.place(p) - shape.place(q)) / (shape.place(r) - shape.place(q))

    return Dimension(found, off, by, ("ratio", p, q, r))


def height(shape: SceneDimensions, p: OwnPlace, q: OwnPlace, way: Dimension) -> Dimension:
    """How far a point lies to the left of the line through another in a direction."""
    one, two = shape.place(p), shape.place(q)
    apart = one - two
    off = _apart(one, two) + _turned(apart, way)

    def by(shape: Dimensions, ar: Arithmetic) -> Real:
        return ((shape.place(p) - shape.place(q)) * ar.cis_deg(-way.by(shape, ar))).imag

    return Dimension((apart * ARITHMETIC.cis_deg(-way.value)).imag, off, by, ("height", p, q, way.of))


def _direction(p: complex, q: complex) -> tuple[float, float]:
    """The direction of a point from another, degrees, and how far off it may be."""
    way = q - p
    if not way:
        return 0.0, 0.0
    if not (p.imag or q.imag):  # along the link's own axis
        return (0.0, 0.0) if way.real > 0 else (180.0, 0.0)
    angle = ARITHMETIC.angle_deg(way)
    return angle, math.degrees(_apart(p, q) / abs(way)) + 4 * HALF * abs(angle)


def _turned(apart: complex, way: Dimension) -> float:
    """How far off what is taken along or across a direction is for turning to it."""
    return HALF * abs(apart) * ((abs(math.radians(way.value)) + 6) if way.value % 90 else 0.0)


def _apart(p: complex, q: complex) -> float:
    """How far off a difference of two places is, the decimals of both and its own rounding together."""
    return HALF * (abs(p) + abs(q) + (abs(p - q) if p and q else 0.0))
