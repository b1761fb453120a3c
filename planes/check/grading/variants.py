"""An assumed mistake: some steps of a program done differently, and their result."""

from collections.abc import Container, Iterator, Mapping
from itertools import chain

from planes.drafting.drawing import draw_steps
from planes.drafting.program import Program
from planes.drafting.steps import Same, Step
from planes.drafting.tools import Env, Tool
from planes.words import Phrase, Told, Written
from planes.words.frozen import field, frozen

Steps = tuple[Step, ...]
Swaps = Mapping[str, Steps]


@frozen
class Variant:
    """Some steps done differently: ``swaps`` replaces the step that makes the name by steps of which the last makes it.

    ``givens`` are values changed or added. ``blames`` is the mark at which the mistake is made.
    """

    mistake: str
    blames: str
    swaps: Swaps = field(default_factory=dict)
    givens: Env = field(default_factory=dict)
    weight: float = 1.0
    about: Mapping[str, Told | Written] = field(default_factory=dict)  # names for the sentence

    @property
    def omits(self) -> bool:
        """Whether it leaves out the vector to its mark, so that the mark is where the vector begins."""
        return any(isinstance(step, Same) and step.label == self.blames for step in chain(*self.swaps.values()))

    @property
    def sentence(self) -> Phrase:
        """The mistake and its correction."""
        return Phrase(f"mistake_{self.mistake}", **{"mark": self.blames, **self.about})

    def draw_affected_steps(self, program: Program, things: Env, tool: Tool, fixed: Container[str]) -> Env:
        """The result of the affected steps from elements drawn without it; ``fixed`` marks stay in place."""
        steps = program.steps_to_redraw(self.givens, self.swaps, fixed)
        return draw_steps(steps, {**things, **self.givens}, tool, self.swaps)


Variants = Iterator[Variant]
