"""Groups of class III and order 4, two basic links hinged to each other: every number against the independent solver,
every assembly against an independent count."""

from __future__ import annotations

import cmath
import math
import random
import re

import pytest
from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from planes.geometry import plane
from planes.geometry.tracks import Pose, Tie, TieKind, advanced
from planes.geometry.two_tracks import both_assemblies
from planes.words.errors import PlanesError, SceneError
from tests.helpers import ROOT
from tests.helpers.comparing import against, balanced, draw, standing
from tests.helpers.mechanisms import KINDS, make
from tests.plans.test_against_oracle import examine

LEADS = ("RR", "PR", "RP")
TIES: tuple[TieKind, ...] = ("arc", "line", "guide")
X, Y, T = fmpq_mpoly_ctx.get(("x", "y", "t"), Ordering.lex).gens()


def spot(rng: random.Random) -> complex:
    return complex(rng.uniform(-1, 1), rng.uniform(-1, 1))


def planted(kinds: list[TieKind], rng: random.Random) -> tuple[list[Tie], Pose]:
    """Ties of a pose that is known, the first two of one link."""
    pose = spot(rng), *(cmath.rect(1.0, rng.uniform(-math.pi, math.pi)) for _ in range(2))
    ties = []
    for k, kind in enumerate(kinds):
        local, place, turn = spot(rng), spot(rng), cmath.rect(1.0, rng.uniform(-math.pi, math.pi))
        axis = pose[1 + k // 2]
        end = pose[0] + axis * local
        if kind == "arc":
            ties.append(Tie("arc", local, place, abs(end - place), link=k // 2))
        elif kind == "line":
            ties.append(Tie("line", local, place, plane.cross(turn, end - place), turn, k // 2))
        else:
            ties.append(Tie("guide", local, place, plane.cross(turn * axis, place - end), turn, k // 2))
    return ties, pose


def exact(z: complex) -> tuple[fmpq, fmpq]:
    """The very numbers that doubles are."""
    return fmpq(*float(z.real).as_integer_ratio()), fmpq(*float(z.imag).as_integer_ratio())


def missed(tie: Tie) -> fmpq_mpoly:
    """By how much a tie is missed, times 1 + t², the hinge being at (x, y) and t = tan θ/2."""
    (lx, ly), (px, py), (tx, ty) = (exact(z) for z in (complex(tie.local), complex(tie.place), complex(tie.turn)))
    (reach, _), cos, sin, over = exact(complex(tie.reach)), 1 - T * T, 2 * T, 1 + T * T
    ex, ey = over * (X - px) + lx * cos - ly * sin, over * (Y - py) + lx * sin + ly * cos  # of the end from the place
    if tie.kind == "arc":
        squares = (X - px) ** 2 + (Y - py) ** 2 + lx * lx + ly * ly - reach * reach
        arms = (X - px) * (lx * cos - ly * sin) + (Y - py) * (lx * sin + ly * cos)
        return over * squares + 2 * arms
    if tie.kind == "line":
        return tx * ey - ty * ex - reach * over
    wx, wy = tx * cos - ty * sin, tx * sin + ty * cos
    return wx * (py - Y) - wy * (px - X) - (tx * ly - ty * lx + reach) * over


def counted(ties: list[Tie]) -> int:
    """Real crossings by a way of their own: t is left out of both tracks, then y, and all complex roots are isolated by
    FLINT."""
    one, two = (missed(ties[k]).resultant(missed(ties[k + 1]), "t") for k in (0, 2))
    left = one.resultant(two, "y")
    powers = {exponents[0]: q for exponents, q in left.to_dict().items()}
    poly = fmpq_poly([powers.get(k, fmpq(0)) for k in range(max(powers) + 1)])
    return sum(root.imag == 0 for root, _ in poly.numer().complex_roots())


def none_is_missed(seed: str) -> int:
    rng = random.Random(seed)
    kinds: list[TieKind] = ["arc"] * 4 if rng.random() < 0.3 else rng.choices(TIES, k=4)
    ties, pose = planted(kinds, rng)
    found = both_assemblies(ties)
    assert found.proved and found.count == counted(ties), (seed, kinds, found.count)
    assert min(max(abs(a - b) for a, b in zip(pose, p, strict=True)) for p in found.poses) < 1e-8, seed
    assert all(abs(t.wrench(p[0], p[1 + t.link])[0]) < 1e-11 for p in found.poses for t in ties), seed
    assert all(abs(advanced(ties, p)[1]) < 1e-9 for p in found.poses), seed
    return found.count


def test_none_is_missed() -> None:
    assert len({none_is_missed(f"few {k}") for k in range(3)}) > 1


@pytest.mark.slow
def test_none_is_missed_of_many() -> None:
    counts = [none_is_missed(f"many {k}") for k in range(60)]
    assert max(counts) >= 8 and not any(count % 2 for count in counts)


def kind_of(rng: random.Random, seed: int) -> str:
    leads = ["RR"] * 4 if seed % 3 == 0 else rng.choices(LEADS, k=4)
    return "+".join("-".join(leads[k : k + 2]) for k in (0, 2))


def with_loads(seed: int) -> None:
    rng = random.Random(f"pairing {seed}")
    kinds = [kind_of(rng, seed)]
    if seed % 2:
        kinds.insert(rng.randrange(2), rng.choice(KINDS))
    examine(make(rng, kinds))


def test_two_basic_links_with_loads_on_every_link() -> None:
    with_loads(5)


@pytest.mark.slow
def test_more_with_loads_on_every_link() -> None:
    for seed in range(100, 112):
        with_loads(seed)


def rubbing(seed: int) -> float | None:
    """The worst number where hinges and guides rub; None where something stands still."""
    rng = random.Random(f"pairing rubs {seed}")
    case = make(rng, [kind_of(rng, seed)], friction=seed % 3 > 0, pins=seed % 3 < 2, rest=seed % 7 == 0)
    if standing(case):
        return None
    drawn, wrong = against(case)
    balanced(drawn, seed)
    return max(wrong.values()) * drawn.sharpest


@pytest.mark.slow
def test_with_friction_in_hinges_and_guides() -> None:
    found = [e for seed in range(16) if (e := rubbing(seed)) is not None]
    assert len(found) > 9 and max(found) <= 1e-9


def test_a_scene_that_does_not_say_is_told_every_assembly() -> None:
    text = (ROOT / "samples" / "class-three" / "two-basic-links.yaml").read_text(encoding="utf-8")
    text = re.sub(r"(?m)^assembly:.*\n", "", text)
    with pytest.raises(SceneError, match="assembles in 2 places") as caught:
        draw(text)
    for near in re.findall(r"near: (\[[^]]*\])", str(caught.value)):
        draw(text + f"assembly: {{E: {{near: {near}}}}}\n")


def test_two_basic_links_that_slide_on_each_other_are_refused_in_words() -> None:
    text = (ROOT / "samples" / "class-three" / "two-basic-links.yaml").read_text(encoding="utf-8")
    text = re.sub(r"(?m)^assembly:.*\n", "", text)
    text = text.replace("5: {points: {E: 0,", "5: {slides: z-z, points: {Z: 0,").replace("E: [0.28, 0.03], S3", "S3")
    text = text.replace("S3: [0.13, -0.02]}", "S3: [0.13, -0.02]}, guides: {z-z: {through: [0.28, 0.03], angle: 40}}")
    with pytest.raises(PlanesError, match=r"2, 3, 4, 5, 6, 7"):
        draw(text)
