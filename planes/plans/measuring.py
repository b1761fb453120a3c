"""What is read off a drawing: results by name, in SI, with the segments they were measured on."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import Any

from planes.drafting.draft import Segment
from planes.drafting.drawing import Drawing
from planes.plans import Plans
from planes.plans.loads import force_name
from planes.scene.mechanism import FRAME
from planes.words import Lang, Phrase
from planes.words.errors import PlanFailure, SceneError, choices
from planes.words.names import POLE, at, kind_of, label_of, mu_of, plan_of
from planes.words.things import plan_phrase
from planes.words.units import UNIT, mu_text

BLUNT = math.sin(math.radians(15))


@dataclass(frozen=True)
class Quantity:
    """One thing that can be asked for: its place in the results and the names of the program it needs."""

    name: str
    path: tuple[str, ...]
    needs: tuple[str, ...]
    reads: tuple[str, ...] = ()


def catalogue(st: Plans) -> dict[str, Quantity]:
    """Every quantity of a mechanism by the name a student writes: v_C, a_H, omega_2, F_21, M_1, v_CB…"""
    found: dict[str, Quantity] = {}

    def add(name: str, path: tuple[str, ...], *needs: str) -> None:
        found.setdefault(name, Quantity(name, path, tuple(n for n in needs if n)))

    for point, marks in st.points.items():
        for letter, mark in (("r", marks.position), ("v", marks.velocity), ("a", marks.acceleration)):
            add(f"{letter}_{point}", ("points", point, letter), at(plan_of(mark), POLE), mark)
    for link, values in st.links.items():
        if link != FRAME:
            for key, name in (("angle_deg", values.angle), ("omega", values.omega), ("epsilon", values.epsilon)):
                add(f"{'phi' if key == 'angle_deg' else key}_{link}", ("links", link, key), name)
    for link in st.velocity_slides:
        rate, quick = st.velocity_slides[link], st.acceleration_slides[link]
        add(f"v_slide_{link}", ("slides", link, "v"), rate.value)
        add(f"a_slide_{link}", ("slides", link, "a"), quick.value)
        add(f"coriolis_{link}", ("slides", link, "coriolis"), *(quick.coriolis or ()))
    for key, r in st.reactions.items():
        needs = (r.start, r.end, r.moment, r.arm, r.normal)
        add(key, ("reactions", key), *needs)
        add(force_name(r.pair.other, r.pair.link), ("reactions", key), *needs)
    driver, turning = st.mechanism.drive.link, st.mechanism.drive.kind == "phi"
    what, letter = ("moment", "M") if turning else ("force", "Fb")
    for name in (f"{letter}_{driver}", f"balancing_{what}"):
        add(name, (f"balancing_{what}",), st.balancing)
    for name in (f"{letter}Z_{driver}", f"zhukovsky_{what}"):
        add(name, (f"zhukovsky_{what}",), st.zhukovsky)
    for s in st.segments:
        ends = at(s.plan, s.start), at(s.plan, s.end)
        if s.plan != "motion" and s.start != s.end and not any(n in st.helpers for n in ends):
            add(s.name, ("plans", s.plan, s.name), *ends)
    return found


def asked(st: Plans, find: Iterable[str], file: str = "") -> list[Quantity]:
    """The quantities named in ``find:``. :class:`SceneError` names those that would have been valid."""
    known = catalogue(st)
    chosen = []
    for name in find:
        if name not in known:
            line = st.mechanism.where.get(("find",))
            raise SceneError(Phrase("no_quantity", name=name, valid=choices(name, known)), file, line)
        chosen.append(known[name])
    return chosen


class Reader:
    """Reads one drawing (``pick`` chooses one of many)."""

    def __init__(self, st: Plans, drawing: Drawing, scales: dict[str, float], pick: int | None = None) -> None:
        self.st, self.drawing, self.scales, self.pick = st, drawing, scales, pick

    def number(self, name: str) -> Any:
        """A mark or value of the drawing as a plain number."""
        value = self.drawing[name]
        if self.pick is not None and _many(value):
            value = value[self.pick].item()
        return value

    def vector(self, start: str, end: str) -> list[float]:
        """A segment as [x, y] in SI."""
        mu = self.scales[mu_of(plan_of(start))]
        way = (self.number(end) - self.number(start)) / mu
        return [self.finite(way.real, end), self.finite(way.imag, end)]

    def value(self, name: str) -> float:
        """A value in SI; 0 for what has no name (it never turns)."""
        return self.finite(self.number(name), name) if name else 0.0

    def finite(self, value: float, name: str) -> float:
        """The number itself, never NaN or infinite."""
        if not math.isfinite(value):
            raise PlanFailure("no_digits", makes=label_of(name))
        return float(value) + 0.0

    def results(self, quantities: Iterable[Quantity] | None = None) -> dict[str, Any]:
        """Results as nested dictionaries, in the order and under the keys of the JSON."""
        chosen = list(catalogue(self.st).values() if quantities is None else quantities)
        out: dict[str, Any] = {}
        for key in ("points", "links", "slides", "reactions"):
            if quantities is None:
                out[key] = {}
        for q in chosen:
            if q.path[0] != "plans":
                self._put(out, q.path)
        for link, found in out.get("slides", {}).items():
            out["slides"][link] = {"guide": self.st.velocity_slides[link].guide, **found}
        return out

    def read(self, quantity: Quantity) -> Any:
        """One quantity: a number, [x, y], or what a sliding pair has; the length in SI of a segment of a plan."""
        if quantity.path[0] != "plans":
            return self._read(quantity.path)
        return math.hypot(*self.vector(*quantity.needs))

    def _put(self, out: dict[str, Any], path: tuple[str, ...]) -> None:
        for key in path[:-1]:
            out = out.setdefault(key, {})
        out.setdefault(path[-1], None)
        out[path[-1]] = self._read(path)

    def _read(self, path: tuple[str, ...]) -> Any:
        st = self.st
        match path:
            case ("points", name, letter):
                marks = st.points[name]
                mark = {"r": marks.position, "v": marks.velocity, "a": marks.acceleration}[letter]
                return self.vector(at(plan_of(mark), POLE), mark)
            case ("links", name, key):
                values = st.links[name]
                return self.value({"angle_deg": values.angle, "omega": values.omega, "epsilon": values.epsilon}[key])
            case ("slides", name, "v"):
                return self.value(st.velocity_slides[name].value)
            case ("slides", name, "a"):
                return self.value(st.acceleration_slides[name].value)
            case ("slides", name, _):
                ends = st.acceleration_slides[name].coriolis
                return self.vector(*ends) if ends else [0.0, 0.0]
            case ("reactions", key):
                return self.reaction(key)
        return self.value(st.balancing if path[0].startswith("balancing") else st.zhukovsky)

    def reaction(self, key: str) -> Any:
        """A hinge's force, or a sliding pair's force, arm and couple at the foot of the slider's first point."""
        r = self.st.reactions[key]
        force = self.vector(r.start, r.end)
        if r.pair.kind == "R":
            return force
        largest = max(abs(self.number(s.makes)) for s in self.drawing.program.steps if plan_of(s.makes) == r.plan)
        nothing = abs(self.value(r.normal)) <= 1e-12 * largest / self.scales[mu_of(r.plan)]
        arm = None if nothing else self.value(r.arm)
        return {"force": force, "arm": arm, "moment": self.value(r.moment)}

    def plan_segments(self, plan: str, names: set[str] | None = None) -> dict[str, Segment]:
        """The measured segments of a plan by their ends ("bc"), each once, of ``names`` alone if given.

        Where one segment is two vectors (v_C and v_CD of a fixed D), it is named as the point's own.
        """
        own = {f"{letter}_{point}" for letter in "va" for point in self.st.points}
        found: dict[str, Segment] = {}
        for s in self.st.segments:
            there = at(s.plan, s.start) in self.drawing and at(s.plan, s.end) in self.drawing
            if s.plan == plan and s.start != s.end and there and (names is None or s.name in names):
                key = s.start + s.end
                if key not in found or (s.name in own and found[key].name not in own):
                    found[key] = s
        return found

    def plans(self, names: set[str] | None = None, errors: dict[str, float] | None = None) -> dict[str, Any]:
        """What was measured on each plan: μ, segments in mm and in SI, sharpness of the crossings."""
        out: dict[str, Any] = {}
        for plan in self.st.drawn:
            if plan in ("lever", "motion"):
                continue
            sharpness = self.sharpness(plan)
            bluntest = min([1.0, *sharpness.values()])
            segments = {
                key: self.segment(s, bluntest, (errors or {}).get(f"{plan}:{key}"))
                for key, s in self.plan_segments(plan, names).items()
            }
            if not segments:
                continue
            out[plan] = {
                "mu": mu_text(self.scales[mu_of(plan)], kind_of(plan)),
                "segments": segments,
                "sharpness": sharpness,
            }
        return out

    def segment(self, s: Segment, bluntest: float, error_mm: float | None = None) -> dict[str, Any]:
        """One segment as measured with the instrument, on a plan whose bluntest crossing has this sharpness."""
        hand, mu = self.drawing.hand, self.scales[mu_of(s.plan)]
        start, end = self.number(at(s.plan, s.start)), self.number(at(s.plan, s.end))
        length = self.finite(hand.read(abs(end - start)), s.name)
        if error_mm is None:
            error_mm = 8 * hand.ar.eps * (abs(start) + abs(end)) / bluntest
        return {
            "mm": float(length), "value": float(length / mu), "unit": UNIT[kind_of(s.plan)],
            "error_mm": float(error_mm), "name": s.name,
        }  # fmt: skip

    def sharpness(self, plan: str) -> dict[str, float]:
        """Sine of the angle at which the lines of each crossed mark meet."""
        found = {}
        for name, sharpness in self.drawing.sharpness.items():
            if plan_of(name) == plan and name not in self.drawing.program.trials:
                one = sharpness[self.pick] if _many(sharpness) and self.pick is not None else sharpness
                found[label_of(name)] = float(one)
        return found


def _many(value: Any) -> bool:
    return bool(getattr(value, "shape", None))


def say_plan(plan: str, lang: Lang) -> str:
    """The name of a plan in words."""
    return plan_phrase(plan).told(lang)
