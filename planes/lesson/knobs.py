"""The given numbers of a lesson that a reader may change, their ranges, and the effect of a dragged mark."""

import random
from functools import cached_property

from planes.drafting.steps import LayOff, Put, Similar, Step
from planes.drafting.steps.crossings import CrossArc, CrossArcs
from planes.drafting.steps.tracks import TrackStep
from planes.geometry.listed import ListArithmetic, Listed
from planes.lesson.dimensions import FreeNumbers
from planes.lesson.formulas import in_lesson_languages, sentence_in_lesson_languages, unit_of_name
from planes.words import Written
from planes.words.names import (
    LEVER_PLAN,
    MOTION_PLAN,
    UNIT_OF_LOADING,
    VELOCITY_PLAN,
    NumbersByName,
    direction_of_given_angle,
    split_value_name,
)
from planes.words.records import Json

COMMON_SCALE_PLANS = (VELOCITY_PLAN, MOTION_PLAN, LEVER_PLAN)
"""Plans with a common scale: the lever's segments are carried from the velocity plan."""
STROKE_WORDS_BY_PREFIX = {
    "‖": "stroke_working",
    "|": "stroke_idle",
}  # loads of a stroke, by the beginning of their names
ZERO_ANGLE_RANGE_DEG = 30.0  # degrees: range of an angle about zero
TRIAL_CHANGE_SHARE = 0.07  # relative: trial change of a number, to find terms that are always zero


class Knobs(FreeNumbers):
    """The free numbers that a reader may change, and the effect of dragging a mark."""

    @cached_property
    def offered_numbers(self) -> list[Json]:
        """Each with its name, its unit and its value in the scene; ``tied`` are those that change with it in
        proportion; one that ``stays`` is never drawn anew at random: guides, and points of a straight line."""
        used = {*self.plans.program.given_names, *self.own}
        knobs = []
        for name, value in self.values_in_scene.items():
            given, _, axis = name.partition(".")
            plan = next((p for p in self.plans.plan_names if p.mu_name == given), None)
            name_in_scene = "" if plan else self.number_name_for_reader(given, axis)
            if given in used and (name_in_scene or plan not in (None, *COMMON_SCALE_PLANS[1:])):
                knob: Json = {"given": name, "at": value, "tied": self.tied_scales(given)}
                written = Written("°") if direction_of_given_angle(given) else unit_of_name(name_in_scene)
                knob |= {"plan": plan} if plan else {"name": name_in_scene, "unit": in_lesson_languages(written.told)}
                if given[0] in STROKE_WORDS_BY_PREFIX and given not in self.plans.means:
                    knob["when"] = sentence_in_lesson_languages(STROKE_WORDS_BY_PREFIX[given[0]])
                if given in self.turned.values() or (not value and direction_of_given_angle(given)):
                    knob["stays"] = True
                knobs.append(knob)
        return [{**k, **more} for k in knobs if (more := self.range_about_zero(k, knobs)) or k["at"]]

    def range_about_zero(self, knob: Json, knobs: list[Json]) -> NumbersByName:
        """The range of a number that is zero: the largest of its kind, for an angular acceleration the square of the
        speed; zero where there is none."""
        if knob["at"]:
            return {}
        if direction_of_given_angle(knob["given"]):
            return {"reach": ZERO_ANGLE_RANGE_DEG}
        letter = split_value_name(knob["name"])[0]
        rates = {"epsilon": "omega", "a": "v"}
        like = ("x", "y", "l") if letter in ("x", "y") else (rates.get(letter, letter),)
        size = max((abs(k["at"]) for k in knobs if split_value_name(k.get("name", ""))[0] in like), default=0.0)
        return {"reach": size ** (2 if letter in rates else 1)} if size else {}

    def tied_scales(self, given: str) -> list[str]:
        """The scales that change with a scale: those of the plans that carry segments from each other."""
        same = [p.mu_name for p in COMMON_SCALE_PLANS if p.mu_name in self.given]
        return [mu for mu in same if mu != given] if given in same else []

    def perturbed_givens(self, count: int, leaning: bool = False) -> dict[str, Listed]:
        """Given numbers with many others near them: a list for each, every second one unchanged, since a structure of
        many links may not assemble with others. Guides keep their directions, unless they are ``leaning``."""
        draw = random.Random(1)
        flat = {n: Listed([v] * count) for n, v in self.values_in_scene.items()}
        for knob in self.offered_numbers:
            most = TRIAL_CHANGE_SHARE * (leaning or "stays" not in knob)
            times = Listed(1 + most * draw.uniform(-1, 1) * (k % 2) for k in range(count))
            flat[knob["given"]] = flat[knob["given"]] + (times - 1) * knob.get("reach", 0.0)
            for name in (knob["given"], *knob["tied"]):
                flat[name] = flat[name] * times
        given = self.givens_from_free(flat, ListArithmetic())
        return {n: z for n, z in given.items() if isinstance(z, Listed) and max(abs(z)) > min(abs(z))}

    def number_name_for_reader(self, given: str, axis: str) -> str:
        """The name of a number for the reader, "" where it is not offered."""
        means = self.plans.means.get(given) or self.plans.means.get(given.lstrip("".join(STROKE_WORDS_BY_PREFIX)))
        letter = split_value_name(given)[0]
        if means and means.quantity in UNIT_OF_LOADING:
            return means.of
        if means and means.quantity == "place":
            return self.coordinate_name(given, axis)
        plain = letter in ("l", "m", "J", "omega", "epsilon", "v", "a", "g") and "°" not in given
        own = plain or given in self.own
        return direction_of_given_angle(given) or given * own

    def coordinate_name(self, given: str, axis: str) -> str:
        """The coordinate of a point of the frame, or of a guide of the frame without a point: across it only."""
        name = split_value_name(given)[1]
        if "°" not in name:
            return f"{axis}_{name}"
        guide = self.plans.mechanism.frame.guides.get(name.strip("°"))
        idle = {0.0: "x", 90.0: "y"}.get(guide.angle_deg % 180) if guide else axis
        return f"{axis}_{name.strip('°')}" if axis != idle else ""

    def numbers_fixing_marks(self) -> dict[str, list[str]]:
        """For each mark of the scheme the numbers that fix it."""
        free = self.values_in_scene
        drive = self.plans.drive_given_name
        placed_by = {}
        for step in self.plans.program.steps:
            names = [
                n
                for n in self.numbers_placing_mark(step)
                if free.get(n) or n == drive or (n in free and direction_of_given_angle(n))
            ]
            if step.plan == "position" and names:
                placed_by[step.makes] = names
        return placed_by

    def numbers_placing_mark(self, step: Step) -> list[str]:
        """The numbers by which a step places its mark."""
        drive = self.plans.drive_given_name
        match step:
            case Put() if step.at:
                return [f"{step.at}.x", f"{step.at}.y"]
            case LayOff():
                turned = getattr(self.plans.program.steps_by_result.get(step.along), "of", "")
                driven = turned == f"x_{self.plans.drive.link}" or step.length == drive
                return [step.length, *self.numbers_of_point_on_link(step.label)[1:], *[drive] * driven]
            case CrossArc():
                return [step.radius]
            case CrossArcs():
                return [step.radius, step.other_radius]
            case Similar():
                return self.numbers_of_point_on_link(step.label)
            case TrackStep():
                held = [hold.reach for hold in step.holds if hold.local == step.local and hold.kind == "arc"]
                basic = [x for x in self.plans.mechanism.links if step.local == f"at_{step.label}_{x}"]
                return [*held, *self.numbers_of_point_on_link(step.label, *basic), drive]
        return []

    def numbers_of_point_on_link(self, label: str, *links: str) -> list[str]:
        """The numbers that fix a point on its link, one of some ``links``."""
        names_of_links = (self.numbers_fixing_point(x, label) for x in links or self.plans.mechanism.links)
        return next(filter(None, names_of_links), [])
