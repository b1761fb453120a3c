"""``planes check`` and ``planes blank``: what is read by the suffix of a file, checked and printed; a folder too."""

from __future__ import annotations

import json
import re
from argparse import Namespace
from contextlib import suppress
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from planes.check import STATUS, Outcome
from planes.check import check as judge
from planes.check.grading.paper import Known
from planes.check.grading.perturbing import HAND, cad
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.handed_in import LINES, PICTURES, PRACTICE, HandedSheet, marks_of, read_paper, sheets_in
from planes.check.report import Checked, as_json, chance_told, heads, numbers_of, rows_of
from planes.cli.commands import scene_of
from planes.cli.options import check_options, value_of
from planes.course.handed_out import HandedOut, handed_out, is_course
from planes.course.ledger import MANIFEST
from planes.scene import Scene
from planes.solving.text_tables import table
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError, guarded
from planes.words.names import kind_of
from planes.words.units import read_mu

if TYPE_CHECKING:
    from planes.documents.class_practices import PracticeSorter
    from planes.documents.class_work import ClassWork, Sorter

_PLACE = re.compile(r"\s*(?:([^=]+)=)?\s*([-+]?{0})\s*[,;]\s*([-+]?{0})\s*".format(r"(?:\d+\.?\d*|\.\d+)"))


def check(args: Namespace) -> int:
    """Check, print, and give the exit status: 0 right, 1 wrong, 2 unreadable, 3 right as far as seen."""
    if is_course(Path(args.scene)) and not args.trace:
        return check_class(args, handed_out(Path(args.scene)), _sheets(args))
    if args.plan is None and (args.trace or not _told_by_itself(args.drawing)):
        args.refuse(say("usage_missing", args.lang) % "--plan")
    scene = scene_of(args)
    value = value_of(args, scene)
    check_options(args, "check", _answer(args))
    if args.drawing and not args.trace:
        sheets = _sheets(args)
        if args.plan is None or Path(args.drawing).is_dir() or sheets[0].practised:
            return check_class(args, handed_out(Path(args.scene)), sheets)
    asked = ask(args, scene, args.plan, value, _mu(args, args.plan))
    if args.trace:
        return _trace(args, asked)
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    if len(sheets) > 1:
        only = _only_page(args, asked, sheets)
        return _said(args, only) if only else check_class(args, handed_out(Path(args.scene)), sheets)
    return _said(args, judge(asked, read_paper(args.drawing, asked, known_of(args))))


def _sheets(args: Namespace) -> list[HandedSheet]:
    """The sheets that were handed in."""
    if args.drawing is None:
        raise PlanesError(Phrase("check_no_drawing"))
    return sheets_in(Path(args.drawing), args.page is not None, MANIFEST)


def _only_page(args: Namespace, asked: Asked, sheets: list[HandedSheet]) -> Outcome | None:
    """What is found on the only page of a file that can be read as the plan, if there is just one."""
    read: list[tuple[int | None, Outcome]] = []
    for sheet in sheets:
        with suppress(PlanesError):
            found = judge(asked, read_paper(args.drawing, asked, sheet.known(known_of(args))))
            read += [(sheet.page, found)] if found.verdict != "unreadable" else []
        if len(read) > 1:
            return None
    for page, found in read:
        found.notes.append(Phrase("check_page_of", page=page, count=len(sheets)))
    return read[0][1] if read else None


def _said(args: Namespace, found: Outcome) -> int:
    """The report written, the outcome printed."""
    if args.output:
        from planes.documents.check import write_report

        write_report(found, args.output, args.lang)
    if args.json:
        print(json.dumps(as_json(found, args.lang), ensure_ascii=False, allow_nan=False))
    else:
        print(told(found, args.lang))
    return STATUS[found.verdict]


def _answer(args: Namespace) -> str:
    """Which of the answers is asked for, by what has to be read."""
    files = [Path(args.drawing or ""), *(Path(pair.partition("=")[2]) for pair in args.others)]
    suffixes = {file.suffix.lower() for file in files}
    if args.trace:
        return "trace"
    if (args.drawing and files[0].is_dir()) or suffixes & {*PICTURES}:
        return "photograph"
    return "lines" if suffixes & {*LINES} else "numbers"


def _trace(args: Namespace, asked: Asked) -> int:
    """The tracing-paper page."""
    from planes.documents.check import write_trace

    if args.drawing or not args.output or Path(args.output).suffix.lower() not in (".html", ".htm"):
        raise PlanesError(Phrase("check_trace"))
    write_trace(asked, args.output, args.lang)
    return 0


def ask(args: Namespace, scene: Scene, plan: str, value: float | None, mu: float | None) -> Asked:
    """The question of the command line."""
    from planes.documents.check import spelling

    asked = Asked(scene, plan, value, mu, spelt=spelling(scene, args.lang))
    others = {}
    for pair in args.others:
        name, _, file = pair.partition("=")
        if not file:
            raise PlanesError(Phrase("check_option", option="--with", text=pair, form="velocity=FILE", hint=""))
        others[name] = read_paper(file, replace(asked, plan=name, mu=None), replace(known_of(args), page=None))
    skill = HAND
    if args.work == "cad":
        from planes.drafting.drawing import run
        from planes.plans.scales import extent

        bench = prepare(asked)
        skill = cad(max(extent(run(bench.program, bench.given), asked.plan), 10.0))
    return replace(asked, skill=skill, others=others)


def _mu(args: Namespace, plan: str) -> float | None:
    return None if args.mu is None else read_mu(args.mu, kind_of(plan))


def known_of(args: Namespace) -> Known:
    """What the command line tells of the drawing."""
    pole = place(args.pole, "--pole")[1] if args.pole else None
    page = None if args.page is None else args.page - 1
    return Known(pole, dict(place(m, "--mark") for m in args.mark), args.format, page)


def place(text: str, option: str) -> tuple[str, complex]:
    """NAME=X,Y or X,Y of the command line."""
    match = _PLACE.fullmatch(text)
    if not match:
        hint = Phrase("decimal_no_comma") if text.count(",") > 1 else ""
        raise PlanesError(Phrase("check_option", option=option, text=text, form="X,Y", hint=hint))
    return (match[1] or "").strip(), complex(float(match[2]), float(match[3]))


def told(found: Outcome, lang: Lang) -> str:
    """The outcome for people: the sentence, then the tables."""
    lines = [" ".join(filter(None, (found.sentence.told(lang), chance_told(found, lang))))]
    marks, numbers = heads(lang)
    lines += table(say("check_marks", lang), marks, [row for _, *row in rows_of(found, lang)])
    lines += table(say("check_numbers", lang), numbers, [row for _, *row in numbers_of(found, lang)])
    return "\n".join(lines + [f"! {n.told(lang)}" for n in found.notes])


def blank(args: Namespace) -> int:
    """``planes blank``: a sheet to draw a plan on."""
    from planes.documents.check import write_blank

    scene = scene_of(args)
    write_blank(Asked(scene, args.plan, value_of(args, scene), _mu(args, args.plan)), args.output, args.lang)
    return 0


def _told_by_itself(drawing: str | None) -> bool:
    """Whether what was handed in may tell the plan: by the marks of sheets, or a practice by its code."""
    return bool(drawing) and (Path(str(drawing)).is_dir() or str(drawing).lower().endswith((*PICTURES, PRACTICE)))


def check_class(args: Namespace, handed: HandedOut, sheets: list[HandedSheet]) -> int:
    """Every drawing and practice of a folder: a row for each, on the terminal and in the file of ``-o``."""
    from planes.documents.class_practices import PracticeSorter
    from planes.documents.class_work import ClassWork, Sorter
    from planes.words.waiting import bar

    def asking(scene: Scene, plan: str, value: float | None, mu: float | None) -> Asked:
        own = value_of(args, scene)
        return ask(args, scene, plan, value if own is None else own, _mu(args, plan) or mu)

    work = ClassWork(Path(args.drawing).name, args.lang, args.output or "")
    sorter = Sorter(handed, asking, args.variant, args.plan)
    practices = PracticeSorter(handed, args.lang, args.variant)
    with bar() as step:
        for number, sheet in enumerate(sheets, 1):
            _look(args, work, sorter, practices, sheet)
            if step:
                step(number, len(sheets))
    work.close()
    print(work.json() if args.json else "\n".join(_class_table(work)).lstrip())
    return work.status


def _look(args: Namespace, work: ClassWork, sorter: Sorter, practices: PracticeSorter, sheet: HandedSheet) -> None:
    """One sheet of a class; whatever is wrong with it never stops the others."""
    from planes.documents.class_work import glance, source_of

    seen, source, task = None, source_of(sheet, _options(args)), None
    if work.taken_up(sheet.name, source, sorter.handed.tasks):
        return
    if sheet.practised:
        row, task = practices.row(sheet)
        work.add_row(row, source, task)
        return
    one = Checked(sheet.name, report=work.link(sheet))
    try:
        with guarded("check_broken", sheet.name):
            known, one.read_from = sheet.known(known_of(args)), str(sheet.file)
            seen = glance(one.read_from, known.page or 0)
            task, asked, one.whose = sorter.asked(sheet, seen.mark)
            one.found = judge(asked, marks_of(sheet, asked, known))
    except PlanesError as error:
        one.refused, one.picture = error, seen.picture if seen else b""
    work.add(one, source, task)


def _options(args: Namespace) -> list[object]:
    """All of the command line that what is found depends on."""
    others = [Path(pair.partition("=")[2]) for pair in args.others]
    read = [file.read_bytes() for file in others if file.is_file()]
    told = (args.variant, args.plan, args.mu, args.phi, args.s, args.pole, args.mark, args.format, args.work, args.lang)
    return [args.page, *told, args.others, read]


def _class_table(work: ClassWork) -> list[str]:
    head, rows = work.table()
    rows = [head, *rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(rows[0]) - 1)]
    aligned = ("  ".join([*(c.ljust(w) for c, w in zip(row, widths, strict=False)), row[-1]]) for row in rows)
    return [say("check_class", work.lang), *(f"  {line.rstrip()}" for line in aligned)]
