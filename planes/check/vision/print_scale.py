"""The scale of a sheet as seen: its print scale, shown by the drawing, or that of the mark that set its scale.

A printer that fits a page into its margins reduces all of it, but people draw on it with a ruler: measured by the
corner marks, all they draw is larger by one factor. A drawing at a wrong scale looks the same, so only factors that
printers produce are accepted.
"""

import math
from dataclasses import replace

from planes.check.grading.handwork import Hand
from planes.check.grading.paper import POINTED_MARK_ERROR_MM, ReadMark
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.vision.from_aside import with_scale_and_tilt_errors
from planes.check.vision.image.picture import Flat
from planes.geometry.arrays import Greys
from planes.words import Phrase, Written

LEAST_PRINT_SCALE, MOST_PRINT_SCALE = 0.9, 1.05  # limits of a print scale
SCANNER_ACCURACY = 0.003  # accuracy of a scanner
LONG_VECTOR_MM = 12.0  # of a vector that determines it
SHEET_ROTATION_RAD = 0.01  # unknown rotation of a sheet, radians
DRAWING_ROTATION_RAD = 0.004  # rotation of a drawing on its paper, radians


def print_scale_of_scan(flat: Flat, grey: Greys, scale: float | None) -> float:
    """The print scale of a blank, from a scan with known pixels per millimetre.

    1 for others (oblique pictures among them), and where no printer produces that scale.
    """
    if scale is None:
        return 1.0
    height, width = grey.shape
    far = min(height, width) / 4
    middle = complex(width, height) / 2
    across, down = (
        2 * far / scale / abs(flat.sheet_point_of_pixel(middle + far * w) - flat.sheet_point_of_pixel(middle - far * w))
        for w in (1, 1j)
    )
    share = (across + down) / 2
    true = LEAST_PRINT_SCALE < share < MOST_PRINT_SCALE and abs(across - down) < SCANNER_ACCURACY < abs(share - 1)
    return share if true else 1.0


def convert_to_true_mm(flat: Flat, about: complex, share: float, spots: list[ReadMark]) -> list[ReadMark]:
    """The marks and the picture of a sheet printed at a scale, converted to true millimetres.

    It is reported only if a ruler shows the difference.
    """
    if share == 1:
        return spots
    if share == flat.printed:
        flat.notes.append(Phrase("check_printed_at", share=Written(f"{100 * share:.1f}")))
    flat.scale = flat.scale / share
    flat.corner = about + (flat.corner - about) * share
    return [replace(s, place=about + (s.place - about) * share) for s in spots]


def with_scale_vector_errors(flat: Flat, about: complex, spots: list[ReadMark], bench: PreparedPlan) -> list[ReadMark]:
    """Marks with the errors of the vector that set the scale of their sheet.

    These are its drawing error, the accuracy of pointing to its ends, and a possible camera tilt.
    """
    if flat.told is None:
        return spots
    length = flat.told[1]
    mark = bench.plan.mark(flat.told[0])
    right = {bench.plan.mark(n): ReadMark(n, z) for n, z in bench.true_marks.items()}
    misses = Hand(bench.program, bench.given, bench.asked.skill, right).misses([mark])
    own = misses[mark].mean_sigma_mm if mark in misses else 0.0
    drawn = math.hypot(own, POINTED_MARK_ERROR_MM) / max(length, LONG_VECTOR_MM)
    turned = (
        DRAWING_ROTATION_RAD
        if flat.by_paper
        else drawn / math.sqrt(2)
        if length > LONG_VECTOR_MM
        else SHEET_ROTATION_RAD
    )
    share = math.hypot(turned if flat.by_file else drawn, flat.aslant)
    return [with_scale_and_tilt_errors(s, about, share, flat.lens) for s in spots]
