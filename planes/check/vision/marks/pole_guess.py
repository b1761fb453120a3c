"""Where a pole may be that nobody told of: where a plan, drawn rightly or with one mistake, would meet most places."""

from collections.abc import Iterator

import numpy

from planes.check.grading.prepared_plan import PreparedPlan, redrawn, variants_of
from planes.check.grading.remedies import asking
from planes.check.vision.marks.places import Seen
from planes.geometry.arrays import Array, Complexes
from planes.words.names import kind_of, label_of

REACH_MM = 2.5  # of a mark from where it should be
MANY, APART_MM = 3, 15.0  # marks that fit elsewhere by no chance; how far off that is another drawing
LEAST, SHARE, SHARE_MISTAKEN = 2, 0.4, 0.7  # of the marks, that must be met; of a mistake's own, which are many plans'
TRIED = 3  # places where nothing but lines tell a pole
MISTAKEN = 0.5  # of a mark: how much more must be met by a plan with a mistake


def pole_found(bench: PreparedPlan, seen: Seen) -> complex | None:
    """The place from which the plan would meet the most places; None where hardly any would be met."""
    ended = [p for p in seen.places if p.ended]
    starts = numpy.array([p.z for p in ended], complex)
    lines = 0.01 * numpy.array([len(p.ended) for p in ended])
    best, place = 0.0, 0j
    for k, ends in enumerate(_ways(bench) if ended else ()):
        hits = _hits(starts, ends)
        at, enough = int(numpy.argmax(hits + lines)), max(LEAST, (SHARE_MISTAKEN if k else SHARE) * len(ends))
        if k == 0 and len(ends) >= MANY and (abs(starts[hits >= len(ends)] - starts[at]) > APART_MM).any():
            seen.ink.flat.notes.append(asking("check_two_plans", "which"))
        worth = float(hits[at] + lines[at]) - MISTAKEN * (k > 0)
        if hits[at] >= enough and worth > best:
            best, place = worth, complex(starts[at])
    return place if best else None


def likely_poles(seen: Seen) -> list[complex]:
    """Where vectors of a plan of motion may begin: where most lines end and no head points to."""
    tips = [head.z for line in seen.lines for head in line.heads]
    free = [p for p in seen.places if len(p.ended) > 1 and all(abs(p.z - tip) > REACH_MM for tip in tips)]
    return [p.z for p in sorted(free, key=lambda p: -len(p.ended))[:TRIED]]


def _hits(starts: Complexes, ends: Complexes) -> Array:
    """How many of a plan's marks, mm from the pole, would be at places where something ends, from each such place."""
    off = abs(starts[:, None, None] + ends[None, :, None] - starts[None, None, :])
    met: Array = (off.min(axis=2) <= REACH_MM).sum(axis=1)
    return met


def _ways(bench: PreparedPlan) -> Iterator[Complexes]:
    """Marks of the plan away from the pole, rightly drawn and with each mistake; of a force plan, where the order of
    the forces is free, without those that are sure to be elsewhere."""
    force = kind_of(bench.asked.plan) == "force"
    loose = {label_of(s.makes) for s in bench.program.steps if force and s.quantity == "tangential"}
    marks = [m for m in bench.marks if label_of(m) not in loose]
    for variant in (None, *variants_of(bench, {}, bench.said_mu)):
        things = redrawn(bench, variant, lambda step, made: made)
        ends = numpy.array([complex(things[m]) for m in marks] if things else [], complex)
        yield ends[numpy.isfinite(ends) & (abs(ends) > 1)]
