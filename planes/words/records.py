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


def finite_or_none(value: float) -> float | None:
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


FORMULA_STARTS = tuple("=+-@\t＝＋－＠")  # a cell that begins so is evaluated by a spreadsheet


def csv_text(rows: Iterable[Iterable[str]]) -> str:
    """Rows with commas between the cells, begun so that a spreadsheet knows the letters; no text of somebody else's is
    worked out as a formula."""
    out = io.StringIO()
    out.write("\ufeff")
    csv.writer(out, lineterminator="\n").writerows([safe_spreadsheet_cell(text) for text in row] for row in rows)
    return out.getvalue()


def decode_table(data: bytes) -> str:
    """The text of a table as spreadsheets save it: in UTF-8, UTF-16 or, in Russian, Windows-1251. UnicodeDecodeError
    where it may be none of these: words would have letters of two alphabets, or capitals within."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1251")
        if _NOT_RUSSIAN_PATTERN.search(text):
            raise
        return text


_CYRILLIC_LETTERS = "А-Яа-яЁёІіЇїЄєЎўҐґ"
_RUSSIAN_TEXT_SIGNS = "«»–—№°±·²µ’…\xa0"
_NOT_RUSSIAN_PATTERN = re.compile(
    rf"[A-Za-z][{_CYRILLIC_LETTERS}]|[{_CYRILLIC_LETTERS}][A-Za-z]|[а-яё][А-ЯЁ]|[^\x00-\x7f{_CYRILLIC_LETTERS}{_RUSSIAN_TEXT_SIGNS}]"
)


def safe_spreadsheet_cell(text: str) -> str:
    """The text on one line, with an apostrophe where a spreadsheet would see a formula; a number is unchanged."""
    text = re.sub(r"[\r\n]+", " ", text)
    try:
        float(text)
    except ValueError:
        if text.startswith(FORMULA_STARTS) or text.lstrip().startswith(FORMULA_STARTS):
            return f"'{text}"
        return text
    return text
