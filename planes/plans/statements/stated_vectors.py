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
from planes.plans.statements.turning import follow
from planes.scene.mechanism import LoadLaw
from planes.scene.vector_amounts import VectorAmount
from planes.scene.vector_equations import SideTerm
from planes.scene.vectors import AlongVector, Amount, Similarity, Statement, VectorGiven
from planes.words.names import Meaning, at, end_of, parts_of

_POINTS = re.compile(r"([^\W\d_]\d*)([^\W\d_]\d*)")
_PARTS = {"n": "normal", "k": "coriolis"}
_LOADS = {"G": "weight", "I": "inertia", "Φ": "inertia", "Ф": "inertia", "P": "load", "Q": "load"}


@dataclass
class VectorState:
    """Names of its length and its direction, where known, and its end marks."""

    length: str | None = None
    direction: str | None = None
    span: tuple[str, str] | None = None


class StatedVectors:
    """The vectors and values of a statement by name; ``used`` are those that others depend on."""

    def __init__(self, statement: Statement) -> None:
        self.statement, self.draft = statement, Draft()
        self.states: dict[str, VectorState] = {}
        self.values: dict[str, str] = {}
        self.used: set[str] = set()
        self.leaned: dict[str, str] = {}  # those whose direction or quotient is taken, by the user of it
        self.quotients: list[tuple[str, str, str]] = []  # the dividend, the divisor, and the name of that number

    def given(self, name: str) -> VectorGiven:
        """The data of a vector in the scene."""
        return self.statement.vectors[name]

    def spanned(self, name: str) -> bool:
        """Whether a vector has been drawn."""
        return name in self.states and self.states[name].span is not None

    def span(self, name: str) -> tuple[str, str]:
        """The end marks of a drawn vector."""
        span = self.states[name].span
        assert span is not None
        return span

    def missing(self, name: str) -> Iterator[str]:
        """Results needed before the vector can be drawn as given."""
        given = self.given(name)
        if isinstance(given.value, VectorAmount):
            yield from (n for n in given.value.names if not self.known(n))
        if isinstance(given.direction, AlongVector) and not self.has_direction(given.direction.vector):
            yield given.direction.vector
        if given.like:
            yield from (n for n in (given.like.of, *(given.like.shape or ())) if not self.known_whole(n))

    def ready(self, name: str) -> bool:
        """Whether all given data of it can be drawn."""
        return name in self.states

    def known(self, name: str) -> bool:
        """Whether a vector's length, or a value, is available for calculation."""
        if name not in self.statement.vectors:
            return name in self.values or name in self.statement.parameters
        return self.spanned(name) or (self.given(name).value is not None and self.ready(name))

    def known_whole(self, name: str) -> bool:
        """Whether a vector's length and direction are both available."""
        return self.spanned(name) or (self.ready(name) and None not in self.parts(name))

    def has_direction(self, name: str) -> bool:
        """Whether a vector's direction is known."""
        return self.spanned(name) or (self.given(name).direction is not None and self.ready(name))

    def parts(self, name: str) -> tuple[str | None, str | None]:
        """The names of its length and direction, each None where unknown; a drawn vector has both."""
        state = self.states[name]
        if state.span or self.given(name).like:
            return state.length or "", state.direction or ""
        return state.length, state.direction

    def state(self, name: str) -> None:
        """Put the data of a vector into the program."""
        given = self.given(name)
        length = None if given.value is None else self.amount(name, given.value, f"|{name}|")
        self.states[name] = VectorState(length, self.given_direction(name, given))

    def amount(self, name: str, amount: Amount, plain: str) -> str:
        """The name of a number: given as ``plain``, or computed as ``name``."""
        if isinstance(amount, LoadLaw):
            return follow(self.draft, self.statement.drive, plain, amount, self.load_of(name) or Meaning("load", name))
        if not isinstance(amount, VectorAmount):
            return self.draft.give(plain, amount, means=self.load_of(name))
        numbers = {n: self.number(n) for n in amount.names}
        below = [n for _, factors in amount.terms for n, power in factors if power < 0]
        self.quotients += [(name, n, numbers[n]) for n in below]
        self.leaned |= {n: name for n in below if n in self.states and self.given(n).value is None}
        terms = [Product(c, tuple((numbers[n], power) for n, power in factors)) for c, factors in amount.terms]
        return self.draft.total(name, terms)

    def number(self, name: str) -> str:
        """The name of a parameter, a value or a vector's length in the program."""
        if name in self.values:
            return self.values[name]
        if name in self.statement.parameters:
            return self.draft.give(name, self.statement.parameters[name])
        self.used.add(name)
        return self.length(name)

    def length(self, name: str) -> str:
        """The name of a vector's length, measured where it was not given."""
        state = self.states[name]
        if state.length is None:
            state.length = self.draft.measure(name, *self.span(name), state.direction)
        return state.length

    def direction(self, name: str) -> str:
        """The name of a vector's direction, measured on the plan where it was not given."""
        state = self.states[name]
        if state.direction is None:
            state.direction = self.draft.through(f"→{name}", *self.span(name), Meaning("own", *line_of(name)))
        return state.direction

    def given_direction(self, name: str, given: VectorGiven) -> str | None:
        """The direction that a scene gives for a vector."""
        way, d = given.direction, self.draft
        if way is None:
            return None
        if isinstance(way, LoadLaw):
            turned = follow(d, self.statement.drive, f"angle_∠{name}", way, Meaning("angle", name))
            return d.step(Aim(f"∠{name}", turned, means=Meaning("given", *line_of(name))))
        if isinstance(way, float):
            return d.aim(f"∠{name}", way, Meaning("given", *line_of(name)))
        self.used.add(way.vector)
        if self.given(way.vector).direction is None:
            self.leaned[way.vector] = name
        base, points = self.direction(way.vector), line_of(way.vector)
        quarter, link = way.quarter % 4, len(points) == 2
        if quarter in (1, 3):
            sign = "−" if quarter == 3 else ""
            return d.step(Turn(f"{sign}⊥{base}", base, quarter, means=Meaning("across", *points)))
        if quarter == 2:
            means = Meaning("towards", *points[::-1]) if link else Meaning("against", way.vector)
        else:
            means = Meaning("along", *points) if link else Meaning("with", way.vector)
        return d.step(Turn(means.action, base, quarter, means=means))

    def transfer(self, name: str, like: Similarity) -> None:
        """The length and the direction of a vector that is similar to another."""
        state, d = self.states[name], self.draft
        base, turn, size = self.direction(like.of), math.degrees(cmath.phase(like.ratio)), abs(like.ratio)
        factors = {self.length(like.of): 1}
        if like.shape:
            one, two = like.shape
            self.leaned |= {n: name for n in (one, two) if self.given(n).direction is None}
            self.quotients.append((name, two, self.length(two)))
            factors |= {self.length(one): 1, self.length(two): -1}
            angles = [d.step(Protractor(f"angle_{n}", self.direction(n))) for n in like.shape]
            turned = d.total(f"turn_{name}", [Product(1.0, ((angles[0], 1),)), Product(-1.0, ((angles[1], 1),))])
        else:
            turned = d.give(f"turn_{name}", turn)
        state.length = d.product(name, size, **factors)
        state.direction = d.step(Turn(f"∠{name}", base, 0, turned, means=Meaning("given", name)))

    def load_of(self, name: str) -> Meaning | None:
        """The load whose magnitude a given number is, where its vector's letter shows it."""
        letter, index, _ = parts_of(name)
        return Meaning("load", name, link=index) if letter in _LOADS or letter == "F" else None

    def mark_of(self, name: str) -> Meaning | None:
        """The meaning of a vector's end mark: of a normal component, a Coriolis one, a weight."""
        letter, index, part = parts_of(name)
        if letter == "a" and part in _PARTS:
            return Meaning("normal" if part == "n" else "coriolis", index)
        if letter == "F":
            return Meaning("tangential", name) if part == "t" else None
        kind = _LOADS.get(letter)
        return Meaning(kind, name, link=index) if kind else None  # type: ignore[arg-type]  # of the table

    def settle(self) -> None:
        """State every vector, and compute every value, whose data are complete by now."""
        before = -1
        while before != len(self.states) + len(self.values):
            before = len(self.states) + len(self.values)
            for name in self.statement.vectors:
                if name not in self.states and next(self.missing(name), None) is None:
                    self.state(name)
            for name, value in self.statement.values.items():
                if name not in self.values and not self.needs(name):
                    self.values[name] = self.amount(name, value, name)

    def needs(self, name: str) -> list[str]:
        """The results that a value waits for."""
        value = self.statement.values[name]
        return [n for n in value.names if not self.known(n)] if isinstance(value, VectorAmount) else []

    def learn(self, equation: Equation, terms: dict[str, SideTerm]) -> None:
        """From now on the vectors of an equation are on its plan."""
        for term in equation.terms:
            stated = terms.get(term.name)
            ends = at(equation.plan, term.start), at(equation.plan, term.end)
            ends = ends if term.sign > 0 else ends[::-1]
            if stated is None or self.spanned(stated.name):
                continue
            if abs(stated.times) != 1:
                self._whole(equation, term, stated, ends)
                continue
            state = self.states[stated.name]
            state.span = ends
            if state.length is None and not term.drawn:
                state.length = term.name
        if equation.total and not self.spanned(equation.total):
            chain = equation.chains[0] or equation.chains[1]
            self.states[equation.total].span = at(equation.plan, chain[0].start), at(equation.plan, chain[-1].end)

    def _whole(self, equation: Equation, term: Term, stated: SideTerm, ends: tuple[str, str]) -> None:
        """A vector with a known multiple: the vector itself is drawn as well."""
        state = self.states[stated.name]
        label = end_of(stated.name) + "″"
        ratio = self.draft.give(f"ratio_{stated.name}", complex(1 / abs(stated.times)))
        state.span = ends[0], self.draft.step(Similar(at(equation.plan, label), *ends, ratio))
        self.draft.show(equation.plan, term.start if term.sign > 0 else term.end, label, stated.name)


def line_of(name: str) -> tuple[str, ...]:
    """The end points of a vector on the scheme, B and C of r_BC; of another vector its name."""
    letter, index, part = parts_of(name)
    match = _POINTS.fullmatch(index) if letter in ("r", "l") and not part else None
    return match.groups() if match else (name,)
