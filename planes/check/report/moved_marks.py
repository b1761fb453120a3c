"""Data for judging moved marks on a page: the tape, the right plan, the rule, the possible sentences."""

from dataclasses import astuple

from planes.check.blank import blank_pole
from planes.check.fiducials import SHEET_MM
from planes.check.grading import evidence, judging, off_vectors
from planes.check.grading.grading import Grading
from planes.check.grading.handwork import LEAST_MARK_ERROR_MM
from planes.check.grading.paper import MarkPlaces, ReadMark
from planes.check.grading.polygons import polygon_sides
from planes.check.grading.prepared_plan import mistake_variants
from planes.check.grading.readable import LEAST_READ_SHARE, key_marks
from planes.check.grading.remedies import phrase_for_reader, phrase_with_remedy
from planes.check.grading.variants import Variant
from planes.check.outcome import Outcome
from planes.check.report.places import jpeg_data_address
from planes.check.report.regrading import SCREEN_MARK_ERROR_MM, Places, TapePair, grading_tape
from planes.check.report.shown import own_marks, own_side_order, point_coordinates, shown_plans, vector_end_labels
from planes.drafting.steps import Same
from planes.geometry.plane import bounding_corners
from planes.plans.extents import plan_extent
from planes.words import Lang, Phrase, say
from planes.words.names import POLE_LABEL, Mark
from planes.words.records import Json

MARK_VERDICTS = ("right", "wrong", "follows", "unread")
PAGE_MARGIN_MM = 12.0  # around a drawing on a page


def moved_marks_data(outcome: Outcome, grading: Grading, lang: Lang) -> Json:
    """The data that a page needs to judge moved marks."""
    bench = outcome.bench
    taken = grading.hand.taken
    variants = mistake_variants(bench, taken, grading.mu)
    tape, (misses, *supposed) = grading_tape(grading, variants)
    truth = {m.label: complex(grading.truth[m]) for m in grading.marks}
    earlier = {m: point_coordinates(t.place) for m, t in taken.items() if m.plan != bench.plan}
    force = bench.plan.is_force
    return {
        "kind": bench.kind,
        "marks": [_mark_data(grading, m, misses[m]) for m in grading.marks],
        "vectors": vector_end_labels(bench),
        "truth": {POLE_LABEL: [0.0, 0.0], **{n: point_coordinates(z) for n, z in truth.items()}},
        "rows": [astuple(s) for s in polygon_sides(bench.plans, bench.plan)]
        if force
        else [(n, POLE_LABEL, n) for n in truth],
        "chained": force,
        "earlier": {f"{m}.{axis}": z[k] for m, z in earlier.items() for k, axis in enumerate("xy")},
        "order": [astuple(s) for s in own_side_order(outcome)],
        "tape": tape,
        "variants": [_variant_data(v, under, lang) for v, under in zip(variants, supposed, strict=True) if under],
        "rule": _verdict_parameters(grading),
        "said": _page_sentences(outcome, lang),
        "otherwise": _polygon_fault_data(grading, lang),
        "words": {
            **{k: say(f"verdict_{k}", lang) for k in MARK_VERDICTS},
            **{k: say(f"check_{k}", lang) for k in ("close", "true_place")},
        },
        "strokes": [[*point_coordinates(a), *point_coordinates(b)] for a, b in outcome.paper.strokes],
        **_picture_and_box(outcome, truth),
    }


def _mark_data(grading: Grading, mark: Mark, miss: TapePair) -> Json:
    """A mark: its position, if it was read, and the data for its verdict."""
    taken = grading.hand.taken.get(mark)
    true = grading.truth[mark]
    own = taken or ReadMark(mark, true, SCREEN_MARK_ERROR_MM)
    return {
        "name": mark.label,
        "key": mark,
        "x": own.place.real,
        "y": own.place.imag,
        "read": taken is not None,
        "error": own.error_mm,
        "miss": miss,
        "true": [true.real, true.imag],
        "from": off_vectors.vector_start_label(grading.hand, mark),
        "vector": off_vectors.vector_label(grading.hand, mark),
        "free": grading.loose.miss(grading.loose.things[mark], true).with_reading_error(own.error_mm).cov,
    }


def _variant_data(v: Variant, under: Places, lang: Lang) -> Json:
    return {
        "mistake": v.mistake,
        "blames": v.blames,
        "weight": v.weight,
        "omits": v.omits,
        "said": v.sentence.told(lang),
        "under": {m.label: places for m, places in under.items()},
    }


def _verdict_parameters(grading: Grading) -> Json:
    """The numbers that verdicts depend on."""
    same = (s.makes for s in grading.hand.program.steps if isinstance(s, Same))
    return {
        "false_alarm": judging.FALSE_ALARM_SHARE,
        "least": LEAST_MARK_ERROR_MM,
        "slip": evidence.SLIP_PROBABILITY,
        "other": judging.OTHER_CAUSE_WEIGHT,
        "undrawn": judging.UNDRAWN_MARK_WEIGHT,
        "margin": judging.LEAST_LEAD_LOG_ODDS,
        "too_well": judging.LEAST_LOG_ODDS_OVER_CHANCE,
        "warn": judging.WARNING_SIGMAS,
        "near": judging.CLOSE_CALL_SIGMAS,
        "as_well": judging.RIVAL_MISTAKE_LOG_ODDS,
        "broad": evidence.log_density_anywhere(plan_extent(grading.truth, grading.marks[0].plan)),
        "readable": LEAST_READ_SHARE,
        "key": [m.label for m in key_marks(grading)],
        "absent": sorted(grading.rebuilt.absent) if grading.rebuilt else [],
        "shown_by": [
            (m.label, [[k.label for k in way] for way in ways]) for m, ways in grading.determining_marks.items()
        ],
        "same": [m.label for m in same if m in grading.marks],
        "smallest": evidence.SMALLEST_DRAWING_SIGMAS * grading.hand.tool.skill.point_mm,
        "sure": evidence.MOST_CHANCE_OF_RANDOM_MARKS,
        "free": not grading.said_mu,
        "gap": grading.closing_error_sigma_mm,
        "order": [m.label for m in judging.judging_order(grading.hand.program.steps, grading.marks)],
    }


def _page_sentences(outcome: Outcome, lang: Lang) -> dict[str, str]:
    """Sentences that a page may need, with placeholders for names and numbers."""
    phrases = {
        "right": outcome.right_sentence(()),
        "as_seen": outcome.right_sentence((Phrase("check_not_judged", names="⟦names⟧"),)),
        "nothing_drawn": phrase_with_remedy("check_nothing_drawn", size="⟦size⟧"),
        "by_chance": Phrase("check_by_chance", size="⟦size⟧", count="⟦count⟧"),
        "nothing": phrase_with_remedy("check_nothing_read", names="⟦names⟧"),
        "too_little": phrase_with_remedy("check_too_little", found="⟦found⟧", count="⟦count⟧", names="⟦names⟧"),
        "other": Phrase("check_other_drawing", count="⟦count⟧", wrong="⟦wrong⟧"),
        "unclear": Phrase("check_unclear", mark="⟦mark⟧", off="⟦off⟧"),
        "off_vector": Phrase("check_off_vector", **{k: f"⟦{k}⟧" for k in off_vectors.PHRASE_PART_NAMES}),
    }
    return {k: phrase_for_reader("here", p).told(lang) for k, p in phrases.items()}


def _polygon_fault_data(grading: Grading, lang: Lang) -> Json | None:
    """An error though no mark is wrong."""
    said = grading.polygon_fault
    if said:
        return {"first": said.parts["mark"], "mark": grading.missing_force, "said": said.told(lang)}
    return None


def _picture_and_box(outcome: Outcome, truth: MarkPlaces) -> Json:
    """The picture, if any, and the part of the paper to show."""
    paper = outcome.paper
    if paper.picture:
        w, h = SHEET_MM
        pole = blank_pole(outcome.bench)
        box = paper.box or (-pole.real, -pole.imag, w - pole.real, h - pole.imag)
        href = jpeg_data_address(paper.picture)
        unread = outcome.grading is None or any(m not in outcome.grading.hand.taken for m in outcome.grading.marks)
        return {"picture": {"href": href, "box": box}, "box": box if unread else _box_of_both_plans(outcome, truth)}
    return {"picture": None, "box": _box_of_both_plans(outcome, truth)}


def _box_of_both_plans(outcome: Outcome, truth: MarkPlaces) -> list[float]:
    """The bounding box of both plans: left, bottom, right, top."""
    shown = shown_plans(outcome)
    margin = complex(PAGE_MARGIN_MM, PAGE_MARGIN_MM)
    vectors_shown = [*shown.own, *shown.true, *outcome.paper.strokes]
    places = [0j, *truth.values(), *own_marks(outcome).values(), *(z for v in vectors_shown for z in v)]
    low, high = bounding_corners(z for z in places if abs(z) < 2000)  # without invalid positions
    return [*point_coordinates(low - margin), *point_coordinates(high + margin)]
