"""Mistakes of a force plan as variants of its steps: loads, moments and arms, reactions, friction."""

from dataclasses import replace

from planes.check.grading.plan_steps import PlanSteps, with_other_direction
from planes.check.grading.variants import Steps, Swaps, Variant, Variants
from planes.drafting.steps import LayOff, Same, Through
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Calculate, Drop, Lean, Measure, Product
from planes.words.names import guide_of, letter_of


def force_variants(w: PlanSteps) -> Variants:
    """Mistakes of the plan of one group or of the driver."""
    for step in w.own:
        if isinstance(step, LayOff):
            yield from _force_mistakes(w, step)
        elif isinstance(step, Cross):
            yield from _reaction_direction_mistakes(w, step)
    yield from _reversed_friction_mistakes(w)


def _force_mistakes(w: PlanSteps, step: LayOff) -> Variants:
    omitted = Same(step.makes, step.start)
    backwards = w.scaled_length_steps(step)
    if step.quantity_represented == "tangential":
        yield w.variant_at_step("reaction_along_loaded_link", step, omitted)
        yield w.variant_at_step("tangential_reversed", step, *backwards)
        yield w.variant_at_step("force_doubled", step, *w.scaled_length_steps(step, 2.0))
        yield from _moment_equation_mistakes(w, step)
        return
    missing = "weight_missing" if step.quantity_represented == "weight" else "force_missing"
    yield from _mistake_with_and_in_moments(w, step, missing, (omitted,), 0.0)
    yield from _mistake_with_and_in_moments(w, step, "force_doubled", w.scaled_length_steps(step, 2.0), 2.0)
    if step.quantity_represented == "weight":
        yield from _mass_for_weight_mistakes(w, step)
    elif step.quantity_represented == "inertia":
        yield from _mistake_with_and_in_moments(w, step, "inertia_along_acceleration", backwards, -1.0)
    elif step.quantity_represented == "reaction":
        yield from _mistake_with_and_in_moments(w, step, "reaction_not_reversed", backwards, -1.0)


def _mistake_with_and_in_moments(w: PlanSteps, step: LayOff, mistake: str, swap: Steps, factor: float) -> Variants:
    """A force wrong in the polygon only, or in the moment equation, too."""
    alone = w.variant_at_step(mistake, step, *swap, weight=0.5)
    yield alone
    swaps = _scaled_moment_equations(w, step, factor)
    if swaps:
        yield replace(alone, swaps={**alone.swaps, **swaps})


def _scaled_moment_equations(w: PlanSteps, step: LayOff, factor: float) -> Swaps:
    """The plan's moment equations with the terms of one force multiplied by a factor."""
    arms = {n for n, m in w.plans.means.items() if m.quantity == "arm" and step.means and m.of == step.means.of}
    equations = {}
    laid = (s for s in w.own if isinstance(s, LayOff) and s.quantity_represented == "tangential")
    for formula in filter(None, map(w.length_formula, laid)):
        terms = tuple(
            replace(t, coefficient=t.coefficient * factor) if any(n in arms for n, _ in t.factors) else t
            for t in formula.terms
        )
        if terms != formula.terms:
            equations[formula.makes] = (replace(formula, terms=terms),)
    return equations


def _mass_for_weight_mistakes(w: PlanSteps, step: LayOff) -> Variants:
    """A mass in kilograms laid off as a force in newtons."""
    weight = w.length_formula(step)
    factors = weight.terms[0].factors if weight else ()
    if mass := next((n for n, _ in factors if letter_of(n) == "m"), None):
        alone = w.variant_at_step("mass_for_weight", step, replace(step, length=mass), weight=0.5)
        yield alone
        if gravity := float(w.given["g"]):
            yield replace(alone, swaps={**alone.swaps, **_scaled_moment_equations(w, step, 1.0 / gravity)})


def _moment_equation_mistakes(w: PlanSteps, step: LayOff) -> Variants:
    """Mistakes of the moment equation for a tangential reaction."""
    if not (formula := w.length_formula(step)):
        return
    terms = formula.terms
    for term in terms if len(terms) > 1 else ():
        name = next((n for n, _ in term.factors), "")
        inertia = letter_of(name) == "MI"
        mistake = "inertia_moment_reversed" if inertia else "moment_sign"
        turned = _formula_with_term_replaced(formula, term, replace(term, coefficient=-term.coefficient))
        yield _moment_equation_variant(step, mistake, (turned,), 1.0 if inertia else 1 / len(terms), name)
    for term in terms:
        yield from _arm_mistakes(w, step, term)
    scaled = tuple(_term_with_arm_in_mm(w, t) for t in terms)
    if scaled != terms:
        yield _moment_equation_variant(step, "arm_wrong", (replace(formula, terms=scaled),), 0.2, "mm")


def _arm_construction(w: PlanSteps, term: Product) -> Drop | None:
    """The construction of a term's arm, if it has one."""
    return next((s for n, _ in term.factors if isinstance(s := w.steps.get(n), Drop)), None)


def _term_with_arm_in_mm(w: PlanSteps, term: Product) -> Product:
    """A term with its arm in millimetres on paper."""
    drop = _arm_construction(w, term)
    if drop:
        return replace(term, factors=(*term.factors, (drop.mu, 1)))
    return term


def _arm_mistakes(w: PlanSteps, step: LayOff, term: Product) -> Variants:
    """The distance between two points, or the wrong leg of the triangle, taken as the arm."""
    formula = w.length_formula(step)
    drop = _arm_construction(w, term)
    if not formula or not drop:
        return
    distance = Measure(f"{drop.makes}~whole", drop.point, drop.about, None, drop.mu)
    leg = Measure(f"{drop.makes}~leg", drop.point, drop.about, drop.along, drop.mu)
    for made in (distance, leg):
        for sign in (1.0, -1.0):
            factors = tuple((made.makes if n == drop.makes else n, p) for n, p in term.factors)
            swapped = _formula_with_term_replaced(
                formula, term, replace(term, coefficient=sign * term.coefficient, factors=factors)
            )
            yield _moment_equation_variant(
                step, "arm_wrong", (made, swapped), 0.25 / len(formula.terms), term.factors[0][0]
            )


def _formula_with_term_replaced(formula: Calculate, old: Product, new: Product) -> Calculate:
    return replace(formula, terms=tuple(new if t is old else t for t in formula.terms))


def _moment_equation_variant(step: LayOff, mistake: str, steps: Steps, weight: float, force: str) -> Variant:
    about = {"force": force.strip("|").replace("MI_", "M_Φ")}
    return Variant(mistake, step.label, {step.length: steps}, {}, weight, about)


def _reaction_direction_mistakes(w: PlanSteps, step: Cross) -> Variants:
    """The lines of the unknown reactions in a wrong direction."""
    own = {"along": step.along, "across": step.across}
    rays = [s for s in w.program.steps if isinstance(s, Through) and s.start.plan == "position"]
    for side, direction in own.items():
        guide = w.base_of_perpendicular(direction)
        if guide and (named := guide_of(guide)) is not None:
            others = [guide, *(s.makes for s in rays if s.makes not in own.values())]
            for i, other in enumerate(others):
                swap = with_other_direction(step, side, other)
                weight = 0.7 if i == 0 else 0.3 / (len(others) - 1)
                yield w.variant_at_step("guide_reaction_not_normal", step, swap, weight=weight, about={"guide": named})


def _reversed_friction_mistakes(w: PlanSteps) -> Variants:
    """Friction drawn in the direction of motion."""
    used = {n for s in w.own if isinstance(s, Cross) for n in (s.along, s.across)}
    leans = [s for s in w.program.steps if isinstance(s, Lean) and s.makes in used]
    trial = next((s for s in w.own if s.label[-1:] in "+-" and isinstance(s, Cross)), None)
    if not leans or trial is None:
        return
    swaps = {}
    for lean in leans:
        back = Calculate(f"{lean.makes}~f", (Product(-1.0, ((lean.coefficient, 1),)),))
        swaps[lean.makes] = (back, replace(lean, coefficient=back.makes))
    yield Variant("friction_along_motion", trial.label.rstrip("+-"), swaps)
