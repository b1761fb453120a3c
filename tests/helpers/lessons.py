"""The page of a lesson, written to a folder and opened in a window: without errors or network requests."""

from __future__ import annotations

import base64
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
from render.page.lesson_page import whole_lesson_page
from render.page.web_page import BASE85_TRANSLATION
from tests.helpers.browser import watched


def lesson_written(folder: Path, scene: Path, lang: str = "ru", data: Json | None = None) -> str:
    """The address of the lesson of a scene; ``data`` is its content, if known."""
    target = folder / f"{scene.stem}.html"
    target.write_text(whole_lesson_page(data or lesson_data(load(str(scene))), lang), encoding="utf-8")
    return target.as_uri()


def brought(text: str) -> dict[str, str]:
    """The packed content of a page, by its ids."""
    found = re.search(r'id="code">(.*?)</script>', text)
    assert found
    standard = {ours: python for python, ours in BASE85_TRANSLATION.items()}
    data = base64.b85decode(json.loads(found[1]).translate(standard))
    whole = json.loads(zlib.decompress(data, -zlib.MAX_WBITS))
    return {key: content for key, _, content in whole}


@contextmanager
def lesson_opened(browser: Any, address: str) -> Iterator[Any]:
    """A window with the lesson."""
    one = browser.new_page()
    errors = watched(one)
    one.goto(address)
    yield one
    one.close()
    assert errors == []
