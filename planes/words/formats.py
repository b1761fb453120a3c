"""The formats of drawings, by the suffix of their files: what every command, course and page offers."""

from collections.abc import Mapping
from typing import Literal

from planes.words.frozen import frozen


@frozen
class DrawingFormat:
    """A format, which ``write`` of the module of ``render/files`` with the name of the suffix writes: its media type,
    what it can be given beside marks, and the package it needs besides those installed with the program.

    The option ``under`` is a picture under the marks, ``text`` the choice of lettering (``--text``).
    """

    media_type: str
    option: Literal["under", "text", ""] = ""
    needs: str = ""


DRAWING_FORMATS: Mapping[str, DrawingFormat] = {
    ".pdf": DrawingFormat("application/pdf", "under"),
    ".dxf": DrawingFormat("image/vnd.dxf", "text", needs="ezdxf"),
    ".svg": DrawingFormat("image/svg+xml", "under"),
    ".png": DrawingFormat("image/png", "under"),
}
DRAWING_SUFFIXES = tuple(DRAWING_FORMATS)


def suffixes_with_option(option: str) -> tuple[str, ...]:
    """The suffixes of formats that can be given something beside marks."""
    return tuple(suffix for suffix, kind in DRAWING_FORMATS.items() if kind.option == option)


SUFFIXES_WITH_PICTURE = suffixes_with_option("under")
