"""The roof over checking: blanks to draw on, reports of checked drawings, a whole class as a table."""

from __future__ import annotations

import base64
import json
from pathlib import Path
from typing import Any

from planes.check.bench import Asked, Bench, prepare
from planes.check.fiducials import SHEET_MM, SIDE_MM, cells, centres
from planes.check.photograph import blank_pole
from planes.check.polygons import sides_of
from planes.check.verdict import Outcome
from planes.check.verdict_rows import as_json, mark_rows, result_rows
from planes.drafting import POLE, label_of
from planes.measuring import say_plan
from planes.scales import kind_of
from planes.units import mu_text
from planes.wording import PlanesError
from planes.words import Lang, Phrase, say
from render import blank, check_page, check_sheet, pdf, png, svg


def write_blank(asked: Asked, output: str, lang: Lang) -> None:
    """A sheet to draw a plan on, as PDF, SVG or PNG."""
    bench = prepare(asked)
    title = asked.scene.title.get(lang, "") or asked.scene.file
    mu = mu_text(bench.said_mu, kind_of(asked.plan), lang)
    squares = [(z, cells(k), SIDE_MM) for k, z in enumerate(centres(SHEET_MM))]
    texts = [f"{say_plan(asked.plan, lang)}, μ = {mu}", title]
    marks = blank.compose(SHEET_MM, squares, blank_pole(bench), texts)
    _write(marks, title, output, lang)


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


def write_report(found: Outcome, output: str, lang: Lang) -> None:
    """The report by the file's suffix: a page, a sheet, a picture or the object."""
    suffix = Path(output).suffix.lower()
    if suffix in (".html", ".htm", ".json"):
        text = json.dumps(as_json(found, lang), ensure_ascii=False) if suffix == ".json" else _page(found, lang)
        try:
            Path(output).write_text(text, encoding="utf-8")
        except OSError as error:
            raise PlanesError(Phrase("check_no_file", file=output, why=error.strerror or "")) from None
        return
    _write(_sheet(found, lang), _title(found, lang), output, lang)


def _title(found: Outcome, lang: Lang) -> str:
    scene = found.bench.asked.scene
    return f"{say_plan(found.bench.asked.plan, lang)}: {scene.title.get(lang, '') or scene.file}"


def _ends(bench: Bench) -> list[tuple[str, str]]:
    """Vectors of the plan by the labels of their ends."""
    plan = bench.asked.plan
    if kind_of(plan) == "force":
        return [(s.start, s.end) for s in sides_of(bench.plans, plan)]
    drawn = {POLE, *(label_of(m) for m in bench.marks)}
    found = dict.fromkeys((s.start, s.end) for s in bench.plans.segments if s.plan == plan and s.start != s.end)
    return [pair for pair in found if set(pair) <= drawn]


def _marks(found: Outcome) -> dict[str, complex]:
    """The person's own marks, from the pole."""
    if found.grading is None:
        return {}
    plan = found.bench.asked.plan
    return {label_of(m): t.place for m, t in found.grading.hand.taken.items() if m.startswith(plan + ":")}


def _true(found: Outcome) -> dict[str, complex]:
    bench = found.bench
    if found.grading:
        return {label_of(m): complex(found.grading.truth[m]) for m in bench.marks}
    from planes.drawing import run

    truth = run(bench.program, bench.given)
    return {label_of(m): complex(truth[m]) for m in bench.marks}


def _next(found: Outcome) -> list[tuple[complex, complex]]:
    """From where each mark is to where the construction from the person's own marks leads."""
    out = []
    for miss, name in ((m, n) for n, m in (found.grading.judgement.misses if found.grading else {}).items()):
        own = found.grading.hand.taken[name].place if found.grading else 0j
        if abs(miss.off) > 0.5:
            out.append((own, own - miss.off))
    return out


def _sheet(found: Outcome, lang: Lang) -> list[Any]:
    """The overlay as a sheet."""
    own, true, ends = _marks(found), _true(found), _ends(found.bench)
    at_own, at_true = {POLE: 0j, **own}, {POLE: 0j, **true}
    verdicts = {r["mark"]: r["verdict"] for r in mark_rows(found)}
    rows = [[say(k, lang) for k in ("check_mark", "check_deviation", "check_tolerance", "check_verdict")]]
    rows += [r[1:] for r in _rows(found, lang)]
    marks = check_sheet.compose(
        SHEET_MM, blank_pole(found.bench), [(at_own[a], at_own[b]) for a, b in ends if a in at_own and b in at_own],
        [(at_true[a], at_true[b]) for a, b in ends], {n: (z, verdicts.get(n, "right")) for n, z in own.items()},
        _title(found, lang), check_sheet.wrapped(found.sentence.told(lang)), rows[:14],
    )  # fmt: skip
    return [m for m in marks if _inside(m)]


def _inside(mark: Any) -> bool:
    """Whether a mark is on the sheet: a wild vector may not be."""
    places = [getattr(mark, k) for k in ("start", "end", "centre", "place") if hasattr(mark, k)]
    places = places or list(getattr(mark, "points", ()))
    w, h = SHEET_MM
    return all(0 <= z.real <= w and 0 <= z.imag <= h for z in places)


def _rows(found: Outcome, lang: Lang) -> list[list[str]]:
    def mm(value: float | None) -> str:
        return "—" if value is None else f"{value:.1f}"

    rows = mark_rows(found)
    sizes = [(mm(r["deviation_mm"]), mm(r["tolerance_mm"])) for r in rows]
    words = [say(f"verdict_{r['verdict']}", lang) for r in rows]
    return [[r["verdict"], r["mark"], *size, word] for r, size, word in zip(rows, sizes, words, strict=True)]


def _page(found: Outcome, lang: Lang) -> str:
    """The report as a page."""
    own, true, ends = _marks(found), _true(found), _ends(found.bench)
    drawn, right = {POLE: 0j, **own}, {POLE: 0j, **true}
    pole = blank_pole(found.bench)
    data: dict[str, Any] = {
        "verdict": found.verdict, "size": list(SHEET_MM), "pole": _pair(pole),
        "marks": {n: _pair(z) for n, z in own.items()},
        "vectors": [(a, b) for a, b in ends if a in drawn and b in drawn],
        "verdicts": {r["mark"]: r["verdict"] for r in mark_rows(found)},
        "true": [[_pair(right[a]), _pair(right[b])] for a, b in ends],
        "next": [[_pair(a), _pair(b)] for a, b in _next(found)],
        "head": [say(k, lang) for k in ("check_mark", "check_deviation", "check_tolerance", "check_verdict")],
        "rows": _rows(found, lang),
        "number_head": [say(k, lang) for k in ("check_result", "check_given", "check_true", "check_verdict")],
        "numbers": [[r["verdict"], r["name"], f"{r['given']:.4g}", f"{r['true']:.4g}",
                     say(f"verdict_{r['verdict']}", lang)] for r in result_rows(found)],
        "notes": [n.told(lang) for n in found.notes],
    }  # fmt: skip
    if found.paper.picture:
        data["picture"] = "data:image/jpeg;base64," + base64.b64encode(found.paper.picture).decode()
    words = {k: say(f"check_page_{k}", lang) for k in ("own", "next", "true", "picture", "save", "drag")}
    words |= {"title": _title(found, lang), "sentence": found.sentence.told(lang)}
    return check_page.page(data, words, lang)


def _pair(z: complex) -> list[float]:
    return [round(z.real, 3), round(z.imag, 3)]

