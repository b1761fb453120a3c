"""The right plans as tracing paper: plain data for a page that lays them over a picture nobody sends anywhere."""

from __future__ import annotations

import shlex
from dataclasses import replace

from planes.check.grading.polygons import sides_of
from planes.check.grading.prepared_plan import Asked, PreparedPlan, known_plans, prepare
from planes.check.report.shown import vectors
from planes.plans.measuring import lettering, say_plan
from planes.words import Lang
from planes.words.names import POLE, kind_of
from planes.words.records import Json
from planes.words.units import mu_text


def tracing_data(asked: Asked, lang: Lang) -> Json:
    """All plans of a scene, the one asked for first, mm from their poles."""
    bench = prepare(asked)
    others = [p for p in known_plans(bench.plans) if p != asked.plan]
    benches = [bench, *(prepare(replace(asked, plan=p, mu=None)) for p in others)]
    scene = asked.scene
    return {
        "title": scene.title.get(lang, "") or scene.file,
        "lettering": lettering(scene, bench.plans),
        "plans": [_plan(b, lang) for b in benches],
    }


def _plan(bench: PreparedPlan, lang: Lang) -> Json:
    plan, kind = bench.asked.plan, kind_of(bench.asked.plan)
    marks = bench.true_marks
    said = say_plan(plan, lang)
    line = shlex.join(bench.asked.line("⟦file⟧")).replace("'⟦file⟧'", "⟦file⟧")
    names = [(s.name, s.start, s.end) for s in sides_of(bench.plans, plan)] if kind == "force" else []
    return {
        "key": plan,
        "kind": kind,
        "title": f"{said[:1].upper()}{said[1:]}, μ = {mu_text(bench.said_mu, kind, lang)}",
        "marks": {POLE: [0.0, 0.0], **{n: [round(z.real, 4), round(z.imag, 4)] for n, z in marks.items()}},
        "far": max(marks, key=lambda n: abs(marks[n])),
        "vectors": vectors(bench),
        "names": names,
        "command": f"{line} --pole ⟦pole⟧ --mark ⟦mark⟧",  # the page puts in the picture and the places of two points
    }
