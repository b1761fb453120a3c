"""The words of one drafting step, and of a moment equation: the action, its numbers, and the reason."""

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial
from typing import Any

from planes.drafting.drawing import Drawing
from planes.drafting.equations import Equation, Term
from planes.drafting.program import StepsByName
from planes.drafting.steps import Carry, Image, LayOff, Put, Same, Similar, Step, Turn
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs, Touch
from planes.drafting.steps.reckoning import Calculate, Choose, Measure
from planes.drafting.steps.tracks import TrackStep
from planes.lesson.false_plans import false_plan_step_words
from planes.lesson.formulas import unit_of_name, value_slot
from planes.lesson.rows import calculation_row
from planes.plans import Plans
from planes.plans.apart import LinkApart
from planes.plans.law_words import law_in_words
from planes.words import Phrase, Told, Written
from planes.words.names import SCHEME_PLAN, Mark, Meaning, PlanId, name_without_plan
from planes.words.units import number_text

Names = Mapping[str, Any]  # the contents of a sentence; all its numbers are in its texts and in its ``rows``
Words = tuple[str, Told, Names]  # the key of the sentence, of the reason (or the reason itself), names


@dataclass
class StepWords:
    """Finds the words of the steps of one drawing."""

    plans: Plans
    drawing: Drawing
    made: StepsByName

    def words_of_step(self, step: Step) -> Words:
        """The key of the sentence of a step, of its reason, and its contents besides the step's own names."""
        if words := false_plan_step_words(step, self.made):
            return words
        match step:
            case Put():
                kind = step.plan.kind
                return "pole", f"pole_{kind}" if kind in ("force", "lever") else "pole", {}
            case LayOff():
                return self.lay_off_words(step)
            case Touch():
                key = "touch" if step.offset else "touch_through"
                return key, "touch", {"action": self.action_words(step.makes), "end": name_without_plan(step.end)}
            case Cross():
                lines = {"action": self.action_words(step.along), "across": self.action_words(step.across)}
                if step.quantity_represented == "special":
                    return "special", "special", lines
                return "cross", self.crossing_reason(step.makes), lines
            case TrackStep():
                return self.track_words(step)
            case CrossArc():  # a guide is known by a place
                key = "arc" if name_without_plan(step.start) == step.start.label else "arc_guide"
                return (
                    key,
                    "arc",
                    {"action": self.action_words(step.along), "radius_mm": value_slot(step.radius, "mm", step.mu)},
                )
            case CrossArcs():
                radius = value_slot(step.radius, "mm", step.mu)
                other = value_slot(step.other_radius, "mm", step.mu)
                return "arcs", "arcs", {"radius_mm": radius, "other_mm": other}
            case Similar():
                return self.similar_figure_words(step)
            case Image():
                return self.image(step)
            case Same():
                return "same", "same", {"start": name_without_plan(step.of)}
            case Carry():
                aside = step.plan == SCHEME_PLAN or self.made[step.first].quantity_represented == "false"
                key = "carry" if step.quarter else "carry_aside" if aside else "carry_back"
                return key, key, {}
            case Choose():
                return "choose", "choose", {}
        raise AssertionError(step)

    def track_words(self, step: TrackStep) -> Words:
        """The crossing of a track with the line of the removed lead; for the others, their places then."""
        drawn = (x for x in self.made.values() if isinstance(x, TrackStep) and x.holds == step.holds)
        first = next(drawn).makes == step.makes
        key = "track_too" if not first else "track" if len(step.holds) == 3 else "track_both"
        leads = [h for h in step.holds if h.kind != "hinge" and (first or h.local == step.local)]
        hold = next((h for h in leads if h.local == step.local), leads[-1] if leads else None)
        if hold is None:
            return key, key, {"kept": Phrase("lesson_kept_hinge")}
        kept: Names = {
            "start": name_without_plan(hold.place),
            "mm": value_slot(hold.reach, "mm", step.mu) if hold.kind == "arc" else "",
            "action": self.action_words(hold.turn) if hold.kind == "line" else "",
        }
        return key, key, {**kept, "kept": Phrase(f"lesson_kept_{hold.kind}", **kept)}

    def action_words(self, direction: str) -> Told | Written:
        """A line of action as written."""
        return self.plans.means[direction].written_action

    def similar_figure_words(self, step: Similar) -> Words:
        """Proportional division, or a similar figure."""
        ratio = complex(self.drawing[step.ratio])
        names = {"first": name_without_plan(step.start), "second": name_without_plan(step.end)}
        if step.plan.kind == "position":
            return "point", "along", names
        if abs(ratio.imag) > 1e-9 * abs(ratio):
            corners = dict(zip(("one", "two", "own"), self.similar_figure_points(step), strict=True))
            return "image", "similar", {**names, **corners}
        return "similar", "similar", {**names, "ratio": Written(partial(number_text, ratio.real))}

    def image(self, step: Image) -> Words:
        """A figure on the segment of two points; or, from a mark that is neither, a vector in the same ratio to the
        segment as on the scheme."""
        key = "image" if step.start == step.image[0] else "carried_image"
        marks = (step.start, *step.image, *step.like, *step.of)
        said = "start", "first", "second", "one", "two", "from", "own"
        names = dict(zip(said, map(name_without_plan, marks), strict=True))
        return key, "similar" if key == "image" else Phrase(f"why_{key}", **names), names

    def similar_figure_points(self, step: Similar) -> Iterator[str]:
        """The points of the link on the scheme, in the order of a similar figure's marks."""
        links = self.plans.mechanism.links.values()
        named = self.plans.points
        own = next(x.points for x in links for p in x.points if step.ratio == f"ratio_{p}_{x.name}")
        for mark in (step.start, step.end, step.makes):
            yield next(p for p in own if mark in (named[p].velocity, named[p].acceleration))

    def crossing_reason(self, mark: Mark) -> Told:
        """Why the lines that cross at a mark have their directions."""
        plan = mark.plan
        label = mark.label
        kind = plan.kind
        for e in (e for e in self.plans.equations if e.plan == plan and kind != "position"):
            sought = [t for t in e.all_terms if t.direction and not t.length and not t.drawn]
            terms = [t for t in sought if label in (t.start, t.end)]
            if any(t.end == label for t in terms):  # the line drawn first finds the mark
                return Phrase(
                    "why_cross",
                    reasons=without_repeats(
                        self.direction_reason(t, displayed_term_name(e, t.name), kind) for t in terms
                    ),
                )
        return "cross_position"

    def direction_reason(self, term: Term, name: str, kind: str) -> Phrase:
        """Why a vector of unknown length has its direction."""
        line = self.plans.means[term.direction or ""]
        return Phrase(f"why_{line.quantity}_{kind}", name=name, line=line.line_name)

    def lay_off_words(self, step: LayOff) -> Words:
        """A known vector: with the formula of its length if that was calculated."""
        kind = step.plan.kind
        mm = value_slot(step.length, "mm", step.mu)
        named = {"mm": mm, "way": laid_off_direction(self.plans.means[step.along])}
        source = self.made.get(step.length)
        name = self.laid_off_vector(step)
        shown = {**named, "name": name, "value": value_slot(step.length), "unit": unit_of_name(name)}
        if kind == "position":
            along = self.made[step.along]
            drive = self.plans.drive
            driven = isinstance(along, Turn) and drive.rotates and along.of == f"x_{drive.link}"
            key = "driver" if driven else "along"
            reason = (
                "moved"
                if step.quantity_represented == "moved"
                else "driver"
                if driven or step.length == "s"
                else "along"
            )
            return key, reason, {**shown, "length": step.length, "unit": unit_of_name("l")}
        if any(m.unknown == step.length for m in self.plans.moments):
            return "found", "found", {**shown, "value": value_slot(step.length, "a")}
        if step.quantity_represented == "load":
            return "load", self.given_load_reason(step.length), shown
        if isinstance(source, Calculate):
            return (
                "lay_off",
                _calculated_vector_reason(step, kind, source),
                {**named, "rows": (calculation_row(source),)},
            )
        if isinstance(source, Measure):
            return "carried", "carried", shown
        return "given", "slide_v", shown

    def given_load_reason(self, value: str) -> Told:
        """That a force is given; with its law, if it has one."""
        law = self.plans.acting.laws.get(f"{value}_given")
        if law is None:
            return "load"
        written = Written(partial(law_in_words, law, self.plans.drive, "⟨{}⟩".format))
        return Phrase("why_load_law", name=value, law=written)

    def laid_off_vector(self, step: LayOff) -> str:
        """The name of the vector a step lays off."""
        plan = step.plan
        label = step.label
        terms = [t for e in self.plans.equations if e.plan == plan for t in e.all_terms]
        own = sorted(terms, key=lambda t: t.start != step.start.label)
        named = [t.name for t in own if t.end == label]
        named += [s.name for s in self.plans.segments_on(plan) if s.end == label]
        return next(iter(named), label)


def single_link_words(one: LinkApart, key: str) -> Names:
    """The words for a single link; ``key`` is the reaction that closes its forces, as in the tables."""
    force = f"⟨{one.force}⟩" + ("" if key == one.force else f" = −⟨{key}⟩")
    return {"link": one.link, "force": force, "sum": " + ".join(f"⟨{name}⟩" for name in (*one.known, one.force))}


def without_repeats(phrases: Iterable[Phrase]) -> tuple[Phrase, ...]:
    """The phrases without those that say the same again."""
    return tuple({p.told(): p for p in phrases}.values())


def plan_showing_step(step: Step) -> PlanId:
    """The plan of a mark (for a tangent, the scheme)."""
    return step.plan or SCHEME_PLAN


def displayed_term_name(equation: Equation, name: str) -> str:
    """The displayed name of a term: the motion of a point relative to a guide of the frame is its absolute vector."""
    for chain in equation.chains:
        if len(chain) == 2 and chain[0].action == "=0" and chain[0].name.endswith("0") and chain[1].name == name:
            return equation.total or name
    return name


def laid_off_direction(direction: Meaning) -> Phrase:
    """The direction in which a vector is laid off, in words."""
    line = direction.line_name
    key = f"lesson_way_{direction.quantity}"
    return Phrase(key, line=line, vector=line, one=direction.of, other=direction.about)


def _calculated_vector_reason(step: LayOff, kind: str, source: Calculate) -> str:
    """The reason for a calculated vector."""
    if kind == "force":
        return {"tangential": "projected", "weight": "weight", "inertia": "inertia"}.get(
            step.quantity_represented, "load"
        )
    if kind == "velocity":
        return "driver_v"
    if step.quantity_represented == "normal":
        return "normal" if any(power < 0 for _, power in source.terms[0].factors) else "normal_w"  # v²/l, ω²l
    if step.quantity_represented == "coriolis":
        return "coriolis"
    return "tangential"


def unknown_vectors(equation: Equation) -> list[str]:
    """Vectors whose lengths an equation gives: its unknown terms and its total."""
    names = [displayed_term_name(equation, t.name) for t in equation.all_terms if not t.drawn and t.length is None]
    return list(dict.fromkeys([*names, *([equation.total] if equation.total else [])]))
