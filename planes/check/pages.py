"""Files of several pages: every page is checked, or the one that holds the plan."""

from __future__ import annotations

import io
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

from planes.check import check
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked
from planes.check.handed_in import read_paper
from planes.check.reading.opened import LARGEST, contents, hushed
from planes.check.report import Checked
from planes.words import Phrase
from planes.words.errors import PlanesError, guarded

PAGED = (".pdf", ".tif", ".tiff")
MOST = 200


def page_count(file: str) -> int:
    """How many pages a file has; one, where that cannot be told."""
    if Path(file).suffix.lower() not in PAGED:
        return 1
    data = contents(file, LARGEST)
    try:
        with hushed():
            return min(max(_counted(data), 1), MOST)
    except Exception:  # what is wrong with the file is told when it is read
        return 1


def _counted(data: bytes) -> int:
    if data[:5] == b"%PDF-":
        import pypdfium2

        return len(pypdfium2.PdfDocument(data))
    from PIL import Image

    return int(getattr(Image.open(io.BytesIO(data), formats=("TIFF",)), "n_frames", 1))


def checked_pages(file: str, asked: Asked, known: Known, name: str = "") -> list[Checked]:
    """A file of one drawing, or the page that was asked for; else the only page that can be read, or all of them."""
    count = page_count(file) if known.page is None else 1
    pages = list(_each(file, asked, known, name or Path(file).name, count))
    read = [k for k, one in enumerate(pages) if one.verdict != "unreadable"]
    if count == 1 or len(read) != 1:
        return pages
    only = pages[read[0]]
    if only.found:
        only.found.notes.append(Phrase("check_page_of", page=read[0] + 1, count=count))
    return [replace(only, file=name or Path(file).name)]


def _each(file: str, asked: Asked, known: Known, name: str, count: int) -> Iterator[Checked]:
    for k in range(count):
        here = known if count == 1 else replace(known, page=k)
        called = name if count == 1 else f"{Path(name).stem} p{k + 1}{Path(name).suffix}"
        try:
            with guarded("check_broken", called):  # one page never stops the others
                yield Checked(called, check(asked, read_paper(file, asked, here)))
        except PlanesError as error:
            yield Checked(called, refused=error)
