"""Marks -> PNG, which carries the same page as SVG, unless there is a picture under it."""

from collections.abc import Sequence

from planes.scene.carried import png_with_drawing
from render.files import svg
from render.files.pdf import write_png
from render.paper.marks import Mark, Size
from render.paper.photo import Photo


def write(marks: Sequence[Mark], size_mm: Size, title: str, *, lang: str = "ru", under: Photo | None = None) -> bytes:
    """The sheet as a PNG file."""
    picture = write_png(marks, size_mm, title, under=under)
    return picture if under else png_with_drawing(picture, svg.write(marks, size_mm, title, lang=lang))
