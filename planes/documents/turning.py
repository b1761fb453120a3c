"""The driver moved once through its range from an extreme position of the driven link: results for sheet 1."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from typing import Any

from planes.batch import Cycle
from planes.batch.columns import columns_of
from planes.diagrams.motion import dead_points, driven_grid
from planes.diagrams.turn import span_of
from planes.diagrams.working import FULL, Span
from planes.documents.graphs import over_cycle
from planes.plans import Plans
from planes.plans.measuring import catalogue
from planes.scene import Scene
from render.sheet.composer import Composer
from render.sheet.project import Project
from render.views.many import Numbered

SECTIONS = 12
FINE = 360  # places of the driver for curves and paths
MARGIN = 0.04  # of a range that is not a whole turn, left out at each end
CLOSE = 0.04  # of a section: an extreme position no farther from a numbered one is that one

Result = dict[str, Any] | None


def turned_once(scene: Scene, plans: Plans, composer: Composer, twelve: bool) -> Project:
    """A project with the driver moved through its range, on request with the numbered positions of the scheme."""
    found, motion = span_of(plans), Motion(plans)
    span = found if found.whole else found.inner(MARGIN)
    dead = dead_points(driven_grid(plans, span.start, span.end)) if span.whole or twelve else []
    if span.whole and dead:
        span = Span(dead[0], dead[0] + FULL, True)
    values = span.values(FINE)
    turn = motion.results(values)
    numbered = motion.numbered(span, turn, dead) if twelve else []
    asked = over_cycle(scene, plans, values, composer.naming)
    return Project(composer, values, turn, numbered, span.whole, *asked)


class Motion:
    """Places of points, and places and rates of links, at any values of the drive: all drawn at once."""

    def __init__(self, plans: Plans) -> None:
        self.plans = plans
        known = catalogue(plans).values()
        self.quantities = [q for q in known if q.path[0] in ("links", "slides") or q.path[::2] == ("points", "r")]

    @cached_property
    def cycle(self) -> Cycle:
        """The program cut down to that."""
        return Cycle(self.plans, columns=columns_of(self.plans, self.quantities))

    def results(self, values: Sequence[float]) -> list[Result]:
        """Results at each value of the drive as a position has them, None where the mechanism does not work."""
        (block,) = self.cycle.blocks(list(values), fast=False)
        rows = {c.name: row for c, row in zip(self.cycle.columns, block.table.tolist(), strict=True)}
        return [None if code else self._result(rows, k) for k, code in enumerate(block.codes.tolist())]

    def _result(self, rows: dict[str, list[float]], k: int) -> dict[str, Any]:
        found: dict[str, Any] = {"points": {}, "links": {}, "slides": {}}
        for q in self.quantities:
            kind, thing, key = q.path
            value = rows[q.name][k] if q.name in rows else [rows[f"{q.name}_x"][k], rows[f"{q.name}_y"][k]]
            found[kind].setdefault(thing, {})[key] = value
        return found

    def numbered(self, span: Span, turn: Sequence[Result], extreme: Sequence[float]) -> list[Numbered]:
        """The numbered positions, and every extreme one, with a prime unless it is a numbered one."""
        section, every = (span.end - span.start) / SECTIONS, FINE // SECTIONS
        last = SECTIONS - 1 if span.whole else SECTIONS
        places = [(v - span.start) / section for v in extreme]
        near = {round(p) % (last + 1) for p in places if _close(p)} | {0, 0 if span.whole else SECTIONS}
        found = [Numbered(str(k), turn[k * every], k in near) for k in range(last + 1)]
        between = [(v, p) for v, p in zip(extreme, places, strict=True) if not _close(p)]
        primed = self.results([v for v, _ in between]) if between else []
        return found + [Numbered(f"{int(p)}′", r, True) for (_, p), r in zip(between, primed, strict=True)]


def _close(number: float) -> bool:
    return abs(number - round(number)) < CLOSE
