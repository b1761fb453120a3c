"""The scheme of a mechanism in one position, with the signs of ГОСТ 2.770: guides, sliders, links, hinges, letters."""

import cmath
import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

from planes.scene.mechanism import FRAME, Link
from planes.scene.ranges import Interval
from planes.solving import Position
from planes.words.names import POLE_LABEL, NameTuple, guide_end_letters
from planes.words.naming import Naming
from render.labels import Label
from render.labels.candidates import Size
from render.paper import symbols
from render.paper.marks import Line, Mark
from render.paper.style import HINGE_RADIUS_MM, INNER_BLOCK_SIZE_MM, OUTER_BLOCK_SIZE_MM, SLIDER_BLOCK_SIZE_MM
from render.paper.symbols import Marks
from render.views.hinges import base_angle
from render.views.plotted import (
    SAME_PLACE_MM,
    Ends,
    Places,
    direction_deg,
    length_of,
    link_outline,
    nearest_outline_point,
)
from render.views.round_guides import round_slider_marks
from render.views.senses import driver_arrows, marks_with_labels

HALF_RAIL_LENGTH_MM = 17.0  # of a guide on each side of its slider
ROD_OVERHANG_MM = 12.0  # of a moving guide beyond its slider
POINT_LETTER_MM = 5.0
HALF_GUIDE_AXIS_LENGTH_MM = 13.0  # of the axis of a guide that is not drawn, on each side of its slider
ROD_RAIL_GAP_MM = 0.8  # distance of a rod's end from a rail


@dataclass
class Scheme:
    """The scheme being drawn; places are mm of paper from the origin of the frame's axes."""

    position: Position
    naming: Naming
    only: NameTuple = ()  # the links that are drawn; none named: all
    framed: bool = True  # whether the frame is drawn

    def __post_init__(self) -> None:
        self.places = Places(self.position)
        self.mechanism = self.places.mechanism
        self.shared = self.places.links_by_hinge
        self.links = [x for x in self.places.links if not self.only or x.name in self.only]
        self.axes, self.rails, self.guides, self.blocks, self.bars, self.hinges = (list[Mark]() for _ in range(6))
        self.named, self.ways = list[Label](), dict[str, list[complex]]()

    def drawn_marks(self, arrows: bool = True, marks: Sequence[Mark] = (), named: Sequence[Label] = ()) -> Marks:
        """All marks: guides, sliders, bars, hinges, letters, the driver's arrows; and the marks on top."""
        ground = [*self.ground_marks, *marks]
        if arrows:
            turning, letters = driver_arrows(self.places, self.naming, ground)
            ground += turning
            self.named += letters
        return marks_with_labels([*self.named, *named], ground)

    @cached_property
    def ground_marks(self) -> list[Mark]:
        """Guides, sliders, bars and hinges."""
        for link in self.links:
            if all(map(self.places.is_drawn, link.points)):
                self.add_link(link)
        self.add_pairs()
        self.add_letters()
        return [*self.axes, *self.rails, *self.guides, *self.blocks, *self.bars, *self.hinges]

    # links

    def add_link(self, link: Link) -> None:
        """A link's bar or plate, its own guides, and its slider if it slides."""
        if round_guide := self.mechanism.round_guide_of_link(link):
            self.blocks += round_slider_marks(self.places, link, *round_guide)
        own = self.mechanism.points_without_guide_centre(link)
        joints = [self.places.point_place(p) for p in own if p in self.shared or p != link.centre]
        if link.slides:
            foot, along = self.places.foot_on_guide(link)
            self.add_slider(link, foot, along)
            joints.append(foot)
        for name in link.guides:
            joints += self.add_moving_guide(name, joints)
        outline = link_outline(joints)
        self.add_link_number(link, outline)
        if len(outline) > 2:
            self.bars += symbols.plate(outline)
        elif len(outline) == 2:
            self.bars += symbols.bar(*outline)
        self.add_mass_centre(link, outline)
        for p in own:
            if p in self.shared:
                self.ways.setdefault(p, []).extend(z - self.places.point_place(p) for z in outline)

    def add_mass_centre(self, link: Link, outline: list[complex]) -> None:
        """The mass centre, and a thin arm to it if it lies away from its link."""
        centre = link.centre
        if not centre or centre in self.shared or not self.places.is_drawn(centre):
            return
        z = self.places.point_place(centre)
        self.hinges += symbols.dot(z)
        near = nearest_outline_point(z, outline)
        if abs(z - near) > SLIDER_BLOCK_SIZE_MM[0] / 2:
            self.bars.append(Line((near, z), "thin"))

    def add_slider(self, link: Link, foot: complex, along: complex) -> None:
        """The slider's block: on rails if its guide is the frame's, smaller where it is held in another block."""
        assert link.slides
        angle = direction_deg(along)
        size = self.block_size(link)
        owner = self.mechanism.owner_of_guide(link.slides.guide)
        if owner != FRAME or not self.framed:
            blocks = self.rails if size == OUTER_BLOCK_SIZE_MM else self.blocks
            blocks += symbols.block(foot, angle, size=size)
            if not self.framed and owner not in self.only:
                self.axes.append(
                    Line(
                        (foot - HALF_GUIDE_AXIS_LENGTH_MM * along, foot + HALF_GUIDE_AXIS_LENGTH_MM * along),
                        "axis",
                        "axis",
                    )
                )
            return
        side = self.rail_side(link, foot, along)
        self.rails += symbols.rail(foot, angle, HALF_RAIL_LENGTH_MM, side, size[1])
        self.rails += symbols.block(foot, angle, size=size)
        reach = (HALF_RAIL_LENGTH_MM + 4) * along
        self.axes.append(Line((foot - reach, foot + reach), "axis", "axis"))
        for letter, end in zip(guide_end_letters(link.slides.guide), (foot + reach, foot - reach), strict=True):
            if letter:
                self.named.append(
                    Label(self.naming.lettered_point(letter), end, 3.5, name=f"guide {link.slides.guide}")
                )

    def block_size(self, link: Link) -> Size:
        """The size of a slider's block: of two in one place the frame's (or the later one) holds the other."""
        if (other := self.slider_in_same_place(link)) is None:
            return SLIDER_BLOCK_SIZE_MM
        if self.mechanism.slider_rank(link) > self.mechanism.slider_rank(other):
            return OUTER_BLOCK_SIZE_MM
        return INNER_BLOCK_SIZE_MM

    def slider_in_same_place(self, link: Link) -> Link | None:
        """The other slider in the same place."""
        here = self.places.point_place(link.first_point)
        others = (x for x in self.mechanism.links.values() if x is not link)
        there = (x for x in others if x.slides and self.places.is_drawn(x.first_point))
        return next((x for x in there if abs(self.places.point_place(x.first_point) - here) < SAME_PLACE_MM), None)

    def rod_overhang(self, link: Link, rod: complex) -> float:
        """How far a rod extends beyond a slider on it: at most to the rail of the block that holds this one."""
        if (other := self.slider_in_same_place(link)) is None or self.block_size(other) != OUTER_BLOCK_SIZE_MM:
            return ROD_OVERHANG_MM
        across = abs((rod * self.places.foot_on_guide(other)[1].conjugate()).imag)
        return min(
            ROD_OVERHANG_MM,
            max(
                (OUTER_BLOCK_SIZE_MM[1] / 2 - ROD_RAIL_GAP_MM) / max(across, 1e-9),
                INNER_BLOCK_SIZE_MM[0] / 2 + ROD_RAIL_GAP_MM,
            ),
        )

    def rail_side(self, link: Link, foot: complex, along: complex) -> int:
        """The side of the slider away from its rods, or from the rest of the mechanism."""
        z = self.places.point_place(link.first_point)
        places = self.places
        rods = [
            rod
            for x in self.mechanism.links
            for rod in places.link_bars(x)
            if min(abs(z - w) for w in rod) < SAME_PLACE_MM
        ]
        far = [w for rod in rods for w in rod] or [
            places.point_place(p) for p in places.links_by_hinge if places.is_drawn(p)
        ]
        if ((sum(far) / len(far) - foot) * along.conjugate()).imag < -1:
            return 1
        return -1

    def add_moving_guide(self, name: str, joints: list[complex]) -> list[complex]:
        """The rod of a guide on a link; the place where the link's own bars join it, if none is on it."""
        if f"∥{name}" not in self.position.drawing:
            return []
        through, along = self.places.guide_line(name)
        ways = [(z - through) * along.conjugate() for z in joints]
        stops = []
        for x in self.places.sliders_on_guides(name):
            foot = ((self.places.foot_on_guide(x)[0] - through) * along.conjugate()).real
            far = self.rod_overhang(x, along)
            stops += [foot - far, foot + far]
        on = [w.real for w in ways if abs(w.imag) < SAME_PLACE_MM]
        reach = on or [w.real for w in ways[:1]]
        if not stops or not reach:
            return []
        low, high = self.rod_range(reach, stops)
        ends = through + low * along, through + high * along
        self.guides += symbols.bar(*ends)
        self.name_moving_guide(name, ends)
        off = [z for z, w in zip(joints, ways, strict=True) if abs(w.imag) >= SAME_PLACE_MM]
        self.add_rigid_joint(through + reach[0] * along, ends, off[:1])
        return [] if on else [through + reach[0] * along]

    def name_moving_guide(self, name: str, ends: Ends) -> None:
        """The letter of a guide on a link that no point has, at its free end: n of n-n, D of AD."""
        letters = re.findall(r"[A-Z]\d*", name) if re.fullmatch(r"([A-Z]\d*)+", name) else [*guide_end_letters(name)]
        own = [p for p in letters if self.places.is_drawn(p)]
        near = self.places.point_place(own[0]) if own else self.places.guide_line(name)[0]
        slides = self.position.plans.velocity_slides
        images = {x for slider, held in slides.items() if held.guide == name for x in self.letters_under(slider)}
        free = next((x for x in letters if x not in own and x not in images), "")
        if free:
            end = max(ends, key=lambda z: abs(z - near))
            self.named.append(Label(self.naming.lettered_point(free), end, 3.5, name=f"guide {name}"))

    def add_rigid_joint(self, z: complex, rod: Sequence[complex], joints: Sequence[complex]) -> None:
        """The sign of a rigid joint where the rod of a guide meets the link's own bar."""
        far = [end for end in rod if abs(end - z) > symbols.GUSSET_SIDE_MM]
        for joint in joints if far else ():
            nearer = max(far, key=lambda end: math.cos(cmath.phase((end - z) / (joint - z))))
            self.bars += symbols.rigid_joint_gusset(z, nearer, joint)

    def rod_range(self, reach: list[float], stops: list[float]) -> Interval:
        """From the place where the link holds the guide to beyond its sliders; no farther on the holding side."""
        low = min(*reach, *stops)
        high = max(*reach, *stops)
        if min(reach) <= min(stops) + ROD_OVERHANG_MM:
            low = min(reach)
        if max(reach) >= max(stops) - ROD_OVERHANG_MM:
            high = max(reach)
        return (low, high) if high - low > 1 else (min(stops), max(stops))

    def add_link_number(self, link: Link, outline: list[complex]) -> None:
        """The number of a link beside its longest side, of a slider beside its block."""
        clear = 0.0
        at: complex | Ends | None = None
        if len(outline) > 1:
            at = max(pairwise((*outline, outline[0])), key=length_of)
        elif link.slides:
            foot, along = self.places.foot_on_guide(link)
            long, wide = self.block_size(link)
            at = (foot - long / 2 * along, foot + long / 2 * along)
            clear = wide / 2
            if long < SLIDER_BLOCK_SIZE_MM[0]:
                at = foot + (long / 2 + 1j * wide / 2) * along
                clear = 0.0
        elif link.slides_round:
            at = self.places.point_place(link.first_point)
            clear = SLIDER_BLOCK_SIZE_MM[0] / 2
        elif slider := next(
            self.places.sliders_on_guides(*link.guides), None
        ):  # a hinge and a guide: the rod between them
            at = self.places.point_place(link.first_point), self.places.foot_on_guide(slider)[0]
        if at is not None:
            text = self.naming.link_number(link.name)
            name = f"link {link.name}"
            ends = at if isinstance(at, tuple) and clear else ()
            self.named.append(Label(text, at, POINT_LETTER_MM, clear=clear, name=name, underlined=True, also=ends))

    # pairs and letters

    def add_pairs(self) -> None:
        """Hinges, those on the frame with their legs."""
        for point, owners in self.shared.items():
            if not self.places.is_drawn(point) or not any(link.name in owners for link in self.links):
                continue
            z = self.places.point_place(point)
            fixed = FRAME in owners and self.framed
            ways = [w / abs(w) for w in self.ways.get(point, []) if abs(w) > SAME_PLACE_MM]
            turn = base_angle(z, ways, [*self.bars, *self.guides]) if fixed else 0.0
            self.hinges += symbols.fixed_hinge(z, turn) if fixed else symbols.hinge(z)

    def add_letters(self) -> None:
        """Letters of all points."""
        first = {p: link for link in reversed(self.links) for p in link.points if self.places.is_drawn(p)}
        for p in dict.fromkeys(p for link in self.links for p in link.points if p in first):
            z = self.places.point_place(p)
            hinged = p in self.shared
            if not hinged and p != first[p].centre:
                self.hinges += symbols.dot(z)
            clear = HINGE_RADIUS_MM if hinged else 0.8
            text = ", ".join(map(self.naming.lettered_point, (p, *self.coincident_guide_letters(p))))
            self.named.append(Label(text, z, POINT_LETTER_MM, clear=clear, priority=1, name=p))

    def coincident_guide_letters(self, point: str) -> list[str]:
        """Letters of the places on guides that coincide with a slider's point, as on the plans: L, B3."""
        slides = self.position.plans.velocity_slides
        drawn = {x.name for x in self.links}
        here = [x.name for x in self.links if x.slides and x.first_point == point and x.name in slides]
        held = (x for x in here if self.mechanism.owner_of_guide(slides[x].guide) in drawn)
        return [letter for x in held for letter in self.letters_under(x)]

    def letters_under(self, slider: str) -> list[str]:
        """The letters of the place on its guide under a slider."""
        plans = self.position.plans
        reading = plans.velocity_slides[slider]
        known = {POLE_LABEL, *(x.velocity.label for x in plans.points.values())}
        return [x.label.upper() for x in ([reading.under] if reading.under else reading.ends) if x.label not in known]
