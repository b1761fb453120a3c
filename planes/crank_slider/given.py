"""The data under ``crank_slider:`` of a scene: the indicator diagram, the law of rotation, and the dimensions of the
parts.

The diagram is the pressure over the cycle from tables of its stages, by monotone interpolation. Between two points the
curve never leaves their pressures (Fritsch and Carlson's cubic with harmonic slopes), so no pressure is outside the
bounds of the table.
"""

from collections.abc import Callable, Mapping

import numpy as np

from planes.crank_slider.parts import Material, RoundPart, Shank, Web
from planes.crank_slider.shape import CrankSliderShape
from planes.geometry.arrays import Array, Indices
from planes.scene.ranges import Interval
from planes.words.frozen import field, frozen
from planes.words.names import NameTuple

FOUR_STROKE_STAGES = ("intake", "compression", "expansion", "exhaust")
TWO_STROKE_STAGES = ("compression", "expansion")
PASCALS_BY_UNIT = {"Pa": 1.0, "kPa": 1e3, "MPa": 1e6, "bar": 1e5}
PISTON_AWAY_STAGES = ("intake", "expansion")  # the stages in which the piston moves away from its top dead centre

Points = tuple[tuple[float, float], ...]


@frozen
class Indicator:
    """``over`` "path": [part of the stroke from top dead centre, p]; "angle": [degrees from the cycle's start, p]."""

    over: str
    unit: str
    stages: Mapping[str, Points]

    @property
    def names(self) -> NameTuple:
        """The stages in the order of the cycle."""
        if "intake" in self.stages:
            return FOUR_STROKE_STAGES
        return TWO_STROKE_STAGES

    @property
    def cycle_deg(self) -> float:
        """The crank's turn in one cycle: 720° or 360°."""
        return 180.0 * len(self.names)

    @property
    def start_deg(self) -> float:
        """The crank angle at the beginning of the cycle: top dead centre is 0°; two-stroke cycles begin at the
        bottom."""
        return 0.0 if "intake" in self.stages else 180.0

    def pressure(self, turned_deg: Array, path: Array) -> Array:
        """Absolute pressure, Pa, ``turned_deg`` after the cycle's start, where the piston has gone ``path`` of S."""
        turned = np.asarray(turned_deg, float)
        pressure = np.zeros(np.shape(turned_deg))
        for k, name in enumerate(self.names):
            inside = (turned >= 180.0 * k) & (turned <= 180.0 * (k + 1))
            at = np.asarray(path)[inside] if self.over == "path" else turned[inside]
            pressure[inside] = self.curve(name)(at) * PASCALS_BY_UNIT[self.unit]
        return pressure

    def curve(self, stage: str) -> Callable[[Array], Array]:
        """The pressure of one stage in the table's unit over its own variable."""
        points = sorted(self.stages[stage])
        return monotone_cubic([x for x, _ in points], [p for _, p in points])


def required_stage_span(stage: str, over: str, names: NameTuple) -> Interval:
    """The required beginning and end of a stage's table."""
    if over == "path":
        return (0.0, 1.0) if stage in PISTON_AWAY_STAGES else (1.0, 0.0)
    k = names.index(stage)
    return 180.0 * k, 180.0 * (k + 1)


def monotone_cubic(x: list[float], y: list[float]) -> Callable[[Array], Array]:
    """The cubic through the points without overshoot between them."""
    xs, ys = np.array(x, float), np.array(y, float)
    h, d = np.diff(xs), np.diff(ys) / np.diff(xs)
    slopes = _monotone_slopes(h, d)

    def value(at: Array) -> Array:
        at = np.clip(at, xs[0], xs[-1])
        k: Indices = np.clip(np.searchsorted(xs, at, side="right") - 1, 0, len(h) - 1)
        t = (at - xs[k]) / h[k]
        one = h[k]
        rise = t * t * (3.0 - 2.0 * t)
        bend = t * (1.0 - t) ** 2 * slopes[k] - t * t * (1.0 - t) * slopes[k + 1]
        values: Array = ys[k] + rise * (ys[k + 1] - ys[k]) + one * bend
        return values

    return value


def _monotone_slopes(h: Array, d: Array) -> Array:
    if len(d) == 1:
        return np.array([d[0], d[0]])
    inner = np.zeros(len(d) - 1)
    same = d[:-1] * d[1:] > 0.0
    w1 = 2.0 * h[1:] + h[:-1]
    w2 = h[1:] + 2.0 * h[:-1]
    inner[same] = ((w1 + w2)[same]) / (w1[same] / d[:-1][same] + w2[same] / d[1:][same])
    return np.array([_end_slope(h[0], h[1], d[0], d[1]), *inner, _end_slope(h[-1], h[-2], d[-1], d[-2])])


def _end_slope(h0: float, h1: float, d0: float, d1: float) -> float:
    slope = ((2.0 * h0 + h1) * d0 - h0 * d1) / (h0 + h1)
    if slope * d0 <= 0.0:
        return 0.0
    return 3.0 * d0 if d0 * d1 <= 0.0 and abs(slope) > 3.0 * abs(d0) else slope


@frozen
class Speed:
    """ω(φ) = ω₁[1 + δ/2·sin(n(φ − φ₀))], n waves a turn; δ = 0: steady."""

    unevenness: float = 0.0
    waves: float = 1.0
    phase_deg: float = 0.0


@frozen
class Shaft:
    """The crankshaft on bearings A and B: distances along it, sections, rotating masses (kg, m)."""

    span: float
    pin_from_b: float
    webs: float
    journal: RoundPart
    crankpin: RoundPart
    web: Web
    pin_mass: float
    web_mass: float
    web_radius: float

    @property
    def left(self) -> float:
        """a: from the plane of the crank to the left counterweight."""
        return self.span - self.pin_from_b - self.webs

    @property
    def right(self) -> float:
        """b: from the plane of the crank to the right counterweight."""
        return self.pin_from_b - self.webs

    def static_moment(self, radius: float) -> float:
        """Of the rotating masses, kg·m; ``radius`` is the crankpin's."""
        return self.pin_mass * radius + self.web_mass * self.web_radius


@frozen
class Counterweights:
    """Radius of both counterweights, their masses if they are chosen, and the balanced part of the translating mass."""

    radius: float
    masses: tuple[float, float] | None = None
    translating: float = 0.5


@frozen
class PistonPin:
    """The piston pin: its section, whole length, length of the rod's bush, gap between the bosses."""

    section: RoundPart
    length: float
    bush: float
    gap: float


@frozen
class Concentration:
    """k_σ, k_τ of a stress raiser and the size factors ε_σ, ε_τ."""

    k_sigma: float
    k_tau: float
    size_sigma: float
    size_tau: float


@frozen
class Limits:
    """Required factors of a part: against yield, against fatigue from–to, against buckling; pressure on the pin,
    MPa."""

    static: float = 2.0
    fatigue: Interval = (1.5, 3.0)
    buckling: float = 3.0
    bush_mpa: float = 60.0
    boss_mpa: float = 50.0


@frozen
class Given:
    """All input of the calculation. A part that is None was not given; its chapter is left out."""

    shape: CrankSliderShape
    bore: float
    ambient: float
    indicator: Indicator
    step_deg: float
    speed: Speed
    allowed_unevenness: float
    positions: tuple[float, ...]
    shaft: Shaft | None = None
    counterweights: Counterweights | None = None
    rod: Shank | None = None
    pin: PistonPin | None = None
    materials: Mapping[str, Material] = field(default_factory=dict)
    concentration: Mapping[str, Concentration] = field(default_factory=dict)
    limits: Limits = Limits()
