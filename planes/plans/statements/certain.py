"""Checks of stated vectors before they become results: polygons close, and no direction is taken from a zero vector."""

from __future__ import annotations

from collections.abc import Callable, Iterator

from planes.drafting.drawing import SHAKEN_DRAWING_SEEDS, Drawing, draw_until_failure
from planes.drafting.instruments import Shaken
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic
from planes.plans.statements.stated_vectors import StatedVectors, VectorState
from planes.scene.vector_equations import Side, SideTerm, VectorEquation
from planes.words import Phrase
from planes.words.names import NameTriple, NumbersByName

CLOSED_GAP_RATIO = 1e-4  # of the largest vector: the number of digits in given numbers
LEAST_CERTAIN_RATIO = 1e-6  # of the largest vector of a plan: larger ones exceed rounding
Row = tuple[VectorEquation, tuple[Side, Side]]
Drawer = Callable[[VectorEquation, Side, Side], None]


class Closings:
    """Equations with less than two unknowns: one of their vectors is drawn as the closing vector, then compared with
    its data."""

    def __init__(self, vectors: StatedVectors, draw: Drawer) -> None:
        self.vectors = vectors
        self._draw = draw
        self.closed: list[tuple[VectorEquation, Side, str, VectorState]] = []

    def draw_closing_equation(self, row: Row) -> None:
        """Draw an equation of vectors that are fully known, or known except for one length or direction."""
        equation, (one, two) = row
        vectors = self.vectors
        left = [t.name for t in one + two if not vectors.is_drawn(t.name) and not vectors.given_data(t.name).like]
        free = next((n for n in left if None in vectors.length_and_direction_names(n)), left[-1] if left else "")
        given = VectorState()
        if free:
            given, vectors.states[free] = vectors.states[free], given
            self._draw(equation, one, two)
        against = tuple(SideTerm(t.name, -t.times) for t in two)
        self.closed.append((equation, one + against, free, given))

    def unclosed_equations(self, drawing: Drawing) -> Iterator[tuple[VectorEquation, Phrase]]:
        """The equations that do not close, and their gaps."""
        for equation, terms, free, given in self.closed:
            values = {t.name: self._vector_value(drawing, t.name) for t in terms}
            gap = (
                _closing_gap(drawing, values[free], given)
                if free
                else abs(sum(t.times * values[t.name] for t in terms))
            )
            if gap > CLOSED_GAP_RATIO * max(map(abs, values.values())):
                details = {"text": equation.text, "gap": gap}
                if free:
                    details |= {"name": free, "size": abs(values[free]), "angle": Arithmetic().angle_deg(values[free])}
                yield equation, Phrase("closing_open_by" if free else "closing_open", **details)

    def _vector_value(self, drawing: Drawing, name: str) -> complex:
        start, end = self.vectors.end_marks(name)
        return complex((drawing[end] - drawing[start]) / drawing[start.plan.mu_name])


def _closing_gap(drawing: Drawing, value: complex, given: VectorState) -> float:
    """The difference between the closing vector of a polygon and its data."""
    length = drawing[given.length] if given.length else None
    if given.direction is None:
        return float(abs(abs(value) - abs(length or 0.0)))
    way = drawing[given.direction]
    return float(abs(plane.cross(way, value)) if length is None else abs(value - way * length))


def uncertain_vectors(vectors: StatedVectors, drawing: Drawing, given: NumbersByName) -> Iterator[NameTriple]:
    """Divisions by zero, and directions or magnitudes taken from a vector without a correct digit: the key of the
    sentence, the name, and the source."""
    yield from (
        ("divided_by_nothing", name, by)
        for name, by, number in vectors.quotients
        if number in drawing and drawing[number] == 0
    )
    faint = [n for n in vectors.leaned if vectors.is_drawn(n) and _vanishes_on_plan(vectors, drawing, n)]
    blunter = [draw_until_failure(drawing.program, given, Shaken(seed))[0] for seed in SHAKEN_DRAWING_SEEDS if faint]
    for name in faint:
        start, end = vectors.end_marks(name)
        size, *moved = (abs(one[end] - one[start]) for one in (drawing, *blunter) if start in one and end in one)
        if size <= max((abs(other - size) for other in moved), default=size):
            yield "no_direction", name, vectors.leaned[name]


def _vanishes_on_plan(vectors: StatedVectors, drawing: Drawing, name: str) -> bool:
    """Whether a vector vanishes beside the marks of its plan."""
    start, end = vectors.end_marks(name)
    if start not in drawing or end not in drawing:
        return False
    largest = max(abs(drawing[s.makes]) for s in drawing.program.mark_steps_by_plan[start.plan] if s.makes in drawing)
    return bool(abs(drawing[end] - drawing[start]) <= LEAST_CERTAIN_RATIO * largest)
