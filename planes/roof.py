"""The roof over both houses: solves a scene, has its sheet composed, and writes the file."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache
from pathlib import Path

from planes.measuring import Quantity
from planes.plans import Plans
from planes.scales import FIT_MM
from planes.scene import Scene
from planes.solving import Position, plans_of, position, told
from planes.words import Lang, say
from planes.wording import PlanesError, PlanFailure
from render.sheet import Sheet, compose
from render.words import say as say_sheet

SUFFIXES = (".svg", ".pdf", ".png")


def draw_sheet(scene: Scene, values: Iterable[float] | None, output: str, lang: Lang = "ru") -> None:
    """Draw the sheet of a scene into a file; :class:`PlanesError` in one sentence, and no file, if it cannot be."""
    path = Path(output)
    if path.suffix.lower() not in SUFFIXES:
        raise PlanesError(say_sheet("bad_suffix", lang, file=output, known=", ".join(SUFFIXES)))
    write(sheet_of(scene, values, lang), path, lang)


def sheet_of(scene: Scene, values: Iterable[float] | None, lang: Lang = "ru") -> Sheet:
    """The composed sheet of one position."""
    plans, wanted = plans_of(scene)
    chosen = [plans.mechanism.drive.position] if values is None else list(values)
    if len(chosen) != 1:
        raise PlanesError(say_sheet("one_position", lang, count=len(chosen)))
    return compose(scene, _drawer(scene, plans, wanted, chosen[0], lang), lang)


def _drawer(
    scene: Scene, plans: Plans, wanted: list[Quantity] | None, value: float, lang: Lang
) -> Callable[[float], Position]:
    """Draws the position with its plans so many times their usual size, where μ is open."""

    @lru_cache(maxsize=8)
    def draw(factor: float) -> Position:
        fits = {plan: factor * fit for plan, fit in FIT_MM.items()}
        try:
            return position(scene, plans, wanted, value, None, lang, fits)
        except PlanFailure as failure:
            drive = plans.mechanism.drive
            place = say("at", lang, name="φ" if drive.kind == "phi" else "s", value=told(value, drive.kind))
            raise PlanesError(place + failure.sentence(lang)) from None

    return draw


def write(sheet: Sheet, path: Path, lang: Lang) -> None:
    """The sheet as a file in the format of its suffix."""
    try:
        match path.suffix.lower():
            case ".svg":
                from render import svg

                svg.write(sheet.marks, sheet.size, sheet.title, path, lang=lang)
            case ".pdf":
                from render import pdf

                pdf.write(sheet.marks, sheet.size, sheet.title, path, lang=lang)
            case _:
                from render import png

                png.write(sheet.marks, sheet.size, sheet.title, path)
    except OSError as error:
        raise PlanesError(say_sheet("unwritable", lang, file=str(path), reason=error.strerror or str(error))) from None
