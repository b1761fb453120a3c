"""Tables of marks that were corrected and saved in a report: their drawing, and the position of its picture.

Two comment lines say so: `# sheet LOOK NAME`, the hash of the drawing's content and the name of the table, and
`# box left bottom right top`, mm from the pole. Tables written by hand have neither and are accepted as they are.
"""

import re
from dataclasses import replace
from pathlib import Path

from planes.check.grading.paper import LARGEST_TABLE_BYTES, Box, ReadPaper
from planes.check.reading.opened import HASH_LETTERS, read_bounded_bytes
from planes.words import Phrase

_BOX_NUMBER_PATTERN = r" (-?[0-9]{1,5}(?:[.][0-9]{1,6})?)"


def saved_table_name(table: Path) -> str:
    """The file name of a table saved by a report; "" for any other table."""
    match = _match_sheet_line(table, rf"[0-9a-f]{{{HASH_LETTERS}}} (.+)")
    return match[1].strip() if match else ""


def is_of_another_drawing(table: Path, look: str) -> bool:
    """Whether a table was saved for a drawing with other content."""
    match = _match_sheet_line(table, rf"([0-9a-f]{{{HASH_LETTERS}}}) .*")
    return bool(match and look and match[1] != look)


def _match_sheet_line(table: Path, form: str) -> re.Match[str] | None:
    return re.search(rf"^# sheet {form}$", _table_head(table), re.MULTILINE)


def _table_head(table: Path) -> str:
    return read_bounded_bytes(table, LARGEST_TABLE_BYTES)[:2000].decode("utf-8", "replace")


def combine_with_picture(paper: ReadPaper, picture: ReadPaper | None) -> ReadPaper:
    """A table of marks corrected in the report of a picture, combined with that picture."""
    notes = [*paper.notes, Phrase("check_by_hand", file=Path(paper.file).name)]
    if picture is None:
        return replace(paper, notes=notes)
    paper = replace(paper, mu=picture.mu, look=picture.look, notes=notes)
    if picture.box is None:
        return paper
    box = _picture_box(Path(paper.file), picture.box)
    return replace(paper, picture=picture.picture, box=box, strokes=picture.strokes)


def _picture_box(table: Path, read: Box) -> Box:
    """The position of the picture relative to the pole, which the user may have moved.

    A report page writes it into its table of marks; it is used if it fits a picture of this size.
    """
    match = re.search(rf"^# box{4 * _BOX_NUMBER_PATTERN}$", _table_head(table), re.MULTILINE)
    left, low, right, high = map(float, match.groups()) if match else read
    same = abs(right - left - read[2] + read[0]) < 0.1 and abs(high - low - read[3] + read[1]) < 0.1
    return (left, low, right, high) if same else read
