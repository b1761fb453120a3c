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
from render.faces import lettered
from render.fonts import face_of
from render.ink import save
from render.sheet import Sheet, compose
from render.sheet.composer import Composer
from render.sheet.project import Project
from render.views import View
from render.views.diagrams import extreme
from render.views.single import Makers, Page, of_mechanism, of_scene_of_vectors, page
from render.words import say

FREE = ("position", "velocity", "acceleration", "force")
SUFFIXES = (".svg", ".pdf", ".png", ".dxf")


def draw_sheet(
    scene: Scene, values: Iterable[float] | None, output: str, lang: Lang = "ru", number: int | None = None,
    view: str | None = None,
) -> None:  # fmt: skip
    """Draw the sheet of a scene into a file; :class:`PlanesError` in one sentence, and no file, if it cannot be.

    ``number`` 1 or 2 is that sheet of a course project; without it everything stands on one page. ``view`` is one
    view alone, without a frame.
    """
    path = Path(output)
    if path.suffix.lower() not in SUFFIXES:
        raise PlanesError(say("bad_suffix", lang, file=output, known=", ".join(SUFFIXES)))
    write(view_of(scene, view, values, lang) if view else sheet_of(scene, values, lang, number), path, lang)


def picture(drawn: Scene | Position, view: str | None = None, lang: Lang = "ru") -> Page:
    """One view (the scheme, unless another is named) of a scene, or of a position solved before, for a notebook.

    A position is drawn as it is, by whatever instrument; what a scene says of its sheet is not known then.
    """
    if isinstance(drawn, Scene):
        return view_of(drawn, view, None, lang)
    mechanism = drawn.plans.mechanism
    scene = Scene("", {}, {}, None, (), {}, mechanism, {}, (), (), drawn.scales, None, None, {})
    return _page(_mechanism_views(scene, drawn, Composer(scene, lang)), view, Composer(scene, lang))


def view_of(scene: Scene, view: str | None, values: Iterable[float] | None = None, lang: Lang = "ru") -> Page:
    """One view of a scene on a page of its own, by name (the first, if none is named)."""
    with lettered(face_of(scene)):
        return _view_of(scene, view, values, lang)


def _view_of(scene: Scene, view: str | None, values: Iterable[float] | None, lang: Lang) -> Page:
    composer = Composer(scene, lang)
    if scene.mechanism is None:
        return _page(of_scene_of_vectors(solve_vectors(scene), composer), view, composer)
    plans, wanted = plans_of(replace(scene, find=None))
    drawn = _drawer(scene, plans, wanted, _one_value(plans, values, lang), lang)(1.0)
    return _page(_mechanism_views(scene, drawn, composer), view, composer)


def _mechanism_views(scene: Scene, drawn: Position, composer: Composer) -> Makers:
    everything = replace(scene, find=None)
    return of_mechanism(drawn, composer, lambda: _turned_once(everything, drawn.plans, composer, True))


def _page(makers: Makers, view: str | None, composer: Composer) -> Page:
    return page(makers, view or next(iter(makers)), composer)


def _one_value(plans: Plans, values: Iterable[float] | None, lang: Lang) -> float:
    """The value of the drive a sheet is drawn for."""
    chosen = [plans.mechanism.drive.position] if values is None else list(values)
    if len(chosen) != 1:
        raise PlanesError(say("one_position", lang, count=len(chosen)))
    return chosen[0]


def sheet_of(scene: Scene, values: Iterable[float] | None, lang: Lang = "ru", number: int | None = None) -> Sheet:
    """The composed sheet of one position, or of vectors alone, lettered as the scene says."""
    with lettered(face_of(scene)):
        return _sheet_of(scene, values, lang, number)


def _sheet_of(scene: Scene, values: Iterable[float] | None, lang: Lang, number: int | None) -> Sheet:
    composer = Composer(scene, lang)
    if scene.mechanism is None:
        found = solve_vectors(scene)

        def of_vectors(factor: float, letter: float, together: bool) -> tuple[list[View], list[View]]:
            return composer.vector_views(found, letter, together), []

        return compose(scene, of_vectors, False, lang)
    if number:
        scene = replace(scene, find=None)
    plans, wanted = plans_of(scene)
    draw = _drawer(scene, plans, wanted, _one_value(plans, values, lang), lang)
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
        project = _turned_once(scene, draw(1.0).plans, composer, bool(scene.sheet.get("positions")))

    def views(factor: float, letter: float, together: bool) -> tuple[list[View], list[View]]:
        return project.sheet(number, draw(factor), letter, together), []

    return compose(scene, views, free, composer.lang, number)


def _turned_once(scene: Scene, plans: Plans, composer: Composer, twelve: bool) -> Project:
    """A project with a whole turn of the driver from the extreme position, on request with twelve schemes of it."""
    start = extreme(plans, *turned(scene, [float(k) for k in range(0, 361, 2)]))
    angles, turn = turned(scene, [start + 5.0 * k for k in range(73)])
    return Project(composer, angles, turn, turn[:72:6] if twelve else ())


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


def write(sheet: Sheet | Page, path: Path, lang: Lang) -> None:
    """The sheet as a file in the format of its suffix."""
    try:
        save(rendered(sheet, path.suffix.lower(), lang), path)
    except OSError as error:
        raise PlanesError(say("unwritable", lang, file=str(path), reason=error.strerror or str(error))) from None


def rendered(sheet: Sheet | Page, suffix: str, lang: Lang) -> bytes:
    """The contents of the sheet's file; the same sheet gives the same bytes."""
    match suffix:
        case ".svg":
            from render import svg

            return svg.write(sheet.marks, sheet.size, sheet.title, lang=lang)
        case ".pdf":
            from render import pdf

            return pdf.write(sheet.marks, sheet.size, sheet.title, lang=lang)
        case ".dxf":
            found: bytes = _dxf(lang).write(sheet.marks, sheet.size, sheet.title, lang=lang)
            return found
        case _:
            from render import png

            return png.write(sheet.marks, sheet.size, sheet.title)


def _dxf(lang: Lang) -> Any:
    """The writer of DXF, if ezdxf is installed."""
    if find_spec("ezdxf") is None:
        raise PlanesError(say("needs_ezdxf", lang))
    from render import dxf

    return dxf
