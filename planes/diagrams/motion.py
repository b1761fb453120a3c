"""The driven link's motion through a uniform turn, in equal sections, as the start of graphical diagrams; and the
driver's positions for curves: runs between dead points, where forces may jump, and stations."""

from math import isfinite

import numpy as np

from planes.diagrams.extremes import extremes_of_curves
from planes.diagrams.turn import Grid, WholeTurn, make_grid, unwind_angles, whole_turn_of, working_range_of
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.curves import (
    FULL_TURN_DEG,
    curves_by_name,
    driven_link_analogues,
    driven_link_and_sliding,
    driven_link_curves,
)
from planes.words import Phrase
from planes.words.errors import PlanesError
from planes.words.frozen import frozen

CURVE_POINTS_PER_SECTION = 10  # points of the drawn curve per section
FEWEST_SECTIONS = 6
MOST_SECTIONS = 72
RANGE_INSET_RATIO = 0.02  # part left off a range that ends at limits of assembly
Row = tuple[float, ...]


@frozen
class Motion:
    """A uniform motion over one turn: ``time`` (s) at the ends of the sections, ``closed`` if it returns to its start;
    ``driver`` is the name of the driver's angle.

    ``ends`` and ``middles`` hold for each rank (0 position, 1 velocity, 2 acceleration) the exact values at the ends
    and at the middles of the sections, SI (an angle in radians); ``curves`` the same over a dense time, for drawing.
    """

    link: str
    slides: bool
    driver: str
    angles: Row
    time: Row
    closed: bool
    ends: tuple[Row, ...]
    middles: tuple[Row, ...]
    dense_time: Row
    curves: tuple[Row, ...]

    @property
    def section_count(self) -> int:
        """The number of sections."""
        return len(self.time) - 1


def motion_of_driven_link(plans: Plans, sections: int = 12, file: str = "") -> Motion:
    """The motion of the driven link from its extreme position on, with the driver turning uniformly in its sense.

    Where the mechanism does not assemble all the way round, the working range is divided instead.
    """
    drive = plans.drive
    if not drive.rotates or not drive.velocity:
        raise PlanesError(Phrase("graphical_no_turn", file=file))
    if not FEWEST_SECTIONS <= sections <= MOST_SECTIONS:
        raise PlanesError(Phrase("graphical_sections", count=sections, least=FEWEST_SECTIONS, most=MOST_SECTIONS))
    link, slides = driven_link_and_sliding(plans)
    turn = WholeTurn(
        plans, [curves_by_name(plans)[n] for n in (driven_link_curves(plans)[0], *driven_link_analogues(plans))]
    )
    low, high, closed = diagram_range(plans)
    flips = () if slides else make_grid(turn, low, high).link_turn_overs
    if flips:
        raise PlanesError(Phrase("graphical_flips", link=link, place=f"{flips[0][1] % FULL_TURN_DEG:.4f}"))
    start, span = (low, high - low) if drive.velocity > 0 else (high, low - high)
    angles = start + span * np.arange(2 * sections + 1) / (2 * sections)
    dense = start + span * np.arange(CURVE_POINTS_PER_SECTION * sections + 1) / (CURVE_POINTS_PER_SECTION * sections)
    half, fine = (_motion_values(turn, at, slides, drive.velocity) for at in (angles, dense))
    ends, middles = (tuple(tuple(row[k::2]) for row in half) for k in (0, 1))
    times, all_times = (tuple((np.radians(at - at[0]) / drive.velocity).tolist()) for at in (angles[::2], dense))
    places = tuple(angles[::2].tolist())
    curves = tuple(map(tuple, fine))
    return Motion(link, slides, drive.motion_names[0], places, times, closed, ends, middles, all_times, curves)


def _motion_values(turn: WholeTurn, angles: Array, slides: bool, rate: float) -> list[list[float]]:
    """Position (from the start), velocity v_q·ω₁ and acceleration a_q·ω₁² of a uniform turn, SI."""
    sample = turn.sample_columns(angles)
    place, v, a = (c.read(sample) + np.zeros(len(angles)) for c in turn.curves)
    if not slides:
        place = np.radians(unwind_angles(place))
    return [row.tolist() for row in (place - place[0], v * rate, a * rate * rate)]


def diagram_range(plans: Plans) -> tuple[float, float, bool]:
    """The beginning and the end of diagrams, and whether the motion is periodic: a whole turn from the driven link's
    first extreme position, or the working range about the scene's position, less a little where rates grow without
    bound."""
    span = working_range_of(plans)
    if not span.whole:
        inner = span.range_without_ends(RANGE_INSET_RATIO)
        return inner.start, inner.end, False
    start = min(dead_point_positions(grid_of_driven_link(plans, 0.0, FULL_TURN_DEG)), default=0.0)
    return start, start + FULL_TURN_DEG, True


def grid_of_driven_link(plans: Plans, start: float, end: float) -> Grid:
    """The driven link's position between two positions of the driver."""
    return make_grid(whole_turn_of(plans, driven_link_curves(plans)[:1]), start, end)


def dead_point_positions(g: Grid) -> list[float]:
    """Where the driven link reverses, in order; without ends of the range, and places where it turns over."""
    cell = 1.01 * (g.places[-1] - g.places[0]) / max(1, len(g.places) - 1)
    turned = (e.place for curve in extremes_of_curves(g)[:1] for e in curve if not e.at and isfinite(e.value))
    return [place for place in turned if all(_driver_distance(place, z, g) > cell for _, z in g.link_turn_overs)]


def _driver_distance(one: float, two: float, g: Grid) -> float:
    """The distance between two positions of the driver, the short way round where it turns fully."""
    if g.closed:
        return abs((one - two + FULL_TURN_DEG / 2) % FULL_TURN_DEG - FULL_TURN_DEG / 2)
    return abs(one - two)


# degrees (or metres) to either side of a dead point, where quantities may jump with the sense of motion
DEAD_POINT_OFFSET = 1e-6
DIAGRAM_STEPS = 720
STATION_COUNT = 12


class Runs:
    """Positions of the driver between two ends, split where the driven link stands still."""

    def __init__(self, plans: Plans, start: float, end: float) -> None:
        self.plans = plans
        self.start = start
        self.end = end
        places = grid_of_driven_link(plans, start, end)
        self.dead = dead_point_positions(places)
        self.closed = places.closed

    def runs_between_dead_points(self) -> list[Array]:
        """Positions in runs between dead points, each run up to the dead point itself."""
        dead = self._dead_point_positions()
        inside = sorted(d for d in dead if self.start + DEAD_POINT_OFFSET < d < self.end - DEAD_POINT_OFFSET)
        first, last = (
            DEAD_POINT_OFFSET * any(abs(d - end) <= DEAD_POINT_OFFSET for d in dead) for end in (self.start, self.end)
        )
        edges = [
            self.start + first,
            *(e for d in inside for e in (d - DEAD_POINT_OFFSET, d + DEAD_POINT_OFFSET)),
            self.end - last,
        ]
        step = (self.end - self.start) / DIAGRAM_STEPS
        return [
            np.linspace(a, b, max(2, round((b - a) / step) + 1)) for a, b in zip(edges[::2], edges[1::2], strict=True)
        ]

    def _dead_point_positions(self) -> set[float]:
        return {d + FULL_TURN_DEG * k for d in self.dead for k in ((-1, 0, 1) if self.closed else (0,))}

    def numbered_stations(self) -> Array:
        """The numbered positions: every twelfth part of the range (of a turn, 30°), from the start."""
        return np.linspace(self.start, self.end, STATION_COUNT + 1)

    def stations_off_dead_points(self) -> Array:
        """The same, with those on a dead point moved just past it: on the point itself a load that opposes motion is
        zero."""
        return np.array(
            [
                z + DEAD_POINT_OFFSET * any(abs(z - d) < DEAD_POINT_OFFSET for d in self._dead_point_positions())
                for z in self.numbered_stations()
            ]
        )
