"""Details of a plan: parts too short to be read are circled, and drawn again enlarged, with a separate scale."""

from collections.abc import Iterable, Sequence

from planes.geometry.plane import corners, toward
from planes.words.frozen import frozen, replace
from render.labels import Label, place
from render.labels.footprints import bounds
from render.paper.hues import PART
from render.paper.marks import Arc, Arrow, Line, Mark, Shape, Text, moved
from render.paper.style import tall
from render.paper.symbols import Marks
from render.views import TITLE_GAP
from render.views.plotted import Ends, upon

SHORT_MM = 3.0  # a vector shorter than this is drawn again
TOGETHER_MM = 3.0  # short vectors closer than this share one detail
ENLARGED = (2, 4, 5, 10, 20, 40, 50, 100)  # scales of ГОСТ 2.302
ALONE_TIMES = 20  # largest enlargement of a single force
RADIUS_MM = 16.0  # of the largest detail
LEAST_MM = 1.6  # radius of the smallest circle on the plan
AROUND = 1.35  # a detail reaches so many times as far as its vectors
LETTER_MM = 5.0
MOST_LABELS = 4  # of a circle, on the plan too
BESIDE_MM = 8.0
LOOK_ALIKE = dict(zip("АВЕКМНРСТУ", "ABEKMHPCTY", strict=True))
UPON_MM = 1.0  # parallel vectors no farther apart are read as one line
SEEN_MM = 1.5  # a part shorter than this in its detail gets another
Groups = list[list[Ends]]


@frozen
class Detail:
    """A circle on the plan, its enlargement, and its letter."""

    centre: complex
    radius: float
    times: int
    letter: str

    @property
    def title(self) -> str:
        """Letter and scale: А (10:1)."""
        return f"{self.letter} ({self.times}:1)"

    def circle(self) -> Arc:
        """The circle on the plan."""
        return Arc(self.centre, max(self.radius, LEAST_MM), style="thin", layer="dimension")

    def named(self) -> Label:
        """The letter beside the circle."""
        clear = max(self.radius, LEAST_MM) + 0.3
        return Label(self.letter, self.centre, LETTER_MM, clear=clear, name=self.title)

    def enlarged(self, z: complex) -> complex:
        """The place of a plan's point in the detail, whose centre is the origin."""
        return self.times * (z - self.centre)

    def holds(self, z: complex) -> bool:
        """Whether a place is inside the detail."""
        return abs(z - self.centre) < 0.97 * self.radius

    def seen(self, ends: Ends) -> Ends | None:
        """The part of a straight stroke within the detail, enlarged; None if there is almost nothing."""
        a, b = map(self.enlarged, ends)
        reach, way = self.times * self.radius, toward(a, b)
        back = way.conjugate()
        foot = a - (a * back).real * way
        if abs(foot) >= reach:
            return None
        half = (reach**2 - abs(foot) ** 2) ** 0.5
        low = max((a * back).real, -half)
        high = min((b * back).real, half)
        return (foot + low * way, foot + high * way) if high - low > 1.0 else None

    def drawn(self, marks: Iterable[Mark], named: Sequence[Label]) -> Marks:
        """The strokes of the plan within the circle, the labels of vectors wholly inside, and the title."""
        ground: list[Mark] = [Arc(0j, self.times * self.radius, style="thin", layer="dimension")]
        ground += (part for mark in marks for part in self.part(mark))
        ground += place([self.label(x) for x in named if self.shows(x)], ground).marks
        top = bounds(ground)[3]
        return (*ground, Text(self.title, complex(0, top + TITLE_GAP), tall(LETTER_MM), "middle", name=self.title))

    def part(self, mark: Mark) -> list[Mark]:
        """The visible part of one mark."""
        if isinstance(mark, Arrow) or (isinstance(mark, Line) and len(mark.points) == 2):
            ends = (mark.start, mark.end) if isinstance(mark, Arrow) else (mark.points[0], mark.points[1])
            piece, name = self.seen(ends), mark.name and mark.name + PART
            if piece and isinstance(mark, Arrow) and self.holds(mark.end):
                return [replace(mark, start=piece[0], end=piece[1], name=name)]
            return [Line(piece, mark.style, mark.layer, name=name)] if piece else []
        if isinstance(mark, (Arc, Shape)):
            at = mark.centre if isinstance(mark, Arc) else sum(mark.points) / len(mark.points)
            return [moved(mark, self.enlarged(at) - at)] if self.holds(at) else []  # the pole's dot keeps its size
        return []

    def shows(self, label: Label) -> bool:
        """Whether the object of a label is wholly visible."""
        return all(map(self.holds, label.at if isinstance(label.at, tuple) else (label.at,)))

    def alone(self, named: Sequence[Label]) -> list[Label]:
        """The labels that are read in the detail alone: those of vectors wholly visible there, where they are many."""
        held = [x for x in named if self.shows(x)]
        return held if len(held) > MOST_LABELS else []

    def label(self, label: Label) -> Label:
        """The label in its enlarged place."""
        z = label.at
        at = (self.enlarged(z[0]), self.enlarged(z[1])) if isinstance(z, tuple) else self.enlarged(z)
        return replace(label, at=at, clear=0.7)


def one_line(one: Ends, other: Ends, shown: Iterable[Detail]) -> bool:
    """Whether two vectors are read as one line, on the plan or in a detail that shows one of them whole."""
    seen = ((d.seen(one), d.seen(other)) for d in shown if all(map(d.holds, one)) or all(map(d.holds, other)))
    pairs = ((one, other), *((a, b) for a, b in seen if a and b))
    return any(upon(a, b, UPON_MM) or upon(b, a, UPON_MM) for a, b in pairs)


def details(vectors: Iterable[Ends], letters: Sequence[str], alone: bool = True) -> list[Detail]:
    """The details of the vectors that are too short; neighbours share one, unless they are too short there. Unless
    ``alone``, a single vector that would need a very large enlargement has none: it is a point with its name."""
    groups = groups_of(vectors, alone)
    return [Detail(*_seat(group), letter) for group, letter in zip(groups, letters, strict=False)]


def _seat(group: Sequence[Ends]) -> tuple[complex, float, int]:
    """The centre and radius of a detail of some vectors, and its enlargement."""
    low, high = corners(z for ends in group for z in ends)
    centre = (low + high) / 2
    radius = AROUND * max(abs(z - centre) for ends in group for z in ends)
    return centre, radius, max((t for t in ENLARGED if t * radius <= RADIUS_MM), default=ENLARGED[0])


def groups_of(vectors: Iterable[Ends], alone: bool = True) -> Groups:
    """Short vectors by details: neighbours together, and again, separately, those that are hardly visible there."""
    details = Groups()
    for group in _neighbours(ends for ends in vectors if abs(ends[1] - ends[0]) < SHORT_MM):
        times = _seat(group)[2]
        lost = [(a, b) for a, b in group if abs(b - a) * times < SEEN_MM]
        parted = len(lost) < len(group)
        details += [group, *groups_of(lost)] if parted else [[ends] for ends in group]
    return [group for group in details if alone or len(group) > 1 or _seat(group)[2] < ALONE_TIMES]


def _neighbours(short: Iterable[Ends]) -> Groups:
    """Vectors in groups of neighbours."""
    groups: Groups = []
    for ends in short:
        near = [g for g in groups if any(abs(z - w) < TOGETHER_MM for two in g for z in two for w in ends)]
        groups = [g for g in groups if g not in near]
        groups.append([*(two for g in near for two in g), ends])
    return groups


def letters(points: Iterable[str], alphabet: str) -> list[str]:
    """Letters for details: those that do not look like the name of a point."""
    taken = {p[:1].upper() for p in points}
    return [x for x in alphabet if LOOK_ALIKE.get(x, x) not in taken]


def beside(marks: Marks, drawn: Sequence[Marks]) -> Marks:
    """A plan with its details: in a row beneath it or in a column to its right, whichever takes less paper."""
    if not drawn:
        return marks
    x0, y0, x1, y1 = bounds(marks)
    boxes = [bounds(d) for d in drawn]
    wide, high = [b[2] - b[0] + BESIDE_MM for b in boxes], [b[3] - b[1] + BESIDE_MM for b in boxes]
    row = max(x1 - x0, sum(wide) - BESIDE_MM) * (y1 - y0 + max(high))
    column = (x1 - x0 + max(wide)) * max(y1 - y0, sum(high) - BESIDE_MM)
    placed = list(marks)
    x, y = ((x0 + x1 - sum(wide) + BESIDE_MM) / 2, y0 - BESIDE_MM) if row < column else (x1 + BESIDE_MM, y1)
    for one, box, w, h in zip(drawn, boxes, wide, high, strict=True):
        placed += [moved(m, complex(x - box[0], y - box[3])) for m in one]
        x, y = (x + w, y) if row < column else (x, y - h)
    return tuple(placed)
