"""Work counted, not timed: how many functions are called, so that a busy machine passes what an idle one does."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

PATIENCE_S = 600  # for another process: it has hung, not merely been slow
PATIENCE_MS = 1000.0 * PATIENCE_S


@contextmanager
def at_most(calls: int) -> Iterator[list[int]]:
    """What stands within may call so many functions; the count is in the list."""
    made = [0]

    def count(frame: FrameType, event: str, arg: Any) -> None:
        if event in ("call", "c_call"):
            made[0] += 1
            if made[0] > calls:
                sys.setprofile(None)
                raise AssertionError(f"more than {calls} functions are called")

    sys.setprofile(count)
    try:
        yield made
    finally:
        sys.setprofile(None)
