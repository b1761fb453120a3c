"""The data of a scene, each item once: the named parameters, then every number of the mechanism without a name. They
are enough to draw it again."""

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import cached_property

from planes.plans import Plans
from planes.plans.force.loads import load_names
from planes.plans.law_words import law_said
from planes.scene.expressions import evaluate
from planes.scene.mechanism import Amount, Guide, Link, StrokeLoad
from planes.scene.structures import StaticLoad
from planes.scene.unit_words import FACTORS
from planes.solving import Position
from planes.solving.given_rows import GivenRow, alike, beside, equal
from planes.words import say
from planes.words.frozen import frozen
from planes.words.lettering import greek
from planes.words.names import kind_of, letter_of
from planes.words.naming import Naming
from planes.words.units import UNIT, number, unit_of_parameter

RANK = ("°", "rad/s", "rad/s²", "m/s", "m/s²", "m", "", "kg", "kgm2", "N/m", "N", "N·m", "units")
"""Units in the order of their rows."""
LONGEST = 60  # longest law in a cell, in characters
LOADING = ("kg", "kgm2", "N/m", "N", "N·m")  # units of numbers needed for forces only
DIGITS = 6  # digits of a given number, as given


@frozen
class GivenTable:
    """The given values that the drawing of a position reads; ``parameters`` are those of its scene. ``steady`` ones
    keep their names whatever the numbers are."""

    position: Position
    naming: Naming
    parameters: Mapping[str, float]
    steady: bool = False

    @property
    def plans(self) -> Plans:
        """The plans that the values are of."""
        return self.position.plans

    def rows(self) -> list[tuple[str, str, str]]:
        """Name, value and unit of every given that is read."""
        lang = self.naming.lang
        unit = {key: say(key, lang) if key else "—" for key in RANK}
        return [(r.name, number(r.value, lang, DIGITS), unit[r.unit]) for r in self.listed()]

    def listed(self) -> list[GivenRow]:
        """Every given that is read, as listed."""
        plain = dict.fromkeys(r for r in self.plain if self.read(r) and (r.value or r.place) and not self.known(r))
        rows = [*filter(self.read, self.drive()), *self.named(), *plain]
        return sorted(rows, key=lambda r: (not r.of_drive, RANK.index(r.unit)))

    def read(self, row: GivenRow) -> bool:
        """Whether the drawing reads it."""
        return not row.given or row.given in self.plans.program.givens

    def drive(self) -> list[GivenRow]:
        """The driver's position, and its motion."""
        drive = self.plans.drive
        if not self.plans.turns:
            return []
        units = ("°", "rad/s", "rad/s²") if drive.rotates else ("m", "m/s", "m/s²")
        letters = drive.letters if self.plans.moves else (drive.kind,)
        names, given = map(self.naming.vector, letters), ("", *drive.rates)
        values = (self.position.at, drive.velocity, drive.acceleration)
        return [GivenRow(*row, of_drive=True) for row in zip(names, values, units, given, strict=False)]

    def named(self) -> Iterator[GivenRow]:
        """The parameters; beside each, the lettering on the sheet of the load, guide or friction it gives."""
        shown = {r.name for r in self.drive()}
        drive = self.plans.drive
        for name, value in self.parameters.items():
            row = GivenRow(greek(name), value, unit_of_parameter(name))
            moved = letter_of(name) == drive.kind and value == drive.position
            same = [r for r in self.plain if alike(r, row)]
            read = any(map(self.read, same)) if same else self.plans.forces or row.unit not in LOADING
            if row.name not in shown and not moved and read and not _unit(name, value):
                other = [beside(r, value) for r in same if r.place or r.unit in ("", "N/m", "N", "N·m")]
                yield GivenRow(" = ".join(dict.fromkeys([row.name, *other])), value, row.unit)

    def known(self, row: GivenRow) -> bool:
        """Whether a parameter gives the same quantity: l_CD for l_DC, J_S2 for J_2."""
        named = (GivenRow(greek(name), v, unit_of_parameter(name)) for name, v in self.parameters.items())
        return any(alike(row, r) for r in named)

    @cached_property
    def plain(self) -> list[GivenRow]:
        """The same as :meth:`unnamed`, in a single pass."""
        return list(self.unnamed())

    def unnamed(self) -> Iterator[GivenRow]:
        """Every number of the mechanism, or of the vectors."""
        m = self.plans.mechanism
        yield from self.vectors()
        for point, z in (self.plans.figure or m.frame).points.items():
            yield from self.place(self.naming.point(point).replace("_{", "").replace("}", ""), z)
        if figure := self.plans.figure:
            for load in figure.spread:
                yield from self.intensities(load)
            if figure.pole:
                yield GivenRow("x_{O}", figure.pole.real, "N", place=True)
                yield GivenRow("y_{O}", figure.pole.imag, "N", place=True)
            yield from self.loads()
            return
        for guide in m.frame.guides.values():
            yield from self.frame_guide(guide)
        for link in m.links.values():
            yield from self.lengths(link)
            n = self.naming.link(link.name)
            yield GivenRow(f"m_{{{n}}}", link.mass or 0.0, "kg", f"m_{link.name}")
            yield GivenRow(f"J_{{{n}}}", link.inertia or 0.0, "kgm2", f"J_{link.name}")
        yield from self.loads()
        yield GivenRow("g", m.gravity or 0.0, "m/s²", "g")
        for name, f in m.friction.items():
            yield GivenRow(f"f_{{{dashed(name)}}}", f, "", f"f_{name}")
        for name, journal in m.journals.items():
            yield GivenRow(f"f_{{{dashed(name)}}}", journal.coefficient, "", f"rho_{name}")
            yield GivenRow(f"r_{{{dashed(name)}}}", journal.radius, "m", f"rho_{name}")
            yield GivenRow(f"ρ_{{{dashed(name)}}}", journal.circle, "m", f"rho_{name}")

    def vectors(self) -> Iterator[GivenRow]:
        """The data of vectors stated in a scene."""
        given, drawn = self.plans.given, self.position.drawing
        for name, (start, _) in self.plans.vectors.items():
            for key, sign, unit in ((f"|{name}|", "", UNIT[kind_of(start)]), (f"angle_∠{name}", "∠", "°")):
                if key in given and key in drawn and not (unit == "N" and key in self.plans.means):
                    yield GivenRow(sign + self.naming.vector(name), float(given[key]), unit, place=bool(sign))

    def place(self, name: str, z: complex) -> Iterator[GivenRow]:
        """The coordinates of a place."""
        if not z and not self.steady:
            yield GivenRow(f"x_{{{name}}} = y_{{{name}}}", 0.0, "m", place=True)
            return
        yield GivenRow(f"x_{{{name}}}", z.real, "m", place=True)
        yield GivenRow(f"y_{{{name}}}", z.imag, "m", place=True)

    def frame_guide(self, guide: Guide) -> Iterator[GivenRow]:
        """The place and direction of a guide of the frame."""
        name = dashed(guide.name)
        upright = guide.through_point is None and {0.0: "y", 90.0: "x"}.get(guide.angle_deg)
        if upright:  # its coordinate gives the direction
            z = guide.through
            yield GivenRow(f"{upright}_{{{name}}}", z.real if upright == "x" else z.imag, "m", place=True)
            return
        if guide.through_point is None:
            yield from self.place(name, guide.through)
        yield GivenRow(f"∠{name}", guide.angle_deg, "°", place=True)

    def lengths(self, link: Link) -> Iterator[GivenRow]:
        """Places of a link's points in its axes, in the shortest form, its guides, its place on the guide it slides
        on."""
        first = link.first_point
        for point, z in link.points.items():
            way = z - link.points[first]
            polar = abs(way), round(math.degrees(cmath.phase(way)), 9)
            name = f"l_{first}{point}"
            length = self.parameters.get(name, polar[0])  # may be a coordinate
            plain = name in self.parameters if self.steady else _signs(*polar) <= _signs(way.real, way.imag)
            if way.imag and not (plain and equal(length, polar[0])):
                yield from self.place(first + point, way)
                continue
            yield GivenRow(f"l_{{{first}{point}}}", polar[0], "m")
            yield GivenRow(f"∠{first}{point}", polar[1], "°")
        for guide in link.guides.values():
            yield GivenRow(f"∠{dashed(guide.name)}", guide.angle_deg, "°")
            if guide.through_point is None:
                yield from self.place(first + dashed(guide.name), guide.through - link.points[first])
        if link.slides:
            yield GivenRow(f"e_{{{self.naming.link(link.name)}}}", link.slides.offset or 0.0, "m")
            yield GivenRow(f"∠{self.naming.link(link.name)}", link.slides.angle_deg or 0.0, "°")

    def intensities(self, load: StaticLoad) -> Iterator[GivenRow]:
        """A distributed load: one intensity, or one at each of its ends."""
        first, last = load.intensity
        index = "".join(map(self.naming.point, load.spread or ()))
        if first == last:
            yield GivenRow(f"q_{{{index}}}", first, "N/m")
            return
        for point, value in zip(load.spread or (), load.intensity, strict=True):
            yield GivenRow(f"q_{{{index}}}^{{{self.naming.point(point)}}}", value, "N/m", place=True)

    def loads(self) -> Iterator[GivenRow]:
        """Forces and couples as lettered on the sheet. In statics a distributed load is given by its intensity, not by
        its resultant, and the ray of a pole acts on no body."""
        plans = self.plans
        resultants = {load.name for load in plans.figure.spread} if plans.figure else set()
        for name, m in plans.means.items():
            stated = m.of not in resultants and bool(m.link or not plans.figure)
            if stated and name in plans.given and m.quantity in ("load", "couple"):
                unit = "N" if m.quantity == "load" else "N·m"
                yield GivenRow(self.naming.vector(m.of), float(plans.given[name]), unit, name)
        mechanism = plans.mechanism
        for name, load in zip(load_names(mechanism), mechanism.loads, strict=True):
            if isinstance(load.direction_deg, float | int):
                axes = f"^{{({self.naming.link(load.direction_link)})}}" if load.direction_link else ""
                sign = f"∠{self.naming.vector(name)}{axes}"
                yield GivenRow(sign, load.direction_deg, "°", f"angle_∠{name}", place=True)

    def laws(self) -> Iterator[tuple[str, str, str]]:
        """Loads given by laws, each with its value in this position."""
        drawing, lang = self.position.drawing, self.naming.lang
        for name, sign, key, _ in self.ruled():
            yield sign, number(float(drawing[name]), lang) if name in drawing else "—", say(key, lang)

    def formulas(self) -> Iterator[str]:
        """The laws of loads."""
        lang = self.naming.lang
        for _, sign, key, law in self.ruled():
            if not isinstance(law, StrokeLoad):
                yield f"{sign} = {self.measured(law, key)}"
                continue
            for word, part in (("stroke_working", law.working), ("stroke_idle", law.idle)):
                yield f"{sign} = {self.measured(part, key)} ({say(word, lang)})"

    def ruled(self) -> Iterator[tuple[str, str, str, Amount | StrokeLoad]]:
        """Loads given by laws: their lettered names, the keys of their units, the laws."""
        plans = self.plans
        for name, law in plans.acting.laws.items() if plans.forces else ():
            m = plans.means[name]
            key, sign = {"load": "N", "couple": "N·m"}.get(m.quantity, "°"), self.naming.vector(m.of)
            yield name, f"∠{sign}" if key == "°" else sign, key, law

    def measured(self, law: Amount, key: str) -> str:
        """A law with its unit, separated from a formula by a comma."""
        return f"{self.law(law)}{' ' if isinstance(law, int | float) else ', '}{say(key, self.naming.lang)}"

    def law(self, law: Amount) -> str:
        """A law, as much of it as fits in a cell."""
        drive = self.plans.drive
        text = law_said(law, drive, self.naming.vector, self.naming.lang, pairs=False)
        return text if len(text) <= LONGEST else "…"


def dashed(name: str) -> str:
    """The name of a guide as printed."""
    return name.replace("-", "–")


def _signs(*values: float) -> int:
    """The printed length of numbers."""
    return sum(len(number(v, "en", DIGITS)) for v in values)


def _unit(name: str, value: float) -> bool:
    """Whether a parameter is a unit for other numbers: by its name and its value."""
    return name in FACTORS and math.isclose(value, evaluate(FACTORS[name], {}), rel_tol=1e-3)
