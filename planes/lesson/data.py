"""All a lesson page shows, as one plain object: frames, equations, and the program itself as a tape.

The page runs the tape for whatever position and numbers are asked, and draws lines between the marks it gives.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cached_property, partial

import numpy

from planes.drafting.drawing import Drawing, run
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Choose
from planes.drafting.steps.tracks import CutTrack
from planes.drafting.tools import Thing
from planes.lesson import Teller, value_of
from planes.lesson.formulas import mu_said, slot, unit
from planes.lesson.frame import Frame, in_both, needed
from planes.lesson.kit import Kit
from planes.lesson.live import Knobs, Live
from planes.lesson.practice import JUDGING, Practice, sentences, told_values
from planes.lesson.scheme import acting, arms, feet, pivots, related, scheme
from planes.lesson.steps import whole
from planes.lesson.written import equation_written
from planes.plans import Plans
from planes.plans.measuring import lettering, say_plan
from planes.plans.scales import fits_on, scales
from planes.scene import Scene
from planes.solving import plans_of
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.names import at, kind_of, lettered, links_of, mu_of, plan_of
from planes.words.records import Json
from planes.words.units import Convention

TRIED = 360  # positions, by which it is told which terms are nothing
Progress = Callable[[int, int], None]


@dataclass(frozen=True)
class Told:
    """A scene drawn in its own position, and the frames of its lesson."""

    scene: Scene
    plans: Plans
    given: Mapping[str, Thing]
    drawing: Drawing
    knobs: Knobs
    teller: Teller
    frames: list[Frame]

    @classmethod
    def of(cls, scene: Scene) -> Told:
        """:class:`SceneError` where there is no mechanism or its own position fails."""
        plans, _ = plans_of(scene, shown=True)
        try:
            mus = scales(plans, scene.mu, fit_mm=fits_on(scene.sheet, plans))
            given = {**plans.given, **plans.at(plans.mechanism.drive.position), **mus}
            drawing = run(plans.program, given)
        except PlanFailure as failure:
            raise SceneError(Phrase("lesson_fails", failure=failure.phrase), scene.file, 1) from None
        drive, knobs = drive_of(plans), Knobs(plans, given)
        values = numpy.linspace(drive["from"], drive["to"], TRIED, endpoint=False)
        cycle = run(plans.program, {**given, **knobs.shaken(TRIED), plans.drive_given: values})
        teller = Teller(plans, drawing, cycle, scene.mu_convention)
        return cls(scene, plans, given, drawing, knobs, teller, teller.frames())

    @cached_property
    def equations(self) -> list[Json]:
        """The vector equations as they are written."""
        return [equation_written(self.plans, e) for e in self.plans.equations]

    @cached_property
    def drive(self) -> Json:
        """The driver's number, and from where to where it runs."""
        return drive_of(self.plans)

    @cached_property
    def practice(self) -> Practice:
        """What a reader is asked."""
        values = {n: float(value_of(n, self.teller, self.drawing)) for n in needed(self.frames)}
        return Practice(self.plans, self.given, self.drawing, self.frames, self.equations, values, self.teller.spans)


def lesson_data(scene: Scene, progress: Progress | None = None) -> Json:
    """The lesson of a scene; ``progress`` hears how far the catalogue of mistakes is drawn. Errors as :class:`Told`."""
    told = Told.of(scene)
    plans, drawing, knobs, frames = told.plans, told.drawing, told.knobs, told.frames
    kit = Kit(plans, drawing)
    return {
        "title": dict(scene.title),
        "moves": plans.moves,
        "formula": plans.structure.formula_as(scene.frame_number).replace("->", "→") if plans.moves else "",
        "lettering": lettering(scene, plans),
        "drive": drive_of(plans),
        "home": knobs.home(),
        "knobs": knobs.all(),
        "drags": knobs.drags(),
        "plans": [_plan(plans, p, scene.mu_convention) for p in plans.drawn if p != "motion"],
        "segments": _segments(plans, drawing),
        "traces": _traces(drawing),
        "scheme": scheme(plans, drawing),
        "moments": arms(plans),
        "related": related(plans),
        "acts": {n: m for n, m in acting(plans).items() if n in {s.name for s in plans.segments}},
        "under": {at("position", u.point): u.other for u in told.teller.stating.under.values()},
        "equations": told.equations,
        "frames": [{**vars(f), "values": told_values(f), "tools": kit.of_frame(f)} for f in frames],
        "results": (results := _results(plans)),
        "units": {n: in_both(partial(unit, n)) for n in needed(frames) if unit(n, "en")},
        **_live(told, [r["value"] for r in results], progress),
    }


def drive_of(plans: Plans) -> Json:
    """The driver's number, and from where to where it runs: nowhere, where a law holds in its own position alone."""
    drive = plans.mechanism.drive
    turns = drive.kind == "phi"
    reach, start = (0.0, drive.position % 1.0) if turns else (plans.reach, drive.position)
    told: Json = {"symbol": "φ" if turns else "s", "given": plans.drive_given, "at": drive.position, "held": None}
    if not plans.moves:
        return {**told, "from": drive.position, "to": drive.position}
    try:
        plans.at(drive.position + numpy.ones(1))
    except SceneError as law:  # a number that holds where the drive stands in the file alone
        return {**told, "from": drive.position, "to": drive.position, "held": in_both(PlanesError(law.phrase).told)}
    return {**told, "from": start - reach, "to": start + (reach or 360.0)}


def _live(told: Told, results: list[str], progress: Progress | None) -> Json:
    """The tape, and where on it every mark, direction, value, sharpness and mistake stands; with what is practised."""
    plans, frames = told.plans, told.frames
    live = Live(plans.program, told.given)
    drawn, own = live.drawing, feet(plans, live.drawing)
    made = (s.makes for s in plans.program.steps if s.kind == "mark" and s.makes not in plans.program.trials)
    marks = {name: drawn[name] for name in made if plan_of(name) != "motion"} | own
    fails = live.failures(plans.drive_given, "φ" if plans.mechanism.drive.kind == "phi" else "s")
    # directions of guides, and of the forces in moment equations
    ways = [f"∥{g}" for link in (plans.mechanism.frame, *plans.mechanism.links.values()) for g in link.guides]
    ways += [f["along"] for moment in arms(plans) for f in moment["forces"]]
    sharp = {n: z for n, z in drawn.sharpness.items() if n not in plans.program.trials and plan_of(n) != "motion"}
    names = dict.fromkeys([*needed(frames), *results, *map(mu_of, plans.drawn), plans.drive_given])
    slips, wrong = told.practice.slips(live, progress)
    lines = told.practice.lines()
    tape, places = live.exported(
        {
            "marks": marks,
            "turned": {d: drawn[d] for d in dict.fromkeys([*ways, *lines]) if d in drawn},
            "values": {
                **{n: value_of(n, told.teller, drawn) for n in names},
                **live.numbers,
                **told.practice.senses(drawn),
            },
            "sharp": sharp,
            "holds": {str(k): ok for k, (ok, _) in enumerate(fails)},
            "slips": wrong,
        }
    )
    holds = [{"at": places["holds"][str(k)], "said": said} for k, (_, said) in enumerate(fails)]
    blunt = {n: in_both(partial(_blunt, n)) for n in sharp}
    lettered = {n for n, m in plans.means.items() if m.quantity == "false"}
    helpers = [*(n for n in marks if n in plans.helpers - lettered), *own]
    places["slips"] = [{**slip, "place": places["slips"][str(k)]} for k, slip in enumerate(slips)]
    asked: Json = {
        "judging": JUDGING,
        "practice": told.practice.items(),
        "lines": lines,
        "mistakes": sentences(slips),
        "id": told.practice.id,
    }
    return {**places, **asked, "tape": tape, "holds": holds, "blunt": blunt, "helpers": helpers}


def _blunt(mark: str, lang: Lang) -> str:
    named = {"mark": lettered(mark), "plan": say_plan(plan_of(mark) or "position", lang)}
    return say("lesson_zone_blunt", lang, **named, angle=slot(mark, "d"))


def _plan(plans: Plans, plan: str, convention: Convention) -> Json:
    """A plan with its scale, its title and the letters of the fixed points of the scheme that stand in its pole."""
    prime = {"velocity": "", "acceleration": "'"}.get(plan)
    fixed = [] if prime is None else [p.lower() + prime for p in pivots(plans.mechanism)]
    return {
        "key": plan,
        "links": list(links_of(plan)) if kind_of(plan) == "force" else [],
        "mu": in_both(partial(mu_said, plan, convention=convention)),
        "title": in_both(lambda lang: (told := say_plan(plan, lang))[:1].upper() + told[1:]),
        "fixed": fixed,
    }


def _segments(plans: Plans, drawing: Drawing) -> list[dict[str, str]]:
    """Each vector of the plans once, by its ends, with every name it goes by."""
    found: dict[tuple[str, str, str], Json] = {}
    named = {t.name: whole(e, t.name) for e in plans.equations for t in e.terms}
    for s in plans.segments:
        if s.start != s.end and s.plan not in ("position", "motion") and at(s.plan, s.end) in drawing:
            new: Json = {"plan": s.plan, "start": s.start, "end": s.end, "names": []}
            new["corner"] = at(s.plan, s.end) in drawing.program.corners
            names = found.setdefault((s.plan, s.start, s.end), new)["names"]
            name = named.get(s.name, s.name)
            names += [name] * (name not in names)
    return list(found.values())


def _traces(drawing: Drawing) -> Json:
    """For each crossed mark, the marks its lines come through, or its arcs are drawn about."""
    found: Json = {}
    steps = drawing.program.makers
    for step in drawing.program.steps:
        name = step.makes
        if isinstance(step, Choose):
            step = steps[step.trials[0].mark]
        match step:
            case Cross():
                found[name] = {"lines": [step.start, step.other]}
            case CrossArc():
                found[name] = {"lines": [step.start], "arcs": [step.centre]}
            case CutTrack():
                own = [h for h in step.holds if h.local == step.local]
                found[name] = {"arcs" if h.kind == "arc" else "lines": [h.place] for h in own}
            case CrossArcs():
                found[name] = {"arcs": [step.centre, step.other]}
    return found


def _results(plans: Plans) -> list[Json]:
    """Rates and balancing loads shown beneath the plans at every position."""
    rates = [*(link.omega for link in plans.links.values()), *(link.epsilon for link in plans.links.values())]
    names = [n for n in dict.fromkeys([*rates, plans.balancing, plans.zhukovsky]) if n in plans.program.made]
    return [{"name": n, "value": n, "unit": in_both(partial(unit, n))} for n in names]
