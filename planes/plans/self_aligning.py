"""What a self-aligning variant is: every pair with what it becomes, and the count of Somov and Malyshev."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from planes.plans.structure import Pair
from planes.words.records import Json

Sign = Literal["R", "P", "C", "S"]
FREEDOMS: Mapping[Sign, int] = {"R": 1, "P": 1, "C": 2, "S": 3}
"""How a pair may move: revolute, prismatic, cylindrical, spherical, with as many freedoms."""


@dataclass(frozen=True)
class Aligned:
    """A variant with q = 0: every pair of the mechanism with what it becomes, and the numbers of Somov and Malyshev."""

    n: int
    freedom: int  # the mechanism's own W, in its plane
    pairs: tuple[tuple[Pair, Sign], ...]

    @property
    def counts(self) -> tuple[int, int, int]:
        """How many pairs there are of the fifth, fourth and third class."""
        return tuple(sum(FREEDOMS[sign] == f for _, sign in self.pairs) for f in (1, 2, 3))  # type: ignore[return-value]

    @property
    def W(self) -> int:
        """The degree of freedom by Somov and Malyshev."""
        p5, p4, p3 = self.counts
        return 6 * self.n - 5 * p5 - 4 * p4 - 3 * p3

    @property
    def q(self) -> int:
        """What is redundant, by Malyshev: as much as the count falls short of the mechanism's own freedom."""
        return self.freedom - self.W

    def sign(self, pair: Pair) -> Sign:
        """What a pair becomes."""
        return next(sign for p, sign in self.pairs if p == pair)

    def json(self) -> Json:
        """The variant as ``planes structure --json`` has it."""
        p5, p4, p3 = self.counts
        kinds = {"R": "revolute", "P": "prismatic", "C": "cylindrical", "S": "spherical"}
        rows = [
            {"pair": p.point or p.guide, "links": [p.other, p.link], "kind": kinds[s], "freedoms": FREEDOMS[s]}
            for p, s in self.pairs
        ]
        return {"W": self.W, "q": self.q, "p5": p5, "p4": p4, "p3": p3, "pairs": rows}
