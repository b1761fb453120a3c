"""The roof over the integrated calculation: a scene in, a report, an object or a summary out."""

from __future__ import annotations

import json
from pathlib import Path

from planes.crank_slider.calculation import Calculation, calculate
from planes.crank_slider.numbers import as_json
from planes.crank_slider.report import document, summary
from planes.scene import Scene
from planes.wording import PlanesError
from planes.words import Lang, Phrase

SUFFIXES = (".html", ".htm", ".pdf", ".json")


def run(scene: Scene, output: str | None, as_object: bool, lang: Lang) -> int:
    """Calculate; write the report if a file is named, print the object or the summary."""
    if output and Path(output).suffix.lower() not in SUFFIXES:
        raise PlanesError(Phrase("cs_suffix", file=output))
    found = calculate(scene)
    if output:
        _write(found, Path(output), lang)
    if as_object:
        print(json.dumps(as_json(found), allow_nan=False))
    elif not output:
        print(summary(found, lang), end="")
    return 0


def _write(found: Calculation, path: Path, lang: Lang) -> None:
    from render import report
    from render.ink import save

    try:
        if path.suffix.lower() == ".json":
            save((json.dumps(as_json(found), ensure_ascii=False, allow_nan=False) + "\n").encode(), path)
        else:
            report.write(document(found, lang), path)
    except OSError as error:
        raise PlanesError(Phrase("cs_unwritable", file=str(path), reason=error.strerror or str(error))) from None
