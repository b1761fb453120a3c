"""The structure of a tagged PDF for screen readers: each page is a figure with a title, and its texts, in order.

ISO 32000-1, 14.7 and 14.8: everything drawn belongs to a numbered piece of its page, and each piece to an element.
"""

from __future__ import annotations

from itertools import chain
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas


class Tags:
    """The elements of a document drawn on a canvas; ``title`` is that of its figures."""

    def __init__(self, canvas: Canvas, title: str) -> None:
        self.canvas = canvas
        self.title = title
        self.root = _pdf_dictionary(Type="StructTreeRoot", K=_pdf_array())
        self.document = self._add_element("Document", self.root)
        self.pages: list[Any] = []  # the elements of the pieces of each
        self.pieces: list[Any] = []  # of the present one
        self.open: Any = None  # the element being drawn
        self.figure: Any = None  # of this page

    def _add_element(self, kind: str, parent: Any) -> Any:
        element = _pdf_dictionary(S=kind, P=self.canvas._doc.Reference(parent), K=_pdf_array())
        parent["K"].sequence.append(self.canvas._doc.Reference(element))
        return element

    def begin_piece(self, text: bool) -> None:
        """What follows is a text, or belongs to the figure of the page."""
        from reportlab.pdfbase.pdfdoc import PDFString

        if not text and self.figure is None:
            self.figure = self._add_element("Figure", self.document)
            self.figure["Alt"] = PDFString(self.title)
        if text or self.open is not self.figure:
            self.end_piece()
            self.open = self._add_element("P", self.document) if text else self.figure
            self.open["K"].sequence.append(len(self.pieces))
            self.canvas._code.append(f"/{'P' if text else 'Figure'} <</MCID {len(self.pieces)}>> BDC")
            self.pieces.append(self.canvas._doc.Reference(self.open))

    def end_piece(self) -> None:
        """The end of the piece being drawn."""
        if self.open is not None:
            self.canvas._code.append("EMC")
            self.open = None

    def end_page(self) -> None:
        """The page is complete: its elements know it, and it knows them."""
        self.end_piece()
        self.canvas.showPage()
        page = self.canvas._doc.Pages.pages[-1]
        page.__NoDefault__ = [*page.__NoDefault__, "StructParents"]
        page.StructParents = len(self.pages)
        for piece in self.pieces:
            self.canvas._doc.idToObject[piece.name]["Pg"] = self.canvas._doc.Reference(page)
        self.pages.append(_pdf_array(*self.pieces))
        self.pieces = []
        self.figure = None

    def end_document(self) -> None:
        """The document is complete."""
        catalog = self.canvas._doc.Catalog
        self.root["ParentTree"] = _pdf_dictionary(Nums=_pdf_array(*chain.from_iterable(enumerate(self.pages))))
        catalog.StructTreeRoot = self.root
        catalog.MarkInfo = _pdf_dictionary()
        catalog.MarkInfo["Marked"] = "true"


def _pdf_array(*entries: object) -> Any:
    from reportlab.pdfbase.pdfdoc import PDFArray

    return PDFArray(list(entries))


def _pdf_dictionary(**entries: object) -> Any:
    from reportlab.pdfbase.pdfdoc import PDFDictionary, PDFName

    return PDFDictionary({key: PDFName(x) if isinstance(x, str) else x for key, x in entries.items()})
