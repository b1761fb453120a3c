"""What was handed in, read by the suffix of its file: a table, a drawing of lines, or a picture."""

from __future__ import annotations

from pathlib import Path

from planes.check.grading.paper import Known, ReadPaper, read_table, with_told
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.reading.strokes import ReadDrawing
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.names import kind_of

LINES = (".svg", ".dxf", ".pdf")
PICTURES = (".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".webp", ".pdf")
TABLES = (".csv", ".json", ".txt", ".tsv")
MOST_SHOWN = 2000  # lines of a drawing shown in its report


def read_paper(file: str, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a file. :class:`PlanesError` where it cannot be read."""
    suffix = Path(file).suffix.lower()
    if suffix in TABLES:
        return read_table(file)
    if sketch := _lines(file, suffix, known):
        return _from_lines(sketch, asked, known)
    if suffix in PICTURES:
        from planes.check.vision.photograph import paper_of_picture

        return paper_of_picture(file, prepare(asked), known)
    raise PlanesError(Phrase("check_suffix", file=file, suffix=suffix))


def _lines(file: str, suffix: str, known: Known) -> ReadDrawing | None:
    """The lines of a drawing of lines; of a PDF with pixels told, or that shows a picture, none."""
    from planes.check.reading.dxf import read_dxf
    from planes.check.reading.pdf import read_pdf
    from planes.check.reading.svg import read_svg

    if suffix == ".pdf":
        return None if known.pole is not None or known.format else read_pdf(file, known.page or 0)
    return {".svg": read_svg, ".dxf": read_dxf}[suffix](file) if suffix in LINES else None


def _from_lines(sketch: ReadDrawing, asked: Asked, known: Known) -> ReadPaper:
    """The marks of a drawing of lines."""
    from planes.check.reading.construction_lines import doubt_of
    from planes.check.reading.matching import scaled
    from planes.check.reading.whole_page import paper_on

    bench = prepare(asked)
    pole = None if known.pole is None else sketch.mm(known.pole)
    sketch, by = scaled(sketch, bench, pole, {n: sketch.mm(z) for n, z in known.marks.items()})
    paper = paper_on(sketch, bench)
    told = {n: sketch.mm(z) for k, z in known.marks.items() if (n := bench.names.find(k))} if pole is None else {}
    if paper.spots:
        told = {} if kind_of(asked.plan) == "force" else told
        paper.spots = with_told(paper.spots, told, doubt_of(sketch))
    paper.scale_mark = by
    origin = paper.spots[0].place if paper.spots else 0j  # the pole is read first
    paper.strokes = [(a - origin, b - origin) for a, b in sketch.strokes[:MOST_SHOWN]] if paper.spots else []
    if by:
        paper.notes.append(Phrase("check_scale_vector", mark=by))
    return paper
