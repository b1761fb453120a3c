"""Small figures of directions beside the plans: a relative vector carried to its point shows the sense in which its
link turns; a relative velocity turned with its guide by a right angle, Coriolis' acceleration."""

import math
from collections.abc import Iterator, Sequence

from planes.drafting.program import StepsByName
from planes.drafting.steps import LayOff, Through, Turn
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.lesson.reckoning import quotients_by_name
from planes.solving import Position
from planes.words.frozen import frozen, replace
from planes.words.names import NamePair, split_value_name
from planes.words.naming import Naming
from render.labels import Label
from render.paper.marks import Arrow, Line, Mark
from render.paper.style import figure_letter_height
from render.paper.symbols import bar, hinge, turn_arrow, unit_vector
from render.views import View, make_view, put_views_in_row, stack_views
from render.views.formulas import ROUNDING_NOISE_MM
from render.views.plotted import direction_deg
from render.views.senses import marks_with_labels

# in letter heights: its rod, its vectors, the radius of its curved arrow
ROD_LENGTH_LETTERS = 3.7
VECTOR_LENGTH_LETTERS = 2.3
SENSE_RADIUS_LETTERS = 1.6
SENSE_SWEEP_DEG, SENSE_START_GAP_DEG = 65.0, 15.0  # angle of a curved arrow, and its gap from the rod
FIGURES_PER_ROW = 5  # distance of figures
FIGURE_LETTER_MM = 3.5


@frozen
class Directions:
    """The figures of a position."""

    position: Position
    naming: Naming

    @property
    def steps_by_result(self) -> StepsByName:
        """The steps by their results."""
        return self.position.drawing.program.steps_by_result

    @property
    def letter(self) -> float:
        """The height of their letters, the unit of all lengths."""
        return figure_letter_height(FIGURE_LETTER_MM)

    def directions_view(self, title: str) -> View | None:
        """All figures in rows; none where nothing turns."""
        cells = [make_view("direction", "", cell) for cell in (*self.rotation_figures(), *self.coriolis_figures())]
        rows = [put_views_in_row(cells[k : k + FIGURES_PER_ROW], 6.0) for k in range(0, len(cells), FIGURES_PER_ROW)]
        figure = make_view("directions", title, stack_views("directions", rows).marks) if rows else None
        return figure and replace(figure, extra=True)

    def rotation_figures(self) -> Iterator[Sequence[Mark]]:
        """A rod with the vector of its far end, and the resulting sense of ω or ε."""
        links = self.position.plans.links.values()
        rates = {name for x in links for name in (x.omega, x.epsilon)}
        for rate, (vector, _) in quotients_by_name(self.position.drawing.program).items():
            step = self.steps_by_result.get(vector) if rate in rates else None
            if (
                isinstance(step, Measure)
                and (rod := self.perpendicular_scheme_line(step.along))
                and (way := self.segment_direction(step.start, step.end))
            ):
                yield self.turning(rod, way, vector, rate)

    def perpendicular_scheme_line(self, across: str | None) -> Through | None:
        """The line of the scheme to which a direction is perpendicular."""
        turn = self.steps_by_result.get(across or "")
        line = self.steps_by_result.get(turn.of) if isinstance(turn, Turn) else None
        return line if isinstance(line, Through) else None

    def segment_direction(self, start: str, end: str) -> complex:
        """The direction of a segment; 0 where it is too short to have one."""
        z = complex(self.position.drawing[end]) - complex(self.position.drawing[start])
        return z / abs(z) if abs(z) > ROUNDING_NOISE_MM else 0j

    def turning(self, rod: Through, way: complex, vector: str, rate: str) -> Sequence[Mark]:
        """One rod."""
        tip = ROD_LENGTH_LETTERS * self.letter * self.segment_direction(rod.start, rod.end)
        ground = [*bar(0j, tip), *hinge(0j), *hinge(tip)]
        ends = ((rod.start, 0j), (rod.end, tip))
        letters = [Label(self.naming.lettered_point(x.label), z, FIGURE_LETTER_MM, clear=1.6, name=x) for x, z in ends]
        vectors = [Arrow(tip, tip + VECTOR_LENGTH_LETTERS * self.letter * way, "vector", "plan", vector)]
        return self.figure_with_sense(ground, vectors, rate, direction_deg(tip), letters)

    def coriolis_figures(self) -> Iterator[Sequence[Mark]]:
        """A guide with the relative velocity on it, and the acceleration that follows from the guide's rotation."""
        for laid in (
            s for s in self.steps_by_result.values() if isinstance(s, LayOff) and split_value_name(s.length)[2] == "k"
        ):
            made = self.steps_by_result[laid.length]
            rate, velocity = (name for name, _ in made.terms[0].factors) if isinstance(made, Calculate) else ("", "")
            slid = self.steps_by_result.get(velocity)
            across = self.segment_direction(laid.start, laid.makes)
            if isinstance(slid, Measure) and (way := self.segment_direction(slid.start, slid.end)) and across:
                yield self.coriolis_figure(way, across, rate, (velocity, laid.length))

    def coriolis_figure(self, way: complex, across: complex, rate: str, names: NamePair) -> Sequence[Mark]:
        """One guide."""
        vectors = [
            Arrow(0j, length * z, "vector", "plan", name)
            for length, z, name in zip(
                (ROD_LENGTH_LETTERS * self.letter, VECTOR_LENGTH_LETTERS * self.letter),
                (way, across),
                names,
                strict=True,
            )
        ]
        guide = Line(
            (-VECTOR_LENGTH_LETTERS * self.letter / 2 * way, 1.2 * ROD_LENGTH_LETTERS * self.letter * way),
            "axis",
            "axis",
        )
        return self.figure_with_sense([guide], vectors, rate, direction_deg(way), ())

    def figure_with_sense(
        self, ground: Sequence[Mark], vectors: Sequence[Arrow], rate: str, from_deg: float, letters: Sequence[Label]
    ) -> Sequence[Mark]:
        """A figure with its vectors and the curved arrow of an angular velocity or acceleration, and all letters."""
        sense = math.copysign(1.0, float(self.position.drawing[rate]))
        kind, link, _ = split_value_name(rate)
        turning = turn_arrow(
            0j, SENSE_RADIUS_LETTERS * self.letter, from_deg + sense * SENSE_START_GAP_DEG, sense * SENSE_SWEEP_DEG
        )
        middle = (
            SENSE_RADIUS_LETTERS
            * self.letter
            * unit_vector(from_deg + sense * (SENSE_START_GAP_DEG + SENSE_SWEEP_DEG / 2))
        )
        rates = f"{'ω' if kind == 'omega' else 'ε'}_{{{self.naming.link_number(link)}}}"
        named = [
            Label(self.naming.lettered_vector(a.name), (a.end, (a.start + a.end) / 2), FIGURE_LETTER_MM, name=a.name)
            for a in vectors
        ]
        turns = Label(rates, middle, FIGURE_LETTER_MM, side=middle, clear=0.5, name=rate)
        return marks_with_labels([*letters, *named, turns], [*ground, *vectors, *turning])
