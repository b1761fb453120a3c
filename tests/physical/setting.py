"""The making, layout and photographing of a drawing: every physical factor as a number or a word of one flat record."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

Colour = tuple[int, int, int]  # blue, green, red


@dataclass(frozen=True)
class Setting:
    """A sheet, a hand, other content of the sheet, and the taking of its picture."""

    # the paper
    sheet: str = "blank"  # "blank" as printed by the program; "frame" alone; "paper" without any print of the program
    grid: str = ""  # "squared" 5 mm, "millimetre", "ruled" 8 mm
    grid_ink: float = 1.0
    tint: Colour = (244, 247, 248)
    tooth: float = 1.0  # depth of the paper's grain for a pencil
    print_scale: float = 1.0
    # the hand
    tool: str = "pencil"
    ink: Colour = (92, 84, 82)  # thick graphite is never black
    press: float = 1.0  # 1 is a firm HB
    wander: float = 0.08  # variation of pressure along a line, σ
    fade_mm: float = 3.0  # over which a line fades at its far end
    fade_to: float = 0.8  # share of pressure left at the very end
    width_mm: float = 0.45
    tremor_mm: float = 0.05
    bow_mm: float = 0.08
    over_mm: float = 0.0  # extension of construction lines beyond the marks
    over_share: float = 0.0  # of vectors with a construction line
    twice: float = 0.0  # share of lines drawn twice
    heads: str = "filled"  # "filled", "barbs", "none"
    rubbed: int = 0  # erased lines
    smudges: int = 0
    dots: bool = False  # ends of vectors marked by a dot
    letters: str = "neat"  # "neat", "wild", "indices" (small and lowered), "script", "none"
    # other content of the sheet
    title_block: bool = False
    table: bool = False
    second_plan: bool = False
    stamp: bool = False
    name: bool = False
    text: str = ""  # around the drawing: "printed", "written" by hand, a "form" with rules
    # the picture
    camera: str = "scan"
    dpi: float = 200.0
    turn_deg: float = 0.0
    quarter: int = 0  # quarter turns
    width_px: int = 2000
    tilt_deg: float = 4.0
    close: bool = False  # at such close range that the sheet's edges are not in view
    lens: float = 0.01
    lamp: float = 0.15  # relative darkness of the far side of the sheet
    shadow: float = 0.0  # darkness of a hand's shadow
    motion_px: float = 0.0
    blur_px: float = 0.6
    noise: float = 2.0
    quality: int = 88
    pole_told: bool = False  # whether a person points to the pole of a sheet with a frame; on plain paper to a mark
    clicked_px: float = 0.6  # σ of the points clicked
    # reserved for the last count
    crease: float = 0.0  # darkness of a fold across the sheet
    curl_mm: float = 0.0
    cup: bool = False
    copied: bool = False  # a photocopy of the drawing
    skipping: float = 0.0  # share of a pen's line where its ball does not write
    # reserved for the count after that
    thumb: bool = False  # holding a corner of the sheet
    ticked: bool = False  # by a teacher's red pen
    banding: float = 0.0  # relative darkness of every other band under a flickering lamp


Spread = Mapping[str, Any]  # a field's value, a list to choose from, or a pair of floats as a range
FIELDS = {f.name for f in fields(Setting)}


def varied(setting: Setting, spread: Spread, rng: random.Random) -> Setting:
    """The setting with some fields set: chosen from lists, drawn from ranges, otherwise unchanged."""
    drawn: dict[str, Any] = {}
    for name, value in spread.items():
        if isinstance(value, list):
            value = rng.choice(value)
        if isinstance(value, tuple) and len(value) == 2:
            value = rng.uniform(*value)
        drawn[name] = value
    return replace(setting, **drawn)
