"""Signs of a drawing that are wrong though its lines are right: exchanged letters, arrowheads."""

from collections.abc import Iterable, Mapping
from typing import Literal

from planes.words import Phrase
from planes.words.frozen import frozen
from planes.words.names import POLE

Vector = tuple[str, str]  # the labels of its ends
Head = Literal["end", "start", "none"]  # where a vector has its arrowhead
FEWEST, MOST = 2, 0.7  # so many vectors, and this share of all, must have their heads at their ends


@frozen
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
