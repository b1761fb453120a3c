"""Photographs of real drawings in a folder with their marks, counted like simulated ones.

Next to a picture `NAME.jpg` lies `NAME.csv`, the marks saved by its report page after manual correction. The first line
of that table is the command that checks it; the options that read a picture on plain paper (`--pole`, `--mark`,
`--format`) may stand in a separate line after a `#`. A table without a command uses the one in the folder's
`command.txt`. Scenes are first looked for in the folder.
"""

from __future__ import annotations

import contextlib
import io
import json
import shlex
import time
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from planes.check.handed_in import PICTURE_SUFFIXES
from planes.cli import main
from tests.physical.counting import Tally, Truth


@dataclass(frozen=True)
class Pair:
    """A picture, the table of its marks, the command that checks the table, and options for the picture only."""

    picture: Path
    marks: Path
    command: tuple[str, ...]
    options: tuple[str, ...] = ()


def pairs(folder: Path) -> Iterator[Pair]:
    """Every picture with marks in a folder and its subfolders."""
    for picture in sorted(folder.rglob("*")):
        marks = picture.with_suffix(".csv")
        if picture.suffix.lower() in PICTURE_SUFFIXES and marks.is_file():
            yield paired(picture, marks)


def paired(picture: Path, marks: Path) -> Pair:
    """A picture and its marks; ValueError if their scene is unknown."""
    lines = marks.read_text("utf-8-sig").splitlines()
    told = [shlex.split(line.lstrip("# ")) for line in lines if line.startswith("#")]
    command = next((words for words in told if words[:2] == ["planes", "check"]), None)
    if command is None:
        file = marks.with_name("command.txt")
        if not file.is_file():
            raise ValueError(f"{marks}: no line '# planes check SCENE …', and no command.txt beside it")
        command = shlex.split(file.read_text("utf-8"))
    options = [word for words in told if words and words[0].startswith("--") for word in words]
    near = (picture.parent / name for name in (command[2], Path(command[2]).name))
    scene = next((str(file) for file in near if file.is_file()), command[2])
    return Pair(picture, marks, (scene, *command[4:]), tuple(options))


def checked(pair: Pair, file: Path, *options: str) -> dict[str, Any] | None:
    """The findings of the command in a file, as its object; None if it fails."""
    scene, *rest = pair.command
    out = io.StringIO()
    with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
        main(["check", scene, str(file), *rest, *options, "--json"])
    found: dict[str, Any] | None = json.loads(out.getvalue()) if out.getvalue() else None
    return found


def counted(pair: Pair) -> Tally:
    """One picture against its corrected marks, which are judged as they are; ValueError if they cannot be."""
    true = checked(pair, pair.marks)
    if true is None or true["verdict"] == "unreadable":
        raise ValueError(f"{pair.marks}: the marks themselves cannot be judged")
    start = time.perf_counter()
    found = checked(pair, pair.picture, *pair.options)
    seconds = time.perf_counter() - start
    truth = Truth(true["verdict"].removesuffix("_as_seen"), frozenset({(true["mistake"], true["first_wrong"])}))
    if found is None:
        return Tally.of(truth, "unreadable", None, None, [], seconds)
    errors = list(off(places(true), places(found)))
    return Tally.of(truth, found["verdict"], found["first_wrong"], found["mistake"], errors, seconds)


def places(found: dict[str, Any]) -> dict[str, complex]:
    """Marks that were read, mm from the pole."""
    return {row["mark"]: complex(*row["read_mm"]) for row in found["marks"] if row["read_mm"]}


def off(true: dict[str, complex], found: dict[str, complex]) -> Iterator[float]:
    """The distances of marks from their corrected positions."""
    return (abs(found[name] - z) for name, z in true.items() if name in found)


def of_folder(folder: Path) -> Tally:
    """All pairs of a folder."""
    whole = Tally()
    for pair in pairs(folder):
        whole.add(counted(pair))
    return whole
