"""What may be wrong with the signs of a drawing though its lines are right: letters that were exchanged, arrowheads."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, replace
from itertools import combinations
from typing import Literal

from planes.check.grading.grading import Grading, grade
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.words import Phrase
from planes.words.names import POLE, kind_of

Vector = tuple[str, str]  # the labels of its ends
Head = Literal["end", "start", "none"]  # where a vector has its arrowhead
FEWEST, MOST = 2, 0.7  # so many vectors, and this share of all, must have their heads at their ends
APART_MM = 3.0  # marks nearer to each other may share their letters


@dataclass(frozen=True)
class SignFault:
    """A sign that is wrong: the letters of ``mark`` and ``other`` are exchanged, or the vector from ``other`` to
    ``mark`` has its head at the wrong end or none."""

    mistake: Literal["names_exchanged", "arrow_reversed", "arrow_missing"]
    mark: str
    other: str
    chance_wrong: float = 1.0

    runner_up = None

    @property
    def first_wrong(self) -> str:
        """The mark it is made at."""
        return self.mark

    @property
    def marks(self) -> tuple[str, ...]:
        """The marks that are wrong."""
        return (self.mark, self.other) if self.mistake == "names_exchanged" else (self.mark,)

    @property
    def fault(self) -> Phrase:
        """What it is, and how to mend it."""
        return Phrase(f"mistake_{self.mistake}", mark=self.mark, other=self.other)


def exchanged(bench: PreparedPlan, paper: ReadPaper, found: Grading) -> tuple[Grading, SignFault] | None:
    """The grading of a drawing that is right once two of its letters are exchanged, and which; None where that does not
    mend it, or a mistake of the catalogue explains every mark."""
    judged = found.judgement
    told = judged.named is not None and judged.explained >= judged.misses.keys()
    if not judged.wrong or told or found.rebuilt or kind_of(bench.asked.plan) == "force":
        return None
    names = {s.name: n for s in paper.spots if (n := bench.names.find(s.name)) and n != POLE}
    wrong = {m.rpartition(":")[2] for m in judged.wrong}
    for one, two in combinations(names, 2):
        if not wrong & {names[one], names[two]}:
            continue
        other = {one: two, two: one}
        spots = [replace(s, name=other.get(s.name, s.name)) for s in paper.spots]
        a, b = (next(s.place for s in spots if s.name == name) for name in (one, two))
        mended = grade(bench, replace(paper, spots=spots)) if abs(a - b) > APART_MM else None
        if mended and not mended.fault and mended.said_mu >= found.said_mu:
            return mended, SignFault("names_exchanged", names[one], names[two], found.judgement.chance_wrong)
    return None


def arrow_faults(heads: Mapping[Vector, Head], sure: float = 1.0) -> Iterable[SignFault]:
    """Vectors whose heads are at the wrong end, or not there, where nearly all others have theirs as they should."""
    good = sum(head == "end" for head in heads.values())
    if good < max(FEWEST, MOST * len(heads)):
        return
    for (start, end), head in heads.items():
        at = start if end == POLE else end
        if head == "start":
            yield SignFault("arrow_reversed", at, start, sure)
        elif head == "none" and good == len(heads) - 1:
            yield SignFault("arrow_missing", at, start, sure)
