"""The method of tracks (of false positions): a link on three leads, drawn where the curve of its hinge cuts a lead.

With one lead removed, the link moves as a coupler and its hinge traces a coupler curve; the group assembles where this
curve meets the arc or the line of that lead. The choice among the crossings is a given, like the side of crossing arcs:
a series for its approximate place over the range of the drive where that assembly exists. The crossing itself is found
from there. The sign of ``side`` is that of the sense of the three lines about each other, which changes only at the
ends of the range.
"""

from collections.abc import Iterator
from itertools import chain

from planes.drafting.steps import MarkStep, Read, Reads, Step, directions, marks, places, values
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry.arithmetic import Arithmetic, Point, Real, Truth
from planes.geometry.tracks import Pose, Tie, TieKind, link_origins, newton_step
from planes.words.frozen import frozen
from planes.words.names import NameTuple

# steps from the guess, a tenth off where lengths were changed, until only the rounding error is left
STEPS_BEFORE_ROUNDING = 5
MOST_SETTLED_MOVE_RATIO = 1e-9  # of the link's size: largest move in the last step


@frozen
class Hold:
    """A lead of the link, by names: ``local`` the point held (its place on the link), ``place`` the mark it is held
    from, ``reach`` a length, ``turn`` the direction of a line, or the angle of a guide in the link's axes. Of two links
    with a common hinge, ``link`` is the one held, and ``hinge`` the place of the hinge on it."""

    kind: TieKind
    local: str
    place: str = ""
    reach: str = ""
    turn: str = ""
    link: int = 0
    hinge: str = ""

    def input_names(self) -> Iterator[Read]:
        """Names of its inputs."""
        turn = directions if self.kind == "line" else values
        yield from places(self.local) + marks(self.place) + values(self.reach) + turn(self.turn) + places(self.hinge)

    def lead_tie(self, env: Env, mu: Real, ar: Arithmetic) -> Tie:
        """The lead in its current position, in mm."""
        reach = abs(env[self.reach]) if self.kind == "arc" else env[self.reach] if self.reach else 0.0
        turn: Point = 1 + 0j
        if self.turn:
            turn = env[self.turn] if self.kind == "line" else ar.cis_deg(env[self.turn])
        local = env[self.local] - env[self.hinge] if self.hinge else env[self.local]
        place = env[self.place] if self.place else 0.0
        return Tie(self.kind, local * mu, place, reach * mu, turn, self.link)


@frozen
class SeriesGuess:
    """The approximate pose of an assembly: series in the drive's position for places (over ``size``) and rotations in
    radians, for each link cut by one track.

    They are series in Chebyshev polynomials of the angle whose cosine is the drive's relative position in its range, so
    they are smooth even at the ends, where two assemblies merge as a square root.
    """

    drive: str
    turning: bool
    middle: str
    half: str
    size: str
    places: NameTuple
    turns: tuple[NameTuple, ...]

    def input_names(self) -> Iterator[Read]:
        """Names of its inputs."""
        yield from values(self.drive, self.middle, self.half, self.size, *chain(*self.turns))
        yield from places(*self.places)

    def relative_drive_position(self, env: Env, ar: Arithmetic) -> Real:
        """The relative position of the drive in its range: -1 to 1."""
        off = env[self.drive] - env[self.middle]
        return (ar.angle_deg(ar.cis_deg(off)) if self.turning else off) / env[self.half]

    def guessed_pose(self, part: Real, env: Env, mu: Real, ar: Arithmetic) -> Pose:
        """The pose guessed."""
        inside = ar.maximum(ar.minimum(part, 1.0), -1.0)
        y = ar.angle_deg(inside + 1j * ar.sqrt(1.0 - inside * inside)) / 90.0 - 1.0
        turns = (chebyshev_sum([env[n] for n in terms], y) for terms in self.turns)
        axes = (ar.cis_deg(turn * 57.29577951308232) for turn in turns)
        return chebyshev_sum([env[n] for n in self.places], y) * (env[self.size] * mu), *axes


def chebyshev_sum(terms: list[Thing], y: Real) -> Thing:
    """A sum of Chebyshev polynomials, by C. W. Clenshaw's recurrence."""
    one: Thing = 0.0
    two: Thing = 0.0
    for term in reversed(terms[1:]):
        one, two = term + 2.0 * y * one - two, one
    return terms[0] + y * one - two


@frozen
class TrackStep(Step):
    """A step that cuts the track of a link's point ``local`` where all ``holds`` are met: three, or two each of two
    links with a common hinge, of which ``link`` has the point; ``hinge`` is its place on that link."""

    local: str
    holds: tuple[Hold, ...]
    guess: SeriesGuess
    mu: str
    side: str
    link: int = 0
    hinge: str = ""

    def input_names(self) -> Reads:
        own = places(self.local) + values(self.mu, self.side) + places(self.hinge)
        held = (read for hold in self.holds for read in hold.input_names())
        return tuple(dict.fromkeys((*held, *self.guess.input_names(), *own)))

    def origin_and_axis_direction(self, env: Env, tool: Tool) -> tuple[Point, Point]:
        """The place of the link's origin, and the direction of its axis."""
        ar = tool.ar
        mu = env[self.mu]
        size = env[self.guess.size] * mu
        ties = [hold.lead_tie(env, mu, ar) for hold in self.holds]
        part = self.guess.relative_drive_position(env, ar)
        pose, det, moved = settle_pose_on_ties(ties, self.guess.guessed_pose(part, env, mu, ar), size, ar)
        tool.record_sharpness(self.makes, abs(det))
        places = link_origins(ties, pose)
        last = [tie for tie in ties if tie.kind != "hinge"][-1]
        miss = abs(last.error_and_wrench(places[last.link], pose[1 + last.link])[0])
        inside: Truth = (part <= 1.0) & (part >= -1.0)
        tool.fail_unless(inside & (moved <= MOST_SETTLED_MOVE_RATIO), self, "track_missed", miss_mm=miss)
        tool.fail_unless(det * env[self.side] > 0, self, "track_missed", miss_mm=miss)
        return places[self.link], pose[1 + self.link]


@frozen
class CutTrack(MarkStep, TrackStep):
    """The mark of the point, where its track is cut."""

    def draw(self, env: Env, tool: Tool) -> Thing:
        origin, axis = self.origin_and_axis_direction(env, tool)
        local = env[self.local] - env[self.hinge] if self.hinge else env[self.local]
        return tool.mark(origin + axis * (local * env[self.mu]))


@frozen
class CutTurn(TrackStep):
    """The direction of the link's x axis, where its track is cut."""

    kind = "direction"

    def draw(self, env: Env, tool: Tool) -> Thing:
        return self.origin_and_axis_direction(env, tool)[1]


def settle_pose_on_ties(ties: list[Tie], pose: Pose, size: Real, ar: Arithmetic) -> tuple[Pose, Real, Real]:
    """The pose near a guess that satisfies the ties, the sharpness (with its sign), and the length of the last step.

    All relative to ``size``, the link's own.
    """
    over = [Tie(t.kind, t.local / size, t.place / size, t.reach / size, t.turn, t.link) for t in ties]
    at: Pose = (pose[0] / size, *pose[1:])
    for _ in range(STEPS_BEFORE_ROUNDING):
        at = newton_step(over, at)[0]
    origin, *axes = (ar.guess(z.real) + 1j * ar.guess(z.imag) for z in at)
    (origin, *axes), moved, det = newton_step(over, (origin, *(axis / abs(axis) for axis in axes)))
    return (origin * size, *axes), det, moved
