"""Hand drawings of groups of class III and IV: by the independent results with a hand's errors, and with a mistake."""

from __future__ import annotations

import json
import random
from pathlib import Path

import pytest

from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked, mistake_variants, prepare
from planes.check.handed_in import read_paper
from planes.check.outcome import Outcome, check
from planes.drafting.drawing import draw_steps
from planes.drafting.steps import LayOff
from planes.drafting.steps.crossings import Cross
from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic
from planes.scene import load
from planes.solving import solve
from planes.words.names import POLE_LABEL
from tests.sample_oracle import EXPECTED, SAMPLES

NAMES = ("class-three/rods", "class-three/guide", "class-four/tray", "class-four/press", "class-four/two-guides")
Row = tuple[str, complex]


def motion(name: str, plan: str) -> list[Row]:
    """The ends of all points' vectors, mm, by the independent solver."""
    scene = load(SAMPLES / f"{name}.yaml")
    points = json.loads((EXPECTED / f"{name}.json").read_text())["positions"][0]["points"]
    mu, tick = solve(scene).positions[0].scales[f"mu_{plan}"], "'" if plan == "acceleration" else ""
    moving = {p: complex(*found[plan[0]]) * mu for p, found in points.items() if p not in scene.mechanism.frame.points}
    return [(POLE_LABEL, 0j), *((p.lower() + tick, z) for p, z in moving.items())]


def forces(name: str, plan: str) -> list[Row]:
    """The forces laid off one after another; a row of the pole wherever the pen is put down anew."""
    found, rows = solve(load(SAMPLES / f"{name}.yaml")).positions[0], [(POLE_LABEL, 0j)]
    for step in found.plans.program.steps:
        if isinstance(step, LayOff | Cross) and step.makes.startswith(f"{plan}:") and not step.is_auxiliary_mark:
            rows += [(POLE_LABEL, found.drawing[step.start])] if rows[-1][0] != step.start.label else []
            rows.append((step.label, found.drawing[step.makes]))
    return rows


def judged(name: str, plan: str, rows: list[Row], folder: Path) -> Outcome:
    rng, path = random.Random(3), folder / "hand.csv"
    lines = ["mark,x_mm,y_mm"]
    for label, z in rows:
        z += 0j if label == POLE_LABEL else complex(rng.gauss(0, 0.15), rng.gauss(0, 0.15))
        lines.append(f"{label},{z.real:.2f},{z.imag:.2f}")
    path.write_text("\n".join(lines) + "\n")
    asked = Asked(load(SAMPLES / f"{name}.yaml"), plan)
    return check(asked, read_paper(str(path), asked, Known()))


@pytest.mark.few(1)
@pytest.mark.parametrize("plan", ["velocity", "acceleration", "force:2-3-4-5"])
@pytest.mark.parametrize("name", NAMES)
def test_a_hand_drawing_is_judged(name: str, plan: str, tmp_path: Path) -> None:
    rows = forces(name, plan) if plan.startswith("force") else motion(name, plan)
    assert judged(name, plan, rows, tmp_path).verdict in ("right", "right_as_seen")
    if plan == "velocity":
        turned = judged(name, plan, [(label, -z) for label, z in rows], tmp_path)
        assert turned.mistake == "omega1_reversed"
        return
    label, place = rows[k := len(rows) - 1 if plan == "acceleration" else 2]
    wrong = judged(name, plan, [*rows[:k], (label, place + 9 + 4j), *rows[k + 1 :]], tmp_path)
    assert wrong.verdict == "wrong"


def test_a_second_polygon_may_follow_without_putting_the_pen_down(tmp_path: Path) -> None:
    rows = forces("class-four/tray", "force:2-3-4-5")
    listed = [rows[0], *(row for row in rows if row[0] != POLE_LABEL)]
    assert len(listed) < len(rows)
    assert judged("class-four/tray", "force:2-3-4-5", listed, tmp_path).verdict == "right"


def test_what_no_mistake_touches_is_not_drawn_anew() -> None:
    """Drawn from where a mistake begins, a plan is the same as drawn from the beginning, with every mistake."""
    bench = prepare(Asked(load(SAMPLES / "class-three/guide.yaml"), "acceleration"))
    for variant in [None, *mistake_variants(bench, {}, bench.said_mu)][::7]:
        whole = {**bench.given, **(variant.givens if variant else {})}
        draw_steps(bench.program.steps, whole, Tool(Arithmetic()), variant.swaps if variant else {})
        assert bench.draw_program(variant, Tool(Arithmetic())) == whole, variant
