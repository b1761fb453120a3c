"""What a program reckons, read back: which value was found from which."""

from dataclasses import dataclass
from functools import cached_property

from planes.drafting.steps import Step
from planes.drafting.steps.reckoning import Calculate
from planes.solving import Position


@dataclass(frozen=True)
class Reckoned:
    """The steps of a position's program."""

    position: Position

    @cached_property
    def steps(self) -> dict[str, Step]:
        """The steps by what they make."""
        return {s.makes: s for s in self.position.drawing.program.steps}

    def products(self, power: int) -> dict[str, tuple[str, str]]:
        """Values that are one other times (1), or through (-1), a length: both by name."""
        plain = (s for s in self.steps.values() if isinstance(s, Calculate) and len(s.terms) == 1)
        factors = ((s.makes, s.terms[0].factors) for s in plain)
        return {name: (f[0][0], f[1][0]) for name, f in factors if [p for _, p in f] == [1, power]}
