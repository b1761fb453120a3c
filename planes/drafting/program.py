"""A program: steps in drawing order, checked by name and kind before any number exists, and sliced."""

from collections.abc import Container, Iterable
from functools import cached_property

from planes.drafting.proofs import Proof, Twofold
from planes.drafting.steps import Kind, LayOff, Step, Through, Turn
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Calculate, Measure
from planes.words import Phrase
from planes.words.errors import ProgramError, choices
from planes.words.frozen import field, frozen
from planes.words.names import plan_of

StepsOf = dict[str, list[Step]]


@frozen
class Program:
    """A straight sequence of steps. Names that no step makes must be given (a value or a place) for a run."""

    steps: tuple[Step, ...]
    # conditions on the result, in the scene's own numbers; the program does not depend on them
    proofs: tuple[Proof, ...] = field(default=(), compare=False)

    def __post_init__(self) -> None:
        made: dict[str, Kind] = {}
        for step in self.steps:
            for name, kind in step.reads():
                have = made.get(name, kind if kind in ("value", "place") else None)
                if have != kind:
                    said = {"step": type(step).__name__, "makes": step.makes, "name": name}
                    wanted = Phrase(f"kind_{kind}")
                    if have:
                        raise ProgramError(Phrase("step_kind", **said, kind=wanted, have=Phrase(f"kind_{have}")))
                    valid = choices(name, [m for m, k in made.items() if k == kind][:12], what="valid_drawn")
                    raise ProgramError(Phrase("step_needs", **said, kind=wanted, valid=valid))
            if step.makes in made:
                raise ProgramError(Phrase("made_twice", makes=step.makes))
            made[step.makes] = step.kind

    @cached_property
    def made(self) -> frozenset[str]:
        """Names of all results of the steps."""
        return frozenset(s.makes for s in self.steps)

    @cached_property
    def makers(self) -> dict[str, Step]:
        """The steps by the names of their results."""
        return {s.makes: s for s in self.steps}

    @cached_property
    def givens(self) -> tuple[str, ...]:
        """Names of the required givens, in the order of first use."""
        names = (name for s in self.steps for name, _ in s.reads())
        return tuple(dict.fromkeys(n for n in names if n not in self.made))

    @cached_property
    def marks(self) -> StepsOf:
        """The steps that draw marks, by their plan: position, velocity, acceleration, force:2-3, …, force:1."""
        marks: StepsOf = {}
        for step in self.steps:
            if step.kind == "mark":
                marks.setdefault(plan_of(step.makes), []).append(step)
        return marks

    @cached_property
    def trials(self) -> frozenset[str]:
        """Marks that are only assumptions (friction): they serve to find which assumption holds."""
        return frozenset(s.makes for s in self.steps if isinstance(s, Cross) and s.supposed)

    @cached_property
    def readers(self) -> StepsOf:
        """The steps that use each name."""
        readers: StepsOf = {}
        for step in self.steps:
            for name in dict.fromkeys(name for name, _ in step.reads()):
                readers.setdefault(name, []).append(step)
        return readers

    @cached_property
    def vanishing(self) -> frozenset[str]:
        """Directions between two marks that only carry lengths proportional to their distance: where the marks coincide
        the length is zero, and any direction will do."""
        return frozenset(s.makes for s in self.steps if isinstance(s, Through) and self._vanishes(s))

    def _vanishes(self, ray: Through) -> bool:
        """Whether a direction is only turned, to lay off lengths proportional to the distance of its marks."""
        turns = self.readers.get(ray.makes, [])
        laid = [s for turn in turns for s in self.readers.get(turn.makes, [])]
        ends = {ray.start, ray.end}
        grow = all(isinstance(s, LayOff) and self._grows(s.length, ends) for s in laid)
        return bool(laid) and grow and all(isinstance(s, Turn) for s in turns)

    def _grows(self, value: str, ends: set[str]) -> bool:
        """Whether every part of a value has the distance of two marks as a factor."""
        made = self.makers.get(value)
        terms = made.terms if isinstance(made, Calculate) else ()
        factors = ([self.makers.get(name) for name, power in t.factors if power > 0] for t in terms)
        return bool(terms) and all(any(isinstance(f, Measure) and {f.start, f.end} == ends for f in x) for x in factors)

    def touched(
        self, changed: Iterable[str], instead: Container[str] = (), fixed: Container[str] = ()
    ) -> tuple[Step, ...]:
        """The steps to redraw when the givens ``changed`` change, or other steps are drawn ``instead`` of some; results
        in ``fixed`` stay, whatever they depend on."""
        dirty, steps = set(changed), []
        for step in self.steps:
            if step.makes in instead or any(name in dirty for name, _ in step.reads()):
                steps.append(step)
                if step.makes not in fixed:
                    dirty.add(step.makes)
        return tuple(steps)

    @cached_property
    def corners(self) -> frozenset[str]:
        """Marks at the end of a vector component (normal, Coriolis or a drive's): not points of a link."""
        return frozenset(s.makes for s in self.steps if s.quantity in ("normal", "coriolis", "relative"))

    def sliced(self, wanted: Iterable[str]) -> "Program":
        """The program without steps that the wanted names do not need; it still proves all it draws."""
        needed = set(wanted)
        for proof in self.proofs:  # a balancing load is always drawn with the other one that checks it
            if isinstance(proof, Twofold) and needed & {proof.one, proof.two}:
                needed |= {proof.one, proof.two}
        kept = []
        for step in reversed(self.steps):
            if step.makes in needed or step.guards:
                kept.append(step)
                needed.update(name for name, _ in step.reads())
        made = {s.makes for s in kept} | set(self.givens)
        return Program(tuple(reversed(kept)), tuple(p for p in self.proofs if made >= p.reads))
