"""The choice of leads by which a basic link is drawn: others are taken where those cross much less sharply.

The plans are stated once for each choice that occurs, from the same scene.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar

from planes.drafting.drawing import run
from planes.drafting.program import Program
from planes.drafting.steps.by_leads import FAIR, ByLeads
from planes.plans.assur.basic_links import Lead
from planes.plans.position.bodies import SCHEME, Bodies
from planes.words.errors import PlanFailure
from planes.words.names import mu_of

Stated = TypeVar("Stated", bound=Any)  # the plans of a mechanism
Leads = tuple[Lead, ...]


@dataclass(frozen=True, eq=False)
class Restating:
    """The scheme as chosen, and what states its plans; each choice of leads once."""

    bodies: Bodies
    state: Callable[[Bodies], Any]
    known: dict[tuple[Leads, ...], Any] = field(default_factory=dict)

    def plans(self, leads: Mapping[str, Leads]) -> Any:
        """The plans in which the first two leads of each basic link meet."""
        key = tuple(leads.values())
        if key not in self.known:
            bodies = self.bodies.apart()
            bodies.leads = dict(leads)
            self.known[key] = self.state(bodies)
        return self.known[key]


def met(program: Program) -> list[ByLeads]:
    """The steps for which other leads may be sharper."""
    return [step for step in program.steps if isinstance(step, ByLeads)]


def with_others(plans: Stated, special: str, turns: int = 1) -> Stated:
    """The plans by the next leads, where these are too nearly parallel; after a full rotation they are these again."""
    basic = next(s.means.of for s in met(plans.program) if s.makes == special and s.means)
    own = plans.leads[basic]
    turned = (*own[turns:], *own[:turns])
    others: Stated = plans.restated({x: turned if leads == own else leads for x, leads in plans.leads.items()})
    return others


def fitting(plans: Stated, value: float) -> Stated:
    """The plans by leads that cross sharply at a position of the drive: these, wherever theirs do."""
    crossings = met(plans.program)
    if not crossings:
        return plans
    program = plans.program.sliced([name for step in crossings for name in step.crossed])
    try:
        things = run(program, {**plans.given, mu_of(SCHEME): 1.0, plans.drive_given: value}).things
    except PlanFailure:  # the same error will arise for the whole
        return plans
    first, turned = plans, set[Leads]()  # of basic links: their steps then have other names
    for step in crossings:
        sharp, leads = step.crossings(things), first.leads[step.means.of] if step.means else ()
        if leads not in turned and sharp[0] < FAIR * max(sharp):
            turned.add(leads)
            plans = with_others(plans, step.makes, sharp.index(max(sharp)))
    return plans
