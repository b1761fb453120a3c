"""All that is told of the samples against what was kept: numbers, their ±, refusals, and the steps that made them.

A number may change by rounding alone; what a change meant to alter is written anew: GOLDEN=write python -m pytest FILE.
"""

from __future__ import annotations

import hashlib
import json
import os
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planes.batch.cycle import Cycle
from planes.scene import load
from planes.solving import plans_and_requested_results, solve
from planes.words.errors import PlanesError
from tests.helpers import ROOT

SAMPLES, KEPT = ROOT / "samples", ROOT / "tests" / "golden" / "answers"
FOLDERS = ("*.yaml", "class-three/*.yaml", "class-three/mixtures/*.yaml", "class-four/*.yaml", "vectors/*.yaml")
SCENES = sorted(str(p.relative_to(SAMPLES).with_suffix("")) for f in FOLDERS for p in SAMPLES.glob(f))
TURNS, ALIKE, LOOSE, DIGITS = 12, 1e-8, 0.2, 9  # positions asked; of numbers, relative; of ±; digits that are kept


def told(path: Path) -> dict[str, Any]:
    """What is told of a scene."""
    scene = load(str(path))
    out: dict[str, Any] = {"solved": solved(scene)}
    if scene.mechanism is None or not scene.mechanism.links:
        return out
    every = plans_and_requested_results(scene)
    steps = [(type(s).__name__, getattr(s, "makes", "")) for s in every[0].program.steps]
    proofs = sorted(f"{type(p).__name__} {p.reason} {p.plan}" for p in every[0].program.proofs)
    out["steps"] = hashlib.sha256(json.dumps([steps, proofs]).encode()).hexdigest()[:16]
    cycle, drive = Cycle(every[0]), every[0].mechanism.drive
    reach = 360.0 / TURNS if drive.kind == "phi" else 0.004
    values = drive.position + reach * np.arange(TURNS)
    (block,) = cycle.blocks(values, fast=False)
    bounds = cycle.error_claims.error_bounds_of_columns(values)
    out["refused"] = [str(cycle.reasons[code - 1]) if code else "" for code in block.codes.tolist()]
    out["columns"] = {c.name: [short(block.table[k]), short(bounds[k])] for k, c in enumerate(cycle.columns)}
    return out


def solved(scene: Any) -> Any:
    """The object of ``solve --json``, or why there is none."""
    try:
        return solve(scene).json()
    except PlanesError as error:
        return str(error)


def short(row: Any) -> list[float | None]:
    """Numbers with the digits that are kept."""
    return [float(f"{x:.{DIGITS}g}") if np.isfinite(x) else None for x in np.asarray(row, float).tolist()]


def differ(kept: Any, now: Any, where: str = "") -> list[str]:
    """Where two objects differ by more than rounding; numbers of a list by its largest."""
    if isinstance(kept, dict) and isinstance(now, dict):
        gone = [f"{where}: {sorted(kept.keys() ^ now.keys())[:3]}"] if kept.keys() != now.keys() else []
        return gone + [d for k in kept.keys() & now.keys() for d in differ(kept[k], now[k], f"{where}.{k}")]
    if isinstance(kept, list) and isinstance(now, list) and len(kept) == len(now):
        if all(isinstance(x, (int, float)) or x is None for x in (*kept, *now)):
            one, two = (np.array([np.nan if x is None else x for x in row], float) for row in (kept, now))
            size = np.nanmax(np.abs(np.r_[one, two, 0.0])) if len(one) else 0.0
            same = np.array_equal(np.isnan(one), np.isnan(two)) and not (np.abs(one - two) > ALIKE * size + 1e-12).any()
            return [] if same else [f"{where}: {kept} → {now}"]
        return [d for k, (a, b) in enumerate(zip(kept, now, strict=True)) for d in differ(a, b, f"{where}[{k}]")]
    if isinstance(kept, (int, float)) and isinstance(now, (int, float)) and not isinstance(kept, bool):
        return [] if abs(kept - now) <= ALIKE * max(abs(kept), abs(now)) + 1e-9 else [f"{where}: {kept} → {now}"]
    return [] if kept == now else [f"{where}: {kept} → {now}"]


def margins(kept: dict[str, Any], now: dict[str, Any]) -> list[str]:
    """Columns whose ± changed by more than a fifth."""
    out = []
    for name, (_, before) in kept.items():
        after = now.get(name, [[], []])[1]
        pairs = [(a or 0.0, b or 0.0) for a, b in zip(before, after, strict=False)]
        if any(abs(a - b) > LOOSE * max(a, b) for a, b in pairs):
            out.append(f"± of {name}: {before[:3]} → {after[:3]}")
    return out


@cache
def now_told(name: str) -> dict[str, Any]:
    return json.loads(json.dumps(told(SAMPLES / f"{name}.yaml"), ensure_ascii=False, default=str))


@pytest.mark.few(12, slow=200)
@pytest.mark.parametrize("name", SCENES)
def test_what_is_told_of_a_sample_is_what_was_kept(name: str) -> None:
    now, path = now_told(name), KEPT / f"{name.replace('/', '-')}.json"
    if os.environ.get("GOLDEN") == "write":
        path.parent.mkdir(exist_ok=True)
        path.write_text(json.dumps(now, ensure_ascii=False, separators=(",", ":")) + "\n", "utf-8")
    kept = json.loads(path.read_text("utf-8"))
    columns, others = kept.pop("columns", {}), dict(now)
    mine = others.pop("columns", {})
    wrong = differ(kept, others) + differ({k: v[0] for k, v in columns.items()}, {k: v[0] for k, v in mine.items()})
    assert not (wrong + margins(columns, mine)), f"{wrong[:5]} {margins(columns, mine)[:3]}; GOLDEN=write if meant"
