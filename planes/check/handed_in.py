"""Reads submitted files by their suffix: a table, a vector drawing or a picture, one page at a time."""

from __future__ import annotations

import re
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import TYPE_CHECKING

from planes.check.grading.paper import Known, ReadPaper, read_table, with_told
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.reading.opened import LARGEST, contents, hash_of, hushed, too_many
from planes.check.reading.strokes import ReadDrawing
from planes.check.saved_marks import corrected, of_another
from planes.words import Phrase
from planes.words.errors import PlanesError, guarded
from planes.words.frozen import frozen, replace

if TYPE_CHECKING:
    from planes.check.vision.image.decoding import DecodedPicture

LINES = (".svg", ".dxf", ".pdf")
PICTURES = (".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp", ".pdf")
TABLES = (".csv", ".json", ".txt", ".tsv")
MOST_SHOWN = 2000  # maximum number of lines of a drawing in its report
MOST_PAGES, MOST_BLANKS = 300, 9  # pages of a file; pages of a picture file whose marks are saved
NO_DRAWINGS = (".html", ".htm", ".yaml", ".yml", ".md", ".py", ".db", ".ini", ".lnk", ".tmp", ".part", ".url")
"""Suffixes of files that may lie next to the submitted drawings."""
PRACTICE = ".practice"
OTHERS = {  # camera and phone formats that are not supported: suffixes and first bytes
    "check_heic": ((".heic", ".heif", ".hif", ".avif"), rb"....ftyp(hei|hev|mif|msf|avi)"),
    "check_gif": ((".gif",), rb"GIF8"),
    "check_raw": ((".dng", ".cr2", ".cr3", ".nef", ".arw", ".orf", ".rw2", ".psd"), rb"8BPS"),
    "check_spreadsheet": ((".xls", ".xlsx", ".ods", ".numbers"), rb"$^"),  # as archives they begin like others
    "check_office": ((".doc", ".docx", ".odt", ".zip", ".rar", ".cdw", ".dwg"), rb"PK\x03\x04|Rar!|AC10"),
}
ENDS = {b"\xff\xd8\xff": b"\xff\xd9", b"\x89PNG": b"IEND", b"%PDF-": b"%%EOF"}  # first and last bytes of complete files


@frozen
class HandedSheet:
    """One submitted sheet: a file or a page of it (from 1), and its name among the others."""

    file: Path
    page: int | None = None

    @property
    def name(self) -> str:
        """The file name; it may hold any bytes."""
        plain = self.file.name.encode("utf-8", "replace").decode()
        return plain if self.page is None else f"{Path(plain).stem}-{self.page}{self.file.suffix}"

    @property
    def practised(self) -> bool:
        """Whether it is an exercise file rather than a drawing."""
        return self.file.suffix.lower() == PRACTICE

    @property
    def marks(self) -> Path:
        """The table of manually corrected marks next to it."""
        return self.file.with_name(f"{Path(self.name).stem}.csv")

    def known(self, known: Known) -> Known:
        """The known data, with the page of this sheet."""
        if self.page is None:
            return known
        if self.page > MOST_PAGES:
            raise too_many(str(self.file), "pages", MOST_PAGES)
        return replace(known, page=self.page - 1)


def sheets_of(file: Path) -> list[HandedSheet]:
    """The sheets of a file: one for each page of a PDF or a TIFF, one for a file that does not open."""
    count = 1
    if (suffix := file.suffix.lower()) in (".pdf", ".tif", ".tiff") and file.is_file():
        with suppress(PlanesError), guarded("check_picture", file), hushed():
            count = _pages(file, suffix)
    if count > MOST_PAGES:
        return [HandedSheet(file, MOST_PAGES + 1)]  # rejected on reading
    return [HandedSheet(file)] if count < 2 else [HandedSheet(file, k + 1) for k in range(count)]


def _pages(file: Path, suffix: str) -> int:
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
    return [f for f in files if f.suffix.lower() not in NO_DRAWINGS]


def sheets_in(place: Path, one_page: bool, but: str = "") -> list[HandedSheet]:
    """The sheets of a file, or of all drawings of a folder; one of each file if ``one_page``.

    Leaves out tables of corrected marks next to their pictures, and the file ``but`` next to the blanks of a course.
    """
    is_folder = place.is_dir()
    files = [f for f in drawings_in(place) if f.name != but] if is_folder else [place]
    sheets = [s for f in files for s in ([HandedSheet(f)] if one_page else sheets_of(f))]
    drawn = [s for s in sheets if is_folder and s.file.suffix.lower() not in (*TABLES, PRACTICE)]
    beside = {s.marks for one in drawn for s in (one, *(replace(one, page=k) for k in range(1, MOST_BLANKS + 1)))}
    sheets = [s for s in sheets if s.file not in beside]
    if not sheets:
        raise PlanesError(Phrase("check_empty_folder", file=str(place)))
    return sheets


def marks_of(sheet: HandedSheet, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a sheet, or their manual corrections if these belong to this drawing; named after the sheet."""
    file, paper = str(sheet.file), None
    if sheet.marks.is_file() and sheet.marks != sheet.file:
        with suppress(PlanesError):
            paper = read_paper(file, asked, known)
        if not of_another(sheet.marks, paper.look if paper else look_of(file, known)):
            paper = corrected(read_paper(str(sheet.marks), asked, known), paper)
        elif paper:
            paper.notes.append(Phrase("check_marks_of_another", file=sheet.marks.name))
    paper = paper or read_paper(file, asked, known)
    paper.file = str(sheet.file.with_name(sheet.name))
    return paper


def look_of(file: str, known: Known) -> str:
    """The hash of the content of a file or of a page; "" if it does not open."""
    with suppress(PlanesError):
        picture = opened(file, known.page)
        return picture.look if picture else hash_of(contents(file, LARGEST))
    return ""


def read_paper(file: str, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a file. :class:`PlanesError`, with advice, if it cannot be read."""
    suffix = Path(file).suffix.lower()
    if suffix in TABLES:
        return read_table(file)
    with telling(file):
        if sketch := _lines(file, suffix, known):
            return replace(_from_lines(sketch, asked, known), look=hash_of(contents(file, LARGEST)))
        if suffix in PICTURES:
            from planes.check.vision.photograph import paper_of_picture

            return paper_of_picture(file, prepare(asked), known)
        raise PlanesError(Phrase("check_suffix", file=file, suffix=suffix))


@contextmanager
def telling(file: str) -> Iterator[None]:
    """Reports a file that does not open by its kind, where known, not only as unreadable."""
    try:
        yield
    except PlanesError as error:
        key = getattr(error.phrase, "key", "")
        better = _kind(file, Path(file).suffix.lower()) if key in ("check_picture", "check_suffix") else None
        raise better or error from None


def opened(file: str, page: int | None = None) -> DecodedPicture | None:
    """The picture of a file (or of a page, from 0); None for a table or a vector drawing.

    :class:`PlanesError` if it does not open.
    """
    suffix = Path(file).suffix.lower()
    with telling(file):
        if suffix in PICTURES:
            from planes.check.vision.image.decoding import load

            return load(file, page)
        if suffix not in (*LINES, *TABLES):
            raise PlanesError(Phrase("check_suffix", file=file, suffix=suffix))
    return None


def _kind(file: str, suffix: str) -> PlanesError | None:
    """The reason to reject a file, where its first or last bytes say more than that it cannot be read."""
    data = contents(file, LARGEST)
    if not data:
        return PlanesError(Phrase("check_empty", file=file))
    for key, (suffixes, begins) in OTHERS.items():
        if suffix in suffixes or re.match(begins, data, re.DOTALL):
            return PlanesError(Phrase(key, file=file, suffix=suffix))
    if data.startswith(b"%PDF-") and b"/Encrypt" in data:
        return PlanesError(Phrase("check_locked", file=file))
    cut = any(data.startswith(head) and end not in data[-1024:] for head, end in ENDS.items())
    return PlanesError(Phrase("check_cut", file=file)) if cut else None


def _lines(file: str, suffix: str, known: Known) -> ReadDrawing | None:
    """The lines of a vector drawing, or those embedded in a picture.

    None for a PDF that shows a picture, or where pixels are given.
    """
    from planes.check.reading.dxf import read_dxf
    from planes.check.reading.pdf import read_pdf
    from planes.check.reading.svg import read_carried, read_svg

    pixels = known.pole is not None or known.marks or known.format
    match suffix:
        case ".pdf":
            return None if known.pole is not None or known.format else read_pdf(file, known.page or 0)
        case ".png":
            return None if pixels else read_carried(file)
    return {".svg": read_svg, ".dxf": read_dxf}[suffix](file) if suffix in LINES else None


def _from_lines(sketch: ReadDrawing, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a vector drawing."""
    from planes.check.grading.sign_faults import arrow_faults
    from planes.check.reading.construction_lines import doubt_of
    from planes.check.reading.drawn_vectors import vectors_drawn
    from planes.check.reading.matching import scaled
    from planes.check.reading.whole_page import paper_on

    bench = prepare(asked)
    pole = None if known.pole is None else sketch.mm(known.pole)
    sketch, by = scaled(sketch, bench, pole, {n: sketch.mm(z) for n, z in known.marks.items()})
    paper = paper_on(sketch, bench)
    if paper.spots:
        pointed = bench.pointed(known.marks, sketch.mm) if pole is None else {}
        doubt = doubt_of(sketch)
        paper.spots = with_told([replace(s, doubt=max(doubt, s.doubt)) for s in paper.spots], pointed)
    drawn = vectors_drawn(sketch, paper, bench)
    paper.scale_mark, paper.signs = by, paper.signs or [*arrow_faults(drawn)]
    missing = [bench.vectors[vector] for vector, one in drawn.items() if one.how == "missing"]
    paper.left = [*dict.fromkeys([*paper.left, *missing])]
    if paper.left:
        paper.notes.append(Phrase("check_no_vector", names=tuple(paper.left)))
    origin = paper.spots[0].place if paper.spots else 0j  # the pole is read first
    paper.strokes = [(a - origin, b - origin) for a, b in sketch.strokes[:MOST_SHOWN]] if paper.spots else []
    if by:
        paper.notes.append(Phrase("check_scale_vector", mark=by))
    return paper
