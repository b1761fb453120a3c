"""A moving mechanism, with its plans beside it, as an animation: GIF, SVG or MP4."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from planes.diagrams.turn import span_of
from planes.plans.scales import FIT_MM, drawn_in_si, fitting, leaders, sides
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.scene.files import keep
from planes.solving import Position, position
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, PlanFailure
from planes.words.names import POLE, kind_of
from planes.words.waiting import bar
from render.files import moving
from render.labels import place
from render.labels.footprints import Bounds
from render.paper.marks import Mark, Text, lettered, moved
from render.paper.outlines import face_of
from render.paper.symbols import dot
from render.paper.typeset import ink_width
from render.sheet.composer import Composer, drawn_plans
from render.views import TITLE_GAP, TITLE_MM, View, view
from render.views.plotted import Plotted, of_position
from render.views.polygon import Polygon
from render.views.scheme import Scheme

FRAMES = 60
"""Positions of a whole turn: one every 6°."""
NEAR_END = 0.05
"""Part of a limited range left out at each end, where velocities grow without bound."""
GAP_MM, MARGIN_MM = 12.0, 6.0
LINE = 1.6
"""The line spacing of a title, in letter heights."""
ASPECT = 16 / 9
"""The aspect ratio of a slide; figures are arranged to come close to it."""

Frame = tuple[Mark, ...]


def animate(scene: Scene, output: str | Path, lang: Lang, frames: int = FRAMES, seconds: float = 6.0) -> None:
    """Write the animation of a scene; one turn (or one way there and back) takes a given time in s.

    :class:`PlanesError` for an unknown suffix, fewer than two frames, or a scene in which nothing moves.
    """
    suffix = Path(output).suffix.lower()
    if suffix not in moving.SUFFIXES:
        raise PlanesError(Phrase("bad_film_suffix", file=str(output), known=moving.SUFFIXES))
    if frames < 2 or not seconds > 0:
        raise PlanesError(Phrase("animation_frames", frames=frames, seconds=seconds))
    if scene.mechanism is None:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    with lettered(face_of(scene)), bar() as step:
        drawn, round_trip = positions(scene, frames, lang)
        pages, size = laid_out(scene, drawn, lang)
        shown = [*pages, *pages[-2:0:-1]] if round_trip else pages
        data = moving.written(shown, size, seconds, suffix, step, scene.title.get(lang) or scene.file, lang)
    keep(data, output)


def positions(scene: Scene, frames: int, lang: Lang) -> tuple[list[Position], bool]:
    """Positions with one μ per plan, evenly over the turn; True if the mechanism moves to and fro instead."""
    plans = scene_plans(scene)
    span = span_of(plans)
    reach = span if span.whole else span.inner(NEAR_END)
    values = reach.values(frames)[: frames if span.whole else None]
    scales = common_scales(scene, values)
    drawn = []
    for value in values:
        try:
            drawn.append(position(replace(scene, mu=scales), plans, None, value, None, lang))
        except PlanFailure:
            continue  # a failed position has no picture
    if len(drawn) < 2:
        raise PlanesError(Phrase("animation_still", file=scene.file))
    return drawn, not span.whole


def common_scales(scene: Scene, values: Sequence[float]) -> dict[str, float | None]:
    """The μ of each kind of plan: the largest standard one with which it fits in all positions."""
    plans, sizes = scene_plans(scene), dict[str, float]()
    for value in values:
        try:
            drawing = drawn_in_si(plans, plans.at(value)[plans.drive_given])
        except PlanFailure:
            continue
        for plan in plans.drawn:
            if plan != "lever":
                sizes[plan] = max(sizes.get(plan, 0.0), *sides(drawing, plan))
    largest = {kind_of(plan): sizes[leader] for plan, leader in leaders(sizes).items() if sizes[leader]}
    return {kind: fitting(kind, size, FIT_MM[kind]) for kind, size in largest.items()}


def laid_out(scene: Scene, drawn: Sequence[Position], lang: Lang) -> tuple[list[Frame], tuple[float, float]]:
    """The marks of each frame, and the size of the picture in mm: figures side by side, with fixed poles."""
    composer = Composer(scene, lang, drawn[0].plans)
    names = figures_of(drawn)
    frames = [{name: figure(composer, one, name) for name in names} for one in drawn]
    cells = {name: cell([frame[name] for frame in frames]) for name in names}
    arranged = [arrangement(cells, some) for some in (1, 2, len(names))]
    places, size = min(arranged, key=lambda one: abs(math.log(one[1][0] / one[1][1] / ASPECT)))
    return [tuple(placed(frame, cells, places)) for frame in frames], size


def cell(views: Sequence[View]) -> Bounds:
    """The box around a figure in all its frames, with the lines of its title above."""
    lefts, lows, rights, tops = zip(*(one.inked for one in views), strict=True)
    titles = views[0].title.split(", ")
    wide = max(ink_width(line, TITLE_MM) for line in titles)
    high = TITLE_GAP + LINE * TITLE_MM * len(titles)
    return min(lefts), min(lows), max(*rights, min(lefts) + wide), max(tops) + high


def arrangement(cells: Mapping[str, Bounds], columns: int) -> tuple[dict[str, complex], tuple[float, float]]:
    """The origin of each figure, with so many in a row; and the size of the whole."""
    names, corners = list(cells), dict[str, complex]()
    y, wide = 0.0, 0.0
    for row in (names[k : k + columns] for k in range(0, len(names), columns)):
        x = 0.0
        for name in row:
            left, _, right, top = cells[name]
            corners[name] = complex(x - left, y - top)
            x += right - left + GAP_MM
        wide = max(wide, x - GAP_MM)
        y -= max(cells[name][3] - cells[name][1] for name in row) + GAP_MM
    high = -y - GAP_MM
    places = {name: corner + complex(MARGIN_MM, MARGIN_MM + high) for name, corner in corners.items()}
    return places, (wide + 2 * MARGIN_MM, high + 2 * MARGIN_MM)


def placed(frame: Mapping[str, View], cells: Mapping[str, Bounds], places: Mapping[str, complex]) -> Iterator[Mark]:
    """The marks of one frame, each figure in its place under its title."""
    for name, one in frame.items():
        for k, line in enumerate(one.title.split(", ")):
            at = complex(cells[name][0], cells[name][3] - (k + 0.7) * LINE * TITLE_MM)
            yield Text(line, at + places[name], TITLE_MM, name=f"title {name}")
        yield from (moved(mark, places[name]) for mark in one.body)


def figures_of(drawn: Sequence[Position]) -> list[str]:
    """The scheme, and the first plan of each kind in the position that shows most of them."""
    plans = max((drawn_plans(of_position(one), one) for one in drawn), key=len)
    kinds = {kind_of(plan): plan for plan in reversed(plans)}
    return ["position", *(kinds[kind] for kind in ("velocity", "acceleration", "force") if kind in kinds)]


def figure(composer: Composer, drawn: Position, name: str) -> View:
    """The scheme, or a plan without details and construction lines, about its origin or pole."""
    plotted = of_position(drawn)
    if name == "position":
        return view(name, composer.titled(drawn, "scheme"), Scheme(drawn, composer.naming).drawn(True), True)
    title = f"{composer.plan_name(name)}, {composer.mu(plotted, name)}"
    return view(name, title, polygon_marks(plotted, name, composer), True)


def polygon_marks(plotted: Plotted, plan: str, composer: Composer) -> Iterator[Mark]:
    """The vectors of a plan with their names."""
    polygon = Polygon(plotted, plan, composer.naming)
    polygon.collect()
    polygon.vectors()
    ground = (*polygon.marks, *polygon.aside, *dot(polygon.mark(POLE), 0.7, "plan"))
    yield from (*ground, *place(polygon.named(), ground).marks)
