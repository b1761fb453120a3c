"""A plan drawn again on lines of known places: what is right, what is wrong by any size, and what nobody could tell."""

from __future__ import annotations

import cmath
import math
import random

import numpy as np
import pytest

pytest.importorskip("cv2")
from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining.explained import Explanation
from planes.check.explaining.plan_lines import Hypothesis, PlanLines
from planes.check.explaining.sought_pole import likeliest_pole
from planes.check.grading.prepared_plan import Asked, prepare
from planes.scene import load
from planes.words.names import POLE_LABEL
from tests import confusion
from tests.helpers.line_ink import drawn
from tests.other_means import Spoilt, lines_of, places

SIX = confusion.bench("six-link", "velocity")
ACCELERATION, FORCE = (confusion.bench("six-link", plan) for plan in ("acceleration", "force:2-3"))
RRR_FORCE = confusion.bench("kind-1-rrr", "force:2-3")


def ink_of(bench: confusion.PreparedPlan, spoilt: Spoilt, turn: complex = 1 + 0j, pole: complex = 0j) -> SheetInk:
    """A plan's lines with their heads, drawn by a steady hand."""
    marks = places(bench, spoilt, random.Random(1))
    assert marks is not None
    at = {POLE_LABEL: pole, **{n: pole + z * turn for n, z in marks.items()}}
    strokes = []
    for a, b in ((at[a], at[b]) for a, b in lines_of(bench) if abs(at[b] - at[a]) > 0.5):
        u = (b - a) / abs(b - a)
        strokes += [(a, b), *((b, b - 3.5 * u * cmath.rect(1, s * 0.26)) for s in (1, -1) if abs(b - a) > 4)]
    return drawn(strokes)


def explained(bench: confusion.PreparedPlan, spoilt: Spoilt = Spoilt(), turn: complex = 1 + 0j) -> Explanation:  # noqa: B008
    return Explanation(PlanLines(bench), ink_of(bench, spoilt, turn), 0j)


@pytest.mark.few(2)
@pytest.mark.parametrize("bench", [SIX, ACCELERATION, FORCE], ids=["velocity", "acceleration", "force"])
def test_the_right_plan_is_the_likeliest_and_its_marks_are_where_they_were_put(bench: confusion.PreparedPlan) -> None:
    seen, put = explained(bench), places(bench, Spoilt(), random.Random(1))
    assert (
        seen.likeliest_drawing is seen.right_drawing
        and seen.chance_wrong < 0.05
        and seen.likeliest_drawing.cover > 0.97
        and put
    )
    if bench is not FORCE:
        off = {s.name: abs(s.place - put[s.name]) for s in seen.seen_marks() if s.name != POLE_LABEL}
        assert len(off) == len(bench.marks) and sorted(off.values())[len(off) // 2] < 0.3


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("bench", "mark", "moved"),
    [(SIX, "b", 17 + 0j), (SIX, "c", 9 - 9j), (ACCELERATION, "n_CB", 8 + 8j), (FORCE, "P_3", -12j)],
)
def test_a_mistake_of_any_size_is_found_at_its_mark(bench: confusion.PreparedPlan, mark: str, moved: complex) -> None:
    if mark not in {m.split(":")[-1] for m in bench.marks}:
        mark = next(m.split(":")[-1] for m in bench.marks[1:])
    seen = explained(bench, Spoilt("length", (mark,), (moved,)))
    assert seen.likeliest_drawing is seen.wrong_drawing and seen.chance_wrong > 0.95
    assert seen.likeliest_drawing.hypothesis.mark in (mark, *[m.split(":")[-1] for m in bench.marks][-2:])


def test_a_plan_mirrored_as_a_whole_is_said_to_be() -> None:
    seen = explained(SIX, Spoilt("mirrored", whole=(1 + 0j, True)))
    (fault,) = seen.transformed_plan_faults()
    assert fault.mistake == "plan_mirrored" and "mirrored" in fault.fault.told("en")
    true = {POLE_LABEL: 0j, **SIX.true_marks}
    assert all(abs(s.place - true[s.name]) < 1.2 for s in seen.seen_marks())


def test_a_sheet_printed_smaller_is_no_mistake() -> None:
    seen = explained(SIX, turn=1 / 0.97 + 0j)
    assert seen.likeliest_drawing is seen.right_drawing


def test_a_pole_nobody_told_of_is_where_the_plan_begins() -> None:
    pole = 31 + 47j
    found = likeliest_pole(PlanLines(SIX), ink_of(SIX, Spoilt(), pole=pole))
    assert found is not None and abs(found - pole) < 1.5


def test_sides_laid_in_another_order_are_right() -> None:
    plan = PlanLines(FORCE)
    row = plan.mark_positions(Hypothesis(), {}, 1)
    assert row is not None
    order = (1, 0, *range(2, len(plan.sides)))
    a, b = plan.line_ends(row, order)
    ink = drawn([(complex(p), complex(q)) for p, q in zip(a[0], b[0], strict=True) if abs(p - q) > 0.5])
    seen = Explanation(plan, ink, 0j)
    assert seen.likeliest_drawing is seen.right_drawing and seen.likeliest_drawing.cover > 0.95


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(10))
def test_sides_laid_by_hand_in_any_order_are_right(seed: int) -> None:
    """Every side ends half a millimetre beside its place, and the next begins there: long sides are not sought first,
    and none is laid over ink that another has drawn."""
    rng, plan = random.Random(seed), PlanLines((FORCE, RRR_FORCE)[seed % 2])
    row = plan.mark_positions(Hypothesis(), {}, 1)
    assert row is not None
    a, b = plan.line_ends(row)
    sides, order = (b - a)[0, : len(plan.sides)].tolist(), [*range(len(plan.sides))]
    rng.shuffle(order)
    path = [0j]
    for k in order[:-1]:
        path.append(path[-1] + sides[k] + complex(rng.gauss(0, 0.4), rng.gauss(0, 0.4)))
    ink = drawn([*zip(path, [*path[1:], 0j], strict=True)])
    seen = Explanation(plan, ink, 0j)
    assert seen.likeliest_drawing is seen.right_drawing


def test_many_drawings_at_once_are_those_drawn_one_by_one() -> None:
    plan, rng = PlanLines(ACCELERATION), np.random.default_rng(3)
    moves = {n: rng.normal(0, 3, 5) + 1j * rng.normal(0, 3, 5) for n in plan.names}
    rows = plan.mark_positions(Hypothesis(), moves, 5)
    assert rows is not None
    for k in range(5):
        one = plan.mark_positions(Hypothesis(), {n: z[k : k + 1] for n, z in moves.items()}, 1)
        assert one is not None and np.abs(one[0] - rows[k]).max() < 1e-9


def test_guides_and_signs_of_a_scheme_are_its_own() -> None:
    bench = prepare(Asked(load(confusion.SAMPLES / "crank-slider.yaml"), "position"))
    plan = PlanLines(bench)
    row = plan.mark_positions(Hypothesis(), {}, 1)
    assert row is not None
    a, b, middles, reach = plan.extra_symbols(row)
    assert a.shape == (1, 1) and math.isclose(abs(b - a)[0, 0], 60.0)
    assert middles.shape == (1, len(reach)) and reach.max() > reach.min()
