"""What ``crank_slider:`` of a scene gives: the diagram, the law of rotation, and the sizes of the parts."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from planes.crank_slider.indicator import Indicator
from planes.crank_slider.parts import Material, Round, Shank, Web
from planes.crank_slider.shape import CrankSliderShape


@dataclass(frozen=True)
class Speed:
    """ω(φ) = ω₁[1 + δ/2·sin(n(φ − φ₀))], n waves a turn; δ = 0: steady."""

    unevenness: float = 0.0
    waves: float = 1.0
    phase_deg: float = 0.0


@dataclass(frozen=True)
class Shaft:
    """The crankshaft on bearings A and B: distances along it, sections, rotating masses (kg, m)."""

    span: float
    pin_from_b: float
    webs: float
    journal: Round
    crankpin: Round
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


@dataclass(frozen=True)
class Counterweights:
    """Radius of both counterweights, their masses if they are chosen, and the part of the translating mass balanced."""

    radius: float
    masses: tuple[float, float] | None = None
    translating: float = 0.5


@dataclass(frozen=True)
class PistonPin:
    """The piston pin: its section, whole length, length of the rod's bush, gap between the bosses."""

    section: Round
    length: float
    bush: float
    gap: float


@dataclass(frozen=True)
class Concentration:
    """k_σ, k_τ of a stress raiser and the size factors ε_σ, ε_τ."""

    k_sigma: float
    k_tau: float
    size_sigma: float
    size_tau: float


@dataclass(frozen=True)
class Limits:
    """Factors a part must reach: against yield, against fatigue from–to, against buckling; pressure on the pin, MPa."""

    static: float = 2.0
    fatigue: tuple[float, float] = (1.5, 3.0)
    buckling: float = 3.0
    bush_mpa: float = 60.0
    boss_mpa: float = 50.0


@dataclass(frozen=True)
class Given:
    """All that the calculation starts from. A part that is None has not been given, its chapter is left out."""

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
