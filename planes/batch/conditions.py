"""Conditions a loop checks in every position: the proofs of the plans hold, and all numbers are finite."""

from collections import defaultdict
from collections.abc import Iterable

from planes.batch.symbols import Num, record_number
from planes.batch.tape import Tape
from planes.drafting.program import Program
from planes.drafting.proofs import Facts
from planes.drafting.tools import Things
from planes.geometry.arithmetic import Arithmetic, Real, Truth
from planes.geometry.plane import squared_length

# relative to the largest value on a plan: a larger gap leads to a drawing, and each proof is checked
SUSPECTED_GAP_RATIO = 1e-12


def operations_carrying_nonfinite(tape: Tape, numbers: Iterable[Real]) -> set[int]:
    """The places of all operations that carry an infinity or NaN into one of these numbers."""
    carriers = set()
    stack = [x.at for x in numbers if isinstance(x, Num)]
    while stack:
        place = stack.pop()
        if place not in carriers:
            carriers.add(place)
            op, args = tape.ops[place]
            stack.extend(args if op in ("add", "sub", "mul", "neg", "abs", "hypot") else ())
    return carriers


def prove_plans_together(program: Program, things: Things, ar: Arithmetic) -> tuple[dict[str, Truth], list[Real]]:
    """Whether the proofs of every reason hold, those of a plan together and relative to all its marks, which is fast;
    where they do not, a loop only suspects, and a drawing decides."""
    together = defaultdict(list)
    for proof in program.proofs:
        together[(proof.reason, proof.plan)].append(proof)
    holds = dict[str, Truth]()
    shown = Facts(things, ar)
    gaps = []
    for (reason, plan), proofs in together.items():
        sizes = [shown.mark(step.makes) for step in program.mark_steps_on(plan)]
        size = sum(map(squared_length, sizes or [size for proof in proofs for size in proof.term_magnitudes(shown)]))
        gap = sum(squared_length(z) for proof in proofs for z in proof.residuals(shown))
        gaps.append(gap)
        holds[reason] = holds.get(reason, True) & (gap <= SUSPECTED_GAP_RATIO**2 * size)
    return holds, gaps


def are_all_finite(tape: Tape, numbers: list[Real]) -> Truth:
    """Whether all are finite: zero times each is zero."""
    total: Real = 0.0
    for x in numbers:
        if isinstance(x, Num):
            total = record_number(tape, "mul", x, 0.0) + total
    return total == 0.0
