"""How long it takes to find places for the labels of a crowded sheet."""

from __future__ import annotations

import pytest

from render.labels import place_labels
from tests.render.test_labels import FIELD, scene


@pytest.mark.parametrize("count", [30, 100])
def bench_labels(benchmark, count: int) -> None:
    labels, marks = scene(count, 2 * count, 5)
    benchmark.group, benchmark.extra_info["what"] = "labels of an A3 sheet", f"{count} labels"
    benchmark.extra_info["positions"] = count
    benchmark(place_labels, labels, marks, FIELD)
