"""Signs of kinematic schemes (ГОСТ 2.770) as marks: sizes in mm of paper, angles in degrees, y up.

A sign is a tuple of marks in drawing order.  Paper-filled ones (hinges, sliders) hide marks drawn before them;
``uncovered`` in ``ink`` turns that into lines really cut.  So the order is: guides, sliders, bars, hinges; then a bar
is visible up to the hinge within a slider, a guide only up to the slider.  The default layer is "scheme", for hatching
"hatch".
"""

import cmath
import math
from collections.abc import Sequence
from itertools import pairwise

from planes.geometry.plane import direction_between
from render.paper.marks import Arc, Hatch, Layer, Line, Mark, Shape
from render.paper.style import (
    BASE_HATCH_SPACING_MM,
    BASE_HATCHING_DEPTH_MM,
    BASE_LINE_LENGTH_MM,
    CLAMP_WALL_LENGTH_MM,
    DOT_RADIUS_MM,
    HINGE_LEG_LENGTH_MM,
    HINGE_RADIUS_MM,
    SLIDER_BLOCK_SIZE_MM,
    WHEEL_RADIUS_MM,
    arrowhead_corners,
    arrowhead_size,
    pen_of_style,
)

Marks = tuple[Mark, ...]
PLATE_HATCH_SPACING_MM = 3.0
GUSSET_SIDE_MM = 4.5
MOST_PARALLEL_SINE = 0.2  # the sine of an angle at which lines count as parallel


def unit_vector(angle_deg: float) -> complex:
    """The unit vector at an angle, exact at right angles."""
    quarter, rest = divmod(angle_deg, 90)
    if rest == 0:
        return (1 + 0j, 1j, -1 + 0j, -1j)[int(quarter) % 4]
    return cmath.rect(1, math.radians(angle_deg))


def hinge(at: complex) -> Marks:
    """A turning pair: a circle of paper."""
    return (Arc(at, HINGE_RADIUS_MM, fill="paper"),)


def hatching(at: complex, angle_deg: float, length: float, side: int = -1) -> Marks:
    """Oblique strokes along a line centred at ``at``, on its right (``side`` −1) or left (+1)."""
    along = unit_vector(angle_deg)
    count = max(2, round(length / BASE_HATCH_SPACING_MM))
    step = length / count
    slant = BASE_HATCHING_DEPTH_MM * (side * 1j - 1) * along
    starts = [at + (-length / 2 + step * (k + 1)) * along for k in range(count)]
    return tuple(Line((z, z + slant), "thin", "hatch") for z in starts)


def hatched_base(at: complex, angle_deg: float = 0, length: float = BASE_LINE_LENGTH_MM, side: int = -1) -> Marks:
    """A line of the frame centred at ``at``, hatched on its right (``side`` −1) or left (+1)."""
    half = length / 2 * unit_vector(angle_deg)
    return (*hatching(at, angle_deg, length, side), Line((at - half, at + half)))


def fixed_hinge(at: complex, angle_deg: float = 0) -> Marks:
    """A hinge on the frame: two legs from the circle to a hatched base; ``angle_deg`` is the base's."""
    foot = at - 1j * unit_vector(angle_deg) * HINGE_LEG_LENGTH_MM
    return (*hatched_base(foot, angle_deg), *hinge_legs(at, foot, angle_deg), *hinge(at))


def hinge_legs(at: complex, foot: complex, angle_deg: float) -> list[Line]:
    """Both legs of a hinge, from its circle to a base about the foot."""
    ends = (foot + side * 0.5 * HINGE_LEG_LENGTH_MM * unit_vector(angle_deg) for side in (-1, 1))
    return [Line((at + HINGE_RADIUS_MM * direction_between(at, end), end)) for end in ends]


def block(at: complex, angle_deg: float = 0, size: tuple[float, float] = SLIDER_BLOCK_SIZE_MM) -> Marks:
    """A slider centred on its guide."""
    along = unit_vector(angle_deg)
    long, wide = size
    corners = tuple(at + (x * long + 1j * y * wide) / 2 * along for x, y in ((-1, -1), (1, -1), (1, 1), (-1, 1)))
    return (Shape(corners, fill="paper"), Line(corners, closed=True))


def rail(at: complex, angle_deg: float, reach: float, side: int = -1, across: float = SLIDER_BLOCK_SIZE_MM[1]) -> Marks:
    """A guide of the frame along the long side of a slider at ``at``, ``reach`` mm to either end: on its right
    (``side`` −1) or left."""
    return hatched_base(at + side * 1j * across / 2 * unit_vector(angle_deg), angle_deg, 2 * reach, side)


def clamp_wall(at: complex, angle_deg: float = 0) -> Marks:
    """A clamp: a wall of the frame across the body that begins there at the angle."""
    return hatched_base(at, angle_deg + 90.0, CLAMP_WALL_LENGTH_MM, side=1)


def roller(at: complex, angle_deg: float = 0) -> Marks:
    """A hinge on wheels: it holds only perpendicular to its base, whose rotation is the angle."""
    along = unit_vector(angle_deg)
    both = hinge_legs(at, at - 1j * along * (HINGE_LEG_LENGTH_MM - 2 * WHEEL_RADIUS_MM), angle_deg)
    ends = [leg.points[1] for leg in both]
    wheels = (
        Arc(end - (x + 1j) * along * WHEEL_RADIUS_MM, WHEEL_RADIUS_MM, style="thin")
        for x, end in zip((-1, 1), ends, strict=True)
    )
    return (
        *hatched_base(at - 1j * along * HINGE_LEG_LENGTH_MM, angle_deg),
        Line(tuple(ends)),
        *both,
        *wheels,
        *hinge(at),
    )


def bar(*points: complex) -> Marks:
    """A link as a thick line through its points."""
    return (Line(tuple(points)),)


def plate(points: Sequence[complex]) -> Marks:
    """A rigid link with three or more hinges: a polygon, hatched by ГОСТ 2.306, the other way where an edge is parallel
    to the strokes."""
    edges = (b - a for a, b in pairwise((*points, points[0])))
    alike = any(abs((way * unit_vector(-45)).imag) < MOST_PARALLEL_SINE * abs(way) for way in edges)
    return (Hatch(tuple(points), 135.0 if alike else 45.0, PLATE_HATCH_SPACING_MM), Line(tuple(points), closed=True))


def rigid_joint_gusset(at: complex, one: complex, other: complex) -> Marks:
    """The sign of two rods rigidly joined in one link: a gusset in their angle."""
    u, v = (direction_between(at, z) for z in (one, other))
    if abs((u * v.conjugate()).imag) > MOST_PARALLEL_SINE:
        return (Shape((at, at + GUSSET_SIDE_MM * u, at + GUSSET_SIDE_MM * v)),)
    return ()


def dot(at: complex, radius: float = DOT_RADIUS_MM, layer: Layer = "scheme") -> Marks:
    """A mass centre or a marked point."""
    return (Arc(at, radius, style="thin", layer=layer, fill="ink"),)


def turn_arrow(
    centre: complex, radius: float, start_deg: float, sweep_deg: float, style: str = "thin", layer: Layer = "scheme"
) -> Marks:
    """The sense of ω, ε or a moment: an arc with a head at its end, clockwise where ``sweep_deg`` < 0."""
    length = radius * math.radians(abs(sweep_deg))
    long, wide = arrowhead_size(length, pen_of_style(style).width)
    tip = centre + radius * unit_vector(start_deg + sweep_deg)
    covered = math.copysign(math.degrees(2 * math.asin(min(1.0, long / 2 / radius))), sweep_deg)
    back = centre + radius * unit_vector(start_deg + sweep_deg - covered)
    low, high = sorted((start_deg, start_deg + sweep_deg - 0.8 * covered))
    arc = Arc(centre, radius, low, high, style, layer)
    if long:
        return (arc, Shape(arrowhead_corners(tip, tip - back, long, wide), layer))
    return (arc,)
