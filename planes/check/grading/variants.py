"""A mistake supposed: some steps of a program done another way, and what they make."""

from collections.abc import Container, Mapping

from planes.drafting.drawing import draw_steps
from planes.drafting.program import Program
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Point
from planes.words import Phrase, Told, Written
from planes.words.frozen import field, frozen


@frozen
class Variant:
    """Some steps done another way: ``swaps`` puts steps in the place of the one that makes the name (the last of
    them makes it too); ``givens`` are values changed or added. ``blames`` is the mark the mistake is made at."""

    mistake: str
    blames: str
    swaps: Mapping[str, tuple[Step, ...]] = field(default_factory=dict)
    givens: Mapping[str, Point] = field(default_factory=dict)
    weight: float = 1.0
    about: Mapping[str, Told | Written] = field(default_factory=dict)  # names for the sentence

    @property
    def sentence(self) -> Phrase:
        """What the mistake is, and how to mend it."""
        return Phrase(f"mistake_{self.mistake}", **{"mark": self.blames, **self.about})

    def drawn(self, program: Program, things: Env, tool: Tool, fixed: Container[str]) -> Env:
        """What the steps it touches make of things drawn without it; marks that are ``fixed`` stay where they are."""
        steps = program.touched(self.givens, self.swaps, fixed)
        return draw_steps(steps, {**things, **self.givens}, tool, self.swaps)
