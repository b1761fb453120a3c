"""Documents: blocks as one HTML page, as a PDF, or as a Word document."""

from collections.abc import Sequence
from importlib import import_module

from planes.solving.document import Block
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.naming import Naming

MODULE_OF_SUFFIX = {".html": "html", ".htm": "html", ".pdf": "pdf", ".docx": "word"}
WORD_PACKAGES = ("docx", "mathml2omml")  # what a Word document needs: the extra ``word``


def render_document(blocks: Sequence[Block], suffix: str, naming: Naming) -> bytes:
    """The contents of the file; the same blocks give the same bytes of a page and of a PDF."""
    try:
        contents: bytes = import_module(f"render.report.{MODULE_OF_SUFFIX[suffix]}").write(blocks, naming)
    except ModuleNotFoundError as error:
        if str(error.name).partition(".")[0] not in WORD_PACKAGES:
            raise
        raise PlanesError(Phrase("no_docx")) from None
    return contents
