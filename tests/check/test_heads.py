"""Arrowheads fitted to ink as triangles."""

from __future__ import annotations

import numpy
import pytest

pytest.importorskip("cv2")
from planes.check.vision.strokes.arrow_tips import NUDGES, Sight
from planes.check.vision.strokes.heads import barbed
from planes.check.vision.strokes.line_fitting import Fitted

HEAD = numpy.array([0.2, 0.05, 0.04, 3.0, 0.6])  # where its tip is, its turn, its length, half of its width
OFF = numpy.array([0.3, -0.05, 0.0, -0.3, 0.1])  # by which it is looked for astray
LIKE = numpy.array([2.8, 0.55]), numpy.array([0.1, 0.05])


def seen(barbs: bool, end: float | None) -> Sight:
    """A head drawn at a place, with a line that goes on."""
    line = Fitted(0j, 1 + 0j, (0.0, 0.0, 0.0), -10.0, 10.0, 0.1, 0.45)
    x, y = numpy.arange(-6.0, 2.5, 0.2)[:, None], numpy.arange(-1.5, 1.51, 0.1)[None, :]
    none = numpy.zeros(numpy.broadcast_shapes(x.shape, y.shape))
    blank = Sight(line, 0.45, 1, x, y, none, none, HEAD.copy(), end, barbs)
    dark = blank.off(HEAD, None)[: none.size].reshape(none.shape)
    return Sight(line, 0.45, 1, x, y, dark, none, HEAD + OFF, end, barbs)


@pytest.mark.parametrize("barbs", [False, True])
@pytest.mark.parametrize("end", [None, 0.2])
def test_several_heads_at_once_are_off_the_ink_as_each_is_alone(barbs: bool, end: float | None) -> None:
    one = seen(barbs, end)
    several = HEAD[:, None] + numpy.diag(NUDGES)
    alone = [one.off(p, LIKE) for p in several.T]
    assert numpy.allclose(one.off(several, LIKE), alone, atol=1e-12) and len({a.tobytes() for a in alone}) == 5


@pytest.mark.parametrize("barbs", [False, True])
def test_a_head_is_found_where_it_was_drawn(barbs: bool) -> None:
    one = seen(barbs, None)
    one.fit(None)
    assert abs(one.p - HEAD).max() < 0.05 and one.good and one.gain > 0.95


def test_rows_without_paper_between_line_and_barb_are_left_as_they_are() -> None:
    full, gap = numpy.ones((3, 20)), numpy.ones((3, 20))
    gap[:, 5:8] = 0.0
    assert barbed(full) is full and barbed(gap).all()
