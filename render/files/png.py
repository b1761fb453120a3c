"""Marks -> PNG: the page of the PDF as a picture, with its physical size and its lettering in the file."""

from __future__ import annotations

import io
import json
from collections.abc import Iterable
from pathlib import Path

from planes.scene.files import save
from planes.words.lettering import LETTERING
from render.files import pdf
from render.paper.marks import Mark, Text
from render.paper.photo import Photo
from render.paper.typeset import layout


def write(
    marks: Iterable[Mark],
    size_mm: tuple[float, float],
    title: str,
    path: str | Path | None = None,
    *,
    dpi: float = 200,
    under: Photo | None = None,
) -> bytes:
    """The sheet as a PNG file at ``dpi`` pixels per inch, ``under`` it a picture; also written to ``path`` if given.

    What is lettered on it, and where, goes with the picture as texts go with a PDF.
    """
    marks = tuple(marks)
    return save(
        from_pdf(pdf.write(marks, size_mm, title, under=under), dpi, lettering=_lettering(marks, size_mm[1])), path
    )


def _lettering(marks: Iterable[Mark], height_mm: float) -> str:
    """Every text: the left end of its base line in mm from the upper left corner, height, width, turn in degrees."""
    found = []
    for laid in (layout(m) for m in marks if isinstance(m, Text)):
        if laid.runs:
            x, y = laid.origin.real, height_mm - laid.origin.imag
            numbers = x, y, laid.runs[0].height, laid.width, laid.turn_deg
            found.append([laid.plain, *(round(n, 2) for n in numbers)])
    return json.dumps(found, ensure_ascii=False)


def from_pdf(data: bytes, dpi: float = 200, page: int = 0, lettering: str = "") -> bytes:
    """One page of a PDF file (counted from 0) as a PNG file."""
    import pypdfium2
    from PIL.PngImagePlugin import PngInfo

    document = pypdfium2.PdfDocument(data)
    try:
        picture = document[page].render(scale=dpi / 72).to_pil().convert("RGB")
    finally:
        document.close()
    out, beside = io.BytesIO(), PngInfo()
    if lettering:
        beside.add_itxt(LETTERING, lettering, zip=True)
    picture.save(out, format="PNG", dpi=(dpi, dpi), optimize=False, pnginfo=beside)
    return out.getvalue()
