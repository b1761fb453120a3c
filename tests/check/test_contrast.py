"""Ink held against its own line: light and fading strokes, rough paper, what was rubbed out, letters, a grid."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import cast

import pytest

pytest.importorskip("cv2")
import cv2
import numpy as np

from planes.check.vision.image.picture import PX_PER_MM, Flat
from planes.check.vision.strokes.contrast import FeltLines
from planes.check.vision.strokes.drawn_lines import lines_of
from planes.check.vision.strokes.ink import Ink, darkness, ink_of
from planes.check.vision.strokes.line_fitting import Fitted, Tip, _last
from planes.check.vision.strokes.line_places import places_of
from planes.check.vision.strokes.residual_ink import patches
from planes.check.vision.strokes.rubbed_out import remaining
from planes.geometry.arrays import Array, Complexes
from tests.physical.paper import PX_PER_MM as FINE
from tests.physical.paper import Paper
from tests.physical.setting import Setting

GRAPHITE, PRINT = (92, 84, 82), (30, 30, 30)
CORNERS = (20 + 15j, 80 + 20j, 65 + 60j)


def seen(paper: Paper) -> Flat:
    """A sheet as a flat picture."""
    grey = cv2.cvtColor(paper.colour, cv2.COLOR_BGR2GRAY)
    small = cv2.resize(grey, None, fx=PX_PER_MM / FINE, fy=PX_PER_MM / FINE, interpolation=cv2.INTER_AREA)
    return Flat(small, PX_PER_MM, by="points")


def sheet(setting: Setting | None = None) -> Paper:
    return Paper((100.0, 75.0), setting or Setting(), random.Random(1))


def draw(paper: Paper, a: complex, b: complex, press: Sequence[float] = (1.0, 1.0)) -> None:
    paper.lay(np.linspace(a, b, 20).tolist(), list(press), 0.45, GRAPHITE)


def triangle(paper: Paper, press: float) -> None:
    for a, b in zip(CORNERS, (*CORNERS[1:], CORNERS[0]), strict=True):
        draw(paper, a, b, (press, press))


def print_letters(paper: Paper) -> None:
    """Rows of printed letters, 3.5 mm high."""
    for row in (60, 130):
        cv2.putText(paper.colour, "velocities, 1 : 20", (120, row), cv2.FONT_HERSHEY_SIMPLEX, 1.9, PRINT, 3)


def lines_on(paper: Paper) -> list[Fitted]:
    """The lines found, those of letters and heads aside."""
    return [line for line in lines_of(ink_of(seen(paper))) or [] if line.length > 6]


def off_ends(line: Fitted, a: complex, b: complex) -> float:
    """How far the ends of a line are from two places."""
    low, high = line.ends
    return min(max(abs(low - a), abs(high - b)), max(abs(low - b), abs(high - a)))


@pytest.mark.parametrize(("press", "tooth"), [(0.45, 1.0), (0.6, 1.0), (1.0, 1.0), (0.6, 1.4), (1.0, 1.4)])
def test_a_light_pencil_is_seen_whole_beside_dark_print(press: float, tooth: float) -> None:
    """Three lines from corner to corner, whatever the pressure and the paper's grain, and none of the letters."""
    paper = sheet(Setting(tooth=tooth))
    print_letters(paper)
    triangle(paper, press)
    lines = lines_on(paper)
    sides = zip(CORNERS, (*CORNERS[1:], CORNERS[0]), strict=True)
    assert len(lines) == 3 and all(min(off_ends(line, a, b) for line in lines) < 0.8 for a, b in sides)


def test_a_printed_title_does_not_tell_how_dark_lines_usually_are() -> None:
    """Of a light pencil's lines below it, as without it; with it, it would seem twice as dark."""
    usual = []
    for rules in (0, 3):
        paper = sheet()
        triangle(paper, 0.45)
        for k in range(rules):
            paper.lay([5 + (72 - 3 * k) * 1j, 95 + (72 - 3 * k) * 1j], [1.0, 1.0], 0.45, PRINT, 1.0)
        usual.append([FeltLines.of(darkness(seen(paper), []), PX_PER_MM, mm).usual for mm in (0.0, 12.0)])
    (plain, plain_below), (titled, below) = usual
    assert titled > 1.5 * plain and below == pytest.approx(plain_below, rel=0.05)


@pytest.mark.parametrize(("fade_mm", "to"), [(8.0, 0.5), (15.0, 0.35)])
def test_a_fading_stroke_is_followed_to_its_end(fade_mm: float, to: float) -> None:
    paper = sheet()
    triangle(paper, 1.0)
    a, b = 10 + 8j, 90 + 12j
    left = abs(b - a) * np.linspace(1, 0, 40)
    draw(paper, a, b, (1 - (1 - to) * np.clip(1 - left / fade_mm, 0, 1)).tolist())
    assert min(off_ends(line, a, b) for line in lines_on(paper)) < 0.6


def test_a_faint_piece_between_firm_ones_is_of_the_line() -> None:
    paper = sheet()
    triangle(paper, 1.0)
    draw(paper, 10 + 8j, 90 + 12j, (1, 1, 1, 1, 0.4, 0.35, 0.4, 1, 1, 1, 1))
    assert min(off_ends(line, 10 + 8j, 90 + 12j) for line in lines_on(paper)) < 0.6


@pytest.mark.parametrize(("lightest", "last"), [(0.3, 23), (0.1, 9)])
def test_a_line_goes_on_into_its_dark_head_unless_it_is_torn(lightest: float, last: int) -> None:
    """Before a head, dark by several strokes upon each other, a light line's ink seems no ink, but is no paper."""
    core = np.array([1.0] * 10 + [lightest] * 4 + [1.0] * 10 + [0.0] * 10)
    assert _last(core, np.arange(len(core)) < 10, 5, 1) == last


@pytest.mark.parametrize("joined", [True, False])
def test_ends_joined_by_a_short_stroke_are_two_places(joined: bool) -> None:
    """Two lines that would cross half a millimetre beyond their ends are one place, unless a vector leads between."""
    a, b = 20 + 20j, 20.9 + 20j
    strokes = [(21 + 60j, a), (80 + 60j, b), *([(a, b)] if joined else [])]
    lines = [Fitted(z, (w - z) / abs(w - z), (0.0, 0.0, 0.0), 0.0, abs(w - z), 0.05, 0.4) for z, w in strokes[:2]]

    def at(z: Complexes) -> Array:
        local = [((z - c) / (d - c), abs(d - c)) for c, d in strokes]
        return np.max([(abs(k - k.real.clip(0, 1)) * mm < 0.25).astype(float) for k, mm in local], axis=0)

    ended = [p.z for p in places_of(lines, cast(Ink, SimpleNamespace(at=at))) if p.ended and not p.doubtful]
    assert all((min(abs(z - end) for z in ended) < 0.2) is joined for end in (a, b))


@pytest.mark.parametrize("end", [90 + 70j, 20 + 70j, 30 + 66j])
def test_what_was_rubbed_out_is_no_line(end: complex) -> None:
    """A ghost from a corner of the drawing, a fifth as dark."""
    paper = sheet()
    triangle(paper, 1.0)
    before = paper.colour.astype(float)
    draw(paper, CORNERS[2], end, (0.9, 0.9))
    paper.colour = (0.8 * before + 0.2 * paper.colour).astype(np.uint8)
    assert len(lines_on(paper)) == 3


def ghost(paper: Paper, a: complex, b: complex, left: float) -> None:
    """A line rubbed out, a share of its darkness left."""
    before = paper.colour.astype(float)
    draw(paper, a, b)
    paper.colour = ((1 - left) * before + left * paper.colour).astype(np.uint8)


@pytest.mark.parametrize("end", [CORNERS[1] + 0.5 * (CORNERS[1] - CORNERS[0]), 92 + 66j, 88 + 36j])
def test_a_ghost_is_told_from_the_line_it_goes_on_from(end: complex) -> None:
    """A third as dark, a ghost ends where the drawing does, in line with a side of it or not; its rest is no line."""
    paper = sheet()
    triangle(paper, 1.0)
    ghost(paper, CORNERS[1], end, 0.36)
    flat = seen(paper)
    lines = [line for line in remaining(flat, lines_of(ink_of(flat)) or []) if line.length > 6]
    assert len(lines) == 3 and all(abs(z - end) > 9 for line in lines for z in line.ends)


def test_a_long_light_construction_line_leaves_the_vector_on_it() -> None:
    paper = sheet()
    triangle(paper, 1.0)
    a, b = CORNERS[0], CORNERS[0] + 20j
    draw(paper, a, a + 45j, (0.5, 0.5))
    draw(paper, a, b)
    flat = seen(paper)
    lines = remaining(flat, lines_of(ink_of(flat)) or [])
    assert any(off_ends(line, a, b) < 27 and line.length > 18 and abs(line.along.real) < 0.1 for line in lines)


def test_what_is_no_ghost_is_left_as_it_was() -> None:
    """With its head, the tip of which may stand a little beyond its line's end."""
    paper = sheet()
    triangle(paper, 1.0)
    lines = lines_of(ink_of(seen(paper))) or []
    for line in lines:
        line.heads = [Tip(line.high + 0.3, 1, line.at(line.high + 0.3), 0.1, 3.0)]
    assert remaining(seen(paper), lines) == lines


@pytest.mark.parametrize(("word", "gap"), [("F_30", 44), ("F_30", 30), ("g30", 30), ("GS8", 34)])
def test_letters_that_touch_are_not_ink_of_the_plan(word: str, gap: int) -> None:
    """Each letter is close upon the one before, so that together they are as large as a line."""
    paper = sheet()
    triangle(paper, 1.0)
    for k, letter in enumerate(word):
        cv2.putText(paper.colour, letter, (130 + k * gap, 200), cv2.FONT_HERSHEY_SIMPLEX, 2.2, GRAPHITE, 9)
    ink = ink_of(seen(paper))
    assert not patches(ink, lines_of(ink) or [])


def smear(paper: Paper) -> None:
    """A broad soft stain."""
    dark = np.zeros(paper.colour.shape[:2], np.float32)
    cv2.ellipse(dark, (600, 500), (260, 60), 20, 0, 360, 0.12, -1)
    paper.colour = (paper.colour * (1 - cv2.GaussianBlur(dark, (0, 0), 25))[..., None]).astype(np.uint8)


@pytest.mark.parametrize("spoil", [print_letters, smear])
def test_letters_and_smears_are_not_followed(spoil: Callable[[Paper], None]) -> None:
    paper = sheet()
    draw(paper, 15 + 10j, 85 + 14j, (0.5, 0.5))
    spoil(paper)
    assert len(lines_on(paper)) == 1


@pytest.mark.parametrize("kind", ["squared", "ruled"])
def test_a_grid_is_no_drawing_though_a_line_runs_along_it(kind: str) -> None:
    paper = sheet(Setting(grid=kind))
    y = next(k for k in range(200, 700) if (paper.colour[k, 300:900].mean() < 228))
    a, b = (complex(x, 75 - y / FINE) for x in (25, 75))
    draw(paper, a, b)
    draw(paper, a, 60 + 12j)
    lines = lines_on(paper)
    assert len(lines) == 2 and min(off_ends(line, a, b) for line in lines) < 1.0
