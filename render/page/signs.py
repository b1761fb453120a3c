"""The signs of the pages: those of the paper, its arrowheads and the widths of its pens, in mm, y up."""

from planes.drafting.pens import LEAST_HEAD_LENGTH_RATIO, LONGEST_HEADLESS_ARROW_MM, MEDIUM_PEN_HEAD, THICK_PEN_HEAD
from planes.words.records import Json
from render.paper import symbols
from render.paper.marks import Arc, Line
from render.paper.style import (
    HALF_ROUND_GUIDE_LENGTH_MM,
    INNER_BLOCK_SIZE_MM,
    OUTER_BLOCK_SIZE_MM,
    PEN_BY_STYLE,
    ROUND_HATCH_SPACING_MM,
    ROUND_HATCHING_DEPTH_MM,
    SLIDER_BLOCK_SIZE_MM,
)

# about their points, unturned
MARKS_OF_SIGN = {
    "hinge": symbols.hinge(0j),
    "point": symbols.dot(0j),
    "ground": symbols.fixed_hinge(0j),
    "block": symbols.block(0j),
    "small": symbols.block(0j, size=INNER_BLOCK_SIZE_MM),
    "large": symbols.block(0j, size=OUTER_BLOCK_SIZE_MM),
    "roller": symbols.roller(0j),
    "clamp": symbols.clamp_wall(0j),
    "stroke": (Line((0j, ROUND_HATCHING_DEPTH_MM * symbols.unit_vector(45)), "thin"),),
}


def page_signs() -> Json:
    """The signs as strokes, arrowheads by their pens, and the sizes of a circular guide."""
    return {
        "signs": {name: sign_strokes(marks) for name, marks in MARKS_OF_SIGN.items()},
        "heads": {"thick": THICK_PEN_HEAD, "vector": MEDIUM_PEN_HEAD},
        "headless": LONGEST_HEADLESS_ARROW_MM,
        "least": LEAST_HEAD_LENGTH_RATIO,
        "reach": HALF_ROUND_GUIDE_LENGTH_MM,
        "gap": ROUND_HATCH_SPACING_MM,
        "wide": SLIDER_BLOCK_SIZE_MM[1],
    }


def sign_strokes(marks: symbols.Marks) -> list[Json]:
    """The pen of each stroke, the points of a line, or the centre and the radius of a circle."""
    return [
        {"pen": m.style, "points": point_coordinates(m.centre), "r": m.radius}
        if isinstance(m, Arc)
        else {"pen": m.style, "points": point_coordinates(*m.points), "closed": m.closed}
        for m in marks
        if isinstance(m, Arc | Line)
    ]


def point_coordinates(*points: complex) -> list[list[float]]:
    """The coordinates of points."""
    return [[round(z.real, 3), round(z.imag, 3)] for z in points]


def pen_widths_css() -> str:
    """The widths of the paper's pens, for style sheets; in a drawing with small signs they are narrower."""
    return "".join(f"--{p}: calc(var(--share, 1) * {PEN_BY_STYLE[p].width}mm); " for p in ("thick", "vector", "thin"))
