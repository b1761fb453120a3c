"""Letters exchanged, an arrow drawn the wrong way or without a head: faults of drawings whose lines are right."""

import random
from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path

import pytest

from planes.check import Outcome, check
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked, prepare
from planes.check.handed_in import read_paper
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
    file.write_bytes(own_page(mistake).rendered(suffix))
    told(checked(file), mistake, marks)


def strokes_of(mistake: str | None, truth: Mapping[str, complex]) -> Pairs:
    """The vectors of the plan as another program draws them, one the wrong way."""
    bench = prepare(Asked(drawn(SAMPLE)[0], "velocity"))
    places = {"p": 0j, **truth}
    ends = [(a, b) for a, b in bench.vectors if abs(places[b] - places[a]) > 1]
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
