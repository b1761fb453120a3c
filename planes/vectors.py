"""Scenes that state vectors and equations alone: solve them in whatever order they can be, by the drafting core."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any

from planes.drafting import Draft
from planes.drawing import Drawing, run
from planes.equations import Equation, Term, unknown
from planes.naming import POLE, at, label_of, mu_of
from planes.program import Program
from planes.scene import Scene, VectorGiven
from planes.statement import Sides, ends, read_equation
from planes.units import mu_text, standard_mu
from planes.wording import EquationError, PlanFailure, SceneError, choices
from planes.words import Phrase, Told

PLAN = "vectors"


@dataclass
class VectorPlan:
    """The equations of a scene as one program; ``spans`` are the marks each vector runs between."""

    scene: Scene
    draft: Draft = field(default_factory=Draft)
    spans: dict[str, tuple[str, str]] = field(default_factory=dict)
    known: dict[str, tuple[str | None, str | None]] = field(default_factory=dict)  # name -> (length, direction)
    choices: list[tuple[str, str]] = field(default_factory=list)  # (given ±1, the vector whose direction it decides)
    solved: dict[str, tuple[int, str]] = field(default_factory=dict)  # mark -> number and text of its equation

    def error(self, index: int, phrase: Told) -> SceneError:
        return SceneError(phrase, self.scene.file, self.scene.equation_lines[index])

    def build(self) -> None:
        """Draw every equation, each as soon as it has but two unknowns."""
        self.draft.pole(PLAN)
        for name, given in self.scene.vectors.items():
            self.known[name] = self._given(name, given)
        left = {i: self._read(i, text) for i, text in enumerate(self.scene.equations)}
        while left:
            done = self._solve_one(left) or self._solve_pair(left)
            if not done:
                index, sides = next(iter(left.items()))
                listed = tuple(self.unknowns(sides)) or Phrase("none")
                raise self.error(index, Phrase("unknowns_are", text=str(sides), listed=listed))
            for index in done:
                del left[index]

    def _given(self, name: str, given: VectorGiven) -> tuple[str | None, str | None]:
        length = None if given.value is None else self.draft.give(f"|{name}|", given.value)
        direction = None if given.direction_deg is None else self.draft.aim(f"∠{name}", given.direction_deg)
        return length, direction

    def _read(self, index: int, text: str) -> Sides:
        for name in re.findall(r"[^\W\d][\w^'′]*", text):
            if name not in self.known:
                valid = choices(name, self.known)
                raise self.error(index, Phrase("no_vector", text=text, name=name, valid=valid))
        try:
            return read_equation(text)
        except EquationError as error:
            raise self.error(index, error.phrase) from None

    def unknowns(self, sides: Sides) -> list[Phrase]:
        """What the equation does not know, in words."""
        found = []
        for name in sides.left + sides.right:
            parts = zip(("length", "direction"), self.known[name], strict=True)
            found += [unknown(name, part) for part, given in parts if given is None]
        return found

    def _solve_one(self, left: dict[int, Sides]) -> list[int]:
        for index, sides in left.items():
            if len(self.unknowns(sides)) == 2:
                self._draw(index, sides.text, sides.left, sides.right)
                return [index]
        return []

    def _solve_pair(self, left: dict[int, Sides]) -> list[int]:
        """Two equations with one unknown vector alone on a side each: their other sides are equal."""
        for i, one in left.items():
            for j, two in left.items():
                if i < j and len(one.left) == 1 and one.left == two.left:
                    both = Sides(f"{one.text}, {two.text}", one.right, two.right)
                    if len(self.unknowns(both)) == 2:
                        self._draw(i, both.text, one.right, two.right, one.left[0])
                        return [i, j]
        return []

    def failure(self, failure: PlanFailure) -> SceneError:
        """What an equation cannot be drawn for, in words of vectors."""
        index, text = self.solved.get(str(failure.numbers.get("makes")), (0, self.scene.equations[0]))
        return self.error(index, Phrase(f"vectors_{failure.reason}", **{**failure.numbers, "text": text}))

    def _draw(
        self, index: int, text: str, left: tuple[str, ...], right: tuple[str, ...], total: str | None = None
    ) -> None:
        named = ends(total or (right or left)[-1])
        target = named[1] if named and not self.draft.has(PLAN, named[1]) else f"e{index + 1}"
        self.solved[target] = index, text
        chains = self._chain(left, target), self._chain(right, target)
        if not chains[1]:
            chains = self._chain(left, POLE), ()
        side = None
        free = [t.name for c in chains for t in c if t.direction is None and t.length is not None]
        if free:
            side = self.draft.give(f"side_{index + 1}", 1.0)
            self.choices.append((side, free[0]))
        try:
            equation = Equation(PLAN, chains, total, side)
        except EquationError as error:
            raise self.error(index, error.phrase) from None
        self.draft.draw(equation)
        for term in equation.terms:
            self._learn(term.name, term.start, term.end)
        if total:
            self._learn(total, POLE, target)

    def _chain(self, names: tuple[str, ...], target: str) -> tuple[Term, ...]:
        """The side's terms, known ones first, from the pole to the target."""
        ordered = sorted(names, key=lambda n: None in self.known[n])
        terms, mark = [], POLE
        for i, name in enumerate(ordered):
            there = self.spans.get(name)
            if there and there[0] == at(PLAN, mark):
                terms.append(Term(name, mark, label_of(there[1]), drawn=True))
            else:
                end = target if i == len(ordered) - 1 else self._label(name, mark)
                length, direction = self.known[name]
                terms.append(Term(name, mark, end, length, direction, direction or ""))
            mark = terms[-1].end
        return tuple(terms)

    def _label(self, name: str, mark: str) -> str:
        """Where a vector laid off from a mark ends: as its name says, else a mark of its own."""
        span = ends(name)
        label = span[1] if span and span[0] == mark else name
        while self.draft.has(PLAN, label):
            label += "′"
        return label

    def _learn(self, name: str, start: str, end: str) -> None:
        """From now on the vector is known: it is on the drawing."""
        marks = at(PLAN, start), at(PLAN, end)
        if None in self.known[name]:
            length = self.draft.measure(f"‖{name}‖", *marks)
            self.known[name] = length, self.draft.through(f"→{name}", *marks)
        self.spans.setdefault(name, marks)


@dataclass(frozen=True)
class VectorResults:
    """A drawn scene of vectors."""

    scene: Scene
    plan: VectorPlan
    drawing: Drawing
    mu: float

    def vectors(self) -> dict[str, complex]:
        """Every vector that stands in an equation, in its own unit."""
        return {n: (self.drawing[e] - self.drawing[s]) / self.mu for n, (s, e) in self.plan.spans.items()}

    def json(self) -> dict[str, Any]:
        """The object printed with ``--json``."""
        quantity = self.scene.quantity or "velocity"
        found = {
            n: {"value": abs(v), "direction_deg": math.degrees(cmath.phase(v)), "xy": [v.real, v.imag]}
            for n, v in self.vectors().items()
        }
        segments = {n: {"mm": abs(v) * self.mu, "value": abs(v), "name": n} for n, v in self.vectors().items()}
        sharpness = {label_of(k): float(v) for k, v in self.drawing.sharpness.items()}
        plan = {"mu": mu_text(self.mu, quantity), "segments": segments, "sharpness": sharpness}
        return {"planes": 1, "scene": self.scene.file, "vectors": found, "plans": {PLAN: plan}, "warnings": []}


def solve_vectors(scene: Scene) -> VectorResults:
    """Draw a scene of vectors. :class:`SceneError` where an equation cannot be drawn, with file:line."""
    plan = VectorPlan(scene)
    plan.build()
    draft = plan.draft
    program = Program(tuple(draft.steps.values()))
    given = {**draft.given, mu_of(PLAN): 1.0}
    for side, name in plan.choices:
        given[side] = _choose(plan, program, given, side, name)
    try:
        drawing = run(program, given)
        mu = scene.mu.get("vectors") or standard_mu(max(abs(drawing[m]) for m in _marks(program)), 100.0)
        return VectorResults(scene, plan, run(program, {**given, mu_of(PLAN): mu}), mu)
    except PlanFailure as failure:
        raise plan.failure(failure) from None


def _marks(program: Program) -> list[str]:
    return [s.makes for s in program.steps if s.kind == "mark"]


def _choose(plan: VectorPlan, program: Program, given: Mapping[str, Any], side: str, name: str) -> float:
    """The root whose vector points nearer to ``near:``."""
    start, end = plan.spans[name]
    found = []
    for sign in (1.0, -1.0):
        try:
            drawing = run(program.sliced([start, end]), {**given, side: sign})
        except PlanFailure:
            continue
        found.append((sign, math.degrees(cmath.phase(drawing[end] - drawing[start]))))
    near = plan.scene.vectors[name].near_deg
    if near is None and found:
        offers = tuple(Phrase("near_angle", angle=angle) for _, angle in found)
        line = plan.scene.where.get(("vectors", name))
        raise SceneError(Phrase("two_directions", name=name, offers=offers), plan.scene.file, line)
    return min(found, key=lambda f: abs((f[1] - (near or 0.0) + 180) % 360 - 180), default=(1.0, 0.0))[0]
