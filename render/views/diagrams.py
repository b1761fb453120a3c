"""Motion over the cycle: diagrams over the driver's position."""

import math
from collections.abc import Sequence
from itertools import cycle

from planes.plans import Plans
from planes.plans.curves import driven_link_and_sliding
from planes.words import say
from planes.words.frozen import frozen
from planes.words.lettering import without_index_markup
from planes.words.names import NamePair
from planes.words.naming import Naming
from planes.words.read_off import read_off_text
from planes.words.units import number_text, standard_mu
from render.labels import Label
from render.paper.letters import mu_with_unit, name_with_unit, value_with_unit
from render.paper.marks import Arrow, Line, Mark, Text
from render.paper.style import figure_letter_height
from render.paper.symbols import Marks, dot
from render.paper.typeset import ink_width
from render.views.curve_pieces import continuous_runs, round_value_step, round_values_between
from render.views.senses import marks_with_labels

SECTION_COUNT = 12
SECTION_WIDTHS_MM = (12.0, 15.0, 18.0, 24.0, 30.0)  # of a section: over a whole turn μ_φ is 0.4, 0.5, … mm per degree
MOST_RANGE_SECTIONS = 3.5  # from the least ordinate to the greatest, over a section
READABLE_RANGE_MM = 40.0  # from the least ordinate to the greatest, in diagrams with readable values
LEAST_ROUND_VALUE_GAP_MM = 5.0  # least distance of round values on their ordinate
TICK_LENGTH_MM = 1.5  # length of a tick
LEAST_VARIATION_RATIO = 1e-6  # relative to their size: positions that vary less are constant
CURVE_LINE_STYLES = ("thick", "dash", "thin", "axis", "phantom", "construction")  # of curves on the same axes
LINE_SAMPLE_LENGTH_MM = 18.0  # length of the line sample beside the name of a curve, with all its dashes
MOST_JUMP_STEP_MM = 0.01  # a step no longer than this along the axis is a jump
DIAGRAM_GAP_MM = 12.0
NAME_LETTER_MM = 3.5  # letter heights of axes and numbers
MOST_HEADING_LETTERS = 14.0  # letter heights: largest width of a curve's name with its μ
FULL_TURN_DEG = 360.0


@frozen
class DiagramCurve:
    """One quantity over the turn: its letter, its unit, and a value or None for every angle. ``name`` is its whole
    lettered name, where it is not the driven link's own; ``places`` are its angles, where they are finer than the
    others' and None marks a jump; ``ends`` where it is least and where greatest, with these values; the zero of a
    ``place`` need not be visible."""

    letter: str
    unit: str
    values: tuple[float | None, ...]
    name: str = ""
    places: tuple[float, ...] = ()
    ends: tuple[tuple[float, float], ...] = ()
    place: bool = False

    @property
    def is_closed(self) -> bool:
        """Whether it ends where it begins, unlike the angle of a link that turns fully."""
        first = self.values[0]
        last = self.values[-1]
        size = max((abs(v) for v in self.values if v is not None), default=0.0)
        return first is not None and last is not None and abs(last - first) <= LEAST_VARIATION_RATIO * size


@frozen
class Axes:
    """Axes of curves on paper: μ, the height of the driver's axis and the value there, the range of heights of the
    curves, and the extra height of their names, mm."""

    mu: float
    zero: float
    base: float
    bottom: float
    top: float
    lift: float = 0.0

    def value_place(self, x: float, value: float) -> complex:
        """The place of a value."""
        return complex(x, self.zero + self.mu * (value - self.base))


def section_width_mm(size: float) -> float:
    """The width of a section, a multiple of the usual one."""
    return max(w for w in SECTION_WIDTHS_MM if w <= max(1.0, size) * SECTION_WIDTHS_MM[0] + 1e-9)


@frozen
class Diagrams:
    """Diagrams one beneath another over the driver's range: three of the driven link, or those requested, each with all
    the curves on its axes. Those ``to_read`` have round values on the ordinates, the least and the greatest, and the
    driver's position at every numbered position."""

    plans: Plans
    angles: Sequence[float]
    panels: Sequence[Sequence[DiagramCurve]]
    naming: Naming
    section: float = SECTION_WIDTHS_MM[0]
    whole: bool = True
    to_read: bool = False

    @property
    def title(self) -> str:
        """Their title."""
        if any(curve.name for panel in self.panels for curve in panel):
            return say("diagrams_asked", self.naming.lang)
        link, slides = driven_link_and_sliding(self.plans)
        key = "diagrams_slider" if slides else "diagrams_link"
        return say(key, self.naming.lang, link=self.naming.link_number(link))

    @property
    def driver_letter_and_unit(self) -> NamePair:
        """The letter of the driver's coordinate, and its unit."""
        return ("φ", "°") if self.plans.drive.rotates else ("s", "m")

    @property
    def letter(self) -> float:
        """The height of names and numbers."""
        return figure_letter_height(NAME_LETTER_MM)

    @property
    def range_length(self) -> float:
        """The length of the driver's range, mm."""
        return self.section * SECTION_COUNT

    def drawn_marks(self) -> Marks:
        """Axes, curves, numbers of positions and scales."""
        marks = list[Mark]()
        lowest = 0.0
        for panel in self.panels:
            axes = self.make_axes(panel, lowest if marks else None)
            marks += self.panel_marks(panel, axes)
            lowest = axes.zero + axes.bottom
        return (*marks, *self.position_numbers(lowest - 8.0 - self.letter))

    def make_axes(self, panel: Sequence[DiagramCurve], above: float | None) -> Axes:
        """Axes of curves, beneath those that end ``above``; an axis for positions far from zero is beneath them."""
        known = [v for curve in panel for v in (*curve.values, *(v for _, v in curve.ends)) if v is not None]
        low = min(known, default=0.0)
        high = max(known, default=0.0)
        size = max(map(abs, known), default=0.0)
        afar = self.to_read and panel[0].place and low * high > 0
        if not afar:
            low = min(0.0, low)
            high = max(0.0, high)
        spread = high - low if high - low > LEAST_VARIATION_RATIO * size else size
        mu = standard_mu(spread, READABLE_RANGE_MM if self.to_read else MOST_RANGE_SECTIONS * self.section)
        step = round_value_step(mu, LEAST_ROUND_VALUE_GAP_MM)
        base = step * math.floor(low / step) if afar else 0.0
        top = mu * (high - base)
        ends = self.extreme_places(panel[0]) if len(panel) == 1 and not self.to_read else []
        under = any(
            side.imag > 0 and self.abscissa_of(place) < MOST_HEADING_LETTERS * self.letter for side, (place, _) in ends
        )
        lift = self.letter + 1.0 if under else 0.0  # room for the greatest value
        zero = 0.0 if above is None else above - DIAGRAM_GAP_MM - 7.0 - lift - top
        return Axes(mu, zero, base, mu * min(0.0, low - base), top, lift)

    def panel_marks(self, panel: Sequence[DiagramCurve], axes: Axes) -> Marks:
        """Curves on their axes, with thin verticals at the numbered positions."""
        low = axes.zero + axes.bottom
        zero = axes.zero
        high = axes.zero + axes.top
        key = self.driver_letter_and_unit[1]
        lang = self.naming.lang
        abscissa = self.naming.lettered_vector(self.plans.drive.motion_names[0])
        sides = (self.section * k for k in range(1, SECTION_COUNT + 1))
        marks = [
            *(Line((complex(x, low - 1.5), complex(x, high + 1.5)), "construction", "construction") for x in sides),
            Arrow(complex(0, zero), complex(self.range_length + 9, zero), "thin", "dimension"),
            Arrow(complex(0, low if self.to_read else zero), complex(0, high + axes.lift + 8), "thin", "dimension"),
            Text(
                name_with_unit(abscissa, key if self.to_read else "", lang),
                complex(self.range_length + 10.5, zero - 1),
                self.letter,
            ),
            *self.heading_marks(panel, axes.mu, complex(2.5, high + axes.lift + 5)),
        ]
        for curve, style in zip(panel, cycle(CURVE_LINE_STYLES), strict=False):
            rows = zip(curve.places or self.angles, curve.values, strict=True)
            path = [None if v is None else axes.value_place(self.abscissa_of(a), v) for a, v in rows]
            marks += (
                Line(tuple(z), "dash" if jump else style, "plan", name=curve.letter)
                for z, jump in continuous_runs(path, MOST_JUMP_STEP_MM)
            )
        marks += self.round_value_marks(axes) if self.to_read else ()
        if len(panel) == 1:
            return self.with_extreme_values(panel[0], axes, marks)
        return tuple(marks)

    def extreme_places(self, curve: DiagramCurve) -> list[tuple[complex, tuple[float, float]]]:
        """The least and greatest places of a curve, beneath it and above it, at the ends of the axis beside it; the
        given ones, or those of the drawn curve."""
        if curve.ends or self.to_read:
            return [*zip((-1j, 1j), curve.ends, strict=False)]
        angles = curve.places or self.angles
        values = curve.values
        count = len(angles) - 1
        closed = self.whole and curve.is_closed
        known = [(v, k) for k, v in enumerate(values[:count] if closed else values) if v is not None]
        ends = []
        for side, (value, k) in zip((-1j, 1j), (min(known), max(known)), strict=True) if known else ():
            beside = [(k - 1) % count, (k + 1) % count] if closed else [max(k - 1, 0), min(k + 1, count)]
            if k not in beside and all(values[j] is not None for j in beside):  # it continues outside the range
                k = k or count  # of a whole turn: there is more room at its end than at its beginning
                inwards = (SECTION_COUNT * k < count) - (SECTION_COUNT * (count - k) < count)
                ends.append((side + 2 * inwards, (angles[k], value)))
        return ends

    def heading_marks(self, panel: Sequence[DiagramCurve], mu: float, place: complex) -> list[Mark]:
        """The names of the curves, each with a sample of its line if there are several, and their scale."""
        lang = self.naming.lang
        link = ""
        if not all(curve.name for curve in panel):
            link = self.naming.link_number(driven_link_and_sliding(self.plans)[0])
        names = [curve.name or f"{curve.letter}_{{{link}}}" for curve in panel]
        if self.to_read:
            names = [name_with_unit(name, curve.unit, lang) for name, curve in zip(names, panel, strict=True)]
        letters = {c.letter + ("" if c.name else link): c.unit for c in panel}  # plans have a different μ_v
        scales = ", ".join(
            f"μ_{{{letter}}} = {mu_with_unit(mu, unit, self.naming)}" for letter, unit in letters.items()
        )
        if len(panel) == 1:
            return [Text(f"{names[0]}, {scales}", place, self.letter)]
        marks = list[Mark]()
        for name, style in zip(names, cycle(CURVE_LINE_STYLES), strict=False):
            marks.append(Line((place + 1.2j, place + complex(LINE_SAMPLE_LENGTH_MM, 1.2)), style, "plan"))
            marks.append(Text(name, place + LINE_SAMPLE_LENGTH_MM + 2, self.letter))
            place += LINE_SAMPLE_LENGTH_MM + 8 + ink_width(name, self.letter)
        return [*marks, Text(scales, place, self.letter)]

    def round_value_marks(self, axes: Axes) -> list[Mark]:
        """Round values on the ordinate."""
        lang = self.naming.lang
        added = list[Mark]()
        low, high = (axes.base + y / axes.mu for y in (axes.bottom, axes.top))
        for value in round_values_between(low, high, round_value_step(axes.mu, LEAST_ROUND_VALUE_GAP_MM)):
            z = axes.value_place(0.0, value)
            added.append(Line((z - TICK_LENGTH_MM, z), "thin", "dimension"))
            added.append(Text(number_text(value, lang, 6), z - complex(TICK_LENGTH_MM + 1, 1.25), 2.5, "end"))
        return added

    def with_extreme_values(self, curve: DiagramCurve, axes: Axes, marks: Sequence[Mark]) -> Marks:
        """The same with dots and values at the least and the greatest."""
        lang = self.naming.lang
        added = list(marks)
        named = []
        for side, (place, value) in self.extreme_places(curve):
            z = axes.value_place(self.abscissa_of(place), value)
            seen = abs(axes.mu * value) > 1e-6
            if seen or self.to_read:
                added += dot(z, 0.6, "plan")
                text = (
                    number_text(value if seen else 0.0, lang)
                    if self.to_read
                    else value_with_unit(read_off_text(value, lang), curve.unit, lang)
                )
                named.append(Label(text, z, 2.5, side, 0.8, name=text))
        return marks_with_labels(named, added)

    def abscissa_of(self, angle: float) -> float:
        """The place of an angle on the axis, from the first one."""
        return (angle - self.angles[0]) / (self.angles[-1] - self.angles[0]) * self.section * SECTION_COUNT

    def position_numbers(self, level: float) -> list[Mark]:
        """Numbers of the positions beneath, the driver's position at the first, or at each, and the scale of the
        axis."""
        places = [complex(self.section * k, level) for k in range(SECTION_COUNT + 1)]
        texts = [Text(str(k), z, self.letter, "middle") for k, z in enumerate(places)]
        letter, key = self.driver_letter_and_unit
        lang = self.naming.lang
        turning = key == "°"
        drive = without_index_markup(self.naming.lettered_vector(self.plans.drive.motion_names[0]))
        mu = self.range_length / abs(self.angles[-1] - self.angles[0])
        text = f"μ_{{{drive}}} = {mu_with_unit(mu, key, self.naming)}"
        if self.to_read:
            places_told = [round(a, 1 if turning else 3) for a in self.angles]
            places_told = [a % FULL_TURN_DEG for a in places_told] if turning and self.whole else places_told
            texts += (
                Text(number_text(a, lang), z - 5.5j, 2.5, "middle") for a, z in zip(places_told, places, strict=True)
            )
            level -= 5.5
        else:
            first = round(self.angles[0], 6) % FULL_TURN_DEG if turning else self.angles[0]
            text = f"{letter}_{{0}} = {value_with_unit(number_text(first, lang), key, lang)},  {text}"
        place = complex(self.range_length / 2, level - 2 * self.letter)
        return [*texts, Text(text + self.constant_rates_text(), place, self.letter, "middle")]

    def constant_rates_text(self) -> str:
        """That both rates of the driver are those given in every position, where the second is not the derivative of
        the first: nor are the curves."""
        drive = self.plans.drive
        if self.to_read or not drive.velocity or not drive.acceleration:
            return ""
        return f";  {', '.join(map(self.naming.lettered_vector, drive.motion_names[1:]))} = const"
