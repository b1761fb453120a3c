"""All a lesson page shows, as one plain object: frames, equations, and every mark over the whole turn of the crank.

The page draws lines between these marks and reckons nothing: what it shows at any position is a position drawn here.
"""

import math
from collections.abc import Callable, Mapping
from functools import partial
from itertools import groupby

import numpy

from planes.drafting.drawing import Drawing, run
from planes.drafting.equations import Equation, Term
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Choose
from planes.geometry.arrays import Array, Booleans, Floats
from planes.lesson import Teller, mu_said, value_of
from planes.lesson.formulas import unit
from planes.lesson.frame import in_both, needed
from planes.lesson.practice import Practice, told_values
from planes.lesson.scheme import arms, feet, pivots, related, scheme
from planes.lesson.steps import whole
from planes.plans import Plans
from planes.plans.measuring import BLUNT, formula_of, lettering, say_plan
from planes.plans.scales import fits_on, scales
from planes.scene import Scene
from planes.solving import failed, plans_of
from planes.words import Lang, Phrase, decimal, say
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.names import at, lettered, mu_of, plan_of
from planes.words.records import Json
from planes.words.units import Convention

POSITIONS = 360
Progress = Callable[[int, int], None]


def lesson_data(scene: Scene, progress: Progress | None = None) -> Json:
    """The lesson of a scene. :class:`SceneError` where there is no mechanism or its own position fails."""
    plans, _ = plans_of(scene, shown=True)
    try:
        mus = scales(plans, scene.mu, fit_mm=fits_on(scene.sheet, plans))
        given = {**plans.given, **mus}
        drawing = run(plans.program, given)
    except PlanFailure as failure:
        raise SceneError(Phrase("lesson_fails", failure=failure.phrase), scene.file, 1) from None
    values, index = _values(plans)
    try:
        moved, held = plans.at(numpy.array(values)), []
    except SceneError as law:  # a number that holds where the drive stands in the file alone
        values, index, held = [plans.mechanism.drive.position], 0, [zone(0, 0, "blunt", PlanesError(law.phrase).told)]
        moved = plans.at(numpy.array(values))
    cycle = run(plans.program, {**given, **moved})
    teller = Teller(plans, drawing, mus, cycle, scene.mu_convention)
    frames = teller.frames()
    names = needed(frames)
    return {
        "title": dict(scene.title),
        "formula": formula_of(plans.structure, scene.frame_number).replace("->", "→"),
        "lettering": lettering(scene, plans),
        "drive": {"symbol": "φ" if plans.mechanism.drive.kind == "phi" else "s", "values": values, "at": index},
        "mus": mus,
        "plans": [_plan(plans, p, mus, scene.mu_convention) for p in plans.drawn if p != "motion"],
        "segments": _segments(plans, drawing),
        "traces": _traces(drawing),
        "scheme": scheme(plans, cycle),
        "moments": arms(plans),
        "related": related(plans),
        "equations": [_equation(plans, e) for e in plans.equations],
        "frames": [{**vars(f), "values": told_values(f)} for f in frames],
        "results": (results := _results(plans)),
        "values": _columns({n: value_of(n, teller, cycle) for n in (*names, *(r["value"] for r in results))}, values),
        "units": {n: in_both(partial(unit, n)) for n in names if unit(n, "en")},
        "practice": Practice(plans, given, drawing, frames).tasks(progress),
        **_turn(plans, cycle, len(values)),
        "zones": held + zones(plans, cycle, len(values)),
        "failed": reasons(plans, given, values, cycle, progress),
    }


def _values(plans: Plans) -> tuple[list[float], int]:
    """The values of the drive the page can show, the scene's own among them."""
    drive = plans.mechanism.drive
    if drive.kind == "phi":
        start = drive.position % 1.0
        values = [start + i for i in range(POSITIONS)]
        return values, int(drive.position - start) % POSITIONS
    half = POSITIONS // 2
    return [drive.position + plans.reach * (i - half) / half for i in range(POSITIONS + 1)], half


def _plan(plans: Plans, plan: str, mus: Mapping[str, float], convention: Convention) -> Json:
    """A plan with its scale, its title and the letters of the fixed points of the scheme that stand in its pole."""
    prime = {"velocity": "", "acceleration": "'"}.get(plan)
    fixed = [] if prime is None else [p.lower() + prime for p in pivots(plans.mechanism)]
    return {
        "key": plan,
        "mu": in_both(partial(mu_said, mus[mu_of(plan)], plan, convention=convention)),
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
            case CrossArcs():
                found[name] = {"arcs": [step.centre, step.other]}
    return found


def _equation(plans: Plans, e: Equation) -> Json:
    """An equation as it is written: without the vectors that are nothing, a vector along the frame's guide itself."""
    total: Json | None = {"name": e.total, "action": "", "known": 0} if e.total else None
    sides = []
    for chain in e.chains:
        alone = [t for t in chain if total and whole(e, t.name) == e.total and t.name != e.total]
        if alone and total:
            total.update(action=_acted(plans, alone[0]), known=alone[0].known)
        elif chain:
            sides.append([_term(plans, e.plan, t) for t in chain])
    return {"plan": e.plan, "total": total, "sides": sides}


def _term(plans: Plans, plan: str, t: Term) -> Json:
    start, end = (at(plan, label) for label in ((t.start, t.end) if t.sign > 0 else (t.end, t.start)))
    own = {"name": t.name, "start": start, "end": end, "at": at(plan, t.end)}
    return {**own, "action": _acted(plans, t), "known": t.known}


def _acted(plans: Plans, t: Term) -> str:
    """The line of action beneath a term."""
    return plans.means[t.direction].action if t.direction else t.action


def _results(plans: Plans) -> list[Json]:
    """Rates and balancing loads shown beneath the plans at every position."""
    rates = [*(link.omega for link in plans.links.values()), *(link.epsilon for link in plans.links.values())]
    names = [n for n in dict.fromkeys([*rates, plans.balancing, plans.zhukovsky]) if n in plans.program.made]
    return [{"name": n, "value": n, "unit": in_both(partial(unit, n))} for n in names]


def _columns(things: Mapping[str, Floats], values: list[float]) -> Json:
    """Values over the turn to ten digits; one number where it never changes."""
    found: Json = {}
    for name, thing in things.items():
        full = numpy.broadcast_to(thing, (len(values),)).astype(float)
        good = full[numpy.isfinite(full)]
        if len(good) and (numpy.ndim(thing) == 0 or numpy.all(good == good[0])):
            found[name] = float(good[0])
        else:
            found[name] = [None if not numpy.isfinite(v) else float(f"{v:.10g}") + 0.0 for v in full]
    return found


def _turn(plans: Plans, cycle: Drawing, count: int) -> Json:
    """Marks (mm) and directions (degrees) over the turn."""

    def column(thing: Floats) -> list[float | None]:
        full = numpy.broadcast_to(thing, (count,))
        return [None if not numpy.isfinite(v) else round(float(v), 2) + 0.0 for v in full]

    m = plans.mechanism
    made = (s.makes for s in cycle.program.steps if s.kind == "mark" and s.makes not in cycle.program.trials)
    own = feet(plans, cycle)
    marks = {name: cycle[name] for name in made if plan_of(name) != "motion"} | own
    # directions of guides, and of the forces in moment equations
    directions = [f"∥{g}" for link in (m.frame, *m.links.values()) for g in link.guides]
    directions += [f["along"] for moment in arms(plans) for f in moment["forces"]]
    angles = {d: numpy.degrees(numpy.angle(cycle[d])) for d in dict.fromkeys(directions) if d in cycle}
    return {
        "marks": {n: [column(numpy.real(z)), column(numpy.imag(z))] for n, z in marks.items()},
        "helpers": [*(n for n in marks if n in plans.helpers), *own],
        "turned": {n: column(a) for n, a in angles.items()},
    }


def zones(plans: Plans, cycle: Drawing, count: int) -> list[Json]:
    """Stretches of positions that fail ("bad") or where lines meet at under 15° ("blunt"), with the reason."""
    names = [n for n in cycle.sharpness if n not in cycle.program.trials and plan_of(n) != "motion"]
    rows = [numpy.broadcast_to(cycle.sharpness[n], (count,)) for n in names]
    table: Array = numpy.nan_to_num(numpy.array(rows), nan=1.0) if rows else numpy.ones((1, count))
    least, worst = table.min(axis=0), table.argmin(axis=0)
    bad: Booleans = numpy.broadcast_to(cycle.failed(), (count,))
    marks = ["" if b else names[w] if s < BLUNT else None for b, w, s in zip(bad, worst, least, strict=True)]
    found, start = [], 0
    for mark, same in groupby(marks):
        first, start = start, start + len(list(same))
        if mark == "":
            found.append(zone(first, start - 1, "bad", partial(say, "lesson_zone_bad")))
        elif mark:
            found.append(zone(first, start - 1, "blunt", partial(_blunt, mark, least[first:start].min())))
    return found


def zone(first: int, last: int, kind: str, told: Callable[[Lang], str]) -> Json:
    """A stretch of positions, and what is said of it."""
    return {"from": first, "to": last, "kind": kind, "said": in_both(told)}


def _blunt(mark: str, least: float, lang: Lang) -> str:
    named = {"mark": lettered(mark), "plan": say_plan(plan_of(mark) or "position", lang)}
    return say("lesson_zone_blunt", lang, **named, angle=decimal(f"{math.degrees(math.asin(least)):.2g}", lang))


def reasons(
    plans: Plans, given: Json, values: list[float], cycle: Drawing, progress: Progress | None = None
) -> dict[str, dict[Lang, str]]:
    """Why each failed position fails, in both languages."""
    indices = numpy.flatnonzero(numpy.broadcast_to(cycle.failed(), (len(values),))).tolist()
    found = {}
    for k, index in enumerate(indices):
        if progress:
            progress(k + 1, len(indices))
        try:
            run(plans.program, {**given, plans.drive_given: values[index]})
        except PlanFailure as failure:
            found[str(index)] = in_both(failed(failure, values[index], plans.mechanism.drive.kind).told)
    return found
