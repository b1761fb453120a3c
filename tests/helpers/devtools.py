"""A window of Chromium, controlled by its DevTools protocol: https://chromedevtools.github.io/devtools-protocol/.

A page has the methods of browser tests: go to an address, evaluate, click, type, drag. An action on an element waits
until it is visible and nothing covers it.
"""

from __future__ import annotations

import base64
import itertools
import json
import re
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import websocket

from tests.helpers.counting import PATIENCE_S

BEAT_S = 0.02  # polling interval
UNPACKED = """new Promise(done => {
  const packed = () => document.readyState !== "complete" || document.getElementById("code") && !globalThis.planes;
  const look = left => packed() && left ? setTimeout(look, 10, left - 1) : done();
  look(1000);
})"""
"""Whether a page is loaded and its script unpacked."""
FUNCTION = re.compile(r"\s*(async\s*)?(\([\w\s,{}\[\].]*\)|\w+)\s*=>|\s*(async\s+)?function\b")
MODIFIERS = {"Alt": 1, "Control": 2, "Meta": 4, "Shift": 8}
KEYS = {
    "Enter": 13, "Tab": 9, "Escape": 27, "Backspace": 8, "Delete": 46, "End": 35, "Home": 36,
    "PageUp": 33, "PageDown": 34,
    "ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, " ": 32,
}  # fmt: skip
TYPED = {"Enter": "\r", "Tab": "\t"}
PICK = """const pick = steps => steps.reduce((all, [verb, by]) => verb === 'nth' ? all.slice(by, by + 1)
  : verb === 'text' ? all.filter(e => e.textContent.toLowerCase().includes(by.toLowerCase()))
  : all.flatMap(e => [...e.querySelectorAll(by)]), [document]);"""
SEEN = "const seen = e => e && e.getClientRects().length && getComputedStyle(e).visibility !== 'hidden';"
READY = """const e = all[0]; if (!seen(e)) return null; e.scrollIntoView({ block: 'nearest', inline: 'nearest' });
  await new Promise(drawn => { requestAnimationFrame(() => requestAnimationFrame(drawn)); setTimeout(drawn, 200); });
  const b = e.getBoundingClientRect(), x = b.x + b.width / 2, y = b.y + b.height / 2;
  const top = document.elementFromPoint(x, y);
  return top && (e === top || e.contains(top) || top.contains(e)) && !e.disabled ? [x, y] : null;"""
CHOOSE = """const e = all[0]; if (!seen(e)) return false;
  const k = by.index ?? [...e.options].findIndex(o => o.value === by.value);
  if (k < 0 || !e.options[k]) return false; e.selectedIndex = k;
  for (const kind of ['input', 'change']) e.dispatchEvent(new Event(kind, { bubbles: true })); return true;"""


class Line:
    """The connection to a browser: commands are answered in turn, events between the answers go to their page."""

    def __init__(self, address: str) -> None:
        self.socket = websocket.create_connection(address, timeout=PATIENCE_S, suppress_origin=True)
        self.numbers = itertools.count(1)
        self.pages: dict[str, Page] = {}
        self.happened: list[tuple[str, dict[str, Any]]] = []  # events of the browser itself

    def ask(self, method: str, session: str = "", **params: Any) -> Any:
        """The result of one command."""
        number = next(self.numbers)
        order = {"id": number, "method": method, "params": params} | ({"sessionId": session} if session else {})
        self.socket.send(json.dumps(order))
        while True:
            answer = self.heard()
            if answer.get("id") == number:
                assert "error" not in answer, f"{method}: {answer['error']['message']}"
                return answer["result"]

    def heard(self) -> Any:
        """The next answer; an event is passed on."""
        said = json.loads(self.socket.recv())
        if "method" in said:
            page = self.pages.get(said.get("sessionId", ""))
            (page.event if page else lambda *event: self.happened.append(event))(said["method"], said["params"])
        return said

    def listen(self, seconds: float) -> None:
        """Receives events for a while."""
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            self.socket.settimeout(max(left, 1e-3))
            try:
                self.heard()
            except websocket.WebSocketTimeoutException:
                break
            finally:
                self.socket.settimeout(PATIENCE_S)


class Browser:
    """A browser, or a separate profile in it: pages open with its window size."""

    def __init__(self, line: Line, profile: str = "", viewport: dict[str, int] | None = None) -> None:
        self.line, self.profile, self.viewport = line, profile, viewport or {"width": 1280, "height": 720}

    def new_context(self, viewport: dict[str, int] | None = None) -> Browser:
        """An empty profile."""
        return Browser(self.line, self.line.ask("Target.createBrowserContext")["browserContextId"], viewport)

    def new_page(self, viewport: dict[str, int] | None = None) -> Page:
        """An empty page."""
        within = {"browserContextId": self.profile} if self.profile else {}
        return Page(
            self,
            self.line.ask("Target.createTarget", url="about:blank", **within)["targetId"],
            viewport or self.viewport,
        )

    def close(self) -> None:
        """Closes the profile with its pages."""
        if self.profile:
            self.line.ask("Target.disposeBrowserContext", browserContextId=self.profile)


class Asked:
    """Queries of the elements found by a selector: of the first of them, where one is meant."""

    page: Page

    def steps_to(self, selector: str) -> list[tuple[str, Any]]:
        """The search for elements: CSS selectors, ``text=`` words in them and ``nth=`` numbers, separated by ``>>``."""
        steps: list[tuple[str, Any]] = []
        for step in filter(None, selector.split(" >> ")):
            verb, _, rest = step.partition("=")
            by = {"text": ("text", rest), "nth": ("nth", int(rest) if verb == "nth" else 0)}
            steps.append(by.get(verb, ("css", step)))
        return steps

    def _of(self, selector: str, body: str, by: Any = None) -> Any:
        given = f"const all = pick({json.dumps(self.steps_to(selector))}), by = {json.dumps(by)};"
        return self.page.evaluate(f"(async () => {{ await {UNPACKED}; {PICK} {SEEN} {given} {body} }})()")

    def _wait(self, selector: str, body: str, by: Any = None) -> Any:
        end = time.monotonic() + PATIENCE_S
        while not (answer := self._of(selector, body, by)):
            assert time.monotonic() < end, f"{selector}: it cannot be seen, is covered or disabled"
            self.page.wait_for_timeout(1000 * BEAT_S)
        return answer

    def inner_text(self, selector: str = "") -> str:
        """Its visible text."""
        return str(self._wait(selector, "return all[0] && [all[0].innerText];")[0])

    def inner_html(self, selector: str = "") -> str:
        """Its content as HTML."""
        return str(self._wait(selector, "return all[0] && [all[0].innerHTML];")[0])

    def get_attribute(self, selector: str, name: str) -> Any:
        """One of its attributes."""
        return self._wait(selector, "return all[0] && [all[0].getAttribute(by)];", name)[0]

    def input_value(self, selector: str = "") -> str:
        """The text typed in it."""
        return str(self._wait(selector, "return all[0] && [all[0].value];")[0])

    def is_visible(self, selector: str = "") -> bool:
        """Whether it is visible."""
        return bool(self._of(selector, "return !!seen(all[0]);"))

    def is_disabled(self, selector: str = "") -> bool:
        """Whether it is disabled."""
        return bool(self._wait(selector, "return all[0] && [all[0].disabled];")[0])

    def is_enabled(self, selector: str = "") -> bool:
        """Whether it is enabled."""
        return not self.is_disabled(selector)

    def click(self, selector: str = "") -> None:
        """Clicks it."""
        self.page.mouse.click(*self._wait(selector, READY))

    def hover(self, selector: str = "") -> None:
        """Moves the pointer over it."""
        self.page.mouse.move(*self._wait(selector, READY))

    def focus(self, selector: str = "") -> None:
        """Gives it the keyboard focus."""
        self._wait(selector, "if (!all[0]) return false; all[0].focus(); return true;")

    def fill(self, selector: str, text: str) -> None:
        """Replaces its text."""
        self._wait(
            selector, "const e = all[0]; if (!seen(e) || e.disabled) return false; e.focus(); e.select(); return true;"
        )
        self.page.ask("Input.insertText", text=text)

    def select_option(self, selector: str, value: str | None = None, index: int | None = None) -> None:
        """Selects from a list."""
        self._wait(selector, CHOOSE, {"value": value} if index is None else {"index": index})

    def check(self, selector: str, wanted: bool = True) -> None:
        """Ticks it."""
        if self._wait(selector, "return all[0] && [all[0].checked];")[0] != wanted:
            self.click(selector)

    def uncheck(self, selector: str) -> None:
        """Unticks it."""
        self.check(selector, False)


@dataclass
class Locator(Asked):
    """All elements found along a path through the page."""

    page: Page
    way: list[tuple[str, Any]]

    def steps_to(self, selector: str) -> list[tuple[str, Any]]:
        """Continues from these."""
        return [*self.way, *super().steps_to(selector)]

    def locator(self, selector: str) -> Locator:
        """Those inside these."""
        return Locator(self.page, self.steps_to(selector))

    def nth(self, k: int) -> Locator:
        """One of them."""
        return Locator(self.page, [*self.way, ("nth", k)])

    @property
    def first(self) -> Locator:
        """The first of them."""
        return self.nth(0)

    def count(self) -> int:
        """The number of elements."""
        return int(self._of("", "return all.length;"))

    def bounding_box(self) -> dict[str, float]:
        """The box of the first one in the window, in pixels."""
        body = "const b = all[0]?.getBoundingClientRect(); return b && b.toJSON();"
        return dict(self._wait("", body))


class Frame:
    """A document: the page's or a nested one."""

    def __init__(self, page: Page, context: int) -> None:
        self.page, self.context = page, context

    def evaluate(self, expression: str) -> Any:
        """The value of an expression, as in JSON; a promise is awaited."""
        return self.page.evaluated(expression, contextId=self.context)


class Page(Asked):
    """One page. ``on`` registers listeners for ``console``, ``pageerror`` and ``request``."""

    def __init__(self, browser: Browser, target: str, viewport: dict[str, int]) -> None:
        self.browser, self.line, self.target, self.page = browser, browser.line, target, self
        self.session = self.line.ask("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        self.line.pages[self.session] = self
        self.hearers: dict[str, list[Callable[[Any], None]]] = {}
        self.errors: list[str] = []
        self.loaded, self.contexts = 0, dict[str, int]()  # number of documents loaded; frames and their contexts
        self.mouse, self.keyboard = Mouse(self), Keyboard(self)
        for room in ("Page", "Runtime", "Log", "Network", "DOM"):
            self.ask(f"{room}.enable")
        self.set_viewport_size(viewport)

    def ask(self, method: str, **params: Any) -> Any:
        """The result of one command of the protocol."""
        return self.line.ask(method, self.session, **params)

    def on(self, kind: str, hearer: Callable[[Any], None]) -> None:
        """Registers a listener for events of a kind."""
        self.hearers.setdefault(kind, []).append(hearer)

    def event(self, method: str, said: dict[str, Any]) -> None:
        """Handles an event of the page."""
        if method == "Page.loadEventFired":
            self.loaded += 1
        elif method == "Runtime.executionContextCreated" and said["context"]["auxData"].get("isDefault"):
            self.contexts[said["context"]["auxData"]["frameId"]] = said["context"]["id"]
        elif method == "Runtime.consoleAPICalled":
            words = " ".join(str(a.get("value", a.get("description", ""))) for a in said["args"])
            self._tell("console", SimpleNamespace(type=said["type"], text=words))
        elif method == "Log.entryAdded":
            self._tell("console", SimpleNamespace(type=said["entry"]["level"], text=said["entry"]["text"]))
        elif method == "Runtime.exceptionThrown":
            thrown = said["exceptionDetails"]
            self._tell("pageerror", thrown.get("exception", {}).get("description", thrown["text"]))
        elif method == "Network.requestWillBeSent":
            self._tell("request", SimpleNamespace(url=said["request"]["url"]))

    def _tell(self, kind: str, what: Any) -> None:
        for hearer in self.hearers.get(kind, ()):
            hearer(what)

    def goto(self, address: str) -> None:
        """Opens an address and waits until it is loaded."""
        before = self.loaded
        went = self.ask("Page.navigate", url=address)
        assert "errorText" not in went, f"{address}: {went['errorText']}"
        while "loaderId" in went and self.loaded == before:
            self.line.heard()
        self.evaluated(UNPACKED)

    def set_content(self, text: str) -> None:
        """Shows a given document."""
        self.ask("Page.setDocumentContent", frameId=self.target, html=text)

    def evaluate(self, expression: str, given: Any = None) -> Any:
        """The value of an expression, or of a function of ``given``; a promise is awaited."""
        return self.evaluated(f"({expression})({json.dumps(given)})" if FUNCTION.match(expression) else expression)

    def evaluated(self, expression: str, **where: Any) -> Any:
        """The value of an expression, as in JSON, with the page's names."""
        expression = f"with (globalThis.planes ?? {{}}) {{ {expression}\n}}"
        how = {"returnByValue": True, "awaitPromise": True, "userGesture": True}
        answer = self.ask("Runtime.evaluate", expression=expression, **how, **where)
        assert "exceptionDetails" not in answer, (
            answer["exceptionDetails"].get("exception", {}).get("description", expression)
        )
        result = answer["result"]
        return (
            float(result["unserializableValue"].rstrip("n")) if "unserializableValue" in result else result.get("value")
        )

    @property
    def frames(self) -> list[Frame]:
        """The document and those nested in it."""
        return [Frame(self, context) for context in self.contexts.values()]

    def locator(self, selector: str) -> Locator:
        """All elements found by a selector."""
        return Locator(self, self.steps_to(selector))

    def title(self) -> str:
        """The title of the document."""
        return str(self.evaluate("document.title"))

    def wait_for_timeout(self, milliseconds: float) -> None:
        """Lets it run for a while."""
        self.line.listen(milliseconds / 1000)

    def wait_for_function(self, expression: str) -> None:
        """Waits until an expression is true."""
        end = time.monotonic() + PATIENCE_S
        while not self.evaluate(expression):
            assert time.monotonic() < end, f"it has not come to {expression}"
            self.wait_for_timeout(1000 * BEAT_S)

    def set_viewport_size(self, size: dict[str, int]) -> None:
        """Sets the size of the page's window."""
        self.ask("Emulation.setDeviceMetricsOverride", **size, deviceScaleFactor=1, mobile=False)

    def emulate_media(
        self, media: str | None = None, color_scheme: str | None = None, reduced_motion: str | None = None
    ) -> None:
        """Screen or print; light or dark; moving or still."""
        asked = {"prefers-color-scheme": color_scheme, "prefers-reduced-motion": reduced_motion}
        features = [{"name": name, "value": value} for name, value in asked.items() if value]
        self.ask("Emulation.setEmulatedMedia", **({"media": media} if media else {}), features=features)

    def pdf(self, path: str = "", prefer_css_page_size: bool = False) -> bytes:
        """The page in print."""
        margins = dict.fromkeys(("marginTop", "marginBottom", "marginLeft", "marginRight"), 0)
        data = base64.b64decode(self.ask("Page.printToPDF", preferCSSPageSize=prefer_css_page_size, **margins)["data"])
        if path:
            Path(path).write_bytes(data)
        return data

    def screenshot(self, path: str) -> None:
        """A screenshot as PNG."""
        Path(path).write_bytes(base64.b64decode(self.ask("Page.captureScreenshot")["data"]))

    def set_input_files(self, selector: str, file: str) -> None:
        """Selects a file."""
        root = self.ask("DOM.getDocument")["root"]["nodeId"]
        node = self.ask("DOM.querySelector", nodeId=root, selector=selector)["nodeId"]
        self.ask("DOM.setFileInputFiles", files=[file], nodeId=node)

    def drop_files(self, selector: str, *files: str) -> None:
        """Drags files from outside the browser and drops them on it."""
        x, y = self._wait(selector, READY)
        data = {"items": [], "files": list(files), "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.ask("Input.dispatchDragEvent", type=kind, x=x, y=y, data=data)

    @contextmanager
    def expect_download(self) -> Iterator[SimpleNamespace]:
        """Waits for a file saved by the page; ``value.save_as`` keeps it."""
        within = {"browserContextId": self.browser.profile} if self.browser.profile else {}
        with tempfile.TemporaryDirectory() as folder:
            how: Any = {"behavior": "allowAndName", "downloadPath": folder, "eventsEnabled": True}
            self.line.ask("Browser.setDownloadBehavior", **how, **within)
            self.line.happened.clear()
            saving = SimpleNamespace()
            yield saving
            end = time.monotonic() + PATIENCE_S
            while not any(m == "Browser.downloadProgress" and p["state"] == "completed" for m, p in self.line.happened):
                assert time.monotonic() < end, "nothing was saved"
                self.wait_for_timeout(1000 * BEAT_S)
            data = next(Path(folder).iterdir()).read_bytes()
        saving.value = SimpleNamespace(save_as=lambda path: Path(path).write_bytes(data))

    def close(self) -> None:
        """Closes it."""
        self.line.pages.pop(self.session)
        self.line.ask("Target.closeTarget", targetId=self.target)


class Mouse:
    """The pointer and its left button."""

    def __init__(self, page: Page) -> None:
        self.page, self.at, self.held, self.shift = page, (0.0, 0.0), 0, 0

    def _send(self, kind: str, **more: Any) -> None:
        x, y = self.at
        self.page.ask("Input.dispatchMouseEvent", type=kind, x=x, y=y, buttons=self.held, modifiers=self.shift, **more)

    def move(self, x: float, y: float, steps: int = 1) -> None:
        """Moves to a point in the window, in this number of steps."""
        (x0, y0) = self.at
        for k in range(1, steps + 1):
            self.at = x0 + (x - x0) * k / steps, y0 + (y - y0) * k / steps
            self._send("mouseMoved", button="left" if self.held else "none")

    def down(self, shift: bool = False) -> None:
        """Presses the button, with or without the Shift key."""
        self.held, self.shift = 1, MODIFIERS["Shift"] * shift
        self._send("mousePressed", button="left", clickCount=1)

    def up(self) -> None:
        """Releases it."""
        self.held = 0
        self._send("mouseReleased", button="left", clickCount=1)
        self.shift = 0

    def click(self, x: float, y: float) -> None:
        """Clicks at a point."""
        self.move(x, y)
        self.down()
        self.up()


class Keyboard:
    """The keyboard."""

    def __init__(self, page: Page) -> None:
        self.page = page

    def press(self, keys: str) -> None:
        """Presses one key with its modifiers: ``Shift+ArrowUp``."""
        *held, key = keys.split("+")
        modifiers = sum(MODIFIERS[name] for name in held)
        typed = "" if modifiers & ~MODIFIERS["Shift"] else TYPED.get(key, key if len(key) == 1 else "")
        code = KEYS.get(key, ord(key.upper()) if len(key) == 1 and key.isalnum() else 0)
        how = {
            "key": key,
            "code": f"Key{key.upper()}" if key.isalpha() and len(key) == 1 else key,
            "modifiers": modifiers,
        }
        every = {"commands": ["selectAll"]} if keys == "Control+A" else {}
        sort = "keyDown" if typed else "rawKeyDown"
        self.page.ask("Input.dispatchKeyEvent", type=sort, text=typed, windowsVirtualKeyCode=code, **how, **every)
        self.page.ask("Input.dispatchKeyEvent", type="keyUp", windowsVirtualKeyCode=code, **how)

    def type(self, text: str) -> None:
        """Types character by character."""
        for letter in text:
            self.press(letter)
