"""The choice of leads by which a basic link is drawn: others are taken where those cross much less sharply.

The plans are stated once for each choice that occurs, from the same scene.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar

from planes.drafting.drawing import draw_program
from planes.drafting.program import Program
from planes.drafting.steps.by_leads import LEAST_FAIR_SHARPNESS_RATIO, ByLeads
from planes.plans.assur.basic_links import Leads
from planes.plans.position.bodies import Bodies
from planes.words.errors import PlanFailure
from planes.words.names import SCHEME_PLAN

Stated = TypeVar("Stated", bound=Any)  # the plans of a mechanism


@dataclass(frozen=True, eq=False)
class Restating:
    """The scheme as chosen, and what states its plans; each choice of leads once."""

    bodies: Bodies
    state: Callable[[Bodies], Any]
    known: dict[tuple[Leads, ...], Any] = field(default_factory=dict)

    def plans_with_meeting_leads(self, leads: Mapping[str, Leads]) -> Any:
        """The plans in which the first two leads of each basic link meet."""
        key = tuple(leads.values())
        if key not in self.known:
            bodies = self.bodies.copy_for_trial()
            bodies.leads = dict(leads)
            self.known[key] = self.state(bodies)
        return self.known[key]


def steps_with_other_leads(program: Program) -> list[ByLeads]:
    """The steps for which other leads may be sharper."""
    return [step for step in program.steps if isinstance(step, ByLeads)]


def plans_by_next_leads(plans: Stated, special: str, turns: int = 1) -> Stated:
    """The plans by the next leads, where these are too nearly parallel; after a full rotation they are these again."""
    basic = next(s.means.of for s in steps_with_other_leads(plans.program) if s.makes == special and s.means)
    own = plans.leads[basic]
    turned = (*own[turns:], *own[:turns])
    others: Stated = plans.restated_with_leads(
        {x: turned if leads == own else leads for x, leads in plans.leads.items()}
    )
    return others


def plans_with_sharp_leads(plans: Stated, value: float) -> Stated:
    """The plans by leads that cross sharply at a position of the drive: these, wherever theirs do."""
    crossings = steps_with_other_leads(plans.program)
    if not crossings:
        return plans
    program = plans.program.cut_to_names([name for step in crossings for name in step.sharp_directions])
    try:
        things = draw_program(program, {**plans.given, SCHEME_PLAN.mu_name: 1.0, plans.drive_given_name: value}).things
    except PlanFailure:  # the same error will arise for the whole
        return plans
    first, turned = plans, set[Leads]()  # of basic links: their steps then have other names
    for step in crossings:
        sharp = step.crossing_sharpnesses(things)
        leads = first.leads[step.means.of] if step.means else ()
        if leads not in turned and sharp[0] < LEAST_FAIR_SHARPNESS_RATIO * max(sharp):
            turned.add(leads)
            plans = plans_by_next_leads(plans, step.makes, sharp.index(max(sharp)))
    return plans
