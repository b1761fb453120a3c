"""A file is written whole or not at all: everything goes through ``planes/scene/files.py``."""

from __future__ import annotations

import ast
import os
import sys
from collections.abc import Iterator
from pathlib import Path

from planes.documents.drawn import DRAWING_SUFFIXES
from planes.scene.files import DRAFT_SUFFIX
from tests.helpers.sheets import sheet
from tests.house.test_rooms import MODULES, tree

WRITERS = {
    "planes.__main__": "what is still to be printed when nobody reads any more goes nowhere",
    "planes.batch.streams": "blocks of a long table, into the draft that `whole` gives",
    "planes.check.reading.opened": "what a library would print goes nowhere",
    "planes.course.ledger": "the journal, line after line; each file through `whole`",
    "planes.scene.files": "the one way",
}
"""Who opens anything for writing, and what."""


def opens(module: str) -> Iterator[int]:
    """Lines that open a file for writing: by a mode, by a flag of the system, or by a path's own method."""
    for node in ast.walk(tree(MODULES[module])):
        match node:
            case ast.Call(func=ast.Attribute(attr="write_bytes" | "write_text" | "open_memmap" | "ParquetWriter")):
                yield node.lineno
            case ast.Call(func=ast.Attribute(attr="open") | ast.Name(id="open")):
                said = [n.value for n in [*node.args, *(k.value for k in node.keywords)] if isinstance(n, ast.Constant)]
                modes = [s for s in said if isinstance(s, str) and set(s) <= set("rwaxbt+")]
                flags = {n.attr for n in ast.walk(node) if isinstance(n, ast.Attribute)}
                if any(set(s) & set("wax+") for s in modes) or flags & {"O_WRONLY", "O_RDWR", "O_APPEND"}:
                    yield node.lineno


def test_nobody_else_opens_a_file_for_writing() -> None:
    found = {module: list(opens(module)) for module in MODULES}
    assert {module for module, lines in found.items() if lines} == set(WRITERS), found


def test_a_sheet_of_any_format_is_written_to_a_draft(tmp_path: Path) -> None:
    opened: list[str] = []
    watching = True

    def watch(event: str, args: tuple[object, ...]) -> None:
        if watching and event == "open" and isinstance(args[2], int) and args[2] & (os.O_WRONLY | os.O_RDWR):
            opened.append(str(args[0]))

    sys.addaudithook(watch)
    for suffix in DRAWING_SUFFIXES:
        sheet("vectors").write(tmp_path / f"sheet{suffix}")
    watching = False
    written = [path for path in opened if Path(path).parent == tmp_path]
    assert len(written) >= len(DRAWING_SUFFIXES) and all(path.endswith(DRAFT_SUFFIX) for path in written)
    assert {path.suffix for path in tmp_path.iterdir()} == set(DRAWING_SUFFIXES)
