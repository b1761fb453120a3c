"""Record a program on a tape: the same steps that draw are run once with the numbers of ``symbols``."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field, replace

from planes.batch.conditions import are_all_finite, operations_carrying_nonfinite, prove_plans_together
from planes.batch.symbols import Num, Test, Vec, place_of_number, record_number
from planes.batch.tape import Tape
from planes.drafting.clearness import is_clear_drawing
from planes.drafting.drawing import draw_steps
from planes.drafting.program import Program
from planes.drafting.steps import Step, Through
from planes.drafting.steps.crossings import CrossArc, CrossArcs
from planes.drafting.tools import Env, Thing, Things, Tool
from planes.geometry.arithmetic import Arithmetic, Many, Point, Real, Truth
from planes.geometry.arrays import Floats
from planes.words.frozen import frozen
from planes.words.names import MarkPair, NamePair

UNCLEAR_REASON = "unclear"


class Recording(Arithmetic):
    """The arithmetic of a tape; values already known are computed at once."""

    size = staticmethod(Many.size)

    def __init__(self) -> None:
        self.turns: list[int] = []  # places of the motion tests, and of their senses

    def sqrt(self, x: Real) -> Real:
        if isinstance(x, Num):
            return record_number(x.tape, "sqrt", x)
        return super().sqrt(x)

    def maximum(self, a: Real, b: Real) -> Real:
        tape = _common_tape(a, b)
        if tape:
            return record_number(tape, "max", a, b)
        return super().maximum(a, b)

    def minimum(self, a: Real, b: Real) -> Real:
        tape = _common_tape(a, b)
        if tape:
            return record_number(tape, "min", a, b)
        return super().minimum(a, b)

    def where(self, ok: Truth, a: Point, b: Point) -> Point:
        if not isinstance(ok, Test):
            return a if ok else b
        if isinstance(a, Vec | complex) or isinstance(b, Vec | complex):
            return Vec(self.where(ok, a.real, b.real), self.where(ok, a.imag, b.imag))
        one = place_of_number(ok.tape, a)
        two = place_of_number(ok.tape, b)
        return a if one == two else record_number(ok.tape, "sel", ok, a, b)

    def cis_deg(self, angle: Real) -> Point:
        if not isinstance(angle, Num):
            return super().cis_deg(angle)
        tape = angle.tape
        quarter = record_number(tape, "floor", angle / 90 + 0.5)
        rest = (angle - 90.0 * quarter) * math.radians(1)
        cos = record_number(tape, "cos", rest)
        sin = record_number(tape, "sin", rest)
        turns = quarter - 4.0 * record_number(tape, "floor", quarter * 0.25)
        odd = (turns == 1) | (turns == 3)
        left = (turns == 1) | (turns == 2)
        below = turns >= 2
        x = self.where(odd, sin, cos)
        y = self.where(odd, cos, sin)
        return Vec(self.where(left, -x, x), self.where(below, -y, y))

    def angle_deg(self, u: Point) -> Real:
        if not isinstance(u, Vec):
            return super().angle_deg(u)
        tape = _common_tape(u.real, u.imag)
        assert tape
        angle = record_number(tape, "atan2", u.imag, u.real) * math.degrees(1)
        return self.where(angle == -180.0, 180.0, angle)

    def sign(self, x: Real) -> Real:
        if not isinstance(x, Num):
            return super().sign(x)
        ahead = x > 0
        self.turns.append(ahead.at)
        return self.where(ahead, 1.0, self.where(x < 0, -1.0, x))

    def guess(self, x: Real) -> Real:
        if isinstance(x, Num):
            return record_number(x.tape, "floor", x * 2.0**40) * 2.0**-40
        return x

    def power(self, x: Real, n: int) -> Real:
        return x**n if isinstance(x, Num) else super().power(x, n)

    def gap(self, c: Point, d: Point, r: Real, s: Real) -> Real:
        parts = c.real, c.imag, d.real, d.imag, r, s
        tape = _common_tape(*parts)
        if tape:
            return record_number(tape, "gap", *parts)
        return super().gap(c, d, r, s)


def _common_tape(*numbers: Real) -> Tape | None:
    return next((x.tape for x in numbers if isinstance(x, Num)), None)


@frozen
class Source:
    """An error source of the instrument: the place on the tape of an error of standard deviation ``size``."""

    place: int
    size: float


@dataclass
class TracingTool(Tool):
    """Draws on a tape. With ``errors`` (point mm, ray rad, ruler mm) every mark, ray and reading has an error."""

    tape: Tape = field(default_factory=Tape)
    errors: tuple[float, float, float] | None = None
    sources: list[Source] = field(default_factory=list)
    choosy: bool = False
    reach: dict[NamePair, Real] = field(default_factory=dict)  # between marks joined by an arc

    def draw(self, step: Step, things: Env) -> Thing:
        """The result; a direction by the radius of the arc that produced it, without a square root."""
        if self.errors is None and isinstance(step, Through):
            for a, b in ((step.start, step.end), (step.end, step.start)):
                if (a, b) in self.reach:
                    return (things[step.end] - things[step.start]) / self.reach[a, b]
        if isinstance(step, CrossArcs | CrossArc):
            self.reach[step.centre, step.makes] = abs(things[step.radius] * things[step.mu])
        if isinstance(step, CrossArcs):
            self.reach[step.other, step.makes] = abs(things[step.other_radius] * things[step.mu])
        return super().draw(step, things)

    def mark(self, place: Point) -> Point:
        if self.errors:
            return place + Vec(self._instrument_error(0), self._instrument_error(0))
        return place

    def transfer_direction(self, direction: Point) -> Point:
        if self.errors:
            return direction * Vec(1.0, self._instrument_error(1))
        return direction

    def read_length(self, length_mm: Real) -> Real:
        if self.errors:
            return length_mm + self._instrument_error(2)
        return length_mm

    def _instrument_error(self, which: int) -> Num:
        assert self.errors
        place = self.tape.record_leaf("source", len(self.sources))
        self.sources.append(Source(place, self.errors[which]))
        return Num(self.tape, place)

    def tool_without_errors(self) -> Tool:
        return replace(self, errors=None)

    def fail_unless(self, ok: Truth, step: object, reason: str, **numbers: Real) -> None:
        if ok is not True:
            self.failures.append((reason, step, ok, numbers))

    def prefer_other_leads_unless(self, ok: Truth, step: object, reason: str) -> None:
        if self.choosy:
            self.fail_unless(ok, step, reason)

    def warn_unless(self, ok: Truth, step: object, reason: str) -> None:
        """A warning stops nothing; its motion test is recorded."""
        if isinstance(ok, Test) and isinstance(self.ar, Recording):
            self.ar.turns.append(ok.at)


@frozen
class Trace:
    """A program on a tape: the places of the outputs and of each condition of a drawing, with its reason."""

    tape: Tape
    outputs: tuple[int, ...]
    requires: tuple[tuple[str, str, int], ...]  # reason, name of the step, place of the condition
    sources: tuple[Source, ...]
    turns: tuple[int, ...]  # places of the motion tests, and of their senses
    proofs: frozenset[str]  # reasons that are only suspicions: a failed proof may be only rounding

    def places_of_givens(self) -> dict[str, int]:
        """Names of the given numbers (of a place, "name.x" and "name.y") and their places."""
        return {v: k for k, v in self.tape.values.items() if self.tape.ops[k][0] == "given"}


Take = Callable[[Things, Arithmetic], Real]


def trace_program(
    program: Program,
    given: Things,
    takes: Sequence[Take],
    known: Things,
    errors: tuple[float, float, float] | None = None,
    must: Sequence[bool] = (),
    fine: float | None = None,
    forces: Iterable[MarkPair] = (),
) -> Trace:
    """Record a program. ``given`` shows which givens are places; those in ``known`` are folded in as constants.

    The outputs marked in ``must`` have to be finite numbers: that is the condition "no_digits"; then comes ``UNCLEAR``:
    where only that fails, the numbers need a closer look. ``fine`` is the relative error of the numbers for which the
    tape is recorded, where they are longer than doubles.
    """
    tape = Tape()
    ar = Recording()
    tool = TracingTool(ar, True, tape=tape, errors=errors, choosy=bool(must), doubt_mm=errors[0] if errors else 0.0)
    if fine is not None:
        tool.slack = fine
        tool.flat = fine
        tool.still = 10 * fine
    things = {n: known[n] if n in known else given_on_tape(tape, n, given[n]) for n in given}
    draw_steps(program.steps, things, tool)
    taken = [take(things, tool.ar) for take in takes]
    if must:
        proved, gaps = prove_plans_together(program, things, tool.ar)
        for reason, holds in proved.items():
            tool.failures.append((reason, None, holds, {}))
        seen = operations_carrying_nonfinite(tape, gaps)
        rest = [x for x, m in zip(taken, must, strict=True) if m and place_of_number(tape, x) not in seen]
        tool.fail_unless(are_all_finite(tape, gaps + rest), None, "no_digits")
        tool.fail_unless(is_clear_drawing(program, things, tool, forces), None, UNCLEAR_REASON)
    outputs = tuple(place_of_number(tape, x) for x in taken)
    requires = tuple((r, getattr(s, "makes", ""), place_of_number(tape, ok)) for r, s, ok, _ in tool.failures)
    proofs = frozenset(p.reason for p in program.proofs)
    return Trace(tape, outputs, requires, tuple(tool.sources), tuple(ar.turns), proofs)


def given_on_tape(tape: Tape, name: str, value: Point) -> Point:
    """A given number or place on a tape, by its name."""
    if _is_place(value):
        return Vec(Num(tape, tape.record_leaf("given", name + ".x")), Num(tape, tape.record_leaf("given", name + ".y")))
    return Num(tape, tape.record_leaf("given", name))


def given_values_by_name(given: Things) -> dict[str, Floats]:
    """The givens of a tape by their names on it."""
    flat = {}
    for name, value in given.items():
        if _is_place(value):
            flat[name + ".x"] = value.real
            flat[name + ".y"] = value.imag
        else:
            flat[name] = value
    return flat


def _is_place(value: object) -> bool:
    """Whether it has two coordinates: one place, or many in an array."""
    return isinstance(value, complex) or getattr(getattr(value, "dtype", None), "kind", "") == "c"
