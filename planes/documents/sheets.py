"""The contents of a scene's sheets: its position drawn at the requested sizes, and its driver moved once through its
range from an extreme position of the driven link, for sheet 1."""

import math
from collections.abc import Iterable, Mapping, Sequence
from functools import cache, cached_property
from typing import Any

import numpy as np

from planes.batch.cycle import Cycle
from planes.batch.table import columns_of_quantities
from planes.diagrams.motion import dead_point_positions, grid_of_driven_link
from planes.diagrams.turn import LEAST_FLIP_DEG, unwind_angles, working_range_of
from planes.documents.cycle import check_diagram_names, diagrams_and_hodographs, finite_or_none, names_under_key
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.curves import FULL_TURN_DEG, WorkingRange, curves_by_name, driven_link_and_sliding, driven_link_curves
from planes.plans.extents import plan_extent, plan_width_and_height
from planes.plans.quantities import results_wanted
from planes.plans.scales import largest_fitting_scale, plan_sizes
from planes.scene import Scene
from planes.solving import Position, failed_position_sentence, plans_and_requested_results, solve_position
from planes.solving.nearest import nearest_working_position
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, PlanFailure, SceneError
from planes.words.frozen import frozen, replace
from planes.words.names import LEVER_PLAN, SCHEME_PLAN, NumbersByName
from render.paper.hues import colour_vectors
from render.paper.marks import using_face
from render.paper.outlines import face_of_scene
from render.sheet import Contents, Held, Sheet, compose_sheet
from render.sheet.composer import Composer, Together
from render.sheet.force_sheet import ForceSheet
from render.sheet.frame import using_form_of_scene
from render.sheet.project import Project
from render.sheet.sizes import LOADED_VIEW_KEY, Sizes
from render.sheet.studio_code import studio_code_view
from render.views import View
from render.views.curve_pieces import drop_steep_ordinates
from render.views.diagrams import SECTION_COUNT, DiagramCurve, section_width_mm
from render.views.many import Numbered, PlacedMechanism

DrivePositions = Iterable[float] | None  # degrees or m; None: that of the scene


def sheet_of(scene: Scene, values: DrivePositions, lang: Lang = "ru", number: int | None = None) -> Sheet:
    """The composed sheet of one position, or of vectors alone; ``number`` is that of a sheet of a project."""
    with using_face(face_of_scene(scene)), using_form_of_scene(scene):
        sheet = _composed_sheet(scene, values, lang, number)
    if scene.sheet.get("colour"):
        return replace(sheet, marks=colour_vectors(sheet.marks))
    return sheet


def _composed_sheet(scene: Scene, values: DrivePositions, lang: Lang, number: int | None) -> Sheet:
    drawn = DrawnPosition(replace(scene, find=None) if number else scene, values, lang)
    check_diagram_names(scene, drawn.plans_and_wanted[0])
    composer = Composer(scene, lang, drawn.plans_and_wanted[0])
    if number:
        return _project_sheet(drawn, composer, number)

    def views(sizes: Sizes, letter: float, together: Together) -> Held:
        now = drawn.position_at_sizes(sizes)
        shown = [*composer.all_views(now, letter, together), *studio_code_views(scene, composer.lang)]
        return shown, [v for v in (composer.moments_view(now, letter),) if v]

    return compose_sheet(scene, Contents(views, free=drawn.has_open_scale), lang)


def _project_sheet(drawn: "DrawnPosition", composer: Composer, number: int) -> Sheet:
    """Sheet 1 or 2 of a course project."""
    scene, project, forces, lang = drawn.scene, Project(composer), ForceSheet(composer), composer.lang
    if number == 1:
        turned = project_over_turn(
            scene, drawn.position_at_scene_scales.plans, composer, bool(scene.sheet.get("positions", True))
        )
        project = replace(turned, reduced=cache(drawn.with_reduced_scheme))

    def views(sizes: Sizes, letter: float, together: Together) -> Held:
        if number == 2:
            return forces.all_views(drawn.position_at_sizes(sizes), drawn.with_enlarged_scheme(sizes), letter), []
        return [
            *project.kinematics_views(
                drawn.position_at_sizes(sizes), sizes.factor_of_plan("diagrams"), letter, together
            ),
            *studio_code_views(scene, lang),
        ], []

    def extents(sizes: Sizes) -> NumbersByName:
        """The parts that can grow: the diagrams."""
        if project.turn:
            return {"diagrams": section_width_mm(sizes.factor_of_plan("diagrams")) * SECTION_COUNT}
        return {}

    if number == 1:
        return compose_sheet(scene, Contents(views, extents, free=drawn.has_open_scale), composer.lang, number)
    held = Contents(views, drawn.loaded_scheme_extents, free=drawn.has_open_scale, together=(Together(),))
    return compose_sheet(scene, held, composer.lang, number)


def studio_code_views(scene: Scene, lang: Lang) -> list[View]:
    """The QR code that opens the scene in a studio, if it names one."""
    return [v for v in (studio_code_view(scene, lang),) if v]


MOST_SCHEME_ENLARGEMENT = 2.0  # how much larger the scheme with loads may be than its groups


@frozen
class DrawnPosition:
    """One position of a scene, drawn with any sizes of its plans; each once."""

    scene: Scene
    values: DrivePositions
    lang: Lang

    @cached_property
    def plans_and_wanted(self) -> tuple[Plans, Any]:
        """The plans, and the requested results."""
        return plans_and_requested_results(self.scene, shown=True)

    @cached_property
    def drive_position(self) -> float:
        """The position of the drive for a sheet."""
        chosen = [self.plans_and_wanted[0].mechanism.drive.position] if self.values is None else list(self.values)
        if len(chosen) != 1:
            raise PlanesError(Phrase("one_position", count=len(chosen)))
        return chosen[0]

    @property
    def has_open_scale(self) -> bool:
        """Whether the scene leaves the μ of any plan open."""
        return any(self.scene.mu.get(p.kind) is None for p in self.plans_and_wanted[0].plan_names if p != LEVER_PLAN)

    def position_at_sizes(self, sizes: Sizes) -> Position:
        """The position at the scene's scales, or smaller where no paper holds its plans at these, each drawn once.
        :class:`PlanesError` where it cannot be drawn."""
        if sizes.factor not in self.positions_by_factor:
            self.positions_by_factor[sizes.factor] = self._draw_position(
                {kind: sizes.factor * mm for kind, mm in self.plan_sizes_mm.items()}
            )
        return self.positions_by_factor[sizes.factor]

    @cached_property
    def plan_sizes_mm(self) -> NumbersByName:
        """The size in mm that a sheet gives each kind of plan."""
        plans = self.plans_and_wanted[0]
        moved = plans.drive_givens_at(self.drive_position)
        return plan_sizes(plans, self.scene.mu, self.scene.sheet, moved)

    @cached_property
    def positions_by_factor(self) -> dict[float, Position]:
        """The position by the factor of its plans."""
        return {}

    @cached_property
    def position_at_scene_scales(self) -> Position:
        """The position at the scene's scales."""
        return self.position_at_sizes(Sizes())

    def loaded_scheme_extents(self, sizes: Sizes) -> NumbersByName:
        """The size in mm of the scheme with loads, if its μ is open: its height, or its height on a square field."""
        wide, high = (
            self.loaded_scheme_enlargement(sizes) * mm
            for mm in plan_width_and_height(self.position_at_sizes(sizes).drawing, SCHEME_PLAN)
        )
        if self.scene.mu.get(SCHEME_PLAN) is None:
            return {LOADED_VIEW_KEY: max(high, wide / math.sqrt(2))}
        return {}

    def loaded_scheme_enlargement(self, sizes: Sizes) -> float:
        """How many times larger the scheme with loads is than the other figures of links."""
        now = self.position_at_sizes(sizes)
        size = plan_extent(now.drawing, SCHEME_PLAN)
        mu = now.scales[SCHEME_PLAN.mu_name]
        if sizes.factor_of_plan(LOADED_VIEW_KEY) == sizes.factor or not size:
            return 1.0
        mm = min(
            sizes.factor_of_plan(LOADED_VIEW_KEY) * self.plan_sizes_mm[SCHEME_PLAN], MOST_SCHEME_ENLARGEMENT * size
        )
        return largest_fitting_scale(SCHEME_PLAN, size / mu, mm) / mu

    def with_enlarged_scheme(self, sizes: Sizes) -> Position:
        """The position with a separate, larger scheme: nothing is measured on it, so it may have a larger μ."""
        now = self.position_at_sizes(sizes)
        times = self.loaded_scheme_enlargement(sizes)
        mu = times * now.scales[SCHEME_PLAN.mu_name]
        if times != 1.0 and mu not in self.positions_by_scheme_mu:
            self.positions_by_scheme_mu[mu] = self._draw_position(
                self.plan_sizes_mm, replace(self.scene, mu={**self.scene.mu, SCHEME_PLAN: mu})
            )
        return now if times == 1.0 else self.positions_by_scheme_mu[mu]

    @cached_property
    def positions_by_scheme_mu(self) -> dict[float, Position]:
        """The position for its scheme alone, with the μ of that."""
        return {}

    def with_reduced_scheme(self, mm: float) -> Position:
        """The position with its scheme reduced to so many mm, whatever its μ is on the sheet."""
        open_mu = {kind: mu for kind, mu in self.scene.mu.items() if kind != "position"}
        return self._draw_position({**self.plan_sizes_mm, "position": mm}, replace(self.scene, mu=open_mu))

    def _draw_position(self, fits: NumbersByName, scene: Scene | None = None) -> Position:
        plans, wanted = self.plans_and_wanted
        try:
            return solve_position(scene or self.scene, plans, wanted, self.drive_position, None, self.lang, fits)
        except PlanFailure as failure:
            said = failed_position_sentence(
                failure, self.drive_position, plans.drive.kind, nearest_working_position(plans, self.drive_position)
            )
            raise SceneError(said, self.scene.file) from None


CURVE_POSITION_COUNT = 360  # positions of the driver for curves and paths
LEFT_OUT_END_SHARE = 0.04  # of a partial range: the part left out at each end
SAME_POSITION_SECTION_SHARE = 0.04  # of a section: an extreme position this close to a numbered one coincides with it

Rows = Mapping[str, Array]


def project_over_turn(scene: Scene, plans: Plans, composer: Composer, twelve: bool) -> Project:
    """A project with the driver moved through its range, and optionally the numbered positions of the scheme."""
    range_of_drive = working_range_of(plans)
    motion = TurningMechanism(plans)
    span = range_of_drive if range_of_drive.whole else range_of_drive.range_without_ends(LEFT_OUT_END_SHARE)
    dead = dead_point_positions(grid_of_driven_link(plans, span.start, span.end)) if span.whole or twelve else []
    if span.whole and dead:
        span = WorkingRange(dead[0], dead[0] + FULL_TURN_DEG, True)
    if plans.drive.velocity < 0:  # positions are numbered in the order in which they are passed
        start, end = (span.start, span.start - FULL_TURN_DEG) if span.whole else (span.end, span.start)
        span = replace(span, start=start, end=end)
    values = span.evenly_spaced_values(CURVE_POSITION_COUNT)
    rows = motion.column_rows(values)
    turn = motion.placed_mechanisms(rows)
    numbered = motion.numbered_positions(span, turn, dead) if twelve else []
    asked, loops = diagrams_and_hodographs(scene, plans, values, span.whole, composer.naming)
    curves = asked or motion.driven_link_curves(rows, span.whole)
    return Project(composer, values, turn, numbered, span.whole, curves, loops, names_under_key(scene.sheet, "paths"))


def _above_least(values: Sequence[float | None]) -> tuple[float | None, ...]:
    """Values from the least of them."""
    least = min((v for v in values if v is not None), default=0.0)
    return tuple(None if v is None else v - least for v in values)


class TurningMechanism:
    """Places of points, and positions and rates of links, at any positions of the drive: all drawn at once."""

    def __init__(self, plans: Plans) -> None:
        self.plans = plans
        known = results_wanted(plans)
        self.quantities = [q for q in known if q.group in ("links", "slides") or (q.group, q.key) == ("points", "r")]
        self.cycle = Cycle(plans, columns=columns_of_quantities(plans, self.quantities))

    def column_rows(self, values: Sequence[float]) -> Rows:
        """Every column at each position of the drive, NaN where the mechanism does not work."""
        (block,) = self.cycle.blocks(list(values), fast=False)
        table = np.where(block.failed_mask, np.nan, block.table)
        return {c.name: row for c, row in zip(self.cycle.columns, table, strict=True)}

    def placed_mechanisms(self, rows: Rows) -> list[PlacedMechanism | None]:
        """The places of all points at each position, None where the mechanism does not work."""
        points = {p: (rows[f"r_{p}_x"] + 1j * rows[f"r_{p}_y"]).tolist() for p in self.plans.points}
        angles = {q.of: rows[q.name].tolist() for q in self.quantities if q.key == "angle_deg"}
        works = np.isfinite(sum(rows.values())).tolist()
        at = ([{name: row[k] for name, row in x.items()} for x in (points, angles)] for k in range(len(works)))
        return [PlacedMechanism(where, how) if ok else None for (where, how), ok in zip(at, works, strict=True)]

    def driven_link_curves(self, rows: Rows, full_turn: bool) -> tuple[DiagramCurve, ...]:
        """Position, from its least, and rates of the driven link, unless the driver is at rest."""
        slides, (place, *rates) = driven_link_and_sliding(self.plans)[1], driven_link_curves(self.plans)
        at = curves_by_name(self.plans)[place].read(rows)
        if not slides:
            at = unwind_angles(at)
            at[1:][np.abs(np.diff(at)) > LEAST_FLIP_DEG] = np.nan  # it turns over: a gap
        letters, units = ("sva", ("m", "m/s", "m/s²")) if slides else ("φωε", ("°", "rad/s", "rad/s²"))
        calm = [drop_steep_ordinates(finite_or_none(row), full_turn) for row in (at, *(rows[rate] for rate in rates))]
        drawn = map(DiagramCurve, letters, units, (_above_least(calm[0]), *calm[1:]))
        return tuple(drawn)[: 1 if self.plans.at_rest else None]

    def numbered_positions(
        self, span: WorkingRange, turn: Sequence[PlacedMechanism | None], extreme: Sequence[float]
    ) -> list[Numbered]:
        """The numbered positions, and every extreme one, with a prime unless it coincides with a numbered one."""
        section = (span.end - span.start) / SECTION_COUNT
        every = CURVE_POSITION_COUNT // SECTION_COUNT
        last = SECTION_COUNT - 1 if span.whole else SECTION_COUNT
        places = [(v, (v - span.start) / section) for v in extreme]
        places = [(v, p % SECTION_COUNT) for v, p in places] if span.whole else places
        between = [(v, p) for v, p in places if abs(p - round(p)) >= SAME_POSITION_SECTION_SHARE]
        near = {round(p) % (last + 1) for v, p in places if (v, p) not in between} | {
            0,
            0 if span.whole else SECTION_COUNT,
        }
        numbered = [Numbered(str(k), turn[k * every], k in near) for k in range(last + 1)]
        primed = self.placed_mechanisms(self.column_rows([v for v, _ in between])) if between else []
        return numbered + [Numbered(f"{int(p)}′", r, True) for (_, p), r in zip(between, primed, strict=True)]
