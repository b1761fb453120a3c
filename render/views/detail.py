"""Details of a plan: parts too short to be read are circled, and drawn again enlarged, with a separate scale."""

from collections.abc import Iterable, Sequence

from planes.geometry.plane import bounding_corners, direction_between
from planes.words.frozen import frozen, replace
from render.labels import Label, place_labels
from render.labels.footprints import box_around_marks
from render.paper.hues import DETAIL_NAME_SUFFIX
from render.paper.marks import Arc, Arrow, Line, Mark, Shape, Text, move_mark
from render.paper.style import figure_letter_height
from render.paper.symbols import Marks
from render.views import TITLE_GAP_MM
from render.views.plotted import Ends, length_of, lines_overlap

LEAST_READABLE_VECTOR_MM = 3.0  # a vector shorter than this is drawn again
SHARED_DETAIL_DISTANCE_MM = 3.0  # short vectors closer than this share one detail
ENLARGEMENT_SCALES = (2, 4, 5, 10, 20, 40, 50, 100)  # scales of ГОСТ 2.302
MOST_SINGLE_ENLARGEMENT = 20  # largest enlargement of a single force
MOST_DETAIL_RADIUS_MM = 16.0  # of the largest detail
LEAST_CIRCLE_RADIUS_MM = 1.6  # radius of the smallest circle on the plan
DETAIL_MARGIN_RATIO = 1.35  # a detail reaches so many times as far as its vectors
DETAIL_LETTER_MM = 5.0
MOST_LABELS_ON_PLAN = 4  # of a circle, on the plan too
DETAIL_GAP_MM = 8.0
LATIN_LOOK_ALIKES = dict(zip("АВЕКМНРСТУ", "ABEKMHPCTY", strict=True))
COINCIDENT_LINES_MM = 1.0  # parallel vectors no farther apart are read as one line
LEAST_VISIBLE_PART_MM = 1.5  # a part shorter than this in its detail gets another
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
        return Arc(self.centre, max(self.radius, LEAST_CIRCLE_RADIUS_MM), style="thin", layer="dimension")

    def letter_label(self) -> Label:
        """The letter beside the circle."""
        clear = max(self.radius, LEAST_CIRCLE_RADIUS_MM) + 0.3
        return Label(self.letter, self.centre, DETAIL_LETTER_MM, clear=clear, name=self.title)

    def enlarged_place(self, z: complex) -> complex:
        """The place of a plan's point in the detail, whose centre is the origin."""
        return self.times * (z - self.centre)

    def contains_place(self, z: complex) -> bool:
        """Whether a place is inside the detail."""
        return abs(z - self.centre) < 0.97 * self.radius

    def visible_stroke_part(self, ends: Ends) -> Ends | None:
        """The part of a straight stroke within the detail, enlarged; None if there is almost nothing."""
        a, b = map(self.enlarged_place, ends)
        reach = self.times * self.radius
        way = direction_between(a, b)
        back = way.conjugate()
        foot = a - (a * back).real * way
        if abs(foot) >= reach:
            return None
        half = (reach**2 - abs(foot) ** 2) ** 0.5
        low = max((a * back).real, -half)
        high = min((b * back).real, half)
        if high - low > 1.0:
            return (foot + low * way, foot + high * way)
        return None

    def detail_contents(self, marks: Iterable[Mark], named: Sequence[Label]) -> Marks:
        """The strokes of the plan within the circle, the labels of vectors wholly inside, and the title."""
        ground: list[Mark] = [Arc(0j, self.times * self.radius, style="thin", layer="dimension")]
        ground += (part for mark in marks for part in self.visible_mark_parts(mark))
        ground += place_labels([self.label(x) for x in named if self.shows_whole(x)], ground).marks
        top = box_around_marks(ground)[3]
        return (
            *ground,
            Text(
                self.title,
                complex(0, top + TITLE_GAP_MM),
                figure_letter_height(DETAIL_LETTER_MM),
                "middle",
                name=self.title,
            ),
        )

    def visible_mark_parts(self, mark: Mark) -> list[Mark]:
        """The visible part of one mark."""
        if isinstance(mark, Arrow) or (isinstance(mark, Line) and len(mark.points) == 2):
            ends = (mark.start, mark.end) if isinstance(mark, Arrow) else (mark.points[0], mark.points[1])
            piece = self.visible_stroke_part(ends)
            name = mark.name and mark.name + DETAIL_NAME_SUFFIX
            if piece and isinstance(mark, Arrow) and self.contains_place(mark.end):
                return [replace(mark, start=piece[0], end=piece[1], name=name)]
            if piece:
                return [Line(piece, mark.style, mark.layer, name=name)]
            return []
        if isinstance(mark, (Arc, Shape)):
            at = mark.centre if isinstance(mark, Arc) else sum(mark.points) / len(mark.points)
            return (
                [move_mark(mark, self.enlarged_place(at) - at)] if self.contains_place(at) else []
            )  # the pole's dot keeps its size
        return []

    def shows_whole(self, label: Label) -> bool:
        """Whether the object of a label is wholly visible."""
        return all(map(self.contains_place, label.at if isinstance(label.at, tuple) else (label.at,)))

    def labels_only_in_detail(self, named: Sequence[Label]) -> list[Label]:
        """The labels that are read in the detail alone: those of vectors wholly visible there, where they are many."""
        held = [x for x in named if self.shows_whole(x)]
        return held if len(held) > MOST_LABELS_ON_PLAN else []

    def label(self, label: Label) -> Label:
        """The label in its enlarged place."""
        z = label.at
        at = (self.enlarged_place(z[0]), self.enlarged_place(z[1])) if isinstance(z, tuple) else self.enlarged_place(z)
        return replace(label, at=at, clear=0.7)


def look_like_one_line(one: Ends, other: Ends, shown: Iterable[Detail]) -> bool:
    """Whether two vectors are read as one line, on the plan or in a detail that shows one of them whole."""
    seen = (
        (d.visible_stroke_part(one), d.visible_stroke_part(other))
        for d in shown
        if all(map(d.contains_place, one)) or all(map(d.contains_place, other))
    )
    pairs = ((one, other), *((a, b) for a, b in seen if a and b))
    return any(lines_overlap(a, b, COINCIDENT_LINES_MM) or lines_overlap(b, a, COINCIDENT_LINES_MM) for a, b in pairs)


def make_details(vectors: Iterable[Ends], letters: Sequence[str], alone: bool = True) -> list[Detail]:
    """The details of the vectors that are too short; neighbours share one, unless they are too short there. Unless
    ``alone``, a single vector that would need a very large enlargement has none: it is a point with its name."""
    groups = group_short_vectors(vectors, alone)
    return [Detail(*_circle_and_enlargement(group), letter) for group, letter in zip(groups, letters, strict=False)]


def _circle_and_enlargement(group: Sequence[Ends]) -> tuple[complex, float, int]:
    """The centre and radius of a detail of some vectors, and its enlargement."""
    low, high = bounding_corners(z for ends in group for z in ends)
    centre = (low + high) / 2
    radius = DETAIL_MARGIN_RATIO * max(abs(z - centre) for ends in group for z in ends)
    return (
        centre,
        radius,
        max((t for t in ENLARGEMENT_SCALES if t * radius <= MOST_DETAIL_RADIUS_MM), default=ENLARGEMENT_SCALES[0]),
    )


def group_short_vectors(vectors: Iterable[Ends], alone: bool = True) -> Groups:
    """Short vectors by details: neighbours together, and again, separately, those that are hardly visible there."""
    details = Groups()
    for group in _group_neighbours(ends for ends in vectors if length_of(ends) < LEAST_READABLE_VECTOR_MM):
        times = _circle_and_enlargement(group)[2]
        lost = [(a, b) for a, b in group if abs(b - a) * times < LEAST_VISIBLE_PART_MM]
        parted = len(lost) < len(group)
        details += [group, *group_short_vectors(lost)] if parted else [[ends] for ends in group]
    return [
        group
        for group in details
        if alone or len(group) > 1 or _circle_and_enlargement(group)[2] < MOST_SINGLE_ENLARGEMENT
    ]


def _group_neighbours(short: Iterable[Ends]) -> Groups:
    """Vectors in groups of neighbours."""
    groups: Groups = []
    for ends in short:
        near = [
            g for g in groups if any(abs(z - w) < SHARED_DETAIL_DISTANCE_MM for two in g for z in two for w in ends)
        ]
        groups = [g for g in groups if g not in near]
        groups.append([*(two for g in near for two in g), ends])
    return groups


def free_detail_letters(points: Iterable[str], alphabet: str) -> list[str]:
    """Letters for details: those that do not look like the name of a point."""
    taken = {p[:1].upper() for p in points}
    return [x for x in alphabet if LATIN_LOOK_ALIKES.get(x, x) not in taken]


def put_details_beside_plan(marks: Marks, drawn: Sequence[Marks]) -> Marks:
    """A plan with its details: in a row beneath it or in a column to its right, whichever takes less paper."""
    if not drawn:
        return marks
    x0, y0, x1, y1 = box_around_marks(marks)
    boxes = [box_around_marks(d) for d in drawn]
    wide = [b[2] - b[0] + DETAIL_GAP_MM for b in boxes]
    high = [b[3] - b[1] + DETAIL_GAP_MM for b in boxes]
    row = max(x1 - x0, sum(wide) - DETAIL_GAP_MM) * (y1 - y0 + max(high))
    column = (x1 - x0 + max(wide)) * max(y1 - y0, sum(high) - DETAIL_GAP_MM)
    placed = list(marks)
    x, y = ((x0 + x1 - sum(wide) + DETAIL_GAP_MM) / 2, y0 - DETAIL_GAP_MM) if row < column else (x1 + DETAIL_GAP_MM, y1)
    for one, box, w, h in zip(drawn, boxes, wide, high, strict=True):
        placed += [move_mark(m, complex(x - box[0], y - box[3])) for m in one]
        x, y = (x + w, y) if row < column else (x, y - h)
    return tuple(placed)
