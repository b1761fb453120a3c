"""The steps of a program as commands and formulas of GeoGebra; a name of the program becomes a label."""

import json
from collections.abc import Callable, Iterator
from dataclasses import fields
from pathlib import Path

from planes.documents.constructed import LiveFigure
from planes.documents.constructed._numbers import RADIANS_PER_DEGREE, number_literal
from planes.drafting import steps as s
from planes.drafting.steps import crossings as c
from planes.drafting.steps import reckoning as r
from planes.words.frozen import field, frozen
from planes.words.names import NamesByName, PlanId
from render.files.ggb import HIDDEN_ASPECT, PALE_COLOUR, Aspect, GeogebraFile, Kind

Labels = dict[str, str]
CONSTRUCTION_LINE_ASPECT = Aspect(PALE_COLOUR, thick=2, dashed=True)
RIGHT_ANGLE_FORMULA = "90 * pi / 180"
OBJECTS_BY_STEP_KIND: dict[str, list[tuple[Kind, str, str, *tuple[str, ...]]]] = json.loads(
    Path(__file__).with_name("geogebra.json").read_text("utf-8")
)
"""The objects that stand for a step of a class: the kind of each, what precedes the step's own label in its label, and
a formula, or a command and its inputs. In braces are fields of the step, by their labels; coordinates of a field's
place end in _x and _y; the others are made by ``Translator.parts``. Vectors shorter than 1E-12 mm have no direction;
numbers below that share of the largest are zero."""


@frozen
class Translator:
    """Writes one step after another into a construction; ``left`` are those that stay numbers."""

    figure: LiveFigure
    made: GeogebraFile
    labels: Labels
    looks: Callable[[s.Step], Aspect]
    left: list[s.Step] = field(default_factory=list)

    def write_step(self, step: s.Step) -> None:
        """One step."""
        names = [kind.__name__ for kind in type(step).__mro__]
        if isinstance(step, s.Put) and not step.at:
            names = ["Pole"]
        elif isinstance(step, s.Carry) and step.quarter % 4:
            names = ["CarryTurned"]
        written = next((OBJECTS_BY_STEP_KIND[name] for name in names if name in OBJECTS_BY_STEP_KIND), None)
        if written is None:
            self.left.append(step)
            self.write_as_constant(step)
            return
        named = dict(self.placeholder_values(step))
        for kind, head, first, *inputs in written:
            label = head + self.labels[step.makes]
            look = self.mark_appearance(step, kind, head)
            if inputs:
                self.made.add_command(kind, [label], first, [text.format_map(named) for text in inputs], look)
            else:
                self.made.add_formula(kind, label, first.format_map(named), look)

    def mark_appearance(self, step: s.Step, kind: Kind, head: str) -> Aspect:
        """The appearance of an object on the way to a mark, or of the mark."""
        if kind == "conic" or (kind == "line" and step.makes in self.figure.shown_marks):
            return CONSTRUCTION_LINE_ASPECT
        if kind == "point" and not head:
            return self.looks(step)
        return HIDDEN_ASPECT

    def write_as_constant(self, step: s.Step) -> None:
        """A step as a constant, with its value in this position."""
        label = self.labels[step.makes]
        thing = complex(self.figure.position.drawing[step.makes])
        if step.kind == "mark":
            self.made.add_formula(
                "point", label, f"{self.pole_label(step.plan)} + {_coordinates_text(thing)}", self.looks(step)
            )
        elif step.kind == "direction":
            self.made.add_formula("vector", label, _coordinates_text(thing))
        else:
            self.made.add_formula("numeric", label, number_literal(thing.real))

    def pole_label(self, plan: PlanId) -> str:
        """The pole of a plan, "(0, 0)" where it has none."""
        return self.labels.get(plan.pole, "(0, 0)")

    def placeholder_values(self, step: s.Step) -> Iterator[tuple[str, object]]:
        """What the names in braces stand for."""
        n = self.labels
        yield "pole", self.pole_label(step.plan)
        for name in (f.name for f in fields(step)):
            match getattr(step, name):
                case str(given):
                    yield from ((name + end, n.get(given + end.replace("_", "."))) for end in ("", "_x", "_y"))
                case int(number):
                    yield name, number_literal(float(number))
                case (str(), str()) as marks:
                    yield name, [n[mark] for mark in marks]
        yield from self.composed_placeholders(step).items()

    def composed_placeholders(self, step: s.Step) -> NamesByName:
        """Parts of a text that are more than a label."""
        n = self.labels
        match step:
            case s.Put() if not step.at:
                return {"at": _coordinates_text(self.figure.pole_places[step.plan])}
            case s.Carry() | s.Turn():
                turns = [f"{step.quarter % 4} * {RIGHT_ANGLE_FORMULA}"] * bool(step.quarter % 4)
                if isinstance(step, s.Turn) and step.angle:
                    turns.append(f"{n[step.angle]} * {RADIANS_PER_DEGREE}")
                return {"turns": " + ".join(turns) or "0"}
            case c.Touch():
                apart = f"Distance[{n[step.start]}, {n[step.end]}]"
                return {"sine": f"({n[step.offset]} * {n[step.mu]} / {apart})" if step.offset else "0"}
            case r.Choose():
                return {"chosen": self.chosen_trial_formula(step)}
            case r.Measure():
                return {"span": self.span_formula(step)}
            case r.Sense():
                beside = [f"Distance[{self.pole_label(m.plan)}, {n[m]}]" for m in step.beside]
                return {"span": self.span_formula(step), "largest": " + ".join(beside) or "0"}
            case r.Calculate():
                return {"sum": " + ".join(map(self.product_formula, step.terms)) or "0"}
            case r.SenseBetween():
                rates = [f"({n[rate]} * abs({n[sense]}))" if rate else "0" for rate, sense in step.signed_rates]
                return dict(zip(("one", "two"), rates, strict=True))
        return {}

    def chosen_trial_formula(self, step: r.Choose) -> str:
        """The trial whose assumptions hold."""
        text = ""
        for trial in reversed(step.trials):
            signs = zip(trial.pushes, trial.signs, strict=True)
            holds = " && ".join(f"{sign} * {self.labels[push]} >= -1E-9" for push, sign in signs)
            text = f"If[{holds}, {self.labels[trial.mark]}{', ' + text if text else ''}]"
        return text

    def span_formula(self, step: r.Measure | r.Sense) -> str:
        """The distance between two marks, or its component along a direction."""
        start = self.labels[step.start]
        end = self.labels[step.end]
        if step.along:
            return f"(({end} - {start}) * {self.labels[step.along]})"
        return f"Distance[{start}, {end}]"

    def product_formula(self, term: r.Product) -> str:
        """One product of powers."""
        factors = (self.labels[name] + (f"^({power})" if power != 1 else "") for name, power in term.factors)
        return " * ".join([number_literal(float(term.coefficient)), *factors])


def _coordinates_text(z: complex) -> str:
    """A place or a vector as two numbers."""
    return f"({number_literal(z.real)}, {number_literal(z.imag)})"
