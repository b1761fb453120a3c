"""A lesson: the program and its drawing as numbered frames, each with a sentence on the action and one on the reason.

Numbers are in slots (:mod:`planes.lesson.formulas`), so a frame serves every position of the mechanism.
"""

from collections.abc import Sequence
from functools import partial

from planes.drafting.drawing import Drawing
from planes.drafting.steps import MarkStep, Put, Step
from planes.drafting.steps.crossings import Touch
from planes.drafting.steps.reckoning import Calculate
from planes.geometry.arrays import Floats
from planes.lesson.centres import CentreFrames
from planes.lesson.formulas import (
    SLOT_PATTERN,
    UNITS_BY_LETTER,
    in_brackets,
    in_lesson_languages,
    plan_scale_text,
    value_slot,
)
from planes.lesson.frame import Frame, Frames, with_chapters
from planes.lesson.free_bodies import FreeBodies
from planes.lesson.moments import as_positions, moment_words
from planes.lesson.reckoning import Reckoning
from planes.lesson.rows import Row, calculation_row
from planes.lesson.standing import with_zero_vector_sentences
from planes.lesson.stated import StatedWords, equations_by_last_mark
from planes.lesson.stating import Stating
from planes.lesson.steps import StepWords, displayed_term_name, plan_showing_step, single_link_words, unknown_vectors
from planes.plans import Plans
from planes.plans.apart import links_with_own_polygon
from planes.plans.force.derived import unit_key_of_value
from planes.plans.force.reactions import Reaction
from planes.words import Phrase, Told, Written
from planes.words.names import (
    ACCELERATION_PLAN,
    LEVER_PLAN,
    POLE_LABEL,
    SCHEME_PLAN,
    VELOCITY_PLAN,
    MarkTuple,
    NamePair,
    NameTriple,
    NameTuple,
    PlanId,
    letter_of,
    name_without_plan,
    plan_of,
)
from planes.words.units import Convention


class Teller:
    """Words the steps of one drawing; ``cycle`` is the drawing (of many positions, and of links of many lengths) that
    decides which terms count as zero."""

    def __init__(
        self, plans: Plans, drawing: Drawing, cycle: Drawing | None = None, convention: Convention = "mm_per_unit"
    ) -> None:
        self.convention: Convention = convention
        self.plans = plans
        self.drawing = drawing
        self.cycle = cycle or drawing
        self.made = drawing.program.steps_by_result
        rates = (rate for link in plans.links.values() for rate in (link.omega, link.epsilon))
        self.rates = {*rates, *plans.values.values()}
        self.moments = {m.unknown: i for i, m in enumerate(plans.moments)}
        self.spans: dict[str, NameTriple] = {}  # segments measured only for the lesson
        self.trials = drawing.program.trial_marks | {c.mark for c in plans.centres}  # no frames of the scheme
        drawn = {
            p: [s.makes for s in own if s.makes not in self.trials]
            for p, own in drawing.program.mark_steps_by_plan.items()
        }
        self.ends = {own[-1] for plan, own in drawn.items() if plan.is_force}
        self.still = {
            p for p in (VELOCITY_PLAN, ACCELERATION_PLAN) if p in plans.plan_names and self.plan_is_at_pole(p)
        }
        self.reckoning = Reckoning(plans, self.made, convention)
        self.words = (StepWords if plans.has_mechanism else StatedWords)(plans, drawing, self.made)
        self.solved = {} if plans.has_mechanism else equations_by_last_mark(plans)
        self.stating = Stating(plans)
        self.bodies = FreeBodies(plans, drawing)

    def lesson_frames(self) -> Frames:
        """All frames, in drawing order."""
        put = [step for step in self.drawing.program.steps if isinstance(step, Put) and step.at]
        names = in_brackets(name_without_plan(p.makes) for p in put if not p.is_auxiliary_mark)
        key = "points" if self.plans.figure else "fixed"
        frames = [self.make_frame(key, SCHEME_PLAN, tuple(p.makes for p in put), names=names)] if put else []
        readings = []
        for step in self.drawing.program.steps:
            if step.makes in self.moments or step.makes in self.rates:
                readings.append(step)
            if step in put or step.makes in self.trials or not self.has_own_frame(step):
                continue
            frames += self.frames_of_values(readings, frames)
            readings = []
            frames.append(self.mark(step))
            solved = ((e.plan, unknown_vectors(e)) for e in self.solved.get(step.makes, ()))
            frames += [self.measured_segments_frame("measured", plan, names) for plan, names in solved if names]
            if step.makes in self.ends:
                frames += self.closing_frames(plan_showing_step(step))
        stated = self.stating.insert_vector_equations(frames + self.frames_of_values(readings, frames), self.make_frame)
        opened = self.bodies.insert_free_bodies(stated, self.make_frame)
        return self.ordered_by_values(
            CentreFrames(self.plans, self.make_frame, self.measured_segment_row).insert_chapter(opened)
        )

    def ordered_by_values(self, frames: Frames) -> Frames:
        """The frames in an order in which every number is found before it is used, and each frame that finds one comes
        just before its first use."""
        reckoning = self.reckoning
        ordered = []
        for f in frames:
            if steps := reckoning.steps_of_missing_values(f):
                arms = self.plans.moments[f.moments].terms if f.moments is not None else ()
                terms = tuple(force for force, arm in arms if arm in {step.makes for step in steps})
                rows = tuple(map(reckoning.value_row, steps))
                reason = "found_arms" if terms else "found_values"
                ordered.append(self.make_frame("found_values", f.plan, (), (), reason, terms, f.moments, rows))
            reckoning.record_frame_values(f)
            ordered.append(f)
        return with_chapters(with_zero_vector_sentences(ordered, self.plans))

    def plan_is_at_pole(self, plan: PlanId) -> bool:
        """Whether every mark of a plan is at its pole in every position: there is nothing to draw."""
        own = self.drawing.program.mark_steps_by_plan[plan]
        return all(not size >= 1e-6 for step in own for size in as_positions(abs(self.cycle[step.makes])))

    def has_own_frame(self, step: Step) -> bool:
        """Whether a step has its own frame."""
        drawn = isinstance(step, Touch) or step.kind == "mark"
        return drawn and step.makes != SCHEME_PLAN.pole and plan_showing_step(step) not in {"motion", *self.still}

    def make_frame(
        self,
        key: str,
        plan: PlanId,
        makes: MarkTuple = (),
        uses: NameTuple = (),
        reason: Told = "",
        terms: NameTuple | None = None,
        moments: int | None = None,
        rows: tuple[Row, ...] = (),
        **names: object,
    ) -> Frame:
        """A frame with its words in every language, of the ``names`` of its sentence and its ``rows``, by their
        numbers."""
        index, equation_terms = self.equation_and_terms(plan, makes)
        own = ((m[1], m[2]) for said in names.values() if isinstance(said, str) for m in SLOT_PATTERN.finditer(said))
        scale = [("k", plan.mu_name)] if key in ("pole", "fixed", "points") else []
        numbers = (*scale, *own, *(n for row in rows for n in row.slots_of_numbers()))
        mu = Written(partial(plan_scale_text, plan, convention=self.convention))
        lines = "; ".join(f"⟪{rows.index(row)}⟫" for row in rows)
        marked = in_lesson_languages(Phrase(f"lesson_{key}", **{**names, "mu": mu, "rows": lines}).told)
        why = in_lesson_languages((reason if isinstance(reason, Phrase) else Phrase(f"why_{reason or key}")).told)
        in_hand = equation_terms if terms is None else terms
        return Frame(key, plan, makes, uses, index, in_hand, marked, why, moments, rows=rows, numbers=numbers)

    def equation_and_terms(self, plan: PlanId, makes: MarkTuple) -> tuple[int | None, NameTuple]:
        """The equation on this plan with a term that ends at one of the marks, and those terms."""
        labels = {m.label for m in makes} - {POLE_LABEL}
        for index, equation in enumerate(self.plans.equations):
            terms = tuple(
                displayed_term_name(equation, t.name) for t in equation.all_terms if t.end in labels and not t.drawn
            )
            if equation.plan == plan and terms:
                return index, terms
        own = self.plans.segments_on(plan)
        return None, tuple([e.name for e in own if e.end in labels and e.start == POLE_LABEL][:1])

    def mark(self, step: Step) -> Frame:
        """The frame of one mark, or of a tangent."""
        read = dict.fromkeys(name for name, kind in step.input_names() if kind == "mark" and name not in self.trials)
        uses = tuple(name for name in read if plan_of(name) != "motion")
        fields = {f: name_without_plan(v) for f, v in vars(step).items() if isinstance(v, str) and f != "makes"}
        key, reason, more = self.words.words_of_step(step)
        makes = (step.makes,) if isinstance(step, MarkStep) else ()
        return self.make_frame(
            key,
            plan_showing_step(step),
            makes,
            uses,
            reason,
            **{**fields, "end": name_without_plan(step.makes), **more},
        )

    def frames_of_values(self, values: list[Step], before: Frames) -> Frames:
        """Frames for the values computed since the last mark: angular velocities and accelerations together, each
        moment equation alone."""
        rates = [v for v in values if v.makes not in self.moments and isinstance(v, Calculate)]
        last = next((f for f in reversed(before) if f.plan in ("velocity", "acceleration")), None)
        frames = []
        if not self.plans.has_mechanism:
            if rates and before:
                frames.append(self.measured_segments_frame("measured", before[-1].plan, (), rates))
        elif last:
            frames += self.stating.rotation_sense_frames(rates, last.plan, self.make_frame)
            crossed = last is before[-1] and last.key == "cross"
            if rates or crossed:
                frames.append(self.measurement_frame(last.plan, rates, before))
        return frames + [f for v in values if v.makes in self.moments for f in self.moment_equation_frames(v)]

    def measurement_frame(self, plan: PlanId, rates: list[Calculate], before: Frames) -> Frame:
        """The measurements on a velocity or acceleration plan after an equation is solved, and the angular values from
        them."""
        own = [f for f in before if f.plan == plan]
        solved = [self.plans.equations[f.equation] for f in own if f.equation is not None]
        known = {name for f in own if f.key == "measured" for name in f.terms}
        names = [name for e in solved[-1:] for name in unknown_vectors(e) if name not in known]
        return self.measured_segments_frame("measured", plan, names, rates)

    def measured_segments_frame(
        self, key: str, plan: PlanId, names: Sequence[str], rates: Sequence[Calculate] = ()
    ) -> Frame:
        """Measured segments of a plan, and velocities or accelerations with their formula and sense."""
        rows = (*(self.measured_segment_row(n, plan) for n in names), *map(self.value_row, rates))
        uses = tuple(dict.fromkeys(m for n in names for m in self.segment_ends(n, plan)))
        return self.make_frame(key, plan, uses=uses, terms=tuple(names), rows=rows)

    def value_row(self, rate: Calculate) -> Row:
        """A value with its formula; of a rotation also its sense."""
        turns = UNITS_BY_LETTER.get(letter_of(rate.makes)) in ("rad/s", "rad/s²")
        return calculation_row(
            rate, unit_key="" if self.plans.has_mechanism else unit_key_of_value(rate.makes), turns=turns
        )

    def segment_ends(self, name: str, plan: PlanId) -> NamePair | tuple[()]:
        """The ends of the segment of that name."""
        own = self.plans.segments_on(plan)
        return next((x.ends for x in own if x.name == name and x.start != x.end), ())

    def measured_segment_row(self, name: str, plan: PlanId) -> Row:
        """A measured segment: its millimetres and its value."""
        span = self.segment_ends(name, plan)
        if not span:
            return Row(name, "", "", "")
        read = f"‖{name}‖"
        mu = plan.mu_name
        self.spans[read] = (*span, mu)
        return self.reckoning.measured_length_row(name, read, mu, value_slot(read))

    def closing_frames(self, plan: PlanId) -> Frames:
        """The reactions read from a closed force polygon, those inside the group each with the link it closes."""
        links = [(one, one.reactions[one.force][0].key) for one in links_with_own_polygon(self.plans, plan)]
        inside = {key for _, key in links}
        reactions = [r for r in self.plans.reactions.values() if r.plan == plan]
        names = [r.key for r in reactions if r.key not in inside and self.segment_ends(r.key, plan)]
        names += [n for n in (self.bodies.balancing_load(plan),) if n and self.plans.drive.kind == "s"]
        frames = [self.measured_segments_frame("closing", plan, names)] if names else []
        for one, key in links:
            row = self.measured_segment_row(key, plan)
            frames.append(
                self.make_frame(
                    "apart", plan, terms=one.closed_vector_names, rows=(row,), **single_link_words(one, key)
                )
            )
        return frames + [self.friction_frame(plan, r) for r in reactions if r.power in self.made]

    def friction_frame(self, plan: PlanId, r: Reaction) -> Frame:
        """Both components of a reaction with friction, or its circle, and the power of friction."""
        key, parts = ("friction_circle", []) if r.pair.point else ("friction", [r.normal, r.friction])
        rows = tuple(self.reckoning.value_row(self.made[n]) for n in (*parts, r.power))
        return self.make_frame(key, plan, terms=(r.key,), rows=rows, force=r.key, point=r.pair.point)

    def reaction_arm_frame(self, r: Reaction) -> Frame:
        """The arm at which a slider's reaction acts, by its couple."""
        arm = self.made[r.arm]
        assert isinstance(arm, Calculate)
        mm = value_slot(r.arm, "mm", SCHEME_PLAN.mu_name)
        return self.make_frame("seated", r.plan, terms=(r.key,), rows=(calculation_row(arm),), force=r.key, mm=mm)

    def moment_equation_frames(self, step: Step) -> Frames:
        """A moment equation with its numbers."""
        if not isinstance(step, Calculate):
            return []
        index = self.moments[step.makes]
        m = self.plans.moments[index]
        key, names, terms = moment_words(m, step, self.cycle)
        plan, reason = (LEVER_PLAN, "moments_lever") if m.links == ("lever",) else (SCHEME_PLAN, "moments")
        frames = [self.make_frame(key, plan, reason=reason, terms=terms, moments=index, **names)]
        seats = (r for r in self.plans.reactions.values() if r.moment == step.makes and key == "moments")
        return frames + [
            self.reaction_arm_frame(r) for r in seats if abs(self.drawing[r.arm]) < 1e6 * self.plans.longest_link_length
        ]  # no NaN


def slot_value(name: str, teller: Teller, drawing: Drawing) -> Floats:
    """A value of a drawing (of one position or many) by the name used in a slot."""
    start, end, mu = teller.spans.get(name, ("", "", ""))
    return abs(drawing[end] - drawing[start]) / drawing[mu] if mu else drawing[name]  # type: ignore[no-any-return]
