"""The way to a limit: where it is found, what every method is worth there, and that no other is better than ours."""

from __future__ import annotations

from functools import cache

import numpy as np
import pytest

from planes.accuracy.comparison import Comparison
from planes.accuracy.digits import Digits
from planes.accuracy.limits import find_nearest_limit
from planes.accuracy.stability import DISTANCE_BINS, POSITIONS_PER_POINT, Approach, approach_nearest_limit
from planes.accuracy.variation import names_of_changed_givens, plans_with_changed_given
from planes.batch import compiled
from planes.drafting.drawing import Drawing
from planes.plans import Plans, plans_of
from planes.scene import load, loads
from tests.helpers import ROOT
from tests.helpers.other_programs import installed
from tests.solving.test_remedies import PARALLELOGRAM

SAMPLES = ROOT / "samples"
CRANK = """
planes: 1
frame: {points: {A: [0, 0]}}
links: {1: {points: {A: 0, B: 0.1}}}
drive: {link: 1, phi: 60, omega: 10}
"""
LIMITS = {  # sample: the given that moves, its value, which side works, what it is
    "six-link": ("angle_x_1", 129.5273973697464, 1, "end"),
    "sliding-driver": ("s", -0.1378775382679627, 1, "end"),
    "kind-1-rrr": ("l_BC", 0.5641881330345845, -1, "end"),
    "kind-2-rrp": ("l_BC", 0.06 + 0.015, 1, "end"),
    "kind-3-rpr": ("l_AB", 0.28, -1, "change"),
    "kind-4-prp": ("angle_x_1", 60.0, -1, "infinite"),
    "kind-5-rpp": ("angle_∥n-n", 0.0, 1, "infinite"),
}
OURS = ["method_scalar", "method_batch", *(["method_compiled"] if compiled.is_compiler_available() else [])]
SHOWN = ["six-link", "kind-1-rrr", "kind-2-rrp", "kind-4-prp"]


def plans(name: str) -> Plans:
    mechanism = load(str(SAMPLES / f"{name}.yaml")).mechanism
    assert mechanism
    return plans_of(mechanism)


@cache
def way(name: str) -> Approach:
    found = approach_nearest_limit(plans(name), installed())
    assert found
    return found


def ours(name: str) -> np.ndarray:
    return np.max([way(name).errors[key] for key in OURS], axis=0)


@pytest.mark.few(3)
@pytest.mark.parametrize("name", list(LIMITS))
def test_every_sample_comes_to_a_limit(name: str) -> None:
    """By its drive; a crank that turns all round by an altered length, a yoke by the angle of its slot."""
    limit = find_nearest_limit(Comparison(plans(name)))
    given, value, side, kind = LIMITS[name]
    assert limit and (limit.way.name, limit.side, limit.kind) == (given, side, kind)
    assert float(limit.value) == pytest.approx(value, rel=1e-13, abs=1e-40)


def test_a_parallelogram_comes_to_its_change_point() -> None:
    mechanism = loads(PARALLELOGRAM).mechanism
    assert mechanism
    limit = find_nearest_limit(Comparison(plans_of(mechanism)))
    assert limit and limit.kind == "change" and float(limit.value) % 180 == pytest.approx(0, abs=1e-12)


def test_a_bare_crank_comes_to_none() -> None:
    mechanism = loads(CRANK).mechanism
    assert mechanism
    assert approach_nearest_limit(plans_of(mechanism)) is None


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("name", SHOWN)
def test_what_is_claimed_is_honest_all_the_way(name: str) -> None:
    a = way(name)
    assert a.distances[0] > 0.09 and a.distances[-1] < 1.01e-14 and (np.diff(a.distances) < 0).all()
    assert (ours(name) <= a.claim).all() and np.median(a.claim / ours(name)) < 10
    assert (np.diff(a.sharpness) < 0).all() and (a.errors["method_digits"] < 1e-15).all()


@pytest.mark.few(0, slow=6)
@pytest.mark.parametrize("name", SHOWN)
@pytest.mark.parametrize("other", ["method_newton", "method_differences", "method_single"])
def test_no_other_way_to_reckon_is_better_anywhere(name: str, other: str) -> None:
    """Newton's iteration with exact derivatives has the errors of the same rounded givens: it is better now and then by
    luck, and not at the median."""
    found = way(name).errors[other]
    told = np.isfinite(found)
    times = found[told] / ours(name)[told]
    assert told.sum() > 3 and np.median(times) >= 1 and times.min() >= (0.2 if other == "method_newton" else 1)


@pytest.mark.parametrize("name", SHOWN)
@pytest.mark.parametrize("tool", ["pylinkage", "kinepy"])
def test_no_other_tool_is_better_anywhere(name: str, tool: str) -> None:
    pytest.importorskip(tool, reason=f"{tool} is among the extra [bench] only: pip install -e '.[bench]'")
    if tool == "pylinkage" and name in ("six-link", "kind-4-prp"):
        pytest.skip("pylinkage has no group with a moving or a second guide")
    found = next(errors for key, errors in way(name).errors.items() if tool in key)
    told = np.isfinite(found)
    assert told.sum() > 3 and (found[told] >= ours(name)[told]).all()


def test_lengths_that_vary_bring_their_own_complex_numbers_along() -> None:
    """A group of class III is begun from numbers of its lengths that have two parts: rows of many lengths keep both."""
    plans = plans_of(load(str(ROOT / "samples/class-three/mixtures/rr-pr-rp.yaml")).mechanism)
    variants = [plans_with_changed_given(plans, "l_OA", 0.08 * (1 + 0.01 * k)) for k in range(3)]
    names = names_of_changed_givens(plans.given, variants[-1].given)
    known = {name: np.array([x.given[name] for x in variants]) for name in names}
    assert any(np.iscomplexobj(v) for v in known.values())
    bench, drive = Comparison(plans, known, variants), np.full(3, 30.0)
    together = bench.columns_by_loop(drive, False)
    for k, x in enumerate(variants):
        alone = Comparison(x).columns_by_loop(drive[:1], False)[:, 0]
        assert together[:, k] == pytest.approx(alone, rel=1e-12, abs=1e-12)
        assert bench.columns_one_by_one(drive)[:, k] == pytest.approx(alone, rel=1e-11, abs=1e-12)


def test_every_position_is_drawn_once_with_fifty_digits(monkeypatch: pytest.MonkeyPatch) -> None:
    """The same drawing gives the truth and the sharpness."""
    digits: list[int] = []
    drawn = Comparison.draw_position

    def counted(self: Comparison, value: float, instrument: Digits | None = None, k: int = 0) -> Drawing:
        digits.extend([instrument.digits] if instrument else [])
        return drawn(self, value, instrument, k)

    monkeypatch.setattr(Comparison, "draw_position", counted)
    assert approach_nearest_limit(plans("kind-2-rrp"))
    assert digits.count(50) == digits.count(30) == POSITIONS_PER_POINT * len(DISTANCE_BINS)
