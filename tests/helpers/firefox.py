"""The installed headless Firefox, controlled by WebDriver BiDi: no separate driver is needed."""

from __future__ import annotations

import itertools
import json
import re
import shutil
import subprocess
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

import pytest

from tests.helpers.counting import PATIENCE_S
from tests.helpers.devtools import UNPACKED

NAMES = ("firefox-esr", "firefox")
_LISTENS = re.compile(r"WebDriver BiDi listening on (ws://\S+)")
WATCHED = ("log.entryAdded", "network.beforeRequestSent")


class Firefox:
    """One window, which opens addresses and evaluates expressions; ``errors`` are errors and requests of pages."""

    def __init__(self, address: str) -> None:
        websocket = pytest.importorskip("websocket", reason="install the test extra: pip install -e '.[test]'")
        self.line = websocket.create_connection(f"{address}/session", timeout=PATIENCE_S, suppress_origin=True)
        self.errors: list[str] = []
        self.numbers = itertools.count(1)
        self.ask("session.new", capabilities={})
        self.ask("session.subscribe", events=list(WATCHED))
        self.tab = self.ask("browsingContext.getTree")["contexts"][0]["context"]

    def ask(self, method: str, **params: Any) -> Any:
        """The result of one command; events before it are kept."""
        number = next(self.numbers)
        self.line.send(json.dumps({"id": number, "method": method, "params": params}))
        while True:
            said = json.loads(self.line.recv())
            if said.get("id") == number:
                assert said["type"] == "success", f"{said.get('error')}: {said.get('message')}"
                return said["result"]
            self._heard(said)

    def _heard(self, said: Any) -> None:
        event = said.get("params", {})
        if said.get("method") == "log.entryAdded" and event["level"] in ("error", "warn"):
            self.errors.append(str(event["text"]))
        if said.get("method") == "network.beforeRequestSent":
            url = event["request"]["url"]
            self.errors += [url] if not url.startswith(("file:", "data:", "about:", "blob:")) else []

    def goto(self, address: str) -> None:
        """Opens an address."""
        self.ask("browsingContext.navigate", context=self.tab, url=address, wait="complete")
        self.evaluate(UNPACKED)

    def set_viewport_size(self, size: dict[str, int]) -> None:
        """Sets the size of the page's window."""
        self.ask("browsingContext.setViewport", context=self.tab, viewport=size)

    def evaluate(self, expression: str) -> Any:
        """The value of an expression, as in JSON; a promise is awaited."""
        own = f"with (globalThis.planes ?? {{}}) return JSON.stringify(await ({expression})) ?? 'null';"
        target, text = {"context": self.tab}, f"(async () => {{ {own} }})()"
        found = self.ask("script.evaluate", expression=text, target=target, awaitPromise=True)
        assert found["type"] == "success", found.get("exceptionDetails", {}).get("text")
        return json.loads(found["result"]["value"])

    def wait_for_timeout(self, milliseconds: float) -> None:
        """Lets the page run."""
        self.evaluate(f"new Promise(done => setTimeout(() => done(1), {milliseconds}))")

    def close(self) -> None:
        """Ends the session."""
        self.line.close()


def installed() -> str:
    """The path of Firefox. Without any, the test is skipped with a note on what to install."""
    found = next(filter(None, map(shutil.which, NAMES)), "")
    if not found:
        pytest.skip("no Firefox here: apt-get install firefox-esr")
    return found


@contextmanager
def firefox() -> Iterator[Firefox]:
    """A window of it, if it is :func:`installed`."""
    found = installed()
    with tempfile.TemporaryDirectory(ignore_cleanup_errors=True) as profile:
        command = [found, "--headless", "--no-remote", "--profile", profile, "--remote-debugging-port", "0"]
        with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True) as started:
            try:
                assert started.stderr
                lines = (_LISTENS.search(line) for line in started.stderr)
                window = Firefox(next(one[1] for one in lines if one))
                yield window
                window.close()
            finally:
                started.terminate()
                started.wait(PATIENCE_S)
