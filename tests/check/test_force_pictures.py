"""Force polygons on pictures: what their ink does not tell is not said; what is printed at the pole is none of it."""

from __future__ import annotations

import random
from pathlib import Path

import pytest

cv2 = pytest.importorskip("cv2")

from tests import picture_corpus as corpus  # noqa: E402
from tests.confusion import easel, possible  # noqa: E402
from tests.helpers.drawings import Mistake  # noqa: E402
from tests.helpers.photographs import SCAN  # noqa: E402


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 4])
def test_what_letters_alone_tell_of_forces_in_one_line_is_not_said(seed: int, tmp_path: Path) -> None:
    """All forces of slider 5 are vertical: its mass drawn for its weight leaves the ink of a right polygon in another
    order."""
    one, rng, file = easel("assignment-12", "force:4-5"), random.Random(seed), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, Mistake("mass_for_weight", "G_5", 1), rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), SCAN, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict != "right"
    assert found.verdict != "right_as_seen" or "G_5" in found.unseen


@pytest.mark.slow
def test_a_long_force_among_others_of_one_line_whose_end_nothing_shows_is_told(tmp_path: Path) -> None:
    """A force of inertia drawn twice as long: its head and the next one's, back to back, are none that is seen."""
    one, rng, file = easel("assignment-12", "force:4-5"), random.Random("1009 11"), tmp_path / "p.jpg"
    alike = ("mass_for_weight", "weight_missing", "force_missing", "force_doubled")
    mistake = rng.choice([m for m in possible(one) if m.name.partition(":")[0] in alike])
    drawn = corpus.drawn(one, mistake, rng)
    assert drawn is not None and (mistake.name, mistake.where) == ("force_doubled", "I_5")
    corpus.picture(drawn, corpus.pole_of(one), corpus.KINDS[rng.choice(list(corpus.KINDS))](rng), rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict != "right" and {"I_5", "G_5"} & {*found.unseen}  # each may be the longer one


@pytest.mark.slow
@pytest.mark.parametrize("seed", [4, 5])
def test_a_mistake_of_half_a_millimetre_leaves_nothing_in_doubt(seed: int, tmp_path: Path) -> None:
    """The weight of a light crank, doubled: no paper shows that."""
    one, rng, file = easel("assignment-12", "force:1"), random.Random(seed), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, None, rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), SCAN, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert (
        found.verdict != "wrong" and "G_1" not in found.unseen
    )  # which of two alike forces goes up, letters alone tell


@pytest.mark.slow
@pytest.mark.parametrize("seed", [3, 4])
def test_what_ink_shows_of_a_mistake_within_a_hand_s_error_is_not_called_right(seed: int, tmp_path: Path) -> None:
    """A force of inertia of two millimetres drawn twice as long; its end is where the next vector begins."""
    one, rng, file = easel("sliding-driver", "force:2-3"), random.Random(seed), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, Mistake("force_doubled", "I_3", 0), rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), SCAN, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict != "right" and "I_3" in (*found.unseen, found.first_wrong)
