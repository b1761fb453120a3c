"""Shear and bending moment along a straight beam: from the string polygon at its points, and from the distributed loads
between them."""

from itertools import pairwise

from planes.geometry.plane import direction_between
from planes.plans.structures.figure import StaticsFigure
from planes.scene.structures import StaticLoad
from planes.solving import Position
from planes.words.frozen import frozen
from planes.words.names import SCHEME_PLAN, NumbersByName, scheme_mark

POINTS_UNDER_DISTRIBUTED_LOAD = 16  # points of a curve under a distributed load
Outline = list[tuple[float, float]]  # m along the beam, N or N·m


@frozen
class BeamOutlines:
    """Points along the beam with their distances, m, and both outlines from the first point to the last."""

    stops: NumbersByName
    shears: Outline
    moments: Outline


def beam_outlines(position: Position) -> BeamOutlines | None:
    """Both diagrams of a straight beam; None where there is none."""
    figure = position.plans.figure
    beam = _Beam(position, figure) if figure and figure.moments else None
    if beam and beam.covers_known_intervals:
        return beam.draw_outlines()
    return None


class _Beam:
    """The beam by the distances of its points."""

    def __init__(self, position: Position, figure: StaticsFigure) -> None:
        self.position = position
        self.figure = figure
        ends = [p for p, _ in figure.moments] + [p for x in figure.spread for p in x.spread or ()]
        ends += [p for *two, _ in figure.shears for p in two]
        places = {p: complex(position.drawing[scheme_mark(p)]) / position.scales[SCHEME_PLAN.mu_name] for p in ends}
        first, last = (pick(places.values(), key=lambda z: (z.real, z.imag)) for pick in (min, max))
        self.way = way = direction_between(first, last)
        stops = {p: ((z - first) * way.conjugate()).real for p, z in places.items()}
        self.stops = dict(sorted(stops.items(), key=lambda one: one[1]))

    @property
    def covers_known_intervals(self) -> bool:
        """Whether every distributed load covers each interval between known moments wholly or not at all."""
        known = sorted(self.stops[p] for p, _ in self.figure.moments)
        ends = [sorted(self.stops[p] for p in x.spread or ()) for x in self.figure.spread]
        return all((low <= a and b <= high) or b <= low or high <= a for low, high in ends for a, b in pairwise(known))

    def value_of_name(self, name: str) -> float:
        """A value as found."""
        return float(self.position.drawing[name])

    def draw_outlines(self) -> BeamOutlines:
        """Both diagrams."""
        level = {
            tuple(sorted(two, key=self.stops.__getitem__)): self.value_of_name(name)
            for *two, name in self.figure.shears
        }
        moments = {p: self.value_of_name(name) for p, name in self.figure.moments}
        shears = [(0.0, 0.0)]
        bent = Outline()
        known = [p for p in self.stops if p in moments]
        for one, other in pairwise(known):
            start = self.stops[one]
            end = self.stops[other]
            long = end - start
            loads = [x for x in self.figure.spread if x.spread and self.load_covers_interval(x, start, end)]
            for k in range(POINTS_UNDER_DISTRIBUTED_LOAD + 1) if loads else (0, POINTS_UNDER_DISTRIBUTED_LOAD):
                t = k / POINTS_UNDER_DISTRIBUTED_LOAD
                sag, slope = (
                    sum(way(x, start, end, t) for x in loads)
                    for way in (self.moment_above_chord, self.shear_above_chord)
                )
                chord = (moments[other] - moments[one]) / long
                bent.append((start + t * long, moments[one] + t * long * chord + sag))
                shears.append((start + t * long, level.get((one, other), chord) + slope))
        return BeamOutlines(self.stops, [*shears, (max(self.stops.values()), 0.0)], bent)

    def load_covers_interval(self, load: StaticLoad, start: float, end: float) -> bool:
        """Whether a distributed load lies between two places."""
        assert load.spread
        low, high = sorted(self.stops[p] for p in load.spread)
        return low <= (start + end) / 2 <= high

    def load_intensities(self, load: StaticLoad, start: float, end: float) -> tuple[float, float]:
        """The intensities at two places, N/m, downwards positive."""
        assert load.spread
        one, other = (self.stops[p] for p in load.spread)
        first, last = map(abs, load.intensity)
        up = 1.0 if load.constant_direction_deg % 360.0 < 180.0 else -1.0
        first, last = (-up * (first + (x - one) / (other - one) * (last - first)) for x in (start, end))
        return first, last

    def moment_above_chord(self, load: StaticLoad, start: float, end: float, t: float) -> float:
        """The excess of the moment over the chord."""
        first, last = self.load_intensities(load, start, end)
        return (end - start) ** 2 / 6 * t * (1 - t) * (first * (2 - t) + last * (1 + t))

    def shear_above_chord(self, load: StaticLoad, start: float, end: float, t: float) -> float:
        """The excess of the shear over that of the chord: the derivative of the former."""
        first, last = self.load_intensities(load, start, end)
        rise = first * (2 - 6 * t + 3 * t * t) + last * (1 - 3 * t * t)
        return (end - start) / 6 * rise
