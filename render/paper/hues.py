"""Colours for teaching, on request: a vector, and the bar over its letter, in the hue of its kind.

The hues are those of Okabe and Ito, which the colour-blind can distinguish; the sky blue is darkened for paper.
"""

from collections.abc import Iterable
from dataclasses import replace

from planes.words.names import letter_of
from render.paper.marks import Arrow, Line, Mark

VELOCITY_COLOUR = "#0072B2"
ACCELERATION_COLOUR = "#D55E00"
LOAD_COLOUR = "#009E73"
INERTIA_COLOUR = "#B0548A"
REACTION_COLOUR = "#2E86B8"
_COLOUR_OF_LETTER = {
    "v": VELOCITY_COLOUR,
    "a": ACCELERATION_COLOUR,
    "I": INERTIA_COLOUR,
    "Φ": INERTIA_COLOUR,
    "F": REACTION_COLOUR,
    "R": REACTION_COLOUR,
}
_COLOUR_OF_LETTER |= dict.fromkeys(("G", "P"), LOAD_COLOUR) | {
    "tension S": VELOCITY_COLOUR,
    "compression S": ACCELERATION_COLOUR,
}
# ends of the names of bars over letters, and of vectors in a detail
BAR_NAME_SUFFIX = " bar"
DETAIL_NAME_SUFFIX = " in part"


def colour_vectors(marks: Iterable[Mark]) -> tuple[Mark, ...]:
    """The marks, arrows and bars of vectors in the hues of their kinds."""
    return tuple(
        replace(m, style=f"{'vector' if m.name.endswith(BAR_NAME_SUFFIX) else m.style} {hue}")
        if isinstance(m, (Arrow, Line))
        and (
            hue := _COLOUR_OF_LETTER.get(
                letter_of(m.name.removesuffix(BAR_NAME_SUFFIX).removesuffix(DETAIL_NAME_SUFFIX))
            )
        )
        else m
        for m in marks
    )
