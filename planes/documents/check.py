"""Documents for checking: blanks to draw on, reports of checked drawings, tracing paper."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

from planes.check import report
from planes.check.blank import blank_pole, plan_fitting_blank
from planes.check.fiducials import (
    CODE_SIDE_MM,
    MARK_SIDE_MM,
    SHEET_MM,
    code_centre,
    corner_mark_cells,
    corner_mark_centres,
)
from planes.check.grading.prepared_plan import Asked, PreparedPlan, prepare
from planes.check.outcome import Outcome
from planes.check.report import as_json, mark_rows
from planes.check.report.shown import shown_plans, tracing_data
from planes.check.sheet_mark import SheetMark
from planes.check.sheet_mark import qr_code_cells as code_cells
from planes.course.papers import given_data_table
from planes.lesson.note import student_and_group
from planes.plans import plans_cut_to_names
from planes.plans.measuring import plan_title, scene_lettering
from planes.scene.files import save_file_or_refuse
from planes.solving import solve_position
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError
from planes.words.formats import DRAWING_SUFFIXES, SUFFIXES_WITH_PICTURE
from planes.words.names import POLE_LABEL, NameTuple, component_ending_at
from planes.words.naming import Naming
from planes.words.units import mu_text
from render.files import Page, pdf
from render.page import check_pages
from render.paper.letters import with_minus_and_decimal_sign
from render.paper.marks import Mark
from render.paper.photo import Photo
from render.sheet import blank_sheet, check_sheet
from render.sheet.studio_code import blank_back_marks


def write_blank(asked: Asked, output: str, lang: Lang) -> None:
    """A sheet to draw a plan on, as PDF, SVG, PNG or DXF."""
    marks, title = blank_marks(asked, lang)
    reverse = blank_back_marks(asked.scene, SHEET_MM, lang)
    if reverse and Path(output).suffix.lower() == ".pdf":
        save_file_or_refuse(pdf.write_pages([(marks, SHEET_MM), (reverse, SHEET_MM)], title, lang), output)
        return
    _write_page(Page(tuple(marks), SHEET_MM, title, lang), output, DRAWING_SUFFIXES)


def blank_marks(asked: Asked, lang: Lang, *more: str, mark: SheetMark | None = None) -> tuple[list[Mark], str]:
    """Marks of a sheet to draw a plan on, and its title; ``more`` lines follow beneath. Its code identifies the
    student, by the names in the scene if ``mark`` does not; an unknown name is written by hand."""
    bench = plan_fitting_blank(prepare(asked))
    asked = bench.asked
    own = mark or SheetMark.from_asked(bench.asked)
    mark = replace(own, mu=own.mu or bench.said_mu, pole=blank_pole(bench))
    title = asked.scene.title.get(lang, "") or asked.scene.file
    mu = with_minus_and_decimal_sign(mu_text(bench.said_mu, bench.kind, lang, asked.scene.mu_convention), lang)
    squares = [(z, corner_mark_cells(k), MARK_SIDE_MM) for k, z in enumerate(corner_mark_centres(SHEET_MM))]
    squares.append((code_centre(), code_cells(mark.printed_text), CODE_SIDE_MM))
    texts = [f"{plan_title(bench.plan, lang)}, μ = {mu}", title, *(more or _owner_lines(asked, mark, lang))]
    fields = [] if mark.student else [say("check_blank_name", lang), say("check_blank_group", lang)]
    pole = (Naming(lang).mark(POLE_LABEL, bench.kind), blank_pole(bench))
    size = say("check_print_size", lang)
    return blank_sheet.blank_sheet_marks(
        SHEET_MM, squares, pole, texts, size, fields, _given_data_lines(bench, lang)
    ), title


def _given_data_lines(bench: PreparedPlan, lang: Lang) -> list[str]:
    """The data of the plan, with numbers that must not be broken across lines."""
    asked = bench.asked
    plans = bench.plans
    cut = plans_cut_to_names(plans, [step.makes for step in plans.program.mark_steps_by_plan[bench.plan]])
    value = plans.drive.position if asked.value is None else asked.value
    at = solve_position(asked.scene, cut, [], value, None, lang)
    given_rows = given_data_table(asked.scene, at, lang).given_rows()
    rows = [f"{name} = {number} {unit}".removesuffix(" —").replace(" °", "°") for name, number, unit in given_rows]
    return [f"{row};" for row in rows[:-1]] + [f"{row}." for row in rows[-1:]]


def _owner_lines(asked: Asked, mark: SheetMark, lang: Lang) -> list[str]:
    """The line beneath the title: the student and the variant, if known."""
    said = []
    if mark.student:
        said.append(student_and_group(mark.student, asked.scene, lang))
    if mark.variant:
        said.append(Phrase("task_variant", variant=mark.variant).told(lang))
    return [f"{'. '.join(said)}."] if said else []


def _write_page(page: Page, output: str, kinds: NameTuple = SUFFIXES_WITH_PICTURE) -> None:
    if Path(output).suffix.lower() not in kinds:
        raise PlanesError(Phrase("check_output", file=output, pictures=SUFFIXES_WITH_PICTURE))
    page.write(output)


def write_trace(asked: Asked, output: str, lang: Lang) -> None:
    """Write the correct plans as a page to lay over a picture."""
    save_file_or_refuse(check_pages.tracing_page(tracing_data(asked, lang), lang).encode(), output)


def write_report(outcome: Outcome, output: str, lang: Lang) -> None:
    """Write the report by the file's suffix: a page, a sheet, a picture or the object."""
    suffix = Path(output).suffix.lower()
    if suffix == ".json":
        save_file_or_refuse(json.dumps(as_json(outcome, lang), ensure_ascii=False, allow_nan=False).encode(), output)
    elif suffix in (".html", ".htm"):
        save_file_or_refuse(check_pages.report_page(report.page_data(outcome, lang), lang).encode(), output)
    else:
        marks, photo = check_sheet.compose_check_sheet(SHEET_MM, _overlay_sheet_contents(outcome, lang))
        _write_page(Page(tuple(marks), SHEET_MM, report.report_title(outcome, lang), lang, under=photo), output)


def _overlay_sheet_contents(outcome: Outcome, lang: Lang) -> check_sheet.Overlay:
    """The contents of a sheet: both plans, the table and the sentence."""
    asked = outcome.bench.asked
    plans = outcome.bench.plans
    kind = outcome.bench.kind
    naming = Naming(lang, **scene_lettering(asked.scene, plans))
    verdicts = {r["mark"]: r["verdict"] for r in mark_rows(outcome)}

    def name(label: str) -> str:
        if kind == "force" and label != POLE_LABEL:
            return naming.lettered_vector(component_ending_at(label))
        return naming.mark(label, kind)

    first = outcome.first_wrong or ""
    said = outcome.sentence.told(lang)
    name_shown = name(first) if first in verdicts else naming.lettered_vector(first)
    shown = shown_plans(outcome)
    photo = Photo(outcome.paper.picture, outcome.paper.box) if outcome.paper.picture and outcome.paper.box else None
    laid = photo is None or max(photo.box[:2]) < -1  # without a known pole it would be in the picture's corner
    return check_sheet.Overlay(
        own=shown.own,
        true=shown.true if laid else [],
        next=shown.next,
        marks={name(n): (z, verdicts.get(n, "right")) for n, z in shown.marks.items()},
        along={name(n): v for n, v in shown.along.items()},
        pole=name(POLE_LABEL),
        title=report.report_title(outcome, lang),
        tables=_report_tables(outcome, name, naming),
        sentence=said.replace(f"{first}:", f"{name_shown}:", 1) if first else said,
        legend=[say(f"check_page_{pen}", lang) for pen in check_sheet.PLAN_LINE_STYLES],
        reduced=say("check_reduced", lang, n="{n}"),
        lines=kind == "position",
        notes=[n.told(lang) for n in outcome.notes],
        photo=photo,
        lang=lang,
    )


def _report_tables(outcome: Outcome, name: Callable[[str], str], naming: Naming) -> list[check_sheet.Table]:
    """The steps, and the results that the student wrote down."""
    lang = naming.lang
    head = [say(k, lang) for k in ("check_mark", "check_deviation", "check_tolerance", "check_verdict")]
    rows = [
        [name(label), off, limit, verdict] for _, label, off, limit, _, verdict in report.mark_table_rows(outcome, lang)
    ]
    numbers = [
        [
            naming.lettered_vector(n),
            with_minus_and_decimal_sign(given, lang),
            with_minus_and_decimal_sign(true, lang),
            verdict.split(":")[0],
        ]
        for _, n, given, true, verdict in report.result_table_rows(outcome, lang)
    ]
    return [(head, rows), (report.table_headings(lang)[1], numbers)]
