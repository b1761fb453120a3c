"""The roof over checking: blanks to draw on, reports of checked drawings, a whole class as a table."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

from planes.check import report
from planes.check.bench import Asked, prepare
from planes.check.fiducials import SHEET_MM, SIDE_MM, cells, centres
from planes.check.photograph import blank_pole
from planes.check.tracing_paper import tracing_data
from planes.check.verdict import Outcome
from planes.check.verdict_rows import as_json, mark_rows
from planes.measuring import say_plan
from planes.naming import POLE
from planes.scales import kind_of
from planes.units import mu_text
from planes.wording import PlanesError
from planes.words import Lang, Phrase, say
from render import blank, check_page, check_sheet, pdf, png, svg, trace_page

TRACE_WORDS = (
    "open", "plan", "by", "layer_plan", "layer_names", "picture", "paper", "zoom", "pole", "turned", "scale", "hint",
    "check", "not_picture",
)  # fmt: skip
PAGE_WORDS = ("own", "next", "truth", "picture", "save", "reset", "moved", "steps", "numbers", "drag", "noscript")


def write_blank(asked: Asked, output: str, lang: Lang) -> None:
    """A sheet to draw a plan on, as PDF, SVG or PNG."""
    marks, title = blank_marks(asked, lang)
    _write(marks, title, output, lang)


def blank_marks(asked: Asked, lang: Lang) -> tuple[list[Any], str]:
    """The marks of a sheet to draw a plan on, and its title."""
    bench = prepare(asked)
    title = asked.scene.title.get(lang, "") or asked.scene.file
    mu = mu_text(bench.said_mu, kind_of(asked.plan), lang)
    squares = [(z, cells(k), SIDE_MM) for k, z in enumerate(centres(SHEET_MM))]
    texts = [f"{say_plan(asked.plan, lang)}, μ = {mu}", title]
    return blank.compose(SHEET_MM, squares, blank_pole(bench), texts), title


def _write(marks: list[Any], title: str, output: str, lang: Lang) -> None:
    suffix = Path(output).suffix.lower()
    writers = {".svg": svg.write, ".pdf": pdf.write}
    try:
        if suffix in writers:
            writers[suffix](marks, SHEET_MM, title, output, lang=lang)
        elif suffix == ".png":
            png.write(marks, SHEET_MM, title, output)
        else:
            raise PlanesError(Phrase("check_output", file=output))
    except OSError as error:
        raise PlanesError(Phrase("check_no_file", file=output, why=error.strerror or str(error))) from None


def write_trace(asked: Asked, output: str, lang: Lang) -> None:
    """The right plans as a page to lay over a picture."""
    words = {k: say(f"trace_{k}", lang) for k in TRACE_WORDS}
    _write_text(trace_page.page(tracing_data(asked, lang), words, lang), output)


def write_report(found: Outcome, output: str, lang: Lang) -> None:
    """The report by the file's suffix: a page, a sheet, a picture or the object."""
    suffix = Path(output).suffix.lower()
    if suffix == ".json":
        _write_text(json.dumps(as_json(found, lang), ensure_ascii=False, allow_nan=False), output)
    elif suffix in (".html", ".htm"):
        words = {k: say(f"check_page_{k}", lang) for k in PAGE_WORDS}
        _write_text(check_page.page(report.page_data(found, lang), words, lang), output)
    else:
        _write(_sheet(found, lang), report.title(found, lang), output, lang)


def _write_text(text: str, output: str) -> None:
    try:
        Path(output).write_text(text, encoding="utf-8")
    except OSError as error:
        raise PlanesError(Phrase("check_no_file", file=output, why=error.strerror or "")) from None


def _sheet(found: Outcome, lang: Lang) -> list[Any]:
    """The overlay as a sheet."""
    own, true, ends = report.own_marks(found), report.true_marks(found), report.vectors(found.bench)
    at_own, at_true = {POLE: 0j, **own}, {POLE: 0j, **true}
    verdicts = {r["mark"]: r["verdict"] for r in mark_rows(found)}
    rows = [[say(k, lang) for k in ("check_mark", "check_deviation", "check_tolerance", "check_verdict")]]
    rows += [[name, own, limit, told] for _, name, own, limit, _, told in report.rows_of(found, lang)]
    marks = check_sheet.compose(
        SHEET_MM, blank_pole(found.bench), [(at_own[a], at_own[b]) for a, b in ends if a in at_own and b in at_own],
        [(at_true[a], at_true[b]) for a, b in ends], {n: (z, verdicts.get(n, "right")) for n, z in own.items()},
        report.title(found, lang), check_sheet.wrapped(found.sentence.told(lang)), rows[:14],
    )  # fmt: skip
    return [m for m in marks if _inside(m)]


def _inside(mark: Any) -> bool:
    """Whether a mark is on the sheet: a wild vector may not be."""
    places = [getattr(mark, k) for k in ("start", "end", "centre", "place") if hasattr(mark, k)]
    places = places or list(getattr(mark, "points", ()))
    w, h = SHEET_MM
    return all(0 <= z.real <= w and 0 <= z.imag <= h for z in places)
