"""The long checks, run by hand: claims over a million random positions, masks over ten million, scenes of any shape,
families of scenes on the way to a limit.

    python -m tests.nightly claims --positions 1000000 --minutes 60
    python -m tests.nightly written --positions 100000 --minutes 60
    python -m tests.nightly masks --positions 10000000 --minutes 60
    python -m tests.nightly scenes --positions 2000
    python -m tests.nightly limits --positions 100000 --minutes 60
    python -m tests.nightly snapped --positions 2000
    python -m tests.nightly spoiled --positions 3000

Each prints what it counted when it is done or its minutes are over, and ends with 1 where anything was wrong.

``scenes`` draws scenes of any shape and compares every number with the independent solver (at most 1e-9 of the largest
of its kind, times the least sharpness).

``snapped`` makes so many scenes with one exact coincidence, and of each a position, a run and a document.

``spoiled`` changes lines, words and numbers of the samples' files and of drawings of them (one in eleven), and looks
how ``solve`` and ``check`` end.

``written`` compares with scenes as they are written, their decimals at 50 digits, at random and near limits (1e-3 to
1e-9 rad); its ratios are over every number with an error, the least of them told too.

The truth of ``claims`` is the same tape read in numbers of 106 bits; at a few positions of every mechanism it is
compared with 50 digits (it must not stray by a hundredth of the claim), and the drawing of one position with the claim
as well. Ratios of claim to error are those of numbers with any error at all for which something is claimed, two hundred
numbers of every mechanism, drawn at random; the median is over all of them.
"""

from __future__ import annotations

import argparse
import math
import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from planes.accuracy.digits import Digits
from planes.batch import compiled
from planes.batch.cycle import Cycle
from planes.batch.error_bounds import Claims
from planes.batch.tracing import given_values_by_name
from planes.drafting.drawing import draw_program
from planes.plans import plans_of
from planes.scene import load, loads
from planes.solving import solve
from planes.words.errors import PlanesError
from tests.helpers import ROOT, as_written
from tests.helpers.comparing import against, standing
from tests.helpers.double_double import FINE, Two, apart, read_long
from tests.helpers.mechanisms import KINDS, any_scene, make, shape_of, to_yaml
from tests.helpers.near_limits import FAMILIES, walk
from tests.helpers.oracle import NoSolution
from tests.helpers.snapped import DOCUMENTS, document_faults, faults, snapped
from tests.helpers.snapped import FAMILIES as FAMILIES_OF_SNAPPED
from tests.helpers.spoiled import fault, made, spoiled

EACH, CLOSE, WIDE, FEW, SEEN = 1000, 1e-6, 1e-3, 2, 200
FULL = 40  # positions of one mechanism compared with its text
COMPILED = 25  # of so many mechanisms one is drawn by the compiled loop too
NEAR = 1e-9  # of the largest number of its kind, times the sharpness: as far as a scene's number may be off
TURN = np.arange(0.0, 360.0, 0.5)


def mechanism(seed: int, **how: Any) -> Cycle | None:
    """A random mechanism of one kind (or a chain of two), ready for many positions."""
    rng = random.Random(seed)
    kinds = [KINDS[seed % 5]] if seed % 4 else [KINDS[seed % 5], rng.choice(KINDS)]
    try:
        found = loads(to_yaml(make(rng, kinds, limit=1e6, **how).scene), "random.yaml").mechanism
        assert found
        return Cycle(plans_of(found))
    except (NoSolution, PlanesError):
        return None


def truth(c: Cycle, values: Any) -> list[Two]:
    """The columns in long numbers."""
    return read_long(c, {**given_values_by_name(c.given), c.plans.drive_given_name: values}, values.shape)


def errors(table: Any, true: list[Two]) -> Any:
    """How far the numbers of a table are from the truth; nothing where that cannot be told."""
    with np.errstate(invalid="ignore"):
        found = np.array([apart(row, x) for row, x in zip(table, true, strict=True)])
        return np.where(found < FINE * np.abs(table), 0.0, found)


def codes(c: Cycle, values: Any) -> Any:
    return np.hstack([b.codes for b in c.blocks(values, fast=False)])


def close_to_limits(c: Cycle, rng: Any, close: float = CLOSE) -> Any:
    """Values closer than ``close`` rad to a limit of assembly, on its working side (none where there is no limit)."""
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
    return good + math.copysign(1.0, good - bad) * np.degrees(close * 10.0 ** rng.uniform(-6, 0, EACH))


@dataclass
class Tally:
    """What a run of claims has counted."""

    count: Counter[str] = field(default_factory=Counter)
    kinds: Counter[str] = field(default_factory=Counter)
    close: Counter[str] = field(default_factory=Counter)
    ratios: dict[str, list[Any]] = field(default_factory=dict)

    def told(self) -> str:
        n = self.count
        by = {k: np.concatenate(v) for k, v in sorted(self.ratios.items())}
        whole = np.concatenate([*by.values(), np.empty(0)])
        median = float(np.median(whole)) if len(whole) else math.nan
        each = ", ".join(f"{k} {np.median(v):.1f}" for k, v in by.items() if len(v))
        return (
            f"claims: {n['positions']} positions of {n['mechanisms']} mechanisms ({dict(self.kinds)}), {n['close']} "
            f"of them closer than {CLOSE:g} rad to a limit ({dict(self.close)}); {n['numbers']} numbers, {n['wrong']} "
            f"further off than claimed; of no error {n['right']}, of no truth {n['unknown']}; nothing claimed for "
            f"{n['silent']} numbers at {n['mute']} positions; median of claim to error {median:.2f} ({each}), "
            f"in {100 * np.mean(whole > 100) if len(whole) else 0:.1f}% above a hundred; "
            f"{n['sampled']} long truths beside 50 digits, {n['strays']} astray; "
            f"{n['single']} drawn one by one, {n['single_wrong']} further off than claimed; {n['compiled']} positions "
            f"compiled too, {n['compiled_wrong']} numbers further off than claimed"
        )


def claims(positions: int, end: float, seed: int) -> bool:
    """Whether no result was further from the truth than claimed."""
    tally = Tally()
    while tally.count["positions"] < positions and time.monotonic() < end:
        seed += 1
        c = mechanism(seed, sliding=False)
        if c is not None:
            _claims_of(c, seed, tally)
    print(tally.told())
    return not any(tally.count[k] for k in ("wrong", "strays", "single_wrong", "compiled_wrong"))


def _claims_of(c: Cycle, seed: int, tally: Tally) -> None:
    rng = np.random.default_rng(seed)
    near = close_to_limits(c, rng) if seed % 3 == 0 else np.empty(0)
    values = near if len(near) else rng.uniform(0, 360, EACH)
    (block,) = c.blocks(values, fast=False, bare=True)
    good = block.codes == 0
    if not good.any():
        return
    values, table = values[good], block.table[:, good]
    true, claimed = truth(c, values), Claims(c).error_bounds_of_columns(values)
    error = errors(table, true)
    _count(c, seed, tally, (values, table, error, claimed))
    if compiled.is_compiler_available() and seed % COMPILED == 0:
        _compiled(c, seed, tally, (values, true, claimed))
    tally.close.update({KINDS[seed % 5]: len(values)} if len(near) else {})
    tally.count["close"] += len(values) if len(near) else 0
    sure = (error > 0) & np.isfinite(claimed)
    rows, places = np.nonzero(sure)
    for k in rng.choice(len(rows), SEEN) if len(rows) else ():
        name = quantity(c.columns[rows[k]].name)
        tally.ratios.setdefault(name, []).append([claimed[rows[k], places[k]] / error[rows[k], places[k]]])
    for k in range(min(FEW, len(values))):
        _beside_digits(c, float(values[k]), [(x[0][k], x[1][k]) for x in true], claimed[:, k], tally.count)


def written(positions: int, end: float, seed: int) -> bool:
    """Whether no result was further from what the scene's own decimals make than claimed."""
    count, ratios = Counter[str](), dict[str, list[Any]]()
    while count["positions"] < positions and time.monotonic() < end:
        seed += 1
        c = mechanism(seed, sliding=False)
        if c is None:
            continue
        rng = np.random.default_rng(seed)
        near = close_to_limits(c, rng, WIDE)[:FULL] if seed % 3 == 0 else np.empty(0)
        error, claimed = beside_text(c, near if len(near) else np.round(rng.uniform(0, 360, FULL), 6))
        sure = (error > 0) & np.isfinite(claimed)
        close = error.shape[1] * bool(len(near))
        count.update(positions=error.shape[1], close=close, numbers=error.size, wrong=int((error > claimed).sum()))
        if (error > claimed).any():
            print(f"seed {seed}: a claim is short")
        for column, claims_, errors_, some in zip(c.columns, claimed, error, sure, strict=True):
            ratios.setdefault(quantity(column.name), []).append(claims_[some] / errors_[some])
            ratios.setdefault("near limits" if len(near) else "elsewhere", []).append(claims_[some] / errors_[some])
    by = {k: np.concatenate(v) for k, v in ratios.items()}
    each = ", ".join(f"{k} {np.median(v):.1f}" for k, v in by.items() if len(v))
    every = np.concatenate([by[k] for k in ("near limits", "elsewhere") if k in by])
    print(
        f"written: {count['positions']} positions, {count['close']} of them closer than {WIDE:g} rad to a limit; "
        f"{count['numbers']} numbers, {len(every)} with an error, {count['wrong']} further off than claimed; claim to "
        f"error: median {np.median(every):.1f} ({each}), least {every.min():.4f}"
    )
    return not count["wrong"]


def beside_text(c: Cycle, values: Any) -> tuple[Any, Any]:
    """Errors against the text of a scene, and what is claimed of them, where the mechanism works."""
    (block,) = c.blocks(values, fast=False, chunk=len(values), bare=True)
    good = block.codes == 0
    return errors(
        block.table[:, good], as_written.truth(c, values[good])
    ), c.decimal_error_claims.error_bounds_of_columns(values[good])


def _count(c: Cycle, seed: int, tally: Tally, found: tuple[Any, Any, Any, Any]) -> None:
    values, table, error, claimed = found
    said, over = np.isfinite(table), error > claimed
    if over.any():
        row, k = np.argwhere(over)[0]
        print(f"seed {seed}: {c.columns[row].name} at {values[k]!r}: {error[row, k]:.3g} > {claimed[row, k]:.3g}")
    silent = said & ~np.isfinite(claimed)
    tally.kinds[KINDS[seed % 5]] += len(values)
    tally.count.update(
        positions=len(values),
        mechanisms=1,
        numbers=int(said.sum()),
        wrong=int(over.sum()),
        right=int((error == 0).sum()),
        unknown=int((said & np.isnan(error)).sum()),
        silent=int(silent.sum()),
        mute=int(silent.any(axis=0).sum()),
    )


def _compiled(c: Cycle, seed: int, tally: Tally, found: tuple[Any, Any, Any]) -> None:
    """The same positions by the compiled loop, which rounds otherwise."""
    values, true, claimed = found
    blocks = list(c.blocks(values, fast=True, bare=True))
    table, good = np.hstack([b.table for b in blocks]), np.hstack([b.codes for b in blocks]) == 0
    over = (errors(table, true) > claimed) & good
    tally.count.update(compiled=int(good.sum()), compiled_wrong=int(over.sum()))
    if over.any():
        row, k = np.argwhere(over)[0]
        print(f"seed {seed}, compiled: {c.columns[row].name} at {values[k]!r} is further off than claimed")


def quantity(name: str) -> str:
    """What kind of quantity a column is of."""
    kind, _, rest = name.partition("_")
    return {"arm": "F arm", "moment": "F moment"}.get(rest.rpartition("_")[2], "F") if kind == "F" else kind


def _beside_digits(c: Cycle, value: float, true: list[Any], claimed: Any, count: Counter[str]) -> None:
    """One position at 50 digits: how many long truths stray from it by more than a hundredth of the claim, and how many
    numbers drawn by themselves are further off than claimed."""
    try:
        drawing = draw_program(c.program, {**c.given, c.plans.drive_given_name: value}, Digits(50))
        single = draw_program(c.program, {**c.given, c.plans.drive_given_name: value})
    except PlanesError:
        return
    ar = drawing.tool.ar
    mpf = ar.mp.mpf  # type: ignore[attr-defined]
    for column, (high, low), bound in zip(c.columns, true, claimed, strict=True):
        exact = column.read_from_drawing(drawing.things, ar)
        strays = float(abs(exact - mpf(float(high)) - mpf(float(low))))
        wrong = float(abs(exact - mpf(float(column.read_from_drawing(single.things, single.tool.ar)))))
        known = math.isfinite(strays) and math.isfinite(bound)
        count.update(sampled=known, strays=known and strays > bound / 100 + FINE * abs(high))
        count.update(single=known, single_wrong=known and wrong > bound)


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
        ways = (False, True) if compiled.is_compiler_available() and seed % COMPILED == 0 else (False,)
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


def scenes(count: int, end: float, seed: int) -> bool:
    """Whether every number of so many scenes is that of the independent solver."""
    shapes: Counter[str] = Counter()
    worst: dict[str, tuple[float, int]] = {}
    done = wrong = 0
    for k in range(seed + 1000, seed + 1000 + count):  # the suite has those below
        if time.monotonic() > end:
            break
        try:
            case, text = any_scene(k)
        except NoSolution:
            shapes["not drawn"] += 1
            continue
        if standing(case):
            shapes["standing still"] += 1
            continue
        done += 1
        shapes.update(shape_of(case.scene))
        try:
            drawn, errors_ = against(case, text)
        except (PlanesError, ArithmeticError) as error:
            wrong += 1
            print(f"scene {k}: {error}")
            continue
        for name, error in errors_.items():
            sort = quantity(name)
            worst[sort] = max(worst.get(sort, (0.0, 0)), (error * drawn.sharpest, k))
            if error * drawn.sharpest > NEAR:
                wrong += 1
                print(f"scene {k}: {name} is {error:.2g} off at sharpness {drawn.sharpest:.2g}")
    largest = ", ".join(f"{sort} {error:.1e} (scene {k})" for sort, (error, k) in sorted(worst.items()))
    print(f"scenes: {done} compared, {wrong} faults; {dict(shapes)}; worst: {largest}")
    return not wrong


def limits(positions: int, end: float, seed: int) -> bool:
    """Whether no number near a limit was wrong without a word."""
    tallies = {family: Counter[str]() for family in FAMILIES}
    while sum(t["positions"] for t in tallies.values()) < positions and time.monotonic() < end:
        for family, tally in tallies.items():
            tally.update(walk(family, seed, 20))
        seed += 1
    for family, tally in tallies.items():
        print(f"{family}: {', '.join(f'{n} {what}' for what, n in sorted(tally.items()))}")
    return not any(t[k] for t in tallies.values() for k in ("invented", "unsaid", "arrays wrong", "compiled wrong"))


def coincidences(count: int, end: float, seed: int) -> bool:
    """Whether every scene with an exact coincidence has right numbers or one sentence, and so has a document of it."""
    done, wrong = Counter[str](), 0
    with tempfile.TemporaryDirectory() as folder:
        for k in range(seed + 1000, seed + 1000 + count):  # the suite has those below
            if time.monotonic() > end:
                break
            one, command = snapped(k), DOCUMENTS[k // len(FAMILIES_OF_SNAPPED) % len(DOCUMENTS)]
            done.update((one.family, command))
            for path in Path(folder).iterdir():
                path.unlink()
            try:
                said = [*faults(one), *document_faults(one, command, Path(folder))]
            except Exception as error:  # a traceback is what is looked for
                said = [f"{type(error).__name__}: {error}"]
            wrong += bool(said)
            for fault in said[:1]:
                print(f"scene {k} ({one.family}, {command}): {fault}", flush=True)
    print(f"snapped: {sum(done[c] for c in DOCUMENTS)} scenes, {wrong} with faults; {dict(done)}")
    return not wrong


def hurried(count: int, end: float, seed: int) -> bool:
    """Scenes and drawings spoiled as by a hurried hand; True if every command ended as it should."""
    samples = sorted((ROOT / "samples").glob("*.yaml")) + sorted((ROOT / "samples/vectors").glob("*.yaml"))
    texts = [f.read_text("utf-8") for f in samples]
    wrong, done = 0, Counter[str]()
    with tempfile.TemporaryDirectory() as where:
        folder = Path(where)
        drawings = [*drawn_for_spoiling(folder)]
        for k in range(count):
            if time.monotonic() > end:
                break
            rng = random.Random(f"{seed} {k}")
            if k % 11:
                words = ["solve", str(made(folder, spoiled(rng.choice(texts), rng), ".yaml"))]
            else:
                scene, plan, text, suffix = rng.choice(drawings)
                words = ["check", scene, str(made(folder, spoiled(text, rng), suffix)), "--plan", plan]
            done[words[0]] += 1
            if said := fault([*words, "--lang", "en"]):
                wrong += 1
                print(f"{seed} {k}: {words[0]}: {said}", flush=True)
    print(f"spoiled: {done['solve']} scenes, {done['check']} drawings, {wrong} with faults")
    return not wrong


def drawn_for_spoiling(folder: Path) -> Iterator[tuple[str, str, str, str]]:
    """Drawings of plans, as text: the scene, the plan, the text, the suffix."""
    for name in ("kind-1-rrr", "kind-2-rrp", "kind-3-rpr", "six-link"):
        scene = str(ROOT / "samples" / f"{name}.yaml")
        for suffix in (".svg", ".dxf"):
            for plan in ("velocity", "acceleration"):
                file = folder / f"drawn{suffix}"
                fault(["sheet", scene, "--view", f"{plan}-plan", "-o", str(file), "--lang", "en"])
                yield scene, plan, file.read_text("utf-8"), suffix
        here = solve(load(scene)).positions[0]
        rows = [f"v_{p},{abs(v):.4g},m/s" for p, v in here.v.items()] + [
            f"omega_{n},{w:.4g},rad/s" for n, w in here.omega.items()
        ]
        yield scene, "velocity", "\n".join(["result,value,unit", *rows]), ".csv"


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=("claims", "written", "masks", "scenes", "limits", "snapped", "spoiled"))
    parser.add_argument("--positions", type=int, default=1000)
    parser.add_argument("--minutes", type=float, default=60.0)
    parser.add_argument("--seed", type=int, default=0)
    asked = parser.parse_args()
    end = time.monotonic() + 60 * asked.minutes
    every = {"claims": claims, "written": written, "masks": masks, "scenes": scenes, "limits": limits}
    every |= {"snapped": coincidences, "spoiled": hurried}
    work = every[asked.what]
    return 0 if work(asked.positions, end, asked.seed) else 1


if __name__ == "__main__":
    sys.exit(main())
