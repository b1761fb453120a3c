"""The only compiler: vector equations, and the steps between them, into a program.

A :class:`Draft` adds steps in the order in which a draughtsman draws. Each method returns the name of its result;
asking twice for the same direction makes one step.
"""

from collections.abc import Iterable, Mapping, Sequence
from copy import copy

from planes.drafting.dimensions import Dimension
from planes.drafting.equations import Chain, Equation, Moments, MomentTerms, Term
from planes.drafting.steps import Aim, LayOff, MarkStep, Put, Step, Through, Turn
from planes.drafting.steps.crossings import Cross, CrossArc, CrossArcs
from planes.drafting.steps.reckoning import Calculate, Drop, Measure, Product
from planes.drafting.tools import Env, Thing
from planes.scene.mechanism import Law
from planes.words import Phrase
from planes.words.errors import ProgramError
from planes.words.frozen import frozen, replace
from planes.words.lettering import name_in_words, plan_phrase
from planes.words.names import (
    POLE_LABEL,
    REPEATED_DIRECTION_SUFFIX,
    SCHEME_PLAN,
    Mark,
    MarkPair,
    Meaning,
    NamePair,
    NameTuple,
    PlanId,
    Quantity,
)

_REVERSED_QUANTITIES: Mapping[Quantity, Quantity] = {"with": "against", "against": "with"}
_PREFIXES_READ_BY_NAME = ("v_", "vq_", "omega", "epsilon")  # values that other modules find by name


@frozen
class Segment:
    """A segment of a plan that measures a quantity: from label ``start`` to ``end``, with a name such as "v_CB"."""

    plan: PlanId
    start: str
    end: str
    name: str

    @property
    def ends(self) -> MarkPair:
        """The full names of its end marks."""
        return self.plan.marks(self.start, self.end)


class Draft:
    """A program under construction, with its givens, equations, moment equations and measured segments."""

    def __init__(self) -> None:
        self.steps: dict[str, Step] = {}
        self.given: Env = {}
        self.means: dict[str, Meaning] = {}  # of givens and vectors
        self.reckoned: dict[str, Dimension] = {}  # givens that change with the links' dimensions
        self.equations: list[Equation] = []
        self.moments: list[Moments] = []
        self.segments: list[Segment] = []
        self.laws: dict[str, Law] = {}  # givens valid only at the drive's position in the file
        self.rays: dict[NamePair, str] = {}  # directions between labels of the scheme

    def copy_for_trial(self) -> "Draft":
        """A copy of this draft that can be continued without changing it."""
        other = copy(self)
        vars(other).update({name: copy(kept) for name, kept in vars(self).items()})
        return other

    def add_given(self, name: str, value: Thing, means: Meaning | None = None) -> str:
        """State a given value (SI, degrees, ±1) or place (complex, m); a name already in use gets a prime."""
        while name in self.steps or name in self.reckoned or self.given.setdefault(name, value) != value:
            name += "′"
        if means:
            self.means.setdefault(name, means)
        return name

    def add_computed_given(self, name: str, dimension: Dimension, means: Meaning | None = None) -> str:
        """State a given computed from the dimensions of links; an equal one is reused."""
        while name in self.given and (name not in self.reckoned or self.reckoned[name].of != dimension.of):
            name += "′"
        if name not in self.reckoned:
            name = self.add_given(name, dimension.value, means)
            self.reckoned[name] = dimension
        return name

    def record_law(self, name: str, law: Law | None) -> None:
        """Record that a given or a direction is valid only at the drive's position in the file."""
        if law:
            self.laws[name] = law

    def add_step(self, step: Step) -> str:
        """Add a step unless it exists; a direction or value named by another one is recorded."""
        while step.makes in self.given or self.steps.setdefault(step.makes, step) != step:
            if step.plan or step.makes.startswith(_PREFIXES_READ_BY_NAME):
                mark = name_in_words(step.makes)
                plan = step.plan
                name = Phrase("mark_of_plan", mark=mark, plan=plan_phrase(plan)) if plan else mark
                raise ProgramError(Phrase("named_twice", name=name))
            step = replace(step, makes=step.makes + (REPEATED_DIRECTION_SUFFIX if step.kind == "direction" else "′"))
        return step.makes

    def draw_mark(self, step: MarkStep) -> Mark:
        """Add a step that draws a mark, once; returns the mark."""
        self.add_step(step)
        return step.makes

    def direction_between_marks(self, one: str, two: str) -> str:
        """The direction from one mark of the scheme to another, as first drawn."""
        if (one, two) not in self.rays:
            means = Meaning("along", one, two)
            self.rays[one, two] = self.draw_direction_through_marks(f"{one}{two}", *SCHEME_PLAN.marks(one, two), means)
        return self.rays[one, two]

    def draw_pole(self, plan: PlanId) -> Mark:
        """The pole of a plan."""
        return self.draw_mark(Put(plan.pole))

    def draw_given_mark(self, plan: PlanId, label: str, place: complex, means: Meaning | None = None) -> Mark:
        """A mark at a given place of the scheme (m)."""
        given = self.add_given(f"place_{label}", place, Meaning("place", label))
        return self.draw_mark(Put(plan.mark(label), given, plan.mu_name, means=means))

    def draw_direction_at_angle(
        self, name: str, angle_deg: float | Dimension, means: Meaning | None = None, given: Meaning | None = None
    ) -> str:
        """A direction at an angle, which may itself be ``given`` under a name."""
        return self.add_step(Aim(name, self._angle_name(name, angle_deg, given), means=means))

    def draw_direction_through_marks(self, name: str, start: Mark, end: Mark, means: Meaning | None = None) -> str:
        """The direction from mark to mark."""
        return self.add_step(Through(name, start, end, means=means))

    def draw_perpendicular(self, line_name: str) -> str:
        """A direction turned by a right angle with the set square."""
        line = self.steps[line_name].means
        return self.add_step(Turn(f"⊥{line_name}", line_name, 1, means=line and replace(line, quantity="across")))

    def draw_turned_direction(
        self, name: str, line_name: str, angle_deg: float | Dimension, means: Meaning, given: Meaning | None = None
    ) -> str:
        """A direction turned by an angle, which may itself be ``given`` under a name."""
        return self.add_step(Turn(name, line_name, 0, self._angle_name(name, angle_deg, given), means=means))

    def _angle_name(self, name: str, angle: float | Dimension, means: Meaning | None) -> str:
        given = f"angle_{name}"
        if isinstance(angle, Dimension):
            return self.add_computed_given(given, angle, means)
        return self.add_given(given, angle, means)

    def lay_off(
        self, plan: PlanId, label: str, start: Mark, along: str, length: str, means: Meaning | None = None
    ) -> Mark:
        """Lay off a length (SI value by name) from a mark."""
        return self.draw_mark(LayOff(plan.mark(label), start, along, length, plan.mu_name, means=means))

    def measure_segment(self, name: str, start: Mark, end: Mark, along: str | None = None) -> str:
        """Measure a segment on its plan, in SI."""
        return self.add_step(Measure(name, start, end, along, start.plan.mu_name))

    def add_product(self, name: str, coefficient: float = 1.0, **factors: int) -> str:
        """One product of powers of values, e.g. v²/l."""
        return self.add_sum(name, [Product(coefficient, tuple(factors.items()))])

    def add_sum(self, name: str, terms: list[Product], means: Meaning | None = None) -> str:
        """A sum of products."""
        return self.add_step(Calculate(name, tuple(terms), means=means))

    def draw_arm(self, force: str, point: Mark, along: str, about: Mark, link: str = "", name: str = "") -> str:
        """The arm of a force at one mark about another: the perpendicular, drawn and measured."""
        means = Meaning("arm", force, about, link)
        name = name or f"h_{force}_{about.label}"
        return self.add_step(Drop(name, point, along, about, point.plan.mu_name, means=means))

    def solve_moment_equation(
        self,
        unknown: str,
        about: Mark,
        links: NameTuple,
        terms: MomentTerms,
        arm: str = "",
        means: Meaning | None = None,
    ) -> str:
        """Solve the moment equation about a mark for one unknown: a force with its ``arm``, or a couple without."""
        value = self.add_sum(unknown, [product for _, _, product in terms], means)
        shown = tuple((name, lever) for name, lever, _ in terms)
        self.moments.append(Moments(about.label, links, shown, value, arm))
        return value

    def direction_back_between_marks(self, one: str, two: str) -> str:
        """The direction from the second of two marks of the scheme to the first."""
        return self.add_step(
            Turn(f"{two}→{one}", self.direction_between_marks(one, two), 2, means=Meaning("towards", two, one))
        )

    def name_segment(self, plan: PlanId, start: str, end: str, name: str) -> None:
        """Name a segment as the representation of a quantity."""
        self.segments.append(Segment(plan, start, end, name))

    def draw_equation(self, equation: Equation) -> None:
        """Solve the equation on its plan: lay off what is known, then close, cross, or cross arcs; measure the rest."""
        ends, open_terms = zip(
            *(self._lay_off_known_terms(equation.plan, chain) for chain in equation.chains), strict=True
        )
        if equation.construction_kind != "close":
            self._cross_open_terms(equation, ends, open_terms)
        self.measure_equation_results(equation)

    def lay_off_until_meeting(self, plan: PlanId, chain: Iterable[Term], last: Term, back: Term) -> None:
        """Lay off a vector forwards from the end of a chain and one backwards from its beginning until they meet; the
        line of either is known."""
        self.draw_equation(Equation(plan, ((*chain, last), (back,))))

    def draw_closing_vector(
        self, plan: PlanId, chain: Iterable[Term], name: str, start: str, end: str = POLE_LABEL
    ) -> None:
        """Draw the closing vector of a polygon, with that name; its length and direction are measured."""
        self.measure_equation_results(Equation(plan, ((*chain, Term(name, start, end)), ())))

    def measure_equation_results(self, equation: Equation) -> None:
        """Measure the results of an equation once its last mark exists."""
        self.equations.append(equation)
        for term in equation.all_terms:
            self.name_segment(equation.plan, *term.end_marks, term.name)
            if not term.drawn and term.length is None:
                start, end = equation.plan.marks(*term.end_marks)
                self.measure_segment(term.name, start, end, term.direction)
        if equation.total and equation.chains[0]:
            self.name_segment(equation.plan, equation.chains[0][0].start, equation.chains[0][-1].end, equation.total)

    def _lay_off_known_terms(self, plan: PlanId, chain: Chain) -> tuple[Mark, list[Term]]:
        """Lay off the known terms; returns the mark reached and the terms still open."""
        mark = plan.mark(chain[0].start if chain else "")
        unknown = []
        for term in chain:
            if term.known_part_count == 2:
                mark = self.lay_off_known_vector(plan, term, mark)
            else:
                unknown.append(term)
        return mark, unknown

    def lay_off_known_vector(self, plan: PlanId, term: Term, start: Mark | None = None) -> Mark:
        """Lay off a known vector (or find it on the plan); returns the mark at its end."""
        if not term.drawn and term.length and term.direction:
            place = start or plan.mark(term.start)
            along = term.direction if term.sign > 0 else self.draw_reversed_direction(term.direction)
            return self.lay_off(plan, term.end, place, along, term.length, term.means)
        return plan.mark(term.end)

    def draw_reversed_direction(self, line_name: str) -> str:
        """The opposite direction."""
        line = self.steps[line_name].means
        turned = line and replace(line, quantity=_REVERSED_QUANTITIES.get(line.quantity, line.quantity))
        if turned and turned.quantity == "towards":
            turned = replace(turned, of=turned.about, about=turned.of)
        return self.add_step(Turn(f"−{line_name}", line_name, 2, means=turned))

    def _cross_open_terms(self, equation: Equation, ends: Sequence[Mark], open_terms: Sequence[list[Term]]) -> None:
        """Cross the lines or arcs of the two open terms."""
        if len(open_terms[0]) == 1:
            (one,), (two,) = open_terms
            start, other = ends
        else:  # both open terms are in one chain: work back from its far end
            one, two = open_terms[0] or open_terms[1]
            start, other = ends if open_terms[0] else reversed(ends)
        mark = equation.plan.mark(one.end)
        mu = equation.plan.mu_name
        side = equation.side or ""
        if one.direction and two.direction:
            self.add_step(Cross(mark, start, one.direction, other, two.direction))
        elif one.direction and two.length:
            self.add_step(
                CrossArc(mark, start, one.direction, other, two.length, mu, side, self._lay_off_of_mark(other))
            )
        elif two.direction and one.length:
            self.add_step(
                CrossArc(mark, other, two.direction, start, one.length, mu, side, self._lay_off_of_mark(start))
            )
        elif one.length and two.length:
            self.add_step(CrossArcs(mark, start, one.length, other, two.length, mu, side))

    def _lay_off_of_mark(self, mark: Mark) -> tuple[Mark, str, str] | None:
        """How a mark was laid off, if it was: the start mark, the direction, the length."""
        step = self.steps[mark]
        if isinstance(step, LayOff):
            return (step.start, step.along, step.length)
        return None
