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
from planes.course.handed_out import SCENE
from planes.course.ledger import Entry, Ledger, digest, fingerprint
from planes.course.numbers import Question, Settled, question, settle
from planes.course.students import Share, shares
from planes.course.summary import StudentRow, as_blocks, as_csv
from planes.course.workers import Each
from planes.documents.answer_book import together, unasked
from planes.documents.course import Made, Order, due, make, names_of
from planes.lesson.note import student_said
from planes.scene import Scene, loads
from planes.words import Lang, Phrase
from planes.words.names import kind_of
from planes.words.naming import Naming
from render.report import rendered

COPIES = 100  # how often numbers may coincide with somebody else's before they are reported as too few
KEY = "key.json"

Step = Callable[[int, int], None]
SettledShares = dict[Share, Settled]


@dataclass
class Report:
    """The result of a run: files made, files kept, and (place, file, sentence) of failures; ``said``: remarks on
    existing files."""

    made: int = 0
    kept: int = 0
    faults: list[tuple[str, str, str]] = field(default_factory=list)
    said: list[tuple[str, str, str]] = field(default_factory=list)


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
        self.given, self.names = shares(self.course), names_of(self.course)
        self.total = len(self.given) * (len(self.names) + 2)

    def run(self) -> Report:
        """Make everything, and the manifest."""
        self.tell(0)
        settled = self.settle()
        orders = {s: self.order(s, settled[s].scene) for s in self.given if not settled[s].fault}
        self.documents(orders)
        wanted = [self.place(s, n) for s, order in orders.items() for n in (SCENE, KEY, *order.files)]
        self.ledger.close([*wanted, *self.summary(settled), *self.together(list(orders))])
        files = [(s, n) for s, order in orders.items() for n in order.files]
        kept = {(s.place, n): self.ledger.entries.get(self.place(s, n), Entry()) for s, n in files}
        self.report.faults.sort()
        self.report.said = sorted((*where, text) for where, entry in kept.items() for text in entry.said)
        places = [share.place for share in orders]
        self.report.said += [("teacher", "quiz", text) for text in unasked(self.ledger.folder, places, self.lang)]
        return self.report

    def place(self, share: Share, name: str) -> str:
        """A file's name within the folder."""
        return f"{self.names.get(name, 'teacher')}/{share.place}/{name}"

    # numbers

    def settle(self) -> SettledShares:
        """Everybody's numbers, no two of which give the same plans of one assignment, if they are drawn."""
        asked = {s: question(self.course, s, self.lang) for s in self.given}
        settled: SettledShares = {}
        todo = list(self.given)
        for _ in range(COPIES):
            settled |= self.answered({s: asked[s] for s in todo})
            todo = list(alike(self.given, settled, self.course.plans))
            if not todo:
                break
            asked |= {s: replace(asked[s], copy=asked[s].copy + 1) for s in todo}
        settled |= dict.fromkeys(todo, Settled(fault=Phrase("course_too_few").told(self.lang)))
        for share in self.given:
            self.kept_or_written(share, asked[share], settled[share])
        return settled

    def answered(self, asked: dict[Share, Question]) -> SettledShares:
        """Answers read from the folder where they exist, otherwise computed."""
        answers = {s: known for s, q in asked.items() if (known := self.read(s, q))}
        todo = [s for s in asked if s not in answers]
        for k, answer in self.each(settle, [replace(asked[s], program=self.program) for s in todo]):
            answers[todo[k]] = answer
        return answers

    def read(self, share: Share, q: Question) -> Settled | None:
        """Scene and key of an earlier run."""
        scene, key = (self.place(share, name) for name in (SCENE, KEY))
        if not all(self.ledger.fresh(name, made_of(q, "")) for name in (scene, key)):
            return None
        folder = self.ledger.folder
        return Settled((folder / scene).read_text("utf-8"), (folder / key).read_text("utf-8"))

    def kept_or_written(self, share: Share, q: Question, answer: Settled) -> None:
        """The scene and the key in the folder; or the error."""
        if answer.fault:
            self.report.faults.append((share.place, "", answer.fault))
            return
        for name, text in ((SCENE, answer.scene), (KEY, answer.key)):
            self.keep(self.place(share, name), made_of(q, ""), text.encode())

    def keep(self, name: str, source: str, data: bytes, said: tuple[str, ...] = ()) -> None:
        """Write a file, unless it exists."""
        if self.ledger.fresh(name, source):
            self.report.kept += 1
        else:
            self.ledger.keep(name, source, data, said)
            self.report.made += 1
        self.tell(1)

    def tell(self, more: int) -> None:
        """Advance the progress bar."""
        self.done += more
        if self.step:
            self.step(self.done, self.total)

    # documents

    def order(self, share: Share, text: str) -> Order:
        """The order for a student."""
        scene = loads(text, SCENE)
        heads = self.heads(share, scene)
        whose = share.assignment.name, share.variant or "", share.folder
        files = due(self.names, scene)
        self.total -= len(self.names) - len(files)
        return Order(text, heads, files, self.course.plans, self.lang, whose)

    def heads(self, share: Share, scene: Scene) -> tuple[str, ...]:
        """The heads of a task: the scene's title, the course, the student, the variant."""
        who = student_said(share.student.name, scene, self.lang)
        own = Phrase("task_variant", variant=share.variant) if share.variant else Phrase("task_drawn")
        title = scene.title.get(self.lang) or share.assignment.name
        return title, self.course.title.get(self.lang, ""), f"{who.removesuffix('.')}. {own.told(self.lang)}."

    def documents(self, orders: dict[Share, Order]) -> None:
        """Every document that does not exist yet."""
        todo: list[tuple[Share, Order]] = []
        for share, order in orders.items():
            left = tuple(n for n in order.files if not self.ledger.fresh(self.place(share, n), order_of(order, n)))
            kept = len(order.files) - len(left)
            self.report.kept += kept
            self.tell(kept)
            if left:
                todo.append((share, replace(order, files=left, program=self.program)))
        for k, made in self.each(make, [order for _, order in todo]):
            self.written(todo[k][0], orders[todo[k][0]], made)

    def written(self, share: Share, order: Order, made: Made) -> None:
        """One student's documents, written to the folder."""
        for name, data in made.files.items():
            self.keep(self.place(share, name), order_of(order, name), data, made.said.get(name, ()))
        for name, sentence in made.faults.items():
            self.ledger.forget(self.place(share, name))  # an earlier one would have other numbers
            self.report.faults.append((share.place, name, sentence))

    def summary(self, settled: SettledShares) -> list[str]:
        """The teacher's table, as CSV and as a page."""
        rows = [StudentRow.of(s, settled[s].scene, settled[s].key, settled[s].fault) for s in self.given]
        title = self.course.title.get(self.lang, "")
        html = rendered(list(as_blocks(rows, title, self.lang)), ".html", Naming(self.lang))
        return self.kept({"teacher/summary.csv": as_csv(rows, self.lang).encode(), "teacher/summary.html": html})

    def kept(self, files: Mapping[str, bytes]) -> list[str]:
        """Files for the teacher, new ones written; returns their names."""
        for name, data in files.items():
            if not self.ledger.fresh(name, digest(data)):
                self.ledger.keep(name, digest(data), data)
        return list(files)

    def together(self, made: Sequence[Share]) -> list[str]:
        """Documents from everybody's files: the book of answers, the questions of platforms."""
        return self.kept(dict(together(self.course, self.ledger.folder, [s.place for s in made], self.lang)))


def made_of(thing: object, name: str) -> str:
    """The hash of all inputs of a file."""
    return digest(repr((thing, name, fingerprint())).encode())


def order_of(order: Order, name: str) -> str:
    """The hash of all inputs of one document in an order."""
    return made_of(replace(order, files=()), name)


def alike(given: Sequence[Share], settled: SettledShares, plans: Sequence[str]) -> Iterator[Share]:
    """Who drew numbers by which the plans that are asked are as somebody before has them."""
    seen = set()
    for share in sorted(given, key=lambda s: s.variant is None):  # given variants stay as they are
        if (answer := settled[share]).fault:
            continue
        key = json.loads(answer.key)
        drawn = key.get("positions", [key])[0].get("plans", {})
        asked = [drawn[name]["segments"] for name in drawn if kind_of(name) in plans]
        numbers = json.dumps([share.assignment.name, asked or key])
        if numbers in seen and share.variant is None:
            yield share
        seen.add(numbers)


def conduct(
    course: Course, folder: Path, each: Each, lang: Lang, step: Step | None = None, abroad: bool = False
) -> Report:
    """Make the whole course in a folder; ``abroad`` where workers may have their own copy of the program."""
    ledger = Ledger(folder)
    with closing(ledger.journal):
        return Conductor(course, ledger, each, lang, step, fingerprint() if abroad else "").run()
