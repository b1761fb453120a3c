"""Practice: what a reader is asked at each step of a lesson, the right answers and the wrong ones with their names.

The wrong answers are drawn from the catalogue of mistakes: each of its variants is run, and where it puts the mark is
the place a reader who makes that mistake would put it.
"""

import cmath
import math
from collections import defaultdict
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial

from planes.check.grading.handwork import Variant
from planes.check.grading.plan_steps import PlanSteps
from planes.check.grading.prepared_plan import catalogue, known_plans
from planes.drafting.drawing import Drawing, run
from planes.drafting.program import Program
from planes.drafting.steps import Image, LayOff, Similar, Step
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Choose
from planes.geometry.arrays import Points
from planes.lesson.formulas import slots
from planes.lesson.frame import Frame, in_both
from planes.plans import Plans
from planes.words import Lang, say
from planes.words.errors import PlanesError
from planes.words.names import Meaning, at, lettered, mu_of, plan_of
from planes.words.records import Json

Said = dict[Lang, str]
APART_MM = 2.5  # a wrong place nearer than this to the right one cannot be told from it
SHORT_MM = 2.0  # a vector too short to be asked for
TURN_DEG = 12.0
LEAST_MM = 0.01  # a length that is written down as nothing
SAME_LENGTH = 0.05  # lengths that differ by less of themselves are one answer
PARTS = ("mark", "line", "other", "value", "ratio", "start", "end", "guide", "normal", "force", "gap")


@dataclass(frozen=True)
class Wrong:
    """Where a mistake puts a mark, with its name and sentence; ``vector`` is what it lays off to there, ``untold``
    whether it spoils a number that the question itself tells, and ``means`` what the directions drawn there mean."""

    mistake: str
    place: complex
    said: Said
    step: Step | None
    vector: complex
    untold: bool
    means: Mapping[str, Meaning]

    @property
    def slip(self) -> Json:
        """The mistake as it is exported."""
        return {"mistake": self.mistake, "said": self.said}


class Practice:
    """The tasks of one lesson in its own position."""

    def __init__(self, plans: Plans, given: Mapping[str, Points], drawing: Drawing, frames: Sequence[Frame]) -> None:
        self.plans, self.given, self.drawing, self.frames = plans, given, drawing, frames
        self.steps = plans.program.makers
        self.told = {f.makes[0]: told_values(f) for f in frames if f.makes}

    def tasks(self, progress: Callable[[int, int], None] | None = None) -> list[Json]:
        """One task for every frame that draws a mark a reader can draw."""
        wrongs = self.wrongs(progress)
        asked = [(k, f.makes[0]) for k, f in enumerate(self.frames) if f.makes and f.key != "fixed"]
        tasks = ((k, mark, self.task(mark, wrongs.get(mark, []))) for k, mark in asked)
        return [{"frame": k, "mark": mark, **task} for k, mark, task in tasks if task]

    def wrongs(self, progress: Callable[[int, int], None] | None) -> dict[str, list[Wrong]]:
        """The wrong places of every mark, by drawing every variant of the catalogue."""
        found: dict[str, list[Wrong]] = defaultdict(list)
        plans = known_plans(self.plans)
        for k, plan in enumerate(plans):
            if progress:
                progress(k + 1, len(plans))
            wanted = [s.makes for s in self.plans.program.steps if plan_of(s.makes) == plan]
            ways = PlanSteps(self.plans, self.plans.program.sliced(wanted), plan)
            for variant in catalogue(ways, {}, self.mu(ways.plan)):
                if wrong := self.drawn(ways, variant):
                    found[at(plan, variant.blames)].append(wrong)
        return found

    def mu(self, plan: str) -> float:
        """The scale of a plan."""
        return complex(self.given[mu_of(plan)]).real

    def drawn(self, ways: PlanSteps, variant: Variant) -> Wrong | None:
        """Where the mark a mistake is blamed at would be; None if nothing can be told apart there."""
        mark = at(ways.plan, variant.blames)
        swap = variant.swaps.get(mark, (self.steps[mark],))
        start = next((s.start for s in (swap[-1], self.steps[mark]) if isinstance(s, LayOff)), mark)
        told = [n for n in self.told.get(mark, ()) if n in self.drawing]
        steps = [own for step in ways.program.steps for own in variant.swaps.get(step.makes, (step,))]
        try:
            program = Program(tuple(steps)).sliced([mark, start, *(n for n in told if n in self.steps)])
            there = run(program, {**self.given, **variant.givens})
        except (PlanesError, ZeroDivisionError, OverflowError):
            return None
        place = complex(there[mark])
        if not cmath.isfinite(place) or abs(place - self.drawing[mark]) < APART_MM:
            return None
        untold = any(abs(abs(there[n]) - abs(self.drawing[n])) > 1e-6 * abs(self.drawing[n]) for n in told)
        along = getattr(self.steps[mark], "along", "")
        names = {"mark": variant.blames, "line": self.plans.means[along].line if along else "", **variant.about}
        shown = {**dict.fromkeys(PARTS, ""), **{k: f"⟨{str(v).lstrip('°')}⟩" if v else "" for k, v in names.items()}}
        said = in_both(lambda lang: say(f"mistake_{variant.mistake}", lang, **shown))
        own = swap[-1] if mark in variant.swaps else None
        means = {**self.plans.means, **{s.makes: s.means for s in swap if s.means}}
        return Wrong(variant.mistake, place, said, own, place - complex(there[start]), untold, means)

    def task(self, mark: str, wrongs: list[Wrong]) -> Json | None:
        """What is asked for one mark."""
        step = self.steps[mark]
        match step:
            case LayOff():
                return self.lay_off(step, wrongs)
            case Cross() | CrossArc() | CrossArcs() | Choose():
                lines = self.lines(step, wrongs) if isinstance(step, Cross) else []
                return {"kind": "cross", "lines": lines, "places": _places(wrongs)}
            case Similar() | Image():
                return {"kind": "similar", "places": _places(wrongs)}
        return None

    def lay_off(self, step: LayOff, wrongs: list[Wrong]) -> Json | None:
        """A known vector: which way, and how long."""
        way = complex(self.drawing[step.makes]) - complex(self.drawing[step.start])
        if abs(way) < SHORT_MM:
            return None
        turned: dict[str, list[Json]] = {}
        lengths = []
        for w in sorted(wrongs, key=lambda w: w.untold):
            angle = math.degrees(cmath.phase(w.vector / way)) if abs(w.vector) > SHORT_MM else 0.0
            quarter = round(angle / 90.0) % 4
            if abs(angle - 90 * round(angle / 90)) < TURN_DEG and quarter:
                slips = turned.setdefault(str(quarter), [])
                slips += [w.slip] * (not slips or not w.untold)
            elif abs(angle) < TURN_DEG and not w.untold and abs(abs(w.vector / way) - 1) > SAME_LENGTH:
                lengths.append({"mm": round(abs(w.vector), 1), **w.slip})
        return {
            "kind": "lay_off",
            "start": step.start,
            "angle": round(math.degrees(cmath.phase(way)), 2),
            "mm": round(abs(way), 2),
            "turned": turned,
            "lengths": lengths + self.scale_slips(step, abs(way)),
            "places": _places(wrongs),
        }

    def scale_slips(self, step: LayOff, length: float) -> list[Json]:
        """Lengths of who forgets the scale, or turns it over."""
        mu, found = self.mu(plan_of(step.makes)), []
        for mistake, slip in (("value_for_mm", length / mu), ("value_over_mu", length / mu / mu)):
            if abs(slip / length - 1) > SAME_LENGTH and slip > LEAST_MM:
                said = in_both(partial(say, f"lesson_{mistake}", mark=f"⟨{lettered(step.makes)}⟩"))
                found.append({"mm": slip, "mistake": mistake, "said": said})
        return found

    def lines(self, step: Cross, wrongs: list[Wrong]) -> list[Json]:
        """The two lines of a crossing, each with the directions to choose from."""
        return [
            {"through": through, "options": self.options(step, direction, side, wrongs)}
            for side, through, direction in (("along", step.start, step.along), ("across", step.other, step.across))
        ]

    def options(self, step: Cross, direction: str, side: str, wrongs: list[Wrong]) -> list[Json]:
        """The right direction among wrong ones, in an order that gives nothing away."""
        right = self.plans.means[direction]
        found: dict[str, Json] = {right.action: {"right": True, "slips": []}}
        for w in wrongs:
            other = getattr(w.step, side, direction) if isinstance(w.step, Cross) else direction
            text = w.means[other].action
            if other != direction and (len(found) < 4 or text in found):
                found.setdefault(text, {"slips": []})["slips"].append(w.slip)
        flipped = replace(right, quantity="along" if right.quantity == "across" else "across")
        found.setdefault(flipped.action, {"slips": []})
        return [{"text": text, **more} for text, more in sorted(found.items())]


def _places(wrongs: list[Wrong]) -> list[Json]:
    """Wrong places, each once for a mistake."""
    found: dict[tuple[float, float, str], Json] = {}
    for w in wrongs:
        place = round(w.place.real, 1), round(w.place.imag, 1)
        found.setdefault((*place, w.mistake), {"at": list(place), **w.slip})
    return list(found.values())


def told_values(frame: Frame) -> list[str]:
    """The values a question about a vector's length tells: those of its sentence but its own, unless that is all."""
    values = sorted({*slots(frame.said["en"])})
    return values if len(values) == 1 else [n for n in values if n not in frame.terms[:1]]
