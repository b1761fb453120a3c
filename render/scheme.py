"""The scheme of a mechanism in one position, with the signs of ГОСТ 2.770: guides, sliders, links, hinges, letters."""

from __future__ import annotations

import cmath
import math
from collections.abc import Sequence
from dataclasses import dataclass, field

from planes.mechanism import FRAME, Link
from planes.solving import Position
from render import labels, symbols
from render.footprints import ink
from render.marks import Line, Mark
from render.names import Naming, lettered
from render.places import NEAR_MM, Places, degrees, nearest, outline_of
from render.style import BLOCK_MM, HINGE_MM

RAIL_MM = 17.0  # of a guide shown on each side of its slider
ROD_MM = 12.0  # of a moving guide shown beyond its slider
LETTER_MM = 5.0
SMALL_MM = (8.0, 4.6)  # a block held inside another
ALONE_MM = 13.0  # of the axis of a guide that is not drawn, on each side of its slider
LARGE_MM = (14.0, 10.5)  # the block that holds it


@dataclass
class Scheme:
    """The scheme being drawn; places are mm of paper about the origin of the frame's axes."""

    position: Position
    naming: Naming
    only: tuple[str, ...] = ()  # the links that are drawn; none named: all
    framed: bool = True  # whether the frame is drawn
    axes: list[Mark] = field(default_factory=list)
    rails: list[Mark] = field(default_factory=list)
    guides: list[Mark] = field(default_factory=list)
    blocks: list[Mark] = field(default_factory=list)
    bars: list[Mark] = field(default_factory=list)
    hinges: list[Mark] = field(default_factory=list)
    named: list[labels.Label] = field(default_factory=list)
    ways: dict[str, list[complex]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.places = Places(self.position)
        self.mechanism, self.shared = self.places.mechanism, self.places.shared
        self.links = [x for n, x in self.mechanism.links.items() if not self.only or n in self.only]

    def drawn(
        self, arrows: bool = True, marks: Sequence[Mark] = (), named: Sequence[labels.Label] = ()
    ) -> tuple[Mark, ...]:
        """All marks: guides, sliders, bars, hinges, letters, the driver's arrows; and what is drawn on top."""
        for link in self.links:
            if all(map(self.places.has, link.points)):
                self.link(link)
        self.pairs()
        self.letters()
        ground: list[Mark] = [*self.axes, *self.rails, *self.guides, *self.blocks, *self.bars, *self.hinges]
        ground += marks
        if arrows:
            ground += self.driver_arrows(ground)
        return (*ground, *labels.place([*self.named, *named], ground).marks)

    # links

    def link(self, link: Link) -> None:
        """A link's bar or plate, its own guides, and its slider if it slides."""
        joints = [self.places.at(p) for p in link.points if p in self.shared or p != link.centre]
        if link.slides:
            foot, along = self.places.foot(link)
            self.slider(link, foot, along)
            joints.append(foot)
        for name in link.guides:
            joints += self.moving_guide(name, joints)
        outline = outline_of(joints)
        self.number(link, outline)
        if len(outline) == 2:
            self.bars += symbols.bar(*outline)
        elif len(outline) > 2:
            size = max(abs(a - b) for a in outline for b in outline)
            self.bars += symbols.plate(outline, max(2.5, size / 16))
        self.offside(link, outline)
        for p in link.points:
            if p in self.shared:
                self.ways.setdefault(p, []).extend(z - self.places.at(p) for z in outline)

    def offside(self, link: Link, outline: list[complex]) -> None:
        """The mass centre, and a thin arm to it where it lies away from its link."""
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
        angle = degrees(along)
        if self.mechanism.owner(link.slides.guide) != FRAME or not self.framed:
            self.blocks += symbols.block(foot, angle, size=SMALL_MM if self.places.doubled(link) else BLOCK_MM)
            if not self.framed and self.mechanism.owner(link.slides.guide) not in self.only:
                self.axes.append(Line((foot - ALONE_MM * along, foot + ALONE_MM * along), "axis", "axis"))
            return
        size = LARGE_MM if self.places.doubled(link) else BLOCK_MM
        side = self.rail_side(foot, along)
        self.rails += symbols.frame_guide(foot, angle, RAIL_MM, RAIL_MM, "rail", side, size[1])
        self.rails += symbols.block(foot, angle, size=size)
        reach = RAIL_MM + 4
        self.axes.append(Line((foot - reach * along, foot + reach * along), "axis", "axis"))
        first, _, second = link.slides.guide.partition("-")
        for letter, end in ((first, foot + reach * along), (second, foot - reach * along)):
            if letter:
                self.named.append(labels.Label(lettered(letter), end, 3.5, name=f"guide {link.slides.guide}"))

    def rail_side(self, foot: complex, along: complex) -> int:
        """The side of the slider that is away from the rest of the mechanism."""
        others = [self.places.at(p) for x in self.mechanism.links.values() for p in x.points if self.places.has(p)]
        middle = sum(others) / len(others)
        return 1 if ((middle - foot) * along.conjugate()).imag < -1 else -1

    def moving_guide(self, name: str, joints: list[complex]) -> list[complex]:
        """The rod of a guide that a link carries; the place where the link's own bars join it, if none is on it."""
        if f"∥{name}" not in self.position.drawing:
            return []
        through, along = self.places.line(name)
        ways = [(z - through) * along.conjugate() for z in joints]
        stops = []
        for slider in self.mechanism.links.values():
            if slider.slides and slider.slides.guide == name and self.places.has(slider.first_point):
                t = ((self.places.foot(slider)[0] - through) * along.conjugate()).real
                stops += [t - ROD_MM, t + ROD_MM]
        on = [w.real for w in ways if abs(w.imag) < NEAR_MM]
        reach = on or [w.real for w in ways[:1]]
        if not stops or not reach:
            return []
        low, high = self.rod(reach, stops)
        self.guides += symbols.bar(through + low * along, through + high * along)
        return [] if on else [through + reach[0] * along]

    def rod(self, reach: list[float], stops: list[float]) -> tuple[float, float]:
        """From where the link holds the guide to beyond its sliders; no more than that on the holding side."""
        low, high = min([*reach, *stops]), max([*reach, *stops])
        if min(reach) <= min(stops) + ROD_MM:
            low = min(reach)
        if max(reach) >= max(stops) - ROD_MM:
            high = max(reach)
        return (low, high) if high - low > 1 else (min(stops), max(stops))

    def number(self, link: Link, outline: list[complex]) -> None:
        """The number of a link beside its longest side, of a slider beside its block."""
        text, clear = self.naming.link(link.name), 0.0
        if len(outline) > 1:
            ends = max(zip(outline, outline[1:] + outline[:1], strict=True), key=lambda e: abs(e[1] - e[0]))
        elif link.slides:
            foot, along = self.places.foot(link)
            ends, clear = (foot - BLOCK_MM[0] / 2 * along, foot + BLOCK_MM[0] / 2 * along), BLOCK_MM[1] / 2
        else:
            self.rod_number(link, text)
            return
        self.named.append(labels.Label(text, ends, LETTER_MM, clear=clear, name=f"link {link.name}"))

    def rod_number(self, link: Link, text: str) -> None:
        """The number of a link that is a hinge and a guide: beside the rod between them."""
        for slider in self.mechanism.links.values():
            if slider.slides and slider.slides.guide in link.guides and self.places.has(slider.first_point):
                ends = self.places.at(link.first_point), self.places.foot(slider)[0]
                self.named.append(labels.Label(text, ends, LETTER_MM, name=f"link {link.name}"))
                return

    # pairs and letters

    def pairs(self) -> None:
        """Hinges, those on the frame with their legs."""
        for point, owners in self.shared.items():
            if not self.places.has(point) or not any(link.name in owners for link in self.links):
                continue
            z = self.places.at(point)
            if FRAME in owners and self.framed:
                self.hinges += symbols.fixed_hinge(z, self.base_angle(point))
            else:
                self.hinges += symbols.hinge(z)

    def base_angle(self, point: str) -> float:
        """The turn of a fixed hinge's base that keeps clear of the bars: upright if it can be."""
        ways = [w / abs(w) for w in self.ways.get(point, []) if abs(w) > NEAR_MM]

        def room(turn: int) -> float:
            leg = -1j * symbols.unit(turn)
            return min((math.degrees(abs(cmath.phase(w / leg))) for w in ways), default=180.0)

        turns = (0, 90, 270, 180)
        return float(next((t for t in turns if room(t) > 50), max(turns, key=room)))

    def letters(self) -> None:
        """Letters of all points."""
        done: list[tuple[complex, str]] = []
        for link in self.links:
            for p in link.points:
                if not self.places.has(p) or any(p == name for _, name in done):
                    continue
                z, hinged = self.places.at(p), p in self.shared
                done.append((z, p))
                if not hinged and p != link.centre:
                    self.hinges += symbols.dot(z)
                clear = HINGE_MM if hinged else 0.8
                self.named.append(labels.Label(self.naming.point(p), z, LETTER_MM, clear=clear, priority=1, name=p))

    def driver_arrows(self, ground: list[Mark]) -> list[Mark]:
        """Curved arrows of the driver's ω and ε about its pivot, or a straight one of a sliding driver's v."""
        drive, pair = self.mechanism.drive, self.position.plans.structure.drive_pair
        if drive.kind == "s" or not self.places.has(pair.point):
            return []
        found: list[Mark] = []
        for rate, letter, radius in ((drive.velocity, "ω", 9.0), (drive.acceleration, "ε", 12.5)):
            if rate:
                pivot, sense = self.places.at(pair.point), math.copysign(1, rate)
                arrow, middle = self.free_arc(pivot, radius, sense, [*ground, *found])
                found += arrow
                text = f"{letter}_{{{self.naming.link(drive.link)}}}"
                self.named.append(labels.Label(text, middle, LETTER_MM, clear=0.5, name=text))
        return found

    def free_arc(
        self, pivot: complex, radius: float, sense: float, ground: list[Mark]
    ) -> tuple[tuple[Mark, ...], complex]:
        """A curved arrow where it crosses nothing, near the crank; and the middle of its arc."""
        crank = math.degrees(cmath.phase(max(self.ways_from(pivot), key=abs, default=1 + 0j)))
        inked = ink(ground)
        best: tuple[int, tuple[Mark, ...], float] | None = None
        for turn in (15, 30, 60, 100, 140, 180, 220, 260, -110, -80):
            start = crank + sense * turn
            arrow = symbols.turn_arrow(pivot, radius, start, sense * 60)
            hits = len(inked.within(ink(arrow).shapes, 0.6)[0])
            if best is None or hits < best[0]:
                best = hits, arrow, start + sense * 30
        assert best
        return best[1], pivot + radius * symbols.unit(best[2])

    def ways_from(self, pivot: complex) -> list[complex]:
        """Ways from the pivot to the driver's other points."""
        points = self.mechanism.links[self.mechanism.drive.link].points
        return [self.places.at(p) - pivot for p in points if self.places.has(p)]
