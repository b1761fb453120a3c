"""How long chains of many links take: the summary of a cycle, the structure, a sheet."""

from __future__ import annotations

import pytest

from planes.diagrams.summary import summary
from planes.diagrams.text import as_json
from planes.documents import sheet_of
from planes.plans import plans_of
from planes.plans.structure import analyse
from planes.scene import loads
from tests.diagrams.test_degenerate import chain


@pytest.mark.parametrize("links", [21, 51])
def bench_cycle_of_a_chain(benchmark, links: int) -> None:
    scene = loads(chain(links // 2))
    benchmark.group, benchmark.extra_info["what"] = "a cycle's summary", f"{links} links"
    benchmark.extra_info["positions"] = 721
    benchmark.pedantic(lambda: as_json(summary(scene, plans_of(scene.mechanism))), rounds=1)


@pytest.mark.parametrize("links", [51, 201])
def bench_structure_of_a_chain(benchmark, links: int) -> None:
    mechanism = loads(chain(links // 2)).mechanism
    benchmark.group, benchmark.extra_info["what"] = "structure", f"{links} links"
    benchmark.extra_info["positions"] = 1
    benchmark(analyse, mechanism)


def bench_sheet_of_a_chain(benchmark) -> None:
    scene = loads(chain(10))
    benchmark.group, benchmark.extra_info["what"] = "a sheet", "21 links"
    benchmark.extra_info["positions"] = 1
    benchmark.pedantic(lambda: sheet_of(scene, None, "ru"), rounds=1)
