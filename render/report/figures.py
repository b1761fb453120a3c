"""Figures of a report: charts, plans of positions side by side, the sketch of a crankshaft."""

from __future__ import annotations

import io
import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from planes.plans.alignment import aligned
from planes.solving.document import Chart, DrawnViews, Figure, ShaftSketch
from planes.words import Lang
from render import charts
from render.charts.strokes import Picture
from render.files import Page, svg
from render.files.pdf import POINTS_PER_MM, draw_marks, png_of
from render.labels.footprints import bounds
from render.paper.marks import Anchor, Arc, Arrow, Line, Mark, Text
from render.sheet.composer import Composer
from render.views import View, beside, stacked, view
from render.views.alignment import alignment_view
from render.views.plotted import Plotted, of_position
from render.views.polygon import Polygon
from render.views.scheme import Scheme

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

WIDTH_MM = 170.0
GAP_MM = 8.0
LETTER_MM = {True: 3.5, False: 2.5}  # of equations that stand alone, and of those beneath their plan
DPI = 220


class MarkedFigure(Page):
    """Marks in mm on a paper of their own size; like a :class:`Picture` it knows its points and draws itself."""

    @property
    def width(self) -> float:
        """Points."""
        return POINTS_PER_MM * self.size[0]

    @property
    def height(self) -> float:
        """Points."""
        return POINTS_PER_MM * self.size[1]

    def svg(self, label: str) -> str:
        """Inline SVG; groups lose their ids, for a page may hold many drawings."""
        text = svg.write(self.marks, self.size, label).decode().partition("?>\n")[2]
        return re.sub(r' (id|xml:lang|lang)="[^"]*"', "", text).strip()

    def draw(self, canvas: Canvas) -> None:
        """Draw on a reportlab canvas, the lower left corner in its origin."""
        canvas.scale(POINTS_PER_MM, POINTS_PER_MM)
        draw_marks(canvas, self.marks)


Shown = Picture | MarkedFigure


def raster(picture: Shown) -> bytes:
    """A picture as a PNG file."""
    from reportlab.pdfgen.canvas import Canvas

    data = io.BytesIO()
    canvas = Canvas(data, (picture.width, picture.height), invariant=1)
    picture.draw(canvas)
    canvas.save()
    return png_of(data.getvalue(), DPI)


@dataclass
class Studio:
    """Draws the figures of one document."""

    lang: Lang
    composers: dict[int, Composer] = field(default_factory=dict)  # by the scene

    def shown(self, figure: Figure) -> tuple[list[Shown], str]:
        """The pictures of a figure, none where there is nothing to be seen, and what stands beneath."""
        match figure.of:
            case Chart() as chart:
                return [charts.chart(chart, WIDTH_MM, self.lang)], figure.caption
            case ShaftSketch() as shaft:
                return [sketch(shaft)], figure.caption
            case DrawnViews() as drawn:
                return self.drawn(drawn, figure.caption)

    def drawn(self, block: DrawnViews, caption: str) -> tuple[list[Shown], str]:
        """The views of one position, side by side where they fit; a caption with every μ if it is asked for."""
        composer = self.composers.setdefault(id(block.scene), Composer(block.scene, self.lang, block.position.plans))
        plotted = of_position(block.position)
        views = []
        for names in block.views:
            held = [v for name in names if (v := _view(name, block, composer, plotted, len(names) == 1))]
            views += [stacked(held[0].key, held) if held[1:] else held[0]] if held else []
        if block.scales:
            caption += ": " + "; ".join(_scaled(names[0], composer, plotted) for names in block.views)
        return rows(views), caption


def _view(name: str, block: DrawnViews, composer: Composer, plotted: Plotted, alone: bool) -> View | None:
    kind, _, plan = name.partition(" ")
    if plan:
        return composer.formulas(plotted, (plan,), LETTER_MM[alone], "")
    if kind == "scheme":
        return view(name, "", Scheme(block.position, composer.naming).drawn())
    if kind == "self-aligning":
        found = aligned(block.position.plans, block.scene.file)
        return alignment_view(block.position, found, composer.naming, "", LETTER_MM[alone])
    if plotted.still(name):
        return None
    return view(name, "", Polygon(plotted, name, composer.naming, counted=composer.details).drawn())


def _scaled(name: str, composer: Composer, plotted: Plotted) -> str:
    """A view's name with its μ, which no line breaks."""
    mu = composer.mu(plotted, "position" if name == "scheme" else name).replace(" ", "\u00a0")
    return mu if name == "scheme" else f"{composer.plan_name(name).lower()}, {mu}"


def rows(views: list[View]) -> list[Shown]:
    """Views set in rows of the page's width."""
    found: list[list[View]] = []
    for v in views:
        if not found or sum(x.width + GAP_MM for x in found[-1]) + v.width > WIDTH_MM:
            found.append([])
        found[-1].append(v)
    return [_row(row) for row in found]


def _row(views: list[View]) -> MarkedFigure:
    height = max(v.height for v in views) + 4
    row = beside(views, GAP_MM, height - 2, 2.0)
    return MarkedFigure(row.marks, (row.box[2] + 2, height))


def sketch(block: ShaftSketch) -> MarkedFigure:
    """The crankshaft as a broken bar: bearings, webs, pin, counterweights, lengths."""
    scale = 105.0 / block.span
    left, right = scale * block.webs, scale * (block.span - block.webs)
    pin, end = scale * block.pin, scale * block.span
    up, down = scale * block.r, -scale * block.radius
    bar = (0j, complex(left, 0), complex(left, up), complex(right, up), complex(right, 0), complex(end, 0))
    marks: list[Mark] = [Line((-12 + 0j, end + 12 + 0j), "axis", "axis"), Line(bar)]
    for x in (left, right):
        marks += [Line((complex(x, 0), complex(x, down)), "thin"), Arc(complex(x, down), 3.0)]
    for z, aside, name in ((0j, -9, "A"), (complex(end, 0), 6, "B")):
        marks += [Line((z - 5 - 8j, z, z + 5 - 8j), closed=True), Arc(z, 1.5, fill="paper")]
        marks.append(Text(name, z + aside - 9j, 5))
    marks += _loads(block, left, right, pin, up, down)
    above = ((0, left, "m"), (right, end, "m"), (left, pin, "a"), (pin, right, "b"))
    for k, sizes in enumerate((above, ((pin, end, "n"),), ((0, end, "L"),))):
        for a, b, name in sizes:
            marks += _size(a, b, down - 14 - 9 * k, name)
    return _row([View("shaft", "", tuple(marks), bounds(marks))])


def _loads(block: ShaftSketch, left: float, right: float, pin: float, up: float, down: float) -> list[Mark]:
    said, top = block.labels, complex(pin, up)
    found: list[Mark] = [Arrow(top, top + 18j, name="N_c"), Text(said["load"], top + 3 + 12j, 3.5)]
    sides: tuple[tuple[int, float, Anchor], ...] = ((-1, left, "end"), (1, right, "start"))
    for k, (side, x, anchor) in enumerate(sides):
        found += [
            Arrow(complex(x, up), complex(x, up + 13), name="Φ"),
            Arrow(complex(x, down - 3), complex(x, down - 12), name="Φ_cw"),
            Text(said["web"], complex(x + 2.5 * side, up + 7), 3.5, anchor),
            Text(said[f"weight_{k}"], complex(x + 4.5 * side, down - 8), 3.5, anchor),
        ]
    return found


def _size(a: float, b: float, y: float, name: str) -> list[Mark]:
    ends = complex(a, y), complex(b, y)
    middle = (ends[0] + ends[1]) / 2
    ticks = (Line((z - 2j, z + 3j), "thin", "dimension") for z in ends)
    arrows = (Arrow(middle, z, "thin", "dimension") for z in ends)
    return [*ticks, *arrows, Text(name, middle + 1j, 3.5, "middle")]
