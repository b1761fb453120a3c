"""The installed headless Chromium, for tests of pages."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from threading import Thread
from typing import Any

import pytest

from tests.helpers.counting import PATIENCE_S

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


LISTENS = re.compile(r"DevTools listening on (ws://\S+)")


@contextmanager
def chromium() -> Iterator[Any]:
    """A browser. Without any, the test is skipped with a note on what to install."""
    devtools = pytest.importorskip("tests.helpers.devtools", reason="install the test extra: pip install -e '.[test]'")
    program = os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), "")
    if not program:
        pytest.skip("no Chromium here: install it (Debian: apt-get install chromium) or name it in CHROMIUM")
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        own = ["--remote-debugging-port=0", f"--user-data-dir={profile}"]
        command = [program, "--headless", *own, *FLAGS, "about:blank"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as started:
            try:
                assert started.stderr
                address = next(heard[1] for line in started.stderr if (heard := LISTENS.search(line)))
                Thread(target=started.stderr.read, daemon=True).start()  # or it stops at a full pipe
                line = devtools.Line(address)
                yield devtools.Browser(line)
                line.socket.close()
            finally:
                started.terminate()
                started.wait(PATIENCE_S)


def until(page: Any, condition: str) -> None:
    """Waits for an expression to become true; polled from outside, since a page evaluates no text within itself."""
    for _ in range(2000):
        if page.evaluate(condition):
            return
        page.wait_for_timeout(30)
    pytest.fail(f"it has not come to {condition}")


def watched(page: Any) -> list[str]:
    """The errors and network requests of the page."""
    errors: list[str] = []
    page.on("console", lambda m: errors.append(m.text) if m.type in ("error", "warning") else None)
    page.on("pageerror", lambda e: errors.append(str(e)))
    page.on("request", lambda r: errors.append(r.url) if not r.url.startswith(("file:", "data:", "about:")) else None)
    return errors
