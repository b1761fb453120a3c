"""All papers of one scene agree: μ, millimetres and letters of results, note, answers, lesson, blanks and sheets."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from planes.check.grading.prepared_plan import Asked, prepare
from planes.course.papers import answer_key_blocks
from planes.documents.lesson import note_position
from planes.documents.sheets import sheet_of
from planes.lesson.data import lesson_data
from planes.lesson.formulas import fill_slots
from planes.lesson.note import Note
from planes.plans.measuring import scene_lettering
from planes.scene import Scene, load
from planes.solving import solve
from planes.solving.document import Block, DocumentTable, Figure, Paragraph
from planes.solving.given import GivenTable
from planes.words import with_decimal_sign
from planes.words.names import PlanId
from planes.words.naming import Naming
from planes.words.units import Convention, mu_text
from render.paper.marks import Text
from render.sheet import Sheet
from tests.helpers import ROOT
from tests.sheets_run import at_random

SCENES = {p.stem: scene for p in sorted((ROOT / "samples").glob("*.yaml")) if (scene := load(p)).mechanism}
SCENES.pop("crank-slider")
SCENES["format A1"] = Scene(**{**vars(SCENES["kind-3-rpr"]), "sheet": {"format": "A1"}})
SCHEMES = {"position": "scheme"}
OF_PLAN = dict.fromkeys(("scheme", "loaded", "group", "apart"), "position") | {"lever": "velocity"}
"""By whose μ a figure of a sheet is drawn that is no plan."""
PER_UNIT = re.compile(r"\d мм(/[А-Яа-я°(]|·с)")


def told_mu(mu: float, plan: str) -> str:
    return with_decimal_sign(mu_text(mu, PlanId.read(plan).kind, "ru"), "ru")


def texts(sheet: Sheet) -> set[str]:
    return {m.text for m in sheet.marks if isinstance(m, Text)}


def told(blocks: list[Block]) -> str:
    """All words and cells of a document, a line each."""
    lines: list[str] = []
    for block in blocks:
        match block:
            case Paragraph():
                lines.append(block.text)
            case Figure() | DocumentTable():
                lines.append(block.caption)
        if isinstance(block, DocumentTable):
            lines += [" ".join(row) for row in block.rows]
    return "\n".join(lines)


@pytest.mark.slow
def test_the_plans_of_three_groups_have_room_at_the_mu_of_the_note(tmp_path: Path) -> None:
    """At 1.4 of the usual size neither A2×3 nor A0 held them, and the sheet had a μ of its own."""
    scene = load(at_random(1, tmp_path, 41012)[0].path)
    found, mus = sheet_of(scene, None, "ru", 2), solve(scene).positions[0].scales
    plans = {v.key: v.title for v, *_ in found.views if v.key.startswith("force") and f"mu_{v.key}" in mus}
    assert len(plans) == 4 and all(told_mu(mus[f"mu_{plan}"], plan) in title for plan, title in plans.items())
    assert found.warnings == ()


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("name", SCENES)
def test_every_paper_has_one_mu_and_the_same_millimetres(name: str) -> None:
    scene = SCENES[name]
    position, drawn = solve(scene).positions[0], note_position(scene, None, "ru")
    assert position.scales == drawn.scales and position.results["plans"] == drawn.results["plans"]
    lesson = lesson_data(scene)
    sheets = {number: sheet_of(scene, None, "ru", number) for number in (None, 1, 2)}
    naming = Naming("ru", **scene_lettering(scene, drawn.plans))
    key = told(list(answer_key_blocks(scene, drawn, ("",), "ru")))
    for plan, mu in {
        p: drawn.scales[p.mu_name] for p in drawn.plans.plan_names if p not in ("lever", "motion")
    }.items():
        assert prepare(Asked(scene, plan)).said_mu == mu
        assert all(
            fill_slots(p["mu"]["ru"], lesson["home"].__getitem__, "ru") == told_mu(mu, plan)
            for p in lesson["plans"]
            if p["key"] == plan
        )
        titles = [v.title for sheet in sheets.values() for v, *_ in sheet.views if v.key in (plan, SCHEMES.get(plan))]
        assert all(told_mu(mu, plan) in title for title in titles), (plan, titles)
        if plan in ("velocity", "acceleration"):
            for vector, _, found in drawn.measured_on(plan):
                mm = f"{found['mm']:.1f}".replace(".", ",")
                rows = [line for line in key.splitlines() if line.startswith(f"⟨{vector}⟩ ⟨")]
                assert rows == [] or any(f" {mm} " in row or f" {mm.removesuffix(',0')} " in row for row in rows)
    assert drawn.plans.structure.formula_with_frame_number(naming.frame, True) in texts(sheets[1])
    assert drawn.plans.structure.formula_with_frame_number(naming.frame, True) in told(
        Note(scene, drawn, "ru").document_blocks()
    )


@pytest.mark.few(0, slow=6)
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("convention", ["mm_per_unit", "unit_per_mm"])
def test_every_figure_has_that_mu_as_the_scene_writes_it(name: str, convention: Convention) -> None:
    """Groups and links apart and the lever too; diagrams and the scheme with loads have their own, written alike."""
    scene = Scene(**{**vars(SCENES[name]), "sheet": {**SCENES[name].sheet, "mu_convention": convention}})
    drawn = note_position(scene, None, "ru")
    still = drawn.plans.at_rest
    for number in (None, 1, 2):
        sheet = sheet_of(scene, None, "ru", number)
        for key, title in ((v.key, v.title) for v, *_ in sheet.views if " = " in v.title):
            plan = PlanId.read(OF_PLAN.get(key, key))
            if (mu := drawn.scales.get(plan.mu_name)) and key != "loaded" and not (key == "lever" and still):
                assert title.endswith(with_decimal_sign(mu_text(mu, plan.kind, "ru", convention), "ru")), (
                    key,
                    title,
                    mu,
                )
        written = [text for text in texts(sheet) if "μ" in text]
        assert written and all(bool(PER_UNIT.search(t)) is (convention == "mm_per_unit") for t in written), written
    if convention == "unit_per_mm":
        papers = (
            told(Note(scene, drawn, "ru").document_blocks()),
            told(list(answer_key_blocks(scene, drawn, ("",), "ru"))),
        )
        assert not any(found := [PER_UNIT.search(paper) for paper in papers]), found


@pytest.mark.few(1, slow=4)
@pytest.mark.parametrize("name", SCENES)
def test_every_given_number_is_on_paper(name: str) -> None:
    scene = SCENES[name]
    drawn = note_position(scene, None, "ru")
    rows = GivenTable(drawn, Naming("ru", **scene_lettering(scene, drawn.plans)), scene.used)
    note = told(Note(scene, drawn, "ru").document_blocks())
    assert all(" ".join(row) in note for row in rows.given_rows())
    for number in (None, 1, 2):
        shown = texts(sheet_of(scene, None, "ru", number))
        assert {cell for row in rows.given_rows() for cell in row} <= shown, (number, name)
    m = drawn.plans.mechanism
    places = {r.name: r.value for r in rows.unnamed_number_rows() if r.place}
    assert all(z == 0 or places[f"x_{{{p.replace('_', '')}}}"] == z.real for p, z in m.frame.points.items())
    assert {link.mass for link in m.links.values() if link.mass} <= {
        r.value for r in rows.unnamed_number_rows() if r.unit == "kg"
    }
