"""The drawings of a class: whose each sheet is, and of which plan, by its mark, else by the name of its file, else by
the options given; rows of what was found, as a page with reports beside it, as a spreadsheet or as objects.

Into a folder the rows go with a ledger: what an earlier run has judged is taken up as it was, if neither the drawing,
its corrected marks, its scene nor the program has changed.
"""

import hashlib
import json
from collections import Counter
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from functools import lru_cache
from os.path import relpath
from pathlib import Path
from urllib.parse import quote

from planes.check import STATUS, report
from planes.check.grading.prepared_plan import Asked
from planes.check.handed_in import HandedSheet, opened
from planes.check.report import Checked
from planes.check.report.class_rows import UNSURE, ClassRow, cells, columns
from planes.check.sheet_mark import SheetMark, mark_on
from planes.course.handed_out import HandedOut, Task, plan_named, variant_named
from planes.course.ledger import Ledger, digest, fingerprint
from planes.scene import Scene
from planes.scene.files import keep
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError, shown
from planes.words.records import as_csv
from render.page import check_pages

MOST_COMMON = 8  # mistakes of a class that are listed
INDEX, MOST_BYTES = "index.html", 200


@dataclass
class ClassWork:
    """All drawings of a folder. ``output`` is a file, or a folder that keeps what was found."""

    title: str
    lang: Lang
    output: str = ""
    rows: list[ClassRow] = field(default_factory=list)
    ledger: Ledger | None = None
    wanted: list[str] = field(default_factory=list)

    def __post_init__(self) -> None:
        suffix = Path(self.output).suffix.lower()
        if suffix not in (".html", ".htm", ".csv", ".json", ""):
            raise PlanesError(Phrase("check_class_output", file=self.output))
        if self.output and not suffix:
            self.ledger = Ledger(Path(self.output))

    @property
    def status(self) -> int:
        """The worst exit status of all."""
        return STATUS[max((row.verdict for row in self.rows), key=[*STATUS].index, default="unreadable")]

    def add(self, one: Checked, source: str = "", task: Task | None = None) -> None:
        """A drawing that was looked at; into a folder goes its report, and what the next run takes up."""
        if self.ledger and one.found:
            shown = report.page_data(one.found, self.lang)
            shown["title"] = ". ".join(filter(None, (one.whose, shown["title"])))
            page = check_pages.report_page(shown, self.lang)
            self._keep(f"{kept_as(one.file)}.html", source, page.encode())
            one = replace(one, report=quote(f"{kept_as(one.file)}.html"))
        self.add_row(ClassRow.of(one, self.lang), source, task)

    def add_row(self, row: ClassRow, source: str = "", task: Task | None = None) -> None:
        """A row; into a folder goes what the next run takes up."""
        self.rows.append(row)
        if self.ledger and task:
            kept = {"scene": str(task.file), "sha256": digest(task.file.read_bytes()), "row": asdict(row)}
            data = json.dumps(kept, ensure_ascii=False, allow_nan=False).encode()
            self._keep(f"rows/{kept_as(row.file)}.json", source, data)

    def _keep(self, name: str, source: str, data: bytes) -> None:
        assert self.ledger
        self.ledger.keep(name, source, data)
        self.wanted.append(name)

    def taken_up(self, name: str, source: str, tasks: tuple[Task, ...]) -> bool:
        """Whether an earlier run has judged the very same; then its row stands."""
        files = [f"rows/{kept_as(name)}.json", f"{kept_as(name)}.html"]
        if not self.ledger or not source or not self.ledger.fresh(files[0], source):
            return False
        with suppress(ValueError, TypeError, KeyError):
            kept = json.loads(self.ledger.path(files[0]).read_bytes())
            row = ClassRow.read(kept["row"])
            same = any(str(t.file) == kept["scene"] and digest(t.file.read_bytes()) == kept["sha256"] for t in tasks)
            whole = self.ledger.fresh(files[1], source) or not row.plan
            if same and whole:
                self.rows.append(row)
                self.wanted += files if row.plan else files[:1]
                return True
        return False

    def link(self, sheet: HandedSheet) -> str:
        """The way from the page to the drawing itself, for one without a report."""
        folder = Path(self.output) if self.ledger else Path(self.output).parent
        if not self.output:
            return ""
        try:
            way = Path(relpath(sheet.file, folder)).as_posix()
        except ValueError:  # on another disk
            return sheet.file.resolve().as_uri()
        return quote(way.encode("utf-8", "surrogateescape"))

    def close(self) -> None:
        """Write it all."""
        suffix = Path(self.output).suffix.lower()
        if self.ledger:
            data = self.page().encode()
            self._keep(INDEX, digest(data), data)
            self.ledger.close(self.wanted)
        elif suffix:
            told = {".json": self.json, ".csv": self.csv}.get(suffix, self.page)
            keep(told().encode(), self.output)

    def json(self) -> str:
        """The objects of all drawings."""
        return json.dumps([row.object for row in self.rows], ensure_ascii=False, allow_nan=False)

    def table(self) -> tuple[list[str], list[list[str]]]:
        """The head and the rows in words."""
        keys, names = columns(self.rows, self.lang)
        return names, [cells(row, keys, self.lang) for row in self.rows]

    def csv(self) -> str:
        """The table for a spreadsheet, begun so that it knows the letters."""
        head, rows = self.table()
        return f"\ufeff{as_csv([head, *rows])}"

    def page(self) -> str:
        """The page, what needs a look at the top."""
        counts, common = Counter(row.verdict for row in self.rows), dict[str, list[tuple[str, str]]]()
        ranked = sorted(self.rows, key=lambda row: row.rank)
        for row in self.rows:
            if row.mistake:
                common.setdefault(row.mistake, []).append((Path(row.file).stem, row.link))
        often = sorted(common.items(), key=lambda said: -len(said[1]))[:MOST_COMMON]
        shown = [v for v in reversed(STATUS) if counts[v] or v not in ("confirmed", "right_as_seen")]
        told = [(say(f"verdict_{v}", self.lang), counts[v]) for v in shown]
        told.insert(1, (say("check_unsure_count", self.lang), sum(row.rank == UNSURE for row in self.rows)))
        keys, head = columns(self.rows, self.lang)
        table = [cells(replace(r, said=r.said.removeprefix(f"{r.first}: ")), keys, self.lang) for r in ranked]
        rows = list(zip(ranked, table, strict=True))
        title = f"{say('check_class', self.lang)}: {self.title}"
        return check_pages.class_page(title, told, often, head, rows, self.lang)


def source_of(sheet: HandedSheet, options: object) -> str:
    """The hash of all that what is found in a sheet depends on, but its scene; "" of one that cannot be opened."""
    try:
        hashes = [_hash(file) for file in (sheet.file, sheet.marks) if file.is_file()]
    except OSError:
        return ""
    return digest(repr([hashes, sheet.page, options, fingerprint()]).encode())


def _hash(file: Path) -> str:
    now = file.stat()
    return _hash_of(file, now.st_size, now.st_mtime_ns)


@lru_cache(maxsize=2)
def _hash_of(file: Path, _size: int, _time: int) -> str:
    """The hash of a file, taken once for all of its pages."""
    with file.open("rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()


def kept_as(name: str) -> str:
    """The name under which a drawing is kept: a disk takes no longer ones."""
    return name if len(name.encode()) < MOST_BYTES else f"{name[:60]}-{digest(name.encode())[:8]}"


THUMB_PX = 300
Asking = Callable[[Scene, str, float | None, float | None], Asked]


@dataclass(frozen=True)
class Glance:
    """A first look at a sheet: its mark if it has one, and a small picture of it (JPEG)."""

    mark: SheetMark | None = None
    picture: bytes = b""


def glance(file: str, page: int = 0) -> Glance:
    """The first look; :class:`PlanesError` where a file does not open."""
    picture = opened(file, page)
    if picture is None:
        return Glance()
    from planes.check.vision.picture import cv, smaller

    small = cv().imencode(".jpg", smaller(picture.grey, THUMB_PX)[0])[1]
    return Glance(mark_on(picture.grey), bytes(small))


@dataclass
class Sorter:
    """Says of each sheet what is asked of it. ``variant`` and ``plan`` are of the options, ``asking`` is the rest."""

    handed: HandedOut
    asking: Asking
    variant: str | None = None
    plan: str | None = None
    known: dict[tuple[object, ...], Asked] = field(default_factory=dict)

    def asked(self, sheet: HandedSheet, mark: SheetMark | None) -> tuple[Task, Asked, str]:
        """The task, what is asked, and whose it is in words; :class:`PlanesError` where nothing tells."""
        stem = sheet.file.stem
        task = self._task(sheet, mark)
        variant = mark.variant if mark else variant_named(stem, task.variant(None).variants) or self.variant
        scene = task.variant(variant)
        plan = (mark.plan if mark else plan_named(stem, scene)) or self.plan
        if not plan:
            raise PlanesError(Phrase("check_which_plan", file=sheet.name))
        value, mu = (mark.value, mark.mu) if mark else (None, None)
        key = task, scene.variant, plan, value, mu
        if key not in self.known:
            self.known[key] = self.asking(scene, plan, value, mu)
        return task, self.known[key], whose(scene, mark)

    def _task(self, sheet: HandedSheet, mark: SheetMark | None) -> Task:
        found = self.handed.marked(mark) if mark else self.handed.named(sheet.file.stem)
        if found is None and mark:
            told = {"scene": shown(mark.scene), "student": shown(mark.student)}
            raise PlanesError(Phrase("check_other_mark", file=sheet.name, **told))
        if found is None and len(self.handed.tasks) == 1:
            found = self.handed.tasks[0]
        if found is None:
            raise PlanesError(Phrase("check_whose_is_it", file=sheet.name))
        return found


def whose(scene: Scene, mark: SheetMark | None) -> str:
    """The student and the variant, as far as they are known."""
    student = str(scene.sheet.get("student", "")) or (mark.student if mark else "")
    return ", ".join(filter(None, (student, (mark.variant if mark else "") or scene.variant or "")))
