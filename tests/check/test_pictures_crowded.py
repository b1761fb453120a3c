"""Pictures whose lines run into each other: vectors upon vectors, ends beyond the pole, letters on a cross."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest

from tests.helpers.drawings import Mistake

pytest.importorskip("cv2")
from planes.check.vision.match.match_force import in_line
from planes.check.vision.search.laid_plan import LaidPlan
from planes.check.vision.search.plan_search import Search
from planes.check.vision.search.polygon_cover import Guess
from planes.check.vision.search.polygon_search import MOST_OF_ALL, SoughtPolygon
from planes.check.vision.strokes.line_places import Place
from tests import picture_corpus as corpus
from tests.check.test_pictures import looked
from tests.confusion import easel
from tests.helpers.photographs import PHONE, SCAN, Camera


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("sample", ["bntu-1", "bntu-2"])
@pytest.mark.parametrize("camera", [SCAN, PHONE], ids=["scan", "phone"])
def test_a_vector_that_goes_back_past_the_pole(sample: str, camera: Camera, tmp_path: Path) -> None:
    """Both vectors are within half a degree of each other; what shows beyond the pole is a head and a short line."""
    _, found = looked(easel(sample, "force:1"), camera, tmp_path, Mistake("not_closed", "F_10"))
    assert (found.verdict, found.mistake, found.first_wrong) == ("wrong", "not_closed", "F_10")
    assert looked(easel(sample, "force:1"), camera, tmp_path)[1].verdict == "right"


@pytest.mark.slow
def test_a_head_at_the_far_end_tells_two_vectors_from_one_gone_back(tmp_path: Path) -> None:
    """Velocities of a and b are nearly one line from the pole; rightly drawn the vector ab leads back along it."""
    one = easel("bntu-5", "velocity")
    assert looked(one, SCAN, tmp_path)[1].verdict == "right"
    _, found = looked(one, SCAN, tmp_path, Mistake("relative_from_pole", "b"))
    assert (found.verdict, found.mistake) == ("wrong", "relative_from_pole")


@pytest.mark.slow
def test_a_head_upon_another_vector(tmp_path: Path) -> None:
    """The vector of a mass centre ends halfway along a link's."""
    one = easel("kind-2-rrp", "velocity")
    for seed in (1, 2, 3):
        drawn, found = looked(one, SCAN, tmp_path, seed=seed)
        spots = {s.name: s.place for s in found.paper.spots}
        assert abs(spots["s1"] - spots["p"] - drawn.marks["s1"]) < 0.5


@pytest.mark.few(1)
@pytest.mark.parametrize("camera", [SCAN, PHONE], ids=["scan", "phone"])
def test_letters_that_touch_the_printed_cross(camera: Camera, tmp_path: Path) -> None:
    one, rng, file = easel("kind-3-rpr", "force:1"), random.Random(4), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, None, rng)
    assert drawn is not None
    words = [("I", 0.1 + 1.9j), ("p", -4.2 - 1.2j), ("_", 1.8 + 0.1j)]
    corpus.picture(replace(drawn, words=words), corpus.pole_of(one), camera, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict == "right", found.sentence.told("en")


def test_a_polygon_is_not_laid_for_ever() -> None:
    """When all ways together have taken so many steps, no more are tried, and that is told."""
    nowhere: Any = None
    polygon = SoughtPolygon(nowhere, nowhere, {}, taken=MOST_OF_ALL + 1)
    assert polygon.endless and polygon.lay(Guess({"G_2": 5j}, {"F_21": 1 + 0j}), 60.0) is None
    assert not SoughtPolygon(nowhere, nowhere, {}).endless


def test_a_mark_hidden_by_the_pole_s_cross_is_not_surely_at_the_pole() -> None:
    """One that should be 2 mm from it may be there; one that should be farther off is at the pole."""
    nowhere: Any = None
    pole = Place(0j, 0.06, frozenset())
    search = Search(nowhere, nowhere, pole, {}, {"velocity:e": 2 + 0j, "velocity:c": 9j}, [], nowhere)
    way = LaidPlan(0.0, {"velocity:e": pole, "velocity:c": pole})
    assert search.error_mm("velocity:e", way) == 2 and search.error_mm("velocity:c", way) == pole.error_mm


def test_forces_are_in_one_line_whichever_way_a_tiny_one_points() -> None:
    assert in_line([50j, -7.5j, 0.7 + 0j, -43j]) and not in_line([50j, -7.5j, 4 + 0j, -43j])
