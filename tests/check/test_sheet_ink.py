"""What a sheet's ink tells of lines: light and dark pencils, print and grids beside them, heads, what is left."""

from __future__ import annotations

import random
from collections.abc import Callable, Sequence

import pytest

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402

from planes.check.evidence.sheet_ink import Box, SheetInk  # noqa: E402
from planes.check.vision.image.bend import PX_PER_MM  # noqa: E402
from planes.check.vision.image.picture import Flat  # noqa: E402
from tests.helpers.line_ink import drawn  # noqa: E402
from tests.physical.paper import PX_PER_MM as FINE  # noqa: E402
from tests.physical.paper import Paper  # noqa: E402
from tests.physical.setting import Setting  # noqa: E402

GRAPHITE, PRINT = (92, 84, 82), (30, 30, 30)
CORNERS = (20 + 15j, 80 + 20j, 65 + 60j)
SIDES = tuple(zip(CORNERS, (*CORNERS[1:], CORNERS[0]), strict=True))
ALL = Box(5 + 5j, 95 + 70j)


def felt(paper: Paper) -> SheetInk:
    """A sheet's ink."""
    grey = cv2.cvtColor(paper.colour, cv2.COLOR_BGR2GRAY)
    small = cv2.resize(grey, None, fx=PX_PER_MM / FINE, fy=PX_PER_MM / FINE, interpolation=cv2.INTER_AREA)
    return SheetInk.of_picture(Flat(small, PX_PER_MM, by="points"))


def sheet(setting: Setting | None = None) -> Paper:
    return Paper((100.0, 75.0), setting or Setting(), random.Random(1))


def draw(paper: Paper, a: complex, b: complex, press: Sequence[float] = (1.0, 1.0)) -> None:
    paper.lay(np.linspace(a, b, 20).tolist(), list(press), 0.45, GRAPHITE)


def triangle(paper: Paper, press: float) -> None:
    for a, b in SIDES:
        draw(paper, a, b, (press, press))


def shares(ink: SheetInk, lines: Sequence[tuple[complex, complex]]) -> list[float]:
    """The shares of lines that are drawn."""
    return list(ink.drawn_shares(np.array([a for a, _ in lines]), np.array([b for _, b in lines]), 56))


def left(ink: SheetInk, lines: Sequence[tuple[complex, complex]]) -> float:
    """mm of ink that lines leave unexplained."""
    a, b = (np.array([[line[k] for line in lines]]) for k in (0, 1))
    return float(ink.unexplained_ink_mm(a, b, ALL, -99 + 0j, 0.0, np.zeros((1, 0), complex), np.zeros(0))[0])


def print_letters(paper: Paper) -> None:
    """Rows of printed letters, 3.5 mm high."""
    for row in (60, 130):
        cv2.putText(paper.colour, "velocities, 1 : 20", (120, row), cv2.FONT_HERSHEY_SIMPLEX, 1.9, PRINT, 3)


def smear(paper: Paper) -> None:
    """A broad soft stain."""
    dark = np.zeros(paper.colour.shape[:2], np.float32)
    cv2.ellipse(dark, (600, 500), (260, 60), 20, 0, 360, 0.12, -1)
    paper.colour = (paper.colour * (1 - cv2.GaussianBlur(dark, (0, 0), 25))[..., None]).astype(np.uint8)


@pytest.mark.parametrize(("press", "tooth"), [(0.45, 1.0), (0.6, 1.0), (1.0, 1.0), (0.6, 1.4), (1.0, 1.4)])
def test_a_light_pencil_is_seen_whole_beside_dark_print(press: float, tooth: float) -> None:
    """Three sides, whatever the pressure and the paper's grain; a line between none of them is not there."""
    paper = sheet(Setting(tooth=tooth))
    print_letters(paper)
    triangle(paper, press)
    ink = felt(paper)
    assert min(shares(ink, SIDES)) > 0.95 and shares(ink, [(22 + 40j, 45 + 20j)])[0] < 0.2


def test_a_fading_stroke_is_seen_to_its_end_and_not_beyond() -> None:
    paper = sheet()
    triangle(paper, 1.0)
    a, b = 10 + 8j, 90 + 12j
    fading = abs(b - a) * np.linspace(1, 0, 40)
    draw(paper, a, b, (1 - 0.65 * np.clip(1 - fading / 15, 0, 1)).tolist())
    ink, way = felt(paper), (b - a) / abs(b - a)
    assert shares(ink, [(a, b)])[0] > 0.95 and shares(ink, [(b + way, b + 8 * way)])[0] < 0.2


@pytest.mark.parametrize("spoil", [print_letters, smear])
def test_letters_and_smears_are_no_lines(spoil: Callable[[Paper], None]) -> None:
    paper, line = sheet(), (15 + 10j, 85 + 14j)
    draw(paper, *line, (0.5, 0.5))
    spoil(paper)
    ink = felt(paper)
    assert shares(ink, [line])[0] > 0.9 and left(ink, [line]) < 12 < 60 < left(ink, [(10 + 60j, 12 + 60j)])


def test_ink_that_no_line_explains_is_measured_and_that_of_a_line_run_on_counts_half() -> None:
    paper = sheet()
    triangle(paper, 1.0)
    draw(paper, CORNERS[1], 90 + 60j)
    ink, more = felt(paper), abs(90 + 60j - CORNERS[1])
    assert left(ink, SIDES) == pytest.approx(more, rel=0.15)
    a, b = SIDES[0]
    short = (a, a + 0.75 * (b - a))
    assert left(ink, [short, *SIDES[1:]]) - left(ink, SIDES) == pytest.approx(0.55 * 0.25 * abs(b - a), rel=0.3)


def test_a_grid_is_no_drawing_though_a_line_runs_along_it() -> None:
    paper = sheet(Setting(grid="squared"))
    y = next(k for k in range(200, 700) if (paper.colour[k, 300:900].mean() < 228))
    a, b = (complex(x, 75 - y / FINE) for x in (25, 75))
    draw(paper, a, b)
    draw(paper, a, 60 + 12j)
    ink = felt(paper)
    assert min(shares(ink, [(a, b), (a, 60 + 12j)])) > 0.95 and left(ink, [(a, b), (a, 60 + 12j)]) < 10


@pytest.mark.parametrize("way", [1, -1])
def test_a_head_speaks_for_the_end_it_is_at(way: int) -> None:
    a, b = 10 + 10j, 60 + 30j
    tip, u = (b, (b - a) / abs(b - a)) if way > 0 else (a, (a - b) / abs(b - a))
    ink = drawn([(a, b), (a, 20 + 60j), *((tip, tip - 3.5 * u * complex(np.exp(s * 0.26j))) for s in (1, -1))])
    here, there = ink.head_evidence(np.array([a]), np.array([b]))[0], ink.head_evidence(np.array([b]), np.array([a]))[0]
    assert way * (here - there) > 1


def test_a_sheet_without_a_line_has_no_ink() -> None:
    assert not felt(sheet()).points.size


def test_a_line_that_cannot_be_drawn_is_nowhere() -> None:
    """Its ends are no numbers: it lies on no ink, and nobody is warned of a cast."""
    paper = sheet()
    triangle(paper, 1.0)
    nowhere = complex(np.nan, np.nan)
    there, not_there, far = shares(felt(paper), [SIDES[0], (SIDES[0][0], nowhere), (nowhere, complex(np.inf, 0))])
    assert there > 0.9 and not_there == far == 0.0
