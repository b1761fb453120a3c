"""The mechanism turned through its cycle: the one batch program, run with the drive's motion and with a unit drive."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from functools import cached_property
from typing import Any

import numpy as np

from planes.cycle import CHUNK, Block, Cycle, Reason
from planes.cycle.columns import columns_of
from planes.diagrams.curves import UNIT, Arrow, Curve, arrows_of, curves_of
from planes.plans import Plans
from planes.wording import PlanesError, choices
from planes.words import Phrase
from planes.working import FULL


class Turn:
    """Curves and vectors of a mechanism, ready to be read at any places of its driver (degrees, or metres)."""

    def __init__(self, plans: Plans, curves: Sequence[Curve], arrows: Sequence[Arrow] = ()) -> None:
        self.plans, self.curves, self.arrows = plans, tuple(curves), tuple(arrows)
        needs = [n for c in curves for n in (*c.needs, *c.slope_needs)] + [n for a in arrows for n in a.needs]
        self.needs = tuple(dict.fromkeys(needs))

    @cached_property
    def cycles(self) -> tuple[tuple[str, Cycle], ...]:
        """The runs there are, each with the prefix of its columns: the drive's own motion, and the unit drive's."""
        columns = {c.name: c for c in columns_of(self.plans)}
        unit = unit_drive(self.plans)
        own = [columns[n] for n in self.needs if not n.startswith(UNIT)]
        one = [columns[n.removeprefix(UNIT)] for n in self.needs if n.startswith(UNIT)]
        runs = []
        if own:
            runs.append(("", Cycle(self.plans, columns=own)))
        if one:
            runs.append((UNIT, Cycle(self.plans, known=unit, columns=one)))
        return tuple(runs)

    @property
    def reasons(self) -> tuple[Reason, ...]:
        """What each code of a block means, of both runs: code k is the reason k - 1."""
        return tuple(r for _, c in self.cycles for r in c.reasons)

    def sample(self, values: Any) -> dict[str, Any]:
        """Every column needed, at every value; NaN where it cannot be drawn."""
        return self._run(np.asarray(values, float))[0]

    def _run(self, values: Any) -> tuple[dict[str, Any], Any]:
        found: dict[str, Any] = {}
        codes, past = np.zeros(len(values), np.int16), 0
        for prefix, run in self.cycles:
            blocks = list(run.blocks(values, fast=False))
            table = np.hstack([b.table for b in blocks])
            mine = np.hstack([b.codes for b in blocks])
            codes = np.where((codes == 0) & (mine != 0), mine + past, codes)
            past += len(run.reasons)
            found |= {prefix + c.name: row for c, row in zip(run.columns, table, strict=True)}
        return found, codes

    def blocks(self, values: Any, chunk: int = CHUNK) -> Iterator[Block]:
        """The curves (one row each) of successive positions, in blocks: what a long table is written from."""
        for start in range(0, len(values), chunk):
            part = np.asarray(values[start : start + chunk], float)
            found, codes = self._run(part)
            yield Block(part, np.array([c.read(found) + np.zeros(len(part)) for c in self.curves]), codes)


def unit_drive(plans: Plans) -> dict[str, float]:
    """The givens of a drive with ω₁ = 1 and ε₁ = 0 (or v = 1 and a = 0): velocities are then analogues, dr/dφ₁."""
    drive = plans.mechanism.drive
    if drive.kind == "s":
        return {"v_drive": 1.0, "a_drive": 0.0}
    return {plans.links[drive.link].omega: 1.0, plans.links[drive.link].epsilon: 0.0}


def turn_of(plans: Plans, names: Iterable[str] | None = None, arrows: Iterable[str] = (), file: str = "") -> Turn:
    """A turn with the curves and vectors of those names (None: every curve)."""
    known, vectors = curves_of(plans), arrows_of(plans)
    chosen = known.values() if names is None else [_named(n, known, file) for n in names]
    return Turn(plans, list(dict.fromkeys(chosen)), [_named(n, vectors, file) for n in arrows])


def _named(name: str, known: dict[str, Any], file: str) -> Any:
    if name not in known:
        raise PlanesError(Phrase("no_curve", name=name, file=file, valid=choices(name, known)))
    return known[name]


def unwound(angles: Any, period: float = FULL) -> Any:
    """Angles without jumps of a full turn, most of them as they were told; NaN stays, and what follows it goes on from
    the last angle before."""
    told = np.array(angles, float)
    found, good = told.copy(), np.flatnonzero(np.isfinite(told))
    if len(good):
        found[good] = np.unwrap(told[good], period=period)
        found -= period * np.round(np.median((found - told)[good]) / period)
    return found
