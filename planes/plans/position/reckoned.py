"""Quantities computed from a scene's numbers before the drawing, with their formulas, so that they can be computed
again for other dimensions of a link, or for decimals as written."""

from collections.abc import Callable, Iterable, Mapping
from typing import Any, NamedTuple

from planes.drafting.dimensions import Dimension
from planes.geometry.arithmetic import Arithmetic, Point
from planes.scene.mechanism import FRAME, Link, Mechanism

FLOAT_ARITHMETIC = Arithmetic()


class OwnPlace(NamedTuple):
    """A place on a link, in its own axes: a point, or the place of a guide."""

    link: str
    point: str = ""
    guide: str = ""


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


# "along" is how far from one point to another it goes in a direction, "height" how far a point lies to the left of the
# line through another in it; "ratio" (p - q) / (r - q): how a point stands to two others.
_DIMENSION_FORMULAS: Mapping[str, Callable[..., Any]] = {
    "-": lambda shape, ar, way: -recompute_dimension(way, shape, ar),
    "difference": lambda shape, ar, one, two: recompute_dimension(one, shape, ar) - recompute_dimension(two, shape, ar),
    "distance": lambda shape, ar, p, q: abs(shape.place(q) - shape.place(p)),
    "direction": lambda shape, ar, p, q: ar.angle_deg(shape.place(q) - shape.place(p)),
    "along": lambda shape, ar, p, q, way: (
        ((shape.place(q) - shape.place(p)) * _rotation_back_to_x(way, shape, ar)).real
    ),
    "ratio": lambda shape, ar, p, q, r: (shape.place(p) - shape.place(q)) / (shape.place(r) - shape.place(q)),
    "height": lambda shape, ar, p, q, way: (
        ((shape.place(p) - shape.place(q)) * _rotation_back_to_x(way, shape, ar)).imag
    ),
}


def recompute_dimension(how: tuple[Any, ...], shape: Any, ar: Arithmetic) -> Any:
    """What a dimension is of links that have this shape, in some arithmetic: by a way above, or as the shape says."""
    way, *what = how
    if way in _DIMENSION_FORMULAS:
        return _DIMENSION_FORMULAS[way](shape, ar, *what)
    return getattr(shape, way)(*what)


def _rotation_back_to_x(way: tuple[Any, ...], shape: Any, ar: Arithmetic) -> Point:
    """The turn from a direction back to x."""
    return ar.cis_deg(-recompute_dimension(way, shape, ar))


def dimension_difference(a: Dimension | None, b: Dimension | None) -> Dimension | None:
    """a - b, where None is an exact zero."""
    if b is None:
        return a
    if a is None:
        return -b
    return Dimension(a.value - b.value, ("difference", a.of, b.of))


def dimension_by_way(shape: SceneDimensions, way: str, *what: OwnPlace | str | Dimension) -> Dimension:
    """A dimension by its way, one of those above or a method of the shape, and what that is of."""
    how = (way, *(one.of if isinstance(one, Dimension) else one for one in what))
    return Dimension(recompute_dimension(how, shape, FLOAT_ARITHMETIC), how)


def direction_between_points(shape: SceneDimensions, p: OwnPlace, q: OwnPlace) -> Dimension:
    """The direction from one point to another, degrees."""
    angle = dimension_by_way(shape, "direction", p, q)
    return angle._replace(value=angle.value or 0.0)
