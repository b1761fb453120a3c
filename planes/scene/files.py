"""The only way files are written: the new file is complete, or the old one stays as it was."""

import errno
import os
import stat
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from secrets import token_hex
from tempfile import TemporaryDirectory

from planes.scene.source import STANDARD_STREAM_PATH
from planes.words import Phrase
from planes.words.errors import PlanesError

DRAFT_SUFFIX = ".part"  # suffix of a file while it is being written


@contextmanager
def draft_replacing_file(path: str | Path, draft: Path | None = None) -> Iterator[Path]:
    """A draft to write to; it takes the file's name once it is safely on disk, and is deleted if anything fails.

    The draft lies beside the file under a unique name. A symbolic link at that name is replaced; its target is not
    written to.
    """
    target = Path(path)
    if is_standard_output(target):
        with TemporaryDirectory() as folder:
            yield (piped := Path(folder) / f"piped{target.suffix}")
            sys.stdout.buffer.write(piped.read_bytes())
        return
    draft = draft or target.parent / f".planes-{token_hex(8)}{DRAFT_SUFFIX}"
    mode = _file_permissions(target)
    try:
        os.close(os.open(draft, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o666))
        yield draft
        with draft.open("rb+") as file:
            os.fsync(file.fileno())
        if mode is not None:
            draft.chmod(mode)
        os.replace(draft, target)
    except BaseException:
        draft.unlink(missing_ok=True)
        raise


def is_standard_output(target: Path) -> bool:
    """Whether the path is standard output: a minus, with the suffix of the format (``-.svg``) where that matters."""
    return target.stem == STANDARD_STREAM_PATH and target.parent == Path()


def _file_permissions(target: Path) -> int | None:
    """The permissions of an existing file, None where there is none; an impossible file name is refused at once."""
    try:
        mode = target.lstat().st_mode
    except FileNotFoundError:
        return None
    if stat.S_ISDIR(mode):
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(target))
    return stat.S_IMODE(mode) if stat.S_ISREG(mode) else None


def save_bytes(data: bytes, path: str | Path | None) -> bytes:
    """Return the bytes unchanged and write them to the path, if given: the whole file or nothing."""
    if path is not None:
        if _is_terminal_or_pipe(Path(path)):
            Path(path).write_bytes(data)
            return data
        with draft_replacing_file(path) as draft:
            draft.write_bytes(data)
    return data


def _is_terminal_or_pipe(target: Path) -> bool:
    """Whether the path is a terminal or a pipe, which is written to and never replaced."""
    try:
        mode = target.stat().st_mode
    except OSError:
        return False
    return stat.S_ISCHR(mode) or stat.S_ISFIFO(mode)


@contextmanager
def writing_errors_in_words(path: str | Path) -> Iterator[None]:
    """A system error while a file is written, as a sentence."""
    try:
        yield
    except OSError as error:
        raise cannot_write_error(error, path) from None


def cannot_write_error(error: OSError, path: str | Path) -> PlanesError:
    """The sentence that says a file cannot be written, and why."""
    return PlanesError(Phrase("cannot_write", file=str(path), reason=error.strerror or str(error)))


def save_file_or_refuse(data: bytes, path: str | Path) -> None:
    """Write the whole file, or refuse with a sentence."""
    with writing_errors_in_words(path):
        save_bytes(data, path)
