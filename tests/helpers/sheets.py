"""Sheets of the samples, each composed once in a run for all tests."""

from __future__ import annotations

from dataclasses import replace
from functools import cache

from planes.documents.sheets import sheet_of
from planes.scene import load
from planes.words import Lang
from render.sheet import Sheet
from tests.helpers import ROOT


def sheet(
    name: str, lang: Lang = "ru", value: float | None = None, number: int | None = None, **settings: object
) -> Sheet:
    """The sheet of a sample ("six-link", "assignments/05"), or one of its project of two.

    ``settings`` override its own ``sheet:``.
    """
    return _composed(name, lang, value, number, tuple(sorted(settings.items())))


@cache
def _composed(
    name: str, lang: Lang, value: float | None, number: int | None, settings: tuple[tuple[str, object], ...]
) -> Sheet:
    scene = load(ROOT / "samples" / f"{name}.yaml")
    scene = replace(scene, sheet={**scene.sheet, **dict(settings)})
    return sheet_of(scene, None if value is None else [value], lang, number)
