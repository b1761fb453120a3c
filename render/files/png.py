"""A page -> PNG, which carries the same page as SVG, unless there is a picture under it."""

from planes.scene.carried import png_with_drawing
from render.files import Page, svg
from render.files.pdf import write_png


def page_bytes(page: Page, text: str) -> bytes:
    """A page as PNG."""
    picture = write_png(page.marks, page.size, page.title, under=page.under)
    return picture if page.under else png_with_drawing(picture, svg.page_bytes(page, text))
