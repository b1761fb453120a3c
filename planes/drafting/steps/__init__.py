"""The steps of a drawing, each a draughtsman's verb: the base class, and the steps that cannot fail.

A step makes one named object from earlier ones and is a frozen record. It makes a mark in mm on a plan, a direction, or
a value in SI; marks are named "plan:label" ("velocity:c"). An instrument (``tool``) draws it and owns the arithmetic,
the errors of hand and ruler, and the handling of failures; so the same step serves one position or an array of many.
"""

from functools import partial
from typing import ClassVar, Literal, get_args

from planes.drafting.tools import Env, Thing, Tool
from planes.geometry import plane
from planes.words.frozen import field, frozen
from planes.words.names import HELPER_MARK_KINDS, Mark, MarkPair, Meaning, PlanId, label_of, plan_of

Kind = Literal["mark", "direction", "value", "place"]
INPUT_KINDS: tuple[Kind, ...] = get_args(Kind)
Read = tuple[str, Kind]
Reads = tuple[Read, ...]


@frozen
class Step:
    """One step; ``makes`` is the name of its result, ``means`` the meaning of that name, if given."""

    makes: str
    means: Meaning | None = field(default=None, kw_only=True, compare=False, repr=False)
    kind: ClassVar[Kind] = "mark"
    guards: ClassVar[bool] = False  # a position that fails it gives no results at all, and it is never sliced away
    needs: ClassVar[Reads] = ()  # the fields that name its inputs, one or several, with their kind

    @property
    def plan(self) -> PlanId:
        """The plan of the mark it draws; none of a direction or a value."""
        return plan_of(self.makes)

    @property
    def label(self) -> str:
        """The name of its result without the plan."""
        return label_of(self.makes)

    @property
    def quantity_represented(self) -> str:
        """The quantity the name stands for; "" where it is not given."""
        return self.means.quantity if self.means else ""

    @property
    def is_auxiliary_mark(self) -> bool:
        """Whether it draws an auxiliary mark, which is never asked for."""
        return self.quantity_represented in HELPER_MARK_KINDS

    @property
    def is_outside_plan(self) -> bool:
        """Whether it draws a mark that may lie anywhere (a guide's place, a trial, a centre) and is no part of the plan
        proper."""
        return self.quantity_represented in ("guide", "moved", "trial", "centre")

    def input_names(self) -> Reads:
        """Names of its inputs, each with its kind."""
        needed = [(getattr(self, field) or (), kind) for field, kind in self.needs]
        return tuple([(n, kind) for names, kind in needed for n in ((names,) if isinstance(names, str) else names)])

    def draw(self, env: Env, tool: Tool) -> Thing:
        """The result, from its inputs in ``env``."""
        raise NotImplementedError


Steps = tuple[Step, ...]


@frozen
class MarkStep(Step):
    """A step that makes a mark."""

    makes: Mark


def _inputs_of_kind(kind: Kind, *names: str | None) -> Reads:
    return tuple((n, kind) for n in names if n)


marks, directions, values, places = (partial(_inputs_of_kind, kind) for kind in INPUT_KINDS)


@frozen
class Put(MarkStep):
    """Put a mark at a given place of the plan (m, by the scale), or at its pole when ``at`` is None."""

    at: str | None = None
    mu: str | None = None
    needs = (("at", "place"), *values("mu"))

    def draw(self, env: Env, tool: Tool) -> Thing:
        if self.at and self.mu:
            return tool.mark(env[self.at] * env[self.mu])
        return 0j


@frozen
class Aim(Step):
    """A direction at a given angle (degrees) from the x axis, by protractor."""

    angle: str
    kind = "direction"
    needs = values("angle")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return tool.ar.cis_deg(env[self.angle])


@frozen
class Through(Step):
    """The direction from one mark to another; where they coincide (a zero vector), any direction."""

    start: Mark
    end: Mark
    kind = "direction"
    needs = marks("start", "end")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return plane.unit_direction(env[self.end] - env[self.start], tool.ar)


@frozen
class Turn(Step):
    """A direction turned by ``quarter`` right angles (set square) and by a given angle (degrees)."""

    of: str
    quarter: int = 0
    angle: str | None = None
    kind = "direction"
    needs = directions("of") + values("angle")

    def draw(self, env: Env, tool: Tool) -> Thing:
        turned = env[self.of] * (1, 1j, -1, -1j)[self.quarter % 4]
        if self.angle:
            return turned * tool.ar.cis_deg(env[self.angle])
        return turned


@frozen
class LayOff(MarkStep):
    """Lay off a signed length (SI, by the scale) from a mark along a direction."""

    start: Mark
    along: str
    length: str
    mu: str
    needs = marks("start") + directions("along") + values("length", "mu")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return tool.mark(env[self.start] + tool.transfer_direction(env[self.along]) * (env[self.length] * env[self.mu]))


@frozen
class Carry(MarkStep):
    """Carry the segment ``first``–``second`` to ``start``, turned by ``quarter`` right angles."""

    start: Mark
    first: Mark
    second: Mark
    quarter: int = 0
    needs = marks("start", "first", "second")

    def draw(self, env: Env, tool: Tool) -> Thing:
        segment = (env[self.second] - env[self.first]) * (1, 1j, -1, -1j)[self.quarter % 4]
        return tool.mark(env[self.start] + segment)


@frozen
class Same(MarkStep):
    """Another name for a mark: all points of a link in translation have one image on the plan."""

    of: Mark
    needs = marks("of")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return env[self.of]


@frozen
class Similar(MarkStep):
    """A mark placed relative to ``start``–``end`` as a point of a link relative to two others: ``ratio`` is the complex
    ratio of the link's sides (a real ratio divides the segment in proportion)."""

    start: Mark
    end: Mark
    ratio: str
    needs = (*marks("start", "end"), ("ratio", "place"))

    def draw(self, env: Env, tool: Tool) -> Thing:
        return tool.mark(env[self.start] + (env[self.end] - env[self.start]) * env[self.ratio])


@frozen
class Image(MarkStep):
    """Similarity taken from the scheme: a mark relative to ``start`` and the segment ``of``, as ``image`` is to
    ``like``."""

    start: Mark
    of: MarkPair
    like: MarkPair
    image: MarkPair
    needs = marks("start", "of", "like", "image")

    def draw(self, env: Env, tool: Tool) -> Thing:
        a, b = self.of
        c, d = self.like
        e, f = self.image
        return tool.mark(env[self.start] + (env[b] - env[a]) * ((env[f] - env[e]) / (env[d] - env[c])))
