"""Drawings written as files: SVG, PDF, PNG, DXF."""

from collections.abc import Callable
from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from planes.scene.carried import png_with_drawing
from planes.scene.files import save_file_or_refuse
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError
from render.paper.marks import Mark, Size
from render.paper.photo import Photo

if TYPE_CHECKING:
    from render.files.dxf_entities import Lettered


@dataclass(frozen=True, repr=False)
class Page:
    """Marks on a page of a given size, width × height in mm, with a picture ``under`` them; and the remarks about
    it."""

    marks: tuple[Mark, ...]
    size: Size
    title: str = ""
    lang: Lang = "ru"
    warnings: tuple[str, ...] = ()
    under: Photo | None = None

    def __repr__(self) -> str:
        return f"<Page {self.title!r}, {self.size[0]:.0f} × {self.size[1]:.0f} mm>"

    def _repr_svg_(self) -> str:
        """The picture a notebook shows."""
        return self.file_contents(".svg").decode().partition("?>\n")[2]

    def file_contents(self, suffix: str, text: "Lettered" = "text") -> bytes:
        """The contents of its file in the format of a suffix; the same page gives the same bytes. A PNG carries the
        page as SVG."""
        if suffix not in WRITER_BY_SUFFIX:
            raise PlanesError(Phrase("bad_suffix", file=suffix or "?", known=DRAWING_SUFFIXES))
        return WRITER_BY_SUFFIX[suffix](self, text)

    def write(self, path: str | Path, text: "Lettered" = "text") -> None:
        """Write the file, whole or not at all."""
        save_file_or_refuse(self.file_contents(Path(path).suffix.lower(), text), path)


def _svg(page: Page, _: "Lettered") -> bytes:
    from render.files import svg

    return svg.write(page.marks, page.size, page.title, lang=page.lang, under=page.under)


def _pdf(page: Page, _: "Lettered") -> bytes:
    from render.files import pdf

    return pdf.write(page.marks, page.size, page.title, lang=page.lang, under=page.under)


def _png(page: Page, text: "Lettered") -> bytes:
    from render.files import pdf

    picture = pdf.write_png(page.marks, page.size, page.title, under=page.under)
    if page.under:
        return picture
    return png_with_drawing(picture, _svg(page, text))


def _dxf(page: Page, text: "Lettered") -> bytes:
    if find_spec("ezdxf") is None:
        raise PlanesError(Phrase("needs_ezdxf"))
    from render.files import dxf

    return dxf.write(page.marks, page.size, page.title, lang=page.lang, text=text)


WRITER_BY_SUFFIX: dict[str, Callable[[Page, "Lettered"], bytes]] = {
    ".svg": _svg,
    ".pdf": _pdf,
    ".png": _png,
    ".dxf": _dxf,
}
"""The formats of drawings; every command that writes one offers these."""
DRAWING_SUFFIXES = tuple(WRITER_BY_SUFFIX)
SUFFIXES_WITH_PICTURE = tuple(s for s in DRAWING_SUFFIXES if s != ".dxf")
"""The formats that can hold a picture under the marks."""
