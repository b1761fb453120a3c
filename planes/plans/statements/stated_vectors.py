"""The known data of a scene's vectors while its equations are drawn: given, computed or measured."""

import cmath
import math
import re
from collections.abc import Iterator
from dataclasses import dataclass

from planes.drafting.draft import Draft
from planes.drafting.equations import Equation, Term
from planes.drafting.steps import Aim, Similar, Turn
from planes.drafting.steps.reckoning import Product, Protractor
from planes.plans.statements.turning import value_name_of_law
from planes.scene.mechanism import LoadLaw
from planes.scene.vector_amounts import VectorAmount
from planes.scene.vector_equations import SideTerm
from planes.scene.vectors import AlongVector, Amount, Similarity, Statement, VectorGiven
from planes.words.names import MarkPair, Meaning, NamesByName, NameTriple, NameTuple, split_value_name, vector_end_label

_POINT_PAIR_PATTERN = re.compile(r"([^\W\d_]\d*)([^\W\d_]\d*)")
_MEANING_BY_COMPONENT = {"n": "normal", "k": "coriolis"}
_LOAD_MEANING_BY_LETTER = {"G": "weight", "I": "inertia", "Φ": "inertia", "Ф": "inertia", "P": "load", "Q": "load"}


@dataclass
class VectorState:
    """Names of its length and its direction, where known, and its end marks."""

    length: str | None = None
    direction: str | None = None
    span: MarkPair | None = None


class StatedVectors:
    """The vectors and values of a statement by name; ``used`` are those that others depend on."""

    def __init__(self, statement: Statement) -> None:
        self.statement = statement
        self.draft = Draft()
        self.states: dict[str, VectorState] = {}
        self.values: NamesByName = {}
        self.used: set[str] = set()
        self.leaned: NamesByName = {}  # those whose direction or quotient is taken, by the user of it
        self.quotients: list[NameTriple] = []  # the dividend, the divisor, and the name of that number

    def given_data(self, name: str) -> VectorGiven:
        """The data of a vector in the scene."""
        return self.statement.vectors[name]

    def is_drawn(self, name: str) -> bool:
        """Whether a vector has been drawn."""
        return name in self.states and self.states[name].span is not None

    def end_marks(self, name: str) -> MarkPair:
        """The end marks of a drawn vector."""
        span = self.states[name].span
        assert span is not None
        return span

    def results_missing_for(self, name: str) -> Iterator[str]:
        """Results needed before the vector can be drawn as given."""
        given = self.given_data(name)
        if isinstance(given.value, VectorAmount):
            yield from (n for n in given.value.names_read if not self.has_known_length(n))
        if isinstance(given.direction, AlongVector) and not self.has_direction(given.direction.vector):
            yield given.direction.vector
        if given.like:
            yield from (n for n in (given.like.of, *(given.like.shape or ())) if not self.is_fully_known(n))

    def is_ready_to_draw(self, name: str) -> bool:
        """Whether all given data of it can be drawn."""
        return name in self.states

    def has_known_length(self, name: str) -> bool:
        """Whether a vector's length, or a value, is available for calculation."""
        if name not in self.statement.vectors:
            return name in self.values or name in self.statement.parameters
        return self.is_drawn(name) or (self.given_data(name).value is not None and self.is_ready_to_draw(name))

    def is_fully_known(self, name: str) -> bool:
        """Whether a vector's length and direction are both available."""
        return self.is_drawn(name) or (
            self.is_ready_to_draw(name) and None not in self.length_and_direction_names(name)
        )

    def has_direction(self, name: str) -> bool:
        """Whether a vector's direction is known."""
        return self.is_drawn(name) or (self.given_data(name).direction is not None and self.is_ready_to_draw(name))

    def length_and_direction_names(self, name: str) -> tuple[str | None, str | None]:
        """The names of its length and direction, each None where unknown; a drawn vector has both."""
        state = self.states[name]
        if state.span or self.given_data(name).like:
            return state.length or "", state.direction or ""
        return state.length, state.direction

    def state_vector_data(self, name: str) -> None:
        """Put the data of a vector into the program."""
        given = self.given_data(name)
        length = None if given.value is None else self.name_of_amount(name, given.value, f"|{name}|")
        self.states[name] = VectorState(length, self.given_direction_name(name, given))

    def name_of_amount(self, name: str, amount: Amount, plain: str) -> str:
        """The name of a number: given as ``plain``, or computed as ``name``."""
        if isinstance(amount, LoadLaw):
            return value_name_of_law(
                self.draft, self.statement.drive, plain, amount, self.load_meaning(name) or Meaning("load", name)
            )
        if not isinstance(amount, VectorAmount):
            return self.draft.add_given(plain, amount, means=self.load_meaning(name))
        numbers = {n: self.name_of_number(n) for n in amount.names_read}
        below = [n for _, factors in amount.terms for n, power in factors if power < 0]
        self.quotients += [(name, n, numbers[n]) for n in below]
        self.leaned |= {n: name for n in below if n in self.states and self.given_data(n).value is None}
        terms = [Product(c, tuple((numbers[n], power) for n, power in factors)) for c, factors in amount.terms]
        return self.draft.add_sum(name, terms)

    def name_of_number(self, name: str) -> str:
        """The name of a parameter, a value or a vector's length in the program."""
        if name in self.values:
            return self.values[name]
        if name in self.statement.parameters:
            return self.draft.add_given(name, self.statement.parameters[name])
        self.used.add(name)
        return self.length_name(name)

    def length_name(self, name: str) -> str:
        """The name of a vector's length, measured where it was not given."""
        state = self.states[name]
        if state.length is None:
            state.length = self.draft.measure_segment(name, *self.end_marks(name), state.direction)
        return state.length

    def direction_name(self, name: str) -> str:
        """The name of a vector's direction, measured on the plan where it was not given."""
        state = self.states[name]
        if state.direction is None:
            state.direction = self.draft.draw_direction_through_marks(
                f"→{name}", *self.end_marks(name), Meaning("own", *scheme_points_of_vector(name))
            )
        return state.direction

    def given_direction_name(self, name: str, given: VectorGiven) -> str | None:
        """The direction that a scene gives for a vector."""
        way = given.direction
        d = self.draft
        if way is None:
            return None
        if isinstance(way, LoadLaw):
            turned = value_name_of_law(d, self.statement.drive, f"angle_∠{name}", way, Meaning("angle", name))
            return d.add_step(Aim(f"∠{name}", turned, means=Meaning("given", *scheme_points_of_vector(name))))
        if isinstance(way, float):
            return d.draw_direction_at_angle(f"∠{name}", way, Meaning("given", *scheme_points_of_vector(name)))
        self.used.add(way.vector)
        if self.given_data(way.vector).direction is None:
            self.leaned[way.vector] = name
        base = self.direction_name(way.vector)
        points = scheme_points_of_vector(way.vector)
        quarter = way.quarter % 4
        link = len(points) == 2
        if quarter in (1, 3):
            sign = "−" if quarter == 3 else ""
            return d.add_step(Turn(f"{sign}⊥{base}", base, quarter, means=Meaning("across", *points)))
        if quarter == 2:
            means = Meaning("towards", *points[::-1]) if link else Meaning("against", way.vector)
        else:
            means = Meaning("along", *points) if link else Meaning("with", way.vector)
        return d.add_step(Turn(means.written_action, base, quarter, means=means))

    def transfer_by_similarity(self, name: str, like: Similarity) -> None:
        """The length and the direction of a vector that is similar to another."""
        state = self.states[name]
        d = self.draft
        base = self.direction_name(like.of)
        turn = math.degrees(cmath.phase(like.ratio))
        size = abs(like.ratio)
        factors = {self.length_name(like.of): 1}
        if like.shape:
            one, two = like.shape
            self.leaned |= {n: name for n in (one, two) if self.given_data(n).direction is None}
            self.quotients.append((name, two, self.length_name(two)))
            factors |= {self.length_name(one): 1, self.length_name(two): -1}
            angles = [d.add_step(Protractor(f"angle_{n}", self.direction_name(n))) for n in like.shape]
            turned = d.add_sum(f"turn_{name}", [Product(1.0, ((angles[0], 1),)), Product(-1.0, ((angles[1], 1),))])
        else:
            turned = d.add_given(f"turn_{name}", turn)
        state.length = d.add_product(name, size, **factors)
        state.direction = d.add_step(Turn(f"∠{name}", base, 0, turned, means=Meaning("given", name)))

    def load_meaning(self, name: str) -> Meaning | None:
        """The load whose magnitude a given number is, where its vector's letter shows it."""
        letter, index, _ = split_value_name(name)
        if letter in _LOAD_MEANING_BY_LETTER or letter == "F":
            return Meaning("load", name, link=index)
        return None

    def end_mark_meaning(self, name: str) -> Meaning | None:
        """The meaning of a vector's end mark: of a normal component, a Coriolis one, a weight."""
        letter, index, part = split_value_name(name)
        if letter == "a" and part in _MEANING_BY_COMPONENT:
            return Meaning("normal" if part == "n" else "coriolis", index)
        if letter == "F":
            return Meaning("tangential", name) if part == "t" else None
        kind = _LOAD_MEANING_BY_LETTER.get(letter)
        return Meaning(kind, name, link=index) if kind else None  # type: ignore[arg-type]  # of the table

    def state_completed_data(self) -> None:
        """State every vector, and compute every value, whose data are complete by now."""
        before = -1
        while before != len(self.states) + len(self.values):
            before = len(self.states) + len(self.values)
            for name in self.statement.vectors:
                if name not in self.states and next(self.results_missing_for(name), None) is None:
                    self.state_vector_data(name)
            for name, value in self.statement.values.items():
                if name not in self.values and not self.results_awaited(name):
                    self.values[name] = self.name_of_amount(name, value, name)

    def results_awaited(self, name: str) -> list[str]:
        """The results that a value waits for."""
        value = self.statement.values[name]
        if isinstance(value, VectorAmount):
            return [n for n in value.names_read if not self.has_known_length(n)]
        return []

    def record_equation_vectors(self, equation: Equation, terms: dict[str, SideTerm]) -> None:
        """From now on the vectors of an equation are on its plan."""
        for term in equation.all_terms:
            stated = terms.get(term.name)
            ends = equation.plan.marks(term.start, term.end)
            ends = ends if term.sign > 0 else ends[::-1]
            if stated is None or self.is_drawn(stated.name):
                continue
            if abs(stated.times) != 1:
                self._draw_undivided_vector(equation, term, stated, ends)
                continue
            state = self.states[stated.name]
            state.span = ends
            if state.length is None and not term.drawn:
                state.length = term.name
        if equation.total and not self.is_drawn(equation.total):
            chain = equation.chains[0] or equation.chains[1]
            self.states[equation.total].span = equation.plan.marks(chain[0].start, chain[-1].end)

    def _draw_undivided_vector(self, equation: Equation, term: Term, stated: SideTerm, ends: MarkPair) -> None:
        """A vector with a known multiple: the vector itself is drawn as well."""
        state = self.states[stated.name]
        label = vector_end_label(stated.name) + "″"
        ratio = self.draft.add_given(f"ratio_{stated.name}", complex(1 / abs(stated.times)))
        state.span = ends[0], self.draft.draw_mark(Similar(equation.plan.mark(label), *ends, ratio))
        self.draft.name_segment(equation.plan, term.start if term.sign > 0 else term.end, label, stated.name)


def scheme_points_of_vector(name: str) -> NameTuple:
    """The end points of a vector on the scheme, B and C of r_BC; of another vector its name."""
    letter, index, part = split_value_name(name)
    match = _POINT_PAIR_PATTERN.fullmatch(index) if letter in ("r", "l") and not part else None
    return match.groups() if match else (name,)
