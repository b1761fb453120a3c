"""Letters exchanged, an arrow drawn the wrong way or without a head: faults of drawings whose lines are right."""

import random
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from planes.check.explaining import weights
from planes.check.explaining.plan_lines import PlanLines
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.handed_in import read_paper
from planes.check.outcome import Outcome, check
from planes.check.report import mark_rows
from render.files import Page
from render.paper.marks import Arrow, Line, Text
from tests.check.test_own_sheets import drawn, view
from tests.helpers import line_drawings

SAMPLE, LETTERS = "six-link", ("b", "c")
FAULTS = (("names_exchanged", set(LETTERS)), ("arrow_reversed", {"b"}), ("arrow_missing", {"b"}), (None, set()))
Pairs = list[tuple[complex, complex]]


def checked(file: Path) -> Outcome:
    asked = Asked(drawn(SAMPLE)[0], "velocity")
    return check(asked, read_paper(str(file), asked, Known()))


def told(found: Outcome, mistake: str | None, marks: set[str]) -> None:
    """One of the marks is blamed for that mistake; a drawing without one is right."""
    assert found.mistake == mistake, found.sentence.told("en")
    assert found.verdict == ("wrong" if mistake else "right"), found.sentence.told("en")
    assert (found.first_wrong in marks) if marks else found.first_wrong is None


def own_page(mistake: str | None) -> Page:
    """The velocity plan as the project draws it, with a sign spoiled."""
    page = view(SAMPLE, "velocity", drawn(SAMPLE)[1])
    places = {n: complex(z) for n, z in prepare(Asked(drawn(SAMPLE)[0], "velocity")).true_marks.items()}
    arrows = [m for m in page.marks if isinstance(m, Arrow)]
    whole = next(m for m in arrows if abs((m.end - m.start) - places["b"]) < 0.5)
    marks = []
    for mark in page.marks:
        if isinstance(mark, Text) and mistake == "names_exchanged" and mark.text in LETTERS:
            mark = replace(mark, text=LETTERS[1 - LETTERS.index(mark.text)])
        elif mark == whole and mistake == "arrow_reversed":
            mark = replace(whole, start=whole.end, end=whole.start)
        elif mark == whole and mistake == "arrow_missing":
            mark = Line((whole.start, whole.end), "thick", "plan")
        marks.append(mark)
    return replace(page, marks=tuple(marks))


@pytest.mark.parametrize("suffix", [".svg", ".dxf", ".pdf", ".png"])
@pytest.mark.parametrize(("mistake", "marks"), FAULTS)
def test_signs_of_the_projects_own_drawings(mistake: str | None, marks: set[str], suffix: str, tmp_path: Path) -> None:
    file = tmp_path / f"plan{suffix}"
    file.write_bytes(own_page(mistake).file_contents(suffix))
    told(checked(file), mistake, marks)


def changed(mark: Arrow, way: str) -> list[Arrow]:
    """A vector drawn otherwise than from its mark to its mark."""
    v, u = mark.end - mark.start, (mark.end - mark.start) / abs(mark.end - mark.start)
    off = min(10.0, abs(v) / 2) * u
    ways = {"short": mark.end - off, "long": mark.end + off, "aside": mark.end + 0.8j * off}
    if way in ways:
        return [replace(mark, end=ways[way])]
    return [replace(mark, start=mark.start + off)] if way == "late" else []


@pytest.mark.few(2, slow=6)
@pytest.mark.parametrize("way", ["missing", "short", "long", "aside", "late"])
@pytest.mark.parametrize(("plan", "suffix"), [("velocity", ".svg"), ("acceleration", ".dxf"), ("velocity", ".pdf")])
def test_a_vector_that_misses_its_marks_or_is_not_drawn(plan: str, way: str, suffix: str, tmp_path: Path) -> None:
    """Others meet at its marks, so that these are right: it is never right all the same, and is told of by name."""
    scene, position = drawn(SAMPLE)
    page, asked, file = view(SAMPLE, plan, position), Asked(scene, plan), tmp_path / f"plan{suffix}"
    arrows = [m for m in page.marks if isinstance(m, Arrow) and abs(m.end - m.start) > 8]
    assert len(arrows) > 6
    for one in arrows:
        marks = [x for m in page.marks for x in (changed(one, way) if m == one else [m])]
        file.write_bytes(replace(page, marks=tuple(marks)).file_contents(suffix))
        found = check(asked, read_paper(str(file), asked, Known()))
        assert found.verdict in (("right_as_seen",) if way == "missing" else ("wrong", "right_as_seen")), one
        assert found.verdict == "right_as_seen" or found.first_wrong
        if found.paper.left:  # and it is said why
            assert any(note.key == "check_no_vector" for note in found.notes)
        if found.mistake == "vector_astray":  # the row shows the miss it is wrong by
            row = next(row for row in mark_rows(found) if row["mark"] == found.first_wrong)
            assert row["own_deviation_mm"] > 1 and row["own_tolerance_mm"] is None


@pytest.mark.few(1)
@pytest.mark.parametrize("sample", ["six-link", "kind-1-rrr", "bntu-1"])
@pytest.mark.parametrize("suffix", [".svg", ".dxf", ".pdf", ".png"])
def test_a_force_turned_round_without_a_head_or_not_drawn(sample: str, suffix: str, tmp_path: Path) -> None:
    """No side of a polygon may be so, whichever it is, and all the rest be right for sure; a sum need not be there."""
    scene, position = drawn(sample)
    page, asked, file = view(sample, "force:2-3", position), Asked(scene, "force:2-3"), tmp_path / f"plan{suffix}"
    bench = prepare(asked)
    places = {"p": 0j, **bench.true_marks}
    sides = {s.name: places[s.end] - places[s.start] for s in PlanLines(bench).sides}
    arrows = [m for m in page.marks if isinstance(m, Arrow) and abs(m.end - m.start) > 8]
    named: set[str | None] = set()
    for name, one in ((n, m) for n, v in sides.items() for m in arrows if abs(m.end - m.start - v) < 0.01):
        if sum(abs(m.end - m.start - one.end + one.start) < 0.01 for m in arrows) > 1:
            continue  # another arrow is the same
        turned, bare = replace(one, start=one.end, end=one.start), Line((one.start, one.end), "thick", "plan")
        for way, drawn_as in {"turned": [turned], "bare": [bare], "missing": []}.items():
            marks = [x for m in page.marks for x in (drawn_as if m is one else [m])]
            file.write_bytes(replace(page, marks=tuple(marks)).file_contents(suffix))
            found = check(asked, read_paper(str(file), asked, Known()))
            assert found.verdict != "right" and (found.first_wrong or name in found.unseen), (name, way)
            named.add(found.mistake)
    assert named >= {"arrow_missing"}


@pytest.mark.parametrize(("one", "two"), [("F_{21}^{t}", "F_{24}"), ("F_{21}^{t}", "Φ_{2}")])
def test_names_of_forces_are_exchanged(one: str, two: str, tmp_path: Path) -> None:
    page, asked = view(SAMPLE, "force:2-3", drawn(SAMPLE)[1]), Asked(drawn(SAMPLE)[0], "force:2-3")
    other, file = {one: two, two: one}, tmp_path / "plan.svg"
    marks = [replace(m, text=other.get(m.text, m.text)) if isinstance(m, Text) else m for m in page.marks]
    file.write_bytes(replace(page, marks=tuple(marks)).file_contents(".svg"))
    assert check(asked, read_paper(str(file), asked, Known())).mistake == "names_exchanged"


@pytest.mark.slow
@pytest.mark.parametrize("way", ["missing", "short"])
def test_a_vector_that_is_not_drawn_on_a_picture(way: str, tmp_path: Path) -> None:
    from tests import picture_corpus as corpus
    from tests.confusion import easel
    from tests.helpers.photographs import SCAN

    one, file = easel(SAMPLE, "velocity"), tmp_path / "p.jpg"
    whole = corpus.drawn(one, None, random.Random(1))
    assert whole is not None
    for k, (a, b) in enumerate(whole.strokes):
        rest = [(a, b - 10 * (b - a) / abs(b - a))] if way == "short" else []
        strokes = [*whole.strokes[:k], *rest, *whole.strokes[k + 1 :]]
        spoiled = replace(whole, strokes=strokes)
        corpus.picture(spoiled, corpus.pole_of(one), SCAN, random.Random(1), file)
        assert corpus.looked_at(one, file)[0].verdict in ("right_as_seen", "unreadable")


def strokes_of(mistake: str | None, truth: Mapping[str, complex]) -> Pairs:
    """The vectors of the plan as another program draws them, one the wrong way."""
    bench = prepare(Asked(drawn(SAMPLE)[0], "velocity"))
    places = {"p": 0j, **truth}
    ends = [(a, b) for a, b in bench.vector_names if abs(places[b] - places[a]) > 1]
    turned = [(b, a) if mistake == "arrow_reversed" and (a, b) == ("p", "b") else (a, b) for a, b in ends]
    return [(places[a], places[b]) for a, b in turned]


@pytest.mark.parametrize("write", [line_drawings.inkscape, line_drawings.illustrator, line_drawings.dxf])
@pytest.mark.parametrize(("mistake", "marks"), [FAULTS[0], FAULTS[1], FAULTS[3]])
def test_signs_of_other_programs_drawings(
    mistake: str | None, marks: set[str], write: Callable[..., str], tmp_path: Path
) -> None:

    truth = prepare(Asked(drawn(SAMPLE)[0], "velocity")).true_marks
    words = line_drawings.labels({"p": 0j, **truth}, random.Random(1))
    if mistake == "names_exchanged":
        words = [(LETTERS[1 - LETTERS.index(t)] if t in LETTERS else t, z) for t, z in words]
    file = tmp_path / ("plan.dxf" if write is line_drawings.dxf else "plan.svg")
    file.write_text(write(strokes_of(mistake, truth), words, 200 + 150j), encoding="utf-8")
    told(checked(file), mistake, marks)


@pytest.mark.slow
@pytest.mark.parametrize("camera", ["SCAN", "PHONE"])
@pytest.mark.parametrize(("mistake", "marks"), [FAULTS[0], FAULTS[1], FAULTS[3]])
def test_signs_on_pictures(mistake: str | None, marks: set[str], camera: str, tmp_path: Path) -> None:
    pytest.importorskip("cv2")
    from tests import picture_corpus as corpus
    from tests.confusion import easel
    from tests.helpers import photographs

    one, file = easel(SAMPLE, "velocity"), tmp_path / "p.jpg"
    paper = corpus.drawn(one, None, random.Random(1))
    assert paper
    if mistake == "names_exchanged":
        words = [(LETTERS[1 - LETTERS.index(t)] if t in LETTERS else t, z) for t, z in paper.words]
        paper = replace(paper, words=words)
    elif mistake == "arrow_reversed":
        turned = [s[::-1] if s == (0j, paper.marks["b"]) else s for s in paper.strokes]
        assert turned != paper.strokes
        paper = replace(paper, strokes=turned)
    corpus.picture(paper, corpus.pole_of(one), getattr(photographs, camera), random.Random(1), file)
    told(corpus.looked_at(one, file)[0], mistake, marks)


@pytest.mark.slow
@pytest.mark.parametrize(("sample", "plan", "k"), [("bntu-1", "force:2-3", 0), ("bntu-2", "force:2-3", 0)])
@pytest.mark.parametrize("camera", ["SCAN", "PHONE"])
def test_a_force_turned_round_on_a_picture_is_not_right(
    sample: str, plan: str, k: int, camera: str, tmp_path: Path
) -> None:
    """Paper beside its end where no other ink may be, and a head at its start, or none: never right for sure."""
    pytest.importorskip("cv2")
    from tests import picture_corpus as corpus
    from tests.confusion import easel
    from tests.helpers import photographs

    one, file = easel(sample, plan), tmp_path / "p.jpg"
    paper = corpus.drawn(one, None, random.Random(1))
    assert paper
    turned = [*paper.strokes[:k], paper.strokes[k][::-1], *paper.strokes[k + 1 :]]
    for strokes, sure in ((paper.strokes, True), (turned, False)):
        drawing = replace(paper, strokes=strokes)
        corpus.picture(drawing, corpus.pole_of(one), getattr(photographs, camera), random.Random(1), file)
        found = corpus.looked_at(one, file)[0]
        assert (found.verdict == "right") is sure, found.unseen
        assert found.verdict != "wrong" or (found.mistake, found.chance) == (
            "arrow_reversed",
            weights.REVERSED_VECTOR_CHANCE,
        )
