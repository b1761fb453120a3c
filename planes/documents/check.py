"""Documents for checking: blanks to draw on, reports of checked drawings, tracing paper."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from planes.check import report
from planes.check.blank import blank_pole, roomy
from planes.check.fiducials import CODE_MM, SHEET_MM, SIDE_MM, cells, centres, code_centre
from planes.check.grading.prepared_plan import Asked, PreparedPlan, prepare
from planes.check.outcome import Outcome
from planes.check.report import as_json, mark_rows
from planes.check.report.shown import shown_plans, tracing_data
from planes.check.sheet_mark import SheetMark
from planes.check.sheet_mark import cells as code_cells
from planes.course.papers import given_of
from planes.lesson.note import student_said
from planes.plans import sliced
from planes.plans.measuring import lettering, title_of
from planes.scene.files import keep
from planes.solving import position
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.names import POLE, kind_of, parted
from planes.words.naming import Naming
from planes.words.units import mu_text
from render.files import Page, pdf
from render.page import check_pages
from render.paper.letters import decimal
from render.paper.marks import Mark
from render.paper.photo import Photo
from render.sheet import blank_sheet, check_sheet
from render.sheet.studio_code import back

KINDS = (".svg", ".pdf", ".png")


def write_blank(asked: Asked, output: str, lang: Lang) -> None:
    """A sheet to draw a plan on, as PDF, SVG, PNG or DXF."""
    marks, title = blank_marks(asked, lang)
    reverse = back(asked.scene, SHEET_MM, lang)
    if reverse and Path(output).suffix.lower() == ".pdf":
        keep(pdf.write_pages([(marks, SHEET_MM), (reverse, SHEET_MM)], title, lang), output)
        return
    _write(Page(tuple(marks), SHEET_MM, title, lang), output, (*KINDS, ".dxf"))


def blank_marks(asked: Asked, lang: Lang, *more: str, mark: SheetMark | None = None) -> tuple[list[Mark], str]:
    """Marks of a sheet to draw a plan on, and its title; ``more`` lines follow beneath. Its code identifies the
    student, by the names in the scene if ``mark`` does not; an unknown name is written by hand."""
    bench = roomy(prepare(asked))
    asked, own = bench.asked, mark or SheetMark.of(bench.asked)
    mark = replace(own, mu=own.mu or bench.said_mu, pole=blank_pole(bench))
    title = asked.scene.title.get(lang, "") or asked.scene.file
    mu = decimal(mu_text(bench.said_mu, kind_of(asked.plan), lang, asked.scene.mu_convention), lang)
    squares = [(z, cells(k), SIDE_MM) for k, z in enumerate(centres(SHEET_MM))]
    squares.append((code_centre(), code_cells(mark.text), CODE_MM))
    texts = [f"{title_of(asked.plan, lang)}, μ = {mu}", title, *(more or _whose(asked, mark, lang))]
    fields = [] if mark.student else [say("check_blank_name", lang), say("check_blank_group", lang)]
    pole, size = (Naming(lang).mark(POLE, kind_of(asked.plan)), blank_pole(bench)), say("check_print_size", lang)
    return blank_sheet.blank(SHEET_MM, squares, pole, texts, size, fields, _given(bench, lang)), title


def _given(bench: PreparedPlan, lang: Lang) -> list[str]:
    """The data of the plan, with numbers that must not be broken across lines."""
    asked, plans = bench.asked, bench.plans
    cut = sliced(plans, [step.makes for step in plans.program.marks[asked.plan]])
    value = plans.drive.position if asked.value is None else asked.value
    at = position(asked.scene, cut, [], value, None, lang)
    given_rows = given_of(asked.scene, at, lang).rows()
    rows = [f"{name} = {number} {unit}".removesuffix(" —").replace(" °", "°") for name, number, unit in given_rows]
    return [f"{row};" for row in rows[:-1]] + [f"{row}." for row in rows[-1:]]


def _whose(asked: Asked, mark: SheetMark, lang: Lang) -> list[str]:
    """The line beneath the title: the student and the variant, if known."""
    said = []
    if mark.student:
        said.append(student_said(mark.student, asked.scene, lang))
    if mark.variant:
        said.append(Phrase("task_variant", variant=mark.variant).told(lang))
    return [f"{'. '.join(said)}."] if said else []


def _write(page: Page, output: str, kinds: tuple[str, ...] = KINDS) -> None:
    if Path(output).suffix.lower() not in kinds:
        raise PlanesError(Phrase("check_output", file=output))
    page.write(output)


def write_trace(asked: Asked, output: str, lang: Lang) -> None:
    """Write the correct plans as a page to lay over a picture."""
    keep(check_pages.trace_page(tracing_data(asked, lang), lang).encode(), output)


def write_report(outcome: Outcome, output: str, lang: Lang) -> None:
    """Write the report by the file's suffix: a page, a sheet, a picture or the object."""
    suffix = Path(output).suffix.lower()
    if suffix == ".json":
        keep(json.dumps(as_json(outcome, lang), ensure_ascii=False, allow_nan=False).encode(), output)
    elif suffix in (".html", ".htm"):
        keep(check_pages.report_page(report.page_data(outcome, lang), lang).encode(), output)
    else:
        marks, photo = check_sheet.compose(SHEET_MM, _overlay(outcome, lang))
        _write(Page(tuple(marks), SHEET_MM, report.title(outcome, lang), lang, under=photo), output)


def _overlay(outcome: Outcome, lang: Lang) -> check_sheet.Overlay:
    """The contents of a sheet: both plans, the table and the sentence."""
    asked, plans = outcome.bench.asked, outcome.bench.plans
    kind, naming = kind_of(asked.plan), Naming(lang, **lettering(asked.scene, plans))
    verdicts = {r["mark"]: r["verdict"] for r in mark_rows(outcome)}

    def name(label: str) -> str:
        return naming.vector(parted(label)) if kind == "force" and label != POLE else naming.mark(label, kind)

    first, said = outcome.first_wrong or "", outcome.sentence.told(lang)
    name_shown, shown = name(first) if first in verdicts else naming.vector(first), shown_plans(outcome)
    photo = Photo(outcome.paper.picture, outcome.paper.box) if outcome.paper.picture and outcome.paper.box else None
    laid = photo is None or max(photo.box[:2]) < -1  # without a known pole it would be in the picture's corner
    return check_sheet.Overlay(
        own=shown.own,
        true=shown.true if laid else [],
        next=shown.next,
        marks={name(n): (z, verdicts.get(n, "right")) for n, z in shown.marks.items()},
        along={name(n): v for n, v in shown.along.items()},
        pole=name(POLE),
        title=report.title(outcome, lang),
        tables=_tables(outcome, name, naming),
        sentence=said.replace(f"{first}:", f"{name_shown}:", 1) if first else said,
        legend=[say(f"check_page_{pen}", lang) for pen in check_sheet.PENS],
        reduced=say("check_reduced", lang, n="{n}"),
        lines=kind == "position",
        notes=[n.told(lang) for n in outcome.notes],
        photo=photo,
        lang=lang,
    )


def _tables(outcome: Outcome, name: Callable[[str], str], naming: Naming) -> list[check_sheet.Table]:
    """The steps, and the results that the student wrote down."""
    lang = naming.lang
    head = [say(k, lang) for k in ("check_mark", "check_deviation", "check_tolerance", "check_verdict")]
    rows = [[name(label), off, limit, verdict] for _, label, off, limit, _, verdict in report.rows_of(outcome, lang)]
    numbers = [
        [naming.vector(n), decimal(given, lang), decimal(true, lang), verdict.split(":")[0]]
        for _, n, given, true, verdict in report.numbers_of(outcome, lang)
    ]
    return [(head, rows), (report.heads(lang)[1], numbers)]
