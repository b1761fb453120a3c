"""How large the plans of a drawing are: boxes around their marks."""

import cmath
from collections.abc import Iterable, Iterator, Sequence
from statistics import median

from planes.drafting.drawing import Drawing, draw_until_failure
from planes.drafting.program import Program
from planes.drafting.tools import Things
from planes.words.names import POLE_LABEL, SCHEME_PLAN, PlanId

Size = tuple[float, float]
"""The width and the height of a figure."""
TURN_POSITIONS = 12
MOST_GROWTH_RATIO = 3.5  # largest growth of a scheme in the course of a turn, relative to its usual size
EXTREME_REACH_RATIO = 1.02  # how much farther an extreme position may reach than the sampled positions
DRAWN_REACH_RATIO = 1.3  # and the limit if it grows beyond that: positions farther off are not drawn


def plan_extent(drawing: Drawing, plan: PlanId) -> float:
    """The larger side of the box around a plan's marks, in SI when drawn at unit scale."""
    return max(plan_width_and_height(drawing, plan))


def plan_width_and_height(drawing: Drawing, plan: PlanId) -> Size:
    """The width and the height of the box around a plan's marks."""
    made = drawing.program.mark_steps_on(plan)
    marks = [drawing[s.makes] for s in made if not s.is_outside_plan and s.label != POLE_LABEL]
    if plan != SCHEME_PLAN:
        marks.append(0j)
    return box_size(marks)


def box_size(places: Iterable[complex]) -> Size:
    """The width and the height of the box around some places, those at infinity left out; 0 and 0 for none."""
    finite = [z for z in places if cmath.isfinite(z)]
    if not finite:
        return 0.0, 0.0
    wide = max(z.real for z in finite) - min(z.real for z in finite)
    return float(wide), float(max(z.imag for z in finite) - min(z.imag for z in finite))


def size_over_turn(program: Program, given: Things, drive: str, step: float, closed: bool) -> Size:
    """The size in SI of a scheme that is drawn in steps of the drive to both sides of its position, until one cannot be
    drawn; over a whole turn, if it is ``closed``."""
    scheme = program.cut_to_names(s.makes for s in program.mark_steps_on(SCHEME_PLAN))
    placed = [*_positions_on_side(scheme, given, drive, step), *_positions_on_side(scheme, given, drive, -step)]
    reaches = [max((abs(z - places[0]) for z in places), default=0.0) for places in placed]
    if not reaches:
        return 0.0, 0.0
    most = most_drawn_reach(reaches, closed and len(placed) >= TURN_POSITIONS)
    return box_size(z for places, reach in zip(placed, reaches, strict=True) if reach <= most for z in places)


def most_drawn_reach(reaches: Sequence[float], closed: bool) -> float:
    """The largest of the reaches of a scheme that is drawn, since near a dead point a point may be anywhere; the
    positions make a whole turn if they are ``closed``."""
    usual = median(reaches)
    if closed and max(reaches) < MOST_GROWTH_RATIO * usual:
        return EXTREME_REACH_RATIO * max(reaches)
    return DRAWN_REACH_RATIO * usual


def _positions_on_side(scheme: Program, given: Things, drive: str, step: float) -> Iterator[list[complex]]:
    """The places of points in the next positions of the drive, half a turn at most."""
    for k in range(TURN_POSITIONS // 2 + 1):
        drawing, failure = draw_until_failure(scheme, {**given, drive: given[drive] + k * step})
        if failure:
            return
        yield [drawing[s.makes] for s in scheme.mark_steps_on(SCHEME_PLAN) if not s.is_outside_plan]
