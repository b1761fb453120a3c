"""The page of a lesson, written to a folder and opened in a window: nothing is complained of, nothing asked for."""

from __future__ import annotations

import json
import re
import zlib
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from planes.lesson.data import lesson_data
from planes.scene import load
from planes.words.records import Json
from render.page.lesson_page import page
from render.page.web_page import LETTERS
from tests.helpers.browser import watched


def lesson_written(folder: Path, scene: Path, lang: str = "ru", data: Json | None = None) -> str:
    """The address of the lesson of a scene; ``data`` is what it shows, where that is known."""
    target = folder / f"{scene.stem}.html"
    target.write_text(page(data or lesson_data(load(str(scene))), lang), encoding="utf-8")
    return target.as_uri()


def brought(text: str) -> dict[str, str]:
    """What a page brings along packed, by its ids."""
    found = re.search(r'id="code">(.*?)</script>', text)
    assert found
    letters = json.loads(found[1])
    short = -len(letters) % 5
    numbers = [int(LETTERS.index(c)) for c in letters + LETTERS[84] * short]
    fours = (sum(n * 85 ** (4 - k) for k, n in enumerate(numbers[at : at + 5])) for at in range(0, len(numbers), 5))
    data = b"".join(four.to_bytes(4, "big") for four in fours)
    whole = json.loads(zlib.decompress(data[: len(data) - short], -zlib.MAX_WBITS))
    return {key: content for key, _, content in whole}


@contextmanager
def lesson_opened(browser: Any, address: str) -> Iterator[Any]:
    """A window with it."""
    one = browser.new_page()
    errors = watched(one)
    one.goto(address)
    yield one
    one.close()
    assert errors == []
