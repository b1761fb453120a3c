"""A plan on paper that tells nothing of how it was photographed: its marks tell the camera's tilt, or owe to it."""

import math
import random
from dataclasses import replace

import pytest

pytest.importorskip("cv2")

from planes.check.grading.paper import ReadMark, ReadPaper
from planes.check.outcome import check
from planes.check.vision.from_aside import fitted_camera_tilt, with_scale_and_tilt_errors
from planes.check.vision.image.lens import Lens
from planes.words.names import POLE_LABEL
from tests import confusion

BENCH = confusion.bench("six-link", "velocity")
TRUE = BENCH.true_marks
FIRST = TRUE["b"]
LENS = Lens(30 - 15j, 240.0, FIRST)
TILT = 0.20 - 0.16j  # 14° from straight above


def at(z: complex, tilt: complex) -> complex:
    """Where a place of a sheet is in a picture by a camera tilted by so much over the lens's middle (mm about that)."""
    u, steep = z - LENS.middle, abs(tilt) / math.hypot(1, abs(tilt))
    along = (u * tilt.conjugate()).real / (abs(tilt) or 1.0)
    flat = u - along * (1 - math.sqrt(1 - steep**2)) * tilt / (abs(tilt) or 1.0)
    return flat / (1 - along * steep / LENS.far)


def seen(z: complex, tilt: complex) -> complex:
    """The same from the pole, to the scale of the mark that was pointed to."""
    return (at(z, tilt) - at(0j, tilt)) * abs(FIRST) / abs(at(FIRST, tilt) - at(0j, tilt))


def over(tilt: complex) -> Lens:
    """That camera's lens over such a picture."""
    share = abs(FIRST) / abs(at(FIRST, tilt) - at(0j, tilt))
    return Lens(-at(0j, tilt) * share, LENS.far * share, seen(FIRST, tilt))


def spots(tilt: complex, seed: int, wrong: str = "") -> list[ReadMark]:
    """The marks of a right plan by a hand, one of them 9 mm off if it is named, as they are seen."""
    rng = random.Random(seed)
    drawn = {
        n: z + complex(rng.gauss(0, 0.25), rng.gauss(0, 0.25)) + (9j if n == wrong else 0) for n, z in TRUE.items()
    }
    drawn["b"] = FIRST
    return [ReadMark(POLE_LABEL, 0j), *(ReadMark(n, seen(z, tilt), 0.2) for n, z in drawn.items())]


def test_what_a_tilted_camera_sees_is_put_right() -> None:
    """To the scale and direction of the same mark, whatever place it is."""
    lens = over(TILT)
    turn = FIRST / lens.positions_under_tilt(seen(FIRST, TILT), TILT)
    assert abs(abs(turn) - 1) < 1e-3
    for z in (50 + 0j, -40 + 30j, 20 - 60j):
        assert abs(lens.positions_under_tilt(seen(z, TILT), TILT) * turn - z) < 1e-6
        assert abs(seen(z, TILT) - z) > 1.0


@pytest.mark.parametrize("wrong", ["", "c"])
def test_the_marks_tell_the_tilt(wrong: str) -> None:
    """One of them drawn wrongly tells no other, though then it may be too little to be believed; of a sheet seen
    straight they tell none."""
    for seed in range(4):
        tilt = fitted_camera_tilt(over(TILT), 0j, spots(TILT, seed, wrong), TRUE)
        assert (tilt is None and wrong) or (tilt is not None and abs(tilt - TILT) < 0.1)
        assert fitted_camera_tilt(LENS, 0j, spots(0j, seed, wrong), TRUE) is None


def test_marks_off_by_one_tilt_are_not_called_wrong() -> None:
    """The same places without a camera are not right; a mark that no tilt moves so is wrong all the same."""
    plain = ReadPaper("p.png", spots(TILT, 1), whole=False)
    aside = replace(
        plain, spots=[plain.spots[0], *(with_scale_and_tilt_errors(s, 0j, 0.005, over(TILT)) for s in plain.spots[1:])]
    )
    off = replace(
        plain,
        spots=[
            plain.spots[0],
            *(with_scale_and_tilt_errors(s, 0j, 0.005, over(TILT)) for s in spots(TILT, 1, "c")[1:]),
        ],
    )
    assert [check(BENCH.asked, paper).verdict for paper in (plain, aside, off)] == ["right_as_seen", "right", "wrong"]
