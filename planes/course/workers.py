"""Parallel work: in this process, in processes of this machine, or by the workers of a Dask cluster.

A task is a module's function and its arguments, all of it plain data; the result does not depend on the worker. Nothing
is shared: workers read and write no files.
"""

import logging
import os
from asyncio import CancelledError
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager, suppress
from importlib import import_module
from typing import Any, Protocol, TypeVar

from planes.words import Phrase
from planes.words.errors import PlanesError

Task = TypeVar("Task")
Done = TypeVar("Done")
Answers = Iterator[tuple[int, Done]]


class Each(Protocol):
    """Applies a function to each of many items: yields (index, result) as they finish."""

    def __call__(self, work: Callable[[Task], Done], tasks: Sequence[Task], /) -> Answers[Done]: ...


SCHEDULER_TIMEOUT_S = 10  # seconds to find a scheduler


@contextmanager
def start_workers(jobs: int | None = None, scheduler: str | None = None, ready: Sequence[str] = ()) -> Iterator[Each]:
    """Workers for tasks: ``jobs`` processes (None: one per core), or those of a Dask ``scheduler``.

    ``ready`` are modules imported once for all processes.
    """
    count = jobs or usable_core_count()
    if scheduler:
        with _dask_workers(scheduler) as each:
            yield each
    elif count == 1:
        yield _run_without_workers
    else:
        with _start_processes(count, ready) as each:
            yield each


def usable_core_count() -> int:
    """How many processes may run at once here."""
    if hasattr(os, "sched_getaffinity"):
        return len(os.sched_getaffinity(0))
    return os.cpu_count() or 1


def _run_without_workers(work: Callable[[Task], Done], tasks: Sequence[Task]) -> Answers[Done]:
    yield from ((k, work(task)) for k, task in enumerate(tasks))


@contextmanager
def _start_processes(count: int, ready: Sequence[str]) -> Iterator[Each]:
    """Processes forked from one that has already imported all modules; they end when this one does, however it ends."""
    import multiprocessing
    from concurrent.futures import ProcessPoolExecutor, as_completed
    from concurrent.futures.process import BrokenProcessPool

    way = "forkserver" if "forkserver" in multiprocessing.get_all_start_methods() else "spawn"
    context: Any = multiprocessing.get_context(way)
    pool = ProcessPoolExecutor(count, context, _end_with_parent)

    def each(work: Callable[[Task], Done], tasks: Sequence[Task]) -> Answers[Done]:
        with _without_signals():
            waiting = {pool.submit(work, task): k for k, task in enumerate(tasks)}
        for done in as_completed(waiting):
            yield waiting.pop(done), done.result()

    try:
        if way == "forkserver":
            context.set_forkserver_preload(list(ready))
            _await_imports(context.Process(target=_end_with_parent))
        yield each
    except BrokenProcessPool:
        raise PlanesError(Phrase("course_worker_lost")) from None
    except (SystemExit, KeyboardInterrupt):
        _end_all_workers()
        raise
    finally:
        pool.shutdown(wait=True, cancel_futures=True)


def _await_imports(first: Any) -> None:
    """Wait until a first process exists, so that their common parent has imported all modules; signals are handled
    meanwhile."""
    from threading import Thread

    def start() -> None:
        with suppress(EOFError, OSError):  # it was ended
            first.start()

    starting = Thread(target=start, daemon=True)
    starting.start()
    while starting.is_alive():
        starting.join(0.1)


@contextmanager
def _without_signals() -> Iterator[None]:
    """A short section without signals: a half-created process would belong to nobody."""
    import signal

    if not hasattr(signal, "pthread_sigmask"):
        yield
        return
    before = signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGINT, signal.SIGTERM, signal.SIGHUP})
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def _end_all_workers() -> None:
    """End all workers now, whatever they are doing: their results are no longer wanted, and they write no files. The
    same goes for their parent process, which may still be importing."""
    import multiprocessing
    import multiprocessing.forkserver
    import signal

    maker: Any = getattr(multiprocessing.forkserver, "_forkserver", None)
    if pid := getattr(maker, "_forkserver_pid", None):
        with suppress(OSError):
            os.kill(pid, signal.SIGKILL)
    for worker in multiprocessing.active_children():
        worker.terminate()


def _end_with_parent() -> None:
    """End this worker as soon as the process it works for is gone."""
    import multiprocessing
    import signal
    import threading

    signal.signal(signal.SIGINT, signal.SIG_IGN)  # the caller decides
    if parent := multiprocessing.parent_process():

        def wait() -> None:
            parent.join()
            os._exit(1)

        threading.Thread(target=wait, daemon=True).start()


@contextmanager
def _dask_workers(address: str) -> Iterator[Each]:
    """The workers of a Dask scheduler."""
    try:
        dask: Any = import_module("distributed")
    except ImportError:
        raise PlanesError(Phrase("course_no_dask")) from None
    logging.getLogger("distributed").setLevel(logging.CRITICAL)  # an error is reported in one sentence
    try:
        client = dask.Client(address, timeout=SCHEDULER_TIMEOUT_S)
    except (OSError, ValueError) as error:
        reason = str(error).partition("\n")[0]
        raise PlanesError(Phrase("course_no_scheduler", address=address, reason=reason)) from None

    def each(work: Callable[[Task], Done], tasks: Sequence[Task]) -> Answers[Done]:
        waiting = {client.submit(work, task, pure=False): k for k, task in enumerate(tasks)}
        try:
            for done in dask.as_completed(list(waiting)):
                yield waiting.pop(done), done.result()
        except (Exception, CancelledError) as error:  # of any library on the way
            details = {"kind": type(error).__name__, "reason": str(error).partition("\n")[0]}
            raise PlanesError(Phrase("course_cluster", **details)) from None

    try:
        yield each
    finally:
        with suppress(OSError):
            client.close()
