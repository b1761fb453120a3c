"""A program: steps in drawing order, checked by name and kind before any number exists, and sliced."""

from collections.abc import Container, Iterable, Mapping
from functools import cached_property

from planes.drafting.proofs import Proof, Twofold
from planes.drafting.steps import Kind, LayOff, MarkStep, Step, Steps, Through, Turn
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.words import Phrase
from planes.words.errors import ProgramError, list_valid_choices
from planes.words.frozen import field, frozen
from planes.words.names import Mark, NameTuple, PlanId

StepsByName = Mapping[str, Step]
StepsOf = dict[str, list[Step]]


@frozen
class Program:
    """A straight sequence of steps. Names that no step makes must be given (a value or a place) for a run."""

    steps: Steps
    # conditions on the result, in the scene's own numbers; the program does not depend on them
    proofs: tuple[Proof, ...] = field(default=(), compare=False)

    def __post_init__(self) -> None:
        made: dict[str, Kind] = {}
        for step in self.steps:
            for name, kind in step.input_names():
                have = made.get(name, kind if kind in ("value", "place") else None)
                if have != kind:
                    said = {"step": type(step).__name__, "makes": step.makes, "name": name}
                    wanted = Phrase(f"kind_{kind}")
                    if have:
                        raise ProgramError(Phrase("step_kind", **said, kind=wanted, have=Phrase(f"kind_{have}")))
                    valid = list_valid_choices(name, [m for m, k in made.items() if k == kind][:12], what="valid_drawn")
                    raise ProgramError(Phrase("step_needs", **said, kind=wanted, valid=valid))
            if step.makes in made:
                raise ProgramError(Phrase("made_twice", makes=step.makes))
            made[step.makes] = step.kind

    @cached_property
    def result_names(self) -> frozenset[str]:
        """Names of all results of the steps."""
        return frozenset(s.makes for s in self.steps)

    @cached_property
    def steps_by_result(self) -> StepsByName:
        """The steps by the names of their results."""
        return {s.makes: s for s in self.steps}

    @cached_property
    def given_names(self) -> NameTuple:
        """Names of the required givens, in the order of first use."""
        names = (name for s in self.steps for name, _ in s.input_names())
        return tuple(dict.fromkeys(n for n in names if n not in self.result_names))

    @cached_property
    def mark_steps_by_plan(self) -> dict[PlanId, list[MarkStep]]:
        """The steps that draw marks, by their plan: position, velocity, acceleration, force:2-3, …, force:1."""
        marks: dict[PlanId, list[MarkStep]] = {}
        for step in self.steps:
            if isinstance(step, MarkStep):
                marks.setdefault(step.plan, []).append(step)
        return marks

    def mark_steps_on(self, plan: PlanId) -> list[MarkStep]:
        """The steps that draw the marks of a plan."""
        return self.mark_steps_by_plan.get(plan, [])

    @cached_property
    def trial_marks(self) -> frozenset[str]:
        """Marks that are only assumptions (friction): they serve to find which assumption holds."""
        return frozenset(s.makes for s in self.steps if isinstance(s, Cross) and s.supposed)

    @cached_property
    def steps_by_name_read(self) -> StepsOf:
        """The steps that use each name."""
        readers: StepsOf = {}
        for step in self.steps:
            for name in dict.fromkeys(name for name, _ in step.input_names()):
                readers.setdefault(name, []).append(step)
        return readers

    @cached_property
    def vanishing_directions(self) -> frozenset[str]:
        """Directions between two marks that only carry lengths proportional to their distance: where the marks coincide
        the length is zero, and any direction will do."""
        return frozenset(s.makes for s in self.steps if isinstance(s, Through) and self._may_vanish(s))

    def _may_vanish(self, ray: Through) -> bool:
        """Whether a direction is only turned, to lay off lengths proportional to the distance of its marks."""
        turns = self.steps_by_name_read.get(ray.makes, [])
        laid = [s for turn in turns for s in self.steps_by_name_read.get(turn.makes, [])]
        ends = {ray.start, ray.end}
        grow = all(isinstance(s, LayOff) and self._is_proportional_to_distance(s.length, ends) for s in laid)
        return bool(laid) and grow and all(isinstance(s, Turn) for s in turns)

    def _is_proportional_to_distance(self, value: str, ends: set[Mark]) -> bool:
        """Whether every part of a value has the distance of two marks as a factor."""
        made = self.steps_by_result.get(value)
        terms = made.terms if isinstance(made, Calculate) else ()
        factors = ([self.steps_by_result.get(name) for name, power in t.factors if power > 0] for t in terms)
        return bool(terms) and all(any(isinstance(f, Measure) and {f.start, f.end} == ends for f in x) for x in factors)

    def steps_to_redraw(
        self, changed: Iterable[str], instead: Container[str] = (), fixed: Container[str] = ()
    ) -> Steps:
        """The steps to redraw when the givens ``changed`` change, or other steps are drawn ``instead`` of some; results
        in ``fixed`` stay, whatever they depend on."""
        dirty = set(changed)
        steps = []
        for step in self.steps:
            if step.makes in instead or any(name in dirty for name, _ in step.input_names()):
                steps.append(step)
                if step.makes not in fixed:
                    dirty.add(step.makes)
        return tuple(steps)

    @cached_property
    def component_end_marks(self) -> frozenset[str]:
        """Marks at the end of a vector component (normal, Coriolis or a drive's): not points of a link."""
        return frozenset(s.makes for s in self.steps if s.quantity_represented in ("normal", "coriolis", "relative"))

    def cut_to_names(self, wanted: Iterable[str]) -> "Program":
        """The program without steps that the wanted names do not need; it still proves all it draws."""
        needed = set(wanted)
        for proof in self.proofs:  # a balancing load is always drawn with the other one that checks it
            if isinstance(proof, Twofold) and needed & {proof.one, proof.two}:
                needed |= {proof.one, proof.two}
        kept = []
        for step in reversed(self.steps):
            if step.makes in needed or step.guards:
                kept.append(step)
                needed.update(name for name, _ in step.input_names())
        made = {s.makes for s in kept} | set(self.given_names)
        return Program(tuple(reversed(kept)), tuple(p for p in self.proofs if made >= p.names_read))
