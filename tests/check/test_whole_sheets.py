"""Whole sheets written by this program, read back: every plan is right, and with a step of it spoiled wrong there."""

from __future__ import annotations

import random
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from planes.check.evidence.line_words import words_among_names
from planes.check.grading.prepared_plan import known_plans
from planes.check.reading.parts import merge_word_pieces
from planes.check.reading.strokes import ReadDrawing
from planes.check.reading.whole_page import scale_in_title, shows_other_plans_only
from planes.check.reading.written import Words
from planes.documents.sheets import DrawnPosition, sheet_of
from planes.scene import Scene
from planes.solving import Position
from planes.words.names import PlanId
from planes.words.naming import Naming
from render.sheet import Sheet
from tests.check.test_own_sheets import ASSIGNMENTS, READERS, SCENES, checked, drawn, made, mistakes, spoiled
from tests.helpers.sheets import sheet


def spoiled_sheet(sample: str, number: int | None, ks: Mapping[str, int], patch: pytest.MonkeyPatch) -> Sheet:
    """A whole sheet with a mistake in each of some plans, at whatever size the sheet has room for."""
    rightly = DrawnPosition._draw_position

    def drawn_wrongly(self: DrawnPosition, fits: Mapping[str, float], scene: Scene | None = None) -> Position:
        right = rightly(self, fits, scene)
        things = dict(right.drawing.things)
        for plan, k in ks.items():
            wrong = made(sample, plan, right, k)[0].drawing.things
            things |= {n: v for n, v in wrong.items() if v != right.drawing.things[n]}
        return replace(right, drawing=replace(right.drawing, things=things))

    patch.setattr(DrawnPosition, "_draw_position", drawn_wrongly)
    found = sheet_of(drawn(sample)[0], None, number=number)
    patch.undo()
    return found


def shown(sample: str, number: int | None) -> Iterator[str]:
    """The plans on a sheet that have something to draw."""
    position = drawn(sample)[1]
    for plan in known_plans(position.plans):
        marks = [m for m in position.drawing.things if m.startswith(f"{plan}:")]
        elsewhere = number and (number == 2) != plan.startswith("force")
        if not elsewhere and any(abs(position.drawing[m]) > 1e-6 for m in marks):
            yield plan


def some_mistakes(sample: str, number: int | None) -> dict[str, int]:
    """By plan of a sheet a random mistake, the same in every run."""
    found = {plan: spoiled(sample, plan, f"{sample} {number} {plan}") for plan in shown(sample, number)}
    return {plan: k for plan, k in found.items() if k is not None}


SHEETS = (
    ("crank-slider", None, "acceleration", ".dxf"),
    ("kind-4-prp", 2, "force:2-3", ".svg"),
    ("assignments/12", 2, "force:2-3", ".dxf"),
    ("assignments/56", 2, "force:2-3", ".dxf"),  # a name far off, with a line to its vector
    ("assignments/34", 1, "position", ".svg"),  # another plan's long title ends as near beside it
    ("assignments/63", 2, "force:4-5", ".pdf"),  # small beside a free body with the same forces
    ("assignments/31", None, "position", ".svg"),  # a link in one row with underlines elsewhere on the sheet
)


@pytest.mark.few(0)
@pytest.mark.parametrize(("sample", "number", "plan", "suffix"), SHEETS)
def test_a_plan_of_a_crowded_sheet_is_right(
    sample: str, number: int | None, plan: str, suffix: str, tmp_path: Path
) -> None:
    found = checked(sample, plan, sheet(sample, number=number), tmp_path / f"sheet{suffix}")
    assert found.verdict == "right", found.sentence.told("en")


SPOILED = (("crank-slider", None, "acceleration", ".svg"), ("kind-5-rpp", 2, "force:2-3", ".dxf"))


@pytest.mark.few(1)
@pytest.mark.parametrize(("sample", "number", "plan", "suffix"), SPOILED)
def test_a_spoiled_step_is_found_on_a_whole_sheet(
    sample: str, number: int | None, plan: str, suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    k = spoiled(sample, plan, 1)
    assert k is not None
    found = checked(sample, plan, spoiled_sheet(sample, number, {plan: k}, monkeypatch), tmp_path / f"sheet{suffix}")
    assert (found.verdict, found.first_wrong) == ("wrong", mistakes(sample, plan)[k].blames), found.sentence.told("en")


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("suffix", READERS)
def test_every_plan_of_a_whole_sheet_is_right(suffix: str, tmp_path: Path) -> None:
    """Frame, title block, tables, equations and the other plans are not lines of the plan."""
    position = drawn("kind-1-rrr")[1]
    whole = sheet("kind-1-rrr")
    for plan in known_plans(position.plans):
        found = checked("kind-1-rrr", plan, whole, tmp_path / f"sheet{suffix}")
        assert found.verdict == "right", (plan, found.sentence.told("en"))


LED_ASTRAY = (
    ("assignments/39", None, "acceleration", ".svg"),  # the word of the pole is nearer to another mark
    ("assignments/21", 1, "acceleration", ".svg"),  # two names in a row
    ("assignments/51", 1, "acceleration", ".dxf"),  # a row of names written in pieces; a line that stops short
    ("assignments/19", 1, "position", ".svg"),  # a line from a name that begins near another name
    ("sliding-driver", None, "position", ".dxf"),  # the origin
    ("assignments/48", None, "velocity", ".dxf"),  # where vectors begin and the word of the pole is, though not nearest
    ("assignments/59", None, "position", ".dxf"),  # a line drawn twice
    ("assignments/51", None, "velocity", ".svg"),  # a line from a name that passes close to another mark
    ("assignments/61", 1, "acceleration", ".dxf"),  # a line from a name that crosses the pole
    ("assignments/46", 2, "force:4-5", ".dxf"),  # vectors each named, of a polygon that is no one chain
    ("bntu-2", 2, "force:1", ".dxf"),  # a free body of the same forces
    ("assignments/55", 2, "force:4-5", ".svg"),
    ("assignments/63", 2, "force:1", ".pdf"),
    ("assignments/38", None, "force:2-3", ".dxf"),  # a name with a line to a vector too short for a head
    ("assignments/01", 2, "force:4-5", ".svg"),  # two vectors there and back whose names are as near to either
    ("assignments/43", None, "force:4-5", ".svg"),  # names nearer to each other's vectors
    ("assignments/30", 2, "force:1", ".svg"),  # what is left of the plan is small, and drawn enlarged
    ("assignments/06", 2, "force:4-5", ".svg"),  # a construction line that ends near a name
)


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize(("sample", "number", "plan", "suffix"), LED_ASTRAY)
def test_what_stands_about_a_spoiled_plan_leads_nobody_astray(
    sample: str, number: int | None, plan: str, suffix: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    ks = some_mistakes(sample, number)
    found = checked(sample, plan, spoiled_sheet(sample, number, ks, monkeypatch), tmp_path / f"sheet{suffix}")
    blames = mistakes(sample, plan)[ks[plan]].blames
    assert (found.verdict, found.first_wrong) == ("wrong", blames), found.sentence.told("en")


WHOLE = [(s, n) for s in (*SCENES, *ASSIGNMENTS) for n in (None, 1, 2)]


@pytest.mark.long
@pytest.mark.parametrize(("sample", "number"), WHOLE)
def test_every_plan_of_every_sheet_is_right(sample: str, number: int | None, tmp_path: Path) -> None:
    whole = sheet_of(drawn(sample)[0], None, number=number)
    for plan in shown(sample, number):
        found = checked(sample, plan, whole, tmp_path / "sheet.svg")
        assert found.verdict == "right", (plan, found.sentence.told("en"))


@pytest.mark.long
@pytest.mark.parametrize("number", [None, 1, 2])
@pytest.mark.parametrize("sample", [*SCENES, *ASSIGNMENTS])
def test_no_sheet_with_a_spoiled_step_is_right(
    sample: str, number: int | None, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """What moves its mark by more than this sheet's plan allows a hand is found, in a random format."""
    suffix, ks = random.Random(f"{sample} {number}").choice(list(READERS)), some_mistakes(sample, number)
    whole = spoiled_sheet(sample, number, ks, monkeypatch)
    for plan, k in ks.items():
        found = checked(sample, plan, whole, tmp_path / f"sheet{suffix}")
        free, limit = (found.grading.free, found.grading.judgement.limit) if found.grading else ({}, 0.0)
        blamed = [m for m in free if m.label == mistakes(sample, plan)[k].blames]
        close = any(free[m].sigmas <= limit for m in blamed)
        assert found.verdict != "right" or close, (plan, suffix, mistakes(sample, plan)[k].mistake, blamed)


PLANS = [*map(PlanId.read, ("position", "velocity", "force:4-5", "force:2-3", "force:1"))]


def test_a_plan_stands_under_the_title_that_names_its_links() -> None:
    body, plan = [ReadDrawing(strokes=[(z, z + 30 - 20j), (z + 30 - 20j, z)]) for z in (0j, 100 + 0j)]
    titles = [
        Words("Группа 2–3 с силами, μl = 100 мм/м", 0 + 5j, 5.0, 60.0),
        Words("План сил группы 2–3, μF = 0,01 мм/Н", 90 + 5j, 5.0, 60.0),
    ]
    assert scale_in_title(titles, plan, PLANS[3], PLANS) == (0.01, True)
    assert not scale_in_title(titles, body, PLANS[3], PLANS)[1]
    assert scale_in_title(titles, plan, PLANS[4], PLANS) == (None, False)
    assert [p for p in PLANS if shows_other_plans_only(titles, p, PLANS)] == ["force:4-5", "force:1"]
    untold = [Words("План сил, μF = 0,01 мм/Н", 90 + 5j, 5.0, 60.0)]
    assert scale_in_title(untold, plan, PLANS[4], PLANS) == (0.01, True) and not shows_other_plans_only(
        untold, PLANS[4], PLANS
    )


def test_a_line_from_a_name_may_stop_short_of_its_mark_and_is_of_the_nearest_name() -> None:
    vectors = [(0j, 40 + 0j), (0j, 30 + 20j), (40 + 0j, 30 + 20j)]
    words = [Words("s2", 44 + 9j, 5.0, 6.0), Words("b", 43 + 17j, 5.0, 3.0)]
    sketch = ReadDrawing(strokes=[*vectors, (44 + 8.4j, 40.3 + 0.5j)], words=words, ways=[1, 1, 1, 0])
    found = words_among_names(sketch, Naming().name_finder(["s2", "b"]), ["s2", "b"]).words
    assert [([*w.likely], w.led) for w in found] == [(["s2"], 40.3 + 0.5j), (["b"], None)]
    assert found[0].distance_to_segment(40 + 0j, 40 + 0j) < 1 < found[1].distance_to_segment(40 + 0j, 40 + 0j)


def test_a_line_from_a_name_of_a_force_leads_to_its_vector() -> None:
    words, known = [Words("F_21", 10 + 20j, 5.0, 8.0), Words("G_2", 16 + 2j, 5.0, 8.0)], ["F_21", "G_2"]
    strokes = [(0j, 40 + 0j), (40 + 0j, 40 + 30j), (14 + 19.4j, 16 + 0j), (40 + 30j, 41 + 30j)]
    sketch = ReadDrawing(strokes=strokes, words=words, ways=[1, 1, 0, 0])
    force, weight = words_among_names(sketch, Naming().name_finder(known), known).words
    assert (
        force.distance_to_segment(*strokes[0]) == 0.0
        and force.distance_to_segment(*strokes[1]) > 20
        and weight.led is None
    )


def test_a_row_of_names_written_in_pieces_is_one_word() -> None:
    pieces = [
        Words("e", 0j, 5.0, 3.5),
        Words("3", 3.6 - 1j, 3.5, 2.5),
        Words("′, k", 6 + 0j, 5.0, 8.8),
        Words("EE3", 14.4 - 1.5j, 3.5, 7.3),
    ]
    assert [w.text for w in merge_word_pieces(pieces)] == ["e3′, kEE3"]
