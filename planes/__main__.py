"""The entry and the exit of the program: ``planes``, ``python -m planes``. No exit leaves an unfinished file.

A signal becomes an exit from any point of the program, so that every draft is deleted; the status is 128 plus its
number.
"""

import gc
import os
import signal
import sys
from typing import NoReturn, TextIO

ENDS = [getattr(signal, name) for name in ("SIGTERM", "SIGHUP") if hasattr(signal, name)]


def run() -> int:
    """The command line from start to end; returns the exit status."""
    for one in ENDS:
        if signal.getsignal(one) is not signal.SIG_IGN:  # as under nohup
            signal.signal(one, _ended)
    try:
        gc.disable()  # while modules are imported, and for commands that are short
        gc.set_threshold(100_000)
        from planes.cli import main

        return main()
    except KeyboardInterrupt:
        return 128 + signal.SIGINT
    finally:
        gc.freeze()  # or the interpreter would search everything for cycles once more at its end
        for stream in (sys.stdout, sys.stderr):
            _drop_unread_output(stream)


def _ended(number: int, _: object) -> NoReturn:
    """Leave, with signals ignored during the clean-up."""
    for one in ENDS:
        signal.signal(one, signal.SIG_IGN)
    sys.exit(128 + number)


def _drop_unread_output(stream: TextIO | None) -> None:
    """Output that nobody reads any more is dropped without the interpreter's message."""
    if stream is None:
        return
    try:
        stream.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), stream.fileno())


if __name__ == "__main__":
    sys.exit(run())
