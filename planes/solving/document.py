"""The parts of a document, whatever its file format: headings, paragraphs, formulas, tables, figures.

In every text _{…} and ^{…} are indices, ⟨…⟩ the name of a vector or a value. The layout is decided elsewhere.
"""

from collections.abc import Iterator, Mapping

from planes.geometry.arrays import Array
from planes.scene import Scene
from planes.solving import Position
from planes.words.frozen import field, frozen
from planes.words.names import NO_PLAN, NamePair, NameTuple, PlanId


@frozen
class Heading:
    """A heading; level 0 is the document's own title."""

    text: str
    level: int = 1


@frozen
class Cover:
    """A title page, after which the ``contents`` are listed: the ``kind`` of document and ``of`` which mechanism, the
    organisation ``above``, the ``people`` whose work it is, the date at its ``foot``."""

    kind: str
    contents: str
    of: str
    above: NameTuple
    people: NameTuple
    foot: str

    @property
    def text(self) -> str:
        """The title in a line."""
        return f"{self.kind}. {self.of}" if self.of else self.kind


@frozen
class Paragraph:
    """``number`` is that of a step; its marks are on ``plan``.

    ``why``: it gives the reason of what was said before; ``mistake``: it says where a source text is wrong.
    """

    text: str
    number: int = 0
    plan: PlanId = NO_PLAN
    why: bool = False
    mistake: bool = False


@frozen
class Formula:
    """A formula (mathtext) in pieces that a line may break between, and its number."""

    parts: tuple[str, ...]
    number: str = ""

    @property
    def tex_source(self) -> str:
        """The whole of it."""
        return "".join(self.parts)


@frozen
class DocumentTable:
    """A table with its caption; the first row is the head."""

    caption: str
    rows: tuple[tuple[str, ...], ...]


@frozen
class PlottedLine:
    """``style`` is the index of its style (colour and dashes); ``label`` "" keeps it out of the legend."""

    x: Array
    y: Array
    label: str = ""
    style: int = 0


@frozen
class Chart:
    """Curves over x. ``equal``: both axes to one scale; ``ticks``: spacing of the marks on x, 0 for the default.

    ``notes`` are words beside points: x, y and the word.
    """

    x: str
    y: str
    curves: tuple[PlottedLine, ...]
    notes: tuple[tuple[float, float, str], ...] = ()
    equal: bool = False
    ticks: float = 0.0
    height_mm: float = 62.0


@frozen
class DrawnViews:
    """Views of one position, side by side where they fit, those of one tuple beneath each other.

    A view is "scheme", a plan, "equations …" of a plan, "loaded" (the mechanism with its loads), "loaded …" (a link
    with all forces on it), "group …" (the links of a force polygon with their forces and arms), "lever", "centre …" (of
    a link's velocities), "studio" (the QR code that opens the scene there); ``scales``: the caption continues with
    every plan and its μ.
    """

    scene: Scene
    position: Position
    views: tuple[NameTuple, ...]
    scales: bool = False


@frozen
class ShaftSketch:
    """The crankshaft on its bearings; numbers in metres. ``masses`` are named by their places ("pin", "weight_0"),
    ``forces`` by their places and directions ("up", "down" in the plane of the crank, "across" perpendicular to it),
    the ``sizes`` shown by their signs."""

    span: float
    pin: float
    webs: float
    r: float
    radius: float
    masses: Mapping[str, str] = field(default_factory=dict)
    forces: Mapping[NamePair, str] = field(default_factory=dict)
    sizes: Mapping[str, str] = field(default_factory=dict)


@frozen
class Figure:
    """A chart, drawn views or a sketch, with its caption."""

    of: Chart | DrawnViews | ShaftSketch
    caption: str = ""


Block = Cover | Heading | Paragraph | Formula | DocumentTable | Figure
Blocks = Iterator[Block]
