"""Instantaneous centres by the theorem of three centres, held against the velocity plan, which leads to none."""

from __future__ import annotations

from itertools import combinations
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from planes.drafting.drawing import Drawing, draw_program
from planes.plans import Plans
from planes.plans.scales import unit_scales_of_plans
from planes.plans.three_centres import plans_with_instant_centres
from planes.scene import Scene, load, loads
from planes.scene.mechanism import FRAME
from planes.solving import plans_and_requested_results
from planes.words.errors import PlanesError
from planes.words.names import VELOCITY_PLAN
from tests.helpers import ROOT
from tests.helpers.mechanisms import any_scene

SAMPLES = [
    f for f in sorted(ROOT.glob("samples/**/*.yaml")) if f.parent.name in ("samples", "class-three", "class-four")
]
LEFT = {"excavator": 9}  # a boom that stands still is held by one line alone
FAR = 1e3  # of the mechanism's size: farther off a centre is told by lines too nearly parallel
CLOSE = 1e-9


def drawn(scene: Scene, count: int = 24) -> tuple[Plans, Drawing]:
    """The plans with centres, in SI, in many positions."""
    plans = plans_with_instant_centres(plans_and_requested_results(scene, shown=True)[0])
    drive, reach = plans.mechanism.drive, plans.longest_link_length
    turn = np.linspace(0, 360, count, endpoint=False) if drive.kind == "phi" else np.linspace(-0.1, 0.1, count) * reach
    try:
        where = plans.drive_givens_at(drive.position + turn)
    except PlanesError:  # a law that holds in the scene's own position
        where = plans.drive_givens_at(drive.position + np.zeros(1))
    return plans, draw_program(plans.program, {**plans.given, **unit_scales_of_plans(plans), **where})


def velocities(plans: Plans, drawing: Drawing, link: str, mark: str) -> Any:
    """The velocity of the point of a link at a mark of the scheme, by a point whose velocity is drawn and by ω."""
    if link == FRAME:
        return np.zeros_like(drawing[mark])
    own = (p for p in plans.mechanism.links[link].points if plans.points[p].velocity in drawing.program.result_names)
    point = next((p for p in own if plans.points[p].position in drawing.program.result_names), None)
    if point is None:
        return None
    omega = drawing[plans.links[link].omega] if plans.links[link].omega else 0.0
    arm = drawing[mark] - drawing[plans.points[point].position]
    return drawing[plans.points[point].velocity] + 1j * omega * arm


def told(plans: Plans, drawing: Drawing) -> int:
    """How many centres were held against the velocity plan, and checks that are rows of a lesson."""
    size, count = plans.longest_link_length, 0
    for c in (c for c in plans.centres if c.mark):
        one, two = (velocities(plans, drawing, x, c.mark) for x in c.links)
        if one is None or two is None:
            continue
        near = (np.abs(drawing[c.mark]) < FAR * size) & np.isfinite(one + two)  # where the mechanism goes together
        if not near.any():
            continue
        others = [drawing[m.velocity] for m in plans.points.values() if m.velocity in drawing.program.result_names]
        scale = np.maximum(np.abs(one), np.nanmax([np.abs(v) for v in np.broadcast_arrays(*others)], axis=0))
        assert np.all((np.abs(one - two) <= CLOSE * scale)[near]), c.name
        count += 1
    for check in plans.checks:
        speeds = [np.abs(drawing[omega] * drawing[far]) for omega, far in check.sides]
        if check.read:
            own = next(s for s in plans.segments if s.name == check.name and s.plan == "velocity")
            speeds.append(np.abs(drawing[VELOCITY_PLAN.mark(own.end)] - drawing[VELOCITY_PLAN.mark(own.start)]))
        near = np.logical_and.reduce([drawing[far] < FAR * size for _, far in check.sides]) & np.isfinite(sum(speeds))
        assert np.all((np.abs(speeds[0] - speeds[1]) <= CLOSE * np.maximum(*speeds) + 1e-12)[near]), check
        count += 1
    return count


@pytest.mark.few(12, slow=30)
@pytest.mark.parametrize("file", SAMPLES, ids=[f.stem for f in SAMPLES])
def test_both_links_of_every_centre_have_its_velocity(file: Path) -> None:
    plans, drawing = drawn(load(str(file)))
    assert told(plans, drawing) >= len(plans.checks)
    links = len(plans.mechanism.links) + 1
    assert len(plans.centres) == (0 if plans.at_rest else LEFT.get(file.stem, links * (links - 1) // 2))


def test_random_mechanisms_have_them_too() -> None:
    held = 0
    for seed in range(30):
        plans, drawing = drawn(loads(any_scene(seed)[1], f"seed {seed}"), 5)
        held += bool(told(plans, drawing))
    assert held >= 25


def test_three_centres_lie_on_one_line() -> None:
    """Of every three links, though no more than two such lines were drawn for a centre."""
    plans, drawing = drawn(load(str(ROOT / "samples" / "six-link.yaml")), 1)
    marks = {frozenset(c.links): complex(drawing[c.mark][0]) for c in plans.centres if c.mark}
    triples = [
        [marks[frozenset(pair)] for pair in combinations(three, 2)]
        for three in combinations("012345", 3)
        if all(frozenset(pair) in marks for pair in combinations(three, 2))
    ]
    assert len(triples) == 12
    for a, b, c in triples:
        area = ((b - a).conjugate() * (c - a)).imag
        assert abs(area) <= CLOSE * max(abs(b - a), abs(c - a), abs(c - b)) ** 2
