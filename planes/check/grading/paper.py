"""A person's submission read from a table: ends of vectors, lengths of segments, or results."""

import csv
import json
import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from planes.check.grading.sign_faults import SignFault
from planes.check.reading.opened import MB, file_error, read_bounded_bytes, too_many_error
from planes.check.reading.written import Stroke
from planes.words import Phrase, available_languages, say
from planes.words.errors import quoted_excerpt
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, Mark
from planes.words.records import decode_table

REQUIRED_COLUMNS = (("mark", "x_mm", "y_mm"), ("segment", "mm"), ("result", "value"))
"""The required columns of each table."""
_COLUMN_KEYS = ("mark", "x_mm", "y_mm", "segment", "mm", "result", "value", "unit", "error_mm")
COLUMN_SPELLINGS = {
    key: (key, *(way for lang in available_languages() for way in say(f"written_{key}", lang).split(", ")))
    for key in _COLUMN_KEYS
}
"""The names of table columns, and how people write them in every language."""
_JSON_PART_COLUMNS = {"rows": "mark", "marks": "mark", "segments": "segment", "results": "result"}  # of JSON
_ROUNDING_SIGMA_DIVISOR = math.sqrt(12)  # a number rounded to r has the error r/√12
LARGEST_TABLE_BYTES = 2 * MB
MOST_ROWS = 2000  # rows
LARGEST_COORDINATE_MM = 10_000.0  # no sheet is larger
POINTED_MARK_ERROR_MM = 0.3  # accuracy of a mark pointed to by a person
MarkPlaces = dict[str, complex]  # by label, or by name
Box = tuple[float, float, float, float]  # left, bottom, right, top, mm from the pole


@frozen
class ReadMark:
    """A mark as read, mm on paper, y up, any origin, with its reading error (in each direction).

    It also has the probability that it was read at a point that is not the person's mark at all. Part of its error may
    be shared with all marks: the displacement by one σ of each common cause.
    """

    name: str
    place: complex
    error_mm: float = 0.1
    doubt: float = 0.0
    shared: tuple[complex, ...] = ()

    @property
    def individual_error_mm(self) -> float:
        """The individual part of its error."""
        return math.sqrt(max(self.error_mm**2 - sum(abs(z) ** 2 for z in self.shared) / 2, 0.0))


ReadMarks = dict[str, ReadMark]  # by label
TakenMarks = dict[Mark, ReadMark]


def with_pointed_marks(spots: Iterable[ReadMark], pointed: MarkPlaces) -> list[ReadMark]:
    """The marks read, with those pointed to by a person, which are certain, in place of their readings."""
    read = [s for s in spots if s.name not in pointed]
    return [*read, *(ReadMark(n, z, POINTED_MARK_ERROR_MM) for n, z in pointed.items())]


@frozen
class Known:
    """Given data of a drawing: its pole, some marks (pixels or drawing units; y down), frame size, page (from 0)."""

    pole: complex | None = None
    marks: MarkPlaces = field(default_factory=dict)
    format: str | None = None
    page: int | None = None


@dataclass
class ReadPaper:
    """Everything read from a submission, in its order. It is ``whole`` if nothing can have been overlooked."""

    file: str = ""
    spots: list[ReadMark] = field(default_factory=list)
    segments: list[tuple[str, float]] = field(default_factory=list)
    results: list[tuple[str, float, str]] = field(default_factory=list)
    scale_mark: str | None = None  # the vector that set the scale of the picture
    mu: float | None = None  # the scale in its title
    whole: bool = True
    pole_told: bool = True  # whether it was named, printed or drawn as such, not guessed from a picture
    picture: bytes = b""  # the rectified picture, for the report
    box: Box | None = None  # its position
    look: str = ""  # hash of its content
    strokes: list[Stroke] = field(default_factory=list)  # lines of a vector drawing, from the pole
    signs: list[SignFault] = field(default_factory=list)  # wrong letters and arrowheads
    left: list[str] = field(default_factory=list)  # ignored columns of a table, vectors not drawn
    untold: list[str] = field(default_factory=list)  # vectors that, with a mistake, may be others
    named: list[str] = field(default_factory=list)  # marks not read, but with names at their expected positions
    notes: list[Phrase] = field(default_factory=list)
    reason: Phrase | None = None  # why none of its marks could be read


def read_table(path: str | Path) -> ReadPaper:
    """A CSV or JSON file as a paper; :class:`PlanesError` if it cannot be read."""
    paper = ReadPaper(str(path))
    try:
        text = decode_table(read_bounded_bytes(path, LARGEST_TABLE_BYTES))
    except UnicodeDecodeError:
        raise file_error("check_text", paper.file) from None
    if text.lstrip()[:1] in ("{", "["):
        _read_json(paper, text)
    else:
        _read_rows(paper, _split_rows(text))
    return paper


def _split_rows(text: str) -> list[tuple[int, list[str]]]:
    """Rows with their numbers; the first row determines the separator."""
    lines = [line for line in text.splitlines() if line.strip() and not line.lstrip().startswith("#")]
    mark = next((c for c in (";", "\t") if lines and c in lines[0]), ",")
    rows = csv.reader(text.splitlines(), delimiter=mark)
    cells = ((rows.line_num, [c.strip() for c in row]) for row in rows)
    return [(line, row) for line, row in cells if any(row) and not row[0].startswith("#")]


def _read_rows(paper: ReadPaper, rows: Sequence[tuple[int, list[str]]]) -> None:
    """Rows under one or more headers: a new header begins a new table."""
    columns = _header_columns(rows[0][1]) if rows else None
    if columns is None:
        raise file_error("check_columns", paper.file)
    for line, row in rows:
        if head := _header_columns(row):
            columns = head
            paper.left += [name for name in head if name and name not in (*COLUMN_SPELLINGS, *paper.left)]
        elif any(row[len(columns) :]):
            raise file_error("check_row_long", paper.file, line=line, count=len(row), most=len(columns))
        else:
            _add_row(paper, dict(zip(columns, row, strict=False)), line)


def _header_columns(row: Sequence[str]) -> list[str] | None:
    names = [next((k for k, words in COLUMN_SPELLINGS.items() if cell.casefold() in words), cell) for cell in row]
    for wanted in REQUIRED_COLUMNS:
        if all(w in names for w in wanted):
            return names
    return None


def _add_row(paper: ReadPaper, row: Mapping[str, object], line: int) -> None:
    """One row of any table."""

    def once(name: str, before: Iterable[str]) -> None:
        if name in before:
            raise file_error("check_row_twice", paper.file, line=line, name=quoted_excerpt(name))

    if "" in (row.get(key) for key in ("x_mm", "y_mm", "mm", "value")):  # the number was not written
        paper.left += [str(row.get(key)) for key in ("mark", "segment", "result") if row.get(key)]
        return
    if len(paper.spots) + len(paper.segments) + len(paper.results) >= MOST_ROWS:
        raise too_many_error(paper.file, "rows", MOST_ROWS)
    if "mark" in row:
        cells = [row.get("x_mm"), row.get("y_mm")]
        if None in cells:
            raise file_error("check_row", paper.file, line=line)
        x, y = (_parse_length_mm(paper, c, line) for c in cells)
        said = row.get("error_mm") or None
        error = (
            abs(_parse_length_mm(paper, said, line)) if said is not None else max(_rounding_error_mm(c) for c in cells)
        )
        once(str(row["mark"]), (s.name for s in paper.spots if s.name != POLE_LABEL))  # a pole begins each polygon
        paper.spots.append(ReadMark(str(row["mark"]), complex(x, y), error))
    elif "segment" in row and row.get("mm") is not None:
        segment = str(row["segment"]), abs(_parse_length_mm(paper, row["mm"], line))
        once(segment[0], (n for n, _ in paper.segments))
        paper.segments.append(segment)
    elif "result" in row and row.get("value") is not None:
        result = str(row["result"]), _parse_number(paper, row["value"], line), str(row.get("unit") or "")
        once(result[0], (n for n, *_ in paper.results))
        paper.results.append(result)
    else:
        raise file_error("check_row", paper.file, line=line)


def _parse_number(paper: ReadPaper, cell: object, line: int) -> float:
    try:
        number = float(str(cell).replace(",", ".").replace("−", "-").replace(" ", "").replace("\u00a0", ""))
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise file_error("check_not_number", paper.file, line=line, text=f'"{str(cell)[:40]}"')
    return number


def _parse_length_mm(paper: ReadPaper, cell: object, line: int) -> float:
    """A length on a sheet, mm."""
    length = _parse_number(paper, cell, line)
    if abs(length) > LARGEST_COORDINATE_MM:
        raise file_error("check_no_place", paper.file, line=line, text=str(cell)[:40])
    return length


def _rounding_error_mm(cell: object) -> float:
    """The rounding error of a number: for 12.5, 0.1/√12 mm."""
    text = str(cell).replace(",", ".")
    digits = len(text.partition(".")[2])
    if "e" in text.lower():
        return 0.02
    return float(max(10.0**-digits / _ROUNDING_SIGMA_DIVISOR, 0.02))


def _read_json(paper: ReadPaper, text: str) -> None:
    """The same tables as JSON: a list of rows, or an object with "marks", "segments" and "results"."""
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise file_error("check_json", paper.file, why=str(error)[:80]) from None
    parts = {"marks": data} if isinstance(data, list) else data if isinstance(data, dict) else {}
    if not any(map(parts.get, _JSON_PART_COLUMNS)):
        raise file_error("check_columns", paper.file)
    for name, key in _JSON_PART_COLUMNS.items():
        for line, row in enumerate(_json_rows(parts.get(name), key), 1):
            _add_row(paper, row, line)


def _json_rows(part: object, key: str) -> Iterable[Mapping[str, object]]:
    if isinstance(part, dict):
        for name, value in part.items():
            if key == "mark" and isinstance(value, list) and len(value) == 2:
                yield {"mark": name, "x_mm": value[0], "y_mm": value[1]}
            else:
                yield {key: name, "mm" if key == "segment" else "value": value}
    elif isinstance(part, list):
        for row in part:
            names = _header_columns(list(row)) if isinstance(row, dict) else None
            yield dict(zip(names, row.values(), strict=True)) if names else {}
