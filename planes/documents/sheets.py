"""The contents of a scene's sheets: its position drawn at the requested sizes, and its driver moved once through its
range from an extreme position of the driven link, for sheet 1."""

import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cache, cached_property
from typing import Any

import numpy as np

from planes.batch.cycle import Cycle
from planes.batch.table import columns_of
from planes.diagrams.motion import dead_points, driven_grid
from planes.diagrams.turn import span_of, unwound
from planes.documents.cycle import check_names, known, over_cycle
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.curves import FULL, WorkingRange, curves_of, driven, output_curves
from planes.plans.position.bodies import SCHEME
from planes.plans.quantities import results_of
from planes.plans.scales import extent, fits_on, fitting, sides
from planes.scene import Scene
from planes.solving import Position, failed, plans_of, position
from planes.solving.nearest import nearest
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.frozen import frozen, replace
from planes.words.names import kind_of, mu_of
from render.paper.hues import coloured
from render.paper.marks import lettered
from render.paper.outlines import face_of
from render.sheet import Contents, Held, Sheet, compose
from render.sheet.composer import Composer, Together
from render.sheet.force_sheet import ForceSheet
from render.sheet.frame import form_of
from render.sheet.project import Project
from render.sheet.sizes import LOADED, Sizes
from render.sheet.studio_code import code_view
from render.views import View
from render.views.diagrams import SECTIONS, DiagramCurve, section_mm
from render.views.many import Numbered, PlacedMechanism


def sheet_of(scene: Scene, values: Iterable[float] | None, lang: Lang = "ru", number: int | None = None) -> Sheet:
    """The composed sheet of one position, or of vectors alone; ``number`` is that of a sheet of a project."""
    with lettered(face_of(scene)), form_of(scene):
        sheet = _sheet_of(scene, values, lang, number)
    return replace(sheet, marks=coloured(sheet.marks)) if scene.sheet.get("colour") else sheet


def _sheet_of(scene: Scene, values: Iterable[float] | None, lang: Lang, number: int | None) -> Sheet:
    drawn = DrawnPosition(replace(scene, find=None) if number else scene, values, lang)
    check_names(scene, drawn.stated[0])
    composer = Composer(scene, lang, drawn.stated[0])
    if number:
        return _numbered(drawn, composer, number)

    def views(sizes: Sizes, letter: float, together: Together) -> Held:
        now = drawn.at(sizes)
        shown = [*composer.views(now, letter, together), *opened(scene, composer.lang)]
        return shown, [v for v in (composer.moments(now, letter),) if v]

    return compose(scene, Contents(views, free=drawn.free), lang)


def _numbered(drawn: "DrawnPosition", composer: Composer, number: int) -> Sheet:
    """Sheet 1 or 2 of a course project."""
    scene, project, forces, lang = drawn.scene, Project(composer), ForceSheet(composer), composer.lang
    if number == 1:
        turned = turned_once(scene, drawn.first.plans, composer, bool(scene.sheet.get("positions", True)))
        project = replace(turned, reduced=cache(drawn.reduced))

    def views(sizes: Sizes, letter: float, together: Together) -> Held:
        if number == 2:
            return forces.views(drawn.at(sizes), drawn.grown(sizes), letter), []
        return [*project.kinematics(drawn.at(sizes), sizes.of("diagrams"), letter, together), *opened(scene, lang)], []

    def extents(sizes: Sizes) -> dict[str, float]:
        """The parts that can grow: the diagrams."""
        return {"diagrams": section_mm(sizes.of("diagrams")) * SECTIONS} if project.turn else {}

    if number == 1:
        return compose(scene, Contents(views, extents, free=drawn.free), composer.lang, number)
    held = Contents(views, drawn.extents, free=drawn.free, together=(Together(),))
    return compose(scene, held, composer.lang, number)


def opened(scene: Scene, lang: Lang) -> list[View]:
    """The QR code that opens the scene in a studio, if it names one."""
    return [v for v in (code_view(scene, lang),) if v]


MOST_TIMES = 2.0  # how much larger the scheme with loads may be than its groups


@frozen
class DrawnPosition:
    """One position of a scene, drawn with any sizes of its plans; each once."""

    scene: Scene
    values: Iterable[float] | None
    lang: Lang

    @cached_property
    def stated(self) -> tuple[Plans, Any]:
        """The plans, and the requested results."""
        return plans_of(self.scene, shown=True)

    @cached_property
    def value(self) -> float:
        """The position of the drive for a sheet."""
        chosen = [self.stated[0].mechanism.drive.position] if self.values is None else list(self.values)
        if len(chosen) != 1:
            raise PlanesError(Phrase("one_position", count=len(chosen)))
        return chosen[0]

    @property
    def free(self) -> bool:
        """Whether the scene leaves the μ of any plan open."""
        return any(self.scene.mu.get(kind_of(p)) is None for p in self.stated[0].drawn if p != "lever")

    def at(self, sizes: Sizes) -> Position:
        """The position at the scene's scales, or smaller where no paper holds its plans at these, each drawn once.
        :class:`PlanesError` where it cannot be drawn."""
        if sizes.factor not in self.kept:
            self.kept[sizes.factor] = self._drawn({kind: sizes.factor * mm for kind, mm in self.fits.items()})
        return self.kept[sizes.factor]

    @cached_property
    def fits(self) -> Mapping[str, float]:
        """The size in mm that a sheet gives each kind of plan."""
        return fits_on(self.scene.sheet, self.stated[0])

    @cached_property
    def kept(self) -> dict[float, Position]:
        """The position by the factor of its plans."""
        return {}

    @cached_property
    def first(self) -> Position:
        """The position at the scene's scales."""
        return self.at(Sizes())

    def extents(self, sizes: Sizes) -> dict[str, float]:
        """The size in mm of the scheme with loads, if its μ is open: its height, or its height on a square field."""
        wide, high = (self.times(sizes) * mm for mm in sides(self.at(sizes).drawing, SCHEME))
        return {LOADED: max(high, wide / math.sqrt(2))} if self.scene.mu.get(SCHEME) is None else {}

    def times(self, sizes: Sizes) -> float:
        """How many times larger the scheme with loads is than the other figures of links."""
        now = self.at(sizes)
        size, mu = extent(now.drawing, SCHEME), now.scales[mu_of(SCHEME)]
        if sizes.of(LOADED) == sizes.factor or not size:
            return 1.0
        mm = min(sizes.of(LOADED) * self.fits[SCHEME], MOST_TIMES * size)
        return fitting(SCHEME, size / mu, mm) / mu

    def grown(self, sizes: Sizes) -> Position:
        """The position with a separate, larger scheme: nothing is measured on it, so it may have a larger μ."""
        now, times = self.at(sizes), self.times(sizes)
        mu = times * now.scales[mu_of(SCHEME)]
        if times != 1.0 and mu not in self.alone:
            self.alone[mu] = self._drawn(self.fits, replace(self.scene, mu={**self.scene.mu, SCHEME: mu}))
        return now if times == 1.0 else self.alone[mu]

    @cached_property
    def alone(self) -> dict[float, Position]:
        """The position for its scheme alone, with the μ of that."""
        return {}

    def reduced(self, mm: float) -> Position:
        """The position with its scheme reduced to so many mm, whatever its μ is on the sheet."""
        open_mu = {kind: mu for kind, mu in self.scene.mu.items() if kind != "position"}
        return self._drawn({**self.fits, "position": mm}, replace(self.scene, mu=open_mu))

    def _drawn(self, fits: Mapping[str, float], scene: Scene | None = None) -> Position:
        plans, wanted = self.stated
        try:
            return position(scene or self.scene, plans, wanted, self.value, None, self.lang, fits)
        except PlanFailure as failure:
            said = failed(failure, self.value, plans.drive.kind, nearest(plans, self.value))
            raise SceneError(said, self.scene.file) from None


FINE = 360  # positions of the driver for curves and paths
MARGIN = 0.04  # of a partial range: the part left out at each end
CLOSE = 0.04  # of a section: an extreme position this close to a numbered one coincides with it

Rows = Mapping[str, Array]


def turned_once(scene: Scene, plans: Plans, composer: Composer, twelve: bool) -> Project:
    """A project with the driver moved through its range, and optionally the numbered positions of the scheme."""
    range_of_drive, motion = span_of(plans), TurningMechanism(plans)
    span = range_of_drive if range_of_drive.whole else range_of_drive.inner(MARGIN)
    dead = dead_points(driven_grid(plans, span.start, span.end)) if span.whole or twelve else []
    if span.whole and dead:
        span = WorkingRange(dead[0], dead[0] + FULL, True)
    if plans.drive.velocity < 0:  # positions are numbered in the order in which they are passed
        start, end = (span.start, span.start - FULL) if span.whole else (span.end, span.start)
        span = replace(span, start=start, end=end)
    values = span.values(FINE)
    rows = motion.rows(values)
    turn = motion.places(rows)
    numbered = motion.numbered(span, turn, dead) if twelve else []
    asked, loops = over_cycle(scene, plans, values, composer.naming)
    return Project(composer, values, turn, numbered, span.whole, asked or motion.curves(rows), loops)


class TurningMechanism:
    """Places of points, and positions and rates of links, at any positions of the drive: all drawn at once."""

    def __init__(self, plans: Plans) -> None:
        self.plans = plans
        known = results_of(plans)
        self.quantities = [q for q in known if q.group in ("links", "slides") or (q.group, q.key) == ("points", "r")]
        self.cycle = Cycle(plans, columns=columns_of(plans, self.quantities))

    def rows(self, values: Sequence[float]) -> Rows:
        """Every column at each position of the drive, NaN where the mechanism does not work."""
        (block,) = self.cycle.blocks(list(values), fast=False)
        table = np.where(block.failed, np.nan, block.table)
        return {c.name: row for c, row in zip(self.cycle.columns, table, strict=True)}

    def places(self, rows: Rows) -> list[PlacedMechanism | None]:
        """The places of all points at each position, None where the mechanism does not work."""
        points = {p: (rows[f"r_{p}_x"] + 1j * rows[f"r_{p}_y"]).tolist() for p in self.plans.points}
        angles = {q.of: rows[q.name].tolist() for q in self.quantities if q.key == "angle_deg"}
        works = np.isfinite(sum(rows.values())).tolist()
        at = ([{name: row[k] for name, row in x.items()} for x in (points, angles)] for k in range(len(works)))
        return [PlacedMechanism(where, how) if ok else None for (where, how), ok in zip(at, works, strict=True)]

    def curves(self, rows: Rows) -> tuple[DiagramCurve, ...]:
        """Position, from its least, and rates of the driven link, unless the driver is at rest."""
        slides, (place, rate, quick) = driven(self.plans)[1], output_curves(self.plans)
        at = curves_of(self.plans)[place].read(rows)
        at = at if slides else unwound(at)
        letters, units = ("sva", ("m", "m/s", "m/s²")) if slides else ("φωε", ("°", "rad/s", "rad/s²"))
        drawn = map(DiagramCurve, letters, units, map(known, (at - np.fmin.reduce(at), rows[rate], rows[quick])))
        return tuple(drawn)[: 1 if self.plans.at_rest else None]

    def numbered(
        self, span: WorkingRange, turn: Sequence[PlacedMechanism | None], extreme: Sequence[float]
    ) -> list[Numbered]:
        """The numbered positions, and every extreme one, with a prime unless it coincides with a numbered one."""
        section, every = (span.end - span.start) / SECTIONS, FINE // SECTIONS
        last = SECTIONS - 1 if span.whole else SECTIONS
        places = [(v, (v - span.start) / section) for v in extreme]
        places = [(v, p % SECTIONS) for v, p in places] if span.whole else places
        between = [(v, p) for v, p in places if abs(p - round(p)) >= CLOSE]
        near = {round(p) % (last + 1) for v, p in places if (v, p) not in between} | {0, 0 if span.whole else SECTIONS}
        numbered = [Numbered(str(k), turn[k * every], k in near) for k in range(last + 1)]
        primed = self.places(self.rows([v for v, _ in between])) if between else []
        return numbered + [Numbered(f"{int(p)}′", r, True) for (_, p), r in zip(between, primed, strict=True)]
