"""The input of views: plans of a mechanism or of vectors, and the places of its parts on the scheme."""

import cmath
import math
from collections import defaultdict
from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from itertools import pairwise
from typing import Any

import shapely

from planes.drafting.draft import Segment
from planes.drafting.drawing import Drawing
from planes.drafting.equations import Equation, Term
from planes.geometry.plane import bounding_corners, direction_between, perpendicular_foot
from planes.plans.apart import LinkApart, links_with_own_polygon
from planes.plans.force.reactions import Reaction
from planes.plans.structures.figure import StaticsFigure
from planes.scene.mechanism import Link, Mechanism
from planes.solving import Position
from planes.words.frozen import frozen, replace
from planes.words.names import SCHEME_PLAN, NameTuple, NumbersByName, PlanId, scheme_mark

Ends = tuple[complex, complex]
Clusters = list[tuple[complex, list[Any]]]  # places with the names there


@frozen
class Plotted:
    """One drawing: ``scales`` are mm per SI unit, ``fixed`` the labels of points of the frame (they are in poles)."""

    drawing: Drawing
    segments: tuple[Segment, ...]
    equations: tuple[Equation, ...]
    scales: NumbersByName
    fixed: NameTuple = ()
    figure: StaticsFigure | None = None
    leaning: tuple[Reaction, ...] = ()  # of guides with friction

    def mark(self, plan: PlanId, label: str) -> complex:
        """The place of a mark, mm from the pole of its plan."""
        return complex(self.drawing[plan.mark(label)])

    def vector_ends(self, plan: PlanId, vector: Segment | Term) -> Ends:
        """The places of both ends of a vector."""
        return self.mark(plan, vector.start), self.mark(plan, vector.end)

    def vector_length_mm(self, plan: PlanId, vector: Segment | Term) -> float:
        """The length of a vector, mm."""
        start, end = self.vector_ends(plan, vector)
        return abs(end - start)

    def has_marks(self, plan: PlanId, *labels: str) -> bool:
        """Whether all these marks are drawn (a sliced program draws only the requested ones)."""
        return all(plan.mark(label) in self.drawing for label in labels)

    def mark_labels(self, plan: PlanId) -> list[str]:
        """Labels of all marks of a plan in drawing order, without auxiliary ones."""
        return [s.label for s in self.drawing.program.mark_steps_on(plan) if not s.is_outside_plan]

    def drawn_segments(self, plan: PlanId) -> list[Segment]:
        """The drawn segments of a plan."""
        return [
            s for s in self.segments if s.plan == plan and s.start != s.end and self.has_marks(plan, s.start, s.end)
        ]

    def plan_mu(self, plan: PlanId) -> float:
        """μ of a plan, mm per SI unit."""
        return self.scales[plan.mu_name]

    def has_only_pole(self, plan: PlanId) -> bool:
        """Whether every mark of the plan is at its pole: there is nothing to draw."""
        ends = self.mark_labels(plan) or [s.end for s in self.drawn_segments(plan)]
        return all(abs(self.mark(plan, label)) < 1e-6 for label in ends)


def plot_position(p: Position) -> Plotted:
    """The plans of a mechanism in one position."""
    m = p.plans.mechanism
    shared = tuple(n.lower() for n in m.frame.points if any(n in link.points for link in m.links.values()))
    leaning = tuple(r for r in p.plans.reactions.values() if r.leans)
    return Plotted(p.drawing, p.plans.segments, p.plans.equations, p.scales, shared, p.plans.figure, leaning)


def plot_with_single_links(p: Position) -> tuple[Plotted, dict[PlanId, list[LinkApart]]]:
    """The same with the plans of single links; and these links by the plan of their group."""
    plotted = plot_position(p)
    plans = {plan: [*links_with_own_polygon(p.plans, plan)] for plan in p.plans.plan_names}
    things = dict(p.drawing.things)
    scales = dict(p.scales)
    segments = [*plotted.segments]
    equations = [*plotted.equations]
    for one in (x for links in plans.values() for x in links):
        if marks := one.vector_end_marks(p.plans, p.drawing):
            things |= {one.plan.mark(label): z for label, z in marks.items()}
            scales[one.plan.mu_name] = p.scales[one.group.mu_name]
            segments += [Segment(one.plan, t.start, t.end, t.name) for t in one.equation.all_terms]
            equations.append(one.equation)
    drawing = replace(p.drawing, things=things)
    return replace(plotted, drawing=drawing, segments=tuple(segments), equations=tuple(equations), scales=scales), plans


def scheme_mu(position: Position) -> float:
    """The scale of the scheme, mm per metre."""
    return position.scales[SCHEME_PLAN.mu_name]


SAME_PLACE_MM = 0.4  # closer places are one
SHARED_LABEL_MM = 0.35  # closer marks share one label
MOST_OVERLAP_SLOPE = 0.06  # lines whose slopes differ by less overlap where they cross


@frozen
class Places:
    """The places of one position."""

    position: Position

    @property
    def mechanism(self) -> Mechanism:
        """The drawn mechanism."""
        return self.position.plans.mechanism

    @property
    def links(self) -> tuple[Link, ...]:
        """The moving links, including passive ones."""
        return *self.mechanism.links.values(), *self.position.plans.passive

    @cached_property
    def links_by_hinge(self) -> dict[str, list[str]]:
        """Points of more than one link, with those links: the hinges."""
        held = defaultdict(list)
        for link in (self.mechanism.frame, *self.links):
            for point in self.mechanism.points_without_guide_centre(link):
                held[point].append(link.name)
        return {point: owners for point, owners in held.items() if len(owners) > 1}

    def is_drawn(self, point: str) -> bool:
        """Whether the point is drawn."""
        return scheme_mark(point) in self.position.drawing

    def point_place(self, point: str) -> complex:
        """The place of a point."""
        return complex(self.position.drawing[scheme_mark(point)])

    def larger_box_side(self, links: Sequence[str]) -> float:
        """The larger side of the box around the points of some links."""
        drawn = [self.point_place(p) for name in links for p in self.mechanism.links[name].points if self.is_drawn(p)]
        low, high = bounding_corners(drawn or [0j])
        return max((high - low).real, (high - low).imag)

    def link_bars(self, name: str) -> list[Ends]:
        """The bars between a link's points, and from its hinge to a slider on its guide."""
        link = self.mechanism.links[name]
        joints = [
            self.point_place(p)
            for p in self.mechanism.points_without_guide_centre(link)
            if self.is_drawn(p) and (p in self.links_by_hinge or p != link.centre)
        ]
        joints += [
            self.foot_on_guide(x)[0] for x in (*self.sliders_on_guides(*link.guides), *([link] if link.slides else ()))
        ]
        outline = link_outline(joints)
        return list(pairwise((*outline, outline[0])))[: len(outline) if len(outline) > 2 else len(outline) - 1]

    def sliders_on_guides(self, *guides: str) -> Iterator[Link]:
        """The links that slide on some guides, if they are drawn."""
        links = self.mechanism.links.values()
        return (x for x in links if x.slides and x.slides.guide in guides and self.is_drawn(x.first_point))

    def guide_line(self, guide: str) -> tuple[complex, complex]:
        """A point of a guide's line and its direction."""
        given = self.mechanism.guide(guide)
        label = given.through_point or f"°{guide}"
        if f"∥{guide}" not in self.position.drawing:  # nothing that moves determines it
            return scheme_mu(self.position) * given.through, cmath.rect(1.0, math.radians(given.angle_deg))
        along = complex(self.position.drawing[f"∥{guide}"])
        if self.is_drawn(label):
            return self.point_place(label), along
        slider = next(x for x in self.mechanism.links.values() if x.slides and x.slides.guide == guide)
        offset = (slider.slides.offset if slider.slides else None) or 0.0
        return self.point_place(slider.first_point) - 1j * along * offset * scheme_mu(self.position), along

    def foot_on_guide(self, link: Link) -> tuple[complex, complex]:
        """The foot of the perpendicular from a slider's first point to its guide, and the guide's direction."""
        assert link.slides
        through, along = self.guide_line(link.slides.guide)
        return perpendicular_foot(self.point_place(link.first_point), through, along), along


def length_of(ends: Ends) -> float:
    """The length of a line."""
    return abs(ends[1] - ends[0])


def lines_overlap(one: Ends, other: Ends, near: float, touch: float = -1.0) -> bool:
    """Whether two lines run side by side for more than a millimetre within a given distance; or are slightly inclined,
    and come closer than ``touch`` mm."""
    way = direction_between(*other)
    a, b = sorted(((z - other[0]) * way.conjugate() for z in one), key=lambda w: w.real)
    low = max(a.real, 0.0)
    high = min(b.real, length_of(other))
    if high - low <= 1.0:
        return False
    slope = (b.imag - a.imag) / (b.real - a.real)
    apart = [a.imag + slope * (t - a.real) for t in (low, high)]
    least = min(map(abs, apart)) if apart[0] * apart[1] > 0 else 0.0
    return max(map(abs, apart)) <= near or (abs(slope) < MOST_OVERLAP_SLOPE and least < touch)


def shift_clear_of_others(ends: Ends, others: Iterable[Ends], step: float, near: float, touch: float = -1.0) -> Ends:
    """The ends of a vector, shifted sideways step by step where it would overlap others, or be ``near``
    them."""
    start, end = ends
    others = list(others)
    side = 1j * (end - start) / abs(end - start)
    if side.real < -1e-9 or (abs(side.real) <= 1e-9 and side.imag < 0):
        side = -side
    places = ((start + k * step * side, end + k * step * side) for k in (0, 1, -1, 2, -2, 3, -3, 4, -4, 5, -5))
    return next((two for two in places if not any(lines_overlap(two, other, near, touch) for other in others)), ends)


def direction_deg(along: complex) -> float:
    """The angle of a direction."""
    return round(math.degrees(cmath.phase(along)), 9)


def link_outline(places: list[complex]) -> list[complex]:
    """The corners of a link: one point, the ends of a bar, or the hull of a plate."""
    unique = list[complex]()
    for z in places:
        if all(abs(z - u) > SAME_PLACE_MM for u in unique):
            unique.append(z)
    if len(unique) < 3:
        return unique
    a, b = max(((p, q) for p in unique for q in unique), key=length_of)
    way = direction_between(a, b)
    if all(abs(((z - a) * way.conjugate()).imag) < SAME_PLACE_MM for z in unique):
        return [a, b]
    return polygon_corners(shapely.MultiPoint([(z.real, z.imag) for z in unique]).convex_hull)


def polygon_corners(area: shapely.Polygon) -> list[complex]:
    """The corners of an area, each once."""
    return [complex(x, y) for x, y in area.exterior.coords[:-1]]


def joint_stroke(places: list[complex]) -> list[complex]:
    """The ends of a bar, or the corners of a plate from joint to joint, without its longest side: one stroke."""
    corners = link_outline(places)
    if len(corners) < 3:
        return corners
    k = max(range(len(corners)), key=lambda k: abs(corners[k] - corners[k - 1]))
    return [*corners[k:], *corners[:k]]


def nearest_outline_point(z: complex, outline: list[complex]) -> complex:
    """The point of a link's outline nearest to a place."""
    corners = [(c.real, c.imag) for c in outline]
    shape = {1: shapely.Point, 2: shapely.LineString}.get(len(corners), shapely.Polygon)(corners)
    return complex(*shapely.shortest_line(shape, shapely.Point(z.real, z.imag)).coords[0])


def group_names_by_place(marks: Iterable[tuple[str, complex]], same: float = SHARED_LABEL_MM) -> Clusters:
    """Names by their places; those closer than ``same`` mm to an earlier one share its place."""
    clusters: Clusters = []
    for name, z in marks:
        near = next((names for place, names in clusters if abs(place - z) <= same), None)
        if near is None:
            clusters.append((z, near := []))
        near.append(name)
    return clusters
