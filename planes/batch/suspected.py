"""Contradictions suspected by a loop, drawn and proved; and the columns lost where a step fails."""

from __future__ import annotations

import numpy as np

from planes.batch.loops import RowsAndCodes
from planes.batch.table import Ready
from planes.batch.tracing import UNCLEAR_REASON, Trace
from planes.drafting.clearness import is_clear_drawing
from planes.drafting.drawing import draw_program, mask_unproved_drawings
from planes.geometry.arrays import FloatsByName
from planes.words.names import MarkPair

Forces = list[MarkPair]  # columns by their ends


def draw_suspected_positions(
    cycle: Ready, trace: Trace, forces: Forces, moving: FloatsByName, count: int
) -> RowsAndCodes:
    """The columns of some positions and their codes (None: nothing failed), drawn step by step and proved."""
    given = {**cycle.given, **moving}
    drawing = draw_program(cycle.program, given)
    mask_unproved_drawings(drawing, given)
    table = np.empty((len(cycle.columns), count))
    with np.errstate(all="ignore"):
        for row, column in zip(table, cycle.columns, strict=True):
            row[:] = column.read_from_drawing(drawing.things, drawing.tool.ar)
    numbered = {(r, makes): k for k, (r, makes, _) in enumerate(trace.requires, 1)}
    counted = np.array([not c.beside for c in cycle.columns])
    plain = is_clear_drawing(cycle.program, drawing.things, drawing.tool, forces)
    codes = np.where(plain, 0, numbered.get((UNCLEAR_REASON, ""), 0))
    codes = np.where(np.isfinite(table[counted].sum(axis=0)), codes, numbered.get(("no_digits", ""), 0))
    for reason, step, ok, _ in reversed(drawing.tool.failures):
        codes = np.where(ok, codes, numbered[reason, getattr(step, "makes", "")])
    return table, codes.astype(np.int16) if codes.any() else None


def columns_by_failing_step(cycle: Ready, trace: Trace) -> dict[str, list[int]]:
    """The columns that depend on each step that may fail."""
    columns: dict[str, list[int]] = {makes: [] for _, makes, _ in trace.requires}
    for k, column in enumerate(cycle.columns):
        for made in cycle.program.cut_to_names(column.needed_names).result_names & columns.keys():
            columns[made].append(k)
    every = list(range(len(cycle.columns)))
    return {**columns, **{s.makes: every for s in cycle.program.steps if s.guards}, "": every}
