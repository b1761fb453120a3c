"""The public functions of ``import planes``: a scene solved, turned, drawn and checked, for typing in a notebook."""

from collections.abc import Iterable, Mapping
from itertools import product
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from planes.batch.table import ERROR_COLUMN_PREFIX, SWEPT_PARAMETER_UNIT, Table
from planes.check.grading.paper import Known
from planes.check.grading.prepared_plan import Asked
from planes.check.handed_in import TABLE_SUFFIXES, read_paper
from planes.check.outcome import Outcome
from planes.check.outcome import check as judge
from planes.course.numbers import main_answer_names
from planes.diagrams.turn import WholeTurn
from planes.documents import animation
from planes.documents.drawn import page_of_view, picture
from planes.documents.lesson import Lesson
from planes.documents.sheets import sheet_of
from planes.geometry.arrays import Array
from planes.plans.curves import curves_meant_by_names
from planes.plans.statements.of_scene import scene_plans
from planes.scene import Scene
from planes.scene.parameters import require_finite_numbers
from planes.scene.ranges import drive_positions_asked, driver_coordinate_asked
from planes.solving.of_scene import AnyScene, scene_from
from planes.words import Lang, home_lang
from planes.words.names import NameTuple, NumbersByName, PlanId
from planes.words.units import read_mu
from render.files import Page
from render.sheet import Sheet

if TYPE_CHECKING:
    from planes.diagrams.text import Extremes

__all__ = ["animate", "check", "cycle", "extremes", "lesson", "picture", "sheet"]


def cycle(
    scene: AnyScene,
    names: str | Iterable[str] | None = None,
    phi: Any = None,
    *,
    s: Any = None,
    errors: bool = False,
    **parameters: Any,
) -> Table:
    """Results for many positions, as arrays by name. ``names`` are results such as "v_C", "omega_2", "F_21", "M_1" or
    the position vector "r_C" (None: everything). Where a position cannot be drawn, there is NaN, and ``failed`` has the
    reason in short ("C: arcs apart"); :func:`solve` for that position gives the full sentence.

    ``phi`` (degrees; ``s``, in m, for a sliding driver) is an array of values, by default a whole turn in steps of a
    degree (for a sliding driver its given position). Any other keyword is a parameter of the scene with its value or
    values: each combination is run for all positions of the drive. The table has a column for the drive and one for
    each parameter. With ``errors`` it also has a bound on the error of every number: ``table["± omega_2"]``.

    >>> import planes
    >>> scene = planes.load("samples/kind-1-rrr.yaml")
    >>> table = planes.cycle(scene, ["v_C", "omega_2"], phi=range(0, 360, 90), l_CD=[0.3, 0.35])
    >>> table
    <Table of 5 columns, 8 positions: l_CD, phi [°], v_C_x [m/s], v_C_y [m/s], omega_2 [rad/s]>
    >>> table["v_C"].shape
    (8,)
    """
    scene = scene_from(scene)
    one = isinstance(names, str) or not isinstance(names, Iterable)
    asked = None if names is None else (str(names),) if one else tuple(map(str, names))
    at = driver_coordinate_asked(scene, phi, s)
    values = None if at is None else _number_array(at, "s" if phi is None else "phi")
    swept = {name: _number_array(v, name) for name, v in parameters.items()}
    tables = []
    for numbers in product(*swept.values()):
        given = dict(zip(swept, map(float, numbers), strict=True))
        tables.append(_turn_results(scene.with_parameters(**given) if given else scene, asked, values, given, errors))
    return Table.joined(tables) if len(tables) > 1 else tables[0]


def _number_array(given: Any, name: str) -> Array:
    """The numbers given; an array of them is looked at as one, in a tenth of the time."""
    flat = isinstance(given, np.ndarray) and given.shape == (given.size,) != (0,) and given.dtype == float
    return given.copy() if flat and np.isfinite(given).all() else np.atleast_1d(require_finite_numbers(given, name))


_READY_TURNS: dict[tuple[int, NameTuple | None], WholeTurn] = {}
"""Turns ready for the next call: by the plans, which they keep, and the names."""
MOST_READY_TURNS = 8


def _turn_results(
    scene: Scene, names: NameTuple | None, values: Array | None, given: NumbersByName, errors: bool
) -> Table:
    """The results for one set of parameters. A turn is made ready in milliseconds, so the last ones are kept; while
    used, one is taken out, for another thread may ask for the same."""
    plans = scene_plans(scene)
    drive = plans.drive
    key = (id(plans), names)
    turn = _READY_TURNS.pop(key, None)
    if turn is None:
        asked = None if names is None else [name for name in names if name != drive.kind]
        turn = WholeTurn(plans, curves_meant_by_names(plans, asked), slopes=False)
    if values is None:
        values = np.arange(360.0) if drive.rotates else np.array([drive.position])
    rows, codes = turn.curve_rows(values, errors=errors)
    heads = [(sign + c.name, c.unit) for sign in ("", ERROR_COLUMN_PREFIX)[: 1 + errors] for c in turn.curves]
    columns = {name: np.full(len(values), number) for name, number in given.items()} | {drive.kind: values}
    units = dict.fromkeys(given, SWEPT_PARAMETER_UNIT) | {drive.kind: "°" if drive.rotates else "m"} | dict(heads)
    columns |= dict(zip(dict(heads), rows, strict=True))
    reasons = np.array(["", *(r.reason_in_short for r in turn.failure_reasons)], dtype=object)
    if len(_READY_TURNS) >= MOST_READY_TURNS:
        _READY_TURNS.clear()
    _READY_TURNS[key] = turn
    return Table(columns, units, reasons[codes], plans.default_naming)


def check(
    scene: AnyScene,
    drawing: str | Path,
    plan: str,
    phi: float | None = None,
    *,
    s: float | None = None,
    mu: str | None = None,
    pole: complex | None = None,
    marks: Mapping[str, complex] | None = None,
    page: int | None = None,
) -> Outcome:
    """Check a drawing of a plan by hand ("position", "velocity", "acceleration", "force:2-3", "force:1").

    ``drawing`` is a table (.csv), a drawing of lines (.svg, .dxf, .pdf) or a picture; ``mu`` its scale, as "30
    mm/(m/s)", if known; ``pole`` and ``marks`` are places in pixels or the drawing's own units, x + iy with y down;
    ``page`` of several counts from 1. The outcome has a ``verdict`` ("right", "right_as_seen", "wrong", "unreadable"),
    ``first_wrong``, ``mistake``, ``sentence``. A table of results alone is right if none of the plan's main ones is
    missing. Raises :class:`PlanesError` where the file cannot be opened or the scene has no such plan.
    """
    scene = scene_from(scene)
    at = drive_positions_asked(scene, phi, s, False)
    known_mu = None if mu is None else read_mu(mu, PlanId.read(plan).kind)
    answers = main_answer_names(scene, at, plan) if str(drawing).lower().endswith(TABLE_SUFFIXES) else ()
    asked = Asked(scene, plan, at, known_mu, answers=answers)
    known = Known(pole, dict(marks or {}), page=None if page is None else page - 1)
    return judge(asked, read_paper(str(drawing), asked, known))


def sheet(
    scene: AnyScene,
    output: str | Path | None = None,
    phi: float | None = None,
    *,
    s: float | None = None,
    number: int | None = None,
    view: str | None = None,
    lang: Lang | None = None,
) -> Sheet | Page:
    """The drawing sheet of one position, written to ``output`` if given (.svg, .pdf, .png, .dxf).

    ``number`` 1 or 2 is a sheet of a course project, ``view`` a single view; otherwise everything is on one sheet. A
    notebook shows the returned value. Raises :class:`PlanesError` where it cannot be drawn or written.
    """
    scene = scene_from(scene)
    lang = lang or home_lang()
    at = drive_positions_asked(scene, phi, s, False) if scene.mechanism else None
    values = None if at is None else [at]
    drawn = page_of_view(scene, view, values, lang) if view else sheet_of(scene, values, lang, number)
    if output is not None:
        drawn.write(output)
    return drawn


def lesson(
    scene: AnyScene, output: str | Path | None = None, lang: Lang | None = None, centres: bool = False
) -> Lesson:
    """The construction step by step as a web page, optionally with a chapter on instantaneous ``centres``; written to
    ``output`` if given. A notebook shows it."""
    page = Lesson(scene_from(scene), lang or home_lang(), centres=centres)
    if output is not None:
        page.write(str(output))
    return page


def extremes(scene: AnyScene) -> "Extremes":
    """Stroke, dead points, time ratio, and the extremes of every curve over the cycle.

    A dict in the shape of ``planes cycle --json``, with numbers at full precision; printed, it is the tables of
    ``planes cycle``. Positions of the driver (``at``) are in degrees, of a sliding driver in m.

    - ``range``: [first, last] position of the driver; ``assembles``: the ranges in which the mechanism assembles.
    - ``driven``: the last link before the frame: ``link``, ``curve`` (its position), ``rotates``, ``stroke`` (m,
      degrees; None if unbounded), ``extreme_positions``, ``forth_deg`` and ``back_deg`` of the driver, ``time_ratio``.
      Missing where no link is driven.
    - ``curves``: by name, ``unit``, ``group`` ("place", "analogue", "rate", "force"), ``extremes``; ``rotates`` if the
      link turns fully. An extreme is ``{"at", "value", "kind": "greatest" | "least"}``; with ``where`` "end" of the
      range or "limit" of assembly if it is not a turning point, with ``unbounded`` where there is no value.
    - ``paths``: by point, ``length`` (m) and the range of ``x`` and ``y``.

    Raises :class:`PlanesError` where the mechanism cannot be drawn at all.

    >>> import planes
    >>> found = planes.extremes(planes.load("samples/kind-1-rrr.yaml"))
    >>> [round(e["at"], 2) for e in found["driven"]["extreme_positions"]]  # dead points, degrees of the crank
    [90.0, 257.32]
    >>> round(found["driven"]["time_ratio"], 4)
    1.1516
    """
    from planes.diagrams.text import Extremes

    return Extremes(scene_from(scene))


def animate(
    scene: AnyScene,
    output: str | Path,
    *,
    frames: int = animation.FRAMES_PER_TURN,
    seconds: float = 6.0,
    lang: Lang | None = None,
) -> None:
    """Write an animation of the mechanism with its plans: ``output`` ends in .gif, .svg or .mp4 (extra ``check``).

    ``frames`` are the positions of one turn, or of one stroke where the driver only swings. The picture lasts
    ``seconds`` and loops. Raises :class:`PlanesError` where nothing moves, or for another suffix.
    """
    animation.animate(scene_from(scene), output, lang or home_lang(), frames, seconds)
