"""A program drawn without a person's marks, and every possible mistake on its way to some results."""

from collections.abc import Collection, Iterable, Iterator, Sequence
from dataclasses import replace

from planes.check.grading.handwork import Hand
from planes.check.grading.paper import ReadMark
from planes.check.grading.prepared_plan import PreparedPlan, known_plans, variants_of
from planes.check.grading.slips import number_of
from planes.check.grading.variants import Variant
from planes.words.names import mu_of, plan_of

EARLIER = 0.25  # weight of a mistake in a plan without any of the results: its own results are assumed to be right


def free_hand(bench: PreparedPlan, wanted: Iterable[str], mu: float, taken: dict[str, ReadMark]) -> Hand:
    """The true plan with propagated drafting errors, all that its mistakes may read, and the wanted names."""
    program = bench.plans.program.sliced([*bench.program.made, *(n for n in wanted if n)])
    return Hand(program, {**bench.given, mu_of(bench.asked.plan): mu}, bench.asked.skill, taken)


def on_the_way(bench: PreparedPlan, free: Hand, shown: Collection[str]) -> Iterator[Variant]:
    """The possible mistakes in each plan on the way to the results, which belong to the plans ``shown``.

    A mistake may also be a habit, made wherever a plan has a step of its kind.
    """
    ways, scales = replace(bench, program=free.program), {plan: mu_of(plan) for plan in known_plans(bench.plans)}
    for plan in dict.fromkeys(plan_of(made) for made in free.program.makers):
        if scales.get(plan) in free.things:
            weight = 1.0 if plan in shown else EARLIER
            every = variants_of(ways, free.taken, number_of(free, scales[plan]), plan)
            for variant in (*every, *_habits(every)):
                yield replace(variant, weight=weight * variant.weight)


def _habits(every: Sequence[Variant]) -> Iterator[Variant]:
    """Each mistake made at all its marks, or at all but the driver's, where it can be made in one way at each."""
    for mistake in dict.fromkeys(v.mistake for v in every):
        same = [v for v in every if v.mistake == mistake]
        if len({v.blames for v in same}) == len(same) == len({m for v in same for m in v.swaps}):
            for some in (same, same[1:]):
                swaps = {made: steps for v in some for made, steps in v.swaps.items()}
                if len(some) > 1:
                    yield replace(some[0], swaps=swaps, givens={name: z for v in some for name, z in v.givens.items()})
