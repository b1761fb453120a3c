"""Transfer functions in the form of the manuals: analogues of velocities and ratios, by segments of the velocity
plan."""

from collections.abc import Collection, Iterator

from planes.drafting.steps.reckoning import Measure
from planes.lesson.reckoning import quotients_by_name
from planes.plans.quantities import Measured
from planes.plans.transfers import TRANSFER_PLAN, vector_giving_driver_rate
from planes.solving import Position
from planes.words import say
from planes.words.frozen import frozen
from planes.words.lettering import parameter_lettering
from planes.words.names import Mark
from planes.words.naming import Naming
from planes.words.read_off import read_off_text

ZERO_VECTOR_SHARE = 1e-9  # relative to the driver's: a smaller vector is rounding noise


@frozen
class TransferFunctions:
    """The ratios of a position's velocities to the driver's, from its plan: v_qC = pc·l_AB/pb, u_21 =
    bc·l_AB/(pb·l_BC).

    The program is followed backwards: ω₂ was calculated from a measured vector and a length.
    """

    position: Position
    naming: Naming

    def transfer_rows(self) -> Iterator[list[str]]:
        """Name, relation of segments, value and unit of each."""
        plans = self.position.plans
        transfers = self.position.of("transfers")
        drive = vector_giving_driver_rate(plans)
        if drive is None:
            return
        segment = self.segment_letters(drive.start, drive.end)
        times = f"·{parameter_lettering(drive.length)}" if drive.length else ""
        for alike, ends, arm in self.turning(transfers.values()):
            yield self.transfer_row(alike, f"{ends}{times}/({segment}·{parameter_lettering(arm)})")
        noise = ZERO_VECTOR_SHARE * (abs(self.position.drawing[drive.length]) if drive.length else 1.0)
        still = {marks.velocity for p, marks in plans.points.items() if p in plans.fixed_points}
        for one in transfers.values():
            column = one.quantity.columns[0]
            if column.part and column.end not in still:
                yield self.transfer_row(
                    [one], f"{self.segment_letters(column.start, column.end)}{times}/{segment}", noise
                )

    def transfer_row(self, alike: list[Measured], relation: str, noise: float = 0.0) -> list[str]:
        """A row of the table, for equal quantities; one below ``noise`` is zero."""
        name = " = ".join(self.naming.lettered_curve(f.quantity.name) for f in alike)
        unit = alike[0].unit
        value = alike[0].number
        shown = read_off_text(value if abs(value) > noise else 0.0, self.naming.lang)
        return [name, relation, shown, "" if unit == "1" else say(unit, self.naming.lang)]

    def turning(self, transfers: Collection[Measured]) -> Iterator[tuple[list[Measured], str, str]]:
        """Ratios of links whose angular velocity is measured on the plan, equal ones together, with the segment and the
        length for each."""
        program = self.position.drawing.program
        for rate, (vector, length) in quotients_by_name(program).items():
            alike = [f for f in transfers if f.quantity.columns[0].value == rate]
            if alike and isinstance(step := program.steps_by_result.get(vector), Measure):
                yield alike, self.segment_letters(step.start, step.end), length

    def segment_letters(self, start: Mark, end: Mark) -> str:
        """The letters of a segment of the plan."""
        return "".join(self.naming.mark(x.label, TRANSFER_PLAN) for x in (start, end))
