"""`python -m tests.physical.classroom [STUDENTS] [seed=K] [into=DIR]`: a teacher's hour, by the commands he types.

A course is made, its blanks are filled in by simulation (some wrong, some askew, some two to a picture), and the
folder is checked in one run; the findings are compared with the owners of the blanks. Then one is corrected by hand.
Drawings already in DIR are not redrawn, but checked by the current program.
"""

from __future__ import annotations

import contextlib
import io
import json
import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pypdfium2

from planes.check.blank import blank_pole, plan_fitting_blank
from planes.check.fiducials import SHEET_MM, is_within_square, mark_and_code_squares
from planes.check.grading.polygons import Side, polygon_sides
from planes.check.grading.prepared_plan import Asked, PreparedPlan, known_plans, mistake_variants, prepare
from planes.check.report.shown import vector_end_labels
from planes.cli import main
from planes.drafting.tools import Tool
from planes.geometry.arithmetic import Arithmetic
from planes.plans.statements.of_scene import scene_plans
from planes.scene import load
from planes.words.names import POLE_LABEL, PlanId
from tests.helpers import ROOT
from tests.helpers.line_drawings import beside_lines, labels, vector_labels
from tests.physical import camera
from tests.physical.factors import HARD, PEOPLE
from tests.physical.layout import ROOM, Page
from tests.physical.letters import Writer
from tests.physical.page import drawn_on, printed_on
from tests.physical.paper import PX_PER_MM, Paper
from tests.physical.setting import Setting, varied
from tests.physical.strokes import Hand
from tests.picture_corpus import Drawn

ERROR_MM, MOVED_MM = 0.15, 4.0  # σ of a mark's position; least displacement by a mistake
WRONG, ASKEW, PHONES, PAIRED = 0.3, 0.2, 0.5, 0.1  # shares of the sheets
COURSE = """course: 1
students: students.txt
assignments: [{folder}/12.yaml, {folder}/26.yaml, {folder}/43.yaml]
variants: given
draw: {{phi_1: {{from: 0, to: 345, step: 15}}, l_AB: 10 %, l_BC: 10 %, l_CD: 10 %, omega_1: 20 %}}
sharpness: 15
documents: [blank]
plans: [velocity, acceleration, force]
seed: {seed}
"""


@dataclass(frozen=True)
class Filled:
    """A completed blank: its owner, plan, mistake, and marks, mm from the pole."""

    student: str
    plan: PlanId
    mistake: str
    picture: Any
    marks: Mapping[str, complex]


def made_course(folder: Path, students: int, seed: int) -> Path:
    """Makes the course; returns the folder of the teacher's files and the students' blanks."""
    folder.mkdir(parents=True, exist_ok=True)
    names = "".join(f"Ученик{k:02d} Имя{k:02d}\n" for k in range(1, students + 1))
    (folder / "students.txt").write_text(names, "utf-8")
    (folder / "course.yaml").write_text(COURSE.format(folder=ROOT / "samples/assignments", seed=seed), "utf-8")
    with contextlib.redirect_stdout(io.StringIO()):
        assert main(["course", str(folder), "--jobs", "1"]) == 0
    return folder / "out"


def filled(out: Path, seed: int) -> Iterator[Filled]:
    """Every page of every blank, drawn on and photographed or scanned."""
    for scene in sorted(out.glob("teacher/*/scene.yaml")):
        student, rng = scene.parent.name, random.Random(f"{seed} {scene.parent.name}")
        asked = load(scene)
        plans = [p for p in known_plans(scene_plans(asked)) if p.kind != "position"]
        with pypdfium2.PdfDocument(out / "students" / student / "blank.pdf") as blank:
            assert len(blank) == len(plans), (student, len(blank), plans)
            for page, plan in zip(blank, plans, strict=True):
                grey = cv2.cvtColor(page.render(scale=PX_PER_MM * 25.4 / 72).to_numpy()[..., :3], cv2.COLOR_BGR2GRAY)
                bench = plan_fitting_blank(prepare(Asked(asked, plan)))
                mistake, one = drawing(bench, rng)
                if one.strokes:  # an empty plan is not submitted
                    yield Filled(student, plan, mistake, taken(bench, one, grey, rng), one.marks)


def taken(bench: PreparedPlan, one: Drawn, blank: Any, rng: random.Random) -> Any:
    """The picture of a blank with this drawing, by a random pencil or pen, scanner or phone."""
    spread = {**PEOPLE, **(HARD if rng.random() < PHONES else {"dpi": [150.0, 200.0, 300.0]})}
    setting = varied(Setting(), spread, rng)
    if rng.random() < ASKEW:
        setting = varied(setting, {"turn_deg": [-3.0, 3.0, 5.0], "quarter": [0, 1, 2, 3]}, rng)
    paper = Paper(SHEET_MM, setting, rng)
    hand = Hand(paper, rng)
    printed_on(paper, blank)
    drawn_on(Page(paper, hand, Writer(hand, rng), rng, blank_pole(bench)), one)
    return camera.taken(paper, setting, rng)[0]


def drawing(bench: PreparedPlan, rng: random.Random) -> tuple[str, Drawn]:
    """A plan as drawn by a person, and its mistake, "" for a right one."""
    true = {POLE_LABEL: 0j, **bench.true_marks}
    tried = [("", true)]
    if rng.random() < WRONG:
        every = mistake_variants(bench, {}, bench.said_mu)
        drawn = ((v.mistake, _marks(bench, v)) for v in rng.sample(every, len(every)))
        tried = [*((name, marks) for name, marks in drawn if marks), *tried]
    for mistake, marks in tried:
        moved = max(abs(marks[n] - z) for n, z in true.items())
        if all(map(_roomy, (z + blank_pole(bench) for z in marks.values()))) and (moved > MOVED_MM or not mistake):
            break
    shaken = {n: z + ERROR_MM * complex(rng.gauss(0, 1), rng.gauss(0, 1)) for n, z in marks.items()} | {POLE_LABEL: 0j}
    force = bench.plan.is_force
    sides = polygon_sides(bench.plans, bench.plan) if force else [Side("", a, b) for a, b in vector_end_labels(bench)]
    sides = [s for s in sides if abs(shaken[s.end] - shaken[s.start]) > 0.5]
    strokes = [(shaken[s.start], shaken[s.end]) for s in sides]
    if force:
        words = vector_labels(
            [(s.name, shaken[s.end] - shaken[s.start]) for s in sides], starts=[a for a, _ in strokes]
        )
    else:
        words = labels(shaken, rng)
    return mistake, Drawn(strokes, beside_lines(words, strokes), shaken)


def _marks(bench: PreparedPlan, variant: Any) -> dict[str, complex]:
    things = bench.draw_program(variant, Tool(Arithmetic()))
    return {} if things is None else {POLE_LABEL: 0j, **{m.label: complex(things[m]) for m in bench.marks}}


def _roomy(z: complex) -> bool:
    inside = ROOM[0].real + 12 < z.real < ROOM[1].real and ROOM[0].imag < z.imag < ROOM[1].imag
    return inside and not any(is_within_square(z, square, 5.0) for square in mark_and_code_squares(SHEET_MM))


def handed_in(sheets: list[Filled], folder: Path, rng: random.Random) -> dict[str, Filled]:
    """The pictures as files, in random order; some of them two to a picture, named by its parts."""
    folder.mkdir(exist_ok=True)
    rng.shuffle(sheets)
    paired, count, told = round(len(sheets) * PAIRED / 2) * 2, 0, dict[str, Filled]()
    for k in range(0, paired, 2):
        one, two = sheets[k : k + 2]
        cv2.imwrite(str(folder / f"IMG_{count:03d}.jpg"), _beside(one.picture, two.picture))
        told |= {f"IMG_{count:03d}-1.jpg": one, f"IMG_{count:03d}-2.jpg": two}
        count += 1
    for one in sheets[paired:]:
        cv2.imwrite(str(folder / f"IMG_{count:03d}.jpg"), one.picture)
        told[f"IMG_{count:03d}.jpg"] = one
        count += 1
    return told


def _beside(one: Any, two: Any) -> Any:
    """Two pictures in one, the second below the first."""
    width = max(one.shape[1], two.shape[1])
    wide = [cv2.resize(p, None, fx=width / p.shape[1], fy=width / p.shape[1]) for p in (one, two)]
    return np.vstack(wide)


def kept(true: Mapping[str, Filled], file: Path) -> None:
    """Writes the content of the pictures next to them."""
    marks = {n: {m: [z.real, z.imag] for m, z in one.marks.items()} for n, one in true.items()}
    rows = {n: [one.student, one.plan, one.mistake, marks[n]] for n, one in true.items()}
    file.write_text(json.dumps(rows), "utf-8")


def drawn_before(file: Path) -> dict[str, Filled]:
    """The drawings of an earlier run."""
    rows = json.loads(file.read_text("utf-8"))
    marks = {n: {m: complex(*z) for m, z in row[3].items()} for n, row in rows.items()}
    return {n: Filled(row[0], row[1], row[2], None, marks[n]) for n, row in rows.items()}


def run(out: Path, photos: Path, report: Path) -> tuple[dict[str, Any], float, int]:
    """Runs the command for a class: the findings for each file, the CPU seconds, and the exit status."""
    said, start = io.StringIO(), time.process_time()
    with contextlib.redirect_stdout(said):
        status = main(["check", str(out), str(photos), "-o", str(report), "--json", "--lang", "en"])
    return {row["file"]: row for row in json.loads(said.getvalue())}, time.process_time() - start, status


def told(found: Mapping[str, Any], true: Mapping[str, Filled]) -> str:
    """The number of sheets identified correctly, and the verdicts on right and wrong ones."""
    counts: Counter[str] = Counter()
    lost, false = [], []
    for name, sheet in true.items():
        row = found.get(name, {})
        whose = str(row.get("whose", "")).split(",")[0].replace(" ", "-") == sheet.student.rpartition("/")[2]
        counts["sorted"] += whose and row.get("plan") == sheet.plan
        truly, verdict = "wrong" if sheet.mistake else "right", row.get("verdict", "not there")
        counts[f"{truly} → {verdict}"] += 1
        if {truly, verdict} == {"right", "wrong"}:
            made, said = sheet.mistake or "right", row["sentence"]["en"]
            false.append(f"false: {name}: {sheet.student} {sheet.plan}: {made} -> {said}")
        if not (whose and row.get("plan") == sheet.plan):
            lost.append(f"{name}: {sheet.student} {sheet.plan} -> {row.get('whose')} {row.get('plan')}")
    lines = [f"{len(true)} sheets; " + ", ".join(f"{k} {n}" for k, n in sorted(counts.items()))]
    return "\n".join([*lines, *false, *lost[:20], *sorted(f"not asked for: {n}" for n in set(found) - set(true))[:20]])


def hour(students: int, seed: int, folder: Path) -> None:
    """Runs all of it, with progress messages."""
    start = time.perf_counter()
    out, photos, report = made_course(folder / "course", students, seed), folder / "photos", folder / "report"
    print(f"course made in {time.perf_counter() - start:.0f} s", flush=True)
    if not (drawn := folder / "drawn.json").is_file():
        kept(handed_in([*filled(out, seed)], photos, random.Random(seed)), drawn)
    true = drawn_before(drawn)
    for table in photos.glob("*.csv"):  # marks corrected in an earlier run
        table.unlink()
    print(f"{len(true)} sheets drawn in {len([*photos.iterdir()])} pictures", flush=True)
    found, seconds, status = run(out, photos, report)
    print(f"{seconds:.0f} s of the processor, exit status {status}\n{told(found, true)}", flush=True)
    name = next((n for n, row in found.items() if row["verdict"] == "unreadable" and n in true), next(iter(true)))
    rows = [f"{n},{z.real:.3f},{z.imag:.3f}" for n, z in true[name].marks.items()]
    (photos / f"{Path(name).stem}.csv").write_text("\n".join(["mark,x_mm,y_mm", *rows]) + "\n", "utf-8")
    before = {f: f.stat().st_mtime_ns for f in report.glob("*.html")}
    again, seconds, _ = run(out, photos, report)
    written = sorted(f.name for f, when in before.items() if f.stat().st_mtime_ns != when)
    changed = sorted(n for n in again if again[n] != found.get(n))
    print(f"{name} put right by hand: {seconds:.0f} s; written anew {written}; found otherwise {changed}")
    print(f"{name}: {found[name]['verdict']} -> {again[name]['verdict']} ({true[name].mistake or 'right'})")


if __name__ == "__main__":
    NUMBERS = [int(w) for w in sys.argv[1:] if w.isdigit()]
    SAID = dict(w.split("=", 1) for w in sys.argv[1:] if "=" in w)
    with tempfile.TemporaryDirectory() as made:
        hour(NUMBERS[0] if NUMBERS else 10, int(SAID.get("seed", "1")), Path(SAID.get("into", made)))
