"""Scenes of vectors alone: every kind of equation against the sum of its own vectors, units, instruments, refusals."""

from __future__ import annotations

import cmath
import math
import random
import re
from itertools import pairwise

import pytest

from planes.accuracy.errors import add_errors_to_results
from planes.drafting.instruments import Instrument, Pencil
from planes.scene import Scene, loads
from planes.solving import Position, Solved, solve
from planes.solving.explaining import explain_steps
from planes.words.errors import SceneError

FORCES = """planes: 1
vectors:
  F_21^t: {value: 5551, direction: 125}
  G_2: {value: 392, direction: -90}
  Φ_2: {value: 2540, direction: 144}
  F_24: {value: 7700, direction: 214.7}
  F_36^n: {direction: 83}
  F_21^n: {direction: 35}
equations: [force:2-3: "F_21^t + G_2 + Φ_2 + F_24 + F_36^n + F_21^n = 0"]
"""
ARCS = """planes: 1
vectors: {r_1: {value: 0.3, direction: 10}, r_2: {value: 0.25, near: 80}, r_3: {value: 0.2}}
equations: ["r_1 + r_2 + r_3 = 0"]
"""
CHAIN = """planes: 1
vectors: {v_B: {value: 2, direction: 60}, v_CB: {perpendicular_to: 35}, v_C: {perpendicular_to: 83},
          v_LC: {value: 1.2, direction: 35}, v_L: {}}
equations: ["v_C = v_B + v_CB", "v_L = v_C + v_LC"]
mu: 30 mm/(m/s)
"""


def scene_of(vectors: str, *equations: str, more: str = "") -> str:
    return f"planes: 1\nvectors: {{{vectors}}}\nequations: {list(equations)}\n{more}"


def drawn(scene: Scene | str, by: Instrument | None = None) -> Position:
    """The scene as it is solved, with its ±."""
    return with_errors(scene, by).positions[0]


def with_errors(scene: Scene | str, by: Instrument | None = None) -> Solved:
    found = solve(loads(scene) if isinstance(scene, str) else scene, instrument=by)
    add_errors_to_results(found, by)
    return found


def vectors(found: Position) -> dict[str, complex]:
    return {name: one.vector for name, one in found.of("vectors").items()}


def total(text: str, found: Position) -> complex:
    """Left minus right of an equation, with the vectors found."""
    left, right = text.split("=")
    side = {1: left, -1: right}
    terms = [(s, t) for s, part in side.items() for t in re.findall(r"([+-]?)\s*([^\s+-]+)", part) if t[1] != "0"]
    return sum(s * (-1 if sign == "-" else 1) * vectors(found)[name] for s, (sign, name) in terms)


def test_a_force_polygon_closes():
    found = drawn(FORCES)
    assert abs(total("F_21^t + G_2 + Φ_2 + F_24 + F_36^n + F_21^n = 0", found)) < 1e-9
    for name, degrees in (("F_36^n", 83), ("F_21^n", 35)):
        assert math.sin(cmath.phase(vectors(found)[name]) - math.radians(degrees)) == pytest.approx(0, abs=1e-12)
    assert found.results["plans"]["force:2-3"]["mu"].endswith("mm/N")


@pytest.mark.parametrize("turn", [7, 83, 190, 301])
@pytest.mark.parametrize("hidden", ["close", "cross", "arc", "arcs"])
@pytest.mark.parametrize("sides", [0, 1, 2, 3])
def test_every_kind_on_every_side(hidden, sides, turn):
    """A closed polygon of five is stated with two parts hidden, and its vectors on either side: they are found."""
    rnd = random.Random(f"{hidden}{sides}{turn}")
    corners = [cmath.rect(rnd.uniform(1, 3), math.radians(turn + 72 * k)) for k in range(5)]
    true = {f"F_{k}": b - a for k, (a, b) in enumerate(pairwise([*corners, corners[0]]), 1)}
    one, other = "F_3", "F_3" if hidden == "close" else "F_5"
    given = {}
    for name, v in true.items():
        value, way = f"value: {abs(v)!r}", f"direction: {math.degrees(cmath.phase(v))!r}"
        near = f"near: {math.degrees(cmath.phase(v)) + 3}"
        parts = {name: f"{value}, {way}"}
        if name in (one, other):
            kind = {"close": "", "cross": way, "arcs": f"{value}, {near}"}
            parts = {name: kind.get(hidden, way if name == one else f"{value}, {near}")}
        given |= parts
    moved = [["F_1", "F_2", "F_3", "F_4", "F_5"], ["F_5", "F_1", "F_2"], ["F_2", "F_4"], ["F_1", "F_4"]][sides]
    left = " + ".join(n for n in true if sides == 0 or n not in moved)
    right = "0" if sides == 0 else "-" + " - ".join(moved)
    stated = ", ".join(f"{n}: {{{text}}}" for n, text in given.items())
    found = drawn(scene_of(stated, f"{left} = {right}"))
    assert vectors(found) == pytest.approx(true, abs=1e-9)


def test_a_name_tells_no_links_and_a_truss_is_one_plan():
    """P_1 loads node 1, and no force plan of link 1 is meant; a plan of some links is named where its equation is."""
    truss = """planes: 1
vectors: {P_1: {value: 10, direction: -90}, N_12: {direction: 45}, N_13: {direction: 135}, R_2: {direction: 90},
  N_23: {direction: 0}, R_3: {}}
equations: ["P_1 + N_12 + N_13 = 0", "R_2 - N_12 + N_23 = 0", "R_3 - N_13 - N_23 = 0"]
"""
    found = drawn(truss)
    assert list(found.results["plans"]) == ["force"] and vectors(found)["R_2"] == pytest.approx(5j)
    named = drawn(truss.replace('["P_1 + N_12 + N_13 = 0",', '[force:1: "P_1 + N_12 + N_13 = 0",'))
    assert list(named.results["plans"]) == ["force:1", "force"]
    for plan, words in (("velocity", "not under"), ("force:", "not under")):
        with pytest.raises(SceneError, match=words):
            loads(truss.replace('["P_1 + N_12 + N_13 = 0",', f'["{plan}": "P_1 + N_12 + N_13 = 0",'))


def test_minus_signs_close_a_polygon_too():
    found = drawn(
        scene_of("F_1: {value: 3, direction: 0}, F_30: {direction: 90}, F_21: {direction: 45}", "F_1 + F_30 = -F_21")
    )
    assert vectors(found)["F_30"] == pytest.approx(3j) and vectors(found)["F_21"] == pytest.approx(-3 - 3j)


def test_two_arcs_by_the_nearer_of_either_vector():
    found = drawn(ARCS)
    assert abs(total("r_1 + r_2 + r_3 = 0", found)) < 1e-14 and vectors(found)["r_2"].imag > 0
    other = loads(ARCS.replace(", near: 80", "").replace("value: 0.2}", "value: 0.2, near: 114}"))
    assert vectors(drawn(other))["r_2"].imag < 0 < vectors(drawn(other))["r_3"].imag


def test_a_vector_found_before_may_stand_alone_on_its_side():
    more = CHAIN.replace('v_C + v_LC"]', 'v_C + v_LC", "v_L = v_D + v_LD"]')
    more = more.replace("v_L: {}", "v_L: {}, v_D: {}, v_LD: {value: 1, direction: 10}")
    found = drawn(more)
    assert abs(total("v_L = v_D + v_LD", found)) < 1e-12


@pytest.mark.parametrize(
    ("names", "plan", "unit"),
    [
        ("F_1 F_2 F_3", "force", "mm/N"),
        ("v_B v_CB v_C", "velocity", "mm/(m/s)"),
        ("r_1 r_2 r_3", "contour", "mm/m"),
        ("a_B a_CB a_C", "acceleration", "mm/(m/s²)"),
        ("a b c", "vectors", "mm/unit"),
        ("P R F_1", "force", "mm/N"),
        ("Φ_2 G_2 N", "force", "mm/N"),
    ],
)
def test_the_unit_is_told_by_the_names(names, plan, unit):
    one, two, three = names.split()
    found = drawn(
        scene_of(
            f"{one}: {{value: 2, direction: 120}}, {two}: {{direction: 35}}, {three}: {{direction: 80}}",
            f"{three} = {one} + {two}",
        )
    )
    assert list(found.results["plans"]) == [plan] and found.results["plans"][plan]["mu"].endswith(unit)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        (
            scene_of("v_B: {value: 2, direction: 60}, v_C: {}, F_1: {value: 4, direction: 10}", "v_C = v_B + F_1"),
            ("s.yaml:3: v_C belongs on the velocity polygon and F_1 on the force polygon",),
        ),
        (FORCES + "mu: 30 mm/(m/s)\n", ("s.yaml:10: mu does not fit F_21^t", "mm/N or N/mm")),
        (CHAIN.replace("v_L: {}", "v_L: {}, v_X: {value: 1, direction: 3}"), ("v_X is in no equation",)),
        (CHAIN.replace("v_C: {", "v_C: {near: 5, "), ("near of vector v_C has no effect",)),
        (CHAIN + "find: [v_Q]\n", ("s.yaml:6: ", "v_Q", "valid: v_B, v_CB")),
    ],
)
def test_what_would_change_nothing_is_refused(text, words):
    with pytest.raises(SceneError) as caught:
        solve(loads(text, "s.yaml"))
    for word in words:
        assert word in str(caught.value)
    assert re.search("[а-я]", caught.value.told("ru"))


def test_find_draws_no_more_than_it_needs():
    scene = loads(CHAIN + "find: [v_C]\n")
    found = drawn(scene)
    assert list(vectors(found)) == ["v_C"] and "vectors:l" not in found.drawing and "dropped" in explain_steps(scene)
    assert vectors(found)["v_C"] == pytest.approx(vectors(drawn(CHAIN))["v_C"])


def test_a_pencil_scatters_as_it_says():
    exact = drawn(FORCES)
    many = [drawn(FORCES, Pencil(seed=s)) for s in range(60)]
    far = [(vectors(r)["F_36^n"] - vectors(exact)["F_36^n"]).real for r in many]
    claimed = many[0].results["errors"]["vectors"]["F_36^n"][0]
    assert 0.75 < math.sqrt(sum(x * x for x in far) / len(far)) / claimed < 1.25
    assert with_errors(FORCES, Pencil(seed=3)).json() == with_errors(FORCES, Pencil(seed=3)).json()
    weight = many[0].results["plans"]["force:2-3"]["segments"]["F_21tG_2"]
    assert weight["name"] == "G_2" and weight["mm"] % 0.5 == 0 and weight["error_mm"] > 0.1


def test_the_bound_of_an_exact_drawing_holds():
    errors = drawn(FORCES).results["errors"]
    assert 0 < errors["vectors"]["F_21^n"][0] < 1e-9 and errors["vectors"]["G_2"][0] < 1e-11
