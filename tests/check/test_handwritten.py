"""Names written by hand: read among a plan's names, and what they say of vectors."""

from __future__ import annotations

import random
from collections.abc import Sequence

import pytest

pytest.importorskip("cv2")
import cv2

from planes.check.evidence.handwritten import Erased, HandWord, HandWords, read_words_beside_lines
from planes.check.evidence.ink import drawing_ink
from planes.check.vision.image.picture import rectify_by_scale
from tests.physical.letters import Writer
from tests.physical.paper import PX_PER_MM, Paper
from tests.physical.setting import Setting
from tests.physical.strokes import Hand

NAMES = ("F_21t", "F_30", "G_2", "I_2", "I_3", "P_3")


def written(style: str, seed: int, *names: str, known: Sequence[str] = NAMES) -> list[HandWord]:
    """Names in a column beside a vector, as they are read among some."""
    rng = random.Random(seed)
    paper = Paper((60.0, 15.0 * len(names) + 10), Setting(letters=style), rng)
    hand = Hand(paper, rng)
    hand.vector(12 + 5j, 12 + 1j * (paper.size[1] - 5))
    for k, name in enumerate(names):
        Writer(hand, rng).word(name, 20 + 1j * (8 + 15 * k))
    flat = rectify_by_scale(cv2.cvtColor(paper.colour, cv2.COLOR_BGR2GRAY), PX_PER_MM)
    low, high = (flat.corner + z for z in (12 + 5j, 12 + 1j * (paper.size[1] - 5)))
    line = Erased([low, (low + high) / 2, high], 0.8, [(high, -4j)])
    return sorted(read_words_beside_lines(drawing_ink(flat), [line], known).words, key=lambda w: w.low.imag)


@pytest.mark.parametrize("style", ["neat", "wild", "indices"])
def test_names_are_read_among_those_of_a_plan(style: str) -> None:
    """Of names in an even and in a wild hand, and with small indices, half are told at least, and none for another."""
    read = [max(w.likely.items(), key=lambda one: one[1]) for w in written(style, 1, *NAMES) if len(w.likely)]
    sure = [name for name, likely in read if likely > 0.7]
    assert len(sure) >= 3 and sure == [name for name in NAMES if name in sure]


def test_a_prime_is_of_its_name() -> None:
    """Names of accelerations, of a letter and a prime: two of three are told, in several hands."""
    names = ("a'", "b'", "e'", "s3'", "n_B")
    read = [w for seed in range(3) for w in written("neat", seed, *names, known=names)]
    told = [max(w.likely, key=lambda n: w.likely[n]) for w in read if max(w.likely.values()) > 0.5]
    assert len(told) >= 10


def test_what_is_no_name_of_the_plan_is_read_as_none() -> None:
    assert all(max(w.likely.values()) < 0.7 for w in written("neat", 2, "M_48", "N_77", "K_95"))


def test_a_name_speaks_for_the_vector_it_stands_by_and_never_loudly() -> None:
    """What was read costs hardly anything by its vector, something elsewhere; what was not read, nothing."""
    words = HandWords([HandWord(0j, 8 + 4j, {"G_2": 0.9, "G_3": 0.1})])
    assert words.vector_name_cost("G_2", -2j, 10 - 2j) < 0.05 and words.vector_name_cost("F_30", 50j, 90j) == 0
    assert 1 < words.vector_name_cost("G_2", 50j, 90j) < 2.6 and words.vector_name_cost("G_3", 50j, 90j) < 0.2
