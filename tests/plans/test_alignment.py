"""The self-aligning variant: counted by Somov and Malyshev, and proved on the mechanism as bodies in space."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planes.plans import Plans, plans_of
from planes.plans.assur.alignment import (
    LOOSER_PAIR_KINDS,
    PAIR_FREEDOMS,
    _pair_places_in_cycle,
    constrains_in_all_positions,
    constraint_determinant,
    matrix_determinant,
    self_aligning_variant,
)
from planes.plans.assur.groups import Pair
from planes.scene import load
from tests.diagrams.test_diagrams import ROCKER, plans_from
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
NAMES = [
    "six-link",
    "assignment-12",
    "kind-1-rrr",
    "kind-2-rrp",
    "kind-3-rpr",
    "kind-4-prp",
    "kind-5-rpp",
    "sliding-driver",
    "crank-slider",
]
Z = np.array([0.0, 0.0, 1.0])


def plans(name: str) -> Plans:
    mechanism = load(str(SAMPLES / f"{name}.yaml")).mechanism
    assert mechanism
    return plans_of(mechanism)


# bodies in space: small displacements u + θ × r of every link, and what a pair forbids of them


def forbidden(sign: str, kind: str, place: complex, along: complex) -> list[tuple[np.ndarray, np.ndarray]]:
    """Rows (on the displacement of the pair's place, on the turning) that a pair keeps zero."""
    axis = Z if kind == "R" else np.array([along.real, along.imag, 0.0])
    across = list(np.linalg.svd(axis[None])[2][1:])
    none = np.zeros(3)
    if sign == "S":
        return [(e, none) for e in np.eye(3)]
    rows = [(v, none) for v in across] + [(none, v) for v in across]  # a round rod in a round hole
    if sign == "R":
        rows.append((axis, none))
    if sign == "P":
        rows.append((none, axis))
    return rows


def matrix(p: Plans, signs: dict[Pair, str], places: dict[Pair, Any]) -> np.ndarray:
    column = {link: 6 * k for k, link in enumerate(p.mechanism.links)}
    rows = []
    for pair, sign in signs.items():
        place, along = places[pair]
        r = np.array([place.real, place.imag, 0.0])
        for moved, turned in forbidden(sign, pair.kind, place, along):
            row = np.zeros(6 * len(column))
            for link, side in ((pair.link, 1.0), (pair.other, -1.0)):
                if link in column:
                    k = column[link]
                    row[k : k + 3] += side * moved
                    row[k + 3 : k + 6] += side * (turned + np.cross(r, moved))  # moved · (θ × r) = θ · (r × moved)
            rows.append(row)
    return np.array(rows)


@pytest.mark.parametrize("name", NAMES)
def test_one_freedom_and_nothing_redundant_as_bodies_in_space(name: str) -> None:
    p = plans(name)
    variant, places = self_aligning_variant(p), _pair_places_in_cycle(p, name)[0].lines
    n = len(p.mechanism.links)
    own = matrix(p, {pair: pair.kind for pair in p.structure.pairs}, places)
    assert len(own) - np.linalg.matrix_rank(own, 1e-9) == p.structure.q
    loosened = matrix(p, dict(variant.pairs), places)
    assert (variant.degree_of_freedom, variant.redundant_constraints) == (1, 0) and len(loosened) == 6 * n - 1
    assert np.linalg.matrix_rank(loosened, 1e-9) == 6 * n - 1
    p5, p4, p3 = variant.pair_counts_by_class
    assert 6 * n - 5 * p5 - 4 * p4 - 3 * p3 == 1 and p5 + p4 + p3 == len(p.structure.pairs)


@pytest.mark.parametrize("file", sorted((SAMPLES / "assignments").glob("*.yaml"))[::6], ids=lambda f: f.stem)
def test_assignments_have_a_variant_that_holds_all_through_the_cycle(file: Path) -> None:
    mechanism = load(str(file)).mechanism
    assert mechanism
    p = plans_of(mechanism)
    variant, cycle = self_aligning_variant(p), _pair_places_in_cycle(p, file.name)
    assert (variant.degree_of_freedom, variant.redundant_constraints) == (1, 0)
    for group in p.structure.groups:
        signs = tuple(variant.new_kind_of_pair(pair) for pair in group.pairs)
        assert all(sign in LOOSER_PAIR_KINDS[pair.kind] for pair, sign in zip(group.pairs, signs, strict=True))
        assert constrains_in_all_positions(group, signs, cycle)


def test_a_rod_between_two_spheres_counts_right_and_is_refused() -> None:
    p = plans_from(ROCKER)
    group, places = p.structure.groups[0], _pair_places_in_cycle(p, "")[0]
    signs = ("S", "S", "R")  # the coupler may spin: one freedom too many, one constraint too many
    assert sum(PAIR_FREEDOMS[s] for s in signs) - 3 == 4
    assert abs(constraint_determinant(group, signs, places)) < 1e-12
    counted = ("S", "R", "C")
    assert sum(PAIR_FREEDOMS[s] for s in counted) - 3 == 3
    assert abs(constraint_determinant(group, counted, places)) > 1e-3


def test_a_variant_loose_in_one_position_only_is_not_taken() -> None:
    """A ball on the crank and a round rod in its guide let the slider turn about the guide when the ball is on it."""
    p = plans("kind-5-rpp")
    group, cycle = p.structure.groups[0], _pair_places_in_cycle(p, "")
    assert abs(constraint_determinant(group, ("S", "P", "C"), cycle[0])) > 1e-3
    assert not constrains_in_all_positions(group, ("S", "P", "C"), cycle)
    assert [s for _, s in self_aligning_variant(p).pairs] == ["R", "C", "C", "C"]


def test_determinants() -> None:
    rng = np.random.default_rng(3)
    for n in (1, 3, 6):
        rows = rng.standard_normal((n, n))
        assert matrix_determinant(rows.tolist()) == pytest.approx(np.linalg.det(rows), rel=1e-11)
    assert matrix_determinant([[1.0, 2.0], [0.0, 0.0]]) == 0.0
