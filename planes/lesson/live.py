"""The program of a lesson as a page runs it: a tape of everything shown."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from planes.batch.plain_tape import PLAIN, PlainRecording, exported
from planes.batch.symbols import place_of
from planes.batch.tape import Tape, reckoned
from planes.batch.tracing import TracingTool
from planes.check.grading.plan_steps import PlanSteps
from planes.check.grading.prepared_plan import catalogue, known_plans
from planes.drafting.drawing import Drawing, draw_steps
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Thing, names_of
from planes.geometry.arrays import Floats
from planes.lesson import value_of
from planes.lesson.formulas import slot, spoken
from planes.lesson.frame import needed
from planes.lesson.practice import Practice, Progress
from planes.lesson.scheme import arms, feet
from planes.lesson.told import Told
from planes.plans import Plans
from planes.words import Lang, Phrase
from planes.words.names import at, mu_of, plan_of
from planes.words.records import Json

APART_MM = 0.3  # a wrong place closer than this to the right one is no mistake
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
    """A lesson on a tape, with all givens free: every step drawn once, and for its ``practice`` its mistakes.

    ``things`` are all that a page knows, by group and name; ``feet`` the marks of arms, ``fails`` the sentences for
    conditions.
    """

    def __init__(self, lesson: Told, progress: Progress | None = None, practice: bool = True) -> None:
        free, program = lesson.knobs, lesson.plans.program
        self.tape, self.home = Tape(), free.home
        self.tool = self.another()
        drawn = free.on(self.tape, self.tool.ar)
        draw_steps(program.steps, drawn, self.tool)
        self.drawing = Drawing(program, drawn, self.tool)
        sharp = self.drawing.sharpness.items()
        self.sharp = {n: z for n, z in sharp if n not in program.trials and plan_of(n) != "motion"}
        self.feet, numbers = feet(lesson.plans, self.drawing), Env()
        self.fails = [*self.failures(lesson.plans, numbers)]
        slips = [*self.mistakes(lesson.practice, progress)] if practice else []
        off = self.numbers_of({str(k): z - self.drawing[slip["at"]] for k, (slip, z) in enumerate(slips)}, self.home)
        visible = [slips[int(k)] for k, z in off.items() if abs(z) > APART_MM]
        self.slips, wrong = [slip for slip, _ in visible], {str(k): z for k, (_, z) in enumerate(visible)}
        made = (s.makes for s in program.steps if s.kind == "mark" and s.makes not in program.trials)
        self.things: dict[str, Mapping[str, Thing]] = {
            "marks": {name: drawn[name] for name in made if plan_of(name) != "motion"} | self.feet,
            "turned": {d: drawn[d] for d in directions(lesson) if d in drawn},
            "values": {
                **{n: value_of(n, lesson.teller, self.drawing) for n in values(lesson)},
                **numbers,
                **lesson.practice.senses(self.drawing),
            },
            "sharp": self.sharp,
            "holds": {str(k): ok for k, (_, _, ok, _) in enumerate(self.tool.failures)},
            "slips": wrong,
        }

    def another(self, kept: Mapping[str, Thing] = MappingProxyType({})) -> _KeepingTool:
        """Another tool that continues the tape; marks that are ``kept`` stay, whatever they depend on."""
        return _KeepingTool(PlainRecording(), True, tape=self.tape, plans=FEW, settled=NEAR, kept=kept)

    def mistakes(self, practice: Practice, progress: Progress | None) -> Iterator[tuple[Json, Thing]]:
        """Every mistake at every mark asked for, and the place on the tape where it puts the mark."""
        plans, drawn = practice.plans, self.drawing
        asked = {item["what"] for item in practice.items() if item["kind"] == "mark"}
        for k, plan in enumerate(names := known_plans(plans)):
            if progress:
                progress(k + 1, len(names))
            own = {s.makes for s in plans.program.marks[plan]}
            tool = self.another({m: drawn[m] for m in own})
            ways = PlanSteps(plans, plans.program.sliced([*own]), plan)
            for variant in catalogue(ways, {}, complex(practice.given[mu_of(plan)]).real):
                mark = at(plan, variant.blames)
                made = variant.drawn(ways.program, drawn.things, tool, own) if mark in asked else {}
                if mark in made:
                    yield practice.slip(variant, mark), made[mark]

    def numbers_of(self, things: Mapping[str, Thing], given: Mapping[str, Floats]) -> dict[str, complex]:
        """Marks and values of the tape with those numbers."""
        places = {n: self._places(z) for n, z in things.items()}
        numbers = reckoned(
            self.tape, self.tape.needed([p for own in places.values() for p in own]), given, float, PLAIN
        )
        return {n: complex(*(float(numbers[p]) for p in own)) for n, own in places.items()}

    def failures(self, plans: Plans, named: Env) -> Iterator[dict[Lang, str]]:
        """The sentences for the failure of each condition, in drawing order; their numbers get names."""
        turns = plans.drive.rotates
        for k, (reason, step, _, numbers) in enumerate(self.tool.failures):
            details = {**getattr(step, "ends", {}), **{n: slot(f"!{n}_{k}") for n in numbers}}
            named |= {f"!{n}_{k}": x if n == "value" else abs(x) for n, x in numbers.items()}
            why = Phrase(reason, **names_of(step), **details)
            where = slot(plans.drive_given, "k") + "°" * turns
            yield spoken("at", name="φ" if turns else "s", value=where, why=why, nearest="")

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


def loaded(lesson: Told) -> list[Json]:
    """The moment equations and the free bodies of a lesson, with the forces and couples on each."""
    return [*arms(lesson.plans), *lesson.teller.bodies.drawn.values()]


def directions(lesson: Told) -> list[str]:
    """The directions that a page draws: of guides and their lines, and of forces."""
    plans = lesson.plans
    ways = [f"∥{g}" for g in plans.mechanism.owners]
    ways += [f.along for f in plans.acting.every if plans.figure and f.spot]
    ways += [line.along for c in plans.centres for line in c.lines]
    ways += [f["along"] for one in loaded(lesson) for f in one["forces"]]
    return [*dict.fromkeys([*ways, *lesson.practice.lines()])]


def values(lesson: Told) -> list[str]:
    """The values that a page shows or draws with."""
    plans = lesson.plans
    sizes = [f["size"] for one in loaded(lesson) for kind in ("forces", "couples") for f in one[kind]]
    known = [size for size in sizes if size in plans.program.made or size in plans.given]
    shown = needed([*lesson.frames, *(lesson.leaning or {}).values()])
    return [*dict.fromkeys([*shown, *results(plans), *known, *map(mu_of, plans.drawn), plans.drive_given])]


def results(plans: Plans) -> list[str]:
    """Angular velocities and accelerations, and balancing loads, shown beneath the plans at every position."""
    rates = [*(link.omega for link in plans.links.values()), *(link.epsilon for link in plans.links.values())]
    return [n for n in dict.fromkeys([*rates, plans.balancing, plans.zhukovsky]) if n in plans.program.made]
