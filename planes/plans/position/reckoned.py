"""Quantities computed from a scene's numbers before the drawing, with their formulas, so that they can be computed
again for other dimensions of a link, or for decimals as written."""

from collections.abc import Callable, Hashable, Iterable
from typing import Any, NamedTuple, Protocol

from planes.drafting.dimensions import Dimension
from planes.geometry.arithmetic import Arithmetic, Point, Real
from planes.scene.mechanism import FRAME, Link, Mechanism

ARITHMETIC = Arithmetic()


class OwnPlace(NamedTuple):
    """A place on a link, in its own axes: a point, or the place of a guide."""

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
    """The dimensions of a scene."""

    def __init__(self, mechanism: Mechanism, passive: Iterable[Link] = ()) -> None:
        self.links = {FRAME: mechanism.frame, **mechanism.links, **{link.name: link for link in passive}}
        self.mechanism = mechanism

    def taken(self, value: Any) -> Any:
        """A number or a place of the scene, as used in the calculation."""
        return value

    def place(self, spot: OwnPlace) -> Any:
        """A place of a link in its own axes, m."""
        link = self.links[spot.link]
        return self.taken(link.guides[spot.guide].through if spot.guide else link.points[spot.point])

    def angle(self, guide: str) -> Any:
        """The direction of a guide in the axes of its link, degrees."""
        return self.taken(self.mechanism.guide(guide).angle_deg)

    def lean(self, slider: str) -> Any:
        """The angle of a slider's axes from its guide, degrees."""
        slides = self.links[slider].slides
        return self.taken((slides.angle_deg if slides else None) or 0.0)

    def offset(self, slider: str) -> Any:
        """How far to the left of its guide a slider's first point lies, m."""
        slides = self.links[slider].slides
        return self.taken((slides.offset if slides else None) or 0.0)


def difference(a: Dimension | None, b: Dimension | None) -> Dimension | None:
    """a - b, where None is an exact zero."""
    if b is None:
        return a
    if a is None:
        return -b
    return Dimension(a.value - b.value, lambda shape, ar: a.by(shape, ar) - b.by(shape, ar), ("difference", a.of, b.of))


def _reckoned(shape: SceneDimensions, by: Callable[[Any, Arithmetic], Any], *what: Hashable) -> Dimension:
    return Dimension(by(shape, ARITHMETIC), by, what)


def own(shape: SceneDimensions, p: OwnPlace) -> Dimension:
    """The place of a point on its link."""
    return _reckoned(shape, lambda shape, ar: shape.place(p), "own", p)


def guided(shape: SceneDimensions, guide: str) -> Dimension:
    """The direction of a guide on its link, degrees."""
    return _reckoned(shape, lambda shape, ar: shape.angle(guide), "guided", guide)


def leaning(shape: SceneDimensions, slider: str) -> Dimension:
    """The angle of a slider's axes from its guide, degrees."""
    return _reckoned(shape, lambda shape, ar: shape.lean(slider), "leaning", slider)


def aside(shape: SceneDimensions, slider: str) -> Dimension:
    """How far to the left of its guide a slider's first point lies."""
    return _reckoned(shape, lambda shape, ar: shape.offset(slider), "aside", slider)


def distance(shape: SceneDimensions, p: OwnPlace, q: OwnPlace) -> Dimension:
    """The distance between two points."""
    return _reckoned(shape, lambda shape, ar: abs(shape.place(q) - shape.place(p)), "distance", p, q)


def angle_deg(shape: SceneDimensions, p: OwnPlace, q: OwnPlace) -> Dimension:
    """The direction from one point to another, degrees."""
    angle = _reckoned(shape, lambda shape, ar: ar.angle_deg(shape.place(q) - shape.place(p)), "angle", p, q)
    return angle._replace(value=angle.value or 0.0)


def along(shape: SceneDimensions, p: OwnPlace, q: OwnPlace, way: Dimension) -> Dimension:
    """The component along a direction of the vector between two points."""

    def by(shape: Dimensions, ar: Arithmetic) -> Real:
        return ((shape.place(q) - shape.place(p)) * ar.cis_deg(-way.by(shape, ar))).real

    return _reckoned(shape, by, "along", p, q, way.of)


def ratio(shape: SceneDimensions, p: OwnPlace, q: OwnPlace, r: OwnPlace) -> Dimension:
    """(p - q) / (r - q): the position of a point relative to two others."""

    def by(shape: Dimensions, ar: Arithmetic) -> Point:
        return (shape.place(p) - shape.place(q)) / (shape.place(r) - shape.place(q))

    return _reckoned(shape, by, "ratio", p, q, r)


def height(shape: SceneDimensions, p: OwnPlace, q: OwnPlace, way: Dimension) -> Dimension:
    """The distance of a point to the left of the line through another in a direction."""

    def by(shape: Dimensions, ar: Arithmetic) -> Real:
        return ((shape.place(p) - shape.place(q)) * ar.cis_deg(-way.by(shape, ar))).imag

    return _reckoned(shape, by, "height", p, q, way.of)
