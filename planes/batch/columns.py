"""The columns of a long table of results, and what a program must have to be drawn for them many times."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from typing import Protocol

from planes.drafting.program import Program
from planes.geometry.arithmetic import Point
from planes.geometry.arrays import Array, Floats, Indices
from planes.plans import Plans
from planes.plans.quantities import Column, Quantity, once, results_of


class Ready(Protocol):
    """A program ready to be drawn any number of times, and the columns read off each drawing."""

    program: Program
    given: dict[str, Point]
    folded: dict[str, float]

    @property
    def columns(self) -> Sequence[Column]: ...

    def moving(self, values: Array, at: Indices | slice) -> Mapping[str, Floats]:
        """The givens that are other in the drawings numbered ``at``."""
        ...


def columns_of(plans: Plans, quantities: Iterable[Quantity] | None = None) -> list[Column]:
    """The columns of the quantities asked, or of all but the bare segments of plans; each once."""
    chosen = results_of(plans) if quantities is None else once(quantities)
    return list({c.name: c for q in chosen for c in q.columns}.values())


def sides_of(columns: Iterable[Column]) -> list[tuple[str, str]]:
    """The ends of the forces among columns, on their plans; each once."""
    return list(dict.fromkeys((c.start, c.end) for c in columns if c.part and c.unit == "N"))
