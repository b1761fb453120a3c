"""``planes check`` of a folder, or of a file of several pages: every sheet once, a row for each; if only one page holds
the plan, it is checked as a single drawing."""

from __future__ import annotations

import shlex
from argparse import Namespace
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING

from planes.check.handed_in import HandedSheet, read_sheet_marks
from planes.check.outcome import Outcome
from planes.check.outcome import check as judge
from planes.check.report import Checked
from planes.cli.asking import drawing_data_from_options, question_from_options, report_outcome, requested_scale
from planes.cli.options import requested_drive_position
from planes.course.handed_out import HandedOut
from planes.scene import Scene
from planes.words import Phrase, home_lang, say
from planes.words.errors import PlanesError, reporting_library_errors
from planes.words.formats import SUFFIXES_WITH_PICTURE
from planes.words.waiting import progress_bar

if TYPE_CHECKING:
    from planes.check.grading.prepared_plan import Asked
    from planes.documents.class_practices import PracticeSorter
    from planes.documents.class_sorting import Sorter
    from planes.documents.class_work import ClassWork


def check_class(args: Namespace, handed: HandedOut, sheets: list[HandedSheet], alone: bool = False) -> int:
    """Every drawing and practice of a folder: a row for each, on the terminal and in the file of ``-o``; for the pages
    of a single file, ``alone``, the only readable one, if there is one."""
    from planes.documents.class_work import ClassWork

    # a report of one drawing, not of several
    refused = alone and Path(args.output or "").suffix.lower() in SUFFIXES_WITH_PICTURE
    work = ClassWork(Path(args.drawing).name, args.lang, "" if refused else args.output or "")
    work.tasks = handed.tasks
    work.command = _repeating_command(args)
    desk = ClassDesk.from_options(args, handed, work)
    with progress_bar() as step:
        for number, sheet in enumerate(sheets, 1):
            desk.judge_sheet(sheet)
            if step:
                step(number, len(sheets))
    if alone and (only := desk.only_outcome(len(sheets))):
        return report_outcome(args, only)
    work.write_results()
    print(work.json() if args.json else "\n".join(_class_table_lines(work)).lstrip())
    if refused:
        raise PlanesError(Phrase("check_class_output", file=args.output))
    return work.worst_exit_status


@dataclass
class ClassDesk:
    """Checks the sheets of a class, one after another."""

    args: Namespace
    work: ClassWork
    sorter: Sorter
    practices: PracticeSorter
    read: dict[int, Outcome] = field(default_factory=dict)  # pages with the requested plan

    @classmethod
    def from_options(cls, args: Namespace, handed: HandedOut, work: ClassWork) -> ClassDesk:
        """A desk with the options of the command line."""
        from planes.documents.class_practices import PracticeSorter
        from planes.documents.class_sorting import Sorter

        def asking(scene: Scene, plan: str, value: float | None, mu: float | None) -> Asked:
            own = requested_drive_position(args, scene)
            return question_from_options(
                args, scene, plan, value if own is None else own, requested_scale(args, plan) or mu
            )

        practices = PracticeSorter(handed, args.lang, args.variant)
        return cls(args, work, Sorter(handed, asking, args.variant, args.plan), practices)

    def judge_sheet(self, sheet: HandedSheet) -> None:
        """One sheet, or each blank of a picture of several; an error in one never stops the others."""
        from planes.documents.class_sorting import preview_sheet
        from planes.documents.class_work import outcome_inputs_hash

        seen = None
        source = outcome_inputs_hash(sheet, _outcome_options(self.args)) if self.work.ledger else ""
        task = None
        if self.work.reuse_earlier_row(sheet.name, source, self.sorter.handed.tasks):
            return
        if sheet.is_exercise:
            row, task = self.practices.sheet_row(sheet)
            self.work.add_row(row, source, task)
            return
        one = Checked(sheet.name, report=self.work.drawing_link(sheet))
        try:
            with reporting_library_errors("check_broken", sheet.name):
                known = sheet.known_with_page(drawing_data_from_options(self.args))
                one.read_from = str(sheet.file)
                seen = preview_sheet(one.read_from, known.page)
                if seen.blanks < 2:
                    task, asked, one.whose = self.sorter.identify_question(sheet, seen.mark)
                    one.found = judge(asked, read_sheet_marks(sheet, asked, known))
                    if name := self.sorter.actual_owner(task, asked, one.found):
                        one.found.notes.append(Phrase("check_anothers_work", name=name))
        except PlanesError as error:
            one.refused = error
            one.picture = seen.picture if seen else b""
        if seen and seen.blanks > 1:
            for number in range(1, seen.blanks + 1):
                self.judge_sheet(replace(sheet, page=number))
            return
        if one.found and one.found.verdict != "unreadable" and one.found.bench.plan == self.args.plan:
            self.read[sheet.page or 1] = one.found
        self.work.add_checked_drawing(one, source, task)

    def only_outcome(self, count: int) -> Outcome | None:
        """The outcome of the only page with the requested plan; None if there are several, or where all are kept."""
        if len(self.read) != 1 or self.work.ledger or self.work.output.endswith(".csv"):
            return None
        [(page, outcome)] = self.read.items()
        outcome.notes.append(Phrase("check_page_of", page=page, count=count))
        return outcome


def _repeating_command(args: Namespace) -> str:
    """The command that checks the same sheets once more, with all its options: without them all would be judged
    anew."""
    names = ("variant", "phi", "s", "plan", "mu", "pole", "format", "page", "work")
    options = [(f"--{name}", str(text)) for name in names if (text := getattr(args, name)) is not None]
    options += [*(("--with", pair) for pair in args.others), *(("--mark", pair) for pair in args.mark)]
    options += [("--lang", args.lang)] * (args.lang != home_lang()) + [("-o", args.output)] * bool(args.output)
    more = (f"{flag}{'=' if text[:1] == '-' else ' '}{shlex.quote(text)}" for flag, text in options)
    return " ".join([shlex.join(["planes", "check", args.scene, args.drawing]), *more])


def _outcome_options(args: Namespace) -> list[object]:
    """All options that the outcome depends on."""
    others = [Path(pair.partition("=")[2]) for pair in args.others]
    read = [file.read_bytes() for file in others if file.is_file()]
    options = (
        args.variant,
        args.plan,
        args.mu,
        args.phi,
        args.s,
        args.pole,
        args.mark,
        args.format,
        args.work,
        args.lang,
    )
    return [args.page, *options, args.others, read]


def _class_table_lines(work: ClassWork) -> list[str]:
    head, rows = work.table_in_words()
    rows = [head, *rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]) - 1)]
    aligned = ("  ".join([*(c.ljust(w) for c, w in zip(row, widths, strict=False)), row[-1]]) for row in rows)
    table = [say("check_class", work.lang), *(f"  {line.rstrip()}" for line in aligned)]
    return [
        *table,
        *(
            [Phrase("check_missing", names=missing).told(work.lang)]
            if (missing := work.students_without_drawing())
            else []
        ),
    ]
