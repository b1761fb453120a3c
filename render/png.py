"""Marks -> PNG: the page of the PDF as a picture, with its physical size in the file."""

from __future__ import annotations

import io
from collections.abc import Iterable, Mapping
from pathlib import Path

from render import pdf
from render.ink import save
from render.marks import Mark


def write(
    marks: Iterable[Mark],
    size_mm: tuple[float, float],
    title: str,
    path: str | Path | None = None,
    *,
    dpi: float = 200,
) -> bytes:
    """The sheet as a PNG file at ``dpi`` pixels per inch; also written to ``path`` if one is given."""
    return save(from_pdf(pdf.write(marks, size_mm, title), dpi), path)


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


def stacked(above: bytes, picture: bytes, layers: Mapping[str, bytes]) -> bytes:
    """A PNG file over a picture that has sheets of ink upon it, each in its colour ("#rrggbb")."""
    from PIL import Image, ImageOps

    top = Image.open(io.BytesIO(above)).convert("RGB")
    under = Image.open(io.BytesIO(picture)).convert("RGB")
    under = under.resize((top.width, round(under.height * top.width / under.width)))
    for colour, data in layers.items():
        ink = ImageOps.invert(Image.open(io.BytesIO(data)).convert("L").resize(under.size))
        under.paste(Image.new("RGB", under.size, colour), mask=ink)
    whole = Image.new("RGB", (top.width, top.height + under.height), "white")
    whole.paste(top, (0, 0))
    whole.paste(under, (0, top.height))
    out = io.BytesIO()
    whole.save(out, format="PNG")
    return out.getvalue()
