"""The plans of a scene of vectors and equations: one program, its equations in any order in which they can be drawn,
each number taken from the plans before it."""

from collections.abc import Iterable
from dataclasses import replace
from math import inf

from planes.drafting.drawing import draw_program, draw_until_failure
from planes.drafting.equations import Equation, unknown_in_words
from planes.plans import Plans
from planes.plans.force.loads import Loads
from planes.plans.scales import plan_scales, unit_scales_of_plans
from planes.plans.statements.certain import Closings, uncertain_vectors
from planes.plans.statements.nearer_way import chosen_side
from planes.plans.statements.stated_chains import Chains
from planes.plans.statements.stated_plans import plans_of_equations
from planes.plans.statements.stated_vectors import StatedVectors
from planes.plans.statements.still import plans_of_still_draft
from planes.plans.statements.turning import mechanism_of_drive_alone
from planes.plans.structures.built import framework_plans
from planes.scene import Scene
from planes.scene.structures import Framework
from planes.scene.vector_equations import Side, SideTerm, VectorEquation
from planes.scene.vectors import Statement
from planes.words import Phrase, Told, sentence_table
from planes.words.errors import EquationError, PlanFailure, ProgramError, SceneError
from planes.words.lettering import name_in_words

Left = list[tuple[VectorEquation, tuple[Side, Side]]]
"""Equations that are not drawn yet, with their sides."""


def stated_plans(scene: Scene) -> Plans:
    """State every plan of a scene of vectors. :class:`SceneError` with file:line where an equation cannot be drawn."""
    assert scene.statement
    if isinstance(scene.statement.subject, Framework):
        return framework_plans(scene, scene.statement.subject)
    try:
        return StatedPlansBuilder(scene, scene.statement).build_plans()
    except ProgramError as error:
        raise SceneError(error.phrase, scene.file, scene.where.get(("vectors",))) from None


class StatedPlansBuilder:
    """Draws the equations, one after another."""

    def __init__(self, scene: Scene, statement: Statement) -> None:
        self.scene = scene
        self.statement = statement
        self.plan_of = plans_of_equations(scene, statement)
        self.vectors = StatedVectors(statement)
        self.draft = self.vectors.draft
        self.chains = Chains(self.vectors)
        self.solved: dict[str, VectorEquation] = {}  # mark -> the equation it was drawn for
        self.chosen: set[str] = set()  # vectors whose direction a side decides
        self.closings = Closings(self.vectors, self._draw_equation)

    def error(self, equation: VectorEquation, phrase: Told) -> SceneError:
        return SceneError(phrase, self.scene.file, equation.line)

    def build_plans(self) -> Plans:
        """All equations, each as soon as it has only two unknowns; then the remaining values."""
        left = [(e, (e.sides[0], side)) for e in self.statement.equations for side in e.sides[1:]]
        while left:
            self.vectors.state_completed_data()
            done = (
                self._draw_one_equation(left)
                or self._draw_pair_with_common_unknown(left)
                or self._draw_closing_equation(left)
            )
            if not done:
                raise self._undrawable_error([e for e, _ in left])
            left = [row for row in left if row not in done]
        self.vectors.state_completed_data()
        self._check_used()
        plans = self._assemble_plans()
        self._refuse_undrawable(plans)
        return plans

    def _are_known(self, names: Iterable[str]) -> bool:
        return all(map(self.vectors.is_ready_to_draw, names))

    def unknown_parts_in_words(self, terms: Side) -> list[Phrase]:
        """The unknown parts of the vectors, in words."""
        unknowns = []
        for term in terms:
            parts = zip(("length", "direction"), self.vectors.length_and_direction_names(term.name), strict=True)
            unknowns += [unknown_in_words(term.name, part) for part, given in parts if given is None]
        return unknowns

    def _unknown_part_count(self, terms: Side) -> float:
        """How many parts of the vectors are unknown; infinite where what they depend on is."""
        if self._are_known(t.name for t in terms):
            return len(self.unknown_parts_in_words(terms))
        return inf

    def _draw_one_equation(self, left: Left) -> list[object]:
        for row in left:
            equation, (one, two) = row
            if self._unknown_part_count(one + two) == 2:
                self._draw_equation(equation, one, two)
                return [row]
        return []

    def _draw_pair_with_common_unknown(self, left: Left) -> list[object]:
        """Two sides equal to the same unknown vector are equal to each other."""
        for i, (one, (total, first)) in enumerate(left):
            for other, (same, second) in left[i + 1 :]:
                alone = len(total) == 1 and total == same and total[0].times == 1.0
                if alone and self._unknown_part_count(first + second) == 2:
                    self._draw_equation(one, first, second, total[0].name, other)
                    return [left[i], (other, (same, second))]
        return []

    def _draw_closing_equation(self, left: Left) -> list[object]:
        """An equation whose unknowns no other equation needs: it is compared with the known data."""
        for row in left:
            terms = row[1][0] + row[1][1]
            if self._unknown_part_count(terms) < 2:
                self.closings.draw_closing_equation(row)
                return [row]
        return []

    def _undrawable_error(self, left: list[VectorEquation]) -> SceneError:
        """Why none of these can be drawn: too many unknowns, or numbers that depend on each other in a circle."""
        for equation in left:
            if self._are_known(equation.vector_names):
                listed = tuple(self.unknown_parts_in_words(tuple(map(SideTerm, equation.vector_names)))) or Phrase(
                    "none"
                )
                return self.error(equation, Phrase("unknowns_are", text=equation.text, listed=listed))
        name, needed = next(
            (n, needed)
            for n in left[0].vector_names
            if not self.vectors.is_ready_to_draw(n)
            for needed in self.vectors.results_missing_for(n)
        )
        return self.error(left[0], Phrase("vector_waits", text=left[0].text, name=name, needed=needed))

    def _draw_equation(
        self,
        equation: VectorEquation,
        one: Side,
        two: Side,
        total: str | None = None,
        other: VectorEquation | None = None,
    ) -> None:
        d = self.draft
        plan = self.plan_of[equation.line, equation.text]
        alone = not total and two and len(one) == 1 and one[0].times == 1
        if alone and self.vectors.length_and_direction_names(one[0].name) == (None, None):
            total = one[0].name
            one = ()
        plan, chains = self.chains.plan_and_chains(plan, one, two, total)
        terms = [*chains[0], *chains[1]]
        free = [t.name for t in terms if t.direction is None and t.length is not None and not t.drawn]
        side = d.add_given(f"side_{len(d.equations) + 1}", 1.0) if free else None
        try:
            drawn = Equation(plan, chains, total, side)
        except EquationError as error:
            raise self.error(equation, error.phrase) from None
        if other:
            equation = replace(equation, text=f"{equation.text}, {other.text}")
        for term in terms:
            self.solved.setdefault(str(name_in_words(term.end)), equation)
        d.draw_equation(drawn)
        self.vectors.record_equation_vectors(drawn, self.chains.stated)
        if side:
            names = [n.rpartition("·")[2] for n in free]
            self.chosen |= {*names}
            d.given[side] = chosen_side(self.scene, self.vectors, side, names)

    def _check_used(self) -> None:
        """Refuse data of a vector that have no effect."""
        named = {name for equation in self.statement.equations for name in equation.vector_names}
        for name, given in self.statement.vectors.items():
            idle = name not in named and name not in self.vectors.used
            if idle or (given.near_deg is not None and name not in self.chosen):
                line = self.scene.where.get(("vectors", name))
                raise SceneError(Phrase("vector_idle" if idle else "near_idle", name=name), self.scene.file, line)
        for name in self.statement.values:
            if needed := self.vectors.results_awaited(name):
                line = self.scene.where.get(("values", name))
                raise SceneError(Phrase("value_waits", name=name, needed=needed[0]), self.scene.file, line)

    def _assemble_plans(self) -> Plans:
        d = self.draft
        nothing = mechanism_of_drive_alone(self.statement.drive, self.scene.where)
        names = [n for n in self.statement.vectors if self.vectors.is_drawn(n)]
        return plans_of_still_draft(
            d,
            nothing,
            Loads(),
            vectors={n: self.vectors.end_marks(n) for n in names},
            values={n: self.vectors.values[n] for n in self.statement.values},
        )

    def _refuse_undrawable(self, plans: Plans) -> None:
        """Refuse an equation that cannot be drawn, in millimetres of its paper."""
        self._refuse_uncertain_vectors(plans)
        try:
            drawing = draw_program(plans.program, {**plans.given, **plan_scales(plans, self.scene.mu)})
        except PlanFailure as failure:
            raise self._failure_in_vector_terms(failure) from None
        for equation, why in self.closings.unclosed_equations(drawing):
            raise self.error(equation, why)

    def _refuse_uncertain_vectors(self, plans: Plans) -> None:
        """Refuse a division by zero, and a direction of a zero vector, as far as the drawing goes."""
        given = {**plans.given, **unit_scales_of_plans(plans)}
        drawing, _ = draw_until_failure(plans.program, given)
        for key, name, by in uncertain_vectors(self.vectors, drawing, given):
            line = self.scene.where.get(("vectors", name), self.scene.where.get(("values", name)))
            raise SceneError(Phrase(key, name=name, by=by), self.scene.file, line)

    def _failure_in_vector_terms(self, failure: PlanFailure) -> SceneError:
        """Why an equation cannot be drawn, in terms of vectors."""
        equation = self.solved.get(str(failure.numbers.get("makes")), self.statement.equations[0])
        key = f"vectors_{failure.reason}"
        if key not in sentence_table("en"):
            return self.error(equation, Phrase("about", what=equation.text, why=failure.phrase))
        return self.error(equation, Phrase(key, **{**failure.numbers, "text": equation.text}))
