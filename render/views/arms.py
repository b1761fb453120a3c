"""Arms of forces on a scheme: perpendiculars to their lines of action."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from typing import Self

from planes.drafting.drawing import Drawing
from planes.drafting.equations import Moments
from planes.drafting.steps.reckoning import Calculate, Drop
from planes.geometry.arithmetic import Arithmetic
from planes.geometry.plane import direction_between, perpendicular_foot
from planes.words import Lang, say
from planes.words.frozen import frozen
from render.labels import Label
from render.paper.marks import Line, Mark, Text
from render.paper.symbols import Marks
from render.views import remark_texts

NAME_LETTER_MM = 3.5
LEAST_ARM_MM = 2.0  # of an arm
ZERO_ARM_MM = 1e-6  # a force with a shorter arm passes through the moment point
ZERO_MOMENT_RATIO = 1e-9  # of the largest moment of the equation: below this it is zero
EQUAL_ARM_MM = 0.1  # arms that differ by less are equal
ARM_NAME_PREFIX = "arm "  # prefix of its label's name
HALF_BREAK_GAP_MM = 2.5  # half the gap of a break along its line


@frozen
class Arm:
    """An arm of a ``force`` at its ``point`` from a place to the ``foot`` on its line of action, with its name."""

    point: complex
    about: complex
    foot: complex
    force: str = ""
    name: str = ""

    @property
    def length(self) -> float:
        """Its length, mm."""
        return abs(self.foot - self.about)

    @classmethod
    def of_step(cls, drawing: Drawing, step: Drop, force: str = "", name: str = "") -> Self:
        """The arm that a step measures."""
        point, along, about = (complex(drawing[x]) for x in (step.point, step.along, step.about))
        return cls(point, about, perpendicular_foot(about, point, along), force, name)


@dataclass
class Arms:
    """Arms with their lines of action; an arm shared by two forces is drawn once, with both names."""

    marks: list[Mark] = field(default_factory=list)
    named: list[Label] = field(default_factory=list)
    short: list[str] = field(default_factory=list)  # names of those too short to see

    def add_arm(self, arm: Arm) -> None:
        """Add an arm; of one too short to see only its name."""
        ends = (arm.about, arm.foot)
        text = arm.name
        if arm.length < LEAST_ARM_MM:
            self.short.append(text)
            return
        self.marks.append(Line((arm.point, arm.foot), "construction", "construction"))
        for k, other in enumerate(self.named):
            if isinstance(other.at, tuple) and all(
                abs(a - b) < EQUAL_ARM_MM for a, b in zip(other.at, ends, strict=True)
            ):
                if text not in other.text.split(" = "):
                    self.named[k] = replace(other, text=f"{other.text} = {text}")
                return
        self.marks.append(Line(ends, "thin", "dimension"))
        self.named.append(Label(text, ends, NAME_LETTER_MM, name=f"{ARM_NAME_PREFIX}{arm.force}", told=True))


def nonzero_terms(drawing: Drawing, equation: Moments) -> list[tuple[str, str, float]]:
    """The forces and couples of a moment equation that are not zero, each with its arm and its product."""
    made = drawing.program.steps_by_result.get(equation.unknown)
    if not isinstance(made, Calculate):
        return []
    values = [float(term.product_value(drawing.things, Arithmetic())) for term in made.terms]
    least = ZERO_MOMENT_RATIO * max(map(abs, values), default=0.0)
    steps = arm_steps_by_result(drawing)
    terms = [(name, arm, v) for (name, arm), v in zip(equation.terms, values, strict=False) if abs(v) > least]
    return [one for one in terms if one[1] not in steps or arm_length_mm(drawing, steps[one[1]]) > ZERO_ARM_MM]


def arm_length_mm(drawing: Drawing, step: Drop) -> float:
    """The measured length of an arm, mm."""
    return Arm.of_step(drawing, step).length


def arm_steps_by_result(drawing: Drawing) -> dict[str, Drop]:
    """The steps that measure arms, by their results."""
    return {s.makes: s for s in drawing.program.steps if isinstance(s, Drop)}


def line_with_break(start: complex, end: complex) -> list[Mark]:
    """A guide extended to a line of action too far for the paper: shortened by a break."""
    along = direction_between(start, end)
    middle = (start + end) / 2
    zigzag = [
        middle + z * along
        for z in (-HALF_BREAK_GAP_MM, complex(-0.3, 0.8) * HALF_BREAK_GAP_MM, complex(0.3, -0.8) * HALF_BREAK_GAP_MM)
    ]
    return [
        Line((start, zigzag[0]), "axis", "axis"),
        Line((*zigzag, middle + HALF_BREAK_GAP_MM * along), "thin", "axis"),
        Line((middle + HALF_BREAK_GAP_MM * along, end), "axis", "axis"),
    ]


def with_unseen_arm_names(named: Iterable[Label], short: Sequence[str], marks: Sequence[Mark], lang: Lang) -> Marks:
    """A figure with the names of the arms beneath it that have no room in it, or are too ``short`` to see."""
    there = {m.name for m in marks if isinstance(m, Text)}
    missing = [x.text for x in named if x.name.startswith(ARM_NAME_PREFIX) and x.name not in there]
    drawn = (*marks,)
    for key, names in (("arms_unlettered", missing), ("arms_short", short)):
        if names:
            drawn = (*drawn, *remark_texts(f"({say(key, lang, names=', '.join(dict.fromkeys(names)))})", drawn))
    return drawn
