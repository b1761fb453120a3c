"""The commands ``planes lesson``, ``essay`` and ``note``: pages, or prose with figures, written whole or not at all."""

import html
import re
from dataclasses import replace
from pathlib import Path

from planes.lesson.data import lesson_data
from planes.lesson.essay import FIGURES_BY_PAGE, data_of_essay_pages
from planes.lesson.questions import Questions
from planes.lesson.stated_note import position_note
from planes.scene import Scene
from planes.scene.files import save_file_or_refuse
from planes.solving import Position, failed_position_sentence, plans_and_requested_results, solve_position
from planes.solving.document import Heading, Paragraph
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.frozen import frozen
from planes.words.lettering import without_index_markup
from planes.words.waiting import progress_bar
from render.page.lesson_page import essay_page, whole_lesson_page
from render.report import MODULE_OF_SUFFIX, render_document
from render.sheet.composer import Composer


@frozen
class Lesson:
    """A lesson that a notebook shows in a frame."""

    scene: Scene
    lang: Lang = "en"
    height: int = 900
    centres: bool = False

    def write(self, output: str) -> None:
        """Write the page to a file; on failure :class:`PlanesError`, and no file."""
        write_lesson(self.scene, output, self.lang, self.centres)

    def _repr_html_(self) -> str:
        inner = html.escape(whole_lesson_page(lesson_data(self.scene, centres=self.centres), self.lang), quote=True)
        return f'<iframe srcdoc="{inner}" style="width: 100%; height: {self.height}px; border: 0"></iframe>'


def write_lesson(scene: Scene, output: str, lang: Lang, centres: bool = False) -> None:
    """The lesson of a scene as one page, with its instantaneous ``centres`` if requested; on failure
    :class:`PlanesError`, and no file."""
    if Path(output).suffix.lower() not in (".html", ".htm"):
        raise PlanesError(Phrase("lesson_suffix", file=output))
    with progress_bar() as step:
        text = whole_lesson_page(lesson_data(scene, step, centres), lang)
    save_file_or_refuse(text.encode(), output)


def write_essay(folder: str, lang: Lang) -> None:
    """The pages of the essay, 1.html to 10.html, in a folder; none is written until all are made."""
    pages = [essay_page(data_of_essay_pages(k), lang) for k in range(1, len(FIGURES_BY_PAGE) + 1)]
    Path(folder).mkdir(parents=True, exist_ok=True)
    for number, text in enumerate(pages, 1):
        save_file_or_refuse(text.encode(), str(Path(folder) / f"{number}.html"))


def write_note(scene: Scene, values: list[float] | None, output: str, lang: Lang) -> None:
    """The note of one position in the format of the file's suffix."""
    save_file_or_refuse(note_file_contents(scene, values, _document_suffix(output), lang), output)


def _document_suffix(output: str) -> str:
    """The format of a document, by its file."""
    suffix = Path(output).suffix.lower()
    if suffix not in MODULE_OF_SUFFIX:
        raise PlanesError(Phrase("note_suffix", file=output))
    return suffix


def write_questions(asked: Questions, output: str) -> None:
    """The questions of a defence, answered, in the format of the file's suffix: .html, .pdf or .docx; on failure
    :class:`PlanesError`, and no file."""
    save_file_or_refuse(render_document(asked.document_blocks(), _document_suffix(output), asked.naming), output)


def questions_as_text(asked: Questions) -> str:
    """The same without figures and formulas."""
    shown = (
        "\n" * isinstance(b, Heading) + b.text for b in asked.document_blocks() if isinstance(b, Heading | Paragraph)
    )
    return without_index_markup(
        re.sub("⟨([^⟩]*)⟩", lambda m: asked.naming.terminal_vector_name(m[1]), "\n".join(shown))
    ).strip()


def position_questions(scene: Scene, values: list[float] | None, lang: Lang) -> Questions:
    """The questions to one position of a scene; :class:`PlanesError` without a mechanism or for several positions,
    :class:`SceneError` where the position cannot be drawn."""
    if scene.mechanism is None:
        raise PlanesError(Phrase("questions_no_mechanism", file=scene.file))
    scene = replace(scene, find=None)  # everything may be asked
    return Questions(scene, note_position(scene, values, lang), lang)


def note_file_contents(scene: Scene, values: list[float] | None, suffix: str, lang: Lang) -> bytes:
    """The contents of a note's file."""
    drawn = note_position(scene, values, lang)
    return render_document(
        position_note(scene, drawn, lang).document_blocks(), suffix, Composer(scene, lang, drawn.plans).naming
    )


def note_position(scene: Scene, values: list[float] | None, lang: Lang) -> Position:
    """The position of the note, completely drawn."""
    plans, wanted = plans_and_requested_results(scene, shown=True)
    if values and len(values) != 1:
        raise PlanesError(Phrase("note_one", count=len(values)))
    value = values[0] if values else plans.drive.position
    try:
        return solve_position(scene, plans, wanted, value, None, lang)
    except PlanFailure as failure:
        raise SceneError(failed_position_sentence(failure, value, plans.drive.kind), scene.file) from None
