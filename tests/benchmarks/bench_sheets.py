"""How long sheets of random mechanisms take, of one to three groups with all their loads: each of them once."""

from __future__ import annotations

from pathlib import Path

import pytest

from planes.documents.sheets import sheet_of
from planes.words.errors import PlanesError
from tests.sheets_run import NUMBERS, Job, at_random, scene_of

MECHANISMS = 100


@pytest.mark.parametrize("number", NUMBERS, ids=lambda n: f"sheet {n}" if n else "one page")
def bench_sheets(benchmark, number: int | None, tmp_path: Path) -> None:
    """The median and the slowest; a warm-up has loaded what is loaded once."""
    jobs = [job for job in at_random(MECHANISMS, tmp_path) if job.number == number]
    draw(jobs[0])
    waiting = iter(jobs)
    benchmark.group, benchmark.extra_info["what"] = "sheets of random mechanisms", f"sheet {number or 'alone'}"
    benchmark.pedantic(draw, setup=lambda: ((next(waiting),), {}), rounds=len(jobs))
    slowest = benchmark.stats.stats.max if benchmark.stats else 0.0
    benchmark.extra_info |= {"positions": 1, "memory": f"slowest {slowest:.1f} s"}


def draw(job: Job) -> None:
    """One sheet, if the scene has one."""
    try:
        sheet_of(scene_of(job), None, job.lang, job.number)
    except PlanesError:
        return
