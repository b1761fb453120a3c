"""Reports: a document of headings, formulas, tables and figures as one HTML page, or as a PDF."""

from __future__ import annotations

from pathlib import Path

from planes.crank_slider.pages import Document
from planes.scene.files import save


def write(document: Document, path: str | Path) -> None:
    """The document as a file, a PDF or, with any other suffix, a page."""
    if Path(path).suffix.lower() == ".pdf":
        from render.report import pdf as paper

        save(paper.write(document), path)
    else:
        from render.report import html as page

        save(page.write(document), path)
