"""The reports of a checked drawing, or of a class, as plain data: for programs, rows, pages."""

import math
import shlex
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import PurePath

from planes.check.grading.evidence import LEAST_VERDICT_PROBABILITY, SURE_VERDICT_PROBABILITY
from planes.check.grading.grading import grading_without_marks
from planes.check.grading.judging import WARNING_SIGMAS
from planes.check.grading.remedies import Reader, phrase_for_reader
from planes.check.grading.written_numbers import Scored
from planes.check.outcome import Outcome
from planes.check.report.moved_marks import moved_marks_data
from planes.check.report.places import wrong_places
from planes.check.report.shown import shown_plans
from planes.drafting.skill import STUDENT_SKILL
from planes.geometry.arithmetic import Real
from planes.plans.measuring import plan_title, scene_lettering
from planes.words import Lang, Phrase, available_languages, join_sentences, say, with_decimal_sign
from planes.words.errors import PlanesError
from planes.words.records import Json
from planes.words.units import mu_text, number_text

MARK_SIZE_KEYS = ("read_mm", "read_error_mm", "deviation_mm", "tolerance_mm")


def mark_rows(out: Outcome) -> list[Json]:
    """The marks of the JSON (or the segments of a table of segments)."""
    g = out.grading
    if g is None:
        return [_segment_row(s) for s in (out.segments.scored if out.segments else [])]
    rows = []
    unseen = [] if out.wrong else out.unseen
    for mark, verdict in g.verdicts.items():
        own = g.hand.taken.get(mark)
        miss = g.judgement.miss_for_verdict(mark, verdict)
        label = mark.label
        row: Json = {"mark": label, **dict.fromkeys(MARK_SIZE_KEYS), "verdict": verdict}
        absent = g.rebuilt is not None and label in g.rebuilt.absent
        if label in unseen or (absent and (verdict == "right" or not (own and miss))):
            row["verdict"] = "unread"
        if own and miss and not (absent and row["verdict"] == "unread") and label not in out.paper.untold:
            free = g.free[mark]
            limit = g.judgement.limit
            sizes = own.error_mm, abs(free.off), free.tolerance_mm(limit), abs(miss.off), miss.tolerance_mm(limit)
            row["read_mm"] = [round(own.place.real, 3), round(own.place.imag, 3)]
            keys = (*MARK_SIZE_KEYS[1:], "own_deviation_mm", "own_tolerance_mm")
            row |= {k: round(mm, 3) if math.isfinite(mm) else None for k, mm in zip(keys, sizes, strict=True)}
            row |= _warning_if_close(verdict == "right" and WARNING_SIGMAS < miss.sigmas <= limit)
        for sign in (one for one in out.paper.signs if label in one.marks):
            row["verdict"] = "wrong"
            if sign.mistake == "vector_astray":  # the vector is wrong, not its mark: that has no tolerance here
                row |= dict.fromkeys(("deviation_mm", "own_deviation_mm"), round(sign.off, 3)) | {
                    "own_tolerance_mm": None
                }
        if label == out.paper.scale_mark:
            row["unjudged"] = "length"  # the scale was taken from it
        rows.append(row)
    return rows


def _warning_if_close(close: bool) -> Json:
    """The addition to a row that is right by a narrow margin."""
    return {"warning": Phrase("check_close").told("en")} if close else {}


def _segment_row(s: Scored) -> Json:
    sizes = s.figure.given, 0.35, round(abs(abs(s.figure.given) - s.true), 3), round(3 * s.sigma, 3)
    row = {"mark": s.figure.name, **dict(zip(MARK_SIZE_KEYS, sizes, strict=True)), "verdict": s.verdict}
    return row | _warning_if_close(s.close)


def result_rows(out: Outcome) -> list[Json]:
    """The results of the JSON."""
    rows = []
    for s in out.results.scored if out.results else []:
        row = {"name": s.figure.name, "given": s.figure.given, "true": s.true, "tolerance": s.tolerance}
        row["verdict"] = s.verdict
        row |= {"mistake": s.slip and s.slip.said.key[len("mistake_") :]} if s.verdict == "wrong" else {}
        rows.append(row | _warning_if_close(s.close))
    return rows


def as_json(out: Outcome, lang: Lang = "en") -> Json:
    """The object printed by ``planes check --json``."""
    asked = out.bench.asked
    plans = out.bench.plans
    unreadable = out.verdict == "unreadable"
    unseen = [Phrase("check_unseen", names=", ".join(out.unseen))] if out.verdict == "right_as_seen" else []
    return {
        "planes": 1,
        "scene": asked.scene.file,
        "variant": asked.scene.variant,
        "phi_deg" if plans.mechanism.drive.kind == "phi" else "s": float(out.bench.given[plans.drive_given_name]),
        "plan": asked.plan,
        "verdict": out.verdict,
        "probability": None if out.chance is None else round(out.chance, 4),
        "unseen": out.unseen,
        "marks": mark_rows(out),
        "first_wrong": None if unreadable else out.first_wrong,
        "mistake": out.mistake,
        "runner_up": None if unreadable else out.runner_up,
        "sentence": {one: out.text_as_typed(out.sentence.told(one)) for one in available_languages("check")},
        "results": result_rows(out),
        "warnings": [out.text_as_typed(n.told(lang)) for n in (*out.notes, *unseen)],
    }


@dataclass
class Checked:
    """One drawing of a folder: its outcome, or why there is none; the link to its report or to itself."""

    file: str
    found: Outcome | None = None
    refused: PlanesError | None = None
    report: str = ""
    whose: str = ""
    picture: bytes = b""  # a small picture of it, if there is no rectified one
    read_from: str = ""  # the file that was opened

    @property
    def verdict(self) -> str:
        """right, right_as_seen, wrong or unreadable."""
        return self.found.verdict if self.found else "unreadable"

    @property
    def first_error_place(self) -> str:
        """The place of the first error."""
        if self.found and self.verdict == "wrong":
            return self.found.first_wrong or ""
        return ""

    def verdict_text(self, lang: Lang) -> str:
        """The mistake, the reason why it cannot be read, or the parts not seen; empty for a right drawing."""
        if self.found is None:
            return self.refused.told(lang) if self.refused else ""
        if self.verdict == "unreadable":  # the notes say what to do
            every = phrases_for_reader(self.found, "sheet") if self.report else [self.found.sentence, *self.found.notes]
        else:
            lost = [n for n in self.found.notes if n.key in ("check_marks_of_another", "check_anothers_work")]
            others = [n for n in lost if n.key == "check_anothers_work"]  # it is the cause
            every = others or [self.found.sentence] * (self.verdict != "right") + lost
        return join_sentences(one.told(lang) for one in every)

    def as_json(self, lang: Lang) -> Json:
        """The object of the drawing, with its file and its owner."""
        head = {"file": self.file, **({"whose": self.whose} if self.whose else {})}
        if self.found:
            return {**head, **as_json(self.found, lang)}
        return {
            **head,
            "verdict": self.verdict,
            "sentence": {one: self.verdict_text(one) for one in available_languages("check")},
        }


def phrases_for_reader(outcome: Outcome, reader: Reader) -> list[Phrase]:
    """The sentence and the notes for a reader of a report, where marks can be moved if it has a drawing."""
    every = (outcome.sentence, *outcome.notes)
    drawn = bool(outcome.grading or outcome.paper.picture)
    return [phrase_for_reader(reader, one) if drawn else one for one in every]


def certainty_text(outcome: Outcome, lang: Lang) -> str:
    """The certainty of the verdict, in words; empty for one without, or of a part only."""
    if outcome.chance is None or outcome.verdict == "right_as_seen":
        return ""
    key = (
        "check_sure"
        if outcome.chance >= SURE_VERDICT_PROBABILITY
        else "check_likely"
        if outcome.chance >= LEAST_VERDICT_PROBABILITY
        else "check_doubtful"
    )
    cause = outcome.cause < SURE_VERDICT_PROBABILITY <= outcome.chance
    share = outcome.cause if cause else outcome.chance
    return say("check_sure_but" if cause else key, lang, percent=f"{100 * share:.0f}" if share >= 0.005 else "< 1")


def correction_hint(outcome: Outcome, lang: Lang) -> str:
    """The correction of a wrong mark whose construction is shown; empty for others."""
    shown = shown_plans(outcome)
    at = shown.marks.get(outcome.first_wrong or "")
    led = outcome.verdict == "wrong" and any(start == at for start, _ in shown.next)
    return say("check_redo", lang) if led else ""


def report_title(outcome: Outcome, lang: Lang) -> str:
    """The plan (or the note that these are results) and the scene."""
    scene = outcome.bench.asked.scene
    head = say("check_numbers", lang) if outcome.has_only_results else plan_title(outcome.bench.plan, lang)
    return f"{head}: {scene.title.get(lang, '') or scene.file}"


def format_mm(value: float | None, lang: Lang) -> str:
    """Millimetres for a table."""
    return "—" if value is None else with_decimal_sign(f"{value:.1f}", lang)


def mark_table_rows(outcome: Outcome, lang: Lang) -> list[list[str]]:
    """Rows of the step table: verdict, mark, off its own construction, tolerance, off the right plan, in words.

    The words say so if a right mark does not follow from a wrong one beside it, but is in its true position.
    """
    rows = []
    for r in mark_rows(outcome):
        free = r["deviation_mm"], r["tolerance_mm"]
        sizes: tuple[Real, Real] = r.get("own_deviation_mm", free[0]), r.get("own_tolerance_mm", free[1])
        close = f" ({say('check_close', lang)})" if "warning" in r else ""
        if r["verdict"] == "right" and None not in sizes and sizes[0] > sizes[1]:
            close = f" ({say('check_true_place', lang)})"
        unjudged = r["verdict"] == "unread" and r["read_mm"]
        words = say("verdict_unjudged" if unjudged else f"verdict_{r['verdict']}", lang) + close
        rows.append([r["verdict"], r["mark"], *(format_mm(v, lang) for v in (*sizes, r["deviation_mm"])), words])
    return rows


def result_table_rows(outcome: Outcome, lang: Lang) -> list[list[str]]:
    """Rows of the table of results: verdict, name, written, true, verdict in words with the slip, if known."""
    rows = []
    scored = outcome.results.scored if outcome.results else []
    for r, s in zip(result_rows(outcome), scored, strict=True):
        verdict = say(f"verdict_{r['verdict']}", lang)
        if s.slip and s.verdict == "wrong":
            verdict += ": " + s.slip.said.told(lang).removeprefix(f"{s.figure.name}: ")
        true = f"{number_text(s.true, lang)} ± {number_text(s.tolerance, lang, 2)}"
        rows.append([r["verdict"], r["name"], number_text(s.figure.given, lang), true, verdict])
    return rows


def table_headings(lang: Lang) -> tuple[list[str], list[str]]:
    """The column headings of both tables."""
    marks = ("check_mark", "check_off_own", "check_tolerance", "check_off_true", "check_verdict")
    numbers = ("check_result", "check_given", "check_true", "check_verdict")
    return [say(k, lang) for k in marks], [say(k, lang) for k in numbers]


def page_data(outcome: Outcome, lang: Lang, places: Sequence[Json] | None = None) -> Json:
    """All data for display and judgement on a page; ``places`` may be precomputed. No movable marks, no tape."""
    marks, numbers = table_headings(lang)
    grading = outcome.grading or (grading_without_marks(outcome.bench) if outcome.paper.picture else None)
    sentence, *notes = phrases_for_reader(outcome, "here")
    return {
        "verdict": outcome.verdict,
        "title": report_title(outcome, lang),
        "sentence": sentence.told(lang),
        "printed": phrases_for_reader(outcome, "sheet")[0].told(lang),
        "chance": f"{certainty_text(outcome, lang)} {correction_hint(outcome, lang)}".strip(),
        "notes": [n.told(lang) for n in notes],
        "head": marks,
        "rows": mark_table_rows(outcome, lang),
        "number_head": numbers,
        "numbers": result_table_rows(outcome, lang),
        "command": check_command(outcome),
        "saved": corrected_table_name(outcome),
        "look": outcome.paper.look,
        "kind": outcome.bench.kind,
        "lettering": scene_lettering(outcome.bench.asked.scene, outcome.bench.plans),
        "places": wrong_places(outcome) if places is None else places,
        "asked": sentence.key == "check_ask",
        **({"page": moved_marks_data(outcome, grading, lang)} if grading else {}),
    }


def corrected_table_name(outcome: Outcome) -> str:
    """The table saved by a page, named after the drawing, so that it lies next to it and the next run uses it."""
    return f"{PurePath(outcome.paper.file).stem or 'marks'}.csv"


def check_command(outcome: Outcome) -> str:
    """The command that checks the table saved by a page."""
    asked = outcome.bench.asked
    words = asked.command_words(corrected_table_name(outcome))
    words += ["--mu", mu_text(asked.mu, outcome.bench.kind)] if asked.mu else []
    words += ["--work", "cad"] if asked.skill != STUDENT_SKILL else []
    for plan, paper in asked.others.items():
        words += ["--with", f"{plan}={paper.file}"]
    return shlex.join(words)
