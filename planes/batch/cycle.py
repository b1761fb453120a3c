"""Many positions of a mechanism at once: one program over blocks of drive positions, from the scheme to the forces.

Memory is that of one block, however many positions there are. A position that cannot be drawn has its reason, and NaN
in all results that depend on the failure. A program is recorded once and evaluated with arrays (``loops``), in long
runs by the compiled loop (``compiled``) where that is installed. Where a loop suspects a contradiction, the position is
drawn, and proved.
"""

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import TypeVar

import numpy as np

from planes.batch import compiled as compiled_loop
from planes.batch.error_bounds import Claims
from planes.batch.loops import ArrayLoop, Loop, RowsAndCodes
from planes.batch.other_leads import OtherLeads
from planes.batch.suspected import columns_by_failing_step, draw_suspected_positions
from planes.batch.table import Block, Ready, Reason, columns_of_quantities, force_ends_of_columns
from planes.batch.tracing import UNCLEAR_REASON, Trace, given_values_by_name, trace_program
from planes.drafting.clearness import has_wide_length_range
from planes.drafting.drawing import draw_program
from planes.drafting.link_proofs import Rigid, Slid
from planes.drafting.program import Program
from planes.geometry.arrays import Array, Floats, FloatsByName, Indices
from planes.plans import Plans
from planes.plans.columns import Column
from planes.plans.quantities import quantities_asked_for
from planes.plans.scales import unit_scales_of_plans
from planes.scene.ranges import Span
from planes.words import Phrase
from planes.words.errors import ProgramError, list_valid_choices
from planes.words.names import MarkPair

BLOCK_POSITIONS = 4096
LEAST_POSITIONS_TO_COMPILE = 400_000
"""Number of positions from which a compiled loop pays: 350 000 to 420 000 for classes II, III and IV."""


def compiling_pays(count: int) -> bool:
    """Whether to compile a loop for so many positions; an existing one is always faster."""
    return compiled_loop.is_compiler_available() and count >= LEAST_POSITIONS_TO_COMPILE


AnyLoop = TypeVar("AnyLoop", bound=Loop)
Places = Sequence[float] | Span | Array  # positions of the drive


class Cycle(Ready):
    """A mechanism ready for any number of positions, cut down to the requested results (``names``; None: all).

    ``known`` overrides givens by name; those with an array, a number for each position, move with the drive.
    ``columns`` may be given directly, in place of ``names``.
    """

    def __init__(
        self,
        plans: Plans,
        names: Iterable[str] | None = None,
        known: FloatsByName | None = None,
        columns: Iterable[Column] | None = None,
    ) -> None:
        quantities = None if names is None else quantities_asked_for(plans, names)
        self.plans = plans
        self.columns = columns_of_quantities(plans, quantities) if columns is None else list(columns)
        self.program = plans.program.cut_to_names([n for c in self.columns for n in c.needed_names])
        self.mus = unit_scales_of_plans(plans)
        self.known = frozenset(known or ())
        self.given = {**plans.given, **self.mus}
        if self.known - {*self.mus, plans.drive_given_name, *plans.drive.rate_names}:
            # an overridden number is no fault of the links it belongs to
            proofs = tuple(p for p in self.program.proofs if not isinstance(p, Rigid | Slid))
            self.program = Program(self.program.steps, proofs)
        for name in self.known - {*self.given}:
            raise ProgramError(Phrase("no_given", name=name, valid=list_valid_choices(name, self.given)))
        self.given |= known or {}
        self.moved = {name: np.asarray(v) for name, v in (known or {}).items() if np.ndim(v)}
        self.folded = {mu: 1.0 for mu in self.mus if mu not in (known or {})}
        self.overrides = known
        self.others = OtherLeads(self)

    @cached_property
    def trace(self) -> Trace:
        """The program on a tape, drawn in SI, or at the given scales."""
        must = [not c.beside for c in self.columns]  # an arm ends where its force does
        takes = [c.read_from_drawing for c in self.columns]
        still = self.given.keys() - self.known - {self.plans.drive_given_name}
        units = {n: self.given[n] for n in still if np.isin(self.given[n], (0, 1, -1))}  # free once they are folded
        return trace_program(
            self.program, self.given, takes, {**units, **self.folded}, must=must, forces=self.force_ends
        )

    @cached_property
    def force_ends(self) -> list[MarkPair]:
        """The ends of the forces among the columns, without those that are computed from zeros: no load reaches
        them."""
        if not (sides := force_ends_of_columns(self.columns)):
            return []
        own = np.array([self.plans.drive.position])
        things = draw_program(self.program, {**self.given, **self.changing_inputs(own, slice(0, 1))}).things
        if not (still := [s for s in sides if (things[s[0]] == things[s[1]]).all()]):
            return sides
        exact = self.error_claims.error_bounds_of_columns(own)[:, 0] == 0
        rough = {(c.start, c.end) for c, sure in zip(self.columns, exact, strict=True) if not sure}
        return [s for s in sides if s not in still or s in rough]

    @cached_property
    def reasons(self) -> tuple[Reason, ...]:
        """The reasons for the codes: code k is reason k - 1."""
        return tuple(Reason(r, makes) for r, makes, _ in self.trace.requires if r != UNCLEAR_REASON)

    @cached_property
    def _proof_codes(self) -> list[int]:
        """The codes of proofs: a failure may be only rounding."""
        return [k for k, r in enumerate(self.reasons, 1) if r.key in self.trace.proofs]

    @cached_property
    def _only_drive_moves(self) -> bool:
        """Whether only the drive moves, and everything may move with it."""
        return not self.moved and not self.plans.laws

    @cached_property
    def _is_never_clear(self) -> bool:
        """Whether no position is clear of rounding."""
        return has_wide_length_range(self.plans.given, self.plans.means)

    @cached_property
    def _dependent_columns(self) -> dict[str, list[int]]:
        return columns_by_failing_step(self, self.trace)

    @cached_property
    def error_claims(self) -> Claims:
        """The error bound of every number."""
        return Claims(self)

    @cached_property
    def decimal_error_claims(self) -> Claims:
        """The same for givens with the uncertainty of decimals."""
        return Claims(self, {n: lost for n, lost in self.plans.decimal_rounding_errors.items() if n not in self.known})

    @cached_property
    def compiled_loop_of_cycle(self) -> compiled_loop.CompiledLoop:
        """The compiled loop."""
        return self._make_loop(compiled_loop.CompiledLoop)

    @cached_property
    def array_loop(self) -> ArrayLoop:
        """The loop by arrays."""
        return self._make_loop(ArrayLoop)

    def _make_loop(self, kind: type[AnyLoop]) -> AnyLoop:
        return kind(
            self.trace,
            (self.plans.drive_given_name, *given_values_by_name(self.moved)),
            given_values_by_name(self.given),
        )

    def changing_inputs(self, values: Array, at: Indices | slice) -> dict[str, Floats]:
        """The inputs that change, at the positions numbered ``at``: the drive with ``values``, and its companions."""
        beside = {name: v[at] for name, v in self.moved.items()}
        return {**self.plans.drive_givens_at(values, self.program, self.known), **beside}

    def blocks(
        self,
        values: Places,
        chunk: int = BLOCK_POSITIONS,
        fast: bool | None = None,
        bare: bool = False,
        out: Array | None = None,
    ) -> Iterator[Block]:
        """Blocks of at most ``chunk`` positions. ``fast`` says whether to compile; by default, where that pays.

        Numbers without a correct digit are NaN, unless the ``bare`` ones are requested.
        """
        fast = self._is_compiling_worthwhile(len(values)) if fast is None else fast
        size = min(chunk, self.choose_loop(fast).row)
        for start in range(0, len(values), size):
            part = np.asarray(values[start : start + size], float)
            into = None if out is None else out[:, start : start + size]
            yield self.block_of_positions(part, slice(start, start + len(part)), fast, bare, into)

    def _is_compiling_worthwhile(self, count: int) -> bool:
        return "compiled" in self.__dict__ or compiling_pays(count)

    def choose_loop(self, fast: bool) -> Loop:
        """The loop, compiled or by arrays."""
        return self.compiled_loop_of_cycle if fast else self.array_loop

    def block_of_positions(
        self, part: Array, at: Indices | slice, fast: bool, bare: bool, out: Array | None = None
    ) -> Block:
        """The block of the positions numbered ``at``; where leads cross too bluntly, by plans with other leads."""
        table, codes = self._run_loop(self.choose_loop(fast), part, at, out)
        block = self._mask_failed_results(part, table, codes)
        if codes is None and not self._is_never_clear:
            return block
        at = np.arange(at.start, at.stop) if isinstance(at, slice) else at
        self.others.fill_block_by_other_cycles(block := self._mask_doubtful_numbers(block, at, bare), at, fast, bare)
        return block

    def table(
        self, values: Array, fast: bool | None = None, out: Array | None = None, threads: int = 1, bare: bool = True
    ) -> tuple[Array, Indices]:
        """A row of all values for each column (in ``out``, where given), and the codes. ``fast`` and ``bare`` are those
        of :meth:`blocks`. Several ``threads`` share the positions: machine code runs in parallel."""
        fast, values = (
            self._is_compiling_worthwhile(len(values)) if fast is None else fast,
            np.ascontiguousarray(values, float),
        )
        out = np.empty((len(self.columns), len(values))) if out is None else out
        codes = np.zeros(len(values), np.intp)
        straight = fast and self._only_drive_moves and not self._is_never_clear and out.strides[1] == values.itemsize

        def fill(part: slice) -> None:
            some = values[part]
            rows = out[:, part]
            start = part.start
            if straight and len(some) and self.compiled_loop_of_cycle.fill_rows(some, rows):
                return
            for block in self.blocks(some, fast=fast, bare=bare, out=rows):
                codes[start : start + len(block.codes)] = block.codes
                start += len(block.codes)

        if threads == 1 or not self._only_drive_moves:
            fill(slice(0, None))
            return out, codes
        from concurrent.futures import ThreadPoolExecutor

        fill(slice(0, 1))  # what threads share is made before they begin
        cuts = np.linspace(0, len(values), threads + 1, dtype=int)
        with ThreadPoolExecutor(threads - 1) as pool:
            rest = pool.map(fill, map(slice, cuts[1:-1], cuts[2:]))
            fill(slice(0, cuts[1]))
            list(rest)
        return out, codes

    def _run_loop(self, loop: Loop, part: Array, at: Indices | slice, out: Array | None = None) -> RowsAndCodes:
        """The table by a loop, and the codes (None: nothing failed); suspected positions are drawn."""
        moving = {self.plans.drive_given_name: part} if self._only_drive_moves else self.changing_inputs(part, at)
        table, codes = loop([np.asarray(x) for x in map(given_values_by_name(moving).__getitem__, loop.inputs)], out)
        if codes is None or not (suspect := np.isin(codes, self._proof_codes)).any():
            return table, codes
        some = {name: np.asarray(v)[suspect] for name, v in moving.items()}
        table[:, suspect], drawn_codes = draw_suspected_positions(
            self, self.trace, self.force_ends, some, int(suspect.sum())
        )
        codes[suspect] = 0 if drawn_codes is None else drawn_codes
        return table, codes if codes.any() else None

    def _mask_failed_results(self, part: Array, table: Array, codes: Indices | None) -> Block:
        """The block with NaN in all results that depend on a failure; and where it is not clear, that code."""
        if codes is None:
            return Block(part, table, np.zeros(len(part), np.int16))
        for code in np.unique(codes[(codes != 0) & (codes <= len(self.reasons))]):
            table[np.ix_(self._dependent_columns[self.reasons[code - 1].makes], codes == code)] = np.nan
        return Block(part, table, codes)

    def _mask_doubtful_numbers(self, block: Block, at: Indices, bare: bool) -> Block:
        """The block with NaN for numbers without a correct digit, where it is not clear."""
        where = np.flatnonzero((block.codes == len(self.reasons) + 1) | (block.codes == 0) & self._is_never_clear)
        block.codes[where] = 0
        if len(where) and not bare:
            bounds = self.error_claims.error_bounds_of_columns(block.values[where], at[where])
            table = block.table[:, where]
            doubtful = self.error_claims.doubtful_numbers(table, bounds) | self.error_claims.numbers_on_faint_forces(
                table, bounds
            )
            block.table[:, where] = np.where(doubtful, np.nan, table)
            block.codes[where[doubtful.any(axis=0)]] = self.reasons.index(Reason("no_digits", "")) + 1
        return block

    def decimal_error_bounds(self, values: Array, at: Indices) -> Array:
        """± of every column for givens with the uncertainty of decimals."""
        return self.others.fill_claimed_bounds(
            self.decimal_error_claims.error_bounds_of_columns(values, at), values, at
        )

    def failure_codes(self, values: Array, at: Indices) -> Indices | None:
        """The reason for which each position fails, by arrays; None: none does."""
        return self._run_loop(self.array_loop, values, at)[1]


__all__ = ["Block", "Column", "Cycle", "Reason"]
