"""The message about a vector that is wrong for no known cause: its measured and its right value."""

import cmath
import math

from planes.check.grading.handwork import Hand
from planes.drafting.steps import LayOff
from planes.words import Phrase, Written
from planes.words.names import POLE_LABEL, Mark

PHRASE_PART_NAMES = "mark", "vector", "mm", "angle", "true_mm", "true_angle"  # parts of the sentence


def wrong_vector_phrase(hand: Hand, mark: Mark, off: complex) -> Phrase:
    """The message for a mark ``off`` (mm) the person's construction: its vector's size and angle, drawn and right."""
    start = vector_start_label(hand, mark)
    if start is None:
        return Phrase("check_unclear", mark=mark.label, off=Written(f"{abs(off):.1f}"))
    own = hand.taken[mark].place - (0j if start == POLE_LABEL else hand.taken[mark.plan.mark(start)].place)
    numbers = [text for z in (own, own - off) for text in (f"{abs(z):.1f}", _angle_text(z))]
    parts = zip(PHRASE_PART_NAMES, (mark.label, vector_label(hand, mark), *map(Written, numbers)), strict=True)
    return Phrase("check_off_vector", **dict(parts))


def vector_start_label(hand: Hand, mark: Mark) -> str | None:
    """The start of the vector to a mark, by its label: the pole or a mark that was read; None in a scheme."""
    if mark.plan.kind == "position":
        return None
    step = hand.program.steps_by_result[mark]
    start = step.start.label if isinstance(step, LayOff) else POLE_LABEL
    if start == POLE_LABEL or mark.plan.mark(start) in hand.taken:
        return start
    return None


def vector_label(hand: Hand, mark: Mark) -> str:
    """The vector to a mark, by its name or its ends."""
    laid = isinstance(hand.program.steps_by_result[mark], LayOff)
    return mark.label if laid else f"{POLE_LABEL}{mark.label}"


def _angle_text(z: complex) -> str:
    """From the x axis, in whole degrees."""
    return str(round(math.degrees(cmath.phase(z)))).replace("-", "−")
