"""The numbers of a scene that a reader may change: for a link the distances of its points and the angles between them,
for a guide its direction; and the given numbers of the program computed from them."""

import cmath
import math
from collections.abc import Iterator, Mapping
from functools import cached_property
from typing import Any

from planes.batch.symbols import Num
from planes.batch.tape import Tape
from planes.batch.tracing import given_on_tape, given_values_by_name
from planes.drafting.tools import Env, Things
from planes.geometry.arithmetic import Arithmetic, Point, Real
from planes.plans import Plans
from planes.plans.position.reckoned import OwnPlace, SceneDimensions, recompute_dimension
from planes.scene.mechanism import FRAME
from planes.words.frozen import frozen
from planes.words.names import NumbersByName, given_name_of_number

ANGLE_NAME_PREFIX = "angle_∠"
SAME_POINT_SHARE = 1e-9  # relative to a link: points closer than that are one


@frozen
class Reach:
    """A place of a link by its ``length`` from another and the ``angle`` from the link's first length: names of
    numbers; the angle is "" for that first length."""

    start: complex
    along: complex
    length: str
    angle: str = ""


def dimensions_used(how: tuple[Any, ...]) -> Iterator[tuple[str, Any]]:
    """The dimensions that a computed one uses: places, angles of guides and offsets of sliders."""
    way, *what = how
    for one in what:
        if isinstance(one, tuple) and not isinstance(one, OwnPlace):
            yield from dimensions_used(one)
        else:
            yield "place" if isinstance(one, OwnPlace) else way, one


class FreeNumbers:
    """The free numbers of a scene, by name: the givens of its program, or the numbers these are computed from."""

    def __init__(self, plans: Plans, given: Things) -> None:
        self.plans = plans
        self.given = given
        self.plain = {n: z for n, z in given.items() if n not in plans.reckoned}
        shape = SceneDimensions(plans.mechanism, plans.passive)
        self.own = dict[str, float]()
        reckoned = (plans.reckoned[n].of for n in plans.program.given_names if n in plans.reckoned)
        asked = dict.fromkeys(one for how in reckoned for one in dimensions_used(how))
        self.reaches = dict(
            self._polar_places_of_points({self.guide_point(spot) for kind, spot in asked if kind == "place"})
        )
        guides, sliders = ([name for kind, name in asked if kind == wanted] for wanted in ("angle", "offset"))
        self.turned = {g: self._add_free_number(ANGLE_NAME_PREFIX + g, shape.angle(g)) for g in guides}
        self.aside = {x: self._add_free_number(f"e_{x}", e) for x in sliders if (e := shape.offset(x))}

    def guide_point(self, spot: OwnPlace) -> OwnPlace:
        """The point on a guide, where it has one."""
        point = self.plans.mechanism.guide(spot.guide).through_point if spot.guide else None
        return OwnPlace(spot.link, point) if point else spot

    @cached_property
    def values_in_scene(self) -> NumbersByName:
        """Every free number as in the scene, of a place both coordinates."""
        flat = {n: float(z) for n, z in given_values_by_name(self.plain).items()}
        means = self.plans.means
        places = {n: z for n, z in flat.items() if (m := means.get(given_name_of_number(n))) and m.quantity == "place"}
        return {**places, **self.own, **{n: z for n, z in flat.items() if n not in places}}

    def givens_on_tape(self, tape: Tape, ar: Arithmetic) -> Env:
        """The given numbers of the program on a tape whose inputs are the free ones."""
        own = {n: Num(tape, tape.record_leaf("given", n)) for n in self.own}
        plain = {n: given_on_tape(tape, n, z) for n, z in self.plain.items()}
        return self._compute_givens(plain, own, ar)

    def givens_from_free(self, free: Mapping[str, Any], ar: Arithmetic | None = None) -> Env:
        """The given numbers of the program by free ones: numbers, or arrays of them."""
        plain = {
            n: free[f"{n}.x"] + 1j * free[f"{n}.y"] if isinstance(z, complex) else free[n]
            for n, z in self.plain.items()
        }
        return self._compute_givens(plain, free, ar or Arithmetic())

    def _compute_givens(self, things: Env, own: Mapping[str, Any], ar: Arithmetic) -> Env:
        shape = _FreeDimensions(self, things, own, ar)
        for name in self.given:
            if name in self.plans.reckoned:
                things[name] = (
                    own[name] if name in self.own else recompute_dimension(self.plans.reckoned[name].of, shape, ar)
                )
        return things

    def numbers_fixing_point(self, link: str, point: str) -> list[str]:
        """The numbers that fix a point on its link."""
        reach = self.reaches.get(OwnPlace(link, point))
        return [n for n in (reach.length, reach.angle) if n] if reach else []

    def _add_free_number(self, name: str, value: float) -> str:
        while name in self.own or (name in self.given and not self._is_same_given(name, value)):
            name += "′"
        self.own[name] = value
        return name

    def _is_same_given(self, name: str, value: float) -> bool:
        return name in self.plans.reckoned and abs(self.given[name] - value) <= SAME_POINT_SHARE * abs(value)

    def _polar_places_of_points(self, asked: set[OwnPlace]) -> Iterator[tuple[OwnPlace, Reach]]:
        """For every link: its first length, from which the angles are counted (for a slider from its axis), and the
        places of its other points."""
        for link in self.plans.mechanism.links.values():
            if len(link.points) > 1:
                meant = ((n, self.plans.means[n]) for n in self.plans.link_lengths)
                given = {(m.of, m.about): n for n, m in meant if m.link == link.name}
                base = next(iter(given), ("", ""))[0] or link.first_point
                ways = {p: z - link.points[base] for p, z in link.points.items()}
                far = [p for p, way in ways.items() if abs(way) > SAME_POINT_SHARE * max(map(abs, ways.values()))]
                ends = [q for p, q in given if p == base and q in far]
                first = "" if link.slides else next(iter(ends or far), "")
                level = ways[first] / abs(ways[first]) if first else 1 + 0j
                for p in sorted(far, key=lambda p: p != first):
                    if (spot := OwnPlace(link.name, p)) in asked:
                        named = given.get((base, p)) or given.get((p, base)) or f"l_{base}{p}"
                        length = self._add_free_number(named, abs(ways[p]))
                        turned = (
                            ""
                            if p == first
                            else self._add_free_number(
                                f"{ANGLE_NAME_PREFIX}{first}{base}{p}", direction_deg(ways[p] / level)
                            )
                        )
                        yield spot, Reach(link.points[base], level, length, turned)


def direction_deg(z: complex) -> float:
    """The direction of a vector, degrees."""
    return math.degrees(cmath.phase(z))


class _FreeDimensions(SceneDimensions):
    """The dimensions as the free numbers make them."""

    def __init__(self, free: FreeNumbers, things: Things, own: Mapping[str, Any], ar: Arithmetic) -> None:
        super().__init__(free.plans.mechanism, free.plans.passive)
        self.free = free
        self.things = things
        self.own = own
        self.ar = ar

    def place(self, spot: OwnPlace) -> Point:
        home = super().place(spot)
        if spot.link == FRAME:
            label = self.free.guide_point(spot).point or f"°{spot.guide}"
            return self.things.get(f"place_{label}", home)
        reach = self.free.reaches.get(self.free.guide_point(spot))
        if not reach:
            return home
        along = reach.along * (self.ar.cis_deg(self.own[reach.angle]) if reach.angle else 1.0)
        return reach.start + self.own[reach.length] * along

    def angle(self, guide: str) -> Real:
        return self.own[self.free.turned[guide]]

    def offset(self, slider: str) -> Real:
        if slider in self.free.aside:
            return self.own[self.free.aside[slider]]
        return super().offset(slider)
