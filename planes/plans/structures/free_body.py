"""One free body in equilibrium: its loads laid off on its force plan, and the three unknowns of its reactions found.

Its supports are a hinge and a line (of a roller, a rod, a rope), three lines, or a clamp. Two lines of action meet, and
a third force in equilibrium with both passes through that point; of four, the resultant of two passes through both
intersections (Culmann). Several loads are first reduced to their resultant, by a string polygon or by composition.
"""

from dataclasses import dataclass, field, replace

from planes.drafting.draft import Draft
from planes.drafting.equations import Chain, Equation, Term
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Product
from planes.plans.force.loads import Couple, Force
from planes.plans.structures.figure import StaticsFigure
from planes.scene.structures import Support
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Mark, Meaning, NamePair, PlanId, scheme_mark, vector_end_label


@frozen
class Meeting(Cross):
    """Cross two lines of forces, or of strings."""

    far = "forces_parallel"
    same = "forces_on_one_line"


@dataclass
class FreeBody:
    """A body by its name with its forces; ``found`` are the end marks of each of its reactions."""

    draft: Draft
    figure: StaticsFigure
    name: str
    plan: PlanId
    forces: list[Force]
    couples: list[Couple]
    supports: list[Support]
    found: dict[str, NamePair] = field(default_factory=dict)
    chain: Chain = ()

    @property
    def supports_with_known_lines(self) -> list[Support]:
        """The supports with reactions of known line."""
        return [s for s in self.supports if s.unknown_count == 1]

    @property
    def hinge_or_clamp(self) -> Support | None:
        """The hinge or the clamp."""
        return next((s for s in self.supports if s.unknown_count > 1), None)

    def lay_off_loads(self) -> str:
        """Lay off all loads one after another; returns the label at the end of the last."""
        self.draft.draw_pole(self.plan)
        self.chain = ()
        for f in self.forces:
            self.append_force(f)
        return self.reached

    def append_force(self, force: Force) -> None:
        """Lay off one more known force."""
        end = vector_end_label(force.name)
        self.chain += (
            Term(
                force.name,
                self.reached,
                end,
                force.size,
                force.along,
                self.line_of_action_text(force.along),
                means=force.meaning_of_mark,
            ),
        )
        self.draft.lay_off_known_vector(self.plan, self.chain[-1])

    @property
    def reached(self) -> str:
        """The label at the present end of the polygon."""
        return self.chain[-1].end if self.chain else POLE_LABEL

    def line_of_action_text(self, along: str) -> str:
        """A line of action as written."""
        means = self.draft.steps[along].means
        return means.written_action if means else ""

    def reaction_line(self, s: Support) -> str:
        """The line of a reaction: the normal of a roller, a rod outwards from the body."""
        if s.to:
            return self.draft.direction_between_marks(s.point, s.to)
        return self.draft.draw_direction_at_angle(f"∠{s.name}", s.normal_deg, Meaning("given", s.name))

    def place_of_support(self, s: Support) -> Mark:
        """The place where a support holds the body."""
        return scheme_mark(s.point)

    def unknown_reaction_term(self, s: Support, start: str, end: str, along: str | None = None) -> Term:
        """A reaction with its line, or with no known data."""
        along = along or self.reaction_line(s)
        return Term(s.name, start, end, None, along, self.line_of_action_text(along))

    def cross_two_reactions(self, one: Support, other: Support, along: str) -> None:
        """From the end of the polygon the ``one`` reaction, then along its line the ``other`` back to the pole."""
        x = vector_end_label(one.name)
        start = self.reached
        back = replace(self.unknown_reaction_term(other, POLE_LABEL, x, along), sign=-1)
        self.draft.lay_off_until_meeting(self.plan, self.chain, self.unknown_reaction_term(one, start, x), back)
        self.found |= {one.name: (start, x), other.name: (x, POLE_LABEL)}

    def close_with_last_reaction(self, s: Support) -> None:
        """The last reaction closes the polygon: its length and direction are measured."""
        self.draft.draw_closing_vector(self.plan, self.chain, s.name, self.reached)
        self.found[s.name] = (self.reached, POLE_LABEL)

    # moment equations

    def unknown_by_moments(self, about: Mark, unknown: str, arm: str = "") -> None:
        """The moments of all loads about a mark give one unknown: a force with its ``arm``, a couple without."""
        tail = ((arm, -1),) if arm else ()
        levers = [(f, self.arm_about_mark(f.name, f.point, f.along, about)) for f in self.forces if f.point != about]
        terms = [(f.name, own, Product(-1.0, ((f.size, 1), (own, 1), *tail))) for f, own in levers]
        terms += [(c.name, "", Product(-1.0 * c.sign, ((c.value, 1), *tail))) for c in self.couples]
        self.draft.solve_moment_equation(unknown, about, (self.name,), terms, arm)

    def arm_about_mark(self, name: str, point: Mark, along: str, about: Mark) -> str:
        """The arm of a force about a mark, drawn and measured on the scheme."""
        return self.draft.draw_arm(name, point, along, about, self.name)

    def solve_reactions_by_moments(self) -> None:
        """A clamp's couple, or the reaction of a support with a line, by moments; the rest closes the polygon."""
        self.lay_off_loads()
        anchor = self.hinge_or_clamp
        lines = self.supports_with_known_lines
        if anchor is None:
            one, two, three = lines
            self.reaction_by_moments(one, self.crossing_of_reaction_lines(two, three))
            self.cross_two_reactions(two, three, self.reaction_line(three))
            return
        if anchor.kind == "clamp":
            self.unknown_by_moments(self.place_of_support(anchor), f"M_{anchor.point}")
        else:
            self.reaction_by_moments(lines[0], self.place_of_support(anchor))
        self.close_with_last_reaction(anchor)

    def reaction_by_moments(self, s: Support, about: Mark) -> None:
        """A reaction by the moments about a mark, laid off."""
        along = self.reaction_line(s)
        self.unknown_by_moments(about, s.name, self.arm_about_mark(s.name, self.place_of_support(s), along, about))
        start = self.reached
        self.append_force(Force(s.name, self.name, s.name, along, self.place_of_support(s), "load"))
        self.found[s.name] = (start, self.reached)

    def crossing_of_reaction_lines(self, one: Support, other: Support) -> Mark:
        """The intersection of the lines of two reactions on the scheme."""
        return self.crossing_of_lines(
            "K",
            self.place_of_support(one),
            self.reaction_line(one),
            self.place_of_support(other),
            self.reaction_line(other),
        )

    def unused_mark(self, label: str) -> Mark:
        """An unused mark of the scheme."""
        while scheme_mark(label) in self.draft.steps:
            label += "′"
        return scheme_mark(label)

    def crossing_of_lines(self, label: str, start: Mark, along: str, other: Mark, across: str) -> Mark:
        """A point of the scheme where two lines meet, both extended to it."""
        mark = self.draft.draw_mark(Meeting(self.unused_mark(label), start, along, other, across))
        self.figure.add_line(SCHEME_PLAN, "action", "", start, mark)
        self.figure.add_line(SCHEME_PLAN, "action", "", other, mark)
        self.figure.knots.append(mark)
        return mark

    # by lines of action

    def solve_by_three_forces(self, point: Mark, along: str) -> None:
        """A load with a line, a support with a line, a hinge: the reaction of the hinge passes through the
        intersection."""
        anchor = self.hinge_or_clamp
        (line,) = self.supports_with_known_lines
        assert anchor
        mark = self.crossing_of_lines("K", point, along, self.place_of_support(line), self.reaction_line(line))
        way = self.draft.direction_between_marks(anchor.point, mark.label)
        self.figure.add_line(SCHEME_PLAN, "action", "", self.place_of_support(anchor), mark)
        self.cross_two_reactions(line, anchor, way)
        self.figure.said |= {mark: "meeting", self.plan.mark(vector_end_label(line.name)): "three_forces"}

    def solve_by_culmann(self, point: Mark, along: str, order: tuple[Support, Support, Support]) -> None:
        """A load with a line and three supports with lines: the load meets one of them, the others meet, and the line
        through both intersections divides the polygon."""
        one, two, three = order
        k = self.crossing_of_lines("K", point, along, self.place_of_support(one), self.reaction_line(one))
        m = self.crossing_of_lines(
            "L",
            self.place_of_support(two),
            self.reaction_line(two),
            self.place_of_support(three),
            self.reaction_line(three),
        )
        way = self.draft.direction_between_marks(k.label, m.label)
        self.figure.add_line(SCHEME_PLAN, "culmann", "", k, m)
        x = vector_end_label(one.name)
        end = vector_end_label(two.name)
        both = f"R_{''.join(dict.fromkeys(two.point + three.point))}"
        back = Term(both, POLE_LABEL, x, None, way, self.line_of_action_text(way), sign=-1)
        self.draft.lay_off_until_meeting(self.plan, self.chain, self.unknown_reaction_term(one, self.reached, x), back)
        parts = self.unknown_reaction_term(two, x, end), self.unknown_reaction_term(three, end, POLE_LABEL)
        self.draft.draw_equation(Equation(self.plan, ((Term(both, x, POLE_LABEL, drawn=True),), parts)))
        self.figure.said |= {k: "meeting", m: "meeting", self.plan.mark(x): "culmann"}
        self.found |= {one.name: (self.reached, x), two.name: (x, end), three.name: (end, POLE_LABEL)}
