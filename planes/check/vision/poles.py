"""Where the pole of a plan is on a sheet: where it is printed or was named, else where the plan fits the lines best."""

from __future__ import annotations

from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.vision.places import Normal, Place, Seen
from planes.words.names import kind_of, label_of

POLE_MM = 0.06  # σ of the place where a line from the pole begins, about the pole
REACH_MM = 2.5  # of a true mark, when the pole is looked for


def pole_on(seen: Seen, near: complex, reach: float = 2.0) -> Place:
    """The pole: where it is printed (or was named), and where the lines drawn from it meet."""
    eqs, ended = Normal(), set[tuple[int, int]]()
    eqs.add(near, 1 + 0j, POLE_MM)
    eqs.add(near, 1j, POLE_MM)
    for k, line in enumerate(seen.lines):
        s, off = line.local(near)
        side = 0 if abs(s - line.low) < abs(s - line.high) else 1
        if abs(off) < 0.8 and abs(line.ends[side] - near) < reach and line.length > 2 * reach:
            eqs.add(line.at(s), 1j * line.direction(s), 2 * line.sigma)
            ended.add((k, side))
    z, sigma = eqs.solved()
    return Place(z, sigma, frozenset(ended))


def pole_found(bench: PreparedPlan, seen: Seen) -> complex | None:
    """The place from which the true plan would meet the most places; None where hardly any would be met."""
    ends = [z for z in bench.true_marks.values() if abs(z) > 1]
    if kind_of(bench.asked.plan) == "force":  # the order of the forces is free: the closing corner alone is sure
        loose = {label_of(s.makes) for s in bench.program.steps if s.quantity == "tangential"}
        ends = [z for n, z in bench.true_marks.items() if n not in loose]
    best, place = 0.0, None
    for p in (p for p in seen.places if p.ended):
        hits = sum(any(q.ended for q in seen.within(p.z + e, REACH_MM)) for e in ends) + 0.01 * len(p.ended)
        if hits > best:
            best, place = hits, p.z
    return place if best >= max(2, 0.4 * len(ends)) else None
