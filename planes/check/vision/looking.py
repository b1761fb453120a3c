"""Examines one rectified picture: finds the pole of a plan and its marks."""

import math
from dataclasses import dataclass, field

from planes.check.blank import blank_pole
from planes.check.evidence.sheet_ink import SheetInk
from planes.check.explaining.explained import Explanation
from planes.check.explaining.plan_lines import PlanLines
from planes.check.explaining.sought_pole import likeliest_pole
from planes.check.explaining.weights import LEAST_COVER, MOST_STRAY_INK_MM
from planes.check.fiducials import SHEET_MM
from planes.check.grading.paper import Box, ReadPaper
from planes.check.grading.prepared_plan import PreparedPlan
from planes.check.vision.image.picture import Flat
from planes.check.vision.page_parts import A2_MM2, split_page
from planes.check.vision.print_scale import convert_to_true_mm, with_scale_vector_errors
from planes.words import Phrase, Written

# minimum share of the ink around a plan that it explains; more if its pole was not given. Of 44 pictures of a plan two
# were below the first, of 44 of another mechanism's plan thirty
LEAST_EXPLAINED_SHARES = 0.35, 0.5


@dataclass
class Look:
    """One examination of a picture: its rectification and the findings."""

    flat: Flat
    pole: complex
    paper: ReadPaper = field(default_factory=ReadPaper)  # with μ, if found at another scale than the stated one
    cover: float = 0.0  # share of the plan's lines found
    explained: float = 0.0  # share of the ink around them that they explain
    bare: bool = False  # whether there are no lines at all

    @property
    def has_plan(self) -> bool:
        """Whether the plan, right or with a mistake, is there."""
        return bool(self.paper.spots)

    def picture_box(self, bench: PreparedPlan) -> Box:
        """The position of the rectified picture."""
        printed = not self.has_plan and self.flat.by == "marks"
        low = self.flat.corner - (self.flat.pole or blank_pole(bench) if printed else self.pole)
        h, w = self.flat.grey.shape[:2]
        high = low + complex(w, h) / self.flat.scale
        return low.real, low.imag, high.real, high.imag


def best_examination(
    bench: PreparedPlan, flat: Flat, pole: complex | None, held: tuple[str, complex] | None = None
) -> Look:
    """The best findings in a rectified picture: in all of it or, on a page of known scale, in one of its parts.

    ``held`` is the mark, with its position, that was pointed to and set the scale of the picture.
    """
    if flat.by != "scale" or pole is not None:
        printed = flat.pole or blank_pole(bench) if flat.by == "marks" or flat.size_mm == SHEET_MM else None
        look = examine_picture(bench, flat, printed if pole is None else pole, held)
        if look.has_plan or pole is not None or flat.by == "marks":
            return look
        return examine_picture(bench, flat, None, held)
    page = split_page(flat)
    looks = [Look(flat, 0j)]
    for k, mu in page.likely_plan_parts(bench):
        look = examine_picture(bench.at_scale(mu), page.cut_out_part(k), None)
        look.paper.mu = mu
        looks.append(look)
        if look.cover * look.explained > LEAST_COVER:
            break
    if math.prod(flat.size_mm) <= A2_MM2 and not any(look.has_plan for look in looks):
        looks.append(examine_picture(bench, flat, None))
    return max(looks, key=lambda look: (look.has_plan, look.cover * look.explained))


def examine_picture(
    bench: PreparedPlan, flat: Flat, near: complex | None, held: tuple[str, complex] | None = None
) -> Look:
    """The plan found in a rectified picture by drawing it again from its pole, near a given point or searched for."""
    ink = SheetInk.of_picture(flat)
    if not ink.points.size:
        return Look(flat, 0j, bare=True)
    plan = PlanLines(bench, flat.printed, held, flat.by == "marks")
    pole = likeliest_pole(plan, ink) if near is None else near
    seen = Explanation(plan, ink, pole)
    likeliest = seen.likeliest_drawing
    look = Look(flat, 0j if near is None else pole, cover=likeliest.cover, explained=seen.explained_ink_share)
    if look.cover < LEAST_COVER or look.cover * look.explained < LEAST_EXPLAINED_SHARES[near is None]:
        return look
    look.pole = pole
    paper = look.paper
    paper.spots = convert_to_true_mm(
        flat, pole, seen.sheet_scale, with_scale_vector_errors(flat, pole, seen.seen_marks(), bench)
    )
    paper.untold = [*seen.unverified_marks(), *seen.marks_without_clear_lines()]
    paper.left = seen.faint_vectors()
    paper.named = seen.marks_seen_by_name_only()
    if likeliest.hypothesis.is_right and likeliest.strange > MOST_STRAY_INK_MM:
        flat.notes.append(Phrase("check_strangers", mm=Written(f"{likeliest.strange:.0f}")))
    motion = bench.kind not in ("position", "force")
    paper.signs = (
        seen.transformed_plan_faults()
        or (seen.swapped_letter_faults() if motion else [])
        or seen.reversed_vector_faults()
    )
    return look
