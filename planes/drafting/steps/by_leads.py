"""Steps by some leads of a basic link, where others would be sharper once those lean: crossings, arms and cosines."""

from functools import reduce

from planes.drafting.steps import Step, directions, marks, values
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Cosine, Drop
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry import plane
from planes.geometry.arithmetic import Point, Real
from planes.words.frozen import frozen
from planes.words.names import NamePair, NameTriple, NameTuple

LEANING_LEADS_REASON = "leads_lean"
"""Reason for other plans: two leads that meet in a special point are too nearly parallel."""
LEAST_FAIR_SHARPNESS_RATIO = 0.4  # of the best crossing of two leads: a pair less sharp than this gives way to another


class ByLeads(Step):
    """A step by some leads of a basic link; others are preferred where those are too nearly parallel."""

    @property
    def sharp_directions(self) -> NameTuple:
        """The directions whose crossing should be sharp."""
        raise NotImplementedError

    def crossing_sharpnesses(self, env: Env) -> tuple[Real, ...]:
        """The sharpness of their crossings: as used, the first two, then after each rotation of the leads."""
        one, two, three, four = (env[name] for name in self.sharp_directions)
        return abs(plane.cross(one, two)), abs(plane.cross(three, four))

    def draw(self, env: Env, tool: Tool) -> Thing:
        """Draw as usual; prefer other leads where these cross much less sharply."""
        own, *others = self.crossing_sharpnesses(env)
        tool.prefer_other_leads_unless(
            own >= LEAST_FAIR_SHARPNESS_RATIO * reduce(tool.ar.maximum, others), self, LEANING_LEADS_REASON
        )
        return super().draw(env, tool)


@frozen
class CrossLeads(ByLeads, Cross):
    """The special point where the lines of two leads cross, unless a crossing with the ``third`` is much sharper."""

    third: str = ""
    third_along: str = ""
    needs = marks("start", "other", "third") + directions("along", "across", "third_along")

    @property
    def sharp_directions(self) -> NameTriple:
        return self.along, self.across, self.third_along

    def crossing_sharpnesses(self, env: Env) -> tuple[Real, Real, Real]:
        one, two, three = (env[name] for name in self.sharp_directions)
        return abs(plane.cross(one, two)), abs(plane.cross(two, three)), abs(plane.cross(three, one))


Line = tuple[Point, Point]  # a point of it, and its direction


@frozen
class CrossInChain(ByLeads, Cross):
    """The special point where the lines of two leads cross, for one of several basic links joined by hinges, unless
    another choice of the last lead or hinge makes all crossings much sharper.

    ``points`` and ``lines`` are of the leads, ``sides`` the basic link of each lead, ``pins`` the hinges, ``joined``
    the two links at each hinge. Of leads and hinges, in one sequence, ``turn`` is found last.
    """

    points: NameTuple = ()
    lines: NameTuple = ()
    pins: NameTuple = ()
    sides: tuple[int, ...] = ()
    joined: tuple[tuple[int, int], ...] = ()
    turn: int = 0
    far = "leads_parallel"
    needs = marks("start", "other", "points", "pins") + directions("along", "across", "lines")

    @property
    def sharp_directions(self) -> NameTuple:
        return self.points + self.pins + self.lines

    def crossing_sharpnesses(self, env: Env) -> tuple[Real, ...]:
        products = [self._lines_to_basic_link(env, side, last)[1] for last, side in enumerate(self.sides)]
        for last, (one, two) in enumerate(self.joined, len(self.sides)):
            products.append(self._lines_to_basic_link(env, one, last)[1] * self._lines_to_basic_link(env, two, last)[1])
        return *products[self.turn :], *products[: self.turn]

    def _lines_to_basic_link(self, env: Env, basic: int, but: int) -> tuple[list[Line], Real]:
        """The lines that lead to a basic link, except one, and the sharpness of all crossings on the way."""
        lines = []
        sharp: Real = 1.0
        for k, side in enumerate(self.sides):
            if side == basic and k != but:
                lines.append((env[self.points[k]], env[self.lines[k]]))
        for k, ends in enumerate(self.joined, len(self.sides)):
            if basic in ends and k != but:
                beyond, sharpness = self._lines_to_basic_link(env, sum(ends) - basic, k)
                pin = env[self.pins[k - len(self.sides)]]
                lines.append((pin, _direction_to_crossing(pin, *beyond)))
                sharp = sharp * sharpness
        (_, ray), (_, other) = lines
        return lines, sharp * abs(plane.cross(ray, other))


def _direction_to_crossing(pin: Point, one: Line, two: Line) -> Point:
    """The direction from a place to the crossing of two lines, or along both where they are parallel."""
    p, u = one
    q, w = two
    line = u * plane.cross(q - pin, w) - w * plane.cross(p - pin, u)
    size = abs(line)
    return line / (size + (size == 0))


@frozen
class CrossFalse(ByLeads, Cross):
    """The hinge of a rod on a false plan, unless the other rod gives it much more sharply (``instead``: the directions
    to cross then)."""

    instead: NamePair = ("", "")
    needs = marks("start", "other") + directions("along", "across", "instead")

    @property
    def sharp_directions(self) -> NameTuple:
        return self.along, self.across, *self.instead


@frozen
class DropFalse(ByLeads, Drop):
    """The arm of a rod's line about the hinge of its driven link, unless the other rod is much better placed
    (``crossed``: the line of the rod, of the hinges it leads to, and both of the other rod)."""

    lines: tuple[str, str, str, str] = ("", "", "", "")
    needs = marks("point", "about") + directions("along", "lines") + values("mu")

    @property
    def sharp_directions(self) -> NameTuple:
        return self.lines


@frozen
class CosineFalse(ByLeads, Cosine):
    """The component factor of a lead's force along the driven guide, unless the other lead is much better placed
    (``crossed``: the line of the lead, that across the guide, and both of the other lead)."""

    lines: tuple[str, str, str, str] = ("", "", "", "")
    needs = directions("of", "along", "lines")

    @property
    def sharp_directions(self) -> NameTuple:
        return self.lines
