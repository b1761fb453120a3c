"""Successive plans: a plan that needs its own result is drawn with a guess, then with a better one, and so on."""

from functools import cached_property, reduce

from planes.drafting.steps import Reads, Step, Steps, values
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry.arithmetic import Real
from planes.words.frozen import frozen

Reals = list[Real]


@frozen
class Fed(Step):
    """A value that a plan both needs and gives: ``factor`` times the ``size`` measured on it."""

    factor: str
    size: str
    kind = "value"
    needs = values("factor", "size")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return env[self.factor] * env[self.size]


@frozen
class Settle(Step):
    """The value ``makes`` of those ``fed`` for which the steps of a plan reproduce it: first drawn with zero, then with
    the results of earlier plans, until they agree. It fails where they do not converge. The plans are drawn without the
    errors of hand and ruler that their inputs have."""

    steps: Steps
    fed: tuple[Fed, ...]
    kind = "value"

    @cached_property
    def _names_read_by_plan(self) -> Reads:
        own = {step.makes for step in self.steps + self.fed}
        names = (read for step in self.steps + self.fed for read in step.input_names() if read[0] not in own)
        return tuple(dict.fromkeys(names))

    def input_names(self) -> Reads:
        return self._names_read_by_plan

    @cached_property
    def _repeated_steps(self) -> Steps:
        """The steps that every plan repeats."""
        changed = {f.makes for f in self.fed}
        redrawn = []
        for step in self.steps:
            if any(name in changed for name, _ in step.input_names()):
                changed.add(step.makes)
                redrawn.append(step)
        return tuple(redrawn)

    def draw(self, env: Env, tool: Tool) -> Thing:
        tool = tool.tool_without_errors()
        things = {**env, **dict.fromkeys((f.makes for f in self.fed), 0.0)}
        sizes = self._draw_and_read_sizes(self.steps, things, tool)
        if self._repeated_steps:
            sizes = self._settled_sizes(sizes, things, tool)
        self._put_sizes_into_inputs(sizes, things)
        return things[self.makes]

    def _settled_sizes(self, first: Reals, things: Env, tool: Tool) -> Reals:
        """The sizes that a plan drawn with them reproduces, by Newton's steps from those of the plan drawn with zero.

        Smaller couples lead to them without a fold; past a fold the slope is reversed, the solution belongs to another
        assembly of forces, and the hinges lock.
        """
        ar = tool.ar
        failures = len(tool.failures)
        sizes = [0.0 for _ in first]
        largest = reduce(ar.maximum, first)
        least = ar.sqrt(ar.eps) * ar.where(largest > 0, largest, 1.0)
        for _ in range(tool.plans):
            self._put_sizes_into_inputs(sizes, things)
            given = self._draw_and_read_sizes(self._repeated_steps, things, tool)
            slopes = [self._error_slope_column(k, sizes, given, least, things, tool) for k in range(len(sizes))]
            steps, turned = solve_by_elimination(slopes, [g - s for g, s in zip(given, sizes, strict=True)])
            del tool.failures[failures:]
            sizes = [s + step for s, step in zip(sizes, steps, strict=True)]
            change = reduce(ar.maximum, map(abs, steps))
            still = change <= tool.settled * least
            if still is True or (hasattr(still, "all") and (still | (change != change)).all()):
                break
        tool.fail_unless(still & (turned > 0), self, "not_settled")
        return sizes

    def _error_slope_column(self, k: int, sizes: Reals, given: Reals, step: Real, things: Env, tool: Tool) -> Reals:
        """How the error of the sizes changes with one of them: a column."""
        self._put_sizes_into_inputs([s + step if i == k else s for i, s in enumerate(sizes)], things)
        moved = self._draw_and_read_sizes(self._repeated_steps, things, tool)
        return [float(i == k) - (m - g) / step for i, (m, g) in enumerate(zip(moved, given, strict=True))]

    def _put_sizes_into_inputs(self, sizes: Reals, things: Env) -> None:
        """Put the values made from the sizes into the inputs of the plan."""
        for fed, size in zip(self.fed, sizes, strict=True):
            things[fed.makes] = things[fed.factor] * size

    def _draw_and_read_sizes(self, steps: Steps, things: Env, tool: Tool) -> Reals:
        """Draw a plan; returns its sizes."""
        for step in steps:
            things[step.makes] = tool.draw(step, things)
        return [things[f.size] for f in self.fed]


def solve_by_elimination(columns: list[Reals], right: Reals) -> tuple[Reals, Real]:
    """The solution of linear equations by C. F. Gauss's elimination, and their determinant."""
    rows = [[*row, r] for row, r in zip(zip(*columns, strict=True), right, strict=True)]
    turned: Real = 1.0
    for k, row in enumerate(rows):
        turned = turned * row[k]
        row[:] = [x / row[k] for x in row]
        for other in (r for r in rows if r is not row):
            other[:] = [x - other[k] * y for x, y in zip(other, row, strict=True)]
    return [row[-1] for row in rows], turned
