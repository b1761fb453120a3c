"""What becomes of many scenes against what was kept: sums of their results, or the sentence they are refused by.

The scenes are the samples with faults of a hurried hand, scenes with an exact coincidence, random ones of every shape,
and bodies in equilibrium. What a change meant to alter is written anew:
GOLDEN=write python -m tests.solving.test_kept_outcomes.
"""

from __future__ import annotations

import json
import os
import random
import re
from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any
from zlib import crc32

import pytest

import planes
from planes.scene import loads
from planes.solving import solve
from planes.words.errors import PlanesError
from tests.helpers import ROOT
from tests.helpers.mechanisms import any_scene
from tests.helpers.snapped import snapped
from tests.helpers.spoiled import spoiled
from tests.plans.test_structures import KINDS, girder

KEPT = ROOT / "tests" / "golden" / "outcomes.json"
SPOILED, SNAPPED, ANY, STILL = 480, 90, 90, 8  # scenes of each kind; of each way of statics
ALIKE = 1e-6  # of the sum of sizes
TOGETHER = 15  # scenes in one test


def scenes() -> Iterator[tuple[str, str]]:
    """Each scene's name and text."""
    templates = sorted((Path(planes.__file__).parent / "templates").glob("*.yaml"))  # of an installed package, too
    files = [*templates, *sorted((ROOT / "samples").glob("**/*.yaml"))]
    files = [f for f in files if "course" not in (f.stem, f.parent.name)]
    for k in range(SPOILED):
        rng = random.Random(f"outcome {k}")
        yield f"spoiled {k}", spoiled(files[k % len(files)].read_text("utf-8"), rng)
    yield from ((f"snapped {k}", snapped(1000 + k).text) for k in range(SNAPPED))
    yield from ((f"any {k}", any_scene(5000 + k)[1]) for k in range(ANY))
    for make, method in (*KINDS, (lambda r, _: girder(r), "truss")):
        rng = random.Random(f"outcome {getattr(make, '__name__', '')} {method}")
        yield from ((f"{method} {k} {make.__name__}", "planes: 1\n" + make(rng, method)) for k in range(STILL))


def outcome(text: str) -> Any:
    """Sums by kind of result, weighed by their names, with the sums of their sizes; or a sentence."""
    try:
        told = solve(loads(text, "s.yaml")).json()
    except PlanesError as error:
        return str(error)
    sums: dict[str, list[float]] = defaultdict(lambda: [0.0, 0.0])
    for path, x in numbers(told):
        kind = re.sub(r"[\d_^].*", "", path[-1] if path[-1] != "xy" else path[-2]) or path[0]
        weight = 1.0 + crc32("/".join(path).encode()) / 2**32
        sums[kind][0] += weight * x
        sums[kind][1] += abs(x)
    failures = [p["error"] for p in told.get("positions", ()) if "error" in p]
    return [failures, {k: [float(f"{x:.9g}") for x in pair] for k, pair in sorted(sums.items())}]


def numbers(told: Any, path: tuple[str, ...] = ()) -> Iterator[tuple[tuple[str, ...], float]]:
    """Every number of an object, but what is claimed of its error."""
    if isinstance(told, dict):
        for key, inner in told.items():
            if "error" not in key:
                yield from numbers(inner, (*path, key))
    elif isinstance(told, list):
        for k, inner in enumerate(told):
            yield from numbers(inner, (*path[:-1], f"{path[-1]}_{k}") if path else (str(k),))
    elif isinstance(told, (int, float)) and not isinstance(told, bool):
        yield path or ("",), float(told)


@cache
def every() -> list[tuple[str, str]]:
    return list(scenes())


def same(kept: Any, now: Any) -> bool:
    """Whether two outcomes are one but for rounding."""
    if isinstance(kept, str) or isinstance(now, str) or kept[0] != now[0] or kept[1].keys() != now[1].keys():
        return bool(kept == now)
    return all(abs(x - now[1][k][0]) <= ALIKE * size for k, (x, size) in kept[1].items())


@pytest.mark.few(34)
@pytest.mark.parametrize("start", range(0, SPOILED + SNAPPED + ANY + STILL * (len(KINDS) + 1), TOGETHER))
def test_a_scene_has_the_outcome_that_was_kept(start: int) -> None:
    kept = json.loads(KEPT.read_text("utf-8"))
    for name, text in every()[start : start + TOGETHER]:
        now = json.loads(json.dumps(outcome(text)))
        assert same(kept[name], now), f"{name}: {kept[name]} → {now}\n{text}"


if __name__ == "__main__":
    assert os.environ.get("GOLDEN") == "write"
    lines = ",\n".join(f"{json.dumps(name)}: {json.dumps(outcome(text), ensure_ascii=False)}" for name, text in every())
    KEPT.write_text("{" + lines + "}\n", "utf-8")
