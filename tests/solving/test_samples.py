"""Every sample: against the published and exact numbers, and against the independent solver over a turn."""

from __future__ import annotations

import json
import math
import re
from functools import cache
from typing import Any

import pytest

from planes.plans.measuring import plan_name_in_words
from planes.scene import Scene, load
from planes.solving import Position, Solved, solve
from tests.helpers import ROOT
from tests.helpers.oracle import Solution, follow
from tests.helpers.oracle import solve as oracle_solve
from tests.sample_oracle import (
    EXPECTED,
    FUNCTIONS,
    HIGHER,
    SAMPLES,
    SKETCHES,
    UNPUBLISHED,
    flat,
    numeric,
    results,
    sketch,
    truth,
    turned,
)
from tests.sample_oracle import scales as sizes

PUBLISHED = ("six-link", "assignment-12", "bntu-1", "bntu-2", "bntu-3", "bntu-4", "bntu-5")
MORE = ("shaper", "lift", "hinge-motor", "carriage", "folding-boom", "excavator", "friction-circles")
OF_ONE_GROUP = tuple(name for name in UNPUBLISHED if name not in MORE)
NEAR = 1e-9


@cache
def scene(name: str, variant: str | None = None) -> Scene:
    return load(SAMPLES / f"{name}.yaml", variant)


@cache
def solved(name: str) -> Solved:
    return solve(scene(name))


@cache
def stored(name: str) -> dict[str, Any]:
    found: dict[str, Any] = json.loads((EXPECTED / f"{name}.json").read_text(encoding="utf-8"))
    return found


class Value(dict[str, Any]):
    """Values of the program by name, read when they are asked for."""

    def __init__(self, position: Position) -> None:
        super().__init__()
        self.position = position

    def __missing__(self, name: str) -> Any:
        return self.position.drawing[name]


def names(position: Position) -> dict[str, Any]:
    """What the expressions of the expected files may name, from one solved position."""
    found = position.results
    points, links, slides = found["points"], found["links"], found["slides"]
    reactions = {k: r["force"] if isinstance(r, dict) else r for k, r in found["reactions"].items()}
    segments = {s["name"]: s["value"] for p in found["plans"].values() for s in p["segments"].values()}
    vectors = {
        s.name: (position.drawing[s.plan.mark(s.end)] - position.drawing[s.plan.mark(s.start)])
        / position.scales[f"mu_{s.plan}"]
        for s in position.plans.segments
        if s.plan in found["plans"]
    }
    drive = position.plans.mechanism.drive
    return FUNCTIONS | {
        "abs": abs,
        **{k: {n: complex(*p[k]) for n, p in points.items()} for k in "rva"},
        "phi": {n: w["angle_deg"] for n, w in links.items()},
        "omega": {n: w["omega"] for n, w in links.items()},
        "epsilon": {n: w["epsilon"] for n, w in links.items()},
        "F": {k: complex(*z) for k, z in reactions.items()},
        "coriolis": {n: complex(*s["coriolis"]) for n, s in slides.items()},
        "M": found.get("balancing_moment"),
        "segment": segments,
        "vector": vectors,
        "value": Value(position),
        "q": 1 / drive.velocity if drive.velocity else math.nan,
    }


@pytest.mark.parametrize("name", PUBLISHED)
def test_published_examples(name: str) -> None:
    """Exact to rounding; each printed value within its tolerance, or wrong for a reason that stands beside it."""
    known = names(solved(name).positions[0])
    for row in stored(name)["quantities"]:
        found, exact, printed = eval(row["read"], known), row["exact"], row["published"]
        assert abs(found - exact) <= NEAR * abs(exact), (row["quantity"], found)
        if row["verdict"] == "right":
            allowed = row.get("tolerance_abs", abs(exact) * row.get("tolerance_rel", 0.0))
            assert abs(printed - found) <= allowed, (row["quantity"], printed, found)
            continue
        assert row["reason"] and abs(printed - found) > row.get("tolerance_rel", 0.03) * abs(exact)


def test_how_much_was_published() -> None:
    counted = {name: len(stored(name)["quantities"]) for name in PUBLISHED}
    assert counted == {
        "six-link": 52,
        "assignment-12": 31,
        "bntu-1": 7,
        "bntu-2": 9,
        "bntu-3": 5,
        "bntu-4": 10,
        "bntu-5": 12,
    }
    absolute = [row.get("tolerance_abs") for row in stored("assignment-12")["quantities"]]
    assert all(t is not None and t < 5.2e-6 for t in absolute)


def test_six_link_signed_vectors_moments_and_transmission() -> None:
    known, rows = names(solved("six-link").positions[0]), stored("six-link")["signed"]
    exact = [complex(*row["exact"]) if isinstance(row["exact"], list) else row["exact"] for row in rows]
    scale = {
        unit: max(abs(e) for e, row in zip(exact, rows, strict=True) if row["unit"] == unit)
        for unit in {row["unit"] for row in rows}
    }
    for row, want in zip(rows, exact, strict=True):
        assert abs(eval(row["read"], known) - want) <= NEAR * scale[row["unit"]], row["read"]
    assert len(rows) == 30


def test_six_link_moment_equation_about_the_inner_hinge() -> None:
    plans = solved("six-link").plans
    equation = next(m for m in plans.moments if m.unknown == "F_21^t")
    assert equation.about == "C" and equation.links == ("2",)
    assert {name for name, _ in equation.terms} >= {"G_2", "I_2", "F_24", "MI_2"}


def test_six_link_assembles_between_two_angles() -> None:
    low, high = stored("six-link")["turn_deg"]
    tries = solve(scene("six-link"), [low - 0.01, low + 0.01, high - 0.01, high + 0.01])
    assert [p.at for p in tries.positions] == [low + 0.01, high - 0.01]
    assert [f["phi_deg"] for f in tries.failed] == [low - 0.01, high + 0.01]
    assert all("mm" in f["error"] and "C" in f["error"] for f in tries.failed)


def compare(found: dict[str, Any], want: dict[str, Any], loose: float = 1.0) -> None:
    """Every number of the wanted results is among the found ones, to 1e-9 of the largest of its sort."""
    got, expected = flat(found), flat(want)
    assert {p for p in got if not p[0].startswith("zhukovsky")} == set(expected)
    unit = sizes(expected)
    for path, (sort, value) in expected.items():
        other, allowed = got[path][1], NEAR * loose * unit[sort]
        if sort == "arm":
            allowed *= shift(expected, path, unit)
        if sort == "arm" and (value is None or other is None):
            push = abs(expected[*path[:-1], "force"][1] or 0.0)
            assert value == other or push <= NEAR * loose * unit["force"], path
            continue
        assert value is not None and other is not None, path
        apart = abs(math.remainder(value.real - other.real, 360)) if sort == "angle" else abs(value - other)
        assert apart <= allowed, (path, value, other)
    for path, (sort, value) in got.items():
        if path[0].startswith("zhukovsky"):
            balance = expected[path[0].replace("zhukovsky", "balancing"),][1] or 0.0
            assert value is not None and abs(value - balance) <= NEAR * loose * unit[sort], path


def test_a_sliding_driver_is_among_the_slides() -> None:
    assert solved("sliding-driver").positions[0].results["slides"]["1"]["v"] == pytest.approx(1.0)


def shift(numbers: Any, path: tuple[str, ...], unit: dict[str, float]) -> float:
    """How much an arm is worse known than a length: it is a couple divided by a force that may be small."""
    return float(unit["force"] / max(abs(numbers[*path[:-1], "force"][1] or 0.0), 1e-9 * unit["force"])) ** 2


def oracle(name: str, solution: Solution) -> dict[str, Any]:
    return results(solution, "balancing_moment" if "phi" in numeric(name)["drive"] else "balancing_force")


@pytest.mark.parametrize("name", [name for name in SKETCHES if name not in HIGHER])
def test_against_the_independent_solver(name: str) -> None:
    compare(solved(name).positions[0].results, oracle(name, truth(name)))


@pytest.mark.parametrize("name", (*UNPUBLISHED, *HIGHER))
def test_against_the_stored_results(name: str) -> None:
    want = stored(name)["positions"][0]
    key = "phi_deg" if "phi_deg" in want else "s"
    found = solved(name).positions[0].results
    assert found[key] == pytest.approx(want[key], rel=1e-15)
    compare(found, want)


@pytest.mark.few(0, slow=5)
@pytest.mark.parametrize("name", [name for name in SKETCHES if name not in HIGHER])
def test_twelve_positions_of_a_turn(name: str) -> None:
    """A full turn by continuation; of the others every position that assembles, from the pose as drawn."""
    drive = numeric(name)["drive"]
    step, start = (30.0, drive["phi"]) if "phi" in drive else (0.02, drive["s"] - 0.1)
    values = [start + step * i for i in range(12)]
    found = solve(scene(name), values)
    drawn = {p.at: p.results for p in found.positions}
    part = {"six-link": 6, "hinge-motor": 11}
    assert len(drawn) == part.get(name, 12), found.failed
    whole = name not in (*part, "kind-4-prp", "sliding-driver")
    solutions = turned(name, values) if whole else ((v, from_pose(name, v, r)) for v, r in drawn.items())
    for value, solution in solutions:
        compare(drawn[value], oracle(name, solution), 1 / bluntest(drawn[value]))


@pytest.mark.few(0, slow=9)
@pytest.mark.parametrize("name", HIGHER)
def test_positions_of_class_three_and_four(name: str) -> None:
    """Every position of a turn that the assembly reaches, from where the plans put the links."""
    start = numeric(name)["drive"]["phi"]
    found = solve(scene(name), [start + 30.0 * i for i in range(12)])
    for p in found.positions:
        compare(p.results, oracle(name, from_pose(name, p.at, p.results)), 1 / bluntest(p.results))


def from_pose(name: str, value: float, found: dict[str, Any]) -> Solution:
    """The independent solution at another value of the drive, started from where the plans put the links."""
    case = numeric(name)
    drive = case["drive"]
    firsts = {link: next(iter(body["points"])) for link, body in case["links"].items()}
    guess = {
        link: (*found["points"][p]["r"], math.radians(found["links"][link]["angle_deg"])) for link, p in firsts.items()
    }
    return oracle_solve(case | {"drive": drive | {"phi" if "phi" in drive else "s": value}}, guess)


def bluntest(found: dict[str, Any]) -> float:
    """The smallest sharpness of a position: what rounding is magnified by."""
    return float(min([1.0, *(s for plan in found["plans"].values() for s in plan["sharpness"].values() if s > 0)]))


@pytest.mark.few(2)
@pytest.mark.parametrize("variant", "АБВГДЕ")
def test_variants_of_assignment_12(variant: str) -> None:
    chosen = scene("assignment-12", variant)
    drive = numeric("assignment-12", variant)["drive"]
    assert (drive["omega"], drive["epsilon"]) == (16, 70)
    start = numeric("assignment-12")["drive"]["phi"]
    case = numeric("assignment-12", variant)
    solution = follow(case | {"drive": drive | {"phi": start}}, sketch("assignment-12"), drive["phi"], 90)
    compare(solve(chosen).positions[0].results, oracle("assignment-12", solution))


def test_vectors_in_closed_form() -> None:
    """v_C = v_B + v_CB with two lines of action: by the law of sines."""
    out = solve(scene("vectors")).json()["vectors"]
    turn = {name: math.radians(a) for name, a in (("v_B", 120), ("v_CB", 35), ("v_C", 80))}
    want = {
        "v_B": 2.0,
        "v_C": 2 * math.sin(turn["v_B"] - turn["v_CB"]) / math.sin(turn["v_C"] - turn["v_CB"]),
        "v_CB": 2 * math.sin(turn["v_B"] - turn["v_C"]) / math.sin(turn["v_C"] - turn["v_CB"]),
    }
    for name, size in want.items():
        z = complex(*out[name]["xy"])
        assert abs(z - size * complex(math.cos(turn[name]), math.sin(turn[name]))) <= 4e-9, name


ALL = (*SKETCHES, "vectors")
CALCULATIONS = {"crank-slider"}  # not a mechanism of groups: the integrated calculation has tests of its own


def test_every_sample_is_known_here() -> None:
    higher = {p.relative_to(SAMPLES).with_suffix("").as_posix() for p in SAMPLES.glob("class-*/**/*.yaml")}
    assert set(HIGHER) == higher and set(SKETCHES) == {*PUBLISHED, *UNPUBLISHED, *HIGHER}
    assert ({path.stem for path in SAMPLES.glob("*.yaml")} - CALCULATIONS) | higher == set(ALL)
    kept = {path.relative_to(EXPECTED).with_suffix("").as_posix() for path in EXPECTED.rglob("*.json")}
    kept = {name for name in kept if not name.startswith("statics")}  # bodies in equilibrium have theirs
    assert kept == {*PUBLISHED, *UNPUBLISHED, *HIGHER}


@pytest.mark.parametrize("name", ALL)
def test_texts_are_in_two_languages_and_comments_too(name: str) -> None:
    found, text = scene(name), (SAMPLES / f"{name}.yaml").read_text(encoding="utf-8")
    for words in (found.title, found.note):
        assert words["ru"] != words["en"] and any("а" <= c <= "я" for c in words["ru"]) and words["en"].strip()
        assert not any("а" <= c.lower() <= "я" for c in words["en"].replace("А to Е", ""))
    said = [line.partition("# ")[2].partition(" / ") for line in text.splitlines()[1:] if "# " in line]
    assert said
    for russian, _, english in said:
        assert any("а" <= c <= "я" for c in russian.lower()) and english
        assert not any("а" <= c <= "я" for c in english.lower())


@pytest.mark.parametrize("name", OF_ONE_GROUP)
def test_plans_of_the_kinds_look_well(name: str) -> None:
    """No vector under 1 mm, of forces half of it (but those that are zero), none above 200 mm, no blunt crossing, no
    warning."""
    found = solved(name).positions[0].results
    assert not found["warnings"]
    assert solved(name).plans.structure.groups[0].pair_letters == (
        name.split("-")[2].upper() if "kind" in name else "RRR"
    )
    for plan, drawn in found["plans"].items():
        kind = plan.partition(":")[0]
        if kind == "position":
            continue
        lengths = [s["mm"] for s in drawn["segments"].values()]
        assert plan_name_in_words(plan, "en") and max(lengths) <= 200, plan
        least = 0.5 if kind == "force" else 1
        assert all(mm >= least or mm < 1e-9 for mm in lengths), (plan, drawn["segments"])
        assert all(s > math.sin(math.radians(20)) for s in drawn["sharpness"].values()), plan


def test_both_links_of_the_five_groups_are_loaded() -> None:
    for name in OF_ONE_GROUP:
        mechanism = scene(name).mechanism
        assert mechanism and mechanism.gravity == 9.81 and {load.link for load in mechanism.loads} == {"2", "3"}
        assert all(link.mass for link in mechanism.links.values())
    rubbing = [name for name in UNPUBLISHED if (m := scene(name).mechanism) and m.friction]
    assert rubbing == ["kind-2-rrp", "carriage", "friction-circles"]


def test_guides_of_samples_are_lettered_so_that_a_sheet_of_either_language_can_have_them() -> None:
    for path in (ROOT / "samples").rglob("*.yaml"):
        if "\ndrive" in (text := path.read_text(encoding="utf-8")) and "planes: 1" in text:
            mechanism = load(path).mechanism
            assert mechanism
            names = {g for link in (mechanism.frame, *mechanism.links.values()) for g in link.guides}
            assert not [name for name in names if re.search("[a-z]{2}", name)], path


@pytest.mark.parametrize("name", PUBLISHED)
def test_a_segment_with_the_name_of_a_points_vector_is_as_long(name: str) -> None:
    """By the rates of points, which are measured by themselves; a chain of three ends at its third vector."""
    found = solved(name).positions[0]
    for plan, vectors in (("velocity", found.v), ("acceleration", found.a)):
        shown = found.results["plans"][plan]["segments"].values()
        named = {one["name"]: one["value"] for one in shown}
        sizes = {key: abs(vectors[key[2:]]) for key in named if key[2:] in vectors}
        assert {key: named[key] for key in sizes} == pytest.approx(sizes, rel=1e-9) and len(sizes) > 1


def test_a_normal_part_ends_at_a_mark_of_its_own() -> None:
    """The reaction in the last hinge is F^τ + F^n; the plan of the published group letters the ends of both."""
    shown = solved("six-link").positions[0].results["plans"]["force:2-3"]["segments"]
    named = {one["name"]: ends for ends, one in shown.items()}
    assert (named["F_30^n"], named["F_21^n"], named["F_32"]) == ("F_30tF_30n", "F_30np", "F_30nF_24")


@pytest.mark.parametrize("name", ["six-link", "class-three/two-basic-links", "class-three/three-basic-links"])
def test_both_parts_of_a_reaction_have_its_name(name: str) -> None:
    for plan, one in solved(name).positions[0].results["plans"].items():
        named = [segment["name"] for segment in one["segments"].values() if plan.startswith("force:")]
        across, along = ({n[:-2] for n in named if n.endswith(part)} for part in ("^t", "^n"))
        assert across == along
