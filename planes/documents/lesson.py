"""The commands ``planes lesson`` and ``planes note``: a page, or prose with figures, written whole or not at all."""

from __future__ import annotations

import html
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from planes.lesson.data import lesson_data
from planes.lesson.note import Block, Figure, Note
from planes.plans import state
from planes.scene import Scene
from planes.scene.files import keep
from planes.solving import Position, failed, position
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.note import note_said
from render.page.lesson_page import page
from render.paper.names import Naming
from render.sheet.composer import Composer
from render.views import View, view
from render.views.plotted import of_position
from render.views.polygon import Polygon
from render.views.scheme import Scheme

NOTES = (".html", ".pdf", ".docx")
LETTER_MM = 3.5


@dataclass(frozen=True)
class Lesson:
    """A lesson that a notebook shows in its own frame."""

    scene: Scene
    lang: Lang = "en"
    height: int = 900

    def write(self, output: str) -> None:
        """The page as a file; :class:`PlanesError`, and no file, if it cannot be."""
        write_lesson(self.scene, output, self.lang)

    def _repr_html_(self) -> str:
        inner = html.escape(page(lesson_data(self.scene), self.lang), quote=True)
        return f'<iframe srcdoc="{inner}" style="width: 100%; height: {self.height}px; border: 0"></iframe>'


def write_lesson(scene: Scene, output: str, lang: Lang) -> None:
    """The lesson of a scene as one page; :class:`PlanesError`, and no file, if it cannot be."""
    path = Path(output)
    if path.suffix.lower() not in (".html", ".htm"):
        raise PlanesError(note_said("lesson_suffix", lang, file=output))
    with bar() as step:
        text = page(lesson_data(scene, step), lang)
    keep(text.encode(), path)


def write_note(scene: Scene, values: list[float] | None, output: str, lang: Lang) -> None:
    """The note of one position in the format of the file's suffix."""
    path = Path(output)
    if path.suffix.lower() not in NOTES:
        raise PlanesError(note_said("note_suffix", lang, file=output))
    keep(note(scene, values, path.suffix.lower(), lang), path)


def note(scene: Scene, values: list[float] | None, suffix: str, lang: Lang) -> bytes:
    """The contents of a note's file."""
    drawn = placed(scene, values, lang)
    blocks = Note(scene, drawn, lang).blocks()
    composer = Composer(scene, lang, drawn.plans)
    return set_note(blocks, figures(blocks, composer, drawn), composer.naming, suffix)


def placed(scene: Scene, values: list[float] | None, lang: Lang) -> Position:
    """The position the note is about, all of it drawn."""
    if scene.mechanism is None:
        raise SceneError(Phrase("vectors_alone"), scene.file, 1)
    plans = state(scene.mechanism, scene.file)
    if values and len(values) != 1:
        raise PlanesError(note_said("note_one", lang, count=len(values)))
    value = values[0] if values else plans.mechanism.drive.position
    try:
        return position(scene, plans, None, value, None, lang)
    except PlanFailure as failure:
        said = failed(failure, value, plans.mechanism.drive.kind, None, lang)
        raise PlanesError(f"{scene.file}: {said}") from None


def figures(blocks: list[Block], composer: Composer, drawn: Position) -> dict[str, View]:
    """The figures the note has places for, without titles: captions say what they are."""
    plotted, found = of_position(drawn), dict[str, View | None]()
    for key in (b.key for b in blocks if isinstance(b, Figure)):
        kind, _, plan = key.partition(" ")
        if kind == "equations":
            found[key] = composer.formulas(plotted, (plan,), LETTER_MM, "")
        elif key == "scheme":
            found[key] = view("scheme", "", Scheme(drawn, composer.naming).drawn())
        elif not plotted.still(key):
            found[key] = view(key, "", Polygon(plotted, key, composer.naming, counted=composer.details).drawn())
    return {key: one for key, one in found.items() if one}


def set_note(blocks: list[Block], views: dict[str, View], naming: Naming, suffix: str) -> bytes:
    """The note in one format."""
    match suffix:
        case ".html":
            from render.report import note_html

            return note_html.write(blocks, views, naming)
        case ".pdf":
            from render.report import note_pdf

            return note_pdf.write(blocks, views, naming)
        case _:
            from render.report import note_docx

            try:
                return note_docx.write(blocks, views, naming)
            except ImportError:
                raise PlanesError(note_said("no_docx", naming.lang)) from None


@contextmanager
def bar() -> Iterator[Callable[[int, int], None] | None]:
    """A progress bar where a person waits at a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from tqdm import tqdm

    with tqdm(leave=False) as shown:

        def step(done: int, count: int) -> None:
            shown.total, shown.n = count, done
            shown.refresh()

        yield step
