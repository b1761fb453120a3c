"""What a scene's sheets are composed of: its position drawn at the sizes asked for, and what else they show."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

from planes.documents.graphs import check_names
from planes.documents.turning import turned_once
from planes.plans import Plans
from planes.plans.scales import FIT_MM, extent, fitting
from planes.scene import Scene
from planes.solving import Position, failed, plans_of, position
from planes.solving.nearest import nearest
from planes.solving.vectors import solve_vectors
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.names import kind_of, mu_of
from render.sheet import Contents, Sheet, compose
from render.sheet.composer import Composer
from render.sheet.project import Project
from render.sheet.sizes import Sizes
from render.views import View


def sheet_of(scene: Scene, values: Iterable[float] | None, lang: Lang = "ru", number: int | None = None) -> Sheet:
    """The composed sheet of one position, or of vectors alone; ``number`` is that of a sheet of a project."""
    if scene.mechanism is None:
        check_names(scene, None)
        found, composer = solve_vectors(scene), Composer(scene, lang)
        return compose(scene, Contents(lambda _, *how: (composer.vector_views(found, *how), [])), lang)
    drawn = DrawnPosition(replace(scene, find=None) if number else scene, values, lang)
    check_names(scene, drawn.stated[0])
    composer = Composer(scene, lang, drawn.stated[0])
    if number:
        return _numbered(drawn, composer, number)

    def views(sizes: Sizes, letter: float, together: bool) -> tuple[list[View], list[View]]:
        now = drawn.at(sizes)
        return composer.views(now, letter, together), composer.extras(now, letter)

    return compose(scene, Contents(views, lambda sizes: drawn.extents(sizes, lambda plan: True)), lang)


def _numbered(drawn: DrawnPosition, composer: Composer, number: int) -> Sheet:
    """Sheet 1 or 2 of a course project."""
    scene = drawn.scene
    project = Project(composer)
    if number == 1:
        project = turned_once(scene, drawn.at(Sizes()).plans, composer, bool(scene.sheet.get("positions")))

    def views(sizes: Sizes, letter: float, together: bool) -> tuple[list[View], list[View]]:
        return project.sheet(number, drawn.at, sizes, letter, together), []

    def extents(sizes: Sizes) -> dict[str, float]:
        return project.extents(number, drawn.at, sizes, drawn.extents(sizes, Project.shows(number)))

    return compose(scene, Contents(views, extents), composer.lang, number)


@dataclass(frozen=True)
class DrawnPosition:
    """One position of a scene, drawn at any sizes of its plans; each once."""

    scene: Scene
    values: Iterable[float] | None
    lang: Lang

    @cached_property
    def stated(self) -> tuple[Plans, Any]:
        """The plans, and what the scene asks for."""
        return plans_of(self.scene)

    @cached_property
    def value(self) -> float:
        """The value of the drive a sheet is drawn for."""
        chosen = [self.stated[0].mechanism.drive.position] if self.values is None else list(self.values)
        if len(chosen) != 1:
            raise PlanesError(Phrase("one_position", count=len(chosen)))
        return chosen[0]

    def at(self, sizes: Sizes) -> Position:
        """The position with plans of those sizes; :class:`PlanesError` where it cannot be drawn."""
        mus = tuple(self.mus(sizes).items())
        if mus not in self.kept:
            self.kept[mus] = self._drawn(self.fits(sizes))
        return self.kept[mus]

    @cached_property
    def kept(self) -> dict[tuple[tuple[str, float], ...], Position]:
        """The position by the μ of its plans, where the scene leaves them open: drawn once at each."""
        return {tuple(self.mus(Sizes()).items()): self.first}

    @cached_property
    def first(self) -> Position:
        """The position with its plans as large as usual."""
        return self._drawn(self.fits(Sizes()))

    @cached_property
    def largest(self) -> dict[str, float]:
        """How large, in SI, the plans are whose μ is open."""
        first = self.first
        open_ = [p for p in first.plans.drawn if p != "lever" and self.scene.mu.get(kind_of(p)) is None]
        return {p: extent(first.drawing, p) / first.scales[mu_of(p)] for p in open_}

    def fits(self, sizes: Sizes) -> dict[str, float]:
        """How many mm each plan may be large."""
        drawn = (p for p in self.stated[0].drawn if p != "lever")
        fits = {plan: sizes.of(plan) * FIT_MM[kind_of(plan)] for plan in (*FIT_MM, *drawn)}
        return {**fits, "force": sizes.factor * FIT_MM["force"]}

    def mus(self, sizes: Sizes) -> dict[str, float]:
        """The μ that plans of those sizes have, where the scene leaves them open."""
        fits = self.fits(sizes)
        return {plan: fitting(plan, size, fits[plan]) for plan, size in self.largest.items()}

    def _drawn(self, fits: Mapping[str, float]) -> Position:
        plans, wanted = self.stated
        try:
            return position(self.scene, plans, wanted, self.value, None, self.lang, fits)
        except PlanFailure as failure:
            said = failed(failure, self.value, plans.mechanism.drive.kind, nearest(plans, self.value))
            raise SceneError(said, self.scene.file) from None

    def extents(self, sizes: Sizes, shown: Callable[[str], bool]) -> dict[str, float]:
        """The size in mm of the plans that are shown and whose μ is open."""
        mus = self.mus(sizes)
        return {plan: size * mus[plan] for plan, size in self.largest.items() if shown(kind_of(plan))}
