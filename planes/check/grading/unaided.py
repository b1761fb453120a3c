"""Whether marks that were read with no pole named show by themselves that they were told rightly."""

from __future__ import annotations

from planes.check.grading.grading import Grading
from planes.check.grading.judging import LEFT_OUT
from planes.words.names import label_of

FAR_MM = 3.0  # a mark this far off was not merely misread
FITTING = 0.9  # the share of the other marks that must be seen, and right, before one of them is blamed


def sure_by_itself(grading: Grading) -> bool:
    """Whether a verdict may be given: on more than one vector, and on what is wrong only where it is so by far."""
    apart = [0j]
    for place in (grading.hand.taken[m].place for m in grading.judgement.misses):
        apart += [place] if all(abs(place - z) > FAR_MM for z in apart) else []
    return len(apart) > 2 and (not grading.strays or _surely_wrong(grading))


def _surely_wrong(grading: Grading) -> bool:
    """Whether a mark that was seen is wrong by far, and nearly all others were seen and are right."""
    found = grading.judgement
    if found.named and found.named.mistake.endswith(LEFT_OUT):
        return False
    off = max((abs(found.misses[m].off) for m in found.wrong), default=0.0)
    fitting = found.explained if found.named else found.misses.keys() - found.wrong
    others = [m for m in grading.shown_by if label_of(m) != found.first_wrong]
    return off > FAR_MM and sum(m in fitting for m in others) >= FITTING * len(others)
