"""A plan of a scene prepared for checking drawings of it: program, marks, scale, and possible mistakes."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property

from planes.check.grading.mistakes import motion_variants
from planes.check.grading.mistakes_force import force_variants
from planes.check.grading.mistakes_position import position_variants
from planes.check.grading.paper import MarkPlaces, ReadPaper, TakenMarks
from planes.check.grading.plan_steps import PlanSteps
from planes.check.grading.variants import Variant, Variants
from planes.drafting.drawing import Drawing, draw_program, draw_steps
from planes.drafting.program import Program
from planes.drafting.skill import STUDENT_SKILL, Skill
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Arithmetic
from planes.plans import Plans
from planes.plans.measuring import scene_lettering
from planes.plans.other_leads import plans_with_sharp_leads
from planes.plans.scales import plan_scales, plan_sizes_on_format
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.words import Phrase, Written
from planes.words.errors import PlanesError, list_valid_choices
from planes.words.frozen import frozen
from planes.words.names import NO_PLAN, POLE_LABEL, VELOCITY_PLAN, Mark, NamePair, NameTuple, PlanId, label_of
from planes.words.naming import Names, Naming
from planes.words.units import mu_text


@frozen
class Asked:
    """The subject of a check: a plan of a scene at a drive value, with what is given of the drawing."""

    scene: Scene
    plan: str
    value: float | None = None
    mu: float | None = None
    skill: Skill = STUDENT_SKILL
    others: Mapping[PlanId, ReadPaper] = field(default_factory=dict)  # drawings of earlier plans
    answers: NameTuple = ()  # results of a complete work, where known

    def command_words(self, file: str) -> list[str]:
        """The words of the command that checks a file in this way."""
        words = ["planes", "check", self.scene.file, file, "--plan", self.plan]
        words += ["--variant", self.scene.variant] if self.scene.variant else []
        drive = self.scene.mechanism.drive if self.scene.mechanism and self.value is not None else None
        return [*words, f"--{drive.kind}={self.value:g}"] if drive else words


@dataclass
class PreparedPlan:
    """All that is independent of the drawing's scale."""

    asked: Asked
    plans: Plans
    given: Env
    program: Program
    marks: list[Mark]
    said_mu: float

    @cached_property
    def plan(self) -> PlanId:
        """The plan asked for."""
        return PlanId.read(self.asked.plan)

    @property
    def kind(self) -> str:
        """Its kind."""
        return self.plan.kind

    @property
    def written_mark_names(self) -> Names:
        """Names of the plan's marks as people write them."""
        return mark_names(self.plans, self.plan, self.naming)

    @cached_property
    def naming(self) -> Naming:
        """The lettering of names on the scene's sheets."""
        return Naming(**scene_lettering(self.asked.scene, self.plans))

    @cached_property
    def true_marks(self) -> MarkPlaces:
        """The marks of the right plan by label, mm from the pole."""
        return {m.label: complex(self.right_drawing[m]) for m in self.marks}

    @cached_property
    def right_drawing(self) -> Drawing:
        """The right plan, drawn."""
        return draw_program(self.program, self.given)

    @cached_property
    def leaning_reactions(self) -> list[tuple[str, str, complex, str]]:
        """The ends of each reaction that leans by friction, by label, with the direction of its guide and its index."""
        own = (r for r in self.plans.reactions.values() if r.plan == self.plan and r.leans)
        ends = ((r, r.start.label, r.end.label) for r in own)
        return [(start, end, complex(self.right_drawing[f"∥{r.pair.guide}"]), r.index) for r, start, end in ends]

    @cached_property
    def mistakes(self) -> list[Variant]:
        """The mistakes of the catalogue, at the stated scale, without a person's marks."""
        return mistake_variants(self, {}, self.said_mu)

    @cached_property
    def vector_names(self) -> dict[NamePair, str]:
        """The names of a motion plan's vectors by the labels of their ends."""
        own = (s for s in self.plans.segments_on(self.plan) if s.start != s.end)
        return {(s.start, s.end): s.name for s in own}

    @cached_property
    def _drawing_before_marks(self) -> tuple[int, Env]:
        """The number of the first step that makes a mark of the plan, and the drawing before it."""
        own = next((k for k, step in enumerate(self.program.steps) if step.makes in self.marks), 0)
        things = dict(self.given)
        try:
            draw_steps(self.program.steps[:own], things, Tool(Arithmetic()))
        except PlanesError:
            return 0, dict(self.given)
        return own, things

    @cached_property
    def _first_step_using(self) -> dict[str, int]:
        """For each element the number of the first step that makes or reads it."""
        steps = [*enumerate(self.program.steps)]
        return {name: k for k, step in reversed(steps) for name in (step.makes, *(n for n, _ in step.input_names()))}

    def draw_program(self, variant: Variant | None, tool: Tool) -> Env | None:
        """The program drawn by a tool, right or with a mistake; None if that is impossible.

        The part before the plan's marks, and before all that the mistake affects, is not redrawn.
        """
        swaps, givens = (variant.swaps, variant.givens) if variant else ({}, {})
        first, before = self._drawing_before_marks
        first = min([first, *(self._first_step_using[n] for n in (*swaps, *givens) if n in self._first_step_using)])
        things = {**before, **givens}
        try:
            draw_steps(self.program.steps[first:], things, tool, swaps)
        except (PlanesError, ZeroDivisionError):
            return None
        return things

    def written_scale(self, mu: float) -> Written:
        """A scale of the plan as written in a sentence."""
        return Written(lambda lang: mu_text(mu, self.kind, lang, self.asked.scene.mu_convention))

    def marks_by_label(self, places: MarkPlaces) -> MarkPlaces:
        """Places of marks of the plan by label, from those by the names that a person wrote."""
        return {n: z for k, z in places.items() if (n := self.written_mark_names.find_name(k))}

    def pointed_positions(self, marks: MarkPlaces, place: Callable[[complex], complex]) -> MarkPlaces:
        """The positions of marks that a person pointed to, by label.

        None in a force plan, where the order of vectors, and so the positions of marks, is free.
        """
        if self.plan.is_force:
            return {}
        return {n: place(z) for n, z in self.marks_by_label(marks).items()}

    def at_scale(self, mu: float | None, fixed: bool = True) -> PreparedPlan:
        """The same at another scale, if there is one; ``fixed`` if no other is considered."""
        if not mu:
            return self
        asked = replace(self.asked, mu=mu) if fixed else self.asked
        return replace(self, asked=asked, given={**self.given, self.plan.mu_name: mu}, said_mu=mu)


def prepare(asked: Asked) -> PreparedPlan:
    """The program of the plan, its marks and its stated scale. Errors list the available plans."""
    plans = scene_plans(asked.scene)
    known = known_plans(plans)
    plan = PlanId.read(asked.plan)
    if plan not in known:
        raise PlanesError(Phrase("check_no_plan", plan=asked.plan, names=list_valid_choices(asked.plan, known)))
    moved = {} if asked.value is None else plans.drive_givens_at(asked.value)
    plans = plans if asked.value is None else plans_with_sharp_leads(plans, asked.value)
    given = {
        **plans.given,
        **plan_scales(plans, asked.scene.mu, moved, plan_sizes_on_format(asked.scene.sheet)),
        **moved,
    }
    if asked.mu:
        given[plan.mu_name] = asked.mu
    marks = plan_marks(plans, plan)
    speeds = plan_marks(plans, VELOCITY_PLAN) if plan == "acceleration" else []  # any may be confused with another
    program = plans.program.cut_to_names([*marks, *speeds])
    return PreparedPlan(asked, plans, given, program, marks, given[plan.mu_name])


def known_plans(plans: Plans) -> list[PlanId]:
    """The plans drawn by a person."""
    return [p for p in plans.plan_names if p not in ("lever", "motion")]


def plan_marks(plans: Plans, plan: PlanId) -> list[Mark]:
    """The marks of a plan drawn by a person, in order of drawing."""
    own = plans.program.mark_steps_on(plan)
    return [s.makes for s in own if not s.is_auxiliary_mark and s.label != POLE_LABEL]


def mark_names(plans: Plans, plan: PlanId, naming: Naming) -> Names:
    """Names of a plan's marks; the normal component of a driven point, n_A, may include its pivot: n_AO."""
    means = ((label_of(mark), m) for mark, m in plans.means.items() if m.quantity == "normal" and m.about)
    normal = {label: (f"n_{m.of}{m.about}",) for label, m in means}
    return naming.name_finder([m.label for m in plan_marks(plans, plan)], more=normal)


def catalogue_mistakes(ways: PlanSteps, taken: TakenMarks, mu: float) -> Variants:
    """Every possible mistake in a plan, drawn at a scale with some of a person's own marks."""
    kind = ways.plan.kind
    if kind == "position":
        return position_variants(ways, taken, mu)
    return force_variants(ways) if kind == "force" else motion_variants(ways)


def mistake_variants(bench: PreparedPlan, taken: TakenMarks, mu: float, plan: PlanId = NO_PLAN) -> list[Variant]:
    """Every possible mistake in a plan, by default the one checked."""
    drive = bench.plans.drive_given_name
    there = replace(bench.plans, given={**bench.plans.given, drive: bench.given[drive]})
    return list(catalogue_mistakes(PlanSteps(there, bench.program, plan or bench.plan), taken, mu))


def drawn_mark_position(bench: PreparedPlan, variant: Variant | None, label: str) -> complex | None:
    """The position of a mark, mm from the pole, in this drawing of the plan; None if it cannot be drawn."""
    things = bench.draw_program(variant, Tool(Arithmetic()))
    if things:
        return complex(things[bench.plan.mark(label)])
    return None
