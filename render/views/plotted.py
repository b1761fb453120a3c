"""What the plans of a sheet are drawn from: a drawing with its equations and segments, of a mechanism or of vectors."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import cached_property

from planes.drafting.draft import Segment
from planes.drafting.drawing import Drawing
from planes.drafting.equations import Equation
from planes.solving import Position
from planes.solving.vectors import PLAN, VectorResults
from planes.words.names import at, kind_of, label_of, mu_of, plan_of


@dataclass(frozen=True)
class Plotted:
    """One drawing: ``scales`` are mm per SI unit, ``fixed`` the labels of points of the frame (they stand in poles),
    ``units`` the kind of plan whose unit each plan's vectors have, ``points`` the labels that are points of links."""

    drawing: Drawing
    segments: tuple[Segment, ...]
    equations: tuple[Equation, ...]
    scales: Mapping[str, float]
    fixed: tuple[str, ...] = ()
    quantity: str = ""

    @cached_property
    def initials(self) -> frozenset[str]:
        """The first letters of everything drawn."""
        return frozenset(label_of(name)[:1] for name in self.drawing.things)

    def mark(self, plan: str, label: str) -> complex:
        """Where a mark stands, mm from the pole of its plan."""
        return complex(self.drawing[at(plan, label)])

    def has(self, plan: str, *labels: str) -> bool:
        """Whether all these marks have been drawn (a sliced program draws only what is asked)."""
        return all(at(plan, label) in self.drawing for label in labels)

    def labels(self, plan: str) -> list[str]:
        """Labels of all marks of a plan in the order they were drawn, the helping ones left out."""
        made = [s for s in self.drawing.program.steps if s.kind == "mark" and plan_of(s.makes) == plan]
        return [label_of(s.makes) for s in made if not s.loose]

    def mu(self, plan: str) -> float:
        """μ of a plan, mm per SI unit."""
        return self.scales[mu_of(plan)]

    def kind(self, plan: str) -> str:
        """The kind of a plan, which tells the unit of its vectors."""
        return self.quantity or kind_of(plan)

    def still(self, plan: str) -> bool:
        """Whether every mark of the plan stands in its pole: there is nothing to draw."""
        return all(abs(self.mark(plan, label)) < 1e-6 for label in self.labels(plan))


def of_position(p: Position) -> Plotted:
    """The plans of a mechanism in one position."""
    m = p.plans.mechanism
    shared = tuple(n.lower() for n in m.frame.points if any(n in link.points for link in m.links.values()))
    return Plotted(p.drawing, p.plans.segments, p.plans.equations, p.scales, shared)


def of_vectors(found: VectorResults) -> Plotted:
    """The plan of a scene that states vectors alone."""
    draft = found.plan.draft
    spans = {name: (label_of(s), label_of(e)) for name, (s, e) in found.spans.items()}
    segments = tuple(Segment(PLAN, start, end, name) for name, (start, end) in spans.items())
    return Plotted(found.drawing, segments, tuple(draft.equations), {mu_of(PLAN): found.mu}, (), found.quantity)
