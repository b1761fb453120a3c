"""Marks -> PNG: the page of the PDF as a picture, with its physical size in the file."""

from __future__ import annotations

import io
from collections.abc import Iterable
from pathlib import Path

from planes.scene.files import save
from render.files import pdf
from render.paper.marks import Mark
from render.paper.photo import Photo


def write(
    marks: Iterable[Mark],
    size_mm: tuple[float, float],
    title: str,
    path: str | Path | None = None,
    *,
    dpi: float = 200,
    under: Photo | None = None,
) -> bytes:
    """The sheet as a PNG file at ``dpi`` pixels per inch, ``under`` it a picture; also written to ``path`` if given."""
    return save(from_pdf(pdf.write(marks, size_mm, title, under=under), dpi), path)


def from_pdf(data: bytes, dpi: float = 200, page: int = 0) -> bytes:
    """One page of a PDF file (counted from 0) as a PNG file."""
    import pypdfium2

    document = pypdfium2.PdfDocument(data)
    try:
        picture = document[page].render(scale=dpi / 72).to_pil().convert("RGB")
    finally:
        document.close()
    out = io.BytesIO()
    picture.save(out, format="PNG", dpi=(dpi, dpi), optimize=False)
    return out.getvalue()
