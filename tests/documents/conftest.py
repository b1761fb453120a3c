"""One browser for all tests of pages; each module has a window of its own, with an empty profile."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from tests.helpers import ROOT
from tests.helpers.browser import chromium
from tests.helpers.lessons import lesson_opened, lesson_written


@pytest.fixture(scope="package")
def chrome() -> Iterator[Any]:
    with chromium() as started:
        yield started


@pytest.fixture(scope="module")
def browser(chrome: Any, request: pytest.FixtureRequest) -> Iterator[Any]:
    """A window of the size the module asks for."""
    context = chrome.new_context(viewport=getattr(request.module, "WIDE", {"width": 1200, "height": 1000}))
    yield context
    context.close()


@pytest.fixture(scope="module")
def lesson(tmp_path_factory: pytest.TempPathFactory) -> str:
    """The lesson of the six links."""
    return lesson_written(tmp_path_factory.mktemp("lesson"), ROOT / "samples" / "six-link.yaml")


@pytest.fixture
def page(browser: Any, lesson: str) -> Iterator[Any]:
    """It in a window; at the end nothing was complained of and nothing asked of the network."""
    with lesson_opened(browser, lesson) as one:
        yield one
