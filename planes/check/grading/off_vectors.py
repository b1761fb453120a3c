"""The message about a vector that is wrong for no known cause: its measured and its right value."""

import cmath
import math

from planes.check.grading.handwork import Hand
from planes.drafting.steps import LayOff
from planes.words import Phrase, Written
from planes.words.names import POLE_LABEL, full_mark_name, label_of, plan_kind, plan_of

PHRASE_PART_NAMES = "mark", "vector", "mm", "angle", "true_mm", "true_angle"  # parts of the sentence


def wrong_vector_phrase(hand: Hand, mark: str, off: complex) -> Phrase:
    """The message for a mark ``off`` (mm) the person's construction: its vector's size and angle, drawn and right."""
    start = vector_start_label(hand, mark)
    if start is None:
        return Phrase("check_unclear", mark=label_of(mark), off=Written(f"{abs(off):.1f}"))
    own = hand.taken[mark].place - (
        0j if start == POLE_LABEL else hand.taken[full_mark_name(plan_of(mark), start)].place
    )
    numbers = [text for z in (own, own - off) for text in (f"{abs(z):.1f}", _angle_text(z))]
    parts = zip(PHRASE_PART_NAMES, (label_of(mark), vector_label(hand, mark), *map(Written, numbers)), strict=True)
    return Phrase("check_off_vector", **dict(parts))


def vector_start_label(hand: Hand, mark: str) -> str | None:
    """The start of the vector to a mark, by its label: the pole or a mark that was read; None in a scheme."""
    if plan_kind(plan_of(mark)) == "position":
        return None
    step = hand.program.steps_by_result[mark]
    start = label_of(step.start) if isinstance(step, LayOff) else POLE_LABEL
    if start == POLE_LABEL or full_mark_name(plan_of(mark), start) in hand.taken:
        return start
    return None


def vector_label(hand: Hand, mark: str) -> str:
    """The vector to a mark, by its name or its ends."""
    laid = isinstance(hand.program.steps_by_result[mark], LayOff)
    return label_of(mark) if laid else f"{POLE_LABEL}{label_of(mark)}"


def _angle_text(z: complex) -> str:
    """From the x axis, in whole degrees."""
    return str(round(math.degrees(cmath.phase(z)))).replace("-", "−")
