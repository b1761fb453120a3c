"""A program drawn without a person's marks, and every possible mistake on its way to some results."""

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from planes.check.grading.handwork import Hand
from planes.check.grading.paper import TakenMarks
from planes.check.grading.prepared_plan import PreparedPlan, known_plans, mistake_variants
from planes.check.grading.slips import drawing_value
from planes.check.grading.variants import Variant, Variants

# weight of a mistake in a plan without any of the results: its own results are assumed to be right
EARLIER_PLAN_WEIGHT = 0.25


def true_plan_with_errors(bench: PreparedPlan, wanted: Iterable[str], mu: float, taken: TakenMarks) -> Hand:
    """The true plan with propagated drafting errors, all that its mistakes may read, and the wanted names."""
    program = bench.plans.program.cut_to_names([*bench.program.result_names, *(n for n in wanted if n)])
    return Hand(program, {**bench.given, bench.plan.mu_name: mu}, bench.asked.skill, taken)


def mistakes_before_results(bench: PreparedPlan, free: Hand, shown: Collection[str]) -> Variants:
    """The possible mistakes in each plan on the way to the results, which belong to the plans ``shown``.

    A mistake may also be a habit, made wherever a plan has a step of its kind.
    """
    ways = replace(bench, program=free.program)
    scales = {plan: plan.mu_name for plan in known_plans(bench.plans)}
    for plan in dict.fromkeys(step.plan for step in free.program.steps):
        if scales.get(plan) in free.things:
            weight = 1.0 if plan in shown else EARLIER_PLAN_WEIGHT
            every = mistake_variants(ways, free.taken, drawing_value(free, scales[plan]), plan)
            for variant in (*every, *_repeated_mistakes(every)):
                yield replace(variant, weight=weight * variant.weight)


def _repeated_mistakes(every: Sequence[Variant]) -> Variants:
    """Each mistake made at all its marks, or at all but the driver's, where it can be made in one way at each."""
    for mistake in dict.fromkeys(v.mistake for v in every):
        same = [v for v in every if v.mistake == mistake]
        if len({v.blames for v in same}) == len(same) == len({m for v in same for m in v.swaps}):
            for some in (same, same[1:]):
                swaps = {made: steps for v in some for made, steps in v.swaps.items()}
                if len(some) > 1:
                    yield replace(some[0], swaps=swaps, givens={name: z for v in some for name, z in v.givens.items()})
