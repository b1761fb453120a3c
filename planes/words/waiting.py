"""What a user at a terminal sees during long work: a progress bar where its length is known, otherwise a clock."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Event, Thread
from typing import Any

PATIENCE_S = 2.0  # before a clock is shown
TICK_S = 0.5
_BAR = Event()
"""Set while a bar is there, which the clock would disturb."""


@contextmanager
def bar(**how: Any) -> Iterator[Callable[[int, int], None] | None]:
    """A progress bar for a user at a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from tqdm import tqdm

    _BAR.set()
    try:
        with tqdm(leave=False, **how) as shown:

            def step(done: int, count: int) -> None:
                shown.total, shown.n = count, done
                shown.refresh()

            yield step
    finally:
        _BAR.clear()


@contextmanager
def waiting() -> Iterator[None]:
    """A clock at a terminal, shown after the first second, wherever there is no progress bar."""
    if not (sys.stderr and sys.stderr.isatty()):
        yield
        return
    over = Event()
    clock = Thread(target=_ticking, args=(over,), daemon=True)
    clock.start()
    try:
        yield
    finally:
        over.set()
        clock.join()


def _ticking(over: Event) -> None:
    begun, shown = time.monotonic(), False
    while not over.wait(TICK_S):
        passed = time.monotonic() - begun
        if passed >= PATIENCE_S and not _BAR.is_set():
            print(f"\r… {passed:.0f} s", end="", file=sys.stderr, flush=True)
            shown = True
    if shown:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
