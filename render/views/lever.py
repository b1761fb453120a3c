"""Zhukovsky's lever: the velocity plan turned by a right angle, with the outer forces at the images of their points."""

from __future__ import annotations

from dataclasses import dataclass

from planes.drafting.steps.reckoning import Drop
from planes.solving import Position
from planes.words.lettering import Naming
from planes.words.names import POLE, at
from render import labels
from render.paper.marks import Arrow, Line, Mark
from render.paper.symbols import dot
from render.views.loading import Arms
from render.views.plotted import of_position
from render.views.polygon import ZERO_MM, gathered
from render.views.senses import parted, yielding

FORCE_MM = 14.0
STEP_MM = 6.0


@dataclass
class Lever:
    """The lever of one position; a driver at rest has the plan of a unit drive turned instead."""

    position: Position
    naming: Naming

    def drawn(self) -> tuple[Mark, ...]:
        """The turned plan, the forces, their arms and all names."""
        plan = "motion" if self.position.plans.at_rest else "velocity"
        plotted = of_position(self.position)
        marks: list[Mark] = []
        for s in self.position.plans.segments:
            if s.plan == plan and s.start != s.end and plotted.has(plan, s.start, s.end):
                ends = 1j * plotted.mark(plan, s.start), 1j * plotted.mark(plan, s.end)
                if abs(ends[1] - ends[0]) > ZERO_MM:
                    marks.append(Line(ends, "thick" if s.start == POLE else "thin", "plan"))
        named = self.letters([(label, 1j * plotted.mark(plan, label)) for label in plotted.labels(plan)])
        marks += dot(0j, 0.8, "plan")
        forces, names = self.forces()
        thin, rest = yielding([*marks, *forces])
        placed = labels.place([*named, *names], rest, None, thin)
        return (*parted(thin, placed.texts), *rest, *placed.marks)

    def letters(self, marks: list[tuple[str, complex]]) -> list[labels.Label]:
        """Letters of the marks; those that coincide share one."""
        places = gathered((self.naming.mark(label, "velocity"), z) for label, z in marks)
        return [labels.Label(", ".join(n), z, 5.0, clear=0.8, priority=1, name=n[0]) for z, n in places]

    def forces(self) -> tuple[list[Mark], list[labels.Label]]:
        """Arrows of the forces at their images, not to scale, and their arms about the pole."""
        drawing, marks, named = self.position.drawing, list[Mark](), list[labels.Label]()
        drops = {s.makes: s for s in drawing.program.steps if isinstance(s, Drop)}
        taken: list[tuple[complex, complex]] = []
        arms = Arms()
        lever = next((m for m in self.position.plans.moments if m.links == ("lever",)), None)
        for name, arm in lever.terms if lever else ():
            step = drops.get(arm)
            if not step or arm not in drawing or abs(complex(drawing[step.point])) < ZERO_MM:
                continue
            size = float(drawing[name]) if name in drawing else 1.0
            point, along = complex(drawing[step.point]), complex(drawing[step.along]) * (1 if size >= 0 else -1)
            same = sum(abs(p - point) < 0.5 and (w * along.conjugate()).real > 0.9 for p, w in taken)
            taken.append((point, along))
            end = point + (FORCE_MM + STEP_MM * same) * along
            marks.append(Arrow(point, end, "thick", "force", name))
            named.append(labels.Label(self.naming.vector(name), ((point + end) / 2, end), 3.5, name=name))
            foot = point + ((0j - point) * along.conjugate()).real * along
            if abs(foot) > 2:
                arms.add(point, (0j, foot), self.naming.arm(name, arm), name)
        return [*marks, *arms.marks], [*named, *arms.named]

    @property
    def there(self) -> bool:
        """Whether the lever was drawn at all."""
        return at("lever", POLE) in self.position.drawing
