"""The columns of a long table of results: their names, units, and how each is taken from what is drawn."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Protocol

from planes.drafting.program import Program
from planes.plans import Plans
from planes.plans.measuring import Quantity, catalogue
from planes.words.names import POLE, at, kind_of, mu_of, plan_of

UNITS = {
    "r": "m", "v": "m/s", "a": "m/s²", "angle_deg": "°", "omega": "rad/s", "epsilon": "rad/s²", "coriolis": "m/s²",
    "moment": "N·m", "force": "N", "velocity": "m/s", "motion": "m/s", "acceleration": "m/s²", "position": "m",
}  # fmt: skip


@dataclass(frozen=True)
class Column:
    """One column: a value by its name, or the ``part`` ("x", "y", "size") of the segment from ``start`` to ``end``.

    A value with ``beside`` (a normal force, then the marks of its plan) is empty where that force is nothing.
    """

    name: str
    unit: str
    value: str = ""
    start: str = ""
    end: str = ""
    part: str = ""
    beside: tuple[str, ...] = ()

    @property
    def kind(self) -> str:
        """What it is weighed against: numbers of its unit; an arm, by itself and those like it."""
        return "arm" if self.beside else self.unit

    @property
    def needs(self) -> tuple[str, ...]:
        """The names of the program the column is taken from."""
        return tuple(n for n in (self.value, self.start, self.end, *self.beside) if n)

    def take(self, things: Mapping[str, Any], ar: Any) -> Any:
        """The column's number (or numbers) from the things drawn."""
        if self.part:
            mu = things[mu_of(plan_of(self.start))]
            segment = things[self.end] - things[self.start]
            size = {"x": lambda: segment.real, "y": lambda: segment.imag, "size": lambda: abs(segment)}[self.part]()
            return size / mu
        if not self.value:
            return 0.0
        return things[self.value] if not self.beside else self._arm(things, ar)

    def _arm(self, things: Mapping[str, Any], ar: Any) -> Any:
        normal, *marks = self.beside
        largest: Any = 0.0
        for mark in marks:
            largest = ar.maximum(largest, abs(things[mark]))
        nothing = abs(things[normal]) <= 1e-12 * largest / things[mu_of(plan_of(marks[0]))]
        return ar.where(nothing, float("nan"), things[self.value])


class Ready(Protocol):
    """A program ready to be drawn any number of times, and the columns read off each drawing."""

    program: Program
    given: dict[str, Any]
    folded: dict[str, float]

    @property
    def columns(self) -> Sequence[Column]: ...

    def moving(self, values: Any, at: Any) -> Mapping[str, Any]:
        """The givens that are other in the drawings numbered ``at``."""
        ...


def columns_of(plans: Plans, quantities: Iterable[Quantity] | None = None) -> list[Column]:
    """The columns of the quantities asked, or of all but the bare segments of plans; each once."""
    known = catalogue(plans).values()
    chosen = [q for q in known if q.path[0] != "plans"] if quantities is None else list(quantities)
    found: dict[str, Column] = {}
    seen = set()
    for q in chosen:
        if q.path not in seen:
            seen.add(q.path)
            for column in _columns(plans, q):
                found.setdefault(column.name, column)
    return list(found.values())


def _columns(plans: Plans, q: Quantity) -> list[Column]:
    match q.path:
        case ("points", point, letter):
            marks = plans.points[point]
            mark = {"r": marks.position, "v": marks.velocity, "a": marks.acceleration}[letter]
            return _vector(q.name, UNITS[letter], at(plan_of(mark), POLE), mark)
        case ("links", _, key):
            return [Column(q.name, UNITS[key], q.needs[0] if q.needs else "")]
        case ("slides", link, "coriolis"):
            ends = plans.acceleration_slides[link].coriolis
            if ends is None:
                return [Column(f"{q.name}_x", "m/s²"), Column(f"{q.name}_y", "m/s²")]
            return _vector(q.name, "m/s²", *ends)
        case ("slides", _, letter):
            return [Column(q.name, UNITS[letter], q.needs[0])]
        case ("reactions", key):
            return _reaction(plans, key)
        case ("plans", plan, _):
            return [Column(q.name, UNITS[kind_of(plan)], "", q.needs[0], q.needs[1], "size")]
    return [Column(q.name, UNITS[q.path[0].rpartition("_")[2]], q.needs[0])]


def _vector(name: str, unit: str, start: str, end: str) -> list[Column]:
    return [Column(f"{name}_{part}", unit, "", start, end, part) for part in ("x", "y")]


def _reaction(plans: Plans, key: str) -> list[Column]:
    r = plans.reactions[key]
    found = _vector(key, "N", r.start, r.end)
    if r.pair.kind == "P":
        marks = tuple(s.makes for s in plans.program.steps if plan_of(s.makes) == r.plan)
        found.append(Column(f"{key}_arm", "m", r.arm, beside=(r.normal, *marks)))
        found.append(Column(f"{key}_moment", "N·m", r.moment))
    return found
