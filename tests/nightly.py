"""The long checks, run by hand: claims over a million random positions, masks over ten million.

    python tests/nightly.py claims --positions 1000000 --minutes 60
    python tests/nightly.py masks --positions 10000000 --minutes 60

Each prints what it counted when it is done or its minutes are over, and ends with 1 where anything was wrong.
The truth of ``claims`` is the same tape read in numbers of 64 bits of mantissa, its constants too; of a few positions
of every mechanism it is compared with 50 digits.
"""

from __future__ import annotations

import argparse
import dataclasses
import math
import random
import sys
import time
from typing import Any

import numpy as np
from mechanisms import KINDS, make, to_yaml
from oracle import NoSolution

from planes.cycle import Cycle, fused
from planes.cycle.claims import Claims
from planes.cycle.digits import Digits
from planes.cycle.reading import read
from planes.cycle.tape import Tape
from planes.cycle.tracing import given_values
from planes.drawing import run
from planes.plans import state
from planes.scene import loads
from planes.wording import PlanesError

LONG = np.longdouble
PI = LONG("3.14159265358979323846264338327950288")
EACH, CLOSE, FEW = 1000, 1e-6, 2
TURN = np.arange(0.0, 360.0, 0.5)


def mechanism(seed: int, **how: Any) -> Cycle | None:
    """A random mechanism of one kind (or a chain of two), ready for many positions."""
    rng = random.Random(seed)
    kinds = [KINDS[seed % 5]] if seed % 4 else [KINDS[seed % 5], rng.choice(KINDS)]
    try:
        found = loads(to_yaml(make(rng, kinds, limit=1e6, **how).scene), "random.yaml").mechanism
        assert found
        return Cycle(state(found))
    except (NoSolution, PlanesError):
        return None


def lengthened(tape: Tape) -> Tape:
    """The tape with its irrational constants at full length."""
    exact = {math.radians(1): PI / 180, math.degrees(1): 180 / PI}
    values = {k: exact.get(v, v) if type(v) is float else v for k, v in tape.values.items()}
    return dataclasses.replace(tape, values=values)


def truth(c: Cycle, values: Any) -> Any:
    """The columns in long numbers."""
    tape = lengthened(c.trace.tape)
    found = read(tape, tape.needed(list(c.trace.outputs)), {**given_values(c.given), c.plans.drive_given: values}, LONG)
    return np.array([np.broadcast_to(found[p], values.shape) for p in c.trace.outputs])


def codes(c: Cycle, values: Any) -> Any:
    return np.hstack([b.codes for b in c.blocks(values, fast=False)])


def close_to_limits(c: Cycle, rng: Any) -> Any:
    """Values closer than ``CLOSE`` rad to a limit of assembly, on its working side (none where there is no limit)."""
    works = codes(c, TURN) == 0
    edges = np.flatnonzero(works != np.roll(works, -1))
    if not len(edges):
        return np.empty(0)
    k = int(rng.choice(edges))
    good, bad = (TURN[k], TURN[k] + 0.5) if works[k] else (TURN[k] + 0.5, TURN[k])
    for _ in range(60):
        middle = (good + bad) / 2
        if codes(c, np.array([middle]))[0] == 0:
            good = middle
        else:
            bad = middle
    return good + math.copysign(1.0, good - bad) * np.degrees(CLOSE * 10.0 ** rng.uniform(-6, 0, EACH))


def claims(positions: int, end: float, seed: int) -> bool:
    """Whether no result was further from the truth than claimed."""
    count = close = numbers = wrong = silent = strays = tried = 0
    ratios: list[Any] = []
    while count < positions and time.monotonic() < end:
        seed += 1
        c = mechanism(seed, sliding=False)
        if c is None:
            continue
        rng = np.random.default_rng(seed)
        near = close_to_limits(c, rng) if seed % 3 == 0 else np.empty(0)
        values = near if len(near) else rng.uniform(0, 360, EACH)
        (block,) = c.blocks(values, fast=False)
        good = block.codes == 0
        if not good.any():
            continue
        tried += 1
        values, table, true = values[good], block.table[:, good], truth(c, values[good])
        with np.errstate(invalid="ignore"):
            claimed, error = Claims(c).bounds(values), np.abs(table - true).astype(float)
            over = (error > claimed) & np.isfinite(table)
        for k in range(min(FEW, len(values))):
            strays += astray(c, float(values[k]), true[:, k], claimed[:, k])
        if over.any():
            wrong += int(over.sum())
            row, k = np.argwhere(over)[0]
            print(f"seed {seed}: {c.columns[row].name} at {values[k]!r}: {error[row, k]:.3g} > {claimed[row, k]:.3g}")
        count, close, numbers = count + len(values), close + (len(values) if len(near) else 0), numbers + table.size
        silent += int((~np.isfinite(claimed).all(axis=0)).sum())
        sure = (error > 0) & np.isfinite(claimed)
        ratios.append(rng.choice(claimed[sure] / error[sure], 200) if sure.any() else np.empty(0))
    median = float(np.median(np.concatenate(ratios))) if ratios else math.nan
    print(
        f"claims: {count} positions of {tried} mechanisms, {close} of them closer than {CLOSE:g} rad to a limit; "
        f"{numbers} numbers, {wrong} further off than claimed; nothing claimed at {silent} positions; "
        f"median of claim to error {median:.1f}; {strays} long truths astray from 50 digits"
    )
    return not wrong and not strays


def astray(c: Cycle, value: float, true: Any, claimed: Any) -> int:
    """How many long truths stray from 50 digits by more than a hundredth of the claim."""
    drawing = run(c.program, {**c.given, c.plans.drive_given: value}, Digits(50))
    mp, found = drawing.hand.ar.mp, 0  # type: ignore[attr-defined]
    for column, x, bound in zip(c.columns, true, claimed, strict=True):
        high = float(x)
        apart = abs(float(column.take(drawing.things, drawing.hand.ar) - mp.mpf(high) - mp.mpf(float(x - LONG(high)))))
        found += bool(math.isfinite(apart) and math.isfinite(bound) and apart > bound / 100 + 1e-300)
    return found


def masks(positions: int, end: float, seed: int) -> bool:
    """Whether no number that is none came without a reason."""
    count = failed = bare = scenes = both = apart = 0
    while count < positions and time.monotonic() < end:
        seed += 1
        c = mechanism(seed, friction=seed % 4 == 0)
        if c is None:
            continue
        scenes += 1
        must = np.array([not x.beside for x in c.columns])
        drive = c.plans.mechanism.drive
        values = np.random.default_rng(seed).uniform(-1, 1, 20_000) * (720 if drive.kind == "phi" else 2)
        ways = (False, True) if fused.available() and seed % 25 == 0 else (False,)
        found = []
        for fast in ways:
            blocks = list(c.blocks(values, fast=fast))
            table, why = np.hstack([b.table for b in blocks]), np.hstack([b.codes for b in blocks])
            none = ~np.isfinite(table[must][:, why == 0])
            if none.any():
                bare += int(none.any(axis=0).sum())
                print(f"seed {seed}, compiled: {fast}: {none.any(axis=0).sum()} positions without a reason")
            bare += sum(not c.reasons[k - 1].key for k in set(why.tolist()) if k)
            found.append(why)
        if len(found) == 2:
            both, apart = both + len(values), apart + int((found[0] != found[1]).sum())
        count, failed = count + len(values) * len(ways), failed + int(sum((w != 0).sum() for w in found))
    print(
        f"masks: {count} positions of {scenes} scenes, {failed} failed, each with its reason; {bare} without one; "
        f"of {both} drawn both by arrays and compiled, {apart} differ in their reason"
    )
    return not bare


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("claims", "masks"))
    parser.add_argument("--positions", type=int, default=1000)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    end = time.monotonic() + 60 * asked.minutes
    work = claims if asked.what == "claims" else masks
    return 0 if work(asked.positions, end, asked.seed) else 1


if __name__ == "__main__":
    sys.exit(main())
