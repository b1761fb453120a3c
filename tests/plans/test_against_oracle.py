"""Every number of the plans against the independent solver, on random mechanisms of all five kinds."""

from __future__ import annotations

import random
from collections import Counter
from typing import Any

import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tests.helpers.comparing import against, balanced, measured_closing_mm, standing
from tests.helpers.mechanisms import KINDS, Case, any_scene, make, mechanisms, shape_of

OPTIONS: dict[str, dict[str, Any]] = {
    "default": {},
    "friction": {"friction": True},
    "rest": {"rest": True},
    "sliding driver": {"sliding": True},
    "blunt": {"ill": 1e-3},
    "micrometre": {"size": 1e-6},
    "megametre": {"size": 1e6},
    "in order": {"swapped": False},
    "friction at rest": {"friction": True, "rest": True},
    "rubbing pins": {"pins": True},
    "rubbing pins and guides": {"pins": True, "friction": True},
    "rubbing pins, a sliding driver at rest": {"pins": True, "sliding": True, "rest": True},
    "sliding friction": {"friction": True, "sliding": True, "ill": 1e-2},
}
FEW = settings(max_examples=60)


def examine(case: Case, text: str | None = None) -> None:
    """All numbers, the lever, the power and the closing of the polygons of one mechanism."""
    drawn, wrong = against(case, text)
    for name, error in wrong.items():
        assert error * drawn.sharpest <= 1e-9, (name, error, drawn.sharpest)
    balanced(drawn)
    if "friction" not in case.scene:
        assert measured_closing_mm(drawn) <= 1e-9


@pytest.mark.slow
@pytest.mark.parametrize("options", OPTIONS.values(), ids=OPTIONS.keys())
def test_chains_of_up_to_three_groups(options: dict[str, Any]) -> None:
    @FEW
    @given(mechanisms(most=3, **options))
    def check(case: Case) -> None:
        assume(not standing(case))
        examine(case)

    check()


@pytest.mark.few(2)
@pytest.mark.parametrize("tenth", range(10))
def test_scenes_of_any_shape(tenth: int) -> None:
    """Two hundred scenes of fixed seeds; ``tests/nightly.py scenes`` goes through two thousand others."""
    for seed in range(20 * tenth, 20 * tenth + 20):
        case, text = any_scene(seed)
        if not standing(case):
            examine(case, text)


def test_the_shapes_that_are_drawn_hold_all_there_is() -> None:
    seen = Counter(shape for seed in range(200) for shape in shape_of(any_scene(seed)[0].scene))
    assert len(seen) == 13 and min(seen.values()) >= 5, seen
    assert seen["a driver of one point with a guide"] >= 15, seen


@pytest.mark.few(1)
@pytest.mark.parametrize("kind", KINDS)
def test_each_kind_alone(kind: str) -> None:
    @FEW
    @given(mechanisms(most=1, kinds=[kind]), st.just(kind))
    def check(case: Case, wanted: str) -> None:
        assert [g[0] for g in case.groups] == [wanted]
        examine(case)

    check()


@pytest.mark.few(8)
@pytest.mark.parametrize("first", KINDS)
@pytest.mark.parametrize("second", KINDS)
def test_every_pair_of_kinds(first: str, second: str) -> None:
    rng = random.Random(f"{first}{second}")
    for friction in (False, True):
        for _ in range(4):
            case = make(rng, [first, second], friction=friction)
            if not standing(case):
                examine(case)


@pytest.mark.slow
def test_the_scene_words_and_near_choose_the_same_assembly() -> None:
    for seed in range(30):
        rng = random.Random(seed)
        kinds = rng.choices(("RRR", "RRP", "RPR"), k=2)
        for assembly in ("near", "side"):
            examine(make(random.Random(seed), kinds, assembly=assembly))
