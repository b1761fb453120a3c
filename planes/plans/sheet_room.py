"""How large the plans of a mechanism can be on its two sheets: figures by their extents, texts by what they list.

Nothing is laid out here. A format holds its figures in columns if they fill no more than two thirds of it. The areas
were measured on the composed sheets of 68 mechanisms, each at three sizes of plans. On these sheets the estimate errs
by 5 % (1 σ) for the first and 10 % for the second, so that one sheet in twelve takes a larger format after all.
"""

from collections.abc import Callable
from functools import cached_property

from planes.drafting.drawing import Drawing
from planes.plans import Plans
from planes.plans.extents import Size, box_size, plan_width_and_height
from planes.words.frozen import frozen
from planes.words.names import RATE_PLANS, SCHEME_PLAN, VELOCITY_PLAN, NameTuple, NumbersByName, PlanId, scheme_mark

ROOM_ON_FORMATS = ((169e3, (122e3, 152e3)), (354e3, (167e3, 270e3)))
"""Of A2 and A1, mm²: the most that was held, and what nearly all held with larger letters, and with smaller ones."""
LARGER_SIZES = (1.0, 1.12, 1.25, 1.4)  # relative to the usual ones; from A2 to A1 the sides grow 1.4 times
KINDS_ENLARGED_TOGETHER = (("velocity", "acceleration", "motion"), ("position",), ("force",))
# around a figure: letters, dimensions, its title, half of the gap to its neighbour
FIGURE_MARGIN_MM = 35.0
GROUP_MARGIN_MM = 55.0
# equations, diagrams and tables: an area for all, and one for each vector that they name
FIRST_SHEET_TEXT_MM2, RATE_VECTOR_MM2 = 52.5e3, 1090.0
# the letters of a force are in several figures
SECOND_SHEET_TEXT_MM2, FORCE_VECTOR_MM2 = 4.7e3, 4300.0


@frozen
class FigureBox:
    """A figure of a sheet: the plan whose μ it has, its size in SI, and the margin around it in mm."""

    plan: PlanId
    size: Size
    margin: float


@frozen
class SheetContents:
    """The figures of a sheet, and the area of its texts."""

    figures: list[FigureBox]
    text_mm2: float

    def area_mm2(self, scales: NumbersByName) -> float:
        """The area they need at some scales; figures of nothing need none."""
        sized = [(scales[f.plan.mu_name], f.size, f.margin) for f in self.figures if any(f.size)]
        return self.text_mm2 + sum((mu * wide + m) * (mu * high + m) for mu, (wide, high), m in sized)


@frozen
class SheetRoom:
    """The figures of both sheets at 1 mm per SI unit: ``drawing`` is that of all plans."""

    plans: Plans
    drawing: Drawing

    def largest_sizes(self, usual: NumbersByName, scales_at: Callable[[NumbersByName], NumbersByName]) -> NumbersByName:
        """The sizes of plans by kind, as large as the formats allow that hold the ``usual`` ones: the kinds that are
        least enlarged are enlarged first. ``scales_at`` gives the μ of all plans for such sizes."""
        steps = dict.fromkeys(KINDS_ENLARGED_TOGETHER, 0)
        best = usual
        usual_areas = self._areas_mm2(scales_at(usual))
        limits = [_room_held(area) for area in usual_areas]
        growing = {*KINDS_ENLARGED_TOGETHER}
        while growing:
            kinds = min((k for k in KINDS_ENLARGED_TOGETHER if k in growing), key=steps.__getitem__)
            tried = {**best, **{k: LARGER_SIZES[steps[kinds] + 1] * usual[k] for k in kinds}}
            held = all(area <= most for area, most in zip(self._areas_mm2(scales_at(tried)), limits, strict=True))
            if held:
                best = tried
                steps[kinds] += 1
            if not held or steps[kinds] == len(LARGER_SIZES) - 1:
                growing.discard(kinds)
        return best

    def _areas_mm2(self, scales: NumbersByName) -> list[float]:
        """The areas that both sheets need."""
        return [sheet.area_mm2(scales) for sheet in (self.first_sheet, self.second_sheet)]

    @cached_property
    def first_sheet(self) -> SheetContents:
        """The scheme over a turn, the rate plans, their equations, diagrams and tables."""
        plans = [p for p in self.plans.plan_names if p in RATE_PLANS]
        listed = sum(len(self.plans.segments_on(p)) for p in plans)
        figures = [FigureBox(SCHEME_PLAN, self.plans.turn_size, FIGURE_MARGIN_MM)]
        figures += [self._figure_of_plan(p, FIGURE_MARGIN_MM) for p in plans]
        return SheetContents(figures, FIRST_SHEET_TEXT_MM2 + RATE_VECTOR_MM2 * listed)

    @cached_property
    def second_sheet(self) -> SheetContents:
        """The loaded scheme, the lever, the force polygons, groups with their forces, and tables."""
        plans = self.plans.force_plans
        if not plans:
            return SheetContents([], 0.0)
        figures = [self._figure_of_plan(p, FIGURE_MARGIN_MM) for p in (SCHEME_PLAN, VELOCITY_PLAN)]
        figures += [self._figure_of_plan(p, 0.0) for p in plans]
        figures += [self._figure_of_links(p.links, GROUP_MARGIN_MM) for p in plans]
        listed = sum(len(self.plans.segments_on(p)) for p in plans)
        return SheetContents(figures, SECOND_SHEET_TEXT_MM2 + FORCE_VECTOR_MM2 * listed)

    def _figure_of_plan(self, plan: PlanId, margin: float) -> FigureBox:
        return FigureBox(plan, plan_width_and_height(self.drawing, plan), margin)

    def _figure_of_links(self, links: NameTuple, margin: float) -> FigureBox:
        """A figure of some links at the scale of the scheme."""
        known = self.plans.mechanism.links
        names = {scheme_mark(p) for x in links if x in known for p in known[x].points}
        return FigureBox(SCHEME_PLAN, box_size(self.drawing[n] for n in names if n in self.drawing), margin)


def _room_held(area: float) -> float:
    """The area with which a sheet should keep its format and its letters, mm²; the same one where it just does."""
    levels = next((levels for most, levels in ROOM_ON_FORMATS if area <= most), ())
    return next((level for level in levels if area <= level), area)
