"""The content of a page of known scale: its ink in connected parts, each as a separate picture."""

import math
from collections.abc import Iterator

import numpy

from planes.check.evidence.ink import drawing_ink, paper_light
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.reading.parts import CONNECTED_STROKES_MM
from planes.check.vision.image.opencv import connected_components, cv, resize_by_factor
from planes.check.vision.image.picture import Flat
from planes.geometry.arrays import Greys, Indices
from planes.geometry.plane import bounding_corners
from planes.words.frozen import frozen
from planes.words.units import standard_mu, standard_scale

MOST_PARTS_EXAMINED = 8  # parts examined, at one scale each
SMALLEST_PART_MM = 6.0  # of a part
PART_MARGIN_MM = 3.0  # margin of paper around it
PX_PER_MM = 2.0  # of the reduced picture in which parts are found
A3_MM2 = 125_000.0  # a larger page is surveyed as if of this size: its parts are examined closely
A2_MM2 = 250_000.0  # a larger part is no plan
LEAST_INK_LEVEL = 40  # of 255, in its pixels
SIZE_SOFTNESS_MM = 6.0  # softness of a size comparison
# relative sizes of a plan in its part: lines extend further, schemes have supports
PLAN_SIZE_RATIOS = (0.7, 0.8, 0.9, 1.0, 1.05)


@frozen
class PageParts:
    """The parts of a page: their numbers on a small picture of it, and their boxes there (left, top, width, height)."""

    flat: Flat
    light: Greys
    labels: Indices
    boxes: list[list[int]]

    def likely_plan_parts(self, bench: PreparedPlan) -> list[tuple[int, float | None]]:
        """Parts that may be the plan, at a standard scale if none is stated; the likeliest first."""
        low, high = bounding_corners([0j, *bench.true_marks.values()])
        size = (high - low).real, (high - low).imag
        parts = []
        for k, seen in enumerate((w / PX_PER_MM, h / PX_PER_MM) for _, _, w, h in self.boxes):
            fits = k and max(seen) > SMALLEST_PART_MM and math.prod(seen) <= A2_MM2
            for mu in _possible_scales(bench, max(size), max(seen)) if fits else ():
                pairs = zip(seen, size, strict=True)
                unlike = (
                    abs(math.log((a + SIZE_SOFTNESS_MM) / (b * mu / bench.said_mu + SIZE_SOFTNESS_MM)))
                    for a, b in pairs
                )
                parts.append((sum(unlike), k, mu))
        return [(k, mu if mu != bench.said_mu else None) for _, k, mu in sorted(parts)[:MOST_PARTS_EXAMINED]]

    def cut_out_part(self, k: int) -> Flat:
        """A part cut out with a margin of paper, the ink of others painted over."""
        up = self.flat.scale / PX_PER_MM
        rim = PART_MARGIN_MM * self.flat.scale
        height, width = self.flat.grey.shape
        x, y, w, h = self.boxes[k]
        left = max(int(x * up - rim), 0)
        top = max(int(y * up - rim), 0)
        right = min(int((x + w) * up + rim), width)
        low = min(int((y + h) * up + rim), height)
        rows = (numpy.arange(top, low) / up).astype(int).clip(0, self.labels.shape[0] - 1)
        columns = (numpy.arange(left, right) / up).astype(int).clip(0, self.labels.shape[1] - 1)
        held = self.labels[rows[:, None], columns]
        place = slice(top, low), slice(left, right)
        grey = numpy.where((held == 0) | (held == k), self.flat.grey[place], self.light[place])
        return Flat(grey, self.flat.scale, self.flat.px_to_mm(left, low), "part")


def _possible_scales(bench: PreparedPlan, true_mm: float, seen_mm: float) -> Iterator[float]:
    """The stated scale, or the standard ones at which a plan has about the size of the part."""
    kind = bench.kind
    if bench.asked.mu or bench.asked.scene.mu.get(kind):
        yield bench.said_mu
    else:
        standard = standard_scale if kind == "position" else standard_mu
        yield from {standard(true_mm / bench.said_mu, seen_mm * size) for size in PLAN_SIZE_RATIOS}


def split_page(flat: Flat) -> PageParts:
    """The parts of a page."""
    cv2 = cv()
    size = tuple(round(mm * PX_PER_MM) for mm in flat.size_mm)
    share = math.sqrt(A3_MM2 / math.prod(flat.size_mm))
    surveyed = Flat(resize_by_factor(flat.grey, share), flat.scale) if share < 1 else flat
    small = cv2.resize(drawing_ink(surveyed).mask * 255, size, interpolation=cv2.INTER_AREA)
    near = round(CONNECTED_STROKES_MM / 2 * PX_PER_MM) * 2 + 1
    spread = cv2.dilate(
        (small > LEAST_INK_LEVEL).astype(numpy.uint8), cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (near, near))
    )
    labels, stats = connected_components(spread)
    return PageParts(flat, paper_light(flat), labels, stats[:, :4].tolist())
