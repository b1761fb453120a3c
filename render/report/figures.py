"""Figures of a report: charts, plans of positions side by side, the sketch of a crankshaft."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

from planes.crank_slider.pages import Chart, Drawn, Sketch
from planes.words import Lang
from render import charts
from render.charts.strokes import Picture
from render.paper.marks import Anchor, Arc, Arrow, Line, Mark, Text
from render.sheet.composer import Composer
from render.views import View, bounds, stacked, view
from render.views.plotted import of_position
from render.views.polygon import Polygon
from render.views.scheme import Scheme

WIDTH_MM = 170.0
GAP_MM = 8.0


@dataclass(frozen=True)
class Figure:
    """Marks in mm on a paper of their own size."""

    marks: tuple[Mark, ...]
    size: tuple[float, float]


def shown(block: Chart | Drawn | Sketch, lang: Lang) -> tuple[Sequence[Picture | Figure], str]:
    """What a block shows, and the title beneath."""
    match block:
        case Chart():
            return [chart(block, lang)], block.title
        case Drawn():
            return drawn(block, lang)
        case Sketch():
            return [sketch(block)], block.title


def chart(block: Chart, lang: Lang) -> Picture:
    """A chart of the report."""
    notes = [(n.x, n.y, n.text) for n in block.notes]
    axes = charts.Axes(block.x, block.y, block.equal, block.ticks)
    return charts.chart(block.curves, axes, notes, (WIDTH_MM, block.height_mm), lang)


def drawn(block: Drawn, lang: Lang) -> tuple[list[Figure], str]:
    """The plans of one position, side by side where they fit, and their title with every μ."""
    composer, plotted = Composer(block.scene, lang, block.position.plans), of_position(block.position)
    views, names = [], []
    for name in block.views:
        if name == "scheme":
            marks = Scheme(block.position, composer.naming).drawn()
            names.append(composer.mu(plotted, "position"))
        else:
            marks = Polygon(plotted, name, composer.naming, counted=composer.details).drawn()
            names.append(f"{composer.plan_name(name).lower()}, {composer.mu(plotted, name)}")
        said = composer.formulas(plotted, (name,), 2.5, "") if block.equations and name != "scheme" else None
        views.append(stacked(name, [v for v in (view(name, "", marks), said) if v]))
    return rows(views), f"{block.title}: {'; '.join(names)}"


def rows(views: list[View]) -> list[Figure]:
    """Views set in rows of the page's width."""
    found: list[list[View]] = []
    for v in views:
        if found and sum(x.width + GAP_MM for x in found[-1]) + v.width <= WIDTH_MM:
            found[-1].append(v)
        else:
            found.append([v])
    return [_row(row) for row in found]


def _row(views: list[View]) -> Figure:
    height = max(v.height for v in views) + 4
    marks: list[Mark] = []
    left = 2.0
    for v in views:
        marks += v.placed(left, height - 2)
        left += v.width + GAP_MM
    return Figure(tuple(marks), (left - GAP_MM + 2, height))


def sketch(block: Sketch) -> Figure:
    """The crankshaft as a broken bar: bearings, webs, pin, counterweights, lengths."""
    scale = 105.0 / block.span
    left, right = scale * block.webs, scale * (block.span - block.webs)
    pin, end = scale * block.pin, scale * block.span
    up, down = scale * block.r, -scale * block.radius
    bar = (0j, complex(left, 0), complex(left, up), complex(right, up), complex(right, 0), complex(end, 0))
    marks: list[Mark] = [Line((-12 + 0j, end + 12 + 0j), "axis", "axis"), Line(bar)]
    for x in (left, right):
        marks += [Line((complex(x, 0), complex(x, down)), "thin"), Arc(complex(x, down), 3.0)]
    for x, name in ((0.0, "A"), (end, "B")):
        marks += [Line((complex(x - 5, -8), complex(x, 0), complex(x + 5, -8)), closed=True),
                  Arc(complex(x, 0), 1.5, fill="paper"),
                  Text(name, complex(x - 9 if x == 0 else x + 6, -9), 5)]  # fmt: skip
    marks += _loads(block, left, right, pin, up, down)
    low = down - 14
    for a, b, name in ((0, left, "m"), (right, end, "m"), (left, pin, "a"), (pin, right, "b")):
        marks += _size(a, b, low, name)
    marks += [*_size(pin, end, low - 9, "n"), *_size(0, end, low - 18, "L")]
    box = bounds(marks)
    by = View("shaft", "", tuple(marks), box)
    return Figure(by.placed(2, by.height + 2), (by.width + 4, by.height + 4))


def _loads(block: Sketch, left: float, right: float, pin: float, up: float, down: float) -> list[Mark]:
    said = block.labels
    found: list[Mark] = [
        Arrow(complex(pin, up), complex(pin, up + 18), name="N_c"),
        Text(said["load"], complex(pin + 3, up + 12), 3.5),
    ]
    for k, x in enumerate((left, right)):
        side = -1 if k == 0 else 1
        anchor: Anchor = "end" if k == 0 else "start"
        found += [Arrow(complex(x, up), complex(x, up + 13), name="Φ"),
                  Arrow(complex(x, down - 3), complex(x, down - 12), name="Φ_cw"),
                  Text(said["web"], complex(x + 2.5 * side, up + 7), 3.5, anchor),
                  Text(said[f"weight_{k}"], complex(x + 4.5 * side, down - 8), 3.5, anchor)]  # fmt: skip
    return found


def _size(a: float, b: float, y: float, name: str) -> list[Mark]:
    ends = complex(a, y), complex(b, y)
    middle = (ends[0] + ends[1]) / 2
    ticks: list[Mark] = [Line((z - 2j, z + 3j), "thin", "dimension") for z in ends]
    return [*ticks, Arrow(middle, ends[0], "thin", "dimension"), Arrow(middle, ends[1], "thin", "dimension"),
            Text(name, middle + 1j, 3.5, "middle")]  # fmt: skip
