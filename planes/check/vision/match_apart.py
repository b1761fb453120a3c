"""Vectors of a force plan told one by one by their arrowheads, where they do not make up one chain.

A printed sheet shows more than the bare polygon: whole reactions beside their parts, inner ones, and forces of one line
side by side. So the plan as it should be is laid on the ink: each of its vectors must have its arrow, no farther aside
than it may have been moved, and no arrow may be left over. A plan with a mistake is not told so: among many vectors of
one line one that is merely unseen makes a mistake fit better than the right plan does.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.grading.polygons import sides_of
from planes.check.grading.prepared_plan import PreparedPlan, redrawn
from planes.check.reading.as_planned import is_right
from planes.check.vision.ink import Ink, evened
from planes.check.vision.ink_cover import TIP_STRAIGHT, InkCover
from planes.check.vision.line_fitting import fitted
from planes.check.vision.places import HEADED_MM, Seen
from planes.words.names import POLE, at

REACH_MM, SHARE = 1.5, 0.015  # how far off its length a vector may be; grading tells whether it is near enough
ASIDE_MM = 7.0  # how far aside a vector may be drawn of where it belongs
COVERED = 0.9
SURE_MM = 3.0  # a shorter vector may be there unseen: it is put where it should be
SHORT_MM = 9.0  # so long a vector alone may have been taken for a letter
STEP_MM = 0.15  # in which such a vector is looked for aside
SLIM_MM = 0.25  # how far aside of a vector its ink may be: another may lie close beside it
HEADED = 0.3  # the share of longer vectors whose heads must be seen: some are hidden by other ink
HIDDEN_MM = 0.4  # σ of where a vector ends whose ends are within other ink
DRAWN_MM = 0.3  # a shorter one is not drawn
WILDEST_MM = 400.0

Ends = tuple[complex, complex]


@dataclass(frozen=True)
class SeenArrow:
    """A vector on a sheet, with how surely each end is known."""

    start: complex
    tip: complex
    sigmas: tuple[float, float]
    headed: bool = True


@dataclass
class ArrowSheet:
    """The arrows of a sheet, and its ink with what was taken for letters."""

    seen: Seen
    cover: InkCover = field(init=False)
    full: Ink = field(init=False)
    known: dict[complex, list[SeenArrow]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        ink = self.seen.ink
        self.cover = InkCover(self.seen, complex(math.inf))
        self.full = Ink(ink.flat, evened(ink.flat), ink.paper, ink.pencil)

    def like(self, vector: complex) -> list[SeenArrow]:
        """Arrows that may be a vector (remembered)."""
        if vector not in self.known:
            self.known[vector] = list(self._like(vector))
        return self.known[vector]

    def _like(self, vector: complex) -> Iterator[SeenArrow]:
        reach = REACH_MM + SHARE * abs(vector)
        for start in (p for p in self.seen.places if p.tip or p.ended):
            goal = start.z + vector
            ends = self.seen.within(goal, reach)
            if ends and self.seen.ink.covered(start.z, goal, SLIM_MM) > COVERED:
                tips = [t for t, way in self.cover.tips if abs(t - goal) < reach and _along(vector, way)]
                closer = None if tips else self.seen.closer(start.z, goal)
                tips += [closer.z] if closer and abs(closer.z - goal) < reach else []
                for tip in tips or [p.z for p in ends if p.ended]:
                    yield SeenArrow(start.z, tip, (start.sigma, 0.15), bool(tips))

    def beside(self, arrow: SeenArrow) -> float:
        """The share of an arrow's way on which its ink is not just there, in tenths."""
        return round(1 - self.seen.ink.covered(arrow.start, arrow.tip, STEP_MM / 2), 1)

    def short(self, a: complex, b: complex) -> SeenArrow | None:
        """A short vector about where it belongs: by itself, or at least some ink where it should be."""
        way, steps = (b - a) / abs(b - a), round(ASIDE_MM / STEP_MM)
        moved = (1j * way * STEP_MM * k for k in sorted(range(-steps, steps + 1), key=abs))
        inked = [by for by in moved if self.full.covered(a + by, b + by, SLIM_MM) > COVERED]
        for by in inked:
            line = fitted(self.full, a + by, b + by)
            start, tip = sorted(line.ends, key=lambda z: (z * way.conjugate()).real) if line else (b, a)
            if max(abs(start - a - by), abs(tip - b - by)) < REACH_MM / 2:
                return SeenArrow(start, tip, (0.2, 0.2), False)
        return SeenArrow(a + inked[0], b + inked[0], (HIDDEN_MM, HIDDEN_MM), False) if inked else None


def _drawn(bench: PreparedPlan) -> tuple[dict[str, Ends], list[Ends]] | None:
    """Ends of the plan's vectors, and of all that may be drawn beside them."""
    plan, things = bench.asked.plan, redrawn(bench, None, lambda step, made: made)
    if things is None:
        return None

    def ends(start: str, end: str) -> Ends | None:
        places = tuple(0j if n == POLE else things.get(at(plan, n), math.nan) for n in (start, end))
        a, b = map(complex, places)
        return (a, b) if abs(a) + abs(b) < WILDEST_MM else None

    sides = {s.name: ends(s.start, s.end) for s in sides_of(bench.plans, plan)}
    more = [ends(s.start, s.end) for s in bench.plans.segments if s.plan == plan]
    needed = {n: e for n, e in sides.items() if e}
    return (needed, [e for e in more if e] + list(needed.values())) if len(needed) == len(sides) else None


def _fits(vector: Ends, start: complex, tip: complex, pole: complex) -> bool:
    """Whether a vector from the pole may be drawn so, some way aside."""
    a, b = vector
    way = (b - a) / abs(b - a)
    reach = REACH_MM + SHARE * abs(b - a)
    off = (start - a - pole) * way.conjugate(), (tip - b - pole) * way.conjugate()
    return all(abs(o.real) < reach and abs(o.imag) < ASIDE_MM for o in off)


def _laid(
    sheet: ArrowSheet, needed: Mapping[str, Ends], drawn: list[Ends]
) -> tuple[dict[str, SeenArrow], complex, bool] | None:
    """The arrow of every vector, the pole, and whether none is missing or over; None where a long one has none."""
    long = {n: e for n, e in needed.items() if abs(e[1] - e[0]) > HEADED_MM}
    likely = {n: sheet.like(b - a) for n, (a, b) in long.items()}
    if any(not arrows and abs(long[n][1] - long[n][0]) > SHORT_MM for n, arrows in likely.items()):
        return None
    best: tuple[int, float, complex] = 0, 0.0, 0j
    for name, arrows in likely.items():
        for pole in (arrow.tip - long[name][1] for arrow in arrows):
            near = [
                [abs(x.tip - long[n][1] - pole) for x in xs if _fits(long[n], x.start, x.tip, pole)]
                for n, xs in likely.items()
            ]
            best = max(best, (sum(map(bool, near)), -sum(map(min, filter(None, near))), pole), key=lambda b: b[:2])
    pole, found = best[2], dict[str, SeenArrow]()
    for name, (a, b) in sorted(needed.items(), key=lambda side: -abs(side[1][1] - side[1][0])):
        length = abs(b - a)
        if length < DRAWN_MM:
            continue
        taken = list(found.values())
        fits = [x for x in likely.get(name, ()) if _fits((a, b), x.start, x.tip, pole) and x not in taken]
        arrow = min(
            fits,
            key=lambda x: (not x.headed, sheet.beside(x), abs(x.tip - b - pole) + abs(x.start - a - pole)),
            default=None,
        )
        if arrow is None and length > SHORT_MM:
            return None
        arrow = arrow or sheet.short(a + pole, b + pole)
        if arrow is None and length < SURE_MM:
            arrow = SeenArrow(a + pole, b + pole, (HIDDEN_MM, HIDDEN_MM), False)
        if arrow is not None:
            found[name] = arrow
    ends = [b + pole for a, b in drawn if abs(b - a) > DRAWN_MM]
    over = any(all(abs(tip - z) > ASIDE_MM / 2 for z in ends) for tip, _ in sheet.cover.tips)
    headed = sum(x.headed for x in found.values()) >= HEADED * len(long)
    whole = all(n in found or abs(b - a) < DRAWN_MM for n, (a, b) in needed.items())
    return (found, pole, headed and whole and not over) if found else None


def _along(vector: complex, way: complex) -> bool:
    """Whether a head points along a vector."""
    return (vector * way.conjugate()).real > TIP_STRAIGHT * abs(vector)


def vectors_apart(bench: PreparedPlan, seen: Seen) -> tuple[list[ReadMark], complex] | None:
    """Every vector of the right plan as a row of its own, and the pole; None where the plan is not drawn so.

    No rows where all its long vectors are there and something about the short ones is not clear.
    """
    drawn = _drawn(bench)
    rows, pole, clear = (_laid(ArrowSheet(seen), *drawn) if drawn else None) or ({}, 0j, False)
    spots = [
        ReadMark(n, z, max(sigma, 0.1))
        for name, one in rows.items()
        for n, z, sigma in ((POLE, one.start, one.sigmas[0]), (name, one.tip, one.sigmas[1]))
    ]
    if not spots:
        return None
    return spots if clear and is_right(bench, ReadPaper("", spots)) else [], pole
