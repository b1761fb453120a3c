"""What is known of each link while the plans grow: its marks, its x axis, and whose turning it shares.

What is reckoned of a scene's numbers before anything is drawn comes each with how far off it may be: a decimal is off
by half of the last place of the double that stands for it, and so is every operation.
"""

import math
from dataclasses import dataclass, field

from planes.drafting.draft import Draft
from planes.drafting.steps import Similar
from planes.geometry.arithmetic import Arithmetic
from planes.plans.groups import Group, Pair
from planes.plans.structure import Structure
from planes.scene.mechanism import FRAME, Link, Mechanism
from planes.words.names import POLE, Meaning, at

SCHEME = "position"
ARITHMETIC = Arithmetic()
HALF = 2.0**-53  # of a last place, at most, relative to the number
Off = tuple[float, float]  # a number, and how far off it may be


@dataclass(frozen=True)
class BodyPoint:
    """A point of a link: its mark's label on the scheme, and its name on the moving plans ("A" there, "A3" here)."""

    place: str
    name: str


@dataclass
class Body:
    """A solved link: ``base`` is a point of it on every plan, ``axis`` the direction of its own x axis; it turns as
    link ``root`` does, of which ``ref`` are two spots (None for the frame, or for a driver of one point)."""

    link: Link
    base: BodyPoint
    axis: str
    root: str
    ref: tuple[BodyPoint, BodyPoint] | None = None
    rigid: bool = False  # ref are two named points of this very link, a constant distance apart
    moving: BodyPoint | None = None  # where the moving plans start from, if not from ``base``

    @property
    def carrier(self) -> BodyPoint:
        """The spot of the link that the moving plans reach first."""
        return self.moving or self.base


@dataclass(frozen=True)
class AssemblyChoice:
    """A ±1 the scene has to choose: the name of the given, the key of ``assembly:`` and the group."""

    side: str
    key: str
    group: Group


@dataclass
class Bodies:
    """The links solved so far, and the marks their own points and lines have on the scheme."""

    mechanism: Mechanism
    structure: Structure
    draft: Draft
    file: str = ""
    choices: list[AssemblyChoice] = field(default_factory=list)
    known: dict[str, Body] = field(default_factory=dict)
    labels: dict[str, str] = field(default_factory=dict)
    coincident: dict[str, tuple[str, str]] = field(default_factory=dict)  # name -> (point it coincides with, link)

    def small_letter(self, name: str) -> str:
        """The label of a point on the moving plans: its small letters, unless another point has taken them."""
        if name not in self.labels:
            label, taken = name.lower(), {POLE, *self.labels.values()}
            while label in taken:
                label = name if label == name.lower() != name else label + "_"
            self.labels[name] = label
        return self.labels[name]

    def place_points(self, body: Body) -> None:
        """Draw the points of a link that are not on the scheme yet, by similarity or from its axis."""
        for name in body.link.points:
            if at(SCHEME, name) not in self.draft.steps:
                self._place_point(body, name, body.link.points[name])
        self.known[body.link.name] = body

    def _place_point(self, body: Body, label: str, p: complex, means: Meaning | None = None) -> str:
        if body.rigid and body.ref:
            one, two = (at(SCHEME, s.place) for s in body.ref)
            return self.similar(at(SCHEME, label), body, label, p, (one, two), means)
        base, d = body.base.place, self.draft
        ray = d.turn(f"{base}{label}", body.axis, *angle_deg(body.link.points[base], p), Meaning("along", base, label))
        d.rays[SCHEME, base, label] = ray
        return d.lay_off(SCHEME, label, at(SCHEME, base), ray, self.length(body.link, base, label, p), means)

    def similar(
        self, mark: str, body: Body, name: str, p: complex, ends: tuple[str, str], means: Meaning | None = None
    ) -> str:
        """The mark of a place of a rigid link, that stands to the ``ends`` as it does to the points they are of."""
        assert body.ref
        given = ratio(p, *(body.link.points[s.place] for s in body.ref))
        return self.draft.step(
            Similar(mark, *ends, self.draft.give(f"ratio_{name}_{body.link.name}", *given), means=means)
        )

    def length(self, link: Link, one: str, two: str, end: complex | None = None) -> str:
        """The given distance of two points of a link; ``end`` is the place of the second if it is none of them."""
        apart = distance(link.points[one], link.points[two] if end is None else end)
        return self.draft.give(f"l_{one}{two}", *apart, Meaning("length", one, two, link.name))

    def distance(self, link: Link, one: BodyPoint, two: BodyPoint) -> str:
        """The distance of two spots of a link: given if both are its points, else taken off the scheme."""
        if one.name in link.points and two.name in link.points:
            return self.length(link, one.place, two.place)
        return self.draft.measure(f"l_{one.place}{two.place}", at(SCHEME, one.place), at(SCHEME, two.place))

    def line(self, pair: Pair, known: str) -> tuple[str, str]:
        """The line of a sliding pair as the solved link ``known`` carries it: a mark on it and its direction."""
        mark = self._guide_mark(self.known[known], pair.guide) if known == pair.other else self.foot(pair)
        return mark, self.direction_from(pair, known, self.known[known].axis)

    def _guide_mark(self, body: Body, name: str) -> str:
        guide = body.link.guides[name]
        label = guide.through_point or f"°{name}"
        if at(SCHEME, label) not in self.draft.steps:
            means = Meaning("guide", name)
            if body.link.name == FRAME:
                return self.draft.put(SCHEME, label, guide.through, means)
            return self._place_point(body, label, guide.through, means)
        return at(SCHEME, label)

    def _slide_angle(self, pair: Pair) -> float:
        slides = self.mechanism.link(pair.link).slides
        return (slides.angle_deg or 0.0) if slides else 0.0

    def axis_along(self, pair: Pair, link: str, direction: str) -> str:
        """The x axis of ``link``, one of the sliding pair, from the direction of the pair's guide."""
        angle = self._slide_angle(pair) if link == pair.link else -self.mechanism.guide(pair.guide).angle_deg
        return self.draft.turn(f"x_{link}", direction, angle, 0.0, Meaning("own", link))

    def direction_from(self, pair: Pair, link: str, axis: str) -> str:
        """The direction of the pair's guide from the x axis of ``link``, one of the pair."""
        name, means, given = f"∥{pair.guide}", Meaning("along", pair.guide), Meaning("angle", pair.guide, link=link)
        if link == pair.link:
            return self.draft.turn(name, axis, -self._slide_angle(pair), 0.0, means)
        angle = self.mechanism.guide(pair.guide).angle_deg
        if link == FRAME:
            return self.draft.aim(name, angle, means, given)
        return self.draft.turn(name, axis, angle, 0.0, means, given)

    def offset(self, pair: Pair, link: str, point: str) -> Off | None:
        """How far a point of ``link`` lies to the left of the pair's line (m), and how far off that may be; None: on it
        by construction."""
        body = self.mechanism.link(link)
        if link == pair.other:
            guide = body.guides[pair.guide]
            if guide.through_point == point:
                return None
            return height(body.points[point], guide.through, guide.angle_deg)
        slides = body.slides
        if slides is None:
            raise AssertionError(pair)
        if point == body.first_point:
            return None if slides.offset is None else (slides.offset, 0.0)
        found = height(body.points[point], body.points[body.first_point], -(slides.angle_deg or 0.0))
        return difference(found, (-(slides.offset or 0.0), 0.0))

    def shifted(self, label: str, means: Meaning, start: str, direction: str, by: Off | None) -> str:
        """A helping mark ``by`` metres to the left of a line through ``start`` (that itself when it is nothing)."""
        if by is None:
            return start
        offset = self.draft.give(f"e_{label}", *by, Meaning("offset", label))
        return self.draft.lay_off(SCHEME, label, start, self.draft.square(direction), offset, means)

    def foot(self, pair: Pair) -> str:
        """The foot of the slider's first point on the guide line."""
        body = self.known[pair.link]
        first = at(SCHEME, body.link.first_point)
        offset = self.offset(pair, pair.link, body.link.first_point)
        if offset is None:
            return first
        direction = self.direction_from(pair, pair.link, body.axis)
        label, means = f"{body.link.first_point}⊥{pair.guide}", Meaning("foot", pair.guide, body.link.first_point)
        return self.shifted(label, means, first, direction, difference((0.0, 0.0), offset))


def difference(a: Off | None, b: Off | None) -> Off | None:
    """a - b, where None is a nothing that stays nothing."""
    if a is None and b is None:
        return None
    (one, off), (other, more) = a or (0.0, 0.0), b or (0.0, 0.0)
    return one - other, off + more + (HALF * (abs(one) + 2 * abs(other)) if one and other else 0.0)


def distance(p: complex, q: complex) -> Off:
    """The distance of two points."""
    way = q - p
    return abs(way), _apart(p, q) + (2 * HALF * abs(way) if way.real and way.imag else 0.0)


def angle_deg(p: complex, q: complex) -> Off:
    """The direction from one point to another, degrees."""
    way = q - p
    if not way:
        return 0.0, 0.0
    if not (p.imag or q.imag):  # along the link's own axis
        return (0.0, 0.0) if way.real > 0 else (180.0, 0.0)
    angle = ARITHMETIC.angle_deg(way)
    return angle, math.degrees(_apart(p, q) / abs(way)) + 4 * HALF * abs(angle)


def along(way: complex, degrees: float) -> float:
    """How far a way goes in a direction."""
    return float((way * ARITHMETIC.cis_deg(-degrees)).real)


def ratio(p: complex, q: complex, r: complex) -> tuple[complex, float]:
    """(p - q) / (r - q): how a point stands to two others."""
    found, base = (p - q) / (r - q), abs(r - q)
    rounded = 6 if p.imag or q.imag or r.imag else 1
    return found, (_apart(p, q) + abs(found) * _apart(r, q)) / base + rounded * HALF * abs(found)


def height(p: complex, q: complex, degrees: float) -> Off:
    """How far ``p`` lies to the left of the line through ``q`` at an angle."""
    way = p - q
    off = _apart(p, q) + HALF * abs(way) * ((abs(math.radians(degrees)) + 6) if degrees % 90 else 0.0)
    return (way * ARITHMETIC.cis_deg(-degrees)).imag, off


def _apart(p: complex, q: complex) -> float:
    """How far off a difference of two places is, the decimals of both and its own rounding together."""
    return HALF * (abs(p) + abs(q) + (abs(p - q) if p and q else 0.0))
