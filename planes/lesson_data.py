"""All a lesson page shows, as one plain object: frames, equations, and every mark over the whole turn of the crank.

The page draws lines between these marks and reckons nothing: what it shows at any position is a position drawn here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from planes.drafting import at, mu_of
from planes.drawing import Drawing, run
from planes.equations import Equation, Term
from planes.lesson import Teller
from planes.measuring import say_plan
from planes.mechanism import FRAME
from planes.plans import Plans, state
from planes.scales import kind_of, scales
from planes.scene import Scene
from planes.solving import failed
from planes.steps import Cross, CrossArc, CrossArcs
from planes.units import mu_text
from planes.wording import PlanFailure, SceneError
from planes.words import Lang, Phrase

POSITIONS = 360
LANGS: tuple[Lang, ...] = ("ru", "en")


def lesson_data(scene: Scene) -> dict[str, Any]:
    """The lesson of a scene. :class:`SceneError` where there is no mechanism or its own position fails."""
    if scene.mechanism is None:
        raise SceneError(Phrase("vectors_alone"), scene.file, scene.where.get(("vectors",), 1))
    plans = state(scene.mechanism, scene.file)
    try:
        mus = scales(plans, scene.mu)
        drawing = run(plans.program, {**plans.given, **mus})
    except PlanFailure as failure:
        raise SceneError(Phrase("lesson_fails", failure=failure.phrase), scene.file, plans.mechanism.where.get(("drive",), 1)) from None
    values, index = _values(plans)
    return {
        "title": dict(scene.title),
        "formula": plans.structure.formula,
        "drive": {"symbol": "φ" if plans.mechanism.drive.kind == "phi" else "s", "values": values, "at": index},
        "plans": [_plan(p, mus) for p in plans.drawn if p != "motion"],
        "segments": _segments(plans, drawing),
        "traces": _traces(drawing),
        "scheme": _scheme(plans),
        "equations": [_equation(e) for e in plans.equations],
        "frames": [_frame(f) for f in Teller(plans, drawing, mus).frames()],
        **_turn(plans, mus, values),
    }


def _values(plans: Plans) -> tuple[list[float], int]:
    """The values of the drive the page can show, the scene's own among them."""
    drive = plans.mechanism.drive
    if drive.kind == "phi":
        start = drive.position % 1.0
        values = [start + i for i in range(POSITIONS)]
        return values, int(drive.position - start) % POSITIONS
    reach = max((abs(v) for k, v in plans.given.items() if k.startswith("l_")), default=1.0)
    half = POSITIONS // 2
    return [drive.position + reach * (i - half) / half for i in range(POSITIONS + 1)], half


def _plan(plan: str, mus: Mapping[str, float]) -> dict[str, Any]:
    kind = "velocity" if plan == "lever" else kind_of(plan)
    mu = {lang: mu_text(mus[mu_of(plan)], kind, lang) for lang in LANGS}
    return {"key": plan, "mu": mu, "title": {lang: say_plan(plan, lang) for lang in LANGS}}


def _segments(plans: Plans, drawing: Drawing) -> list[dict[str, str]]:
    found: dict[tuple[str, str, str], dict[str, str]] = {}
    for s in plans.segments:
        if s.start != s.end and s.plan not in ("position", "motion") and at(s.plan, s.end) in drawing:
            found.setdefault((s.plan, s.start, s.end), {"plan": s.plan, "start": s.start, "end": s.end, "name": s.name})
    return list(found.values())


def _traces(drawing: Drawing) -> dict[str, Any]:
    """For each crossed mark, the marks its lines come through, or its arcs are drawn about."""
    found: dict[str, Any] = {}
    for step in drawing.program.steps:
        match step:
            case Cross():
                found[step.makes] = {"lines": [step.start, step.other]}
            case CrossArc():
                found[step.makes] = {"lines": [step.start], "arcs": [step.centre]}
            case CrossArcs():
                found[step.makes] = {"arcs": [step.centre, step.other]}
    return found


def _scheme(plans: Plans) -> dict[str, Any]:
    """What the scheme is drawn from: links by their points, guides by a mark and a direction, sliders."""
    m = plans.mechanism
    links = [
        {
            "name": x.name,
            "points": [at("position", p) for p in x.points],
            "slides": x.slides.guide if x.slides else None,
        }
        for x in m.links.values()
    ]
    guides = [
        {"name": g.name, "link": link.name, "mark": at("position", g.through_point or f"°{g.name}")}
        for link in (m.frame, *m.links.values())
        for g in link.guides.values()
    ]
    pivots = [at("position", p) for p in m.frame.points if any(p in x.points for x in m.links.values())]
    return {"links": links, "guides": guides, "pivots": pivots, "driver": m.drive.link, "frame": FRAME}


def _equation(e: Equation) -> dict[str, Any]:
    chains = [[_term(e.plan, t) for t in chain] for chain in e.chains]
    return {"plan": e.plan, "total": e.total, "chains": chains}


def _term(plan: str, t: Term) -> dict[str, Any]:
    return {"name": t.name, "end": at(plan, t.end), "action": t.action.replace("⊥∥", "⊥"), "known": t.known}


def _frame(frame: Any) -> dict[str, Any]:
    return {
        "plan": frame.plan, "makes": frame.makes, "uses": frame.uses, "equation": frame.equation,
        "terms": frame.terms, "said": dict(frame.said),
    }  # fmt: skip


def _turn(plans: Plans, mus: Mapping[str, float], values: list[float]) -> dict[str, Any]:
    """Marks (mm), directions of guides (degrees), rates and sharpness over the turn; why positions fail."""
    import numpy

    drawing = run(plans.program, {**plans.given, **mus, plans.drive_given: numpy.array(values)})
    bad = drawing.failed()
    count = len(values)

    def column(thing: Any, digits: int) -> list[float | None]:
        full = numpy.broadcast_to(thing, (count,))
        return [None if not numpy.isfinite(v) else round(float(v), digits) + 0.0 for v in full]

    marks, rates = {}, {}
    for step in drawing.program.steps:
        thing = drawing[step.makes]
        if step.kind == "mark" and step.makes not in drawing.program.trials:
            marks[step.makes] = [column(numpy.real(thing), 2), column(numpy.imag(thing), 2)]
        elif step.kind == "value" and step.makes.startswith(("omega", "epsilon")):
            rates[step.makes] = column(thing, 4)
    for name in (plans.balancing, plans.zhukovsky):
        rates[name] = column(drawing[name], 4)
    turned = {g: column(numpy.degrees(numpy.angle(drawing[f"∥{g}"])), 2) for g in _guides(plans) if f"∥{g}" in drawing}
    sharp = numpy.ones(count)
    for value in drawing.sharpness.values():
        sharp = numpy.fmin(sharp, numpy.broadcast_to(value, (count,)))
    return {
        "marks": marks, "rates": rates, "turned": turned, "sharp": column(sharp, 3),
        "failed": {} if bad is None else _reasons(plans, mus, values, numpy.flatnonzero(bad).tolist()),
    }  # fmt: skip


def _guides(plans: Plans) -> list[str]:
    m = plans.mechanism
    return [g for link in (m.frame, *m.links.values()) for g in link.guides]


def _reasons(plans: Plans, mus: Mapping[str, float], values: list[float], indices: list[int]) -> dict[str, Any]:
    """Why each failed position fails, in both languages."""
    found = {}
    for index in indices:
        try:
            run(plans.program, {**plans.given, **mus, plans.drive_given: values[index]})
        except PlanFailure as failure:
            kind = plans.mechanism.drive.kind
            found[str(index)] = {lang: failed(failure, values[index], kind, None, lang) for lang in LANGS}
    return found
