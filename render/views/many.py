"""Many positions on one scheme: links in thin lines at twelve angles, paths of points, numbers at the crank."""

import cmath
import math
from collections import Counter
from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import groupby, pairwise

import numpy as np

from planes.geometry.plane import perpendicular_foot
from planes.plans import Plans
from planes.plans.extents import most_drawn_reach
from planes.scene.mechanism import FRAME, Link, Mechanism, PlacesByName
from planes.words import Lang, say
from planes.words.frozen import frozen
from planes.words.names import NumbersByName
from render.labels import Label
from render.paper.marks import Line, Mark
from render.views.dimensions import Size, dimension_text, stroke_dimension
from render.views.plotted import SAME_PLACE_MM, group_names_by_place, joint_stroke, link_outline
from render.views.senses import POSITION_NAME_PREFIX

SHARED_NUMBER_DISTANCE_MM = 2.0  # places closer than this are numbered together
SAMPLES_PER_LINE = 10  # sample points of a line
STROKE_CLEARANCE_MM = 16.0  # clear distance of a stroke from everything else


@frozen
class PlacedMechanism:
    """A mechanism in one position: the places of its points, in m, and the angles of its links, in degrees."""

    points: PlacesByName
    angles: NumbersByName


@frozen
class Numbered:
    """One of many positions: its number, its pose (None where the mechanism does not work), whether an extreme."""

    number: str
    result: PlacedMechanism | None
    extreme: bool = False


@frozen
class ManyPositions:
    """Numbered positions and a finer turn for the ``paths`` of these points, or of all hinges between moving links;
    ``mu`` is that of the scheme, mm per m."""

    plans: Plans
    numbered: Sequence[Numbered]
    turn: Sequence[PlacedMechanism | None]
    mu: float
    paths: Sequence[str] = ()

    def place_on_paper(self, result: PlacedMechanism, point: str) -> complex:
        """The place of a point in a position, on paper."""
        return result.points[point] * self.mu

    @property
    def mechanism(self) -> Mechanism:
        """The drawn mechanism."""
        return self.plans.mechanism

    @cached_property
    def most_reach(self) -> float:
        """Largest distance of a drawn point from the driver's pair: near a dead point it may be anywhere."""
        sizes = [self.position_reach(r) for r in self.turn if r]
        return most_drawn_reach(sizes, self.is_full_turn) if sizes else 0.0

    @property
    def is_full_turn(self) -> bool:
        """Whether the driver turns fully, so that all paths are closed."""
        first = self.turn[0]
        last = self.turn[-1]
        if not first or not last:
            return False
        return all(abs(self.place_on_paper(first, p) - self.place_on_paper(last, p)) < 0.1 for p in first.points)

    def position_reach(self, result: PlacedMechanism) -> float:
        """The largest distance of a point from the driver's pair, on paper."""
        centre = self.place_on_paper(result, self.mechanism.links[self.plans.drive.link].first_point)
        return max(abs(self.place_on_paper(result, p) - centre) for p in result.points)

    def fits_on_paper(self, result: PlacedMechanism | None) -> bool:
        """Whether a position exists and fits on the paper."""
        return result is not None and self.position_reach(result) <= self.most_reach

    @cached_property
    def marks(self) -> list[Mark]:
        """Bars of all links in all positions, the extreme ones blacker, and the paths."""
        bars = list[Mark]()
        for one, result in self.drawn_positions():
            style = "thin" if one.extreme else "construction"
            shapes = (x for link in self.mechanism.links.values() for x in self.link_shapes(link, result))
            bars += (Line(tuple(shape), style, "construction", name=POSITION_NAME_PREFIX) for shape in shapes)
        return [*bars, *self.path_marks()]

    def drawn_positions(self) -> Iterator[tuple[Numbered, PlacedMechanism]]:
        """The numbered positions that are drawn, with their poses."""
        return ((one, one.result) for one in self.numbered if one.result and self.fits_on_paper(one.result))

    def link_shapes(self, link: Link, result: PlacedMechanism) -> list[list[complex]]:
        """One stroke through the joints of a link, and the rods of its guides up to their sliders."""
        hinged = {p for x in self.mechanism.bodies if x is not link for p in x.points}
        own = self.mechanism.points_without_guide_centre(link)
        held = [p for p in own if p in hinged]
        loose = [p for p in own if p not in hinged and p != link.centre] if len(held) < 2 else []
        joints = [self.place_on_paper(result, p) for p in (*held, *loose)]
        if link.slides:
            joints.append(self.foot_on_guide(link, link.slides.guide, result))
        rods = []
        for guide in link.guides:
            feet = [
                self.foot_on_guide(x, guide, result)
                for x in self.mechanism.bodies
                if x.slides and x.slides.guide == guide
            ]
            through, along = self.guide_line(guide, result)
            ways = [(z - through) * along.conjugate() for z in joints]
            on = [w.real for w in ways if abs(w.imag) < SAME_PLACE_MM] or [w.real for w in ways[:1]]
            ends = [*on, *(((z - through) * along.conjugate()).real for z in feet)]
            joints += [through + on[0] * along]
            rods += [link_outline([through + min(ends) * along, through + max(ends) * along])] if feet else []
        return [shape for shape in (joint_stroke(joints), *rods) if len(shape) > 1]

    def guide_line(self, guide: str, result: PlacedMechanism) -> tuple[complex, complex]:
        """A point of a guide's line and its direction."""
        mechanism = self.mechanism
        owner = mechanism.link(mechanism.owner_of_guide(guide))
        given = mechanism.guide(guide)
        along = cmath.exp(1j * math.radians(given.angle_deg))
        if owner is mechanism.frame:
            return given.through * self.mu, along
        turn = cmath.exp(1j * math.radians(result.angles[owner.name]))
        first = owner.first_point
        return self.place_on_paper(result, first) + (given.through - owner.points[first]) * turn * self.mu, along * turn

    def foot_on_guide(self, slider: Link, guide: str, result: PlacedMechanism) -> complex:
        """The foot of the perpendicular from a slider's first point to its guide."""
        return perpendicular_foot(self.place_on_paper(result, slider.first_point), *self.guide_line(guide, result))

    @property
    def points_with_paths(self) -> Sequence[str]:
        """The chosen points; by default the hinges without those on a frame's guide, whose paths are straight."""
        m = self.mechanism
        sliders = (x for x in m.links.values() if x.slides and m.owner_of_guide(x.slides.guide) == FRAME)
        plain = {*m.frame.points, *(p for x in sliders for p in x.points)}
        counted = Counter(p for link in m.links.values() for p in link.points)
        return self.paths or [p for p, count in counted.items() if count > 1 and p not in plain]

    def path_marks(self) -> list[Mark]:
        """Paths, dashed."""
        dashed = list[Mark]()
        for point in self.points_with_paths:
            for there, places in groupby(self.turn, key=self.fits_on_paper):
                run = [self.place_on_paper(result, point) for result in places if result and there]
                if len(run) > 2 and max(abs(z - run[0]) for z in run) > 1:
                    dashed.append(Line(tuple(run[self.one_way_slice(point, run)]), "dash", "construction"))
        return dashed

    def one_way_slice(self, point: str, run: Sequence[complex]) -> slice:
        """The path from one end of a rocker's swing to the other: dashes of the way back would fill the gaps."""
        m = self.mechanism
        pivots = [q for link in m.links.values() if point in link.points for q in m.frame.points if q in link.points]
        if not pivots:
            return slice(None)
        turned = np.unwrap(np.angle(np.array(run) - m.frame.points[pivots[0]] * self.mu))
        first, last = sorted((int(turned.argmin()), int(turned.argmax())))
        return slice(first, last + 1)

    def missing_position_remarks(self, lang: Lang) -> list[str]:
        """A remark about the numbered positions that are not drawn."""
        failed = [x.number for x in self.numbered if not x.result]
        far = [x.number for x in self.numbered if x.result and not self.fits_on_paper(x.result)]
        groups = (("positions_failed", failed), ("positions_far", far))
        return [say(key, lang, numbers=", ".join(numbers)) for key, numbers in groups if numbers]

    def position_labels(self) -> list[Label]:
        """Numbers of the positions at the end of the crank, in its hinge if it has one, or beneath a sliding driver;
        of extreme ones at sliders of the frame, or at the ends of rockers if there are none."""
        drive = self.plans.drive
        pair = self.plans.structure.drive_pair
        link = self.mechanism.links[drive.link]
        numbers = []
        hinged = self.points_of_other_links(link)
        ends = [p for p in link.points if p != pair.point or drive.kind == "s"]
        ends.sort(key=lambda p: p not in hinged)
        for one, result in self.drawn_positions():
            z = (
                self.place_on_paper(result, ends[0])
                if ends
                else self.farthest_drawn_point(link, self.place_on_paper(result, pair.point), result)
            )
            side = -1j if drive.kind == "s" else z - self.place_on_paper(result, pair.point)
            numbers.append(Label(one.number, z, 2.5, side=side, clear=1.6, name=f"position {one.number}"))
        held = [*self.followers_on_frame()]
        sliding = [one for one in held if one[0].slides] or held
        return [*numbers, *(label for link, point in sliding for label in self.extreme_position_labels(link, point))]

    def points_of_other_links(self, link: Link) -> set[str]:
        """The points of all moving links except one."""
        return {p for x in self.mechanism.links.values() if x is not link for p in x.points}

    def farthest_drawn_point(self, link: Link, pivot: complex, result: PlacedMechanism) -> complex:
        """The end of the drawn part of a link with no point but its pivot."""
        drawn = (z for shape in self.link_shapes(link, result) for z in shape)
        return max(drawn, key=lambda z: abs(z - pivot), default=pivot)

    def followers_on_frame(self) -> Iterator[tuple[Link, str]]:
        """The links except the driver that slide on the frame or turn about it, each with its farthest point."""
        m = self.mechanism
        for link in m.links.values():
            if link.name != m.drive.link:
                held = [p for p in link.points if p in m.frame.points]
                others = self.points_of_other_links(link)
                if link.slides and m.owner_of_guide(link.slides.guide) == FRAME:
                    yield link, link.first_point
                elif held and (free := [p for p in link.points if p in others and p not in self.plans.fixed_points]):
                    yield link, max(free, key=lambda p: abs(link.points[p] - link.points[held[0]]))

    def extreme_position_labels(self, link: Link, point: str) -> Iterator[Label]:
        """Numbers of the extreme positions along the path of a point, coinciding ones together; the first and the last
        of all, where that hardly moves."""
        places = group_names_by_place(
            ((one.number, self.place_on_paper(result, point)) for one, result in self.drawn_positions()),
            SHARED_NUMBER_DISTANCE_MM,
        )
        extreme = {one.number for one, _ in self.drawn_positions() if one.extreme}
        for z, numbers in places:
            row = [n for n in numbers if n.isdigit()]
            text = ", ".join(n for n in numbers if n in extreme)
            text = f"{row[0]}–{row[-1]}" if len(places) == 1 and len(row) > 2 else text
            if text:
                yield Label(text, z, 2.5, side=self.outward_direction(link, z), name=f"position {text} of {point}")

    def outward_direction(self, link: Link, z: complex) -> complex:
        """The direction away from the pivot of a link, or from the guide of the frame it slides on."""
        frame = self.mechanism.frame
        if link.slides:
            return -1j * cmath.rect(1, math.radians(self.mechanism.guide(link.slides.guide).angle_deg))
        return z - next(frame.points[p] for p in link.points if p in frame.points) * self.mu

    @cached_property
    def sample_points(self) -> list[complex]:
        """Sample points along the links in the drawn positions."""
        moving = self.mechanism.links.values()
        shapes = [shape for _, r in self.drawn_positions() for x in moving for shape in self.link_shapes(x, r)]
        return [z for shape in shapes for a, b in pairwise(shape) for z in _points_along(a, b)]

    def stroke_dimensions(self, lang: Lang) -> list[Size]:
        """The strokes of sliders on the frame's guides, in true mm, outside everything drawn and each other; none where
        the ends of the range are not drawn."""
        sizes = list[Size]()
        shown = [r for r in self.turn if r]
        if not all(map(self.fits_on_paper, shown)):
            return sizes
        for link, slides in ((link, link.slides) for link, _ in self.followers_on_frame() if shown):
            if not slides:
                continue
            through, along = self.guide_line(slides.guide, shown[0])
            at = [((self.place_on_paper(r, link.first_point) - through) * along.conjugate()).real for r in shown]
            others = (z for one in sizes for z in _points_along(*one.ends, 4))
            ways = ((z - through) * along.conjugate() for z in (*self.sample_points, *others))
            beside = [0.0, *(w.imag for w in ways if min(at) < w.real < max(at))]
            off = min(min(beside) - STROKE_CLEARANCE_MM, max(beside) + STROKE_CLEARANCE_MM, key=abs)
            ends = (through + min(at) * along, through + max(at) * along)
            sizes.append(stroke_dimension(*ends, 1j * off * along, dimension_text((max(at) - min(at)) / self.mu, lang)))
        return [one for one in sizes if one.has_room_for_text]


def _points_along(start: complex, end: complex, parts: int = SAMPLES_PER_LINE) -> list[complex]:
    """The ends of a line and of its equal parts."""
    return [start + k / parts * (end - start) for k in range(parts + 1)]
