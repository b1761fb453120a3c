"""The roof over both houses: solves a scene, has its sheet composed, and writes the file."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import replace
from functools import lru_cache
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from planes.measuring import Quantity
from planes.nearest import nearest
from planes.plans import Plans
from planes.scales import FIT_MM
from planes.scene import Scene
from planes.solving import Position, failed, plans_of, position, solve
from planes.vectors import solve_vectors
from planes.wording import PlanesError, PlanFailure
from planes.words import Lang
from render.compose import Composer
from render.diagrams import extreme
from render.sheet import Sheet, compose
from render.two_sheets import Project
from render.view import View
from render.words import say

FREE = ("position", "velocity", "acceleration", "force")
SUFFIXES = (".svg", ".pdf", ".png", ".dxf")


def draw_sheet(
    scene: Scene, values: Iterable[float] | None, output: str, lang: Lang = "ru", number: int | None = None
) -> None:
    """Draw the sheet of a scene into a file; :class:`PlanesError` in one sentence, and no file, if it cannot be.

    ``number`` 1 or 2 is that sheet of a course project; without it everything stands on one page.
    """
    path = Path(output)
    if path.suffix.lower() not in SUFFIXES:
        raise PlanesError(say("bad_suffix", lang, file=output, known=", ".join(SUFFIXES)))
    write(sheet_of(scene, values, lang, number), path, lang)


def sheet_of(scene: Scene, values: Iterable[float] | None, lang: Lang = "ru", number: int | None = None) -> Sheet:
    """The composed sheet of one position, or of vectors alone."""
    composer = Composer(scene, lang)
    if scene.mechanism is None:
        found = solve_vectors(scene)

        def of_vectors(factor: float, letter: float, together: bool) -> tuple[list[View], list[View]]:
            return composer.vector_views(found, letter, together), []

        return compose(scene, of_vectors, False, lang)
    if number:
        scene = replace(scene, find=None)
    plans, wanted = plans_of(scene)
    chosen = [plans.mechanism.drive.position] if values is None else list(values)
    if len(chosen) != 1:
        raise PlanesError(say("one_position", lang, count=len(chosen)))
    draw = _drawer(scene, plans, wanted, chosen[0], lang)
    free = any(scene.mu.get(kind) is None for kind in FREE)
    if number:
        return _numbered(scene, draw, composer, free, number)

    def views(factor: float, letter: float, together: bool) -> tuple[list[View], list[View]]:
        position = draw(factor)
        return composer.views(position, letter, together), composer.extras(position, letter)

    return compose(scene, views, free, lang)


def _numbered(scene: Scene, draw: Callable[[float], Position], composer: Composer, free: bool, number: int) -> Sheet:
    """Sheet 1 or 2 of a course project."""
    project = Project(composer)
    if number == 1 and draw(1.0).plans.mechanism.drive.kind == "phi":
        start = extreme(draw(1.0).plans, *turned(scene, [float(k) for k in range(0, 361, 2)]))
        angles, turn = turned(scene, [start + 5.0 * k for k in range(73)])
        twelve = turn[:72:6] if scene.sheet.get("positions") else ()
        project = Project(composer, angles, turn, twelve)

    def views(factor: float, letter: float, together: bool) -> tuple[list[View], list[View]]:
        return project.sheet(number, draw(factor), letter, together), []

    return compose(scene, views, free, composer.lang, number)


def turned(scene: Scene, angles: list[float]) -> tuple[list[float], list[dict[str, Any] | None]]:
    """Results at each angle of the driver, None where the mechanism does not work."""
    solved = solve(scene, angles)
    found = {p.value: p.results for p in solved.positions}
    return angles, [found.get(a) for a in angles]


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
            near = nearest(plans, value)
            raise PlanesError(failed(failure, value, plans.mechanism.drive.kind, near, lang)) from None

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
            case ".dxf":
                dxf = _dxf(lang)
                dxf.write(sheet.marks, sheet.size, sheet.title, path, lang=lang)
            case _:
                from render import png

                png.write(sheet.marks, sheet.size, sheet.title, path)
    except OSError as error:
        raise PlanesError(say("unwritable", lang, file=str(path), reason=error.strerror or str(error))) from None


def _dxf(lang: Lang) -> Any:
    """The writer of DXF, if ezdxf is installed."""
    if find_spec("ezdxf") is None:
        raise PlanesError(say("needs_ezdxf", lang))
    from render import dxf

    return dxf
