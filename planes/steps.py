"""The steps of a drawing as frozen records, each a draughtsman's verb, and how each is drawn.

A step makes one named thing (a mark in mm on a plan, a direction, or a value in SI) from things made before. Marks
are named "plan:label" ("velocity:c"). A step is drawn by an instrument (``tool``), which owns the arithmetic, the
errors of hand and ruler, and what a failure does; so the same step serves one position or an array of many.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar, Literal

from planes import plane
from planes.tools import Env, Tool

Kind = Literal["mark", "direction", "value", "place"]
Read = tuple[str, Kind]


@dataclass(frozen=True)
class Step:
    """One step; ``makes`` is the name of what it draws or reckons."""

    makes: str
    kind: ClassVar[Kind] = "mark"

    def reads(self) -> tuple[Read, ...]:
        """Names of what the step needs, each with its kind."""
        raise NotImplementedError

    def draw(self, env: Env, tool: Tool) -> Any:
        """The thing itself, from the things in ``env``."""
        raise NotImplementedError


def _marks(*names: str | None) -> tuple[Read, ...]:
    return tuple((n, "mark") for n in names if n)


def _directions(*names: str | None) -> tuple[Read, ...]:
    return tuple((n, "direction") for n in names if n)


def _values(*names: str | None) -> tuple[Read, ...]:
    return tuple((n, "value") for n in names if n)


@dataclass(frozen=True)
class Put(Step):
    """Put a mark at a given place of the plan (m, by the scale), or at its pole when ``at`` is None."""

    at: str | None = None
    mu: str | None = None

    def reads(self) -> tuple[Read, ...]:
        return ((self.at, "place"), *_values(self.mu)) if self.at else ()

    def draw(self, env: Env, tool: Tool) -> Any:
        return tool.mark(env[self.at] * env[self.mu]) if self.at and self.mu else 0j


@dataclass(frozen=True)
class Aim(Step):
    """A direction at a given angle (degrees) from the x axis, by protractor."""

    angle: str
    kind: ClassVar[Kind] = "direction"

    def reads(self) -> tuple[Read, ...]:
        return _values(self.angle)

    def draw(self, env: Env, tool: Tool) -> Any:
        return tool.ar.cis_deg(env[self.angle])


@dataclass(frozen=True)
class Through(Step):
    """The direction from one mark to another; of two coinciding marks (a zero vector), any."""

    start: str
    end: str
    kind: ClassVar[Kind] = "direction"

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.start, self.end)

    def draw(self, env: Env, tool: Tool) -> Any:
        return plane.unit(env[self.end] - env[self.start], tool.ar)


@dataclass(frozen=True)
class Turn(Step):
    """A direction turned by ``quarter`` right angles (set square) and by a given angle (degrees)."""

    of: str
    quarter: int = 0
    angle: str | None = None
    kind: ClassVar[Kind] = "direction"

    def reads(self) -> tuple[Read, ...]:
        return _directions(self.of) + _values(self.angle)

    def draw(self, env: Env, tool: Tool) -> Any:
        turned = env[self.of] * (1, 1j, -1, -1j)[self.quarter % 4]
        return turned * tool.ar.cis_deg(env[self.angle]) if self.angle else turned


@dataclass(frozen=True)
class LayOff(Step):
    """Lay a signed length (SI, by the scale) off from a mark along a direction."""

    start: str
    along: str
    length: str
    mu: str

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.start) + _directions(self.along) + _values(self.length, self.mu)

    def draw(self, env: Env, tool: Tool) -> Any:
        return tool.mark(env[self.start] + tool.ray(env[self.along]) * (env[self.length] * env[self.mu]))


@dataclass(frozen=True)
class Carry(Step):
    """Carry the segment ``first``–``second`` to ``start``, turned by ``quarter`` right angles."""

    start: str
    first: str
    second: str
    quarter: int = 0

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.start, self.first, self.second)

    def draw(self, env: Env, tool: Tool) -> Any:
        segment = (env[self.second] - env[self.first]) * (1, 1j, -1, -1j)[self.quarter % 4]
        return tool.mark(env[self.start] + segment)


@dataclass(frozen=True)
class Same(Step):
    """Another name for a mark: the points of a link that does not turn share one end on the plan."""

    of: str

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.of)

    def draw(self, env: Env, tool: Tool) -> Any:
        return env[self.of]


@dataclass(frozen=True)
class Cross(Step):
    """Cross two lines."""

    start: str
    along: str
    other: str
    across: str

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.start, self.other) + _directions(self.along, self.across)

    def draw(self, env: Env, tool: Tool) -> Any:
        u, w = tool.ray(env[self.along]), tool.ray(env[self.across])
        place, sharpness, gap = plane.lines(env[self.start], u, env[self.other], w)
        tool.sharpen(self.makes, abs(sharpness))
        met = abs(sharpness) > tool.flat
        apart = abs(gap) > tool.slack * (abs(env[self.start]) + abs(env[self.other]))
        tool.require(met | apart, self, "coincident", gap_mm=gap)
        tool.require(met, self, "parallel", gap_mm=gap)
        return tool.mark(place)


@dataclass(frozen=True)
class CrossArc(Step):
    """Cross a line with an arc of a given radius (SI) about a mark; ``side`` +1 is ahead along the line."""

    start: str
    along: str
    centre: str
    radius: str
    mu: str
    side: str

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.start, self.centre) + _directions(self.along) + _values(self.radius, self.mu, self.side)

    def draw(self, env: Env, tool: Tool) -> Any:
        radius = abs(env[self.radius] * env[self.mu])
        u = tool.ray(env[self.along])
        place, sharpness, miss = plane.line_arc(env[self.start], u, env[self.centre], radius, env[self.side], tool.ar)
        tool.sharpen(self.makes, sharpness)
        slack = tool.slack * (abs(env[self.start]) + abs(env[self.centre]) + radius)
        tool.require(miss <= slack, self, "arc_short", miss_mm=miss)
        tool.require(radius > 0, self, "no_length")
        return tool.mark(place)


@dataclass(frozen=True)
class CrossArcs(Step):
    """Cross two arcs (засечки); ``side`` +1 is to the left of the way from ``centre`` to ``other``."""

    centre: str
    radius: str
    other: str
    other_radius: str
    mu: str
    side: str

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.centre, self.other) + _values(self.radius, self.other_radius, self.mu, self.side)

    def draw(self, env: Env, tool: Tool) -> Any:
        r, s = abs(env[self.radius] * env[self.mu]), abs(env[self.other_radius] * env[self.mu])
        centre, other = env[self.centre], env[self.other]
        place, sharpness, far, near = plane.arcs(centre, r, other, s, env[self.side], tool.ar)
        tool.sharpen(self.makes, sharpness)
        slack = tool.slack * (abs(centre) + abs(other) + r + s)
        tool.require(far <= slack, self, "arcs_apart", miss_mm=far)
        tool.require(near <= slack, self, "arcs_inside", miss_mm=near)
        tool.require(abs(other - centre) > slack, self, "arcs_coincide")
        tool.require((r > 0) & (s > 0), self, "no_lengths")
        return tool.mark(place)


@dataclass(frozen=True)
class Touch(Step):
    """The direction of the line through ``start`` that passes ``end`` at a given offset (SI) to its left: the
    tangent to a circle, or simply the line through both when ``offset`` is None."""

    start: str
    end: str
    offset: str | None
    mu: str
    side: str
    kind: ClassVar[Kind] = "direction"

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.start, self.end) + _values(self.offset, self.mu, self.side)

    def draw(self, env: Env, tool: Tool) -> Any:
        offset = env[self.offset] * env[self.mu] if self.offset else 0.0
        start, end = env[self.start], env[self.end]
        u, sharpness, miss = plane.tangent(start, end, offset, env[self.side], tool.ar)
        tool.sharpen(self.makes, sharpness)
        slack = tool.slack * (abs(start) + abs(end) + abs(offset))
        tool.require(miss <= slack, self, "circle_large", miss_mm=miss)
        tool.require(abs(end - start) > slack, self, "points_meet", miss_mm=miss)
        return u


@dataclass(frozen=True)
class Similar(Step):
    """A mark that stands to ``start``–``end`` as a point of a link to two others: ``ratio`` is the complex ratio of
    the link's own sides (a real ratio divides the segment in proportion)."""

    start: str
    end: str
    ratio: str

    def reads(self) -> tuple[Read, ...]:
        return (*_marks(self.start, self.end), (self.ratio, "place"))

    def draw(self, env: Env, tool: Tool) -> Any:
        return tool.mark(env[self.start] + (env[self.end] - env[self.start]) * env[self.ratio])


@dataclass(frozen=True)
class Image(Step):
    """Similarity taken off the scheme: from ``start`` draw what ``image`` is to ``like`` for the segment ``of``."""

    start: str
    of: tuple[str, str]
    like: tuple[str, str]
    image: tuple[str, str]

    def reads(self) -> tuple[Read, ...]:
        return _marks(self.start, *self.of, *self.like, *self.image)

    def draw(self, env: Env, tool: Tool) -> Any:
        (a, b), (c, d), (e, f) = self.of, self.like, self.image
        return tool.mark(env[self.start] + (env[b] - env[a]) * ((env[f] - env[e]) / (env[d] - env[c])))
