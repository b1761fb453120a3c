"""Solve a scene for one or many positions of its drive: the output of ``planes solve``, as plain dictionaries."""

import math
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from operator import attrgetter
from pathlib import Path
from typing import Any

from planes.drafting.draft import Segment
from planes.drafting.drawing import Drawing, draw_program, refuse_unproved_drawing
from planes.drafting.instruments import Instrument, Pencil, is_exact
from planes.plans import Plans
from planes.plans.measuring import DrawingReader, polar_json
from planes.plans.quantities import (
    RESULT_GROUPS,
    Measured,
    Quantity,
    nested_json,
    quantities_asked_for,
    results_with_intermediates,
)
from planes.plans.scales import plan_scales, plan_sizes_on_format
from planes.plans.statements.of_scene import plans_cut_to_results, plans_fitted_at_position, scene_plans
from planes.scene import Scene
from planes.solving.nearest import Nearest
from planes.solving.own_equations import check_own_equations
from planes.solving.readings import BALANCING_LOAD_NAMES, RESULT_KINDS, Readings, require_known_name
from planes.solving.scatter import length_scatter_mm
from planes.solving.warned import accuracy_warnings
from planes.words import Lang, Phrase, Written
from planes.words.errors import PlanFailure, ProgramError, SceneError
from planes.words.frozen import frozen
from planes.words.names import POLE_LABEL, MarkPair, NumbersByName, PlanId, split_value_name
from planes.words.records import Json, Pictured, Tabulated

_GET_VECTOR = attrgetter("vector")
_GET_NUMBER = attrgetter("number")
MOST_SUGGESTED_POSITIONS = 20  # for how many failed positions the nearest working one is looked for


@frozen
class Position(Pictured, Tabulated):
    """One position of a mechanism: the drive's position ``at`` (degrees, or m), plans, drawing, scales, and ``results``
    as in the JSON, with the measured segments and the warnings.

    Results are read by name or number: ``r``, ``v``, ``a`` of points are complex (x + iy in m, m/s, m/s²), ``omega``
    and ``epsilon`` of links in rad/s and rad/s²; :meth:`value` takes any name that ``find:`` takes.
    """

    at: float
    plans: Plans
    drawing: Drawing
    scales: NumbersByName
    found: tuple[Measured, ...]
    results: Json

    @property
    def r(self) -> Readings[complex]:
        """Positions of points, m: complex by name."""
        return self.of("points", "r").attribute_of_each(_GET_VECTOR)

    @property
    def v(self) -> Readings[complex]:
        """Velocities of points, m/s."""
        return self.of("points", "v").attribute_of_each(_GET_VECTOR)

    @property
    def a(self) -> Readings[complex]:
        """Accelerations of points, m/s²."""
        return self.of("points", "a").attribute_of_each(_GET_VECTOR)

    @property
    def omega(self) -> Readings[float]:
        """Angular velocities of links, rad/s, counter-clockwise positive."""
        return self.of("links", "omega").attribute_of_each(_GET_NUMBER)

    @property
    def epsilon(self) -> Readings[float]:
        """Angular accelerations of links, rad/s²."""
        return self.of("links", "epsilon").attribute_of_each(_GET_NUMBER)

    def of(self, group: str, key: str = "") -> Readings[Measured]:
        """The results of one kind ("points", "v"; "reactions"), by the name of the point, link or reaction. Raises
        :class:`UnknownName`, a KeyError, for an unknown kind."""
        own = {f.quantity.of: f for f in self.found if (f.quantity.group, f.quantity.key) == (group, key)}
        if not own:
            require_known_name(f"{group}.{key}".strip("."), RESULT_KINDS)
        return Readings(own, self.plans.default_naming, key)

    def rows(self, group: str) -> dict[str, dict[str, Measured]]:
        """The results of every point, link or slide, by its name and the key."""
        rows: dict[str, dict[str, Measured]] = {}
        for f in self.found:
            if f.quantity.group == group:
                rows.setdefault(f.quantity.of, {})[f.quantity.key] = f
        return rows

    def number(self, group: str) -> float | None:
        """The balancing load, if it was asked for: "balancing_moment" or, by the lever, "zhukovsky_moment" (N·m);
        "balancing_force" or "zhukovsky_force" (N). :class:`UnknownName` for another group."""
        require_known_name(group, BALANCING_LOAD_NAMES)
        return next((f.number for f in self.found if f.quantity.group == group), None)

    def measured_on(self, plan: PlanId) -> Iterator[tuple[str, Segment, Json]]:
        """The segments of a plan, without those of points that never move; a whole velocity or acceleration vector is
        named by its point. Raises :class:`UnknownName`, a KeyError, for an unknown plan."""
        require_known_name(plan, self.results["plans"])
        moving = self.plans.points.items() if plan in ("velocity", "acceleration") else ()
        points = {getattr(marks, plan).label: p for p, marks in moving}
        for s in self.plans.segments_on(plan):
            segment = self.results["plans"][plan]["segments"].get(s.start + s.end)
            if segment and segment["name"] == s.name:
                is_total = (
                    points and s.start == POLE_LABEL and s.ends[1] not in self.drawing.program.component_end_marks
                )
                letter, false, _ = split_value_name(s.end.rstrip("'"))
                point = points.get(s.end) or letter.upper() + (f"^{false}" if false else "")
                if not is_total or point not in self.plans.fixed_points:
                    yield (f"{plan[0]}_{point}" if is_total else s.name), s, segment

    def value(self, name: str) -> float | complex:
        """A quantity by its name in ``find:``, or a curve of :func:`planes.extremes`: a number in SI, complex for a
        vector; analogues of acceleration are those of an exact drawing. :attr:`names` are all there are; for another,
        or one that ``find:`` left out, a :class:`PlanesError`."""
        from planes.plans.curves import curves_meant_by_name

        if str(name) == self.plans.drive.kind:
            return self.at
        columns = CurveColumns(self)
        try:
            numbers = [float(curve.read(columns)) for curve in curves_meant_by_name(self.plans, str(name))]
        except (KeyError, ProgramError):
            raise SceneError(Phrase("not_in_find", name=name)) from None
        return complex(*numbers[:2]) if len(numbers) > 1 else numbers[0]

    @property
    def names(self) -> list[str]:
        """All names that :meth:`value` and :func:`planes.cycle` take."""
        from planes.plans.curves import askable_names

        return askable_names(self.plans)

    def __repr__(self) -> str:
        if not self.plans.has_mechanism:
            return f"<Position: vectors {', '.join(self.of('vectors'))}>"
        drive = self.plans.drive
        place = drive_position_in_words(self.at, drive.kind, "en")
        return f"<Position {drive.kind} = {place}: {self.plans.structure.structural_formula}>"


class CurveColumns(dict[str, Any]):
    """The columns that curves are read from, each measured when it is asked for; "q:" those of a unit drive."""

    def __init__(self, position: Position) -> None:
        measured = (zip(f.quantity.columns, f.numbers, strict=True) for f in position.found)
        super().__init__({c.name: math.nan if n is None else n for pairs in measured for c, n in pairs})
        self.position = position

    def __missing__(self, name: str) -> float:
        from planes.plans.curves import UNIT_DRIVE_PREFIX, columns_by_name

        here = self.position
        plans = self.position.plans
        column = columns_by_name(plans)[name.removeprefix(UNIT_DRIVE_PREFIX)]
        drawing = here.drawing
        if name.startswith(UNIT_DRIVE_PREFIX):
            unit = dict(zip(plans.drive.rate_names, (1.0, 0.0), strict=True))
            given = {**plans.given, **here.scales, **plans.drive_givens_at(here.at), **unit}
            drawing = draw_program(plans.program.cut_to_names(column.needed_names), given)
        number = DrawingReader(plans, drawing, here.scales).read_column(column)
        return math.nan if number is None else number


@dataclass
class Solved:
    """All positions that could be drawn, and the failed ones, each with its sentence; ``values`` as requested, of the
    ``instrument``."""

    scene: Scene
    plans: Plans
    wanted: list[Quantity] | None  # the results the scene asks for, None for all
    values: list[float] = field(default_factory=list)
    positions: list[Position] = field(default_factory=list)
    failed: list[Json] = field(default_factory=list)
    instrument: Instrument | None = None
    lang: Lang = "en"

    def at(self, value: float) -> Position:
        """The position at a value of the drive."""
        return solve_position(self.scene, self.plans, self.wanted, value, self.instrument, self.lang)

    def __repr__(self) -> str:
        return f"<Solved: {len(self.positions)} positions, {len(self.failed)} failed>"

    def json(self) -> Json:
        """The object that ``planes solve --json`` prints."""
        doubts = [doubt.told(self.lang) for doubt in self.scene.doubts]
        head = {"planes": 1, "scene": Path(self.scene.file).name, "variant": self.scene.variant}
        listed = [{**p.results, "warnings": doubts + p.results["warnings"]} for p in self.positions]
        for one in () if self.plans.has_mechanism else listed:
            one["vectors"] = {n: polar_json(complex(*xy)) for n, xy in one.get("vectors", {}).items()}
        if not self.plans.depends_on_drive:
            return {**head, **listed[0]}
        if self.plans.has_mechanism:
            head["structure"] = self.plans.structure.json()
        return {**head, "positions": listed, "failed": self.failed}


def plans_and_requested_results(scene: Scene, shown: bool = False) -> tuple[Plans, list[Quantity] | None]:
    """The plans of a scene cut to the requested results, or with the whole scheme if ``shown``; and these results
    (None: all)."""
    plans = scene_plans(scene)
    if scene.find is None:
        return plans, None
    return plans_cut_to_results(plans, quantities_asked_for(plans, scene.find, scene.file), plans if shown else None)


def solve(
    scene: Scene, values: Iterable[float] | None = None, instrument: Instrument | None = None, lang: Lang = "en"
) -> Solved:
    """Draw and measure every requested position. Raises :class:`SceneError` where the scene itself is invalid."""
    plans, wanted = plans_and_requested_results(scene)
    drive = plans.drive
    asked_at = [drive.position] if values is None else list(values)
    solved = Solved(scene, plans, wanted, asked_at, instrument=instrument, lang=lang)
    nearest = Nearest(plans)
    for value in solved.values:
        try:
            solved.positions.append(solved.at(value))
        except PlanFailure as failure:
            if not plans.depends_on_drive:
                raise SceneError(failure.phrase, scene.file) from None
            near = nearest.nearest_to_position(value) if len(solved.failed) < MOST_SUGGESTED_POSITIONS else None
            solved.failed.append(
                {
                    drive_position_key(plans): value,
                    "error": failed_position_sentence(failure, value, drive.kind, near).told(lang),
                }
            )
    return solved


def failed_position_sentence(failure: PlanFailure, value: float, kind: str, near: float | None = None) -> Phrase:
    """The sentence about a failed position, with the nearest one that works."""
    name = "φ" if kind == "phi" else "s"
    there = Phrase("nearest", name=name, value=_drive_position_text(near, kind, True)) if near is not None else ""
    return Phrase("at", name=name, value=_drive_position_text(value, kind), why=failure.phrase, nearest=there)


def drive_position_in_words(value: float, kind: str, lang: Lang) -> str:
    """A position of the drive in words."""
    return _drive_position_text(value, kind).told(lang)


def _drive_position_text(value: float, kind: str, exact: bool = False) -> Phrase | Written:
    """A position of the drive, to ten digits or ``exact``."""
    number = repr(value).removesuffix(".0") if exact else f"{value:.10g}"
    if kind == "phi":
        return Written(f"{number}°")
    return Phrase("in_m", value=Written(number))


def drive_position_key(plans: Plans) -> str:
    """The JSON key of the drive's position."""
    return "phi_deg" if plans.drive.rotates else "s"


def solve_position(
    scene: Scene,
    plans: Plans,
    wanted: list[Quantity] | None,
    value: float,
    instrument: Instrument | None,
    lang: Lang,
    fit_mm: NumbersByName | None = None,
) -> Position:
    """One position drawn at its scales and measured. An open μ is the largest with which the plan fits ``fit_mm``, or
    the sheet named in the scene."""
    moved = plans.drive_givens_at(value)
    plans, wanted = plans_fitted_at_position(plans, wanted, value)
    mus = plan_scales(plans, scene.mu, moved, fit_mm or plan_sizes_on_format(scene.sheet))
    given = {**plans.given, **mus, **moved}
    drawing = draw_program(plans.program, given, instrument)
    refuse_unproved_drawing(
        plans.program, given, drawing if is_exact(instrument) else None
    )  # a pencil's errors prove nothing
    reader = DrawingReader(plans, drawing, mus)
    measured = tuple(map(reader.read_quantity, results_with_intermediates(plans, wanted)))
    at_drive = {drive_position_key(plans): value} if plans.depends_on_drive else {}
    groups = RESULT_GROUPS if plans.has_mechanism else ()
    results = {**at_drive, **results_json(plans, measured, groups if wanted is None else ())}
    names = None if wanted is None else {n for q in wanted for n in (q.name, q.json_path[-1])}
    errors = None
    if isinstance(instrument, Pencil):
        parts = [
            (plan, key, s) for plan in plans.plan_names for key, s in reader.measured_segments_of_plan(plan).items()
        ]
        spans: dict[str, MarkPair] = {plan.mark(key): s.ends for plan, key, s in parts}
        errors = length_scatter_mm(plans.program, given, plans.drive_given_name, instrument, spans)
    drawn = reader.measurements_by_plan(names, errors)
    if drawn or wanted is None:
        results["plans"] = drawn
    results["warnings"] = accuracy_warnings(reader, wanted, given, lang)
    if scene.equations and wanted is None:
        results["equations"] = [e.json() for e in check_own_equations(plans, drawing, mus, scene.equations, scene.file)]
    return Position(value, plans, drawing, mus, measured, results)


def results_json(plans: Plans, measured: Iterable[Measured], groups: Iterable[str] = ()) -> Json:
    """The results as in the JSON; those of a slider include its guide."""
    out = nested_json(measured, groups)
    for link, one in out.get("slides", {}).items():
        out["slides"][link] = {"guide": plans.velocity_slides[link].guide, **one}
    return out
