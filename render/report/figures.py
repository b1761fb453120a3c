"""Figures of a report: charts, views of positions side by side, sketches of a crankshaft."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from planes.plans.assur.alignment import aligned
from planes.solving.document import Chart, DrawnViews, Figure, ShaftSketch
from planes.words.names import CREMONA, links_of
from planes.words.naming import Naming
from render import charts
from render.charts.strokes import Picture
from render.files import Page, svg
from render.files.pdf import POINTS_PER_MM, draw_marks, png_of
from render.paper.letters import tagged
from render.report.shaft import shaft_view
from render.sheet.composer import Composer
from render.sheet.force_sheet import ForceSheet
from render.sheet.studio_code import ON_TASK_MM, code_view
from render.views import View, beside, stacked, view
from render.views.alignment import alignment_view
from render.views.cremona import Cremona
from render.views.instant_centre import instant_centre
from render.views.moments import Lever
from render.views.plotted import Plotted, with_links_apart
from render.views.polygon import Polygon
from render.views.scheme import Scheme
from render.views.special_points import special_points

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

WIDTH_MM = 170.0
GAP_MM = 8.0
LETTER_MM = {True: 3.5, False: 2.5}  # heights of equations alone, and of those beneath their plan
DPI = 220


class MarkedFigure(Page):
    """Marks in mm on a paper of their size; like a :class:`Picture` it knows its size in points and draws itself."""

    @property
    def width(self) -> float:
        """Points."""
        return POINTS_PER_MM * self.size[0]

    @property
    def height(self) -> float:
        """Points."""
        return POINTS_PER_MM * self.size[1]

    def svg(self, label: str) -> str:
        """Inline SVG; groups lose their ids, since a page may hold many drawings."""
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

    canvas = Canvas("", (picture.width, picture.height), invariant=1, pageCompression=0)
    picture.draw(canvas)
    return png_of(canvas.getpdfdata(), DPI)


class DocumentSetter:
    """Sets the blocks of one document: names in its lettering, and its figures."""

    def __init__(self, naming: Naming) -> None:
        self.naming = naming
        self.composers: dict[int, Composer] = {}  # by the scene

    def text(self, text: str, plan: str = "") -> str:
        """Running text in tags."""
        return tagged(text, self.naming, plan)

    def shown(self, figure: Figure) -> tuple[list[Shown], str]:
        """The pictures of a figure, none where there is nothing to see, and its caption."""
        match figure.of:
            case Chart() as chart:
                return [charts.chart(chart, WIDTH_MM, self.naming.lang)], figure.caption
            case ShaftSketch() as shaft:
                return [_row([shaft_view(shaft)])], figure.caption
            case DrawnViews() as drawn:
                return self.drawn(drawn, figure.caption)

    def drawn(self, block: DrawnViews, caption: str) -> tuple[list[Shown], str]:
        """The views of one position, side by side where they fit; a caption with every μ if requested."""
        composer = self.composers.setdefault(
            id(block.scene), Composer(block.scene, self.naming.lang, block.position.plans)
        )
        plotted, _ = with_links_apart(block.position)
        views = []
        for names in block.views:
            held = [v for name in names if (v := _view(name, block, composer, plotted, len(names) == 1))]
            views += [stacked(held[0].key, held) if held[1:] else held[0]] if held else []
        if block.scales:
            caption += ": " + "; ".join(_scaled(names[0], composer, plotted) for names in block.views)
        return rows(views), caption


def _view(name: str, block: DrawnViews, composer: Composer, plotted: Plotted, alone: bool) -> View | None:
    kind, _, asked_for = name.partition(" ")
    position, naming = block.position, composer.naming
    if kind in ("asked", "equations"):
        return composer.formulas(plotted, (asked_for,), LETTER_MM[alone], "", kind == "asked")
    if name == CREMONA:
        return view(name, "", Cremona(plotted, naming).drawn())
    if kind == "beam" or (kind in ("scheme", "structure") and position.plans.figure):
        of_statics = composer.beam(position) if kind == "beam" else composer.space(position, kind == "structure")
        return of_statics and replace(of_statics, title="")
    if kind == "scheme":
        return view(name, "", Scheme(position, naming).drawn(True, *special_points(position, naming)))
    if kind == "loaded":
        forces = ForceSheet(composer)
        return forces.alone(position, asked_for) if asked_for else replace(forces.loaded(position), title="")
    if kind == "group" and (group := ForceSheet(composer).group(position, asked_for, links_of(asked_for))):
        return replace(group, title="")
    if kind == "studio":
        return code_view(block.scene, composer.lang, ON_TASK_MM)
    if kind == "lever":
        return view(name, "", Lever(position, naming).drawn())
    if kind == "centre":
        return instant_centre(position, asked_for, naming)
    if kind == "self-aligning":
        alignment = aligned(position.plans, block.scene.file)
        return alignment_view(position, alignment, naming, "", LETTER_MM[alone])
    if plotted.still(name):
        return None
    return view(name, "", Polygon(plotted, name, naming, counted=composer.details).drawn())


def _scaled(name: str, composer: Composer, plotted: Plotted) -> str:
    """A view's name with its μ, unbroken across lines."""
    mu = composer.mu(plotted, "position" if name == "scheme" else name).replace(" ", "\u00a0")
    return mu if name == "scheme" else f"{composer.plan_name(name).lower()}, {mu}"


def rows(views: list[View]) -> list[Shown]:
    """Views set in rows of the page's width."""
    rows_of_views = list[list[View]]()
    for v in views:
        if not rows_of_views or sum(x.width + GAP_MM for x in rows_of_views[-1]) + v.width > WIDTH_MM:
            rows_of_views.append([])
        rows_of_views[-1].append(v)
    return [_row(row) for row in rows_of_views]


def _row(views: list[View]) -> MarkedFigure:
    height = max(v.height for v in views) + 4
    row = beside(views, GAP_MM, height - 2, 2.0)
    return MarkedFigure(row.marks, (row.box[2] + 2, height))
