"""Traces of similarity on a plan: the sides of the triangles that gave points of links."""

from collections.abc import Collection, Iterator

from planes.drafting.steps import Carry, Image, Similar
from planes.drafting.steps.crossings import Cross
from planes.plans.scales import ZERO_VECTOR_MM
from planes.words.names import NamePair, PlanId
from render.paper.marks import Line
from render.views.plotted import Ends, Plotted, length_of

Triangle = tuple[complex, complex, complex]


def construction_traces(
    plotted: Plotted, plan: PlanId, drawn: Collection[NamePair]
) -> tuple[list[Line], list[Triangle]]:
    """Construction lines of a plan with ``drawn`` vectors between those marks, and the triangles to be hatched."""
    sides = list(_lines_to_false_points(plotted, plan))
    triangles = []
    for step in plotted.drawing.program.steps:
        if step.plan != plan or not isinstance(step, (Similar, Image)):
            continue
        base = (step.start, step.end) if isinstance(step, Similar) else step.image
        if step.start not in base:  # laid off from a separate mark: there is no triangle on the base
            sides.append((plotted.mark(plan, step.start.label), plotted.mark(plan, step.label)))
            continue
        corners = [base[0].label, step.label, base[1].label]
        a, x, b = (plotted.mark(plan, corner) for corner in corners)
        flat = abs(b - a) < ZERO_VECTOR_MM or abs(((x - a) / (b - a)).imag) * abs(b - a) < ZERO_VECTOR_MM
        sides += [(a, b)] * (tuple(corners[::2]) not in drawn) + [(a, x), (x, b)] * (not flat)
        if not flat and step.quantity_represented != "false":
            triangles.append((a, x, b))
    return [Line(ends, "thin", "construction") for ends in sides if length_of(ends) > ZERO_VECTOR_MM], triangles


def _lines_to_false_points(plotted: Plotted, plan: PlanId) -> Iterator[Ends]:
    """The lines that gave points of false positions."""
    for step in plotted.drawing.program.steps:
        if step.plan == plan and step.quantity_represented == "false" and isinstance(step, (Carry, Cross)):
            for mark in (step.start,) if isinstance(step, Carry) else (step.start, step.other):
                yield plotted.mark(plan, mark.label), plotted.mark(plan, step.label)
