"""The text of one fused loop, in LLVM's language, that evaluates a tape for every position.

The code is branchless, so that the compiler computes several positions at once.
"""

import re
import struct
from collections import defaultdict
from functools import cache
from pathlib import Path
from string import Template

from planes.batch.tape import TEST_OPERATIONS, Tape
from planes.words.frozen import field, frozen

LONGEST_ROW_POSITIONS = 2048
"""Largest number of positions in a block: a row of every input and output."""
MOST_ROWS_BYTES = 900_000
"""Bytes of all rows together: more than the cache holds is slow, and needs new memory from the system each time."""
ROW_GAP_POSITIONS = 8
"""The distance between rows is no power of two, otherwise all rows would compete for the same few cache lines."""


def positions_per_row(count: int) -> int:
    """Number of positions in a block with so many rows."""
    row = LONGEST_ROW_POSITIONS
    while row > LONGEST_ROW_POSITIONS // 8 and 8 * count * (row + ROW_GAP_POSITIONS) > MOST_ROWS_BYTES:
        row //= 2
    return row


MOST_PAIRED_OPERATIONS = 500
"""Up to so many operations, positions are computed two vectors at a time, so that neither waits for a root of the
other. With more, registers run short and compiling takes twice as long (a whole six-link: 66 ns and 0.33 s; by twos 71
and 0.63)."""

NO_OVERLAP_METADATA = ", !llvm.access.group !2"  # rows do not overlap

LLVM_OPERATIONS = {
    "add": "fadd {fused} double {0}, {1}",
    "sub": "fsub {fused} double {0}, {1}",
    "mul": "fmul {fused} double {0}, {1}",
    "inv": "fdiv double 1.0, {0}",
    "neg": "fneg double {0}",
    "abs": "call double @llvm.fabs.f64(double {0})",
    "floor": "call double @llvm.floor.f64(double {0})",
    "gap": "call double @kgap(double {0}, double {1}, double {2}, double {3}, double {4}, double {5})",
    "sel": "select i1 {0}, double {1}, double {2}",
    "and": "and i1 {0}, {1}",
    "or": "or i1 {0}, {1}",
    "not": "xor i1 {0}, true",
    "same": "icmp eq i1 {0}, {1}",
    "lt": "fcmp olt double {0}, {1}",
    "le": "fcmp ole double {0}, {1}",
    "eq": "fcmp oeq double {0}, {1}",
    **dict.fromkeys(("sqrt", "sin", "cos"), "call double @k{op}(double {0})"),
    **dict.fromkeys(("hypot", "atan2", "max", "min"), "call double @k{op}(double {0}, double {1})"),
}
"""The operations of a tape; @k… are functions of loop.ll."""


def llvm_number(x: float) -> str:
    """The bits of a number, as in LLVM's text."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', x))[0]:016X}"


class Lines:
    """Lines of code, each with its result named by a letter and a number."""

    def __init__(self, letter: str = "v") -> None:
        self.letter = letter
        self.lines = list[str]()

    def __call__(self, text: str) -> str:
        name = f"%{self.letter}{len(self.lines)}"
        self.lines.append(f"  {name} = {text}")
        return name


@frozen
class LoopText:
    """The loop under construction: places of the tape to names in the loop."""

    tape: Tape
    names: dict[int, str]
    rough: frozenset[int]
    lines: Lines = field(default_factory=Lines)

    def value_name(self, place: int) -> str:
        """The name of a place in the loop, or the constant itself."""
        if place in self.names:
            return self.names[place]
        value = self.tape.values[place]
        if isinstance(value, bool):
            return str(value).lower()
        return llvm_number(value)

    def write_operation(self, place: int) -> None:
        """One operation."""
        op, args = self.tape.ops[place]
        if op in ("const", "given"):
            return
        op = "same" if op == "eq" and self.tape.ops[args[0]][0] in TEST_OPERATIONS else op
        fused = "reassoc nsz contract" if place in self.rough else "nsz contract"
        text = LLVM_OPERATIONS[op].format(*map(self.value_name, args), op=op, fused=fused)
        self.names[place] = self.lines(text)

    def address_in_row(self, begin: str, kind: str = "double") -> str:
        """The address of the position in a row."""
        return self.lines(f"getelementptr inbounds {kind}, ptr {begin}, i64 %i")

    def store_in_row(self, name: str, begin: str, kind: str = "double") -> None:
        """Store a number in its row."""
        pointer = self.address_in_row(begin, kind)
        self.lines.lines.append(f"  store {kind} {name}, ptr {pointer}, align 8{NO_OVERLAP_METADATA}")


def llvm_module_text(
    tape: Tape,
    order: list[int],
    inputs: list[int],
    fixed: list[int],
    outputs: list[int],
    codes: list[int],
    rough: frozenset[int],
    apart: int,
) -> str:
    """The module with a function run(rows, out, codes, fixed, n, stride). It reads ``rows`` of ``inputs`` at a distance
    of ``apart``, fills rows of ``outputs``, ``stride`` numbers apart, and writes to ``codes`` the number of the first
    condition that fails (0: all hold); it returns 0 if all of these are 0. The places ``rough`` may be rounded as suits
    the machine."""
    head = Lines("c")
    names = {}
    for k, place in enumerate(fixed):
        pointer = head(f"getelementptr inbounds double, ptr %fixed, i64 {k}")
        loaded = head(f"load double, ptr {pointer}, align 8")
        names[place] = (
            head(f"fcmp une double {loaded}, {llvm_number(0.0)}") if tape.ops[place][0] in TEST_OPERATIONS else loaded
        )
    begins = [_row_begin(head, "%rows", str(apart), k) for k in range(len(inputs))]
    rows = defaultdict(list)
    for k, place in enumerate(outputs):
        rows[place].append(_row_begin(head, "%out", "%stride", k))
    text = LoopText(tape, names, rough)
    for place, begin in zip(inputs, begins, strict=True):
        text.names[place] = text.lines(f"load double, ptr {text.address_in_row(begin)}, align 8{NO_OVERLAP_METADATA}")
    for place in order:
        if place not in text.names:
            text.write_operation(place)
        for begin in rows.pop(place, ()):
            text.store_in_row(text.value_name(place), begin)
    for place, still in rows.items():
        for begin in still:
            text.store_in_row(text.value_name(place), begin)
    code = "0"
    for k in range(len(codes), 0, -1):
        code = text.lines(f"select i1 {text.value_name(codes[k - 1])}, i64 {code}, i64 {k}")
    text.store_in_row(code, "%codes", "i64")
    fixed_text, operations = ("\n".join(part.lines) for part in (head, text.lines))
    vectors = 2 if len(order) <= MOST_PAIRED_OPERATIONS else 1
    return _loop_template().substitute(fixed=fixed_text, operations=operations, code=code, vectors=vectors)


def module_storing_past_caches(optimised: str) -> str:
    """A module, optimised, whose full vectors are stored to memory past the caches; its rows must begin on whole cache
    lines."""
    widest = max(map(int, re.findall(r"store <(\d+) x double>", optimised)), default=1)
    stores = rf"(store <{widest} x double> .*, align )8"
    return re.sub(stores, rf"\g<1>{8 * widest}, !nontemporal !{{i32 1}}", optimised)


def _row_begin(t: Lines, base: str, stride: str, k: int) -> str:
    return t(f"getelementptr inbounds double, ptr {base}, i64 {t(f'mul nuw nsw i64 {stride}, {k}')}")


@cache
def _loop_template() -> Template:
    return Template(Path(__file__).with_name("loop.ll").read_text("utf-8"))
