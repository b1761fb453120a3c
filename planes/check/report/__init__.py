"""What the reports of a checked drawing show, as plain data: rows of tables, what a page shows, its command."""

from __future__ import annotations

import shlex

from planes.check import Outcome
from planes.check.grading.grading import empty
from planes.check.grading.perturbing import HAND
from planes.check.report.moved_marks import moved_marks
from planes.check.report.rows import mark_rows, result_rows
from planes.geometry.arithmetic import Real
from planes.plans.measuring import say_plan
from planes.words import Lang, Phrase, decimal, say
from planes.words.names import kind_of
from planes.words.records import Json
from planes.words.units import mu_text


def title(found: Outcome, lang: Lang) -> str:
    """The plan and the scene."""
    scene = found.bench.asked.scene
    plan = say_plan(found.bench.asked.plan, lang)
    return f"{plan[:1].upper()}{plan[1:]}: {scene.title.get(lang, '') or scene.file}"


def mm(value: float | None, lang: Lang) -> str:
    """Millimetres for a table."""
    return "—" if value is None else decimal(f"{value:.1f}", lang)


def rows_of(found: Outcome, lang: Lang) -> list[list[str]]:
    """Rows of the step table: verdict, mark, off its own construction, tolerance, off the right plan, in words.

    A right mark beside a wrong one does not follow from it: it is told by the right plan.
    """
    rows = []
    for r in mark_rows(found):
        free = r["deviation_mm"], r["tolerance_mm"]
        sizes: tuple[Real, Real] = r.get("own_deviation_mm", free[0]), r.get("own_tolerance_mm", free[1])
        if r["verdict"] == "right" and None not in sizes and sizes[0] > sizes[1]:
            sizes = free
        close = f" ({say('check_close', lang)})" if "warning" in r else ""
        words = say(f"verdict_{r['verdict']}", lang) + close
        rows.append([r["verdict"], r["mark"], *(mm(v, lang) for v in (*sizes, r["deviation_mm"])), words])
    return rows


def numbers_of(found: Outcome, lang: Lang) -> list[list[str]]:
    """Rows of the table of results: verdict, name, written, true, verdict in words with the slip if it is known."""
    rows = []
    for r in result_rows(found):
        told, slip = say(f"verdict_{r['verdict']}", lang), r.get("mistake")
        if slip:
            told += ": " + Phrase(f"mistake_{slip}", mark="").told(lang).removeprefix(": ")
        rows.append([r["verdict"], r["name"], *(decimal(f"{r[k]:.4g}", lang) for k in ("given", "true")), told])
    return rows


def heads(lang: Lang) -> tuple[list[str], list[str]]:
    """Names of the columns of both tables."""
    marks = ("check_mark", "check_off_own", "check_tolerance", "check_off_true", "check_verdict")
    numbers = ("check_result", "check_given", "check_true", "check_verdict")
    return [say(k, lang) for k in marks], [say(k, lang) for k in numbers]


def page_data(found: Outcome, lang: Lang) -> Json:
    """All a page shows and judges by. Without marks there is nothing to move, so no tape."""
    marks, numbers = heads(lang)
    grading = found.grading or (empty(found.bench) if found.paper.picture else None)
    return {
        "verdict": found.verdict,
        "title": title(found, lang),
        "sentence": found.sentence.told(lang),
        "notes": [n.told(lang) for n in found.notes],
        "head": marks,
        "rows": rows_of(found, lang),
        "number_head": numbers,
        "numbers": numbers_of(found, lang),
        "command": command(found),
        **({"page": moved_marks(found, grading, lang)} if grading else {}),
    }


def command(found: Outcome) -> str:
    """The command that checks the table a page saves."""
    asked = found.bench.asked
    words = asked.line("marks.csv")
    words += ["--mu", mu_text(asked.mu, kind_of(asked.plan))] if asked.mu else []
    words += ["--work", "cad"] if asked.skill != HAND else []
    for plan, paper in asked.others.items():
        words += ["--with", f"{plan}={paper.file}"]
    return shlex.join(words)
