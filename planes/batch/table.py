"""Results of many positions by name, as arrays; what a sweep in Python gives."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import TYPE_CHECKING

import numpy as np

from planes.geometry.arrays import Array, Complexes, Texts
from planes.words import Phrase
from planes.words.errors import PlanesError, valid_names

if TYPE_CHECKING:
    from pandas import DataFrame

SHOWN = 6  # columns named in the short form


class Table(Mapping[str, Array | Complexes]):
    """Columns by name, each an array of shape (positions,); ``units`` say what they are in.

    A vector ``v_C`` is complex, x + iy; its parts are ``v_C_x`` and ``v_C_y``. Where a position could not be drawn the
    numbers are NaN and ``failed`` has the reason, a key of the table of words, "" elsewhere.
    """

    def __init__(self, columns: Mapping[str, Array], units: Mapping[str, str], failed: Texts) -> None:
        self.columns, self.units, self.failed = dict(columns), dict(units), failed

    def __getitem__(self, name: str) -> Array | Complexes:
        if f"{name}_x" in self.columns:
            return self.columns[f"{name}_x"] + 1j * self.columns[f"{name}_y"]
        if name not in self.columns:
            raise PlanesError(Phrase("no_column", name=name, valid=valid_names(name, list(self.columns))))
        return self.columns[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        return len(self.columns)

    def __repr__(self) -> str:
        names = [f"{name} [{self.units[name]}]" for name in self.columns]
        more = ", …" if len(names) > SHOWN else ""
        return f"<Table of {len(self.failed)} positions: {', '.join(names[:SHOWN])}{more}>"

    def to_pandas(self) -> DataFrame:
        """The columns as a ``pandas.DataFrame``, the reasons last. Needs pandas."""
        import pandas

        return pandas.DataFrame({**self.columns, "failed": self.failed})

    @classmethod
    def joined(cls, tables: list[Table]) -> Table:
        """Tables of the same columns, one below another."""
        columns = {name: np.concatenate([t.columns[name] for t in tables]) for name in tables[0]}
        return cls(columns, tables[0].units, np.concatenate([t.failed for t in tables]))
