"""Every plan of every sample and assignment against what was kept: its marks in millimetres, its frames, its structure.

A mark may move by rounding alone; what a change meant to alter is written anew:
GOLDEN=write python -m tests.solving.test_kept_plans.
"""

from __future__ import annotations

import hashlib
import json
import os
from pathlib import Path
from typing import Any

import pytest

from planes.lesson.told import SceneLesson
from planes.plans.assur.alignment import self_aligning_variant
from planes.scene import load
from planes.solving import plans_and_requested_results, solve
from planes.solving.given import GivenTable
from planes.solving.structure_text import alignment_report, structure_report_text
from planes.words.errors import PlanesError
from planes.words.lettering import without_index_markup
from planes.words.naming import Naming
from tests.helpers import ROOT

SAMPLES, KEPT = ROOT / "samples", ROOT / "tests" / "golden" / "plans.json"
FOLDERS = ("*.yaml", "class-*/**/*.yaml", "vectors/*.yaml", "statics/*.yaml", "assignments/*.yaml")
SCENES = sorted({str(p.relative_to(SAMPLES).with_suffix("")) for f in FOLDERS for p in SAMPLES.glob(f)})
ALIKE = 1e-8  # of the size of what is drawn


def drawn(path: Path) -> dict[str, Any]:
    """Where each thing of a scene's drawing is, what its frames draw, and what is told of its structure and data."""
    scene = load(str(path))
    out: dict[str, Any] = {}
    try:
        lesson = SceneLesson.of(scene, centres=True)
        things = {name: place(thing) for name, thing in lesson.drawing.things.items()}
        out["things"] = {name: z for name, z in sorted(things.items()) if z is not None}
        frames = [(f.key, f.plan, f.chapter, f.makes, f.uses, str(f.terms), str(f.rows)) for f in lesson.frames]
        program = lesson.plans.program
        reads = [(type(s).__name__, s.makes, sorted(map(str, s.input_names()))) for s in program.steps]
        proofs = sorted(f"{type(p).__name__} {p.reason} {p.plan} {sorted(p.names_read)}" for p in program.proofs)
        stated = [str(x) for x in (*lesson.plans.segments, *lesson.plans.equations, *lesson.plans.moments)]
        out["program"] = hashlib.sha256(json.dumps([reads, proofs, stated]).encode()).hexdigest()[:16]
        out["frames"] = hashlib.sha256(json.dumps(frames).encode()).hexdigest()[:16]
    except PlanesError as error:
        out["lesson"] = str(error)
    if scene.mechanism is not None and scene.mechanism.links:
        (plans, *_) = plans_and_requested_results(scene)
        out["structure"] = structure_report_text(plans.structure, "en", scene.mechanism.frame_number)
        out["aligned"] = said(lambda: without_index_markup(alignment_report(self_aligning_variant(plans), "en")))
    out["given"] = said(lambda: data(scene))
    return out


def data(scene: Any) -> str:
    """The table of what is given, with its laws."""
    position = solve(scene).positions[0]
    table = GivenTable(position, Naming("ru", **position.plans.lettering_basis), scene.parameters)
    return "; ".join(
        " ".join(row)
        for row in (*table.given_rows(), *table.load_law_rows(), *([f] for f in table.load_law_formulas()))
    )


def said(act: Any) -> str:
    """A text, or why there is none."""
    try:
        return str(act())
    except PlanesError as error:
        return str(error)


def place(thing: Any) -> list[float] | None:
    """A point or a number of the drawing."""
    try:
        z = complex(thing)
    except TypeError:
        return None
    return [float(f"{x:.9g}") for x in ((z.real, z.imag) if z.imag else (z.real,))]


def moved(kept: dict[str, list[float]], now: dict[str, list[float]]) -> list[str]:
    """Things that are elsewhere, gone or new."""
    wrong = [f"{name} gone or new" for name in kept.keys() ^ now.keys()]
    for name in kept.keys() & now.keys():
        one, two = complex(*kept[name]), complex(*now[name])
        if abs(one - two) > ALIKE * max(1.0, abs(one)):
            wrong.append(f"{name}: {kept[name]} → {now[name]}")
    return wrong


@pytest.mark.few(60)
@pytest.mark.parametrize("name", SCENES)
def test_every_plan_is_what_was_kept(name: str) -> None:
    now = json.loads(json.dumps(drawn(SAMPLES / f"{name}.yaml"), ensure_ascii=False))
    kept = json.loads(KEPT.read_text("utf-8")).get(name, {})
    assert not (wrong := moved(kept.pop("things", {}), now.pop("things", {}))), wrong[:5]
    assert now == kept, "GOLDEN=write python -m tests.solving.test_kept_plans, if this was meant"


if __name__ == "__main__":
    assert os.environ.get("GOLDEN") == "write"
    every = {name: drawn(SAMPLES / f"{name}.yaml") for name in SCENES}
    lines = ",\n".join(
        f"{json.dumps(k)}:{json.dumps(v, ensure_ascii=False, separators=(',', ':'))}" for k, v in every.items()
    )
    KEPT.write_text("{" + lines + "}\n", "utf-8")
