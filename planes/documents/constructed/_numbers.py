"""The numbers of a construction: the free ones of the scene, and formulas for those computed from them."""

import math
from collections.abc import Mapping
from functools import cached_property
from typing import Any

from planes.batch.plain_tape import PlainRecording
from planes.batch.symbols import Num, Vec, number, place_of
from planes.batch.tape import Tape
from planes.documents.constructed import LiveFigure
from planes.drafting.tools import Thing, Things
from planes.geometry.arithmetic import Point, Real
from planes.lesson.dimensions import FreeNumbers
from render.files.ggb import written

LONGEST = 2000  # letters of a formula: a number with a longer one stays a number
RADIAN = "pi / 180"
INFIX = {"add": "+", "sub": "-", "mul": "*"}
CALLED = {"abs": "abs", "sqrt": "sqrt", "sin": "sin", "cos": "cos", "atan2": "atan2"}


class Trigonometry(PlainRecording):
    """The arithmetic of formulas, with sines and cosines of angles."""

    def cis_deg(self, angle: Real) -> Point:
        if not isinstance(angle, Num):
            return super().cis_deg(angle)
        turn = angle * (math.pi / 180)
        return Vec(number(angle.tape, "cos", turn), number(angle.tape, "sin", turn))

    def angle_deg(self, u: Point) -> Real:
        if not isinstance(u, Vec):
            return super().angle_deg(u)
        tape = next(x.tape for x in (u.imag, u.real) if isinstance(x, Num))
        return number(tape, "atan2", u.imag, u.real) * (180 / math.pi)


class GivenNumbers:
    """The givens of a figure's program."""

    def __init__(self, figure: LiveFigure) -> None:
        self.figure = figure
        things = figure.position.drawing.things
        self.given: Things = {n: things[n] for n in figure.program.givens}

    @cached_property
    def free(self) -> dict[str, float]:
        """Every free number, for a place both coordinates, by its name in the program."""
        return {n: v for n, v in self._home.items() if n in self._read}

    @cached_property
    def _numbers(self) -> FreeNumbers | None:
        stated = self.figure.stated
        own = {n: self.figure.position.drawing.things[n] for n in stated.program.givens}
        return FreeNumbers(stated, {**stated.given, **own}) if stated.moves else None

    @cached_property
    def _home(self) -> dict[str, float]:
        if self._numbers:
            return self._numbers.home
        flat: dict[str, float] = {}
        for n, given in self.given.items():
            z: Any = given
            flat |= {f"{n}.x": z.real, f"{n}.y": z.imag} if isinstance(z, complex) else {n: float(z)}
        return flat

    @cached_property
    def _tape(self) -> tuple[Tape, dict[str, Thing]]:
        tape = Tape()
        return tape, self._numbers.on(tape, Trigonometry()) if self._numbers else {}

    @cached_property
    def _read(self) -> set[str]:
        """The free numbers that formulas use, or that are givens themselves."""
        used = {n.removesuffix(end) + end for n in self.given for end in (".x", ".y", "")} & {*self._home}
        tape, _ = self._tape
        for name in self.reckoned:
            places = tape.needed([place_of(tape, x) for x in self._parts(name)])
            used |= {str(tape.values[p]) for p in places if tape.ops[p][0] == "given"}
        return used

    @cached_property
    def reckoned(self) -> list[str]:
        """The given numbers and places computed from free ones."""
        return [n for n in self.given if n not in self._home and f"{n}.x" not in self._home]

    def _parts(self, name: str) -> list[Real]:
        thing: Any = self._tape[1].get(name, self.given[name])
        return [thing.real, thing.imag] if isinstance(self.given[name], complex) else [thing]

    def formulas(self, name: str, labels: Mapping[str, str]) -> list[str]:
        """A computed number, or both coordinates of a place, by the ``labels`` of the free ones."""
        tape = self._tape[0]
        home: Any = self.given[name]
        plain = [home.real, home.imag] if isinstance(home, complex) else [home]
        formulas = []
        for part, value in zip(self._parts(name), plain, strict=True):
            text = formula(tape, place_of(tape, part), labels)
            formulas.append(text if text and len(text) < LONGEST else literal(float(value)))
        return formulas


def formula(tape: Tape, place: int, labels: Mapping[str, str]) -> str:
    """A number of a tape as a formula, "" where it uses an operation without a formula here."""
    op, args = tape.ops[place]
    if op == "const":
        return literal(float(tape.values[place]))
    if op == "given":
        return labels[str(tape.values[place])]
    parts = [formula(tape, a, labels) for a in args]
    if not all(parts) or max(map(len, parts)) > LONGEST:
        return ""
    if op in INFIX:
        return f"({parts[0]} {INFIX[op]} {parts[1]})"
    if op in CALLED:
        return f"{CALLED[op]}({', '.join(parts)})"
    return {"inv": "(1 / {0})", "neg": "(-{0})", "hypot": "sqrt({0}^2 + {1}^2)"}.get(op, "").format(*parts)


def literal(value: float) -> str:
    """A number in a formula."""
    return f"({written(value)})" if value < 0 else written(value)
