"""A reaction shared by the two bearings of a shaft: by moments of the spatial equations, in and outside their span."""

from __future__ import annotations

import random

import numpy as np
import pytest

import planes
from planes.lesson.stated_note import position_note
from planes.scene import loads
from planes.solving import solve
from planes.solving.document import Paragraph
from planes.solving.tables import solve_report_text
from planes.words import available_languages
from planes.words.errors import SceneError

SCENE = """planes: 1
frame: {points: {O: [0, 0], D: [0.4, -0.1]}}
links:
  1: {points: {O: 0, A: 0.1}%s, mass: 3, inertia: 0.1}
  2: {points: {A: 0, B: 0.35, S: 0.1}, mass: 4, inertia: 0.05, centre: S%s}
  3: {points: {D: 0, B: 0.25}%s, mass: 2}
assembly: {B: left}
drive: {link: 1, phi: 60, omega: 20}
loads: [{link: 3, point: B, force: 500, direction: 200}]
gravity: 9.81
"""


def scene(driver: str = "", rod: str = "", rocker: str = "") -> planes.Scene:
    said = (f", bearings: {places}" if places else "" for places in (driver, rod, rocker))
    return loads(SCENE % tuple(said))


def in_space(force: complex, first: float, second: float) -> tuple[float, float]:
    """The parts of a reaction by six equations of a body in space: both bearings hold what acts in the plane z = 0."""
    rows, right = np.zeros((4, 4)), np.zeros(4)
    for k, z in enumerate((first, second)):
        rows[0, 2 * k] = rows[1, 2 * k + 1] = 1.0  # sums of x and y
        rows[2, 2 * k + 1], rows[3, 2 * k] = z, z  # moments about x and y
    right[:2] = force.real, force.imag
    x = np.linalg.solve(rows, right)
    way = force / abs(force)
    return tuple(float((complex(*x[2 * k : 2 * k + 2]) * way.conjugate()).real) for k in range(2))  # type: ignore[return-value]


def test_they_share_it_as_in_space() -> None:
    """Among random places many are overhung: there one bearing acts against the whole reaction."""
    r, against = random.Random(3), 0
    for _ in range(40):
        first, second = r.uniform(-0.3, 0.3), r.uniform(-0.3, 0.3)
        for at in (60.0, 200.0):
            (p,) = solve(scene(f"[{first!r}, {second!r}]", "", f"[{second!r}, {first!r}]"), [at]).positions
            for name, one, two in (("F_10", first, second), ("F_30", second, first)):
                whole = p.of("reactions")[name].vector
                parts = [p.of("bearings")[f"{name}^{k}"].number for k in (1, 2)]
                most = max(abs(whole), *map(abs, parts))
                assert parts == pytest.approx(in_space(whole, one, two), abs=1e-12 * most)
                assert sum(parts) == pytest.approx(abs(whole), abs=1e-12 * most)
                assert (min(parts) < 0) == (first * second > 0)
                against += min(parts) < 0
    assert against > 40


def test_a_table_and_a_name_give_them_too() -> None:
    made = scene("[-0.1, 0.3]")
    table = planes.cycle(made, ["F_10", "F_10^1", "F_10^2"], phi=np.arange(0.0, 360.0, 30.0))
    whole = np.hypot(table["F_10_x"], table["F_10_y"])
    assert table["F_10^1"] == pytest.approx(0.75 * whole, rel=1e-14)
    assert table["F_10^2"] == pytest.approx(0.25 * whole, rel=1e-14)
    (p,) = solve(loads(SCENE % (", bearings: [-0.1, 0.3]", "", "") + "find: [F_10^2]\n")).positions
    assert p.results["bearings"].keys() == {"F_10^2"}


def test_table_json_and_note_tell_them() -> None:
    made = scene("[0.1, 0.3]")
    solved = solve(made)
    (p,) = solved.positions
    assert p.results["bearings"].keys() == {"F_10^1", "F_10^2"} and p.results["bearings"]["F_10^2"] < 0
    assert "Reactions in the bearings of a shaft" in solve_report_text(solved, "en")
    for lang in available_languages():
        told = [b.text for b in position_note(made, p, lang).result_blocks() if isinstance(b, Paragraph)]
        assert sum("⟨F_10^1⟩ = " in t or "⟨F_10^2⟩ = −" in t for t in told) == 2


def test_without_them_nothing_is_shared() -> None:
    (p,) = solve(scene()).positions
    assert not p.of("bearings") and "bearings" not in p.results


@pytest.mark.parametrize(
    ("places", "said"),
    [
        (("[0.1, 0.1]",), "scene.yaml:4: link 1: both bearings are at 0.1 m from the plane of motion"),
        (("", "[-0.1, 0.1]"), "scene.yaml:5: link 2: bearings belong to a link with a hinge on the frame"),
        (("[0.1]",), "scene.yaml:4: "),
        (("[a, 0.1]",), "scene.yaml:4: "),
    ],
)
def test_what_cannot_be_shared_is_refused(places: tuple[str, ...], said: str) -> None:
    with pytest.raises(SceneError) as refusal:
        scene(*places)
    told = refusal.value.told("en")
    assert told.startswith(said) and "\n" not in told and refusal.value.told("uk") != told
