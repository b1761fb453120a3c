"""Forces and couples on a scheme: arrows at their points, curved arrows of couples, arms with their lines of action."""

from __future__ import annotations

import cmath
import math
from dataclasses import dataclass, field

from planes.drafting import Moments
from planes.naming import at
from planes.plans.bodies import SCHEME
from planes.solving import Position
from planes.steps.reckoning import Drop
from render import labels, symbols
from render.marks import Arrow, Line, Mark
from render.names import Naming
from render.views.places import Places

FORCE_MM = 15.0  # shortest arrow of a force; forces are not to scale
STEP_MM = 6.0  # by which the next one of the same point and direction is longer
COUPLE_MM = 6.5  # radius of a couple's curved arrow
NAME_MM = 3.5
NOTHING = 1e-9  # of the largest force: none


@dataclass
class Loading:
    """The forces on some links, being drawn over their scheme."""

    position: Position
    naming: Naming
    links: tuple[str, ...]
    marks: list[Mark] = field(default_factory=list)
    named: list[labels.Label] = field(default_factory=list)
    taken: list[tuple[complex, complex, float]] = field(default_factory=list)

    def __post_init__(self) -> None:
        self.places, self.drawing = Places(self.position), self.position.drawing

    def loads(self, carried: bool) -> None:
        """Weights, inertia, loads; and, where ``carried``, the reactions that came from groups solved before."""
        acting = self.position.plans.acting
        for link in self.links:
            for force in acting.forces[link]:
                if (force.spot or carried) and force.size in self.drawing and self.big(float(self.drawing[force.size])):
                    way = complex(self.drawing[force.along])
                    self.force(force.name, complex(self.drawing[force.point]), way * _sign(self.drawing[force.size]))
            for k, couple in enumerate(c for c in acting.couples[link] if not c.name.startswith("MR_")):
                value = float(self.drawing[couple.value]) * couple.sign if couple.value in self.drawing else 0.0
                if abs(value) > 1e-9:
                    self.couple(couple.name, link, value, k)

    def reactions(self, plan: str) -> None:
        """The reactions of a plan's outer pairs, in the parts the plan finds them in, at their points."""
        for name, way in self.parts(plan).items():
            base = name.partition("^")[0]
            found = next((r for k, r in self.position.plans.reactions.items() if base in (k, self.reversed(k))), None)
            if not found or abs(way) < 1e-6:
                continue
            if found.pair.kind == "R":
                point = self.places.at(found.pair.point)
            else:
                foot, along = self.places.foot(self.places.mechanism.links[found.pair.link])
                arm = float(self.drawing[found.arm]) if found.arm in self.drawing else 0.0
                arm = arm if math.isfinite(arm) and abs(arm) < 10 else 0.0
                point = foot + arm * along * self.position.scales[f"mu_{SCHEME}"]
            self.force(name, point, way / abs(way), from_outside=True)

    def balancing(self) -> None:
        """The balancing couple (or force) on the driver."""
        plans = self.position.plans
        if plans.balancing not in self.drawing:
            return
        if plans.mechanism.drive.kind == "s":
            foot, along = self.places.foot(plans.mechanism.links[plans.structure.driver])
            self.force(plans.balancing, foot, along * _sign(self.drawing[plans.balancing]))
        else:
            taken = len([c for c in plans.acting.couples[plans.structure.driver] if not c.name.startswith("MR_")])
            name = self.naming.balancing(True)
            self.couple(name, plans.structure.driver, float(self.drawing[plans.balancing]), taken, name)

    def parts(self, plan: str) -> dict[str, complex]:
        """Names and segments (mm) of the unknown forces of a plan, the inner ones left out."""
        found: dict[str, complex] = {}
        for equation in self.position.plans.equations:
            if equation.plan == plan:
                for term in equation.terms:
                    ends = (term.start, term.end) if term.sign > 0 else (term.end, term.start)
                    if term.name.startswith("F") and all(at(plan, e) in self.drawing for e in ends):
                        way = complex(self.drawing[at(plan, ends[1])]) - complex(self.drawing[at(plan, ends[0])])
                        if self.outer(term.name):
                            found.setdefault(term.name, way)
        return found

    def outer(self, name: str) -> bool:
        """Whether a force is a reaction on one of the links from a link outside, not carried from another plan."""
        index = name.partition("^")[0].removeprefix("F_")
        on, by = index.split("_", 1) if "_" in index else (index[:1], index[1:])
        known = {f.name for link in self.links for f in self.position.plans.acting.forces[link]}
        return on in self.links and by not in self.links and name not in known

    def reversed(self, key: str) -> str:
        """F_12 of F_21."""
        pair = self.position.plans.reactions[key].pair
        return f"F_{pair.other}{pair.link}" if len(pair.other) == len(pair.link) == 1 else f"F_{pair.other}_{pair.link}"

    def big(self, size: float) -> bool:
        """Whether a force is more than rounding noise."""
        sizes = [abs(float(self.drawing[f.size])) for fs in self.position.plans.acting.forces.values() for f in fs
                 if f.size in self.drawing]  # fmt: skip
        return abs(size) > NOTHING * max(sizes, default=0.0)

    def force(self, name: str, point: complex, way: complex, from_outside: bool = False) -> None:
        """An arrow from its point (a load), or with its head there (a reaction), longer where others point the same."""
        side = -way if from_outside else way
        like = [s for p, s, _ in self.taken if abs(p - point) < 0.5 and (s * side.conjugate()).real > 0.9]
        length = FORCE_MM + STEP_MM * len(like)
        self.taken.append((point, side, length))
        ends = (point + length * side, point) if from_outside else (point, point + length * side)
        if from_outside:
            ends = (ends[0], point + 1.6 * side)
        self.marks.append(Arrow(*ends, "thick", "force", name))
        far = ends[0] if from_outside else ends[1]
        self.named.append(labels.Label(self.naming.vector(name), (far, (far + point) / 2), NAME_MM, name=name))

    def couple(self, name: str, link: str, value: float, number: int, text: str = "") -> None:
        """A curved arrow about the mass centre of its link, or the middle of its bar."""
        body = self.places.mechanism.links[link]
        centre = self.places.at(body.mass_centre)
        radius, sense = COUPLE_MM + 3 * number, math.copysign(1.0, value)
        start = 100.0 if sense > 0 else 80.0
        self.marks += symbols.turn_arrow(centre, radius, start, sense * 150, "thick", "force")
        middle = centre + radius * cmath.rect(1, math.radians(start + sense * 75))
        self.named.append(labels.Label(text or self.naming.vector(name), middle, NAME_MM, clear=0.4, name=name))

    def arms(self, equations: list[Moments]) -> None:
        """Thin perpendiculars from the centre of moments to the lines of action, which are drawn out to meet them."""
        drops = {s.makes: s for s in self.drawing.program.steps if isinstance(s, Drop)}
        for equation in equations:
            for name, arm in equation.terms:
                step = drops.get(arm)
                if not step or step.makes not in self.drawing:
                    continue
                point, about = complex(self.drawing[step.point]), complex(self.drawing[step.about])
                along = complex(self.drawing[step.along])
                foot = point + ((about - point) * along.conjugate()).real * along
                if abs(foot - about) < 2:
                    continue
                self.marks.append(Line((point, foot), "construction", "construction"))
                self.marks.append(Line((about, foot), "thin", "dimension"))
                text = f"h_{{{''.join(c for c in self.naming.vector(name) if c not in '_^{}')}}}"
                self.named.append(labels.Label(text, (about, foot), NAME_MM, name=f"arm {name}"))


def _sign(value: object) -> float:
    return math.copysign(1.0, float(value))  # type: ignore[arg-type]
