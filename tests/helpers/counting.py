"""Counts work instead of timing it: the number of function calls is the same on a busy machine as on an idle one."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from types import FrameType
from typing import Any

PATIENCE_S = 600  # for another process: it hangs, rather than being slow
PATIENCE_MS = 1000.0 * PATIENCE_S


@contextmanager
def at_most(calls: int) -> Iterator[list[int]]:
    """Limits the number of function calls in its block; the count is in the list."""
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
