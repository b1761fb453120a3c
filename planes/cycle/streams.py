"""Long tables written block by block: CSV, NumPy (.npy, .npz), Parquet. A file appears when it is whole."""

from __future__ import annotations

import os
import zipfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from planes.cycle import Block, Reason
from planes.wording import PlanesError
from planes.words import Phrase

GROUP = 65_536  # rows of one group of Parquet


class Writer(Protocol):
    """Takes blocks one after another."""

    def write(self, block: Block) -> None: ...

    def close(self, whole: bool = True) -> None: ...


class Heading:
    """What a table's columns are: the drive's value, the results, and why a position failed."""

    def __init__(self, drive: tuple[str, str], columns: Iterable[tuple[str, str]], reasons: tuple[Reason, ...]) -> None:
        self.columns = [drive, *columns]
        self.reasons = ["", *(f"{r.key}: {r.makes}" if r.makes else r.key for r in reasons)]

    @property
    def titles(self) -> list[str]:
        """Names with units: "v_C_x [m/s]"."""
        return [f"{name} [{unit}]" for name, unit in self.columns]


@contextmanager
def opened(path: Path, heading: Heading, count: int) -> Iterator[Writer]:
    """A writer by the suffix of the file; what was begun and not ended leaves no file."""
    make = WRITERS.get(path.suffix.lower())
    if make is None:
        raise PlanesError(Phrase("cycle_suffix", file=str(path), suffixes=", ".join(WRITERS)))
    part = path.with_name(f".{path.name}.part")
    writer = None
    try:
        writer = make(part, heading, count)
        yield writer
        writer.close()
        writer = None
        os.replace(part, path)
    except OSError as error:
        raise PlanesError(Phrase("cannot_write", file=str(path), reason=error.strerror or str(error))) from None
    finally:
        if writer:
            writer.close(whole=False)
        part.unlink(missing_ok=True)


class Csv:
    """Comma-separated text, UTF-8: shortest digits that give every number back; an empty cell where there is none."""

    def __init__(self, path: Path, heading: Heading, count: int) -> None:
        self.file, self.reasons = path.open("w", encoding="utf-8", newline="\n"), heading.reasons
        self.file.write(",".join([*heading.titles, "failed"]) + "\n")

    def write(self, block: Block) -> None:
        """One line for each position."""
        rows = np.vstack([block.values, block.table]).T.tolist()
        lines = (",".join(map(repr, row)) for row in rows)
        text = (f"{line},{self.reasons[code]}\n" for line, code in zip(lines, block.codes.tolist(), strict=True))
        self.file.write("".join(text).replace("nan", ""))

    def close(self, whole: bool = True) -> None:
        """End the file."""
        self.file.close()


class Npy:
    """One NumPy array of records, made at its full length and filled."""

    def __init__(self, path: Path, heading: Heading, count: int) -> None:
        kinds = [(name, "<f8") for name, _ in heading.columns] + [("failed", "<i2")]
        self.array = np.lib.format.open_memmap(path, mode="w+", dtype=np.dtype(kinds), shape=(count,))
        self.at = 0

    def write(self, block: Block) -> None:
        """Fill the next records."""
        part = self.array[self.at : self.at + len(block.values)]
        for name, row in zip(self.array.dtype.names or (), [block.values, *block.table, block.codes], strict=True):
            part[name] = row
        self.at += len(block.values)

    def close(self, whole: bool = True) -> None:
        """Everything is on the disk."""
        self.array.flush()


class Npz:
    """A NumPy archive: an array for each column, their units, and the reasons the codes in "failed" stand for."""

    def __init__(self, path: Path, heading: Heading, count: int) -> None:
        self.path, self.heading, self.raw = path, heading, path.with_suffix(".raw")
        self.npy = Npy(self.raw, heading, count)

    def write(self, block: Block) -> None:
        """Records first; columns when all are there."""
        self.npy.write(block)

    def close(self, whole: bool = True) -> None:
        """Columns out of records, a piece at a time."""
        try:
            self.npy.close()
            if not whole:
                return
            with zipfile.ZipFile(self.path, "w", zipfile.ZIP_STORED, allowZip64=True) as archive:
                for name in self.npy.array.dtype.names or ():
                    self._column(archive, name)
                for name, words in (("units", [u for _, u in self.heading.columns]), ("reasons", self.heading.reasons)):
                    with archive.open(f"{name}.npy", "w") as file:
                        np.lib.format.write_array(file, np.array(words))
        finally:
            self.raw.unlink(missing_ok=True)

    def _column(self, archive: zipfile.ZipFile, name: str, piece: int = 65536) -> None:
        array = self.npy.array
        header = {"descr": array.dtype[name].str, "fortran_order": False, "shape": array.shape}
        with archive.open(f"{name}.npy", "w", force_zip64=True) as file:
            np.lib.format.write_array_header_1_0(file, header)
            for start in range(0, len(array), piece):
                file.write(np.ascontiguousarray(array[name][start : start + piece]).tobytes())


class Parquet:
    """Apache Parquet, where pyarrow is installed."""

    def __init__(self, path: Path, heading: Heading, count: int) -> None:
        try:
            import pyarrow
            import pyarrow.parquet
        except ImportError:
            raise PlanesError(Phrase("cycle_no_parquet")) from None
        self.arrow, self.reasons = pyarrow, np.array(heading.reasons)
        fields = [
            pyarrow.field(name, pyarrow.float64(), metadata={"unit": unit}) for name, unit in heading.columns
        ]
        self.schema = pyarrow.schema([*fields, pyarrow.field("failed", pyarrow.string())])
        self.writer = pyarrow.parquet.ParquetWriter(path, self.schema)
        self.waiting: list[Block] = []

    def write(self, block: Block) -> None:
        """Blocks wait until they make a row group: what is told of every group stays in memory to the end."""
        self.waiting.append(block)
        if sum(len(b.values) for b in self.waiting) >= GROUP:
            self._group()

    def _group(self) -> None:
        rows = np.hstack([np.vstack([b.values, b.table]) for b in self.waiting])
        codes = np.hstack([b.codes for b in self.waiting])
        columns: list[Any] = [*rows, self.reasons[codes]]
        self.writer.write_table(self.arrow.table([self.arrow.array(c) for c in columns], schema=self.schema))
        self.waiting.clear()

    def close(self, whole: bool = True) -> None:
        """The last group, and the footer."""
        try:
            if whole and self.waiting:
                self._group()
        finally:
            self.writer.close()


WRITERS: dict[str, Callable[[Path, Heading, int], Writer]] = {
    ".csv": Csv, ".npy": Npy, ".npz": Npz, ".parquet": Parquet,
}  # fmt: skip
