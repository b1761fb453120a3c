"""The plans of any scene."""

from planes.plans import Plans, plans_cut_to_names, plans_of
from planes.plans.other_leads import plans_with_sharp_leads
from planes.plans.quantities import Quantity, quantities_asked_for
from planes.scene import Scene
from planes.words.names import SCHEME_PLAN, NameTuple


def scene_plans(scene: Scene) -> Plans:
    """All the plans of a scene's mechanism, or of its vectors, stated once and stored with it: neither changes."""
    assert scene.mechanism or scene.statement
    kept = vars(scene.mechanism or scene.statement)
    if "plans" not in kept:
        if scene.mechanism:
            kept["plans"] = plans_of(scene.mechanism, scene.file)
        else:  # a mechanism needs neither statics nor stated equations: they take a tenth of a start
            from planes.plans.statements.stated import stated_plans

            kept["plans"] = stated_plans(scene)
    plans: Plans = kept["plans"]
    return plans


def names_to_find(scene: Scene) -> NameTuple:
    """The entries of ``find:``, in any spelling, by the names of the program."""
    return tuple(q.name for q in quantities_asked_for(scene_plans(scene), scene.find or (), scene.file))


def plans_fitted_at_position(
    plans: Plans, wanted: list[Quantity] | None, value: float
) -> tuple[Plans, list[Quantity] | None]:
    """The plans by leads that cross sharply at a position of the drive, cut to the wanted results; and these
    results."""
    fit = plans_with_sharp_leads(plans, value)
    if fit is plans or wanted is None:
        return fit, wanted
    return plans_cut_to_results(fit, quantities_asked_for(fit, [q.name for q in wanted]), plans)


def plans_cut_to_results(plans: Plans, wanted: list[Quantity], shown: Plans | None) -> tuple[Plans, list[Quantity]]:
    """The plans cut to the wanted results, and to the scheme for what is ``shown``; and these results."""
    scheme = [step.makes for step in shown.program.mark_steps_on(SCHEME_PLAN)] if shown else []
    return plans_cut_to_names(plans, [*(n for q in wanted for n in q.needed_names), *scheme]), wanted
