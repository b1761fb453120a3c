"""The driver moved once through its range from an extreme position of the driven link, for sheet 1."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property

import numpy as np

from planes.batch import Cycle
from planes.batch.columns import columns_of
from planes.diagrams.curves import curves_of, output_curves
from planes.diagrams.driven import FULL, WorkingRange, driven
from planes.diagrams.motion import dead_points, driven_grid
from planes.diagrams.turn import span_of, unwound
from planes.documents.graphs import known, over_cycle
from planes.geometry.arrays import Array
from planes.plans import Plans
from planes.plans.quantities import results_of
from planes.scene import Scene
from render.sheet.composer import Composer
from render.sheet.project import Project
from render.views.diagrams import DiagramCurve
from render.views.many import Numbered, PlacedMechanism

SECTIONS = 12
FINE = 360  # places of the driver for curves and paths
MARGIN = 0.04  # of a range that is not a whole turn, left out at each end
CLOSE = 0.04  # of a section: an extreme position no farther from a numbered one is that one

Rows = Mapping[str, Array]


def turned_once(scene: Scene, plans: Plans, composer: Composer, twelve: bool) -> Project:
    """A project with the driver moved through its range, on request with the numbered positions of the scheme."""
    found, motion = span_of(plans), TurningMechanism(plans)
    span = found if found.whole else found.inner(MARGIN)
    dead = dead_points(driven_grid(plans, span.start, span.end)) if span.whole or twelve else []
    if span.whole and dead:
        span = WorkingRange(dead[0], dead[0] + FULL, True)
    values = span.values(FINE)
    rows = motion.rows(values)
    turn = motion.places(rows)
    numbered = motion.numbered(span, turn, dead) if twelve else []
    asked, loops = over_cycle(scene, plans, values, composer.naming)
    return Project(composer, values, turn, numbered, span.whole, asked or motion.curves(rows), loops)


class TurningMechanism:
    """Places of points, and places and rates of links, at any values of the drive: all drawn at once."""

    def __init__(self, plans: Plans) -> None:
        self.plans = plans
        known = results_of(plans)
        self.quantities = [q for q in known if q.group in ("links", "slides") or (q.group, q.key) == ("points", "r")]

    @cached_property
    def cycle(self) -> Cycle:
        """The program cut down to that."""
        return Cycle(self.plans, columns=columns_of(self.plans, self.quantities))

    def rows(self, values: Sequence[float]) -> Rows:
        """Every column at each value of the drive, NaN where the mechanism does not work."""
        (block,) = self.cycle.blocks(list(values), fast=False)
        table = np.where(block.failed, np.nan, block.table)
        return {c.name: row for c, row in zip(self.cycle.columns, table, strict=True)}

    def places(self, rows: Rows) -> list[PlacedMechanism | None]:
        """Where everything is at each value, None where the mechanism does not work."""
        points = {p: (rows[f"r_{p}_x"] + 1j * rows[f"r_{p}_y"]).tolist() for p in self.plans.points}
        angles = {q.of: rows[q.name].tolist() for q in self.quantities if q.key == "angle_deg"}
        works = np.isfinite(sum(rows.values())).tolist()
        return [PlacedMechanism(_at(points, k), _at(angles, k)) if ok else None for k, ok in enumerate(works)]

    def curves(self, rows: Rows) -> tuple[DiagramCurve, ...]:
        """Place, from its least, and rates of the driven link."""
        slides, (place, rate, quick) = driven(self.plans)[1], output_curves(self.plans)
        at = curves_of(self.plans)[place].read(rows)
        at = at if slides else unwound(at)
        letters, units = ("sva", ("m", "m/s", "m/s²")) if slides else ("φωε", ("°", "rad/s", "rad/s²"))
        return tuple(map(DiagramCurve, letters, units, map(known, (at - np.fmin.reduce(at), rows[rate], rows[quick]))))

    def numbered(
        self, span: WorkingRange, turn: Sequence[PlacedMechanism | None], extreme: Sequence[float]
    ) -> list[Numbered]:
        """The numbered positions, and every extreme one, with a prime unless it is a numbered one."""
        section, every = (span.end - span.start) / SECTIONS, FINE // SECTIONS
        last = SECTIONS - 1 if span.whole else SECTIONS
        places = [(v - span.start) / section for v in extreme]
        near = {round(p) % (last + 1) for p in places if _close(p)} | {0, 0 if span.whole else SECTIONS}
        found = [Numbered(str(k), turn[k * every], k in near) for k in range(last + 1)]
        between = [(v, p) for v, p in zip(extreme, places, strict=True) if not _close(p)]
        primed = self.places(self.rows([v for v, _ in between])) if between else []
        return found + [Numbered(f"{int(p)}′", r, True) for (_, p), r in zip(between, primed, strict=True)]


def _at(rows: Rows, k: int) -> dict[str, float]:
    return {name: row[k] for name, row in rows.items()}


def _close(number: float) -> bool:
    return abs(number - round(number)) < CLOSE
