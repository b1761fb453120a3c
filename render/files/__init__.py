"""Drawings written as files: the module named as a suffix writes its format."""

from dataclasses import dataclass
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import TYPE_CHECKING

from planes.scene.files import save_file_or_refuse
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError
from planes.words.formats import DRAWING_FORMATS, DRAWING_SUFFIXES
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
        if suffix not in DRAWING_FORMATS:
            raise PlanesError(Phrase("bad_suffix", file=suffix or "?", known=DRAWING_SUFFIXES))
        kind = DRAWING_FORMATS[suffix]
        if kind.needs and find_spec(kind.needs) is None:
            raise PlanesError(Phrase(f"needs_{kind.needs}"))
        more = {kind.option: {"under": self.under, "text": text}[kind.option]} if kind.option else {}
        writer = import_module(f"render.files.{suffix[1:]}")
        contents: bytes = writer.write(self.marks, self.size, self.title, lang=self.lang, **more)
        return contents

    def write(self, path: str | Path, text: "Lettered" = "text") -> None:
        """Write the file, whole or not at all."""
        save_file_or_refuse(self.file_contents(Path(path).suffix.lower(), text), path)
