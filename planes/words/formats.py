"""The formats of drawings, by the suffix of their files: what every command, course and page offers.

A drawing is written by ``page_bytes`` of the module of ``render/files`` that has the name of the suffix.
"""

from collections.abc import Mapping

from planes.words.frozen import frozen


@frozen
class DrawingFormat:
    """A format: its media type, whether it can hold a picture under the marks, whether the lettering can be chosen in
    it (``--text``), and the package it needs besides those installed with the program."""

    media_type: str
    holds_picture: bool = True
    has_text_choice: bool = False
    needs: str = ""


DRAWING_FORMATS: Mapping[str, DrawingFormat] = {
    ".pdf": DrawingFormat("application/pdf"),
    ".dxf": DrawingFormat("image/vnd.dxf", holds_picture=False, has_text_choice=True, needs="ezdxf"),
    ".svg": DrawingFormat("image/svg+xml"),
    ".png": DrawingFormat("image/png"),
}
DRAWING_SUFFIXES = tuple(DRAWING_FORMATS)
SUFFIXES_WITH_PICTURE = tuple(s for s in DRAWING_SUFFIXES if DRAWING_FORMATS[s].holds_picture)
SUFFIXES_WITH_TEXT_CHOICE = tuple(s for s in DRAWING_SUFFIXES if DRAWING_FORMATS[s].has_text_choice)
