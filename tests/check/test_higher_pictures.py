"""Pictures of hand drawings of class III and IV, as scanners and telephones give them."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest

pytest.importorskip("cv2")
from tests import confusion
from tests.physical import higher

SAMPLES = ("class-three/slider", "class-three/guide", "class-four/tray", "class-four/press")


@pytest.mark.slow
@pytest.mark.parametrize("condition", higher.CONDITIONS)
@pytest.mark.parametrize("plan", ["velocity", "acceleration", "force:2-3-4-5"])
def test_right_ones_are_right_and_mistakes_are_found(condition: str, plan: str, tmp_path: Path) -> None:
    made = Counter(higher.row(one) for one in higher.pictures(condition, [plan], 2, tmp_path, SAMPLES))
    told = {verdict for what, verdict in made if what == "right"}
    assert told <= ({"right"} if plan != "force:2-3-4-5" else {"right", "right_as_seen", "unreadable"})
    assert ("wrong", "right") not in made
    found = sum(times for (what, verdict), times in made.items() if what == "wrong" and verdict.startswith("found"))
    assert found >= sum(times for (what, _), times in made.items() if what == "wrong") / 2


@pytest.mark.slow
@pytest.mark.parametrize("sample", ["class-three/slider", "class-three/guide"])
def test_a_force_polygon_drawn_as_its_equation_runs_is_read(sample: str, tmp_path: Path) -> None:
    made = [higher.row(one) for one in higher.pictures("scan", ["force:2-3-4-5"], 1, tmp_path, [sample])]
    assert made == [("right", "right")]


@pytest.mark.slow
def test_a_page_is_read_in_three_seconds(tmp_path: Path) -> None:
    """On one idle core; as many more beside others' work."""
    taken = next(higher.pictures("scan", ["acceleration"], 1, tmp_path, ["class-four/tray"]))
    confusion.bench("class-four/tray", "acceleration")
    assert min(higher.looked_at(taken)[1] for _ in range(3)) < 6.0
