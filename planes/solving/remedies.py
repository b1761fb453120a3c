"""A draughtsman's remedies near a dead point: a smaller scale, or values between those of neighbouring positions."""

import math
from collections.abc import Collection, Sequence
from dataclasses import replace

from planes.plans.columns import Column
from planes.plans.extents import plan_extent
from planes.plans.measuring import BLUNT_CROSSING_SINE, DrawingReader, plan_name_in_words
from planes.plans.quantities import MOTION_GROUPS, Measured
from planes.plans.scales import PLAN_FIT_MM
from planes.scene import Scene
from planes.solving import (
    Position,
    Solved,
    drive_position_in_words,
    drive_position_key,
    failed_position_sentence,
    plans_and_requested_results,
    results_json,
)
from planes.solving.nearest import can_be_drawn
from planes.words import Lang, Written, say
from planes.words.errors import PlanFailure
from planes.words.names import PlanId
from planes.words.units import mu_text

FAR_NEIGHBOUR_DEG = 5.0
NEAR_NEIGHBOUR_DEG = 0.01
MOST_PLAN_SIZE_RATIO = 2.0  # times its usual size on the paper: a larger plan does not fit
MOST_NEIGHBOUR_DIFFERENCE_RATIO = 0.25  # relative: neighbours that extrapolate further apart than this are useless


def remedy_positions(solved: Solved) -> None:
    """Correct what can be corrected: positions at given scales too large for blunt crossings, and failed positions."""
    solved.positions = [position_at_released_scales(solved, p) for p in solved.positions]
    left = []
    for failure in solved.failed:
        between = interpolate_position(solved, failure[drive_position_key(solved.plans)], failure["error"])
        if between:
            solved.positions.append(between)
        else:
            left.append(failure)
    solved.failed = left
    order = {value: k for k, value in enumerate(solved.values)}
    solved.positions.sort(key=lambda p: order[p.at])


def position_at_released_scales(solved: Solved, p: Position) -> Position:
    """The position with the given μ released for each plan that is blunt and does not fit; unchanged if there is
    none."""
    scene = solved.scene
    lang = solved.lang
    large: dict[str, tuple[PlanId, str, float, float]] = {}
    reader = DrawingReader(p.plans, p.drawing, p.scales)
    for plan in p.plans.plan_names:
        stated = scene.mu.get(plan.kind)
        size = plan_extent(p.drawing, plan)
        blunt = {label: s for label, s in reader.crossing_sharpness(plan).items() if s < BLUNT_CROSSING_SINE}
        if stated and blunt and size > MOST_PLAN_SIZE_RATIO * PLAN_FIT_MM[plan.kind]:
            angle = math.degrees(math.asin(min(blunt.values())))
            large.setdefault(plan.kind, (plan, ", ".join(blunt), angle, size))
    if not large:
        return p
    again = replace(solved, scene=_scene_with_open_scales(scene, large)).at(p.at)
    again.results["remedied"] = sorted(large)
    for kind, (plan, marks, angle, size) in large.items():
        said, now = (mu_text(x[plan.mu_name], kind, lang, scene.mu_convention) for x in (p.scales, again.scales))
        parts = {
            "marks": marks,
            "angle_deg": Written(f"{angle:.2g}"),
            "size_mm": f"{size:.0f}",
            "plan": plan_name_in_words(plan, lang),
        }
        again.results["warnings"].append(say("remedy_scale", lang, said=said, mu=now, **parts))
    return again


def position_for_sheet(
    scene: Scene, values: list[float] | None, lang: Lang
) -> tuple[Scene, list[float] | None, list[str]]:
    """The position to draw on a sheet instead, and sentences about it: released scales, or the neighbour used."""
    solved = Solved(scene, *plans_and_requested_results(scene), lang=lang)
    drive = solved.plans.drive
    asked = [drive.position] if values is None else values
    if len(asked) != 1:
        return scene, values, []
    try:
        p = position_at_released_scales(solved, solved.at(asked[0]))
    except PlanFailure as failure:
        near = interpolate_position(solved, asked[0], "")
        if near is None:
            return scene, values, []
        there = near.results["interpolated"][1]
        kind = drive.kind
        why = failed_position_sentence(failure, asked[0], kind)
        return scene, [there], [say("remedy_beside", lang, why=why, there=drive_position_in_words(there, kind, lang))]
    kinds = p.results.get("remedied", [])
    said = p.results["warnings"][len(p.results["warnings"]) - len(kinds) :]
    return _scene_with_open_scales(scene, kinds), values, said


def _scene_with_open_scales(scene: Scene, kinds: Collection[str]) -> Scene:
    """The scene with the scales of some plans left to the program."""
    return replace(scene, mu={k: v for k, v in scene.mu.items() if k not in kinds})


def interpolate_position(solved: Solved, value: float, why: str) -> Position | None:
    """Values at a position that cannot be drawn, from neighbours that can; None where they give no answer.

    They are the means of the positions 5° to either side, where the motion is smooth; where it turns back at a change
    point, the extrapolation from 10° and 5° before it, in the driver's direction.
    """
    plans = solved.plans
    lang = solved.lang
    drive = solved.plans.drive
    near = [value - NEAR_NEIGHBOUR_DEG, value + NEAR_NEIGHBOUR_DEG]
    if not drive.rotates or not all(can_be_drawn(plans, v) for v in near):
        return None
    way = math.copysign(FAR_NEIGHBOUR_DEG, drive.velocity)
    ways = {
        "remedy_between": ((value - FAR_NEIGHBOUR_DEG, 0.5), (value + FAR_NEIGHBOUR_DEG, 0.5), near),
        "remedy_carried": (
            (value - 2 * way, -1.0),
            (value - way, 2.0),
            [value - math.copysign(NEAR_NEIGHBOUR_DEG, way)],
        ),
    }
    for key, ((one, first), (two, second), ends) in ways.items():
        try:
            a, b = solved.at(one), solved.at(two)
            measured = _weighted_sums(a.found, b.found, first, second)
            beside = [solved.at(v).found for v in ends]
        except PlanFailure:
            continue
        steady = tuple(f for f in measured if f.quantity.group in (*MOTION_GROUPS, "transfers"))
        apart = max(_relative_difference(steady, x) for x in beside)
        if apart <= MOST_NEIGHBOUR_DIFFERENCE_RATIO:
            loose = max(_relative_difference(measured, x) for x in beside) > MOST_NEIGHBOUR_DIFFERENCE_RATIO
            measured, why = (steady, why + say("remedy_no_forces", lang)) if loose else (measured, why)
            low, high = (drive_position_in_words(v, drive.kind, lang) for v in (one, two))
            said = say(key, lang, why=why, low=low, high=high, apart=f"{100 * apart:.2g} %")
            empty = (k for k, v in a.results.items() if v == {} and (k in MOTION_GROUPS or not loose))
            shaped = results_json(plans, measured, empty)
            results = {drive_position_key(plans): value, **{k: shaped[k] for k in a.results if k in shaped}}
            results |= {"interpolated": [one, two], "warnings": [said]}
            return Position(value, plans, b.drawing, b.scales, measured, results)
    return None


def _weighted_sums(a: Sequence[Measured], b: Sequence[Measured], one: float, two: float) -> tuple[Measured, ...]:
    """Weighted sums of all results; angles go the short way round."""

    def blended(c: Column, x: float | None, y: float | None) -> float | None:
        if x is None or y is None:
            return None
        if c.unit == "°":
            y = x + math.remainder(y - x, 360.0)
            return math.remainder(one * x + two * y, 360.0)
        return one * x + two * y

    return tuple(
        Measured(x.quantity, tuple(map(blended, x.quantity.columns, x.numbers, y.numbers)))
        for x, y in zip(a, b, strict=True)
    )


def _relative_difference(a: Sequence[Measured], b: Sequence[Measured]) -> float:
    """The difference of two results: the largest relative to the largest number of its kind."""
    sizes: dict[str, float] = {}
    gaps: dict[str, float] = {}
    others = {f.quantity.json_path: f.numbers for f in b}
    rows = [(f.quantity, zip(f.quantity.columns, f.numbers, others[f.quantity.json_path], strict=True)) for f in a]
    for q, c, x, y in ((q, *row) for q, numbers in rows for row in numbers):
        if x is not None and y is not None:
            kind = q.key or f"{q.group} {c.comparison_class}"
            turns = c.unit == "°"
            gap = abs(math.remainder(x - y, 360.0)) if turns else abs(x - y)
            sizes[kind] = max(sizes.get(kind, 0.0), 180.0 if turns else abs(y))
            gaps[kind] = max(gaps.get(kind, 0.0), gap)
    for slow, quick in (("epsilon", sizes.get("omega", 0.0) ** 2), ("coriolis", sizes.get("a", 0.0))):
        sizes[slow] = max(sizes.get(slow, 0.0), quick)
    return max((gap / sizes[kind] for kind, gap in gaps.items() if gap > 1e-9 * sizes[kind]), default=0.0)
