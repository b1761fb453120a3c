"""The known data of each link while the plans grow: its marks, its x axis, and the link whose rotation it shares."""

from collections.abc import Callable
from copy import copy
from dataclasses import dataclass, field

from planes.drafting.dimensions import Dimension
from planes.drafting.draft import Draft
from planes.drafting.steps import Similar
from planes.drafting.steps.tracks import Hold, SeriesGuess
from planes.plans.assur.basic_links import Lead, Leads, Triad
from planes.plans.assur.contours import Contour, Tracked
from planes.plans.assur.groups import Group, Pair
from planes.plans.assur.structure import Structure
from planes.plans.position.reckoned import (
    OwnPlace,
    SceneDimensions,
    dimension_by_way,
    dimension_difference,
    direction_between_points,
)
from planes.scene.mechanism import FRAME, Link, Mechanism
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Mark, MarkPair, Meaning, NamePair, NamesByName, scheme_mark


@frozen
class BodyPoint:
    """A point of a link: its mark's label on the scheme, and its name on the velocity and acceleration plans ("A"
    there, "A3" here)."""

    place: str
    name: str


@dataclass
class Body:
    """A solved link: ``base`` is a point of it on every plan, ``axis`` the direction of its x axis; it turns as link
    ``root`` does, of which ``ref`` are two points (None for the frame, or for a driver with one point)."""

    link: Link
    base: BodyPoint
    axis: str
    root: str
    ref: tuple[BodyPoint, BodyPoint] | None = None
    rigid: bool = False  # ref are two named points of this same link, a constant distance apart
    moving: BodyPoint | None = None  # start point on the velocity and acceleration plans, if not ``base``

    @property
    def first_reached_point(self) -> BodyPoint:
        """The point of the link that the velocity and acceleration plans reach first."""
        return self.moving or self.base


@frozen
class AssemblyChoice:
    """A ±1 that the scene must choose: the name of the given, the key of ``assembly:`` and the group."""

    side: str
    key: str
    group: Group | Triad | Contour
    placed: bool = True  # its places are known before other choices are made


@frozen
class BraceReach:
    """The length of a cylinder that braces a hinge, by names of values: its sense, its reach along its guide and the
    distance between its hinges, which differs from the reach where a hinge lies off the guide."""

    way: str
    reach: str
    length: str
    offset: bool


@frozen
class TrackChoice:
    """Which crossing of a track is meant: the series of an assembly, its sign, and the ties of the link."""

    key: str
    group: Tracked
    holds: tuple[Hold, ...]
    guess: SeriesGuess
    side: str


@dataclass
class Bodies:
    """The links solved so far, and the marks of their points and lines on the scheme."""

    mechanism: Mechanism
    structure: Structure
    draft: Draft
    file: str = ""
    choices: list[AssemblyChoice | TrackChoice] = field(default_factory=list)
    leads: dict[str, Leads] = field(default_factory=dict)  # of a basic link: the first two meet in S
    known: dict[str, Body] = field(default_factory=dict)
    labels: NamesByName = field(default_factory=dict)
    placers: dict[Lead, Callable[[], None]] = field(default_factory=dict)  # of leads with a drive inside, drawn aside
    reach: BraceReach | None = None
    specials: NamesByName = field(default_factory=dict)  # basic link -> name of its point S
    standing: set[str] = field(default_factory=lambda: {FRAME})  # links that never move
    passive: tuple[Link, ...] = ()  # drawn by points of others
    coincident: dict[str, NamePair] = field(default_factory=dict)  # name -> (coincident point, link)

    @property
    def link_dimensions(self) -> SceneDimensions:
        """The dimensions of the links."""
        return SceneDimensions(self.mechanism, self.passive)

    def copy_for_trial(self) -> "Bodies":
        """A copy that can grow separately."""
        other = copy(self)
        vars(other).update({name: copy(kept) for name, kept in vars(self).items() if isinstance(kept, dict | list)})
        other.draft, other.known = self.draft.copy_for_trial(), {name: copy(body) for name, body in self.known.items()}
        return other

    def special_point_name(self, basic: str) -> str:
        """The name of the special point of a basic link, not used by any other point."""
        others = (name for link, name in self.specials.items() if link != basic)
        taken = {*self.mechanism.point_names, *self.coincident, *others}
        names = "S", f"S{basic}", "T", "U", "W", *(f"S{basic}" + "_" * k for k in range(1, 2 + len(taken)))
        name = next(name for name in names if name not in taken)
        return self.specials.setdefault(basic, name)

    def plan_label_of_point(self, name: str) -> str:
        """The label of a point on the velocity and acceleration plans: its small letters, unless another point has
        them."""
        if name not in self.labels:
            label = name.lower()
            taken = {POLE_LABEL, *self.labels.values()}
            while label in taken:
                label = name if label == name.lower() != name else label + "_"
            self.labels[name] = label
        return self.labels[name]

    def draw_missing_points(self, body: Body) -> None:
        """Draw the points of a link that are still missing on the scheme, by similarity or from its axis."""
        for name in body.link.points:
            if scheme_mark(name) not in self.draft.steps:
                self._draw_point(body, name, OwnPlace(body.link.name, name))
        self.known[body.link.name] = body

    def _draw_point(self, body: Body, label: str, p: OwnPlace, means: Meaning | None = None) -> Mark:
        if body.rigid and body.ref:
            one, two = (scheme_mark(s.place) for s in body.ref)
            return self.mark_by_similarity(scheme_mark(label), body, label, p, (one, two), means)
        base = body.base.place
        d = self.draft
        way = direction_between_points(self.link_dimensions, OwnPlace(p.link, base), p)
        ray = d.draw_turned_direction(f"{base}{label}", body.axis, way, Meaning("along", base, label))
        d.rays[base, label] = ray
        return d.lay_off(
            SCHEME_PLAN, label, scheme_mark(base), ray, self.given_distance(body.link, base, label, p), means
        )

    def mark_by_similarity(
        self, mark: Mark, body: Body, name: str, p: OwnPlace, ends: MarkPair, means: Meaning | None = None
    ) -> Mark:
        """The mark of a place of a rigid link, in the same ratio to the ``ends`` as to the points they represent."""
        assert body.ref
        like = dimension_by_way(self.link_dimensions, "ratio", p, *(OwnPlace(p.link, s.place) for s in body.ref))
        return self.draft.draw_mark(
            Similar(mark, *ends, self.draft.add_computed_given(f"ratio_{name}_{p.link}", like), means=means)
        )

    def given_distance(self, link: Link, one: str, two: str, end: OwnPlace | None = None) -> str:
        """The given distance of two points of a link; ``end`` is the place of the second if it is none of them."""
        apart = dimension_by_way(
            self.link_dimensions, "distance", OwnPlace(link.name, one), end or OwnPlace(link.name, two)
        )
        return self.draft.add_computed_given(f"l_{one}{two}", apart, Meaning("length", one, two, link.name))

    def distance_of_places(self, link: Link, one: BodyPoint, two: BodyPoint) -> str:
        """The distance between two places of a link: given if both are its points, else measured on the scheme."""
        if one.name in link.points and two.name in link.points:
            return self.given_distance(link, one.place, two.place)
        return self.draft.measure_segment(f"l_{one.place}{two.place}", *SCHEME_PLAN.marks(one.place, two.place))

    def guide_mark_and_direction(self, pair: Pair, known: str) -> tuple[Mark, str]:
        """The line of a sliding pair on the solved link ``known``: a mark on it and its direction."""
        mark = self._guide_mark(self.known[known], pair.guide) if known == pair.other else self.foot_on_guide(pair)
        return mark, self.guide_direction_from_axis(pair, known, self.known[known].axis)

    def _guide_mark(self, body: Body, name: str) -> Mark:
        guide = body.link.guides[name]
        label = guide.through_point or f"°{name}"
        if scheme_mark(label) not in self.draft.steps:
            means = Meaning("guide", name)
            if body.link.name == FRAME:
                return self.draft.draw_given_mark(SCHEME_PLAN, label, guide.through, means)
            return self._draw_point(body, label, OwnPlace(body.link.name, guide=name), means)
        return scheme_mark(label)

    def guide_angle_in_link(self, pair: Pair, link: str) -> Dimension:
        """The direction of the pair's guide in the axes of ``link``, one of the pair, degrees."""
        if link == pair.link:
            return -dimension_by_way(self.link_dimensions, "lean", link)
        return dimension_by_way(self.link_dimensions, "angle", pair.guide)

    def link_axis_from_guide(self, pair: Pair, link: str, direction: str) -> str:
        """The x axis of ``link``, one of the sliding pair, from the direction of the pair's guide."""
        return self.draft.draw_turned_direction(
            f"x_{link}", direction, -self.guide_angle_in_link(pair, link), Meaning("own", link)
        )

    def guide_direction_from_axis(self, pair: Pair, link: str, axis: str) -> str:
        """The direction of the pair's guide from the x axis of ``link``, one of the pair."""
        name = f"∥{pair.guide}"
        means = Meaning("along", pair.guide)
        given = Meaning("angle", pair.guide, link=link)
        angle = self.guide_angle_in_link(pair, link)
        if link == pair.link:
            return self.draft.draw_turned_direction(name, axis, angle, means)
        if link == FRAME:
            return self.draft.draw_direction_at_angle(name, angle, means, given)
        return self.draft.draw_turned_direction(name, axis, angle, means, given)

    def point_offset_from_guide(self, pair: Pair, link: str, point: str) -> Dimension | None:
        """How far a point of ``link`` lies to the left of the pair's line (m), with its uncertainty; None: on it by
        construction."""
        body = self.mechanism.link(link)
        if link == pair.other:
            guide = body.guides[pair.guide]
            if guide.through_point == point:
                return None
            return dimension_by_way(
                self.link_dimensions,
                "height",
                OwnPlace(link, point),
                OwnPlace(link, guide=pair.guide),
                dimension_by_way(self.link_dimensions, "angle", pair.guide),
            )
        slides = body.slides
        if slides is None:
            raise AssertionError(pair)
        own = None if slides.offset is None else -dimension_by_way(self.link_dimensions, "offset", link)
        if point == body.first_point:
            return None if own is None else -own
        spots = OwnPlace(link, point), OwnPlace(link, body.first_point)
        return dimension_difference(
            dimension_by_way(
                self.link_dimensions, "height", *spots, -dimension_by_way(self.link_dimensions, "lean", link)
            ),
            own,
        )

    def shifted_mark(self, label: str, means: Meaning, start: Mark, direction: str, by: Dimension | None) -> Mark:
        """An auxiliary mark ``by`` metres to the left of a line through ``start`` (``start`` itself where that is
        zero)."""
        if by is None:
            return start
        offset = self.draft.add_computed_given(f"e_{label}", by, Meaning("offset", label))
        return self.draft.lay_off(SCHEME_PLAN, label, start, self.draft.draw_perpendicular(direction), offset, means)

    def mark_of_pair(self, pair: Pair) -> Mark:
        """The mark where a pair acts: its hinge, or the foot of the perpendicular from the slider's first point."""
        if pair.kind == "R":
            return scheme_mark(pair.point)
        return self.foot_on_guide(pair)

    def foot_on_guide(self, pair: Pair) -> Mark:
        """The foot of the perpendicular from the slider's first point to the guide."""
        body = self.known[pair.link]
        first = scheme_mark(body.link.first_point)
        offset = self.point_offset_from_guide(pair, pair.link, body.link.first_point)
        if offset is None:
            return first
        direction = self.guide_direction_from_axis(pair, pair.link, body.axis)
        label = f"{body.link.first_point}⊥{pair.guide}"
        means = Meaning("foot", pair.guide, body.link.first_point)
        return self.shifted_mark(label, means, first, direction, -offset)
