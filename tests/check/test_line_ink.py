"""What a file's lines tell when they are asked as a sheet's ink is."""

from __future__ import annotations

import random

import numpy
import pytest

from planes.check.evidence import line_ink
from planes.check.evidence.line_ink import LineInk
from planes.check.explaining import scorer
from planes.check.explaining.hypotheses import transformed_plan_hypotheses, trial_displacements
from planes.check.explaining.plan_lines import Hypothesis, PlanLines
from planes.check.outcome import check
from planes.check.reading.hatching import without_hatching
from planes.check.reading.matching import read_plan_marks
from planes.check.reading.strokes import ReadDrawing
from planes.check.reading.written import Stroke, Words
from planes.words.naming import Naming
from tests import confusion


def ink_of(strokes: list[Stroke], ways: list[int] | None = None) -> LineInk:
    return LineInk(ReadDrawing(strokes=strokes, ways=ways or []), Naming().name_finder([]))


@pytest.mark.parametrize("about", [0, 1, 2])
def test_the_share_of_a_line_that_is_drawn_is_that_of_its_places_with_a_line_by_them(about: int) -> None:
    """Place by place, each asked of every line."""
    rng = random.Random(about)
    ends = [complex(rng.uniform(0, 30), rng.uniform(0, 30)) for _ in range(24)]
    strokes: list[Stroke] = list(zip(ends[::2], ends[1::2], strict=True))
    a = numpy.array([s + complex(rng.gauss(0, 0.3), rng.gauss(0, 0.3)) for s, _ in strokes])
    b = numpy.array([e + complex(rng.gauss(0, 0.3), rng.gauss(0, 0.3)) for _, e in strokes])
    found, aside = ink_of(strokes).drawn_shares(a, b, 56, about), line_ink.LINE_OFFSETS_MM[about]
    for start, end, share in zip(a.tolist(), b.tolist(), found.tolist(), strict=True):
        felt = 0.0
        for t in (numpy.arange(4000) + 0.5) / 4000:
            most = 0.0
            for p, q in strokes:
                turned = abs(((end - start).conjugate() * (q - p)).real) / abs(end - start) / abs(q - p)
                z = (start + t * (end - start) - p) / ((q - p) / abs(q - p))
                if abs(z.imag) < aside and -aside < z.real < abs(q - p) + aside:
                    most = max([most, *(worth for least, worth in line_ink.TURNED_LINE_RESPONSES if turned > least)])
            felt += most / 4000
        assert share == pytest.approx(felt, abs=0.02)  # how far aside is asked across the other line


def test_a_drawing_as_large_as_a_town_is_asked_as_any_other() -> None:
    strokes: list[Stroke] = [(0j, 3e6 + 1e6j), (0j, 20 + 0j)]
    ink = ink_of(strokes, [1, 1])
    shares = ink.drawn_shares(numpy.array([0j, 0j]), numpy.array([20 + 0j, 20j]), 56)
    assert shares[0] == pytest.approx(1.0) and shares[1] < 0.05 and len(ink.points) < 2 * line_ink.MOST_PIECES


def test_a_plan_larger_than_any_sheet_is_weighed_by_no_more_hypotheses() -> None:
    bench = confusion.bench("six-link", "acceleration")
    larger = [PlanLines(bench.at_scale(bench.said_mu * times, fixed=False), to_fit=False) for times in (10, 1000)]
    few, many = (
        len(transformed_plan_hypotheses(plan)) + len(trial_displacements(plan, Hypothesis())) for plan in larger
    )
    assert many <= 1.05 * few


@pytest.mark.parametrize(("plan", "most"), [("velocity", 1), ("acceleration", 1)])
def test_a_right_drawing_is_laid_on_its_lines_once(plan: str, most: int, monkeypatch: pytest.MonkeyPatch) -> None:
    """It leaves nothing to be explained: no other is settled."""
    bench, laid = confusion.bench("six-link", plan), list[str]()
    places, pole = {"p": 0j, **bench.true_marks}, 100 + 100j
    strokes = [(pole + places[a], pole + places[b]) for a, b in bench.vector_names if abs(places[a] - places[b]) > 1]
    words = [Words(n, pole + z + 1 + 1j) for n, z in places.items()]
    settled = scorer.Scorer.settle_hypothesis
    monkeypatch.setattr(scorer.Scorer, "settle_hypothesis", lambda s, h: laid.append(h.kind) or settled(s, h))  # type: ignore[func-returns-value]
    found = check(
        bench.asked, read_plan_marks(ReadDrawing(strokes=strokes, words=words, ways=[1] * len(strokes)), bench)
    )
    assert found.verdict == "right" and laid == ["right"] * most


def test_a_row_of_hatching_that_ends_by_something_by_chance_is_hatching_still() -> None:
    rows: list[Stroke] = [(4.0 * k + 0j, 4.0 * k + 20 + 20j) for k in range(9)]
    corner = rows[2][1] + 0.2
    sketch = ReadDrawing(strokes=[*rows, (corner, corner + 30), (corner, corner - 40 + 3j)])
    assert without_hatching(sketch).strokes == sketch.strokes[9:]


def test_a_scribble_in_which_anything_would_match_is_refused() -> None:
    rng, bench = random.Random(1), confusion.bench("six-link", "velocity")
    ends = [complex(rng.uniform(0, 150), rng.uniform(0, 150)) for _ in range(1000)]
    words = [Words(n, z) for n, z in zip(("p", *bench.true_marks), ends, strict=False)]
    strokes: list[Stroke] = list(zip(ends[::2], ends[1::2], strict=True))
    paper = read_plan_marks(ReadDrawing(strokes=strokes, words=words, ways=[1] * 500), bench)
    assert not paper.spots and paper.reason is not None and "too many lines" in paper.reason.told("en")


def test_a_plan_of_other_numbers_is_read_by_its_names() -> None:
    bench, pole, rng = confusion.bench("six-link", "velocity"), 100 + 100j, random.Random(4)
    places = {n: z * complex(rng.uniform(-2, 2), rng.uniform(-2, 2)) for n, z in bench.true_marks.items()} | {"p": 0j}
    strokes = [(pole + places[a], pole + places[b]) for a, b in bench.vector_names]
    words = [Words(n, pole + z + 0.5 + 0.5j) for n, z in places.items()]
    found = check(
        bench.asked, read_plan_marks(ReadDrawing(strokes=strokes, words=words, ways=[1] * len(strokes)), bench)
    )
    assert "another drawing" in found.sentence.told("en") and "of this variant" in found.sentence.told("en")
