"""A lesson: the program and its drawing as numbered frames, each a sentence of what is done and why.

One frame a mark: the directions and calculations a mark needs are told with it; what is measured after an equation
is drawn is a frame of its own, and so is each moment equation.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from planes import steps as s
from planes.drafting import POLE, Moments, label_of, mu_of
from planes.drawing import Drawing
from planes.equations import Equation
from planes.formulas import bracketed, formula, number, unit_of
from planes.plans import Plans
from planes.reckoning import Calculate, Choose, Measure
from planes.scales import kind_of
from planes.units import mu_text
from planes.words import Lang
from planes.words_lesson import LESSON


@dataclass(frozen=True)
class Frame:
    """One frame of a lesson. ``makes`` are the marks it adds, ``uses`` those it stands on (full names); ``equation``
    is the index of the vector equation being solved, ``terms`` the vectors in hand; ``said`` the words by language."""

    plan: str
    makes: tuple[str, ...]
    uses: tuple[str, ...]
    equation: int | None
    terms: tuple[str, ...]
    said: Mapping[Lang, str]


def tell(key: str, lang: Lang, **names: object) -> str:
    """A sentence of the lesson with its names and numbers."""
    return LESSON[key][0 if lang == "ru" else 1].format(**names)


class Teller:
    """Tells the steps of one drawing at its scales."""

    def __init__(self, plans: Plans, drawing: Drawing, scales: Mapping[str, float]) -> None:
        self.plans, self.drawing, self.scales = plans, drawing, scales
        self.made = {step.makes: step for step in drawing.program.steps}
        self.moments = {m.unknown: m for m in plans.moments}
        self.sizes = {f.name: f.size for forces in plans.acting.forces.values() for f in forces}

    def frames(self) -> list[Frame]:
        """All frames, in the order of the drawing."""
        put: list[s.Step] = [step for step in self.drawing.program.steps if isinstance(step, s.Put) and step.at]
        found = [self.fixed(put)] if put else []
        readings: list[s.Step] = []
        for step in self.drawing.program.steps:
            if step.kind == "value" and self.tells(step):
                readings.append(step)
            tells = step.kind == "mark" or isinstance(step, s.Touch)
            if not tells or step in put or step.makes in self.drawing.program.trials:
                continue
            found += self.readings(readings)
            readings = []
            if kind_of(self.plan(step)) != "motion" and step.makes != "position:p":
                found.append(self.mark(step))
        return found + self.readings(readings)

    def plan(self, step: s.Step) -> str:
        """The plan a mark stands on (a tangent's, the scheme)."""
        return step.makes.rpartition(":")[0] or "position"

    def tells(self, step: s.Step) -> bool:
        """Whether a value is told on its own: angular rates, moment equations, balancing loads."""
        return step.makes in self.moments or step.makes.startswith(("omega", "epsilon"))

    def fixed(self, put: list[s.Step]) -> Frame:
        """The fixed points together."""
        names = ", ".join(f"⟨{label_of(p.makes).lstrip('°')}⟩" for p in put)
        return self.frame("position", tuple(p.makes for p in put), (), "fixed", names=names)

    def frame(self, plan: str, makes: tuple[str, ...], uses: tuple[str, ...], key: str, **names: Any) -> Frame:
        """A frame with its sentence in both languages; callables among the names are asked per language."""
        index, terms = self.equation_of(plan, makes)
        said: dict[Lang, str] = {}
        for lang in ("ru", "en"):
            mu = mu_text(self.scales[mu_of(plan)], "velocity" if plan in ("lever", "motion") else kind_of(plan), lang)
            here = {k: v(lang) if callable(v) else v for k, v in names.items()}
            said[lang] = tell(key, lang, **{**here, "mu": mu})
        return Frame(plan, makes, uses, index, terms, said)

    def equation_of(self, plan: str, makes: tuple[str, ...]) -> tuple[int | None, tuple[str, ...]]:
        """The equation on this plan with a term that ends at one of the marks, and those terms."""
        labels = {label_of(m) for m in makes} - {POLE}
        for index, equation in enumerate(self.plans.equations):
            terms = tuple(t.name for t in equation.terms if t.end in labels and not t.drawn)
            if equation.plan == plan and terms:
                return index, terms
        return None, ()

    def mark(self, step: s.Step) -> Frame:
        """The frame of one mark."""
        uses = tuple(name for name, kind in step.reads() if kind == "mark")
        names = {f: label_of(v) for f, v in vars(step).items() if isinstance(v, str) and f != "makes"}
        key, more = self.words(step)
        return self.frame(self.plan(step), (step.makes,), uses, key, **{**names, "end": label_of(step.makes), **more})

    def words(self, step: s.Step) -> tuple[str, dict[str, Any]]:
        """The key of the sentence of a step, and what it says besides the step's own names."""
        mm = self.mm
        match step:
            case s.Put():
                return "pole", {}
            case s.LayOff():
                return self.lay_off(step)
            case s.Touch():
                return "touch", {"action": self.action(step.makes), "end": label_of(step.end)}
            case s.Cross():
                return "cross", {"action": self.action(step.along), "across": self.action(step.across)}
            case s.CrossArc():
                return "arc", {"action": self.action(step.along), "radius_mm": mm(step.radius, step.mu)}
            case s.CrossArcs():
                return "arcs", {"radius_mm": mm(step.radius, step.mu), "other_mm": mm(step.other_radius, step.mu)}
            case s.Similar():
                ratio = self.drawing[step.ratio]
                return "similar", {
                    "first": label_of(step.start), "second": label_of(step.end),
                    "ratio": lambda lang: number(abs(ratio), lang),
                }  # fmt: skip
            case s.Image():
                return "image", {"first": label_of(step.image[0]), "second": label_of(step.image[1])}
            case s.Same():
                return "same", {"start": label_of(step.of)}
            case s.Carry():
                return "carry", {}
            case Choose():
                return "choose", {}
        raise AssertionError(step)

    def lay_off(self, step: s.LayOff) -> tuple[str, dict[str, Any]]:
        """A known vector: with the formula of its length where it was calculated."""
        value = self.drawing[step.length]
        more = {"mm": self.mm(step.length, step.mu), "action": self.action(step.along)}
        source = self.made.get(step.length)
        if isinstance(source, Calculate):
            return "lay_off", {**more, "formula": lambda lang: str(formula(source, self.drawing, lang))}
        if isinstance(source, Measure):
            name = label_of(step.makes)
            told = lambda lang: number(value, lang)  # noqa: E731
            return "carried", {**more, "name": name, "value": told, "unit": unit_of(name), "length": step.length}
        along = self.made[step.along]
        driven = isinstance(along, s.Turn) and along.of == f"x_{self.plans.mechanism.drive.link}"
        told = lambda lang: number(value, lang)  # noqa: E731
        return "driver" if driven else "along", {**more, "value": told, "unit": "m", "length": step.length}

    def mm(self, value: str, mu: str) -> Any:
        """A length on paper, as each language writes it."""
        size = abs(self.drawing[value] * self.drawing[mu])
        return lambda lang: number(round(size, 1), lang)

    def action(self, direction: str) -> str:
        """A line of action as it is written: ⊥BC, ∥y-y, C→B."""
        return direction.replace("⊥∥", "⊥")

    def readings(self, values: list[s.Step]) -> list[Frame]:
        """Frames of what was reckoned since the last mark: rates together, each moment equation alone."""
        rates = [v for v in values if v.makes not in self.moments and isinstance(v, Calculate)]
        found = []
        if rates:
            plan = self.plan_of_value(rates[0])
            told = lambda lang: "; ".join(str(formula(v, self.drawing, lang)) for v in rates)  # noqa: E731
            uses = tuple(n for v in rates for n in self.marks_of(v))
            found.append(self.frame(plan, (), uses, "measured", readings=told))
        found += [self.moment(self.moments[v.makes]) for v in values if v.makes in self.moments]
        return found

    def marks_of(self, step: s.Step) -> list[str]:
        """Marks of the segments a calculated value was measured on."""
        sources = [self.made.get(name) for name, _ in step.reads()]
        return [m for source in sources if isinstance(source, Measure) for m in (source.start, source.end)]

    def plan_of_value(self, step: s.Step) -> str:
        """The plan whose segments a value was measured on."""
        marks = self.marks_of(step)
        return marks[0].rpartition(":")[0] if marks else "velocity"

    def moment(self, m: Moments) -> Frame:
        """A moment equation with its numbers."""
        plan = "lever" if m.links == ("lever",) else "position"

        def terms(lang: Lang) -> str:
            parts: list[str] = []
            for force, arm in m.terms:
                size = number(self.drawing[self.sizes.get(force, force)], lang)
                arm_text = f" · {bracketed(number(self.drawing[arm], lang))}" if arm else ""
                parts.append(f"{bracketed(size) if parts else size}{arm_text}")
            return " + ".join(parts) or "0"

        value = self.drawing[m.unknown]
        return self.frame(
            plan, (), (), "moments", about=m.about, links=", ".join(m.links), terms=terms, unknown=m.unknown,
            value=lambda lang: number(value, lang), unit=unit_of(m.unknown),
        )  # fmt: skip


def equation_terms(equation: Equation) -> list[str]:
    """Names of the terms of an equation, in order."""
    return [t.name for t in equation.terms]
