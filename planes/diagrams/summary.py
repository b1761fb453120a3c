"""A whole cycle in figures: the driven link's stroke and dead points, the time ratio, extremes of all curves, paths."""

from collections.abc import Iterable, Sequence
from functools import cached_property

import numpy as np

from planes.diagrams.extremes import Extreme, extremes_of_curves, has_variation
from planes.diagrams.turn import Grid, driver_search_range, grid_in_one_piece, make_grid, whole_turn_of
from planes.geometry.arrays import Array, Complexes
from planes.plans import Plans
from planes.plans.curves import FULL_TURN_DEG, Curve, driven_link_and_sliding
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.scene.ranges import Interval
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen, replace
from planes.words.names import NameTuple, component_axis, letter_of, name_index

EQUAL_CURVES_RATIO = 1e-12


@frozen
class CurveSummary:
    """A curve (or several equal ones: ``names``) with its least and greatest values, one number if it is constant."""

    names: NameTuple
    unit: str
    group: str
    least: Extreme
    greatest: Extreme
    size: float  # the largest finite magnitude on the grid: a value negligible beside it is zero
    rounds: bool  # an angle of a link that turns all the way round
    constant: bool


@frozen
class DrivenStroke:
    """The driven link between its two extreme positions (``dead``: the driver's positions and the link's own there).

    ``swing`` is in metres or degrees. ``forth`` and ``back`` are the parts of the driver's turn (degrees) in which it
    goes from the first extreme position to the second, and returns; their ratio, the larger over the smaller, is ``K``.
    A link that turns all the way round has no extreme positions, nor does one that moves without bound (``swing`` inf).
    """

    link: str
    slides: bool
    curve: str
    dead: tuple[Extreme, ...]
    swing: float
    rounds: bool = False
    forth: float | None = None
    back: float | None = None
    others: int = 0

    @property
    def time_ratio(self) -> float | None:
        """The time ratio at a constant speed of the driver: the longer of the two strokes over the shorter."""
        if not self.forth or not self.back:
            return None
        return max(self.forth, self.back) / min(self.forth, self.back)


@frozen
class Path:
    """A point's path: its length and its bounding box."""

    point: str
    length: float
    x: Interval
    y: Interval


@frozen
class Summary:
    """The figures of a cycle, all read from one :class:`Grid`; ``names``: the curves that the user asked for."""

    scene: Scene
    plans: Plans
    grid: Grid
    names: NameTuple = ()

    @cached_property
    def extremes_by_curve(self) -> dict[str, list[Extreme]]:
        """Every curve's extremes by its name."""
        return {c.name: e for c, e in zip(self.grid.turn.curves, extremes_of_curves(self.grid), strict=True)}

    @cached_property
    def driven_stroke(self) -> DrivenStroke | None:
        """The driven link's stroke, or angle of swing; None where it turns over, or there is no mechanism."""
        if not self.plans.has_mechanism:
            return None
        link, slides = driven_link_and_sliding(self.plans)
        name = f"{'s' if slides else 'phi'}_{link}"
        curve = next((c for c in self.grid.turn.curves if c.name == name), None)
        if curve is None or link == self.plans.drive.link or name in dict(self.grid.link_turn_overs):
            return None
        if self.grid.turns_fully(curve):
            return DrivenStroke(link, slides, name, (), FULL_TURN_DEG, True)
        some = self.extremes_by_curve[name]
        if not some:
            return None
        low = min(some, key=lambda e: e.value)
        high = max(some, key=lambda e: e.value)
        if np.isinf(high.value - low.value):
            return DrivenStroke(link, slides, name, tuple(e for e in some if np.isinf(e.value)), np.inf)
        dead = tuple(sorted((low, high), key=lambda e: e.place))
        others = sum(e.at == "" for e in some if e not in dead)
        forth = back = None
        if self.grid.closed:
            forth = (dead[1].place - dead[0].place) % FULL_TURN_DEG
            back = FULL_TURN_DEG - forth
        return DrivenStroke(link, slides, name, dead, high.value - low.value, False, forth, back, others)

    @cached_property
    def curve_summaries(self) -> tuple[CurveSummary, ...]:
        """The curves to show: of vectors the magnitudes; equal ones in one row; no curve that is always zero."""
        rows_with_values = list[tuple[Array, CurveSummary]]()
        for curve in self.grid.turn.curves:
            if not self._is_shown(curve):
                continue
            y = self.grid.curve_values(curve)
            if not np.isfinite(y).any() or np.nanmax(np.abs(y)) <= self.grid.rounding_variation(curve):
                continue
            twin = next(
                (k for k, (other, row) in enumerate(rows_with_values) if _is_equal_to_row(y, other, curve, row)), None
            )
            if twin is None:
                rows_with_values.append((y, self._summarise_curve(curve, y)))
            else:
                other, row = rows_with_values[twin]
                rows_with_values[twin] = other, replace(row, names=(*row.names, curve.name))
        return tuple(row for _, row in rows_with_values)

    def _summarise_curve(self, curve: Curve, y: Array) -> CurveSummary:
        some = self.extremes_by_curve[curve.name]
        size = float(np.nanmax(np.abs(y)))
        rounds = self.grid.turns_fully(curve)
        k = int(np.flatnonzero(np.isfinite(y))[0])
        extremes = some or [Extreme(float(self.grid.places[k]), float(y[k]), 1)]  # the only value of a constant
        low = _first_greatest_extreme(extremes, -1, size)
        high = _first_greatest_extreme(extremes, 1, size)
        still = not some and not rounds
        return CurveSummary((curve.name,), curve.unit, curve.group, low, high, size, rounds, still)

    def _is_shown(self, curve: Curve) -> bool:
        name = curve.name
        driver = self.plans.drive.link
        if self.names:
            return name in self.names
        if letter_of(name) in ("MZ", "FbZ") or component_axis(name):
            return False
        if letter_of(name) == "phi":
            return name_index(name) != driver and has_variation(
                self.grid.curve_values(curve), self.grid.rounding_variation(curve)
            )
        return name != f"s_{driver}"

    @cached_property
    def paths_of_points(self) -> tuple[Path, ...]:
        """Paths of the moving points."""
        paths = []
        frame = self.plans.mechanism.frame.points
        for p in self.plans.points:
            if p not in frame:
                z = self.grid.sampled_columns[f"r_{p}_x"] + 1j * self.grid.sampled_columns[f"r_{p}_y"]
                length = sum(_path_length(run) for run in np.split(z, np.flatnonzero(~self.grid.assembled_mask)))
                if length:
                    both = (*self.extremes_by_curve[f"r_{p}_x"], *self.extremes_by_curve[f"r_{p}_y"])
                    length = np.inf if any(np.isinf(e.value) for e in both) else length
                    x, y = (
                        (self._extreme_coordinate(f"r_{p}_{axis}", -1), self._extreme_coordinate(f"r_{p}_{axis}", 1))
                        for axis in "xy"
                    )
                    paths.append(Path(p, length, x, y))
        return tuple(paths)

    def _extreme_coordinate(self, name: str, sense: int) -> float:
        """The greatest (or least, −1) coordinate."""
        row = self.grid.sampled_columns[name]
        some = [e.value for e in self.extremes_by_curve[name]] or [float(row[np.isfinite(row)][0])]
        return sense * max(sense * value for value in some)


def _first_greatest_extreme(some: Sequence[Extreme], sense: int, size: float) -> Extreme:
    """The greatest (or least, −1) of extremes; of those equal within rounding the first."""
    most = max(sense * e.value for e in some)
    return next(e for e in some if sense * e.value >= most - EQUAL_CURVES_RATIO * size)


def _path_length(path: Complexes) -> float:
    """The length of a curve through many points: that of its polygon, improved by the polygon of every second point."""
    path = path[np.isfinite(path)]
    if len(path) < 2:
        return 0.0
    polygon = float(np.abs(np.diff(path)).sum())
    if len(path) % 2 == 0:
        return polygon
    return polygon + (polygon - float(np.abs(np.diff(path[::2])).sum())) / 3


def _is_equal_to_row(y: Array, other: Array, curve: Curve, row: CurveSummary) -> bool:
    if (curve.unit, curve.group) != (row.unit, row.group) or curve.name[:2] != row.names[0][:2]:
        return False
    size = np.nanmax(np.abs(other))
    return bool(
        np.array_equal(np.isnan(y), np.isnan(other)) and np.nanmax(np.abs(y - other)) <= EQUAL_CURVES_RATIO * size
    )


def summary_of_scene(scene: Scene, ends: Interval | None = None, names: Iterable[str] | None = None) -> Summary:
    """The cycle of a scene between two positions of the driver, or by default a turn, or a slider's reach.
    :class:`PlanesError` where the mechanism assembles nowhere."""
    plans = scene_plans(scene)
    start, end = ends or ((0.0, FULL_TURN_DEG) if plans.drive.rotates else driver_search_range(plans))
    cycle = summarise_cycle(scene, plans, start, end, names)
    if not cycle.grid.assembled_mask.any():
        raise PlanesError(Phrase("cycle_never", first=start, last=end))
    return cycle


def summarise_cycle(
    scene: Scene, plans: Plans, start: float = 0.0, end: float = FULL_TURN_DEG, names: Iterable[str] | None = None
) -> Summary:
    """The cycle between two positions of the driver (degrees, or metres): every curve, read at 721 positions or more;
    ``names`` are those to show.

    A full turn in which the mechanism stops somewhere begins there, so that a working range is one piece.
    """
    count = max(721, round(abs(end - start) / 0.5) + 1) if plans.drive.rotates else 721
    shown = () if names is None else tuple(c.name for c in whole_turn_of(plans, names, file=scene.file).curves)
    turn = whole_turn_of(plans)
    low = min(start, end)
    high = max(start, end)
    return Summary(scene, plans, grid_in_one_piece(make_grid(turn, low, high, min(count, 20001))), shown)
