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
    """Rows with commas between the cells, begun so that a spreadsheet knows the letters; no text of somebody else's is
    worked out as a formula."""
    out = io.StringIO()
    out.write("\ufeff")
    csv.writer(out, lineterminator="\n").writerows([cell(text) for text in row] for row in rows)
    return out.getvalue()


def table_text(data: bytes) -> str:
    """The text of a table as spreadsheets save it: in UTF-8, UTF-16 or, in Russian, Windows-1251. UnicodeDecodeError
    where it may be none of these: words would have letters of two alphabets, or capitals within."""
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return data.decode("utf-16")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = data.decode("cp1251")
        if _NOT_RUSSIAN.search(text):
            raise
        return text


_RUSSIAN = "А-Яа-яЁёІіЇїЄєЎўҐґ"
_SIGNS = "«»–—№°±·²µ’…\xa0"
_NOT_RUSSIAN = re.compile(rf"[A-Za-z][{_RUSSIAN}]|[{_RUSSIAN}][A-Za-z]|[а-яё][А-ЯЁ]|[^\x00-\x7f{_RUSSIAN}{_SIGNS}]")


def cell(text: str) -> str:
    """The text on one line, after an apostrophe where a spreadsheet would take it for a formula; a number stays one."""
    text = re.sub(r"[\r\n]+", " ", text)
    try:
        float(text)
    except ValueError:
        return f"'{text}" if text.startswith(FORMULA) or text.lstrip().startswith(FORMULA) else text
    return text
