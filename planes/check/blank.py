"""The position of the pole on a blank, and the scale at which its plan has room."""

from planes.check.fiducials import OTHER_MARGIN_MM, SHEET_MM, has_room, pole_position
from planes.check.grading.prepared_plan import PreparedPlan
from planes.plans.scales import largest_fitting_scale

NEXT_SMALLER_SCALE_FACTOR = 0.99  # factor on a scale that forces the next smaller standard scale
MOST_POLE_OFFSET_MM = 12.0  # a pole this far from the middle of the blank does not give away the direction of the plan


def plan_fitting_blank(bench: PreparedPlan) -> PreparedPlan:
    """The plan as on its blank: at the largest standard scale, not above the scene's, that has room on the sheet.

    A plan of motion has its pole in the middle of the sheet, so that it leaves room in every direction.
    """
    plan = bench.plan
    if bench.asked.mu:
        return bench
    if plan.kind not in ("position", "force"):
        aside = abs(blank_pole(bench) - pole_position([])) > MOST_POLE_OFFSET_MM
        reach = max(abs(z) for z in bench.true_marks.values()) / bench.said_mu
        if aside:
            return bench.at_scale(largest_fitting_scale(plan, reach, SHEET_MM[1] / 2 - OTHER_MARGIN_MM))
        return bench
    while not has_room([*bench.true_marks.values()]):
        bench = bench.at_scale(largest_fitting_scale(plan, 1.0, NEXT_SMALLER_SCALE_FACTOR * bench.said_mu))
    return bench


def blank_pole(bench: PreparedPlan) -> complex:
    """The position of the pole on the blank of this plan."""
    return pole_position([*bench.true_marks.values()])
