"""Arms of forces on a scheme: perpendiculars to their lines of action."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

from planes.drafting.drawing import Drawing
from planes.drafting.steps.reckoning import Drop
from planes.geometry.plane import direction_between, perpendicular_foot
from planes.words import Lang, say
from render.labels import Label
from render.paper.marks import Line, Mark, Text
from render.paper.symbols import Marks
from render.views import remark_texts

NAME_LETTER_MM = 3.5
LEAST_ARM_MM = 2.0  # of an arm
EQUAL_ARM_MM = 0.1  # arms that differ by less are equal
ARM_NAME_PREFIX = "arm "  # prefix of its label's name
HALF_BREAK_GAP_MM = 2.5  # half the gap of a break along its line


@dataclass
class Arms:
    """Arms with their lines of action; an arm shared by two forces is drawn once, with both names."""

    marks: list[Mark] = field(default_factory=list)
    named: list[Label] = field(default_factory=list)

    def add_arm(self, point: complex, along: complex, about: complex, text: str, force: str) -> None:
        """Add the arm about a place of the force at ``point``, unless it is too short to see."""
        ends = about, perpendicular_foot(about, point, along)
        if abs(ends[1] - about) < LEAST_ARM_MM:
            return
        self.marks.append(Line((point, ends[1]), "construction", "construction"))
        for k, other in enumerate(self.named):
            if isinstance(other.at, tuple) and all(
                abs(a - b) < EQUAL_ARM_MM for a, b in zip(other.at, ends, strict=True)
            ):
                if text not in other.text.split(" = "):
                    self.named[k] = replace(other, text=f"{other.text} = {text}")
                return
        self.marks.append(Line(ends, "thin", "dimension"))
        self.named.append(Label(text, ends, NAME_LETTER_MM, name=f"{ARM_NAME_PREFIX}{force}", told=True))


def arm_steps_by_result(drawing: Drawing) -> dict[str, Drop]:
    """The steps that measure arms, by their results."""
    return {s.makes: s for s in drawing.program.steps if isinstance(s, Drop)}


def line_with_break(start: complex, end: complex) -> list[Mark]:
    """A guide extended to a line of action too far for the paper: shortened by a break."""
    along, middle = direction_between(start, end), (start + end) / 2
    zigzag = [
        middle + z * along
        for z in (-HALF_BREAK_GAP_MM, complex(-0.3, 0.8) * HALF_BREAK_GAP_MM, complex(0.3, -0.8) * HALF_BREAK_GAP_MM)
    ]
    return [
        Line((start, zigzag[0]), "axis", "axis"),
        Line((*zigzag, middle + HALF_BREAK_GAP_MM * along), "thin", "axis"),
        Line((middle + HALF_BREAK_GAP_MM * along, end), "axis", "axis"),
    ]


def with_unplaced_arm_names(named: Iterable[Label], marks: Sequence[Mark], lang: Lang) -> Marks:
    """A figure with the names of the arms beneath it that have no room in it, and are in their equation."""
    there = {m.name for m in marks if isinstance(m, Text)}
    missing = [x.text for x in named if x.name.startswith(ARM_NAME_PREFIX) and x.name not in there]
    return (
        (*marks, *remark_texts(f"({say('arms_unlettered', lang, names=', '.join(missing))})", marks))
        if missing
        else (*marks,)
    )
