"""Colours for teaching, on request: a vector, and the bar over its letter, in the hue of its kind.

The hues are those of Okabe and Ito, which the colour-blind can distinguish; the sky blue is darkened for paper.
"""

from collections.abc import Iterable
from dataclasses import replace

from planes.words.names import letter_of
from render.paper.marks import Arrow, Line, Mark

VELOCITY, ACCELERATION, LOAD, INERTIA, REACTION = "#0072B2", "#D55E00", "#009E73", "#B0548A", "#2E86B8"
_OF_LETTERS = {"v": VELOCITY, "a": ACCELERATION, "I": INERTIA, "Φ": INERTIA, "F": REACTION, "R": REACTION}
_OF_LETTERS |= dict.fromkeys(("G", "P"), LOAD) | {"tension S": VELOCITY, "compression S": ACCELERATION}
BAR, PART = " bar", " in part"  # ends of the names of bars over letters, and of vectors in a detail


def coloured(marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks, arrows and bars of vectors in the hues of their kinds."""
    return tuple(
        replace(m, style=f"{'vector' if m.name.endswith(BAR) else m.style} {hue}")
        if isinstance(m, (Arrow, Line))
        and (hue := _OF_LETTERS.get(letter_of(m.name.removesuffix(BAR).removesuffix(PART))))
        else m
        for m in marks
    )
