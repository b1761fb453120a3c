"""Instantaneous centres of all pairs of links, by the theorem of three centres (Aronhold and Kennedy).

The three centres of links i, j and k are collinear. So the centre of i and j is the crossing of two such lines, by two
other links; a line to a centre at infinity, of a slider and its guide, has the direction of that centre. The steps come
after the velocity plan in the program. No polygon is read for them, but two checks use its angular velocities.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import combinations

from planes.drafting.draft import Draft
from planes.drafting.program import Program
from planes.drafting.steps import Same
from planes.drafting.steps.apart import CrossApart, ThroughApart
from planes.plans.centres import Centre, CentreLine, Check, instant_centre_name
from planes.plans.record import Plans
from planes.scene.mechanism import FRAME
from planes.words.names import NO_MARK, Mark, Meaning, NamePair, NameTuple, scheme_mark


@dataclass
class Centres:
    """Finds the centres of a mechanism, and adds them to the drawing."""

    plans: Plans
    draft: Draft
    found: dict[frozenset[str], Centre] = field(default_factory=dict)

    @cached_property
    def links(self) -> NameTuple:
        """The frame and the links that have pairs."""
        pairs = self.plans.structure.pairs
        return (FRAME, *(x for x in self.plans.mechanism.links if any(p.has_link(x) for p in pairs)))

    def draw_centres(self) -> None:
        """Draw those of pairs, then the crossings of two lines, until no more are found."""
        self.record_centres_of_pairs()
        before = -1
        while before < len(self.found):
            before = len(self.found)
            for i, j in combinations(self.links, 2):
                if frozenset((i, j)) not in self.found:
                    self.find_centre_by_lines(i, j)

    def record_centres_of_pairs(self) -> None:
        """The hinges, and sliders' centres at infinity across their guides."""
        for pair in self.plans.structure.pairs:
            links = self.links.index(pair.other), self.links.index(pair.link)
            i, j = (self.links[k] for k in sorted(links))
            if pair.kind == "R":
                self.record_centre(i, j, point=pair.point)
            elif f"∥{pair.guide}" in self.draft.steps:
                self.record_centre(i, j, self.draft.draw_perpendicular(f"∥{pair.guide}"))

    def record_centre(
        self, i: str, j: str, along: str = "", lines: tuple[CentreLine, ...] = (), point: str = ""
    ) -> None:
        """Record a centre: at an existing hinge, at infinity, or where its lines cross."""
        name = instant_centre_name(i, j, self.plans.mechanism.frame_number)
        mark = scheme_mark(name)
        means = Meaning("centre", i, j)
        if point:
            self.draft.add_step(Same(mark, scheme_mark(point), means=means))
        elif not along:
            one, two = lines
            self.draft.add_step(CrossApart(mark, one.mark, one.along, two.mark, two.along, means=means))
        self.found[frozenset((i, j))] = Centre((i, j), name, NO_MARK if along else mark, along, lines, point)

    def find_centre_by_lines(self, i: str, j: str) -> None:
        """The centre of two links from the known ones, if they determine it."""
        between = [(k, self.found.get(frozenset((i, k))), self.found.get(frozenset((k, j)))) for k in self.links]
        ways = [(k, one, two) for k, one, two in between if one and two]
        for _, one, two in ways:
            if one.point and one.point == two.point:
                self.record_centre(i, j, point=one.point)
                return
        lines = dict[NameTuple, CentreLine]()
        far = False
        for k, one, two in ways:
            if one.along and two.along:
                far = True
            else:
                line = self.line_of_three_centres(k, one, two)
                lines.setdefault(tuple(sorted((line.mark, line.other or line.along))), line)
        first, *more = [*lines.values(), None]
        if first and (far or more[0]):
            self.record_centre(i, j, *((first.along, (first,)) if far else ("", (first, *filter(None, more[:1])))))

    def line_of_three_centres(self, third: str, one: Centre, two: Centre) -> CentreLine:
        """The line of three centres by two of them, not both at infinity."""
        if one.along or two.along:
            return CentreLine(third, one.mark or two.mark, one.along or two.along)
        along = ThroughApart(f"{one.name}{two.name}", one.mark, two.mark, means=Meaning("along", one.name, two.name))
        return CentreLine(third, one.mark, self.draft.add_step(along), two.mark)

    def velocity_checks_by_centres(self) -> Iterator[Check]:
        """For every centre not known at once, the velocities of its links by it."""
        for c in (c for c in list(self.found.values()) if c.mark and c.lines):
            if c.links[0] == FRAME:
                for point in self.moving_points_of_link(c.links[1]):
                    own = self.spin_and_centre_distance(c.links[1], point, scheme_mark(point))
                    yield from [Check(f"v_{point}", c, (own,), True)] if own else []
                continue
            turning = [s for s in (self.spin_and_centre_distance(x, c.name, c.mark) for x in c.links) if s]
            sliding = [
                (p, x) for x in c.links if self.centre_with_frame(x).along for p in self.moving_points_of_link(x)
            ]
            if len(turning) == 2:
                yield Check(f"v_{c.name.replace('_', '')}", c, (turning[0], turning[1]))
            elif turning and sliding:
                point, link = sliding[0]
                yield Check(f"v_{point}", c, (turning[0],), True, link)

    def centre_with_frame(self, link: str) -> Centre:
        """The centre of a link and the frame."""
        return self.found.get(frozenset((FRAME, link)), Centre((FRAME, link), ""))

    def moving_points_of_link(self, link: str) -> list[str]:
        """A point of a link with a measured velocity, if there is one."""
        shown = {s.name for s in self.plans.segments if s.plan == "velocity"}
        own = (p for p in self.plans.mechanism.links[link].points if p not in self.plans.fixed_points)
        return [p for p in own if f"v_{p}" in shown and scheme_mark(p) in self.draft.steps][:1]

    def spin_and_centre_distance(self, link: str, label: str, mark: Mark) -> NamePair | None:
        """ω of a turning link and the distance of a mark from its centre with the frame, where that is a mark."""
        omega = self.plans.links[link].omega
        pole = self.centre_with_frame(link)
        if not omega or not pole.mark:
            return None
        ends = f"{pole.name}{label}".replace("_", "")
        return omega, self.draft.measure_segment(f"l_{ends}", pole.mark, mark)


def plans_with_instant_centres(plans: Plans) -> Plans:
    """The plans with the instantaneous centres of their links and the checks by them; unchanged where there is no
    velocity plan, or nothing moves."""
    if not plans.has_mechanism or "velocity" not in plans.plan_names or plans.at_rest or not plans.acting.motion:
        return plans
    draft = plans.acting.motion.bodies.draft.copy_for_trial()
    before = {*draft.steps}
    centres = Centres(plans, draft)
    centres.draw_centres()
    checks = tuple(centres.velocity_checks_by_centres())
    new = [s for name, s in draft.steps.items() if name not in before]
    reads = {name for s in new for name, _ in s.input_names()}
    steps = plans.program.steps
    last = max(k for k, s in enumerate(steps) if s.makes in reads or s.plan == "velocity")
    program = Program((*steps[: last + 1], *new, *steps[last + 1 :]), plans.program.proofs)
    means = {**plans.means, **{s.makes: s.means for s in new if s.means}}
    return replace(plans, program=program, means=means, centres=tuple(centres.found.values()), checks=checks)
