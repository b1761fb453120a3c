"""Force polygons on pictures: what their ink does not tell is not said; what is printed at the pole is none of it."""

from __future__ import annotations

import random
from itertools import pairwise
from pathlib import Path

import pytest

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402

from planes.check.grading.handwork import Miss  # noqa: E402
from planes.check.grading.prepared_plan import PreparedPlan  # noqa: E402
from planes.check.vision.image.picture import PX_PER_MM, Flat  # noqa: E402
from planes.check.vision.marks.places import Seen, sheet_of  # noqa: E402
from planes.check.vision.match.match_force import start_of, vectors_on  # noqa: E402
from planes.check.vision.search.ink_cover import InkCover  # noqa: E402
from planes.check.vision.search.polygon_cover import LaidChain, PolygonCorner  # noqa: E402
from planes.check.vision.search.polygon_search import SoughtPolygon  # noqa: E402
from planes.check.vision.strokes.heads import one_ink  # noqa: E402
from planes.check.vision.strokes.line_fitting import Tip  # noqa: E402
from planes.check.vision.strokes.line_places import Place  # noqa: E402
from planes.check.vision.strokes.lone_heads import LoneHeads  # noqa: E402
from tests import confusion  # noqa: E402
from tests import picture_corpus as corpus  # noqa: E402
from tests.confusion import easel, possible  # noqa: E402
from tests.helpers.drawings import Mistake  # noqa: E402
from tests.helpers.photographs import SCAN  # noqa: E402

PAPER, PENCIL = 245, 70
HEAD_MM = 3.5


def sheet(strokes: list[tuple[complex, complex]], heads: list[tuple[complex, complex]], by: str = "points") -> Flat:
    """A flat picture of strokes, and of filled heads at the ends of ways."""
    grey = np.full((800, 1200), PAPER, np.uint8)

    def px(z: complex) -> tuple[int, int]:
        return round(z.real * PX_PER_MM * 16), round((800 - z.imag * PX_PER_MM) * 16)

    for a, b in strokes:
        cv2.line(grey, px(a), px(b), PENCIL, round(0.45 * PX_PER_MM), cv2.LINE_AA, 4)
    for a, b in heads:
        back = HEAD_MM * (b - a) / abs(b - a)
        corners = [b, b - back + 0.25j * back, b - back - 0.25j * back]
        cv2.fillPoly(grey, [np.array([px(z) for z in corners], np.int32)], PENCIL, cv2.LINE_AA, 4)
    return Flat(cv2.GaussianBlur(grey, (0, 0), 0.8), PX_PER_MM, by=by)


def test_a_vector_a_degree_from_a_shorter_one_shows_its_head() -> None:
    """Their lines run together and are taken for one, which ends where the shorter does."""
    pole = 20 + 20j
    short, long = pole + 50 * np.exp(0.7j), pole + 56 * np.exp(0.688j)
    vectors = [(pole, complex(short)), (pole, complex(long)), (pole, 90 + 25j), (90 + 25j, complex(short))]
    seen = sheet_of(sheet(vectors, vectors))
    assert seen is not None
    found = min((abs(p.z - long) for p in [*seen.places, seen.closer(pole, complex(long))] if p), default=99.0)
    assert found < 0.6


def test_a_head_is_told_from_the_shaft_behind_it() -> None:
    """A piece of ink left over: a short shaft with a head; turned about it points nowhere."""
    flat = sheet([(20 + 20j, 22 + 20j)], [(20 + 20j, 25.5 + 20j)])
    seen = sheet_of(flat)
    assert seen is not None
    down, across = np.nonzero(flat.grey < (PAPER + PENCIL) / 2)
    piece = flat.mm(0, 0) + (across - 1j * down) / flat.scale
    heads = LoneHeads(seen.all_ink, HEAD_MM, [piece])
    heads.pieces.clear()
    heads.ink.even[:] = 0  # a line leads to it from anywhere
    tips = heads.tip(5 + 20j, 25 + 20j), heads.tip(40 + 20j, 20 + 20j)
    assert tips[0] is not None and abs(tips[0] - (25.5 + 20j)) < 0.4
    assert tips[1] is None


@pytest.mark.parametrize(("other", "one"), [(Tip(7.2, -1, 0j, 0.1, 3.0), True), (Tip(5.0, -1, 0j, 0.1, 3.0), False)])
def test_heads_that_point_at_each_other_s_bases_are_of_one_ink(other: Tip, one: bool) -> None:
    """Two that stand back to back are two."""
    assert one_ink(Tip(10.0, 1, 0j, 0.1, 3.0), other) is one


@pytest.mark.few(1)
@pytest.mark.parametrize("apart", [0.0, 0.6, -0.2, 0.3, 1.0, 2.0])
def test_heads_back_to_back_on_one_line_are_seen(apart: float) -> None:
    """So far apart are their bases: nothing of the line, or hardly anything, is between them."""
    a, b, up = 20 + 50j, 120 + 50j, 40j
    left, right = 70 - apart / 2 - HEAD_MM + 50j, 70 + apart / 2 + HEAD_MM + 50j
    others = [(a, a + up), (b, b + up), (60 + 20j, 100 + 30j)]
    seen = sheet_of(sheet([(a, b), *others], [*others, (b, left), (a, right)]))
    assert seen is not None
    line = max((x for x in seen.lines if abs(x.along.imag) < 0.1), key=lambda x: x.length)
    ways = {round(h.sign * line.along.real): h.z for h in line.heads}
    assert abs(ways[-1] - left) < 1.1 and abs(ways[1] - right) < 1.1


@pytest.mark.parametrize(("sigma", "unseen"), [(0.3, False), (3.0, True)])
def test_a_vector_whose_length_is_hardly_known_may_end_unseen_beside_a_place(sigma: float, unseen: bool) -> None:
    """A line begins two millimetres from where the vector should end, upon another's line."""
    pole, v = 20 + 50j, 40 + 0j
    seen = sheet_of(sheet([(pole, pole + 90), (pole + v + 0.4, pole + v + 30j)], []))
    assert seen is not None
    sought = SoughtPolygon(InkCover(seen, pole, [v]), Place(pole, 0.1, frozenset()), {"I": Miss(0j, (sigma**2, 0, 1))})
    ends = sought._ends_near("I", v, PolygonCorner(pole))
    assert any(hidden for *_, hidden in ends) is unseen and not all(hidden for *_, hidden in ends)


@pytest.mark.parametrize(("by", "priced"), [("marks", False), ("points", True)])
def test_the_letter_printed_at_a_blank_s_pole_is_not_the_drawing_s(by: str, priced: bool) -> None:
    """Its stem hangs together with a vector; on other paper it may be one."""
    pole = 60 + 50j
    seen = sheet_of(sheet([(pole, pole + 40), (pole + 0.1j, pole - 4.5 - 8j)], [], "points"))
    assert seen is not None
    seen.ink.flat.by = by
    cover = InkCover(seen, pole, [40 + 0j])
    left = cover.price([(pole, pole + 40)])
    assert (left > 1.5) == priced


@pytest.mark.parametrize(("by", "on"), [("marks", False), ("points", True)])
def test_a_line_that_ends_on_the_printed_letter_is_not_said_to_go_on(by: str, on: bool) -> None:
    """A closing vector's construction line runs past the pole into the letter there; on other paper it is longer."""
    pole, way = 60 + 50j, complex(np.exp(0.82j))
    start = pole + 40 * way
    seen = sheet_of(sheet([(start, pole - 7.5 * way)], []))
    assert seen is not None
    seen.ink.flat.by = by
    sought = SoughtPolygon(InkCover(seen, pole, [40 * way]), Place(pole, 0.1, frozenset()), {})
    assert sought._goes_on(start, LaidChain(0.0, [("F", start, 0.1)])) is on


def test_a_place_misread_tells_but_once_against_the_vectors_that_meet_there() -> None:
    """Read a millimetre too far, half a millimetre surely, where a hand errs by a quarter: the next vector should end a
    fifth of a millimetre from where it would if nothing was misread, not a whole one."""
    start, v, misread = PolygonCorner(10 + 0j), 7 + 0j, 18 + 0j
    corner = start.after(start.z + v, (2.0, misread, 0.5, False), 0.25)
    assert corner.z + corner.off == pytest.approx(17.2) and corner.loose == 0.2
    sure = start.after(start.z + v, (2.0, misread, 0.01, False), 0.25)
    assert abs(sure.off) < 0.01 and sure.loose < 0.02
    nothing = corner.after(corner.z + corner.off, (0.0, misread, 0.3, True), 0.25)
    assert nothing.z + nothing.off == pytest.approx(17.2)


def test_heads_upon_each_other_that_are_not_seen_cost_once() -> None:
    """Two vectors come to one place the same way, a third from the other side; no head is there."""
    a, b = 30 + 50j, 80 + 50j
    seen = sheet_of(sheet([(a, b), (b, 110 + 50j), (a, a + 30j)], [(a, a + 30j)]))
    assert seen is not None
    ink = InkCover(seen, a, [50 + 0j])
    sought, chain = SoughtPolygon(ink, Place(a, 0.1, frozenset()), {}), LaidChain(0.0, [("F", b, 0.1), ("G", a, 0.1)])
    bare, other = ink.bare(a, b), ink.bare(110 + 50j, b)
    assert ink.headed and bare > 2 and other > 2
    assert sought._longer(chain, a, 0.0, ("H", b, 0.1)).cost == pytest.approx(0.0)
    assert sought._longer(chain, 110 + 50j, 0.0, ("H", b, 0.1)).cost == pytest.approx(other)


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 4])
def test_what_letters_alone_tell_of_forces_in_one_line_is_not_said(seed: int, tmp_path: Path) -> None:
    """All forces of slider 5 are vertical: its mass drawn for its weight leaves the ink of a right polygon in another
    order."""
    one, rng, file = easel("assignment-12", "force:4-5"), random.Random(seed), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, Mistake("mass_for_weight", "G_5", 1), rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), SCAN, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict != "right"
    assert found.verdict != "right_as_seen" or "G_5" in found.unseen


@pytest.mark.slow
def test_a_long_force_among_others_of_one_line_whose_end_nothing_shows_is_told(tmp_path: Path) -> None:
    """A force of inertia drawn twice as long: its head and the next one's, back to back, are none that is seen."""
    one, rng, file = easel("assignment-12", "force:4-5"), random.Random("1009 11"), tmp_path / "p.jpg"
    alike = ("mass_for_weight", "weight_missing", "force_missing", "force_doubled")
    mistake = rng.choice([m for m in possible(one) if m.name.partition(":")[0] in alike])
    drawn = corpus.drawn(one, mistake, rng)
    assert drawn is not None and (mistake.name, mistake.where) == ("force_doubled", "I_5")
    corpus.picture(drawn, corpus.pole_of(one), corpus.KINDS[rng.choice(list(corpus.KINDS))](rng), rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict != "right" and "I_5" in found.unseen


@pytest.mark.slow
@pytest.mark.parametrize("seed", [4, 5])
def test_a_mistake_of_half_a_millimetre_leaves_nothing_in_doubt(seed: int, tmp_path: Path) -> None:
    """The weight of a light crank, doubled: no paper shows that."""
    one, rng, file = easel("assignment-12", "force:1"), random.Random(seed), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, None, rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), SCAN, rng, file)
    assert corpus.looked_at(one, file)[0].verdict == "right"


@pytest.mark.slow
@pytest.mark.parametrize("seed", [3, 4])
def test_what_ink_shows_of_a_mistake_within_a_hand_s_error_is_not_called_right(seed: int, tmp_path: Path) -> None:
    """A force of inertia of two millimetres drawn twice as long; its end is where the next vector begins."""
    one, rng, file = easel("sliding-driver", "force:2-3"), random.Random(seed), tmp_path / "p.jpg"
    drawn = corpus.drawn(one, Mistake("force_doubled", "I_3", 0), rng)
    assert drawn is not None
    corpus.picture(drawn, corpus.pole_of(one), SCAN, rng, file)
    found = corpus.looked_at(one, file)[0]
    assert found.verdict != "right" and "I_3" in (*found.unseen, found.first_wrong)


POLE = 100 + 75j


def polygon(gap: complex = 0j) -> tuple[PreparedPlan, Seen]:
    """A plan of forces, and what is seen of its polygon; of its longest vector nothing is drawn about a place."""
    bench = confusion.bench("six-link", "force:2-3")
    corners = [POLE, *(POLE + z for z in bench.true_marks.values()), POLE]
    strokes = list(pairwise(corners))
    flat = sheet(strokes, [(a, b) for a, b in strokes if abs(b - a) > HEAD_MM])
    if gap:
        cv2.circle(flat.grey, [round(x) for x in flat.px(POLE + gap)], round(10 * PX_PER_MM), PAPER, -1)
    seen = sheet_of(flat)
    assert seen is not None
    return bench, seen


@pytest.mark.slow
def test_a_polygon_begins_where_it_can_be_laid_from() -> None:
    """Nobody told the pole, which is one of its corners."""
    start = start_of(*polygon())
    assert start is not None and abs(start - POLE) < 0.5


@pytest.mark.slow
def test_a_vector_that_is_but_partly_drawn_is_one() -> None:
    """A third of it is not there; the other vectors leave no doubt."""
    bench, seen = polygon(gap=-31.3 - 36.5j)
    read = vectors_on(bench, seen, POLE)
    assert abs(next(s.place for s in read.spots if s.name == "F_24") - POLE - bench.true_marks["F_24"]) < 0.5
