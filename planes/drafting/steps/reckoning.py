"""Steps that read a drawing and compute from the readings: measuring, arms, arithmetic, senses, choices."""

from functools import reduce

from planes.drafting.steps import MarkStep, Reads, Step, directions, marks, values
from planes.drafting.tools import Env, Thing, Things, Tool
from planes.geometry import plane
from planes.geometry.arithmetic import Arithmetic, Point, Real, Truth
from planes.words.frozen import frozen
from planes.words.names import Mark, MarkTuple, NamePair, NameTuple

SLACK_ROPE_FORCE_RATIO = 1e-12  # of the largest force: below this a rope is slack


@frozen
class Measure(Step):
    """The length of a segment in SI: signed along a direction if one is named, otherwise its magnitude."""

    start: Mark
    end: Mark
    along: str | None
    mu: str
    kind = "value"
    needs = marks("start", "end") + directions("along") + values("mu")

    def draw(self, env: Env, tool: Tool) -> Thing:
        segment = env[self.end] - env[self.start]
        length = plane.dot(env[self.along], segment) if self.along else abs(segment)
        return tool.read_length(length) / env[self.mu]


@frozen
class Pull(Measure):
    """The pull of the rope ``name``: the reaction along it. A rope that would have to push, by more than rounding
    beside the forces up to the marks ``beside``, fails the position."""

    name: str = ""
    beside: MarkTuple = ()
    guards = True
    needs = Measure.needs + marks("beside")

    def draw(self, env: Env, tool: Tool) -> Thing:
        pull = Measure.draw(self, env, tool)
        largest = reduce(tool.ar.maximum, [tool.ar.size(env[mark]) for mark in self.beside])
        tool.fail_unless(
            pull * env[self.mu] >= -(SLACK_ROPE_FORCE_RATIO * largest + tool.doubt_mm), self, "rope_pushes"
        )
        return pull


@frozen
class Drop(Step):
    """The arm, in SI, of a line of action through ``point`` about ``about``: positive when a force along the line turns
    counter-clockwise."""

    point: Mark
    along: str
    about: Mark
    mu: str
    kind = "value"
    needs = marks("point", "about") + directions("along") + values("mu")

    def draw(self, env: Env, tool: Tool) -> Thing:
        arm = plane.cross(env[self.point] - env[self.about], env[self.along])
        return tool.read_length(arm) / env[self.mu]


@frozen
class Protractor(Step):
    """The angle of a direction from the x axis, degrees in (-180, 180]."""

    of: str
    kind = "value"
    needs = directions("of")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return tool.ar.angle_deg(env[self.of])


@frozen
class Cosine(Step):
    """The cosine of the angle between two directions: the component of one unit vector along the other."""

    of: str
    along: str
    kind = "value"
    needs = directions("of", "along")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return plane.dot(env[self.of], env[self.along])


@frozen
class Product:
    """``coefficient`` times named values, each to a whole power."""

    coefficient: float
    factors: tuple[tuple[str, int], ...]

    def product_value(self, env: Things, ar: Arithmetic) -> Real:
        """The product itself."""
        product: Real = self.coefficient
        for name, power in self.factors:
            product = product * ar.power(env[name], power)
        return product


@frozen
class Calculate(Step):
    """A sum of products of values: v²/l, or a moment equation solved for its one unknown."""

    terms: tuple[Product, ...]
    kind = "value"

    def input_names(self) -> Reads:
        return values(*dict.fromkeys(name for t in self.terms for name, _ in t.factors))

    def draw(self, env: Env, tool: Tool) -> Thing:
        total: Real = 0.0
        for term in self.terms:
            total = total + term.product_value(env, tool.ar)
        return total


@frozen
class Sense(Step):
    """+1, -1 or 0: the sense of a segment along a direction (without one: 1 unless the segment vanishes).

    A segment is zero when it vanishes beside the largest of the marks ``beside``, measured from ``start``.
    """

    start: Mark
    end: Mark
    along: str | None
    beside: MarkTuple
    told: bool = True
    kind = "value"
    needs = marks("start", "end", "beside") + directions("along")

    def length_and_farthest_distance(self, env: Things, ar: Arithmetic) -> tuple[Real, Real]:
        """The length of the segment along its direction, and the distance of the farthest of the others."""
        segment = env[self.end] - env[self.start]
        length = plane.dot(env[self.along], segment) if self.along else abs(segment)
        return length, reduce(ar.maximum, (abs(env[mark]) for mark in self.beside), 0.0)

    def draw(self, env: Env, tool: Tool) -> Thing:
        length, largest = self.length_and_farthest_distance(env, tool.ar)
        moving = abs(length) > tool.still * largest
        if self.told:
            tool.warn_unless(moving, self, "standstill")
        return tool.ar.where(moving, tool.ar.sign(length), 0.0)


@frozen
class SenseOf(Step):
    """+1, -1 or 0: the sign of a value."""

    value: str
    kind = "value"
    needs = values("value")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return tool.ar.sign(env[self.value])


@frozen
class SizeOf(Step):
    """A value without its sign."""

    value: str
    kind = "value"
    needs = values("value")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return abs(env[self.value])


@frozen
class SenseBetween(Step):
    """+1, -1 or 0: the sense of rotation of one link relative to another, or to a fixed one (""); each at its ``rate``,
    or zero where its ``sense`` is zero."""

    rate: str
    sense: str
    other_rate: str
    other_sense: str
    kind = "value"
    needs = values("rate", "sense", "other_rate", "other_sense")

    def draw(self, env: Env, tool: Tool) -> Thing:
        ar = tool.ar
        rates = [(env[rate] * abs(env[sense])) if rate else 0.0 for rate, sense in self.signed_rates]
        apart = rates[0] - rates[1]
        largest = ar.maximum(abs(rates[0]), abs(rates[1]))
        moving = abs(apart) > tool.still * largest
        tool.warn_unless(moving, self, "standstill")
        return ar.where(moving, ar.sign(apart), 0.0)

    @property
    def signed_rates(self) -> tuple[NamePair, NamePair]:
        """The rate of each with its sense."""
        return (self.rate, self.sense), (self.other_rate, self.other_sense)


@frozen
class Lean(Step):
    """The line of a guide's reaction with Coulomb friction: the normal inclined by arctan f against the sliding.

    ``push`` is the assumed sign of the reaction along the normal: friction opposes the sliding whichever side of the
    guide bears.
    """

    normal: str
    along: str
    coefficient: str
    sliding: str
    push: int
    kind = "direction"
    needs = directions("normal", "along") + values("coefficient", "sliding")

    def draw(self, env: Env, tool: Tool) -> Thing:
        friction = env[self.coefficient] * env[self.sliding] * self.push
        return plane.unit_direction(env[self.normal] - env[self.along] * friction, tool.ar)


@frozen
class Trial:
    """A place drawn on the assumption that the reactions ``pushes`` have the signs ``signs``."""

    mark: Mark
    pushes: NameTuple
    signs: tuple[int, ...]


@frozen
class Choose(MarkStep):
    """Keep the one trial whose assumption holds; none, or two different ones, means self-locking."""

    trials: tuple[Trial, ...]
    size: Mark
    mu: str

    def input_names(self) -> Reads:
        pushes = tuple(dict.fromkeys(p for t in self.trials for p in t.pushes))
        return marks(*(t.mark for t in self.trials)) + values(*pushes, self.mu) + marks(self.size)

    def draw(self, env: Env, tool: Tool) -> Thing:
        chosen: Point = complex("nan")
        sharp: Real = 1.0
        count: Real = 0
        for trial in reversed(self.trials):
            true: Truth = True
            slack = (1e-10 * (abs(env[trial.mark]) + abs(env[self.size])) + tool.doubt_mm) / env[self.mu]
            for push, sign in zip(trial.pushes, trial.signs, strict=True):
                true = true & (env[push] * sign >= -slack)
            fresh = true & ~(abs(env[trial.mark] - chosen) <= slack * env[self.mu])
            count = count + fresh
            chosen = tool.ar.where(true, env[trial.mark], chosen)
            sharp = tool.ar.where(true, tool.sharpness[trial.mark], sharp)
        tool.record_sharpness(self.makes, sharp)
        tool.fail_unless(count == 1, self, "self_locking", solutions=count)
        return chosen
