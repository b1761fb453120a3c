"""Intersections of two lines, a line and an arc, or two arcs, and the tangent to a circle: the steps that can fail."""

from planes.drafting.steps import MarkStep, Reads, Step, directions, marks, values
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry import plane
from planes.geometry.arithmetic import Real
from planes.words.frozen import frozen
from planes.words.names import Mark


@frozen
class Cross(MarkStep):
    """Cross two lines. A ``supposed`` crossing is a trial: parallel lines give no mark instead of a failure."""

    start: Mark
    along: str
    other: Mark
    across: str
    supposed: bool = False
    far = "parallel"  # the reasons for its absence
    same = "coincident"
    needs = marks("start", "other") + directions("along", "across")

    def crossing_and_sharpness(self, env: Env, tool: Tool) -> plane.Met:
        """Where the lines cross, how sharply, and how far apart they are there if they are parallel."""
        u = tool.transfer_direction(env[self.along])
        w = tool.transfer_direction(env[self.across])
        return plane.intersect_lines(env[self.start], u, env[self.other], w)

    def draw(self, env: Env, tool: Tool) -> Thing:
        place, sharpness, gap = self.crossing_and_sharpness(env, tool)
        tool.record_sharpness(self.makes, abs(sharpness))
        met = abs(sharpness) > tool.flat
        if self.supposed:
            return tool.ar.where(met, tool.mark(place), complex("nan"))
        size = tool.ar.size
        apart = abs(gap) > tool.slack * (size(env[self.start]) + size(env[self.other]))
        tool.fail_unless(met | apart, self, self.same, gap_mm=gap)
        tool.fail_unless(met, self, self.far, gap_mm=gap)
        return tool.mark(place)


class TwoPlaces(Step):
    """A step with two solutions, one of which is selected by a side; they merge where the construction only just
    exists."""

    def opening_measure(self, env: Env) -> Real:
        """Positive where it can be drawn, negative where it cannot, and smooth in between: mm² or mm⁴."""
        raise NotImplementedError


@frozen
class CrossArc(TwoPlaces, MarkStep):
    """Cross a line with an arc of a given radius (SI) about a mark; ``side`` +1 is ahead along the line.

    ``arm`` names the mark, direction and length by which the centre was laid off, for exact instruments.
    """

    start: Mark
    along: str
    centre: Mark
    radius: str
    mu: str
    side: str
    arm: tuple[Mark, str, str] | None = None

    def input_names(self) -> Reads:
        hub, ray, length = self.arm or (None, None, None)
        lines = directions(self.along, ray)
        return marks(self.start, self.centre, hub) + lines + values(self.radius, self.mu, self.side, length)

    def draw(self, env: Env, tool: Tool) -> Thing:
        radius = abs(env[self.radius] * env[self.mu])
        u = tool.transfer_direction(env[self.along])
        arm = None
        if self.arm and not tool.doubt_mm:
            hub, ray, length = self.arm
            arm = env[hub], env[ray], env[length] * env[self.mu]
        start = env[self.start]
        centre = env[self.centre]
        side = env[self.side]
        place, sharpness, miss = plane.intersect_line_circle(start, u, centre, radius, side, tool.ar, arm)
        tool.record_sharpness(self.makes, sharpness)
        slack = tool.slack * (tool.ar.size(start) + tool.ar.size(centre) + radius)
        tool.fail_unless(radius > 0, self, "no_length")
        tool.fail_unless(miss <= slack, self, "arc_short", miss_mm=miss, miss=miss / env[self.mu])
        return tool.mark(place)

    def opening_measure(self, env: Env) -> Real:
        radius = env[self.radius] * env[self.mu]
        height = plane.cross(env[self.along], env[self.centre] - env[self.start])
        return (radius - height) * (radius + height)


@frozen
class CrossArcs(TwoPlaces, MarkStep):
    """Cross two arcs (засечки); ``side`` +1 is to the left of the way from ``centre`` to ``other``."""

    centre: Mark
    radius: str
    other: Mark
    other_radius: str
    mu: str
    side: str
    needs = marks("centre", "other") + values("radius", "other_radius", "mu", "side")

    def draw(self, env: Env, tool: Tool) -> Thing:
        r = abs(env[self.radius] * env[self.mu])
        s = abs(env[self.other_radius] * env[self.mu])
        centre = env[self.centre]
        other = env[self.other]
        place, sharpness, far, near = plane.intersect_circles(centre, r, other, s, env[self.side], tool.ar)
        tool.record_sharpness(self.makes, sharpness)
        slack = tool.slack * (tool.ar.size(centre) + tool.ar.size(other) + r + s)
        square = plane.dot(other - centre, other - centre)  # test without its square root
        tool.fail_unless((r > 0) & (s > 0), self, "no_lengths")
        tool.fail_unless(square <= (r + s + slack) ** 2, self, "arcs_apart", miss_mm=far, miss=far / env[self.mu])
        outside = square >= tool.ar.maximum(abs(r - s) - slack, 0.0) ** 2
        tool.fail_unless(outside, self, "arcs_inside", miss_mm=near, miss=near / env[self.mu])
        tool.fail_unless(square > slack * slack, self, "arcs_coincide")
        return tool.mark(place)

    def opening_measure(self, env: Env) -> Real:
        r = env[self.radius] * env[self.mu]
        s = env[self.other_radius] * env[self.mu]
        apart = env[self.other] - env[self.centre]
        square = plane.dot(apart, apart)
        return ((r + s) ** 2 - square) * (square - (r - s) ** 2)


@frozen
class Touch(TwoPlaces):
    """The direction of the line through ``start`` that passes ``end`` at a given offset (SI) to its left: the tangent
    to a circle, or simply the line through both when ``offset`` is None."""

    start: Mark
    end: Mark
    offset: str | None
    mu: str
    side: str
    kind = "direction"
    needs = marks("start", "end") + values("offset", "mu", "side")

    def draw(self, env: Env, tool: Tool) -> Thing:
        offset = env[self.offset] * env[self.mu] if self.offset else 0.0
        start = env[self.start]
        end = env[self.end]
        u, sharpness, miss = plane.tangent_direction(start, end, offset, env[self.side], tool.ar)
        tool.record_sharpness(self.makes, sharpness)
        slack = tool.slack * (tool.ar.size(start) + tool.ar.size(end) + abs(offset))
        tool.fail_unless(miss <= slack, self, "circle_large", miss_mm=miss, miss=miss / env[self.mu])
        tool.fail_unless(abs(end - start) > slack, self, "points_meet", miss_mm=miss)
        return u

    def opening_measure(self, env: Env) -> Real:
        offset = env[self.offset] * env[self.mu] if self.offset else 0.0
        apart = env[self.end] - env[self.start]
        return plane.dot(apart, apart) - offset * offset
