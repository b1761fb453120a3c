"""Reads submitted files by their suffix: a table, a vector drawing or a picture, one page at a time."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from planes.check.grading.paper import Known, ReadPaper, read_table, with_pointed_marks
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.reading.opened import (
    LARGEST_FILE_BYTES,
    file_error,
    hash_of_content,
    read_bounded_bytes,
    silenced_output,
    too_many_error,
)
from planes.check.reading.strokes import ReadDrawing
from planes.check.saved_marks import combine_with_picture, is_of_another_drawing
from planes.words import Phrase
from planes.words.errors import PlanesError, reporting_library_errors
from planes.words.frozen import frozen, replace

if TYPE_CHECKING:
    from planes.check.vision.image.decoding import DecodedPicture

VECTOR_SUFFIXES = (".svg", ".dxf", ".pdf")
PICTURE_SUFFIXES = (".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp", ".pdf")
TABLE_SUFFIXES = (".csv", ".json", ".txt", ".tsv")
MOST_LINES_SHOWN = 2000  # maximum number of lines of a drawing in its report
MOST_PAGES = 300  # pages of a file
MOST_PAGES_WITH_MARKS = 9  # pages of a picture file whose marks are saved
NO_DRAWING_SUFFIXES = (".html", ".htm", ".yaml", ".yml", ".md", ".py", ".db", ".ini", ".lnk", ".tmp", ".part", ".url")
"""Suffixes of files that may lie next to the submitted drawings."""
EXERCISE_SUFFIX = ".practice"
UNSUPPORTED_FORMATS = {  # camera and phone formats that are not supported: suffixes and first bytes
    "check_heic": ((".heic", ".heif", ".hif", ".avif"), rb"....ftyp(hei|hev|mif|msf|avi)"),
    "check_gif": ((".gif",), rb"GIF8"),
    "check_raw": ((".dng", ".cr2", ".cr3", ".nef", ".arw", ".orf", ".rw2", ".psd"), rb"8BPS"),
    "check_spreadsheet": ((".xls", ".xlsx", ".ods", ".numbers"), rb"$^"),  # as archives they begin like others
    "check_office": ((".doc", ".docx", ".odt", ".zip", ".rar", ".cdw", ".dwg"), rb"PK\x03\x04|Rar!|AC10"),
}
FILE_END_BYTES = {
    b"\xff\xd8\xff": b"\xff\xd9",
    b"\x89PNG": b"IEND",
    b"%PDF-": b"%%EOF",
}  # first and last bytes of complete files


@frozen
class HandedSheet:
    """One submitted sheet: a file or a page of it (from 1), and its name among the others."""

    file: Path
    page: int | None = None

    @property
    def name(self) -> str:
        """The file name; it may hold any bytes."""
        plain = self.file.name.encode("utf-8", "replace").decode()
        if self.page is None:
            return plain
        return f"{Path(plain).stem}-{self.page}{self.file.suffix}"

    @property
    def is_exercise(self) -> bool:
        """Whether it is an exercise file rather than a drawing."""
        return self.file.suffix.lower() == EXERCISE_SUFFIX

    @property
    def corrected_marks_file(self) -> Path:
        """The table of manually corrected marks next to it."""
        return self.file.with_name(f"{Path(self.name).stem}.csv")

    def known_with_page(self, known: Known) -> Known:
        """The known data, with the page of this sheet."""
        if self.page is None:
            return known
        if self.page > MOST_PAGES:
            raise too_many_error(str(self.file), "pages", MOST_PAGES)
        return replace(known, page=self.page - 1)


def sheets_of(file: Path) -> list[HandedSheet]:
    """The sheets of a file: one for each page of a PDF or a TIFF, one for a file that does not open."""
    count = 1
    if (suffix := file.suffix.lower()) in (".pdf", ".tif", ".tiff") and file.is_file():
        with suppress(PlanesError), reporting_library_errors("check_picture", file), silenced_output():
            count = _page_count(file, suffix)
    if count > MOST_PAGES:
        return [HandedSheet(file, MOST_PAGES + 1)]  # rejected on reading
    if count < 2:
        return [HandedSheet(file)]
    return [HandedSheet(file, k + 1) for k in range(count)]


def _page_count(file: Path, suffix: str) -> int:
    if suffix == ".pdf":
        import pypdfium2

        with pypdfium2.PdfDocument(file) as document:
            return len(document)
    from PIL import Image

    with Image.open(file, formats=("TIFF",)) as opened:
        return int(getattr(opened, "n_frames", 1))


def drawings_in(folder: Path) -> list[Path]:
    """The files of a folder that may be drawings or exercise files."""
    files = [f for f in sorted(folder.iterdir()) if f.is_file() and not f.name.startswith((".", "~$"))]
    return [f for f in files if f.suffix.lower() not in NO_DRAWING_SUFFIXES]


def sheets_in(place: Path, one_page: bool, but: str = "") -> list[HandedSheet]:
    """The sheets of a file, or of all drawings of a folder; one of each file if ``one_page``.

    Leaves out tables of corrected marks next to their pictures, and the file ``but`` next to the blanks of a course.
    """
    is_folder = place.is_dir()
    files = [f for f in drawings_in(place) if f.name != but] if is_folder else [place]
    sheets = [s for f in files for s in ([HandedSheet(f)] if one_page else sheets_of(f))]
    drawn = [s for s in sheets if is_folder and s.file.suffix.lower() not in (*TABLE_SUFFIXES, EXERCISE_SUFFIX)]
    beside = {
        s.corrected_marks_file
        for one in drawn
        for s in (one, *(replace(one, page=k) for k in range(1, MOST_PAGES_WITH_MARKS + 1)))
    }
    sheets = [s for s in sheets if s.file not in beside]
    if not sheets:
        raise file_error("check_empty_folder", place)
    return sheets


def read_sheet_marks(sheet: HandedSheet, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a sheet, or their manual corrections if these belong to this drawing; named after the sheet."""
    file = str(sheet.file)
    paper = None
    if sheet.corrected_marks_file.is_file() and sheet.corrected_marks_file != sheet.file:
        with suppress(PlanesError):
            paper = read_paper(file, asked, known)
        if not is_of_another_drawing(sheet.corrected_marks_file, paper.look if paper else content_hash_of(file, known)):
            paper = combine_with_picture(read_paper(str(sheet.corrected_marks_file), asked, known), paper)
        elif paper:
            paper.notes.append(Phrase("check_marks_of_another", file=sheet.corrected_marks_file.name))
    paper = paper or read_paper(file, asked, known)
    paper.file = str(sheet.file.with_name(sheet.name))
    return paper


def content_hash_of(file: str, known: Known) -> str:
    """The hash of the content of a file or of a page; "" if it does not open."""
    with suppress(PlanesError):
        picture = open_picture(file, known.page)
        if picture:
            return picture.pixel_hash
        return hash_of_content(read_bounded_bytes(file, LARGEST_FILE_BYTES))
    return ""


def read_paper(file: str, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a file. :class:`PlanesError`, with advice, if it cannot be read."""
    suffix = Path(file).suffix.lower()
    if suffix in TABLE_SUFFIXES:
        return read_table(file)
    with explain_unopened_file(file):
        if sketch := _read_lines(file, suffix, known):
            return replace(
                _marks_from_lines(sketch, asked, known),
                look=hash_of_content(read_bounded_bytes(file, LARGEST_FILE_BYTES)),
            )
        if suffix in PICTURE_SUFFIXES:
            from planes.check.vision.photograph import read_picture

            return read_picture(file, prepare(asked), known)
        raise file_error("check_suffix", file, suffix=suffix)


@contextmanager
def explain_unopened_file(file: str) -> Iterator[None]:
    """Reports a file that does not open by its kind, where known, not only as unreadable."""
    try:
        yield
    except PlanesError as error:
        key = getattr(error.phrase, "key", "")
        better = (
            _rejection_reason(file, Path(file).suffix.lower()) if key in ("check_picture", "check_suffix") else None
        )
        raise better or error from None


def open_picture(file: str, page: int | None = None) -> DecodedPicture | None:
    """The picture of a file (or of a page, from 0); None for a table or a vector drawing.

    :class:`PlanesError` if it does not open.
    """
    suffix = Path(file).suffix.lower()
    with explain_unopened_file(file):
        if suffix in PICTURE_SUFFIXES:
            from planes.check.vision.image.decoding import load

            return load(file, page)
        if suffix not in (*VECTOR_SUFFIXES, *TABLE_SUFFIXES):
            raise file_error("check_suffix", file, suffix=suffix)
    return None


def _rejection_reason(file: str, suffix: str) -> PlanesError | None:
    """The reason to reject a file, where its first or last bytes say more than that it cannot be read."""
    data = read_bounded_bytes(file, LARGEST_FILE_BYTES)
    if not data:
        return file_error("check_empty", file)
    for key, (suffixes, begins) in UNSUPPORTED_FORMATS.items():
        if suffix in suffixes or re.match(begins, data, re.DOTALL):
            return file_error(key, file, suffix=suffix)
    if data.startswith(b"%PDF-") and b"/Encrypt" in data:
        return file_error("check_locked", file)
    cut = any(data.startswith(head) and end not in data[-1024:] for head, end in FILE_END_BYTES.items())
    return file_error("check_cut", file) if cut else None


def _read_lines(file: str, suffix: str, known: Known) -> ReadDrawing | None:
    """The lines of a vector drawing, or those embedded in a picture.

    None for a PDF that shows a picture, or where pixels are given.
    """
    from planes.check.reading.dxf import read_dxf
    from planes.check.reading.pdf import read_pdf
    from planes.check.reading.svg import read_embedded_svg, read_svg

    pixels = known.pole is not None or known.format
    match suffix:
        case ".pdf" if not pixels:
            return read_pdf(file, known.page or 0)
        case ".png" if not (pixels or known.marks):
            return read_embedded_svg(file)
        case ".svg":
            return read_svg(file)
        case ".dxf":
            return read_dxf(file)
    return None


def _marks_from_lines(sketch: ReadDrawing, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a vector drawing."""
    from planes.check.grading.sign_faults import arrow_faults
    from planes.check.reading.construction_lines import misread_mark_share
    from planes.check.reading.drawn_vectors import drawn_motion_vectors
    from planes.check.reading.matching import scale_sketch
    from planes.check.reading.whole_page import read_page

    bench = prepare(asked)
    pole = None if known.pole is None else sketch.mm(known.pole)
    sketch, by = scale_sketch(sketch, bench, pole, {n: sketch.mm(z) for n, z in known.marks.items()})
    paper = read_page(sketch, bench)
    if paper.spots:
        pointed = bench.pointed_positions(known.marks, sketch.mm) if pole is None else {}
        doubt = misread_mark_share(sketch)
        paper.spots = with_pointed_marks([replace(s, doubt=max(doubt, s.doubt)) for s in paper.spots], pointed)
    drawn = drawn_motion_vectors(sketch, paper, bench)
    paper.scale_mark = by
    paper.signs = paper.signs or [*arrow_faults(drawn)]
    missing = [bench.vector_names[vector] for vector, one in drawn.items() if one.how == "missing"]
    paper.left = [*dict.fromkeys([*paper.left, *missing])]
    if paper.left:
        paper.notes.append(Phrase("check_no_vector", names=tuple(paper.left)))
    origin = paper.spots[0].place if paper.spots else 0j  # the pole is read first
    paper.strokes = [(a - origin, b - origin) for a, b in sketch.strokes[:MOST_LINES_SHOWN]] if paper.spots else []
    if by:
        paper.notes.append(Phrase("check_scale_vector", mark=by))
    return paper
