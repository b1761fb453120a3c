"""The folder of results: every file appears complete, with a line in the manifest for its inputs.

An interrupted run leaves a journal beside the manifest; the next one reads both, keeps the unchanged files, and removes
unfinished ones. The fingerprint of the program is one of a file's inputs.
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

from planes.scene.files import DRAFT_SUFFIX, cannot_write_error, draft_replacing_file, writing_errors_in_words
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.records import Json

_LIBRARY_NAMES = "numpy shapely reportlab ezdxf svgwrite matplotlib fonttools pillow pypdfium2 segno"
LIBRARIES = tuple(_LIBRARY_NAMES.split())


@cache
def program_fingerprint() -> str:
    """The program's files, including its words, Python and the libraries for calculation and drawing, as one hash:
    equal for two programs that make the same files from the same scenes."""
    house = Path(__file__).parents[2]
    every = (f for room in ("planes", "render") for f in (house / room).rglob("*"))
    files = [f for f in every if f.is_file() and "__pycache__" not in f.parts]
    digest = hashlib.sha256()
    for file in sorted(files, key=lambda f: f.relative_to(house).as_posix()):
        digest.update(file.relative_to(house).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    digest.update(repr(library_versions()).encode())
    return digest.hexdigest()


def library_versions() -> dict[str, str]:
    """Python and the libraries, with their versions."""
    python = {"python": f"{platform.python_implementation()} {platform.python_version()}"}
    return python | {name: _library_version(name) for name in LIBRARIES}


def _library_version(name: str) -> str:
    try:
        return version(name)
    except PackageNotFoundError:
        return "-"


Sentences = tuple[str, ...]
MANIFEST_FILE_NAME = "manifest.json"
JOURNAL_FILE_NAME = ".journal"
DRAFT_FILE_NAME = f"{JOURNAL_FILE_NAME}{DRAFT_SUFFIX}"  # the file being written


def contents_hash(data: bytes) -> str:
    """The hash of a file's contents."""
    return hashlib.sha256(data).hexdigest()


class Entry(NamedTuple):
    """The hash of a file's inputs, the hash of the file, and sentences to report about it."""

    source: str = ""
    sha256: str = ""
    said: Sentences = ()

    def json(self) -> Json:
        """The entry as in the manifest."""
        said = {"said": list(self.said)} if self.said else {}
        return {"from": self.source, "sha256": self.sha256, **said}


class Ledger:
    """The files of one folder by their names within it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self.journal = os.fdopen(_open_own_file(folder / JOURNAL_FILE_NAME), "a", encoding="utf-8")
            _lock_folder(self.journal, folder)
            (folder / DRAFT_FILE_NAME).unlink(missing_ok=True)
            self.entries: dict[str, Entry] = dict(self._recorded_entries())
            self.journal.write("\n")  # after a line that was cut short
        except OSError as error:
            raise cannot_write_error(error, error.filename or folder) from None

    def checked_path(self, name: str) -> Path:
        """The path of a file; one outside the folder, by dots or through a link, is refused."""
        path = self.folder / name
        here = os.path.realpath(self.folder)
        plain = "\0" not in name and ".." not in Path(name).parts
        if plain and Path(os.path.realpath(path.parent)).is_relative_to(here):
            return path
        raise PlanesError(Phrase("course_outside", file=name, folder=str(self.folder)))

    def _is_inside_folder(self, name: str) -> bool:
        with suppress(PlanesError):
            return bool(self.checked_path(name))
        return False

    def _recorded_entries(self) -> Iterable[tuple[str, Entry]]:
        """The contents of the manifest, then the journal's complete lines."""
        manifest = self.folder / MANIFEST_FILE_NAME
        listed = _parsed_line(manifest.read_text("utf-8", "replace")).get("files") if manifest.is_file() else None
        for name, entry in listed.items() if isinstance(listed, dict) else ():
            if self._is_inside_folder(name):
                yield name, _valid_entry(entry)
        for line in (self.folder / JOURNAL_FILE_NAME).read_text("utf-8", "replace").splitlines():
            if (entry := _parsed_line(line)) and self._is_inside_folder(name := str(entry.get("name"))):
                yield name, _valid_entry(entry)

    def is_up_to_date(self, name: str, source: str) -> bool:
        """Whether the file is still as it was made, from the same inputs."""
        entry = self.entries.get(name, Entry())
        path = self.folder / name
        return entry.source == source and path.is_file() and contents_hash(path.read_bytes()) == entry.sha256

    def write_file(self, name: str, source: str, data: bytes, said: Sentences = ()) -> None:
        """Write a complete file, then its line."""
        path = self.checked_path(name)
        with writing_errors_in_words(path):
            self._write_complete_file(path, data)
            entry = self.entries[name] = Entry(source, contents_hash(data), said)
            self.journal.write(json.dumps({"name": name, **entry.json()}, ensure_ascii=False) + "\n")
            self.journal.flush()

    def _write_complete_file(self, path: Path, data: bytes) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        with draft_replacing_file(path, self.folder / DRAFT_FILE_NAME) as draft:
            draft.write_bytes(data)

    def write_manifest(self, wanted: Iterable[str] | None = None) -> None:
        """Write the manifest in place of the journal; with ``wanted``, earlier files that are not wanted are
        deleted."""
        with writing_errors_in_words(self.folder / MANIFEST_FILE_NAME):
            for name in self.entries.keys() - set(wanted) if wanted is not None else ():
                self.delete_unchanged_file(name)
            files = {name: entry.json() for name, entry in sorted(self.entries.items())}
            text = json.dumps({"planes": 1, "files": files}, ensure_ascii=False, indent=1) + "\n"
            self._write_complete_file(self.folder / MANIFEST_FILE_NAME, text.encode())
            self.journal.close()
            (self.folder / JOURNAL_FILE_NAME).unlink()

    def delete_unchanged_file(self, name: str) -> None:
        """Delete a file made earlier, unless a person has changed it."""
        path = self.checked_path(name)
        was = self.entries.pop(name, Entry()).sha256
        if path.is_file() and contents_hash(path.read_bytes()) == was:
            path.unlink()
            for folder in path.parents:
                if folder == self.folder or any(folder.iterdir()):
                    break
                folder.rmdir()


def _open_own_file(path: Path) -> int:
    """The file of this exact name opened for appending: not the target of a link."""
    return os.open(path, os.O_WRONLY | os.O_CREAT | os.O_APPEND | getattr(os, "O_NOFOLLOW", 0), 0o666)


def _parsed_line(text: str) -> Json:
    """The object in a line; empty if the line was cut short."""
    try:
        record = json.loads(text)
    except (ValueError, RecursionError):
        return {}
    return record if isinstance(record, dict) else {}


def _valid_entry(read: object) -> Entry:
    """An entry of the manifest or the journal; an empty one if it is invalid."""
    if not isinstance(read, dict):
        return Entry()
    said = read.get("said")
    sentences = tuple(map(str, said)) if isinstance(said, list) else ()
    return Entry(str(read.get("from")), str(read.get("sha256")), sentences)


def _lock_folder(file: TextIO, folder: Path) -> None:
    """Lock the folder for this run, where the system can."""
    try:
        import fcntl
    except ImportError:
        return
    try:
        fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        file.close()
        raise PlanesError(Phrase("course_locked", folder=str(folder))) from None
