"""The program of a lesson as a page runs it: a tape of all that is shown, and the given numbers a reader may change."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, partial
from types import MappingProxyType

import numpy

from planes.batch.plain_tape import PlainRecording, exported
from planes.batch.symbols import place_of
from planes.batch.tape import Tape, read
from planes.batch.tracing import TracingTool, given_on, given_values
from planes.drafting.drawing import Drawing, draw_steps
from planes.drafting.program import Program
from planes.drafting.steps import LayOff, Put, Similar, Step
from planes.drafting.steps.crossings import CrossArc, CrossArcs
from planes.drafting.tools import Env, Thing, names_of
from planes.geometry.arrays import Array, Complexes, Floats
from planes.lesson.formulas import slot, unit
from planes.lesson.frame import in_both
from planes.plans import Plans
from planes.words import Lang, Phrase, say
from planes.words.names import aimed, mu_of, parts_of, plan_of, point_of
from planes.words.records import Json

CARRIED = ("velocity", "motion", "lever")
"""Plans of one scale: the lever's segments are carried from one of velocities."""
SHAKEN = 0.07  # of itself: how far a number is changed to see which terms are nothing whatever it is
FEW, NEAR = 4, 1e3
"""Successive plans of a page, which shows four digits, and how near the last of them is, to the root of rounding."""


@dataclass
class _KeepingTool(TracingTool):
    """Draws on from marks as they are kept, not as it has made them."""

    kept: Mapping[str, Thing] = field(default_factory=dict)

    def make(self, step: Step, way: Sequence[Step], things: Env) -> Thing:
        made = super().make(step, way, things)
        things[step.makes] = self.kept.get(step.makes, things[step.makes])
        return made


class Live:
    """Every step drawn once on a tape, all that is given free."""

    def __init__(self, program: Program, given: Mapping[str, Thing]) -> None:
        self.tape = Tape()
        self.tool = self.another()
        things = {n: given_on(self.tape, n, z) for n, z in given.items()}
        draw_steps(program.steps, things, self.tool)
        self.drawing = Drawing(program, things, self.tool)
        self.numbers: dict[str, Thing] = {}  # that sentences of failures tell

    def another(self, kept: Mapping[str, Thing] = MappingProxyType({})) -> _KeepingTool:
        """A tool that goes on writing on the tape; marks that are ``kept`` stay, whatever leads there."""
        return _KeepingTool(PlainRecording(), True, tape=self.tape, plans=FEW, settled=NEAR, kept=kept)

    def apart(self, pairs: Sequence[tuple[Thing, Thing]], given: Mapping[str, Thing]) -> list[float]:
        """How far two marks of the tape are apart with those numbers, for each of the pairs; NaN of one that fails."""
        apart = self.numbers_of({str(k): a - b for k, (a, b) in enumerate(pairs)}, given_values(given))
        return [abs(z) for z in apart.values()]

    def numbers_of(self, things: Mapping[str, Thing], given: Mapping[str, Floats]) -> dict[str, complex]:
        """Marks and values of the tape with those numbers."""
        places = {n: self._places(z) for n, z in things.items()}
        numbers = read(self.tape, self.tape.needed([p for own in places.values() for p in own]), given)
        return {n: complex(*(float(numbers[p]) for p in own)) for n, own in places.items()}

    def failures(self, drive: str, symbol: str) -> list[tuple[Thing, dict[Lang, str]]]:
        """What must hold, in the order of the drawing, and what is said where it does not."""
        found = []
        for k, (reason, step, ok, numbers) in enumerate(self.tool.failures):
            told = {**getattr(step, "ends", {}), **{n: slot(f"!{n}_{k}") for n in numbers}}
            self.numbers |= {f"!{n}_{k}": x if n == "value" else abs(x) for n, x in numbers.items()}
            why = Phrase(reason, **names_of(step), **told)
            where = slot(drive, "k") + "°" * (symbol == "φ")
            found.append((ok, in_both(partial(say, "at", name=symbol, value=where, why=why, nearest=""))))
        return found

    def exported(self, things: Mapping[str, Mapping[str, Thing]]) -> tuple[Json, Json]:
        """The tape, and the places on it of everything by group and name: one of a number, two of a mark."""
        old = {group: {n: self._places(z) for n, z in them.items()} for group, them in things.items()}
        told, new = exported(self.tape, [p for them in old.values() for places in them.values() for p in places])
        del told["sources"]
        flat = {
            group: {n: new[p[0]] if len(p) == 1 else [new[q] for q in p] for n, p in them.items()}
            for group, them in old.items()
        }
        return told, flat

    def _places(self, thing: Thing) -> list[int]:
        """Of a mark or a direction its two coordinates."""
        parts = [thing.real, thing.imag] if hasattr(thing, "conjugate") and not isinstance(thing, float) else [thing]
        return [place_of(self.tape, x) for x in parts]


@dataclass(frozen=True)
class Knobs:
    """Which given numbers a reader may change, and what dragging a mark changes."""

    plans: Plans
    given: Mapping[str, Thing]

    def home(self) -> dict[str, float]:
        """Every number of the tape as the scene has it."""
        return {n: float(z) for n, z in given_values(self.given).items()}

    def all(self) -> list[Json]:
        """Each with its name, its unit and what it is in the scene; ``tied`` are those that change with it, as what
        power of it."""
        used, found = {*self.plans.program.givens}, []
        for name, value in self.home().items():
            given, _, axis = name.partition(".")
            plan = next((p for p in self.plans.drawn if mu_of(p) == given), None)
            told = "" if plan else self.told(given, axis)
            if given in used and (told or plan not in (None, *CARRIED[1:])):
                kind: Json = {"plan": plan} if plan else {"name": told, "unit": in_both(partial(unit, told))}
                kind |= {"unit": in_both(lambda _: "°")} if aimed(given) else {}
                found.append({"given": name, "at": value, "tied": self.tied(given) if value else {}, **kind})
        return [{**k, **self.around(k, found)} for k in found if k["at"] or self.around(k, found)]

    def around(self, knob: Json, knobs: list[Json]) -> dict[str, float]:
        """Of a number that is nothing how far from it one may go: as far as the largest of its kind, an angular
        acceleration as far as the square of the speed; not at all where there is none."""
        letter = parts_of(str(knob["name"]))[0] if "name" in knob else ""
        rates = {"epsilon": "omega", "a": "v"}
        like = ("x", "y", "l") if letter in ("x", "y") else (rates.get(letter, letter),)
        sizes = [abs(k["at"]) for k in knobs if "name" in k and parts_of(k["name"])[0] in like and k["at"]]
        return {"reach": max(sizes) ** (2 if letter in rates else 1)} if sizes and not knob["at"] else {}

    def tied(self, given: str) -> dict[str, int]:
        """What changes with a number: with a scale those of the plans carried from one another, with a length the
        ratios of it to the length of its link, or of others to it."""
        if given in (same := [mu_of(p) for p in CARRIED if mu_of(p) in self.given]):
            return {mu: 1 for mu in same if mu != given}
        means = self.plans.means.get(given)
        if means is None or means.quantity != "length":
            return {}
        mine = [m for n, m in self.plans.means.items() if m.quantity == "length" and m.link == means.link]
        laid = {f"ratio_{p}_{m.link}": p for m in mine for p in (m.of, m.about)}
        ratios = {n: p for n, p in laid.items() if n in self.given}
        ends, bases = {means.of, means.about}, self.bases
        own = {n: 1 for n, p in ratios.items() if p in ends} | {n: -1 for n in ratios if bases.get(n) == ends}
        own = own or dict.fromkeys(ratios, -1)
        return {f"{n}.{axis}": power for n, power in own.items() for axis in "xy" if f"{n}.{axis}" in self.home()}

    @cached_property
    def bases(self) -> dict[str, set[str]]:
        """The two points of a link that each ratio is of, on its scheme or drawn aside."""
        similar = [s for s in self.plans.program.steps if isinstance(s, Similar) and plan_of(s.makes) == "position"]
        return {s.ratio: {point_of(n) for n in (s.start, s.end)} for s in reversed(similar)}

    def shaken(self, count: int) -> dict[str, Array | Complexes]:
        """Given numbers by many others near them, but those that are nothing: an array for each, every second as it is,
        since what hangs together by many links may have no place with others."""
        moved = numpy.arange(count) % 2
        draw, flat = numpy.random.default_rng(1), {n: numpy.full(count, v) for n, v in self.home().items()}
        for knob in self.all():
            times = 1 + SHAKEN * moved * draw.uniform(-1, 1, count)
            flat[knob["given"]] = flat[knob["given"]] + (times - 1) * knob.get("reach", 0.0)
            for name, power in {knob["given"]: 1, **knob["tied"]}.items():
                flat[name] = flat[name] * times**power
        whole = {
            n: flat[f"{n}.x"] + 1j * flat[f"{n}.y"] if isinstance(z, complex) else flat[n]
            for n, z in self.given.items()
        }
        return {n: z for n, z in whole.items() if numpy.ptp(abs(z)) > 0}

    def told(self, given: str, axis: str) -> str:
        """The name a number is told by, "" where it is not offered."""
        means, letter = self.plans.means.get(given), parts_of(given)[0]
        if means and means.quantity in ("load", "couple"):
            return means.of
        ends = (
            {f"at_{p}_{means.link}" for p in (means.of, means.about)} if means and means.quantity == "length" else set()
        )
        if ends & self.given.keys():
            return ""  # the places of its points on the link are given, and it is reckoned from them
        if means and means.quantity == "place":
            return f"{axis}_{parts_of(given)[1]}" if "°" not in given else ""
        return given if letter in ("l", "m", "J", "omega", "epsilon", "v", "a", "g") else aimed(given)

    def drags(self) -> dict[str, list[str]]:
        """For each mark of the scheme the numbers that place it."""
        free, drive = self.home(), self.plans.drive_given
        found = {}
        for step in self.plans.program.steps:
            names = [n for n in self.placing(step) if free.get(n) or n == drive]
            if plan_of(step.makes) == "position" and step.kind == "mark" and names:
                found[step.makes] = names
        return found

    def placing(self, step: Step) -> list[str]:
        """The numbers a step places its mark by."""
        match step:
            case Put() if step.at:
                return [f"{step.at}.x", f"{step.at}.y"]
            case LayOff():
                turned = getattr(self.plans.program.makers.get(step.along), "of", "")
                driven = turned == f"x_{self.plans.mechanism.drive.link}" or step.length == self.plans.drive_given
                return [step.length, *[self.plans.drive_given] * driven]
            case CrossArc():
                return [step.radius]
            case CrossArcs():
                return [step.radius, step.other_radius]
        return []
