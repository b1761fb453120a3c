"""A moving picture: as many frames as positions, poles at rest, each vector as long as its value at the one μ."""

from __future__ import annotations

import math
import re
from itertools import pairwise
from pathlib import Path

import pytest
from PIL import Image

import planes
from planes.cli import main
from planes.documents.animation import frames_and_size, positions_over_turn
from planes.words.names import VELOCITY_PLAN
from render.paper.marks import Arrow
from tests.helpers import ROOT

FOUR_BAR = ROOT / "samples" / "kind-1-rrr.yaml"
ROCKING = ROOT / "samples" / "six-link.yaml"


def test_frames_are_the_positions_of_one_turn(tmp_path: Path) -> None:
    file = tmp_path / "turn.gif"
    planes.animate(planes.load(FOUR_BAR), file, frames=4, seconds=2, lang="en")
    with Image.open(file) as film:
        assert film.n_frames == 4 and film.info["loop"] == 0  # type: ignore[attr-defined]
        assert film.info["duration"] == 500 and abs(film.size[0] - 900) <= 1


def test_one_scale_for_all_frames_and_poles_at_rest() -> None:
    scene = planes.load(FOUR_BAR)
    drawn, back = positions_over_turn(scene, 6, "en")
    assert not back and len(drawn) == 6
    assert len({one.scales[VELOCITY_PLAN.mu_name] for one in drawn}) == 1
    pages, (wide, high) = frames_and_size(scene, drawn, "en")
    tails = []
    for page, one in zip(pages, drawn, strict=True):
        (crank,) = [m for m in page if isinstance(m, Arrow) and m.name == "v_B"]
        assert abs(crank.end - crank.start) == pytest.approx(
            abs(one.v["B"]) * one.scales[VELOCITY_PLAN.mu_name], abs=1e-9
        )
        tails.append(crank.start)
        assert all(0 < z.real < wide and 0 < z.imag < high for z in (crank.start, crank.end))
    assert max(abs(z - tails[0]) for z in tails) < 1e-9


def test_a_driver_that_only_swings_goes_there_and_back(tmp_path: Path) -> None:
    file = tmp_path / "swing.svg"
    planes.animate(planes.load(ROCKING), file, frames=3, lang="en")
    text = file.read_text("utf-8")
    assert re.search(r'<svg[^>]* lang="en"', text) and re.search(r"<title>[^<]+</title>", text)
    assert text.count("<animate ") == 6 and "<script" not in text  # four positions and two of them on the way back
    starts = sorted(float(x.split(";")[1]) for x in re.findall(r'keyTimes="(.*?)"', text))
    assert all(math.isclose(b - a, 1 / 6, abs_tol=1e-5) for a, b in pairwise(starts))


@pytest.mark.slow
def test_the_command_writes_a_moving_svg(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "turn.svg"
    assert main(["cycle", str(FOUR_BAR), "--film", "-o", str(file), "--lang", "en"]) == 0
    text = file.read_text("utf-8")
    assert text.count("<animate ") == 60 and "<script" not in text and text.count("</svg>") == 1
    assert main(["cycle", str(FOUR_BAR), "--film", "--lang", "en"]) == 2
    assert "--film has no effect without --output" in capsys.readouterr().err


def test_a_film_opens(tmp_path: Path) -> None:
    cv2 = pytest.importorskip("cv2")
    file = tmp_path / "turn.mp4"
    planes.animate(planes.load(FOUR_BAR), file, frames=4, seconds=1, lang="en")
    film = cv2.VideoCapture(str(file))
    assert film.get(cv2.CAP_PROP_FRAME_COUNT) == 4 and film.get(cv2.CAP_PROP_FPS) == pytest.approx(4)
    assert film.read()[1].mean() > 200  # ink on white paper


@pytest.mark.parametrize(
    ("file", "more", "says"),
    [
        ("a.avi", {}, "must end in .gif, .svg, .mp4"),
        ("a.gif", {"frames": 1}, "at least two frames"),
        ("a.gif", {"seconds": 0}, "duration"),
    ],
)
def test_what_cannot_move_is_one_sentence(tmp_path: Path, file: str, more: dict[str, int], says: str) -> None:
    with pytest.raises(planes.PlanesError) as refused:
        planes.animate(planes.load(FOUR_BAR), tmp_path / file, **more)  # type: ignore[arg-type]
    assert says in refused.value.told("en") and not list(tmp_path.iterdir())


def test_the_command_picks_it_by_the_suffix(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    vectors = ROOT / "samples" / "vectors.yaml"
    assert main(["cycle", str(vectors), "-o", str(tmp_path / "a.gif"), "--lang", "en"]) == 2
    assert "has no mechanism" in capsys.readouterr().err
    assert main(["cycle", str(FOUR_BAR), "--show", "v_C", "-o", str(tmp_path / "a.gif"), "--lang", "en"]) == 2
    assert "--show" in capsys.readouterr().err and not list(tmp_path.iterdir())
