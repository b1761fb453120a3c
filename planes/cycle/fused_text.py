"""The text of one fused loop, in LLVM's own language, that goes through a tape for every position.

Everything is branchless, with sines and arctangents as polynomials, so that the compiler takes several positions at
once. Coefficients are those of fdlibm (Sun Microsystems, 1993), correct to within one unit of the last place.
"""

from __future__ import annotations

import struct

from planes.cycle.tape import TESTS, Tape

ROW = 2048
"""Positions worked at once: a row of every input and output, all of them small enough for the cache."""
STRIDE = ROW + 8
"""From row to row in memory: no power of two, or all rows would fight for the same few lines of the cache."""

SIN = (-1.66666666666666324348e-01, 8.33333333332248946124e-03, -1.98412698298579493134e-04,
       2.75573137070700676789e-06, -2.50507602534068634195e-08, 1.58969099521155010221e-10)  # fmt: skip
COS = (4.16666666666666019037e-02, -1.38888888888741095749e-03, 2.48015872894767294178e-05,
       -2.75573143513906633035e-07, 2.08757232129817482790e-09, -1.13596475577881948265e-11)  # fmt: skip
ATAN = (3.33333333333329318027e-01, -1.99999999998764832476e-01, 1.42857142725034663711e-01,
        -1.11111104054623557880e-01, 9.09088713343650656196e-02, -7.69187620504482999495e-02,
        6.66107313738753120669e-02, -5.83357013379057348645e-02, 4.97687799461593236017e-02,
        -3.65315727442169155270e-02, 1.62858201153657823623e-02)  # fmt: skip
HALF, QUARTER, RIGHT = 4.63647609000806093515e-01, 7.85398163397448278999e-01, 1.5707963267948966
HALF_LOW, QUARTER_LOW, RIGHT_LOW = 2.26987774529616870924e-17, 3.06161699786838301793e-17, 6.123233995736766e-17


def literal(x: float) -> str:
    """A number as LLVM writes it: its bits."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', x))[0]:016X}"


class _Lines:
    """Lines of one function, each naming its result."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def __call__(self, text: str) -> str:
        self.lines.append(f"  %v{len(self.lines)} = {text}")
        return f"%v{len(self.lines) - 1}"

    def op(self, name: str, a: str, b: str, flags: str = "") -> str:
        return self(f"{name}{flags} double {a}, {b}")

    def horner(self, z: str, coefficients: tuple[float, ...]) -> str:
        """A polynomial in z."""
        total = literal(coefficients[-1])
        for c in reversed(coefficients[:-1]):
            total = self.op("fadd", self.op("fmul", total, z, " contract"), literal(c), " contract")
        return total

    def select(self, test: str, a: str, b: str, kind: str = "double") -> str:
        return self(f"select i1 {test}, {kind} {a}, {kind} {b}")

    def call(self, name: str, *args: str) -> str:
        return self(f"call double @{name}({', '.join(f'double {a}' for a in args)})")


def _function(name: str, args: str, lines: _Lines, result: str) -> str:
    head = f"define internal double @{name}({args}) alwaysinline {{"
    return "\n".join([head, *lines.lines, f"  ret double {result}", "}"])


def _sine() -> str:
    t = _Lines()
    z = t.op("fmul", "%x", "%x")
    rest = t.op("fmul", t.op("fmul", z, "%x"), t.horner(z, SIN), " contract")
    return _function("ksin", "double %x", t, t.op("fadd", "%x", rest, " contract"))


def _cosine() -> str:
    t = _Lines()
    z = t.op("fmul", "%x", "%x")
    half = t.op("fmul", z, literal(0.5))
    rest = t.op("fmul", t.op("fmul", z, z), t.horner(z, COS))
    whole = t.op("fsub", literal(1.0), half)
    lost = t.op("fsub", t.op("fsub", literal(1.0), whole), half)
    return _function("kcos", "double %x", t, t.op("fadd", whole, t.op("fadd", lost, rest)))


def _arctangent() -> str:
    t = _Lines()
    x, y = t.call("llvm.fabs.f64", "%x"), t.call("llvm.fabs.f64", "%y")
    steep = t(f"fcmp ogt double {y}, {x}")
    low, high = t.select(steep, x, y), t.select(steep, y, x)
    high = t.select(t(f"fcmp oeq double {high}, {literal(0.0)}"), literal(1.0), high)
    small = t(f"fcmp olt double {low}, {t.op('fmul', high, literal(7 / 16))}")
    middle = t(f"fcmp olt double {low}, {t.op('fmul', high, literal(11 / 16))}")
    two_low, two_high = t.op("fadd", low, low), t.op("fadd", high, high)
    top = t.select(small, low, t.select(middle, t.op("fsub", two_low, high), t.op("fsub", low, high)))
    under = t.select(small, high, t.select(middle, t.op("fadd", two_high, low), t.op("fadd", low, high)))
    a = t.op("fdiv", top, under)
    z = t.op("fmul", a, a)
    lost = t.op("fmul", a, t.op("fmul", z, t.horner(z, ATAN)))
    base = t.select(small, literal(0.0), t.select(middle, literal(HALF), literal(QUARTER)))
    fine = t.select(small, literal(0.0), t.select(middle, literal(HALF_LOW), literal(QUARTER_LOW)))
    angle = t.op("fsub", base, t.op("fsub", t.op("fsub", lost, fine), a))
    angle = t.select(steep, _less(t, RIGHT, RIGHT_LOW, angle), angle)
    back = t(f"fcmp olt double %x, {literal(0.0)}")
    angle = t.select(back, _less(t, 2 * RIGHT, 2 * RIGHT_LOW, angle), angle)
    return _function("katan2", "double %y, double %x", t, t.call("llvm.copysign.f64", angle, "%y"))


def _less(t: _Lines, high: float, low: float, angle: str) -> str:
    return t.op("fsub", literal(high), t.op("fsub", angle, literal(low)))


INTRINSICS = {"sqrt": 1, "fabs": 1, "floor": 1, "copysign": 2}


class Text:
    """The loop being written: places of the tape to names in the loop."""

    def __init__(self, tape: Tape, names: dict[int, str]) -> None:
        self.tape, self.names, self.t = tape, names, _Lines()

    def name(self, place: int) -> str:
        """What stands for a place: its name in the loop, or the constant itself."""
        if place in self.names:
            return self.names[place]
        value = self.tape.values[place]
        return str(value).lower() if isinstance(value, bool) else literal(value)

    def write(self, place: int) -> None:
        """One operation."""
        op, args = self.tape.ops[place]
        if op not in ("const", "given"):
            self.names[place] = self._line(op, [self.name(a) for a in args], args)

    def _line(self, op: str, a: list[str], args: tuple[int, ...]) -> str:
        t = self.t
        match op:
            case "add" | "sub" | "mul":
                return t.op("f" + op, a[0], a[1])
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
        return t.call({"sin": "ksin", "cos": "kcos", "atan2": "katan2"}[op], *a)


def _row(t: _Lines, row: int) -> str:
    index = t(f"add nuw nsw i64 %i, {row * STRIDE}")
    return t(f"getelementptr inbounds double, ptr %rows, i64 {index}")


def module(
    tape: Tape, order: list[int], inputs: list[int], fixed: list[int], outputs: list[int], codes: list[int]
) -> str:
    """The module of a function run(rows, fixed, n): rows of ``inputs`` first, then it fills rows of ``outputs``, and
    last the number of the first of the conditions ``codes`` that does not hold (0: all hold); returns the sum of these.
    """
    head = _Lines()
    names = {}
    for k, place in enumerate(fixed):
        pointer = head(f"getelementptr inbounds double, ptr %fixed, i64 {k}")
        loaded = head(f"load double, ptr {pointer}, align 8")
        names[place] = head(f"fcmp une double {loaded}, {literal(0.0)}") if tape.ops[place][0] in TESTS else loaded
    text = Text(tape, {place: name.replace("%v", "%c") for place, name in names.items()})
    for k, place in enumerate(inputs):
        text.names[place] = text.t(f"load double, ptr {_row(text.t, k)}, align 8")
    for place in order:
        if place not in text.names:
            text.write(place)
    code = literal(0.0)
    for k in range(len(codes), 0, -1):
        code = text.t.select(text.name(codes[k - 1]), code, literal(float(k)))
    stores = []
    for k, name in enumerate([*map(text.name, outputs), code], len(inputs)):
        stores.append(f"  store double {name}, ptr {_row(text.t, k)}, align 8")
    stores.append(f"  %sum = fadd reassoc double %sofar, {code}")
    opening = [line.replace("%v", "%c") for line in head.lines]
    return "\n".join([*_frame(), *opening, *OPEN, *text.t.lines, *stores, *CLOSE])


def _frame() -> list[str]:
    declared = [
        f"declare double @llvm.{name}.f64({', '.join(['double'] * count)})" for name, count in INTRINSICS.items()
    ]
    start = "define double @run(ptr noalias %rows, ptr noalias %fixed, i64 %n) {\nentry:"
    return [*declared, _sine(), _cosine(), _arctangent(), start]


OPEN = (
    "  br label %loop\nloop:",
    "  %i = phi i64 [ 0, %entry ], [ %next, %loop ]",
    f"  %sofar = phi double [ {literal(0.0)}, %entry ], [ %sum, %loop ]",
)
CLOSE = (
    "  %next = add nuw nsw i64 %i, 1",
    "  %more = icmp slt i64 %next, %n",
    "  br i1 %more, label %loop, label %done, !llvm.loop !0",
    "done:\n  ret double %sum\n}",
    "!0 = distinct !{!0, !1}",
    '!1 = !{!"llvm.loop.vectorize.enable", i1 true}',
)
