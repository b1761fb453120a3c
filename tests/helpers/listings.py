"""Mark listings: every mark of a sheet as one line of text in hundredths of a mm, for comparison and storage.

``GOLDEN=write python -m pytest tests/render/test_golden.py`` rewrites the stored listings.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterable

from render.paper.marks import Arc, Arrow, Hatch, Line, Mark, Shape, Text
from render.sheet import Sheet
from tests.helpers import ROOT

GOLDEN = ROOT / "tests" / "golden"
SHOWN = 40  # lines of a difference


def place(z: complex) -> str:
    return f"({z.real + 0.0:.2f} {z.imag + 0.0:.2f})".replace("-0.00", "0.00")


def places(points: Iterable[complex]) -> str:
    return " ".join(map(place, points))


def line(mark: Mark) -> str:
    """One mark: layer, kind, positions in mm, style, words."""
    match mark:
        case Line():
            told = f"line {mark.style} {places(mark.points)}{' closed' if mark.closed else ''}"
        case Arc():
            told = f"arc {mark.style} {place(mark.centre)} r {mark.radius:.2f} "
            told += f"{mark.start_deg:.1f}..{mark.end_deg:.1f} {mark.fill}"
        case Arrow():
            told = f"arrow {mark.style} {place(mark.start)} -> {place(mark.end)} {mark.name}"
        case Shape():
            told = f"shape {mark.fill} {places(mark.points)}"
        case Text():
            turned = f" turned {mark.turn_deg:.1f}" if mark.turn_deg else ""
            told = f"text {mark.height:.2f} {mark.anchor} {place(mark.place)}{turned} {mark.text!r}"
        case Hatch():
            told = f"hatch {mark.angle_deg:.1f} every {mark.gap:.2f} {places(mark.points)}"
    return f"{mark.layer:12} {told}".rstrip()


def listing(sheet: Sheet) -> str:
    """The size, the views with their upper left corners, and all marks in drawing order."""
    head = ["size {:.2f} x {:.2f}".format(*sheet.size)]
    head += [f"view {v.key} at {place(complex(left, top))}" for v, left, top in sheet.views]
    return "\n".join([*head, *map(line, sheet.marks)]) + "\n"


def difference(kept: str, found: str) -> str:
    """Removed (-) and new (+) lines, only the first ones if there are many."""
    lines = [
        text
        for text in difflib.unified_diff(kept.splitlines(), found.splitlines(), "kept", "drawn now", "", "", 0, "")
        if not text.startswith("@@")
    ]
    gone, new = (sum(text.startswith(sign) for text in lines[2:]) for sign in "-+")
    rest = [f"… and {len(lines) - SHOWN} lines more"] if len(lines) > SHOWN else []
    return "\n".join([f"{gone} lines are gone, {new} are new", *lines[:SHOWN], *rest])
