"""The page of a lesson, written to a folder and opened in a window: nothing is complained of, nothing asked for."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from planes.lesson.data import lesson_data
from planes.scene import load
from planes.words.records import Json
from render.page.lesson_page import page
from tests.helpers.browser import watched


def lesson_written(folder: Path, scene: Path, lang: str = "ru", data: Json | None = None) -> str:
    """The address of the lesson of a scene; ``data`` is what it shows, where that is known."""
    target = folder / f"{scene.stem}.html"
    target.write_text(page(data or lesson_data(load(str(scene))), lang), encoding="utf-8")
    return target.as_uri()


@contextmanager
def lesson_opened(browser: Any, address: str) -> Iterator[Any]:
    """A window with it."""
    one = browser.new_page()
    errors = watched(one)
    one.goto(address)
    yield one
    one.close()
    assert errors == []
