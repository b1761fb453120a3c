"""Tables as CSV that a spreadsheet only shows: no text of somebody else's is worked out as a formula."""

from __future__ import annotations

import csv
import io
import re
from collections.abc import Iterable

FORMULA = tuple("=+-@\t＝＋－＠")  # begins what a spreadsheet works out instead of showing


def as_csv(rows: Iterable[Iterable[str]]) -> str:
    """Rows with commas between the cells."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([cell(text) for text in row] for row in rows)
    return out.getvalue()


def cell(text: str) -> str:
    """The text on one line, after an apostrophe where a spreadsheet would take it for a formula; a number stays one."""
    text = re.sub(r"[\r\n]+", " ", text)
    try:
        float(text)
    except ValueError:
        return f"'{text}" if text.startswith(FORMULA) or text.lstrip().startswith(FORMULA) else text
    return text
