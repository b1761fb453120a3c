"""Practices that were handed in: ``planes check SCENE FILE.practice``, or a folder of them, in one table."""

from __future__ import annotations

import json
from argparse import Namespace
from dataclasses import asdict
from pathlib import Path

from planes.cli.commands import scene_of
from planes.lesson.handed_practice import SUFFIX
from planes.words import say
from planes.words.errors import PlanesError


def practices(drawing: str | None) -> list[Path]:
    """The files of practice that were handed in."""
    place = Path(drawing or "")
    found = sorted(place.glob(f"*{SUFFIX}")) if drawing and place.is_dir() else [place]
    return [file for file in found if file.suffix.lower() == SUFFIX]


def check_practices(args: Namespace, files: list[Path]) -> int:
    """A line, or an object, for each; 2 where one was refused."""
    from planes.lesson.data import Told
    from planes.lesson.handed_practice import PracticeJudge

    judge, rows, status = PracticeJudge(Told.of(scene_of(args))), [], 0
    for file in files:
        try:
            found = asdict(judge.judged(str(file)))
            rows.append({"file": file.name, **found, "said": say("practice_told", args.lang, **found)})
        except PlanesError as error:
            status = 2
            rows.append({"file": file.name, "error": error.told(args.lang)})
    if args.json:
        print(json.dumps(rows, ensure_ascii=False))
    else:
        print("\n".join(row.get("error") or f"{row['file']}: {row['said']}" for row in rows))
    return status
