"""Transfer functions as the manuals ask for them: analogues of velocities and ratios, each by segments of the velocity
plan."""

from collections.abc import Iterator
from dataclasses import dataclass

from planes.diagrams.curves import analogue_units, ratio_name
from planes.drafting.steps.reckoning import Measure
from planes.lesson.reckoned import Reckoned
from planes.words import say
from planes.words.lettering import Naming, greek, lettered_curve
from planes.words.names import POLE, label_of
from planes.words.read_off import measured

PLAN = "velocity"
NOISE_MM = 1e-7  # a shorter vector is rounding noise


@dataclass(frozen=True)
class TransferFunctions(Reckoned):
    """What the velocities of a position are to the driver's, from its plan: v_qC = pc·l_AB/pb,
    u_21 = bc·l_AB/(pb·l_BC).

    The program is read backwards: ω₂ was calculated from a measured vector and a length, the driver's vector from ω₁
    and another.
    """

    naming: Naming

    def rows(self) -> Iterator[list[str]]:
        """Name, relation of segments, value and unit of each."""
        drive, found = self.position.plans.mechanism.drive, self.driver()
        if found is None or not drive.velocity:
            return
        (segment, length), units = found, analogue_units(drive.kind == "phi")
        times = f"·{greek(length)}" if length else ""
        for links, ends, arm in self.turning():
            names = [lettered_curve(ratio_name(self.position.plans, link), self.naming) for link in links]
            value = self.position.results["links"][links[0]]["omega"] / drive.velocity
            yield self.row(" = ".join(names), f"{ends}{times}/({segment}·{greek(arm)})", value, units["omega"])
        for vector, s, size in self.position.measured_on(PLAN):
            ends, value = self.ends(s.start, s.end), size["value"] if size["mm"] > NOISE_MM else 0.0
            if s.start == POLE != s.end and ends != segment:
                name = lettered_curve(f"vq{vector[1:]}", self.naming)
                yield self.row(name, f"{ends}{times}/{segment}", value / abs(drive.velocity), units["v"])

    def row(self, name: str, relation: str, value: float, key: str) -> list[str]:
        """A row of the table."""
        said = "" if key == "1" else say(key, self.naming.lang)
        return [name, relation, measured(value, self.naming.lang), said]

    def driver(self) -> tuple[str, str] | None:
        """The segment of the driver's own vector, and the length it turns at, if it turns."""
        drive = self.position.plans.mechanism.drive
        if drive.kind == "s":
            return self.ends(*self.position.plans.velocity_slides[drive.link].ends), ""
        swung = ((name, length) for name, (rate, length) in self.products(1).items() if rate == f"omega_{drive.link}")
        for name, length in swung:
            for s in (s for s in self.position.plans.segments_of[PLAN] if s.name == name and s.start == POLE):
                return self.ends(s.start, s.end), length
        return None

    def turning(self) -> Iterator[tuple[list[str], str, str]]:
        """Links whose angular velocity is read off the plan, those that turn alike together, with the segment and the
        length it is found by."""
        links = self.position.plans.links
        for rate, (vector, length) in self.products(-1).items():
            alike = [link for link, names in links.items() if names.omega == rate]
            if alike and isinstance(step := self.steps.get(vector), Measure):
                yield alike, self.ends(step.start, step.end), length

    def ends(self, start: str, end: str) -> str:
        """The letters of a segment of the plan."""
        return "".join(self.naming.mark(label_of(x), PLAN) for x in (start, end))
