"""The small figures of directions: what they show follows from what they are drawn with."""

from __future__ import annotations

import cmath
import math

import pytest

from planes.plans.measuring import scene_lettering
from planes.scene import load
from planes.solving import solve
from planes.words.names import split_value_name
from planes.words.naming import Naming
from render.paper.marks import Arc, Arrow, Line, Shape, Text
from render.views.directions import Directions
from tests.helpers import ROOT

SCENES = sorted(p for f in ("", "assignments") for p in (ROOT / "samples" / f).glob("*.yaml") if p.stem != "vectors")


def sense(marks) -> float:
    """Which way the curved arrow of a figure turns, by where its head is."""
    (head,) = [m for m in marks if isinstance(m, Shape)]
    (arc,) = [m for m in marks if isinstance(m, Arc) and m.fill == "none"]
    tip = cmath.phase((head.points[0] - arc.centre) / cmath.rect(1, math.radians((arc.start_deg + arc.end_deg) / 2)))
    return math.copysign(1, tip)


@pytest.mark.few(8)
@pytest.mark.parametrize("path", SCENES, ids=lambda p: p.stem)
def test_senses_follow_from_the_vectors(path):
    """v = ω×r, a^t = ε×r and a^k = 2ω×v, each about what is solved for the link."""
    scene = load(path)
    position = solve(scene).positions[0]
    figures = Directions(position, Naming("en", **scene_lettering(scene, position.plans)))
    links = position.results["links"]
    for marks in figures.rotation_figures():
        (arrow,) = [m for m in marks if isinstance(m, Arrow)]
        (rod,) = [m for m in marks if isinstance(m, Line) and m.style == "thick"]
        (rate,) = [m.name for m in marks if isinstance(m, Text) and m.name.startswith(("omega", "epsilon"))]
        turn = ((arrow.end - arrow.start) * (rod.points[1] - rod.points[0]).conjugate()).imag
        key, link, _ = split_value_name(rate)
        assert turn * sense(marks) > 0 and turn * links[link][key] > 0, rate
        assert math.isclose(abs(turn), abs(arrow.end - arrow.start) * abs(rod.points[1] - rod.points[0]), rel_tol=1e-6)
    for marks in figures.coriolis_figures():
        velocity, acceleration = (m.end - m.start for m in marks if isinstance(m, Arrow))
        (rate,) = [m.name for m in marks if isinstance(m, Text) and m.name.startswith("omega")]
        turn = (acceleration * velocity.conjugate()).imag
        assert turn * sense(marks) > 0 and turn * links[split_value_name(rate)[1]]["omega"] > 0, rate


def test_every_turning_link_and_every_coriolis_acceleration_has_its_figure():
    position = solve(load(ROOT / "samples" / "six-link.yaml")).positions[0]
    figures = Directions(position, Naming("en"))
    assert len(list(figures.rotation_figures())) == 4 and len(list(figures.coriolis_figures())) == 1
    at_rest = solve(load(ROOT / "samples" / "bntu-1.yaml")).positions[0]
    assert Directions(at_rest, Naming("en")).directions_view("") is None
