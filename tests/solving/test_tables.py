"""Tables of what was found and of what is given: equal decimals in a column, each thing once, nothing of nothing."""

import pytest

from planes.lesson.conditions import condition_sentences
from planes.plans.statements.of_scene import scene_plans
from planes.scene import loads
from planes.solving import solve
from planes.solving.given import GivenTable
from planes.solving.tables import solve_report_text
from planes.solving.text_tables import rows_with_equal_decimals
from planes.words.naming import Naming

OFFSET = """
planes: 1
parameters: {l_OA: 0.08, l_AB: 0.26, e: 0.02, phi_1: 60}
frame: {points: {O: [0, 0]}, guides: {x-x: {y: -e}}}
links:
  1: {points: {O: 0, A: l_OA}, mass: 1, inertia: 0.01}
  2: {points: {A: 0, B: l_AB, S2: 0.1}, mass: 2, inertia: 0.03, centre: S2}
  3: {points: {B: 0}, slides: x-x, mass: 3}
assembly: {B: ahead}
drive: {link: 1, phi: phi_1, omega: 20}
gravity: 9.81
"""
AXIS = """
planes: 1
frame: {points: {O: [0, 0], D: [0.4, 0.1]}}
links:
  1: {points: {O: 0, A: 0.1}, mass: 3}
  2: {points: {A: 0, B: 0.4}}
  3: {points: {D: 0, B: 0.3, S3: 1e-17}, centre: S3, mass: 5}
assembly: {B: left}
drive: {link: 1, phi: 61, omega: 3, epsilon: 1}
gravity: 0
"""


@pytest.mark.parametrize(
    ("column", "even"),
    [
        (["1.2", "1.25"], ["1.20", "1.25"]),
        (["2", "1.987", "0", "—"], ["2.000", "1.987", "0", "—"]),
        (["590.5", "30.93", "500"], ["590.5", "30.93", "500.0"]),  # no more than four digits are known
        (["0,05", "−0,3891"], ["0,0500", "−0,3891"]),
        (["60", "20"], ["60", "20"]),
    ],
)
def test_numbers_of_a_column_have_as_many_decimals(column: list[str], even: list[str]) -> None:
    assert [row[1] for row in rows_with_equal_decimals([("1.5", cell) for cell in column])] == even


def test_an_offset_is_given_once_and_every_mass_centre_is_named() -> None:
    scene = loads(OFFSET)
    (position,) = solve(scene).positions
    names = [row.name for row in GivenTable(position, Naming("en"), scene.used).listed_givens()]
    assert "e = −y_{x–x}" in names and "y_{x–x}" not in names
    assert any("1 — ⟨O⟩, 2 — ⟨S2⟩, 3 — ⟨B⟩" in told for told in condition_sentences(scene_plans(scene), "ru"))


def test_a_force_polygon_of_rounding_alone_is_nothing() -> None:
    solved = solve(loads(AXIS))
    assert {plan["mu"] for name, plan in solved.positions[0].results["plans"].items() if "force" in name} == {"1 mm/N"}
    assert solve_report_text(solved, "en").count("all its forces are zero; there is nothing to draw") == 2
