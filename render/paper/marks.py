"""The elements of a sheet: lines, arcs, arrows, filled shapes and text, in millimetres of paper.

A place is a complex number in mm from the lower left corner of the sheet, x to the right and y up. Every mark names its
``layer`` (its meaning); its appearance is decided by ``style`` alone, so widths and letters are never scaled by a
plan's μ. Back-ends know these six records and nothing else.
"""

from collections.abc import Iterator
from contextlib import AbstractContextManager, contextmanager
from contextvars import ContextVar
from typing import Literal, TypeVar

from planes.words.frozen import field, frozen, replace

Layer = Literal[
    "construction", "axis", "hatch", "table", "dimension", "frame", "scheme", "plan", "force", "result", "text"
]
"""From the lowest to the topmost: a paper-white disc hides only layers beneath it."""
Anchor = Literal["start", "middle", "end"]
Size = tuple[float, float]
"""Width and height."""
Polyline = tuple[complex, ...]


@frozen
class Face:
    """``font`` is the path of a font's file, "" for the built-in lettering; ``family`` the name of the font."""

    font: str = ""
    slanted: bool = False
    family: str = ""


BUILT_IN_FACE = Face()
Asked = TypeVar("Asked")
_chosen = ContextVar("face", default=BUILT_IN_FACE)


def current_face() -> Face:
    """The face of texts created now."""
    return _chosen.get()


def using_face(face: Face) -> AbstractContextManager[None]:
    """In this context, texts are created and measured in that face."""
    return using_setting(_chosen, face)


@contextmanager
def using_setting(asked: ContextVar[Asked], value: Asked) -> Iterator[None]:
    """In this context, the drawing setting has that value."""
    token = asked.set(value)
    try:
        yield
    finally:
        asked.reset(token)


@frozen
class Line:
    """A polyline through ``points`` (two or more), open or closed, in the line type of its ``style``.

    ``name`` gives the purpose of a line that does not show it ("leader").
    """

    points: Polyline
    style: str = "thick"
    layer: Layer = "scheme"
    closed: bool = False
    name: str = ""


@frozen
class Arc:
    """A circular arc about ``centre`` from ``start_deg`` counter-clockwise to ``end_deg`` (360 apart: a circle).

    ``fill`` "paper" paints the disc white first (a hinge), "ink" black, "none" leaves it open.
    """

    centre: complex
    radius: float
    start_deg: float = 0.0
    end_deg: float = 360.0
    style: str = "thick"
    layer: Layer = "scheme"
    fill: Literal["none", "paper", "ink"] = "none"


@frozen
class Arrow:
    """A straight arrow; the head is a filled triangle at ``end``. ``name`` is that of the vector ("v_CB")."""

    start: complex
    end: complex
    style: str = "thick"
    layer: Layer = "plan"
    name: str = ""


@frozen
class Shape:
    """A filled polygon."""

    points: tuple[complex, ...]
    layer: Layer = "scheme"
    fill: Literal["ink", "paper"] = "ink"


@frozen
class Text:
    """One line of text at its base line; ``text`` may hold _{…} and ^{…} for lower and upper indices.

    ``height`` is the height of capitals in mm; ``turn_deg`` rotates it about ``place``; ``face`` is its typeface; its
    letters are ``narrow`` times as wide as in that face.
    """

    text: str
    place: complex
    height: float = 3.5
    anchor: Anchor = "start"
    turn_deg: float = 0.0
    layer: Layer = "text"
    name: str = ""
    face: Face = field(default_factory=current_face)
    narrow: float = 1.0


@frozen
class Hatch:
    """A region filled with thin parallel strokes at ``angle_deg`` every ``gap`` mm."""

    points: tuple[complex, ...]
    angle_deg: float = 45.0
    gap: float = 1.0
    layer: Layer = "hatch"


Mark = Line | Arc | Arrow | Shape | Text | Hatch


def move_mark(mark: Mark, by: complex) -> Mark:
    """The same mark shifted ``by`` a vector in mm."""
    if isinstance(mark, Arrow):
        return replace(mark, start=mark.start + by, end=mark.end + by)
    if isinstance(mark, Arc):
        return replace(mark, centre=mark.centre + by)
    if isinstance(mark, Text):
        return replace(mark, place=mark.place + by)
    return replace(mark, points=tuple(p + by for p in mark.points))
