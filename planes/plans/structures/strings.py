"""The string polygon: rays from a pole to the ends of the forces, and on the scheme strings parallel to them, each from
the line of one force to that of the next. The outermost strings meet on the line of the resultant; between supports the
closing line parts the polygon of forces into both reactions.
"""

import cmath
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from planes.drafting.equations import Equation, Term
from planes.drafting.steps.crossings import Cross
from planes.plans.position.bodies import SCHEME
from planes.plans.structures.free_body import FreeBody
from planes.scene.structures import Support
from planes.words.names import POLE, Meaning, at, end_of

O = "O"  # noqa: E741  the letter of the pole in every textbook
TURNS = 24  # directions in which a pole is tried
NEAR, FAR = 0.6, 1.2  # how far from the middle of the polygon, of its size
CLOSING = "z"


@dataclass
class StringPolygon:
    """The strings of a body's loads, by a pole in N from where the polygon of forces begins."""

    body: FreeBody
    pole: complex
    rays: list[str] = field(default_factory=list)
    knots: list[str] = field(default_factory=list)  # marks of the scheme from string to string

    def draw(self, start: str) -> None:
        """All rays, and all strings from a mark of the scheme on the first one."""
        b, d, plan = self.body, self.body.draft, self.body.plan
        size, angle = abs(self.pole), math.degrees(cmath.phase(self.pole))
        along = d.aim(f"∠{O}", angle, Meaning("given", O))
        d.lay_off(plan, O, at(plan, POLE), along, d.give(f"|p{O}|", size), Meaning("special"))
        b.figure.poles.append(at(plan, O))
        b.figure.said[at(plan, O)] = "rays"
        ends = [POLE, *(t.end for t in b.chain)]
        for k, end in enumerate(ends):
            means = Meaning("along", str(k))
            self.rays.append(d.through(f"∥{k}", at(plan, O), at(plan, end), means))
            b.figure.stroke(plan, "ray", str(k), at(plan, O), at(plan, end))
        self.knots = [start]
        for k, f in enumerate(b.forces):
            if f.point == start and not k:
                self.knots.append(start)
                continue
            knot = d.step(Cross(b.fresh(f"{k + 1}"), self.knots[-1], self.rays[k], f.point, f.along))
            b.figure.stroke(SCHEME, "action", "", f.point, knot)
            b.figure.stroke(SCHEME, "string", str(k), self.knots[-1], knot)
            self.knots.append(knot)
            b.figure.said[knot] = "string"

    def resultant(self) -> tuple[str, str]:
        """The mark of the scheme where the outermost strings meet, and the direction of the resultant there."""
        b, last = self.body, str(len(self.rays) - 1)
        mark = b.draft.step(Cross(b.fresh("K"), self.knots[1], self.rays[0], self.knots[-1], self.rays[-1]))
        b.figure.knots.append(mark)
        b.figure.said[mark] = "outermost"
        b.figure.stroke(SCHEME, "string", "0", self.knots[1], mark)
        b.figure.stroke(SCHEME, "string", last, self.knots[-1], mark)
        return mark, total(b, mark)

    def close(self, line: Support) -> str:
        """The closing line from the first knot to the line of a reaction; its direction."""
        b, d, last = self.body, self.body.draft, len(self.rays) - 1
        along, spot = b.along(line), b.spot(line)
        knot = d.step(Cross(b.fresh(f"{last + 1}"), self.knots[-1], self.rays[-1], spot, along))
        b.figure.stroke(SCHEME, "action", "", spot, knot)
        b.figure.stroke(SCHEME, "string", str(last), self.knots[-1], knot)
        b.figure.said[knot] = "string"
        b.figure.stroke(SCHEME, "closing", CLOSING, self.knots[0], knot)
        return d.through(f"∥{CLOSING}", self.knots[0], knot, Meaning("along", CLOSING))


def total(b: FreeBody, mark: str) -> str:
    """The resultant of all loads, which acts at a mark of the scheme; its direction."""
    b.draft.conclude(Equation(b.plan, (b.chain, ()), "R"))
    way = b.draft.through("∥R", at(b.plan, POLE), at(b.plan, b.reached), Meaning("along", "R"))
    b.figure.results.append(("R", mark, way))
    return way


def by_strings(b: FreeBody, pole: complex) -> None:
    """The reactions of a hinge and a line by the closing line of the string polygon that begins in the hinge."""
    anchor, (line,) = b.anchor, b.lines
    assert anchor
    b.lay()
    polygon = StringPolygon(b, pole)
    polygon.draw(b.spot(anchor))
    closing, start, x = polygon.close(line), b.reached, end_of(line.name)
    last = str(len(polygon.rays) - 1)
    found = Term(f"N_{last}", O, start, drawn=True)
    parted = Term(f"N_{CLOSING}", O, x, None, closing, b.action(closing))
    b.draft.draw(Equation(b.plan, ((found, b.seek(line, start, x)), (parted,))))
    b.figure.stroke(b.plan, "ray", CLOSING, at(b.plan, O), at(b.plan, x))
    b.figure.said[at(b.plan, x)] = "closing_line"
    b.found[line.name] = (start, x)
    b.chain += (Term(line.name, start, x, drawn=True),)
    b.close(anchor)


def by_composition(b: FreeBody) -> tuple[str, str]:
    """The resultant of all loads, each taken together with those before where both lines meet."""
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
    """A pole at which no string runs along the line of a force it meets, at N from the beginning of the polygon; with
    ``first`` the strings are closed on a line of that direction, else on themselves. ``lines`` are those of forces."""
    ends = [0j]
    for force in forces:
        ends.append(ends[-1] + force)
    low = complex(min(z.real for z in ends), min(z.imag for z in ends))
    high = complex(max(z.real for z in ends), max(z.imag for z in ends))
    size, middle = max(abs(high - low), max(map(abs, forces))), (low + high) / 2
    tried = [middle + size * far * cmath.rect(1, math.tau * k / TURNS) for far in (NEAR, FAR) for k in range(TURNS)]
    tried = [rounded(z, size) for z in tried]
    return max(tried, key=lambda o: round(min(sharpness(o, ends, lines, first)), 2))


def rounded(z: complex, size: float) -> complex:
    """A place with two digits beside a size."""
    step = 10.0 ** (math.floor(math.log10(size)) - 1)
    return complex(round(z.real / step) * step, round(z.imag / step) * step)


def sharpness(
    pole: complex, ends: Sequence[complex], lines: Sequence[complex], last: complex | None
) -> Iterator[float]:
    """The sines of the angles at which the strings meet what they are drawn to."""
    rays = [end - pole for end in ends]
    for (one, two), line in zip(pairwise(rays), lines, strict=True):
        yield from (sine(one, line), sine(two, line))
    yield sine(rays[-1], rays[0] if last is None else last)


def sine(u: complex, v: complex) -> float:
    """The sine of the angle between two lines, 0 where one is nothing."""
    size = abs(u) * abs(v)
    return abs((u * v.conjugate()).imag) / size if size else 0.0
