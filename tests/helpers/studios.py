"""The studio for tests: its server, or its files on a plain one; and a hand that draws on its canvas."""

from __future__ import annotations

import subprocess
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import Any

from tests.helpers import ROOT
from tests.helpers.browser import until

INNER = "document.getElementById('lesson').contentWindow.planes"
SEEN = f"{INNER}?.live ? true : false"


@contextmanager
def served(*more: str) -> Iterator[str]:
    """The address of a separate studio, with the token."""
    command = [sys.executable, "-m", "planes", "studio", "--no-browser", "--lang", "en", *more]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True, cwd=ROOT) as started:
        assert started.stdout
        try:
            yield started.stdout.readline().split(" at ")[1].split(";")[0]
        finally:
            started.terminate()


class _Quiet(SimpleHTTPRequestHandler):
    extensions_map = SimpleHTTPRequestHandler.extensions_map | {".mjs": "text/javascript", ".wasm": "application/wasm"}

    def log_message(self, *_: Any) -> None:
        pass


@contextmanager
def behind_files(folder: Path) -> Iterator[str]:
    """The address of a folder on a plain server."""
    server = ThreadingHTTPServer(("127.0.0.1", 0), partial(_Quiet, directory=str(folder)))
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield f"http://127.0.0.1:{server.server_port}/"
    finally:
        server.shutdown()
        server.server_close()


class Hand:
    """A hand on the canvas, in coordinates of the mechanism, m."""

    def __init__(self, page: Any) -> None:
        self.page = page

    @classmethod
    def on_fresh(cls, page: Any) -> Hand:
        """A hand on a new mechanism, from whatever view is shown."""
        page.locator("#views [data-view=gallery]").click()
        page.locator("#fresh").click()
        return cls(page)

    def at(self, x: float, y: float) -> tuple[float, float]:
        """The position on the screen of a point of the mechanism."""
        told = "(() => { const b = document.getElementById('canvas').getBoundingClientRect(),"
        told += f" q = canvas.view.px([{x!r}, {y!r}]); return [b.left + q[0], b.top + q[1]]; }})()"
        left, top = self.page.evaluate(told)
        return left, top

    def tool(self, name: str) -> None:
        """Selects a tool."""
        self.page.locator(f"[data-tool={name}]").click()

    def press(self, x: float, y: float) -> None:
        """Clicks a point."""
        with self.done():
            self.page.mouse.move(*self.at(x, y))
            self.page.mouse.down()
            self.page.mouse.up()

    def drag(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """Drags from one point to another."""
        (a, b), (c, d) = self.at(*start), self.at(*end)
        with self.done():
            self.page.mouse.move(a, b)
            self.page.mouse.down()
            for k in range(1, 5):
                self.page.mouse.move(a + (c - a) * k / 4, b + (d - b) * k / 4)
            self.page.mouse.up()

    @contextmanager
    def done(self) -> Iterator[None]:
        """An action of the hand, until the page has processed it and no request to the engine is open."""
        before = self.page.evaluate("canvas.hands")
        yield
        until(self.page, f"canvas.hands > {before}")
        self.rest()

    def rest(self) -> None:
        """Waits until no request to the engine is open."""
        self.page.wait_for_timeout(60)
        until(self.page, "engine.idle()")

    def points(self) -> dict[str, list[float]]:
        """The points of the sketch."""
        found: dict[str, list[float]] = self.page.evaluate("canvas.sketch.points")
        return found
