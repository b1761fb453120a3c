"""A plan of rates or forces as marks: arrows, lines of action, traces of similarity and the names of all."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property

from planes.drafting.equations import Term
from planes.drafting.steps import Carry, Image, Similar
from planes.drafting.steps.crossings import Cross
from planes.plans.scales import ZERO_MM
from planes.words import say
from planes.words.names import POLE, at, label_of, plan_of
from planes.words.naming import Naming
from planes.words.read_off import measured
from planes.words.units import UNIT, number
from render import labels
from render.labels.footprints import overprinted
from render.paper.marks import Arrow, Layer, Line, Mark, Text
from render.paper.symbols import dot
from render.paper.typeset import plain
from render.views import detail, remark
from render.views.hatching import hatched
from render.views.plotted import Ends, Plotted, set_apart
from render.views.senses import parted

NOTHING_MM = 1e-10  # a vector shorter than this is none
SAME_MM = 0.35  # marks closer than this share one label
BEYOND_MM = 7.0  # how far a line of action runs past the crossing
ALONE_MM = 12.0  # half of a line of action on which the vector vanished
ASIDE_MM = 2.0  # between vectors of one line
TOUCH_MM = 0.5  # how near they may come where they slant but slightly
MARK_MM = 5.0
VALUE = "value"  # in the names of labels with one
FORCE_MM = 3.5


@dataclass
class Polygon:
    """One plan being drawn: every vector once, though several names may stand for it."""

    plotted: Plotted
    plan: str
    naming: Naming
    arrows: dict[tuple[str, str], list[str]] = field(default_factory=dict)
    marks: list[Mark] = field(default_factory=list)
    places: dict[tuple[str, str], Ends] = field(default_factory=dict)
    triangles: list[tuple[complex, complex, complex]] = field(default_factory=list)
    shifted: bool = False
    counted: dict[tuple[str, float], int] = field(default_factory=dict)  # details of plans at their μ
    valued: bool = False  # whether vectors have their values beside them

    @property
    def of_rates(self) -> bool:
        """Whether its marks are lettered (velocities, accelerations) rather than its vectors named (forces)."""
        return self.plan in ("velocity", "acceleration")

    def mark(self, label: str) -> complex:
        """Where a mark stands, mm from the pole."""
        return self.plotted.mark(self.plan, label)

    def drawn(self) -> tuple[Mark, ...]:
        """All marks of the plan, its labels too."""
        self.collect()
        self.traces()
        self.lines_of_action()
        self.vectors()
        ground = (*self.marks, *(dot(self.mark(POLE), 0.7, "plan") if self.of_rates else ()))
        named = self.mark_labels() if self.of_rates else self.vector_labels()
        details = detail.details(self.places.values(), self.letters())
        circled = (*ground, *(d.circle() for d in details))
        strokes = hatched(self.triangles)
        inside = {x for d in details for x in d.alone(named) if x.at != self.mark(POLE)}
        outer = [x for x in named if x not in inside]
        outer += [d.named() for d in details]
        placed = labels.place(self.with_values(outer), circled, None, strokes)
        if self.valued and overprinted((*circled, *placed.marks)):
            placed = labels.place(outer, circled, None, strokes)
        marks = (*parted(strokes, placed.texts), *circled, *placed.marks)
        apart = {d: self.mark_labels(SAME_MM / d.times) if self.of_rates else named for d in details}
        marks = detail.beside(marks, [d.drawn(ground, apart[d], not self.of_rates) for d in details])
        self.shifted |= not self.of_rates and any(d.asides(ground) for d in details)
        for text in self.remarks(placed.texts):
            marks = (*marks, *remark(f"({text})", marks))
        return marks

    def remarks(self, texts: Iterable[Text]) -> Iterator[str]:
        """What must be known of the plan: that vectors are moved aside, and the unit of the values at them."""
        lang = self.naming.lang
        if self.shifted:
            yield say("shifted", lang)
        if any(t.name.startswith(VALUE) for t in texts):
            yield say("values_beside", lang, unit=say(UNIT[self.plotted.kind(self.plan)], lang))

    def letters(self) -> list[str]:
        """Letters for the details of this plan, after those of the plans before it."""
        plans = list(dict.fromkeys(s.plan for s in self.plotted.segments if s.plan not in ("lever", "motion")))
        used = sum(map(self.details_of, plans[: plans.index(self.plan)] if self.plan in plans else ()))
        taken = map(label_of, self.plotted.drawing.things)
        return detail.letters(taken, say("detail_letters", self.naming.lang))[used:]

    def details_of(self, plan: str) -> int:
        """How many details another plan of this drawing has."""
        key = plan, self.plotted.mu(plan)
        if key not in self.counted:
            other = Polygon(self.plotted, plan, self.naming)
            other.collect()
            other.vectors()
            self.counted[key] = len(detail.groups_of(other.places.values()))
        return self.counted[key]

    def collect(self) -> None:
        """Every measured segment by its ends."""
        for s in self.plotted.drawn_segments(self.plan):
            if abs(self.mark(s.end) - self.mark(s.start)) > ZERO_MM:
                names = self.arrows.setdefault((s.start, s.end), [])
                names += [s.name] * (s.name not in names)

    def unseen(self, title: str) -> list[str]:
        """A sentence about the vectors that are too short to be drawn, if there are any."""
        drawn = self.plotted.drawn_segments(self.plan)
        sizes = {s.name: abs(self.mark(s.end) - self.mark(s.start)) for s in drawn}
        names = [plain(self.naming.vector(n)) for n, size in sizes.items() if NOTHING_MM < size <= ZERO_MM]
        told = {"view": plain(title), "names": ", ".join(names), "least": number(ZERO_MM, self.naming.lang)}
        return [say("too_short", self.naming.lang, **told)] if names else []

    def terms(self) -> Iterable[Term]:
        """The terms of this plan's equations whose ends are drawn."""
        for equation in self.plotted.equations:
            if equation.plan == self.plan:
                yield from (t for t in equation.terms if self.plotted.has(self.plan, t.start, t.end))

    @cached_property
    def given(self) -> set[str]:
        """The vectors this plan was begun with."""
        return {term.name for term in self.terms() if term.known == 2}

    def lines_of_action(self) -> None:
        """Thin lines of the terms known in direction only, a little past the crossing they were drawn for."""
        for term in self.terms():
            if term.known != 1 or not term.direction:
                continue
            start, end = self.mark(term.start), self.mark(term.end)
            way, along = end - start, ALONE_MM * complex(self.plotted.drawing[term.direction])
            ends = (start, end + BEYOND_MM * way / abs(way)) if abs(way) > ZERO_MM else (end - along, end + along)
            self.marks.append(Line(ends, "construction", "construction"))

    def traces(self) -> None:
        """The sides of the similar triangles by which points of links were found."""
        for step in self.plotted.drawing.program.steps:
            if plan_of(step.makes) != self.plan:
                continue
            if step.quantity == "false" and isinstance(step, (Carry, Cross)):
                for mark in (step.start,) if isinstance(step, Carry) else (step.start, step.other):
                    self.trace(self.mark(label_of(mark)), self.mark(label_of(step.makes)))
            if not isinstance(step, (Similar, Image)):
                continue
            base = (step.start, step.end) if isinstance(step, Similar) else step.image
            if step.start not in base:  # laid off from a mark of its own: there is no triangle on the base
                self.trace(self.mark(label_of(step.start)), self.mark(label_of(step.makes)))
                continue
            corners = [label_of(base[0]), label_of(step.makes), label_of(base[1])]
            a, x, b = map(self.mark, corners)
            flat = abs(b - a) < ZERO_MM or abs(((x - a) / (b - a)).imag) * abs(b - a) < ZERO_MM
            sides = [(a, b)] * (tuple(corners[::2]) not in self.arrows) + [(a, x), (x, b)] * (not flat)
            for side in sides:
                self.trace(*side)
            if not flat and step.quantity != "false":
                self.triangles.append((a, x, b))

    def trace(self, start: complex, end: complex) -> None:
        """A construction line."""
        if abs(end - start) > ZERO_MM:
            self.marks.append(Line((start, end), "thin", "construction"))

    def vectors(self) -> None:
        """The arrows: results thick, what they are made of thinner; forces of one line side by side."""
        for (start, end), names in sorted(self.arrows.items(), key=lambda item: not self.is_result(*item)):
            ends, thick = (self.mark(start), self.mark(end)), self.is_result((start, end), names)
            placed = ends if self.of_rates else set_apart(ends, self.places.values(), ASIDE_MM, ASIDE_MM / 2, TOUCH_MM)
            self.shifted |= placed != ends
            self.places[start, end] = placed
            layer: Layer = "result" if thick else "plan" if self.of_rates else "force"
            tail, tip = placed
            self.marks.append(Arrow(tail, tip, "result" if thick else "vector", layer, names[0]))

    def is_result(self, ends: tuple[str, str], names: list[str]) -> bool:
        """Whole vectors from the pole, and whole forces that were found here."""
        if not self.of_rates:
            return any("^" not in name and name not in self.given for name in names)
        return ends[0] == POLE and at(self.plan, ends[1]) not in self.plotted.drawing.program.corners

    def vector_labels(self) -> list[labels.Label]:
        """Names beside their vectors; equal reactions share one label."""
        told = ((ends, names, " = ".join(map(self.naming.vector, names))) for ends, names in self.arrows.items())
        return [labels.Label(text, self.places[ends], FORCE_MM, name=names[0]) for ends, names, text in told]

    def with_values(self, named: Sequence[labels.Label]) -> list[labels.Label]:
        """The same labels with the values of vectors, if these are wanted: of forces after their names; of rates, whose
        ends are named, with names of their own, as far as there is room."""
        at = {self.places[ends]: (ends, names) for ends, names in self.arrows.items() if self.valued}
        told = {place: self.value(ends, names) for place, (ends, names) in at.items()}
        if self.of_rates:
            own = (labels.Label(text, place, FORCE_MM, name=VALUE, told=True) for place, text in told.items())
            return [*named, *own]
        return [replace(x, text=told[x.at], name=f"{VALUE} {x.name}") if x.at in told else x for x in named]

    def value(self, ends: tuple[str, str], names: Sequence[str]) -> str:
        """The names of a vector with its value."""
        size = abs(self.mark(ends[1]) - self.mark(ends[0])) / self.plotted.mu(self.plan)
        named = [*map(self.naming.vector, names), measured(size, self.naming.lang)]
        return (" = " if len(names) > 1 else " ").join(named)

    def mark_labels(self, same: float = SAME_MM) -> list[labels.Label]:
        """Letters of the marks; those that coincide share one label."""
        clusters = gathered([(label, self.mark(label)) for label in self.plotted.labels(self.plan)], same)
        centre = sum(z for z, _ in clusters) / len(clusters)
        found, prime = [], "'" if self.plan == "acceleration" else ""
        for z, names in clusters:
            fixed = [n + prime for n in self.plotted.fixed] if POLE in names else []
            text = ", ".join(dict.fromkeys(self.naming.mark(n, self.plan) for n in [*names, *fixed]))
            away = (z - centre) / abs(z - centre) if abs(z - centre) > ZERO_MM else 0
            found.append(labels.Label(text, z, MARK_MM, side=away, clear=0.7, priority=1, name=text))
        return found


def gathered(marks: Iterable[tuple[str, complex]], same: float = SAME_MM) -> list[tuple[complex, list[str]]]:
    """Names by their places; those that stand closer than ``same`` mm to one before share its place."""
    clusters: list[tuple[complex, list[str]]] = []
    for name, z in marks:
        near = next((names for place, names in clusters if abs(place - z) <= same), None)
        if near is None:
            clusters.append((z, near := []))
        near.append(name)
    return clusters
