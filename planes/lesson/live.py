"""The program of a lesson as a page runs it: a tape of everything shown."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from planes.batch.plain_tape import PLAIN, PlainRecording, exported
from planes.batch.symbols import place_of
from planes.batch.tape import Tape, reckoned
from planes.batch.tracing import TracingTool
from planes.drafting.drawing import Drawing, draw_steps
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Thing, names_of
from planes.geometry.arrays import Floats
from planes.lesson.dimensions import FreeNumbers
from planes.lesson.formulas import slot, spoken
from planes.words import Lang, Phrase
from planes.words.names import plan_of
from planes.words.records import Json

FEW, NEAR = 4, 1e3
"""Successive plans of a page, which shows four digits, and the tolerance of the last of them, relative to the root of
rounding."""


@dataclass
class _KeepingTool(TracingTool):
    """Continues from marks as stored, not from its own results."""

    kept: Mapping[str, Thing] = field(default_factory=dict)

    def make(self, step: Step, way: Sequence[Step], things: Env) -> Thing:
        made = super().make(step, way, things)
        things[step.makes] = self.kept.get(step.makes, things[step.makes])
        return made


class Live:
    """Every step drawn once on a tape, with all givens free."""

    def __init__(self, free: FreeNumbers) -> None:
        self.tape, self.home, program = Tape(), free.home, free.plans.program
        self.tool = self.another()
        things = free.on(self.tape, self.tool.ar)
        draw_steps(program.steps, things, self.tool)
        self.drawing = Drawing(program, things, self.tool)
        self.numbers = Env()  # names used in failure sentences
        sharp = self.drawing.sharpness.items()
        self.sharp = {n: z for n, z in sharp if n not in program.trials and plan_of(n) != "motion"}

    def another(self, kept: Mapping[str, Thing] = MappingProxyType({})) -> _KeepingTool:
        """Another tool that continues the tape; marks that are ``kept`` stay, whatever they depend on."""
        return _KeepingTool(PlainRecording(), True, tape=self.tape, plans=FEW, settled=NEAR, kept=kept)

    def apart(self, pairs: Sequence[tuple[Thing, Thing]]) -> list[float]:
        """The distance between two marks of the tape in the scene, for each of the pairs; NaN for one that fails."""
        apart = self.numbers_of({str(k): a - b for k, (a, b) in enumerate(pairs)}, self.home)
        return [abs(z) for z in apart.values()]

    def numbers_of(self, things: Mapping[str, Thing], given: Mapping[str, Floats]) -> dict[str, complex]:
        """Marks and values of the tape with those numbers."""
        places = {n: self._places(z) for n, z in things.items()}
        numbers = reckoned(
            self.tape, self.tape.needed([p for own in places.values() for p in own]), given, float, PLAIN
        )
        return {n: complex(*(float(numbers[p]) for p in own)) for n, own in places.items()}

    def failures(self, drive: str, symbol: str) -> list[tuple[Thing, dict[Lang, str]]]:
        """The conditions, in drawing order, and the sentences for their failure."""
        failures = []
        for k, (reason, step, ok, numbers) in enumerate(self.tool.failures):
            details = {**getattr(step, "ends", {}), **{n: slot(f"!{n}_{k}") for n in numbers}}
            self.numbers |= {f"!{n}_{k}": x if n == "value" else abs(x) for n, x in numbers.items()}
            why = Phrase(reason, **names_of(step), **details)
            where = slot(drive, "k") + "°" * (symbol == "φ")
            failures.append((ok, spoken("at", name=symbol, value=where, why=why, nearest="")))
        return failures

    def exported(self, things: Mapping[str, Mapping[str, Thing]]) -> tuple[Json, Json]:
        """The tape, and the places on it of all results by group and name: one for a number, two for a mark."""
        old = {group: {n: self._places(z) for n, z in them.items()} for group, them in things.items()}
        exported_tape, new = exported(
            self.tape, [p for them in old.values() for places in them.values() for p in places]
        )
        del exported_tape["sources"]
        flat = {
            group: {n: new[p[0]] if len(p) == 1 else [new[q] for q in p] for n, p in them.items()}
            for group, them in old.items()
        }
        return exported_tape, flat

    def _places(self, thing: Thing) -> list[int]:
        """The two coordinates of a mark or a direction."""
        parts = [thing.real, thing.imag] if hasattr(thing, "conjugate") and not isinstance(thing, float) else [thing]
        return [place_of(self.tape, x) for x in parts]
