"""The message about a vector that is wrong for no known cause: its measured and its right value."""

import math

from planes.check.grading.handwork import Hand
from planes.drafting.steps import LayOff
from planes.words import Phrase, Written
from planes.words.names import POLE, at, kind_of, label_of, plan_of

SENTENCE = "mark", "vector", "mm", "angle", "true_mm", "true_angle"  # parts of the sentence


def off_sentence(hand: Hand, mark: str, off: complex) -> Phrase:
    """The message for a mark ``off`` (mm) the person's construction: its vector's size and angle, drawn and right."""
    start = drawn_from(hand, mark)
    if start is None:
        return Phrase("check_unclear", mark=label_of(mark), off=Written(f"{abs(off):.1f}"))
    own = hand.taken[mark].place - (0j if start == POLE else hand.taken[at(plan_of(mark), start)].place)
    numbers = [f(z) for z in (own, own - off) for f in (_size, _angle)]
    parts = zip(SENTENCE, (label_of(mark), vector_to(hand, mark), *map(Written, numbers)), strict=True)
    return Phrase("check_off_vector", **dict(parts))


def drawn_from(hand: Hand, mark: str) -> str | None:
    """The start of the vector to a mark, by its label: the pole or a mark that was read; None in a scheme."""
    if kind_of(plan_of(mark)) == "position":
        return None
    step = hand.program.makers[mark]
    start = label_of(step.start) if isinstance(step, LayOff) else POLE
    return start if start == POLE or at(plan_of(mark), start) in hand.taken else None


def vector_to(hand: Hand, mark: str) -> str:
    """The vector to a mark, by its name or its ends."""
    laid = isinstance(hand.program.makers[mark], LayOff)
    return label_of(mark) if laid else f"{POLE}{label_of(mark)}"


def _size(z: complex) -> str:
    return f"{abs(z):.1f}"


def _angle(z: complex) -> str:
    """From the x axis, in whole degrees."""
    degrees = round(math.degrees(math.atan2(z.imag, z.real)))
    return str(degrees).replace("-", "−")
