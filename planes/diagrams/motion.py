"""The driven link's motion through a uniform turn, in equal sections: what graphical diagrams start from."""

from __future__ import annotations

from math import isfinite

import numpy as np

from planes.diagrams.curves import curves_of, output_curves, transfer_curves
from planes.diagrams.driven import FULL, driven
from planes.diagrams.extremes import extremes
from planes.diagrams.graphical import Construction, differentiated, integrated
from planes.diagrams.stages import Motion
from planes.diagrams.turn import Grid, WholeTurn, grid, span_of, turn_of, unwound
from planes.geometry.arrays import Array
from planes.plans import Plans, mechanism_plans
from planes.scene import Scene
from planes.words import Phrase
from planes.words.errors import PlanesError

DENSE = 10  # places of the drawn curve within a section
FEWEST, MOST = 6, 72
INSET = 0.02  # of a range that ends at limits of assembly


def motion_of(plans: Plans, sections: int = 12, file: str = "") -> Motion:
    """The motion of the driven link from its extreme position on, the driver turning uniformly the way it does.

    Where the mechanism does not assemble all the way round it is the working part of the turn that is divided.
    """
    drive = plans.mechanism.drive
    if drive.kind != "phi" or not drive.velocity:
        raise PlanesError(Phrase("graphical_no_turn", file=file))
    if not FEWEST <= sections <= MOST:
        raise PlanesError(Phrase("graphical_sections", count=sections, least=FEWEST, most=MOST))
    link, slides = driven(plans)
    turn = WholeTurn(plans, [curves_of(plans)[n] for n in (output_curves(plans)[0], *transfer_curves(plans))])
    low, high, closed = ends_of(plans)
    flips = () if slides else grid(turn, low, high).flips
    if flips:
        raise PlanesError(Phrase("graphical_flips", link=link, place=f"{flips[0][1] % FULL:.4f}"))
    start, span = (low, high - low) if drive.velocity > 0 else (high, low - high)
    angles = start + span * np.arange(2 * sections + 1) / (2 * sections)
    dense = start + span * np.arange(DENSE * sections + 1) / (DENSE * sections)
    half, fine = _values(turn, angles, slides, drive.velocity), _values(turn, dense, slides, drive.velocity)
    return Motion(
        link,
        slides,
        tuple(map(float, angles[::2])),
        _time(angles[::2], drive.velocity),
        closed,
        tuple(tuple(row[::2]) for row in half),
        tuple(tuple(row[1::2]) for row in half),
        _time(dense, drive.velocity),
        tuple(tuple(row) for row in fine),
    )


def _time(angles: Array, rate: float) -> tuple[float, ...]:
    return tuple(float(t) for t in np.radians(angles - angles[0]) / rate)


def _values(turn: WholeTurn, angles: Array, slides: bool, rate: float) -> list[list[float]]:
    """Place (counted from the start), velocity v_q·ω₁ and acceleration a_q·ω₁² of a uniform turn, SI."""
    sample = turn.sample(angles)
    place, v, a = (c.read(sample) + np.zeros(len(angles)) for c in turn.curves)
    if not slides:
        place = np.radians(unwound(place))
    return [[float(x) for x in row] for row in (place - place[0], v * rate, a * rate * rate)]


def ends_of(plans: Plans) -> tuple[float, float, bool]:
    """Where diagrams begin and end, and whether they come back: a whole turn from the driven link's first extreme
    position, or the working range about the scene's own place, less a little where rates grow without bound."""
    span = span_of(plans)
    if not span.whole:
        inner = span.inner(INSET)
        return inner.start, inner.end, False
    start = min(dead_points(driven_grid(plans, 0.0, FULL)), default=0.0)
    return start, start + FULL, True


def driven_grid(plans: Plans, start: float, end: float) -> Grid:
    """The driven link's place between two places of the driver."""
    return grid(turn_of(plans, output_curves(plans)[:1]), start, end)


def dead_points(g: Grid) -> list[float]:
    """Where the driven link turns back, in order: not where it turns over, nor at ends of the range and of assembly."""
    cell = 1.01 * (g.places[-1] - g.places[0]) / max(1, len(g.places) - 1)
    turned = (e.place for e in extremes(g)[0] if not e.at and isfinite(e.value))
    return [place for place in turned if all(_apart(place, z, g) > cell for _, z in g.flips)]


def _apart(one: float, two: float, g: Grid) -> float:
    """How far two places of the driver are apart, the short way round where it goes round."""
    return abs((one - two + FULL / 2) % FULL - FULL / 2) if g.closed else abs(one - two)


def constructed(scene: Scene, sections: int, pole_mm: float | None = None) -> list[Construction]:
    """Both graphical constructions of the driven link's motion."""
    if pole_mm is not None and not 1.0 <= pole_mm <= 500.0:
        raise PlanesError(Phrase("graphical_pole", pole=pole_mm))
    motion = motion_of(mechanism_plans(scene), sections, scene.file)
    return [differentiated(motion, pole_mm), integrated(motion, pole_mm)]
