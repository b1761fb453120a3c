"""The steps of a program as commands and formulas of GeoGebra; a name of the program becomes a label."""

from collections.abc import Callable

from planes.documents.constructed import LiveFigure
from planes.documents.constructed._numbers import RADIAN, literal
from planes.drafting import steps as s
from planes.drafting.steps import crossings as c
from planes.drafting.steps import reckoning as r
from planes.drafting.steps.laws import ByStroke
from planes.words.names import POLE, at, plan_of
from render.files.ggb import HIDDEN, PALE, Aspect, GeogebraFile

STILL = "1E-12"  # of the largest vector: below this it is zero
NOTHING_MM = "1E-12"  # marks closer than this have no direction: nothing is laid off along it
Labels = dict[str, str]
LINE = Aspect(PALE, thick=2, dashed=True)
RIGHT = "90 * pi / 180"


class Translator:
    """Writes one step after another into a construction; ``left`` are those that stay numbers."""

    def __init__(self, figure: LiveFigure, made: GeogebraFile, labels: Labels, looks: Callable[[str], Aspect]) -> None:
        self.figure, self.made, self.labels, self.looks = figure, made, labels, looks
        self.left: list[s.Step] = []

    def of(self, step: s.Step) -> None:
        """One step."""
        if not (self.mark(step) or self.crossing(step) or self.ray(step) or self.value(step)):
            self.left.append(step)
            self.stands(step)

    def stands(self, step: s.Step) -> None:
        """A step as a constant, with its value in this position."""
        label, thing = self.labels[step.makes], complex(self.figure.position.drawing[step.makes])
        both = f"({literal(thing.real)}, {literal(thing.imag)})"
        if step.kind == "mark":
            self.made.formula("point", label, f"{self.pole(step.makes)} + {both}", self.looks(step.makes))
        else:
            kind, text = ("vector", both) if step.kind == "direction" else ("numeric", literal(thing.real))
            self.made.formula(kind, label, text)  # type: ignore[arg-type]

    def pole(self, mark: str) -> str:
        """The pole of a mark's plan, "(0, 0)" where it has none."""
        return self.labels.get(at(plan_of(mark), POLE), "(0, 0)")

    def mark(self, step: s.Step) -> bool:
        """A point; returns whether it can be constructed."""
        n, label, look = self.labels, self.labels[step.makes], self.looks(step.makes)
        match step:
            case s.Put() if step.at:
                text = f"({n[step.at + '.x']} * {n[str(step.mu)]}, {n[step.at + '.y']} * {n[str(step.mu)]})"
                self.made.formula("point", label, f"{self.pole(step.makes)} + {text}", look)
            case s.Put():
                pole = self.figure.poles[plan_of(step.makes)]
                self.made.formula("point", label, f"({literal(pole.real)}, {literal(pole.imag)})", look)
            case s.LayOff():
                way = f"({n[step.length]} * {n[step.mu]}) * {n[step.along]}"
                self.made.command("point", [label], "Translate", [n[step.start], way], look)
            case s.Carry():
                self.turned(label, n[step.start], f"Vector[{n[step.first]}, {n[step.second]}]", step.quarter, look)
            case s.Same():
                self.made.formula("point", label, f"{n[step.of]} + (0, 0)", look)
            case s.Similar():
                x, y = n[step.ratio + ".x"], n[step.ratio + ".y"]
                self.similar(label, n[step.start], n[step.end], (f"sqrt({x}^2 + {y}^2)", f"atan2({y}, {x})"), look)
            case s.Image():
                (a, b), (p, q), (d, e) = ([n[m] for m in ends] for ends in (step.of, step.like, step.image))
                self.made.command("point", [f"t1{label}"], "Translate", [n[step.start], f"Vector[{a}, {b}]"])
                like, image = f"({q} - {p})", f"({e} - {d})"
                times = f"Distance[{d}, {e}] / Distance[{p}, {q}]"
                turn = f"atan2({like} ⊗ {image}, {like} * {image})"
                self.similar(label, n[step.start], f"t1{label}", (times, turn), look)
            case r.Choose():
                self.made.formula("point", label, self.chosen(step), look)
            case _:
                return False
        return True

    def crossing(self, step: s.Step) -> bool:
        """A point where lines or arcs meet; returns whether the step is of this kind."""
        n, label, look = self.labels, self.labels[step.makes], self.looks(step.makes)
        match step:
            case c.Cross():
                lines = (
                    self.line(step.makes, 0, step.start, step.along),
                    self.line(step.makes, 1, step.other, step.across),
                )
                self.made.command("point", [label], "Intersect", lines, look)
            case c.CrossArc():
                line = self.line(step.makes, 0, step.start, step.along)
                arc = self.arc(label, 1, step.centre, step.radius, step.mu)
                ahead = f"{n[step.side]} * ((i1{label} - {n[step.centre]}) * {n[step.along]})"
                self.one_of(label, [line, arc], ahead, look)
            case c.CrossArcs():
                arcs = [
                    self.arc(label, 1, step.centre, step.radius, step.mu),
                    self.arc(label, 2, step.other, step.other_radius, step.mu),
                ]
                centre = n[step.centre]
                left = f"{n[step.side]} * (({n[step.other]} - {centre}) ⊗ (i1{label} - {centre}))"
                self.one_of(label, arcs, left, look)
            case _:
                return False
        return True

    def line(self, makes: str, number: int, start: str, along: str) -> str:
        """A line through a mark along a direction."""
        label = f"g{number}{self.labels[makes]}"
        shown = LINE if makes in self.figure.marks else HIDDEN
        self.made.command("line", [label], "Line", [self.labels[start], self.labels[along]], shown)
        return label

    def arc(self, label: str, number: int, centre: str, radius: str, mu: str) -> str:
        """A circle about a mark."""
        reach = f"abs({self.labels[radius]} * {self.labels[mu]})"
        self.made.command("conic", [f"k{number}{label}"], "Circle", [self.labels[centre], reach], LINE)
        return f"k{number}{label}"

    def one_of(self, label: str, met: list[str], side: str, look: Aspect) -> None:
        """The one of two intersections on the chosen side, in whichever order they are found."""
        both = [f"i1{label}", f"i2{label}"]
        for k, one in enumerate(both, 1):
            self.made.command("point", [one], "Intersect", [*met, str(k)])
        self.made.command("point", [label], "If", [f"{side} >= 0", *both], look)

    def turned(self, label: str, start: str, way: str, quarter: int, look: Aspect) -> None:
        """A mark at a vector from another, turned by right angles."""
        moved = f"t1{label}" if quarter % 4 else label
        self.made.command("point", [moved], "Translate", [start, way], HIDDEN if quarter % 4 else look)
        if quarter % 4:
            self.made.command("point", [label], "Rotate", [moved, f"{quarter % 4} * {RIGHT}", start], look)

    def similar(self, label: str, start: str, end: str, ratio: tuple[str, str], look: Aspect) -> None:
        """A mark in a given ratio to two others: dilated and rotated."""
        self.made.command("point", [f"t2{label}"], "Dilate", [end, ratio[0], start])
        self.made.command("point", [label], "Rotate", [f"t2{label}", ratio[1], start], look)

    def chosen(self, step: r.Choose) -> str:
        """The trial whose assumptions hold."""
        text = ""
        for trial in reversed(step.trials):
            signs = zip(trial.pushes, trial.signs, strict=True)
            holds = " && ".join(f"{sign} * {self.labels[push]} >= -1E-9" for push, sign in signs)
            text = f"If[{holds}, {self.labels[trial.mark]}{', ' + text if text else ''}]"
        return text

    def ray(self, step: s.Step) -> bool:
        """A unit vector; returns whether it can be constructed."""
        n, label, put = self.labels, self.labels[step.makes], self.made.command
        match step:
            case s.Aim():
                turn = f"{n[step.angle]} * {RADIAN}"
                self.made.formula("vector", label, f"(cos({turn}), sin({turn}))")
            case s.Through():
                start, end = n[step.start], n[step.end]
                put("vector", [f"t1{label}"], "Vector", [start, end])
                self.made.formula("vector", label, f"t1{label} / Max[Distance[{start}, {end}], {NOTHING_MM}]")
            case s.Turn():
                turns = [f"{step.quarter % 4} * {RIGHT}"] * bool(step.quarter % 4)
                turns += [f"{n[step.angle]} * {RADIAN}"] if step.angle else []
                put("vector", [label], "Rotate", [n[step.of], " + ".join(turns) or "0"])
            case c.Touch():
                put("vector", [f"t1{label}"], "Vector", [n[step.start], n[step.end]])
                put("vector", [f"t2{label}"], "UnitVector", [f"t1{label}"])
                apart = f"Distance[{n[step.start]}, {n[step.end]}]"
                sine = f"({n[step.offset]} * {n[step.mu]} / {apart})" if step.offset else "0"
                ahead = f"({n[step.side]} * sqrt(1 - {sine}^2)) * t2{label}"
                self.made.formula("vector", label, f"{ahead} - {sine} * Rotate[t2{label}, {RIGHT}]")
            case r.Lean():
                leant = f"{n[step.coefficient]} * {n[step.sliding]} * {literal(step.push)}"
                self.made.formula("vector", f"t1{label}", f"{n[step.normal]} - ({leant}) * {n[step.along]}")
                put("vector", [label], "UnitVector", [f"t1{label}"])
            case _:
                return False
        return True

    def value(self, step: s.Step) -> bool:
        """A number; returns whether there is a formula for it."""
        text = self.number(step)
        if text:
            self.made.formula("numeric", self.labels[step.makes], text)
        return bool(text)

    def number(self, step: s.Step) -> str:
        """The formula of a number, "" if there is none."""
        n = self.labels
        match step:
            case r.Measure():
                return f"{self.length(step)} / {n[step.mu]}"
            case r.Drop():
                return f"(({n[step.point]} - {n[step.about]}) ⊗ {n[step.along]}) / {n[step.mu]}"
            case r.Protractor():
                return f"atan2((1, 0) ⊗ {n[step.of]}, (1, 0) * {n[step.of]}) * 180 / pi"
            case r.Cosine():
                return f"{n[step.of]} * {n[step.along]}"
            case r.Calculate():
                return " + ".join(self.product(term) for term in step.terms) or "0"
            case r.Sense():
                size = self.length(step)
                beside = [f"Distance[{self.pole(m)}, {n[m]}]" for m in step.beside]
                return f"If[abs({size}) > {STILL} * ({' + '.join(beside) or '0'}), sgn({size}), 0]"
            case r.SenseOf():
                return f"sgn({n[step.value]})"
            case r.SizeOf():
                return f"abs({n[step.value]})"
            case r.SenseBetween():
                one, two = (f"({n[rate]} * abs({n[sense]}))" if rate else "0" for rate, sense in step.both)
                return f"If[abs({one} - {two}) > {STILL} * (abs({one}) + abs({two})), sgn({one} - {two}), 0]"
            case ByStroke():
                way = f"({literal(step.sense)} * {n[step.stroke]})"
                working, idle = f"{n[step.working]} * (abs({way}) + {way})", f"{n[step.idle]} * (abs({way}) - {way})"
                return f"({working} + {idle}) / 2"
        return ""

    def length(self, step: r.Measure | r.Sense) -> str:
        """The distance between two marks, or its component along a direction."""
        start, end = self.labels[step.start], self.labels[step.end]
        return f"(({end} - {start}) * {self.labels[step.along]})" if step.along else f"Distance[{start}, {end}]"

    def product(self, term: r.Product) -> str:
        """One product of powers."""
        factors = (self.labels[name] + (f"^({power})" if power != 1 else "") for name, power in term.factors)
        return " * ".join([literal(float(term.coefficient)), *factors])
