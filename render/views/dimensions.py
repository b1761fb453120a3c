"""Dimensions on a scheme: two arrows from the middle, extension lines to the measured object, the number over them."""

from collections.abc import Iterable, Iterator, Sequence

import shapely

from planes.scene.mechanism import FRAME
from planes.words import Lang
from planes.words.frozen import frozen, replace
from planes.words.naming import Naming
from planes.words.units import number_text
from render.labels import Label, Labelled
from render.labels.footprints import Bounds
from render.paper.marks import Arrow, Line, Mark, Text
from render.paper.style import figure_letter_height
from render.paper.symbols import turn_arrow, unit_vector
from render.paper.typeset import ink_width
from render.views.plotted import Ends, Places, direction_deg, length_of

EXTENSION_LINE_OVERRUN_MM = 1.5  # of an extension line beyond the arrow
NUMBER_RISE_MM = 0.9  # of the number over the dimension line
COMMA_ALLOWANCE_MM = 0.6  # of a comma below the base line: extra height of a number over an arrowhead
NUMBER_LETTER_MM = 3.5
DIMENSION_OFFSET_MM = 10.0  # distance of dimensions from the drawing
ARROWHEADS_LENGTH_MM = 8.0  # of the arrows beside the text
# the radius of the driver's angle, and the length of the axis it is measured from
DRIVER_ANGLE_RADIUS_MM = 16.0
DRIVER_AXIS_LENGTH_MM = 21.0
# of a dimension's length, where its text may be
TEXT_POSITION_RATIOS = (0.5, 0.42, 0.58, 0.35, 0.65, 0.25, 0.75, 0.15, 0.85)
MOST_PERPENDICULAR_COSINE = 1e-6


@frozen
class Size:
    """A dimension between two ``places``, with the ends of its arrows, ``aside`` of them."""

    places: Ends
    ends: Ends
    aside: complex
    text: str
    name: str = "size"

    @property
    def has_room_for_text(self) -> bool:
        """Whether it is long enough for its text and the heads beside it."""
        return (
            length_of(self.ends) > ink_width(self.text, figure_letter_height(NUMBER_LETTER_MM)) + ARROWHEADS_LENGTH_MM
        )

    def extension_lines(self) -> list[Line]:
        """The extension lines from the measured object to its arrows."""
        pairs = zip(self.places, self.ends, strict=True)
        return [Line((z, end + EXTENSION_LINE_OVERRUN_MM * self.aside), "thin", "dimension") for z, end in pairs]

    def dimension_marks(self, others: Sequence[Line] = ()) -> list[Mark]:
        """All its marks; its arrows part, beneath the text, where no other line comes near."""
        a, b = self.ends
        free = (z for t in TEXT_POSITION_RATIOS if self.is_text_clear(z := a + t * (b - a), others))
        parting = next(free, (a + b) / 2)
        arrows = [Arrow(parting, end, "thin", "dimension") for end in self.ends]
        short = (
            min(abs(end - parting) for end in self.ends)
            < (ink_width(self.text, figure_letter_height(NUMBER_LETTER_MM)) + ARROWHEADS_LENGTH_MM) / 2
        )
        place = parting + (NUMBER_RISE_MM + (COMMA_ALLOWANCE_MM if short else 0.0)) * 1j * unit_vector(
            self.text_angle_deg
        )
        return [
            *self.extension_lines(),
            *arrows,
            Text(
                self.text,
                place,
                figure_letter_height(NUMBER_LETTER_MM),
                anchor="middle",
                turn_deg=self.text_angle_deg,
                layer="dimension",
                name=self.name,
            ),
        ]

    @property
    def text_angle_deg(self) -> float:
        """The direction of its text, degrees: read from below or from the right."""
        turn = direction_deg(self.ends[1] - self.ends[0])
        return turn - 180 * round(turn / 180 - 1e-9)

    def is_text_clear(self, z: complex, others: Iterable[Line]) -> bool:
        """Whether a text over a place is clear of other lines."""
        half = ink_width(self.text, figure_letter_height(NUMBER_LETTER_MM)) / 2 + NUMBER_RISE_MM
        way = unit_vector(self.text_angle_deg)
        box = shapely.box(
            -half,
            -figure_letter_height(NUMBER_LETTER_MM),
            half,
            figure_letter_height(NUMBER_LETTER_MM) + 2 * NUMBER_RISE_MM,
        )
        turned = ([(w - z) / way for w in line.points] for line in others)
        return not any(box.intersects(shapely.LineString([(w.real, w.imag) for w in line])) for line in turned)


def draw_dimensions(sizes: Sequence[Size], ground: Iterable[Mark] = ()) -> list[Mark]:
    """Dimensions whose texts are crossed neither by a line of the drawing nor by another's extension line."""
    lines = [m for m in ground if isinstance(m, Line)] + [line for one in sizes for line in one.extension_lines()]
    return [m for one in sizes for m in one.dimension_marks(lines)]


def stroke_dimension(one: complex, other: complex, off: complex, text: str) -> Size:
    """The stroke of a slider between two places, drawn at that distance, perpendicular to it."""
    return Size((one, other), (one + off, other + off), off / abs(off), text, "stroke")


def frame_dimensions(places: Places, mu: float, about: Bounds, lang: Lang) -> list[Size]:
    """The distances of the frame's hinges and of horizontal and vertical guides from the driver's pair, in true mm:
    horizontal dimensions beneath everything drawn, vertical ones at its left."""
    sizes = list[Size]()
    pair = places.position.plans.structure.drive_pair.point
    if places.mechanism.drive.on != FRAME:  # the driver has no pair with the frame: from the first hinge of the frame
        pair = next((p for p in places.mechanism.frame.points if p in places.links_by_hinge), "")
    if not places.is_drawn(pair):
        return sizes
    for way, aside, edge in ((1 + 0j, -1j, -about[1]), (1j, -1 + 0j, -about[0])):
        base = places.point_place(pair)
        ways = {round(((z - base) / way).real, 2): z for z in _frame_places(places, way)}
        plain = ((base, ways[t], dimension_text(abs(t) / mu, lang)) for t in sorted(ways, key=abs))
        feet = (Size((a, b), ((a / way).real * way, (b / way).real * way), aside, text) for a, b, text in plain)
        for k, one in enumerate(x for x in feet if x.has_room_for_text):
            off = (edge + DIMENSION_OFFSET_MM + k * 2 * figure_letter_height(NUMBER_LETTER_MM)) * aside
            sizes.append(replace(one, ends=(one.ends[0] + off, one.ends[1] + off)))
    return sizes


def dimension_text(metres: float, lang: Lang) -> str:
    """A dimension as a drawing has it."""
    return number_text(round(1000 * metres, 1), lang, 7)


def _frame_places(places: Places, way: complex) -> Iterator[complex]:
    """The frame's hinges, and the feet of sliders on its guides perpendicular to a direction."""
    m = places.mechanism
    yield from (places.point_place(p) for p in m.frame.points if p in places.links_by_hinge and places.is_drawn(p))
    for foot, along in (places.foot_on_guide(x) for x in places.sliders_on_guides(*m.frame.guides)):
        if abs((along / way).real) < MOST_PERPENDICULAR_COSINE:
            yield foot


def driver_angle(places: Places, naming: Naming) -> Labelled:
    """The driver's angle from the x axis, about its pivot, and its name."""
    drive = places.mechanism.drive
    pair = places.position.plans.structure.drive_pair.point
    turn = places.position.at % 360 if drive.rotates and places.is_drawn(pair) and drive.on == FRAME else 0.0
    if not turn:
        return [], []
    pivot = places.point_place(pair)
    text = f"φ_{{{naming.link_number(drive.link)}}}"
    axis = Line((pivot, pivot + DRIVER_AXIS_LENGTH_MM), "axis", "axis")
    arc = turn_arrow(pivot, DRIVER_ANGLE_RADIUS_MM, 0, turn, layer="dimension")
    middle = pivot + DRIVER_ANGLE_RADIUS_MM * unit_vector(turn / 2)
    out = unit_vector(turn / 2)
    return [axis, *arc], [Label(text, middle, NUMBER_LETTER_MM, side=out, clear=0.5, name=text)]
