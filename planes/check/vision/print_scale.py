"""At what share of its size a sheet is seen: as a blank was printed, told by the drawing on it, or as a mark was drawn
from which its scale was taken.

A printer that fits a page into its margins makes all of it smaller, but people draw on it by a ruler: measured by the
corner marks, all they draw is larger by one factor. A drawing to a wrong scale looks the same, so no more is believed
than printers do.
"""

import math
from dataclasses import replace

from planes.check.grading.handwork import Hand
from planes.check.grading.paper import TOLD_MM, ReadMark
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.vision.from_aside import as_sure
from planes.check.vision.image.picture import Flat
from planes.geometry.arrays import Greys
from planes.words import Phrase, Written
from planes.words.names import at

LEAST, MOST = 0.9, 1.05  # of its size that a page may be printed at
TRUE = 0.003  # so true is a scanner
LONG_MM = 12.0  # of a vector that tells it
LYING = 0.01  # how much a sheet lies turned that nothing tells of, radians
ALONG = 0.004  # how much what people draw lies turned on their paper, radians


def printed_share(flat: Flat, grey: Greys, scale: float | None) -> float:
    """The share of its size a blank was printed at, told by a scan that knows its pixels to a millimetre; 1 of others
    (those that see it askew among them), and where no printer makes it so large."""
    if scale is None:
        return 1.0
    height, width = grey.shape
    far, middle = min(height, width) / 4, complex(width, height) / 2
    across, down = (2 * far / scale / abs(flat.place(middle + far * w) - flat.place(middle - far * w)) for w in (1, 1j))
    share = (across + down) / 2
    true = LEAST < share < MOST and abs(across - down) < TRUE < abs(share - 1)
    return share if true else 1.0


def resized_by(flat: Flat, about: complex, share: float, spots: list[ReadMark]) -> list[ReadMark]:
    """Marks of a sheet printed at a share of its size, and its picture from now on, in millimetres of a ruler, that are
    so much longer; said only where a ruler shows it."""
    if share == 1:
        return spots
    if share == flat.printed:
        flat.notes.append(Phrase("check_printed_at", share=Written(f"{100 * share:.1f}")))
    flat.scale, flat.corner = flat.scale / share, about + (flat.corner - about) * share
    return [replace(s, place=about + (s.place - about) * share) for s in spots]


def measured_by(flat: Flat, about: complex, spots: list[ReadMark], bench: PreparedPlan) -> list[ReadMark]:
    """Marks as sure as what their sheet was measured by: a vector that is itself off by what a hand errs and by how
    surely its ends were pointed to, and seen by a camera that may have been tilted."""
    if flat.told is None:
        return spots
    length, mark = flat.told[1], at(bench.asked.plan, flat.told[0])
    right = {at(bench.asked.plan, n): ReadMark(n, z) for n, z in bench.true_marks.items()}
    misses = Hand(bench.program, bench.given, bench.asked.skill, right).misses([mark])
    own = misses[mark].mean if mark in misses else 0.0
    drawn = math.hypot(own, TOLD_MM) / max(length, LONG_MM)
    turned = ALONG if flat.by_paper else drawn / math.sqrt(2) if length > LONG_MM else LYING
    share = math.hypot(turned if flat.by_file else drawn, flat.aslant)
    return [as_sure(s, about, share, flat.lens) for s in spots]
