"""Every run draws the same random scenes, and none is refused for what a busy machine takes to draw it.

``@pytest.mark.few(n)`` leaves a test with many cases n of them, evenly chosen; the others are slow, with ``slow=m``
so many of them, and the rest long.

``@pytest.mark.needs("scipy")``: without that package the test is skipped, and says so; the extra ``ci`` has them all.
"""

from __future__ import annotations

import gc
import os
import sys
from collections import defaultdict
from importlib.util import find_spec
from pathlib import Path

import pytest
from hypothesis import HealthCheck, settings

if sys.dont_write_bytecode:  # else each worker, and each command a test starts, compiles every module anew
    sys.dont_write_bytecode = False
    os.environ.pop("PYTHONDONTWRITEBYTECODE", None)
    COMPILED = Path(__file__).parents[1] / ".pytest_cache" / "compiled"
    sys.pycache_prefix = os.environ["PYTHONPYCACHEPREFIX"] = str(COMPILED)

os.environ.setdefault("PLANES_CACHE", str(Path(__file__).parents[1] / ".pytest_cache" / "code"))

settings.register_profile(
    "planes", derandomize=True, deadline=None, suppress_health_check=[HealthCheck.too_slow, HealthCheck.data_too_large]
)
settings.load_profile("planes")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Before tests are chosen by their marks."""
    for item in items:
        wanted = [name for mark in item.iter_markers("needs") for name in mark.args]
        if missing := [name for name in wanted if find_spec(name) is None]:
            item.add_marker(pytest.mark.skip(reason=f"without {', '.join(missing)}: pip install -e '.[ci]'"))
    cases: dict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        if item.get_closest_marker("few"):
            cases[item.nodeid.partition("[")[0]].append(item)
    for every in cases.values():
        mark = every[0].get_closest_marker("few")
        fast = _evenly(len(every), mark.args[0] if mark else 0)
        slow = _evenly(len(every), mark.kwargs.get("slow", len(every)) if mark else 0)
        for k, item in enumerate(every):
            if k not in fast:
                item.add_marker("slow" if k in slow else "long")


def pytest_collection_finish() -> None:
    """What was imported and collected stays: the garbage collector need not go through it again and again."""
    gc.collect()
    gc.freeze()
    gc.set_threshold(100_000, 50, 100)


def pytest_sessionfinish() -> None:
    """pytest runs the collector five times at the end: the first run finds what is left, the others search little."""
    gc.collect()
    gc.freeze()


def _evenly(count: int, some: int) -> set[int]:
    return {round((k + 0.5) * (count - 1) / some) for k in range(some)} if some < count else set(range(count))
