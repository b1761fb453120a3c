"""Opens submitted files: their size is bounded, and whatever fails in a reading library becomes one sentence."""

import hashlib
import os
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from planes.words import Phrase
from planes.words.errors import PlanesError

MB = 1_000_000
LARGEST_FILE_BYTES = 200 * MB  # of pictures and pages
HASH_LETTERS = 16  # of a hash


def hash_of_content(shown: bytes) -> str:
    """A short hash of the content of a drawing."""
    return hashlib.sha256(shown).hexdigest()[:HASH_LETTERS]


def read_bounded_bytes(path: str | Path, most: int) -> bytes:
    """The bytes of a file of at most ``most``; :class:`PlanesError` if it is no file or larger."""
    file = Path(path)
    try:
        if file.exists() and not file.is_file():
            raise file_error("check_no_plain_file", path)
        with file.open("rb") as opened:
            data = opened.read(most + 1)
    except (OSError, ValueError) as error:
        why = getattr(error, "strerror", None) or str(error)
        raise file_error("check_no_file", path, why=why) from None
    if len(data) > most:
        raise file_error("check_large_file", path, most=most // MB)
    return data


def file_error(key: str, file: str | Path, **parts: object) -> PlanesError:
    """An error that names the file."""
    return PlanesError(Phrase(key, file=str(file), **parts))


def too_many_error(file: str, what: str, most: int) -> PlanesError:
    """An error for a file that holds more than any drawing of a plan; ``what`` is counted."""
    return file_error("check_too_many", file, what=Phrase(f"count_{what}"), most=most)


@contextmanager
def silenced_output() -> Iterator[None]:
    """Suppresses terminal output of libraries while they decode."""
    try:
        kept = os.dup(2)
    except OSError:  # there is no terminal
        yield
        return
    nowhere = os.open(os.devnull, os.O_WRONLY)
    try:
        os.dup2(nowhere, 2)
        yield
    finally:
        os.dup2(kept, 2)
        os.close(kept)
        os.close(nowhere)
