"""The command ``planes chart``: a figure of both charts, or of speed alone with the reason, and their table."""

from __future__ import annotations

import csv
from dataclasses import replace
from pathlib import Path

import pytest

from planes.accuracy import methods, stability
from planes.accuracy.comparison import Comparison
from planes.accuracy.limits import find_nearest_limit
from planes.cli import main
from planes.documents.charts import distance_axis_title, with_moving_driver
from planes.scene import load
from tests.accuracy.test_stability import CRANK, plans
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"


@pytest.fixture
def quick(monkeypatch: pytest.MonkeyPatch) -> None:
    """Few positions to time and to follow."""
    monkeypatch.setattr(methods, "TIMED_POSITIONS", 500)
    monkeypatch.setattr(stability, "POSITIONS_PER_POINT", 1)
    monkeypatch.setattr(stability, "DISTANCE_BINS", range(2, 29, 6))
    monkeypatch.setattr(stability, "PATH_START_INDICES", frozenset({0}))


@pytest.mark.slow
def test_a_chart_and_its_table(tmp_path: Path, quick: None) -> None:
    out, table = tmp_path / "c.svg", tmp_path / "c.csv"
    scene = str(SAMPLES / "kind-2-rrp.yaml")
    assert main(["chart", scene, "-o", str(out), "--table", str(table), "--lang", "en"]) == 0
    assert out.read_text(encoding="utf-8").startswith("<?xml")
    parts = table.read_text(encoding="utf-8").split("\n\n")
    speed, ways, turning = (list(csv.reader(part.splitlines())) for part in parts)
    assert speed[0] == ["method", "s", "error"]
    names = [row[0] for row in speed[1:]]
    assert {"exact, one by one", "exact, by arrays", "50 digits", "Newton's iteration"} <= set(names)
    assert [n for n in names if "pencil" in n][:2] == ["pencil, A4, 0.5 mm", "pencil, A4, 0.1 mm"]
    assert all(float(row[1]) > 0 and 0 < float(row[2]) < 10 for row in speed[1:])
    assert ways[0][:3] == [
        "length l_BC: relative distance to 0.075 m (0.2 m in the scene), at φ = 150°",
        "sine of the meeting angle",
        "claimed error",
    ]
    assert [float(row[0]) for row in ways[1:]] == pytest.approx([1e-1, 1e-4, 1e-7, 1e-10, 1e-13], rel=0.02)
    assert turning[0] == ["curve", "angle of the driver, °", "l_BC, m"] and len(turning) > 50
    assert max(float(row[2]) for row in turning[1:]) == pytest.approx(0.075, abs=1e-4)


def test_a_length_that_is_none_is_told_with_those_there_are(capsys: pytest.CaptureFixture[str], tmp_path: Path) -> None:
    out = str(tmp_path / "c.png")
    assert main(["chart", str(SAMPLES / "six-link.yaml"), "--length", "l_XY", "-o", out, "--lang", "en"]) == 2
    assert "no length l_XY that can be changed alone; valid: l_AB, l_BC, l_DC" in capsys.readouterr().err


@pytest.mark.slow
def test_where_nothing_leads_to_a_limit_the_chart_says_so(
    tmp_path: Path, quick: None, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "s.yaml").write_text(CRANK, encoding="utf-8")
    said: list[str] = []
    from matplotlib.axes import Axes

    titled = Axes.set_title
    monkeypatch.setattr(Axes, "set_title", lambda self, text, **how: (said.append(text), titled(self, text, **how))[1])
    out = tmp_path / "c.png"
    assert main(["chart", str(tmp_path / "s.yaml"), "-o", str(out), "--lang", "en"]) == 0
    assert out.exists() and any("no limit: neither the drive" in text for text in said)


@pytest.mark.few(1)
@pytest.mark.parametrize(
    ("name", "words"),
    [
        ("six-link", "distance to φ = 129.5274°, rad"),
        ("sliding-driver", "distance to s = −0.1378775 m, m"),
        ("kind-5-rpp", "angle of the guide n-n: distance to 0° (75° in the scene), rad, at φ = −130°"),
    ],
)
def test_an_axis_says_what_is_altered(name: str, words: str) -> None:
    limit = find_nearest_limit(Comparison(plans(name)))
    assert limit and distance_axis_title(limit, "en") == words


def test_a_driver_at_rest_is_moved() -> None:
    mechanism = load(str(SAMPLES / "bntu-1.yaml")).mechanism
    assert mechanism and mechanism.drive.velocity == 0 and with_moving_driver(mechanism).drive.velocity == 1
    quick = replace(mechanism, drive=replace(mechanism.drive, velocity=3.0))
    assert with_moving_driver(quick) is quick


def test_what_cannot_be_charted_is_said(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene = str(SAMPLES / "six-link.yaml")
    assert main(["chart", scene, "-o", str(tmp_path / "c.xls"), "--lang", "en"]) == 2
    assert main(["chart", str(SAMPLES / "vectors.yaml"), "-o", str(tmp_path / "c.png"), "--lang", "en"]) == 2
    told = capsys.readouterr().err
    assert "valid: .png, .svg, .pdf" in told and "has no mechanism" in told and not list(tmp_path.iterdir())
