"""Details: every vector too short to be read is drawn once more, enlarged by a standard scale, with its name."""

from __future__ import annotations

import cmath
import math
import re
from dataclasses import replace

import pytest

from planes.scene import load
from planes.solving import solve
from planes.words.names import ACCELERATION_PLAN, VELOCITY_PLAN
from planes.words.naming import Naming
from render.paper.hues import DETAIL_NAME_SUFFIX
from render.paper.marks import Arc, Arrow, Text
from render.views.detail import (
    ENLARGEMENT_SCALES,
    LEAST_READABLE_VECTOR_MM,
    LEAST_VISIBLE_PART_MM,
    free_detail_letters,
    look_like_one_line,
    make_details,
)
from render.views.plotted import plot_position
from render.views.polygon import SHARED_LABEL_MM, Polygon
from tests.helpers import ROOT
from tests.helpers.sheets import sheet

SAMPLES = {path.stem: path for path in sorted((ROOT / "samples").glob("*.yaml"))}


POINT_MM = 1.3  # what is longer is enlarged less than twenty times
CROWDED = {"assignment-12": None, "kind-5-rpp": None, "crank-slider": None, "kind-3-rpr": 2, "kind-4-prp": 2}


@pytest.mark.few(0)
@pytest.mark.parametrize(("name", "number"), list(CROWDED.items()))
def test_every_short_vector_is_drawn_again_larger(name, number):
    found = sheet(name, number=number)
    titles = [m.text for m in found.marks if isinstance(m, Text) and re.fullmatch(r"\w \(\d+:1\)", m.text)]
    assert len({t[0] for t in titles}) == len(titles)
    said = [m.text for m in found.marks if isinstance(m, Text)]
    assert all(said.count(title[0]) == 1 for title in titles)  # the letter on the plan itself
    plans = [v for v, _, _ in found.views if v.key in ("velocity", "acceleration") or v.key.startswith("force")]
    arrows = [a for v in plans for a in v.marks if isinstance(a, Arrow)]
    least = {
        a.name: LEAST_VISIBLE_PART_MM if a.name.endswith(DETAIL_NAME_SUFFIX) else LEAST_READABLE_VECTOR_MM
        for a in arrows
        if a.name
    }
    short = [a for a in arrows if a.name and abs(a.end - a.start) < least[a.name] - 1e-6]
    assert short
    names = {m.name for m in found.marks if isinstance(m, Text)}
    for one in short:
        if one.layer in ("force", "result") and one.name in names and abs(one.end - one.start) < POINT_MM:
            continue  # by itself it is a point with its name
        span = one.end - one.start
        times = [(a.end - a.start) / span for a in arrows if a.name.endswith(DETAIL_NAME_SUFFIX)]
        assert any(abs(t - k) < 1e-6 * k for t in times for k in ENLARGEMENT_SCALES), one.name


@pytest.mark.parametrize("number", ["07", "25", "44"])
def test_marks_that_a_detail_draws_apart_are_named_apart(number):
    scene = replace(load(SAMPLES["six-link"].parent / "assignments" / f"{number}.yaml"), find=None)
    position, naming = solve(scene).positions[0], Naming("ru")
    for plan in (VELOCITY_PLAN, ACCELERATION_PLAN):
        polygon = Polygon(plot_position(position), plan, naming)
        polygon.drawn_marks()
        for one in make_details(polygon.places.values(), "ABCDEFG"):
            named = [x for x in polygon.mark_labels(SHARED_LABEL_MM / one.times) if one.shows_whole(x)]
            for label in polygon.plotted.mark_labels(plan):
                z = polygon.mark(label)
                held = [x for x in named if naming.mark(label, plan) in x.text.split(", ")]
                if held:
                    assert one.times * abs(held[0].at - z) <= SHARED_LABEL_MM
        texts = {m.text for m in Polygon(plot_position(position), plan, naming).drawn_marks() if isinstance(m, Text)}
        if (number, plan) == ("44", "acceleration"):
            assert "n_{EK}" in texts


def test_neighbours_share_a_detail():
    found = make_details([(0j, 2 + 0j), (2 + 0j, 2 + 1j), (50j, 51j), (0j, 80 + 0j)], "AB")
    assert [(d.centre, d.title) for d in found] == [(1 + 0.5j, "A (10:1)"), (50.5j, "B (20:1)")]
    assert isinstance(found[0].circle(), Arc)
    assert found[0].contains_place(2 + 0j) and not found[0].contains_place(4 + 0j)


def test_what_is_lost_in_a_detail_has_one_of_its_own():
    found = make_details([(0j, 2 + 0j), (2 + 0j, 2 + 0.1j), (2 + 0.1j, 2 + 2j)], "ABC")
    assert [(d.centre, d.times) for d in found] == [(1 + 1j, 5), (2 + 0.05j, 100)]
    spread = make_details([(2j * k, 2j * k + 0.1) for k in range(9)], "ABCDEFGHI")
    assert [d.centre for d in spread] == [2j * k + 0.05 for k in range(9)] and {d.times for d in spread} == {100}


@pytest.mark.parametrize(("turn_deg", "read"), [(0, True), (1.5, True), (2.5, True), (8, False)])
def test_forces_that_lie_on_one_line_in_their_detail_are_read_as_one(turn_deg, read):
    way = cmath.rect(1, math.radians(90 + turn_deg))
    (one,) = make_details([(0j, -way)], "A")
    assert look_like_one_line((-20j, 0j), (0j, -way), [one]) is read
    assert not look_like_one_line((-20j, 0j), (0j, -way), [])


def test_a_detail_is_not_called_like_a_point():
    assert free_detail_letters(["A", "B", "C", "O", "S2"], "АБВГДЕЖ")[:3] == ["Б", "Г", "Д"]
    assert free_detail_letters(["A", "B", "C"], "ABCDEF")[:2] == ["D", "E"]


def test_a_force_by_itself_is_not_enlarged_twenty_times():
    one, two = (0j, 0.5 + 0j), (0.5 + 0j, 0.5 + 0.4j)
    assert [d.times for d in make_details([one], "AB")] == [40] and make_details([one], "AB", False) == []
    assert len(make_details([one, two], "AB", False)) == 1
    assert [d.times for d in make_details([(0j, 2 + 0j)], "AB", False)] == [10]
