"""A seeded few of the sheets that ``sheets_run`` looks over: nothing overlaps, leaves the frame, or is missing."""

from __future__ import annotations

import random
from dataclasses import replace
from pathlib import Path

import pytest

from planes.documents.sheets import sheet_of
from render.labels import Label, place_labels
from render.paper.marks import Arc, Line, Mark, Text, move_mark
from render.paper.typeset import plain_text
from tests import sheets_run
from tests.sheets_run import (
    Job,
    at_random,
    clashes,
    crossings,
    jobs,
    leaders,
    look,
    omissions,
    scene_of,
    unlettered,
    untranslated,
)

SEED, COUNT = 5, 8
SOME = random.Random(SEED).sample(jobs(True, True), COUNT)
SOME += random.Random(SEED + 1).sample(jobs(True, True, lang="en"), COUNT // 2)
SCENES = [path for path in (*sheets_run.SAMPLES, *sheets_run.ASSIGNMENTS) if path.stem != "vectors"]
EVERY = [Job(path, number) for path in SCENES for number in (1, 2)]
SIX_LINK = next(p for p in sheets_run.SAMPLES if p.stem == "six-link")

STRICT = ("letters under", "stands before", "begun again", "begins between", "meets", "is not lettered", "is nowhere")
KINDS_OF_FAULTS = (*STRICT, " lies on ", "overlaps the label", "read as one word", "upon each other", "crosses")
RANK = "is larger than the scheme"


@pytest.mark.slow
@pytest.mark.few(1)
@pytest.mark.parametrize("job", SOME, ids=str)
def test_a_sheet_has_no_fault(job: Job) -> None:
    found = look(job)
    assert found.faults == ()
    refused = any(why in found.failed for why in ("φ = ", "s = ", "μ"))  # no such position, or no paper for a stated μ
    assert refused or found.full > 0.4


@pytest.mark.few(0, slow=16)
@pytest.mark.parametrize("job", EVERY, ids=str)
def test_every_sheet_of_a_project_is_without_fault(job: Job) -> None:
    """No ink on ink, names apart, letters of the standard, left edges on the module, figures in the order of the
    calculation, the scheme with loads the largest, no force upon another, nothing left out unsaid."""
    found = look(job)
    if str(job) == "excavator, sheet 2":  # two sides of its polygon are nearly parallel, a millimetre apart
        assert all("drawn upon each other" in fault for fault in found.faults)
        return
    assert (found.faults, found.failed) == ((), "")


@pytest.mark.long
def test_faults_of_sheets_of_random_mechanisms_are_few_and_told(tmp_path: Path) -> None:
    """Three groups with all their loads are more than a sheet may hold: what lies on other ink is named by it."""
    found = [look(job) for job in at_random(100, tmp_path) if job.number]
    every = [(one, fault) for one in found for fault in one.faults]
    faults = [(one, fault) for one, fault in every if RANK not in fault]
    outranked = {str(one.job): one.paper for one, fault in every if RANK in fault}
    assert {*outranked.values()} <= {"A1", "A2x3", "A0", "A1x3"} and len(outranked) <= 0.1 * len(found), outranked
    smaller = [str(one.job) for one in found if any("μ меньше" in sentence for sentence in one.said)]
    assert len(smaller) <= 0.01 * len(found), smaller  # a scheme of 1025 mm, near a dead point, fits no paper
    unsaid = [
        (str(one.job), f)
        for one, f in faults
        if " lies on " in f and plain_text(f.split("'")[1]) not in " ".join(one.said)
    ]
    assert unsaid == []
    kinds = {kind: sum(kind in f for _, f in faults) for kind in KINDS_OF_FAULTS}
    assert sum(kinds.values()) == len(faults), faults
    assert all(kinds[kind] == 0 for kind in STRICT), kinds
    assert len({str(one.job) for one, _ in faults}) <= 0.01 * len(found), kinds


def test_the_looking_sees_what_is_wrong() -> None:
    job = Job(SIX_LINK, 2)
    sheet, scene = sheet_of(scene_of(job), None, "ru", 2), scene_of(job)
    assert clashes(sheet) == omissions(scene, None, sheet, job) == []
    name, at = next((m, k) for k, m in enumerate(sheet.marks) if isinstance(m, Text) and m.name == "C")
    struck = replace(sheet, marks=(*sheet.marks, Line((name.place, name.place + 4 + 4j))))
    assert any("'C' lies on 'line" in fault for fault in clashes(struck))
    assert untranslated(sheet, "ru") == [] and any("'Реакции' is Russian" in f for f in untranslated(sheet, "en"))
    raw = replace(sheet, marks=(*sheet.marks, Text("M omegaq_1", 100 + 100j)))
    assert unlettered(sheet) == [] and len(unlettered(raw)) == 1
    gone = replace(sheet, marks=tuple(move_mark(m, 400j) if k == at else m for k, m in enumerate(sheet.marks)))
    assert any("sticks out" in fault for fault in clashes(gone))
    unsaid = replace(sheet, marks=tuple(m for m in sheet.marks if not (isinstance(m, Text) and "21" in m.text)))
    assert any("F_21" in fault for fault in omissions(scene, None, unsaid, job))


def test_the_lever_of_a_mechanism_at_rest_is_lettered() -> None:
    job = Job(next(p for p in sheets_run.SAMPLES if p.stem == "bntu-1"), 2)
    sheet = sheet_of(scene_of(job), None, "ru", 2)
    assert any("ω_{q1}" in m.text for m in sheet.marks if isinstance(m, Text))
    assert unlettered(sheet) == []


def boxed_in(centre: complex) -> list[Mark]:
    """Circles about a point that leave no room beside it."""
    return [Arc(centre, r, style="thin") for r in (2.0, 4.0, 6.0, 8.0, 10.0)]


def test_leaders_cross_neither_letters_nor_each_other() -> None:
    points = [50 + 50j, 54 + 50j, 52 + 53j, 50 + 55j]
    marks = [m for z in points for m in boxed_in(z)]
    placed = place_labels(
        [Label(name, z) for name, z in zip(("S_{2}", "B", "C_{3}", "12"), points, strict=True)], marks
    )
    assert len(placed.leaders) >= 3
    assert sheets_run._leaders_meet(list(placed.leaders)) == []
    assert leaders(placed.marks) == list(placed.leaders)


def test_a_leader_goes_where_it_crosses_least() -> None:
    fence: list[Mark] = [Line((complex(40 + k, 20), complex(40 + k, 49)), "thin") for k in range(25)]
    placed = place_labels([Label("S_{2}", 50 + 52j)], [*boxed_in(50 + 52j), *fence])
    (leader,) = placed.leaders
    assert leader.points[0].imag > 52
    assert len(crossings([*fence, leader])) == 0


def test_a_thin_line_gives_way_where_there_is_no_room_beside_it() -> None:
    from render.views.senses import break_lines_at_texts

    bars = [Line((complex(30, y), complex(70, y)), "construction", "construction") for y in range(30, 71, 3)]
    placed = place_labels([Label("B", 50 + 50j)], (), None, bars)
    assert placed.leaders == ()
    pieces = break_lines_at_texts(bars, placed.texts)
    assert len(pieces) > len(bars)
    assert clear(placed.texts[0], pieces)


def clear(text: Text, lines: object) -> bool:
    from tests.helpers.conflicts import conflicts

    return conflicts([text], lines) == ()  # type: ignore[arg-type]
