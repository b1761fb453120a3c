"""The text of one fused loop, in LLVM's language, that evaluates a tape for every position.

The code is branchless, so that the compiler computes several positions at once.
"""

import re

from planes.batch.llvm_functions import Lines, arctangent, cosine, gap, literal, sine
from planes.batch.tape import TESTS, Tape

LONGEST = 2048
"""Largest number of positions in a block: a row of every input and output."""
ROOM = 900_000
"""Bytes of all rows together: more than the cache holds is slow, and needs new memory from the system each time."""
EXTRA = 8
"""The distance between rows is no power of two, otherwise all rows would compete for the same few cache lines."""


def row_of(count: int) -> int:
    """Number of positions in a block with so many rows."""
    row = LONGEST
    while row > LONGEST // 8 and 8 * count * (row + EXTRA) > ROOM:
        row //= 2
    return row


PAIRED = 500
"""Up to so many operations, positions are computed two vectors at a time, so that neither waits for a root of the
other. With more, registers run short and compiling takes twice as long (a whole six-link: 66 ns and 0.33 s; by twos 71
and 0.63)."""

ALONE = ", !llvm.access.group !2"  # rows do not overlap

INTRINSICS = {"sqrt": 1, "fabs": 1, "floor": 1, "copysign": 2, "fma": 3}


class LoopText:
    """The loop under construction: places of the tape to names in the loop."""

    def __init__(self, tape: Tape, names: dict[int, str], rough: frozenset[int]) -> None:
        self.tape, self.names, self.rough, self.lines = tape, names, rough, Lines()

    def name(self, place: int) -> str:
        """The name of a place in the loop, or the constant itself."""
        if place in self.names:
            return self.names[place]
        value = self.tape.values[place]
        return str(value).lower() if isinstance(value, bool) else literal(value)

    def write(self, place: int) -> None:
        """One operation."""
        op, args = self.tape.ops[place]
        if op not in ("const", "given"):
            fused = " reassoc nsz contract" if place in self.rough else " nsz contract"
            self.names[place] = self._line(op, [self.name(a) for a in args], args, fused)

    def at(self, begin: str, kind: str = "double") -> str:
        """The address of the position in a row."""
        return self.lines(f"getelementptr inbounds {kind}, ptr {begin}, i64 %i")

    def store(self, name: str, begin: str, kind: str = "double") -> None:
        """Store a number in its row."""
        pointer = self.at(begin, kind)
        self.lines.lines.append(f"  store {kind} {name}, ptr {pointer}, align 8{ALONE}")

    def _line(self, op: str, a: list[str], args: tuple[int, ...], fused: str) -> str:
        t = self.lines
        match op:
            case "add" | "sub" | "mul":
                return t.op("f" + op, a[0], a[1], fused)
            case "inv":
                return t.op("fdiv", literal(1.0), a[0])
            case "neg":
                return t(f"fneg double {a[0]}")
            case "abs" | "floor":
                return t.call({"abs": "llvm.fabs.f64", "floor": "llvm.floor.f64"}[op], a[0])
            case "sqrt":
                below = t(f"fcmp olt double {a[0]}, {literal(0.0)}")
                return t.call("llvm.sqrt.f64", t.select(below, literal(0.0), a[0]))
            case "hypot":
                return t.call("llvm.sqrt.f64", t.op("fadd", t.op("fmul", a[0], a[0]), t.op("fmul", a[1], a[1])))
            case "max" | "min":
                return t.select(t(f"fcmp {'ugt' if op == 'max' else 'ult'} double {a[0]}, {a[1]}"), a[0], a[1])
            case "sel":
                return t.select(*a)
            case "and" | "or":
                return t(f"{op} i1 {a[0]}, {a[1]}")
            case "not":
                return t(f"xor i1 {a[0]}, true")
            case "eq" if self.tape.ops[args[0]][0] in TESTS:
                return t(f"icmp eq i1 {a[0]}, {a[1]}")
            case "lt" | "le" | "eq":
                return t(f"fcmp o{op} double {a[0]}, {a[1]}")
        return t.call({"sin": "ksin", "cos": "kcos", "atan2": "katan2", "gap": "kgap"}[op], *a)


def module(
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
    head, names = Lines("c"), dict[int, str]()
    for k, place in enumerate(fixed):
        pointer = head(f"getelementptr inbounds double, ptr %fixed, i64 {k}")
        loaded = head(f"load double, ptr {pointer}, align 8")
        names[place] = head(f"fcmp une double {loaded}, {literal(0.0)}") if tape.ops[place][0] in TESTS else loaded
    begins = [_begin(head, "%rows", str(apart), k) for k in range(len(inputs))]
    rows: dict[int, list[str]] = {}
    for k, place in enumerate(outputs):
        rows.setdefault(place, []).append(_begin(head, "%out", "%stride", k))
    text = LoopText(tape, names, rough)
    for place, begin in zip(inputs, begins, strict=True):
        text.names[place] = text.lines(f"load double, ptr {text.at(begin)}, align 8{ALONE}")
    for place in order:
        if place not in text.names:
            text.write(place)
        for begin in rows.pop(place, ()):
            text.store(text.name(place), begin)
    for place, still in rows.items():
        for begin in still:
            text.store(text.name(place), begin)
    code = "0"
    for k in range(len(codes), 0, -1):
        code = text.lines.select(text.name(codes[k - 1]), code, str(k), "i64")
    text.store(code, "%codes", "i64")
    last = f"  %failed = or i64 %sofar, {code}", *CLOSE, _beside(2 if len(order) <= PAIRED else 1)
    return "\n".join([*_frame(), *head.lines, *OPEN, *text.lines.lines, *last])


def past_caches(optimised: str) -> str:
    """A module, optimised, whose full vectors are stored to memory past the caches; its rows must begin on whole cache
    lines."""
    widest = max(map(int, re.findall(r"store <(\d+) x double>", optimised)), default=1)
    stores = rf"(store <{widest} x double> .*, align )8"
    return re.sub(stores, rf"\g<1>{8 * widest}, !nontemporal !{{i32 1}}", optimised)


def _begin(t: Lines, base: str, stride: str, k: int) -> str:
    return t(f"getelementptr inbounds double, ptr {base}, i64 {t(f'mul nuw nsw i64 {stride}, {k}')}")


def _beside(vectors: int) -> str:
    return f'!4 = !{{!"llvm.loop.interleave.count", i32 {vectors}}}'


def _frame() -> list[str]:
    declared = [
        f"declare double @llvm.{name}.f64({', '.join(['double'] * count)})" for name, count in INTRINSICS.items()
    ]
    pointers = ", ".join(f"ptr noalias %{name}" for name in ("rows", "out", "codes", "fixed"))
    start = f"define i64 @run({pointers}, i64 %n, i64 %stride) #0 {{\nentry:"
    return [*declared, sine(), cosine(), arctangent(), gap(), start]


OPEN = (
    "  br label %loop\nloop:",
    "  %i = phi i64 [ 0, %entry ], [ %next, %loop ]",
    "  %sofar = phi i64 [ 0, %entry ], [ %failed, %loop ]",
)
CLOSE = (
    "  %next = add nuw nsw i64 %i, 1",
    "  %more = icmp slt i64 %next, %n",
    "  br i1 %more, label %loop, label %done, !llvm.loop !0",
    "done:\n  fence seq_cst\n  ret i64 %failed\n}",  # stores past the caches are over before another thread reads
    "!0 = distinct !{!0, !1, !3, !4}",
    "!2 = distinct !{}",
    '!3 = !{!"llvm.loop.parallel_accesses", !2}',
    '!1 = !{!"llvm.loop.vectorize.enable", i1 true}',
    'attributes #0 = { "prefer-vector-width"="512" }',  # the full vector width of the machine
)
