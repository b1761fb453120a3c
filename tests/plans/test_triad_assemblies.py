"""All assemblies of a link on three ties: published ones, an independent exact count, and words."""

from __future__ import annotations

import cmath
import math
import random
import re
from collections.abc import Mapping
from itertools import combinations_with_replacement

import numpy as np
import pytest
from flint import fmpq, fmpq_poly

from planes.batch.cycle import Cycle
from planes.drafting.tools import Thing
from planes.geometry import plane
from planes.geometry.sextic import three_tie_assemblies
from planes.geometry.tracks import Tie
from planes.plans import plans_of
from planes.plans.position.branch import Waypoint, _Way
from planes.plans.scales import drawn_in_si
from planes.scene import loads
from planes.words.errors import SceneError
from tests.helpers import ROOT

KINDS = ("arc", "line", "guide")
OVER = fmpq_poly([1, 0, 1])


def held(bases: list[complex], platform: list[complex], legs: list[float]) -> list[Tie]:
    return [Tie("arc", p, b, leg) for b, p, leg in zip(bases, platform, legs, strict=True)]


def turns(ties: list[Tie]) -> list[float]:
    found = three_tie_assemblies(ties)
    assert found.is_count_proved
    return [math.degrees(cmath.phase(axis)) for _, axis in found.poses]


def test_published_two() -> None:
    legs = [math.sqrt(50), math.sqrt(26), 5.0]
    found = turns(held([0, 10, 3 + 10j], [0, 4, 2 + 2j], legs))
    assert found == pytest.approx([-46.2252859799, 0.0], abs=1e-9)


def test_published_six() -> None:
    a, b, c = 17.04, 20.84, 16.54
    x = (a * a + b * b - c * c) / (2 * a)
    found = turns(held([0, 15.91, 10j], [0, a, complex(x, math.sqrt(b * b - x * x))], [14.98, 15.38, 12.0]))
    wanted = [-56.5494583167, -2.7118877033, 14.0552008002, 33.5565786564, 57.4125792459, 122.206418227]
    assert found == pytest.approx(wanted, abs=1e-9)


PUBLISHED = [-56.5494583167, -2.7118877033, 14.0552008002, 33.5565786564, 57.4125792459, 122.206418227]


def test_the_truss_of_the_samples_has_the_six_published_assemblies() -> None:
    """A scene that does not say which is meant is told six; each is chosen by its place, and leans as published."""
    text = (ROOT / "samples" / "class-three" / "truss.yaml").read_text(encoding="utf-8")
    text = re.sub(r"(?m)^assembly:.*\n", "", text)
    with pytest.raises(SceneError, match="assembles in 6 places") as caught:
        drawn(text)
    leaning = []
    for near in re.findall(r"near: (\[[^]]*\])", str(caught.value)):
        things = drawn(text + f"assembly: {{D: {{near: {near}}}}}\n")
        leaning.append(math.degrees(cmath.phase(things["position:C"] - things["position:B"])))
    assert leaning == pytest.approx(PUBLISHED, abs=1e-9)


def drawn(text: str) -> Mapping[str, Thing]:
    """The scheme where the drive stands in the file."""
    mechanism = loads(text).mechanism
    assert mechanism
    return drawn_in_si(plans_of(mechanism), mechanism.drive.position).things


def planted(kinds: tuple[str, ...], rng: random.Random) -> tuple[list[Tie], complex, complex]:
    """Ties of a pose that is known."""

    def spot() -> complex:
        return complex(rng.uniform(-1, 1), rng.uniform(-1, 1))

    origin, axis, ties = spot(), cmath.rect(1.0, rng.uniform(-math.pi, math.pi)), []
    for kind in kinds:
        local, place, turn = spot(), spot(), cmath.rect(1.0, rng.uniform(-math.pi, math.pi))
        end = origin + axis * local
        if kind == "arc":
            ties.append(Tie("arc", local, place, abs(end - place)))
        elif kind == "line":
            ties.append(Tie("line", local, place, plane.cross(turn, end - place), turn))
        else:
            ties.append(Tie("guide", local, place, plane.cross(turn * axis, place - end), turn))
    return ties, origin, axis


def exact(number: float) -> fmpq:
    """The very number a double is."""
    return fmpq(*number.as_integer_ratio())


def of_place(local: complex, place: complex) -> tuple[fmpq_poly, fmpq_poly]:
    """local e - place by its coordinates, over 1 + t², where e is the link's x axis and t = tan θ/2."""
    x, y = (exact(z) for z in (local.real, local.imag))
    cos, sin = fmpq_poly([1, 0, -1]), fmpq_poly([0, 2])
    return x * cos - y * sin - exact(place.real) * OVER, x * sin + y * cos - exact(place.imag) * OVER


def row(tie: Tie) -> tuple[fmpq_poly, fmpq_poly, fmpq_poly, fmpq_poly]:
    """What a tie says of the origin (x, y), over (1 + t²)²: of x² + y², of x, of y, and what is left."""
    reach, (x, y) = exact(tie.reach) * OVER, of_place(tie.local, tie.place)
    if tie.kind == "arc":
        return OVER * OVER, 2 * x * OVER, 2 * y * OVER, x * x + y * y - reach * reach
    if tie.kind == "line":
        u, v = exact(tie.turn.real), exact(tie.turn.imag)
        return 0 * OVER, -v * OVER * OVER, u * OVER * OVER, (u * y - v * x - reach) * OVER
    u, v = of_place(tie.turn, 0j)
    return 0 * OVER, v * OVER, -u * OVER, v * x - u * y - reach * OVER


def counted(ties: list[Tie]) -> int:
    """Real roots by a way of its own: the resultant in rationals, and all its complex roots isolated by FLINT."""
    rows = [row(t) for t in ties]
    arcs = [r for r, t in zip(rows, ties, strict=True) if t.kind == "arc"]
    if not arcs:
        (_, *p), (_, *q), (_, *r) = rows
        whole = sum(p[i] * (q[j] * r[k] - q[k] * r[j]) for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)))
    else:
        square = arcs[0]
        others = [r for r in rows if r is not square]
        plain = [tuple(x - y for x, y in zip(r, square, strict=True)) if r in arcs else r for r in others]
        (_, a, b, c), (_, d, f, g) = plain
        x, y, w = b * g - c * f, c * d - a * g, a * f - b * d
        whole = square[0] * (x * x + y * y) + w * (square[1] * x + square[2] * y) + square[3] * w * w
    assert isinstance(whole, fmpq_poly)
    while not whole % OVER:
        whole = whole // OVER
    return sum(root.imag == 0 for root, _ in whole.numer().complex_roots())


@pytest.mark.parametrize("kinds", list(combinations_with_replacement(KINDS, 3)), ids="-".join)
def test_none_is_missed(kinds: tuple[str, ...]) -> None:
    rng = random.Random("-".join(kinds))
    for _ in range(3):
        ties, origin, axis = planted(kinds, rng)
        found = three_tie_assemblies(ties)
        assert found.is_count_proved and found.count == counted(ties)
        assert min(abs(o - origin) + abs(a - axis) for o, a in found.poses) < 1e-8
        assert all(abs(t.error_and_wrench(o, a)[0]) < 1e-12 for o, a in found.poses for t in ties)


@pytest.mark.long
@pytest.mark.parametrize("part", range(10))
def test_none_is_missed_of_ten_thousand(part: int) -> None:
    rng = random.Random(f"many {part}")
    for _ in range(1000):
        ties, _, _ = planted(tuple(rng.choices(KINDS, k=3)), rng)
        found = three_tie_assemblies(ties)
        assert found.is_count_proved and found.count == counted(ties)


SCENE = """\
planes: 1
frame: {points: {O: [0, 0], E: [0.5, 0.3], F: [0.6, -0.3]}}
links:
  1: {points: {O: 0, A: 0.1}}
  2: {points: {A: 0, B: 0.3}}
  3: {points: {B: 0, C: [0.2, 0.1], D: [0.2, -0.12]}, mass: 5, inertia: 0.1}
  4: {points: {E: 0, C: 0.25}}
  5: {points: {F: 0, D: 0.25}, mass: 2}
drive: {link: 1, phi: 60, omega: 10}
gravity: 9.81
"""


def test_a_scene_that_does_not_say_is_told_every_assembly() -> None:
    scene = loads(SCENE)
    assert scene.mechanism
    with pytest.raises(SceneError) as caught:
        plans_of(scene.mechanism, "scene.yaml")
    said = str(caught.value)
    assert "assembles in 2 places (proved" in said
    assert "D: {near: [0.43323, -0.11375]} or D: {near: [0.50334, -0.069444]}" in said


@pytest.mark.needs("llvmlite")
def test_one_assembly_is_followed_alike_by_arrays_and_the_compiled_loop() -> None:
    scene = loads(SCENE + "assembly: {D: {near: [0.5, -0.07]}}\n")
    assert scene.mechanism
    cycle = Cycle(plans_of(scene.mechanism))
    values = np.linspace(0.0, 360.0, 721)
    slow, quick = cycle.table(values, False)[0], cycle.table(values, True)[0]
    works = np.isfinite(slow).all(axis=0)
    assert 680 < works.sum() < 721  # beyond its dead points there is no number
    assert np.array_equal(works, np.isfinite(quick).all(axis=0))
    size = np.abs(slow[:, works]).max(axis=1, keepdims=True)
    assert (np.abs(slow - quick)[:, works] <= 1e-9 * (size + 1e-9)).all()
    assert {r.key for r in cycle.reasons} >= {"track_missed"}


def test_a_place_between_two_assemblies_chooses_none() -> None:
    text = (ROOT / "samples/class-three/press.yaml").read_text()
    assert "near: [0.6, 0.03]" in text
    with pytest.raises(SceneError, match=r"0\.1935 m from the nearest of the 2 places .* 0\.2256 m from the next") as e:
        plans_of(loads(text.replace("near: [0.6, 0.03]", "near: [0.5, 0.2]")).mechanism)  # type: ignore[arg-type]
    assert "C: {near: [0.59944, 0.034041]} or C: {near: [0.40423, 0.40425]}" in str(e.value)


TURNS = [(-50, 250), (-250, 50), (-1000, 1000), (-20, 1000), (-1000, 20), (-30, 40)]


@pytest.mark.parametrize(("low", "high"), TURNS)
def test_the_way_of_an_assembly_is_all_it_lasts_but_no_more_than_a_turn(low: float, high: float) -> None:
    """Of an assembly that lasts from ``low`` to ``high`` about 0: half a turn to each side, or what one side leaves."""
    way = _Way.__new__(_Way)
    way.start, way.step, way.turning = Waypoint(0.0, [], (0j, 1 + 0j)), 1.0, True
    way.find_pose_at = lambda value, near: Waypoint(value, [], near) if low <= value <= high else None  # type: ignore[method-assign]
    spots = [spot.value for spot in way.poses_on_path()]
    ahead = min(high, max(180.0, 360.0 + max(low, -180.0)))
    behind = max(low, ahead - 360.0)
    assert spots == sorted(spots) and (spots[0], spots[-1]) == pytest.approx((behind, ahead), abs=1e-3)
