"""Data for judging moved marks on a page: the tape, the right plan, the rule, the possible sentences."""

import base64
from collections.abc import Mapping
from dataclasses import astuple

from planes.check.blank import blank_pole
from planes.check.fiducials import SHEET_MM
from planes.check.grading import evidence, judging, off_vectors
from planes.check.grading.grading import Grading
from planes.check.grading.handwork import LEAST_MM
from planes.check.grading.paper import ReadMark
from planes.check.grading.polygons import sides_of
from planes.check.grading.prepared_plan import variants_of
from planes.check.grading.readable import READABLE, key_marks
from planes.check.grading.remedies import asking, told_to
from planes.check.grading.variants import Variant
from planes.check.outcome import Outcome
from planes.check.report.regrading import SURELY_MM, retrace
from planes.check.report.shown import own_marks, own_order, pair, shown_plans, vectors
from planes.drafting.steps import Same
from planes.geometry.plane import corners
from planes.plans.scales import extent
from planes.words import Lang, Phrase, say
from planes.words.names import POLE, kind_of, label_of, plan_of
from planes.words.records import Json

VERDICTS = ("right", "wrong", "follows", "unread")
MARGIN_MM = 12.0  # around a drawing on a page


def moved_marks(outcome: Outcome, grading: Grading, lang: Lang) -> Json:
    """The data that a page needs to judge moved marks."""
    bench, plan, taken = outcome.bench, outcome.bench.asked.plan, grading.hand.taken
    variants = variants_of(bench, taken, grading.mu)
    tape, (misses, *supposed) = retrace(grading, variants)
    truth = {label_of(m): complex(grading.truth[m]) for m in grading.marks}
    earlier = {m: pair(t.place) for m, t in taken.items() if plan_of(m) != plan}
    force = kind_of(plan) == "force"
    return {
        "kind": kind_of(plan),
        "marks": [_mark(grading, m, misses[m]) for m in grading.marks],
        "vectors": vectors(bench),
        "truth": {POLE: [0.0, 0.0], **{n: pair(z) for n, z in truth.items()}},
        "rows": [astuple(s) for s in sides_of(bench.plans, plan)] if force else [(n, POLE, n) for n in truth],
        "chained": force,
        "earlier": {f"{m}.{axis}": z[k] for m, z in earlier.items() for k, axis in enumerate("xy")},
        "order": [astuple(s) for s in own_order(outcome)],
        "tape": tape,
        "variants": [_variant(v, under, lang) for v, under in zip(variants, supposed, strict=True) if under],
        "rule": _rule(grading),
        "said": _said(outcome, lang),
        "otherwise": _otherwise(grading, lang),
        "words": {
            **{k: say(f"verdict_{k}", lang) for k in VERDICTS},
            **{k: say(f"check_{k}", lang) for k in ("close", "true_place")},
        },
        "strokes": [[*pair(a), *pair(b)] for a, b in outcome.paper.strokes],
        **_shown(outcome, truth),
    }


def _mark(grading: Grading, mark: str, miss: tuple[int, int]) -> Json:
    """A mark: its position, if it was read, and the data for its verdict."""
    taken, true = grading.hand.taken.get(mark), grading.truth[mark]
    own = taken or ReadMark(mark, true, SURELY_MM)
    return {
        "name": label_of(mark),
        "key": mark,
        "x": own.place.real,
        "y": own.place.imag,
        "read": taken is not None,
        "error": own.error_mm,
        "miss": miss,
        "true": [true.real, true.imag],
        "from": off_vectors.drawn_from(grading.hand, mark),
        "vector": off_vectors.vector_to(grading.hand, mark),
        "free": grading.loose.miss(grading.loose.things[mark], true).blurred(own.error_mm).cov,
    }


def _variant(v: Variant, under: Mapping[str, tuple[int, int]], lang: Lang) -> Json:
    return {
        "mistake": v.mistake,
        "blames": v.blames,
        "weight": v.weight,
        "said": v.sentence.told(lang),
        "under": {label_of(m): places for m, places in under.items()},
    }


def _rule(grading: Grading) -> Json:
    """The numbers that verdicts depend on."""
    absent, point = grading.rebuilt.absent if grading.rebuilt else (), grading.hand.tool.skill.point_mm
    same = (s.makes for s in grading.hand.program.steps if isinstance(s, Same))
    return {
        "false_alarm": judging.FALSE_ALARM,
        "least": LEAST_MM,
        "slip": evidence.SLIP,
        "other": judging.OTHER_CAUSE,
        "undrawn": judging.UNDRAWN,
        "left_out": judging.LEFT_OUT,
        "margin": judging.MARGIN,
        "too_well": judging.TOO_WELL,
        "warn": judging.WARN,
        "near": judging.NEAR,
        "as_well": judging.AS_WELL,
        "broad": evidence.breadth(extent(grading.truth, plan_of(grading.marks[0]))),
        "readable": READABLE,
        "key": [label_of(m) for m in key_marks(grading)],
        "absent": sorted(absent),
        "shown_by": [
            (label_of(m), [[label_of(k) for k in way] for way in ways]) for m, ways in grading.shown_by.items()
        ],
        "same": [label_of(m) for m in same if m in grading.marks],
        "smallest": evidence.SMALLEST * point,
        "sure": evidence.MOST_BY_CHANCE,
        "free": not grading.said_mu,
        "gap": grading.gap_sigma,
        "order": [label_of(m) for m in judging.order_of_reckoning(grading.hand.program.steps, grading.marks)],
    }


def _said(outcome: Outcome, lang: Lang) -> dict[str, str]:
    """Sentences that a page may need, with placeholders for names and numbers."""
    phrases = {
        "right": outcome.right(()),
        "as_seen": outcome.right((Phrase("check_not_judged", names="⟦names⟧"),)),
        "nothing_drawn": asking("check_nothing_drawn", size="⟦size⟧"),
        "by_chance": Phrase("check_by_chance", size="⟦size⟧", count="⟦count⟧"),
        "nothing": asking("check_nothing_read", names="⟦names⟧"),
        "too_little": asking("check_too_little", found="⟦found⟧", count="⟦count⟧", names="⟦names⟧"),
        "other": Phrase("check_other_drawing", count="⟦count⟧", wrong="⟦wrong⟧"),
        "unclear": Phrase("check_unclear", mark="⟦mark⟧", off="⟦off⟧"),
        "off_vector": Phrase("check_off_vector", **{k: f"⟦{k}⟧" for k in off_vectors.SENTENCE}),
    }
    return {k: told_to("here", p).told(lang) for k, p in phrases.items()}


def _otherwise(grading: Grading, lang: Lang) -> Json | None:
    """An error though no mark is wrong."""
    said = grading.otherwise
    return {"first": said.parts["mark"], "mark": grading.left_out, "said": said.told(lang)} if said else None


def _shown(outcome: Outcome, truth: Mapping[str, complex]) -> Json:
    """The picture, if any, and the part of the paper to show."""
    paper = outcome.paper
    if paper.picture:
        (w, h), pole = SHEET_MM, blank_pole(outcome.bench)
        box = paper.box or (-pole.real, -pole.imag, w - pole.real, h - pole.imag)
        href = "data:image/jpeg;base64," + base64.b64encode(paper.picture).decode()
        unread = outcome.grading is None or any(m not in outcome.grading.hand.taken for m in outcome.grading.marks)
        return {"picture": {"href": href, "box": box}, "box": box if unread else _about(outcome, truth)}
    return {"picture": None, "box": _about(outcome, truth)}


def _about(outcome: Outcome, truth: Mapping[str, complex]) -> list[float]:
    """The bounding box of both plans: left, bottom, right, top."""
    shown, margin = shown_plans(outcome), complex(MARGIN_MM, MARGIN_MM)
    vectors_shown = [*shown.own, *shown.true, *outcome.paper.strokes]
    places = [0j, *truth.values(), *own_marks(outcome).values(), *(z for v in vectors_shown for z in v)]
    low, high = corners(z for z in places if abs(z) < 2000)  # without invalid positions
    return [*pair(low - margin), *pair(high + margin)]
