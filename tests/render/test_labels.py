"""Label places: no overlap, near what is named, the same every time."""

from __future__ import annotations

import cmath
import random
from dataclasses import replace

import pytest

import render.labels as labels_room
from render.labels import Label, board, place_labels
from render.labels.candidates import Candidates, count_clashes
from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text, move_mark
from render.paper.typeset import text_box_corners
from tests.helpers.conflicts import conflicts

FIELD = (0.0, 0.0, 420.0, 297.0)


def scene(labels: int, segments: int, seed: int) -> tuple[list[Label], list[Mark]]:
    """Labels of ends and of segments among arrows and lines strewn over an A3 sheet."""
    dice = random.Random(seed)
    marks: list[Mark] = []
    wanted: list[Label] = []
    for k in range(segments):
        start = complex(dice.uniform(60, 360), dice.uniform(60, 237))
        end = start + cmath.rect(dice.uniform(10, 60), dice.uniform(0, 6.28))
        marks.append(Arrow(start, end) if k % 2 else Line((start, end), "thin"))
        if k < labels:
            wanted.append(Label(f"v_{{C{k}}}", (start, end), 3.5) if k % 2 else Label(f"B_{{{k}}}", end))
    return wanted, marks


def distance(text: Text, point: complex) -> float:
    box = text_box_corners(text)
    dx = max(box[0].real - point.real, 0, point.real - box[1].real)
    dy = max(box[0].imag - point.imag, 0, point.imag - box[2].imag)
    return abs(complex(dx, dy))


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", range(3))
def test_a_crowded_sheet_has_no_conflict(seed: int) -> None:
    labels, marks = scene(60, 90, seed)
    placed = place_labels(labels, marks, FIELD)
    assert conflicts(placed.texts, [*marks, *placed.leaders], FIELD) == ()
    assert [text.text for text in placed.texts] == [label.text for label in labels]
    assert len(placed.leaders) <= 12
    assert place_labels(labels, marks, FIELD) == placed


def test_a_hundred_labels() -> None:
    labels, marks = scene(100, 200, 5)
    placed = place_labels(labels, marks, FIELD)
    assert len(conflicts(placed.texts, [*marks, *placed.leaders], FIELD)) <= 1


def test_labels_stand_near_what_they_name() -> None:
    a, b, c = 50 + 50j, 90 + 80j, 140 + 50j
    marks: list[Mark] = [Line((a, b, c)), *(Arc(z, 1.5, fill="paper") for z in (a, b, c))]
    labels = [Label(name, z, clear=1.8) for name, z in (("A", a), ("B", b), ("C", c))]
    placed = place_labels([*labels, Label("2", (b, c))], marks, (0, 0, 200, 150))
    assert conflicts(placed.texts, marks) == () and placed.leaders == ()
    for text, point in zip(placed.texts, (a, b, c), strict=False):
        assert 1.8 < distance(text, point) < 5.5


@pytest.mark.parametrize("side", [1, 1j, -1, -1j])
def test_the_wished_side_is_taken_when_it_is_free(side: complex) -> None:
    (text,) = place_labels([Label("S_{2}", 50 + 50j, side=side)], [Arc(50 + 50j, 0.8, fill="ink")]).texts
    box = text_box_corners(text)
    middle = sum(box) / 4 - 50 - 50j
    assert (middle / side).real > 2 and abs((middle / side).imag) < 1


def test_a_label_boxed_in_gets_a_leader() -> None:
    around: list[Mark] = [Arc(50 + 50j, r, style="thin") for r in (2.0, 4.0, 6.0, 8.0, 10.0)]
    placed = place_labels([Label("S_{2}", 50 + 50j)], around, (0, 0, 100, 100))
    (leader,) = placed.leaders
    assert abs(leader.points[1] - 50 - 50j) < 1
    assert conflicts(placed.texts, [*around, *placed.leaders], (0, 0, 100, 100)) == ()


def test_what_is_told_elsewhere_makes_way_where_there_is_no_room_for_all() -> None:
    field = (0.0, 0.0, 14.0, 14.0)
    points = [Label(name, complex(7, 3 + 4 * k), clear=1.0) for k, name in enumerate("BCD")]
    arms = [Label(f"h_{{{k}}}", 7 + 7j, 3.5, name=f"arm {k}") for k in range(9)]
    every = place_labels([*points, *arms], [], field)
    assert len(every.texts) == 12 and conflicts(every.texts, [], field) != ()
    some = place_labels([*points, *(replace(arm, told=True) for arm in arms)], [], field)
    assert conflicts(some.texts, some.leaders, field) == ()
    assert {"B", "C", "D"} <= {t.text for t in some.texts} and 3 < len(some.texts) < 12
    there = place_labels([*points[:1], replace(arms[0], told=True)], [], (0, 0, 40, 40))
    assert len(there.texts) == 2


def test_labels_of_one_point_do_not_read_as_one() -> None:
    placed = place_labels([Label("b", 50 + 50j), Label("c", 50 + 50j), Label("p", 50 + 50j)], [])
    assert conflicts(placed.texts) == ()


@pytest.mark.parametrize("count", [40, 160])
def test_the_work_grows_with_the_labels_and_not_with_their_square(count: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """Labels in four heaps as crowded as one: every place is held against its own heap alone."""
    compared = 0

    def counted(some: Candidates, others: Candidates) -> object:
        nonlocal compared
        compared += len(some.wish) * len(others.wish)
        return count_clashes(some, others)

    monkeypatch.setattr(board, "count_clashes", counted)
    labels, marks = scene(40, 60, 3)
    heaps = [600 * k for k in range(count // 40)]
    shifted = [
        replace(x, at=x.at + by if isinstance(x.at, complex) else (x.at[0] + by, x.at[1] + by))
        for by in heaps
        for x in labels
    ]
    place_labels(shifted, [move_mark(m, by) for by in heaps for m in marks])
    assert compared < 6_000 * count


@pytest.mark.slow
def test_labels_that_cannot_all_stand_are_given_up_after_so_many_moves(monkeypatch: pytest.MonkeyPatch) -> None:
    made = []
    monkeypatch.setattr(labels_room, "Board", lambda *given: made.append(board.Board(*given)) or made[-1])
    crowd = [Label(f"F_{{{k}}}", complex(k % 8, k // 8)) for k in range(64)]
    place_labels(crowd, [], (-10, -10, 20, 20))
    assert made[0].moves < board.MOST_MOVES + 20 * len(crowd)


@pytest.mark.few(1)
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_neighbours_stand_apart_by_more_than_letters_of_one_word(seed: int) -> None:
    """Of 100 labels on a crowded sheet no two in one line are nearer than 0.6 of their letters' height."""
    labels, marks = scene(100, 120, seed)
    boxes = [(text.height, text_box_corners(text)) for text in place_labels(labels, marks, FIELD).texts]
    for k, (high, one) in enumerate(boxes):
        for other_high, other in boxes[:k]:
            in_line = min(one[2].imag, other[2].imag) > max(one[0].imag, other[0].imag)
            apart = max(other[0].real - one[2].real, one[0].real - other[2].real)
            assert not in_line or apart >= 0.6 * min(high, other_high) - 1e-9


def test_the_number_of_a_link_is_underlined_and_its_leader_ends_in_a_dot() -> None:
    bar = (50 + 50j, 70 + 50j)
    fence: list[Mark] = [Line((complex(30, y), complex(90, y)), "thin") for y in range(38, 63) if y != 50]
    placed = place_labels([Label("2", bar, underlined=True), Label("K", 60 + 55.5j)], [Line(bar), *fence])
    lines = [m for m in placed.signs if isinstance(m, Line)]
    dots = [m for m in placed.signs if isinstance(m, Arc)]
    box = text_box_corners(placed.texts[0])
    assert len(lines) == 1 and lines[0].points[0].imag < box[0].imag
    assert lines[0].points[0].real < box[0].real < box[2].real < lines[0].points[1].real
    ends = [leader.points[1] for leader in placed.leaders]
    assert {dot.centre for dot in dots} == set(ends)
    assert len(ends) == 2


def test_nothing_to_place() -> None:
    assert place_labels([]).marks == ()
    assert conflicts([]) == ()


def test_conflicts_are_found_and_said() -> None:
    text = Text("B", 50 + 50j, 5)
    assert conflicts([text, Text("B", 51 + 50j, 5)])[0].kind == "label"
    assert conflicts([text], [text]) == ()  # the same text given twice
    for struck in (
        Line((40 + 52j, 60 + 52j)),
        Arrow(40 + 52j, 60 + 52j, name="v_B"),
        Arc(51 + 50j, 2),
        Arc(51 + 52j, 20, fill="paper"),
        Shape((40 + 40j, 60 + 40j, 50 + 70j)),
        Hatch((40 + 40j, 60 + 40j, 50 + 70j)),
    ):
        (found,) = conflicts([text], [struck])
        assert found.kind == "stroke" and str(found).startswith("'B' lies on '")
    assert conflicts([text], [Line((40 + 49.5j, 60 + 49.5j))]) == ()
    assert conflicts([text], [Line((40 + 49.8j, 60 + 49.8j))])  # 0.2 mm below, but half a pen is 0.3
    assert [str(z) for z in conflicts([text], [], (0, 0, 52, 100))] == ["'B' sticks out of 'field' at (50.0; 50.0) mm"]
    assert conflicts([], [Line((0.2 + 5j, 9 + 5j))], (0, 0, 10, 10))[0].kind == "field"
