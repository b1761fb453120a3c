"""One browser for all tests of pages; each module has a window of its own, with an empty profile."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import pytest

from tests.helpers.browser import chromium
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
