"""The numbers of a construction: the free ones of the scene, and formulas for those computed from them."""

import math
from functools import cached_property
from typing import Any

from planes.batch.plain_tape import PlainRecording
from planes.batch.symbols import Num, Vec, place_of_number, record_number
from planes.batch.tape import Tape
from planes.documents.constructed import LiveFigure
from planes.drafting.tools import Env, Things
from planes.geometry.arithmetic import Point, Real
from planes.lesson.dimensions import FreeNumbers
from planes.words.names import NamesByName, NumbersByName
from render.files.ggb import geogebra_number

MOST_FORMULA_LETTERS = 2000  # letters of a formula: a number with a longer one stays a number
RADIANS_PER_DEGREE = "pi / 180"
INFIX_OPERATORS = {"add": "+", "sub": "-", "mul": "*"}
FUNCTION_NAMES = {"abs": "abs", "sqrt": "sqrt", "sin": "sin", "cos": "cos", "atan2": "atan2"}


class Trigonometry(PlainRecording):
    """The arithmetic of formulas, with sines and cosines of angles."""

    def cis_deg(self, angle: Real) -> Point:
        if not isinstance(angle, Num):
            return super().cis_deg(angle)
        turn = angle * (math.pi / 180)
        return Vec(record_number(angle.tape, "cos", turn), record_number(angle.tape, "sin", turn))

    def angle_deg(self, u: Point) -> Real:
        if not isinstance(u, Vec):
            return super().angle_deg(u)
        tape = next(x.tape for x in (u.imag, u.real) if isinstance(x, Num))
        return record_number(tape, "atan2", u.imag, u.real) * (180 / math.pi)


class GivenNumbers:
    """The givens of a figure's program."""

    def __init__(self, figure: LiveFigure) -> None:
        self.figure = figure
        things = figure.position.drawing.things
        self.given: Things = {n: things[n] for n in figure.shown_program.given_names}

    @cached_property
    def free_values(self) -> NumbersByName:
        """Every free number, for a place both coordinates, by its name in the program."""
        return {n: v for n, v in self._values_of_free.items() if n in self._used_free_numbers}

    @cached_property
    def _free_numbers(self) -> FreeNumbers | None:
        stated = self.figure.stated_plans
        own = {n: self.figure.position.drawing.things[n] for n in stated.program.given_names}
        if stated.has_mechanism:
            return FreeNumbers(stated, {**stated.given, **own})
        return None

    @cached_property
    def _values_of_free(self) -> NumbersByName:
        if self._free_numbers:
            return self._free_numbers.values_in_scene
        flat: dict[str, float] = {}
        for n, given in self.given.items():
            z: Any = given
            flat |= {f"{n}.x": z.real, f"{n}.y": z.imag} if isinstance(z, complex) else {n: float(z)}
        return flat

    @cached_property
    def _tape(self) -> tuple[Tape, Env]:
        tape = Tape()
        return tape, self._free_numbers.givens_on_tape(tape, Trigonometry()) if self._free_numbers else {}

    @cached_property
    def _used_free_numbers(self) -> set[str]:
        """The free numbers that formulas use, or that are givens themselves."""
        used = {n.removesuffix(end) + end for n in self.given for end in (".x", ".y", "")} & {*self._values_of_free}
        tape, _ = self._tape
        for name in self.computed_names:
            places = tape.places_needed([place_of_number(tape, x) for x in self._tape_coordinates(name)])
            used |= {str(tape.values[p]) for p in places if tape.ops[p][0] == "given"}
        return used

    @cached_property
    def computed_names(self) -> list[str]:
        """The given numbers and places computed from free ones."""
        return [n for n in self.given if n not in self._values_of_free and f"{n}.x" not in self._values_of_free]

    def _tape_coordinates(self, name: str) -> list[Real]:
        thing: Any = self._tape[1].get(name, self.given[name])
        if isinstance(self.given[name], complex):
            return [thing.real, thing.imag]
        return [thing]

    def coordinate_formulas(self, name: str, labels: NamesByName) -> list[str]:
        """A computed number, or both coordinates of a place, by the ``labels`` of the free ones."""
        tape = self._tape[0]
        home: Any = self.given[name]
        plain = [home.real, home.imag] if isinstance(home, complex) else [home]
        formulas = []
        for part, value in zip(self._tape_coordinates(name), plain, strict=True):
            text = tape_formula(tape, place_of_number(tape, part), labels)
            formulas.append(text if text and len(text) < MOST_FORMULA_LETTERS else number_literal(float(value)))
        return formulas


def tape_formula(tape: Tape, place: int, labels: NamesByName) -> str:
    """A number of a tape as a formula, "" where it uses an operation without a formula here."""
    op, args = tape.ops[place]
    if op == "const":
        return number_literal(float(tape.values[place]))
    if op == "given":
        return labels[str(tape.values[place])]
    parts = [tape_formula(tape, a, labels) for a in args]
    if not all(parts) or max(map(len, parts)) > MOST_FORMULA_LETTERS:
        return ""
    if op in INFIX_OPERATORS:
        return f"({parts[0]} {INFIX_OPERATORS[op]} {parts[1]})"
    if op in FUNCTION_NAMES:
        return f"{FUNCTION_NAMES[op]}({', '.join(parts)})"
    return {"inv": "(1 / {0})", "neg": "(-{0})", "hypot": "sqrt({0}^2 + {1}^2)"}.get(op, "").format(*parts)


def number_literal(value: float) -> str:
    """A number in a formula."""
    if value < 0:
        return f"({geogebra_number(value)})"
    return geogebra_number(value)
