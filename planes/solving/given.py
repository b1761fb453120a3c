"""The data of a scene, each item once: the named parameters, then every number of the mechanism without a name. They
are enough to draw it again."""

import cmath
import math
from collections.abc import Iterator
from functools import cached_property

from planes.plans import Plans
from planes.plans.force.loads import names_of_loads
from planes.plans.law_words import law_in_words
from planes.scene.expressions import evaluate_expression
from planes.scene.mechanism import Amount, Guide, Link, StrokeLoad
from planes.scene.structures import StaticLoad
from planes.scene.unit_words import UNIT_FACTORS
from planes.solving import Position
from planes.solving.given_rows import GivenRow, are_numbers_equal, gives_same_quantity, name_beside_parameter
from planes.words import say
from planes.words.frozen import frozen
from planes.words.lettering import parameter_lettering
from planes.words.names import UNIT_OF_LOADING, NumbersByName, letter_of
from planes.words.naming import Naming
from planes.words.units import number_text, unit_of_parameter

UNITS_IN_ROW_ORDER = ("°", "rad/s", "rad/s²", "m/s", "m/s²", "m", "", "kg", "kgm2", "N/m", "N", "N·m", "units")
"""Units in the order of their rows."""
LONGEST_LAW_CHARACTERS = 60  # longest law in a cell, in characters
FORCE_ONLY_UNITS = ("kg", "kgm2", "N/m", "N", "N·m")  # units of numbers needed for forces only
GIVEN_NUMBER_DIGITS = 6  # digits of a given number, as given


@frozen
class GivenTable:
    """The given values that the drawing of a position reads; ``parameters`` are those of its scene. ``steady`` ones
    keep their names whatever the numbers are."""

    position: Position
    naming: Naming
    parameters: NumbersByName
    steady: bool = False

    @property
    def plans_of_values(self) -> Plans:
        """The plans that the values are of."""
        return self.position.plans

    def given_rows(self) -> list[tuple[str, str, str]]:
        """Name, value and unit of every given that is read."""
        lang = self.naming.lang
        unit = {key: say(key, lang) if key else "—" for key in UNITS_IN_ROW_ORDER}
        return [(r.name, number_text(r.value, lang, GIVEN_NUMBER_DIGITS), unit[r.unit]) for r in self.listed_givens()]

    def listed_givens(self) -> list[GivenRow]:
        """Every given that is read, as listed."""
        plain = dict.fromkeys(
            r
            for r in self.unnamed_rows_once
            if self.is_read_by_drawing(r) and (r.value or r.place) and not self.is_given_by_parameter(r)
        )
        rows = [*filter(self.is_read_by_drawing, self.drive_rows()), *self.parameter_rows(), *plain]
        return sorted(rows, key=lambda r: (not r.of_drive, UNITS_IN_ROW_ORDER.index(r.unit)))

    def is_read_by_drawing(self, row: GivenRow) -> bool:
        """Whether the drawing reads it."""
        return not row.given or row.given in self.plans_of_values.program.given_names

    def drive_rows(self) -> list[GivenRow]:
        """The driver's position, and its motion."""
        drive = self.plans_of_values.drive
        if not self.plans_of_values.depends_on_drive:
            return []
        units = ("°", "rad/s", "rad/s²") if drive.rotates else ("m", "m/s", "m/s²")
        letters = drive.motion_names if self.plans_of_values.has_mechanism else (drive.kind,)
        names = map(self.naming.lettered_vector, letters)
        given = ("", *drive.rate_names)
        values = (self.position.at, drive.velocity, drive.acceleration)
        return [GivenRow(*row, of_drive=True) for row in zip(names, values, units, given, strict=False)]

    def parameter_rows(self) -> Iterator[GivenRow]:
        """The parameters; beside each, the lettering on the sheet of the load, guide or friction it gives."""
        shown = {r.name for r in self.drive_rows()}
        drive = self.plans_of_values.drive
        for name, value in self.parameters.items():
            row = GivenRow(parameter_lettering(name), value, unit_of_parameter(name))
            moved = letter_of(name) == drive.kind and value == drive.position
            same = [r for r in self.unnamed_rows_once if gives_same_quantity(r, row)]
            read = (
                any(map(self.is_read_by_drawing, same))
                if same
                else self.plans_of_values.force_plans or row.unit not in FORCE_ONLY_UNITS
            )
            if row.name not in shown and not moved and read and not _is_unit_parameter(name, value):
                other = [name_beside_parameter(r, value) for r in same if r.place or r.unit in ("", "N/m", "N", "N·m")]
                yield GivenRow(" = ".join(dict.fromkeys([row.name, *other])), value, row.unit)

    def is_given_by_parameter(self, row: GivenRow) -> bool:
        """Whether a parameter gives the same quantity: l_CD for l_DC, J_S2 for J_2."""
        named = (GivenRow(parameter_lettering(name), v, unit_of_parameter(name)) for name, v in self.parameters.items())
        return any(gives_same_quantity(row, r) for r in named)

    @cached_property
    def unnamed_rows_once(self) -> list[GivenRow]:
        """The same as :meth:`unnamed`, in a single pass."""
        return list(self.unnamed_number_rows())

    def unnamed_number_rows(self) -> Iterator[GivenRow]:
        """Every number of the mechanism, or of the vectors."""
        m = self.plans_of_values.mechanism
        yield from self.vector_data_rows()
        for point, z in (self.plans_of_values.figure or m.frame).points.items():
            yield from self.place_coordinate_rows(
                self.naming.lettered_point(point).replace("_{", "").replace("}", ""), z
            )
        if figure := self.plans_of_values.figure:
            for load in figure.spread:
                yield from self.load_intensity_rows(load)
            if figure.pole:
                yield GivenRow("x_{O}", figure.pole.real, "N", place=True)
                yield GivenRow("y_{O}", figure.pole.imag, "N", place=True)
            yield from self.lettered_load_rows()
            return
        for guide in m.frame.guides.values():
            yield from self.frame_guide_rows(guide)
        for link in m.links.values():
            yield from self.link_dimension_rows(link)
            n = self.naming.link_number(link.name)
            yield GivenRow(f"m_{{{n}}}", link.mass or 0.0, "kg", f"m_{link.name}")
            yield GivenRow(f"J_{{{n}}}", link.inertia or 0.0, "kgm2", f"J_{link.name}")
        yield from self.lettered_load_rows()
        yield GivenRow("g", m.gravity or 0.0, "m/s²", "g")
        for name, f in m.friction.items():
            yield GivenRow(f"f_{{{printed_guide_name(name)}}}", f, "", f"f_{name}")
        for name, journal in m.journals.items():
            yield GivenRow(f"f_{{{printed_guide_name(name)}}}", journal.coefficient, "", f"rho_{name}")
            yield GivenRow(f"r_{{{printed_guide_name(name)}}}", journal.radius, "m", f"rho_{name}")
            yield GivenRow(f"ρ_{{{printed_guide_name(name)}}}", journal.friction_circle_radius, "m", f"rho_{name}")

    def vector_data_rows(self) -> Iterator[GivenRow]:
        """The data of vectors stated in a scene."""
        given = self.plans_of_values.given
        drawn = self.position.drawing
        for name, (start, _) in self.plans_of_values.vectors.items():
            for key, sign, unit in ((f"|{name}|", "", start.plan.unit), (f"angle_∠{name}", "∠", "°")):
                if key in given and key in drawn and not (unit == "N" and key in self.plans_of_values.means):
                    yield GivenRow(sign + self.naming.lettered_vector(name), float(given[key]), unit, place=bool(sign))

    def place_coordinate_rows(self, name: str, z: complex) -> Iterator[GivenRow]:
        """The coordinates of a place."""
        if not z and not self.steady:
            yield GivenRow(f"x_{{{name}}} = y_{{{name}}}", 0.0, "m", place=True)
            return
        yield GivenRow(f"x_{{{name}}}", z.real, "m", place=True)
        yield GivenRow(f"y_{{{name}}}", z.imag, "m", place=True)

    def frame_guide_rows(self, guide: Guide) -> Iterator[GivenRow]:
        """The place and direction of a guide of the frame."""
        name = printed_guide_name(guide.name)
        upright = guide.through_point is None and {0.0: "y", 90.0: "x"}.get(guide.angle_deg)
        if upright:  # its coordinate gives the direction
            z = guide.through
            yield GivenRow(f"{upright}_{{{name}}}", z.real if upright == "x" else z.imag, "m", place=True)
            return
        if guide.through_point is None:
            yield from self.place_coordinate_rows(name, guide.through)
        yield GivenRow(f"∠{name}", guide.angle_deg, "°", place=True)

    def link_dimension_rows(self, link: Link) -> Iterator[GivenRow]:
        """Places of a link's points in its axes, in the shortest form, its guides, its place on the guide it slides
        on."""
        first = link.first_point
        for point, z in link.points.items():
            way = z - link.points[first]
            polar = abs(way), round(math.degrees(cmath.phase(way)), 9)
            name = f"l_{first}{point}"
            length = self.parameters.get(name, polar[0])  # may be a coordinate
            plain = (
                name in self.parameters
                if self.steady
                else _printed_length(*polar) <= _printed_length(way.real, way.imag)
            )
            if way.imag and not (plain and are_numbers_equal(length, polar[0])):
                yield from self.place_coordinate_rows(first + point, way)
                continue
            yield GivenRow(f"l_{{{first}{point}}}", polar[0], "m")
            yield GivenRow(f"∠{first}{point}", polar[1], "°")
        for guide in link.guides.values():
            yield GivenRow(f"∠{printed_guide_name(guide.name)}", guide.angle_deg, "°")
            if guide.through_point is None:
                yield from self.place_coordinate_rows(
                    first + printed_guide_name(guide.name), guide.through - link.points[first]
                )
        if link.slides:
            yield GivenRow(f"e_{{{self.naming.link_number(link.name)}}}", link.slides.offset or 0.0, "m")
            yield GivenRow(f"∠{self.naming.link_number(link.name)}", link.slides.angle_deg or 0.0, "°")

    def load_intensity_rows(self, load: StaticLoad) -> Iterator[GivenRow]:
        """A distributed load: one intensity, or one at each of its ends."""
        first, last = load.intensity
        index = "".join(map(self.naming.lettered_point, load.spread or ()))
        if first == last:
            yield GivenRow(f"q_{{{index}}}", first, "N/m")
            return
        for point, value in zip(load.spread or (), load.intensity, strict=True):
            yield GivenRow(f"q_{{{index}}}^{{{self.naming.lettered_point(point)}}}", value, "N/m", place=True)

    def lettered_load_rows(self) -> Iterator[GivenRow]:
        """Forces and couples as lettered on the sheet. In statics a distributed load is given by its intensity, not by
        its resultant, and the ray of a pole acts on no body."""
        plans = self.plans_of_values
        resultants = {load.name for load in plans.figure.spread} if plans.figure else set()
        for name, m in plans.means.items():
            stated = m.of not in resultants and bool(m.link or not plans.figure)
            if stated and name in plans.given and (unit := UNIT_OF_LOADING.get(m.quantity)):
                yield GivenRow(self.naming.lettered_vector(m.of), float(plans.given[name]), unit, name)
        mechanism = plans.mechanism
        for name, load in zip(names_of_loads(mechanism), mechanism.loads, strict=True):
            if isinstance(load.direction_deg, float | int):
                axes = f"^{{({self.naming.link_number(load.direction_link)})}}" if load.direction_link else ""
                sign = f"∠{self.naming.lettered_vector(name)}{axes}"
                yield GivenRow(sign, load.direction_deg, "°", f"angle_∠{name}", place=True)

    def load_law_rows(self) -> Iterator[tuple[str, str, str]]:
        """Loads given by laws, each with its value in this position."""
        drawing = self.position.drawing
        lang = self.naming.lang
        for name, sign, key, _ in self.loads_given_by_laws():
            yield sign, number_text(float(drawing[name]), lang) if name in drawing else "—", say(key, lang)

    def load_law_formulas(self) -> Iterator[str]:
        """The laws of loads."""
        lang = self.naming.lang
        for _, sign, key, law in self.loads_given_by_laws():
            if not isinstance(law, StrokeLoad):
                yield f"{sign} = {self.law_with_unit(law, key)}"
                continue
            for word, part in (("stroke_working", law.working), ("stroke_idle", law.idle)):
                yield f"{sign} = {self.law_with_unit(part, key)} ({say(word, lang)})"

    def loads_given_by_laws(self) -> Iterator[tuple[str, str, str, Amount | StrokeLoad]]:
        """Loads given by laws: their lettered names, the keys of their units, the laws."""
        plans = self.plans_of_values
        for name, law in plans.acting.laws.items() if plans.force_plans else ():
            m = plans.means[name]
            key = UNIT_OF_LOADING.get(m.quantity, "°")
            sign = self.naming.lettered_vector(m.of)
            yield name, f"∠{sign}" if key == "°" else sign, key, law

    def law_with_unit(self, law: Amount, key: str) -> str:
        """A law with its unit, separated from a formula by a comma."""
        return (
            f"{self.law_fitting_cell(law)}{' ' if isinstance(law, int | float) else ', '}{say(key, self.naming.lang)}"
        )

    def law_fitting_cell(self, law: Amount) -> str:
        """A law, as much of it as fits in a cell."""
        drive = self.plans_of_values.drive
        text = law_in_words(law, drive, self.naming.lettered_vector, self.naming.lang, pairs=False)
        return text if len(text) <= LONGEST_LAW_CHARACTERS else "…"


def printed_guide_name(name: str) -> str:
    """The name of a guide as printed."""
    return name.replace("-", "–")


def _printed_length(*values: float) -> int:
    """The printed length of numbers."""
    return sum(len(number_text(v, "en", GIVEN_NUMBER_DIGITS)) for v in values)


def _is_unit_parameter(name: str, value: float) -> bool:
    """Whether a parameter is a unit for other numbers: by its name and its value."""
    return name in UNIT_FACTORS and math.isclose(value, evaluate_expression(UNIT_FACTORS[name], {}), rel_tol=1e-3)
