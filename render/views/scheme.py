"""The scheme of a mechanism in one position, with the signs of ГОСТ 2.770: guides, sliders, links, hinges, letters."""

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from planes.scene.mechanism import FRAME, Link
from planes.solving import Position
from planes.words.names import POLE, ends_of, label_of
from planes.words.naming import Naming
from render.labels import Label
from render.paper import symbols
from render.paper.marks import Line, Mark
from render.paper.style import BLOCK_MM, HINGE_MM, LARGE_MM, SMALL_MM
from render.paper.symbols import Marks
from render.views.hinges import base_angle
from render.views.plotted import NEAR_MM, Ends, Places, degrees, nearest, outline_of
from render.views.round_guides import round_slider
from render.views.senses import driver_arrows, labelled

RAIL_MM = 17.0  # of a guide on each side of its slider
ROD_MM = 12.0  # of a moving guide beyond its slider
LETTER_MM = 5.0
ALONE_MM = 13.0  # of the axis of a guide that is not drawn, on each side of its slider
CLEAR_MM = 0.8  # distance of a rod's end from a rail


@dataclass
class Scheme:
    """The scheme being drawn; places are mm of paper from the origin of the frame's axes."""

    position: Position
    naming: Naming
    only: tuple[str, ...] = ()  # the links that are drawn; none named: all
    framed: bool = True  # whether the frame is drawn

    def __post_init__(self) -> None:
        self.places = Places(self.position)
        self.mechanism, self.shared = self.places.mechanism, self.places.shared
        self.links = [x for x in self.places.links if not self.only or x.name in self.only]
        self.axes, self.rails, self.guides, self.blocks, self.bars, self.hinges = (list[Mark]() for _ in range(6))
        self.named, self.ways = list[Label](), dict[str, list[complex]]()

    def drawn(self, arrows: bool = True, marks: Sequence[Mark] = (), named: Sequence[Label] = ()) -> Marks:
        """All marks: guides, sliders, bars, hinges, letters, the driver's arrows; and the marks on top."""
        ground = [*self.strokes, *marks]
        if arrows:
            turning, letters = driver_arrows(self.places, self.naming, ground)
            ground += turning
            self.named += letters
        return labelled([*self.named, *named], ground)

    @cached_property
    def strokes(self) -> list[Mark]:
        """Guides, sliders, bars and hinges."""
        for link in self.links:
            if all(map(self.places.has, link.points)):
                self.link(link)
        self.pairs()
        self.letters()
        return [*self.axes, *self.rails, *self.guides, *self.blocks, *self.bars, *self.hinges]

    # links

    def link(self, link: Link) -> None:
        """A link's bar or plate, its own guides, and its slider if it slides."""
        if round_guide := self.mechanism.round_guide(link):
            self.blocks += round_slider(self.places, link, *round_guide)
        own = self.mechanism.joined(link)
        joints = [self.places.at(p) for p in own if p in self.shared or p != link.centre]
        if link.slides:
            foot, along = self.places.foot(link)
            self.slider(link, foot, along)
            joints.append(foot)
        for name in link.guides:
            joints += self.moving_guide(name, joints)
        outline = outline_of(joints)
        self.number(link, outline)
        if len(outline) > 2:
            self.bars += symbols.plate(outline)
        elif len(outline) == 2:
            self.bars += symbols.bar(*outline)
        self.offside(link, outline)
        for p in own:
            if p in self.shared:
                self.ways.setdefault(p, []).extend(z - self.places.at(p) for z in outline)

    def offside(self, link: Link, outline: list[complex]) -> None:
        """The mass centre, and a thin arm to it if it lies away from its link."""
        centre = link.centre
        if not centre or centre in self.shared or not self.places.has(centre):
            return
        z = self.places.at(centre)
        self.hinges += symbols.dot(z)
        near = nearest(z, outline)
        if abs(z - near) > BLOCK_MM[0] / 2:
            self.bars.append(Line((near, z), "thin"))

    def slider(self, link: Link, foot: complex, along: complex) -> None:
        """The slider's block: on rails if its guide is the frame's, smaller where it is held in another block."""
        assert link.slides
        angle, size, owner = degrees(along), self.size(link), self.mechanism.owner(link.slides.guide)
        if owner != FRAME or not self.framed:
            blocks = self.rails if size == LARGE_MM else self.blocks
            blocks += symbols.block(foot, angle, size=size)
            if not self.framed and owner not in self.only:
                self.axes.append(Line((foot - ALONE_MM * along, foot + ALONE_MM * along), "axis", "axis"))
            return
        side = self.rail_side(link, foot, along)
        self.rails += symbols.rail(foot, angle, RAIL_MM, side, size[1])
        self.rails += symbols.block(foot, angle, size=size)
        reach = (RAIL_MM + 4) * along
        self.axes.append(Line((foot - reach, foot + reach), "axis", "axis"))
        for letter, end in zip(ends_of(link.slides.guide), (foot + reach, foot - reach), strict=True):
            if letter:
                self.named.append(Label(self.naming.point(letter), end, 3.5, name=f"guide {link.slides.guide}"))

    def size(self, link: Link) -> tuple[float, float]:
        """The size of a slider's block: of two in one place the frame's (or the later one) holds the other."""
        if (other := self.beside(link)) is None:
            return BLOCK_MM
        return LARGE_MM if self.mechanism.rank(link) > self.mechanism.rank(other) else SMALL_MM

    def beside(self, link: Link) -> Link | None:
        """The other slider in the same place."""
        here, others = self.places.at(link.first_point), (x for x in self.mechanism.links.values() if x is not link)
        there = (x for x in others if x.slides and self.places.has(x.first_point))
        return next((x for x in there if abs(self.places.at(x.first_point) - here) < NEAR_MM), None)

    def beyond(self, link: Link, rod: complex) -> float:
        """How far a rod extends beyond a slider on it: at most to the rail of the block that holds this one."""
        if (other := self.beside(link)) is None or self.size(other) != LARGE_MM:
            return ROD_MM
        across = abs((rod * self.places.foot(other)[1].conjugate()).imag)
        return min(ROD_MM, max((LARGE_MM[1] / 2 - CLEAR_MM) / max(across, 1e-9), SMALL_MM[0] / 2 + CLEAR_MM))

    def rail_side(self, link: Link, foot: complex, along: complex) -> int:
        """The side of the slider away from its rods, or from the rest of the mechanism."""
        z, places = self.places.at(link.first_point), self.places
        rods = [rod for x in self.mechanism.links for rod in places.rods(x) if min(abs(z - w) for w in rod) < NEAR_MM]
        far = [w for rod in rods for w in rod] or [places.at(p) for p in places.shared if places.has(p)]
        return 1 if ((sum(far) / len(far) - foot) * along.conjugate()).imag < -1 else -1

    def moving_guide(self, name: str, joints: list[complex]) -> list[complex]:
        """The rod of a guide on a link; the place where the link's own bars join it, if none is on it."""
        if f"∥{name}" not in self.position.drawing:
            return []
        through, along = self.places.line(name)
        ways = [(z - through) * along.conjugate() for z in joints]
        stops = []
        for x in self.places.sliders(name):
            foot, far = ((self.places.foot(x)[0] - through) * along.conjugate()).real, self.beyond(x, along)
            stops += [foot - far, foot + far]
        on = [w.real for w in ways if abs(w.imag) < NEAR_MM]
        reach = on or [w.real for w in ways[:1]]
        if not stops or not reach:
            return []
        low, high = self.rod(reach, stops)
        ends = through + low * along, through + high * along
        self.guides += symbols.bar(*ends)
        off = [z for z, w in zip(joints, ways, strict=True) if abs(w.imag) >= NEAR_MM]
        self.corner(through + reach[0] * along, ends, off[:1])
        return [] if on else [through + reach[0] * along]

    def corner(self, z: complex, rod: Sequence[complex], joints: Sequence[complex]) -> None:
        """The sign of a rigid joint where the rod of a guide meets the link's own bar."""
        far = [end for end in rod if abs(end - z) > symbols.GUSSET_MM]
        for joint in joints if far else ():
            nearer = max(far, key=lambda end: math.cos(cmath.phase((end - z) / (joint - z))))
            self.bars += symbols.rigid(z, nearer, joint)

    def rod(self, reach: list[float], stops: list[float]) -> tuple[float, float]:
        """From the place where the link holds the guide to beyond its sliders; no farther on the holding side."""
        low, high = min(*reach, *stops), max(*reach, *stops)
        if min(reach) <= min(stops) + ROD_MM:
            low = min(reach)
        if max(reach) >= max(stops) - ROD_MM:
            high = max(reach)
        return (low, high) if high - low > 1 else (min(stops), max(stops))

    def number(self, link: Link, outline: list[complex]) -> None:
        """The number of a link beside its longest side, of a slider beside its block."""
        clear = 0.0
        at: complex | Ends | None = None
        if len(outline) > 1:
            at = max(pairwise((*outline, outline[0])), key=lambda e: abs(e[1] - e[0]))
        elif link.slides:
            foot, along = self.places.foot(link)
            long, wide = self.size(link)
            at, clear = (foot - long / 2 * along, foot + long / 2 * along), wide / 2
            if long < BLOCK_MM[0]:
                at, clear = foot + (long / 2 + 1j * wide / 2) * along, 0.0
        elif link.slides_round:
            at, clear = self.places.at(link.first_point), BLOCK_MM[0] / 2
        elif slider := next(self.places.sliders(*link.guides), None):  # a hinge and a guide: the rod between them
            at = self.places.at(link.first_point), self.places.foot(slider)[0]
        if at is not None:
            text, name = self.naming.link(link.name), f"link {link.name}"
            ends = at if isinstance(at, tuple) and clear else ()
            self.named.append(Label(text, at, LETTER_MM, clear=clear, name=name, underlined=True, also=ends))

    # pairs and letters

    def pairs(self) -> None:
        """Hinges, those on the frame with their legs."""
        for point, owners in self.shared.items():
            if not self.places.has(point) or not any(link.name in owners for link in self.links):
                continue
            z, fixed = self.places.at(point), FRAME in owners and self.framed
            ways = [w / abs(w) for w in self.ways.get(point, []) if abs(w) > NEAR_MM]
            turn = base_angle(z, ways, [*self.bars, *self.guides]) if fixed else 0.0
            self.hinges += symbols.fixed_hinge(z, turn) if fixed else symbols.hinge(z)

    def letters(self) -> None:
        """Letters of all points."""
        first = {p: link for link in reversed(self.links) for p in link.points if self.places.has(p)}
        for p in dict.fromkeys(p for link in self.links for p in link.points if p in first):
            z, hinged = self.places.at(p), p in self.shared
            if not hinged and p != first[p].centre:
                self.hinges += symbols.dot(z)
            clear = HINGE_MM if hinged else 0.8
            text = ", ".join(map(self.naming.point, (p, *self.images(p))))
            self.named.append(Label(text, z, LETTER_MM, clear=clear, priority=1, name=p))

    def images(self, point: str) -> list[str]:
        """Letters of the places on guides that coincide with a slider's point, as on the plans: L, B3."""
        plans, drawn = self.position.plans, {x.name for x in self.links}
        known, images = {POLE, *(label_of(x.velocity) for x in plans.points.values())}, list[str]()
        for link in self.links:
            if link.slides and link.first_point == point and link.name in plans.velocity_slides:
                reading = plans.velocity_slides[link.name]
                if self.mechanism.owner(reading.guide) in drawn:
                    ends = (reading.under,) if reading.under else reading.ends
                    images += (x.upper() for x in map(label_of, ends) if x not in known)
        return images
