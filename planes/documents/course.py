"""The documents of one student, made by any worker: plain data in, the contents of files out."""

import json
import threading
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from functools import cached_property

from pypdfium2 import PdfDocument

from planes.check.fiducials import SHEET_MM
from planes.check.grading.prepared_plan import Asked
from planes.check.sheet_mark import SheetMark
from planes.course import PLATFORMS, Course
from planes.course.ledger import Sentences, program_fingerprint
from planes.course.numbers import missing_document_reason
from planes.course.papers import (
    answer_key_blocks,
    clearest_driver_angle,
    conditions_in_words,
    given_data_table,
    task_sheet_blocks,
)
from planes.course.quiz import Pool, Quiz, QuizGiven, quiz_items
from planes.documents.check import blank_marks
from planes.documents.drawn import page_of_view, picture
from planes.documents.lesson import note_file_contents, note_position
from planes.documents.packages import scorm_archive
from planes.documents.platforms import question_stem
from planes.documents.sheets import sheet_of
from planes.lesson.data import lesson_data
from planes.plans.scales import PLAN_FIT_MM
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene, loads
from planes.solving import Position, solve_position
from planes.solving.document import Block
from planes.solving.given import GIVEN_NUMBER_DIGITS
from planes.words import Lang, Phrase
from planes.words.frozen import frozen
from planes.words.names import NamesByName, NameTriple, NameTuple, NumbersByName
from render.files import Page, pdf
from render.page.lesson_page import whole_lesson_page
from render.paper.letters import BRACKETED_NAME_PATTERN
from render.report import render_document
from render.sheet import Sheet
from render.sheet.composer import Composer
from render.sheet.studio_code import blank_back_marks

SCHEME_SIZES_MM = (75.0, 60.0, 45.0, 36.0)
"""Sizes of the scheme on a task: the largest that leaves room for the rest of the page is used."""
_DRAWING_LOCK = threading.Lock()  # a worker may have several threads; the drawing libraries prefer one


@frozen
class Order:
    """What is to be made of a student's scene: the names of ``files``, their heads, the plans asked for; whose it is:
    assignment, variant, student, as blanks say it."""

    scene: str
    heads: NameTuple
    files: NameTuple
    plans: NameTuple
    lang: Lang
    whose: NameTriple = ("", "", "")
    program: str = ""


@frozen
class MadeDocuments:
    """The contents of files by name; for a failed file a sentence with the reason; ``said``: remarks on the others."""

    files: dict[str, bytes] = field(default_factory=dict)
    faults: NamesByName = field(default_factory=dict)
    said: dict[str, NameTuple] = field(default_factory=dict)


def folders_by_file_name(course: Course) -> NamesByName:
    """The files for each student: name -> its folder, "students" or "teacher"."""
    known = {"sheets": [f"sheet-{n}.{f}" for n in (1, 2) for f in course.formats], "lesson": ["lesson.html"]}
    known |= {"scorm": ["scorm.zip"], "book": ["key.pdf"]} | {key: ["quiz.json"] for key in PLATFORMS}
    side = {"task": "students", "blank": "students"}
    return {n: side.get(d, "teacher") for d in course.documents for n in known.get(d, [f"{d}.pdf"])}


def files_of_scene(names: NamesByName, scene: Scene) -> NameTuple:
    """Those of the files that a scene has: stated vectors have one sheet."""
    return tuple(n for n in names if scene.mechanism or not n.startswith("sheet-2"))


def make_documents(order: Order) -> MadeDocuments:
    """Every file requested; a failure does not stop the rest."""
    if order.program and order.program != program_fingerprint():
        fault = Phrase("course_other_program").told(order.lang)
        return MadeDocuments({}, dict.fromkeys(order.files, fault))
    made = MadeDocuments()
    desk = Desk(order)
    with _DRAWING_LOCK:
        for name in order.files:
            try:
                made.files[name], made.said[name] = desk.file_contents(name)
            except Exception as error:
                made.faults[name] = missing_document_reason(error, order.lang)
    return made


@dataclass
class Desk:
    """Makes one student's documents; shared parts are made once."""

    order: Order
    sheets: dict[int, Sheet] = field(default_factory=dict)

    @property
    def lang(self) -> Lang:
        """The language of the documents."""
        return self.order.lang

    @cached_property
    def scene(self) -> Scene:
        """The student's scene."""
        return loads(self.order.scene, "scene.yaml")

    @cached_property
    def drawn_position(self) -> Position:
        """The student's position."""
        return note_position(self.scene, None, self.lang)

    def file_contents(self, name: str) -> tuple[bytes, Sentences]:
        """The contents of one file, and the remarks about it."""
        kind, _, suffix = name.partition(".")
        if kind.startswith("sheet-"):
            sheet = self.sheet(int(kind[-1]))
            return sheet.file_contents(f".{suffix}"), sheet.warnings
        return getattr(self, kind)(), ()

    def sheet(self, number: int) -> Sheet:
        """A sheet of the project, composed once for all its formats."""
        if number not in self.sheets:
            asked = number if self.drawn_position.plans.has_mechanism else None  # stated vectors have one sheet
            self.sheets[number] = sheet_of(self.scene, None, self.lang, asked)
        return self.sheets[number]

    def task(self) -> bytes:
        """The sheet of the task, its scheme drawn in another position; one page, if possible."""
        made = []
        for size in SCHEME_SIZES_MM:
            shown = self.scheme_to_show({**PLAN_FIT_MM, "position": size}, size < SCHEME_SIZES_MM[0])
            sheet = task_sheet_blocks(
                self.scene, self.drawn_position, shown, self.order.heads, self.lang, self.order.plans
            )
            made.append(self.pdf_of_blocks(sheet))
            if not self.drawn_position.plans.has_mechanism or len(PdfDocument(made[-1])) == 1:
                return made[-1]
        return made[0]

    @cached_property
    def shown_drive_position(self) -> float:
        """The position of the drive in which the scheme is shown, chosen over all that can be drawn."""
        return clearest_driver_angle(scene_plans(self.scene), self.drawn_position.at)

    def scheme_to_show(self, fits: NumbersByName | None = None, smaller: bool = False) -> Position:
        """The scheme in that position, at the scene's own μ unless it must be ``smaller``."""
        scene = replace(self.scene, mu={**self.scene.mu, "position": None}) if smaller else self.scene
        return solve_position(scene, self.drawn_position.plans, [], self.shown_drive_position, None, self.lang, fits)

    def key(self) -> bytes:
        """The answers as a document."""
        return self.pdf_of_blocks(answer_key_blocks(self.scene, self.drawn_position, self.order.heads, self.lang))

    def pdf_of_blocks(self, blocks: Iterable[Block]) -> bytes:
        """Blocks as a PDF."""
        return render_document(list(blocks), ".pdf", Composer(self.scene, self.lang, self.drawn_position.plans).naming)

    def blank(self) -> bytes:
        """A page for each plan."""
        plans = [p for p in self.drawn_position.plans.plan_names if p.kind in self.order.plans]
        lang = self.lang
        scene, variant, student = self.order.whose
        asked = [(Asked(self.scene, plan), SheetMark(scene, variant, student, plan)) for plan in plans]
        pages = [blank_marks(one, lang, self.order.heads[-1], mark=mark) for one, mark in asked]
        title = pages[0][1] if pages else ""
        reverse = blank_back_marks(self.scene, SHEET_MM, lang)
        sides = [marks for marks, _ in pages for marks in (marks, reverse) if marks]
        return pdf.write_pages([(marks, SHEET_MM) for marks in sides], title, lang)

    def lesson(self) -> bytes:
        """The lesson's page."""
        return whole_lesson_page(lesson_data(self.scene), self.lang).encode()

    def scorm(self) -> bytes:
        """The lesson as a package of a learning platform."""
        assignment, _, student = self.order.whose
        given = question_stem(Pool([self.platform_task], self.lang), "", "")
        scored = whole_lesson_page(lesson_data(self.scene), self.lang, given).encode()
        return scorm_archive(scored, f"{assignment} {student}", self.order.heads[0])

    @cached_property
    def platform_task(self) -> Quiz:
        """The task for platforms, without questions."""
        table = given_data_table(self.scene, self.drawn_position, self.lang, steady=True)
        said = conditions_in_words(self.scene, self.drawn_position, self.lang)
        return Quiz(
            student=str(self.scene.sheet.get("student", "")),
            group=str(self.scene.sheet.get("group", "")),
            assignment=self.order.whose[0],
            title=self.order.heads[0],
            place=self.order.whose[2],
            given=tuple(
                QuizGiven(r.name, float(f"{r.value:.{GIVEN_NUMBER_DIGITS}g}"), r.unit) for r in table.listed_givens()
            ),
            said=BRACKETED_NAME_PATTERN.sub(lambda m: table.naming.lettered_name(m[1]), said),
        )

    def quiz(self) -> bytes:
        """What platforms ask, with the scheme in another position as a picture."""
        asked = quiz_items(self.scene, self.lang, self.order.plans)
        held = replace(self.platform_task, questions=asked, picture=self.question_picture().file_contents(".png"))
        return (json.dumps(held.json(), ensure_ascii=False, indent=1) + "\n").encode()

    def question_picture(self) -> Page:
        """The picture of a question: the scheme in another position; for stated vectors their equations."""
        if not self.drawn_position.plans.has_mechanism:
            return page_of_view(self.scene, "asked", None, self.lang)
        return picture(self.scheme_to_show(), None, self.lang)

    def note(self) -> bytes:
        """The explanatory note."""
        return note_file_contents(self.scene, None, ".pdf", self.lang)
