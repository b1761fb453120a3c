"""``planes check`` on a folder: every drawing of a class, as a table, a page, or a report for each."""

from __future__ import annotations

import argparse
import json
import sys
from collections.abc import Callable, Iterable
from pathlib import Path

from planes.check import check
from planes.check.grading.paper import ReadPaper
from planes.check.grading.prepared_plan import Asked
from planes.check.report.classes import Checked, ClassWork, heads
from planes.words import Lang, Phrase, say
from planes.words.errors import PlanesError, guarded
from planes.words.spreadsheet import as_csv

Reader = Callable[[str], ReadPaper]
NO_DRAWINGS = (".html", ".htm", ".yaml", ".yml", ".md", ".py", ".db", ".ini", ".lnk", ".tmp")  # lie beside the drawings


def check_class(args: argparse.Namespace, asked: Asked, read: Reader) -> int:
    """Every drawing of a folder: a row for each, on the terminal and in the file of ``-o``."""
    folder = Path(args.drawing)
    files = [f for f in sorted(folder.iterdir()) if f.is_file() and not f.name.startswith((".", "~$"))]
    files = [f for f in files if f.suffix.lower() not in NO_DRAWINGS]
    if not files:
        raise PlanesError(Phrase("check_empty_folder", file=args.drawing))
    group = ClassWork(folder.name)
    for file in _shown(files):
        name = file.name.encode("utf-8", "replace").decode()  # any bytes at all may be the name of a file
        try:
            with guarded("check_broken", name):  # one file never stops the others
                group.all.append(Checked(name, check(asked, read(str(file)))))
        except PlanesError as error:
            group.all.append(Checked(name, refused=error))
    if args.output:
        _write(group, args.output, args.lang)
    print(_json(group, args.lang) if args.json else "\n".join(_table(group, args.lang)).lstrip())
    return group.status


def _table(group: ClassWork, lang: Lang) -> list[str]:
    rows = [heads(lang), *(one.row(lang) for one in group.all)]
    widths = [max(len(row[i]) for row in rows) for i in range(3)]
    aligned = ("  ".join([*(c.ljust(w) for c, w in zip(row, widths, strict=False)), row[3]]) for row in rows)
    return [say("check_class", lang), *(f"  {line.rstrip()}" for line in aligned)]


def _json(group: ClassWork, lang: Lang) -> str:
    return json.dumps([one.as_json(lang) for one in group.all], ensure_ascii=False, allow_nan=False)


def _csv(group: ClassWork, lang: Lang) -> str:
    table = as_csv([heads(lang), *(one.row(lang) for one in group.all)])
    return f"\ufeff{table}"  # so that a spreadsheet knows the letters


def _write(group: ClassWork, output: str, lang: Lang) -> None:
    """The table as a page, a spreadsheet or objects; a folder gets a report for each drawing and the page."""
    from planes.documents.check import write_class, write_text

    suffix = Path(output).suffix.lower()
    if suffix == ".json":
        write_text(_json(group, lang), output)
    elif suffix == ".csv":
        write_text(_csv(group, lang), output)
    elif suffix in (".html", ".htm", ""):
        write_class(group, output, lang)
    else:
        raise PlanesError(Phrase("check_class_output", file=output))


def _shown(files: list[Path]) -> Iterable[Path]:
    """The files, with a bar where a person waits."""
    if not sys.stderr.isatty():
        return files
    from tqdm import tqdm

    shown: Iterable[Path] = tqdm(files, unit="", leave=False)
    return shown
