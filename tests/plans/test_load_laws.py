"""Loads that are laws of the motion: against the independent solver, in every form, one position or many."""

from __future__ import annotations

import math
import random
import re
from dataclasses import replace

import numpy as np
import pytest

from planes.accuracy.digits import Digits
from planes.batch.cycle import Cycle
from planes.course.papers import condition_sentences
from planes.drafting.drawing import draw_program
from planes.drafting.instruments import Pencil
from planes.lesson.note import Note
from planes.plans import plans_of
from planes.plans.law_words import law_in_words
from planes.plans.scales import drawn_in_si
from planes.scene import Scene, loads
from planes.scene.mechanism import LoadLaw, StrokeLoad
from planes.solving import solve as planes_solve
from planes.solving.document import DocumentTable
from planes.solving.given import GivenTable
from planes.solving.of_scene import solve as solve_one
from planes.words import say
from planes.words.errors import PlanesError, SceneError
from planes.words.naming import Naming
from planes.words.units import PLANS_WITH_MU
from tests.helpers.comparing import against
from tests.helpers.mechanisms import KINDS, to_yaml
from tests.helpers.mixtures import lawful
from tests.helpers.oracle import follow

MOST = 1e-9


@pytest.mark.parametrize("seed", range(24))
def test_laws_of_any_form_agree_with_the_independent_solver(seed) -> None:
    kinds = tuple(random.Random(seed).choices(KINDS, k=1 + seed % 3))
    case = lawful(seed, kinds, friction=seed % 4 == 3, rest=seed % 8 == 5)
    _, apart = against(case)
    assert max(apart.values()) < MOST, sorted(apart.items(), key=lambda x: -x[1])[:3]


@pytest.mark.needs("llvmlite")
@pytest.mark.few(3)
@pytest.mark.parametrize("seed", range(8))
def test_many_positions_have_the_numbers_of_each(seed) -> None:
    case = lawful(100 + seed, (KINDS[seed % 5],), friction=seed % 4 == 3, rest=seed == 6)
    scene = loads(to_yaml(case.scene))
    assert scene.mechanism
    cycle, drive = Cycle(plans_of(scene.mechanism), None), scene.mechanism.drive
    values = [drive.position + (2.0 if drive.kind == "phi" else 1e-3) * k for k in range(-8, 9)]
    arrays, loop = (next(cycle.blocks(values, fast=fast)) for fast in (False, True))
    assert (arrays.codes == loop.codes).all() and (~arrays.failed_mask).sum() >= 5
    units = [c.unit for c in cycle.columns]
    most = [np.nanmax(abs(arrays.table[[k for k, x in enumerate(units) if x == u]])) for u in units]
    balancing = next(k for k, c in enumerate(cycle.columns) if c.value == cycle.plans.balancing)
    for i in np.flatnonzero(~arrays.failed_mask):
        one = drawn_in_si(cycle.plans, values[i])
        for k, column in enumerate(cycle.columns):
            numbers = arrays.table[k, i], loop.table[k, i], column.read_from_drawing(one.things, one.tool.ar)
            assert np.nanmax(np.abs(np.subtract.outer(numbers, numbers))) <= MOST * most[k] or column.beside
        sol = follow(case.scene, case.guess, values[i], 4)
        assert abs(arrays.table[balancing, i] - sol.balancing) < MOST * most[balancing]


@pytest.mark.parametrize("seed", range(4))
def test_no_number_of_a_law_is_further_off_than_claimed(seed) -> None:
    scene = loads(to_yaml(lawful(200 + seed, ("RRR", "RRP")).scene))
    assert scene.mechanism
    cycle = Cycle(plans_of(scene.mechanism), None)
    own = scene.mechanism.drive.position
    table, claimed = cycle.table(np.array([own]), fast=False)[0], cycle.error_claims.error_bounds_of_columns([own])
    truth = draw_program(cycle.program, {**cycle.given, cycle.plans.drive_given_name: own}, Digits(40))
    for column, found, bound in zip(cycle.columns, table[:, 0], claimed[:, 0], strict=True):
        if not column.beside:
            assert abs(column.read_from_drawing(truth.things, truth.tool.ar) - found) <= bound, column.name


ENGINE = """planes: 1
parameters: {l_OA: 0.08, phi_1: 40, P: 3000, F: P*sin(phi_1)}
variants: {B: {P: 1000, phi_1: 90}}
frame: {points: {O: [0, 0]}, guides: {x-x: {y: 0}}}
links:
  1: {points: {O: 0, A: l_OA}}
  2: {points: {A: 0, B: 0.3}, mass: 2}
  3: {points: {B: 0}, slides: x-x, mass: 1}
assembly: {B: ahead}
drive: {link: 1, phi: phi_1, omega: 10}
loads: [{link: 3, point: B, force: LAW, direction: 180}]
"""


def engine(law: str, **parameters: float) -> Scene:
    return loads(ENGINE.replace("LAW", law), "e.yaml", **parameters)


def load_at(scene: Scene, *values: float) -> list[float]:
    return [p.results["loads"]["P_3"] for p in planes_solve(scene, values or None).positions]


def test_the_drives_own_parameter_follows_the_drive() -> None:
    for law in ('"P*sin(phi_1)"', "F", '"3000*sin(phi)"'):
        assert load_at(engine(law), 40, 90, -30) == pytest.approx([3000 * math.sin(math.radians(40)), 3000, -1500])
    assert load_at(loads(ENGINE.replace("LAW", "F"), variant="B"), 90, 30) == pytest.approx([1000, 500])
    assert load_at(engine("F", phi_1=90)) == pytest.approx([3000])
    again = loads(engine("F").to_yaml())
    assert again.mechanism == engine("F").mechanism and load_at(again, 30) == pytest.approx([1500])


def test_a_number_that_holds_in_one_position_is_refused_on_either_side_of_it() -> None:
    """The speed is taken from the drive's own parameter, so it is not known one degree back, nor one ahead."""
    scene = loads(ENGINE.replace("LAW", "5").replace("omega: 10", "omega: phi_1/4"), "e.yaml")
    assert scene.mechanism and planes_solve(scene, [40]).positions[0].omega["1"] == pytest.approx(10)
    plans = plans_of(scene.mechanism)
    for value in (39.0, 41.0, np.array([40.0, 39.0]), np.array([41.0, 40.0])):
        with pytest.raises(SceneError, match="valid at phi = 40 only"):
            plans.drive_givens_at(value)
    assert plans.drive_givens_at(40.0) == {plans.drive_given_name: 40.0}
    assert (plans.drive_givens_at(np.full(2, 40.0))[plans.drive_given_name] == 40).all()
    assert plans.drive_givens_at(39.0, known={"omega_1"}) == {plans.drive_given_name: 39.0}  # another speed is said


def test_a_table_over_a_turn_repeats_itself() -> None:
    scene = engine("{over: phi_1, table: [[-90, 10], [0, 40], [180, 100], [270, 10]]}")
    assert load_at(scene, 90, 450, -270, 225, -135, 0, 270) == pytest.approx([70, 70, 70, 55, 55, 40, 10])


def test_strokes_and_their_ends() -> None:
    scene = engine("{working: 6000, idle: {over: s_3, table: [[0.22, 0], [0.38, 160]]}, stroke: behind}")
    assert load_at(scene, 90) == [6000]
    assert load_at(scene, 270) == pytest.approx([(math.sqrt(0.3**2 - 0.08**2) - 0.22) * 1000])
    (ends,) = planes_solve(scene, [180]).positions
    assert ends.results["loads"]["P_3"] == 0 and "3: the speed is zero" in ends.results["warnings"][0]
    resting = loads(ENGINE.replace("LAW", "{working: 6000, idle: 1}").replace(", omega: 10", ""))
    assert load_at(resting, 90, 270) == [0, 0]  # with the driver at rest there is no stroke
    hand = planes_solve(scene, [0, 180, 359.99], Pencil())
    assert not hand.failed


def test_a_parameter_with_the_name_of_another_motion_is_refused() -> None:
    """phi_2 is the angle of link 2, and so is no name for the crank's; phi_1 is both the parameter and the angle."""
    assert load_at(engine('"3000*sin(phi_1)"'), 90) == pytest.approx([3000])
    with pytest.raises(SceneError, match="phi_2 is a parameter, and could also be the angle of link 2"):
        loads(ENGINE.replace("phi_1", "phi_2").replace("LAW", '"3000*sin(phi_2)"'), "e.yaml")
    rate = ENGINE.replace("omega: 10", "omega: omega_2").replace("l_OA: 0.08,", "l_OA: 0.08, omega_2: 10,")
    with pytest.raises(SceneError, match="omega_2 is a parameter"):
        loads(rate.replace("LAW", '"phi + omega_2"'), "e.yaml")
    own = rate.replace("omega_2", "omega_1").replace("LAW", '"phi + omega_1"')
    assert load_at(loads(own, "e.yaml"), 50) == [60]


def test_a_stroke_of_a_driver_at_rest_loads_nothing_and_says_so() -> None:
    scene = loads(ENGINE.replace("LAW", "{working: 6000, idle: 200}").replace("omega: 10", "omega: 0, epsilon: 5"))
    (found,) = planes_solve(scene, [40]).positions
    assert found.results["loads"]["P_3"] == 0
    assert any(said.startswith("3: the speed is zero") for said in found.results["warnings"])


REFUSED = [
    ("F_21", "e.yaml:11: force of load 1: F_21 is found only after the loads, so none can depend on it; valid: phi, "),
    ("v_9", 'force of load 1: "v_9": the name "v_9" is not defined; valid'),
    ("2*v_P", "v_P is a parameter, and could also be the speed of point P; give the parameter another name"),
    ('"2*v_3"', "v_3 could be the speed of point 3 or the velocity of link 3 along its guide; give the point another"),
    ("s_3^phi", "a quantity that varies may be raised to a whole power or a half, at most 20"),
    ("{over: P, table: [[0, 1], [1, 2]]}", "a table needs something that varies after over"),
    ("{over: phi, table: [[0, 1]]}", "e.yaml:11: table of force of load 1 has 1 pairs [x, value]; it needs"),
    ("{over: phi, table: [[0, 1], [0, 2]]}", "the first numbers of the pairs must increase, but 0 follows 0"),
    ("{over: phi, table: [[0, 1], [360, 2]]}", "goes over a whole turn, but begins with 1 and ends with 2"),
    ("{working: 1}", "force of load 1 needs the key idle"),
    ("{working: 1, idle: 2, slider: 2}", 'there is no sliding pair "2"; valid: 3'),
    (
        "{over: s_3, table: [[0, 1], [0.3, 2]]}",
        "P_3 (line 11 of the scene) goes over s_3 from 0 to 0.3, and here that is",
    ),
    ("sqrt(s_3 - 1)", "the law of P_3 (line 11 of the scene) has no value here"),
    ("1/(phi - 40)", "the law of P_3 (line 11 of the scene) has no value here"),
]


@pytest.mark.parametrize(("law", "words"), REFUSED, ids=[law for law, _ in REFUSED])
def test_what_is_no_law_is_refused_in_one_sentence(law, words) -> None:
    text = ENGINE.replace("LAW", law if law[0] in '{"' else f'"{law}"')
    text = text.replace("B: 0.3}", "B: 0.3, P: 0.1, 3: 0.2}")
    text = text.replace("{l_OA", "{v_P: 1, l_OA" if "v_P" in law else "{l_OA")
    with pytest.raises(PlanesError) as refusal:
        solve_one(loads(text, "e.yaml"))
    assert words in refusal.value.told("en") and re.search("[а-я]{4}", refusal.value.told("ru"))


def test_laws_of_a_mechanism_built_in_python() -> None:
    built = engine("1").mechanism
    assert built
    law = LoadLaw("200*sin(phi)"), LoadLaw("s_3", ((0.2, 10.0), (0.4, 30.0))), StrokeLoad(LoadLaw("v_3^2"), 7.0, "3")
    for value, now in zip(law, (200 * math.sin(math.radians(40)), 25.68, 7.0), strict=True):
        scene = Scene(
            mechanism=replace(built, loads=(replace(built.loads[0], value=value),)), mu=dict.fromkeys(PLANS_WITH_MU)
        )
        assert load_at(scene) == pytest.approx([now], rel=1e-3)
    for value in (LoadLaw("sin("), LoadLaw("M_1"), StrokeLoad(1.0, 2.0, "2")):
        with pytest.raises(SceneError, match=r"^e.yaml:11: "):
            plans_of(replace(built, loads=(replace(built.loads[0], value=value),)), "e.yaml")


@pytest.mark.parametrize("lang", ["ru", "en"])
def test_law_and_value_are_told(lang) -> None:
    scene = loads(ENGINE.replace("LAW", "{working: F, idle: 200, stroke: behind}") + "find: [P_3, M_1]\n")
    law = {"en": "3000·sin(⟨phi_1⟩)", "ru": "3000·sin(⟨phi_1⟩)"}[lang]
    (here,) = planes_solve(scene).positions
    assert here.value("P_3") == pytest.approx(3000 * math.sin(math.radians(40)))
    note = [row for b in Note(scene, here, lang).opening_blocks() if isinstance(b, DocumentTable) for row in b.rows]
    assert any(row[:2] == ("P_{3}", "1928") for row in note)
    assert any(law in line for line in condition_sentences(here.plans, lang))
    given = GivenTable(here, Naming(lang), scene.parameters)
    assert ("P_{3}", "1928", {"en": "N", "ru": "Н"}[lang]) in [*given.given_rows(), *given.load_law_rows()]
    newton = say("N", lang)
    assert list(given.load_law_formulas()) == [
        f"P_{{3}} = (3000·sin(φ_{{1}})), {newton} ({say('stroke_working', lang)})",
        f"P_{{3}} = 200 {newton} ({say('stroke_idle', lang)})",
    ]


def test_only_squares_and_cubes_have_small_figures() -> None:
    drive = loads(ENGINE.replace("LAW", "5")).mechanism.drive
    assert (
        law_in_words(LoadLaw("phi^2 + 2*phi^3 - phi^4/phi^-1"), drive, str, "en") == "phi_1²+2·phi_1³−phi_1^4/phi_1^−1"
    )
