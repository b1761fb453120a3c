"""A line and a crossing that may not exist: coinciding marks give no line, parallel lines no mark."""

from planes.drafting.steps import Through
from planes.drafting.steps.crossings import Cross
from planes.drafting.tools import Env, Thing, Tool
from planes.geometry import plane
from planes.words.frozen import frozen


@frozen
class ThroughApart(Through):
    """The direction from one mark to another, missing where they coincide."""

    def draw(self, env: Env, tool: Tool) -> Thing:
        start = env[self.start]
        end = env[self.end]
        there = abs(end - start) > tool.slack * (abs(start) + abs(end))
        return tool.ar.where(there, plane.unit_direction(end - start, tool.ar), complex("nan"))


@frozen
class CrossApart(Cross):
    """The crossing of two lines, missing where they are parallel or one of them is missing; neither is a failure."""

    def draw(self, env: Env, tool: Tool) -> Thing:
        place, sharpness, _ = self.crossing_and_sharpness(env, tool)
        return tool.ar.where(abs(sharpness) > tool.flat, tool.mark(place), complex("nan"))
