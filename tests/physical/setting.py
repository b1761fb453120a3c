"""How a drawing is made, laid out and taken: every physical factor as a number or a word of one flat record."""

from __future__ import annotations

import random
from collections.abc import Mapping
from dataclasses import dataclass, fields, replace
from typing import Any

Colour = tuple[int, int, int]  # blue, green, red


@dataclass(frozen=True)
class Setting:
    """A sheet, a hand, what else stands on the sheet, and how its picture is taken."""

    # the paper
    sheet: str = "blank"  # "blank" as the program prints it; "frame" alone; "paper" without any print of the program
    grid: str = ""  # "squared" 5 mm, "millimetre", "ruled" 8 mm
    grid_ink: float = 1.0
    tint: Colour = (244, 247, 248)
    tooth: float = 1.0  # how deep the paper's grain is to a pencil
    print_scale: float = 1.0
    # the hand
    tool: str = "pencil"
    ink: Colour = (92, 84, 82)  # of graphite laid on thickly it is never black
    press: float = 1.0  # 1 is a firm HB
    wander: float = 0.08  # how much pressure wanders along a line, σ
    fade_mm: float = 3.0  # over which a line runs out at its far end
    fade_to: float = 0.8  # the share of pressure left at the very end
    width_mm: float = 0.45
    tremor_mm: float = 0.05
    bow_mm: float = 0.08
    over_mm: float = 0.0  # how far construction lines run beyond the marks
    over_share: float = 0.0  # of vectors with a construction line
    twice: float = 0.0  # the share of lines drawn twice
    heads: str = "filled"  # "filled", "barbs", "none"
    rubbed: int = 0  # lines rubbed out
    smudges: int = 0
    dots: bool = False  # ends of vectors marked by a dot
    letters: str = "neat"  # "neat", "wild", "indices" (small and lowered), "script", "none"
    # what else is on the sheet
    title_block: bool = False
    table: bool = False
    second_plan: bool = False
    stamp: bool = False
    name: bool = False
    text: str = ""  # about the drawing: "printed", "written" by hand, a "form" with rules
    # how the picture is taken
    camera: str = "scan"
    dpi: float = 200.0
    turn_deg: float = 0.0
    quarter: int = 0  # quarter turns
    width_px: int = 2000
    tilt_deg: float = 4.0
    close: bool = False  # so near the drawing that the sheet's edges are not in view
    lens: float = 0.01
    lamp: float = 0.15  # how much darker the far side of the sheet is
    shadow: float = 0.0  # how dark a hand's shadow is
    motion_px: float = 0.0
    blur_px: float = 0.6
    noise: float = 2.0
    quality: int = 88
    pole_told: bool = False  # whether a person points to the pole of a sheet with a frame; on plain paper to a mark too
    clicked_px: float = 0.6  # σ of the places he points to
    # kept for the last count
    crease: float = 0.0  # how dark a fold across the sheet is
    curl_mm: float = 0.0
    cup: bool = False
    copied: bool = False  # a photocopy of the drawing
    skipping: float = 0.0  # the share of a pen's line where its ball does not write
    # kept for the count after that
    thumb: bool = False  # that holds a corner of the sheet
    ticked: bool = False  # by a teacher's red pen
    banding: float = 0.0  # how much darker every other band of a flickering lamp's light is


Spread = Mapping[str, Any]  # a field's value, a list to choose of, or a pair of floats to draw between
FIELDS = {f.name for f in fields(Setting)}


def varied(setting: Setting, spread: Spread, rng: random.Random) -> Setting:
    """The setting with some fields set: chosen from lists, drawn from ranges, else as they stand."""
    drawn: dict[str, Any] = {}
    for name, value in spread.items():
        if isinstance(value, list):
            value = rng.choice(value)
        if isinstance(value, tuple) and len(value) == 2:
            value = rng.uniform(*value)
        drawn[name] = value
    return replace(setting, **drawn)
