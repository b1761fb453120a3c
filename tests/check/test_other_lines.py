"""Lines on a plan that are none of its vectors: hatching, lines along each other, letters beside shafts."""

from __future__ import annotations

import random
from dataclasses import replace
from itertools import pairwise

import pytest

from planes.check.outcome import check
from planes.check.reading.arrowheads import assign_arrowheads
from planes.check.reading.construction_lines import misread_mark_share, vector_strokes
from planes.check.reading.hatching import LEAST_HATCH_ROWS, without_hatching
from planes.check.reading.matching import read_plan_marks
from planes.check.reading.parts import remove_letter_strokes
from planes.check.reading.strokes import Arrowhead, ReadDrawing, strokes_with_heads
from planes.check.reading.written import Stroke, Words
from tests import confusion
from tests.helpers.drawings import NONE, Hand, Mistake

TRIANGLE: list[Stroke] = [(0j, 40 + 0j), (40 + 0j, 10 + 30j), (0j, 10 + 30j)]


def hatched(rows: int, gap: float, uneven: float = 0.0) -> list[Stroke]:
    """Strokes side by side within the triangle, one of them in two pieces around a letter."""
    starts = [12 + 2j + 1j * (gap * k + uneven * (k % 2)) for k in range(rows)]
    return [(starts[0], starts[0] + 3), (starts[0] + 5, starts[0] + 9), *((z, z + 9) for z in starts[1:])]


@pytest.mark.parametrize("gap", [1.0, 3.5])
def test_hatching_is_no_line_of_a_plan(gap: float) -> None:
    sketch = ReadDrawing(strokes=[*TRIANGLE, *hatched(6, gap)], ways=[1, 1, 1, *[0] * 7])
    left = without_hatching(sketch)
    assert left.strokes == TRIANGLE and strokes_with_heads(left) == [0, 1, 2]


def test_level_hatching_drawn_a_little_up_and_down_is_of_one_direction() -> None:
    rows: list[Stroke] = [(12 + 2j + 3j * k, 21 + 2j + 3j * k + (-1) ** k * 0.0002j) for k in range(LEAST_HATCH_ROWS)]
    assert without_hatching(ReadDrawing(strokes=[*TRIANGLE, *rows])).strokes == TRIANGLE


def test_a_drawing_of_no_lines_has_no_hatching() -> None:
    nothing = ReadDrawing()
    assert without_hatching(nothing) is nothing


@pytest.mark.parametrize(("rows", "gap", "uneven"), [(LEAST_HATCH_ROWS - 1, 3.0, 0.0), (6, 3.0, 0.8), (6, 9.0, 0.0)])
def test_few_or_uneven_lines_side_by_side_are_no_hatching(rows: int, gap: float, uneven: float) -> None:
    sketch = ReadDrawing(strokes=[*TRIANGLE, *hatched(rows, gap, uneven)])
    assert without_hatching(sketch) is sketch


def test_lines_that_join_others_are_no_hatching() -> None:
    """Forces of one direction, each from the end of the one beside it."""
    rungs: list[Stroke] = [(2j * k, 30 + 2j * k) for k in range(6)]
    rails: list[Stroke] = [(s[k % 2], t[k % 2]) for k, (s, t) in enumerate(pairwise(rungs))]
    sketch = ReadDrawing(strokes=[*rungs[1:-1], *rails])
    assert without_hatching(sketch) is sketch


@pytest.mark.parametrize("back", [0.0, 0.5, 1.0])
def test_a_short_shaft_beside_a_name_is_no_letter(back: float) -> None:
    """A program draws it to the tip, into the head or to its back."""
    head = Arrowhead(5.5j, 1j, 2.75)
    shaft = (0j, 5.5j - 2.75j * back)
    sketch = ReadDrawing(strokes=[shaft, (1 + 0.5j, 1 + 3.5j)], words=[Words("F", 0.9 + 0.5j, 3.5, 2.0)], heads=[head])
    remove_letter_strokes(sketch)
    assign_arrowheads(sketch)
    assert sketch.strokes == [(0j, 5.5j)] and sketch.ways == [1]


@pytest.mark.parametrize("turned", [0.0, 0.01])
def test_construction_lines_along_each_other_run_on_from_their_vectors(turned: float) -> None:
    """Two vectors lie on one ray from the pole; their lines overshoot it alike."""
    u, w = 1 + 0j, 1 + 1j * turned
    vectors: list[Stroke] = [(0j, 30 * u), (0j, 50 * w), (0j, 30j), (30j, 30 * u), (30j, 50 * w)]
    lines: list[Stroke] = [(-5 * u, 38 * u), (-5 * w, 61 * w)]
    assert vector_strokes(ReadDrawing(strokes=[*vectors, *lines])) == [0, 1, 2, 3, 4]


@pytest.mark.parametrize("both", [False, True])
def test_vectors_without_heads_that_run_past_each_other_end_where_they_cross(both: bool) -> None:
    """The mass centre, whose vector lies along the crank's, ends nowhere; nothing is called wrong for that."""
    bench = confusion.bench("kind-1-rrr", "velocity")
    pole, places = 100 + 100j, {"p": 0j, **bench.true_marks}
    strokes: list[Stroke] = []
    for one, two in [*(("p", n) for n in bench.true_marks), *bench.vector_names]:
        a, b = places[one], places[two]
        over = (3 + len(strokes)) * (b - a) / abs(b - a)
        strokes.append((pole + a - both * over, pole + b + over))
    words = [Words(n, pole + z + 1 + 1j) for n, z in places.items()]
    sketch = ReadDrawing(strokes=strokes, words=words)
    paper = read_plan_marks(sketch, bench)
    read = {s.name: s.place - paper.spots[0].place for s in paper.spots}
    assert {"b", "c"} < set(read) and all(abs(read[n] - places[n]) < 0.1 for n in ("b", "c"))
    doubted = [replace(s, doubt=misread_mark_share(sketch)) for s in paper.spots]
    assert check(bench.asked, replace(paper, spots=doubted)).verdict != "wrong"


@pytest.mark.parametrize(
    ("name", "where", "told"), [("inertia_along_acceleration", "I_3", False), ("force_missing", "I_3", True)]
)
def test_a_wrong_polygon_without_heads_that_is_as_good_the_other_way_round_is_not_blamed(
    name: str, where: str, told: bool
) -> None:
    """Either the inertia is reversed, or all but it."""
    easel, bench, z = confusion.easel("bntu-5", "force:2-3"), confusion.bench("bntu-5", "force:2-3"), 100 + 100j
    vectors = easel.draw(Mistake(name, where, 0), Hand(NONE, random.Random(0)))[0]
    strokes, words = list[Stroke](), [Words("p", z + 3)]
    for n, v in vectors.items():
        strokes.append((z, z + v))
        words.append(Words(n, z + v / 2 + 1j * v / abs(v)))
        z += v
    assert bool(read_plan_marks(ReadDrawing(strokes=strokes, words=words), bench).spots) is told
