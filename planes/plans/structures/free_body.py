"""One free body in equilibrium: its loads laid off on its force plan, and the three unknowns of its reactions found.

Its supports are a hinge and a line (of a roller, a rod, a rope), three lines, or a clamp. Two lines of action meet, and
a third force in equilibrium with both passes through that point; of four, the resultant of two passes through both
intersections (Culmann). Several loads are first reduced to their resultant, by a string polygon or by composition.
"""

from dataclasses import dataclass, field, replace

from planes.drafting.draft import Draft
from planes.drafting.equations import Equation, Term
from planes.drafting.steps.crossings import Cross
from planes.drafting.steps.reckoning import Product
from planes.plans.force.loads import Couple, Force
from planes.plans.position.bodies import SCHEME, on_scheme
from planes.plans.structures.figure import StaticsFigure
from planes.scene.structures import Support
from planes.words.frozen import frozen
from planes.words.names import POLE, Meaning, at, end_of, label_of

Chain = tuple[Term, ...]


@frozen
class Meeting(Cross):
    """Cross two lines of forces, or of strings."""

    far, same = "forces_parallel", "forces_on_one_line"


@dataclass
class FreeBody:
    """A body by its name with its forces; ``found`` are the end marks of each of its reactions."""

    draft: Draft
    figure: StaticsFigure
    name: str
    plan: str
    forces: list[Force]
    couples: list[Couple]
    supports: list[Support]
    found: dict[str, tuple[str, str]] = field(default_factory=dict)
    chain: Chain = ()

    @property
    def lines(self) -> list[Support]:
        """The supports with reactions of known line."""
        return [s for s in self.supports if s.held == 1]

    @property
    def anchor(self) -> Support | None:
        """The hinge or the clamp."""
        return next((s for s in self.supports if s.held > 1), None)

    def lay(self) -> str:
        """Lay off all loads one after another; returns the label at the end of the last."""
        self.draft.pole(self.plan)
        self.chain = ()
        for f in self.forces:
            self.append(f)
        return self.reached

    def append(self, force: Force) -> None:
        """Lay off one more known force."""
        f, end = force, end_of(force.name)
        self.chain += (Term(f.name, self.reached, end, f.size, f.along, self.action(f.along), means=f.means),)
        self.draft.lay(self.plan, self.chain[-1])

    @property
    def reached(self) -> str:
        """The label at the present end of the polygon."""
        return self.chain[-1].end if self.chain else POLE

    def action(self, along: str) -> str:
        """A line of action as written."""
        means = self.draft.steps[along].means
        return means.action if means else ""

    def along(self, s: Support) -> str:
        """The line of a reaction: the normal of a roller, a rod outwards from the body."""
        if s.to:
            return self.draft.ray(SCHEME, s.point, s.to)
        return self.draft.aim(f"∠{s.name}", s.normal_deg, Meaning("given", s.name))

    def spot(self, s: Support) -> str:
        """The place where a support holds the body."""
        return on_scheme(s.point)

    def seek(self, s: Support, start: str, end: str, along: str | None = None) -> Term:
        """A reaction with its line, or with no known data."""
        along = along or self.along(s)
        return Term(s.name, start, end, None, along, self.action(along))

    def meet(self, one: Support, other: Support, along: str) -> None:
        """From the end of the polygon the ``one`` reaction, then along its line the ``other`` back to the pole."""
        x, start = end_of(one.name), self.reached
        back = replace(self.seek(other, POLE, x, along), sign=-1)
        self.draft.meet(self.plan, self.chain, self.seek(one, start, x), back)
        self.found |= {one.name: (start, x), other.name: (x, POLE)}

    def close(self, s: Support) -> None:
        """The last reaction closes the polygon: its length and direction are measured."""
        self.draft.close(self.plan, self.chain, s.name, self.reached)
        self.found[s.name] = (self.reached, POLE)

    # moment equations

    def moments(self, about: str, unknown: str, arm: str = "") -> None:
        """The moments of all loads about a mark give one unknown: a force with its ``arm``, a couple without."""
        tail = ((arm, -1),) if arm else ()
        levers = [(f, self.arm(f.name, f.point, f.along, about)) for f in self.forces if f.point != about]
        terms = [(f.name, own, Product(-1.0, ((f.size, 1), (own, 1), *tail))) for f, own in levers]
        terms += [(c.name, "", Product(-1.0 * c.sign, ((c.value, 1), *tail))) for c in self.couples]
        self.draft.balance(unknown, about, (self.name,), terms, arm)

    def arm(self, name: str, point: str, along: str, about: str) -> str:
        """The arm of a force about a mark, drawn and measured on the scheme."""
        return self.draft.arm(name, point, along, about, self.name)

    def by_moments(self) -> None:
        """A clamp's couple, or the reaction of a support with a line, by moments; the rest closes the polygon."""
        self.lay()
        anchor, lines = self.anchor, self.lines
        if anchor is None:
            one, two, three = lines
            self.reckon(one, self.crossing(two, three))
            self.meet(two, three, self.along(three))
            return
        if anchor.kind == "clamp":
            self.moments(self.spot(anchor), f"M_{anchor.point}")
        else:
            self.reckon(lines[0], self.spot(anchor))
        self.close(anchor)

    def reckon(self, s: Support, about: str) -> None:
        """A reaction by the moments about a mark, laid off."""
        along = self.along(s)
        self.moments(about, s.name, self.arm(s.name, self.spot(s), along, about))
        start = self.reached
        self.append(Force(s.name, self.name, s.name, along, self.spot(s), "load"))
        self.found[s.name] = (start, self.reached)

    def crossing(self, one: Support, other: Support) -> str:
        """The intersection of the lines of two reactions on the scheme."""
        return self.cross("K", self.spot(one), self.along(one), self.spot(other), self.along(other))

    def fresh(self, label: str) -> str:
        """An unused mark of the scheme."""
        while on_scheme(label) in self.draft.steps:
            label += "′"
        return on_scheme(label)

    def cross(self, label: str, start: str, along: str, other: str, across: str) -> str:
        """A point of the scheme where two lines meet, both extended to it."""
        mark = self.draft.step(Meeting(self.fresh(label), start, along, other, across))
        self.figure.stroke(SCHEME, "action", "", start, mark)
        self.figure.stroke(SCHEME, "action", "", other, mark)
        self.figure.knots.append(mark)
        return mark

    # by lines of action

    def three_forces(self, point: str, along: str) -> None:
        """A load with a line, a support with a line, a hinge: the reaction of the hinge passes through the
        intersection."""
        anchor, (line,) = self.anchor, self.lines
        assert anchor
        mark = self.cross("K", point, along, self.spot(line), self.along(line))
        way = self.draft.ray(SCHEME, anchor.point, label_of(mark))
        self.figure.stroke(SCHEME, "action", "", self.spot(anchor), mark)
        self.meet(line, anchor, way)
        self.figure.said |= {mark: "meeting", at(self.plan, end_of(line.name)): "three_forces"}

    def culmann(self, point: str, along: str, order: tuple[Support, Support, Support]) -> None:
        """A load with a line and three supports with lines: the load meets one of them, the others meet, and the line
        through both intersections divides the polygon."""
        one, two, three = order
        k = self.cross("K", point, along, self.spot(one), self.along(one))
        m = self.cross("L", self.spot(two), self.along(two), self.spot(three), self.along(three))
        way = self.draft.ray(SCHEME, label_of(k), label_of(m))
        self.figure.stroke(SCHEME, "culmann", "", k, m)
        x, end = end_of(one.name), end_of(two.name)
        both = f"R_{''.join(dict.fromkeys(two.point + three.point))}"
        back = Term(both, POLE, x, None, way, self.action(way), sign=-1)
        self.draft.meet(self.plan, self.chain, self.seek(one, self.reached, x), back)
        parts = self.seek(two, x, end), self.seek(three, end, POLE)
        self.draft.draw(Equation(self.plan, ((Term(both, x, POLE, drawn=True),), parts)))
        self.figure.said |= {k: "meeting", m: "meeting", at(self.plan, x): "culmann"}
        self.found |= {one.name: (self.reached, x), two.name: (x, end), three.name: (end, POLE)}
