"""The folder of results: every file appears whole, with a line in the manifest that says what it was made from.

A run that was cut short leaves a journal beside the manifest; the next one reads both, keeps the files that are what
they were, and clears away what was only begun.
"""

from __future__ import annotations

import hashlib
import json
import os
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from planes.wording import PlanesError
from planes.words import Phrase

MANIFEST, JOURNAL = "manifest.json", ".journal"
PART = ".part"  # ends the name of a file while it is being written


def digest(data: bytes) -> str:
    """The hash of a file's contents."""
    return hashlib.sha256(data).hexdigest()


class Ledger:
    """The files of one folder: name within it -> (hash of what it was made from, hash of the file)."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        try:
            folder.mkdir(parents=True, exist_ok=True)
            self.journal = (folder / JOURNAL).open("a", encoding="utf-8")
            _lock(self.journal, folder)
            for part in folder.rglob(f".*{PART}"):
                part.unlink()
            self.entries: dict[str, tuple[str, str]] = dict(self._read())
            self.journal.write("\n")  # after a line that was cut short
        except OSError as error:
            raise _refused(error, folder) from None

    def _read(self) -> Iterable[tuple[str, tuple[str, str]]]:
        """What the manifest says, then the journal's whole lines."""
        manifest = self.folder / MANIFEST
        listed = _parsed(manifest.read_text("utf-8", "replace")).get("files") if manifest.is_file() else None
        for name, entry in listed.items() if isinstance(listed, dict) else ():
            yield name, _entry(entry)
        for line in (self.folder / JOURNAL).read_text("utf-8", "replace").splitlines():
            if entry := _parsed(line):
                yield str(entry.get("name")), _entry(entry)

    def fresh(self, name: str, source: str) -> bool:
        """Whether the file is there as it was made, and was made from the same."""
        made_from, is_now = self.entries.get(name, ("", ""))
        path = self.folder / name
        return made_from == source and path.is_file() and digest(path.read_bytes()) == is_now

    def keep(self, name: str, source: str, data: bytes) -> None:
        """Write a file whole, then its line."""
        try:
            put(self.folder / name, data)
            self.entries[name] = (source, digest(data))
            line = {"name": name, "from": source, "sha256": digest(data)}
            self.journal.write(json.dumps(line, ensure_ascii=False) + "\n")
            self.journal.flush()
        except OSError as error:
            raise _refused(error, self.folder / name) from None

    def close(self, wanted: Iterable[str] | None = None) -> None:
        """Write the manifest in place of the journal; with ``wanted``, files made earlier that are not go away."""
        try:
            for name in self.entries.keys() - set(wanted) if wanted is not None else ():
                self.forget(name)
            files = {name: {"from": a, "sha256": b} for name, (a, b) in sorted(self.entries.items())}
            text = json.dumps({"planes": 1, "files": files}, ensure_ascii=False, indent=1) + "\n"
            put(self.folder / MANIFEST, text.encode())
            self.journal.close()
            (self.folder / JOURNAL).unlink()
        except OSError as error:
            raise _refused(error, self.folder / MANIFEST) from None

    def forget(self, name: str) -> None:
        """Take away a file made earlier, unless a person has changed it."""
        path, (_, was) = self.folder / name, self.entries.pop(name, ("", ""))
        if path.is_file() and digest(path.read_bytes()) == was:
            path.unlink()
            for folder in path.parents:
                if folder == self.folder or any(folder.iterdir()):
                    break
                folder.rmdir()


def put(path: Path, data: bytes) -> None:
    """The whole file, safe on the disk, or the one that was there before."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(f".{path.name}{PART}")
    with part.open("wb") as file:
        file.write(data)
        file.flush()
        os.fsync(file.fileno())
    os.replace(part, path)


def _parsed(text: str) -> dict[str, Any]:
    """An object, or nothing if it was not written to its end."""
    try:
        found = json.loads(text)
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _entry(said: Any) -> tuple[str, str]:
    """What a file was made from, and its hash."""
    return (str(said.get("from")), str(said.get("sha256"))) if isinstance(said, dict) else ("", "")


def _lock(file: Any, folder: Path) -> None:
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


def _refused(error: OSError, path: Path) -> PlanesError:
    return PlanesError(Phrase("cannot_write", file=error.filename or str(path), reason=error.strerror or str(error)))
