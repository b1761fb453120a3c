"""Positions of a cycle one by one: as a long table, with a progress bar and the failed ranges in words, and as a short
listing, as text and as JSON."""

import math
import sys
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np

from planes.batch.cycle import Block, Cycle, Reason
from planes.batch.streams import TableHead, open_block_writer
from planes.batch.table import ERROR_COLUMN_PREFIX
from planes.diagrams.turn import WholeTurn
from planes.drafting.drawing import draw_program, refuse_unproved_drawing
from planes.plans import Plans
from planes.plans.curves import CHAPTERS_BY_GROUP, Curve
from planes.plans.scales import unit_scales_of_plans
from planes.scene.ranges import Span
from planes.solving import drive_position_in_words, drive_position_key, failed_position_sentence
from planes.solving.nearest import Nearest
from planes.solving.text_tables import aligned_table
from planes.words import Lang, put_decimal_signs, say
from planes.words.errors import PlanFailure
from planes.words.records import Json, finite_or_none
from planes.words.waiting import progress_bar

FULL_TURN_SPAN = Span(0.0, 1.0, 361)
MOST_DESCRIBED_RANGES = 20  # failed ranges described in words


@dataclass
class Gap:
    """Successive positions that failed for the same reason."""

    code: int
    first: float
    last: float
    count: int


def write_table(
    turn: WholeTurn, values: Span | None, output: str, lang: Lang, fast: bool | None = None, errors: bool = False
) -> int:
    """Write a table of curves, with ``errors`` the ± of each after them; returns the exit status."""
    span = values or default_table_range(turn.plans)
    kind = turn.plans.drive.kind
    count = len(span)
    drive = (kind, "°" if kind == "phi" else "m")
    heads = [(c.name, c.unit) for c in turn.curves]
    heads += [(ERROR_COLUMN_PREFIX + name, unit) for name, unit in heads if errors]
    gaps: list[Gap] = []
    with open_block_writer(Path(output), TableHead(drive, heads, turn.failure_reasons), count) as writer:
        for block in blocks_with_progress_bar(turn.curve_blocks(span, fast, errors), count, lang):
            writer.write_block(block)
            collect_failed_ranges(gaps, block)
    report_failed_ranges(turn.cycles_by_prefix[0][1], turn.failure_reasons, gaps, kind, lang)
    failed = sum(gap.count for gap in gaps)
    print(say("cycle_done", lang, file=output, count=count, failed=failed), file=sys.stderr)
    return 0 if failed < count else 2


def default_table_range(plans: Plans) -> Span:
    """The default range of a table: a full turn, or the given position of a slider."""
    drive = plans.drive
    return FULL_TURN_SPAN if drive.rotates else Span(drive.position, 0.0, 1)


def blocks_with_progress_bar(blocks: Iterator[Block], count: int, lang: Lang) -> Iterator[Block]:
    """The blocks, with a progress bar for a user at a terminal."""
    done = 0
    with progress_bar(unit=f" {say('positions', lang)}", unit_scale=True) as step:
        for block in blocks:
            yield block
            done += len(block.values)
            if step:
                step(done, count)


def collect_failed_ranges(gaps: list[Gap], block: Block) -> None:
    """Merge the failed positions of a block into the ranges found so far."""
    codes = block.codes
    edges = np.flatnonzero(np.diff(codes)) + 1
    for start, end in zip([0, *edges], [*edges, len(codes)], strict=True):
        code = int(codes[start])
        first = float(block.values[start])
        last = float(block.values[end - 1])
        if not gaps or gaps[-1].code != code:
            gaps.append(Gap(code, first, last, 0))
        gaps[-1].last = last
        gaps[-1].count += int(end - start) * (code != 0)


def report_failed_ranges(table: Cycle, reasons: tuple[Reason, ...], gaps: list[Gap], kind: str, lang: Lang) -> None:
    """Report on stderr where and why positions failed."""
    failed = [gap for gap in gaps if gap.code]
    for gap in failed[:MOST_DESCRIBED_RANGES]:
        first, last = (drive_position_in_words(v, kind, lang) for v in (gap.first, gap.last))
        name = "φ" if kind == "phi" else "s"
        why = failure_sentence(table, reasons, gap, lang)
        print(say("cycle_failed", lang, name=name, first=first, last=last, count=gap.count, why=why), file=sys.stderr)
    if len(failed) > MOST_DESCRIBED_RANGES:
        print(say("cycle_more", lang, count=len(failed) - MOST_DESCRIBED_RANGES), file=sys.stderr)


def failure_sentence(table: Cycle, reasons: tuple[Reason, ...], gap: Gap, lang: Lang) -> str:
    """The sentence about the first position of a range, drawn singly at full size."""
    given = {**table.given, **dict.fromkeys(table.mus, 1000.0), table.plans.drive_given_name: gap.first}
    try:
        refuse_unproved_drawing(table.program, given, draw_program(table.program, given))
    except PlanFailure as failure:
        return failure.told(lang)
    why = reasons[gap.code - 1]
    (block,) = table.blocks([gap.first], fast=False)
    empty = (c.name for c, row in zip(table.columns, block.table, strict=True) if np.isnan(row[0]) and not c.beside)
    return say("no_digits", lang, makes=why.makes or ", ".join(empty) or "…")


LISTING_DECIMALS = 5


def curves_at_positions(turn: WholeTurn, values: Any) -> dict[str, list[float]]:
    """Every curve at each position of the drive, by its name."""
    sample = turn.sample_columns(values)
    return {c.name: c.read(sample).tolist() for c in turn.curves}


def curves_at_positions_json(turn: WholeTurn, values: Any) -> Json:
    """The listing as JSON data: None where a curve has no value."""
    rows = curves_at_positions(turn, values)
    key = drive_position_key(turn.plans)
    positions = [
        {key: float(v), "values": {n: finite_or_none(row[k]) for n, row in rows.items()}} for k, v in enumerate(values)
    ]
    return {"planes": 1, "units": {c.name: c.unit for c in turn.curves}, "positions": positions}


def failed_position_sentences(turn: WholeTurn, values: Any, lang: Lang) -> list[str]:
    """A sentence for each position that cannot be drawn."""
    plans = turn.plans
    sentences = []
    given = {**plans.given, **dict.fromkeys(unit_scales_of_plans(plans), 1000.0)}
    nearest = Nearest(plans)
    for value in map(float, values):
        try:
            draw_program(plans.program, {**given, plans.drive_given_name: value})
        except PlanFailure as failure:
            sentences.append(
                failed_position_sentence(failure, value, plans.drive.kind, nearest.nearest_to_position(value)).told(
                    lang
                )
            )
    return sentences


def curve_listing_text(turn: WholeTurn, values: Any, lang: Lang) -> str:
    """Every curve in each position, in the order of the analytic method, with five decimals."""
    told_rows = curves_at_positions(turn, values)
    kind = turn.plans.drive.kind
    lines = []
    for key, curves in _curves_by_chapter(turn.curves):
        rows = [[c.name, say(c.unit, lang), *map(number_with_five_decimals, told_rows[c.name])] for c in curves]
        head = ["", say("column_unit", lang), *(drive_position_in_words(float(v), kind, lang) for v in values)]
        lines += aligned_table(say(key, lang), head, rows)
    return put_decimal_signs("\n".join(lines[1:]), lang) + "\n"


def _curves_by_chapter(curves: tuple[Curve, ...]) -> list[tuple[str, list[Curve]]]:
    def chapter(c: Curve) -> str:
        quick = c.name.startswith(("a", "epsilon", "coriolis"))
        return CHAPTERS_BY_GROUP[c.group][-1 if quick else 0]

    keys = chain(*CHAPTERS_BY_GROUP.values())
    return [(f"group_{k}", [c for c in curves if chapter(c) == k]) for k in keys]


def number_with_five_decimals(value: float) -> str:
    """A number with five decimals, without trailing zeros, as a calculating sheet prints it."""
    if not math.isfinite(value):
        return "—"
    text = f"{value:.{LISTING_DECIMALS}f}".rstrip("0").rstrip(".")
    return "0" if text in ("-0", "") else text
