"""Which strokes are near to boxes, against shapely's own distances."""

from __future__ import annotations

import random

import numpy as np
import pytest
import shapely

from render.labels.board import Everywhere
from render.labels.candidates import (
    FAR_DISTANCES_MM,
    NEAR_DISTANCES_MM,
    Label,
    candidates_beside,
    candidates_far_off,
    count_clashes,
    join_candidates,
)
from render.labels.footprints import segments_meet
from render.labels.nearness import edges_of_shapes


@pytest.mark.parametrize("seed", range(4))
def test_as_many_shapes_are_near_as_shapely_says(seed: int) -> None:
    dice = random.Random(seed)
    drawn = [curve(dice) for _ in range(60)]
    shapes = np.array([shapely.LineString(z) if k % 3 else shapely.Polygon(z) for k, z in enumerate(drawn)])
    shapes = shapes[shapely.is_valid(shapes)]
    halves = np.array([dice.choice((0.0, 0.25, 0.5)) for _ in shapes])
    corners = np.array([[dice.uniform(0, 80), dice.uniform(0, 80)] for _ in range(300)])
    boxes = np.hstack([corners, corners + [[dice.uniform(0.5, 12), dice.uniform(0.5, 6)] for _ in corners]])
    apart = shapely.distance(shapely.box(*boxes.T)[:, None], shapes[None, :]) - halves
    for clear, found in zip(
        (1.3, 0.5), edges_of_shapes(shapes, halves).count_near_shapes(boxes, (1.3, 0.5)), strict=True
    ):
        assert found.tolist() == (apart <= clear).sum(axis=1).tolist()
        assert found.max() > 1


def curve(dice: random.Random) -> list[tuple[float, float]]:
    """A line of some chords, or one that stays at its point."""
    x, y, wide = dice.uniform(0, 80), dice.uniform(0, 80), dice.choice((0.0, 3.0, 30.0))
    return [(x + dice.uniform(0, wide), y + dice.uniform(0, wide)) for _ in range(dice.randint(4, 8))]


def test_a_box_inside_a_filled_shape_is_on_ink_and_one_within_a_ring_is_not() -> None:
    round_ = [(0.0, 0.0), (40.0, 0.0), (40.0, 40.0), (0.0, 40.0), (0.0, 0.0)]
    shapes, inside = np.array([shapely.Polygon(round_), shapely.LineString(round_)]), np.array([[15.0, 15, 25, 25]])
    assert [
        edges_of_shapes(shapes[k : k + 1], np.zeros(1)).count_near_shapes(inside, (1.0,))[0].tolist() for k in (0, 1)
    ] == [[1], [0]]
    assert edges_of_shapes(shapes[:0], np.zeros(0)).count_near_shapes(inside, (1.0,))[0].tolist() == [0]


@pytest.mark.parametrize("seed", range(3))
def test_a_place_does_to_others_what_each_pair_of_places_says(seed: int) -> None:
    dice = random.Random(seed)
    labels = [Label(f"F_{{{k}}}", complex(dice.uniform(0, 60), dice.uniform(0, 40)), 3.5) for k in range(8)]
    options = [
        join_candidates([candidates_beside(x, NEAR_DISTANCES_MM), candidates_far_off(x, FAR_DISTANCES_MM[:4])])
        for x in labels
    ]
    every, many = join_candidates(options), len(options[0].wish)
    found = Everywhere(every)
    rows = dice.sample(range(len(every.wish)), 40)
    clashes, close = count_clashes(every, every.select_rows(np.array(rows)))
    for row, wanted, near in zip(rows, clashes.T, close.T, strict=True):
        own = slice(row // many * many, (row // many + 1) * many)
        wanted[own], near[own] = 0, False
        effect = found.effect_on_others(row, own)
        assert effect.near.tolist() == np.flatnonzero(near).tolist()
        assert effect.clashing.tolist() == np.flatnonzero(wanted).tolist()
        assert effect.clashes.tolist() == wanted[effect.clashing].tolist()
    assert clashes.max() > 1


def test_two_leaders_meet_whichever_is_asked_first() -> None:
    long, short = np.array([0j, 20 + 0j]), np.array([5 + 0.1j, 6 + 0.25j])  # the long one's ends are far off its line
    assert segments_meet(long, short) and segments_meet(short, long)
    assert not segments_meet(long, short + 1j) and not segments_meet(short + 1j, long)
