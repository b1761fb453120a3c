"""What a graphical construction gave, beside the exact values: a table for the terminal, with its scales and errors."""

from __future__ import annotations

import math
from dataclasses import dataclass

from planes.diagrams.graphical import Construction
from planes.diagrams.stages import Stage
from planes.drafting.drawing import Drawing
from planes.drafting.instruments import Exact, Pencil
from planes.solving.tables import table
from planes.words import Lang, say
from planes.words.records import Json
from planes.words.units import RATES, quantity

PENCILS = 400
LETTERS = {True: ("s", "v", "a"), False: ("φ", "ω", "ε")}


@dataclass(frozen=True)
class MeasuredDiagram:
    """One diagram as measured: at every point what was found, the exact value, and a pencil's standard deviation."""

    stage: Stage
    found: list[float]
    exact: list[float]
    pencil: list[float]

    @property
    def worst(self) -> float:
        """The largest error of the method itself, as a part of the largest exact value."""
        size = max(map(abs, self.exact)) or 1.0
        return max(abs(f - e) for f, e in zip(self.found, self.exact, strict=True)) / size


def readings(c: Construction, pencil: Pencil | None = None) -> list[MeasuredDiagram]:
    """Every diagram of a construction: drawn without an error of hand, and by many draughtsmen."""
    import numpy

    drawing: Drawing = c.drawn(Exact())
    crowd = c.drawn(pencil or Pencil(), {"mu_paper": numpy.ones(PENCILS)})
    found = []
    for stage in c.stages:
        spread = [float(numpy.std(v)) if numpy.ndim(v) else 0.0 for v in c.measured(crowd, stage)]
        found.append(MeasuredDiagram(stage, [float(v) for v in c.measured(drawing, stage)], c.exact(stage), spread))
    return found


def scales(c: Construction, lang: Lang) -> list[str]:
    """The scales of the diagrams, each with the formula it follows from; μ in mm per unit."""
    letters, units, mm = LETTERS[c.motion.slides], RATES[c.motion.slides], say("mm", lang)
    lines = [f"μ_t = {quantity(c.mu_t)} {mm}/{say('s', lang)}"]
    previous: Stage | None = None
    for stage in c.stages:
        letter, unit = letters[stage.rank], say(units[stage.rank], lang)
        text = f"μ_{letter} = "
        if previous:
            other = letters[previous.rank]
            text += f"H·μ_{other}/μ_t = " if c.kind == "differentiation" else f"μ_{other}·μ_t/H = "
        text += f"{quantity(stage.mu)} {mm}/{'(' + unit + ')' if '/' in unit else unit}"
        pole = stage if c.kind == "differentiation" else previous
        if previous and pole and pole.pole_mm:
            text += f", H = {quantity(pole.pole_mm)} {mm}"
        lines.append(text)
        previous = stage
    return lines


def as_json(constructions: list[Construction]) -> Json:
    """The constructions as plain things: scales, poles, and every point with what was found and what is exact, SI."""
    return {
        "planes": 1,
        "constructions": [
            {
                "kind": c.kind,
                "link": c.motion.link,
                "mu_t": c.mu_t,
                "diagrams": [
                    {
                        "quantity": LETTERS[c.motion.slides][r.stage.rank],
                        "unit": RATES[c.motion.slides][r.stage.rank],
                        "mu": r.stage.mu,
                        "pole_mm": r.stage.pole_mm,
                        "given": r.stage.given,
                        "points": [
                            {
                                "point": label,
                                "phi_deg": _angle(c, half),
                                "found": found,
                                "exact": exact,
                                "pencil": spread,
                            }
                            for (half, label), found, exact, spread in zip(
                                r.stage.points, r.found, r.exact, r.pencil, strict=True
                            )
                            if half >= 0
                        ],
                    }
                    for r in readings(c)
                ],
            }
            for c in constructions
        ],
    }


def report(constructions: list[Construction], lang: Lang) -> str:
    """Tables of the constructions, one after the other."""
    lines: list[str] = []
    for c in constructions:
        lines += ["", say(f"graphical_{c.kind}", lang, link=c.motion.link, count=c.motion.sections)]
        lines += [f"  {line}" for line in scales(c, lang)]
        for reading in readings(c):
            if not reading.stage.given:
                lines += _reading(c, reading, lang)
    return "\n".join(lines[1:]) + "\n"


def _reading(c: Construction, r: MeasuredDiagram, lang: Lang) -> list[str]:
    rank, slides = r.stage.rank, c.motion.slides
    unit = say(RATES[slides][rank], lang)
    head = [
        say("graphical_point", lang),
        "φ1, °",
        say("graphical_found", lang),
        say("graphical_exact", lang),
        "Δ, %",
        say("graphical_pencil", lang),
    ]
    size = max(map(abs, r.exact)) or 1.0
    rows = []
    for (half, label), found, exact, spread in zip(r.stage.points, r.found, r.exact, r.pencil, strict=True):
        if half < 0:
            continue  # the last middle over again
        cells: list[float] = [0.0 if abs(x) < 1e-12 * size else x for x in (found, exact)]
        rows.append(
            [
                label,
                quantity(_angle(c, half), "", 5),
                *map(quantity, cells),
                f"{100 * (found - exact) / size:.2f}",
                f"{100 * spread / size:.2f}",
            ]
        )
    title = f"{LETTERS[slides][rank]}{c.motion.link}, {unit}"
    lines = table(title, head, rows)
    return [*lines, "  " + say("graphical_worst", lang, error=f"{100 * r.worst:.2f}")]


def _angle(c: Construction, half: int) -> float:
    """The driver's angle at a point, within one turn."""
    a, b = c.motion.angles[:2]
    return math.fmod(a + (b - a) * half / 2, 360.0) % 360.0
