"""Scenes close to the limits of a mechanism or of its numbers: families with their limit in closed form.

Also the error that a number may have without a warning.
"""

from __future__ import annotations

import math
import random
from collections import Counter
from collections.abc import Callable
from typing import Any
from unittest.mock import patch

import numpy as np

from planes.accuracy.digits import Digits
from planes.batch import compiled
from planes.batch.cycle import Cycle
from planes.drafting.drawing import draw_program
from planes.drafting.steps import tracks
from planes.scene import loads
from planes.solving import plans_and_requested_results, solve
from planes.words.errors import PlanFailure
from tests.helpers.mechanisms import make, to_yaml

WRONG = 1e-3  # of the largest number of its kind
DIGITS = 60
RRR = """planes: 1
frame: {{points: {{A: [0, 0], D: [{d!r}, 0]}}}}
links:
  1: {{points: {{A: 0, B: {r!r}}}}}
  2: {{points: {{B: 0, C: {rod!r}}}}}
  3: {{points: {{D: 0, C: {q!r}}}}}
assembly: {{C: left}}
drive: {{link: 1, phi: 0, omega: 10, epsilon: 3}}
"""
RRP = """planes: 1
frame: {{points: {{A: [0, 0]}}, guides: {{x: {{y: {e!r}}}}}}}
links:
  1: {{points: {{A: 0, B: {r!r}}}}}
  2: {{points: {{B: 0, C: {rod!r}}}}}
  3: {{points: {{C: 0}}, slides: x}}
assembly: {{C: ahead}}
drive: {{link: 1, phi: 0, omega: 10, epsilon: 3}}
"""
PRP = """planes: 1
frame: {{points: {{A: [0, 0]}}, guides: {{x: {{y: {e!r}}}}}}}
links:
  1: {{points: {{A: 0}}, guides: {{g: {{through: [0, {r!r}], angle: 0}}}}}}
  2: {{points: {{C: 0}}, slides: g}}
  3: {{points: {{C: 0}}, slides: x}}
drive: {{link: 1, phi: 0, omega: 10, epsilon: 3}}
"""
RPR = """planes: 1
frame: {{points: {{O: [0, 0], D: [{d!r}, 0]}}}}
links:
  1: {{points: {{O: 0, A: {r!r}}}}}
  2: {{points: {{A: 0}}, slides: g}}
  3: {{points: {{D: 0, C: 0.5}}, guides: {{g: {{through: D, angle: 0}}}}}}
assembly: {{g: ahead}}
drive: {{link: 1, phi: 0, omega: 10, epsilon: 3}}
"""


def _four_bar_limit(rng: random.Random) -> tuple[str, float]:
    while True:
        r, rod, q, d = (rng.uniform(0.1, 0.9) for _ in range(4))
        reach = rng.choice((rod + q, abs(rod - q)))
        cosine = (r * r + d * d - reach * reach) / (2 * r * d)
        if abs(cosine) < 0.99:
            return RRR.format(r=r, rod=rod, q=q, d=d), math.degrees(math.acos(cosine))


def _change_point(rng: random.Random) -> tuple[str, float]:
    r, d = rng.uniform(0.1, 0.4), rng.uniform(0.5, 0.9)
    return RRR.format(r=r, rod=d, q=r, d=d), rng.choice((0.0, 180.0))


def _kite(rng: random.Random) -> tuple[str, float]:
    r, rod = rng.uniform(0.1, 0.4), rng.uniform(0.5, 0.9)
    return RRR.format(r=r, rod=rod, q=rod, d=r), 0.0


def _crank_limit(rng: random.Random) -> tuple[str, float]:
    while True:
        r, rod, e = rng.uniform(0.3, 0.9), rng.uniform(0.1, 0.5), rng.uniform(-0.5, 0.5)
        sine = (e + rng.choice((rod, -rod))) / r
        if abs(sine) < 0.99:
            return RRP.format(r=r, rod=rod, e=e), math.degrees(math.asin(sine))


def _crank_fold(rng: random.Random) -> tuple[str, float]:
    r = rng.uniform(0.1, 0.9)
    return RRP.format(r=r, rod=r, e=0.0), rng.choice((90.0, -90.0))


def _parallel_guides(rng: random.Random) -> tuple[str, float]:
    return PRP.format(r=rng.uniform(0.1, 0.5), e=rng.uniform(0.6, 0.9)), rng.choice((0.0, 180.0))


def _slot_through(rng: random.Random) -> tuple[str, float]:
    r = rng.uniform(0.1, 0.9)
    return RPR.format(r=r, d=r), 0.0


def _slot_by(rng: random.Random) -> tuple[str, float]:
    r = rng.uniform(0.1, 0.9)
    return RPR.format(r=r, d=r * (1 + 10.0 ** rng.uniform(-12, -2))), 0.0


def dead_point(rng: random.Random, kind: str) -> tuple[str, float]:
    """A group of a higher class, and an end of the range of its assembly."""
    while True:
        text = to_yaml(make(rng, [kind], sliding=False).scene)
        given = plans_and_requested_results(loads(text))[0].given
        middle, half = (next(v for n, v in given.items() if n.startswith(f"{what}_")) for what in ("middle", "half"))
        if half < 179.0:
            return text, float(middle + rng.choice((1, -1)) * half)


def _three(rng: random.Random) -> tuple[str, float]:
    return dead_point(rng, "-".join(rng.choices(("RR", "PR", "RP"), k=3)))


def _four(rng: random.Random) -> tuple[str, float]:
    return dead_point(rng, " ".join(["IV", rng.choice(("RR", "RP")), *rng.choices(("RR", "PR", "RP"), k=2)]))


HIGHER: dict[str, Callable[[random.Random], tuple[str, float]]] = {"class III": _three, "class IV": _four}
FAMILIES: dict[str, Callable[[random.Random], tuple[str, float]]] = {
    "four-bar limit": _four_bar_limit,
    "change point": _change_point,
    "kite": _kite,
    "crank limit": _crank_limit,
    "crank fold": _crank_fold,
    "parallel guides": _parallel_guides,
    "slot through its pivot": _slot_through,
    "slot by its pivot": _slot_by,
}


def case(family: str, rng: random.Random, count: int) -> tuple[str, list[float]]:
    """A scene, and values of its drive 1e-15…0.1 rad on either side of its limit."""
    text, at = {**FAMILIES, **HIGHER}[family](rng)
    return text, [at + rng.choice((1, -1)) * math.degrees(10.0 ** rng.uniform(-15, -1)) for _ in range(count)]


def truth(c: Cycle, value: float) -> Any:
    """The columns at many digits; None without a mechanism."""
    try:
        with patch.object(
            tracks, "STEPS_BEFORE_ROUNDING", DIGITS
        ):  # where two assemblies meet, Newton's iteration converges slowly
            drawing = draw_program(c.program, {**c.given, c.plans.drive_given_name: value}, Digits(DIGITS))
    except PlanFailure:
        return None
    return np.array([float(x.read_from_drawing(drawing.things, drawing.tool.ar)) for x in c.columns])


def worst(c: Cycle, row: Any, true: Any) -> float:
    """The largest error, relative to the largest number of its kind; omitted numbers are not wrong."""
    found = 0.0
    for unit in {x.unit for x in c.columns}:
        rows = np.array([x.unit == unit for x in c.columns])
        error = np.abs(row[rows] - true[rows])
        if unit == "°":
            error, size = np.minimum(error, 360.0 - error), 180.0
        else:
            size = np.abs(true[rows]).max()
        error = error[~np.isnan(error)]
        found = max(found, float(error.max(initial=0.0)) / (size or 1.0))
    return found


def walk(family: str, seed: int, count: int) -> Counter[str]:
    """Counts positions of one scene: without a mechanism, rejected though there is one, numbers given without one.

    Also wrong results of ``solve`` without a warning, and wrong ones in a table (by arrays, compiled).
    """
    text, values = case(family, random.Random(f"{family}{seed}"), count)
    scene = loads(text)
    c = Cycle(plans_and_requested_results(scene)[0])
    ways = {"arrays": False, "compiled": True} if compiled.is_compiler_available() and seed == 0 else {"arrays": False}
    tables = {way: next(c.blocks(values, fast=fast)) for way, fast in ways.items()}
    tally, cycles = Counter[str](positions=count), {id(c.plans): c}
    for k, value in enumerate(values):
        true, solved = truth(c, value), solve(scene, [value])
        if true is None:
            tally.update(absent=1, invented=bool(solved.positions) or any(t.codes[k] == 0 for t in tables.values()))
            continue
        tally.update(refused=not solved.positions)
        for p in solved.positions:
            own = cycles.setdefault(id(p.plans), Cycle(p.plans))  # leads that lean there delegate to others
            found = {x.name: x.read_from_drawing(p.drawing.things, p.drawing.tool.ar) for x in own.columns}
            row = np.array([found[x.name] for x in c.columns], float)
            wrong = bool(worst(c, row, true) > WRONG)
            tally.update(wrong=wrong, unsaid=wrong and not p.results["warnings"], warned=bool(p.results["warnings"]))
        for way, block in tables.items():
            masked = np.isnan(block.table[:, k]) & ~np.isnan(true)
            tally.update(
                {
                    f"{way} wrong": worst(c, block.table[:, k], true) > WRONG,
                    f"{way} masked": bool(masked.any()),
                    f"{way} numbers": block.table.shape[0],
                    f"{way} left out": int(masked.sum()),
                }
            )
    return tally
