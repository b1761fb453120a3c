"""The single fault of an otherwise right drawing: two letters swapped, or its scale."""

from dataclasses import replace
from itertools import combinations

from planes.check.grading.grading import Grading, grade
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.grading.sign_faults import SignFault
from planes.plans.scales import largest_fitting_scale
from planes.words.names import POLE_LABEL

LEAST_SWAP_DISTANCE_MM = 3.0  # marks nearer to each other may share their letters
STANDARD_SCALE_DIFFERENCE = 0.02  # relative difference at which a scale shown by vectors stands for a standard one


def grading_with_swapped_letters(
    bench: PreparedPlan, paper: ReadPaper, grading: Grading
) -> tuple[Grading, SignFault] | None:
    """The grading of a drawing that is right once two of its letters are swapped, and which.

    None if swapping does not mend it, or a mistake of the catalogue explains every mark.
    """
    judged = grading.judgement
    explained = judged.named is not None and judged.explained.keys() >= judged.misses.keys()
    by_search = bool(paper.picture) and bench.plan.is_force  # the search has named its sides
    if not judged.wrong or explained or by_search:
        return None
    names = {s.name: n for s in paper.spots if (n := bench.written_mark_names.find_name(s.name)) and n != POLE_LABEL}
    wrong = {m.label for m in judged.wrong}
    for one, two in combinations(names, 2):
        if not wrong & {names[one], names[two]}:
            continue
        other = {one: two, two: one}
        spots = [replace(s, name=other.get(s.name, s.name)) for s in paper.spots]
        a, b = (next(s.place for s in spots if s.name == name) for name in (one, two))
        mended = grade(bench, replace(paper, spots=spots)) if abs(a - b) > LEAST_SWAP_DISTANCE_MM else None
        if mended and not mended.fault and mended.said_mu >= grading.said_mu:
            return mended, SignFault("names_exchanged", names[one], names[two], grading.judgement.chance_wrong)
    return None


def plan_scale_fault(bench: PreparedPlan, mu: float, chance: float = 1.0) -> SignFault:
    """The fault of a whole plan drawn at another scale than asked, mm per unit: a standard one, if close to it."""
    standard = largest_fitting_scale(bench.plan, 1.0, mu * (1 + STANDARD_SCALE_DIFFERENCE))
    drawn = bench.written_scale(standard if abs(standard / mu - 1) <= STANDARD_SCALE_DIFFERENCE else float(f"{mu:.3g}"))
    return SignFault("plan_scaled", bench.marks[0].label, drawn, chance, mu / bench.said_mu)
