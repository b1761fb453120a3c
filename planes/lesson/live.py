"""The program of a lesson as a page runs it: a tape of everything shown."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from types import MappingProxyType

from planes.batch.plain_tape import FLOAT_OPERATIONS, PlainRecording, export_operations
from planes.batch.symbols import place_of_number
from planes.batch.tape import Tape, compute_places
from planes.batch.tracing import TracingTool
from planes.check.grading.plan_steps import PlanSteps
from planes.check.grading.prepared_plan import catalogue_mistakes, known_plans
from planes.drafting.drawing import Drawing, draw_steps
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Thing, Things, names_for_step_sentence
from planes.geometry.arrays import FloatsByName
from planes.lesson import slot_value
from planes.lesson.formulas import sentence_in_lesson_languages, value_slot
from planes.lesson.frame import values_of_frames
from planes.lesson.practice import Practice, Progress
from planes.lesson.scheme import arm_foot_marks, moment_arms
from planes.lesson.told import SceneLesson
from planes.plans import Plans
from planes.words import Lang, Phrase
from planes.words.names import MOTION_PLAN, NO_PLAN, plan_of
from planes.words.records import Json

LEAST_MISTAKE_OFFSET_MM = 0.3  # a wrong place closer than this to the right one is no mistake
MOST_SUCCESSIVE_PLANS = 4
SETTLED_TOLERANCE_RATIO = 1e3
"""Successive plans of a page, which shows four digits, and the tolerance of the last of them, relative to the root of
rounding."""


@dataclass
class _KeepingTool(TracingTool):
    """Continues from marks as stored, not from its own results."""

    kept: Things = field(default_factory=dict)

    def draw_by_other_steps(self, step: Step, way: Sequence[Step], things: Env) -> Thing:
        made = super().draw_by_other_steps(step, way, things)
        things[step.makes] = self.kept.get(step.makes, things[step.makes])
        return made


class Live:
    """A lesson on a tape, with all givens free: every step drawn once, and for its ``practice`` its mistakes.

    ``things`` are all that a page knows, by group and name; ``feet`` the marks of arms, ``fails`` the sentences for
    conditions.
    """

    def __init__(self, lesson: SceneLesson, progress: Progress | None = None, practice: bool = True) -> None:
        free = lesson.knobs
        program = lesson.plans.program
        self.tape = Tape()
        self.home = free.values_in_scene
        self.tool = self.continuing_tool()
        drawn = free.givens_on_tape(self.tape, self.tool.ar)
        draw_steps(program.steps, drawn, self.tool)
        self.drawing = Drawing(program, drawn, self.tool)
        sharp = self.drawing.crossing_sharpness.items()
        self.sharp = {n: z for n, z in sharp if n not in program.trial_marks and plan_of(n) != "motion"}
        self.feet = arm_foot_marks(lesson.plans, self.drawing)
        numbers = Env()
        self.fails = [*self.failure_sentences(lesson.plans, numbers)]
        slips = [*self.mistakes_on_tape(lesson.practice, progress)] if practice else []
        off = self.evaluate_on_tape(
            {str(k): z - self.drawing[slip["at"]] for k, (slip, z) in enumerate(slips)}, self.home
        )
        visible = [slips[int(k)] for k, z in off.items() if abs(z) > LEAST_MISTAKE_OFFSET_MM]
        self.slips = [slip for slip, _ in visible]
        wrong = {str(k): z for k, (_, z) in enumerate(visible)}
        made = (s for s in program.steps if s.plan not in (NO_PLAN, MOTION_PLAN) and s.makes not in program.trial_marks)
        self.things: dict[str, Things] = {
            "marks": {s.makes: drawn[s.makes] for s in made} | self.feet,
            "turned": {d: drawn[d] for d in page_directions(lesson) if d in drawn},
            "values": {
                **{n: slot_value(n, lesson.teller, self.drawing) for n in page_values(lesson)},
                **numbers,
                **lesson.practice.tangential_moments(self.drawing),
            },
            "sharp": self.sharp,
            "holds": {str(k): ok for k, (_, _, ok, _) in enumerate(self.tool.failures)},
            "slips": wrong,
        }

    def continuing_tool(self, kept: Things = MappingProxyType({})) -> _KeepingTool:
        """Another tool that continues the tape; marks that are ``kept`` stay, whatever they depend on."""
        return _KeepingTool(
            PlainRecording(),
            True,
            tape=self.tape,
            plans=MOST_SUCCESSIVE_PLANS,
            settled=SETTLED_TOLERANCE_RATIO,
            kept=kept,
        )

    def mistakes_on_tape(self, practice: Practice, progress: Progress | None) -> Iterator[tuple[Json, Thing]]:
        """Every mistake at every mark asked for, and the place on the tape where it puts the mark."""
        plans = practice.plans
        drawn = self.drawing
        asked = {item["what"] for item in practice.practice_items() if item["kind"] == "mark"}
        for k, plan in enumerate(names := known_plans(plans)):
            if progress:
                progress(k + 1, len(names))
            own = {s.makes for s in plans.program.mark_steps_by_plan[plan]}
            tool = self.continuing_tool({m: drawn[m] for m in own})
            ways = PlanSteps(plans, plans.program.cut_to_names([*own]), plan)
            for variant in catalogue_mistakes(ways, {}, complex(practice.given[plan.mu_name]).real):
                mark = plan.mark(variant.blames)
                made = variant.draw_affected_steps(ways.program, drawn.things, tool, own) if mark in asked else {}
                if mark in made:
                    yield practice.mistake_at_mark(variant, mark), made[mark]

    def evaluate_on_tape(self, things: Things, given: FloatsByName) -> dict[str, complex]:
        """Marks and values of the tape with those numbers."""
        places = {n: self._tape_coordinates(z) for n, z in things.items()}
        numbers = compute_places(
            self.tape,
            self.tape.places_needed([p for own in places.values() for p in own]),
            given,
            float,
            FLOAT_OPERATIONS,
        )
        return {n: complex(*(float(numbers[p]) for p in own)) for n, own in places.items()}

    def failure_sentences(self, plans: Plans, named: Env) -> Iterator[dict[Lang, str]]:
        """The sentences for the failure of each condition, in drawing order; their numbers get names."""
        turns = plans.drive.rotates
        for k, (reason, step, _, numbers) in enumerate(self.tool.failures):
            details = {**getattr(step, "ends", {}), **{n: value_slot(f"!{n}_{k}") for n in numbers}}
            named |= {f"!{n}_{k}": x if n == "value" else abs(x) for n, x in numbers.items()}
            why = Phrase(reason, **names_for_step_sentence(step), **details)
            where = value_slot(plans.drive_given_name, "k") + "°" * turns
            yield sentence_in_lesson_languages("at", name="φ" if turns else "s", value=where, why=why, nearest="")

    def tape_and_places(self, things: Mapping[str, Things]) -> tuple[Json, Json]:
        """The tape, and the places on it of all results by group and name: one for a number, two for a mark."""
        old = {group: {n: self._tape_coordinates(z) for n, z in them.items()} for group, them in things.items()}
        exported_tape, new = export_operations(
            self.tape, [p for them in old.values() for places in them.values() for p in places]
        )
        del exported_tape["sources"]
        flat = {
            group: {n: new[p[0]] if len(p) == 1 else [new[q] for q in p] for n, p in them.items()}
            for group, them in old.items()
        }
        return exported_tape, flat

    def _tape_coordinates(self, thing: Thing) -> list[int]:
        """The two coordinates of a mark or a direction."""
        parts = [thing.real, thing.imag] if hasattr(thing, "conjugate") and not isinstance(thing, float) else [thing]
        return [place_of_number(self.tape, x) for x in parts]


def moments_and_free_bodies(lesson: SceneLesson) -> list[Json]:
    """The moment equations and the free bodies of a lesson, with the forces and couples on each."""
    return [*moment_arms(lesson.plans), *lesson.teller.bodies.forces_by_polygon.values()]


def page_directions(lesson: SceneLesson) -> list[str]:
    """The directions that a page draws: of guides and their lines, and of forces."""
    plans = lesson.plans
    ways = [f"∥{g}" for g in plans.mechanism.owners]
    ways += [f.along for f in plans.acting.every if plans.figure and f.spot]
    ways += [line.along for c in plans.centres for line in c.lines]
    ways += [f["along"] for one in moments_and_free_bodies(lesson) for f in one["forces"]]
    return [*dict.fromkeys([*ways, *lesson.practice.named_directions()])]


def page_values(lesson: SceneLesson) -> list[str]:
    """The values that a page shows or draws with."""
    plans = lesson.plans
    sizes = [f["size"] for one in moments_and_free_bodies(lesson) for kind in ("forces", "couples") for f in one[kind]]
    known = [size for size in sizes if size in plans.program.result_names or size in plans.given]
    shown = values_of_frames([*lesson.frames, *(lesson.leaning or {}).values()])
    return [
        *dict.fromkeys(
            [
                *shown,
                *rates_and_balancing_loads(plans),
                *known,
                *(p.mu_name for p in plans.plan_names),
                plans.drive_given_name,
            ]
        )
    ]


def rates_and_balancing_loads(plans: Plans) -> list[str]:
    """Angular velocities and accelerations, and balancing loads, shown beneath the plans at every position."""
    rates = [*(link.omega for link in plans.links.values()), *(link.epsilon for link in plans.links.values())]
    return [n for n in dict.fromkeys([*rates, plans.balancing, plans.zhukovsky]) if n in plans.program.result_names]
