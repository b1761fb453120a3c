"""Pictures of hand drawings of class III and IV, as scanners and telephones give them."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("cv2")
from tests.physical import higher


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(
    ("condition", "sample", "plan"),
    [
        ("scan", "class-four/tray", "acceleration"),
        ("phone", "class-three/guide", "velocity"),
        ("scan", "class-three/slider", "force:2-3-4-5"),
    ],
)
def test_a_right_one_is_right_and_a_mistake_is_found(condition: str, sample: str, plan: str, tmp_path: Path) -> None:
    made = [higher.row(one) for one in higher.pictures(condition, [plan], 2, tmp_path, [sample])]
    assert made[0] == ("right", "right")
    if plan.startswith("force"):  # of so many vectors a mistake is often unreadable, never right
        assert made[1] == ("wrong", "unreadable") or made[1][1].startswith("found")
    else:
        assert made[1][1].startswith("found at its step"), made


@pytest.mark.slow
def test_a_polygon_nobody_can_read_is_told_so_soon(tmp_path: Path) -> None:
    """It took twenty times the processor time of the same mechanism's plan of accelerations; now little more."""
    plans = ("acceleration", "force:2-3-4-5")
    press = (higher.pictures("scan", [plan], 1, tmp_path, ["class-three/press"]) for plan in plans)
    taken = [next(made) for made in press]
    (_, usual), (found, seconds) = map(higher.looked_at, taken)
    assert seconds < 4 * usual and (isinstance(found, str) or found.verdict != "wrong")
