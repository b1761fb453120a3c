"""What stands on a page of known scale: its ink in parts that hang together, each as a picture of its own."""

from __future__ import annotations

import math
from collections.abc import Sequence

from planes.check.reading.parts import TOGETHER_MM
from planes.check.vision.ink import ink_of, light_of
from planes.check.vision.picture import Flat, cv
from planes.geometry.arrays import Greys, Indices

MOST = 6  # parts that are looked at
LEAST_MM, RIM_MM = 6.0, 3.0  # of a part; of paper around it
PX_PER_MM = 2.0  # of the smaller picture on which parts are told
SOFT_MM = 6.0  # what counts little in a size


def parts_of(flat: Flat, plan: Sequence[complex]) -> list[Flat]:
    """The parts of a page, those of about the size of a plan first, each with the others' ink painted over."""
    import numpy

    cv2, ink, light = cv(), ink_of(flat), light_of(flat)
    factor = PX_PER_MM / flat.scale
    small = cv2.resize(ink.mask * 255, None, fx=factor, fy=factor, interpolation=cv2.INTER_AREA)
    near = round(TOGETHER_MM / 2 * PX_PER_MM) * 2 + 1
    spread = cv2.dilate((small > 40).astype(numpy.uint8), cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (near, near)))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(spread, connectivity=8)
    size = _size(plan)
    found: list[tuple[float, int]] = []
    for k, (_, _, w, h, _) in enumerate(stats.tolist()):
        if k and max(w, h) > LEAST_MM * PX_PER_MM:
            found.append(
                (
                    sum(
                        abs(math.log((a / PX_PER_MM + SOFT_MM) / (b + SOFT_MM)))
                        for a, b in zip((w, h), size, strict=True)
                    ),
                    k,
                )
            )
    return [_part(flat, light, labels, k, stats[k].tolist()) for _, k in sorted(found)[:MOST]]


def _size(plan: Sequence[complex]) -> tuple[float, float]:
    xs, ys = [z.real for z in plan], [z.imag for z in plan]
    return max(xs) - min(xs), max(ys) - min(ys)


def _part(flat: Flat, light: Greys, labels: Indices, k: int, box: Sequence[int]) -> Flat:
    """A part cut out, with paper around it."""
    import numpy

    up, (height, width) = flat.scale / PX_PER_MM, flat.grey.shape
    rim = RIM_MM * flat.scale
    left, top = (max(int(n * up - rim), 0) for n in box[:2])
    right, low = min(int((box[0] + box[2]) * up + rim), width), min(int((box[1] + box[3]) * up + rim), height)
    rows, columns = (
        numpy.clip(numpy.arange(a, b) / up, 0, n - 1).astype(int)
        for a, b, n in ((top, low, labels.shape[0]), (left, right, labels.shape[1]))
    )
    own = labels[rows[:, None], columns[None, :]]
    grey = numpy.where((own == 0) | (own == k), flat.grey[top:low, left:right], light[top:low, left:right])
    return Flat(numpy.ascontiguousarray(grey), flat.scale, flat.mm(left, low), "part")
