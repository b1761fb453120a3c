"""A view: one part of a sheet drawn about its own origin, in mm, with its title and its bounding box."""

from collections.abc import Iterable, Sequence
from functools import cached_property

from planes.words.frozen import frozen, replace
from planes.words.names import NameTuple
from render.labels.footprints import Bounds, box_around_marks, overprinted_labels
from render.paper.marks import Mark, Text, move_mark
from render.paper.style import figure_letter_height
from render.paper.symbols import Marks
from render.paper.typeset import ink_bounds, ink_width, plain_text, wrap_text

TITLE_LETTER_MM = 5.0  # letter height of titles
REMARK_LETTER_MM = 2.5
LEAST_REMARK_LETTERS = 24.0  # letters: a line of remarks beneath what is narrower
# how much longer than the others a line of remarks may be to avoid a single word on the last line
MOST_LINE_LENGTH_RATIO = 1.15
TITLE_GAP_MM = 4.0  # from a title to its view
MOST_INDENTATION_MM = 35.0  # largest indentation of a view relative to its title


@frozen
class View:
    """``key`` names the view for settings ("velocity"), ``title`` is lettered above it ("" for none), ``heading`` mm
    high; ``body`` and ``inked`` are the part beneath the title, and its box; ``unseen`` are sentences about parts that
    are missing; ``step`` is its part of the calculation; views of one ``block`` are put beneath each other where there
    is room, with their ``plumb`` lines, if any, on one vertical."""

    key: str
    title: str
    body: Marks
    inked: Bounds
    figure: bool = False  # a scheme or a plan: read one after another
    unseen: NameTuple = ()
    step: str = ""
    heading: float = TITLE_LETTER_MM
    extra: bool = False  # shown only if the format that holds all others has room for it too
    block: str = ""
    plumb: float | None = None  # x of the body

    @cached_property
    def titled_marks_and_box(self) -> tuple[Marks, Bounds]:
        """The marks with the title, which begins at their left edge, and the box of all."""
        if not self.title:
            return self.body, self.inked
        left, low, right, top = self.inked
        x0, y0, x1, y1 = ink_bounds(self.title, self.heading)
        text = Text(self.title, complex(left - x0, top + TITLE_GAP_MM - y0), self.heading, name=f"title {self.key}")
        return (*self.body, text), (left, low, max(right, left - x0 + x1), text.place.imag + y1)

    @property
    def marks(self) -> Marks:
        """All marks, with the title."""
        return self.titled_marks_and_box[0]

    @property
    def box(self) -> Bounds:
        """Its bounding box, with the title."""
        return self.titled_marks_and_box[1]

    @cached_property
    def unreadable_labels(self) -> NameTuple:
        """The labels that found no place."""
        return tuple(dict.fromkeys(map(plain_text, overprinted_labels(self.marks))))

    @property
    def width(self) -> float:
        """Width of the box in mm."""
        return self.box[2] - self.box[0]

    @property
    def height(self) -> float:
        """Height of the box in mm."""
        return self.box[3] - self.box[1]

    def marks_placed_at(self, left: float, top: float) -> Marks:
        """The marks with the upper left corner of the box at a place of the sheet."""
        by = complex(left - self.box[0], top - self.box[3])
        return tuple(move_mark(mark, by) for mark in self.marks)


def make_view(key: str, title: str, marks: Iterable[Mark], figure: bool = False, unseen: Iterable[str] = ()) -> View:
    """A view of marks, with their bounding box."""
    held = tuple(marks)
    return View(key, title, held, box_around_marks(held), figure, tuple(unseen))


def remark_texts(text: str, marks: Iterable[Mark]) -> list[Text]:
    """A remark about the marks, in small letters beneath them, from their left edge, no wider than they are."""
    x0, y0, x1, _ = box_around_marks(tuple(marks))
    high = figure_letter_height(REMARK_LETTER_MM)
    wide = max(x1 - x0, LEAST_REMARK_LETTERS * high)
    lines = wrap_text(text, wide, high)
    if " " not in lines[-1]:
        lines = wrap_text(text, min(wide, MOST_LINE_LENGTH_RATIO * ink_width(text, high) / len(lines)), high)
    return [Text(t, complex(x0, y0 - 2.5 - high - 1.7 * high * k), high, name="remark") for k, t in enumerate(lines)]


def paragraph_view(key: str, title: str, text: str, width: float, letter: float) -> View:
    """Sentences in lines within a given width in mm."""
    lines = wrap_text(text, width, letter)
    return make_view(key, title, [Text(line, -1.7j * letter * k, letter) for k, line in enumerate(lines)])


def stack_views(key: str, views: Sequence[View], gap: float = 6.0, centred: bool = False) -> View:
    """Views one beneath another, flush left or centred, as one view with the title of the first."""
    marks = list[Mark]()
    y = 0.0
    boxes = []
    for one in (replace(views[0], title=""), *views[1:]):
        by = complex(-(one.box[0] + one.box[2]) / 2 if centred else -one.box[0], y - one.box[3])
        marks += (move_mark(mark, by) for mark in one.marks)
        left, low, right, top = one.box
        boxes.append((left + by.real, low + by.imag, right + by.real, top + by.imag))
        y = boxes[-1][1] - gap
    lefts, lows, rights, tops = zip(*boxes, strict=True)
    box = (min(lefts), min(lows), max(rights), max(tops))
    unseen = tuple(s for v in views for s in v.unseen)
    return replace(views[0], key=key, body=tuple(marks), inked=box, unseen=unseen)


def align_plumb_lines(views: Sequence[View]) -> list[View]:
    """The views indented from a common left edge so that their plumb lines coincide; unchanged if one would be too far
    from its title."""
    lines = [None if v.plumb is None else v.plumb - v.inked[0] for v in views]
    far = max((x for x in lines if x is not None), default=0.0)
    sets = [0.0 if x is None else far - x for x in lines]
    if max(sets, default=0.0) > MOST_INDENTATION_MM:
        return list(views)
    return [replace(v, inked=(v.inked[0] - by, *v.inked[1:])) if by else v for v, by in zip(views, sets, strict=True)]


def put_views_in_row(views: Sequence[View], gap: float = 8.0, top: float | None = None, left: float = 0.0) -> View:
    """Views side by side as one view, their lower edges in line, or their upper ones at ``top``."""
    marks = list[Mark]()
    for one in views:
        marks += one.marks_placed_at(left, one.height if top is None else top)
        left += one.width + gap
    return View("row", "", tuple(marks), (0.0, 0.0, left - gap, max(one.height for one in views)))
