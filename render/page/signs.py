"""The signs of the pages: those of the paper, its arrowheads and the widths of its pens, in mm, y up."""

from planes.drafting.pens import HEADLESS_MM, LEAST_WIDTH, MEDIUM, THICK
from planes.words.records import Json
from render.paper import symbols
from render.paper.marks import Arc, Line
from render.paper.style import BLOCK_MM, LARGE_MM, PENS, ROUND_GAP_MM, ROUND_HATCH_MM, ROUND_MM, SMALL_MM

# about their points, unturned
NAMED = {
    "hinge": symbols.hinge(0j),
    "point": symbols.dot(0j),
    "ground": symbols.fixed_hinge(0j),
    "block": symbols.block(0j),
    "small": symbols.block(0j, size=SMALL_MM),
    "large": symbols.block(0j, size=LARGE_MM),
    "roller": symbols.roller(0j),
    "clamp": symbols.wall(0j),
    "stroke": (Line((0j, ROUND_HATCH_MM * symbols.unit(45)), "thin"),),
}


def signs() -> Json:
    """The signs as strokes, arrowheads by their pens, and the sizes of a circular guide."""
    return {
        "signs": {name: strokes(marks) for name, marks in NAMED.items()},
        "heads": {"thick": THICK, "vector": MEDIUM},
        "headless": HEADLESS_MM,
        "least": LEAST_WIDTH,
        "reach": ROUND_MM,
        "gap": ROUND_GAP_MM,
        "wide": BLOCK_MM[1],
    }


def strokes(marks: symbols.Marks) -> list[Json]:
    """The pen of each stroke, the points of a line, or the centre and the radius of a circle."""
    return [
        {"pen": m.style, "points": places(m.centre), "r": m.radius}
        if isinstance(m, Arc)
        else {"pen": m.style, "points": places(*m.points), "closed": m.closed}
        for m in marks
        if isinstance(m, Arc | Line)
    ]


def places(*points: complex) -> list[list[float]]:
    """The coordinates of points."""
    return [[round(z.real, 3), round(z.imag, 3)] for z in points]


def pens() -> str:
    """The widths of the paper's pens, for style sheets; in a drawing with small signs they are narrower."""
    return "".join(f"--{p}: calc(var(--share, 1) * {PENS[p].width}mm); " for p in ("thick", "vector", "thin"))
