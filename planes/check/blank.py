"""Where a blank has its pole, and at what scale a plan has room on it."""

from planes.check.fiducials import OTHER_MM, SHEET_MM, has_room, pole_place
from planes.check.grading.prepared_plan import PreparedPlan
from planes.plans.scales import fitting
from planes.words.names import kind_of

SMALLER = 0.99  # of a scale: the next one of the standard is smaller
ASIDE_MM = 12.0  # how far from a blank's middle its pole tells nobody where the plan goes


def roomy(bench: PreparedPlan) -> PreparedPlan:
    """A plan as a blank has it: at the largest standard scale, no larger than the scene's, that has room for it there;
    if of motion, with its pole in the middle of the sheet, for any plan of that size, whichever way it goes."""
    plan = bench.asked.plan
    if bench.asked.mu:
        return bench
    if kind_of(plan) not in ("position", "force"):
        aside = abs(blank_pole(bench) - pole_place([])) > ASIDE_MM
        reach = max(abs(z) for z in bench.true_marks.values()) / bench.said_mu
        return bench.at(fitting(plan, reach, SHEET_MM[1] / 2 - OTHER_MM), fixed=True) if aside else bench
    while not has_room([*bench.true_marks.values()]):
        bench = bench.at(fitting(plan, 1.0, SMALLER * bench.said_mu), fixed=True)
    return bench


def blank_pole(bench: PreparedPlan) -> complex:
    """Where the blank of this plan has its pole."""
    return pole_place([*bench.true_marks.values()])
