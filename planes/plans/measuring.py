"""Readings from a drawing: results by name, in SI, with the segments measured; and the names of plans and structure in
words."""

import cmath
import math

from planes.drafting.draft import Segment
from planes.drafting.drawing import Drawing
from planes.plans import Plans
from planes.plans.assur.structure import Structure
from planes.plans.columns import Column
from planes.plans.quantities import Measured, Quantity
from planes.scene import Scene
from planes.words import Lang, capitalize_first_letter
from planes.words.errors import PlanFailure
from planes.words.lettering import plan_phrase
from planes.words.names import NumbersByName, PlanId, label_of
from planes.words.records import Json
from planes.words.units import mu_text

BLUNT_CROSSING_SINE = math.sin(math.radians(15))


class DrawingReader:
    """Reads one drawing."""

    def __init__(self, stated: Plans, drawing: Drawing, scales: NumbersByName) -> None:
        self.stated = stated
        self.drawing = drawing
        self.scales = scales
        self.own = {f"{letter}_{point}" for letter in "va" for point in stated.points}  # vectors of points

    def finite_number(self, value: float, name: str) -> float:
        """The number itself, never NaN or infinite."""
        if not math.isfinite(value):
            raise PlanFailure("no_digits", makes=label_of(name))
        return float(value) + 0.0

    def read_quantity(self, quantity: Quantity) -> Measured:
        """One quantity in SI; the length of a segment of a plan."""
        return Measured(quantity, tuple(map(self.read_column, quantity.columns)))

    def read_column(self, c: Column) -> float | None:
        """One number; None for the arm of no force."""
        things = self.drawing.things
        ar = self.drawing.tool.ar
        if c.beside and c.has_no_normal_force(things, ar):
            return None
        return self.finite_number(c.read_from_drawing(things, ar), c.value or c.end)

    def measured_segments_of_plan(self, plan: PlanId, names: set[str] | None = None) -> dict[str, Segment]:
        """The measured segments of a plan by their ends ("bc"), each once, only those of ``names`` if given.

        Where one segment is two vectors (v_C and v_CD of a fixed D), it is named as the point's own.
        """
        segments: dict[str, Segment] = {}
        for s in self.stated.segments_on(plan):
            there = all(end in self.drawing for end in s.ends)
            if s.start != s.end and there and (names is None or s.name in names):
                key = s.start + s.end
                if key not in segments or (s.name in self.own and segments[key].name not in self.own):
                    segments[key] = s
        return segments

    def measurements_by_plan(self, names: set[str] | None = None, errors: dict[str, float] | None = None) -> Json:
        """The measurements on each plan: μ, segments in mm and in SI, sharpness of the crossings."""
        out: Json = {}
        for plan in self.stated.plan_names:
            if plan in ("lever", "motion"):
                continue
            sharpness = self.crossing_sharpness(plan)
            bluntest = self.bluntest_sharpness(plan)
            segments = {
                key: self.measure_segment(s, bluntest, (errors or {}).get(plan.mark(key)))
                for key, s in self.measured_segments_of_plan(plan, names).items()
            }
            if segments:
                mu = mu_text(self.scales[plan.mu_name], plan.kind)
                out[plan] = {"mu": mu, "segments": segments, "sharpness": sharpness}
        return out

    def measure_segment(self, s: Segment, bluntest: float, error_mm: float | None = None) -> Json:
        """One segment as measured with the instrument, on a plan whose bluntest crossing has this sharpness."""
        tool = self.drawing.tool
        mu = self.scales[s.plan.mu_name]
        start, end = (self.drawing[s.plan.mark(end)] for end in (s.start, s.end))
        length = self.finite_number(tool.read_length(abs(end - start)), s.name)
        if error_mm is None:
            error_mm = 8 * tool.ar.eps * (abs(start) + abs(end)) / bluntest
        sizes = {"mm": float(length), "value": float(length / mu)}
        return {**sizes, "unit": s.plan.unit, "error_mm": float(error_mm), "name": s.name}

    def crossing_sharpness(self, plan: PlanId) -> dict[str, float]:
        """Sine of the angle at which the lines of each crossed mark meet."""
        program = self.drawing.program
        sharpness = self.drawing.crossing_sharpness
        crossed = (s.makes for s in program.mark_steps_on(plan) if s.makes in sharpness)
        return {name.label: float(sharpness[name]) for name in crossed if name not in program.trial_marks}

    def bluntest_sharpness(self, plan: PlanId) -> float:
        """The smallest sharpness, by which errors grow. Touching arcs have none, and their error is the root of a
        rounding error."""
        return max(min([1.0, *self.crossing_sharpness(plan).values()]), 2 * math.sqrt(self.drawing.tool.ar.eps))


def polar_json(z: complex) -> Json:
    """A stated vector as in the JSON output."""
    return {"value": abs(z), "direction_deg": math.degrees(cmath.phase(z)), "xy": [z.real, z.imag]}


def plan_name_in_words(plan: PlanId, lang: Lang) -> str:
    """The name of a plan in words."""
    return plan_phrase(plan).told(lang)


def plan_title(plan: PlanId, lang: Lang) -> str:
    """The name of a plan for the beginning of a title."""
    return capitalize_first_letter(plan_name_in_words(plan, lang))


def counted_structure_numbers(s: Structure) -> tuple[str, str]:
    """W and q with numbers filled in; p_{1} are pairs of one freedom."""
    n = 1 + sum(len(g.links) for g in s.groups)
    p = len(s.pairs)
    redundant = f"q = W − 6n + 5p_{{1}} = {s.W} − 6·{n} + 5·{p} = {s.q}"
    return f"W = 3n − 2p_{{1}} = 3·{n} − 2·{p} = {s.W}", redundant.replace("-", "−")


def scene_lettering(scene: Scene, plans: Plans | None = None) -> Json:
    """The lettering of a scene's names, on a sheet as on a page. Only its plans know which vectors end at a point of
    the frame under a slider; the vectors of force plans do not need that."""
    drive = scene.mechanism.drive.link if scene.mechanism else ""
    own = plans.lettering_basis if plans else {"frame": scene.frame_number, "driver": drive}
    return {**own, "from_on": scene.sheet.get("reactions") == "from-on", "convention": scene.mu_convention}
