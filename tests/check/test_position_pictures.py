"""Pictures of position plans: schemes with hinges, guides, sliders and supports, right or with one mistake."""

from __future__ import annotations

import random
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from tests.confusion import SAMPLES
from tests.sample_oracle import HIGHER, SKETCHES

cv2 = pytest.importorskip("cv2")
from planes.check.blank import blank_pole, plan_fitting_blank  # noqa: E402
from planes.check.grading.prepared_plan import Asked, PreparedPlan, prepare  # noqa: E402
from planes.check.outcome import Outcome, check  # noqa: E402
from planes.check.vision.photograph import read_picture  # noqa: E402
from planes.scene import load  # noqa: E402
from tests.helpers import photographs  # noqa: E402
from tests.helpers import position_pictures as schemes  # noqa: E402
from tests.helpers.photographs import PHONE, SCAN, Camera  # noqa: E402


@cache
def bench(sample: str) -> PreparedPlan:
    """The scheme at the scale of its blank, told."""
    free = plan_fitting_blank(prepare(Asked(load(SAMPLES / f"{sample}.yaml"), "position")))
    return prepare(Asked(free.asked.scene, "position", mu=free.said_mu))


def looked(
    sample: str, sol: Any, camera: Camera, folder: Path, seed: int = 1, symbols: int = 2, as_sample: str = ""
) -> tuple[schemes.Scheme, Outcome]:
    """A scheme on its blank (or on another's), and what the checker finds in its picture."""
    b, file, rng = bench(as_sample or sample), folder / "p.jpg", random.Random(f"{sample} {seed}")
    drawn = schemes.scheme(sample, sol, bench(sample).said_mu)
    photographs.save(str(file), schemes.picture(drawn, blank_pole(b), camera, rng, symbols), camera)
    return drawn, check(b.asked, read_picture(str(file), b))


def off(drawn: schemes.Scheme, found: Outcome) -> list[float]:
    """How far the points were read from where they were put, mm."""
    origin = next(s.place for s in found.paper.spots if s.name == "p")
    return [abs(s.place - origin - drawn.places[s.name]) for s in found.paper.spots if s.name in drawn.places]


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(
    "camera", [replace(PHONE, grid="square", erased=2), replace(SCAN, grid="millimetre")], ids=["phone", "scan"]
)
@pytest.mark.parametrize("first", range(3))
def test_right_schemes_are_right_and_their_points_where_they_were_put(
    first: int, camera: Camera, tmp_path: Path
) -> None:
    errors, count = [], 0
    for sample in list(SKETCHES)[first::3]:
        drawn, found = looked(sample, schemes.solved(sample), camera, tmp_path)
        # a point to which no link's line leads is not seen by lines alone: a slider's between two guides, a centre
        if sample in ("excavator", "assignment-12"):  # two links in one line: where one ends nobody sees by lines alone
            continue
        assert found.verdict == "right" or len(found.unseen) == 1, (sample, found.sentence.told("en"))
        errors += off(drawn, found)
        count += len(drawn.places)
    errors.sort()
    assert len(errors) > 0.6 * count  # centres and points at guides have no line that leads to them
    assert errors[len(errors) // 2] < 0.3 and errors[int(0.95 * len(errors))] < 1.0


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("first", range(3))
@pytest.mark.parametrize("symbols", [0, 1])
def test_a_scheme_without_its_signs(symbols: int, first: int, tmp_path: Path) -> None:
    """Lines alone, or with circles and dots: read, or said to be unreadable where links in one line hide a hinge, or
    a guide of class III runs over one, so that no end is seen there."""
    found = {s: looked(s, schemes.solved(s), SCAN, tmp_path, symbols=symbols)[1] for s in list(SKETCHES)[first::3]}
    assert "wrong" not in {f.verdict for f in found.values()}
    unread = {s for s, f in found.items() if f.verdict == "unreadable"}
    assert unread <= ({"bntu-5", "assignment-12", "shaper", "excavator", *HIGHER} if symbols == 0 else set())


def scaled(link: str, point: str, factor: float) -> schemes.Change:
    def change(scene: dict[str, Any]) -> None:
        scene["links"][link]["points"][point] *= factor

    return change


def through_pivot(scene: dict[str, Any]) -> None:
    scene["frame"]["guides"]["q-q"]["through"] = [0, 0]


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize(
    ("sample", "mistake", "where", "made"),
    [
        ("six-link", "other_assembly", "C", {"mirrored": "C"}),
        ("kind-1-rrr", "other_assembly", "C", {"mirrored": "C"}),
        ("sliding-driver", "other_assembly", "C", {"mirrored": "C"}),
        ("kind-2-rrp", "guide_offset_ignored", "C", {"change": through_pivot}),
        ("kind-2-rrp", "angle_sense", "B", {"phi": -15.0}),
        ("kind-3-rpr", "angle_sense", "B", {"phi": 70.0}),
        ("kind-4-prp", "angle_sense", "K", {"phi": 5.0}),
        ("bntu-3", "angle_sense", "A", {"phi": 90.0}),
        ("kind-5-rpp", "angle_sense", "A", {"phi": 130.0}),
        ("kind-2-rrp", "link_scale", "C", {"change": scaled("2", "C", 0.85)}),
        ("bntu-1", "link_scale", "B", {"change": scaled("2", "B", 0.9)}),
        ("bntu-3", "link_scale", "C", {"change": scaled("3", "C", 0.9)}),
        ("kind-4-prp", "link_scale", "K", {"change": scaled("1", "K", 1.15)}),
    ],
)
def test_mistakes_of_a_scheme_are_seen_and_named(
    sample: str, mistake: str, where: str, made: dict[str, Any], tmp_path: Path
) -> None:
    sol = schemes.mistaken(sample, made.get("change"), made.get("phi"), made.get("mirrored", ""))
    _, found = looked(sample, sol, PHONE if mistake == "angle_sense" else SCAN, tmp_path)
    assert (found.verdict, found.mistake, found.first_wrong) == ("wrong", mistake, where)


@pytest.mark.slow
def test_another_scheme_is_not_this_one(tmp_path: Path) -> None:
    for other in ("kind-1-rrr", "kind-5-rpp", "bntu-3"):
        _, found = looked(other, schemes.solved(other), SCAN, tmp_path, as_sample="six-link")
        assert found.verdict == "unreadable", other


@pytest.mark.slow
def test_an_empty_blank_of_a_scheme(tmp_path: Path) -> None:
    drawn = schemes.Scheme()
    for symbols in (0, 2):
        file = tmp_path / "p.png"
        cv2.imwrite(str(file), schemes.picture(drawn, 150 + 100j, SCAN, random.Random(1), symbols))
        assert check(bench("six-link").asked, read_picture(str(file), bench("six-link"))).verdict == "unreadable"
