"""What is not seen is not right: empty blanks, marks put anywhere, scribbles of every size are never judged right."""

from __future__ import annotations

import random
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pytest

from planes.check.grading.paper import Known, ReadMark, ReadPaper
from planes.check.grading.prepared_plan import Asked, PreparedPlan, known_plans, prepare
from planes.check.handed_in import read_paper
from planes.check.outcome import check
from planes.check.reading.matching import read_plan_marks
from planes.check.reading.strokes import ReadDrawing
from planes.check.reading.svg import read_svg
from planes.check.reading.written import Words
from planes.check.report import as_json
from planes.cli import main
from planes.documents.check import write_blank
from planes.drafting.drawing import draw_program
from planes.drafting.steps import Similar
from planes.plans import plans_of
from planes.scene import load
from tests.helpers import ROOT

SAMPLES = ROOT / "samples"
SCENES = ("kind-1-rrr", "bntu-2", "assignments/66")
SIZES = (0.1, 0.3, 0.5, 1, 2, 4, 10, 30, 100, 300)
RIGHT = {"p": 0j, "b": 30 + 51.96j, "c": 71.66 - 8.11j, "s2": 57.77 + 11.91j, "l": 41.13 - 29.28j, "h": 30.03j}


@cache
def benches() -> tuple[PreparedPlan, ...]:
    """Every plan of the scenes."""
    return tuple(_benches())


def _benches() -> Iterator[PreparedPlan]:
    for name in SCENES:
        scene = load(SAMPLES / f"{name}.yaml")
        assert scene.mechanism
        for plan in known_plans(plans_of(scene.mechanism, scene.file)):
            yield prepare(Asked(scene, plan))


@pytest.mark.slow
def test_an_empty_blank_is_unreadable(tmp_path: Path) -> None:
    for bench in benches():
        file = tmp_path / "blank.svg"
        write_blank(bench.asked, str(file), "en")
        assert check(bench.asked, read_plan_marks(read_svg(file), bench)).verdict == "unreadable", bench.asked


FILES = sorted(p for p in (*SAMPLES.glob("*.yaml"), *SAMPLES.glob("assignments/*.yaml")) if p.stem != "vectors")


@pytest.mark.few(0, slow=5)
@pytest.mark.parametrize("sample", FILES, ids=lambda p: p.stem)
def test_an_empty_blank_of_every_sample_is_unreadable(sample: Path, tmp_path: Path) -> None:
    scene, file = load(sample), str(tmp_path / "blank.svg")
    assert scene.mechanism
    for plan in known_plans(plans_of(scene.mechanism, scene.file)):
        asked = Asked(scene, plan)
        write_blank(asked, file, "ru")
        assert check(asked, read_paper(file, asked, Known())).verdict == "unreadable", plan


@pytest.mark.few(1)
@pytest.mark.parametrize("suffix", ["pdf", "png"])
def test_an_empty_blank_on_paper_is_unreadable(tmp_path: Path, suffix: str) -> None:
    pytest.importorskip("cv2")
    scene, file = str(SAMPLES / "kind-1-rrr.yaml"), str(tmp_path / f"blank.{suffix}")
    for plan in ("velocity", "acceleration"):
        assert main(["blank", scene, "--plan", plan, "-o", file]) == 0
        assert main(["check", scene, file, "--plan", plan]) == 2


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("size", SIZES)
def test_marks_put_anywhere_are_never_right(size: float) -> None:
    rng = random.Random(size)
    for bench in benches():
        labels = [m.label for m in bench.marks]
        for count in (3, len(labels)):
            names = rng.sample(labels, min(count, len(labels)))
            spots = [ReadMark(n, complex(rng.uniform(-size, size), rng.uniform(-size, size)), 0.05) for n in names]
            assert check(bench.asked, ReadPaper("t", [ReadMark("p", 0j), *spots])).verdict != "right", (
                bench.asked,
                spots,
            )


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("size", SIZES)
def test_scribbles_are_never_right(size: float) -> None:
    rng = random.Random(size)
    for bench in benches()[::2]:
        z = [complex(rng.uniform(-size, size), rng.uniform(-size, size)) for _ in range(rng.choice([4, 8, 20]))]
        sketch = ReadDrawing("scribble", words=[Words("p", z[0], 3, 2)])
        if rng.random() < 0.5:
            sketch.words += [Words(m.label, rng.choice(z), 3, 2) for m in bench.marks]
        sketch.add_polyline(z)
        assert check(bench.asked, read_plan_marks(sketch, bench)).verdict != "right", (bench.asked, z)


def test_marks_read_badly_show_nothing() -> None:
    """A table may say how surely its marks were read, and then anything would do."""
    asked = Asked(load(SAMPLES / "six-link.yaml"), "velocity")
    for error in (0.1, 50.0):
        found = check(asked, ReadPaper("t", [ReadMark(n, z, error) for n, z in RIGHT.items()]))
        assert found.verdict == ("right" if error < 1 else "unreadable")


@pytest.mark.parametrize(
    ("lengths", "mu", "verdict"),
    [
        ({"pb": 60.0}, None, "right"),
        ({"pb": 45.0}, None, "unreadable"),
        ({"pb": 0.5, "bc": 0.4, "pc": 0.7}, None, "unreadable"),
        ({"pb": 60.0, "bc": 73.1, "pc": 72.1}, 30.0, "right"),
        ({"pb": 36.0, "bc": 43.9, "pc": 43.3, "ps2": 35.4}, None, "right"),
    ],
)
def test_lengths_at_a_scale_of_their_own(lengths: dict[str, float], mu: float | None, verdict: str) -> None:
    asked = Asked(load(SAMPLES / "six-link.yaml"), "velocity", mu=mu)
    assert check(asked, ReadPaper("t", segments=list(lengths.items()))).verdict == verdict


def test_a_table_without_one_force_of_a_polygon_is_not_judged() -> None:
    """Marks of another plan: not one force is said to be left out."""
    asked = Asked(load(SAMPLES / "six-link.yaml"), "force:2-3")
    found = check(asked, ReadPaper("t", [ReadMark(n, z) for n, z in RIGHT.items()]))
    assert found.verdict == "unreadable" and found.sentence.key == "check_of_another_plan"


def test_marks_that_were_not_seen_are_named() -> None:
    asked = Asked(load(SAMPLES / "six-link.yaml"), "velocity")
    spots = [ReadMark(n, z) for n, z in RIGHT.items()]
    whole, part = (
        check(asked, ReadPaper("t", spots)),
        check(asked, ReadPaper("t", [s for s in spots if s.name != "s2"])),
    )
    assert not whole.unseen and whole.sentence.told("en") == "The drawing is right: velocity polygon."
    found = as_json(part)
    assert part.unseen == ["s2"] and "not judged: s2" in found["sentence"]["en"]
    assert "не проверено: s2" in found["sentence"]["ru"]
    assert found["warnings"] == ["Not seen and not judged: s2."]


@pytest.mark.parametrize(("named", "verdict"), [((), "unreadable"), (("b",), "right")])
def test_a_mark_that_its_name_tells_is_enough_to_judge_by(named: tuple[str, ...], verdict: str) -> None:
    """The only crossing of a plan, upon another mark, is read by its name alone."""
    scene = load(SAMPLES / "bntu-2.yaml")
    bench = prepare(Asked(scene, "velocity", mu=prepare(Asked(scene, "velocity")).said_mu))
    spots = [ReadMark("p", 0j), ReadMark("a", bench.true_marks["a"])]
    assert check(bench.asked, ReadPaper("t", spots, whole=False, named=list(named))).verdict == verdict


def test_a_mistake_that_changes_nothing_is_not_named() -> None:
    """A point on the line of its link, turned over about that line, stays where it is."""
    count = 0
    for bench in benches():
        true = draw_program(bench.program, bench.given) if bench.asked.plan == "velocity" else {}
        for step in bench.program.steps if true else ():
            if not isinstance(step, Similar) or complex(bench.given[step.ratio]).imag or step.makes not in bench.marks:
                continue
            for off in (1.5 + 1j, -2 + 0.5j, 3j):
                places = {m.label: complex(true[m]) + (off if m == step.makes else 0) for m in bench.marks}
                spots = [ReadMark("p", 0j), *(ReadMark(n, z, 0.05) for n, z in places.items())]
                assert check(bench.asked, ReadPaper("t", spots)).mistake != "similarity_mirrored", (bench.asked, step)
                count += 1
    assert count
