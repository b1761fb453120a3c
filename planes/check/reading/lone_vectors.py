"""Vectors of a force plan told one by one by their arrowheads and names, wherever on the plan they lie.

A sheet may show more than the bare polygon: whole reactions beside their parts, inner reactions, lines of action; and
forces of one line are drawn side by side. Then lines do not make up one chain, yet each arrow is a vector.
"""

import math
from collections.abc import Mapping, Sequence

from planes.check.grading.paper import ReadMark
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.chains import FAR_WORD, NEAR_MM, NO_WORD, TOO_FAR, UNLIKE, named_best, true_vectors
from planes.check.reading.strokes import SHORT_MM, ReadDrawing, headed
from planes.check.reading.written import Stroke
from planes.drafting.drawing import run
from planes.words.names import POLE, at, end_of

SHARE = 0.1  # a vector off by more of its length is not the true one
REVERSED = 0.25  # how unlike a vector is its opposite
NAMED = 2.0  # what unlikeness counts for where names are written: they stand beside their own arrows
ALIKE, LEAST = 1.03, 0.2  # sizes worth trying differ by so much; the smallest, to what is stated
OTHER = 3.0  # what it costs for the size to be other than it seems
LED = 4.0  # how much farther another vector is from a name with a line to its own
HEADLESS_MM = 2.0  # a shorter vector may be drawn without a head

Costs = list[dict[str, float]]


def lone_vectors(sketch: ReadDrawing, bench: PreparedPlan) -> tuple[list[ReadMark], bool]:
    """The plan's vectors, each as a row of its own, and whether nothing can have been overlooked."""
    arrows, sides = arrows_of(sketch), true_vectors(bench)
    bare = [s for s in sketch.strokes if abs(s[1] - s[0]) < HEADLESS_MM and s not in arrows and s[::-1] not in arrows]
    named = _named([(s,) for s in arrows] + [(s, s[::-1]) for s in bare], sketch, bench, {**others(bench), **sides})
    rows = [(n, *stroke) for n, stroke in named if n in sides]
    spots = [ReadMark(n, z, sketch.error_mm) for name, a, b in rows for n, z in ((POLE, a), (name or "", b))]
    names = [n for n, _ in named]
    seen = all(n in names for n, v in sides.items() if SHORT_MM < abs(v) < HEADLESS_MM)
    return spots, bool(arrows) and all(names[: len(arrows)]) and seen


def arrows_of(sketch: ReadDrawing) -> list[Stroke]:
    """Strokes with arrowheads, each towards its head."""
    return [s if sketch.ways[k] > 0 else s[::-1] for k in headed(sketch) if (s := sketch.strokes[k])]


def _named(
    arrows: Sequence[Sequence[Stroke]], sketch: ReadDrawing, bench: PreparedPlan, known: Mapping[str, complex]
) -> list[tuple[str | None, Stroke]]:
    """Each arrow's name and way, of those it may go, at the size that explains all best: it is the drawer's choice."""
    lengths = [abs(t) for t in known.values() if abs(t) > HEADLESS_MM]
    sizes: list[float] = []
    for ratio in sorted(abs(b - a) / t for (a, b), *_ in arrows for t in lengths) if not bench.asked.mu else ():
        if LEAST < ratio < 1 / LEAST and (not sizes or ratio > ALIKE * sizes[-1]):
            sizes.append(ratio)
    best: tuple[float, list[str | None], list[Costs]] = math.inf, [], []
    for size in (1.0, *sizes):
        ways = [_costs(strokes, sketch, bench, {n: t * size for n, t in known.items()}) for strokes in arrows]
        costs = [{n: min(row[n] for row in rows if n in row) for n in set[str]().union(*rows)} for rows in ways]
        names = named_best(costs)
        price = sum(row[n] if n else TOO_FAR for n, row in zip(names, costs, strict=True)) + OTHER * (size != 1.0)
        if price < best[0]:
            best = price, names, ways
    return [
        (name, min(zip(rows, strokes, strict=True), key=lambda way: way[0].get(name or "", math.inf))[1])
        for name, rows, strokes in zip(*best[1:], arrows, strict=True)
    ]


def others(bench: PreparedPlan) -> dict[str, complex]:
    """Vectors that may be drawn beside the polygon's own: whole reactions, inner ones."""
    plan, made = bench.asked.plan, run(bench.plans.program, bench.given)
    own = bench.plans.segments_of.get(plan, ())
    return {end_of(s.name): complex(made[at(plan, s.end)] - made[at(plan, s.start)]) for s in own}


def _costs(arrows: Sequence[Stroke], sketch: ReadDrawing, bench: PreparedPlan, known: Mapping[str, complex]) -> Costs:
    """What it costs each arrow to have each name: how far its word stands, and how unlike the true vector it is."""
    spelt = bench.naming.names(known)
    words = [(spelt.find(w.text), w) for w in sketch.words]
    written = {n for n, _ in words if n and n != POLE}
    out: Costs = []
    for a, b in arrows:
        near = {n: NO_WORD if n not in written else FAR_WORD for n in known}
        for name, word in words:
            far = word.beside((a, b)) * (LED if word.led else 1)
            if name in near and far <= NEAR_MM and word.runs((a, b), sketch.words):
                near[name] = min(near[name], far)
        fits = (n for n, t in known.items() if abs(b - a) >= HEADLESS_MM or abs(t) < HEADLESS_MM)  # or has no head
        row = {n: near[n] + (NAMED if n in written else UNLIKE) * _unlike(b - a, known[n]) for n in fits}
        out.append({n: c for n, c in row.items() if c < TOO_FAR})
    return out


def _unlike(v: complex, true: complex) -> float:
    """How unlike a vector is the true one: hardly, if it is the true one reversed, for then its name must tell."""
    back = abs(v + true) < abs(v - true)
    off = abs(v + true if back else v - true)
    return min(1.0, off / (SHARE * abs(true) + 1) + REVERSED * back) + min(1.0, off / (abs(true) + 1))
