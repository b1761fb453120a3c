"""A scene drawn in its given position, with the frames of its lesson."""

from functools import cached_property

from planes.drafting.drawing import Drawing, draw_program
from planes.drafting.equations import Equation, Term
from planes.drafting.instruments import InLists
from planes.drafting.tools import Things
from planes.geometry.listed import Listed
from planes.lesson import Teller, slot_value
from planes.lesson.formulas import in_lesson_languages
from planes.lesson.frame import Frame, Frames, values_of_frames
from planes.lesson.knobs import Knobs
from planes.lesson.practice import Practice
from planes.lesson.steps import displayed_term_name
from planes.plans import Plans
from planes.plans.scales import plan_scales, plan_sizes, plan_sizes_on_format
from planes.plans.three_centres import plans_with_instant_centres
from planes.scene import Scene
from planes.solving import plans_and_requested_results
from planes.words import Phrase
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.frozen import frozen
from planes.words.names import PlanId, scheme_mark
from planes.words.records import Json

ZERO_TERM_TEST_POSITIONS = 180  # positions that decide which terms are zero


@frozen
class SceneLesson:
    """A scene drawn in its given position, and the frames of its lesson."""

    scene: Scene
    plans: Plans
    given: Things
    drawing: Drawing
    knobs: Knobs
    teller: Teller
    frames: Frames

    @classmethod
    def of(cls, scene: Scene, centres: bool = False) -> "SceneLesson":
        """The lesson of a scene; :class:`SceneError` where there is no mechanism or its given position fails."""
        plans, _ = plans_and_requested_results(scene, shown=True)
        plans = plans_with_instant_centres(plans) if centres else plans
        try:
            mus = plan_scales(plans, scene.mu, fit_mm=plan_sizes_on_format(scene.sheet))
            given = {**plans.given, **plans.drive_givens_at(plans.drive.position), **mus}
            drawing = draw_program(plans.program, given)
        except PlanFailure as failure:
            raise SceneError(Phrase("lesson_fails", failure=failure.phrase), scene.file, 1) from None
        knobs = Knobs(plans, given)
        teller = Teller(plans, drawing, _draw_sample_positions(knobs), scene.mu_convention)
        return cls(scene, plans, given, drawing, knobs, teller, teller.lesson_frames())

    def under(self) -> Json:
        """By the points of sliders, those under them, each with the frame whose equation first needs it."""
        numbered = ((k, f.equation) for k, f in enumerate(self.frames) if f.key == "equation")
        stated = [(k, self.plans.equations[n]) for k, n in numbered if n is not None]
        marks: Json = {}
        sliding = self.teller.stating.slider_of_vector
        for u in self.teller.stating.guided_points_by_motion.values():
            first = (k for k, e in stated if any(s and s.other == u.other for s in map(sliding, e.all_terms)))
            marks[scheme_mark(u.point)] = {"name": u.other, "from": next(first, -1)}
        return marks

    @cached_property
    def leaning(self) -> dict[int, Frame] | None:
        """Frames with more to say where guides are turned, by their number; None where the frames differ altogether."""
        if not any("stays" in knob for knob in self.knobs.offered_numbers):
            return {}
        frames = Teller(
            self.plans, self.drawing, _draw_sample_positions(self.knobs, True), self.scene.mu_convention
        ).lesson_frames()
        if [f.makes for f in frames] != [f.makes for f in self.frames]:
            return None
        return {k: f for k, (f, own) in enumerate(zip(frames, self.frames, strict=True)) if f != own}

    @cached_property
    def equations(self) -> list[Json]:
        """The vector equations as written."""
        return [written_equation(self.plans, e) for e in self.plans.equations]

    @cached_property
    def drive(self) -> Json:
        """The driver's number, and its range."""
        return drive_number_and_range(self.plans)

    @cached_property
    def practice(self) -> Practice:
        """The questions to a reader."""
        values = {n: float(slot_value(n, self.teller, self.drawing)) for n in values_of_frames(self.frames)}
        sizes = plan_sizes(self.plans, self.scene.mu, self.scene.sheet)
        own = self.plans, self.drawing, self.frames, self.equations, sizes
        return Practice(*own, self.given, values, self.teller.spans)


def _draw_sample_positions(knobs: Knobs, leaning: bool = False) -> Drawing:
    """The drawing of many positions, and of numbers near those of the scene."""
    plans = knobs.plans
    drive = drive_number_and_range(plans)
    start = drive["from"]
    reach = drive["to"] - drive["from"]
    values = Listed(start + reach * k / ZERO_TERM_TEST_POSITIONS for k in range(ZERO_TERM_TEST_POSITIONS))
    return draw_program(
        plans.program,
        {**knobs.given, **knobs.perturbed_givens(ZERO_TERM_TEST_POSITIONS, leaning), plans.drive_given_name: values},
        InLists(),
    )


def drive_number_and_range(plans: Plans) -> Json:
    """The driver's number, and its range: a single value, where a law is valid in the given position alone."""
    drive = plans.drive
    turns = drive.rotates
    reach, start = (0.0, drive.position % 1.0) if turns else (plans.longest_link_length, drive.position)
    still: Json = {"symbol": "φ" if turns else "s", "given": plans.drive_given_name, "at": drive.position, "held": None}
    still |= {"from": drive.position, "to": drive.position}
    if not plans.depends_on_drive:
        return still
    try:
        plans.drive_givens_at(drive.position + 1.0)
    except SceneError as law:  # a number valid only at the drive's position in the file
        return {**still, "held": in_lesson_languages(PlanesError(law.phrase).told)}
    return {**still, "from": start - reach, "to": start + (reach or 360.0)}


def written_equation(plans: Plans, e: Equation) -> Json:
    """An equation as written: without zero vectors, with a vector along the frame's guide as itself."""
    if not e.total:
        sides = [[_term_data(plans, e.plan, t, sign) for sign, t in side] for side in e.sides_as_written]
        return {"plan": e.plan, "total": None, "closed": e.is_closed_polygon, "sides": sides}
    total: Json = {"name": e.total, "action": "", "known": 0}
    sides = []
    for chain in e.chains:
        alone = [t for t in chain if displayed_term_name(e, t.name) == e.total and t.name != e.total]
        if alone:
            total.update(action=_line_of_action(plans, alone[0]), known=alone[0].known_part_count)
        elif chain:
            sides.append([_term_data(plans, e.plan, t, t.sign) for t in chain])
    return {"plan": e.plan, "total": total, "closed": False, "sides": sides}


def _term_data(plans: Plans, plan: PlanId, t: Term, sign: int) -> Json:
    start, end = plan.marks(*t.end_marks)
    own = {"name": t.name, "start": start, "end": end, "at": plan.mark(t.end)}
    return {**own, "action": _line_of_action(plans, t), "known": t.known_part_count, "minus": sign < 0}


def _line_of_action(plans: Plans, t: Term) -> str:
    """The line of action beneath a term."""
    return plans.means[t.direction].written_action if t.direction else t.action
