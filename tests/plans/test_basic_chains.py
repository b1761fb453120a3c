"""Groups of class III of order 4 and more, basic links hinged to each other: every number against the independent
solver, assemblies of two against an independent count, of more each one proved."""

from __future__ import annotations

import cmath
import math
import random
import re
from dataclasses import replace
from typing import Any

import pytest
import yaml
from flint import Ordering, fmpq, fmpq_mpoly, fmpq_mpoly_ctx, fmpq_poly

from planes.drafting.drawing import draw_program
from planes.geometry import plane
from planes.geometry.searched import is_proved_assembly, search_assemblies
from planes.geometry.tracks import Pose, Tie, TieKind, link_origins, newton_step
from planes.geometry.two_tracks import two_link_assemblies
from planes.plans import Plans
from planes.plans.other_leads import plans_by_next_leads, steps_with_other_leads
from planes.plans.scales import plan_scales
from planes.scene import loads
from planes.words.errors import PlanesError, SceneError
from tests.helpers import ROOT
from tests.helpers.comparing import Drawn, against, balanced, differences, draw, expected, standing
from tests.helpers.comparing import pose as pose_of
from tests.helpers.mechanisms import KINDS, Case, make, to_yaml
from tests.helpers.oracle import solve as oracle_solve
from tests.plans.test_against_oracle import examine

LEADS = ("RR", "PR", "RP")
TIES: tuple[TieKind, ...] = ("arc", "line", "guide")
X, Y, T = fmpq_mpoly_ctx.get(("x", "y", "t"), Ordering.lex).gens()


def spot(rng: random.Random) -> complex:
    return complex(rng.uniform(-1, 1), rng.uniform(-1, 1))


def planted(kinds: list[TieKind], rng: random.Random, held: tuple[int, ...] = (0, 0, 1, 1)) -> tuple[list[Tie], Pose]:
    """Ties of a pose that is known, each of the link it is ``held`` by; links beyond the second hang on the last."""
    links = 1 + max(held)
    pose = spot(rng), *(cmath.rect(1.0, rng.uniform(-math.pi, math.pi)) for _ in range(links))
    hinges = [Tie("hinge", spot(rng), 0j, 0.0, link=k - 1) for k in range(2, links)]
    places, ties = link_origins(hinges, pose), list[Tie]()
    for kind, k in zip(kinds, held, strict=True):
        local, place, turn = spot(rng), spot(rng), cmath.rect(1.0, rng.uniform(-math.pi, math.pi))
        axis = pose[1 + k]
        end = places[k] + axis * local
        if kind == "arc":
            ties.append(Tie("arc", local, place, abs(end - place), link=k))
        elif kind == "line":
            ties.append(Tie("line", local, place, plane.cross(turn, end - place), turn, k))
        else:
            ties.append(Tie("guide", local, place, plane.cross(turn * axis, place - end), turn, k))
    return [*ties, *hinges], pose


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
    found = two_link_assemblies(ties)
    assert found.is_count_proved and found.count == counted(ties), (seed, kinds, found.count)
    assert min(max(abs(a - b) for a, b in zip(pose, p, strict=True)) for p in found.poses) < 1e-8, seed
    assert all(abs(t.error_and_wrench(p[0], p[1 + t.link])[0]) < 1e-11 for p in found.poses for t in ties), seed
    assert all(abs(newton_step(ties, p)[1]) < 1e-9 for p in found.poses), seed
    return found.count


def test_none_is_missed() -> None:
    assert len({none_is_missed(f"few {k}") for k in range(3)}) > 1


@pytest.mark.slow
def test_none_is_missed_of_many() -> None:
    counts = [none_is_missed(f"many {k}") for k in range(60)]
    assert max(counts) >= 8 and not any(count % 2 for count in counts)


def apart(one: Pose, two: Pose) -> float:
    return max(abs(a - b) for a, b in zip(one, two, strict=True))


@pytest.mark.slow
def test_a_search_meets_all_that_an_exact_count_has() -> None:
    """Two links, whose assemblies are counted exactly: none of them is missed."""
    for seed in range(40):
        rng = random.Random(f"met {seed}")
        ties, _ = planted(rng.choices(TIES, k=4), rng)
        exact_ones, found = two_link_assemblies(ties), search_assemblies(ties, 1.0)
        assert not found.whole and found.is_count_proved and len(found.poses) == exact_ones.count, seed
        assert all(min(apart(p, q) for q in found.poses) < 1e-9 for p in exact_ones.poses), seed


@pytest.mark.slow
def test_a_search_meets_what_was_planted_in_longer_chains() -> None:
    """Of three and four links: the planted assembly is among them, and they come by twos."""
    for seed in range(24):
        rng = random.Random(f"planted {seed}")
        held = (0, 0, 1, 2, 2) if seed % 4 else (0, 0, 1, 2, 3, 3)
        ties, pose = planted(rng.choices(TIES, k=len(held)), rng, held)
        found = search_assemblies(ties, 1.0)
        assert min(apart(pose, p) for p in found.poses) < 1e-8 and found.is_count_proved, seed
        assert len(found.poses) % 2 == 0, (seed, len(found.poses))


def test_what_is_proved_is_a_single_root() -> None:
    """A planted pose is; beside it none is, and where two assemblies are one it is not single."""
    ties, pose = planted(["arc", "line", "guide", "arc", "arc"], random.Random("proved"), (0, 0, 1, 2, 2))
    assert is_proved_assembly(ties, pose)
    assert not is_proved_assembly(ties, (pose[0] + 1e-7, *pose[1:]))
    ties = [
        Tie("arc", 0j, 0j, 1.0),
        Tie("line", 0j, 1j, 0.0),
        Tie("line", 1 + 0j, 1j, 0.0),
    ]  # an arc that a line touches
    assert not is_proved_assembly(ties, (1j, 1 + 0j))
    assert is_proved_assembly([ties[0], *(replace(t, place=0.6j) for t in ties[1:])], (0.8 + 0.6j, 1 + 0j))


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


def of_three(rng: random.Random) -> str:
    one, two, three, four, five = rng.choices(LEADS, k=5)
    return f"{one}-{two}+{three}+{four}-{five}"


@pytest.mark.slow
def test_three_basic_links_with_loads_on_every_link() -> None:
    for seed in range(12):
        rng = random.Random(f"three {seed}")
        kinds = [of_three(rng)]
        if seed % 3 == 0:
            kinds.insert(rng.randrange(2), rng.choice(KINDS))
        examine(make(rng, kinds))


@pytest.mark.slow
@pytest.mark.parametrize("links", [2, 3])
def test_whichever_is_found_last_every_number_is_the_same(links: int) -> None:
    """Every lead and every hinge in its turn, against the independent solver."""
    for seed in range(4):
        rng = random.Random(f"last {links} {seed}")
        case = make(rng, [kind_of(rng, seed) if links == 2 else of_three(rng)], sliding=False)
        plans = draw(to_yaml(case.scene)).plans
        special, turns = steps_with_other_leads(plans.program)[0].makes, {""}
        for k in range(3 * links - 1):
            d = by(case, plans_by_next_leads(plans, special, k))
            wanted = {n.name: n for n in expected(oracle_solve(case.scene, pose_of(d)), True)}
            assert max(differences(d, wanted).values()) * d.sharpest <= 1e-9, (seed, k)
            balanced(d)
            turns.add(d.plans.leads[next(iter(d.plans.leads))][-1].pair_letters)
        assert len(turns) > 1


def star(rng: random.Random) -> dict[str, Any]:
    """A triangle with a basic link at each corner, on two rods each; the crank drives the first."""
    corners, middle = {"P": 1 + 0j, "Q": 1.6 + 0.1j, "R": 1.2 + 0.6j}, (3.8 + 0.7j) / 3
    crank, names = cmath.rect(0.15, math.radians(40)), iter("BCDEFG")
    scene: dict[str, Any] = {"planes": 1, "frame": {"points": {"O": [0, 0]}}, "gravity": 9.81}
    scene["links"] = {"1": {"points": {"O": [0, 0], "A": [0.15, 0]}, "mass": 1.0, "inertia": 0.1}}
    drawn = {"10": {n: z - corners["P"] for n, z in corners.items()}}
    for k, (corner, z) in enumerate(corners.items(), 11):
        out = z + 0.8 * (z - middle)
        drawn[str(k)] = {corner: 0j}
        for name in (next(names), next(names)):
            hinge, pivot = (out + cmath.rect(r * rng.uniform(0.5, 1), rng.uniform(-3, 3)) for r in (0.35, 0.7))
            far = f"{name}0" if name != "B" else "A"
            if far == "A":
                pivot = crank
            else:
                scene["frame"]["points"][far] = [pivot.real, pivot.imag]
            drawn[str(k)][name] = hinge - z
            drawn[f"2{'BCDEFG'.index(name)}"] = {far: 0j, name: complex(abs(hinge - pivot))}
    for link, points in drawn.items():
        told = {n: [z.real, z.imag] for n, z in points.items()}
        scene["links"][link] = {"points": told, "mass": rng.uniform(1, 3), "inertia": rng.uniform(0.1, 0.3)}
    scene["assembly"] = {"Q": {"near": [corners["Q"].real, corners["Q"].imag]}}
    return scene | {"drive": {"link": "1", "phi": 40.0, "omega": 7.0, "epsilon": 3.0}}


@pytest.mark.slow
def test_a_star_of_four_basic_links() -> None:
    """Order 6: every one of the outer three leads the middle one."""
    scene = star(random.Random(5))
    d = draw(yaml.safe_dump(scene, sort_keys=False))
    (group,) = d.plans.structure.groups
    assert group.json()["order"] == 6  # type: ignore[index]
    wanted = {n.name: n for n in expected(oracle_solve(scene, pose_of(d)), True)}
    assert max(differences(d, wanted).values()) * d.sharpest <= 1e-9
    balanced(d)


def by(case: Case, plans: Plans) -> Drawn:
    value = plans.mechanism.drive.position
    chosen = {**plan_scales(plans, {}, plans.drive_givens_at(value)), **plans.drive_givens_at(value)}
    return Drawn(loads(to_yaml(case.scene)), plans, chosen, draw_program(plans.program, {**plans.given, **chosen}))


@pytest.mark.slow
def test_more_with_loads_on_every_link() -> None:
    for seed in range(100, 112):
        with_loads(seed)


def rubbing(seed: int) -> float | None:
    """The worst number where hinges and guides rub; None where something stands still."""
    rng = random.Random(f"pairing rubs {seed}")
    kind = of_three(rng) if seed % 4 == 3 else kind_of(rng, seed)
    case = make(rng, [kind], friction=seed % 3 > 0, pins=seed % 3 < 2, rest=seed % 7 == 0)
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
