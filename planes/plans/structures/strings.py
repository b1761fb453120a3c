"""The string polygon: rays from a pole to the ends of the forces, and parallel strings on the scheme, each from the
line of one force to that of the next. The outermost strings meet on the line of the resultant; between supports the
closing line divides the force polygon into both reactions."""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from planes.drafting.equations import Equation, Term
from planes.geometry.plane import corners, sine
from planes.plans.position.bodies import SCHEME
from planes.plans.structures.free_body import FreeBody, Meeting
from planes.scene.structures import Support
from planes.words.names import POLE, Meaning, at, end_of

O = "O"  # noqa: E741  the letter of the pole in every textbook
TURNS = 24  # directions in which a pole is tried
NEAR, FAR = 0.6, 1.2  # distance from the middle of the polygon, of its size
CLOSING = "z"
TRIED = "′"  # suffix of a trial's letters


@dataclass
class StringPolygon:
    """The strings of a body's loads, by rays from a pole on its force plan; a ``trial`` has no letters."""

    body: FreeBody
    pole: str = O
    trial: bool = False
    rays: list[str] = field(default_factory=list)
    knots: list[str] = field(default_factory=list)  # marks of the scheme from string to string

    def draw(self, start: str) -> None:
        """All rays, and all strings from a mark of the scheme on the first one."""
        b, d, plan = self.body, self.body.draft, self.body.plan
        b.figure.poles.append(at(plan, self.pole))
        b.figure.said.setdefault(at(plan, self.pole), "rays")
        ends = [POLE, *(t.end for t in b.chain)]
        for k, end in enumerate(ends):
            letter = "" if self.trial else str(k)
            means = Meaning("along", f"{k}{TRIED * self.trial}")
            self.rays.append(d.through(f"∥{means.of}", at(plan, self.pole), at(plan, end), means))
            b.figure.stroke(plan, "trial" if self.trial else "ray", letter, at(plan, self.pole), at(plan, end))
        self.knots = [start]
        for k, f in enumerate(b.forces):
            if f.point == start and not k:
                self.knots.append(start)
                continue
            self.knots.append(self.string(k, f.point, f.along))
            b.figure.stroke(SCHEME, "action", "", f.point, self.knots[-1])

    def string(self, k: int, point: str, along: str) -> str:
        """A string from the end of the one before to a line; returns the mark there."""
        b, letter = self.body, "" if self.trial else str(k)
        mark = b.fresh(f"{k + 1}{TRIED * self.trial}")
        knot = b.draft.step(Meeting(mark, self.knots[-1], self.rays[k], point, along))
        b.figure.stroke(SCHEME, "trial" if self.trial else "string", letter, self.knots[-1], knot)
        b.figure.said[knot] = "trial_string" if self.trial else "string"
        return knot

    def cut(self, k: int, point: str, along: str) -> str:
        """The mark where a string of a trial meets a line through a point."""
        b, spot = self.body, at(SCHEME, point)
        mark = b.draft.step(Meeting(b.fresh(f"{point}{TRIED}"), self.knots[k], self.rays[k], spot, along))
        b.figure.stroke(SCHEME, "trial", "", spot, mark)
        return mark

    def resultant(self) -> tuple[str, str]:
        """The mark of the scheme where the outermost strings meet, and the direction of the resultant there."""
        b, last = self.body, str(len(self.rays) - 1)
        mark = b.draft.step(Meeting(b.fresh("K"), self.knots[1], self.rays[0], self.knots[-1], self.rays[-1]))
        b.figure.knots.append(mark)
        b.figure.said[mark] = "outermost"
        b.figure.stroke(SCHEME, "string", "0", self.knots[1], mark)
        b.figure.stroke(SCHEME, "string", last, self.knots[-1], mark)
        return mark, total(b, mark)

    def close(self, line: Support) -> str:
        """The closing line from the first knot to the line of a reaction; its direction."""
        b, d, last = self.body, self.body.draft, len(self.rays) - 1
        knot = self.string(last, b.spot(line), b.along(line))
        b.figure.stroke(SCHEME, "action", "", b.spot(line), knot)
        b.figure.stroke(SCHEME, "closing", CLOSING, self.knots[0], knot)
        return d.through(f"∥{CLOSING}", self.knots[0], knot, Meaning("along", CLOSING))


def lay_pole(b: FreeBody, pole: complex, label: str = O) -> None:
    """The pole of a string polygon at a place in N from the start of the force polygon."""
    d, size, angle = b.draft, abs(pole), math.degrees(cmath.phase(pole))
    along = d.aim(f"∠{label}", angle, Meaning("given", label))
    length = d.give(f"|p{label}|", size, Meaning("load", f"p{label}"))
    d.lay_off(b.plan, label, at(b.plan, POLE), along, length, Meaning("foot"))


def pole_through(b: FreeBody, pole: complex, points: Sequence[str], before: int) -> None:
    """The pole for strings through points of the scheme; of three points, ``before`` is the number of loads before the
    middle one. A trial polygon from the first point divides the loads between two points: the ray parallel to its
    closing line meets theirs at a point common to all poles, and the pole lies on the parallel through it to the line
    of both points."""
    d, plan, first = b.draft, b.plan, at(SCHEME, points[0])
    lay_pole(b, pole, O + TRIED)
    trial = StringPolygon(b, O + TRIED, True)
    trial.draw(first)
    cuts = [0, before, len(b.forces)] if len(points) == 3 else [0, len(b.forces)]
    ends = [POLE, *(t.end for t in b.chain)]
    parted = list[tuple[str, str]]()
    for n, (low, high) in enumerate(pairwise(cuts)):
        means = Meaning("along", f"R{TRIED}{n + 1}")
        chord = d.through(f"∥{means.of}", at(plan, ends[low]), at(plan, ends[high]), means)
        stops = [(low, points[n]), (high, points[n + 1])]
        start, end = (trial.cut(k, p, chord) if k else first for k, p in stops)
        b.figure.stroke(SCHEME, "trial", "", start, end)
        closing = d.through(f"∥{TRIED}{n + 1}", start, end, Meaning("along", f"{CLOSING}{TRIED}{n + 1}"))
        mark = at(plan, f"m{n + 1}")
        d.step(Meeting(mark, at(plan, O + TRIED), closing, at(plan, ends[low]), chord, means=Meaning("foot")))
        b.figure.stroke(plan, "trial", "", at(plan, O + TRIED), mark)
        parted.append((mark, d.ray(SCHEME, points[n], points[n + 1])))
    other = parted[1] if len(parted) > 1 else (at(plan, O + TRIED), chord)
    d.step(Meeting(at(plan, O), *parted[0], *other, means=Meaning("foot")))
    b.figure.said |= {at(plan, O): "pole_through"}
    for mark, _ in parted:
        b.figure.stroke(plan, "action", "", mark, at(plan, O))


def total(b: FreeBody, mark: str) -> str:
    """The resultant of all loads, which acts at a mark of the scheme; its direction."""
    b.draft.conclude(Equation(b.plan, (b.chain, ()), "R"))
    way = b.draft.through("∥R", at(b.plan, POLE), at(b.plan, b.reached), Meaning("along", "R"))
    b.figure.results.append(("R", mark, way))
    return way


def by_strings(b: FreeBody) -> tuple[StringPolygon, str, str]:
    """The reactions of a hinge and a support with a line, by the closing line of the string polygon that begins at the
    hinge; returns this polygon, the direction of that line, and the label at the end of the second reaction."""
    anchor, (line,) = b.anchor, b.lines
    assert anchor
    polygon = StringPolygon(b)
    polygon.draw(b.spot(anchor))
    closing, start, x = polygon.close(line), b.reached, end_of(line.name)
    last = str(len(polygon.rays) - 1)
    last_ray = Term(f"N_{last}", O, start, drawn=True)
    parted = Term(f"N_{CLOSING}", O, x, None, closing, b.action(closing))
    b.draft.draw(Equation(b.plan, ((last_ray, b.seek(line, start, x)), (parted,))))
    b.figure.stroke(b.plan, "ray", CLOSING, at(b.plan, O), at(b.plan, x))
    b.figure.said[at(b.plan, x)] = "closing_line"
    b.found[line.name] = (start, x)
    b.chain += (Term(line.name, start, x, drawn=True),)
    b.close(anchor)
    return polygon, closing, x


def by_composition(b: FreeBody) -> tuple[str, str]:
    """The resultant of all loads, each composed with those before at the intersection of both lines."""
    mark, along, before = b.forces[0].point, b.forces[0].along, b.chain[0]
    for k, (f, term) in enumerate(zip(b.forces[1:], b.chain[1:], strict=True), 2):
        mark = b.cross(str(k), mark, along, f.point, f.along)
        name = "R" if k == len(b.chain) else f"R_{''.join(map(str, range(1, k + 1)))}"
        b.draft.conclude(Equation(b.plan, ((before, term), ()), name))
        before = Term(name, POLE, term.end, drawn=True)
        along = b.draft.through(f"∥{name}", at(b.plan, POLE), at(b.plan, term.end), Meaning("along", name))
        b.figure.results.append((name, mark, along))
    return mark, along


def chosen_pole(forces: Sequence[complex], first: complex | None, lines: Sequence[complex]) -> complex:
    """A pole at which no string is parallel to a force it meets, in N from the start of the polygon; with ``first`` the
    strings are closed on a line of that direction, else on themselves. ``lines`` are those of forces."""
    ends = [0j]
    for force in forces:
        ends.append(ends[-1] + force)
    low, high = corners(ends)
    size, middle = max(abs(high - low), max(map(abs, forces))), (low + high) / 2
    tried = [middle + size * far * cmath.rect(1, math.tau * k / TURNS) for far in (NEAR, FAR) for k in range(TURNS)]
    tried = [rounded(z, size) for z in tried]
    return max(tried, key=lambda o: round(min(sharpness(o, ends, lines, first)), 2))


def rounded(z: complex, size: float) -> complex:
    """A place rounded to two digits of a size."""
    step = 10.0 ** (math.floor(math.log10(size)) - 1)
    return complex(round(z.real / step) * step, round(z.imag / step) * step)


def sharpness(
    pole: complex, ends: Sequence[complex], lines: Sequence[complex], last: complex | None
) -> Iterator[float]:
    """The sines of the angles at which the strings meet the lines they are drawn to."""
    rays = [end - pole for end in ends]
    for (one, two), line in zip(pairwise(rays), lines, strict=True):
        yield from (sine(one, line), sine(two, line))
    yield sine(rays[-1], rays[0] if last is None else last)
