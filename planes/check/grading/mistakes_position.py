"""Mistakes of a position plan: other assembly, sense of the angle, a link at another scale, an offset ignored."""

import cmath
import math
from collections.abc import Mapping, Sequence

from planes.check.grading.paper import MarkPlaces, TakenMarks
from planes.check.grading.plan_steps import PlanSteps
from planes.check.grading.variants import Variant, Variants
from planes.drafting.drawing import draw_program
from planes.drafting.steps import LayOff, MarkStep, Step
from planes.drafting.steps.crossings import CrossArc, CrossArcs
from planes.drafting.steps.tracks import CutTrack
from planes.geometry.arithmetic import Arithmetic
from planes.geometry.assemblies import all_assemblies
from planes.geometry.tracks import link_origins, newton_step
from planes.plans.assur.groups import Group
from planes.words import Phrase, Told, Written
from planes.words.names import letter_of

SAME_ASSEMBLY_TOLERANCE = 1e-6  # of a link's size: within this, the assemblies are the same
LEAST_GUIDE_OFFSET = 1e-6  # relative: a guide nearer to the pivot passes through it
LEAST_LINK_SCALE_ERROR = 0.04  # a smaller error of a link's length is inaccuracy, not scale


def position_variants(w: PlanSteps, taken: TakenMarks, mu: float) -> Variants:
    """Mistakes of a position plan; the person's own marks show the scale at which a link may have been drawn."""
    yield from _driver_angle_mistakes(w)
    for name, value in w.given.items():
        if name not in w.program.given_names:
            continue
        users = w.steps_using(name)
        if letter_of(name) == "side":
            second = {"which": Phrase("assembly_second")}
            yield from _variant_of_changed_givens(w, "other_assembly", users, {name: -float(value)}, about=second)
        elif letter_of(name) == "e" and value:
            yield from _variant_of_changed_givens(w, "guide_offset_ignored", users, {name: 0.0})
    yield from _guide_through_pivot_mistakes(w)
    yield from _other_class_iii_assemblies(w)
    for step in w.own:
        yield from _link_scale_mistakes(w, step, taken, mu)


def _guide_through_pivot_mistakes(w: PlanSteps) -> Variants:
    """A guide of the frame drawn through the driver's pivot, its offset ignored."""
    mechanism = w.plans.mechanism
    driver = mechanism.links[mechanism.drive.link].points if w.plans.has_mechanism else ()
    pivot = next((f"place_{n}" for n in driver if n in mechanism.frame.points), "")
    for guide in mechanism.frame.guides if pivot in w.given else ():
        place = f"place_°{guide}"
        if place in w.program.given_names and _misses_point(w, place, pivot, f"angle_∥{guide}"):
            yield from _variant_of_changed_givens(
                w, "guide_offset_ignored", w.steps_using(place), {place: w.given[pivot]}
            )


def _other_class_iii_assemblies(w: PlanSteps) -> Variants:
    """Another assembly of a class III group: its basic link elsewhere on the same three leads."""
    cuts = {step.holds: step for step in w.program.steps if isinstance(step, CutTrack)}
    for holds, cut in cuts.items():
        program = w.program.cut_to_names([name for hold in holds for name, _ in hold.input_names()])
        given = {**w.given, cut.mu: 1.0}
        things = draw_program(program, given).things
        guess = cut.guess
        ties = [hold.lead_tie(things, 1.0, Arithmetic()) for hold in holds]
        size = things[guess.size]
        drawn = draw_program(w.program.cut_to_names([cut.makes]), given)[cut.makes]
        terms = *guess.places, *(name for turn in guess.turns for name in turn)
        here = {guess.middle: things[guess.drive], guess.half: 1.0} | dict.fromkeys(terms, 0.0)
        poses = all_assemblies(ties, size).poses
        local = things[cut.local] - (things[cut.hinge] if cut.hinge else 0.0)
        others = [
            p
            for p in poses
            if abs(link_origins(ties, p)[cut.link] + p[1 + cut.link] * local - drawn) > SAME_ASSEMBLY_TOLERANCE * size
        ]
        which = Phrase("assembly_another", count=len(poses), level=_assur_class_by_basic_link(w, cut))
        for pose in others:
            turned = {turn[0]: cmath.phase(axis) for turn, axis in zip(guess.turns, pose[1:], strict=True)}
            there = here | {guess.places[0]: pose[0] / size} | turned
            there[cut.side] = math.copysign(1.0, newton_step(ties, pose)[2])
            users = w.steps_using(guess.middle)
            part = 1 / len(others)
            yield from _variant_of_changed_givens(w, "other_assembly", users, there, part, {"which": which})


def _assur_class_by_basic_link(w: PlanSteps, cut: CutTrack) -> str:
    """The class of the group whose basic link is drawn so."""
    groups = (g for g in w.plans.structure.groups if not isinstance(g, Group))
    return next(g.level for g in groups if cut.side == f"sense_{g.basic}")


def _misses_point(w: PlanSteps, place: str, pivot: str, angle: str) -> bool:
    """Whether the line of a guide misses a point."""
    way = cmath.rect(1.0, math.radians(float(w.given[angle])))
    start = complex(w.given[place])
    off = (complex(w.given[pivot]) - start) * way.conjugate()
    return abs(off.imag) > LEAST_GUIDE_OFFSET * max(abs(start), 1e-9)


def _driver_angle_mistakes(w: PlanSteps) -> Variants:
    """φ measured from the wrong axis or in the wrong sense."""
    given = w.plans.drive_given_name
    if w.plans.mechanism.drive.kind != "phi":
        return
    phi = float(w.given[given])
    wrong = (-phi, 180 - phi, 180 + phi, 90 - phi, phi + 90, phi - 90)
    users = [s for s in w.own if isinstance(s, LayOff)][:1]
    for angle in wrong:
        yield from _variant_of_changed_givens(w, "angle_sense", users, {given: angle}, 1 / len(wrong))


def _variant_of_changed_givens(
    w: PlanSteps,
    mistake: str,
    users: Sequence[Step],
    givens: MarkPlaces,
    weight: float = 1.0,
    about: Mapping[str, Told | Written] | None = None,
) -> Variants:
    """A variant blamed at the first mark of the plan that depends on the changed givens."""
    touched = w.program.steps_to_redraw((), instead={u.makes for u in users})
    for step in [step for step in touched if step.plan and not step.is_auxiliary_mark][:1]:
        yield Variant(mistake, step.label, {}, dict(givens), weight, about or {})


def _link_scale_mistakes(w: PlanSteps, step: MarkStep, taken: TakenMarks, mu: float) -> Variants:
    """A length drawn at another scale, the one shown by the person's own mark."""
    own = taken.get(step.makes)
    label = step.label
    ends = []
    if isinstance(step, LayOff):
        ends.append((step.start, step.length))
    if isinstance(step, CrossArc | CrossArcs):
        ends.append((step.centre, step.radius))
    if isinstance(step, CrossArcs):
        ends.append((step.other, step.other_radius))
    for centre, length in ends:
        value = w.given.get(length)
        start = taken.get(centre)
        if own is None or start is None or not value or length not in w.plans.link_lengths:
            continue
        ratio = abs(own.place - start.place) / mu / abs(float(value))
        if abs(ratio - 1) > LEAST_LINK_SCALE_ERROR:
            about: dict[str, Told | Written] = {"value": length, "ratio": Written(f"{ratio:.3g}")}
            yield Variant("link_scale", label, {}, {length: float(value) * ratio}, 0.1, about)
