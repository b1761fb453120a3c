"""Solve a scene for one or many positions of its drive: the output of ``planes solve``, as plain dictionaries."""

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from operator import attrgetter
from pathlib import Path
from typing import Any

from planes.drafting.draft import Segment
from planes.drafting.drawing import Drawing, proved, run
from planes.drafting.instruments import Instrument, Pencil, is_exact
from planes.plans import Plans
from planes.plans.measuring import DrawingReader, polar
from planes.plans.quantities import GROUPS, Measured, Quantity, asked, nested, told_of
from planes.plans.scales import fits_on, scales
from planes.plans.statements.of_scene import cut_to, fitted, scene_plans
from planes.scene import Scene
from planes.solving.nearest import Nearest
from planes.solving.own_equations import own_equations
from planes.solving.readings import KINDS, LOADS, Readings, known
from planes.solving.scatter import scatter_mm
from planes.solving.warned import warnings
from planes.words import Lang, Phrase, Written
from planes.words.errors import PlanFailure, ProgramError, SceneError
from planes.words.frozen import frozen
from planes.words.names import POLE, label_of, parts_of
from planes.words.records import Json, Pictured, Tabulated

_VECTOR, _NUMBER = attrgetter("vector"), attrgetter("number")
TOLD = 20  # for how many failed positions the nearest working one is looked for


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
    scales: Mapping[str, float]
    found: tuple[Measured, ...]
    results: Json

    @property
    def r(self) -> Readings[complex]:
        """Positions of points, m: complex by name."""
        return self.of("points", "r").each(_VECTOR)

    @property
    def v(self) -> Readings[complex]:
        """Velocities of points, m/s."""
        return self.of("points", "v").each(_VECTOR)

    @property
    def a(self) -> Readings[complex]:
        """Accelerations of points, m/s²."""
        return self.of("points", "a").each(_VECTOR)

    @property
    def omega(self) -> Readings[float]:
        """Angular velocities of links, rad/s, counter-clockwise positive."""
        return self.of("links", "omega").each(_NUMBER)

    @property
    def epsilon(self) -> Readings[float]:
        """Angular accelerations of links, rad/s²."""
        return self.of("links", "epsilon").each(_NUMBER)

    def of(self, group: str, key: str = "") -> Readings[Measured]:
        """The results of one kind ("points", "v"; "reactions"), by the name of the point, link or reaction. Raises
        :class:`UnknownName`, a KeyError, for an unknown kind."""
        own = {f.quantity.of: f for f in self.found if (f.quantity.group, f.quantity.key) == (group, key)}
        if not own:
            known(f"{group}.{key}".strip("."), KINDS)
        return Readings(own, self.plans.naming, key)

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
        known(group, LOADS)
        return next((f.number for f in self.found if f.quantity.group == group), None)

    def measured_on(self, plan: str) -> Iterator[tuple[str, Segment, Json]]:
        """The segments of a plan, without those of points that never move; a whole velocity or acceleration vector is
        named by its point. Raises :class:`UnknownName`, a KeyError, for an unknown plan."""
        known(plan, self.results["plans"])
        moving = self.plans.points.items() if plan in ("velocity", "acceleration") else ()
        points = {label_of(getattr(marks, plan)): p for p, marks in moving}
        for s in self.plans.segments_of.get(plan, ()):
            segment = self.results["plans"][plan]["segments"].get(s.start + s.end)
            if segment and segment["name"] == s.name:
                is_total = points and s.start == POLE and s.ends[1] not in self.drawing.program.corners
                letter, false, _ = parts_of(s.end.rstrip("'"))
                point = points.get(s.end) or letter.upper() + (f"^{false}" if false else "")
                if not is_total or point not in self.plans.standing:
                    yield (f"{plan[0]}_{point}" if is_total else s.name), s, segment

    def value(self, name: str) -> float | complex:
        """A quantity by its name in ``find:``, or a curve of :func:`planes.extremes`: a number in SI, complex for a
        vector; analogues of acceleration are those of an exact drawing. :attr:`names` are all there are; for another,
        or one that ``find:`` left out, a :class:`PlanesError`."""
        from planes.plans.curves import meant

        if str(name) == self.plans.drive.kind:
            return self.at
        columns = CurveColumns(self)
        try:
            numbers = [float(curve.read(columns)) for curve in meant(self.plans, str(name))]
        except (KeyError, ProgramError):
            raise SceneError(Phrase("not_in_find", name=name)) from None
        return complex(*numbers[:2]) if len(numbers) > 1 else numbers[0]

    @property
    def names(self) -> list[str]:
        """All names that :meth:`value` and :func:`planes.cycle` take."""
        from planes.plans.curves import names_of

        return names_of(self.plans)

    def __repr__(self) -> str:
        if not self.plans.moves:
            return f"<Position: vectors {', '.join(self.of('vectors'))}>"
        drive = self.plans.drive
        return f"<Position {drive.kind} = {told(self.at, drive.kind, 'en')}: {self.plans.structure.formula}>"


class CurveColumns(dict[str, Any]):
    """The columns that curves are read from, each measured when it is asked for; "q:" those of a unit drive."""

    def __init__(self, position: Position) -> None:
        measured = (zip(f.quantity.columns, f.numbers, strict=True) for f in position.found)
        super().__init__({c.name: math.nan if n is None else n for pairs in measured for c, n in pairs})
        self.position = position

    def __missing__(self, name: str) -> float:
        from planes.plans.curves import UNIT, all_columns

        here, plans = self.position, self.position.plans
        column, drawing = all_columns(plans)[name.removeprefix(UNIT)], here.drawing
        if name.startswith(UNIT):
            unit = dict(zip(plans.drive.rates, (1.0, 0.0), strict=True))
            given = {**plans.given, **here.scales, **plans.at(here.at), **unit}
            drawing = run(plans.program.sliced(column.needs), given)
        number = DrawingReader(plans, drawing, here.scales).column(column)
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
        return position(self.scene, self.plans, self.wanted, value, self.instrument, self.lang)

    def __repr__(self) -> str:
        return f"<Solved: {len(self.positions)} positions, {len(self.failed)} failed>"

    def json(self) -> Json:
        """The object that ``planes solve --json`` prints."""
        doubts = [doubt.told(self.lang) for doubt in self.scene.doubts]
        head = {"planes": 1, "scene": Path(self.scene.file).name, "variant": self.scene.variant}
        listed = [{**p.results, "warnings": doubts + p.results["warnings"]} for p in self.positions]
        for one in () if self.plans.moves else listed:
            one["vectors"] = {n: polar(complex(*xy)) for n, xy in one.get("vectors", {}).items()}
        if not self.plans.turns:
            return {**head, **listed[0]}
        head |= {"structure": self.plans.structure.json()} if self.plans.moves else {}
        return {**head, "positions": listed, "failed": self.failed}


def plans_of(scene: Scene, shown: bool = False) -> tuple[Plans, list[Quantity] | None]:
    """The plans of a scene cut to the requested results, or with the whole scheme if ``shown``; and these results
    (None: all)."""
    plans = scene_plans(scene)
    if scene.find is None:
        return plans, None
    return cut_to(plans, asked(plans, scene.find, scene.file), plans if shown else None)


def solve(
    scene: Scene, values: Iterable[float] | None = None, instrument: Instrument | None = None, lang: Lang = "en"
) -> Solved:
    """Draw and measure every requested position. Raises :class:`SceneError` where the scene itself is invalid."""
    plans, wanted = plans_of(scene)
    drive = plans.drive
    asked_at = [drive.position] if values is None else list(values)
    solved = Solved(scene, plans, wanted, asked_at, instrument=instrument, lang=lang)
    nearest = Nearest(plans)
    for value in solved.values:
        try:
            solved.positions.append(solved.at(value))
        except PlanFailure as failure:
            if not plans.turns:
                raise SceneError(failure.phrase, scene.file) from None
            near = nearest.to(value) if len(solved.failed) < TOLD else None
            solved.failed.append({key_of(plans): value, "error": failed(failure, value, drive.kind, near).told(lang)})
    return solved


def failed(failure: PlanFailure, value: float, kind: str, near: float | None = None) -> Phrase:
    """The sentence about a failed position, with the nearest one that works."""
    name = "φ" if kind == "phi" else "s"
    there = Phrase("nearest", name=name, value=_place(near, kind, True)) if near is not None else ""
    return Phrase("at", name=name, value=_place(value, kind), why=failure.phrase, nearest=there)


def told(value: float, kind: str, lang: Lang) -> str:
    """A position of the drive in words."""
    return _place(value, kind).told(lang)


def _place(value: float, kind: str, exact: bool = False) -> Phrase | Written:
    """A position of the drive, to ten digits or ``exact``."""
    number = repr(value).removesuffix(".0") if exact else f"{value:.10g}"
    return Written(f"{number}°") if kind == "phi" else Phrase("in_m", value=Written(number))


def key_of(plans: Plans) -> str:
    """The JSON key of the drive's position."""
    return "phi_deg" if plans.drive.rotates else "s"


def position(
    scene: Scene,
    plans: Plans,
    wanted: list[Quantity] | None,
    value: float,
    instrument: Instrument | None,
    lang: Lang,
    fit_mm: Mapping[str, float] | None = None,
) -> Position:
    """One position drawn at its scales and measured. An open μ is the largest with which the plan fits ``fit_mm``, or
    the sheet named in the scene."""
    moved = plans.at(value)
    plans, wanted = fitted(plans, wanted, value)
    mus = scales(plans, scene.mu, moved, fit_mm or fits_on(scene.sheet, plans))
    given = {**plans.given, **mus, **moved}
    drawing = run(plans.program, given, instrument)
    proved(plans.program, given, drawing if is_exact(instrument) else None)  # a pencil's errors prove nothing
    reader = DrawingReader(plans, drawing, mus)
    measured = tuple(map(reader.read, told_of(plans, wanted)))
    at_drive, groups = {key_of(plans): value} if plans.turns else {}, GROUPS if plans.moves else ()
    results = {**at_drive, **as_json(plans, measured, groups if wanted is None else ())}
    names = None if wanted is None else {n for q in wanted for n in (q.name, q.path[-1])}
    errors = None
    if isinstance(instrument, Pencil):
        parts = [(plan, key, s) for plan in plans.drawn for key, s in reader.plan_segments(plan).items()]
        spans = {f"{plan}:{key}": s.ends for plan, key, s in parts}
        errors = scatter_mm(plans.program, given, plans.drive_given, instrument, spans)
    drawn = reader.plans(names, errors)
    if drawn or wanted is None:
        results["plans"] = drawn
    results["warnings"] = warnings(reader, wanted, given, lang)
    if scene.equations and wanted is None:
        results["equations"] = [e.json() for e in own_equations(plans, drawing, mus, scene.equations, scene.file)]
    return Position(value, plans, drawing, mus, measured, results)


def as_json(plans: Plans, measured: Iterable[Measured], groups: Iterable[str] = ()) -> Json:
    """The results as in the JSON; those of a slider include its guide."""
    out = nested(measured, groups)
    for link, one in out.get("slides", {}).items():
        out["slides"][link] = {"guide": plans.velocity_slides[link].guide, **one}
    return out
