"""Marks judged together: errors they share, forces reckoned from others, mistakes within the limits, shaky hands."""

from __future__ import annotations

import random

import numpy
import pytest

from planes.check.grading.grading import grade
from planes.check.grading.handwork import Hand, Miss
from planes.check.grading.judging import judging_order, misses_given_earlier
from tests import confusion
from tests.confusion import bench, easels, hand_in, run_all, told
from tests.helpers.drawings import SHAKY, Care, Mistake


def miss(off: complex, *change: complex) -> Miss:
    each = numpy.array(change)
    xx, xy, yy = (float(a @ b) for a, b in ((each.real, each.real), (each.real, each.imag), (each.imag, each.imag)))
    return Miss(off, (xx + 0.01, xy, yy + 0.01), each)


def test_what_one_mark_shows_of_an_error_is_expected_in_the_next() -> None:
    """Two marks off by the same error of 2 mm, twice as far in the second."""
    misses = {"a": miss(2 + 0j, 2, 0.3j), "b": miss(4 + 0j, 4, 0.3j), "c": miss(-4 + 0j, 4, 0.3j)}
    found = misses_given_earlier(misses, ["a", "b", "c"], 3.3)
    assert found["a"].off == misses["a"].off and misses["c"].sigmas < 1.1
    assert abs(found["b"].off) < 0.1 and found["b"].tolerance_mm(1.0) < 0.4 < misses["b"].tolerance_mm(1.0)
    assert found["c"].sigmas > 10  # where the error that is known of would never lead


def test_a_wrong_mark_tells_nothing_of_others() -> None:
    misses = {"a": miss(9 + 0j, 2, 0.3j), "b": miss(4 + 0j, 4, 0.3j)}
    assert misses_given_earlier(misses, ["a", "b"], 3.3)["b"].sigmas == pytest.approx(misses["b"].sigmas)
    assert misses_given_earlier(misses, ["b", "a"], 3.3)["a"].sigmas > misses["a"].sigmas


def test_a_reaction_reckoned_from_forces_is_judged_after_them() -> None:
    """F^t stands first in the polygon, but its moments are those of the forces laid off after it."""
    one = bench("six-link", "force:2-3")
    order = [m.rpartition(":")[2] for m in judging_order(one.program.steps, one.marks)]
    assert order == ["G_2", "I_2", "F_24", "G_3", "F_30t", "F_21t", "F_30n"]
    motion = bench("six-link", "acceleration")
    assert judging_order(motion.program.steps, motion.marks) == motion.marks


def test_the_persons_own_forces_sharpen_a_reckoned_one() -> None:
    """Where the scheme is drawn decides over F_24, I_2 and F_21t alike; the first two say what is left for F_21t."""
    one = bench("six-link", "force:2-3")
    easel = confusion.easel("six-link", "force:2-3")
    found = grade(one, hand_in(easel, None, Care(), random.Random(3)))
    assert found is not None
    alone = Hand(one.program, one.given, one.asked.skill, found.hand.taken).misses(one.marks)
    mark = "force:2-3:F_21t"
    assert found.judgement.misses[mark].largest_sigma_mm < 0.4 * alone[mark].largest_sigma_mm


@pytest.mark.parametrize(
    ("sample", "plan", "mistake", "mu_told"),
    [
        ("assignment-12", "force:2-3", Mistake("weight_missing", "G_3"), True),  # a vector of 1 mm
        (
            "assignment-12",
            "force:2-3",
            Mistake("force_doubled", "F_34"),
            False,
        ),  # only a weight of 1 mm tells the scale
        ("six-link", "force:2-3", Mistake("moment_sign:G_3", "F_30t"), True),
    ],
)
def test_small_signs_are_heeded(sample: str, plan: str, mistake: Mistake, mu_told: bool) -> None:
    easel = confusion.easel(sample, plan)
    for seed in range(3):
        found = grade(bench(sample, plan, mu_told), hand_in(easel, mistake, Care(), random.Random(seed)))
        assert found is not None and found.judgement.named is not None
        named = found.judgement.named
        assert (named.mistake, named.blames) == (mistake.name.partition(":")[0], mistake.where)


@pytest.mark.slow
def test_right_drawings_of_a_shaky_hand_are_seldom_refused() -> None:
    """The limits are for a hand as shaky as this one: of a hundred right drawings two may be refused."""
    refused = []
    for k, easel in enumerate(easels()):
        for n in range(8):
            found = grade(bench(easel.sample, easel.plan), hand_in(easel, None, SHAKY, random.Random(100 * k + n)))
            assert found is not None
            refused.append(found.judgement.first_wrong is not None)
    assert len(refused) == 8 * 55 and sum(refused) <= 0.02 * len(refused)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("first", range(2))
def test_confusion_table_of_a_shaky_hand(capsys: pytest.CaptureFixture[str], first: int) -> None:
    found = run_all(1, SHAKY, list(easels())[first::2])
    with capsys.disabled():
        print("\na shaky hand\n" + told(found))
    assert found.mistakes > 300
    assert found.found >= 0.98 * found.mistakes
    assert found.blamed >= 0.95 * found.mistakes
    assert found.named >= 0.90 * found.mistakes
    assert found.innocent_blamed <= 0.02 * found.innocent


def test_a_drawing_of_the_tests_is_the_solvers_when_the_hand_is_steady() -> None:
    """The reaction found from a person's own moments is the true one where nothing is drawn amiss."""
    for easel in easels():
        if easel.plan.startswith("force"):
            marks, _ = easel.draw(None, confusion.Hand(confusion.NONE, random.Random(0)))
            assert abs(sum(marks.values())) < 1e-6 * max(map(abs, marks.values()))
            found = grade(bench(easel.sample, easel.plan), hand_in(easel, None, confusion.NONE, random.Random(0)))
            assert found is not None and max(m.sigmas for m in found.judgement.misses.values()) < 0.7
