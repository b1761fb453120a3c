"""A whole cycle drawn: diagrams of chosen curves, hodographs and paths, read from the one program; those on a sheet,
and a separate page."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from math import isfinite

import numpy

from planes.diagrams.extremes import Extreme, extremes_of_curves
from planes.diagrams.motion import Runs, diagram_range
from planes.diagrams.turn import WholeTurn, make_grid, unwind_angles, whole_turn_of
from planes.geometry.arithmetic import Real
from planes.geometry.arrays import Array, ArrayPair
from planes.plans import Plans
from planes.plans.curves import (
    FULL_TURN_DEG,
    Curve,
    CycleVector,
    curve_or_vector_by_name,
    curves_by_name,
    driven_link_curves,
    vectors_by_name,
)
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.scene.ranges import Span
from planes.words import Lang, Phrase
from planes.words.errors import PlanesError, SceneError
from planes.words.lettering import letter_of_scale
from planes.words.names import component_axis, letter_of, name_index
from planes.words.naming import Naming
from planes.words.units import suitable_unit_multiple
from render.files import Page
from render.paper.marks import Text, using_face
from render.paper.outlines import face_of_scene
from render.paper.typeset import wrap_text
from render.sheet.composer import Composer
from render.sheet.single import page_cut_to_view
from render.views import TITLE_LETTER_MM, View, make_view, stack_views
from render.views.curve_pieces import drop_steep_ordinates
from render.views.diagrams import SECTION_COUNT, DiagramCurve, Diagrams
from render.views.hodographs import Hodograph, hodograph_view

SECTION_WIDTH_MM = 15.0
DIAGRAM_GAP_MM = 10.0
HODOGRAPHS_PER_ROW = 2  # hodographs
SHEET_CURVE_KEYS = ("diagrams", "hodographs")


class DrawnTurn:
    """A turn read at the driver's positions of its runs, and at the numbered positions, as drawn."""

    def __init__(self, turn: WholeTurn, runs: Runs, naming: Naming) -> None:
        self.turn = turn
        self.runs = runs
        self.naming = naming
        self.pieces = [(places, turn.sample_columns(places)) for places in runs.runs_between_dead_points()]
        self.stations = turn.sample_columns(runs.stations_off_dead_points())

    def curve(self, curve: Curve, ends: Sequence[Extreme] = ()) -> DiagramCurve:
        """A curve, with its marked values; angles are unwound in both."""
        places, values = self.joined(curve)
        at = [e.place for e in ends]
        marked_values = numpy.array([e.value for e in ends])
        if curve.angular:
            values = unwind_angles(values)
            there = numpy.isfinite(values)
            marked_values = marked_values + FULL_TURN_DEG * numpy.round(
                (numpy.interp(at, places[there], values[there]) - marked_values) / FULL_TURN_DEG
            )
        name = self.naming.lettered_curve(curve.name)
        marked = tuple(zip(at, marked_values.tolist(), strict=True))
        place = curve.group == "place"
        return DiagramCurve(
            letter_of_scale(name), curve.unit, finite_or_none(values), name, finite_or_none(places), marked, place
        )

    def loop(self, arrow: CycleVector) -> Hodograph:
        """A hodograph, or a path."""
        name = self.naming.lettered_curve(arrow.name)
        point = self.naming.lettered_point(name_index(arrow.name)) if letter_of(arrow.name) == "r" else ""
        path = self.joined(arrow)[1]
        size, unit = suitable_unit_multiple(arrow.unit, float(numpy.nanmax(abs(path), initial=0.0)))
        return Hodograph(
            name, unit, finite_or_none(path / size), finite_or_none(arrow.read(self.stations) / size), point
        )

    def joined(self, curve: Curve | CycleVector) -> ArrayPair:
        """A curve's runs as one row of positions and one of values, with gaps between them."""
        x = numpy.concatenate([part for places, _ in self.pieces for part in (places, places[-1:])][:-1])
        rows = [part for _, sample in self.pieces for part in (curve.read(sample), [numpy.nan])]
        return x, numpy.concatenate(rows[:-1])


def finite_or_none(values: Array) -> tuple[Real, ...]:
    """Plain numbers, None where there are none."""
    return tuple(None if v != v else v for v in values.tolist())


def diagrams_and_hodographs(
    scene: Scene, plans: Plans, angles: Sequence[float], full_turn: bool, naming: Naming
) -> tuple[tuple[DiagramCurve, ...], tuple[Hodograph, ...]]:
    """The diagrams and hodographs named in ``sheet:`` of a scene, over the angles of a range or a ``full_turn``."""
    names, loops = (names_under_key(scene.sheet, key) for key in SHEET_CURVE_KEYS)
    if not names and not loops:
        return (), ()
    turn = whole_turn_of(plans, names, loops, scene.file)
    turned = DrawnTurn(turn, Runs(plans, min(angles), max(angles)), naming)
    curves = (turned.curve(c) for c in turn.curves)
    calm = tuple(replace(c, values=drop_steep_ordinates(c.values, full_turn)) for c in curves)
    return calm, tuple(map(turned.loop, turn.arrows))


def check_diagram_names(scene: Scene, plans: Plans | None) -> None:
    """Check that every diagram, hodograph and point with a path named in ``sheet:`` exists, on whichever sheet it is
    drawn."""
    for key in (*SHEET_CURVE_KEYS, "paths"):
        names = names_under_key(scene.sheet, key)
        line = scene.where.get(("sheet", key))
        if names and plans is None:
            raise SceneError(Phrase("cycle_no_mechanism", file=f"sheet.{key}"), scene.file, line)
        if names and plans:
            there: dict[str, Curve | CycleVector] = {
                **(curves_by_name if key == "diagrams" else vectors_by_name)(plans)
            }
            if key == "paths":
                there = {name_index(n): vector for n, vector in there.items() if letter_of(n) == "r"}
            for n, name in enumerate(names):
                try:
                    curve_or_vector_by_name(name, there, plans, f"sheet.{key}")
                except PlanesError as error:
                    raise SceneError(error.phrase, scene.file, scene.where.get(("sheet", key, str(n)), line)) from None


def sheet_entry_errors(scene: Scene) -> Iterator[PlanesError]:
    """Entries of ``sheet:`` that do not exist: a font, diagrams, hodographs, paths."""
    for look in (
        lambda: face_of_scene(scene),
        lambda: check_diagram_names(scene, scene_plans(scene) if scene.mechanism else None),
    ):
        try:
            look()
        except PlanesError as error:
            yield error


def names_under_key(sheet: Mapping[str, object], key: str) -> list[str]:
    """Names under a key of ``sheet:``, as a list or separated by commas."""
    said = sheet.get(key)
    names = said if isinstance(said, list) else str(said or "").split(",")
    return [str(n).strip() for n in names if str(n).strip()]


def cycle_page(
    scene: Scene,
    span: Span | None,
    show: Sequence[str] | None,
    hodographs: Sequence[str] | None,
    paths: Sequence[str] | None,
    lang: Lang,
) -> Page:
    """A page with diagrams of the curves, those joined by a plus on common axes, hodographs and paths."""
    if span is not None and span.count < 2:
        raise PlanesError(Phrase("cycle_one_place", file=scene.file))
    plans = scene_plans(scene)
    if show is None and not plans.has_mechanism:
        show = () if hodographs or paths else [name for name in curves_by_name(plans) if not component_axis(name)]
    elif show is None:  # the driven link's motion, and the balancing load
        drive = plans.drive
        balancing = f"{'M' if drive.rotates else 'Fb'}_{drive.link}"
        show = () if hodographs or paths else (*driven_link_curves(plans), balancing)
    known = curves_by_name(plans)
    panels = [[curve_or_vector_by_name(n, known, plans, scene.file).name for n in name.split("+")] for name in show]
    loops = [*(hodographs or ()), *(f"r_{name_index(p) if letter_of(p) == 'r' else p}" for p in paths or ())]
    turn = whole_turn_of(plans, [n for names in panels for n in names], loops, scene.file)
    runs = Runs(plans, *(diagram_range(plans)[:2] if span is None else sorted(span.first_and_last)))
    composer = Composer(scene, lang, plans)
    title = scene.title.get(lang, "")
    turned = DrawnTurn(turn, runs, composer.naming)
    with using_face(face_of_scene(scene)):
        views = _title_lines(title) + _diagram_views(turned, panels) + _hodograph_rows(turned)
        return page_cut_to_view(stack_views("cycle", views, DIAGRAM_GAP_MM), title, lang)


def _title_lines(text: str) -> list[View]:
    """The title of the scene, in lines no wider than the diagrams."""
    lines = wrap_text(text, SECTION_COUNT * SECTION_WIDTH_MM, TITLE_LETTER_MM)
    marks = [Text(line, -1.7j * TITLE_LETTER_MM * k, TITLE_LETTER_MM, "middle") for k, line in enumerate(lines)]
    return [make_view("title", "", marks)] if marks else []


def _diagram_views(turned: DrawnTurn, panels: Sequence[Sequence[str]]) -> list[View]:
    """The diagrams, one beneath another."""
    turn = turned.turn
    runs = turned.runs
    by_name = {c.name: c for c in turn.curves}
    if not panels:
        return []
    curve_extremes = extremes_of_curves(make_grid(turn, runs.start, runs.end))
    ends = {curve.name: _least_and_greatest(some) for curve, some in zip(turn.curves, curve_extremes, strict=True)}
    curves = [with_suitable_units([turned.curve(by_name[n], ends[n]) for n in names]) for names in panels]
    stations = runs.numbered_stations().tolist()
    shown = Diagrams(
        turn.plans, stations, curves, turned.naming, SECTION_WIDTH_MM, runs.closed, to_read=True
    ).drawn_marks()
    return [make_view("diagrams", "", shown)]


def with_suitable_units(panel: Sequence[DiagramCurve]) -> list[DiagramCurve]:
    """The curves of some axes in the multiple of their units that suits their values; as they are where one of them has
    no such multiple, since an axis has one scale."""
    most = max((abs(v) for curve in panel for v in curve.values if v is not None), default=0.0)
    multiples = {curve.unit: suitable_unit_multiple(curve.unit, most) for curve in panel}
    size, *others = {size for size, _ in multiples.values()}
    if others:
        return list(panel)
    return [
        replace(
            curve,
            unit=multiples[curve.unit][1],
            values=tuple(v and v / size for v in curve.values),
            ends=tuple((place, v / size) for place, v in curve.ends),
        )
        for curve in panel
    ]


def _least_and_greatest(curve_extremes: Sequence[Extreme]) -> list[Extreme]:
    """The least and the greatest value, where they are finite."""
    some = [e for e in curve_extremes if isfinite(e.value)]
    if some:
        return [max(some, key=lambda e: sense * e.value) for sense in (-1, 1)]
    return []


def _hodograph_rows(turned: DrawnTurn) -> list[View]:
    """Hodographs and paths in rows; those of a whole turn are closed."""
    loops = [turned.loop(arrow) for arrow in turned.turn.arrows]
    if turned.runs.closed:
        loops = [replace(loop, path=(*loop.path, None, loop.path[0])) for loop in loops]
    rows = (loops[k : k + HODOGRAPHS_PER_ROW] for k in range(0, len(loops), HODOGRAPHS_PER_ROW))
    return [hodograph_view(row, turned.naming, to_read=True) for row in rows]
