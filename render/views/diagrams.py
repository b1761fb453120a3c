"""Diagrams of the driven link against the driver's angle: displacement, velocity (or ω), acceleration (or ε)."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from planes.mechanism import FRAME
from planes.plans import Plans
from planes.units import standard_mu
from render.marks import Arrow, Line, Mark, Text
from render.names import Naming
from render.words import decimal, number, say

SECTION_MM = 11.0  # of 30 degrees on the axis of φ
TALL_MM = 24.0  # the largest ordinate
BETWEEN_MM = 12.0
FULL = 360.0


@dataclass(frozen=True)
class Curve:
    """One quantity over the turn: its letter, its unit, and a value or None for every angle."""

    letter: str
    unit: str
    values: tuple[float | None, ...]


def driven(plans: Plans) -> tuple[str, bool]:
    """The link that a mechanism drives, and whether it slides on the frame: the last group's."""
    m, group = plans.mechanism, plans.structure.groups[-1]
    for name in (group.last, group.first):
        slides = m.links[name].slides
        if slides and m.owner(slides.guide) == FRAME:
            return name, True
    on_frame = [p for p in plans.structure.pairs if p.joins(FRAME)]
    grounded = [n for n in (group.last, group.first) if any(p.joins(n) for p in on_frame)]
    return (grounded or [group.last])[0], False


def curves(plans: Plans, results: Sequence[dict[str, Any] | None]) -> tuple[Curve, Curve, Curve]:
    """The three curves of the driven link; its place counts from its least."""
    link, slides = driven(plans)
    if not slides:
        angle, omega, epsilon = (read(results, "links", link, k) for k in ("angle_deg", "omega", "epsilon"))
        return Curve("φ", "°", unwound(angle)), Curve("ω", "rad/s", omega), Curve("ε", "rad/s²", epsilon)
    guide = plans.mechanism.guide(plans.mechanism.links[link].slides.guide)  # type: ignore[union-attr]
    along = complex(math.cos(math.radians(guide.angle_deg)), math.sin(math.radians(guide.angle_deg)))
    point = plans.mechanism.links[link].first_point
    places = [None if r is None else (complex(*r["points"][point]["r"]) * along.conjugate()).real for r in results]
    least = min((p for p in places if p is not None), default=0.0)
    shifted = tuple(None if p is None else p - least for p in places)
    v, a = (read(results, "slides", link, k) for k in ("v", "a"))
    return Curve("s", "m", shifted), Curve("v", "m/s", v), Curve("a", "m/s²", a)


def read(results: Sequence[dict[str, Any] | None], kind: str, link: str, key: str) -> tuple[float | None, ...]:
    """One quantity of a link in every position."""
    return tuple(None if r is None else float(r[kind][link][key]) for r in results)


def unwound(angles: Sequence[float | None]) -> tuple[float | None, ...]:
    """Angles without jumps of a full turn, counted from their least."""
    found: list[float | None] = []
    last: float | None = None
    for angle in angles:
        if angle is not None and last is not None:
            angle -= FULL * round((angle - last) / FULL)
        found.append(angle)
        last = angle if angle is not None else last
    least = min((a for a in found if a is not None), default=0.0)
    return tuple(None if a is None else a - least for a in found)


@dataclass(frozen=True)
class Diagrams:
    """Three diagrams one beneath the other over one axis of the driver's angle."""

    plans: Plans
    angles: Sequence[float]
    results: Sequence[dict[str, Any] | None]
    naming: Naming

    @property
    def title(self) -> str:
        """What they show."""
        link, slides = driven(self.plans)
        key = "diagrams_slider" if slides else "diagrams_link"
        return say(key, self.naming.lang, link=self.naming.link(link))

    def drawn(self) -> tuple[Mark, ...]:
        """Axes, curves, numbers of positions and scales."""
        marks: list[Mark] = []
        zero, lowest = 0.0, 0.0
        for curve in curves(self.plans, self.results):
            known = [v for v in curve.values if v is not None]
            mu = standard_mu(max(map(abs, known), default=0.0), TALL_MM)
            top, bottom = mu * max([0.0, *known]), mu * min([0.0, *known])
            zero = (lowest - BETWEEN_MM - 7.0 - top) if marks else 0.0
            marks += self.sections(zero + bottom - 1.5, zero + top + 1.5)
            marks += self.one(curve, mu, zero, top)
            lowest = zero + bottom
        return (*marks, *self.numbers(lowest - 6.5))

    def one(self, curve: Curve, mu: float, zero: float, top: float) -> list[Mark]:
        """One curve on its axes, its zero line at the height ``zero``."""
        wide = SECTION_MM * 12
        marks: list[Mark] = [
            Arrow(complex(0, zero), complex(wide + 9, zero), "thin", "dimension"),
            Arrow(complex(0, zero), complex(0, zero + top + 8), "thin", "dimension"),
            Text("φ", complex(wide + 10.5, zero - 1), 3.5),
        ]
        n, lang = self.naming, self.naming.lang
        link = n.link(driven(self.plans)[0])
        unit = "°" if curve.unit == "°" else say(curve.unit, lang)
        per = f"({unit})" if "/" in unit else unit
        name = f"{curve.letter}_{{{link}}}, μ_{{{curve.letter}}} = {decimal(f'{mu:g}', lang)} {say('mm', lang)}/{per}"
        marks.append(Text(name, complex(2.5, zero + top + 5), 3.5))
        for piece in pieces(self.angles, curve.values):
            points = tuple(complex(self.x(a), zero + mu * v) for a, v in piece)
            marks.append(Line(points, "thick", "plan"))
        return marks

    def x(self, angle: float) -> float:
        """The place of an angle on the axis, from the first one."""
        return (angle - self.angles[0]) / 30 * SECTION_MM

    def sections(self, low: float, high: float) -> list[Mark]:
        """Thin verticals every 30 degrees."""
        places = [SECTION_MM * k for k in range(1, 13)]
        return [Line((complex(x, low), complex(x, high)), "construction", "construction") for x in places]

    def numbers(self, level: float) -> list[Mark]:
        """Numbers of the positions beneath, and the angle of the first."""
        found: list[Mark] = [Text(str(k), complex(SECTION_MM * k, level), 3.5, "middle") for k in range(13)]
        start = f"φ_{{0}} = {number(self.angles[0] % FULL, self.naming.lang)}°"
        return [*found, Text(start, complex(SECTION_MM * 12 + 6, level), 3.5)]


def pieces(angles: Sequence[float], values: Sequence[float | None]) -> list[list[tuple[float, float]]]:
    """Runs of angles at which the mechanism works."""
    found: list[list[tuple[float, float]]] = [[]]
    for angle, value in zip(angles, values, strict=True):
        if value is None:
            found.append([])
        else:
            found[-1].append((angle, value))
    return [piece for piece in found if len(piece) > 1]


def extreme(plans: Plans, angles: Sequence[float], results: Sequence[dict[str, Any] | None]) -> float:
    """The driver's angle at which the driven link stands in an extreme position: its rate changes sign there."""
    rate = curves(plans, results)[1].values
    for (a, u), (b, v) in pairwise(zip(angles, rate, strict=True)):
        if u is not None and v is not None and (u < 0 <= v or u > 0 >= v):
            return a + (b - a) * u / (u - v)
    return angles[0]
