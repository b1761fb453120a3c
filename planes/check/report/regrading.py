"""A grading for a page: the miss of each mark as a tape of plain arithmetic, rerun whenever a mark is moved.

The steps are drawn once with the numbers of a tape, as a person draws them: a mark that was read is looked up, and
every drawing, ruler and reading error is a separate source. So a reader of the tape needs no mechanics: values give the
misses, slopes with respect to the sources their tolerances.
"""

import math
from collections.abc import Container, Iterable
from dataclasses import dataclass

from planes.batch.plain_tape import PlainRecording, export_operations
from planes.batch.symbols import Num, Vec, place_of_number
from planes.batch.tape import Tape
from planes.batch.tracing import Source, TracingTool
from planes.check.grading.grading import Grading
from planes.check.grading.handwork import Person
from planes.check.grading.variants import Variant
from planes.drafting.drawing import draw_steps
from planes.drafting.steps import Same
from planes.drafting.tools import Env
from planes.geometry.arithmetic import Truth
from planes.words.names import Mark
from planes.words.records import Json

TapePair = tuple[int, int]
Places = dict[Mark, TapePair]  # positions on a tape of x and y of each mark's miss
SCREEN_MARK_ERROR_MM = 0.2  # accuracy of placing a mark on the screen


@dataclass
class _TapeHand(Person, TracingTool):
    """A person at work on a tape; marks that may be read later are looked up only if they are."""

    late: Container[str] = ()

    def source(self, size: float) -> Num:
        """A new error."""
        place = self.tape.record_leaf("source", len(self.sources))
        self.sources.append(Source(place, size))
        return Num(self.tape, place)

    def is_read(self, mark: Mark) -> Truth:
        """Whether a mark is a person's own: known now, or by a number of the tape."""
        if mark in self.late:
            return Num(self.tape, self.tape.record_leaf("given", f"{mark}?")) > 0.5
        return super().is_read(mark)


class _Desk:
    """Draws a person's program on a tape."""

    def __init__(self, grading: Grading) -> None:
        hand = grading.hand
        skill = hand.tool.skill
        self.errors = (skill.point_mm, math.radians(skill.ray_deg), skill.ruler_mm)
        late = [m for m in grading.marks if m not in hand.taken]
        self.program = hand.program
        self.taken = hand.taken
        self.tape = Tape()
        self.tool = _TapeHand(
            PlainRecording(), True, tape=self.tape, errors=self.errors, late=late, plans=12, settled=1e-5
        )
        self.own = {
            mark: self._read_mark_position(mark) for mark in (*hand.taken, *late) if mark in hand.program.result_names
        }
        self.tool.own = self.own
        self.tool.values = hand.given
        self.things: Env = dict(hand.given)
        for name, share in hand.unsure.items():
            self.things[name] = self.things[name] * (1 + self.tool.source(share))
        self.made = draw_steps(self.program.steps, self.things, self.tool)

    def _read_mark_position(self, mark: Mark) -> Vec:
        """The position of a read mark, with its reading error."""
        error = self.taken[mark].error_mm if mark in self.taken else SCREEN_MARK_ERROR_MM
        if isinstance(self.program.steps_by_result[mark], Same):
            error = max(error, self.errors[0])
        x, y = (
            Num(self.tape, self.tape.record_leaf("given", f"{mark}.{axis}")) + self.tool.source(error) for axis in "xy"
        )
        return Vec(x, y)

    def miss_tape_positions(self, marks: Iterable[Mark], variant: Variant | None = None) -> Places:
        """The positions on the tape of each mark's miss, from the original steps or those affected by a mistake."""
        made = variant.draw_affected_steps(self.program, self.things, self.tool, self.taken) if variant else self.made
        off = {m: self.own[m] - made[m] for m in marks if m in made}
        return {m: (place_of_number(self.tape, z.real), place_of_number(self.tape, z.imag)) for m, z in off.items()}


def grading_tape(grading: Grading, variants: Iterable[Variant]) -> tuple[Json, list[Places]]:
    """The grading as a tape (plain data), with every mistake as another path to the marks it affects; and positions.

    Positions on the tape are given for the plan itself, then for each mistake. Unused numbers are dropped, and the
    positions renumbered.
    """
    desk = _Desk(grading)
    misses_by_way = [desk.miss_tape_positions(grading.marks, way) for way in (None, *variants)]
    wanted = [place for one in misses_by_way for pair in one.values() for place in pair]
    exported_tape, new = export_operations(desk.tape, wanted, desk.tool.sources)
    places = [{m: (new[x], new[y]) for m, (x, y) in one.items()} for one in misses_by_way]
    return exported_tape, places
