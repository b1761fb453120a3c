"""Scenes that state vectors and equations alone: drawn by the drafting core with any instrument, and measured."""

import cmath
import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from planes.drafting.drawing import Drawing, run
from planes.drafting.instruments import Instrument, Pencil
from planes.drafting.program import Program
from planes.drafting.tools import Thing
from planes.scene import Scene
from planes.solving import scatter_mm
from planes.solving.vector_plan import PLAN, VectorPlan, quantity_of
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanFailure, SceneError, choices
from planes.words.names import label_of, mu_of
from planes.words.records import Json
from planes.words.units import UNIT, mu_text, standard_mu

FIT_MM = 100.0  # how long the plan may be where μ is open
BLUNT_DEG = 15.0

__all__ = ["PLAN", "VectorPlan", "VectorResults", "program_of", "solve_vectors", "stated"]


@dataclass(frozen=True)
class VectorResults:
    """A drawn scene of vectors; ``spans`` are the marks each vector asked for runs between, ``scatter_mm`` how far
    apart pencils end, ``errors`` the ± of the results where they were asked."""

    scene: Scene
    plan: VectorPlan
    drawing: Drawing
    mu: float
    quantity: str
    spans: Mapping[str, tuple[str, str]]
    scatter_mm: Mapping[str, float] = field(default_factory=dict)
    errors: Json | None = None

    @property
    def given(self) -> dict[str, Thing]:
        """What the drawing was made from."""
        return {name: self.drawing.things[name] for name in self.plan.draft.given}

    def vectors(self) -> dict[str, complex]:
        """Every vector asked for, in its own unit."""
        return {n: (self.drawing[e] - self.drawing[s]) / self.mu for n, (s, e) in self.spans.items()}

    def segment(self, name: str) -> Json:
        """The vector as it is measured on the plan."""
        start, end = (self.drawing[mark] for mark in self.spans[name])
        mm, blunt = self.drawing.tool.read(abs(end - start)), min([1.0, *self.drawing.sharpness.values()])
        error = self.scatter_mm.get(name, 8 * self.drawing.tool.ar.eps * (abs(start) + abs(end)) / blunt)
        if self.errors:
            error = self.errors["plans"][PLAN]["segments"][name]["mm"] or error
        sizes = {"mm": float(mm), "value": float(mm / self.mu)}
        return {**sizes, "unit": UNIT[self.quantity], "error_mm": float(error), "name": name}

    def warnings(self, lang: Lang = "en") -> list[str]:
        """Crossings too blunt to be drawn well."""
        angles = {label_of(k): math.degrees(math.asin(min(1.0, v))) for k, v in self.drawing.sharpness.items()}
        return [
            say("blunt", lang, makes=f"{mark} ({say('plan_vectors', lang)})", angle_deg=f"{angle:.2g}")
            for mark, angle in angles.items()
            if angle < BLUNT_DEG
        ]

    def json(self, lang: Lang = "en") -> Json:
        """The object printed with ``--json``."""
        found = {
            n: {"value": abs(v), "direction_deg": math.degrees(cmath.phase(v)), "xy": [v.real, v.imag]}
            for n, v in self.vectors().items()
        }
        sharpness = {label_of(k): float(v) for k, v in self.drawing.sharpness.items()}
        segments = {n: self.segment(n) for n in self.spans}
        plan = {"mu": mu_text(self.mu, self.quantity), "segments": segments, "sharpness": sharpness}
        errors = {} if self.errors is None else {"errors": self.errors}
        warnings = [*(d.told(lang) for d in self.scene.doubts), *self.warnings(lang)]
        told = {"planes": 1, "scene": self.scene.file, "vectors": found, "plans": {PLAN: plan}}
        return {**told, **errors, "warnings": warnings}


def stated(scene: Scene) -> tuple[VectorPlan, dict[str, tuple[str, str]]]:
    """The equations of a scene as a plan, and the spans of the vectors it asks for."""
    plan = VectorPlan(scene)
    plan.build()
    for name in scene.find or ():
        if name not in plan.spans:
            why = Phrase("no_quantity", name=name, valid=choices(name, plan.spans))
            raise SceneError(why, scene.file, scene.where.get(("find",)))
    return plan, {name: plan.spans[name] for name in scene.find or plan.spans}


def program_of(plan: VectorPlan, spans: Mapping[str, tuple[str, str]]) -> Program:
    """The steps that lead to these vectors."""
    return Program(tuple(plan.draft.steps.values())).sliced(mark for span in spans.values() for mark in span)


def solve_vectors(scene: Scene, instrument: Instrument | None = None) -> VectorResults:
    """Draw a scene of vectors. :class:`SceneError` where an equation cannot be drawn, with file:line."""
    quantity, (plan, spans) = quantity_of(scene), stated(scene)
    program, given = program_of(plan, spans), dict(plan.draft.given)
    for side, names in plan.choices:
        given[side] = _choose(plan, given, side, names)
    try:
        drawing = run(program, given)
        longest = max(abs(drawing[s.makes]) for s in program.steps if s.kind == "mark")
        mu = scene.mu.get("vectors") or standard_mu(longest, FIT_MM)
        given[mu_of(PLAN)] = mu
        drawing = run(program, given, instrument)
    except PlanFailure as failure:
        raise plan.failure(failure) from None
    scatter = scatter_mm(program, given, mu_of(PLAN), instrument, spans) if isinstance(instrument, Pencil) else {}
    return VectorResults(scene, plan, drawing, mu, quantity, spans, scatter)


def _choose(plan: VectorPlan, given: Mapping[str, Thing], side: str, names: tuple[str, ...]) -> float:
    """The root whose vectors point nearer to ``near:``."""
    near = {name: given_near for name in names if (given_near := plan.scene.vectors[name].near_deg) is not None}
    asked = list(near) or [names[0]]
    program = program_of(plan, {name: plan.spans[name] for name in asked})
    found = []
    for sign in (1.0, -1.0):
        try:
            drawing = run(program, {**given, side: sign})
        except PlanFailure:
            continue
        ways = {n: math.degrees(cmath.phase(drawing[plan.spans[n][1]] - drawing[plan.spans[n][0]])) for n in asked}
        apart = sum(abs((ways[name] - angle + 180) % 360 - 180) for name, angle in near.items())
        found.append((apart, sign, ways))
    if not near and found:
        offers = tuple(Phrase("near_angle", angle=ways[asked[0]]) for _, _, ways in found)
        line = plan.scene.where.get(("vectors", asked[0]))
        raise SceneError(Phrase("two_directions", name=asked[0], offers=offers), plan.scene.file, line)
    return min(found, key=lambda one: one[0], default=(0.0, 1.0, {}))[1]
