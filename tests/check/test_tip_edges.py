"""Where a head ends upon a line that runs on."""

from __future__ import annotations

import random

import pytest

pytest.importorskip("cv2")
import cv2
import numpy

from planes.check.vision.image.picture import by_scale
from planes.check.vision.strokes.ink import Ink, ink_of
from planes.check.vision.strokes.tip_edges import ending
from tests.physical.paper import PX_PER_MM, Paper
from tests.physical.setting import Setting
from tests.physical.strokes import Hand

START, TIP, END = 5 + 10j, 30 + 12j, 55 + 14j
WAY = (TIP - START) / abs(TIP - START)


def drawn(seed: int, headed: bool) -> Ink:
    """A line from start to end, with a vector upon its first half."""
    rng = random.Random(seed)
    hand = Hand(Paper((60.0, 24.0), Setting(), rng), rng)
    hand.line(START, END)
    if headed:
        hand.vector(START, TIP)
    grey = numpy.asarray(cv2.cvtColor(hand.paper.colour, cv2.COLOR_BGR2GRAY), numpy.uint8)
    return ink_of(by_scale(grey, PX_PER_MM))


def test_the_tip_of_a_head_upon_a_longer_line_is_where_its_ink_ends() -> None:
    """To a third of a millimetre, from wherever it seemed to be; of three, the ends of two at least are seen."""
    inks = [drawn(seed, headed=True) for seed in range(3)]
    found = [ending(ink, TIP + off * WAY, WAY, 0.45) for ink in inks for off in (-0.3, 0.0, 0.3)]
    seen = [z for z in found if z is not None]
    assert len(seen) >= 6 and max(abs(z - TIP) for z in seen) < 0.33


def test_a_plain_line_seems_to_end_nowhere_but_in_the_paper_s_grain() -> None:
    inks = [drawn(seed, headed=False) for seed in range(3)]
    assert sum(ending(ink, TIP, WAY, 0.45) is not None for ink in inks) <= 1
