"""Force plans with friction in their pairs: drawn aside, first without friction, until they reproduce it."""

from collections.abc import Iterable, Mapping

from planes.drafting.steps.reckoning import SizeOf
from planes.drafting.steps.settling import Fed
from planes.plans.assur.contours import AnyGroup
from planes.plans.assur.groups import Pair
from planes.plans.force.hinges import Grip, Slip, guide_friction, hinge_friction, settle_friction_values
from planes.plans.force.loads import Couple, name_of_force
from planes.plans.force.reactions import Statics
from planes.words.frozen import field, frozen
from planes.words.names import MarkPair


@frozen
class Rubs:
    """Friction in the pairs of a plan: couples in hinges, and given forces on guides."""

    grips: Mapping[Pair, Grip] = field(default_factory=dict)
    slips: Mapping[Pair, Slip] = field(default_factory=dict)

    def friction_couples_on_link(self, link: str) -> list[Couple]:
        """The couples of its hinges on a link."""
        return [grip.couple_on_link(link) for pair, grip in self.grips.items() if pair.has_link(link)]


class RubbingPlan:
    """The plan of a group with friction in its pairs; the ``couples`` of each link act on it, loads and friction."""

    couples: Mapping[str, list[Couple]]

    def __init__(self, statics: Statics, group: AnyGroup) -> None:
        self.statics = statics
        self.group = group
        self.bodies = statics.bodies
        self.draft = statics.bodies.draft

    def rub(self, rubs: Rubs) -> None:
        """Apply the friction couples of hinges to the links."""
        for link, couples in self.couples.items():
            couples += rubs.friction_couples_on_link(link)

    def polygon(self) -> Mapping[Pair, MarkPair]:
        """Draw the polygons; each reaction is on the first link of its pair."""
        raise NotImplementedError

    def settle_friction(self, hinges: Iterable[Pair], guides: Iterable[Pair] = ()) -> Rubs:
        """Apply the friction of these pairs, at the values to which trial plans converge."""
        acting = self.statics.acting
        grips = {p: grip for p in hinges if (grip := hinge_friction(acting, p))}
        rubs = Rubs(grips, {p: slip for p in guides if (slip := guide_friction(acting, p))})
        if rubs.grips or rubs.slips:
            self.rub(rubs)
            trial = type(self)(self.statics.copy_for_trial(), self.group)
            trial.rub(rubs)
            settle_friction_values(acting, (*_friction_from_trial(trial, rubs),), trial.draft)
        return rubs


def _friction_from_trial(trial: RubbingPlan, rubs: Rubs) -> Iterable[Fed]:
    """The results of a trial plan: couples by the reactions of hinges, friction by the normal forces of guides."""
    ends = trial.polygon()
    d = trial.draft
    for pair, grip in rubs.grips.items():
        yield Fed(grip.couple, grip.factor, d.measure_segment(f"|{name_of_force(pair.link, pair.other)}|", *ends[pair]))
    for pair, slip in rubs.slips.items():
        name = f"N_{name_of_force(pair.link, pair.other)}"
        normal = d.measure_segment(name, *ends[pair], d.draw_perpendicular(f"∥{pair.guide}"))
        yield Fed(slip.force, slip.factor, d.add_step(SizeOf(f"|{name}|", normal)))
