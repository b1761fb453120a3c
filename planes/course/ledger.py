"""The folder of results: every file appears whole, with a line in the manifest that says what it was made from.

A run that was cut short leaves a journal beside the manifest; the next one reads both, keeps the files that are what
they were, and clears away what was only begun. The fingerprint of the program is part of what a file was made from.
"""

import hashlib
import json
import os
import platform
from collections.abc import Iterable
from contextlib import suppress
from functools import cache
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path
from typing import NamedTuple, TextIO

from planes.scene.files import PART, cannot_write, sayable, whole
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.records import Json

_ALL = "numpy shapely reportlab ezdxf svgwrite matplotlib fonttools pillow pypdfium2 segno"
LIBRARIES = tuple(_ALL.split())


@cache
def fingerprint() -> str:
    """The program's own files, words among them, Python and the libraries that reckon and draw, as one hash: the same
    for two programs that make the same files of the same scenes."""
    house = Path(__file__).parents[2]
    every = (f for room in ("planes", "render") for f in (house / room).rglob("*"))
    files = [f for f in every if f.is_file() and "__pycache__" not in f.parts]
    digest = hashlib.sha256()
    for file in sorted(files, key=lambda f: f.relative_to(house).as_posix()):
        digest.update(file.relative_to(house).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    digest.update(repr(made_with()).encode())
    return digest.hexdigest()


def made_with() -> dict[str, str]:
    """Python and the libraries, with their versions."""
    python = {"python": f"{platform.python_implementation()} {platform.python_version()}"}
    return python | {name: _version(name) for name in LIBRARIES}


def _version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "-"


MANIFEST, JOURNAL = "manifest.json", ".journal"
DRAFT = f"{JOURNAL}{PART}"  # the one file that is being written


def digest(data: bytes) -> str:
    """The hash of a file's contents."""
    return hashlib.sha256(data).hexdigest()


class Entry(NamedTuple):
    """The hash of what a file was made from, the hash of the file, and sentences that must be said of it."""

    source: str = ""
    sha256: str = ""
    said: tuple[str, ...] = ()

    def json(self) -> Json:
        """As the manifest has it."""
        said = {"said": list(self.said)} if self.said else {}
        return {"from": self.source, "sha256": self.sha256, **said}


class Ledger:
    """The files of one folder by their names within it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self.journal = os.fdopen(_own(folder / JOURNAL), "a", encoding="utf-8")
            _lock(self.journal, folder)
            (folder / DRAFT).unlink(missing_ok=True)
            self.entries: dict[str, Entry] = dict(self._read())
            self.journal.write("\n")  # after a line that was cut short
        except OSError as error:
            raise cannot_write(error, error.filename or folder) from None

    def path(self, name: str) -> Path:
        """The file of a name; one that leads out of the folder, by its dots or over a link, is none of ours."""
        path, here = self.folder / name, os.path.realpath(self.folder)
        plain = "\0" not in name and ".." not in Path(name).parts
        if plain and Path(os.path.realpath(path.parent)).is_relative_to(here):
            return path
        raise PlanesError(Phrase("course_outside", file=name, folder=str(self.folder)))

    def _ours(self, name: str) -> bool:
        with suppress(PlanesError):
            return bool(self.path(name))
        return False

    def _read(self) -> Iterable[tuple[str, Entry]]:
        """What the manifest says, then the journal's whole lines."""
        manifest = self.folder / MANIFEST
        listed = _parsed(manifest.read_text("utf-8", "replace")).get("files") if manifest.is_file() else None
        for name, entry in listed.items() if isinstance(listed, dict) else ():
            if self._ours(name):
                yield name, _entry(entry)
        for line in (self.folder / JOURNAL).read_text("utf-8", "replace").splitlines():
            if (entry := _parsed(line)) and self._ours(name := str(entry.get("name"))):
                yield name, _entry(entry)

    def fresh(self, name: str, source: str) -> bool:
        """Whether the file is there as it was made, and was made from the same."""
        entry = self.entries.get(name, Entry())
        path = self.folder / name
        return entry.source == source and path.is_file() and digest(path.read_bytes()) == entry.sha256

    def keep(self, name: str, source: str, data: bytes, said: tuple[str, ...] = ()) -> None:
        """Write a file whole, then its line."""
        path = self.path(name)
        with sayable(path):
            self._put(path, data)
            entry = self.entries[name] = Entry(source, digest(data), said)
            self.journal.write(json.dumps({"name": name, **entry.json()}, ensure_ascii=False) + "\n")
            self.journal.flush()

    def _put(self, path: Path, data: bytes) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        with whole(path, self.folder / DRAFT) as draft:
            draft.write_bytes(data)

    def close(self, wanted: Iterable[str] | None = None) -> None:
        """Write the manifest in place of the journal; with ``wanted``, files made earlier that are not go away."""
        with sayable(self.folder / MANIFEST):
            for name in self.entries.keys() - set(wanted) if wanted is not None else ():
                self.forget(name)
            files = {name: entry.json() for name, entry in sorted(self.entries.items())}
            text = json.dumps({"planes": 1, "files": files}, ensure_ascii=False, indent=1) + "\n"
            self._put(self.folder / MANIFEST, text.encode())
            self.journal.close()
            (self.folder / JOURNAL).unlink()

    def forget(self, name: str) -> None:
        """Take away a file made earlier, unless a person has changed it."""
        path, was = self.path(name), self.entries.pop(name, Entry()).sha256
        if path.is_file() and digest(path.read_bytes()) == was:
            path.unlink()
            for folder in path.parents:
                if folder == self.folder or any(folder.iterdir()):
                    break
                folder.rmdir()


def _own(path: Path) -> int:
    """The file of this very name opened to be gone on with: not what a link leads to."""
    return os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND | getattr(os, "O_NOFOLLOW", 0), 0o666)


def _parsed(text: str) -> Json:
    """An object, or nothing if it was not written to its end."""
    try:
        record = json.loads(text)
    except (ValueError, RecursionError):
        return {}
    return record if isinstance(record, dict) else {}


def _entry(read: object) -> Entry:
    """An entry of the manifest or the journal, an empty one if it is none."""
    if not isinstance(read, dict):
        return Entry()
    said = read.get("said")
    sentences = tuple(map(str, said)) if isinstance(said, list) else ()
    return Entry(str(read.get("from")), str(read.get("sha256")), sentences)


def _lock(file: TextIO, folder: Path) -> None:
    """Hold the folder for this run; where the system cannot, nothing is held."""
    try:
        import fcntl
    except ImportError:
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        raise PlanesError(Phrase("course_locked", folder=str(folder))) from None
