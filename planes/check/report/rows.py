"""The outcome of a check as the object for programs: marks, results, the sentence in both languages."""

from __future__ import annotations

import math

from planes.check import Outcome
from planes.check.grading.judging import WARN
from planes.check.grading.written_numbers import Scored
from planes.words import Lang, Phrase
from planes.words.names import label_of
from planes.words.records import Json

SIZES = ("read_mm", "read_error_mm", "deviation_mm", "tolerance_mm")


def mark_rows(out: Outcome) -> list[Json]:
    """The marks of the JSON (or the segments of a table of segments)."""
    g = out.grading
    if g is None:
        return [_segment_row(s) for s in (out.segments.scored if out.segments else [])]
    rows = []
    for mark, verdict in g.verdicts.items():
        own, miss = g.hand.taken.get(mark), g.judgement.misses.get(mark)
        row: Json = {"mark": label_of(mark), **dict.fromkeys(SIZES), "verdict": verdict}
        absent = g.rebuilt is not None and label_of(mark) in g.rebuilt.absent
        if own and miss and not (absent and verdict == "right"):
            free = g.free[mark]
            limit = g.judgement.limit
            found = own.error_mm, abs(free.off), free.reach(limit), abs(miss.off), miss.reach(limit)
            row["read_mm"] = [round(own.place.real, 3), round(own.place.imag, 3)]
            keys = (*SIZES[1:], "own_deviation_mm", "own_tolerance_mm")
            row |= {k: round(mm, 3) if math.isfinite(mm) else None for k, mm in zip(keys, found, strict=True)}
            row |= _warned(verdict == "right" and WARN < miss.sigmas <= limit)
        elif absent:
            row["verdict"] = "unread"
        if label_of(mark) == out.paper.scale_mark:
            row["unjudged"] = "length"  # the scale was taken from it
        rows.append(row)
    return rows


def _warned(close: bool) -> Json:
    """What is added to a row that is right by less than it should."""
    return {"warning": Phrase("check_close").told("en")} if close else {}


def _segment_row(s: Scored) -> Json:
    sizes = s.figure.given, 0.35, round(abs(abs(s.figure.given) - s.true), 3), round(3 * s.sigma, 3)
    row = {"mark": s.figure.name, **dict(zip(SIZES, sizes, strict=True)), "verdict": s.verdict}
    return row | _warned(s.close)


def result_rows(out: Outcome) -> list[Json]:
    """The results of the JSON."""
    rows = []
    for s in out.results.scored if out.results else []:
        row = {"name": s.figure.name, "given": s.figure.given, "true": s.true, "verdict": s.verdict}
        row |= {"mistake": s.slip} if s.verdict == "wrong" else {}
        rows.append(row | _warned(s.close))
    return rows


def as_json(out: Outcome, lang: Lang = "en") -> Json:
    """The object ``planes check --json`` prints."""
    asked, plans = out.bench.asked, out.bench.plans
    value = float(out.bench.given[plans.drive_given])
    unreadable = out.verdict == "unreadable"
    unseen = [Phrase("check_unseen", names=", ".join(out.unseen))] if out.unseen and out.verdict == "right" else []
    return {
        "planes": 1,
        "scene": asked.scene.file,
        "variant": asked.scene.variant,
        "phi_deg" if plans.mechanism.drive.kind == "phi" else "s": value,
        "plan": asked.plan,
        "verdict": out.verdict,
        "marks": mark_rows(out),
        "first_wrong": None if unreadable else out.first_wrong,
        "mistake": out.mistake,
        "runner_up": None if unreadable else out.runner_up,
        "sentence": {one: out.sentence.told(one) for one in ("ru", "en")},
        "results": result_rows(out),
        "warnings": [n.told(lang) for n in (*out.notes, *unseen)],
    }
