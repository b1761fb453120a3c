"""What the lesson's scheme is drawn from: links, guides, sliders, forces with their arms, and which name is whose."""

from __future__ import annotations

import re
from typing import Any

from planes.drafting.draft import Moments
from planes.drafting.drawing import Drawing
from planes.drafting.steps import LayOff, Step
from planes.drafting.steps.reckoning import Calculate, Drop
from planes.plans import Plans
from planes.scene.mechanism import FRAME, Mechanism
from planes.words.names import at, plan_of

SPREAD = (8, 92)  # per cent of the positions by which the length of a rod is judged


def scheme(plans: Plans, cycle: Drawing) -> dict[str, Any]:
    """Links by their points, guides by a mark and a direction, sliders."""
    m = plans.mechanism
    moving = [p for x in m.links.values() for p in x.points]
    links = [
        {
            "name": x.name,
            "points": [at("position", p) for p in x.points],
            "hinges": [at("position", p) for p in x.points if moving.count(p) > 1 or p in m.frame.points],
            "slides": x.slides.guide if x.slides else None,
        }
        for x in m.links.values()
    ]
    guides = [
        {
            "name": g.name,
            "link": link.name,
            "mark": (mark := at("position", g.through_point or f"°{g.name}")),
            "reach": _reach(plans, cycle, g.name, mark),
        }
        for link in (m.frame, *m.links.values())
        for g in link.guides.values()
        if at("position", g.through_point or f"°{g.name}") in cycle
    ]
    fixed = [at("position", p) for p in pivots(m)]
    return {"links": links, "guides": guides, "pivots": fixed, "driver": m.drive.link, "frame": FRAME}


def pivots(m: Mechanism) -> list[str]:
    """The fixed points that belong to a moving link too."""
    return [p for p in m.frame.points if any(p in x.points for x in m.links.values())]


def _reach(plans: Plans, cycle: Drawing, guide: str, mark: str) -> list[float]:
    """From where to where along a guide its sliders run, mm from its mark, in most positions."""
    import numpy

    joints = [cycle[at("position", p)] for x in plans.mechanism.links.values() for p in x.points]
    size = max((float(numpy.nanmedian(abs(a - b))) for a in joints for b in joints), default=0.0)
    found = [0.0]
    for link in plans.mechanism.links.values():
        if link.slides and link.slides.guide == guide and f"∥{guide}" in cycle:
            way = (cycle[at("position", link.first_point)] - cycle[mark]) * numpy.conj(cycle[f"∥{guide}"])
            run = numpy.real(numpy.atleast_1d(way))
            run = run[numpy.isfinite(run)]
            found += [round(float(v), 1) for v in numpy.percentile(run, SPREAD)] if len(run) else []
    return [round(max(min(found), -size), 1), round(min(max(found), size), 1)]


def arms(plans: Plans) -> list[dict[str, Any]]:
    """For each moment equation the forces in it: where each acts, its direction and the foot of its arm."""
    steps: dict[str, Step] = {s.makes: s for s in plans.program.steps}
    found = []
    for m in plans.moments:
        plan = "lever" if m.links == ("lever",) else "position"
        forces = _forces(m, steps) + _unknown(plans, m, steps)
        found.append({"about": at(plan, m.about), "plan": plan, "links": list(m.links), "forces": forces})
    return found


def _forces(m: Moments, steps: dict[str, Step]) -> list[dict[str, Any]]:
    found = []
    equation = steps.get(m.unknown)
    terms = equation.terms if isinstance(equation, Calculate) else ()
    for (name, arm), term in zip(m.terms, terms, strict=False):
        drop = steps.get(arm)
        if isinstance(drop, Drop):
            own = {"name": name, "mark": drop.point, "along": drop.along, "size": term.factors[0][0]}
            found.append({**own, "foot": _foot(arm, drop)})
    return found


def _foot(arm: str, drop: Drop) -> str:
    return at(plan_of(drop.point), f"⊥{arm}")


def _unknown(plans: Plans, m: Moments, steps: dict[str, Step]) -> list[dict[str, Any]]:
    """The tangential reaction a moment equation is solved for."""
    laid = next((s for s in steps.values() if isinstance(s, LayOff) and s.length == m.unknown), None)
    reaction = plans.reactions.get(m.unknown.removesuffix("^t"))
    if laid is None or reaction is None:
        key = m.unknown.removesuffix("^t")
        reaction = next((r for r in plans.reactions.values() if r.key == key), None)
    if laid is None or reaction is None:
        return []
    mark = at("position", reaction.pair.point)
    return [{"name": m.unknown, "mark": mark, "along": laid.along, "size": m.unknown, "foot": None}]


def feet(plans: Plans, cycle: Drawing) -> dict[str, Any]:
    """The feet of the arms as marks."""
    import numpy

    found = {}
    for step in plans.program.steps:
        if isinstance(step, Drop) and step.makes in cycle and plan_of(step.point) != "motion":
            way = numpy.real((cycle[step.about] - cycle[step.point]) * numpy.conj(cycle[step.along]))
            found[_foot(step.makes, step)] = cycle[step.point] + way * cycle[step.along]
    return found


def related(plans: Plans) -> dict[str, list[str]]:
    """Links and points of the scheme by the names of vectors and values that are theirs."""
    m, found = plans.mechanism, dict[str, list[str]]()
    points = {p: link.name for link in (*m.links.values(),) for p in link.points}
    names = {s.name for s in plans.segments} | {t.name for e in plans.equations for t in e.terms}
    for name in sorted(names | set(plans.links) | set(plans.program.made)):
        letter, _, index = name.partition("^")[0].strip("|‖").partition("_")
        if letter in ("v", "a", "r") and index in points:
            found[name] = [at("position", index)]
        elif letter in ("v", "a") and (pair := _pair(plans, index)):
            found[name] = [pair]
        elif letter in ("omega", "epsilon", "G", "I", "MI", "P", "M") and index.partition("_")[0] in m.links:
            found[name] = [f"link:{index.partition('_')[0]}"]
        elif letter == "F" and (key := re.sub(r"[tn]$", "", index)):
            on = key.partition("_")[0] if "_" in key else key[:1]
            found[name] = [f"link:{on}"] if on in m.links else []
    return {k: v for k, v in found.items() if v}


def _pair(plans: Plans, symbol: str) -> str:
    """The link that carries both points of "CB", or the slider of a relative motion "HL"."""
    for link in plans.mechanism.links.values():
        for one in link.points:
            for two in link.points:
                if one != two and one + two == symbol:
                    return f"link:{link.name}"
    for link in plans.mechanism.links.values():
        if link.slides and any(symbol.startswith(p) or symbol.endswith(p) for p in link.points):
            return f"link:{link.name}"
    return ""
