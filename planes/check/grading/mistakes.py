"""The catalogue of mistakes of velocity and acceleration plans, as variants of the program's steps."""

from collections.abc import Iterator, Sequence

from planes.check.grading.plan_steps import PlanSteps, with_other_direction
from planes.check.grading.variants import Steps, Variant, Variants
from planes.drafting.steps import Carry, Image, LayOff, MarkStep, Read, Same, Similar, Step
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Point
from planes.words import Phrase, Told
from planes.words.frozen import frozen, replace
from planes.words.names import POLE_LABEL, VELOCITY_PLAN, Mark, MarkPair, guide_of, letter_of


def motion_variants(w: PlanSteps) -> Variants:
    """Mistakes of a velocity or acceleration plan."""
    quick = w.plan == "acceleration"
    yield from _driver_mistakes(w, quick)
    for step in w.own:
        if isinstance(step, Cross):
            yield from _intersection_mistakes(w, step, quick)
        elif isinstance(step, Similar | Image):
            yield from _similarity_mistakes(w, step, quick)
        elif isinstance(step, LayOff) and quick and step.quantity_represented == "normal":
            yield from _normal_component_mistakes(w, step)
        elif isinstance(step, LayOff) and quick and step.quantity_represented == "coriolis":
            yield from _coriolis_mistakes(w, step)
        elif isinstance(step, LayOff) and (line := w.base_of_perpendicular(step.along)):
            mistake = "tangential_along_link" if quick else "along_link"
            yield w.variant_at_step(mistake, step, replace(step, along=line), about={"line": line})


def _driver_mistakes(w: PlanSteps, quick: bool) -> Variants:
    """The driver's motion taken with the wrong sense, or left out."""
    spin = "epsilon" if quick else "omega"
    name = w.plans.mechanism.drive.rate_names[quick]
    mark = next((s.makes for s in w.own if isinstance(s, LayOff) and _determines_length(w, name, s.length)), None)
    if name not in w.program.given_names or mark is None:
        return
    value = float(w.given[name])
    label = mark.label
    about = {"value": name}
    yield Variant(f"{spin}1_reversed", label, {}, {name: -value}, 1.0, about)
    if quick:
        yield Variant("epsilon1_ignored", label, {}, {name: 0.0}, 1.0, about)


def _determines_length(w: PlanSteps, value: str, length: str) -> bool:
    return value == length or (length in w.steps and any(n == value for n, _ in w.steps[length].input_names()))


def _intersection_mistakes(w: PlanSteps, step: Cross, quick: bool) -> Variants:
    """An intersection of two lines: one of them in a wrong direction or from a wrong point."""
    sides = (("along", step.along), ("across", step.across))
    for side, direction in sides:
        line = w.base_of_perpendicular(direction)
        guide = guide_of(direction)
        if line and guide_of(line) is None:
            about: dict[str, Told] = {"line": line}
            mistake = "tangential_along_link" if quick else "along_link"
            yield w.variant_at_step(mistake, step, with_other_direction(step, side, line), about=about)
            others = [d for d in w.perpendiculars() if d not in (step.along, step.across) and w.is_made_before(d, step)]
            others += [d for _, d in sides if d != direction and not quick]
            for other in others if not quick else []:
                variant_step = with_other_direction(step, side, other)
                yield w.variant_at_step(
                    "wrong_link", step, variant_step, weight=1 / len(others), about={"line": line, "other": other}
                )
        elif guide is not None:
            turned = f"⊥{direction}~{step.makes}"
            swap = w.perpendicular_step(direction, turned), with_other_direction(step, side, turned)
            from_pole = (step.start if side == "along" else step.other) == w.pole
            about = {"guide": guide, "vector": Phrase(f"absolute_{w.plan}" if from_pole else f"relative_{w.plan}")}
            yield w.variant_at_step("across_guide", step, *swap, about=about)
    if not quick:
        yield from _start_point_mistakes(w, step)


def _start_point_mistakes(w: PlanSteps, step: Cross) -> Variants:
    """Two lines drawn from each other's ends, or the relative velocity laid off backwards."""
    starts = (step.start, step.other)
    if w.pole in starts and step.start != step.other:
        yield w.variant_at_step("relative_from_pole", step, replace(step, start=step.other, other=step.start))
    elif w.pole not in starts:
        for one, two in ((w.pole, step.other), (step.start, w.pole)):
            yield w.variant_at_step("relative_from_pole", step, replace(step, start=one, other=two), weight=0.5)
    for known in dict.fromkeys(s for s in starts if s != w.pole):
        met = step.plan.mark(f"{step.label}~met")
        yield w.variant_at_step(
            "relative_reversed", step, replace(step, makes=met), Carry(step.makes, known, met, known)
        )


def _similarity_mistakes(w: PlanSteps, step: Similar | Image, quick: bool) -> Variants:
    """A mark by similarity: mirrored, divided from the wrong end, or built on another segment."""
    start, end = (step.start, step.end) if isinstance(step, Similar) else step.image
    yield from _mirrored_similarity(w, step)
    if isinstance(step, Image) and step.start != start:
        return  # carried over from a single mark: there is no other end to start from
    about = {"start": start.label, "end": end.label}
    if not quick:
        yield w.variant_at_step("divided_from_wrong_end", step, _similar_on_segment(step, end, start), about=about)
        for far in (end, start):
            if w.pole not in (start, end):
                for pair in ((w.pole, far), (far, w.pole)):
                    variant_step = _similar_on_segment(step, *pair)
                    yield w.variant_at_step("similarity_on_pole_segments", step, variant_step, weight=0.25, about=about)
        return
    for one, two in ((start, end), (end, start)):
        for normal in _normal_component_ends(w, one, two):
            ends = (normal, two) if one == start else (two, normal)
            words = {"normal": normal.label, **about}
            yield w.variant_at_step("similarity_on_tangential", step, _similar_on_segment(step, *ends), about=words)


def _similar_on_segment(step: Similar | Image, start: Mark, end: Mark) -> Step:
    if isinstance(step, Similar):
        return replace(step, start=start, end=end)
    return replace(step, start=start, image=(start, end))


def _normal_component_ends(w: PlanSteps, start: str, end: str) -> Iterator[Mark]:
    """Ends of normal components laid off from ``start`` on the way to ``end``."""
    meets = w.steps.get(end)
    for step in w.own:
        normal = step.quantity_represented == "normal" and isinstance(step, LayOff) and step.start == start
        if normal and isinstance(meets, Cross) and step.makes in (meets.start, meets.other):
            yield step.makes


def _mirrored_similarity(w: PlanSteps, step: Similar | Image) -> Variants:
    """The similar figure mirrored about its base."""
    name = f"mirrored {step.makes}"
    if isinstance(step, Similar):
        ratio = complex(w.given[step.ratio]).conjugate()
        mirrored = (replace(step, ratio=name),)
        yield Variant("similarity_mirrored", step.label, {step.makes: mirrored}, {name: ratio})
        return
    foot = Mirror(step.plan.mark(f"{step.label}~mirrored"), step.of, step.like)
    yield w.variant_at_step("similarity_mirrored", step, foot, replace(step, of=(step.of[0], foot.makes)))


@frozen
class Mirror(MarkStep):
    """The second of the marks ``of``, mirrored in the line through the first along ``like``."""

    of: MarkPair
    like: MarkPair

    def input_names(self) -> tuple[Read, ...]:
        return tuple((n, "mark") for n in (*self.of, *self.like))

    def draw(self, env: Env, tool: Tool) -> Point:
        a, b = self.of
        c, d = self.like
        along = env[d] - env[c]
        return env[a] + along * ((env[b] - env[a]) / along).conjugate()


def _normal_component_mistakes(w: PlanSteps, step: LayOff) -> Variants:
    """A normal component: outward, left out, with another velocity, from the pole."""
    yield w.variant_at_step("normal_outward", step, *w.scaled_length_steps(step))
    yield w.variant_at_step("normal_missing", step, Same(step.makes, step.start))
    if step.start != w.pole:
        yield w.variant_at_step("normal_from_pole", step, replace(step, start=w.pole))
    formula = w.length_formula(step)
    if not formula or not formula.terms:
        return
    squares = [n for n, power in formula.terms[0].factors if power == 2 and isinstance(w.steps.get(n), Measure)]
    for square in squares:
        others = list(_other_speeds(w, step, square))
        for other, measured in others:
            swap = (*measured, *_length_from_other_value(step, formula, [square], other, "v²"))
            about = {"value": square, "other": other.removeprefix(f"{step.makes} ")}
            yield w.variant_at_step("normal_wrong_velocity", step, *swap, weight=1 / len(others), about=about)


def _length_from_other_value(
    step: LayOff, formula: Calculate, old: Sequence[str], new: str, tag: str
) -> tuple[Step, Step]:
    """A laid-off length computed with another value in place of some factors."""
    factors = tuple((new if n in old else n, power) for n, power in formula.terms[0].factors)
    formula_with_slip = Calculate(f"{step.makes} {tag}", (replace(formula.terms[0], factors=factors),))
    return formula_with_slip, replace(step, length=formula_with_slip.makes)


def _other_speeds(w: PlanSteps, step: LayOff, but: str) -> Iterator[tuple[str, Steps]]:
    """Other speeds of the velocity plan, with a step that reads each if there is none yet."""
    for name, made in w.steps.items():
        plain = isinstance(made, Measure) and made.start.plan == "velocity" and "slide" not in name
        if name != but and plain and w.is_made_before(name, step):
            yield name, ()
    for name, made in w.steps.items():
        if (
            isinstance(made, MarkStep)
            and made.plan == "velocity"
            and made.label != POLE_LABEL
            and w.is_made_before(name, step)
        ):
            tag = f"{step.makes} v_{made.label.upper()}"
            yield tag, (Measure(tag, VELOCITY_PLAN.pole, made.makes, None, VELOCITY_PLAN.mu_name),)


def _coriolis_mistakes(w: PlanSteps, step: LayOff) -> Variants:
    """A Coriolis component: left out, reversed, halved, with another ω, along the guide."""
    yield w.variant_at_step("coriolis_missing", step, Same(step.makes, step.start))
    yield w.variant_at_step("coriolis_reversed", step, *w.scaled_length_steps(step))
    yield w.variant_at_step("coriolis_half", step, *w.scaled_length_steps(step, 0.5))
    if guide := w.base_of_perpendicular(step.along):
        yield w.variant_at_step("coriolis_along_guide", step, replace(step, along=guide), weight=0.5)
        length, _ = w.scaled_length_steps(step)
        back = replace(step, along=guide, length=length.makes)
        yield w.variant_at_step("coriolis_along_guide", step, length, back, weight=0.5)
    formula = w.length_formula(step)
    if not formula:
        return
    used = [n for n, _ in formula.terms[0].factors if letter_of(n) == "omega"]
    spins = [n for n in (*w.program.given_names, *w.steps) if letter_of(n) == "omega" and n not in used]
    spins = [n for n in spins if n in w.program.given_names or w.is_made_before(n, step)]
    for spin in spins:
        swap = _length_from_other_value(step, formula, used, spin, "ω")
        about = {"value": used[0] if used else "", "other": spin}
        yield w.variant_at_step("coriolis_wrong_omega", step, *swap, weight=1 / len(spins), about=about)
