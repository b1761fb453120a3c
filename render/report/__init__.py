"""Reports: a document of headings, formulas, tables and figures as one HTML page, or as a PDF."""

from __future__ import annotations

from pathlib import Path

from planes.crank_slider.pages import Document
from render.ink import save
from render.report import html as report_html
from render.report import pdf as report_pdf

WRITERS = {".html": report_html.write, ".htm": report_html.write, ".pdf": report_pdf.write}


def write(document: Document, path: str | Path) -> None:
    """The document as a file, in the format of its suffix."""
    save(WRITERS[Path(path).suffix.lower()](document), path)
