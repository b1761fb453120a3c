"""The data of a lesson page as one plain object: frames, equations, and the program itself as a tape.

The page runs the tape for any position and numbers, and draws lines between the resulting marks.
"""

from functools import partial

from planes.drafting.drawing import Drawing
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Choose
from planes.drafting.steps.tracks import TrackStep
from planes.lesson.centres import UNSEEN_CENTRE_REMARKS, crossing_lines_by_centre
from planes.lesson.formulas import (
    in_lesson_languages,
    plan_scale_text,
    sentence_in_lesson_languages,
    unit_of_name,
    value_slot,
)
from planes.lesson.frame import Frame, values_of_frames
from planes.lesson.kit import Kit
from planes.lesson.live import Live, rates_and_balancing_loads
from planes.lesson.practice import JUDGING_TOLERANCES, Progress, mistake_sentences, revealed_values
from planes.lesson.rows import row_templates
from planes.lesson.scheme import frame_hinges, moment_arms, owners_by_name, points_of_application, scheme_data
from planes.lesson.steps import displayed_term_name
from planes.lesson.told import SceneLesson
from planes.plans import Plans
from planes.plans.measuring import plan_title, scene_lettering
from planes.scene import Scene
from planes.words import Lang
from planes.words.lettering import plan_phrase
from planes.words.names import POLE_LABEL, SCHEME_PLAN, NamePair, PlanId, name_without_plan, plan_of
from planes.words.records import Json
from planes.words.units import Convention

MOTION = ("velocity", "acceleration", "lever")
"""The plans that are not of forces."""


def lesson_data(scene: Scene, progress: Progress | None = None, centres: bool = False, practice: bool = True) -> Json:
    """The lesson of a scene, with its instantaneous ``centres`` if requested; ``progress`` is called while the
    catalogue of mistakes is drawn. Without its ``practice`` it is ``pending``. Errors as for :class:`Told`."""
    lesson = SceneLesson.of(scene, centres)
    plans = lesson.plans
    drawing = lesson.drawing
    knobs = lesson.knobs
    frames = lesson.frames
    kit = Kit(plans, drawing)
    more = lesson.leaning or {}
    under = lesson.teller.stating.guided_points_by_motion.values()
    acts = points_of_application(plans)
    vectors = {s.name for s in plans.segments}
    return {
        "title": dict(scene.title),
        "moves": plans.has_mechanism,
        "formula": plans.structure.formula_with_frame_number(scene.frame_number).replace("->", "→")
        if plans.has_mechanism
        else "",
        "lettering": scene_lettering(scene, plans),
        "drive": lesson.drive,
        "home": knobs.values_in_scene,
        "knobs": [k for k in knobs.offered_numbers if lesson.leaning is not None or "stays" not in k],
        "drags": knobs.numbers_fixing_marks(),
        "plans": [_plan_data(plans, p, scene.mu_convention) for p in plans.plan_names if p != "motion"],
        "segments": _vector_segments(plans, drawing),
        "traces": _lines_and_arcs_of_marks(drawing),
        "scheme": scheme_data(plans, drawing),
        "moments": moment_arms(plans),
        "bodies": lesson.teller.bodies.forces_by_polygon,
        "related": owners_by_name(plans, {u.other: u.link for u in under}),
        "acts": {n: m for n, m in acts.items() if n in vectors},
        "under": lesson.under(),
        "equations": lesson.equations,
        "centres": crossing_lines_by_centre(plans),
        "noted": {
            k: sentence_in_lesson_languages(f"lesson_centre_{k}", name="{name}")
            for k in UNSEEN_CENTRE_REMARKS * bool(plans.centres)
        },
        "frames": (shown := [_frame_data(f, kit) for f in frames]),
        "leaning": {k: {n: z for n, z in _frame_data(f, kit).items() if z != shown[k][n]} for k, f in more.items()},
        "reckoned": row_templates(row for f in [*frames, *more.values()] for row in f.rows),
        "results": [
            {"name": n, "value": n, "unit": in_lesson_languages(unit_of_name(n).told)}
            for n in rates_and_balancing_loads(plans)
        ],
        "units": {
            n: in_lesson_languages(unit_of_name(n).told)
            for n in values_of_frames([*frames, *more.values()])
            if unit_of_name(n).told()
        },
        **_tape_data(lesson, progress, practice),
        **({} if practice else {"pending": True}),
    }


def practice_data(scene: Scene) -> Json:
    """What a lesson lacks without its practice: the mistakes, and the tape with their places."""
    lesson = SceneLesson.of(scene)
    return {**_tape_data(lesson), "lettering": scene_lettering(scene, lesson.plans), "pending": False}


def _frame_data(frame: Frame, kit: Kit) -> Json:
    tells = [name for how, name in frame.numbers if how in ("v", "a")]
    own = {k: z for k, z in vars(frame).items() if k not in ("marked", "numbers", "said")}
    own |= {"said": frame.marked, "rows": [row.json() for row in frame.rows]}
    return {**own, "values": revealed_values(frame), "tells": tells, "tools": kit.tools_for_frame(frame)}


def _tape_data(lesson: SceneLesson, progress: Progress | None = None, practice: bool = True) -> Json:
    """The tape, and the places on it of all that a page shows; with the practice."""
    live = Live(lesson, progress, practice)
    plans = lesson.plans
    tape, places = live.tape_and_places(live.things)
    lettered = {n for n, m in plans.means.items() if m.quantity == "false"}
    places["slips"] = [{**slip, "place": places["slips"][str(k)]} for k, slip in enumerate(live.slips)]
    return {
        **places,
        "judging": JUDGING_TOLERANCES,
        "practice": lesson.practice.practice_items() if practice else [],
        "lines": lesson.practice.named_directions(),
        "mistakes": mistake_sentences(live.slips) if practice else {},
        "id": lesson.practice.practice_id,
        "tape": tape,
        "holds": [{"at": places["holds"][str(k)], "said": said} for k, said in enumerate(live.fails)],
        "blunt": {n: _blunt_crossing_warning(n) for n in live.sharp},
        "helpers": [*(n for n in places["marks"] if n in plans.auxiliary_marks - lettered), *live.feet],
    }


def _blunt_crossing_warning(mark: str) -> dict[Lang, str]:
    plan = plan_phrase(plan_of(mark) or SCHEME_PLAN)
    return sentence_in_lesson_languages(
        "lesson_zone_blunt", mark=name_without_plan(mark), plan=plan, angle=value_slot(mark, "d")
    )


def _plan_data(plans: Plans, plan: PlanId, convention: Convention) -> Json:
    """A plan with its scale, its title and the letters of the scheme's fixed points, which are at its pole."""
    primes = {"velocity": [""], "acceleration": ["'"]}.get(plan, [])
    return {
        "key": plan,
        "links": [x for x in plan.links if x in plans.mechanism.links or plans.has_mechanism] * (plan.is_force),
        "mu": in_lesson_languages(partial(plan_scale_text, plan, convention=convention)),
        "title": in_lesson_languages(partial(plan_title, plan)),
        "fixed": [p.lower() + prime for prime in primes for p in frame_hinges(plans.mechanism)],
    }


def _vector_segments(plans: Plans, drawing: Drawing) -> list[dict[str, str]]:
    """Each vector of the plans once, by its ends, with all its names and its pen: results are thick; ``sum`` marks a
    force that is not a term."""
    segments: dict[NamePair, Json] = {}
    every = [(e, t) for e in plans.equations for t in e.all_terms]
    named = {t.name: displayed_term_name(e, t.name) for e, t in every}
    terms = {(e.plan, *sorted((t.start, t.end))) for e, t in every}
    rays = plans.figure.poles if plans.figure else ()
    for s in plans.segments:
        start, end = s.ends
        shown = s.plan not in ("position", "motion") and start not in rays
        if start != end and shown and end in drawing:
            force = s.plan.kind not in MOTION
            name = named.get(s.name, s.name)
            from_pole = s.start == POLE_LABEL and end not in drawing.program.component_end_marks
            new: Json = {"plan": s.plan, "start": s.start, "end": s.end, "names": []}
            if force and (s.plan, *sorted((s.start, s.end))) not in terms:
                new["sum"] = True
            one = segments.setdefault(s.ends, new)
            one["names"] += [name] * (name not in one["names"])
            result = any("^" not in n for n in one["names"]) if force else from_pole
            one["pen"] = "result" if result else "part"
    return list(segments.values())


def _lines_and_arcs_of_marks(drawing: Drawing) -> Json:
    """For each crossed mark, the marks on its lines, or the centres of its arcs."""
    traces: Json = {}
    for step in drawing.program.steps:
        name = step.makes
        if isinstance(step, Choose):
            step = drawing.program.steps_by_result[step.trials[0].mark]
        match step:
            case Cross():
                traces[name] = {"lines": [step.start, step.other]}
            case CrossArc():
                traces[name] = {"lines": [step.start], "arcs": [step.centre]}
            case TrackStep():
                own = [h for h in step.holds if h.local == step.local]
                traces[name] = {"arcs" if h.kind == "arc" else "lines": [h.place] for h in own}
            case CrossArcs():
                traces[name] = {"arcs": [step.centre, step.other]}
    return traces
