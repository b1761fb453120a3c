"""A program depends on structure, never on values: mechanisms of round numbers, many of which are one by chance."""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

import pytest

from planes.plans import plans_of
from planes.scene import loads
from planes.scene.mechanism import Guide, Link, Mechanism
from planes.words.errors import PlanesError
from tests.helpers.mechanisms import KINDS, NoSolution, make, to_yaml

INNER = (False, False, False, "slider", "motor", "brace", "boom", True)


def rounded(node: Any, key: str = "") -> Any:
    """Angles to right ones, places to quarters of a metre."""
    if isinstance(node, dict):
        return {k: rounded(v, k) for k, v in node.items() if k not in ("loads", "friction")}
    if isinstance(node, list):
        return [rounded(v, key) for v in node]
    if not isinstance(node, float):
        return node
    return float(round(node / 90) * 90) if key in ("angle", "phi") else round(node * 4) / 4


def shaken(link: Link, rng: random.Random) -> Link:
    """All its dimensions a millionth off."""
    points = {p: z + 1e-6 * complex(rng.uniform(-1, 1), rng.uniform(-1, 1)) for p, z in link.points.items()}
    guides = {}
    for n, g in link.guides.items():
        assert isinstance(g, Guide)
        through = points[g.through_point] if g.through_point else g.through + 1e-6 * rng.random()
        guides[n] = replace(g, through=through, angle_deg=g.angle_deg + 1e-5 * rng.random())
    slides = link.slides
    if slides:
        angle, offset = (x if x is None else x + 1e-6 * rng.random() for x in (slides.angle_deg, slides.offset))
        slides = replace(slides, angle_deg=angle, offset=offset)
    return replace(link, points=points, guides=guides, slides=slides)


def apart(m: Mechanism) -> bool:
    """Whether no two points of a link are at one place, which is a shape of its own."""
    return all(len({*x.points.values()}) == len(x.points) for x in (m.frame, *m.links.values()))


def same_when_shaken(seed: int) -> bool | None:
    """Whether a mechanism of round numbers has the program it has when they are off; None where it is refused."""
    rng = random.Random(f"round {seed}")
    inner = rng.choice(INNER)
    try:
        case = make(rng, rng.choices(KINDS, k=rng.randint(not inner, 3)), inner=inner, assembly="side")
        m = loads(to_yaml(rounded(case.scene))).mechanism
        assert m
        plans = plans_of(m)
    except (PlanesError, NoSolution):
        return None
    if not apart(m):
        return None
    drive = replace(m.drive, position=m.drive.position + 1e-6)
    links = {n: shaken(x, rng) for n, x in m.links.items()}
    other = plans_of(replace(m, links=links, frame=shaken(m.frame, rng), drive=drive))
    return plans.program == other.program and plans.given.keys() == other.given.keys()


def test_numbers_that_are_the_same_by_chance_are_not_taken_for_one() -> None:
    found = [same for seed in range(6) if (same := same_when_shaken(seed)) is not None]
    assert len(found) > 2 and all(found)


@pytest.mark.slow
def test_more_numbers_that_are_the_same_by_chance() -> None:
    found = [same for seed in range(100, 220) if (same := same_when_shaken(seed)) is not None]
    assert len(found) > 60 and all(found)
