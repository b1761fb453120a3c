"""``planes.solve``: one position of a scene, or several."""

from collections.abc import Iterable
from pathlib import Path
from typing import Any, overload

from planes import scene as scenes
from planes.drafting.instruments import Instrument
from planes.scene import Scene
from planes.scene.ranges import drive_positions_asked
from planes.solving import Position, Solved, plans_and_requested_results, solve_position
from planes.solving import solve as solve_each
from planes.solving.building import Linkage, scene_with_doubts_warned
from planes.words import Phrase, home_lang
from planes.words.errors import PlanesError

Numbers = Iterable[float]
AnyScene = Scene | Linkage | str | Path
"""A scene, a mechanism built in Python, or the path of a file."""


def scene_from(scene: AnyScene) -> Scene:
    """The scene that is given in one of these ways."""
    if isinstance(scene, str | Path):
        return load(scene)
    made = scene.scene() if isinstance(scene, Linkage) else scene
    if not isinstance(made, Scene):
        raise PlanesError(Phrase("scene_needed", given=type(scene).__name__))
    return made


def load(path: str | Path, variant: str | None = None, **parameters: float) -> Scene:
    """Read a scene file, with other numbers for the ``parameters`` named (SI, degrees).

    Raises :class:`~planes.words.errors.SceneError`, with file and line, for a mistake in the file or an unknown
    parameter; warns (``UserWarning``) of numbers that seem to be in other units, as the command line does.
    """
    return scene_with_doubts_warned(scenes.load(path, variant, **parameters))


def loads(text: str, file: str = "scene.yaml", variant: str | None = None, **parameters: float) -> Scene:
    """Read the text of a scene file, as :func:`load` does."""
    return scene_with_doubts_warned(scenes.loads(text, file, variant, **parameters))


@overload
def solve(
    scene: AnyScene, phi: float | None = None, *, s: float | None = None, instrument: Instrument | None = None
) -> Position: ...
@overload
def solve(
    scene: AnyScene, phi: Numbers | None = None, *, s: Numbers | None = None, instrument: Instrument | None = None
) -> Solved: ...
def solve(
    scene: AnyScene, phi: Any = None, *, s: Any = None, instrument: Instrument | None = None
) -> Position | Solved:
    """Draw and measure one position of a scene (or of the file at a path), or each of several.

    ``phi`` (degrees; ``s``, in m, for a sliding driver) is one value or an iterable of them; the default is the value
    in the scene. One value gives a :class:`Position`, or raises :class:`planes.PlanFailure` where it cannot be drawn;
    several give a :class:`Solved`: ``positions`` are those that could be drawn, ``failed`` has the reasons for the
    others.

    >>> import planes
    >>> scene = planes.load("samples/kind-1-rrr.yaml")
    >>> here = planes.solve(scene, phi=60)
    >>> round(abs(here.v["C"]), 4)  # m/s
    1.2077
    >>> [round(p.value("omega_2"), 3) for p in planes.solve(scene, range(0, 90, 30)).positions]  # rad/s
    [-0.902, 0.684, 2.553]
    """
    scene = scene_from(scene)
    at = drive_positions_asked(scene, phi, s)
    if isinstance(at, list):
        return solve_each(scene, at, instrument, home_lang())
    plans, wanted = plans_and_requested_results(scene)
    value = plans.drive.position if at is None else at
    return solve_position(scene, plans, wanted, value, instrument, home_lang())
