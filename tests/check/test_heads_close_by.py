"""Heads that lie close by others' heads and lines: their tips are seen apart, and nothing else is taken for one."""

from __future__ import annotations

import random

import pytest

pytest.importorskip("cv2")
import cv2
import numpy

from planes.check.vision.image.picture import by_scale
from planes.check.vision.marks.places import Seen, sheet_of
from planes.check.vision.strokes.arrow_tips import _supposed
from planes.check.vision.strokes.head_ink import but_strokes
from planes.check.vision.strokes.line_fitting import Fitted, Tip
from planes.check.vision.strokes.line_places import places_of
from tests.physical.paper import PX_PER_MM, Paper
from tests.physical.setting import Setting
from tests.physical.strokes import Hand

Vector = tuple[complex, complex]
POLE = 72 + 8j
WHITE = sheet_of(by_scale(numpy.full((200, 200), 245, numpy.uint8), PX_PER_MM))


def drawn(seed: int, setting: Setting, *vectors: Vector, past: float = 0.0) -> Seen:
    """A sheet of vectors with their heads, each on a line that runs on so far past both its ends."""
    rng = random.Random(seed)
    hand = Hand(Paper((80.0, 80.0), setting, rng), rng)
    for a, b in vectors:
        beyond = past * (b - a) / abs(b - a)
        if past:
            hand.line(a - beyond, b + beyond, 1.0, 0.7)
        hand.vector(a, b)
    grey = numpy.asarray(cv2.cvtColor(hand.paper.colour, cv2.COLOR_BGR2GRAY), numpy.uint8)
    seen = sheet_of(by_scale(grey, PX_PER_MM))
    assert seen is not None
    return seen


def line(a: complex, b: complex, clear: bool, head: float | None = None) -> Fitted:
    """A line that may have a head so far before its end."""
    length, along = abs(b - a), (b - a) / abs(b - a)
    found = Fitted(a, along, (0.0, 0.0, 0.0), 0.0, length, 0.05, 0.45, [True, clear])
    found.heads = [Tip(length - head, 1, b - head * along, 0.15, 3.4)] if head is not None else []
    return found


@pytest.mark.parametrize("apart", [1.2, 2.0])
def test_of_two_vectors_one_way_each_ends_where_it_does(apart: float) -> None:
    """Their lines run side by side; the farther's free end was taken for the nearer's."""
    far, near = line(0j, 50 + 0.3j, True), line(0j, 50 - apart + 0.9j, False, 0.1)
    assert WHITE is not None
    places = places_of([far, near], WHITE.ink)
    assert min(abs(p.z - far.ends[1]) for p in places) < 0.1
    assert min(abs(p.z - near.heads[0].z) for p in places) < 0.1


def test_strokes_of_a_head_are_no_line_and_a_short_vector_is_one() -> None:
    headed = line(0j, 50 + 0j, True, 0.0)
    stroke, short = line(49.8 + 0.3j, 46.4 + 0.9j, False), line(49.8 + 0.3j, 48.5 + 3.2j, True)
    assert but_strokes([headed, stroke, short]) == [headed, short]


def test_heads_are_looked_for_where_lines_cross_but_not_by_their_ends() -> None:
    """By an end other strokes lie as a head's would: a right plan was called wrong for a head seen there."""
    long, across, short = line(0j, 50 + 0j, True), line(30 - 9j, 30 + 9j, True), line(48 - 9j, 48 + 9j, True)
    supposed = {(round(x.tip), x.sign) for x in _supposed(long, [long, across, short], [])}
    assert supposed == {(0, -1), (50, 1), (30, 1), (30, -1)}


@pytest.mark.slow
def test_a_tip_in_another_head_is_not_at_its_far_side() -> None:
    """Of eight seeds seven are seen within half a millimetre; four were, of which one to a fifth."""
    d, e = POLE + (-60 + 17j), POLE + (-60.2 + 10j)
    tip = (d + e) / 2
    sheets = [drawn(seed, Setting(), (POLE, d), (POLE, e), (POLE, tip), (d, e)) for seed in range(1, 4)]
    assert all(min(abs(p.z - tip) for p in seen.places if p.ended) < 0.5 for seen in sheets)


@pytest.mark.slow
def test_heads_are_seen_where_construction_lines_cross() -> None:
    """Of a pen's barbs, whose sides are not straight, all of 24 are seen; four were, where no line ended."""
    corners = (12 + 60j, 62 + 60j, 62 + 30j)
    vectors = list(zip(corners, (*corners[1:], corners[0]), strict=True))
    setting = Setting(tool="pen", heads="barbs", tremor_mm=0.1)
    for seed in (1, 2):
        heads = [h.z for x in drawn(seed, setting, *vectors, past=7.0).lines for h in x.heads]
        assert len(heads) == 3
        assert all(min(abs(z - b) for z in heads) < 0.5 for _, b in vectors)
