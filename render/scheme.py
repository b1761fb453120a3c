"""The scheme of a mechanism in one position, with the signs of ГОСТ 2.770: guides, sliders, links, hinges, letters."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, field

import shapely

from planes.bodies import SCHEME
from planes.drafting import at
from planes.mechanism import FRAME, Link
from planes.solving import Position
from render import labels, symbols
from render.footprints import ink
from render.marks import Line, Mark
from render.names import Naming, lettered
from render.style import BLOCK_MM, HINGE_MM

NEAR_MM = 0.4
RAIL_MM = 17.0  # of a guide shown on each side of its slider
ROD_MM = 12.0  # of a moving guide shown beyond its slider
LETTER_MM = 5.0
SMALL_MM = (8.0, 4.6)  # a block held inside another
LARGE_MM = (14.0, 10.5)  # the block that holds it


@dataclass
class Scheme:
    """The scheme being drawn; places are mm of paper about the origin of the frame's axes."""

    position: Position
    naming: Naming
    axes: list[Mark] = field(default_factory=list)
    rails: list[Mark] = field(default_factory=list)
    guides: list[Mark] = field(default_factory=list)
    blocks: list[Mark] = field(default_factory=list)
    bars: list[Mark] = field(default_factory=list)
    hinges: list[Mark] = field(default_factory=list)
    named: list[labels.Label] = field(default_factory=list)
    ways: dict[str, list[complex]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        self.mechanism = self.position.plans.mechanism
        self.shared = self._shared()

    def _shared(self) -> dict[str, list[str]]:
        """Points of more than one link, with those links: the hinges."""
        held: dict[str, list[str]] = {}
        for link in (self.mechanism.frame, *self.mechanism.links.values()):
            for point in link.points:
                held.setdefault(point, []).append(link.name)
        return {point: owners for point, owners in held.items() if len(owners) > 1}

    def has(self, point: str) -> bool:
        """Whether the point has been drawn."""
        return at(SCHEME, point) in self.position.drawing

    def at(self, point: str) -> complex:
        """Where a point stands."""
        return complex(self.position.drawing[at(SCHEME, point)])

    def drawn(self, arrows: bool = True) -> tuple[Mark, ...]:
        """All marks: guides, sliders, bars, hinges, letters, and the driver's arrows."""
        for link in self.mechanism.links.values():
            if all(map(self.has, link.points)):
                self.link(link)
        self.pairs()
        self.letters()
        ground: list[Mark] = [*self.axes, *self.rails, *self.guides, *self.blocks, *self.bars, *self.hinges]
        if arrows:
            ground += self.driver_arrows(ground)
        return (*ground, *labels.place(self.named, ground).marks)

    # links

    def link(self, link: Link) -> None:
        """A link's bar or plate, its own guides, and its slider if it slides."""
        joints = [self.at(p) for p in link.points if p in self.shared or p != link.centre]
        if link.slides:
            foot, along = self.foot(link)
            self.slider(link, foot, along)
            joints.append(foot)
        for name in link.guides:
            joints += self.moving_guide(name, joints)
        outline = _outline(joints)
        self.number(link, outline)
        if len(outline) == 2:
            self.bars += symbols.bar(*outline)
        elif len(outline) > 2:
            size = max(abs(a - b) for a in outline for b in outline)
            self.bars += symbols.plate(outline, max(2.5, size / 16))
        self.offside(link, outline)
        for p in link.points:
            if p in self.shared:
                self.ways.setdefault(p, []).extend(z - self.at(p) for z in outline)

    def offside(self, link: Link, outline: list[complex]) -> None:
        """The mass centre, and a thin arm to it where it lies away from its link."""
        centre = link.centre
        if not centre or centre in self.shared or not self.has(centre):
            return
        z = self.at(centre)
        self.hinges += symbols.dot(z)
        near = _nearest(z, outline)
        if abs(z - near) > BLOCK_MM[0] / 2:
            self.bars.append(Line((near, z), "thin"))

    def line(self, guide: str) -> tuple[complex, complex]:
        """A point of a guide's line and its direction."""
        given = self.mechanism.guide(guide)
        label = given.through_point or f"°{guide}"
        along = complex(self.position.drawing[f"∥{guide}"])
        if self.has(label):
            return self.at(label), along
        slider = next(x for x in self.mechanism.links.values() if x.slides and x.slides.guide == guide)
        offset = slider.slides.offset if slider.slides else None
        mu = self.position.scales[f"mu_{SCHEME}"]
        return self.at(slider.first_point) - 1j * along * (offset or 0.0) * mu, along

    def foot(self, link: Link) -> tuple[complex, complex]:
        """The foot of a slider's first point on its guide, and the guide's direction."""
        assert link.slides
        through, along = self.line(link.slides.guide)
        first = self.at(link.first_point)
        return through + ((first - through) * along.conjugate()).real * along, along

    def slider(self, link: Link, foot: complex, along: complex) -> None:
        """The slider's block: on rails if its guide is the frame's, smaller where it is held in another block."""
        assert link.slides
        angle = _degrees(along)
        if self.mechanism.owner(link.slides.guide) != FRAME:
            self.blocks += symbols.block(foot, angle, size=SMALL_MM if self.doubled(link) else BLOCK_MM)
            return
        size = LARGE_MM if self.doubled(link) else BLOCK_MM
        side = self.rail_side(foot, along)
        self.rails += symbols.frame_guide(foot, angle, RAIL_MM, RAIL_MM, "rail", side, size[1])
        self.rails += symbols.block(foot, angle, size=size)
        reach = RAIL_MM + 4
        self.axes.append(Line((foot - reach * along, foot + reach * along), "axis", "axis"))
        first, _, second = link.slides.guide.partition("-")
        for letter, end in ((first, foot + reach * along), (second, foot - reach * along)):
            if letter:
                self.named.append(labels.Label(lettered(letter), end, 3.5, name=f"guide {link.slides.guide}"))

    def doubled(self, link: Link) -> bool:
        """Whether another slider is hinged to this one, in one place."""
        others = [x for x in self.mechanism.links.values() if x is not link and x.slides]
        return any(self.has(x.first_point) and abs(self.at(x.first_point) - self.at(link.first_point)) < NEAR_MM
                   for x in others)  # fmt: skip

    def rail_side(self, foot: complex, along: complex) -> int:
        """The side of the slider that is away from the rest of the mechanism."""
        others = [self.at(p) for x in self.mechanism.links.values() for p in x.points if self.has(p)]
        middle = sum(others) / len(others)
        return 1 if ((middle - foot) * along.conjugate()).imag < -1 else -1

    def moving_guide(self, name: str, joints: list[complex]) -> list[complex]:
        """The rod of a guide that a link carries; the place where the link's own bars join it, if none is on it."""
        if f"∥{name}" not in self.position.drawing:
            return []
        through, along = self.line(name)
        ways = [(z - through) * along.conjugate() for z in joints]
        stops = []
        for slider in self.mechanism.links.values():
            if slider.slides and slider.slides.guide == name and self.has(slider.first_point):
                t = ((self.foot(slider)[0] - through) * along.conjugate()).real
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
            foot, along = self.foot(link)
            ends, clear = (foot - BLOCK_MM[0] / 2 * along, foot + BLOCK_MM[0] / 2 * along), BLOCK_MM[1] / 2
        else:
            self.rod_number(link, text)
            return
        self.named.append(labels.Label(text, ends, LETTER_MM, clear=clear, name=f"link {link.name}"))

    def rod_number(self, link: Link, text: str) -> None:
        """The number of a link that is a hinge and a guide: beside the rod between them."""
        for slider in self.mechanism.links.values():
            if slider.slides and slider.slides.guide in link.guides and self.has(slider.first_point):
                ends = self.at(link.first_point), self.foot(slider)[0]
                self.named.append(labels.Label(text, ends, LETTER_MM, name=f"link {link.name}"))
                return

    # pairs and letters

    def pairs(self) -> None:
        """Hinges, those on the frame with their legs."""
        for point, owners in self.shared.items():
            if not self.has(point):
                continue
            z = self.at(point)
            if FRAME in owners:
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
        for link in (self.mechanism.frame, *self.mechanism.links.values()):
            for p in link.points:
                if not self.has(p) or any(p == name for _, name in done):
                    continue
                if link.name == FRAME and p not in self.shared:
                    continue
                z, hinged = self.at(p), p in self.shared
                done.append((z, p))
                if not hinged and p != link.centre:
                    self.hinges += symbols.dot(z)
                clear = HINGE_MM if hinged else 0.8
                self.named.append(labels.Label(self.naming.point(p), z, LETTER_MM, clear=clear, priority=1, name=p))

    def driver_arrows(self, ground: list[Mark]) -> list[Mark]:
        """Curved arrows of the driver's ω and ε about its pivot, or a straight one of a sliding driver's v."""
        drive, pair = self.mechanism.drive, self.position.plans.structure.drive_pair
        if drive.kind == "s" or not self.has(pair.point):
            return []
        found: list[Mark] = []
        for rate, letter, radius in ((drive.velocity, "ω", 9.0), (drive.acceleration, "ε", 12.5)):
            if rate:
                arrow, middle = self.free_arc(self.at(pair.point), radius, math.copysign(1, rate), [*ground, *found])
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
        return [self.at(p) - pivot for p in self.mechanism.links[self.mechanism.drive.link].points if self.has(p)]


def _degrees(along: complex) -> float:
    return round(math.degrees(cmath.phase(along)), 9)


def _off(z: complex, a: complex, b: complex) -> float:
    """Distance of a point from a line."""
    way = (b - a) / abs(b - a)
    return abs(((z - a) * way.conjugate()).imag)


def _outline(places: list[complex]) -> list[complex]:
    """The corners of a link: one point, the ends of a bar, or the hull of a plate."""
    unique: list[complex] = []
    for z in places:
        if all(abs(z - u) > NEAR_MM for u in unique):
            unique.append(z)
    if len(unique) < 3:
        return unique
    a, b = max(((p, q) for p in unique for q in unique), key=lambda e: abs(e[1] - e[0]))
    if all(_off(z, a, b) < NEAR_MM for z in unique):
        return [a, b]
    hull = shapely.MultiPoint([(z.real, z.imag) for z in unique]).convex_hull
    return [complex(x, y) for x, y in list(hull.exterior.coords)[:-1]]


def _nearest(z: complex, outline: list[complex]) -> complex:
    """The point of a link's outline that is nearest to a place."""
    if len(outline) == 1:
        return outline[0]
    if len(outline) > 2:
        shape = shapely.Polygon([(c.real, c.imag) for c in outline])
        if shape.contains(shapely.Point(z.real, z.imag)):
            return z
    feet = []
    for a, b in zip(outline, outline[1:] + outline[:1], strict=True):
        t = ((z - a) * (b - a).conjugate()).real / abs(b - a) ** 2
        feet.append(a + min(1.0, max(0.0, t)) * (b - a))
    return min(feet, key=lambda foot: abs(foot - z))
