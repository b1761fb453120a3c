"""Long tables written block by block: CSV, NumPy (.npy, .npz), Parquet. A file appears only when it is complete."""

import zipfile
from collections.abc import Callable, Iterable, Iterator
from contextlib import contextmanager, suppress
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryFile
from typing import IO, Any

import numpy as np

from planes.batch.cycle import Block, Reason
from planes.geometry.arrays import Array
from planes.scene.files import draft_replacing_file, writing_errors_in_words
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.names import NamePair

ROWS_PER_PARQUET_GROUP = 65_536  # rows of one group of Parquet


class TableHead:
    """The columns of a table: the drive's position, the results, and the reason of a failure."""

    def __init__(self, drive: NamePair, columns: Iterable[NamePair], reasons: tuple[Reason, ...]) -> None:
        self.columns = [drive, *columns]
        self.reasons = ["", *(f"{r.key}: {r.makes}" if r.makes else r.key for r in reasons)]


class BlockWriter:
    """Takes blocks one after another; ``end`` when all are there, ``close`` in any case."""

    file: IO[Any]

    def write_block(self, block: Block) -> None:
        """The next positions."""
        raise NotImplementedError

    def finish_file(self) -> None:
        """Finish the file, or raise the error now."""
        self.file.flush()

    def close_file(self) -> None:
        """Close the file."""
        self.file.close()


class Csv(BlockWriter):
    """Comma-separated text, UTF-8: the fewest digits that reproduce every number; an empty cell for a missing one."""

    def __init__(self, path: Path, heading: TableHead, count: int) -> None:
        self.file = path.open("wb")
        self.reasons = [f",{reason}\n".encode() for reason in heading.reasons]
        titles = [*(f"{name} [{unit}]" for name, unit in heading.columns), "failed"]
        self.file.write((",".join(titles) + "\n").encode())

    def write_block(self, block: Block) -> None:
        """One line for each position."""
        lines = _csv_lines(np.vstack([block.values, block.table]).T)
        starts = [0, *(np.flatnonzero(np.diff(block.codes)) + 1).tolist(), len(lines)]
        for start, end in pairwise(starts):
            self.file.write(self.reasons[block.codes[start]].join([*lines[start:end], b""]))


def _csv_lines(rows: Array) -> list[bytes]:
    """The numbers of each row, separated by commas: fifteen times as fast by orjson (the extra ``fast``) as by
    Python."""
    try:
        import orjson
    except ImportError:
        return [",".join(map(repr, row)).replace("nan", "").encode() for row in rows.tolist()]
    text = orjson.dumps(np.ascontiguousarray(rows), option=orjson.OPT_SERIALIZE_NUMPY)
    return text[2:-2].replace(b"null", b"").split(b"],[")


class Npy(BlockWriter):
    """One NumPy array of records, its full length stated first."""

    def __init__(self, path: Path, heading: TableHead, count: int) -> None:
        self.kinds = np.dtype([(name, "<f8") for name, _ in heading.columns] + [("failed", "<i2")])
        start = np.lib.format.open_memmap(path, mode="w+", dtype=self.kinds, shape=(count,)).offset
        self.file = path.open("rb+")  # not through the memory map: a full disk would kill the program without a message
        self.file.seek(start)

    def write_block(self, block: Block) -> None:
        """The next records."""
        part = np.empty(len(block.values), self.kinds)
        for name, row in zip(self.kinds.names or (), [block.values, *block.table, block.codes], strict=True):
            part[name] = row
        self.file.write(part.tobytes())


class Npz(BlockWriter):
    """A NumPy archive: an array for each column, their units, and the reasons for the codes in "failed"."""

    def __init__(self, path: Path, heading: TableHead, count: int) -> None:
        self.path = path
        self.heading = heading
        self.count = count
        self.at = 0
        self.file = TemporaryFile(dir=path.parent)  # noqa: SIM115  # columns in turn; it has no name to be left

    def write_block(self, block: Block) -> None:
        """The next piece of every column."""
        for number, row in enumerate([block.values, *block.table, block.codes]):
            self.file.seek(8 * (number * self.count + self.at))
            self.file.write(np.asarray(row, self._number_type(number)).tobytes())
        self.at += len(block.values)

    def _number_type(self, number: int) -> str:
        return "<f8" if number < len(self.heading.columns) else "<i2"

    def finish_file(self) -> None:
        """Finish the archive of whole columns."""
        with zipfile.ZipFile(self.path, "w", zipfile.ZIP_STORED, allowZip64=True) as archive:
            for number, name in enumerate([*(n for n, _ in self.heading.columns), "failed"]):
                with archive.open(f"{name}.npy", "w", force_zip64=True) as file:
                    self._write_column(file, number)
            for name, words in (("units", [u for _, u in self.heading.columns]), ("reasons", self.heading.reasons)):
                with archive.open(f"{name}.npy", "w") as file:
                    np.lib.format.write_array(file, np.array(words))

    def _write_column(self, file: IO[bytes], number: int, piece: int = 1 << 20) -> None:
        kind = self._number_type(number)
        header = {"descr": kind, "fortran_order": False, "shape": (self.count,)}
        np.lib.format.write_array_header_1_0(file, header)
        self.file.seek(8 * number * self.count)
        left = np.dtype(kind).itemsize * self.count
        for start in range(0, left, piece):
            file.write(self.file.read(min(piece, left - start)))


class Parquet(BlockWriter):
    """Apache Parquet, where pyarrow is installed."""

    def __init__(self, path: Path, heading: TableHead, count: int) -> None:
        try:
            import pyarrow
            import pyarrow.parquet
        except ImportError:
            raise PlanesError(Phrase("cycle_no_parquet")) from None
        self.arrow = pyarrow
        self.reasons = np.array(heading.reasons)
        fields = [pyarrow.field(name, pyarrow.float64(), metadata={"unit": unit}) for name, unit in heading.columns]
        self.schema = pyarrow.schema([*fields, pyarrow.field("failed", pyarrow.string())])
        self.writer = pyarrow.parquet.ParquetWriter(path, self.schema)
        self.waiting: list[Block] = []

    def write_block(self, block: Block) -> None:
        """Collect blocks until they make a row group: the metadata of every group stay in memory to the end."""
        self.waiting.append(block)
        if sum(len(b.values) for b in self.waiting) >= ROWS_PER_PARQUET_GROUP:
            self._write_row_group()

    def _write_row_group(self) -> None:
        rows = np.hstack([np.vstack([b.values, b.table]) for b in self.waiting])
        codes = np.hstack([b.codes for b in self.waiting])
        columns = [*rows, self.reasons[codes]]
        self.writer.write_table(self.arrow.table([self.arrow.array(c) for c in columns], schema=self.schema))
        self.waiting.clear()

    def finish_file(self) -> None:
        """Write the last group, and the footer."""
        if self.waiting:
            self._write_row_group()
        self.writer.close()

    def close_file(self) -> None:
        """Close the file."""
        self.writer.close()


WRITERS_BY_SUFFIX: dict[str, Callable[[Path, TableHead, int], BlockWriter]] = {
    ".csv": Csv,
    ".npy": Npy,
    ".npz": Npz,
    ".parquet": Parquet,
}


@contextmanager
def open_block_writer(path: Path, heading: TableHead, count: int) -> Iterator[BlockWriter]:
    """A writer by the suffix of the file; an unfinished table leaves no file."""
    make = WRITERS_BY_SUFFIX.get(path.suffix.lower())
    if make is None:
        raise PlanesError(Phrase("cycle_suffix", file=str(path), suffixes=", ".join(WRITERS_BY_SUFFIX)))
    with writing_errors_in_words(path), draft_replacing_file(path) as draft:
        writer = make(draft, heading, count)
        try:
            yield writer
            writer.finish_file()
        finally:
            with suppress(OSError):  # of a full disk: already reported
                writer.close_file()
