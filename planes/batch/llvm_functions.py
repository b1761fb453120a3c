"""Functions that one fused loop calls, in LLVM's language: sines, arctangents, the gap between two circles.

The code is branchless, with sines and arctangents as polynomials, so that the compiler computes several positions at
once. Coefficients are those of fdlibm (Sun Microsystems, 1993), correct to within one unit of the last place.
"""

import struct

from planes.geometry.arithmetic import EPS

SIN = (
    -1.66666666666666324348e-01,
    8.33333333332248946124e-03,
    -1.98412698298579493134e-04,
    2.75573137070700676789e-06,
    -2.50507602534068634195e-08,
    1.58969099521155010221e-10,
)
COS = (
    4.16666666666666019037e-02,
    -1.38888888888741095749e-03,
    2.48015872894767294178e-05,
    -2.75573143513906633035e-07,
    2.08757232129817482790e-09,
    -1.13596475577881948265e-11,
)
ATAN = (
    3.33333333333329318027e-01,
    -1.99999999998764832476e-01,
    1.42857142725034663711e-01,
    -1.11111104054623557880e-01,
    9.09088713343650656196e-02,
    -7.69187620504482999495e-02,
    6.66107313738753120669e-02,
    -5.83357013379057348645e-02,
    4.97687799461593236017e-02,
    -3.65315727442169155270e-02,
    1.62858201153657823623e-02,
)
HALF, QUARTER, RIGHT = 4.63647609000806093515e-01, 7.85398163397448278999e-01, 1.5707963267948966
HALF_LOW, QUARTER_LOW, RIGHT_LOW = 2.26987774529616870924e-17, 3.06161699786838301793e-17, 6.123233995736766e-17


def literal(x: float) -> str:
    """The bits of a number, as in LLVM's text."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', x))[0]:016X}"


class Lines:
    """Lines of one function, each with its result named by a letter and a number."""

    def __init__(self, letter: str = "v") -> None:
        self.letter, self.lines = letter, list[str]()

    def __call__(self, text: str) -> str:
        name = f"%{self.letter}{len(self.lines)}"
        self.lines.append(f"  {name} = {text}")
        return name

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


def _function(name: str, args: str, lines: Lines, result: str) -> str:
    head = f"define internal double @{name}({args}) alwaysinline {{"
    return "\n".join([head, *lines.lines, f"  ret double {result}", "}"])


def sine() -> str:
    t = Lines()
    z = t.op("fmul", "%x", "%x")
    rest = t.op("fmul", t.op("fmul", z, "%x"), t.horner(z, SIN), " contract")
    return _function("ksin", "double %x", t, t.op("fadd", "%x", rest, " contract"))


def cosine() -> str:
    t = Lines()
    z = t.op("fmul", "%x", "%x")
    half = t.op("fmul", z, literal(0.5))
    rest = t.op("fmul", t.op("fmul", z, z), t.horner(z, COS))
    rounded = t.op("fsub", literal(1.0), half)
    lost = t.op("fsub", t.op("fsub", literal(1.0), rounded), half)
    return _function("kcos", "double %x", t, t.op("fadd", rounded, t.op("fadd", lost, rest)))


def arctangent() -> str:
    t = Lines()
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


def gap() -> str:
    """``error_free.gap``, with the rounding errors of products by one fused operation: (r + s)² less the distance's
    square, two parts of each, so that gaps of the same places share the latter."""
    t = Lines()
    names = ("cx", "cy", "dx", "dy", "r", "s")
    x, y = (_squared(t, f"%d{axis}", f"%c{axis}", "fsub") for axis in "xy")
    radii = _squared(t, "%r", "%s", "fadd")
    difference, part = _apart(t, x[0], t(f"fneg double {y[0]}"))
    lost = t.op("fadd", part, t.op("fadd", x[1], y[1]))
    left = t.op("fadd", t.op("fsub", radii[0], difference), t.op("fsub", radii[1], lost))
    size, *more = (t.call("llvm.fabs.f64", f"%{name}") for name in names)
    for one in more:
        size = t.op("fadd", size, one, " reassoc contract")
    doubt = t.op("fmul", size, t.op("fmul", t.call("llvm.fabs.f64", t.op("fadd", "%r", "%s")), literal(EPS)))
    sure = t(f"fcmp ogt double {t.call('llvm.fabs.f64', left)}, {doubt}")
    kept = t.select(sure, left, t.op("fmul", left, literal(0.0)))
    return _function("kgap", ", ".join(f"double %{name}" for name in names), t, kept)


def _squared(t: Lines, a: str, b: str, op: str) -> tuple[str, str]:
    """The square of a sum or difference, with its rounding error and that of the sum."""
    total, lost = _apart(t, a, b) if op == "fsub" else _apart(t, a, t(f"fneg double {b}"))
    square = t.op("fmul", total, total)
    twice = t.op("fadd", lost, lost)
    return square, t.call(
        "llvm.fma.f64", total, twice, t.call("llvm.fma.f64", total, total, t(f"fneg double {square}"))
    )


def _apart(t: Lines, a: str, b: str) -> tuple[str, str]:
    """a - b and its rounding error."""
    total = t.op("fsub", a, b)
    part = t.op("fsub", total, a)
    return total, t.op("fsub", t.op("fsub", a, t.op("fsub", total, part)), t.op("fadd", b, part))


def _less(t: Lines, high: float, low: float, angle: str) -> str:
    return t.op("fsub", literal(high), t.op("fsub", angle, literal(low)))
