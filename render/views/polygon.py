"""A velocity, acceleration or force plan as marks: arrows, lines of action, traces of similarity and all names."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations

from planes.drafting.equations import Term
from planes.geometry.plane import direction_between, perpendicular_foot
from planes.plans.scales import ZERO_VECTOR_MM
from planes.words import say
from planes.words.names import POLE_LABEL, NamePair, PlanId, label_of
from planes.words.naming import Naming
from planes.words.read_off import read_off_text
from planes.words.units import number_text
from render import labels
from render.labels import Label
from render.labels.footprints import overprinted_labels
from render.paper.marks import Arrow, Layer, Line, Mark
from render.paper.symbols import Marks, dot
from render.paper.typeset import plain_text
from render.views import detail, remark_texts
from render.views.hatching import hatch_triangles
from render.views.plotted import (
    SHARED_LABEL_MM,
    Clusters,
    Ends,
    Plotted,
    group_names_by_place,
    length_of,
    shift_clear_of_others,
)
from render.views.senses import break_lines_at_texts
from render.views.strings import string_and_ray_lines
from render.views.traces import construction_traces

LEAST_DRAWN_VECTOR_MM = 1e-10  # a shorter vector is not drawn
LINE_OF_ACTION_OVERRUN_MM = 7.0  # how far a line of action extends past the crossing
HALF_LONE_LINE_LENGTH_MM = 12.0  # half the length of a line of action whose vector vanished
FORCE_SUM_SHIFT_MM = 2.0  # distance of a sum of forces from the forces it overlaps
TICK_END_RATIOS = 0.3, 0.8  # of the way there
LEAST_INCLINED_DISTANCE_MM = 0.5  # least distance where they are slightly inclined
MARK_LETTER_MM = 5.0
END_NUMBER_LETTER_MM = 2.5  # numbers of ends
VALUE_NAME_PREFIX = "value"  # part of the names of labels with one
FORCE_LETTER_MM = 3.5


@dataclass
class Polygon:
    """One plan being drawn: every vector once, even with several names.

    Forces are head to tail. Those that overlap are recognised by their numbered ends; only a sum of them is drawn
    ``aside``, with ticks to its ends.
    """

    plotted: Plotted
    plan: PlanId
    naming: Naming
    arrows: dict[NamePair, list[str]] = field(default_factory=dict)
    marks: list[Mark] = field(default_factory=list)
    places: dict[NamePair, Ends] = field(default_factory=dict)
    aside: list[Mark] = field(default_factory=list)
    counted: dict[tuple[str, float], int] = field(default_factory=dict)  # details of plans at their μ
    valued: bool = False  # whether vectors have their values beside them

    @property
    def is_rate_plan(self) -> bool:
        """Whether its marks are lettered (velocities, accelerations) rather than its vectors named (forces)."""
        return self.plan in ("velocity", "acceleration")

    def mark(self, label: str) -> complex:
        """The place of a mark, mm from the pole."""
        return self.plotted.mark(self.plan, label)

    def drawn_marks(self) -> Marks:
        """All marks of the plan, including its labels."""
        self.collect_vectors()
        lines, triangles = construction_traces(self.plotted, self.plan, self.arrows)
        self.marks += lines
        self.draw_lines_of_action()
        self.draw_vectors()
        sides = self.friction_sides()
        self.marks += (Arrow(*ends, "vector", "force", name) for name, ends in sides.items())
        rays, lettered = string_and_ray_lines(self.plotted.drawing, self.plotted.figure, self.plan)
        self.marks += rays
        ground = (*self.marks, *dot(self.mark(POLE_LABEL), 0.7, "plan"))
        details = detail.make_details(self.places.values(), self.free_detail_letters(), self.is_rate_plan)
        lettered += [
            Label(self.naming.lettered_vector(name), ends, FORCE_LETTER_MM, name=name) for name, ends in sides.items()
        ]
        named = [*self.name_labels(details), *lettered]
        circled = (*ground, *self.aside, *(d.circle() for d in details))
        strokes = hatch_triangles(triangles)
        inside = {x for d in details for x in d.labels_only_in_detail(named) if x.at != self.mark(POLE_LABEL)}
        outer = [x for x in named if x not in inside]
        outer += [d.letter_label() for d in details]
        placed = labels.place_labels(self.labels_with_values(outer), circled, None, strokes)
        if self.valued and overprinted_labels((*circled, *placed.marks)):
            placed = labels.place_labels(outer, circled, None, strokes)
        marks = (*break_lines_at_texts(strokes, placed.texts), *circled, *placed.marks)
        marks = detail.put_details_beside_plan(
            marks, [d.detail_contents(ground, self.name_labels(details, d.times)) for d in details]
        )
        if any(t.name.startswith(VALUE_NAME_PREFIX) for t in placed.texts):
            lang = self.naming.lang
            text = say("values_beside", lang, unit=say(self.plan.unit, lang))
            marks = (*marks, *remark_texts(f"({text})", marks))
        return marks

    def free_detail_letters(self) -> list[str]:
        """Letters for the details of this plan, after those of the plans before it."""
        plans = list(dict.fromkeys(s.plan for s in self.plotted.segments if s.plan not in ("lever", "motion")))
        used = sum(map(self.detail_count, plans[: plans.index(self.plan)] if self.plan in plans else ()))
        taken = map(label_of, self.plotted.drawing.things)
        return detail.free_detail_letters(taken, say("detail_letters", self.naming.lang))[used:]

    def detail_count(self, plan: PlanId) -> int:
        """The number of details in another plan of this drawing."""
        key = plan, self.plotted.plan_mu(plan)
        if key not in self.counted:
            other = Polygon(self.plotted, plan, self.naming)
            other.collect_vectors()
            other.draw_vectors()
            self.counted[key] = len(detail.group_short_vectors(other.places.values(), other.is_rate_plan))
        return self.counted[key]

    def collect_vectors(self) -> None:
        """Every measured segment by its ends."""
        rays = self.plotted.figure.poles if self.plotted.figure else ()
        for s in self.plotted.drawn_segments(self.plan):
            if s.ends[0] not in rays and self.plotted.vector_length_mm(self.plan, s) > ZERO_VECTOR_MM:
                names = self.arrows.setdefault((s.start, s.end), [])
                name = self.naming.own_vector_name(s.name)
                names += [name] * (name not in names)

    def too_short_remarks(self, title: str) -> list[str]:
        """A sentence about the vectors that are too short to be drawn, if there are any."""
        drawn = self.plotted.drawn_segments(self.plan)
        sizes = {s.name: self.plotted.vector_length_mm(self.plan, s) for s in drawn}
        names = [
            plain_text(self.naming.lettered_vector(n))
            for n, size in sizes.items()
            if LEAST_DRAWN_VECTOR_MM < size <= ZERO_VECTOR_MM
        ]
        facts = {
            "view": plain_text(title),
            "names": ", ".join(names),
            "least": number_text(ZERO_VECTOR_MM, self.naming.lang),
        }
        return [say("too_short", self.naming.lang, **facts)] if names else []

    def drawn_terms(self) -> Iterable[Term]:
        """The terms of this plan's equations with drawn ends."""
        for equation in self.plotted.equations:
            if equation.plan == self.plan:
                yield from (t for t in equation.all_terms if self.plotted.has_marks(self.plan, t.start, t.end))

    @cached_property
    def given_vector_names(self) -> set[str]:
        """The vectors at the start of this plan."""
        return {term.name for term in self.drawn_terms() if term.known_part_count == 2}

    def draw_lines_of_action(self) -> None:
        """Thin lines of the terms known in direction only, slightly past the crossing."""
        for term in self.drawn_terms():
            if term.known_part_count != 1 or not term.direction:
                continue
            start, end = self.plotted.vector_ends(self.plan, term)
            way = end - start
            along = HALF_LONE_LINE_LENGTH_MM * complex(self.plotted.drawing[term.direction])
            ends = (
                (start, end + LINE_OF_ACTION_OVERRUN_MM * way / abs(way))
                if abs(way) > ZERO_VECTOR_MM
                else (end - along, end + along)
            )
            self.marks.append(Line(ends, "construction", "construction"))

    def draw_vectors(self) -> None:
        """The arrows: results thick, their components thinner; sums of forces beside the forces they overlap."""
        terms = {ends for t in self.drawn_terms() for ends in ((t.start, t.end), (t.end, t.start))}
        order = sorted(self.arrows.items(), key=lambda item: (item[0] not in terms, not self.is_result(*item)))
        for (start, end), names in order:
            ends = (self.mark(start), self.mark(end))
            thick = self.is_result((start, end), names)
            moves = not self.is_rate_plan and (start, end) not in terms
            placed = ends
            if moves and length_of(ends) >= detail.LEAST_READABLE_VECTOR_MM:
                placed = shift_clear_of_others(
                    ends,
                    self.places.values(),
                    FORCE_SUM_SHIFT_MM,
                    detail.COINCIDENT_LINES_MM,
                    LEAST_INCLINED_DISTANCE_MM,
                )
            self.places[start, end] = placed
            layer: Layer = "result" if thick else "plan" if self.is_rate_plan else "force"
            arrow = Arrow(*placed, "result" if thick else "vector", layer, names[0])
            if placed == ends:
                self.marks.append(arrow)
            else:
                ticks = (Line(tick_ends(*two), "thin", "construction") for two in zip(ends, placed, strict=True))
                self.aside += (*ticks, arrow)

    def friction_sides(self) -> dict[str, Ends]:
        """The normal force and the friction of each leaning reaction, as the sides of a right triangle upon it."""
        sides = dict[str, Ends]()
        for r in self.plotted.leaning:
            start = r.start.label
            end = r.end.label
            if r.plan == self.plan and self.plotted.has_marks(self.plan, start, end):
                a = self.mark(start)
                b = self.mark(end)
                along = complex(self.plotted.drawing[f"∥{r.pair.guide}"])
                corner = perpendicular_foot(a, b, along)
                if abs(corner - a) > detail.LEAST_READABLE_VECTOR_MM < abs(b - corner):
                    sides |= {f"N_{r.index}": (a, corner), f"T_{r.index}": (corner, b)}
        return sides

    def is_result(self, ends: NamePair, names: list[str]) -> bool:
        """Whole vectors from the pole, and whole forces that were found here."""
        if not self.is_rate_plan:
            return any("^" not in name and name not in self.given_vector_names for name in names)
        return ends[0] == POLE_LABEL and self.plan.mark(ends[1]) not in self.plotted.drawing.program.component_end_marks

    def name_labels(self, details: Sequence[detail.Detail] = (), times: float = 1.0) -> list[Label]:
        """The names of marks or vectors, in their places on a plan enlarged by a factor."""
        if self.is_rate_plan:
            return self.mark_labels(SHARED_LABEL_MM / times)
        places = self.overlapping_ends(details)
        numbers = {corner: k for k, (_, corners) in enumerate(places, 1) for corner in corners}
        pole = (
            [(self.naming.mark(POLE_LABEL, self.plan), self.mark(POLE_LABEL))]
            if self.plotted.has_marks(self.plan, POLE_LABEL)
            else []
        )
        ends = group_names_by_place(
            [*pole, *((str(k), z) for k, (z, _) in enumerate(places, 1))], SHARED_LABEL_MM / times
        )
        named_labels = [Label(", ".join(n), z, END_NUMBER_LETTER_MM, clear=0.4, name=f"end {n[0]}") for z, n in ends]
        for k, ((start, end), names) in enumerate(self.arrows.items()):
            back = self.arrows.get((end, start), [])
            if back and (end, start) in [*self.arrows][:k]:
                continue  # it is named with the opposite one
            text = " = ".join(map(self.naming.lettered_vector, names))
            text += f" ({numbers[start]}–{numbers[end]})" if {start, end} <= numbers.keys() else ""
            text += "".join(f" = −{self.naming.lettered_vector(name)}" for name in back)
            named_labels.append(Label(text, self.places[start, end], FORCE_LETTER_MM, name=names[0]))
        return named_labels

    def overlapping_ends(self, details: Sequence[detail.Detail]) -> Clusters:
        """The ends of the vectors that overlap here or in a detail, along the polygon."""
        standing = {(a, b): (self.mark(a), self.mark(b)) for a, b in self.arrows}
        standing = {key: ends for key, ends in standing.items() if self.places[key] == ends}
        lying = {
            key
            for two in combinations(standing, 2)
            if detail.look_like_one_line(standing[two[0]], standing[two[1]], details)
            for key in two
        }
        lying |= {key[::-1] for key in lying}
        terms = [(t.start, t.end) for t in self.drawn_terms()]
        corners = dict.fromkeys(z for key in (*terms, *standing) if key in lying for z in key)
        return group_names_by_place([(corner, self.mark(corner)) for corner in corners], ZERO_VECTOR_MM)

    def labels_with_values(self, named: Sequence[Label]) -> list[Label]:
        """The same labels with the values of vectors, if requested: of forces after their names; of velocities and
        accelerations, whose ends are named, as separate names, as far as there is room."""
        at = {self.places[ends]: names for ends, names in self.arrows.items() if self.valued}
        if self.is_rate_plan:
            texts = ((place, " = ".join(map(self.naming.lettered_vector, names))) for place, names in at.items())
            own = [Label(text, place, FORCE_LETTER_MM, name=VALUE_NAME_PREFIX, told=True) for place, text in texts]
            return [*named, *map(self.label_with_value, own)]
        return [
            replace(self.label_with_value(x), name=f"{VALUE_NAME_PREFIX} {x.name}") if x.at in at else x for x in named
        ]

    def label_with_value(self, label: Label) -> Label:
        """The label of a vector with its value."""
        assert isinstance(label.at, tuple)
        size = length_of(label.at) / self.plotted.plan_mu(self.plan)
        sign = " = " if " = " in label.text else " "
        return replace(label, text=f"{label.text}{sign}{read_off_text(size, self.naming.lang)}")

    def mark_labels(self, same: float = SHARED_LABEL_MM) -> list[Label]:
        """Letters of the marks; coinciding ones share one label."""
        clusters = group_names_by_place(
            [(label, self.mark(label)) for label in self.plotted.mark_labels(self.plan)], same
        )
        centre = sum(z for z, _ in clusters) / len(clusters)
        letters = []
        prime = "'" if self.plan == "acceleration" else ""
        for z, names in clusters:
            fixed = [n + prime for n in self.plotted.fixed] if POLE_LABEL in names else []
            text = ", ".join(dict.fromkeys(self.naming.mark(n, self.plan) for n in [*names, *fixed]))
            away = direction_between(centre, z) if abs(z - centre) > ZERO_VECTOR_MM else 0
            letters.append(Label(text, z, MARK_LETTER_MM, side=away, clear=0.7, priority=1, name=text))
        return letters


def tick_ends(start: complex, end: complex) -> Ends:
    """A tick between an end of a sum's forces and its own, without touching either: it is not a vector."""
    return start + TICK_END_RATIOS[0] * (end - start), start + TICK_END_RATIOS[1] * (end - start)
