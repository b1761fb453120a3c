"""Drawings written as files: SVG, PDF, PNG, DXF."""

from dataclasses import dataclass
from importlib.util import find_spec
from pathlib import Path

from planes.scene.carried import png_with_drawing
from planes.scene.files import save_file_or_refuse
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError
from render.files import dxf, pdf, svg
from render.files.dxf_entities import Lettered
from render.paper.marks import Mark
from render.paper.photo import Photo

DRAWING_SUFFIXES = (".svg", ".pdf", ".png", ".dxf")


@dataclass(frozen=True, repr=False)
class Page:
    """Marks on a page of a given size, width × height in mm, with a picture ``under`` them; and the remarks about
    it."""

    marks: tuple[Mark, ...]
    size: tuple[float, float]
    title: str = ""
    lang: Lang = "ru"
    warnings: tuple[str, ...] = ()
    under: Photo | None = None

    def __repr__(self) -> str:
        return f"<Page {self.title!r}, {self.size[0]:.0f} × {self.size[1]:.0f} mm>"

    def _repr_svg_(self) -> str:
        """The picture a notebook shows."""
        return self.file_contents(".svg").decode().partition("?>\n")[2]

    def file_contents(self, suffix: str, text: Lettered = "text") -> bytes:
        """The contents of its file in the format of a suffix; the same page gives the same bytes. A PNG carries the
        page as SVG."""
        match suffix:
            case ".svg":
                return svg.write(self.marks, self.size, self.title, lang=self.lang, under=self.under)
            case ".pdf":
                return pdf.write(self.marks, self.size, self.title, lang=self.lang, under=self.under)
            case ".dxf" if find_spec("ezdxf") is None:
                raise PlanesError(Phrase("needs_ezdxf"))
            case ".dxf":
                return dxf.write(self.marks, self.size, self.title, lang=self.lang, text=text)
            case ".png":
                picture = pdf.write_png(self.marks, self.size, self.title, under=self.under)
                return picture if self.under else png_with_drawing(picture, self.file_contents(".svg"))
        raise PlanesError(Phrase("bad_suffix", file=suffix or "?", known=".svg, .pdf, .png, .dxf"))

    def write(self, path: str | Path, text: Lettered = "text") -> None:
        """Write the file, whole or not at all."""
        save_file_or_refuse(self.file_contents(Path(path).suffix.lower(), text), path)
