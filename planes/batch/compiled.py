"""A program as one compiled loop over positions (the extra ``fast``): made from a tape.

The compiler is the one inside numba, called directly: a tape has no types to infer and no branches.
"""

import ctypes
from collections.abc import Callable, Sequence
from functools import cache, cached_property
from hashlib import sha256
from importlib.util import find_spec
from itertools import pairwise
from typing import Any

import numpy as np

from planes.batch import kept_code
from planes.batch.llvm_ir import ROW_GAP_POSITIONS, llvm_module_text, module_storing_past_caches, positions_per_row
from planes.batch.loops import Loop, RowsAndCodes
from planes.batch.tracing import Trace
from planes.geometry.arrays import Array, FloatsByName, Indices
from planes.words.names import NameTuple

CACHE_LINE_BYTES = 64
"""Bytes of a cache line: numbers that straddle two lines are an eighth slower."""
POSITIONS_PER_CALL = 2**14
"""Number of positions of a table in one call, so that their codes stay in the cache."""
LEAST_BYTES_PAST_CACHES = 2**25
"""Bytes of a table that no cache holds: stores past the caches take half the time of others, a six-link's at 10⁶."""


def is_compiler_available() -> bool:
    """Whether the compiler is installed."""
    return find_spec("llvmlite") is not None


class CompiledLoop(Loop):
    """A compiled trace ready to run; compiled at the first run."""

    def __init__(self, trace: Trace, moving: NameTuple, given: FloatsByName) -> None:
        super().__init__(trace, moving, given)
        tape = trace.tape
        outputs = list(trace.outputs)
        fixed = [p for p in self.still if tape.ops[p][0] != "const"]
        tested = (place for _, makes, place in trace.requires if makes)  # the others only ask for a closer look
        rough = frozenset(self.moved).difference(tape.places_needed([*outputs, *tested]))
        self.row = positions_per_row(len(self.places) + len(outputs) + 1)
        self.text = llvm_module_text(
            tape, self.moved, self.places, fixed, outputs, self.conditions, rough, self.row + ROW_GAP_POSITIONS
        )
        self.fixed = np.array([float(self.still[p]) for p in fixed] or [0.0])

    @cached_property
    def run_function(self) -> Callable[..., int]:
        """The machine code (``llvm_ir.module``)."""
        return _compiled_run_function(self.text)

    @cached_property
    def run_function_past_caches(self) -> Callable[..., int]:
        """The machine code that stores past the caches."""
        return _compiled_run_function(self.text, past=True)

    def __call__(self, rows: Sequence[Array], out: Array | None = None) -> RowsAndCodes:
        """One block of positions.

        This code runs for every block, so it is short: rows of inputs, outputs and codes share one piece of memory, and
        its address is taken the short way (``array.ctypes`` takes six times as long).
        """
        inputs = len(rows)
        count = len(rows[0])
        wide = self.row + ROW_GAP_POSITIONS
        made = 0 if out is not None else len(self.trace.outputs)
        memory = np.empty((inputs + 1 + made) * wide + CACHE_LINE_BYTES // 8)
        begin = _memory_address(memory)
        begin += (skip := -begin % CACHE_LINE_BYTES)
        block = np.ndarray((inputs + 1 + made, wide), float, memory, skip)
        for k, values in enumerate(rows):
            block[k, :count] = values
        codes = begin + 8 * wide * inputs
        filled = begin + 8 * wide * (inputs + 1)
        if out is None:
            out = block[inputs + 1 :, :count]
        else:
            filled = _memory_address(out[0])
            wide = out.strides[0] >> 3
        failed = self.run_function(begin, filled, codes, self._fixed_rows_address, count, wide)
        return out, block[inputs, :count].view(np.int64).astype(np.int16) if failed else None

    def fill_rows(self, values: Array, out: Array) -> bool:
        """All positions for a single input, each output straight into its row of ``out``; returns whether all of them
        hold. Other threads may run at the same time. A few positions are computed before the rest, so that no vector
        store straddles two cache lines: a quarter faster."""
        begin = _memory_address(values)
        into = _memory_address(out[0])
        apart = out.strides[0]
        count = len(values)
        lined = into % 8 == apart % CACHE_LINE_BYTES == 0
        skip = min(-into % CACHE_LINE_BYTES >> 3, count) if lined else 0
        step, run = (
            (1, self.run_function_past_caches)
            if lined and apart * len(out) >= LEAST_BYTES_PAST_CACHES
            else (CACHE_LINE_BYTES, self.run_function)
        )
        codes = np.empty(min(POSITIONS_PER_CALL, count), np.int64)
        places = *range(0, skip, step), *range(skip, count, POSITIONS_PER_CALL), count
        return not any(
            run(begin + 8 * a, into + 8 * a, _memory_address(codes), self._fixed_rows_address, b - a, apart >> 3)
            for a, b in pairwise(places)
        )

    @cached_property
    def _fixed_rows_address(self) -> int:
        return _memory_address(self.fixed)


def _memory_address(array: Array | Indices) -> int:
    return ctypes.addressof(ctypes.c_char.from_buffer(array.data))


_RUN_FUNCTION_TYPE = ctypes.CFUNCTYPE(ctypes.c_int64, *[ctypes.c_void_p] * 4, ctypes.c_int64, ctypes.c_int64)


@cache
def _compiled_run_function(text: str, past: bool = False) -> Callable[..., int]:
    """The compiled loop, its stores ``past`` the caches or not; compiled once for each structure, compiler and
    processor."""
    import llvmlite.binding as llvm

    llvm.initialize_native_target()
    llvm.initialize_native_asmprinter()
    target = llvm.Target.from_default_triple()
    processor = llvm.get_host_cpu_name()
    features = llvm.get_host_cpu_features().flatten()
    machine = target.create_target_machine(cpu=processor, features=features, opt=3)
    engine = llvm.create_mcjit_compiler(llvm.parse_assembly(""), machine)
    identity = (text, str(past), processor, features, target.triple, ".".join(map(str, llvm.llvm_version_info)))
    name = sha256("\0".join(identity).encode()).hexdigest()
    code = kept_code.kept_object_file(name)
    if code is None:
        kept_code.keep_object_file(name, code := _make_object_file(text, machine, past))
    engine.add_object_file(llvm.ObjectFileRef.from_data(code))
    engine.finalize_object()
    _LIVE_ENGINES.append(engine)
    return _RUN_FUNCTION_TYPE(engine.get_function_address("run"))


def _make_object_file(text: str, machine: Any, past: bool) -> bytes:
    """The object file of a text."""
    import llvmlite.binding as llvm

    parsed = llvm.parse_assembly(text)
    parsed.verify()
    options = llvm.create_pipeline_tuning_options(speed_level=3)
    options.loop_vectorization = True
    builder = llvm.create_pass_builder(machine, options)
    builder.getModulePassManager().run(parsed, builder)
    made: bytes = machine.emit_object(llvm.parse_assembly(module_storing_past_caches(str(parsed))) if past else parsed)
    return made


_LIVE_ENGINES: list[object] = []  # kept alive while their code runs
