"""Where lines meet: whether a place is on a line, where two cross, which line goes on at the end of a vector."""

from collections.abc import Sequence

from planes.check.vision.strokes.line_fitting import Fitted
from planes.geometry.arrays import Booleans, Complexes

BESIDE_MM, ASLANT = 0.9, 0.125  # how far beside a line its vector may run, and how much askew to it
END_MM, GOAL_MM = 1.5, 0.2  # a line that goes on has so much left; how nearly it is told where a head is looked for


def on(line: Fitted, z: complex, reach: float = 0.5, beyond: float = 0.5) -> bool:
    """Whether a place is on a line."""
    s, off = line.local(z)
    return abs(off) < reach and line.low - beyond < s < line.high + beyond


def held(line: Fitted, places: Complexes, reach: float = 0.5) -> Booleans:
    """Which of some places are on a line, or so near it."""
    p = (places - line.origin) * line.along.conjugate()
    upon: Booleans = (
        (abs(p.imag - line.bow(p.real)) < reach) & (line.low - reach < p.real) & (p.real < line.high + reach)
    )
    return upon


def crossing(one: Fitted, two: Fitted) -> complex | None:
    """Where two lines cross; None where they are nearly parallel."""
    s, r = (one.low + one.high) / 2, (two.low + two.high) / 2
    for _ in range(3):
        a, u, b, w = one.at(s), one.direction(s), two.at(r), two.direction(r)
        turn = (u.conjugate() * w).imag
        if abs(turn) < 0.06:
            return None
        z = complex(a + u * ((b - a).conjugate() * w).imag / turn)
        s = min(max(one.local(z)[0], one.low - 3), one.high + 3)
        r = min(max(two.local(z)[0], two.low - 3), two.high + 3)
    return z


def line_on_to(lines: Sequence[Fitted], start: complex, end: complex) -> tuple[Fitted, float, int] | None:
    """The line along which a vector from ``start`` leads that goes on at its ``end``; where on it that is (to a fifth
    of a millimetre, towards the vector's tip), and whether the vector runs along it or against it."""
    way = (end - start) / abs(end - start)
    near = [x for x in lines if abs((x.along * way.conjugate()).imag) < ASLANT and abs(x.local(end)[1]) < BESIDE_MM]
    line = min(near, key=lambda x: abs(x.local(end)[1]), default=None)
    if line is None or not line.low + END_MM < line.local(end)[0] < line.high - END_MM:
        return None
    sign = 1 if (line.along * way.conjugate()).real > 0 else -1
    return line, round(sign * line.local(end)[0] / GOAL_MM) * GOAL_MM, sign
