"""Small figures of directions beside the plans: a relative vector carried to its point shows the sense in which its
link turns; a relative velocity turned with its guide by a right angle, Coriolis' acceleration."""

import math
from collections.abc import Iterator, Sequence

from planes.drafting.steps import LayOff, Step, Through, Turn
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.lesson.reckoning import quotients
from planes.solving import Position
from planes.words.frozen import frozen, replace
from planes.words.names import label_of, parts_of
from planes.words.naming import Naming
from render.labels import Label
from render.paper.marks import Arrow, Line, Mark
from render.paper.style import tall
from render.paper.symbols import bar, hinge, turn_arrow, unit
from render.views import View, beside, stacked, view
from render.views.formulas import NOISE_MM
from render.views.plotted import degrees
from render.views.senses import labelled

ROD, ARROW, SENSE = 3.7, 2.3, 1.6  # in letter heights: its rod, its vectors, the radius of its curved arrow
SWEEP_DEG, FROM_DEG = 65.0, 15.0  # angle of a curved arrow, and its gap from the rod
A_ROW = 5  # distance of figures
LETTER_MM = 3.5


@frozen
class Directions:
    """The figures of a position."""

    position: Position
    naming: Naming

    @property
    def steps(self) -> dict[str, Step]:
        """The steps by their results."""
        return self.position.drawing.program.makers

    @property
    def letter(self) -> float:
        """The height of their letters, the unit of all lengths."""
        return tall(LETTER_MM)

    def view(self, title: str) -> View | None:
        """All figures in rows; none where nothing turns."""
        cells = [view("direction", "", cell) for cell in (*self.turned(), *self.coriolis())]
        rows = [beside(cells[k : k + A_ROW], 6.0) for k in range(0, len(cells), A_ROW)]
        figure = view("directions", title, stacked("directions", rows).marks) if rows else None
        return figure and replace(figure, extra=True)

    def turned(self) -> Iterator[Sequence[Mark]]:
        """A rod with the vector of its far end, and the resulting sense of ω or ε."""
        links = self.position.plans.links.values()
        rates = {name for x in links for name in (x.omega, x.epsilon)}
        for rate, (vector, _) in quotients(self.position.drawing.program).items():
            step = self.steps.get(vector) if rate in rates else None
            if isinstance(step, Measure) and (rod := self.rod(step.along)) and (way := self.way(step.start, step.end)):
                yield self.turning(rod, way, vector, rate)

    def rod(self, across: str | None) -> Through | None:
        """The line of the scheme to which a direction is perpendicular."""
        turn = self.steps.get(across or "")
        line = self.steps.get(turn.of) if isinstance(turn, Turn) else None
        return line if isinstance(line, Through) else None

    def way(self, start: str, end: str) -> complex:
        """The direction of a segment; 0 where it is too short to have one."""
        z = complex(self.position.drawing[end]) - complex(self.position.drawing[start])
        return z / abs(z) if abs(z) > NOISE_MM else 0j

    def turning(self, rod: Through, way: complex, vector: str, rate: str) -> Sequence[Mark]:
        """One rod."""
        tip = ROD * self.letter * self.way(rod.start, rod.end)
        ground = [*bar(0j, tip), *hinge(0j), *hinge(tip)]
        ends = ((rod.start, 0j), (rod.end, tip))
        letters = [Label(self.naming.point(label_of(x)), z, LETTER_MM, clear=1.6, name=x) for x, z in ends]
        vectors = [Arrow(tip, tip + ARROW * self.letter * way, "vector", "plan", vector)]
        return self.figure(ground, vectors, rate, degrees(tip), letters)

    def coriolis(self) -> Iterator[Sequence[Mark]]:
        """A guide with the relative velocity on it, and the acceleration that follows from the guide's rotation."""
        for laid in (s for s in self.steps.values() if isinstance(s, LayOff) and parts_of(s.length)[2] == "k"):
            made = self.steps[laid.length]
            rate, velocity = (name for name, _ in made.terms[0].factors) if isinstance(made, Calculate) else ("", "")
            slid, across = self.steps.get(velocity), self.way(laid.start, laid.makes)
            if isinstance(slid, Measure) and (way := self.way(slid.start, slid.end)) and across:
                yield self.led(way, across, rate, (velocity, laid.length))

    def led(self, way: complex, across: complex, rate: str, names: tuple[str, str]) -> Sequence[Mark]:
        """One guide."""
        vectors = [
            Arrow(0j, length * z, "vector", "plan", name)
            for length, z, name in zip((ROD * self.letter, ARROW * self.letter), (way, across), names, strict=True)
        ]
        guide = Line((-ARROW * self.letter / 2 * way, 1.2 * ROD * self.letter * way), "axis", "axis")
        return self.figure([guide], vectors, rate, degrees(way), ())

    def figure(
        self, ground: Sequence[Mark], vectors: Sequence[Arrow], rate: str, from_deg: float, letters: Sequence[Label]
    ) -> Sequence[Mark]:
        """A figure with its vectors and the curved arrow of an angular velocity or acceleration, and all letters."""
        sense, (kind, link, _) = math.copysign(1.0, float(self.position.drawing[rate])), parts_of(rate)
        turning = turn_arrow(0j, SENSE * self.letter, from_deg + sense * FROM_DEG, sense * SWEEP_DEG)
        middle = SENSE * self.letter * unit(from_deg + sense * (FROM_DEG + SWEEP_DEG / 2))
        rates = f"{'ω' if kind == 'omega' else 'ε'}_{{{self.naming.link(link)}}}"
        named = [
            Label(self.naming.vector(a.name), (a.end, (a.start + a.end) / 2), LETTER_MM, name=a.name) for a in vectors
        ]
        turns = Label(rates, middle, LETTER_MM, side=middle, clear=0.5, name=rate)
        return labelled([*letters, *named, turns], [*ground, *vectors, *turning])
