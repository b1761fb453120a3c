"""The outer form of answers: JSON values, notebook views, CSV tables that a spreadsheet shows but never evaluates."""

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
    """A number for JSON; None where it is infinite or not a number."""
    return value if math.isfinite(value) else None


class Described:
    """Shown in a notebook. The view is set several floors above, where the face of the whole package is known."""

    def _repr_html_(self) -> str:
        html: str = sys.modules[__name__.partition(".")[0]].in_notebook(self)
        return html


class Pictured(Described):
    """Also shown as its scheme or its plans."""

    def _repr_svg_(self) -> str | None:
        shown: str | None = sys.modules[__name__.partition(".")[0]].shown(self)
        return shown


class Tabulated:
    """Printed as its tables."""

    def __str__(self) -> str:
        text: str = sys.modules[__name__.partition(".")[0]].text_of(self)
        return text


FORMULA = tuple("=+-@\t＝＋－＠")  # a cell that begins so is evaluated by a spreadsheet


def as_csv(rows: Iterable[Iterable[str]]) -> str:
    """Rows of cells separated by commas; no text from outside can be evaluated as a formula."""
    out = io.StringIO()
    csv.writer(out, lineterminator="\n").writerows([cell(text) for text in row] for row in rows)
    return out.getvalue()


def cell(text: str) -> str:
    """The text on one line, with an apostrophe where a spreadsheet would see a formula; a number is unchanged."""
    text = re.sub(r"[\r\n]+", " ", text)
    try:
        float(text)
    except ValueError:
        return f"'{text}" if text.startswith(FORMULA) or text.lstrip().startswith(FORMULA) else text
    return text
