"""How long chains of many links take: the summary of a cycle, the structure, a sheet."""

from __future__ import annotations

import tempfile
from pathlib import Path

import pytest
from conftest import peak_of

from planes.diagrams.summary import summarise_cycle
from planes.diagrams.text import summary_json
from planes.documents.sheets import sheet_of
from planes.plans import plans_of
from planes.plans.assur.analysis import analyse_structure
from planes.scene import loads
from tests.diagrams.test_degenerate import chain


def timed(benchmark, group: str, links: int, positions: int, memory: str) -> None:
    benchmark.group, benchmark.extra_info["what"] = group, f"{links} links"
    benchmark.extra_info |= {"positions": positions, "memory": memory}


def of_process(links: int, command: str) -> str:
    """The memory the whole command takes."""
    with tempfile.TemporaryDirectory() as folder:
        scene = Path(folder) / "chain.yaml"
        scene.write_text(chain(links // 2), encoding="utf-8")
        return peak_of([word.format(scene) for word in command.split()])


@pytest.mark.parametrize("links", [21, 51])
def bench_cycle_of_a_chain(benchmark, links: int) -> None:
    scene = loads(chain(links // 2))
    timed(benchmark, "a cycle's summary", links, 721, of_process(links, "cycle {} --json"))
    benchmark.pedantic(lambda: summary_json(summarise_cycle(scene, plans_of(scene.mechanism))), rounds=1)


@pytest.mark.parametrize("links", [51, 201])
def bench_structure_of_a_chain(benchmark, links: int) -> None:
    mechanism = loads(chain(links // 2)).mechanism
    timed(benchmark, "structure", links, 1, of_process(links, "structure {}"))
    benchmark(analyse_structure, mechanism)


@pytest.mark.parametrize("links", [11, 21])
def bench_sheet_of_a_chain(benchmark, links: int) -> None:
    scene = loads(chain(links // 2))
    timed(benchmark, "a sheet", links, 1, of_process(links, "sheet {0} -o {0}.svg"))
    benchmark.pedantic(lambda: sheet_of(scene, None, "ru"), rounds=1)
