"""What a user at a terminal sees during long work: a progress bar where its length is known, otherwise a clock."""

import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from threading import Event, Thread
from typing import Any

CLOCK_DELAY_S = 2.0  # before a clock is shown
CLOCK_STEP_S = 0.5
_BAR_IS_SHOWN = Event()
"""Set while a bar is there, which the clock would disturb."""


@contextmanager
def progress_bar(**how: Any) -> Iterator[Callable[[int, int], None] | None]:
    """A progress bar for a user at a terminal."""
    if not sys.stderr.isatty():
        yield None
        return
    from tqdm import tqdm

    _BAR_IS_SHOWN.set()
    try:
        with tqdm(leave=False, **how) as shown:

            def step(done: int, count: int) -> None:
                shown.total = count
                shown.n = done
                shown.refresh()

            yield step
    finally:
        _BAR_IS_SHOWN.clear()


@contextmanager
def waiting_clock() -> Iterator[None]:
    """A clock at a terminal, shown after the first second, wherever there is no progress bar."""
    if not (sys.stderr and sys.stderr.isatty()):
        yield
        return
    over = Event()
    clock = Thread(target=_show_clock, args=(over,), daemon=True)
    clock.start()
    try:
        yield
    finally:
        over.set()
        clock.join()


def _show_clock(over: Event) -> None:
    begun = time.monotonic()
    shown = False
    while not over.wait(CLOCK_STEP_S):
        passed = time.monotonic() - begun
        if passed >= CLOCK_DELAY_S and not _BAR_IS_SHOWN.is_set():
            print(f"\r… {passed:.0f} s", end="", file=sys.stderr, flush=True)
            shown = True
    if shown:
        print("\r\033[K", end="", file=sys.stderr, flush=True)
