"""The data of a lesson page as one plain object: frames, equations, and the program itself as a tape.

The page runs the tape for any position and numbers, and draws lines between the resulting marks.
"""

from functools import partial

from planes.drafting.drawing import Drawing
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Choose
from planes.drafting.steps.tracks import CutTrack
from planes.lesson.centres import NOTED, lines_of
from planes.lesson.formulas import in_both, mu_said, slot, spoken, unit
from planes.lesson.frame import Frame, needed
from planes.lesson.kit import Kit
from planes.lesson.live import Live, results
from planes.lesson.practice import JUDGING, Progress, sentences, told_values
from planes.lesson.rows import templates
from planes.lesson.scheme import acting, arms, pivots, related, scheme
from planes.lesson.steps import whole
from planes.lesson.told import Told
from planes.plans import Plans
from planes.plans.measuring import lettering, title_of
from planes.scene import Scene
from planes.words import Lang
from planes.words.lettering import plan_phrase
from planes.words.names import POLE, kind_of, lettered, links_of, plan_of
from planes.words.records import Json
from planes.words.units import Convention

MOTION = ("velocity", "acceleration", "lever")
"""The plans that are not of forces."""


def lesson_data(scene: Scene, progress: Progress | None = None, centres: bool = False, practice: bool = True) -> Json:
    """The lesson of a scene, with its instantaneous ``centres`` if requested; ``progress`` is called while the
    catalogue of mistakes is drawn. Without its ``practice`` it is ``pending``. Errors as for :class:`Told`."""
    lesson = Told.of(scene, centres)
    plans, drawing, knobs, frames = lesson.plans, lesson.drawing, lesson.knobs, lesson.frames
    kit, more, under = Kit(plans, drawing), lesson.leaning or {}, lesson.teller.stating.under.values()
    acts, vectors = acting(plans), {s.name for s in plans.segments}
    return {
        "title": dict(scene.title),
        "moves": plans.moves,
        "formula": plans.structure.formula_as(scene.frame_number).replace("->", "→") if plans.moves else "",
        "lettering": lettering(scene, plans),
        "drive": lesson.drive,
        "home": knobs.home,
        "knobs": [k for k in knobs.all if lesson.leaning is not None or "stays" not in k],
        "drags": knobs.drags(),
        "plans": [_plan(plans, p, scene.mu_convention) for p in plans.drawn if p != "motion"],
        "segments": _segments(plans, drawing),
        "traces": _traces(drawing),
        "scheme": scheme(plans, drawing),
        "moments": arms(plans),
        "bodies": lesson.teller.bodies.drawn,
        "related": related(plans, {u.other: u.link for u in under}),
        "acts": {n: m for n, m in acts.items() if n in vectors},
        "under": lesson.under(),
        "equations": lesson.equations,
        "centres": lines_of(plans),
        "noted": {k: spoken(f"lesson_centre_{k}", name="{name}") for k in NOTED * bool(plans.centres)},
        "frames": (shown := [_shown(f, kit) for f in frames]),
        "leaning": {k: {n: z for n, z in _shown(f, kit).items() if z != shown[k][n]} for k, f in more.items()},
        "reckoned": templates(row for f in [*frames, *more.values()] for row in f.rows),
        "results": [{"name": n, "value": n, "unit": in_both(unit(n).told)} for n in results(plans)],
        "units": {n: in_both(unit(n).told) for n in needed([*frames, *more.values()]) if unit(n).told()},
        **_live(lesson, progress, practice),
        **({} if practice else {"pending": True}),
    }


def practice_data(scene: Scene) -> Json:
    """What a lesson lacks without its practice: the mistakes, and the tape with their places."""
    lesson = Told.of(scene)
    return {**_live(lesson), "lettering": lettering(scene, lesson.plans), "pending": False}


def _shown(frame: Frame, kit: Kit) -> Json:
    tells = [name for how, name in frame.numbers if how in ("v", "a")]
    own = {k: z for k, z in vars(frame).items() if k not in ("marked", "numbers", "said")}
    own |= {"said": frame.marked, "rows": [row.json() for row in frame.rows]}
    return {**own, "values": told_values(frame), "tells": tells, "tools": kit.of_frame(frame)}


def _live(lesson: Told, progress: Progress | None = None, practice: bool = True) -> Json:
    """The tape, and the places on it of all that a page shows; with the practice."""
    live, plans = Live(lesson, progress, practice), lesson.plans
    tape, places = live.exported(live.things)
    lettered = {n for n, m in plans.means.items() if m.quantity == "false"}
    places["slips"] = [{**slip, "place": places["slips"][str(k)]} for k, slip in enumerate(live.slips)]
    return {
        **places,
        "judging": JUDGING,
        "practice": lesson.practice.items() if practice else [],
        "lines": lesson.practice.lines(),
        "mistakes": sentences(live.slips) if practice else {},
        "id": lesson.practice.id,
        "tape": tape,
        "holds": [{"at": places["holds"][str(k)], "said": said} for k, said in enumerate(live.fails)],
        "blunt": {n: _blunt(n) for n in live.sharp},
        "helpers": [*(n for n in places["marks"] if n in plans.helpers - lettered), *live.feet],
    }


def _blunt(mark: str) -> dict[Lang, str]:
    plan = plan_phrase(plan_of(mark) or "position")
    return spoken("lesson_zone_blunt", mark=lettered(mark), plan=plan, angle=slot(mark, "d"))


def _plan(plans: Plans, plan: str, convention: Convention) -> Json:
    """A plan with its scale, its title and the letters of the scheme's fixed points, which are at its pole."""
    primes = {"velocity": [""], "acceleration": ["'"]}.get(plan, [])
    return {
        "key": plan,
        "links": [x for x in links_of(plan) if x in plans.mechanism.links or plans.moves] * (kind_of(plan) == "force"),
        "mu": in_both(partial(mu_said, plan, convention=convention)),
        "title": in_both(partial(title_of, plan)),
        "fixed": [p.lower() + prime for prime in primes for p in pivots(plans.mechanism)],
    }


def _segments(plans: Plans, drawing: Drawing) -> list[dict[str, str]]:
    """Each vector of the plans once, by its ends, with all its names and its pen: results are thick; ``sum`` marks a
    force that is not a term."""
    segments: dict[tuple[str, str], Json] = {}
    every = [(e, t) for e in plans.equations for t in e.terms]
    named = {t.name: whole(e, t.name) for e, t in every}
    terms = {(e.plan, *sorted((t.start, t.end))) for e, t in every}
    rays = plans.figure.poles if plans.figure else ()
    for s in plans.segments:
        start, end = s.ends
        shown = s.plan not in ("position", "motion") and start not in rays
        if start != end and shown and end in drawing:
            force, name = kind_of(s.plan) not in MOTION, named.get(s.name, s.name)
            from_pole = s.start == POLE and end not in drawing.program.corners
            new: Json = {"plan": s.plan, "start": s.start, "end": s.end, "names": []}
            if force and (s.plan, *sorted((s.start, s.end))) not in terms:
                new["sum"] = True
            one = segments.setdefault(s.ends, new)
            one["names"] += [name] * (name not in one["names"])
            result = any("^" not in n for n in one["names"]) if force else from_pole
            one["pen"] = "result" if result else "part"
    return list(segments.values())


def _traces(drawing: Drawing) -> Json:
    """For each crossed mark, the marks on its lines, or the centres of its arcs."""
    traces: Json = {}
    for step in drawing.program.steps:
        name = step.makes
        if isinstance(step, Choose):
            step = drawing.program.makers[step.trials[0].mark]
        match step:
            case Cross():
                traces[name] = {"lines": [step.start, step.other]}
            case CrossArc():
                traces[name] = {"lines": [step.start], "arcs": [step.centre]}
            case CutTrack():
                own = [h for h in step.holds if h.local == step.local]
                traces[name] = {"arcs" if h.kind == "arc" else "lines": [h.place] for h in own}
            case CrossArcs():
                traces[name] = {"arcs": [step.centre, step.other]}
    return traces
