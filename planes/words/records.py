"""The outer form of answers: what JSON holds, what a notebook shows, tables as CSV that a spreadsheet only shows."""

import csv
import io
import math
import re
import sys
from collections.abc import Iterable
from typing import Any

Json = dict[str, Any]
"""An object of JSON: names to numbers, texts, lists and objects again."""


def or_none(value: float) -> float | None:
    """A number for a program: none where it has no end, or is none."""
    return value if math.isfinite(value) else None


class Described:
    """Shown in a notebook. Who tells it stands floors above: the face of the whole package knows."""

    def _repr_html_(self) -> str:
        html: str = sys.modules[__name__.partition(".")[0]].in_notebook(self)
        return html


class Pictured(Described):
    """Shown as its scheme or its plans, too."""

    def _repr_svg_(self) -> str | None:
        shown: str | None = sys.modules[__name__.partition(".")[0]].shown(self)
        return shown


class Tabulated:
    """Printed as its tables."""

    def __str__(self) -> str:
        text: str = sys.modules[__name__.partition(".")[0]].text_of(self)
        return text


FORMULA = tuple("=+-@\t＝＋－＠")  # begins what a spreadsheet works out instead of showing


def as_csv(rows: Iterable[Iterable[str]]) -> str:
    """Rows with commas between the cells; no text of somebody else's is worked out as a formula."""
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
