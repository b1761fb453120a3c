"""Sizes on a scheme: two arrows that part from the middle, lines that lead to what is measured, the size over them."""

from collections.abc import Iterator

from planes.words import Lang
from planes.words.lettering import Naming
from render.labels import Label
from render.labels.footprints import Bounds
from render.paper import symbols
from render.paper.letters import decimal
from render.paper.marks import Arrow, Line, Mark, Text
from render.views.plotted import Places, degrees

PAST_MM = 1.5  # of a leading line beyond the arrow
OVER_MM = 0.9  # of the size over the line of its arrows
LETTER_MM = 3.5
APART_MM, BESIDE_MM = 8.0, 14.0  # of sizes from each other, and from what is drawn
LEAST_MM = 9.0  # the shortest that has room for its arrows and its number
ANGLE_MM, AXIS_MM = 16.0, 21.0  # the radius at which the driver's angle is shown, and the axis it is measured from
SQUARE = 1e-6


def stroke(one: complex, other: complex, off: complex, text: str) -> list[Mark]:
    """The way of a slider between two places, drawn so far off, square to it."""
    return _size((one, one + off), (other, other + off), off / abs(off), text, "stroke")


def _size(
    one: tuple[complex, complex], other: tuple[complex, complex], aside: complex, text: str, name: str
) -> list[Mark]:
    """The size between two places, each with the end of its arrow."""
    middle, turn = (one[1] + other[1]) / 2, degrees(other[1] - one[1])
    turn -= 180 * round(turn / 180 - 1e-9)  # read from below or from the right
    leading = [Line((z, end + PAST_MM * aside), "thin", "dimension") for z, end in (one, other)]
    arrows = [Arrow(middle, end, "thin", "dimension") for _, end in (one, other)]
    place = middle + OVER_MM * 1j * symbols.unit(turn)
    return [*leading, *arrows, Text(text, place, LETTER_MM, "middle", turn, "dimension", name)]


def frame_sizes(places: Places, mu: float, drawn: Bounds, lang: Lang) -> list[Mark]:
    """How far the frame's hinges, level and upright guides are from the driver's pair, in mm as they are: level sizes
    beneath everything drawn, upright ones at its left."""
    found, pair = list[Mark](), places.position.plans.structure.drive_pair.point
    if not places.has(pair):
        return found
    for way, aside, edge in ((1 + 0j, -1j, -drawn[1]), (1j, -1 + 0j, -drawn[0])):
        base = places.at(pair)
        ways = {round(((z - base) / way).real, 2): z for z in _held(places, way)}
        long = sorted((t for t in ways if abs(t) > LEAST_MM), key=abs)
        for k, t in enumerate(long):
            off = (edge + BESIDE_MM + k * APART_MM) * aside
            one, other = ((x, (x / way).real * way + off) for x in (base, ways[t]))
            found += _size(one, other, aside, decimal(f"{1000 * abs(t) / mu:.4g}", lang), "size")
    return found


def _held(places: Places, way: complex) -> Iterator[complex]:
    """The frame's hinges, and the feet of sliders on its guides that stand square to a way."""
    m = places.mechanism
    yield from (places.at(p) for p in m.frame.points if p in places.shared and places.has(p))
    for foot, along in (places.foot(x) for x in places.sliders(*m.frame.guides)):
        if abs((along / way).real) < SQUARE:
            yield foot


def driver_angle(places: Places, naming: Naming) -> tuple[list[Mark], list[Label]]:
    """The driver's angle from the axis x, about its pivot, and its name."""
    drive, pair = places.mechanism.drive, places.position.plans.structure.drive_pair.point
    turn = places.position.at % 360 if drive.kind == "phi" and places.has(pair) else 0.0
    if not turn:
        return [], []
    pivot, text = places.at(pair), f"φ_{{{naming.link(drive.link)}}}"
    axis = Line((pivot, pivot + AXIS_MM), "axis", "axis")
    arc = symbols.turn_arrow(pivot, ANGLE_MM, 0, turn, layer="dimension")
    middle, out = pivot + ANGLE_MM * symbols.unit(turn / 2), symbols.unit(turn / 2)
    return [axis, *arc], [Label(text, middle, LETTER_MM, side=out, clear=0.5, name=text)]
