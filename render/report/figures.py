"""Figures of a report: charts, views of positions side by side, sketches of a crankshaft."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import TYPE_CHECKING

from planes.plans.assur.alignment import self_aligning_variant
from planes.solving.document import Chart, DrawnViews, Figure, ShaftSketch
from planes.words.names import CREMONA_PLAN, NO_PLAN, SCHEME_PLAN, PlanId
from planes.words.naming import Naming
from render import charts
from render.charts.strokes import Picture
from render.files import Page, svg
from render.files.pdf import POINTS_PER_MM, draw_marks, png_of_pdf
from render.paper.letters import tagged_sentence
from render.report.shaft import shaft_view
from render.sheet.composer import Composer
from render.sheet.force_sheet import ForceSheet
from render.sheet.studio_code import CODE_ON_TASK_MM, studio_code_view
from render.views import View, make_view, put_views_in_row, stack_views
from render.views.alignment import alignment_view
from render.views.cremona import Cremona
from render.views.instant_centre import instant_centre_scheme
from render.views.moments import Lever
from render.views.plotted import Plotted, plot_with_single_links
from render.views.polygon import Polygon
from render.views.scheme import Scheme
from render.views.special_points import special_point_marks

if TYPE_CHECKING:
    from reportlab.pdfgen.canvas import Canvas

PAGE_WIDTH_MM = 170.0
ROW_GAP_MM = 8.0
EQUATION_LETTER_MM = {True: 3.5, False: 2.5}  # heights of equations alone, and of those beneath their plan
RASTER_DPI = 220


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

    def inline_svg(self, label: str) -> str:
        """Inline SVG; groups lose their ids, since a page may hold many drawings."""
        text = svg.write(self.marks, self.size, label).decode().partition("?>\n")[2]
        return re.sub(r' (id|xml:lang|lang)="[^"]*"', "", text).strip()

    def draw(self, canvas: Canvas) -> None:
        """Draw on a reportlab canvas, the lower left corner in its origin."""
        canvas.scale(POINTS_PER_MM, POINTS_PER_MM)
        draw_marks(canvas, self.marks)


Shown = Picture | MarkedFigure


def png_of_picture(picture: Shown) -> bytes:
    """A picture as a PNG file."""
    from reportlab.pdfgen.canvas import Canvas

    canvas = Canvas("", (picture.width, picture.height), invariant=1, pageCompression=0)
    picture.draw(canvas)
    return png_of_pdf(canvas.getpdfdata(), RASTER_DPI)


class DocumentSetter:
    """Sets the blocks of one document: names in its lettering, and its figures."""

    def __init__(self, naming: Naming) -> None:
        self.naming = naming
        self.composers: dict[int, Composer] = {}  # by the scene

    def text(self, text: str, plan: PlanId = NO_PLAN) -> str:
        """Running text in tags."""
        return tagged_sentence(text, self.naming, plan)

    def shown(self, figure: Figure) -> tuple[list[Shown], str]:
        """The pictures of a figure, none where there is nothing to see, and its caption."""
        match figure.of:
            case Chart() as chart:
                return [charts.draw_chart(chart, PAGE_WIDTH_MM, self.naming.lang)], figure.caption
            case ShaftSketch() as shaft:
                return [_row_figure([shaft_view(shaft)])], figure.caption
            case DrawnViews() as drawn:
                return self.drawn(drawn, figure.caption)

    def drawn(self, block: DrawnViews, caption: str) -> tuple[list[Shown], str]:
        """The views of one position, side by side where they fit; a caption with every μ if requested."""
        composer = self.composers.setdefault(
            id(block.scene), Composer(block.scene, self.naming.lang, block.position.plans)
        )
        plotted, _ = plot_with_single_links(block.position)
        views = []
        for names in block.views:
            held = [v for name in names if (v := _view_by_name(name, block, composer, plotted, len(names) == 1))]
            if held:
                views.append(stack_views(held[0].key, held) if held[1:] else held[0])
        if block.scales:
            caption += ": " + "; ".join(_name_with_mu(names[0], composer, plotted) for names in block.views)
        return views_in_rows(views), caption


def _view_by_name(name: str, block: DrawnViews, composer: Composer, plotted: Plotted, alone: bool) -> View | None:
    kind, _, asked_for = name.partition(" ")
    plan = PlanId.read(asked_for or name)
    position = block.position
    naming = composer.naming
    if kind in ("asked", "equations"):
        return composer.equations_view(plotted, (plan,), EQUATION_LETTER_MM[alone], "", kind == "asked")
    if name == CREMONA_PLAN:
        return make_view(name, "", Cremona(plotted, naming).drawn_marks())
    if kind == "beam" or (kind in ("scheme", "structure") and position.plans.figure):
        of_statics = (
            composer.beam_view(position)
            if kind == "beam"
            else composer.space_diagram_view(position, kind == "structure")
        )
        return of_statics and replace(of_statics, title="")
    if kind == "scheme":
        return make_view(name, "", Scheme(position, naming).drawn_marks(True, *special_point_marks(position, naming)))
    if kind == "loaded":
        forces = ForceSheet(composer)
        if asked_for:
            return forces.single_link_view(position, asked_for)
        return replace(forces.loaded_scheme_view(position), title="")
    if kind == "group" and (group := ForceSheet(composer).group_view(position, plan, plan.links)):
        return replace(group, title="")
    if kind == "studio":
        return studio_code_view(block.scene, composer.lang, CODE_ON_TASK_MM)
    if kind == "lever":
        return make_view(name, "", Lever(position, naming).drawn_marks())
    if kind == "centre":
        return instant_centre_scheme(position, asked_for, naming)
    if kind == "self-aligning":
        alignment = self_aligning_variant(position.plans, block.scene.file)
        return alignment_view(position, alignment, naming, "", EQUATION_LETTER_MM[alone])
    if plotted.has_only_pole(plan):
        return None
    return make_view(name, "", Polygon(plotted, plan, naming, counted=composer.details).drawn_marks())


def _name_with_mu(name: str, composer: Composer, plotted: Plotted) -> str:
    """A view's name with its μ, unbroken across lines."""
    plan = SCHEME_PLAN if name == "scheme" else PlanId.read(name)
    mu = composer.title_mu(plotted, plan).replace(" ", "\u00a0")
    if name == "scheme":
        return mu
    return f"{composer.plan_name(plan).lower()}, {mu}"


def views_in_rows(views: list[View]) -> list[Shown]:
    """Views set in rows of the page's width."""
    rows_of_views = list[list[View]]()
    for v in views:
        if not rows_of_views or sum(x.width + ROW_GAP_MM for x in rows_of_views[-1]) + v.width > PAGE_WIDTH_MM:
            rows_of_views.append([])
        rows_of_views[-1].append(v)
    return [_row_figure(row) for row in rows_of_views]


def _row_figure(views: list[View]) -> MarkedFigure:
    height = max(v.height for v in views) + 4
    row = put_views_in_row(views, ROW_GAP_MM, height - 2, 2.0)
    return MarkedFigure(row.marks, (row.box[2] + 2, height))
