"""Successive plans: a plan that needs its own result is drawn with a guess, then with what that gave, and so on."""

from dataclasses import dataclass
from functools import cached_property, reduce
from typing import ClassVar

from planes.drafting.steps import Kind, Read, Step, values
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry.arithmetic import Real


@dataclass(frozen=True)
class Fed(Step):
    """A value that a plan is drawn with and that it gives: ``factor`` times the ``size`` measured on it."""

    factor: str
    size: str
    kind: ClassVar[Kind] = "value"
    needs = values("factor", "size")

    def draw(self, env: Env, tool: Tool) -> Thing:
        return env[self.factor] * env[self.size]


@dataclass(frozen=True)
class Settle(Step):
    """The value ``makes`` of those ``fed``, with which the steps of a plan give it again: they are drawn first with
    nothing, then with what the plan before gave, until nothing changes. Where plans do not settle it fails. They are
    drawn aside, without the errors of hand and ruler that what they are drawn from has."""

    plan: tuple[Step, ...]
    fed: tuple[Fed, ...]
    kind: ClassVar[Kind] = "value"

    @cached_property
    def _read(self) -> tuple[Read, ...]:
        own = {step.makes for step in (*self.plan, *self.fed)}
        names = (read for step in (*self.plan, *self.fed) for read in step.reads() if read[0] not in own)
        return tuple(dict.fromkeys(names))

    def reads(self) -> tuple[Read, ...]:
        return self._read

    @cached_property
    def _anew(self) -> tuple[Step, ...]:
        """The steps that every plan draws anew."""
        changed, found = {f.makes for f in self.fed}, []
        for step in self.plan:
            if any(name in changed for name, _ in step.reads()):
                changed.add(step.makes)
                found.append(step)
        return tuple(found)

    def draw(self, env: Env, tool: Tool) -> Thing:
        tool, things = tool.calm(), {**env, **dict.fromkeys((f.makes for f in self.fed), 0.0)}
        sizes, before = self._drawn(self.plan, things, tool), [0.0 for _ in self.fed]
        failures, largest = len(tool.failures), reduce(tool.ar.maximum, sizes)
        for _ in range(tool.plans if self._anew else 0):
            before, sizes = sizes, self._drawn(self._anew, things, tool)
            del tool.failures[failures:]
            change = reduce(tool.ar.maximum, (abs(a - b) for a, b in zip(sizes, before, strict=True)))
            still = change <= tool.ar.eps * largest
            if still is True or (hasattr(still, "all") and still.all()):
                return things[self.makes]
        if self._anew:
            tool.require(change <= tool.settled * largest, self, "not_settled", plans=tool.plans)
        return things[self.makes]

    def _drawn(self, steps: tuple[Step, ...], things: Env, tool: Tool) -> list[Real]:
        """Draw a plan, and put what it gives in the place of what it was drawn with; the sizes it gives."""
        for step in (*steps, *self.fed):
            things[step.makes] = step.draw(things, tool)
        return [things[f.size] for f in self.fed]
