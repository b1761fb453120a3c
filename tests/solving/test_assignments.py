"""The 68 assignments in their six variants: drawn with forces, and every number against the independent solver.

The scenes are read a second time here, by a YAML reader and an evaluator of its own, so that a slip of the
program's reader is seen too. The schemes are reconstructions; what was known of each before its scene was
written (groups, branch, range of the block on its line) is the table ``SCHEMES``.
"""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import pytest
import yaml

from planes.course.survey import survey_rows
from planes.drafting.drawing import draw_program
from planes.plans import plans_of
from planes.plans.scales import plan_scales
from planes.scene import load
from tests.helpers import ROOT
from tests.helpers.comparing import Drawn, closing_mm, differences, expected, measured_closing_mm, power
from tests.helpers.oracle import Solution
from tests.helpers.oracle import solve as solve_independently

FOLDER = ROOT / "samples" / "assignments"
VARIANTS = "АБВГДЕ"
FILES = sorted(FOLDER.glob("*.yaml"))
CLOSE = 1e-9

# What the command ``planes solve samples/assignments --lang en`` lists, in all six variants; the rest is in full.
NO_TURN = "the driver 1 makes no full turn: the mechanism does not assemble from 224.4° to 315.6°"
EXCEPTIONS = {
    28: "links 4 and 5: the table gives them neither lengths nor coordinates",
    29: "the table gives no mass m_4",
    66: NO_TURN,
    68: NO_TURN,
}

# Kinds of the groups of links 2, 3 and 4, 5: 1 RRR, 2 RRP, 3 RPR, 4 PRP, 5 RPP.
GROUPS = {
    (2, 3): [1, 2, 16, 23, 24, 33],
    (2, 4): [3, 4, 5, 6, 9, 40, 41],
    (1, 4): [7, 8, 17, 18, 22, 25, 26, 34, 62, 63],
    (2, 5): [10, 36],
    (3, 5): [11, 12, 31],
    (3, 2): [13, 14, 15, 19, 20, 27, 29, 32, 46],
    (3, 4): [30, 45],
    (3, 1): [43, 44],
    (1, 3): [21, 38, 39, 57, 58, 59, 60, 61],
    (1,): [28],
    (1, 2): [35, 37, 47, 48, 49, 50, 51, 52, 53, 54, 55, 56],
    (2, 2): [42, 64, 65, 66, 67, 68],
}
# Where a point must be, seen from another one, in all six variants.
SIDES = {
    **dict.fromkeys((1, 2, 5, 6, 23, 24), "C above A"),
    **dict.fromkeys((3, 9), "C left of A"),
    **dict.fromkeys((4, 10, 16, 33, 36, 40, 41, 42), "C right of A"),
    **dict.fromkeys(range(49, 64), "B above C"),
    **dict.fromkeys(range(64, 69), "B right of A"),
    26: "C above D",
    7: "C above D",
}
# How far the point of the block is from a point of its line, from and to, m, over the six variants.
RANGES = {
    1: ("D", "E", 0.41, 0.61),
    3: ("E", "B", 0.2, 0.4),
    4: ("E", "C", 0.32, 0.34),
    7: ("K", "C", 0.172, 0.211),
    8: ("K", "B", 0.053, 0.268),
    16: ("B", "D", 0.3, 0.7),
    17: ("K", "D", 0.2, 0.303),
    18: ("K", "C", 0.316, 0.336),
    20: ("D", "B", 0.2106, 0.5107),
    21: ("E", "H", 0.106, 0.231),
    22: ("E", "D", 0.2, 0.264),
    23: ("E", "H", 0.47, 0.85),
    25: ("E", "D", 0.3, 0.455),
    26: ("E", "D", 0.1, 0.151),
    34: ("E", "D", 0.2, 0.278),
    35: ("E", "D", 0.283, 0.335),
    40: ("D", "C", 0.45, 0.481),
    41: ("D", "C", 0.45, 0.474),
    42: ("D", "B", 0.217, 0.454),
    43: ("C", "B", 0.18, 0.42),
    44: ("C", "B", 0.19, 0.43),
    49: ("D", "A", 1.044, 1.045),
}

TEXTS = ("link", "point", "against", "centre")  # keys whose values are names, never numbers
FUNCTIONS = {"sin": lambda x: math.sin(math.radians(x)), "cos": lambda x: math.cos(math.radians(x))}


def number(value: Any, names: Mapping[str, float]) -> Any:
    """A node of the file as the independent solver wants it: expressions evaluated, names of points kept."""
    if isinstance(value, Mapping):
        return {k: v if k in TEXTS else number(v, names) for k, v in value.items()}
    if isinstance(value, list):
        return [number(v, names) for v in value]
    if set(re.findall(r"[^\W\d]\w*", value)) <= {*names, *FUNCTIONS}:
        return float(eval(value, {"__builtins__": {}}, {**FUNCTIONS, **names}))
    return value


def plain(path: Path, variant: str) -> dict[str, Any]:
    """The scene of one variant as a numeric dict, read without the program."""
    raw = yaml.load(path.read_text(encoding="utf-8"), Loader=yaml.BaseLoader)
    names = {k: float(v) for k, v in {**raw["parameters"], **raw["variants"][variant]}.items()}
    return {k: number(raw[k], names) for k in ("frame", "links", "drive", "loads", "gravity")}


def drawn(path: Path, variant: str) -> Drawn:
    """The variant drawn at automatic scales."""
    scene = load(path, variant)
    assert scene.mechanism
    plans = plans_of(scene.mechanism)
    mu = dict(plan_scales(plans, scene.mu, {}))
    return Drawn(scene, plans, mu, draw_program(plans.program, {**plans.given, **mu}))


def independent(d: Drawn, scene: Mapping[str, Any]) -> Solution:
    """The same position by Newton's iteration, started a little off the drawn place of every link."""
    guess = {}
    for name, link in scene["links"].items():
        first, spot = next(iter(link["points"].items()))
        assert spot == 0, f"the first point of link {name} is the origin of its axes"
        at = d.place(d.plans.points[first].position)
        guess[name] = (at.real + 1e-4, at.imag - 1e-4, math.radians(d.number(d.plans.links[name].angle)) + 1e-4)
    return solve_independently(scene, guess)


@pytest.mark.few(4)
@pytest.mark.parametrize("path", FILES, ids=[p.stem for p in FILES])
def test_all_variants_against_the_independent_solver(path: Path) -> None:
    """Both balancing moments, closing of all polygons, power, and every number."""
    for variant in VARIANTS:
        d, scene = drawn(path, variant), plain(path, variant)
        where = f"{path.stem} {variant}"
        allowed = CLOSE / min(1.0, d.sharpest)
        balancing, lever = d.number(d.plans.balancing), d.number(d.plans.zhukovsky)
        assert abs(balancing - lever) <= CLOSE * abs(balancing), where
        assert closing_mm(d) <= allowed * 100 and measured_closing_mm(d) <= allowed * 100, where
        total, largest = power(d)
        assert abs(total) <= allowed * largest, where
        truth = {n.name: n for n in expected(independent(d, scene), True)}
        wrong = {k: e for k, e in differences(d, truth).items() if not e <= allowed}
        assert not wrong, (where, wrong)


@pytest.mark.few(2, slow=12)
@pytest.mark.parametrize("path", FILES, ids=[p.stem for p in FILES])
def test_the_table_of_all_positions_lists_what_is_not_in_full(path: Path) -> None:
    lines = survey_rows((str(path), "en", None))
    assert "".join(line.variant for line in lines) == VARIANTS
    for line in lines:
        assert line.is_right and line.balancing is not None and line.difference is not None, line
        exception = EXCEPTIONS.get(int(path.stem))
        assert len(line.remarks) == (exception is not None)
        assert exception is None or line.remarks[0].startswith(exception)


def test_every_assignment_and_variant_is_there() -> None:
    assert [int(p.stem) for p in FILES] == list(range(1, 69))
    for path in FILES:
        scene = load(path)
        assert "".join(scene.variants) == VARIANTS and scene.parameters["phi_1"] == load(path, "А").parameters["phi_1"]
        comments = " ".join(line for line in path.read_text("utf-8").splitlines() if line.startswith("# "))
        for lang, lost, sure in (("ru", "утрачен", "Уверенность "), ("en", "lost", "Confidence is ")):
            assert lost in comments and sure in comments and path.stem.lstrip("0") in scene.title[lang]
            assert lost not in scene.note[lang] and sure not in scene.note[lang]  # a drawing has no word of it


def test_groups_are_those_of_the_reconstruction() -> None:
    kinds = {n: kinds for kinds, numbers in GROUPS.items() for n in numbers}
    assert sorted(kinds) == list(range(1, 69))
    for path in FILES:
        scene = load(path)
        assert scene.mechanism
        s, n = plans_of(scene.mechanism).structure, int(path.stem)
        assert s.W == 1 and tuple(g.kind for g in s.groups) == kinds[n], path.stem
        pairs = [{"2", "3"}, {"4", "5"}][: len(s.groups)]
        assert [set(g.links) for g in s.groups] == pairs and (len(pairs) == 2 or n == 28)


@pytest.mark.slow
def test_branches_are_those_of_the_reconstruction() -> None:
    """The stated sides, and the block within its stated range on its line, in all variants."""
    for path in FILES:
        n = int(path.stem)
        for variant in VARIANTS if n in SIDES or n in RANGES else "":
            d = drawn(path, variant)
            place = {k: d.place(marks.position) for k, marks in d.plans.points.items()}
            if n in SIDES:
                point, word, base = SIDES[n].replace(" of", "").split()
                z = place[point] - place[base]
                assert {"above": z.imag, "left": -z.real, "right": z.real}[word] > 0, (n, variant)
            if n in RANGES:
                one, two, least, most = RANGES[n]
                assert least - 1e-9 <= abs(place[one] - place[two]) <= most, (n, variant)
