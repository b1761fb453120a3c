"""Plans of stated vectors: the samples against their mechanisms, random systems of equations against a linear solver,
arcs against their closed form, numbers carried from plan to plan, and what cannot be drawn."""

from __future__ import annotations

import cmath
import json
import math
import random
import re
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

import planes
from planes.cli import main
from planes.drafting.instruments import Pencil
from planes.plans.statements.of_scene import scene_plans
from planes.scene import load, loads
from planes.solving import Position, solve
from planes.words.errors import SceneError
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"


def solved(text: str) -> Position:
    return solve(loads(text, "s.yaml")).positions[0]


def polar(z: complex) -> str:
    return f"value: {abs(z)!r}, direction: {math.degrees(cmath.phase(z))!r}"


def scene(vectors: dict[str, str], equations: list[str], more: str = "") -> str:
    rows = "".join(f"  {name}: {{{given}}}\n" for name, given in vectors.items())
    return f"planes: 1\nvectors:\n{rows}equations:\n" + "".join(f"  - {e}\n" for e in equations) + more


def vectors(found: Position) -> dict[str, complex]:
    return {name: one.vector for name, one in found.of("vectors").items()}


# samples


def test_the_six_link_by_equations_has_the_numbers_of_the_mechanism() -> None:
    stated, mechanism = (planes.solve(planes.load(SAMPLES / f"{n}.yaml")) for n in ("vectors/six-link", "six-link"))
    found = vectors(stated)
    for point in ("B", "C", "S2", "H"):
        assert found[f"v_{point}"] == pytest.approx(mechanism.v[point], rel=1e-11)
        assert found[f"a_{point}"] == pytest.approx(mechanism.a[point], rel=1e-11)
    for link in "23":
        assert stated.value(f"omega_{link}") == pytest.approx(mechanism.omega[link], rel=1e-11)
        assert stated.value(f"epsilon_{link}") == pytest.approx(mechanism.epsilon[link], rel=1e-11)
    assert found["a_HL^k"] == pytest.approx(mechanism.value("coriolis_4"), rel=1e-11)
    assert found["v_HL"] == pytest.approx(mechanism.drawing["∥CL"] * mechanism.value("v_slide_4"), rel=1e-11)


def test_the_group_by_its_equation_has_the_reactions_of_the_mechanism() -> None:
    stated, mechanism = (planes.solve(planes.load(SAMPLES / f"{n}.yaml")) for n in ("vectors/group", "six-link"))
    found = vectors(stated)
    for name, own in (("F_21", "F_21"), ("F_36", "F_30"), ("F_32", "F_32")):
        assert found[name] == pytest.approx(mechanism.value(own), rel=1e-9)
    assert list(stated.results["plans"]) == ["force:2-3"]  # the inner reaction is read off the group's plan


def test_the_slider_by_its_equation_has_friction_as_the_mechanism() -> None:
    stated, mechanism = (planes.solve(planes.load(SAMPLES / f"{n}.yaml")) for n in ("vectors/friction", "bntu-2"))
    found = vectors(stated)
    assert found["F_30"] == pytest.approx(mechanism.value("F_30"), rel=1e-11)
    assert found["F_21"] == pytest.approx(mechanism.value("F_21"), rel=1e-11)
    assert found["N_30"] == pytest.approx(1j * mechanism.value("N_30"), rel=1e-11)
    assert stated.value("P_T") == pytest.approx(mechanism.value("P_T30"), rel=1e-11)
    assert stated.value("M_1") == pytest.approx(mechanism.value("M_1"), rel=1e-11)


# systems against a linear solver


@pytest.mark.parametrize("seed", range(30))
def test_a_system_of_lines_is_what_a_linear_solver_finds(seed: int) -> None:
    """Vectors of known or unknown length along known lines, with coefficients and signs, in equations any two of which
    share vectors: each row has two new lengths. The order of the file is shuffled."""
    rnd = random.Random(seed)
    rows = rnd.randint(2, 5)
    known = {f"F_{k}": cmath.rect(rnd.uniform(1, 3), rnd.uniform(0, 2 * math.pi)) for k in range(1, 5)}
    given = {name: polar(z) for name, z in known.items()}
    lines = {f"u{k}": rnd.uniform(-180, 180) for k in range(2 * rows)}
    equations, matrix, right = [], np.zeros((2 * rows, 2 * rows)), np.zeros(2 * rows)
    for row in range(rows):
        lines[f"u{2 * row + 1}"] = lines[f"u{2 * row}"] + rnd.uniform(35, 145) * rnd.choice((-1, 1))
        terms = [(f"u{k}", rnd.choice((1.0, -1.0, 0.5, -2.0))) for k in (2 * row, 2 * row + 1)]
        terms += [(f"u{k}", rnd.choice((1.0, -1.0, 3.0))) for k in rnd.sample(range(2 * row), min(2 * row, 2))]
        terms += [(name, rnd.choice((1.0, -1.0, 1.5))) for name in rnd.sample(sorted(known), 2)]
        rnd.shuffle(terms)
        cut = rnd.randint(0, len(terms))
        sides = []
        for side, sign in ((terms[:cut], 1.0), (terms[cut:], -1.0)):
            told = "".join(f" {'+' if c * sign > 0 else '-'} {abs(c)!r}*{n}" for n, c in side)
            sides.append(re.sub(r"\b1\.0\*", "", told.removeprefix(" + ")) or "0")
        equations.append(f'"{" = ".join(sides)}"')
        for name, c in terms:
            if name in known:
                right[2 * row : 2 * row + 2] -= c * np.array([known[name].real, known[name].imag])
            else:
                z = cmath.rect(c, math.radians(lines[name]))
                matrix[2 * row : 2 * row + 2, int(name[1:])] += [z.real, z.imag]
    lengths = np.linalg.solve(matrix, right)
    given = {name: text for name, text in given.items() if any(name in e for e in equations)}
    given |= {name: f"direction: {angle!r}" for name, angle in lines.items()}
    text = scene({k.replace("u", "F_9"): v for k, v in given.items()}, [e.replace("u", "F_9") for e in equations])
    found = vectors(solved(text))
    for name, angle in lines.items():
        want = cmath.rect(lengths[int(name[1:])], math.radians(angle))
        assert found[name.replace("u", "F_9")] == pytest.approx(want, rel=1e-8, abs=1e-9), name


@pytest.mark.parametrize("seed", range(12))
@pytest.mark.parametrize("kind", ["arc", "arcs"])
def test_arcs_in_a_chain_of_contours_are_the_vectors_they_were_made_of(kind: str, seed: int) -> None:
    rnd = random.Random(f"{kind}{seed}")
    true, given, equations, last = {}, {}, [], ""
    for k in range(3):
        corners = [cmath.rect(rnd.uniform(1, 2), math.radians(120 * j + rnd.uniform(-20, 20))) for j in range(3)]
        turn = true[last] / (corners[1] - corners[0]) if last else 1.0
        sides = [turn * (b - a) for a, b in pairwise([*corners, corners[0]])]
        names = [last or "r_0", f"r_{2 * k + 1}", f"r_{2 * k + 2}"]
        for name, z in zip(names, sides, strict=True):
            near = f"near: {math.degrees(cmath.phase(z)) + rnd.uniform(-8, 8)!r}"
            parts = {names[0]: polar(z), names[1]: f"value: {abs(z)!r}, {near}"}
            line = f"direction: {math.degrees(cmath.phase(z)) + rnd.choice((0, 180))!r}"
            given.setdefault(name, parts.get(name, line if kind == "arc" else f"value: {abs(z)!r}"))
            true.setdefault(name, z)
        equations.append(f"{names[0]} + {names[1]} = -{names[2]}")
        last = names[2]
    found = vectors(solved(scene(given, equations[::-1])))
    assert found == pytest.approx(true, abs=1e-8)


# numbers of plans before


FOUR_BAR = (ROOT / "docs" / "scene.md").read_text("utf-8").split("```yaml\n")[2].split("```")[0]


def four_bar() -> tuple[complex, complex, float, float]:
    """B→C, D→C, ω2 and ε2 of the four-bar of the docs, by intersection of circles and two linear systems."""
    b, d = cmath.rect(0.1, math.radians(60)), 0.35 + 0j
    along = (d - b) / abs(d - b)
    x = (0.3**2 - 0.25**2 + abs(d - b) ** 2) / (2 * abs(d - b))
    c = b + along * complex(x, math.sqrt(0.3**2 - x * x))
    bc, dc = c - b, c - d
    system = np.array([[(1j * bc).real, -(1j * dc).real], [(1j * bc).imag, -(1j * dc).imag]])
    w2, w3 = np.linalg.solve(system, [-(20j * b).real, -(20j * b).imag])
    rest = 400 * b + w2 * w2 * bc - w3 * w3 * dc
    e2, _ = np.linalg.solve(system, [rest.real, rest.imag])
    return bc, dc, w2, e2


def test_v_squared_over_l_comes_from_the_plan_before() -> None:
    found, (bc, dc, w2, e2) = solved(FOUR_BAR), four_bar()
    own = vectors(found)
    assert (own["r_BC"], own["r_DC"]) == (pytest.approx(bc), pytest.approx(dc))
    assert (found.value("omega_2"), found.value("epsilon_2")) == (pytest.approx(w2), pytest.approx(e2))
    assert own["v_S"] == pytest.approx(own["v_B"] + 0.4 * own["v_CB"])
    assert own["v_KB"] == pytest.approx(0.5 * own["v_CB"] * cmath.exp(1j * math.radians(30)))
    assert own["a_CB^n"] == pytest.approx(-w2 * w2 * bc)


def test_an_error_of_the_pencil_is_carried_to_the_next_plan() -> None:
    """The normal acceleration is what the drawn v_CB makes of it, not the true one."""
    scene = loads(FOUR_BAR)
    exact = vectors(solve(scene).positions[0])
    apart = []
    for seed in range(40):
        drawn = solve(scene, instrument=Pencil(seed=seed)).positions[0]
        speed = float(drawn.drawing["v_CB"])
        assert drawn.drawing["a_CB^n"] == pytest.approx(speed * speed / 0.3, rel=1e-12)
        apart.append(abs(vectors(drawn)["a_CB^n"]) - abs(exact["a_CB^n"]))
    assert 0.02 < float(np.std(apart)) < 0.4  # of 6.5 m/s²: 0.3 mm of 20 mm alone would be 0.1


def test_a_figure_like_another_on_its_plan() -> None:
    """v_S by Δbcs ∼ ΔBCS of the contour, whichever marks it starts at."""
    text = scene(
        {
            "r_BC": polar(3 + 1j),
            "r_BS": polar(1 + 2j),
            "r_CS": "",
            "v_B": polar(2j),
            "v_CB": polar(-1 + 0.5j),
            "v_C": "",
            "v_S": "",
            "v_SB": "similar: v_CB, as: [r_BS, r_BC]",
            "v_T": "",
            "v_TC": "similar: v_CB, ratio: 2, angle: 90",
        },
        ["r_BS = r_BC + r_CS", "v_C = v_B + v_CB", "v_S = v_B + v_SB", "v_T = v_C + v_TC"],
    )
    found = vectors(solved(text.replace("{}", "{}")))
    assert found["v_SB"] == pytest.approx((-1 + 0.5j) * (1 + 2j) / (3 + 1j))
    assert found["v_S"] == pytest.approx(2j + found["v_SB"])
    assert found["v_TC"] == pytest.approx(2j * (-1 + 0.5j))


def test_what_lies_end_to_end_is_read_there() -> None:
    plans = scene_plans(load(str(SAMPLES / "vectors" / "group.yaml")))
    spans = {name: tuple(mark.rpartition(":")[2] for mark in ends) for name, ends in plans.vectors.items()}
    assert (
        spans["F_36"] == ("G_3", "F_36n") and spans["F_21"] == ("F_36n", "F_21t") and spans["F_32"] == ("F_36n", "F_24")
    )


def test_a_line_of_action_is_told_by_the_vector_it_is_across() -> None:
    plans = scene_plans(load(str(SAMPLES / "vectors" / "six-link.yaml")))
    lines = {t.name: t.action for e in plans.equations for t in e.all_terms if not t.drawn}
    assert (lines["v_LC"], lines["v_CB"], lines["a_CB^n"]) == ("⊥CH", "⊥BC", "C→B")


def test_each_plan_has_its_own_scale() -> None:
    two = (ROOT / "samples" / "vectors" / "six-link.yaml").read_text("utf-8")
    mus = {plan: one["mu"] for plan, one in solved(two).results["plans"].items()}
    assert mus == {"contour": "250 mm/m", "velocity": "30 mm/(m/s)", "acceleration": "2 mm/(m/s²)"}
    forces = scene({"F_1": "value: 100, direction: 0", "F_2": "value: 50, direction: 90", "R": ""}, ["R = F_1 + F_2"])
    assert solved(forces).results["plans"]["force"]["segments"]["pF_2"]["unit"] == "N"


@pytest.mark.parametrize("path", sorted((SAMPLES / "vectors").glob("*.yaml")), ids=lambda p: p.stem)
def test_samples_are_told_in_two_languages(path: Path) -> None:
    found = load(str(path))
    for words in (found.title, found.note):
        assert re.search("[а-я]", words["ru"]) and not re.search("[а-я]", words["en"]) and words["en"]
    remarks = [
        line.partition("# ")[2].partition(" / ") for line in path.read_text("utf-8").splitlines()[1:] if "# " in line
    ]
    assert all(ru and en and not re.search("[а-я]", en) for ru, _, en in remarks if re.search("[а-яA-Za-z]{3}", ru))


# readers


@pytest.mark.few(3)
@pytest.mark.parametrize("command", ["sheet {} -o a.svg", "note {} -o a.html", "lesson {} -o a.html"])
@pytest.mark.parametrize("name", ["six-link", "group", "friction"])
def test_every_document_is_made(command: str, name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    for lang in ("ru", "en"):
        words = command.format(SAMPLES / "vectors" / f"{name}.yaml").split()
        assert main([*words, "--lang", lang]) == 0
        text = Path(words[-1]).read_text("utf-8")
        assert len(text) > 5000 and not re.search("NaN|undefined|Traceback", text.partition("<script")[0])


def test_a_drawing_of_a_stated_plan_is_checked(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path, file = str(SAMPLES / "vectors" / "six-link.yaml"), tmp_path / "marks.csv"
    (found,) = solve(load(path)).positions
    labels = ("b", "c", "s2", "l", "h")
    marks = {label: complex(found.drawing[f"velocity:{label}"]) for label in labels}
    for label, wrong, status in (("c", 0j, 0), ("c", 6 + 6j, 1)):
        rows = (
            f"{n},{z.real + (n == label) * wrong.real},{z.imag + (n == label) * wrong.imag}" for n, z in marks.items()
        )
        file.write_text("mark,x_mm,y_mm\np,0,0\n" + "\n".join(rows), encoding="utf-8")
        assert main(["check", path, str(file), "--plan", "velocity", "--work", "cad", "--json"]) == status
        report = json.loads(capsys.readouterr().out)
        assert report["verdict"] == ("wrong" if wrong else "right")
        assert report["first_wrong"] == (label if wrong else None)


# refusals

BASE = {"v_B": "value: 2, direction: 120", "v_CB": "direction: 35", "v_C": "direction: 80"}
BAD: list[tuple[dict[str, str], list[str], str, str]] = [
    ({}, ["v_C = v_B + v_CD"], "", "s.yaml:7: v_C = v_B + v_CD: there is no vector v_CD"),
    ({"v_CB": "direction: v_X"}, ["v_C = v_B + v_CB"], "", "s.yaml:4: direction of vector v_CB: there is no vector"),
    ({"v_CB": "direction: v_CB"}, ["v_C = v_B + v_CB"], "", "s.yaml:7: v_C = v_B + v_CB: v_CB is found from v_CB"),
    ({"v_B": "value: v_C^2, direction: 3"}, ["v_C = v_B + v_CB"], "", "v_B is found from v_C, which no equation"),
    ({"v_CB": ""}, ["v_C = v_B + v_CB"], "", "length of v_C, length of v_CB, direction of v_CB"),
    ({"v_CB": "direction: 80"}, ["v_C = v_B + v_CB"], "", "s.yaml:7: v_C = v_B + v_CB: "),
    ({}, ["v_C = v_B + v_CB"], "mu: 1 mm/N\n", "s.yaml:8: mu does not fit v_C: a velocity polygon"),
    ({}, ["v_C = v_B + v_CB"], "mu: 1 mm/m\nplans: {position: {mu: 2 mm/m}}\n", "both mu and plans.position"),
    ({}, ["v_C = v_B + v_CB"], "values: {k: v_C/(v_B + v_CB)}\n", '"v_C/(v_B + v_CB)": a result of'),
    ({}, ["v_C = v_B + v_CB"], "values: {k: sqrt(v_C)}\n", "sqrt takes numbers and parameters"),
    ({}, ["v_C = v_B + v_CB"], "values: {k: v_C^0.5}\n", "raised to a whole power from 1 to 9"),
    ({}, ["v_C = v_B + v_CB"], "values: {k: h, h: k}\n", "s.yaml:8: values: k is found from h, which nothing gives"),
    ({}, ["v_C = v_B + v_CB"], "values: {v_C: 1}\n", "v_C would name a vector and a value"),
    ({}, ["v_C = 0 = v_B + v_CB"], "", "0 is one of several sides"),
    ({}, ["v_C = v_B + 0*v_CB"], "", "v_CB is taken zero times"),
    ({}, ["v_C = v_B + q*v_CB"], "", '"q" is not defined'),
    ({"v_CB": "similar: v_C"}, ["v_C = v_B + v_CB"], "", "needs one of the keys ratio, as"),
    ({"v_CB": "similar: v_C, as: [v_B]"}, ["v_C = v_B + v_CB"], "", "as of vector v_CB has 1 vectors; write two"),
    ({"v_CB": "similar: v_C, ratio: 2, value: 3"}, ["v_C = v_B + v_CB"], "", "both similar and value"),
    ({"v_CB": "similar: v_C, ratio: 2"}, ["v_C = v_B + v_CB"], "", "v_CB is found from v_C"),
]


@pytest.mark.parametrize(("changed", "equations", "more", "words"), BAD)
def test_what_cannot_be_drawn_is_one_sentence(
    changed: dict[str, str], equations: list[str], more: str, words: str
) -> None:
    with pytest.raises(SceneError) as caught:
        solved(scene(BASE | changed, equations, more))
    told = caught.value.told("en")
    assert words in told and re.match(r"s\.yaml:\d+: ", told) and "\n" not in told
    assert re.search("[а-я]", caught.value.told("ru"))


def test_a_vector_that_both_sides_hold_twice_is_not_what_they_add_up_to() -> None:
    given = {"F_1": polar(1), "F_2": polar(1j), "F_3": "direction: 45", "F_4": "direction: -45", "R": ""}
    once = solved(scene(given, ["R = F_1 + F_3", "R = F_2 + F_4"]))
    assert vectors(once)["R"] == pytest.approx(1)  # F_3 is nothing, F_4 is 1 − j
    with pytest.raises(SceneError, match="the unknowns are length of R, direction of R, length of F_3"):
        solved(scene(given, ["2*R = F_1 + F_3", "2*R = F_2 + F_4"]))


def test_a_length_that_closes_a_polygon_is_held_against_it() -> None:
    """Of R its length alone is given, and all else is known: 3 and 4 across it are 5 together."""
    given = {"F_1": polar(3), "F_2": polar(4j), "R": "value: 5"}
    assert vectors(solved(scene(given, ["R = F_1 + F_2"])))["R"] == pytest.approx(3 + 4j)
    with pytest.raises(SceneError, match=r"0\.5"):
        solved(scene(given | {"R": "value: 5.5"}, ["R = F_1 + F_2"]))
