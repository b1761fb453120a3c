"""Motion over the cycle: diagrams against the driver's place, and hodographs, ends of a vector laid off from a pole."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from planes.diagrams.driven import driven
from planes.plans import Plans
from planes.words import say
from planes.words.lettering import Naming
from planes.words.names import letter_of
from planes.words.units import number, standard_mu
from render import labels
from render.paper.letters import scale, unit
from render.paper.marks import Arrow, Line, Mark, Text
from render.paper.symbols import dot
from render.views import View, beside, view

SECTIONS = 12
WIDTHS_MM = (12.0, 15.0, 18.0, 24.0, 30.0)  # of a section: over a whole turn μ_φ is 0.4, 0.5, … mm per degree
TALL = 2.1  # the largest ordinate, over a section
BETWEEN_MM = 12.0
FULL = 360.0
STEEP = 5.0  # ordinates are cut at so many times their median at the ends of a range, which are dead positions
WILD = 30.0  # and at so many anywhere


@dataclass(frozen=True)
class DiagramCurve:
    """One quantity over the turn: its letter, its unit, and a value or None for every angle. ``name`` is its whole name
    as it is lettered, where it is not the driven link's own; ``places`` its angles, where they are finer than the
    others' and None marks a jump."""

    letter: str
    unit: str
    values: tuple[float | None, ...]
    name: str = ""
    places: tuple[float, ...] = ()


def section_mm(size: float) -> float:
    """The width of a section, so many times its usual one."""
    return max(w for w in WIDTHS_MM if w <= max(1.0, size) * WIDTHS_MM[0] + 1e-9)


@dataclass(frozen=True)
class Diagrams:
    """Diagrams one beneath the other over the driver's range: three of the driven link, or those asked for."""

    plans: Plans
    angles: Sequence[float]
    curves: Sequence[DiagramCurve]
    naming: Naming
    section: float = WIDTHS_MM[0]
    whole: bool = True

    @property
    def title(self) -> str:
        """What they show."""
        if any(curve.name for curve in self.curves):
            return say("diagrams_asked", self.naming.lang)
        link, slides = driven(self.plans)
        key = "diagrams_slider" if slides else "diagrams_link"
        return say(key, self.naming.lang, link=self.naming.link(link))

    def drawn(self) -> tuple[Mark, ...]:
        """Axes, curves, numbers of positions and scales."""
        marks: list[Mark] = []
        zero, lowest = 0.0, 0.0
        for curve in self.curves:
            curve = curve if self.whole else cut_off(curve)
            known = [v for v in curve.values if v is not None]
            mu = standard_mu(max(map(abs, known), default=0.0), TALL * self.section)
            top, bottom = mu * max([0.0, *known]), mu * min([0.0, *known])
            zero = (lowest - BETWEEN_MM - 7.0 - top) if marks else 0.0
            for x in (self.section * k for k in range(1, SECTIONS + 1)):  # thin verticals at the numbered positions
                ends = complex(x, zero + bottom - 1.5), complex(x, zero + top + 1.5)
                marks.append(Line(ends, "construction", "construction"))
            marks += self.one(curve, mu, zero, top)
            lowest = zero + bottom
        return (*marks, *self.numbers(lowest - 6.5))

    def one(self, curve: DiagramCurve, mu: float, zero: float, top: float) -> list[Mark]:
        """One curve on its axes, its zero line at the height ``zero``."""
        wide = self.section * SECTIONS
        marks: list[Mark] = [
            Arrow(complex(0, zero), complex(wide + 9, zero), "thin", "dimension"),
            Arrow(complex(0, zero), complex(0, zero + top + 8), "thin", "dimension"),
            Text(self.abscissa, complex(wide + 10.5, zero - 1), 3.5),
        ]
        name = curve.name or f"{curve.letter}_{{{self.naming.link(driven(self.plans)[0])}}}"
        text = f"{name}, μ_{{{curve.letter}}} = {scale(mu, curve.unit, self.naming.lang)}"
        marks.append(Text(text, complex(2.5, zero + top + 5), 3.5))
        for piece in pieces(curve.places or self.angles, curve.values):
            points = tuple(complex(self.x(a), zero + mu * v) for a, v in piece)
            marks.append(Line(points, "thick", "plan"))
        for angle, *ends in jumps(curve):
            marks.append(Line(tuple(complex(self.x(angle), zero + mu * v) for v in ends), "dash", "plan"))
        return marks

    @property
    def abscissa(self) -> str:
        """The letter of the driver's place."""
        drive = self.plans.mechanism.drive
        return f"{'φ' if drive.kind == 'phi' else 's'}_{{{self.naming.link(drive.link)}}}"

    def x(self, angle: float) -> float:
        """The place of an angle on the axis, from the first one."""
        return (angle - self.angles[0]) / (self.angles[-1] - self.angles[0]) * self.section * SECTIONS

    def numbers(self, level: float) -> list[Mark]:
        """Numbers of the positions beneath, the driver's place in the first, and the scale of the axis."""
        places = (complex(self.section * k, level) for k in range(SECTIONS + 1))
        found: list[Mark] = [Text(str(k), z, 3.5, "middle") for k, z in enumerate(places)]
        turning, lang = self.plans.mechanism.drive.kind == "phi", self.naming.lang
        letter, key = ("φ", "°") if turning else ("s", "m")
        first = round(self.angles[0], 6) % FULL if turning else self.angles[0]
        start = f"{letter}_{{0}} = {number(first, lang)}{'' if turning else ' '}{unit(key, lang)}"
        mu = self.section * SECTIONS / (self.angles[-1] - self.angles[0])
        text = f"{start},  μ_{{{letter}}} = {scale(mu, key, lang)}"
        return [*found, Text(text, complex(self.section * SECTIONS / 2, level - 7.0), 3.5, "middle")]


def cut_off(curve: DiagramCurve) -> DiagramCurve:
    """A curve without ordinates far beyond the rest, which grow without bounds beside dead positions."""
    sizes = sorted(abs(v) for v in curve.values if v is not None)
    usual = sizes[len(sizes) // 2] if sizes else 0.0
    calm = [k for k, v in enumerate(curve.values) if v is not None and abs(v) <= STEEP * usual]
    low, high = (calm[0], calm[-1]) if calm else (0, 0)
    near = [v is not None and abs(v) <= WILD * usual for v in curve.values]
    kept = (v if near[k] and low <= k <= high else None for k, v in enumerate(curve.values))
    return replace(curve, values=tuple(kept))


def jumps(curve: DiagramCurve) -> list[tuple[float, float, float]]:
    """Where a curve of its own places breaks off and goes on: the angle, the value before and the one after."""
    rows = zip(curve.places, curve.places[2:], curve.values, curve.values[1:], curve.values[2:], strict=False)
    near = ((a, y, z) for a, b, y, gap, z in rows if gap is None and abs(b - a) < 1e-4)
    return [(a, y, z) for a, y, z in near if y is not None and z is not None]


def pieces(angles: Sequence[float], values: Sequence[float | None]) -> list[list[tuple[float, float]]]:
    """Runs of angles at which the mechanism works."""
    runs = groupby(zip(angles, values, strict=True), key=lambda row: row[1] is not None)
    found = ([(angle, value) for angle, value in run if value is not None] for _, run in runs)
    return [piece for piece in found if len(piece) > 1]


WIDE_MM = 70.0  # the larger side of a hodograph
AXIS_MM = 8.0  # of the axes beyond it
APART_MM = 14.0


@dataclass(frozen=True)
class Hodograph:
    """A vector over the cycle, as complex numbers in ``unit`` (None where the mechanism does not assemble; a single one
    is a jump), and at the numbered positions."""

    name: str
    unit: str
    path: tuple[complex | None, ...]
    stations: tuple[complex | None, ...]


def hodograph_view(loops: Sequence[Hodograph], naming: Naming) -> View:
    """Hodographs side by side, each under its name and scale."""
    row = beside([_one(loop, naming) for loop in loops], APART_MM, top=0.0)
    return view("hodographs", "", row.marks, figure=True)


def _one(loop: Hodograph, naming: Naming) -> View:
    lang = naming.lang
    known = [z for z in loop.path if z is not None] + [0j]
    x, y = [z.real for z in known], [z.imag for z in known]
    mu = standard_mu(max(max(x) - min(x), max(y) - min(y)), WIDE_MM)
    title = f"{say('hodograph', lang, name=loop.name)}, μ_{{{letter_of(loop.name)}}} = {scale(mu, loop.unit, lang)}"
    return view("hodograph", title, _drawn(loop, mu, [z * mu for z in known]), height=3.5)


def _drawn(loop: Hodograph, mu: float, inked: Sequence[complex]) -> list[Mark]:
    low = complex(min(z.real for z in inked) - AXIS_MM, min(z.imag for z in inked) - AXIS_MM)
    high = complex(max(z.real for z in inked) + AXIS_MM, max(z.imag for z in inked) + AXIS_MM)
    ground: list[Mark] = [
        Arrow(complex(low.real, 0), complex(high.real, 0), "thin", "dimension"),
        Arrow(complex(0, low.imag), complex(0, high.imag), "thin", "dimension"),
    ]
    for piece, jump in _runs([None if z is None else z * mu for z in loop.path]):
        ground.append(Line(tuple(piece), "dash" if jump else "thick", "plan"))
    ends = (("x", complex(high.real, 0)), ("y", complex(0, high.imag)), ("p", 0j))
    named = [labels.Label(text, z, 3.5, clear=0.8, name=text) for text, z in ends]
    seen: list[complex] = []
    for k, z in enumerate(loop.stations):
        if z is None or any(abs(z - other) * mu < 0.4 for other in seen):
            continue
        seen.append(z)
        ground += dot(z * mu, 0.6, "plan")
        named.append(labels.Label(str(k), z * mu, 2.5, clear=0.8, name=f"position {k}"))
    placed = labels.place(named, ground)
    return [*ground, *placed.marks]


def _runs(path: Sequence[complex | None]) -> list[tuple[list[complex], bool]]:
    """Runs of a path, with the jumps over its single gaps."""
    found: list[tuple[list[complex], bool]] = []
    run: list[complex] = []
    gap = 0
    for z in path:
        if z is None:
            gap += 1
            continue
        if gap == 1 and run:
            found += [(run, False), ([run[-1], z], True)]
        elif gap and run:
            found.append((run, False))
        run = [z] if gap else [*run, z]
        gap = 0
    return [(piece, jump) for piece, jump in [*found, (run, False)] if len(piece) > 1]
