"""Two bodies with a common hinge, each on a hinge of the ground: neither can be solved by itself. The reaction of each
across the line of its two hinges comes from moments about the common one; along these lines both reactions meet in one
polygon."""

from dataclasses import dataclass, replace

from planes.drafting.equations import Equation, Term
from planes.plans.force.loads import Force
from planes.plans.structures.free_body import FreeBody
from planes.scene.structures import Support
from planes.words.names import POLE_LABEL, NamePair, scheme_mark, vector_end_label


@dataclass
class Arch:
    """Both bodies, the ``first`` and the ``last``, on one plan; their common hinge is the support ``crown``."""

    first: FreeBody
    last: FreeBody
    crown: Support

    def draw_arch_plan(self) -> dict[str, NamePair]:
        """The plan; returns the end marks of every reaction, that of the crown on the last body."""
        one = self.first
        two = self.last
        d = one.draft
        plan = one.plan
        (a, across), (b, other) = map(self.springing_and_cross_component, (one, two))
        both = replace(one, forces=[across, *one.forces, *two.forces, other], chain=())
        both.lay_off_loads()
        start = both.chain[0].end
        parted = both.chain[len(one.forces)].end
        end = both.chain[-1].start
        x = vector_end_label(f"{b.name}^n")
        last = Term(f"{b.name}^n", both.reached, x, None, self.line_of_both_hinges(b), f"∥{b.point}{self.crown.point}")
        back = Term(
            f"{a.name}^n", POLE_LABEL, x, None, self.line_of_both_hinges(a), f"∥{a.point}{self.crown.point}", sign=-1
        )
        d.lay_off_until_meeting(plan, both.chain, last, back)
        d.name_segment(plan, x, start, a.name)
        d.name_segment(plan, end, x, b.name)
        own = tuple(t for t in both.chain if t.name in {f.name for f in two.forces})
        crown_reaction = Term(b.name, end, x, drawn=True)
        d.measure_equation_results(Equation(plan, ((*own, crown_reaction, Term(self.crown.name, x, parted)), ())))
        return {a.name: (x, start), b.name: (end, x), self.crown.name: (x, parted)}

    def line_of_both_hinges(self, s: Support) -> str:
        """The line of a body's two hinges."""
        return self.first.draft.direction_between_marks(s.point, self.crown.point)

    def springing_and_cross_component(self, body: FreeBody) -> tuple[Support, Force]:
        """A body's hinge on the ground, and the component of its reaction across the line of both hinges."""
        s = next(s for s in body.supports if s.unknown_count == 2 and s.point != self.crown.point)
        name = f"{s.name}^t"
        along = body.draft.draw_perpendicular(self.line_of_both_hinges(s))
        spot = body.place_of_support(s)
        crown = scheme_mark(self.crown.point)
        body.unknown_by_moments(crown, name, body.arm_about_mark(name, spot, along, crown))
        return s, Force(name, body.name, name, along, spot, "tangential")
