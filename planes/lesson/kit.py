"""The draughtsman's tools for a step, and where they are placed: set square, compass, dividers, protractor.

A tool is described by marks alone: a page knows their places, whatever numbers are given.
"""

from collections.abc import Iterator

from planes.drafting.drawing import Drawing
from planes.drafting.program import StepsByName
from planes.drafting.steps import Aim, Carry, Image, LayOff, Similar, Step, Turn
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Choose, Drop
from planes.drafting.steps.tracks import TrackStep
from planes.lesson.frame import Frame
from planes.lesson.scheme import arm_foot_mark
from planes.plans import Plans
from planes.words.frozen import frozen
from planes.words.names import NamePair, NameTuple, plan_of, scheme_mark
from planes.words.records import Json

Handled = Iterator[Json]


@frozen
class Kit:
    """The tools for each step of a program: ``from`` are the marks where a tool takes its setting, none if it
    is set elsewhere (dividers from a scale); ``guide`` is the guide it is laid against."""

    plans: Plans
    drawing: Drawing

    @property
    def steps_by_result(self) -> StepsByName:
        """The steps by their results."""
        return self.drawing.program.steps_by_result

    def tools_for_frame(self, f: Frame) -> list[Json]:
        """The tools for a frame: for its mark, its measurements, the arms it drops, the vector it carries."""
        if f.makes:
            if f.key != "fixed":
                return list(self.tools_for_step(self.steps_by_result[f.makes[0]]))
            return []
        if f.turns:
            return [_dividers_tool(span, (f.turns["point"],)) for span in self.segments_of_frame(f)[:1]]
        if f.key in ("measured", "closing"):
            return [_dividers_tool(span, ()) for span in self.segments_of_frame(f)]
        arms = self.plans.moments[f.moments].terms if f.moments is not None and f.key == "found_values" else ()
        steps = (self.steps_by_result.get(arm) for force, arm in arms if force in f.terms)
        return [_perpendicular_tool(step) for step in steps if isinstance(step, Drop)]

    def segments_of_frame(self, f: Frame) -> list[NamePair]:
        """The segments of a frame's vectors on its plan."""
        own = {x.name: x.ends for x in self.plans.segments_on(f.plan) if x.start != x.end}
        return [own[name] for name in f.terms if name in own]

    def tools_for_step(self, step: Step) -> Handled:
        """The tools for a step, in order of use."""
        end = step.makes
        if isinstance(step, LayOff | Cross | CrossArc):
            yield from self.line_tools(step.along, step.start, end)
        match step:
            case Choose():  # all trials are drawn the same way
                yield from self.tools_for_step(self.steps_by_result[step.trials[0].mark])
            case LayOff():
                yield _dividers_tool((), (step.start, end))
            case Cross():
                yield from self.line_tools(step.across, step.other, end)
            case TrackStep():
                for hold in step.holds:
                    if hold.local == step.local:
                        if hold.kind == "arc":
                            yield _compass_tool(hold.place, end)
                        elif hold.kind == "line":
                            yield from self.line_tools(hold.turn, hold.place, end)
            case CrossArc():
                yield _compass_tool(step.centre, end)
            case CrossArcs():
                yield _compass_tool(step.centre, end)
                yield _compass_tool(step.other, end)
            case Similar() | Image():
                yield from self.similar_figure_tools(step)
            case Carry():
                yield _dividers_tool((step.first, step.second), (step.start, end))

    def line_tools(self, direction: str, start: str, end: str) -> Handled:
        """A line through two marks: by a set square along or across another line, by protractor at an angle."""
        step = self.steps_by_result[direction]
        if plan_of(end) != "position":
            yield {"tool": "square", "to": (start, end), **self.set_square_base(step)}
            return
        while isinstance(step, Turn) and not step.angle:
            step = self.steps_by_result[step.of]
        base = self.set_square_base(step).get("from", ()) if isinstance(step, Turn) else ()
        turned = isinstance(step, Turn | Aim) and not self.guide_of_direction(step)
        yield {"tool": "protractor" if base or turned else "square", "to": (start, end), "from": base}

    def set_square_base(self, step: Step) -> Json:
        """What a set square is laid against: two marks of the scheme, or a guide."""
        if guide := self.guide_of_direction(step):
            return {"guide": guide}
        means = self.plans.means.get(step.makes)
        ends = tuple(scheme_mark(point) for point in (means.of, means.about)) if means else ()
        if ends and all(mark in self.drawing for mark in ends):
            return {"from": ends}
        if isinstance(step, Turn):
            return self.set_square_base(self.steps_by_result[step.of])
        return {}

    def guide_of_direction(self, step: Step) -> str:
        """The guide that a direction is along or across, "" for another."""
        means = self.plans.means.get(step.makes)
        if means and not means.about and means.of in self.plans.mechanism.owners:
            return means.of
        return ""

    def similar_figure_tools(self, step: Similar | Image) -> Handled:
        """A figure similar to one of the scheme: both its angles by protractor; a point on the line itself by
        dividers."""
        ends = (step.start, step.end) if isinstance(step, Similar) else step.image
        along = isinstance(step, Similar) and not complex(self.drawing[step.ratio]).imag
        if along or step.start not in ends:
            yield _dividers_tool((), (step.start, step.makes))
            return
        for vertex, other in (ends, ends[::-1]):
            yield {"tool": "protractor", "to": (vertex, step.makes), "from": (vertex, other)}


def _perpendicular_tool(step: Drop) -> Json:
    """The set square that drops an arm: laid along a force, its other edge through the moment point."""
    foot = arm_foot_mark(step)
    return {"tool": "square", "to": (step.about, foot), "from": (step.point, foot)}


def _dividers_tool(taken: NameTuple, to: NameTuple) -> Json:
    return {"tool": "dividers", "from": taken, "to": to}


def _compass_tool(centre: str, end: str) -> Json:
    return {"tool": "compass", "to": (centre, end)}
