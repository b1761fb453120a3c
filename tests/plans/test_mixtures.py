"""Random scenes that mix laws of loads, friction, arcs, cylinders and groups of classes II and III, and their ways."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from planes.batch.cycle import Cycle
from planes.cli import main
from planes.plans import plans_of
from planes.plans.scales import drawn_in_si
from planes.scene import loads
from planes.words.errors import PlanFailure
from tests.helpers.comparing import against, balanced
from tests.helpers.mechanisms import to_yaml
from tests.helpers.mixtures import FEATURES, features_of, mixed

MOST = 1e-9


def compared(seeds: range) -> tuple[Counter[str], float, int]:
    """How many scenes with each feature were compared, the worst number, how many were refused by the method.

    Successive plans need not settle where friction nearly locks, though the equations all at once have an answer.
    """
    seen, worst, refused = Counter[str](), 0.0, 0
    for seed in seeds:
        case = mixed(seed)
        try:
            drawn, apart = against(case)
        except PlanFailure as failure:
            assert failure.reason == "not_settled", seed
            refused += 1
            continue
        worst = max(worst, max(apart.values()) * drawn.sharpest)
        assert worst <= MOST, (seed, sorted(apart.items(), key=lambda x: -x[1])[:3])
        balanced(drawn, seed)
        seen.update(features_of(case))
    return seen, worst, refused


@pytest.mark.slow
def test_mixtures_agree_with_the_independent_solver() -> None:
    seen, _, refused = compared(range(24))
    assert set(seen) == set(FEATURES), set(FEATURES) - set(seen)
    assert not refused


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("fifth", range(5))
def test_many_mixtures_agree_with_the_independent_solver(fifth: int) -> None:
    seen, _, refused = compared(range(1000 + 100 * fifth, 1100 + 100 * fifth))
    assert set(seen) == set(FEATURES) and min(seen.values()) >= 5, seen
    assert refused <= 3


@pytest.mark.needs("llvmlite")
@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("seed", [5, 11, 50, 14])
def test_arrays_the_compiled_loop_and_one_position_agree(seed: int) -> None:
    scene = loads(to_yaml(mixed(seed).scene))
    assert scene.mechanism
    cycle, drive = Cycle(plans_of(scene.mechanism), None), scene.mechanism.drive
    values = [drive.position + (1.0 if drive.kind == "phi" else 2e-3) * k for k in range(-3, 4)]
    arrays, loop = (next(cycle.blocks(values, fast=fast)) for fast in (False, True))
    assert (arrays.codes == loop.codes).all() and (~arrays.failed_mask).sum() >= 4
    units = [c.unit for c in cycle.columns]
    most = [np.nanmax(abs(arrays.table[[k for k, x in enumerate(units) if x == u]])) for u in units]
    for i in np.flatnonzero(~arrays.failed_mask):
        one = drawn_in_si(cycle.plans, values[i])
        for k, column in enumerate(cycle.columns):
            numbers = arrays.table[k, i], loop.table[k, i], column.read_from_drawing(one.things, one.tool.ar)
            assert np.nanmax(np.abs(np.subtract.outer(numbers, numbers))) <= MOST * most[k] or column.beside, (
                column.name
            )


@pytest.mark.slow
@pytest.mark.parametrize("seed", [11, 29])
def test_a_sheet_and_a_note_are_written(seed: int, tmp_path: Path) -> None:
    scene, page, note = (str(tmp_path / f"m.{x}") for x in ("yaml", "svg", "html"))
    Path(scene).write_text(to_yaml(mixed(seed).scene), encoding="utf-8")
    assert main(["sheet", scene, "-o", page]) == 0 and main(["note", scene, "-o", note]) == 0
    assert all(Path(x).stat().st_size > 10_000 for x in (page, note))
