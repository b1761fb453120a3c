"""Documents of a whole course: the teacher's book of answers, the question files of learning platforms."""

import hashlib
import io
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

import pypdfium2

from planes.course import PLATFORMS, Course
from planes.course.quiz import Quiz, judgeable_quizzes, too_uncertain_results
from planes.documents.packages import WRITERS_BY_PLATFORM
from planes.words import Lang, say

_CREATION_DATE_PATTERN = re.compile(rb"(?<=/CreationDate\(D:)\d+")
_FILE_ID_PATTERN = re.compile(rb"(?<=[\[>])<[0-9A-F]{32}>(?=[<\]])")


def common_course_files(course: Course, folder: Path, places: Sequence[str], lang: Lang) -> Iterator[tuple[str, bytes]]:
    """The files of a course with everybody's work, by their names within the folder."""
    here = [folder / "teacher" / place for place in places]
    if "book" in course.documents:
        keys = [file for one in here if (file := one / "key.pdf").is_file()]
        yield "teacher/book.pdf", answer_book_pdf(keys)
    if not {*PLATFORMS} & {*course.documents}:
        return
    quizzes = judgeable_quizzes(_read_quizzes(folder, places))
    title = course.title.get(lang, "")
    for name in PLATFORMS:
        if name in course.documents and quizzes:
            files = WRITERS_BY_PLATFORM[name](quizzes, title, lang)
            yield from ((f"teacher/{name}{file}", data) for file, data in files.items())


def omitted_question_notes(folder: Path, places: Sequence[str], lang: Lang) -> Iterator[str]:
    """The questions that quizzes leave out, one sentence per assignment."""
    for name, names in too_uncertain_results(_read_quizzes(folder, places)).items():
        yield say("quiz_too_wide", lang, scene=name, names=", ".join(names))


def _read_quizzes(folder: Path, places: Sequence[str]) -> list[Quiz]:
    kept = (folder / "teacher" / place / "quiz.json" for place in places)
    return [Quiz.from_stored_text(file.read_text("utf-8")) for file in kept if file.is_file()]


def answer_book_pdf(keys: Sequence[Path]) -> bytes:
    """The pages of everybody's key, in the order of the list."""
    pages = pypdfium2.PdfDocument.new()
    held = io.BytesIO()
    for key in keys:
        with pypdfium2.PdfDocument(key) as one:
            pages.import_pages(one)
    pages.save(held)
    pages.close()
    named = hashlib.sha256(b"".join(key.read_bytes() for key in keys)).hexdigest()[:32].upper().encode()
    plain = _FILE_ID_PATTERN.sub(
        b"<" + named + b">", held.getvalue()
    )  # the library gives a file a random name and a date
    return _CREATION_DATE_PATTERN.sub(lambda date: b"0" * len(date[0]), plain)
