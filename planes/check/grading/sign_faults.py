"""Wrong signs in a drawing with right lines: swapped letters, arrowheads."""

from collections.abc import Iterator, Mapping
from typing import Literal, NamedTuple

from planes.words import Phrase, Written
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, NamePair, NameTuple

Vector = NamePair  # the labels of its ends
# this many heads at the ends of their vectors, and most of all heads, show that the person draws them there
LEAST_HEADS_AT_ENDS = 2


class DrawnVector(NamedTuple):
    """A vector as drawn: head at its end, at its start or none; ``off`` mm astray from its marks; or not drawn."""

    how: Literal["end", "start", "none", "astray", "missing"]
    off: float = 0.0


@frozen
class SignFault:
    """A wrong sign of a drawing.

    The letters of ``mark`` and ``other`` are swapped; or the vector from ``other`` to ``mark`` (a force by its name
    alone) has its head at the wrong end or none, or is ``off`` mm astray; or the whole plan, whose first mark is
    ``mark``, is mirrored, turned by ``off`` degrees, or ``off`` times its size, at the scale ``other``.
    """

    mistake: Literal[
        "names_exchanged",
        "arrow_reversed",
        "arrow_missing",
        "vector_astray",
        "plan_mirrored",
        "plan_turned",
        "plan_scaled",
    ]
    mark: str
    other: str | Written
    chance_wrong: float = 1.0
    off: float = 0.0

    runner_up = None

    @property
    def first_wrong(self) -> str:
        """The mark where it is made."""
        return self.mark

    @property
    def marks(self) -> NameTuple:
        """The wrong marks."""
        if self.mistake == "names_exchanged":
            return (self.mark, str(self.other))
        return (self.mark,)

    @property
    def fault(self) -> Phrase:
        """The fault and its correction."""
        off = f"{self.off:.3g}" if self.mistake == "plan_scaled" else f"{self.off:.1f}"
        vector = Phrase("vector_from_to", start=self.other, end=self.mark) if self.other else Phrase("vector_this")
        return Phrase(f"mistake_{self.mistake}", mark=self.mark, other=self.other, vector=vector, off=Written(off))


def arrow_faults(vectors: Mapping[Vector, DrawnVector]) -> Iterator[SignFault]:
    """Vectors astray, and those with a head at the wrong end or missing where most others have it right."""
    ends = [one.how for one in vectors.values() if one.how in ("end", "start", "none")]
    good = ends.count("end")
    usual = good >= LEAST_HEADS_AT_ENDS and 2 * good > len(ends)
    for (start, end), one in vectors.items():
        at = start if end == POLE_LABEL else end
        if one.how == "astray":
            yield SignFault("vector_astray", at, start, off=one.off)
        elif one.how == "start" and usual:
            yield SignFault("arrow_reversed", at, start)
        elif one.how == "none" and usual and good == len(ends) - 1:
            yield SignFault("arrow_missing", at, start)
