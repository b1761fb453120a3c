"""A long table of results: its columns, the program to draw them many times, and the results of many positions by name,
as arrays: the result of a sweep in Python."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from planes.drafting.program import Program
from planes.geometry.arithmetic import Point
from planes.geometry.arrays import Array, Booleans, Complexes, Floats, Indices, Texts
from planes.plans import Plans
from planes.plans.columns import Column
from planes.plans.quantities import Quantity, distinct_quantities, results_wanted
from planes.words import Phrase
from planes.words.errors import PlanesError, UnknownName
from planes.words.frozen import frozen
from planes.words.names import MarkPair, label_of
from planes.words.naming import Naming
from planes.words.records import Described

if TYPE_CHECKING:
    from matplotlib.figure import Figure
    from pandas import DataFrame

SWEPT_PARAMETER_UNIT = "SI"  # the unit of a parameter with several values
ERROR_COLUMN_PREFIX = "± "  # before the name of a column: the bound on its errors
MOST_SHOWN_COLUMNS = 6  # columns named in the short form


class Table(Described, Mapping[str, Array | Complexes]):
    """Columns by name, each an array of shape (positions,), with their ``units``; ``len`` counts the columns.

    A vector ``v_C`` is complex, x + iy; its components are ``v_C_x`` and ``v_C_y``. Where a position cannot be drawn,
    the numbers are NaN and ``failed`` gives the mark and the reason in short, "C: arcs apart"; elsewhere it is "".
    """

    def __init__(
        self, columns: Mapping[str, Array], units: Mapping[str, str], failed: Texts, naming: Naming | None = None
    ) -> None:
        self.columns = dict(columns)
        self.units = dict(units)
        self.failed = failed
        self.naming = naming or Naming()

    def __getitem__(self, name: str) -> Array | Complexes:
        if name in self.columns:
            return self.columns[name]
        if f"{name}_x" in self.columns:
            return self.columns[f"{name}_x"] + 1j * self.columns[f"{name}_y"]
        try:
            return self[
                self.naming.name_finder((*self.quantities, *self.columns), poles=False).require_name(
                    str(name), "no_column"
                )
            ]
        except PlanesError as error:
            raise UnknownName(error.phrase) from None

    @property
    def quantities(self) -> list[str]:
        """The vectors by their names, v_C of v_C_x and v_C_y, then the other columns."""
        vectors = [column.removesuffix("_x") for column in self.columns if column.endswith("_x")]
        parts = {f"{vector}_{part}" for vector in vectors for part in "xy"}
        return list(dict.fromkeys((*vectors, *(column for column in self.columns if column not in parts))))

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __repr__(self) -> str:
        names = [
            name if (unit := self.units[name]) == SWEPT_PARAMETER_UNIT else f"{name} [{unit}]" for name in self.columns
        ]
        more = ", …" if len(names) > MOST_SHOWN_COLUMNS else ""
        lost = int(np.count_nonzero(self.failed != ""))
        failed = f", {lost} of them failed" if lost else ""
        shown = ", ".join(names[:MOST_SHOWN_COLUMNS])
        return f"<Table of {len(self)} columns, {len(self.failed)} positions{failed}: {shown}{more}>"

    def to_pandas(self) -> DataFrame:
        """The columns as a ``pandas.DataFrame``, the reasons last. Needs pandas: ``pip install pandas``."""
        try:
            import pandas
        except ImportError:
            raise PlanesError(Phrase("needs_pandas")) from None

        return pandas.DataFrame({**self.columns, "failed": self.failed})

    def plot(self, *names: str, over: str | None = None) -> Figure:
        """Curves of the columns named (of all by default) over another one, by default the drive's; a panel for each
        unit.

        A vector ``v_C`` is drawn by its magnitude; in a sweep each set of parameters has its curve. Returns a
        ``matplotlib.figure.Figure``, which a notebook shows and ``figure.savefig("curves.png")`` saves. Raises
        :class:`UnknownName`, a KeyError, for an unknown column.
        """
        from matplotlib.figure import Figure

        over = over or next(iter(set(self.columns) & {"phi", "s"}), next(iter(self.columns)))
        swept = [name for name in self.columns if self.units[name] == SWEPT_PARAMETER_UNIT]
        drawn = names or [
            name for name in self.quantities if name not in {over, *swept} and ERROR_COLUMN_PREFIX not in name
        ]
        changes = [np.diff(self.columns[name]) != 0 for name in swept]
        ends = (np.flatnonzero(np.any(changes, axis=0)) + 1).tolist() if swept else list[int]()
        panels = defaultdict(list)
        for name in drawn:
            panels[self.units.get(name) or self.units.get(f"{name}_x", "")].append(name)
        figure = Figure(figsize=(7.0, 2.4 * len(panels) + 0.6), layout="constrained")
        axes = figure.subplots(len(panels), sharex=True, squeeze=False)[:, 0]
        for panel, (unit, curves) in zip(axes, panels.items(), strict=True):
            for name in curves:
                values = np.abs(self[name]) if np.iscomplexobj(self[name]) else self[name]
                for run in np.split(np.arange(len(values)), ends):
                    swept_values = [f"{one} = {self.columns[one][run[0]]:g}" for one in swept]
                    panel.plot(self[over][run], values[run], label=", ".join([name, *swept_values]))
            panel.set_ylabel(unit)
            panel.grid(alpha=0.3)
            panel.legend(loc="best")
        axes[-1].set_xlabel(f"{over}, {self.units[over]}")
        return figure

    @classmethod
    def joined(cls, tables: list[Table]) -> Table:
        """Tables of the same columns, one below another."""
        columns = {name: np.concatenate([t.columns[name] for t in tables]) for name in tables[0]}
        return cls(columns, tables[0].units, np.concatenate([t.failed for t in tables]), tables[0].naming)


class Block(NamedTuple):
    """Results of successive positions: a row of ``table`` for each column; ``codes`` number the reasons (0: none)."""

    values: Array
    table: Array
    codes: Indices

    @property
    def failed_mask(self) -> Booleans:
        """Positions that could not be drawn: a mask."""
        return np.asarray(self.codes != 0)


@frozen
class Reason:
    """Why positions fail: a key of the table of words, and the step that failed."""

    key: str
    makes: str

    @property
    def reason_in_short(self) -> str:
        """The reason in short: "C: arcs apart"."""
        return ": ".join(filter(None, (label_of(self.makes), self.key.replace("_", " "))))


@dataclass(eq=False)
class Ready:
    """A program ready to be drawn any number of times, and the columns read from each drawing; scales that are
    ``folded`` in are not givens."""

    program: Program
    given: dict[str, Point]
    columns: list[Column]
    folded: dict[str, float]

    def changing_inputs(self, values: Array, at: Indices | slice) -> dict[str, Floats]:
        """The givens that differ in the drawings numbered ``at``: none here."""
        return {}


def columns_of_quantities(plans: Plans, quantities: Iterable[Quantity] | None = None) -> list[Column]:
    """The columns of the requested quantities, or of all but the bare segments of plans; each once."""
    chosen = results_wanted(plans) if quantities is None else distinct_quantities(quantities)
    return list({c.name: c for q in chosen for c in q.columns}.values())


def force_ends_of_columns(columns: Iterable[Column]) -> list[MarkPair]:
    """The ends of the forces among the columns, on their plans; each once."""
    return list(dict.fromkeys((c.start, c.end) for c in columns if c.part and c.unit == "N"))
