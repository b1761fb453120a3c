"""Dimensions on a scheme: two arrows from the middle, extension lines to the measured object, the number over them."""

from collections.abc import Iterable, Iterator, Sequence

import shapely

from planes.scene.mechanism import FRAME
from planes.words import Lang
from planes.words.frozen import frozen, replace
from planes.words.naming import Naming
from planes.words.units import number
from render.labels import Label, Labelled
from render.labels.footprints import Bounds
from render.paper.marks import Arrow, Line, Mark, Text
from render.paper.style import tall
from render.paper.symbols import turn_arrow, unit
from render.paper.typeset import ink_width
from render.views.plotted import Ends, Places, degrees

PAST_MM = 1.5  # of an extension line beyond the arrow
OVER_MM = 0.9  # of the number over the dimension line
TAIL_MM = 0.6  # of a comma below the base line: extra height of a number over an arrowhead
LETTER_MM = 3.5
BESIDE_MM = 10.0  # distance of dimensions from the drawing
HEADS_MM = 8.0  # of the arrows beside the text
ANGLE_MM, AXIS_MM = 16.0, 21.0  # the radius of the driver's angle, and the length of the axis it is measured from
PARTING = (0.5, 0.42, 0.58, 0.35, 0.65, 0.25, 0.75, 0.15, 0.85)  # of a dimension's length, where its text may be
SQUARE = 1e-6


@frozen
class Size:
    """A dimension between two ``places``, with the ends of its arrows, ``aside`` of them."""

    places: Ends
    ends: Ends
    aside: complex
    text: str
    name: str = "size"

    @property
    def fits(self) -> bool:
        """Whether it is long enough for its text and the heads beside it."""
        return abs(self.ends[1] - self.ends[0]) > ink_width(self.text, tall(LETTER_MM)) + HEADS_MM

    def leading(self) -> list[Line]:
        """The extension lines from the measured object to its arrows."""
        pairs = zip(self.places, self.ends, strict=True)
        return [Line((z, end + PAST_MM * self.aside), "thin", "dimension") for z, end in pairs]

    def marks(self, others: Sequence[Line] = ()) -> list[Mark]:
        """All its marks; its arrows part, beneath the text, where no other line comes near."""
        a, b = self.ends
        free = (z for t in PARTING if self.clear(z := a + t * (b - a), others))
        parting = next(free, (a + b) / 2)
        arrows = [Arrow(parting, end, "thin", "dimension") for end in self.ends]
        short = min(abs(end - parting) for end in self.ends) < (ink_width(self.text, tall(LETTER_MM)) + HEADS_MM) / 2
        place = parting + (OVER_MM + (TAIL_MM if short else 0.0)) * 1j * unit(self.turn)
        return [
            *self.leading(),
            *arrows,
            Text(
                self.text,
                place,
                tall(LETTER_MM),
                anchor="middle",
                turn_deg=self.turn,
                layer="dimension",
                name=self.name,
            ),
        ]

    @property
    def turn(self) -> float:
        """The direction of its text, degrees: read from below or from the right."""
        turn = degrees(self.ends[1] - self.ends[0])
        return turn - 180 * round(turn / 180 - 1e-9)

    def clear(self, z: complex, others: Iterable[Line]) -> bool:
        """Whether a text over a place is clear of other lines."""
        half, way = ink_width(self.text, tall(LETTER_MM)) / 2 + OVER_MM, unit(self.turn)
        box = shapely.box(-half, -tall(LETTER_MM), half, tall(LETTER_MM) + 2 * OVER_MM)
        turned = ([(w - z) / way for w in line.points] for line in others)
        return not any(box.intersects(shapely.LineString([(w.real, w.imag) for w in line])) for line in turned)


def sizes_drawn(sizes: Sequence[Size], ground: Iterable[Mark] = ()) -> list[Mark]:
    """Dimensions whose texts are crossed neither by a line of the drawing nor by another's extension line."""
    lines = [m for m in ground if isinstance(m, Line)] + [line for one in sizes for line in one.leading()]
    return [m for one in sizes for m in one.marks(lines)]


def stroke(one: complex, other: complex, off: complex, text: str) -> Size:
    """The stroke of a slider between two places, drawn at that distance, perpendicular to it."""
    return Size((one, other), (one + off, other + off), off / abs(off), text, "stroke")


def frame_sizes(places: Places, mu: float, about: Bounds, lang: Lang) -> list[Size]:
    """The distances of the frame's hinges and of horizontal and vertical guides from the driver's pair, in true mm:
    horizontal dimensions beneath everything drawn, vertical ones at its left."""
    sizes, pair = list[Size](), places.position.plans.structure.drive_pair.point
    if places.mechanism.drive.on != FRAME:  # the driver has no pair with the frame: from the first hinge of the frame
        pair = next((p for p in places.mechanism.frame.points if p in places.shared), "")
    if not places.has(pair):
        return sizes
    for way, aside, edge in ((1 + 0j, -1j, -about[1]), (1j, -1 + 0j, -about[0])):
        base = places.at(pair)
        ways = {round(((z - base) / way).real, 2): z for z in _held(places, way)}
        plain = ((base, ways[t], in_mm(abs(t) / mu, lang)) for t in sorted(ways, key=abs))
        feet = (Size((a, b), ((a / way).real * way, (b / way).real * way), aside, text) for a, b, text in plain)
        for k, one in enumerate(x for x in feet if x.fits):
            off = (edge + BESIDE_MM + k * 2 * tall(LETTER_MM)) * aside
            sizes.append(replace(one, ends=(one.ends[0] + off, one.ends[1] + off)))
    return sizes


def in_mm(metres: float, lang: Lang) -> str:
    """A dimension as a drawing has it."""
    return number(round(1000 * metres, 1), lang, 7)


def _held(places: Places, way: complex) -> Iterator[complex]:
    """The frame's hinges, and the feet of sliders on its guides perpendicular to a direction."""
    m = places.mechanism
    yield from (places.at(p) for p in m.frame.points if p in places.shared and places.has(p))
    for foot, along in (places.foot(x) for x in places.sliders(*m.frame.guides)):
        if abs((along / way).real) < SQUARE:
            yield foot


def driver_angle(places: Places, naming: Naming) -> Labelled:
    """The driver's angle from the x axis, about its pivot, and its name."""
    drive, pair = places.mechanism.drive, places.position.plans.structure.drive_pair.point
    turn = places.position.at % 360 if drive.rotates and places.has(pair) and drive.on == FRAME else 0.0
    if not turn:
        return [], []
    pivot, text = places.at(pair), f"φ_{{{naming.link(drive.link)}}}"
    axis = Line((pivot, pivot + AXIS_MM), "axis", "axis")
    arc = turn_arrow(pivot, ANGLE_MM, 0, turn, layer="dimension")
    middle, out = pivot + ANGLE_MM * unit(turn / 2), unit(turn / 2)
    return [axis, *arc], [Label(text, middle, LETTER_MM, side=out, clear=0.5, name=text)]
