"""The scale μ of every plan: as given in the scene, or the largest standard one that fits its part of the paper.

One choice for a scene and a position, independent of a sheet: results, note, lesson, blanks and sheets all use it.
"""

import math
from collections.abc import Mapping
from functools import cached_property, lru_cache
from typing import Self

from planes.drafting.drawing import Drawing, draw_program, draw_until_failure
from planes.drafting.program import Program
from planes.geometry.arithmetic import Real
from planes.plans import Plans
from planes.plans.extents import plan_extent
from planes.plans.sheet_room import SheetRoom
from planes.words.errors import PlanFailure
from planes.words.frozen import frozen
from planes.words.names import (
    ACCELERATION_PLAN,
    LEVER_PLAN,
    MOTION_PLAN,
    NO_PLAN,
    SCHEME_PLAN,
    VELOCITY_PLAN,
    NumbersByName,
    PlanId,
    scheme_mark,
)
from planes.words.units import standard_mu, standard_scale

PLAN_FIT_MM = {"position": 150.0, "velocity": 100.0, "acceleration": 100.0, "force": 140.0, "motion": 100.0}
PLAN_FIT_MM |= {"contour": 100.0, "vectors": 100.0, "cremona": 140.0}
"""The usual size of a plan on paper."""
PLAN_SIZE_RATIO_BY_FORMAT = {"A4": 0.5, "A3": 0.7, "A2": 1.0, "A1": 1.4, "A0": 2.0}
"""The size of plans on a format named in the scene, relative to the usual: the ratio of the formats' sides."""
PLAN_SIZE_RATIO_BY_JOINED = dict(
    zip(PLAN_SIZE_RATIO_BY_FORMAT, [*PLAN_SIZE_RATIO_BY_FORMAT.values(), 2.8][1:], strict=True)
)
"""For several formats side by side, as A3x4: their height is that of the next larger format."""
ROUNDING_FORCE_RATIO = 1e-12  # of mass times acceleration: a force that is only rounding
ZERO_VECTOR_MM = 0.05  # a vector shorter than this has no length on paper
LEAST_LINK_MM = 12.5  # the signs of a hinge and a slider, beside each other
SHORT_LINK_SIZE_RATIO = 1.7  # a scheme with a link shorter than this may be larger than usual by this
LEAST_FORCE_PLAN_MM = 50.0  # a force plan that would be smaller than this at the common μ gets a second one


def plan_sizes_on_format(sheet: Mapping[str, object]) -> NumbersByName | None:
    """The size of each kind of plan on the format named for the sheets of a scene; None where none is."""
    name = str(sheet.get("format", "auto"))
    if name == "auto":
        return None
    share = (PLAN_SIZE_RATIO_BY_JOINED if "x" in name else PLAN_SIZE_RATIO_BY_FORMAT)[name[:2]]
    return {kind: share * mm for kind, mm in PLAN_FIT_MM.items()}


def scale_leaders(sizes: Mapping[PlanId, float], fit_mm: NumbersByName = PLAN_FIT_MM) -> dict[PlanId, PlanId]:
    """For each plan, given the sizes in SI, the plan whose μ it shares. Force plans share one, since forces are carried
    from one to another: that of the largest plan. Those too small at it share the μ of the largest among them."""
    forces = sorted((p for p in sizes if p.is_force), key=lambda p: -sizes[p])
    small = [
        p
        for p in forces
        if 0.0 < sizes[p] * largest_fitting_scale(p, sizes[forces[0]], fit_mm["force"]) < LEAST_FORCE_PLAN_MM
    ]
    leader_of = {plan: forces[0] if plan in forces else plan for plan in sizes}
    return leader_of | dict.fromkeys(small, next(iter(small), NO_PLAN))


def unit_scales_of_plans(plans: Plans) -> dict[str, float]:
    """Every μ as 1 mm per SI unit: a drawing in SI, to find the sizes."""
    return {plan.mu_name: 1.0 for plan in plans.plan_names}


def drawn_in_si(plans: Plans, value: Real, program: Program | None = None) -> Drawing:
    """All plans, or some of them, drawn in SI at one position of the drive or many."""
    return draw_program(
        program or plans.program, {**plans.given, **unit_scales_of_plans(plans), plans.drive_given_name: value}
    )


def plan_scales(
    plans: Plans,
    said: Mapping[str, float | None],
    given: Mapping[str, object] | None = None,
    fit_mm: NumbersByName | None = None,
) -> dict[str, float]:
    """μ of every plan of one position (names to mm per SI unit). Raises the same errors as drawing that position.

    ``fit_mm`` is the size of each kind of plan, if not as large as the sheets allow.
    """
    choice = ScaleChoice.of(plans, said, given)
    if not fit_mm:
        entire = ScaleChoice.of(plans.uncut, said, given) if plans.uncut else choice
        fit_mm = entire.largest_sizes
    chosen = choice.scales_at(fit_mm)
    if choice.failure:  # give it in millimetres of the paper
        draw_program(plans.program, {**choice.given, **chosen})
        raise choice.failure
    return chosen


def plan_sizes(
    plans: Plans,
    said: Mapping[str, float | None],
    sheet: Mapping[str, object],
    given: Mapping[str, object] | None = None,
) -> NumbersByName:
    """The size of each kind of plan: that for the format named for the sheets of a scene, or the largest with which the
    sheets of a mechanism should keep their formats, however little of it is drawn."""
    return plan_sizes_on_format(sheet) or ScaleChoice.of(plans.uncut or plans, said, given).largest_sizes


@frozen
class ScaleChoice:
    """The choice of every μ of one position: ``said`` are those of the scene by kind of plan, ``drawing`` shows the
    plans at the scales of ``given``, 1 mm per SI unit, as far as there is no ``failure``."""

    plans: Plans
    said: Mapping[str, float | None]
    given: Mapping[str, object]
    drawing: Drawing
    failure: PlanFailure | None

    @classmethod
    def of(cls, plans: Plans, said: Mapping[str, float | None], moved: Mapping[str, object] | None = None) -> Self:
        """The choice for a position of the drive, by default that of the scene."""
        given = {**plans.given, **unit_scales_of_plans(plans), **(moved or {})}
        return cls(plans, said, given, *draw_until_failure(plans.program, given))

    @cached_property
    def largest_sizes(self) -> NumbersByName:
        """The largest size of each kind of plan with which the sheets of a mechanism should keep their formats."""
        if self.plans.has_mechanism and self.open_plan_sizes_si:
            return SheetRoom(self.plans, self.drawing).largest_sizes(PLAN_FIT_MM, self.scales_at)
        return PLAN_FIT_MM

    @cached_property
    def open_plan_sizes_si(self) -> Mapping[PlanId, float]:
        """The sizes in SI of the plans whose μ the scene leaves open."""
        names = [p for p in self.plans.plan_names if p != LEVER_PLAN and not self.said.get(p.kind)]
        return {plan: _plan_size_si(self.plans, self.drawing, plan) for plan in names}

    def scales_at(self, fit_mm: NumbersByName) -> dict[str, float]:
        """Every μ for some sizes of plans."""
        sizes = self.open_plan_sizes_si
        named = [p for p in self.plans.plan_names if p != LEVER_PLAN]
        chosen = {p.mu_name: mu for p in named if (mu := self.said.get(p.kind))}
        for plan, leader in scale_leaders(sizes, fit_mm).items():
            mm = fit_mm[plan.kind]
            chosen[plan.mu_name] = mu = largest_fitting_scale(plan, sizes[leader], mm)
            if plan == SCHEME_PLAN and mm >= PLAN_FIT_MM[plan] and mu * self._shortest_link < LEAST_LINK_MM:
                larger = max(mm, SHORT_LINK_SIZE_RATIO * PLAN_FIT_MM[plan])
                chosen[plan.mu_name] = largest_fitting_scale(plan, sizes[leader], larger)
        if LEVER_PLAN in self.plans.plan_names:
            chosen[LEVER_PLAN.mu_name] = chosen[(MOTION_PLAN if self.plans.at_rest else VELOCITY_PLAN).mu_name]
        return chosen

    @cached_property
    def _shortest_link(self) -> float:
        """The length of the shortest link from its first point to the farthest other, its mass centre aside, in SI."""
        links = self.plans.mechanism.links.values()
        marks = ([scheme_mark(p) for p in link.points if p != link.centre] for link in links)
        places = [[self.drawing[m] for m in names if m in self.drawing] for names in marks]
        return min((max(abs(z - one[0]) for z in one[1:]) for one in places if len(one) > 1), default=math.inf)


@lru_cache(1024)
def largest_fitting_scale(plan: str, size: float, fit_mm: float) -> float:
    """The largest standard μ, mm per SI unit, at which a plan of this size in SI fits into so many millimetres."""
    return (standard_scale if plan == "position" else standard_mu)(size, fit_mm)


def _plan_size_si(plans: Plans, drawing: Drawing, plan: PlanId) -> float:
    """The size of a plan in SI; zero for a force polygon with only the rounding of inertia and weight."""
    size = plan_extent(drawing, plan)
    m = plans.mechanism
    if plan.is_force and "acceleration" in plans.plan_names:
        mass = sum(link.mass or 0.0 for link in m.links.values())
        if size > ROUNDING_FORCE_RATIO * mass * ((m.gravity or 0.0) + plan_extent(drawing, ACCELERATION_PLAN)):
            return size
        return 0.0
    return size
