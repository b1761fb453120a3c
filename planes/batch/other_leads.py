"""Positions where two leads of a special point cross too bluntly: drawn by plans with other leads."""

from collections.abc import Iterator
from functools import cached_property
from typing import Any

import numpy as np

from planes.batch.table import columns_of_quantities
from planes.drafting.steps.by_leads import LEANING_LEADS_REASON
from planes.geometry.arrays import Array, Indices
from planes.plans.other_leads import plans_by_next_leads

Cycle = Any  # of planes.batch: a cycle knows what it passes on


class OtherLeads:
    """The cycles of the same columns by other leads, each stated when it is first needed."""

    def __init__(self, cycle: Cycle) -> None:
        self.cycle = cycle
        self.known: dict[str, Cycle] = {}

    @cached_property
    def special_points_by_code(self) -> dict[int, str]:
        """The special points by the codes of positions where their leads are too nearly parallel."""
        return {k: r.makes for k, r in enumerate(self.cycle.reasons, 1) if r.key == LEANING_LEADS_REASON}

    def fill_block_by_other_cycles(self, block: Any, at: Indices, fast: bool, bare: bool) -> None:
        """Put the results of other cycles into a block of the positions numbered ``at``."""
        for where, other in self._positions_by_cycle(block.codes):
            row = other.choose_loop(fast).row
            for some in np.split(where, range(row, len(where), row)):
                drawn = other.block_of_positions(block.values[some], at[some], fast, bare)
                block.table[:, some] = drawn.table
                block.codes[some] = [self._local_code(other, code) for code in drawn.codes.tolist()]

    def fill_claimed_bounds(self, claimed: Array, values: Array, at: Indices) -> Array:
        """The ± of positions, with those of other cycles filled in."""
        for where, other in self._positions_by_cycle(
            self.cycle.failure_codes(values, at) if self.special_points_by_code else None
        ):
            claimed[:, where] = other.decimal_error_bounds(values[where], at[where])
        return claimed

    def _positions_by_cycle(self, codes: Indices | None) -> Iterator[tuple[Indices, Cycle]]:
        """The positions drawn by another cycle, each with that cycle."""
        for code, special in self.special_points_by_code.items() if codes is not None else ():
            if (where := np.flatnonzero(codes == code)).size:
                yield where, self._cycle_with_next_leads(special)

    def _cycle_with_next_leads(self, special: str) -> Cycle:
        """The cycle with the next two leads of a special point: one of three pairs crosses most sharply."""
        if special not in self.known:
            own = self.cycle
            plans = plans_by_next_leads(own.plans, special)
            columns = {c.name: c for c in columns_of_quantities(plans)}
            asked = [columns[c.name] for c in own.columns]
            self.known[special] = type(own)(plans, known=own.overrides, columns=asked)
        return self.known[special]

    def _local_code(self, other: Cycle, code: int) -> int:
        """The local number of another cycle's reason; an unknown reason counts as the special point's."""
        if not code:
            return 0
        said = other.reasons[code - 1]
        own = self.cycle.reasons
        same = [k for k, r in enumerate(own, 1) if r.key == said.key]
        return next((k for k in same if own[k - 1] == said), (same or list(self.special_points_by_code))[0])
