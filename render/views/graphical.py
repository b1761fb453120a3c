"""Graphical differentiation and integration drawn: diagrams one beneath another, poles with their rays, carried
ordinates, the constructed curve and, in dashes, the exact one."""

from collections.abc import Sequence
from itertools import pairwise

from planes.diagrams.graphical import Construction, Stage
from planes.drafting.drawing import Drawing
from planes.scene.ranges import Interval
from planes.words import say
from planes.words.frozen import frozen
from planes.words.names import PlanId
from planes.words.naming import Naming
from planes.words.units import UNITS_OF_PLACE_AND_RATES, number_text
from render.paper.letters import mu_with_unit
from render.paper.marks import Arc, Arrow, Line, Mark, Text
from render.paper.style import DOT_RADIUS_MM
from render.paper.symbols import Marks, dot
from render.paper.typeset import ink_width

DIAGRAM_GAP_MM = 15.0
AXIS_OVERRUN_MM = 9.0  # of an axis past its last section
PIECES_PER_INTERVAL = 8  # pieces of a drawn curve between two points
MU_FORMULAS = {
    "mm_per_unit": ("H·μ_{{{0}}}/μ_{{t}}", "μ_{{{0}}}·μ_{{t}}/H"),
    "unit_per_mm": ("μ_{{{0}}}/(H·μ_{{t}})", "H·μ_{{{0}}}·μ_{{t}}"),
}
"""μ of a diagram by differentiation and by integration, in either convention."""


@frozen
class Graphical:
    """A drawn construction, with its scales."""

    construction: Construction
    drawing: Drawing
    naming: Naming

    def drawn_marks(self) -> Marks:
        """All diagrams, the first one on top."""
        marks = []
        lowest = 0.0
        for k, stage in enumerate(self.construction.stages):
            bottom, top = self.ordinate_range(stage)
            zero = lowest - DIAGRAM_GAP_MM - top if k else 0.0
            marks += self.diagram_marks(stage, k, complex(0, zero), bottom, top)
            lowest = zero + min(bottom, self.pole_distance_room(stage) - 2.0 if stage.pole_mm else bottom)
        return (*marks, *self.position_numbers(lowest - 6.5), *self.line_legend(lowest - 15.0))

    def mark_place(self, plan: PlanId, label: str) -> complex:
        """The place of a mark from the origin of its diagram."""
        return complex(self.drawing[plan.mark(label)]) - complex(self.drawing[plan.mark("o")])

    def curve_points(self, stage: Stage) -> list[complex]:
        """The points of a diagram; for a closed turn, two more at either end."""
        own = [self.mark_place(stage.plan, label) for half, label in stage.points if half >= 0]
        if not self.construction.motion.closed or stage.given or self.construction.kind != "differentiation":
            return own
        wide = self.mark_place(stage.plan, "t").real
        return [*(z - wide for z in own[-2:]), *own, *(z + wide for z in own[:2])]

    def exact_curve(self, stage: Stage) -> list[complex]:
        """The exact curve."""
        m = self.construction.motion
        first = m.curves[0][0] if stage.rank == 0 else 0.0
        return [
            complex(t * self.construction.time_scale, (y - first) * stage.mu)
            for t, y in zip(m.dense_time, m.curves[stage.rank], strict=True)
        ]

    def ordinate_range(self, stage: Stage) -> Interval:
        """The lowest and the highest ordinate, mm."""
        levels = [0.0, *(z.imag for z in (*self.curve_points(stage), *self.exact_curve(stage)))]
        return min(levels), max(levels)

    # one diagram

    def diagram_marks(self, stage: Stage, k: int, zero: complex, bottom: float, top: float) -> list[Mark]:
        """Axes, sections, the exact curve, the construction and its result."""
        wide = self.mark_place(stage.plan, "t").real
        n = self.construction.motion.section_count
        ends = ((zero + wide * k / n + 1j * y for y in (bottom - 1.5, top + 1.5)) for k in range(1, n + 1))
        marks: list[Mark] = [Line(tuple(two), "construction", "construction") for two in ends]
        marks += [
            Arrow(zero, zero + wide + AXIS_OVERRUN_MM, "thin", "dimension"),
            Arrow(zero + 1j * min(0.0, bottom - 1.5), zero + 1j * (top + 9.0), "thin", "dimension"),
            Text("t", zero + complex(wide + AXIS_OVERRUN_MM + 1.5, -1), 3.5),
            Text(self.heading_text(stage, k), zero + complex(3.0, top + 6.0), 3.5),
        ]
        exact = tuple(zero + z for z in self.exact_curve(stage))
        marks.append(Line(exact, "thick" if stage.given else "dash", "plan"))
        return [*marks, *self.pole_marks(stage, zero), *self.curve_marks(stage, zero, wide)]

    def heading_text(self, stage: Stage, k: int) -> str:
        """The quantity and its scale, with its formula."""
        c = self.construction
        letters = "sva" if self.construction.motion.slides else "φωε"
        own = letters[stage.rank]
        text = f"{own}_{{{self.naming.link_number(c.motion.link)}}};  μ_{{{own}}} = "
        if k:
            other = letters[c.stages[k - 1].rank]
            ways = MU_FORMULAS[self.naming.convention]
            text += f"{ways[c.kind != 'differentiation'].format(other)} = "
        text += mu_with_unit(stage.mu, UNITS_OF_PLACE_AND_RATES[c.motion.slides][stage.rank], self.naming)
        if k:
            return text
        return f"{text};  μ_{{t}} = {mu_with_unit(c.time_scale, 's', self.naming)}"

    def pole_marks(self, stage: Stage, zero: complex) -> list[Mark]:
        """The pole, its rays to the axis of ordinates, and its distance."""
        if stage.pole_mm is None:
            return []
        low = zero + self.mark_place(stage.plan, "P")
        high = zero
        level = self.pole_distance_room(stage)
        marks: list[Mark] = [Line((low, zero + h), "construction", "construction") for h in self.ray_crossings(stage)]
        marks += [*dot(low, 0.6, "construction"), Line((low, zero), "thin", "dimension")]
        text = f"H = {number_text(stage.pole_mm, self.naming.lang)}"
        middle = (low + high) / 2
        written = Text(text, middle + 1j * (level + 1.2), 3.5, "middle")
        if ink_width(text, 3.5) > stage.pole_mm - 2.0:  # beside a short distance, on an extension of its line
            written = Text(text, low + complex(-4.0, level - 1.3), 3.5, "end")
            marks.append(Line((low + complex(-3.0, level), low + 1j * level), "thin", "dimension"))
        return [
            *marks,
            written,
            Text("P", low + complex(-1.5, -1.2), 3.5, "end"),
            Line((low, low + 1j * (level - 1.0)), "thin", "dimension"),
            Line(
                (high + 1j * min(0.0, self.ordinate_range(stage)[0] - 1.5), high + 1j * (level - 1.0)),
                "thin",
                "dimension",
            ),
            *(Arrow(middle + 1j * level, end + 1j * level, "thin", "dimension") for end in (low, high)),
        ]

    def pole_distance_room(self, stage: Stage) -> float:
        """Room for the pole distance: beneath all the rays."""
        return min(0.0, *(z.imag for z in self.ray_crossings(stage))) - 7.0

    def ray_crossing_labels(self, stage: Stage) -> list[str]:
        """Labels of the points whose ordinates are on the axis too."""
        labels = [label for half, label in stage.points if half >= 0]
        if self.construction.kind == "integration":
            labels = [f"{k}½" for k in range(self.construction.motion.section_count)]
        return [x for x in labels if stage.plan.mark(f"h{x}") in self.drawing.things]

    def ray_crossings(self, stage: Stage) -> list[complex]:
        """Where the rays meet the axis of ordinates."""
        return [self.mark_place(stage.plan, f"h{x}") for x in self.ray_crossing_labels(stage)]

    def curve_marks(self, stage: Stage, zero: complex, wide: float) -> list[Mark]:
        """The points and the curve through them (for an integral its polygon), with its construction."""
        points = self.curve_points(stage)
        by_chords = self.construction.kind == "differentiation"
        marks = []
        for label in self.ray_crossing_labels(stage):  # ordinates carried to or from the axis
            cut = self.mark_place(stage.plan, f"h{label}")
            point = self.mark_place(stage.plan, label)
            marks.append(Line((zero + cut, zero + point), "construction", "construction"))
        if by_chords and stage.rank < 2:
            near = wide / self.construction.motion.section_count / 2 + 1e-6
            ends = [z for z in points if -near <= z.real <= wide + 1e-6]
            marks += [Line((zero + a, zero + b), "construction", "construction") for a, b in pairwise(ends)]
        if not stage.given:
            path = crop_curve(smooth_curve(points), wide) if by_chords else points
            marks.append(Line(tuple(zero + z for z in path), "thick", "plan"))
        inside = [z for z in points if -1e-6 <= z.real <= wide + 1e-6]
        return [*marks, *(Arc(zero + z, DOT_RADIUS_MM * 0.75, style="thin", layer="plan", fill="ink") for z in inside)]

    # beneath

    def position_numbers(self, level: float) -> list[Mark]:
        """Numbers of the positions and the driver's angle at the first."""
        m = self.construction.motion
        wide = self.mark_place(self.construction.stages[0].plan, "t").real
        every = 1 if m.section_count <= 24 else 2
        texts = [
            Text(str(k), complex(wide * k / m.section_count, level), 3.5, "middle")
            for k in range(0, m.section_count + 1, every)
        ]
        start = f"φ_{{0}} = {number_text(round(m.angles[0] % 360.0, 4), self.naming.lang)}°"
        return [*texts, Text(start, complex(wide + 6, level), 3.5)]

    def line_legend(self, level: float) -> list[Mark]:
        """A legend of the lines."""
        marks = list[Mark]()
        for x, style, key in ((0, "thick", "graphical_drawn"), (62, "dash", "graphical_exact")):
            marks.append(Line((complex(x, level), complex(x + 14, level)), style, "plan"))
            marks.append(Text(say(key, self.naming.lang), complex(x + 16, level - 1.3), 3.5))
        return marks


def smooth_curve(points: Sequence[complex]) -> list[complex]:
    """A curve through points as with a French curve: cubic pieces whose slopes follow the neighbours."""
    if len(points) < 3:
        return list(points)
    ends = [2 * points[0] - points[1], *points, 2 * points[-1] - points[-2]]
    curve = []
    for a, b, c, d in zip(ends, ends[1:], ends[2:], ends[3:], strict=False):
        m = (c - a) / 2
        n = (d - b) / 2
        for k in range(PIECES_PER_INTERVAL):
            t = k / PIECES_PER_INTERVAL
            curve.append(b + t * (m + t * (3 * (c - b) - 2 * m - n + t * (m + n - 2 * (c - b)))))
    return [*curve, points[-1]]


def crop_curve(path: Sequence[complex], wide: float) -> list[complex]:
    """The part of a curve over the axis, clipped exactly at both ends."""
    kept = []
    for a, b in pairwise(path):
        for x in (0.0, wide):
            if (a.real - x) * (b.real - x) < 0:
                kept.append(a + (b - a) * (x - a.real) / (b.real - a.real))
        if 0.0 <= b.real <= wide:
            kept.append(b)
    if kept:
        return [z for z in [path[0], *kept] if -1e-9 <= z.real <= wide + 1e-9]
    return list(path)
