"""The chart of a scene with programs by others beside ours: `python -m tests.benchmarks.charts_beside SCENE CHART
[TABLE]`; of the mechanisms a kernel was written for, that too."""

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))

import numpy as np

from planes.accuracy.comparison import Comparison, OtherProgram
from planes.documents.charts import draw_chart
from planes.scene import load
from tests.helpers.other_programs import installed

NEAR_LIMITS = {"limit-stretched": "four-bar", "limit-folded": "four-bar", "kind-4-prp": "tangent"}
"""Kernels of scenes that come to a limit, and are not raced."""


def by_hand(scene: str) -> list[OtherProgram]:
    """The kernel written by hand for a scene and compiled with numba."""
    import rivals
    from conftest import SCENES

    known = {stem: name for name, stem in SCENES.items()} | NEAR_LIMITS
    name = known.get(Path(scene).stem)
    if name is None or name == "slotted lever":  # its kernel has no places
        return []
    kernel, columns = rivals.KERNELS[name], rivals.COLUMNS[name]
    rows = [f"{column}_{part}" for column in columns if column[0] in "rva" for part in "xy"]

    def work(bench: Comparison, values: Any) -> Any:
        out = np.empty((64, len(values)))
        for k in range(len(values)):
            kernel(np.array([float(values[k])]), out[:, k : k + 1], *rivals.numbers(name, bench.plans_at(k)))
        made = dict(zip(rows, out, strict=False))
        return np.array([made.get(c.name, np.full(len(values), np.nan)) for c in bench.cycle.columns])

    def quickest(bench: Comparison, values: Any) -> Callable[[Any], object]:
        out, told = np.empty((64, 100_000)), rivals.numbers(name)
        return lambda some: kernel(some, out, *told)

    return [OtherProgram("numba by hand", lambda _: True, work, quickest, 100_000)]


if __name__ == "__main__":
    beside = [*by_hand(sys.argv[1]), *installed()]
    draw_chart(load(sys.argv[1]), sys.argv[2], sys.argv[3] if len(sys.argv) > 3 else None, "en", beside)
