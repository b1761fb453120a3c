"""The basic crank-slider scene of the tests of the integrated calculation, and ways to change it."""

from __future__ import annotations

from functools import cache

from planes.crank_slider.calculation import Calculation, calculate
from planes.scene import loads
from tests.helpers import ROOT

SAMPLE = (ROOT / "samples" / "crank-slider.yaml").read_text(encoding="utf-8")

TWO_STROKE = """\
  indicator:
    over: angle
    unit: bar
    compression: [[0, 1.1], [60, 1.1], [120, 6], [180, 40]]
    expansion: [[180, 40], [195, 62], [240, 14], [300, 3], [360, 1.1]]
"""


def changed(*pairs: tuple[str, str], text: str = SAMPLE) -> str:
    """The sample with pieces replaced; each must be present."""
    for old, new in pairs:
        assert old in text, old
        text = text.replace(old, new, 1)
    return text


def two_stroke() -> str:
    """The sample with a two-stroke diagram over the crank angle."""
    start, end = SAMPLE.index("  indicator:"), SAMPLE.index("  step: 1")
    text = SAMPLE[:start] + TWO_STROKE + SAMPLE[end:]
    return changed(
        ("positions: [30, 120, 380, 450]", "positions: [200, 390]"), ("ambient: 0.1", "ambient: 1"), text=text
    )


@cache
def calculated(text: str = SAMPLE, variant: str | None = None) -> Calculation:
    """The calculation of a text, made once in a run."""
    return calculate(loads(text, "crank-slider.yaml", variant))
