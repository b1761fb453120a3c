"""The string polygon: rays from a pole to the ends of the forces, and parallel strings on the scheme, each from the
line of one force to that of the next. The outermost strings meet on the line of the resultant; between supports the
closing line divides the force polygon into both reactions."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from planes.drafting.equations import Equation, Term
from planes.geometry.plane import bounding_corners, sine_between
from planes.plans.structures.free_body import FreeBody, Meeting
from planes.scene.structures import Support
from planes.words.names import POLE_LABEL, SCHEME_PLAN, Mark, Meaning, scheme_mark, vector_end_label

STRING_POLE_LETTER = "O"  # the letter of the pole in every textbook
TRIED_POLE_DIRECTIONS = 24  # directions in which a pole is tried
NEAR_POLE_DISTANCE_RATIO = 0.6  # distance from the middle of the polygon, of its size
FAR_POLE_DISTANCE_RATIO = 1.2  # the same for a far pole
CLOSING_LINE_LETTER = "z"
TRIAL_SUFFIX = "′"  # suffix of a trial's letters


@dataclass
class StringPolygon:
    """The strings of a body's loads, by rays from a pole on its force plan; a ``trial`` has no letters."""

    body: FreeBody
    pole: str = STRING_POLE_LETTER
    trial: bool = False
    rays: list[str] = field(default_factory=list)
    knots: list[Mark] = field(default_factory=list)  # marks of the scheme from string to string

    def draw_rays_and_strings(self, start: Mark) -> None:
        """All rays, and all strings from a mark of the scheme on the first one."""
        b = self.body
        d = b.draft
        plan = b.plan
        pole = plan.mark(self.pole)
        b.figure.poles.append(pole)
        b.figure.said.setdefault(pole, "rays")
        ends = [POLE_LABEL, *(t.end for t in b.chain)]
        for k, end in enumerate(ends):
            letter = "" if self.trial else str(k)
            means = Meaning("along", f"{k}{TRIAL_SUFFIX * self.trial}")
            mark = plan.mark(end)
            self.rays.append(d.draw_direction_through_marks(f"∥{means.of}", pole, mark, means))
            b.figure.add_line(plan, "trial" if self.trial else "ray", letter, pole, mark)
        self.knots = [start]
        for k, f in enumerate(b.forces):
            if f.point == start and not k:
                self.knots.append(start)
                continue
            self.knots.append(self.draw_string_to_line(k, f.point, f.along))
            b.figure.add_line(SCHEME_PLAN, "action", "", f.point, self.knots[-1])

    def draw_string_to_line(self, k: int, point: Mark, along: str) -> Mark:
        """A string from the end of the one before to a line; returns the mark there."""
        b = self.body
        letter = "" if self.trial else str(k)
        mark = b.unused_mark(f"{k + 1}{TRIAL_SUFFIX * self.trial}")
        knot = b.draft.draw_mark(Meeting(mark, self.knots[-1], self.rays[k], point, along))
        b.figure.add_line(SCHEME_PLAN, "trial" if self.trial else "string", letter, self.knots[-1], knot)
        b.figure.said[knot] = "trial_string" if self.trial else "string"
        return knot

    def mark_where_string_meets_line(self, k: int, point: str, along: str) -> Mark:
        """The mark where a string of a trial meets a line through a point."""
        b = self.body
        spot = scheme_mark(point)
        mark = b.draft.draw_mark(
            Meeting(b.unused_mark(f"{point}{TRIAL_SUFFIX}"), self.knots[k], self.rays[k], spot, along)
        )
        b.figure.add_line(SCHEME_PLAN, "trial", "", spot, mark)
        return mark

    def resultant_mark_and_direction(self) -> tuple[Mark, str]:
        """The mark of the scheme where the outermost strings meet, and the direction of the resultant there."""
        b = self.body
        last = str(len(self.rays) - 1)
        mark = b.draft.draw_mark(
            Meeting(b.unused_mark("K"), self.knots[1], self.rays[0], self.knots[-1], self.rays[-1])
        )
        b.figure.knots.append(mark)
        b.figure.said[mark] = "outermost"
        b.figure.add_line(SCHEME_PLAN, "string", "0", self.knots[1], mark)
        b.figure.add_line(SCHEME_PLAN, "string", last, self.knots[-1], mark)
        return mark, resultant_at_mark(b, mark)

    def draw_closing_line(self, line: Support) -> str:
        """The closing line from the first knot to the line of a reaction; its direction."""
        b = self.body
        d = b.draft
        last = len(self.rays) - 1
        knot = self.draw_string_to_line(last, b.place_of_support(line), b.reaction_line(line))
        b.figure.add_line(SCHEME_PLAN, "action", "", b.place_of_support(line), knot)
        b.figure.add_line(SCHEME_PLAN, "closing", CLOSING_LINE_LETTER, self.knots[0], knot)
        return d.draw_direction_through_marks(
            f"∥{CLOSING_LINE_LETTER}", self.knots[0], knot, Meaning("along", CLOSING_LINE_LETTER)
        )


def lay_off_pole(b: FreeBody, pole: complex, label: str = STRING_POLE_LETTER) -> None:
    """The pole of a string polygon at a place in N from the start of the force polygon."""
    d = b.draft
    size = abs(pole)
    angle = math.degrees(cmath.phase(pole))
    along = d.draw_direction_at_angle(f"∠{label}", angle, Meaning("given", label))
    length = d.add_given(f"|p{label}|", size, Meaning("load", f"p{label}"))
    d.lay_off(b.plan, label, b.plan.pole, along, length, Meaning("foot"))


def pole_for_strings_through(b: FreeBody, pole: complex, points: Sequence[str], before: int) -> None:
    """The pole for strings through points of the scheme; of three points, ``before`` is the number of loads before the
    middle one. A trial polygon from the first point divides the loads between two points: the ray parallel to its
    closing line meets theirs at a point common to all poles, and the pole lies on the parallel through it to the line
    of both points."""
    d = b.draft
    plan = b.plan
    first = scheme_mark(points[0])
    letter = STRING_POLE_LETTER + TRIAL_SUFFIX
    trial_pole = plan.mark(letter)
    lay_off_pole(b, pole, letter)
    trial = StringPolygon(b, letter, True)
    trial.draw_rays_and_strings(first)
    cuts = [0, before, len(b.forces)] if len(points) == 3 else [0, len(b.forces)]
    ends = [POLE_LABEL, *(t.end for t in b.chain)]
    parted = []
    for n, (low, high) in enumerate(pairwise(cuts)):
        means = Meaning("along", f"R{TRIAL_SUFFIX}{n + 1}")
        chord = d.draw_direction_through_marks(f"∥{means.of}", *plan.marks(ends[low], ends[high]), means)
        stops = [(low, points[n]), (high, points[n + 1])]
        start, end = (trial.mark_where_string_meets_line(k, p, chord) if k else first for k, p in stops)
        b.figure.add_line(SCHEME_PLAN, "trial", "", start, end)
        closing = d.draw_direction_through_marks(
            f"∥{TRIAL_SUFFIX}{n + 1}", start, end, Meaning("along", f"{CLOSING_LINE_LETTER}{TRIAL_SUFFIX}{n + 1}")
        )
        mark = plan.mark(f"m{n + 1}")
        d.add_step(Meeting(mark, trial_pole, closing, plan.mark(ends[low]), chord, means=Meaning("foot")))
        b.figure.add_line(plan, "trial", "", trial_pole, mark)
        parted.append((mark, d.direction_between_marks(points[n], points[n + 1])))
    other = parted[1] if len(parted) > 1 else (plan.mark(STRING_POLE_LETTER + TRIAL_SUFFIX), chord)
    d.add_step(Meeting(plan.mark(STRING_POLE_LETTER), *parted[0], *other, means=Meaning("foot")))
    b.figure.said |= {plan.mark(STRING_POLE_LETTER): "pole_through"}
    for mark, _ in parted:
        b.figure.add_line(plan, "action", "", mark, plan.mark(STRING_POLE_LETTER))


def resultant_at_mark(b: FreeBody, mark: Mark) -> str:
    """The resultant of all loads, which acts at a mark of the scheme; its direction."""
    b.draft.measure_equation_results(Equation(b.plan, (b.chain, ()), "R"))
    way = b.draft.draw_direction_through_marks("∥R", b.plan.pole, b.plan.mark(b.reached), Meaning("along", "R"))
    b.figure.results.append(("R", mark, way))
    return way


def reactions_by_string_polygon(b: FreeBody) -> tuple[StringPolygon, str, str]:
    """The reactions of a hinge and a support with a line, by the closing line of the string polygon that begins at the
    hinge; returns this polygon, the direction of that line, and the label at the end of the second reaction."""
    anchor = b.hinge_or_clamp
    (line,) = b.supports_with_known_lines
    assert anchor
    polygon = StringPolygon(b)
    polygon.draw_rays_and_strings(b.place_of_support(anchor))
    closing = polygon.draw_closing_line(line)
    start = b.reached
    x = vector_end_label(line.name)
    last = str(len(polygon.rays) - 1)
    last_ray = Term(f"N_{last}", STRING_POLE_LETTER, start, drawn=True)
    parted = Term(f"N_{CLOSING_LINE_LETTER}", STRING_POLE_LETTER, x, None, closing, b.line_of_action_text(closing))
    b.draft.draw_equation(Equation(b.plan, ((last_ray, b.unknown_reaction_term(line, start, x)), (parted,))))
    b.figure.add_line(b.plan, "ray", CLOSING_LINE_LETTER, *b.plan.marks(STRING_POLE_LETTER, x))
    b.figure.said[b.plan.mark(x)] = "closing_line"
    b.found[line.name] = (start, x)
    b.chain += (Term(line.name, start, x, drawn=True),)
    b.close_with_last_reaction(anchor)
    return polygon, closing, x


def resultant_by_composition(b: FreeBody) -> tuple[Mark, str]:
    """The resultant of all loads, each composed with those before at the intersection of both lines."""
    mark = b.forces[0].point
    along = b.forces[0].along
    before = b.chain[0]
    for k, (f, term) in enumerate(zip(b.forces[1:], b.chain[1:], strict=True), 2):
        mark = b.crossing_of_lines(str(k), mark, along, f.point, f.along)
        name = "R" if k == len(b.chain) else f"R_{''.join(map(str, range(1, k + 1)))}"
        b.draft.measure_equation_results(Equation(b.plan, ((before, term), ()), name))
        before = Term(name, POLE_LABEL, term.end, drawn=True)
        along = b.draft.draw_direction_through_marks(
            f"∥{name}", b.plan.pole, b.plan.mark(term.end), Meaning("along", name)
        )
        b.figure.results.append((name, mark, along))
    return mark, along


def choose_sharp_pole(forces: Sequence[complex], first: complex | None, lines: Sequence[complex]) -> complex:
    """A pole at which no string is parallel to a force it meets, in N from the start of the polygon; with ``first`` the
    strings are closed on a line of that direction, else on themselves. ``lines`` are those of forces."""
    ends = [0j]
    for force in forces:
        ends.append(ends[-1] + force)
    low, high = bounding_corners(ends)
    size = max(abs(high - low), max(map(abs, forces)))
    middle = (low + high) / 2
    tried = [
        middle + size * far * cmath.rect(1, math.tau * k / TRIED_POLE_DIRECTIONS)
        for far in (NEAR_POLE_DISTANCE_RATIO, FAR_POLE_DISTANCE_RATIO)
        for k in range(TRIED_POLE_DIRECTIONS)
    ]
    tried = [round_to_two_digits(z, size) for z in tried]
    return max(tried, key=lambda o: round(min(string_crossing_sines(o, ends, lines, first)), 2))


def round_to_two_digits(z: complex, size: float) -> complex:
    """A place rounded to two digits of a size."""
    step = 10.0 ** (math.floor(math.log10(size)) - 1)
    return complex(round(z.real / step) * step, round(z.imag / step) * step)


def string_crossing_sines(
    pole: complex, ends: Sequence[complex], lines: Sequence[complex], last: complex | None
) -> Iterator[float]:
    """The sines of the angles at which the strings meet the lines they are drawn to."""
    rays = [end - pole for end in ends]
    for (one, two), line in zip(pairwise(rays), lines, strict=True):
        yield from (sine_between(one, line), sine_between(two, line))
    yield sine_between(rays[-1], rays[0] if last is None else last)
