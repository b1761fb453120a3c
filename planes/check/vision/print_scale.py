"""The scale of a sheet as seen: its print scale, shown by the drawing, or that of the mark that set its scale.

A printer that fits a page into its margins reduces all of it, but people draw on it with a ruler: measured by the
corner marks, all they draw is larger by one factor. A drawing at a wrong scale looks the same, so only factors that
printers produce are accepted.
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

LEAST, MOST = 0.9, 1.05  # limits of a print scale
TRUE = 0.003  # accuracy of a scanner
LONG_MM = 12.0  # of a vector that determines it
LYING = 0.01  # unknown rotation of a sheet, radians
ALONG = 0.004  # rotation of a drawing on its paper, radians


def printed_share(flat: Flat, grey: Greys, scale: float | None) -> float:
    """The print scale of a blank, from a scan with known pixels per millimetre.

    1 for others (oblique pictures among them), and where no printer produces that scale.
    """
    if scale is None:
        return 1.0
    height, width = grey.shape
    far, middle = min(height, width) / 4, complex(width, height) / 2
    across, down = (2 * far / scale / abs(flat.place(middle + far * w) - flat.place(middle - far * w)) for w in (1, 1j))
    share = (across + down) / 2
    true = LEAST < share < MOST and abs(across - down) < TRUE < abs(share - 1)
    return share if true else 1.0


def resized_by(flat: Flat, about: complex, share: float, spots: list[ReadMark]) -> list[ReadMark]:
    """The marks and the picture of a sheet printed at a scale, converted to true millimetres.

    It is reported only if a ruler shows the difference.
    """
    if share == 1:
        return spots
    if share == flat.printed:
        flat.notes.append(Phrase("check_printed_at", share=Written(f"{100 * share:.1f}")))
    flat.scale, flat.corner = flat.scale / share, about + (flat.corner - about) * share
    return [replace(s, place=about + (s.place - about) * share) for s in spots]


def measured_by(flat: Flat, about: complex, spots: list[ReadMark], bench: PreparedPlan) -> list[ReadMark]:
    """Marks with the errors of the vector that set the scale of their sheet.

    These are its drawing error, the accuracy of pointing to its ends, and a possible camera tilt.
    """
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
