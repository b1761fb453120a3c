"""The roof over checking: blanks to draw on, reports of checked drawings, a whole class as a table."""

from __future__ import annotations

import json
from collections import Counter
from pathlib import Path
from typing import Any
from urllib.parse import quote

from planes.check import report
from planes.check.bench import Asked, prepare
from planes.check.fiducials import SHEET_MM, SIDE_MM, cells, centres
from planes.check.photograph import blank_pole
from planes.check.polygons import sides_of
from planes.check.tracing_paper import tracing_data
from planes.check.verdict import Outcome
from planes.check.verdict_rows import as_json, mark_rows
from planes.measuring import say_plan
from planes.naming import POLE
from planes.scales import kind_of
from planes.units import mu_text
from planes.wording import PlanesError
from planes.words import Lang, Phrase, say
from render import blank, check_page, check_sheet, class_page, pdf, png, svg, trace_page
from render.names import Naming

TRACE_WORDS = (
    "open", "plan", "by", "layer_plan", "layer_names", "picture", "paper", "zoom", "pole", "turned", "scale", "hint",
    "check", "not_picture",
)  # fmt: skip
PAGE_WORDS = ("own", "next", "truth", "picture", "save", "reset", "moved", "steps", "numbers", "drag", "noscript")


def write_blank(asked: Asked, output: str, lang: Lang) -> None:
    """A sheet to draw a plan on, as PDF, SVG or PNG."""
    marks, title = blank_marks(asked, lang)
    _write(marks, title, output, lang)


def blank_marks(asked: Asked, lang: Lang, *more: str) -> tuple[list[Any], str]:
    """The marks of a sheet to draw a plan on, and its title; ``more`` lines stand beneath it."""
    bench = prepare(asked)
    title = asked.scene.title.get(lang, "") or asked.scene.file
    mu = mu_text(bench.said_mu, kind_of(asked.plan), lang)
    squares = [(z, cells(k), SIDE_MM) for k, z in enumerate(centres(SHEET_MM))]
    mu = mu.replace(".", ",") if lang == "ru" else mu
    texts = [f"{say_plan(asked.plan, lang)}, μ = {mu}", title, *more]
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
    write_text(trace_page.page(tracing_data(asked, lang), words, lang), output)


def write_report(found: Outcome, output: str, lang: Lang) -> None:
    """The report by the file's suffix: a page, a sheet, a picture or the object."""
    suffix = Path(output).suffix.lower()
    if suffix == ".json":
        write_text(json.dumps(as_json(found, lang), ensure_ascii=False, allow_nan=False), output)
    elif suffix in (".html", ".htm"):
        words = {k: say(f"check_page_{k}", lang) for k in PAGE_WORDS}
        write_text(check_page.page(report.page_data(found, lang), words, lang), output)
    elif suffix == ".png" and found.paper.picture and found.paper.box:
        _write_over(found, output, lang)
    else:
        _write(check_sheet.compose(SHEET_MM, _overlay(found, lang)), report.title(found, lang), output, lang)


def _write_over(found: Outcome, output: str, lang: Lang) -> None:
    """The sheet, and under it the picture with both plans upon it."""
    overlay, title = _overlay(found, lang), report.title(found, lang)
    left, low, right, top = found.paper.box or (0.0, 0.0, *SHEET_MM)
    colours = check_sheet.over_picture(overlay, complex(left, low))
    sheet = png.write(check_sheet.compose(SHEET_MM, overlay), SHEET_MM, title)
    layers = {colour: png.write(marks, (right - left, top - low), title) for colour, marks in colours.items() if marks}
    try:
        Path(output).write_bytes(png.stacked(sheet, found.paper.picture, layers))
    except OSError as error:
        raise PlanesError(Phrase("check_no_file", file=output, why=error.strerror or "")) from None


def write_class(group: Any, output: str, lang: Lang) -> None:
    """The drawings of a class as a page; into a folder, with the report of each beside it."""
    target = Path(output)
    if not target.suffix:
        try:
            target.mkdir(parents=True, exist_ok=True)
        except OSError as error:
            raise PlanesError(Phrase("check_no_file", file=output, why=error.strerror or "")) from None
        for one in group.all:
            if one.found:
                one.report = f"{one.file}.html"
                write_report(one.found, str(target / one.report), lang)
        output = str(target / "index.html")
    counts = Counter(one.verdict for one in group.all)
    common = Counter(one.said(lang).partition(": ")[2] for one in group.all if one.found and one.found.mistake)
    told = [(say(f"verdict_{v}", lang), counts[v]) for v in ("right", "wrong", "unreadable")]
    head = [say(k, lang) for k in ("check_file", "check_verdict", "check_mark", "check_first")]
    rows = [(one.verdict, quote(one.report), one.row(lang)) for one in group.all]
    words = {"common": say("check_common", lang)}
    title = f"{say('check_class', lang)}: {group.title}"
    write_text(class_page.page(title, told, common.most_common(5), head, rows, words, lang), output)


def write_text(text: str, output: str) -> None:
    """A file of text, or a sentence why not."""
    try:
        Path(output).write_text(text, encoding="utf-8")
    except OSError as error:
        raise PlanesError(Phrase("check_no_file", file=output, why=error.strerror or "")) from None


def _overlay(found: Outcome, lang: Lang) -> check_sheet.Overlay:
    """What a sheet shows: both plans, the table and the sentence."""
    bench, naming = found.bench, _naming(found, lang)
    kind, own = kind_of(bench.asked.plan), report.own_marks(found)
    at_own, at_true = {POLE: 0j, **own}, {POLE: 0j, **report.true_marks(found)}
    verdicts = {r["mark"]: r["verdict"] for r in mark_rows(found)}
    sides = sides_of(bench.plans, bench.asked.plan) if kind == "force" else []

    def name(label: str) -> str:
        return naming.vector(_upper(label)) if kind == "force" and label != POLE else naming.mark(label, kind)

    head = [say(k, lang) for k in ("check_mark", "check_deviation", "check_tolerance", "check_verdict")]
    first, said = found.first_wrong or "", found.sentence.told(lang)
    ends = [(a, b) for a, b in report.vectors(bench) if a in at_own and b in at_own]
    return check_sheet.Overlay(
        own=[(at_own[a], at_own[b]) for a, b in ends],
        true=[(at_true[a], at_true[b]) for a, b in report.vectors(bench)],
        next=report.leads(found),
        marks={name(n): (z, verdicts.get(n, "right")) for n, z in own.items()},
        along={name(s.name): (at_own[s.start], at_own[s.end]) for s in sides if s.start in at_own and s.end in at_own},
        pole=name(POLE), title=report.title(found, lang), head=head,
        sentence=said.replace(f"{first}:", f"{name(first)}:", 1) if first in at_own else said,
        rows=[[name(label), off, limit, told] for _, label, off, limit, _, told in report.rows_of(found, lang)],
        legend=(say("check_page_own", lang), say("check_page_truth", lang), say("check_page_next", lang)),
        reduced=say("check_reduced", lang, n="{n}"), lines=kind == "position",
    )  # fmt: skip


def _naming(found: Outcome, lang: Lang) -> Naming:
    scene = found.bench.asked.scene
    return Naming(lang, scene.frame_number, scene.sheet.get("reactions") == "from-on")


def _upper(name: str) -> str:
    """F_21t as the vector it is, F_21^t."""
    return f"{name[:-1]}^{name[-1]}" if name.startswith("F_") and name[-1] in "tn" else name
