"""A headless Chromium for the tests of pages: the system's, or the one Playwright has installed."""

from __future__ import annotations

import os
import shutil
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest

from tests.helpers.counting import PATIENCE_MS

FLAGS = [
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")


@contextmanager
def chromium() -> Iterator[Any]:
    """A browser. Without any the test is skipped, and says what to install."""
    sync = pytest.importorskip("playwright.sync_api", reason="install the test extra: pip install -e '.[test]'")
    with sync.sync_playwright() as tools:
        own = Path(tools.chromium.executable_path)
        system = next(filter(None, map(shutil.which, NAMES)), "")
        found = os.environ.get("CHROMIUM") or (str(own) if own.exists() else system)
        if not found:
            pytest.skip("no Chromium here: apt-get install chromium, or playwright install --with-deps chromium")
        started = tools.chromium.launch(executable_path=found, headless=True, args=FLAGS, timeout=PATIENCE_MS)
        try:
            yield started
        finally:
            started.close()


def until(page: Any, condition: str) -> None:
    """Wait for what an expression says; asked from outside, for a page evaluates no text within itself."""
    for _ in range(2000):
        if page.evaluate(condition):
            return
        page.wait_for_timeout(30)
    pytest.fail(f"it has not come to {condition}")


def watched(page: Any) -> list[str]:
    """What the page complains of, or asks the network for."""
    errors: list[str] = []
    page.on("console", lambda m: errors.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda e: errors.append(str(e)))
    page.on("request", lambda r: errors.append(r.url) if not r.url.startswith(("file:", "data:", "about:")) else None)
    return errors
