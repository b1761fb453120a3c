"""The cause named for a mistake: no surer than the evidence, and one that explains all the numbers, not the nearest."""

from __future__ import annotations

from pathlib import Path

import pytest

from planes.check.grading.evidence import SURE_VERDICT_PROBABILITY
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked
from planes.check.handed_in import read_paper
from planes.check.outcome import Outcome, check
from planes.check.report import certainty_text, mark_rows
from planes.cli import main
from planes.scene import load
from tests.helpers import ROOT

# a six-link with a crank of 95 mm at 150°, its accelerations by closed formulas with some normal parts left out
RIGHT = {"omega_2": 1.858, "omega_3": 3.292, "omega_4": 1.127, "v_F": 1.177}
RELATIVE_LEFT_OUT = {"epsilon_2": 32.24, "epsilon_3": -23.04, "epsilon_4": -7.892, "a_F": 8.24}
OF_CB_LEFT_OUT = {"epsilon_2": 22.93, "epsilon_3": -23.88, "epsilon_4": -0.3685, "a_F": 9.849}


def checked(scene: Path, lines: list[str], plan: str, folder: Path) -> Outcome:
    (file := folder / "table.csv").write_text("\n".join(lines) + "\n", "utf-8")
    asked = Asked(load(scene), plan)
    return check(asked, read_paper(str(file), asked, Known()))


@pytest.mark.parametrize("wrong", [RELATIVE_LEFT_OUT, OF_CB_LEFT_OUT])
def test_one_mistake_that_gives_all_the_numbers_is_named_before_a_slip_of_one(
    wrong: dict[str, float], tmp_path: Path
) -> None:
    """ε₃ is also within 6 % of what the whole relative acceleration would give: that explains no other number."""
    scene = tmp_path / "scene.yaml"
    assert main(["new", "six-link", "-o", str(scene), "--lang", "en"]) == 0
    text = scene.read_text("utf-8").replace("l_AB: 0.1,", "l_AB: 0.095,").replace("phi_1: 50", "phi_1: 150")
    scene.write_text(text, "utf-8")
    lines = [f"{name},{value}" for name, value in {**RIGHT, **wrong}.items()]
    found = checked(scene, ["result,value", *lines], "velocity", tmp_path)
    assert (found.mistake, found.verdict) == ("normal_missing", "wrong") and found.cause > SURE_VERDICT_PROBABILITY
    assert found.results and found.results.first_wrong_figure and found.results.first_wrong_figure.slip is None
    assert all(s.true == pytest.approx(RIGHT[s.figure.name], abs=1e-3) for s in found.results.scored[:4])


@pytest.mark.parametrize("e", [-70, -62])
def test_a_point_on_the_right_line_is_no_evidence_for_a_mistake_that_crosses_it_anywhere(
    e: int, tmp_path: Path
) -> None:
    """A line along DE is nearly parallel to the guide: where they meet is known to 80 mm, and so fits any point."""
    lines = ["mark,x_mm,y_mm", "p,0,0", "b,-41.6,24.0", "b3,-43.8,5.2", "d,-64.7,7.7", f"e,{e},0"]
    found = checked(ROOT / "samples/shaper.yaml", lines, "velocity", tmp_path)
    assert (found.verdict, found.first_wrong, found.mistake) == ("wrong", "e", None)


def test_a_cause_is_as_sure_as_it_is(tmp_path: Path) -> None:
    """That a drawing is wrong may be sure, and its cause not."""
    lines = ["mark,x_mm,y_mm", "p,0,0", "b,-41.6,24.0", "b3,-43.8,5.2", "d,-64.7,7.7", "e,65,0"]
    found = checked(ROOT / "samples/shaper.yaml", lines, "velocity", tmp_path)
    assert found.mistake == "along_link" and found.chance and found.chance > SURE_VERDICT_PROBABILITY > found.cause
    assert certainty_text(found, "en") == f"(Wrong for sure; for this cause: {100 * found.cause:.0f} %.)"


def test_a_mark_that_was_written_shows_its_place_where_it_is_not_judged(tmp_path: Path) -> None:
    lines = ["mark,x_mm,y_mm", "p,0,0", "b,30,52", "c,73.7,-8.6", "s2,57.8,11.9", "l,41.1,-29.3", "h,0,30"]
    found = checked(ROOT / "samples/six-link.yaml", lines, "velocity", tmp_path)
    rows = {row["mark"]: row for row in mark_rows(found)}
    assert found.unseen == ["s2"] and rows["s2"]["verdict"] == "unread" and rows["s2"]["read_mm"] == [57.8, 11.9]
