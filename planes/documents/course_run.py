"""The whole course in one run: numbers drawn, documents made by several workers, each file stored as soon as it exists.

Only this process writes. Files of an earlier run are verified by their hash and kept, if they were made from the same
inputs; so an interrupted run continues where it stopped.
"""

import json
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import closing
from dataclasses import dataclass, field, replace
from pathlib import Path

from planes.course import Course
from planes.course.handed_out import SCENE_FILE_NAME
from planes.course.ledger import Entry, Ledger, Sentences, contents_hash, program_fingerprint
from planes.course.numbers import Question, SettledNumbers, settle_numbers, worker_question
from planes.course.students import Share, shares_of_course
from planes.course.summary import StudentRow, as_blocks, as_csv
from planes.course.workers import Each
from planes.documents.answer_book import common_course_files, omitted_question_notes
from planes.documents.course import MadeDocuments, Order, files_of_scene, folders_by_file_name, make_documents
from planes.lesson.note import student_and_group
from planes.scene import Scene, loads
from planes.words import Lang, Phrase
from planes.words.names import NameTriple, NameTuple, PlanId
from planes.words.naming import Naming
from render.report import render_document

MOST_COINCIDING_DRAWS = 100  # how often numbers may coincide with somebody else's before they are reported as too few
KEY_FILE_NAME = "key.json"

Step = Callable[[int, int], None]
SettledShares = dict[Share, SettledNumbers]


@dataclass
class Report:
    """The result of a run: files made, files kept, and (place, file, sentence) of failures; ``said``: remarks on
    existing files."""

    made: int = 0
    kept: int = 0
    faults: list[NameTriple] = field(default_factory=list)
    said: list[NameTriple] = field(default_factory=list)


@dataclass
class Conductor:
    """One run over one folder. ``program`` is the version that remote workers must have, "" for local ones."""

    course: Course
    ledger: Ledger
    each: Each
    lang: Lang
    step: Step | None = None
    program: str = ""
    report: Report = field(default_factory=Report)
    done: int = 0

    def __post_init__(self) -> None:
        self.given = shares_of_course(self.course)
        self.names = folders_by_file_name(self.course)
        self.total = len(self.given) * (len(self.names) + 2)

    def make_course(self) -> Report:
        """Make everything, and the manifest."""
        self.advance_progress(0)
        settled = self.settle_all_numbers()
        orders = {s: self.student_order(s, settled[s].scene) for s in self.given if not settled[s].fault}
        self.make_missing_documents(orders)
        wanted = [
            self.place_in_folder(s, n)
            for s, order in orders.items()
            for n in (SCENE_FILE_NAME, KEY_FILE_NAME, *order.files)
        ]
        self.ledger.write_manifest(
            wanted + self.write_summary_table(settled) + self.write_common_documents(list(orders))
        )
        files = [(s, n) for s, order in orders.items() for n in order.files]
        kept = {(s.place, n): self.ledger.entries.get(self.place_in_folder(s, n), Entry()) for s, n in files}
        self.report.faults.sort()
        self.report.said = sorted((*where, text) for where, entry in kept.items() for text in entry.said)
        places = [share.place for share in orders]
        self.report.said += [
            ("teacher", "quiz", text) for text in omitted_question_notes(self.ledger.folder, places, self.lang)
        ]
        return self.report

    def place_in_folder(self, share: Share, name: str) -> str:
        """A file's name within the folder."""
        return f"{self.names.get(name, 'teacher')}/{share.place}/{name}"

    # numbers

    def settle_all_numbers(self) -> SettledShares:
        """Everybody's numbers, no two of which give the same plans of one assignment, if they are drawn."""
        asked = {s: worker_question(self.course, s, self.lang) for s in self.given}
        settled: SettledShares = {}
        todo = list(self.given)
        for _ in range(MOST_COINCIDING_DRAWS):
            settled |= self.worker_answers({s: asked[s] for s in todo})
            todo = list(shares_with_same_plans(self.given, settled, self.course.plans))
            if not todo:
                break
            asked |= {s: replace(asked[s], copy=asked[s].copy + 1) for s in todo}
        settled |= dict.fromkeys(todo, SettledNumbers(fault=Phrase("course_too_few").told(self.lang)))
        for share in self.given:
            self.store_settled(share, asked[share], settled[share])
        return settled

    def worker_answers(self, asked: dict[Share, Question]) -> SettledShares:
        """Answers read from the folder where they exist, otherwise computed."""
        answers = {s: known for s, q in asked.items() if (known := self.read_earlier_run(s, q))}
        todo = [s for s in asked if s not in answers]
        for k, answer in self.each(settle_numbers, [replace(asked[s], program=self.program) for s in todo]):
            answers[todo[k]] = answer
        return answers

    def read_earlier_run(self, share: Share, q: Question) -> SettledNumbers | None:
        """Scene and key of an earlier run."""
        scene, key = (self.place_in_folder(share, name) for name in (SCENE_FILE_NAME, KEY_FILE_NAME))
        if not all(self.ledger.is_up_to_date(name, inputs_hash(q, "")) for name in (scene, key)):
            return None
        folder = self.ledger.folder
        return SettledNumbers((folder / scene).read_text("utf-8"), (folder / key).read_text("utf-8"))

    def store_settled(self, share: Share, q: Question, answer: SettledNumbers) -> None:
        """The scene and the key in the folder; or the error."""
        if answer.fault:
            self.report.faults.append((share.place, "", answer.fault))
            return
        for name, text in ((SCENE_FILE_NAME, answer.scene), (KEY_FILE_NAME, answer.key)):
            self.write_unless_present(self.place_in_folder(share, name), inputs_hash(q, ""), text.encode())

    def write_unless_present(self, name: str, source: str, data: bytes, said: Sentences = ()) -> None:
        """Write a file, unless it exists."""
        if self.ledger.is_up_to_date(name, source):
            self.report.kept += 1
        else:
            self.ledger.write_file(name, source, data, said)
            self.report.made += 1
        self.advance_progress(1)

    def advance_progress(self, more: int) -> None:
        """Advance the progress bar."""
        self.done += more
        if self.step:
            self.step(self.done, self.total)

    # documents

    def student_order(self, share: Share, text: str) -> Order:
        """The order for a student."""
        scene = loads(text, SCENE_FILE_NAME)
        heads = self.task_heads(share, scene)
        whose = share.assignment.name, share.variant or "", share.folder
        files = files_of_scene(self.names, scene)
        self.total -= len(self.names) - len(files)
        return Order(text, heads, files, self.course.plans, self.lang, whose)

    def task_heads(self, share: Share, scene: Scene) -> NameTuple:
        """The heads of a task: the scene's title, the course, the student, the variant."""
        who = student_and_group(share.student.name, scene, self.lang)
        own = Phrase("task_variant", variant=share.variant) if share.variant else Phrase("task_drawn")
        title = scene.title.get(self.lang) or share.assignment.name
        return title, self.course.title.get(self.lang, ""), f"{who.removesuffix('.')}. {own.told(self.lang)}."

    def make_missing_documents(self, orders: dict[Share, Order]) -> None:
        """Every document that does not exist yet."""
        todo = []
        for share, order in orders.items():
            left = tuple(
                n
                for n in order.files
                if not self.ledger.is_up_to_date(self.place_in_folder(share, n), document_inputs_hash(order, n))
            )
            kept = len(order.files) - len(left)
            self.report.kept += kept
            self.advance_progress(kept)
            if left:
                todo.append((share, replace(order, files=left, program=self.program)))
        for k, made in self.each(make_documents, [order for _, order in todo]):
            self.write_student_documents(todo[k][0], orders[todo[k][0]], made)

    def write_student_documents(self, share: Share, order: Order, made: MadeDocuments) -> None:
        """One student's documents, written to the folder."""
        for name, data in made.files.items():
            self.write_unless_present(
                self.place_in_folder(share, name), document_inputs_hash(order, name), data, made.said.get(name, ())
            )
        for name, sentence in made.faults.items():
            self.ledger.delete_unchanged_file(
                self.place_in_folder(share, name)
            )  # an earlier one would have other numbers
            self.report.faults.append((share.place, name, sentence))

    def write_summary_table(self, settled: SettledShares) -> list[str]:
        """The teacher's table, as CSV and as a page."""
        rows = [StudentRow.of_share(s, settled[s].scene, settled[s].key, settled[s].fault) for s in self.given]
        title = self.course.title.get(self.lang, "")
        html = render_document(list(as_blocks(rows, title, self.lang)), ".html", Naming(self.lang))
        return self.write_teacher_files(
            {"teacher/summary.csv": as_csv(rows, self.lang).encode(), "teacher/summary.html": html}
        )

    def write_teacher_files(self, files: Mapping[str, bytes]) -> list[str]:
        """Files for the teacher, new ones written; returns their names."""
        for name, data in files.items():
            if not self.ledger.is_up_to_date(name, contents_hash(data)):
                self.ledger.write_file(name, contents_hash(data), data)
        return list(files)

    def write_common_documents(self, made: Sequence[Share]) -> list[str]:
        """Documents from everybody's files: the book of answers, the questions of platforms."""
        return self.write_teacher_files(
            dict(common_course_files(self.course, self.ledger.folder, [s.place for s in made], self.lang))
        )


def inputs_hash(thing: object, name: str) -> str:
    """The hash of all inputs of a file."""
    return contents_hash(repr((thing, name, program_fingerprint())).encode())


def document_inputs_hash(order: Order, name: str) -> str:
    """The hash of all inputs of one document in an order."""
    return inputs_hash(replace(order, files=()), name)


def shares_with_same_plans(given: Sequence[Share], settled: SettledShares, plans: Sequence[str]) -> Iterator[Share]:
    """Who drew numbers by which the plans that are asked are as somebody before has them."""
    seen = set()
    for share in sorted(given, key=lambda s: s.variant is None):  # given variants stay as they are
        if (answer := settled[share]).fault:
            continue
        key = json.loads(answer.key)
        drawn = key.get("positions", [key])[0].get("plans", {})
        asked = [drawn[name]["segments"] for name in drawn if PlanId.read(name).kind in plans]
        numbers = json.dumps([share.assignment.name, asked or key])
        if numbers in seen and share.variant is None:
            yield share
        seen.add(numbers)


def conduct_course(
    course: Course, folder: Path, each: Each, lang: Lang, step: Step | None = None, abroad: bool = False
) -> Report:
    """Make the whole course in a folder; ``abroad`` where workers may have their own copy of the program."""
    ledger = Ledger(folder)
    with closing(ledger.journal):
        return Conductor(course, ledger, each, lang, step, program_fingerprint() if abroad else "").make_course()
