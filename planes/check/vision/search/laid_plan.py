"""A way a plan may have been drawn, laid on a picture mark by mark; and where it may be gone on with otherwise."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import NamedTuple

from planes.check.grading.prepared_plan import Begun
from planes.check.grading.variants import Variant
from planes.check.vision.strokes.line_places import Place
from planes.words.names import POLE, label_of


class Stop(NamedTuple):
    """Where a way stood when a mark was come to: the plan as it was begun and laid so far, and what came nowhere."""

    drawing: Begun
    laid: LaidPlan
    lost: list[complex]

    def with_mistake(self, variant: Variant | None, cost: float) -> Stop:
        """The same where it was come to without the mistake, for whose sake a way costs so much more."""
        if variant is self.laid.variant:
            return self
        return self._replace(laid=replace(self.laid, cost=self.laid.cost + cost, variant=variant))


@dataclass
class LaidPlan:
    """One way the plan may have been drawn, laid on the picture."""

    cost: float
    found: dict[str, Place] = field(default_factory=dict)  # by mark
    variant: Variant | None = None
    vanished: bool = False  # whether a mark that should be elsewhere came to the pole, where it leaves no trace
    others: list[tuple[str, Place | None]] = field(default_factory=list)  # nearly as likely places of marks, or nowhere
    stops: dict[str, Stop] = field(default_factory=dict)  # by mark

    def ends(self, pole: complex) -> dict[str, complex]:
        """Where the pole and the marks that are found lie, by their labels."""
        return {POLE: pole, **{label_of(m): p.z for m, p in self.found.items()}}

    def copy(self) -> LaidPlan:
        """The same, to go on from."""
        return replace(self, found=dict(self.found), others=[*self.others], stops=dict(self.stops))
