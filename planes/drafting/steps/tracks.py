"""The method of tracks (of false positions): a link on three leads, drawn where the track of its hinge cuts a lead.

With one lead taken off, the link moves as a coupler does, and its hinge draws a track; where that meets the arc or the
line of the lead that was taken off, the group assembles. Which of the crossings is meant is a given, as the side of
crossing arcs is: a series that says, over the range of the drive where that assembly lasts, where about it is. From
there the crossing itself is found; the sign of ``side`` is that of the three lines' sense about each other, which
changes at the ends of the range alone.
"""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import ClassVar

from planes.drafting.steps import Kind, Read, Step
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry.arithmetic import Arithmetic, Point, Real, Truth
from planes.geometry.tracks import Pose, Tie, TieKind, newton

BEFORE = 5  # steps from the guess, a tenth off where lengths were changed, until it is no worse than rounding makes it
SETTLED = 1e-9  # of the link's size: the last step moves it by less


@dataclass(frozen=True)
class Hold:
    """A lead of the link, by names: ``local`` the point held (its place on the link), ``place`` the mark it is held
    from, ``reach`` a length, ``turn`` the direction of a line, or the angle of a guide in the link's own axes."""

    kind: TieKind
    local: str
    place: str
    reach: str = ""
    turn: str = ""

    def reads(self) -> Iterator[Read]:
        """Names of what it needs."""
        yield from ((self.local, "place"), (self.place, "mark"))
        if self.reach:
            yield self.reach, "value"
        if self.turn:
            yield self.turn, "direction" if self.kind == "line" else "value"

    def tie(self, env: Env, mu: Real, ar: Arithmetic) -> Tie:
        """The lead as it lies, in mm."""
        reach = abs(env[self.reach]) if self.kind == "arc" else env[self.reach] if self.reach else 0.0
        turn: Point = 1 + 0j
        if self.turn:
            turn = env[self.turn] if self.kind == "line" else ar.cis_deg(env[self.turn])
        return Tie(self.kind, env[self.local] * mu, env[self.place], reach * mu, turn)


@dataclass(frozen=True)
class SeriesGuess:
    """Where about an assembly is: series in the drive's value, of places (over ``size``) and of the turn in radians.

    They go by Chebyshev's polynomials of the angle whose cosine is the drive's part of its range, so that the ends of
    it, where two assemblies meet and part at the rate of a square root, are as smooth as the middle.
    """

    drive: str
    turning: bool
    middle: str
    half: str
    size: str
    places: tuple[str, ...]
    turns: tuple[str, ...]

    def reads(self) -> Iterator[Read]:
        """Names of what it needs."""
        yield from ((n, "value") for n in (self.drive, self.middle, self.half, self.size, *self.turns))
        yield from ((n, "place") for n in self.places)

    def part(self, env: Env, ar: Arithmetic) -> Real:
        """Where the drive is in the range: -1 to 1."""
        off = env[self.drive] - env[self.middle]
        return (ar.angle_deg(ar.cis_deg(off)) if self.turning else off) / env[self.half]

    def pose(self, part: Real, env: Env, mu: Real, ar: Arithmetic) -> Pose:
        """The pose guessed."""
        inside = ar.maximum(ar.minimum(part, 1.0), -1.0)
        y = ar.angle_deg(inside + 1j * ar.sqrt(1.0 - inside * inside)) / 90.0 - 1.0
        place, turn = series([env[n] for n in self.places], y), series([env[n] for n in self.turns], y)
        return place * (env[self.size] * mu), ar.cis_deg(turn * 57.29577951308232)


def series(terms: list[Thing], y: Real) -> Thing:
    """A sum of Chebyshev's polynomials, by C. W. Clenshaw's recurrence."""
    one: Thing = 0.0
    two: Thing = 0.0
    for term in reversed(terms[1:]):
        one, two = term + 2.0 * y * one - two, one
    return terms[0] + y * one - two


@dataclass(frozen=True)
class CutTrack(Step):
    """Cut the track of a link's point: the mark of the point ``local`` where all three ``holds`` are kept."""

    local: str
    holds: tuple[Hold, Hold, Hold]
    guess: SeriesGuess
    mu: str
    side: str

    def reads(self) -> tuple[Read, ...]:
        own: tuple[Read, ...] = ((self.local, "place"), (self.mu, "value"), (self.side, "value"))
        held = (read for hold in self.holds for read in hold.reads())
        found: dict[Read, None] = dict.fromkeys((*held, *self.guess.reads(), *own))
        return tuple(found)

    def draw(self, env: Env, tool: Tool) -> Thing:
        origin, axis = self.lie(env, tool)
        return tool.mark(origin + axis * (env[self.local] * env[self.mu]))

    def lie(self, env: Env, tool: Tool) -> Pose:
        """Where the link lies."""
        ar, mu = tool.ar, env[self.mu]
        size = env[self.guess.size] * mu
        ties = [hold.tie(env, mu, ar) for hold in self.holds]
        part = self.guess.part(env, ar)
        pose, det, moved = settle(ties, self.guess.pose(part, env, mu, ar), size, ar)
        tool.sharpen(self.makes, abs(det))
        miss = abs(ties[2].wrench(*pose)[0])
        inside: Truth = (part <= 1.0) & (part >= -1.0)
        tool.require(inside & (moved <= SETTLED), self, "track_missed", miss_mm=miss)
        tool.require(det * env[self.side] > 0, self, "track_missed", miss_mm=miss)
        return pose


@dataclass(frozen=True)
class CutTurn(CutTrack):
    """The direction of the link's x axis, where its track is cut."""

    kind: ClassVar[Kind] = "direction"

    def draw(self, env: Env, tool: Tool) -> Thing:
        return self.lie(env, tool)[1]


def settle(ties: list[Tie], pose: Pose, size: Real, ar: Arithmetic) -> tuple[Pose, Real, Real]:
    """The pose near a guessed one that keeps three ties, how sharply (with its sign), and how far the last step was.

    All in parts of ``size``: the link's own."""
    over = [Tie(t.kind, t.local / size, t.place / size, t.reach / size, t.turn) for t in ties]
    origin, axis = pose[0] / size, pose[1]
    for _ in range(BEFORE):
        origin, axis, _, _ = newton(over, origin, axis)
    origin = ar.guess(origin.real) + 1j * ar.guess(origin.imag)
    axis = ar.guess(axis.real) + 1j * ar.guess(axis.imag)
    axis = axis / abs(axis)
    origin, axis, moved, det = newton(over, origin, axis)
    return (origin * size, axis), det, moved
