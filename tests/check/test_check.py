"""Checking a person's drawing: tables, lines, pictures; what is found, where it is blamed, how it is named."""

from __future__ import annotations

import json
import math
import random
import re
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from planes.check.grading.paper import ReadMark, ReadPaper, read_table
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.outcome import check
from planes.check.reading.matching import read_plan_marks
from planes.check.reading.svg import read_svg
from planes.check.report import as_json, result_table_rows
from planes.cli import main
from planes.drafting.drawing import draw_program as run_program
from planes.scene import load
from planes.words.errors import PlanesError
from planes.words.names import VELOCITY_PLAN
from tests import confusion
from tests.confusion import SAMPLES, Easel, easels, run_all, told
from tests.helpers import drawings, line_drawings
from tests.helpers.drawings import Care, Hand, Mistake

SIX = str(SAMPLES / "six-link.yaml")
RIGHT = {"p": 0j, "b": 30 + 51.96j, "c": 71.66 - 8.11j, "s2": 57.77 + 11.91j, "l": 41.13 - 29.28j, "h": 30.03j}
KEYS = {
    "planes",
    "scene",
    "phi_deg",
    "plan",
    "verdict",
    "marks",
    "first_wrong",
    "mistake",
    "runner_up",
    "sentence",
    "results",
}


def csv(marks: dict[str, complex], separator: str = ",", comma: str = ".", origin: complex = 100 + 80j) -> str:
    rows = [[n, f"{(z + origin).real:.2f}", f"{(z + origin).imag:.2f}"] for n, z in marks.items()]
    lines = [["mark", "x_mm", "y_mm"], *[[r[0], *(c.replace(".", comma) for c in r[1:])] for r in rows]]
    return "\n".join(separator.join(line) for line in lines) + "\n"


def asked(plan: str = "velocity", **options: Any) -> Asked:
    return Asked(load(SIX), plan, **options)


def run(capsys: pytest.CaptureFixture[str], *args: str) -> tuple[int, dict[str, Any]]:
    status = main(["check", SIX, *args, "--json"])
    out = capsys.readouterr().out
    return status, json.loads(out) if out else {}


@pytest.mark.parametrize(("separator", "comma"), [(",", "."), (";", ","), (";", "."), ("\t", ",")])
def test_a_right_table_is_right(tmp_path: Path, capsys: pytest.CaptureFixture[str], separator: str, comma: str) -> None:
    file = tmp_path / "v.csv"
    file.write_text(csv(RIGHT, separator, comma), encoding="utf-8-sig")
    status, found = run(capsys, str(file), "--plan", "velocity")
    assert status == 0 and found["verdict"] == "right" and found["first_wrong"] is None and found["mistake"] is None
    assert set(found) >= KEYS and {m["mark"] for m in found["marks"]} == set(RIGHT) - {"p"}
    assert all(m["verdict"] == "right" and m["deviation_mm"] < 0.1 for m in found["marks"])
    assert found["phi_deg"] == 150.0 and set(found["sentence"]) >= {"ru", "en"}


def test_what_follows_is_not_blamed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "v.csv"
    file.write_text(csv({n: -z for n, z in RIGHT.items()}), encoding="utf-8")
    status, found = run(capsys, str(file), "--plan", "velocity")
    assert status == 1 and (found["first_wrong"], found["mistake"]) == ("b", "omega1_reversed")
    verdicts = {m["mark"]: m["verdict"] for m in found["marks"]}
    assert verdicts == {"b": "wrong", "c": "follows", "s2": "follows", "l": "follows", "h": "follows"}


def test_names_of_all_alphabets_and_a_missing_normal(tmp_path: Path) -> None:
    easel = confusion.easel("kind-1-rrr", "acceleration")
    marks, _ = easel.draw(Mistake("normal_missing", "n_CB"), Hand(drawings.NONE, random.Random(1)))
    odd = {"n_B": "n_В", "b'": "b’", "c'": "с′", "n_CD": "n CD"}
    file = tmp_path / "a.csv"
    file.write_text(csv({"π": 0j, **{odd.get(n, n): z for n, z in marks.items()}}, ";", ","), encoding="utf-8")
    found = check(Asked(load(SAMPLES / "kind-1-rrr.yaml"), "acceleration"), read_table(file))
    assert (found.first_wrong, found.mistake) == ("n_CB", "normal_missing")


NORMALS = ("n_BA", "nBA", "n_{BA}", "n_ВА", "n_B", "nB")


@pytest.mark.parametrize("written", NORMALS)
def test_the_normal_part_of_a_driven_point_is_written_with_its_pivot_or_without(written: str, tmp_path: Path) -> None:
    """In a table of marks, in one of segments, and beside a vector of a drawing."""
    easel = next(e for e in easels() if (e.sample, e.plan) == ("six-link", "acceleration"))
    bench = prepare(asked("acceleration", mu=easel.mu))
    true = {m.label: complex(run_program(bench.program, bench.given)[m]) for m in bench.marks}
    spots = [ReadMark(written if n == "n_B" else n, z + 7) for n, z in {"p": 0j, **true}.items()]
    found = check(bench.asked, ReadPaper("t", spots))
    assert found.verdict == "right" and found.grading and not found.notes and not found.unseen
    assert found.grading.hand.taken["acceleration:n_B"].place == pytest.approx(true["n_B"])
    spots = [ReadMark(s.name, 7 - true["n_B"]) if s.name == written else s for s in spots]
    assert check(bench.asked, ReadPaper("t", spots)).first_wrong == "n_B"
    lengths = [(f"p{written}", abs(true["n_B"])), (f"{written}b'", abs(true["b'"] - true["n_B"])), ("pb'", 1.0)]
    table = check(bench.asked, ReadPaper("t", segments=lengths))
    assert not table.notes and [s["mark"] for s in as_json(table)["marks"]] == ["pn_B", "n_Bb'", "pb'"]
    strokes, words = sketch_of(easel, None)
    file = tmp_path / "plan.svg"
    words = [(written if n == "n_B" else n, z) for n, z in words]
    file.write_text(line_drawings.inkscape(strokes, words, 0j), encoding="utf-8")
    paper = read_plan_marks(read_svg(file), bench)
    assert "n_B" in {s.name for s in paper.spots} and check(bench.asked, paper).verdict == "right"


@pytest.mark.parametrize(
    ("rows", "plan", "first", "mistake"),
    [
        ([("v_C", 2.4, "m/s"), ("omega_2", 8.12, "рад/с")], "velocity", None, None),
        ([("v_C", 2404.0, "мм/с")], "velocity", None, None),
        ([("v_C", 2.4 * 900, "m/s"), ("omega_2", 8.12, "")], "velocity", "v_C", "mu_inverted"),
        ([("v_C", 72.1, "m/s")], "velocity", "v_C", "mm_for_value"),
        ([("v_C", 2404.0, "")], "velocity", "v_C", "unit_missing"),
        ([("omega_2", 8.12 * 30 / 3.1416, "")], "velocity", "omega_2", "unit_missing"),
        ([("omega_2", 8.12 * 180 / 3.1416, "rad/s")], "velocity", "omega_2", "unit_missing"),
        ([("omega_2", 465.2, "°/s")], "velocity", None, None),
        ([("omega_2", 8.12 / 250, "rad/s")], "velocity", "omega_2", "omega_without_mu_l"),
        ([("omega_2", 8.12, ""), ("omega_3", 16.0, "")], "velocity", "omega_3", "sense_wrong"),
    ],
)
def test_results(rows: list[tuple[str, float, str]], plan: str, first: str | None, mistake: str | None) -> None:
    found = as_json(check(asked(plan), ReadPaper("t", results=rows)))
    assert (found["first_wrong"], found["mistake"]) == (first, mistake)
    assert [r["name"] for r in found["results"]] == [n for n, _, _ in rows]


@pytest.mark.parametrize(
    ("rows", "said"),
    [
        ("v_C,2.4\nomega_2,8.12\n", "Right as far as seen: results; not in the table: epsilon_2, omega_3, "),
        ("v_H,1.2\nv_X,1\n", "Right as far as seen: results; not judged: v_H; not in the table: omega_2, "),
        ("v_C,2.4\nomega_3,16\n", "omega_3: the magnitude is right, but the sign "),
    ],
)
def test_results_alone_need_no_plan(rows: str, said: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    file = tmp_path / "results.csv"
    file.write_text(f"result,value\n{rows}", "utf-8")
    main(["check", SIX, str(file), "--lang", "en"])
    assert capsys.readouterr().out.startswith(said)
    file.write_text("mark,x_mm,y_mm\np,0,0\n", "utf-8")
    assert main(["check", SIX, str(file)]) == 2


@pytest.mark.parametrize(
    ("sample", "link", "ends"), [("bntu-5", "2", "BA"), ("sliding-driver", "2", "CB"), ("sliding-driver", "3", "CD")]
)
def test_epsilon_from_the_total(sample: str, link: str, ends: str) -> None:
    """ε by the whole a_CB instead of its tangential part, where the normal part is large."""
    solved = confusion.motion(sample).sol
    one, two = (solved.points[n] for n in ends)
    total, true = abs(one[2] - two[2]) / abs(one[0] - two[0]), solved.links[link][2]
    assert total > 1.2 * abs(true)
    asked_for = Asked(load(SAMPLES / f"{sample}.yaml"), "acceleration")
    for written, mistake in ((math.copysign(total, true), "epsilon_from_total"), (true, None)):
        found = check(asked_for, ReadPaper("t", results=[(f"epsilon_{link}", written, "")]))
        assert (found.mistake, found.first_wrong) == (mistake, f"epsilon_{link}" if mistake else None)


POSITIONS = [
    ("guide_offset_ignored", "C", {"e": 0.0}),
    ("angle_sense", "B", {"phi_1": -15}),
    ("angle_sense", "B", {"phi_1": 75}),
    ("link_scale", "B", {"l_AB": 0.066}),
    ("link_scale", "C", {"l_BC": 0.16}),
]


@pytest.mark.parametrize(("mistake", "where", "changed"), POSITIONS)
def test_position_plans_with_one_mistake(mistake: str, where: str, changed: dict[str, float], tmp_path: Path) -> None:
    """A slider-crank with an inclined offset guide, drawn by another scene in which the mistake is the truth."""
    text = (SAMPLES / "kind-2-rrp.yaml").read_text(encoding="utf-8")
    wrong = text
    for name, value in changed.items():
        wrong = re.sub(rf"\b{name}: [\d.]+", f"{name}: {value}", wrong, count=1)
    file = tmp_path / "wrong.yaml"
    file.write_text(wrong, encoding="utf-8")
    drawn = solved_points(file)
    rng, mu = random.Random(3), prepare(Asked(load(SAMPLES / "kind-2-rrp.yaml"), "position")).said_mu
    for noise in (0.0, 0.2, 0.2, 0.2):
        spots = [
            ReadMark(n, z * mu + complex(rng.gauss(0, noise), rng.gauss(0, noise)), 0.03) for n, z in drawn.items()
        ]
        found = check(
            Asked(load(SAMPLES / "kind-2-rrp.yaml"), "position", mu=mu), ReadPaper("t", [ReadMark("p", 0j), *spots])
        )
        assert (found.first_wrong, found.mistake) == (where, mistake)
    right = [ReadMark(n, z * mu, 0.03) for n, z in solved_points(SAMPLES / "kind-2-rrp.yaml").items()]
    found = check(
        Asked(load(SAMPLES / "kind-2-rrp.yaml"), "position", mu=mu), ReadPaper("t", [ReadMark("p", 0j), *right])
    )
    assert found.verdict == "right"


def solved_points(file: Path) -> dict[str, complex]:
    """Points of a scene, m."""
    bench = prepare(Asked(load(file), "position"))
    drawn = run_program(bench.program, bench.given)
    return {m.rpartition(":")[2]: complex(drawn[m]) / bench.said_mu for m in bench.marks}


def test_segments_with_another_scale() -> None:
    lengths = {"pb": 60.0, "bc": 73.1, "pc": 72.1, "ps2": 59.0}
    for factor in (1.0, 0.5, 1.7):
        found = check(asked(), ReadPaper("t", segments=[(n, v * factor) for n, v in lengths.items()]))
        assert found.verdict == "right", factor
    wrong = check(asked(), ReadPaper("t", segments=[("pb", 60.0), ("bc", 73.1), ("pc", 120.0)]))
    assert wrong.verdict == "wrong"


def test_the_scale_is_free_but_a_stated_one_is_not() -> None:
    paper = ReadPaper("t", [ReadMark(n, 0.6 * z + 30, 0.05) for n, z in RIGHT.items()])
    found = as_json(check(asked(), paper))
    assert found["verdict"] == "right" and "18" in " ".join(found["warnings"])
    assert as_json(check(asked(mu=30.0), paper))["first_wrong"] == "b"


def test_the_same_persons_velocities_count() -> None:
    """Normals are judged from the velocities the person really drew."""
    easel = confusion.easel("kind-1-rrr", "acceleration")
    m, hand = confusion.motion("kind-1-rrr"), Hand(drawings.NONE, random.Random(1))
    mu_scheme = confusion.bench("kind-1-rrr", "acceleration").given["mu_position"]
    scheme = drawings.draw_scheme(m, hand, mu_scheme)
    velocity = drawings.draw_velocity(m, hand, easel.mu_v, scheme, Mistake("relative_from_pole", "c"))
    drawn = drawings.draw_acceleration(m, hand, easel.mu, scheme, velocity, easel.mu_v)
    papers = [
        ReadPaper("t", [ReadMark("p", 0j), *(ReadMark(n, z) for n, z in s.marks.items())]) for s in (velocity, drawn)
    ]
    scene = load(SAMPLES / "kind-1-rrr.yaml")
    alone = check(Asked(scene, "acceleration"), papers[1])
    both = check(Asked(scene, "acceleration", others={VELOCITY_PLAN: papers[0]}), papers[1])
    assert alone.verdict != "right" and both.verdict == "right"


@pytest.mark.few(1)
@pytest.mark.parametrize(
    "text",
    [
        "",
        "x",
        "a,b\n1,2\n",
        "mark,x_mm,y_mm\nb,one,2\n",
        "mark,x_mm,y_mm\np,nan,0\n",
        "mark,x_mm,y_mm\np,0,1e308\n",
        "{",
        "[1]",
        '{"marks": 5}',
        "mark,x_mm,y_mm\np,1\n",
    ],
)
def test_bad_tables_are_one_sentence(tmp_path: Path, text: str) -> None:
    file = tmp_path / "t.csv"
    file.write_text(text, encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-m", "planes", "check", SIX, str(file), "--plan", "velocity"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2 and "Traceback" not in done.stderr + done.stdout


def test_another_drawing_is_unreadable() -> None:
    for other in ("kind-1-rrr", "kind-2-rrp"):
        easel = confusion.easel(other, "velocity")
        paper = confusion.hand_in(easel, None, Care(), random.Random(1))
        found = as_json(check(Asked(load(SIX), "velocity", mu=30.0), paper))
        assert found["verdict"] == "unreadable" and found["first_wrong"] is None, other
    with pytest.raises(PlanesError, match="velocity"):
        check(asked("speed"), paper)


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("mu_told", [True, False], ids=["", "without-mu"])
@pytest.mark.parametrize("first", range(2))
def test_confusion_table(capsys: pytest.CaptureFixture[str], mu_told: bool, first: int) -> None:
    """Half of all samples' velocity, acceleration and force plans, drawn with a pencil, right or with one mistake each;
    and a quarter with the scale for the checker to find, but for mistakes that only draw the plan larger."""
    found = run_all(1, Care(), list(easels())[first :: 2 if mu_told else 4], told=mu_told)
    with capsys.disabled():
        print("\n" + ("" if mu_told else "without μ\n") + told(found))
    part = 0.5 if mu_told else 0.25
    assert found.right > 200 * part and found.mistakes > 600 * part
    assert found.accepted >= 0.98 * found.right
    assert found.found >= 0.98 * found.mistakes
    assert found.blamed >= 0.95 * found.mistakes
    assert found.named >= 0.90 * found.mistakes
    assert found.innocent_blamed <= 0.02 * found.innocent or not mu_told


Writer = Callable[[list[tuple[complex, complex]], list[tuple[str, complex]], complex], str]


def sketch_of(easel: Easel, mistake: Mistake | None, seed: int = 1, factor: float = 1.0) -> tuple[list[Any], list[Any]]:
    """A plan as strokes and words, so many times larger."""
    drawn, _ = easel.draw(mistake, Hand(Care(), random.Random(seed)))
    marks = {n: factor * z for n, z in drawn.items()}
    if not easel.plan.startswith("force"):
        quick = easel.plan == "acceleration"
        strokes = line_drawings.motion_strokes(confusion.motion(easel.sample), marks, quick)
        return strokes, line_drawings.labels({"p": 0j, **marks}, random.Random(seed))
    strokes, z = [], 0j
    for v in marks.values():
        strokes.append((z, z + v))
        z += v
    return strokes, line_drawings.vector_labels(list(marks.items()))


@pytest.mark.parametrize("seed", range(3))
def test_noise_is_never_right(seed: int, tmp_path: Path) -> None:
    rng = random.Random(seed)
    spots = [complex(rng.uniform(0, 400), rng.uniform(0, 280)) for _ in range(20000 if seed == 0 else 80)]
    lines = list(zip(spots[::2], spots[1::2], strict=True))
    file = tmp_path / "noise.svg"
    file.write_text(line_drawings.inkscape(lines, [], 0j), encoding="utf-8")
    b = confusion.bench("six-link", "velocity")
    assert check(b.asked, read_plan_marks(read_svg(file), b)).verdict == "unreadable"


@pytest.mark.slow
@pytest.mark.parametrize("what", ["empty", "noise", "face", "text", "blank"])
def test_pictures_of_something_else(what: str, tmp_path: Path) -> None:
    cv2 = pytest.importorskip("cv2")
    import numpy as np

    from tests.helpers import photographs

    rng = np.random.default_rng(1)
    file = tmp_path / "x.png"
    if what == "text":
        file.write_text("no picture")
    else:
        picture = np.full((900, 1300), 230, np.uint8)
        if what == "noise":
            picture = rng.integers(0, 255, (900, 1300)).astype(np.uint8)
        elif what == "face":
            cv2.ellipse(picture, (600, 450), (200, 300), 0, 0, 360, 90, -1)
        elif what == "blank":
            picture = photographs.sheet([], [], 150 + 100j, photographs.SCAN, random.Random(1))
        cv2.imwrite(str(file), picture)
    done = subprocess.run(
        [sys.executable, "-m", "planes", "check", SIX, str(file), "--plan", "velocity"],
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2 and "Traceback" not in done.stderr and len(done.stderr + done.stdout) > 20


def test_a_picture_with_two_points_named(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """Without corner marks: the pole and one vector, in pixels, give the scale; that vector's length is not judged."""
    cv2 = pytest.importorskip("cv2")
    import numpy as np

    picture, k, pole = np.full((1500, 1500), 245, np.uint8), 9.0, 500 + 800j
    at = {n: pole + complex(z.real, -z.imag) * k for n, z in RIGHT.items()}
    for a, b in (("p", "b"), ("p", "c"), ("b", "c"), ("p", "s2"), ("p", "l"), ("l", "h"), ("p", "h")):
        one, two = ((int(at[n].real), int(at[n].imag)) for n in (a, b))
        cv2.line(picture, one, two, 60, 4, cv2.LINE_AA)
    file = tmp_path / "plain.png"
    cv2.imwrite(str(file), picture)
    b = at["b"]
    status, found = run(
        capsys,
        str(file),
        "--plan",
        "velocity",
        "--lang",
        "en",
        "--pole",
        "500,800",
        "--mark",
        f"b={b.real:.0f},{b.imag:.0f}",
    )
    assert status == 0 and found["verdict"] == "right"
    assert any("could not be judged" in w for w in found["warnings"])
    status, found = run(capsys, str(file), "--plan", "velocity")
    assert status == 2 and not found


@pytest.mark.parametrize("suffix", [".html", ".pdf", ".png", ".svg", ".json"])
def test_reports(tmp_path: Path, suffix: str, capsys: pytest.CaptureFixture[str]) -> None:
    drawing, report = tmp_path / "v.csv", tmp_path / f"report{suffix}"
    drawing.write_text(csv({n: -z for n, z in RIGHT.items()}), encoding="utf-8")
    assert main(["check", SIX, str(drawing), "--plan", "velocity", "-o", str(report), "--lang", "ru"]) == 1
    assert report.stat().st_size > 500
    if suffix == ".html":
        text = report.read_text(encoding="utf-8")
        assert "против вращения" in text and not re.search("https?:", text.replace("http://www.w3.org", ""))
    assert main(["check", SIX, str(drawing), "--plan", "velocity", "-o", str(tmp_path / "r.doc")]) == 2
    capsys.readouterr()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """The drawings of a class."""
    found = tmp_path / "class"
    found.mkdir()
    (found / "anna.csv").write_text(csv(RIGHT), encoding="utf-8")
    for name in ("boris", "gleb"):
        (found / f"{name}.csv").write_text(csv({n: -z for n, z in RIGHT.items()}), encoding="utf-8")
    (found / "vera.csv").write_text("nothing", encoding="utf-8")
    (found / "egor.doc").write_text("a letter", encoding="utf-8")
    (found / ".hidden").write_text("", encoding="utf-8")
    (found / "old.html").write_text("", encoding="utf-8")
    return found


def test_a_class(folder: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["check", SIX, str(folder), "--plan", "velocity", "--lang", "en"]) == 2
    rows = [line.split() for line in capsys.readouterr().out.splitlines()[2:]]
    assert [row[:2] for row in rows] == [
        ["anna.csv", "right"],
        ["boris.csv", "wrong"],
        ["egor.doc", "unreadable"],
        ["gleb.csv", "wrong"],
        ["vera.csv", "unreadable"],
    ]
    assert "rotation;" in rows[1] and "columns:" in rows[4]
    assert main(["check", SIX, str(folder), "--plan", "velocity", "--json"]) == 2
    found = {one["file"]: one for one in json.loads(capsys.readouterr().out)}
    assert [one["verdict"] for one in found.values()] == ["right", "wrong", "unreadable", "wrong", "unreadable"]
    assert found["boris.csv"]["mistake"] == "omega1_reversed" and ".doc" in found["egor.doc"]["sentence"]["en"]


@pytest.mark.parametrize("name", ["class.html", "class.csv", "class.json", "reports"])
def test_a_class_as_a_file(folder: Path, tmp_path: Path, name: str, capsys: pytest.CaptureFixture[str]) -> None:
    target = tmp_path / name
    assert main(["check", SIX, str(folder), "--plan", "velocity", "--lang", "ru", "-o", str(target)]) == 2
    if name == "reports":
        reports = {f"{n}.csv.html" for n in ("anna", "boris", "gleb")}
        assert {f.name for f in target.iterdir()} == {"index.html", "manifest.json", "rows", *reports}
        assert 'href="boris.csv.html"' in (target / "index.html").read_text(encoding="utf-8")
        target = target / "index.html"
    text = target.read_text(encoding="utf-8")
    assert all(f in text for f in ("anna.csv", "boris.csv", "egor.doc", "vera.csv"))
    if target.suffix == ".html":
        assert "против вращения ведущего звена; поверните вектор на 180° — <b>2</b>: " in text
    assert main(["check", SIX, str(folder), "--plan", "velocity", "-o", str(tmp_path / "class.doc")]) == 2
    capsys.readouterr()


def test_numbers_are_checked_apart_from_the_drawing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """A right drawing with a slip in the numbers: the marks are right, the number is named."""
    file = tmp_path / "v.csv"
    for name, written, mistake in (
        ("v_C", 2.4 * 900, "mu_inverted"),
        ("v_C", 72.1, "mm_for_value"),
        ("omega_2", 8.12 / 250, "omega_without_mu_l"),
        ("omega_3", 16.0, "sense_wrong"),
    ):
        file.write_text(
            csv(RIGHT)
            + f"result,value,unit\nomega_2,8.12,\n{name},{written},\n".replace("omega_2,8.12,\nomega_2", "omega_2"),
            encoding="utf-8",
        )
        status, found = run(capsys, str(file), "--plan", "velocity")
        assert status == 1 and (found["first_wrong"], found["mistake"]) == (name, mistake)
        assert {m["verdict"] for m in found["marks"]} == {"right"}


def test_slips_are_named_beside_a_wrong_drawing(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    """The drawing's mistake comes first; numbers reckoned wrongly, from true or from own segments, keep their names."""
    file, own = tmp_path / "v.csv", {n: -z for n, z in RIGHT.items()} | {"c": 30 + 40j}
    rows = f"v_C,{abs(own['c'])},m/s\nomega_2,{8.12 / 250},\nv_B,2,m/s\nv_S2,0.123,m/s\n"
    file.write_text(csv(own) + "result,value,unit\n" + rows, encoding="utf-8")
    status, found = run(capsys, str(file), "--plan", "velocity", "--lang", "en")
    assert status == 1 and found["first_wrong"] == "b"
    assert [(r["name"], r.get("mistake")) for r in found["results"]] == [
        ("v_C", "mm_for_value"),
        ("omega_2", "omega_without_mu_l"),
        ("v_B", None),
        ("v_S2", None),
    ]
    assert main(["check", SIX, str(file), "--plan", "velocity", "--lang", "en"]) == 1
    assert "wrong: the millimetres of the segment are given as the value" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("sample", "plan"),
    [("six-link", "velocity"), ("six-link", "acceleration"), ("six-link", "force:2-3"), ("kind-2-rrp", "position")],
)
def test_the_printed_report_keeps_to_its_sheet(sample: str, plan: str) -> None:
    """Everything inside the frame, the drawing off the table, however far a wrong mark has run away."""
    from planes.check.fiducials import SHEET_MM
    from planes.documents.check import _overlay_sheet_contents
    from render.paper.marks import Arc, Arrow, Line, Text
    from render.sheet.check_sheet import compose_check_sheet

    bench = prepare(Asked(load(SAMPLES / f"{sample}.yaml"), plan))
    drawn = run_program(bench.program, bench.given)
    spots = [ReadMark("p", 0j), *(ReadMark(m.rpartition(":")[2], complex(drawn[m])) for m in bench.marks)]
    spots[2] = ReadMark(spots[2].name, spots[2].place * 9 - 400)
    found = check(Asked(bench.asked.scene, plan, mu=bench.said_mu), ReadPaper("t", spots))
    marks, photo = compose_check_sheet(SHEET_MM, _overlay_sheet_contents(found, "ru"))
    places = [
        z
        for m in marks
        for z in (
            (m.start, m.end)
            if isinstance(m, Arrow)
            else m.points
            if isinstance(m, Line)
            else (m.place,)
            if isinstance(m, Text)
            else (m.centre,)
        )
    ]
    assert all(19.9 <= z.real <= SHEET_MM[0] - 4.9 and 4.9 <= z.imag <= SHEET_MM[1] - 4.9 for z in places)
    table = [z for m in marks if isinstance(m, Line) and m.layer == "table" for z in m.points]
    left, top, low = min(z.real for z in table), max(z.imag for z in table), min(z.imag for z in table)
    inked = [m.end if isinstance(m, Arrow) else m.centre for m in marks if isinstance(m, Arrow | Arc)]
    beside, beneath = (all(test(z) for z in inked) for test in (lambda z: z.real < left, lambda z: z.imag > top))
    assert (beside or beneath) and low > 4.9 and photo is None and len(marks) > 40


@pytest.mark.parametrize("suffix", [".pdf", ".svg", ".png"])
def test_a_printed_blank_is_found_by_its_corners(tmp_path: Path, suffix: str) -> None:
    pytest.importorskip("cv2")
    from planes.check.vision.image.decoding import load as picture
    from planes.check.vision.image.picture import find_marks, flatten

    file = tmp_path / f"blank{suffix}"
    assert main(["blank", SIX, "--plan", "velocity", "-o", str(file)]) == 0
    if suffix != ".svg":
        assert sorted(find_marks(picture(file).grey)) == [0, 1, 2, 3]
        flat = flatten(picture(file).grey)
        assert flat is not None and flat.grey.shape == (1680, 2376)


@pytest.mark.parametrize("plan", ["position", "velocity"])
def test_a_result_that_needs_no_step_of_the_plan_is_judged(plan: str) -> None:
    """What is given, or nothing at a fixed point, may be written beside any plan."""
    for name, true in (("epsilon_1", 80.0), ("a_A", 0.0), ("v_D", 0.0)):
        for value, verdict in ((true, "right"), (true + 20.0, "wrong")):
            found = check(asked(plan), ReadPaper("t", results=[(name, value, "")]))
            assert found.verdict == verdict, (name, found)


@pytest.mark.parametrize(
    "head",
    [
        "result,value,unit",
        "результат;значение;единица",
        "величина;число;ед.",
        "результат;значення;одиниця",
        "вынік;значэнне;адзінка",
    ],
)
def test_the_columns_of_a_table_are_named_in_any_language(head: str, tmp_path: Path) -> None:
    mark = ";" if ";" in head else ","
    (file := tmp_path / "t.csv").write_text(f"{head}\nv_C{mark}2.4{mark}m/s\n", encoding="utf-8")
    paper = read_table(file)
    assert paper.results == [("v_C", 2.4, "m/s")] and not paper.left


def test_a_name_with_another_index_is_not_guessed_at() -> None:
    out = check(
        asked("velocity"), ReadPaper("t", results=[("v_C", 2.4, "m/s"), ("omega_7", 3.0, ""), ("omga_2", 8.1, "")])
    )
    assert out.unknown == {"omega_7": "", "omga_2": "omega_2"}


def test_a_number_of_a_report_has_a_true_minus() -> None:
    out = check(asked("velocity"), ReadPaper("t", results=[("v_C", 2.4, "m/s"), ("omega_2", -3.53, "")]))
    assert result_table_rows(out, "ru")[1][2] == "−3,53" and "−3,53" in out.sentence.told("ru")
