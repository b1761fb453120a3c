"""One browser for all tests of pages; each module has a window of its own, with an empty profile."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from planes.lesson.data import lesson_data
from planes.scene import load
from render.page.lesson_page import page as written
from tests.helpers import ROOT
from tests.helpers.browser import chromium, watched
from tests.helpers.counting import PATIENCE_MS


@pytest.fixture(scope="package")
def chrome() -> Iterator[Any]:
    with chromium() as started:
        yield started


@pytest.fixture(scope="module")
def browser(chrome: Any, request: pytest.FixtureRequest) -> Iterator[Any]:
    """A window of the size the module asks for."""
    context = chrome.new_context(viewport=getattr(request.module, "WIDE", {"width": 1200, "height": 1000}))
    context.set_default_timeout(PATIENCE_MS)
    yield context
    context.close()


@pytest.fixture(scope="module")
def lesson(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The lesson of the six links."""
    target = tmp_path_factory.mktemp("lesson") / "lesson.html"
    target.write_text(written(lesson_data(load(str(ROOT / "samples" / "six-link.yaml"))), "ru"), encoding="utf-8")
    return target.as_uri()


@pytest.fixture
def page(browser: Any, lesson: str) -> Iterator[Any]:
    """It in a window; at the end nothing was complained of and nothing asked of the network."""
    one = browser.new_page()
    errors = watched(one)
    one.goto(lesson)
    yield one
    one.close()
    assert errors == []
