"""A moving mechanism, with its plans beside it, as an animation: GIF, SVG or MP4."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from planes.diagrams.turn import working_range_of
from planes.plans.extents import plan_width_and_height
from planes.plans.scales import PLAN_FIT_MM, drawn_in_si, largest_fitting_scale, scale_leaders
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.scene.files import save_file_or_refuse
from planes.solving import Position, solve_position
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, PlanFailure
from planes.words.names import POLE_LABEL, SCHEME_PLAN, PlanId
from planes.words.waiting import progress_bar
from render.files import moving
from render.labels import place_labels
from render.labels.candidates import Size
from render.labels.footprints import Bounds
from render.paper.marks import Mark, Text, move_mark, using_face
from render.paper.outlines import face_of_scene
from render.paper.symbols import dot
from render.paper.typeset import ink_width
from render.sheet.composer import Composer, drawn_plans
from render.views import TITLE_GAP_MM, TITLE_LETTER_MM, View, make_view
from render.views.plotted import Plotted, plot_position
from render.views.polygon import Polygon
from render.views.scheme import Scheme

FRAMES_PER_TURN = 60
"""Positions of a whole turn: one every 6°."""
LEFT_OUT_END_SHARE = 0.05
"""Part of a limited range left out at each end, where velocities grow without bound."""
FIGURE_GAP_MM = 12.0
MARGIN_MM = 6.0
TITLE_LINE_SPACING = 1.6
"""The line spacing of a title, in letter heights."""
SLIDE_ASPECT_RATIO = 16 / 9
"""The aspect ratio of a slide; figures are arranged to come close to it."""

Frame = tuple[Mark, ...]


def animate(scene: Scene, output: str | Path, lang: Lang, frames: int = FRAMES_PER_TURN, seconds: float = 6.0) -> None:
    """Write the animation of a scene; one turn (or one way there and back) takes a given time in s.

    :class:`PlanesError` for an unknown suffix, fewer than two frames, or a scene in which nothing moves.
    """
    suffix = Path(output).suffix.lower()
    if suffix not in moving.ANIMATION_SUFFIXES:
        raise PlanesError(Phrase("bad_film_suffix", file=str(output), known=moving.ANIMATION_SUFFIXES))
    if frames < 2 or not seconds > 0:
        raise PlanesError(Phrase("animation_frames", frames=frames, seconds=seconds))
    if scene.mechanism is None:
        raise PlanesError(Phrase("cycle_no_mechanism", file=scene.file))
    with using_face(face_of_scene(scene)), progress_bar() as step:
        drawn, round_trip = positions_over_turn(scene, frames, lang)
        pages, size = frames_and_size(scene, drawn, lang)
        shown = pages + pages[-2:0:-1] if round_trip else pages
        data = moving.animation_bytes(shown, size, seconds, suffix, step, scene.title.get(lang) or scene.file, lang)
    save_file_or_refuse(data, output)


def positions_over_turn(scene: Scene, frames: int, lang: Lang) -> tuple[list[Position], bool]:
    """Positions with one μ per plan, evenly over the turn; True if the mechanism moves to and fro instead."""
    plans = scene_plans(scene)
    span = working_range_of(plans)
    reach = span if span.whole else span.range_without_ends(LEFT_OUT_END_SHARE)
    values = reach.evenly_spaced_values(frames)[: frames if span.whole else None]
    scales = common_scales(scene, values)
    drawn = []
    for value in values:
        try:
            drawn.append(solve_position(replace(scene, mu=scales), plans, None, value, None, lang))
        except PlanFailure:
            continue  # a failed position has no picture
    if len(drawn) < 2:
        raise PlanesError(Phrase("animation_still", file=scene.file))
    return drawn, not span.whole


def common_scales(scene: Scene, values: Sequence[float]) -> dict[str, float | None]:
    """The μ of each kind of plan: the largest standard one with which it fits in all positions."""
    plans = scene_plans(scene)
    sizes = dict[PlanId, float]()
    for value in values:
        try:
            drawing = drawn_in_si(plans, plans.drive_givens_at(value)[plans.drive_given_name])
        except PlanFailure:
            continue
        for plan in plans.plan_names:
            if plan != "lever":
                sizes[plan] = max(sizes.get(plan, 0.0), *plan_width_and_height(drawing, plan))
    largest = {plan.kind: sizes[leader] for plan, leader in scale_leaders(sizes).items() if sizes[leader]}
    return {kind: largest_fitting_scale(kind, size, PLAN_FIT_MM[kind]) for kind, size in largest.items()}


def frames_and_size(scene: Scene, drawn: Sequence[Position], lang: Lang) -> tuple[list[Frame], Size]:
    """The marks of each frame, and the size of the picture in mm: figures side by side, with fixed poles."""
    composer = Composer(scene, lang, drawn[0].plans)
    names = figure_names(drawn)
    frames = [{name: figure_view(composer, one, name) for name in names} for one in drawn]
    cells = {name: figure_bounds([frame[name] for frame in frames]) for name in names}
    arranged = [figure_origins_and_size(cells, some) for some in (1, 2, len(names))]
    places, size = min(arranged, key=lambda one: abs(math.log(one[1][0] / one[1][1] / SLIDE_ASPECT_RATIO)))
    return [tuple(frame_marks(frame, cells, places)) for frame in frames], size


def figure_bounds(views: Sequence[View]) -> Bounds:
    """The box around a figure in all its frames, with the lines of its title above."""
    lefts, lows, rights, tops = zip(*(one.inked for one in views), strict=True)
    titles = views[0].title.split(", ")
    wide = max(ink_width(line, TITLE_LETTER_MM) for line in titles)
    high = TITLE_GAP_MM + TITLE_LINE_SPACING * TITLE_LETTER_MM * len(titles)
    return min(lefts), min(lows), max(*rights, min(lefts) + wide), max(tops) + high


def figure_origins_and_size(cells: Mapping[PlanId, Bounds], columns: int) -> tuple[dict[PlanId, complex], Size]:
    """The origin of each figure, with so many in a row; and the size of the whole."""
    names = list(cells)
    corners = {}
    y = 0.0
    wide = 0.0
    for row in (names[k : k + columns] for k in range(0, len(names), columns)):
        x = 0.0
        for name in row:
            left, _, right, top = cells[name]
            corners[name] = complex(x - left, y - top)
            x += right - left + FIGURE_GAP_MM
        wide = max(wide, x - FIGURE_GAP_MM)
        y -= max(cells[name][3] - cells[name][1] for name in row) + FIGURE_GAP_MM
    high = -y - FIGURE_GAP_MM
    places = {name: corner + complex(MARGIN_MM, MARGIN_MM + high) for name, corner in corners.items()}
    return places, (wide + 2 * MARGIN_MM, high + 2 * MARGIN_MM)


def frame_marks(
    frame: Mapping[PlanId, View], cells: Mapping[PlanId, Bounds], places: Mapping[PlanId, complex]
) -> Iterator[Mark]:
    """The marks of one frame, each figure in its place under its title."""
    for name, one in frame.items():
        for k, line in enumerate(one.title.split(", ")):
            at = complex(cells[name][0], cells[name][3] - (k + 0.7) * TITLE_LINE_SPACING * TITLE_LETTER_MM)
            yield Text(line, at + places[name], TITLE_LETTER_MM, name=f"title {name}")
        yield from (move_mark(mark, places[name]) for mark in one.body)


def figure_names(drawn: Sequence[Position]) -> list[PlanId]:
    """The scheme, and the first plan of each kind in the position that shows most of them."""
    plans = max((drawn_plans(plot_position(one), one) for one in drawn), key=len)
    kinds = {plan.kind: plan for plan in reversed(plans)}
    return [SCHEME_PLAN, *(kinds[kind] for kind in ("velocity", "acceleration", "force") if kind in kinds)]


def figure_view(composer: Composer, drawn: Position, name: PlanId) -> View:
    """The scheme, or a plan without details and construction lines, about its origin or pole."""
    plotted = plot_position(drawn)
    if name == "position":
        return make_view(
            name, composer.title_with_mu(drawn, "scheme"), Scheme(drawn, composer.naming).drawn_marks(True), True
        )
    title = f"{composer.plan_name(name)}, {composer.title_mu(plotted, name)}"
    return make_view(name, title, polygon_marks(plotted, name, composer), True)


def polygon_marks(plotted: Plotted, plan: PlanId, composer: Composer) -> Iterator[Mark]:
    """The vectors of a plan with their names."""
    polygon = Polygon(plotted, plan, composer.naming)
    polygon.collect_vectors()
    polygon.draw_vectors()
    ground = (*polygon.marks, *polygon.aside, *dot(polygon.mark(POLE_LABEL), 0.7, "plan"))
    yield from ground + place_labels(polygon.name_labels(), ground).marks
