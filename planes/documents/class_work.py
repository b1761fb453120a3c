"""The drawings of a class: rows of outcomes, as a page with reports, as a spreadsheet or as objects; duplicate plans,
and missing students.

In a folder the rows have a ledger: an earlier judgement is reused if the drawing, its corrected marks, its scene and
the program are unchanged.
"""

import hashlib
import json
from collections import Counter, defaultdict
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import asdict, dataclass, field, replace
from functools import lru_cache
from os.path import relpath
from pathlib import Path
from urllib.parse import quote

from planes.check import report
from planes.check.handed_in import HandedSheet
from planes.check.outcome import EXIT_STATUS_OF_VERDICT
from planes.check.report import Checked
from planes.check.report.class_rows import UNSURE_RANK, ClassRow, cells_as_typed, row_cells, table_columns
from planes.course.handed_out import Task, are_of_several_assignments
from planes.course.ledger import Ledger, contents_hash, program_fingerprint
from planes.scene.files import save_file_or_refuse
from planes.words import Lang, Phrase, join_sentences, say
from planes.words.errors import PlanesError
from planes.words.records import csv_text
from render.page import check_pages

MOST_LISTED_MISTAKES = 8  # mistakes of a class that are listed
INDEX_FILE_NAME = "index.html"
MOST_FILE_NAME_BYTES = 200


@dataclass
class ClassWork:
    """All drawings of a folder. ``output`` is a file, or a folder that keeps the outcomes."""

    title: str
    lang: Lang
    output: str = ""
    rows: list[ClassRow] = field(default_factory=list)
    ledger: Ledger | None = None
    wanted: list[str] = field(default_factory=list)
    tasks: tuple[Task, ...] = ()  # all scenes handed out
    command: str = ""  # that checks them all once more

    def __post_init__(self) -> None:
        suffix = Path(self.output).suffix.lower()
        if suffix not in (".html", ".htm", ".csv", ".json", ""):
            raise PlanesError(Phrase("check_class_output", file=self.output))
        if self.output and not suffix:
            self.ledger = Ledger(Path(self.output))

    @property
    def worst_exit_status(self) -> int:
        """The worst exit status of all."""
        return EXIT_STATUS_OF_VERDICT[
            max((row.verdict for row in self.rows), key=[*EXIT_STATUS_OF_VERDICT].index, default="unreadable")
        ]

    def add_checked_drawing(self, one: Checked, source: str = "", task: Task | None = None) -> None:
        """Add a checked drawing; in a folder with its report, and the data for the next run."""
        name = f"{stored_drawing_name(one.file)}.html"
        one = replace(one, report=quote(name)) if self.ledger and one.found else one
        row = ClassRow.from_checked(one, self.lang)
        if self.ledger and one.found:
            shown = report.page_data(one.found, self.lang, row.places)
            shown["title"] = join_sentences([one.whose, shown["title"]])
            page = check_pages.report_page({**shown, "of_class": one.file, "command": self.command}, self.lang)
            self._store_file(name, source, page.encode())
        self.add_row(row, source, task)

    def add_row(self, row: ClassRow, source: str = "", task: Task | None = None) -> None:
        """Add a row; in a folder with the data for the next run."""
        row = replace(row, task=str(task.file)) if task else row
        self.rows.append(row)
        if self.ledger and task:
            kept = {"scene": str(task.file), "sha256": contents_hash(task.file.read_bytes()), "row": asdict(row)}
            data = json.dumps(kept, ensure_ascii=False, allow_nan=False).encode()
            self._store_file(f"rows/{stored_drawing_name(row.file)}.json", source, data)

    def _store_file(self, name: str, source: str, data: bytes) -> None:
        assert self.ledger
        self.ledger.write_file(name, source, data)
        self.wanted.append(name)

    def reuse_earlier_row(self, name: str, source: str, tasks: tuple[Task, ...]) -> bool:
        """Whether an earlier run judged exactly the same input; then its row is reused."""
        files = [f"rows/{stored_drawing_name(name)}.json", f"{stored_drawing_name(name)}.html"]
        if not self.ledger or not source or not self.ledger.is_up_to_date(files[0], source):
            return False
        with suppress(ValueError, TypeError, KeyError):
            kept = json.loads(self.ledger.checked_path(files[0]).read_bytes())
            row = ClassRow.from_saved(kept["row"])
            same = any(
                str(t.file) == kept["scene"] and contents_hash(t.file.read_bytes()) == kept["sha256"] for t in tasks
            )
            if same and (self.ledger.is_up_to_date(files[1], source) or not row.plan):
                self.rows.append(row)
                self.wanted += files if row.plan else files[:1]
                return True
        return False

    def drawing_link(self, sheet: HandedSheet) -> str:
        """The path from the page to the drawing itself, for one without a report."""
        folder = Path(self.output) if self.ledger else Path(self.output).parent
        if not self.output:
            return ""
        try:
            way = Path(relpath(sheet.file, folder)).as_posix()
        except ValueError:  # on another disk
            return sheet.file.resolve().as_uri()
        return quote(way.encode("utf-8", "surrogateescape"))

    def write_results(self) -> None:
        """Write everything."""
        suffix = Path(self.output).suffix.lower()
        if self.ledger:
            data = self.page_html().encode()
            self._store_file(INDEX_FILE_NAME, contents_hash(data), data)
            self.ledger.write_manifest(self.wanted)
        elif suffix:
            writer = {".json": self.json, ".csv": self.table_as_csv}.get(suffix, self.page_html)
            save_file_or_refuse(writer().encode(), self.output)

    def json(self) -> str:
        """The objects of all drawings."""
        return json.dumps([row.object for row in self.rows], ensure_ascii=False, allow_nan=False)

    def table_in_words(self) -> tuple[list[str], list[list[str]]]:
        """The head and the rows in words."""
        keys, names = table_columns(self.rows, self.lang)
        rows = zip(self.rows, self._row_cells(self.rows, keys), strict=True)
        return names, [cells_as_typed(row, cells, self.lang) for row, cells in rows]

    def _row_cells(self, rows: Sequence[ClassRow], keys: Sequence[str]) -> list[list[str]]:
        """The cells of rows; beside an outcome a note if the same person handed in the same plan twice."""
        again = {
            f: Phrase("check_again", names=", ".join(more)).told(self.lang)
            for f, more in self._duplicate_drawings().items()
        }
        return [row_cells(row.with_text(again.get(row.file, "")), keys, self.lang) for row in rows]

    def _duplicate_drawings(self) -> dict[str, list[str]]:
        """By file the other drawings of the same plan by the same student."""
        own = {str(t.file) for t in self.tasks if t.student}
        same = defaultdict(list)
        for row in self.rows:
            if row.plan and row.task in own:
                same[row.plan_task_and_student].append(row.file)
        return {f: [one for one in files if one != f] for files in same.values() if len(files) > 1 for f in files}

    def students_without_drawing(self) -> str:
        """The students without any drawing, with the assignments where there are several."""
        came = {row.task for row in self.rows}
        several = are_of_several_assignments(self.tasks)
        names = defaultdict(list)
        for task in self.tasks:
            if task.student and str(task.file) not in came:
                name = str(task.scene_in_variant(None).sheet.get("student") or task.student.replace("-", " "))
                names[name].append(task.scene)
        every = (f"{name} ({', '.join(scenes)})" if several else name for name, scenes in names.items())
        return ", ".join(every).removesuffix(".")  # the sentence ends with its own

    def table_as_csv(self) -> str:
        """The table for a spreadsheet."""
        head, rows = self.table_in_words()
        return csv_text([head, *rows])

    def page_html(self) -> str:
        """The page, with doubtful drawings at the top."""
        counts = Counter(row.verdict for row in self.rows)
        ranked = sorted(self.rows, key=lambda row: row.rank)
        shown = [v for v in reversed(EXIT_STATUS_OF_VERDICT) if counts[v] or v not in ("confirmed", "right_as_seen")]
        verdict_counts = [(say(f"verdict_{v}", self.lang), counts[v]) for v in shown]
        verdict_counts.append((say("check_unsure_count", self.lang), sum(row.rank == UNSURE_RANK for row in self.rows)))
        keys, head = table_columns(self.rows, self.lang)
        table = self._row_cells([replace(r, said=r.said.removeprefix(f"{r.first}: ")) for r in ranked], keys)
        rows = list(zip(ranked, table, strict=True))
        title = f"{say('check_class', self.lang)}: {self.title}"
        missing = self.students_without_drawing()
        absent = Phrase("check_missing", names=missing).told(self.lang) if missing else ""
        return check_pages.class_page(title, verdict_counts, self._common_mistakes(), absent, head, rows, self.lang)

    def _common_mistakes(self) -> list[tuple[str, list[tuple[str, str]]]]:
        """Mistakes in more than one drawing (a duplicate counts once), with the students and their reports."""
        common = dict[str, dict[object, tuple[str, str]]]()
        again = self._duplicate_drawings()
        for row in self.rows:
            if row.mistake:
                one = row.plan_task_and_student if row.file in again else row.file
                common.setdefault(row.mistake, {}).setdefault(one, (row.whose or Path(row.file).stem, row.link))
        several = [(said, [*whose.values()]) for said, whose in common.items() if len(whose) > 1]
        return sorted(several, key=lambda said: -len(said[1]))[:MOST_LISTED_MISTAKES]


def outcome_inputs_hash(sheet: HandedSheet, options: object) -> str:
    """The hash of all inputs of a sheet's outcome except its scene; "" for a sheet that cannot be opened."""
    try:
        hashes = [_file_hash(file) for file in (sheet.file, sheet.corrected_marks_file) if file.is_file()]
    except OSError:
        return ""
    return contents_hash(repr([hashes, sheet.page, options, program_fingerprint()]).encode())


def _file_hash(file: Path) -> str:
    now = file.stat()
    return _cached_file_hash(file, now.st_size, now.st_mtime_ns)


@lru_cache(maxsize=2)
def _cached_file_hash(file: Path, _size: int, _time: int) -> str:
    """The hash of a file, computed once for all of its pages."""
    with file.open("rb") as opened:
        return hashlib.file_digest(opened, "sha256").hexdigest()


def stored_drawing_name(name: str) -> str:
    """The stored name of a drawing: file systems limit its length."""
    if len(name.encode()) < MOST_FILE_NAME_BYTES:
        return name
    return f"{name[:60]}-{contents_hash(name.encode())[:8]}"
