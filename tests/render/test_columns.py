"""Columns of the calculation: in order, on the module, clear of what is in the way, as low as any breaking is."""

from __future__ import annotations

import random
from itertools import pairwise, product

import pytest

from render.sheet.columns import OVERFULL_COLUMN_COST, STEP_BREAK_COST, Columns, Item
from render.sheet.frame import Paper
from render.sheet.module import LEAST_RIGHT_GAP_MM, UNITS_PER_MODULE, VIEW_GAP_MM, Module
from render.sheet.stacking import Stacking

A2 = Module((20.0, 5.0, 589.0, 415.0), ((404.0, 5.0, 589.0, 60.0), (20.0, 401.0, 90.0, 415.0)))
SMALL = Module((0.0, 0.0, 185.0, 100.0), ())


def broken(items: list[Item], module: Module) -> Columns:
    """Views in columns of a module."""
    return Columns(items, Stacking(module))


def boxes(columns: Columns) -> list[tuple[float, float, float, float]]:
    """The views in their places: left, lower, right, upper."""
    placed = zip(columns.items, columns.view_spots, strict=True)
    return [(s.x, s.top - i.height, s.x + i.width, s.top) for i, s in placed]


def some(seed: int) -> list[Item]:
    """Views of random sizes, a table in four."""
    rng = random.Random(seed)
    wide = ((rng.uniform(30, 180), rng.uniform(30, 150), rng.randrange(3)) for _ in range(rng.randint(5, 12)))
    return [Item(w, h, f"step {s}", rng.random() < 0.25) for w, h, s in wide]


@pytest.mark.parametrize("seed", range(25))
def test_views_keep_apart_begin_on_the_module_and_keep_clear_of_the_title_block(seed: int) -> None:
    order, found = broken(some(seed), A2).best_arrangement()
    if found.total_cost >= OVERFULL_COLUMN_COST:
        return
    placed = boxes(found)
    for k, a in enumerate(placed):
        assert A2.inside[0] + VIEW_GAP_MM - 1e-9 <= a[0] and a[2] <= A2.inside[2] - LEAST_RIGHT_GAP_MM + 1e-9
        assert A2.inside[1] + VIEW_GAP_MM - 1e-9 <= a[1] and a[3] <= A2.inside[3] - VIEW_GAP_MM + 1e-9
        units = (a[0] - A2.left(0)) / A2.unit_pitch
        assert abs(units - round(units)) < 1e-9
        for b in (*placed[:k], *A2.taken):
            assert max(b[0] - a[2], a[0] - b[2], b[1] - a[3], a[1] - b[3]) >= VIEW_GAP_MM - 1e-6
    figures = [k for k in order if not some(seed)[k].loose]
    assert figures == sorted(figures)


@pytest.mark.parametrize("name", ["A3", "A2", "A1", "A0", "A3x3", "A2x3"])
def test_a_unit_begins_over_the_left_edge_of_the_title_block(name: str) -> None:
    paper = Paper(name)
    module = Module(paper.field, paper.occupied_areas)
    before = (paper.title_block[0] - module.left(0)) / module.unit_pitch
    assert abs(before - round(before)) < 1e-9 and before > 10
    assert (
        LEAST_RIGHT_GAP_MM - 1e-9
        <= paper.field[2] - module.left(module.unit_count) + VIEW_GAP_MM
        < module.unit_pitch + LEAST_RIGHT_GAP_MM
    )


def test_columns_begin_at_one_level_where_there_is_room_beneath_it() -> None:
    short, tall = Item(170.0, 300.0), Item(170.0, 395.0)
    beneath = A2.taken[1][1] - VIEW_GAP_MM  # the cell in the corner is over the first column
    assert [s.top for s in broken([short, short], A2).view_spots] == [beneath, beneath]
    assert [s.top for s in broken([short, tall], A2).view_spots] == [beneath, A2.inside[3] - VIEW_GAP_MM]


def test_some_of_the_random_views_have_room() -> None:
    assert (
        sum(broken(some(seed), A2).best_arrangement()[1].total_cost < OVERFULL_COLUMN_COST for seed in range(25)) >= 8
    )


def test_later_views_stand_lower_or_farther_right() -> None:
    columns = broken([Item(120.0, 90.0) for _ in range(9)], A2)
    assert columns.total_cost < OVERFULL_COLUMN_COST
    for a, b in pairwise(columns.view_spots):
        assert b.x > a.x or b.top < a.top


def test_a_small_view_stands_beside_a_tall_one_and_two_beneath_each_other_beside_it() -> None:
    columns = broken([Item(80.0, 86.0), Item(80.0, 40.0), Item(80.0, 39.0)], SMALL)
    (a, b, c) = columns.view_spots
    assert columns.total_cost < OVERFULL_COLUMN_COST and a.top == b.top > c.top and b.x == c.x > a.x
    assert broken([Item(80.0, 87.0), *columns.items[1:]], SMALL).total_cost >= OVERFULL_COLUMN_COST


def test_a_table_gives_way_to_figures_and_stands_where_there_is_room() -> None:
    tall, table = Item(80.0, 80.0), Item(80.0, 80.0, loose=True)
    wide = Item(160.0, 80.0)
    field = Module((0.0, 0.0, 185.0, 210.0), ())
    assert broken([tall, wide, table], field).total_cost >= OVERFULL_COLUMN_COST
    order, found = broken([tall, wide, table], field).best_arrangement()
    assert found.total_cost < OVERFULL_COLUMN_COST and order == [0, 2, 1]


def test_views_without_hope_have_no_room_in_any_order_of_tables() -> None:
    """Of views that find no room most are known not to before other orders are tried."""
    rng, paper, known = random.Random(7), Paper("A3"), {True: 0, False: 0}
    field = Module(paper.field, paper.occupied_areas)
    for seed in range(40):
        columns = broken(some(seed)[:7], field)
        figures = [k for k, item in enumerate(columns.items) if not (k and item.loose)]
        for _ in range(10 if columns.has_no_arrangement else 0):
            order = list(figures)
            for k in set(range(len(columns.items))) - set(figures):
                order.insert(rng.randint(1, len(order)), k)
            assert columns.reordered_columns(order).total_cost >= OVERFULL_COLUMN_COST
        known[columns.has_no_arrangement] += columns.best_arrangement()[1].total_cost >= OVERFULL_COLUMN_COST
    assert known[True] > 3 * known[False] > 0


def test_there_is_hope_where_columns_stand_side_by_side_but_for_a_table_between_them() -> None:
    field = Module((0.0, 0.0, 740.0, 100.0), ((385.0, 0.0, 550.0, 40.0),))
    wide, tall, table = Item(350.0, 80.0), Item(150.0, 80.0), Item(150.0, 40.0, loose=True)
    assert broken([wide, tall], field).total_cost >= OVERFULL_COLUMN_COST
    columns = broken([wide, tall, table], field)
    assert not columns.has_no_arrangement
    assert (
        columns.best_arrangement()[0] == [0, 2, 1] and columns.best_arrangement()[1].total_cost < OVERFULL_COLUMN_COST
    )


def test_no_table_stands_before_the_first_view_nor_for_nothing_before_an_earlier_table() -> None:
    field = Module((0.0, 0.0, 370.0, 210.0), ())
    views = [Item(80.0, 190.0), *(Item(80.0, high, loose=True) for high in (40.0, 60.0, 50.0, 30.0))]
    order, found = broken(views, field).best_arrangement()
    assert found.total_cost < OVERFULL_COLUMN_COST and order == [0, 1, 2, 3, 4]
    wide = [Item(350.0, 100.0), Item(80.0, 90.0, loose=True)]
    assert broken(wide, Module((0.0, 0.0, 370.0, 230.0), ((0.0, 0.0, 200.0, 20.0),))).best_arrangement()[0] == [0, 1]


@pytest.mark.parametrize("seed", range(6))
def test_no_other_breaking_is_cheaper(seed: int) -> None:
    """Every way to end columns after some views and units, tried one by one."""
    rng = random.Random(seed)
    items = [Item(rng.uniform(20, 90), rng.uniform(20, 60), str(rng.randrange(2))) for _ in range(4)]
    columns = broken(items, SMALL)

    def price(first: int, unit: int) -> float:
        if first == len(items):
            return (SMALL.unit_count - unit) / UNITS_PER_MODULE
        ends = product(range(first + 1, len(items) + 1), range(unit + 1, SMALL.unit_count + 1))
        return min(
            (
                columns.column_costs(columns.all_views_piece[first:k])[e, e - unit] + torn(k) + price(k, e)
                for k, e in ends
            ),
            default=9e9,
        )

    def torn(k: int) -> float:
        return STEP_BREAK_COST * (k < len(items) and items[k].step == items[k - 1].step)

    assert columns.total_cost == pytest.approx(price(0, 0)) or columns.total_cost > OVERFULL_COLUMN_COST


def test_a_view_wider_than_two_modules_has_a_column_where_the_field_is_wide_enough() -> None:
    field = (0.0, 0.0, 800.0, 500.0)
    assert broken([Item(420.0, 100.0)], Module(field, ())).total_cost >= OVERFULL_COLUMN_COST
    assert broken([Item(420.0, 100.0)], Module(field, (), 420.0)).total_cost < OVERFULL_COLUMN_COST
