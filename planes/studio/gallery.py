"""The gallery: scenes with a small animated picture, and the places of their points as the driver turns."""

import math
from collections.abc import Iterable
from itertools import groupby
from pathlib import Path

from planes.drafting.drawing import draw_program
from planes.drafting.instruments import InLists
from planes.geometry.listed import Listed
from planes.lesson.told import drive_number_and_range
from planes.plans import Plans, structure_of
from planes.scene import Scene, loads
from planes.scene.source import read_file_text
from planes.solving import plans_and_requested_results
from planes.studio.sketches import marks_and_their_steps, sketch_of
from planes.words.errors import PlanesError
from planes.words.records import Json

PICTURE_POSITION_COUNT = 36  # positions of the driver in an animated picture
PICTURE_RESOLUTION_PARTS = 500  # of the size of a picture: resolution of places
OWN_SCENE_FOLDERS = (Path(__file__).with_name("classics"), Path(__file__).parents[1] / "templates")
"""The folder of the scenes that come with the program."""


def gallery_entries(more: Iterable[str]) -> list[Json]:
    """The gallery: an entry for every scene with a mechanism that works, of those that come with the program and of
    ``more`` folders and their subfolders; names are those of files, each once."""
    rows = {}
    for path in (file for folder in (*OWN_SCENE_FOLDERS, *map(Path, more)) for file in sorted(folder.rglob("*.yaml"))):
        try:
            text = read_file_text(path)
            scene = loads(text, path.name)
            own = {**sketch_of(scene), **motion_of_points(scene)}
            plans, _ = plans_and_requested_results(scene, shown=True)
            formula = structure_of(plans.mechanism, scene.file).formula_with_frame_number(scene.frame_number)
        except PlanesError:
            continue
        name = path.stem if path.stem not in rows and not path.stem.isdigit() else f"{path.parent.name}-{path.stem}"
        one = {"name": name, "title": dict(scene.title), "formula": formula.replace("->", "→"), "text": text}
        rows[name] = {**one, "sketch": own}
    return list(rows.values())


def motion_of_points(scene: Scene) -> Json:
    """The places of every point at successive positions of the driver, as far to both sides of the given one as it can
    be drawn; ``round``: it turns without end. A driver that does not is sampled once more, between its ends."""
    plans, _ = plans_and_requested_results(scene, shown=True)
    drive = drive_number_and_range(plans)
    turns = drive["symbol"] == "φ"
    start = drive["from"]
    reach = drive["to"] - drive["from"]
    step = reach / PICTURE_POSITION_COUNT if not drive["held"] else 0.0
    values = [start + step * k for k in range(PICTURE_POSITION_COUNT)] if step else [drive["at"]]
    places, works = point_places_at(plans, values)
    home = round((drive["at"] - start) / step) % PICTURE_POSITION_COUNT if step else 0
    runs = _working_run_about(home, works, len(values), turns)
    goes_round = len(runs) == len(values)
    if not goes_round and len(runs) > 1:
        low, high = (start + step * k for k in (runs[0] - 1, runs[-1] + 1))
        kept = start + step * (home if home in runs else runs[len(runs) // 2])
        places, works = point_places_at(
            plans, [low + (high - low) * k / PICTURE_POSITION_COUNT for k in range(PICTURE_POSITION_COUNT + 1)]
        )
        runs = _working_run_about(
            round(PICTURE_POSITION_COUNT * (kept - low) / (high - low)), works, PICTURE_POSITION_COUNT + 1, False
        )
    motion = {p: [z] * len(runs) if isinstance(z, complex) else [z[k] for k in runs] for p, z in places.items()}
    return {"motion": _rounded_places(motion) if len(runs) > 1 else {}, "round": turns and goes_round}


def point_places_at(plans: Plans, values: list[float]) -> tuple[dict[str, complex | list[complex]], list[int]]:
    """The places of the points at positions of the driver, a single place for fixed points; and which positions can be
    drawn."""
    marks, program = marks_and_their_steps(plans)
    drawn = draw_program(
        program, {**plans.given, plans.drive_given_name: Listed(values), "mu_position": 1.0}, InLists()
    )
    places = {p: [*z] if isinstance(z := drawn[mark], Listed) else complex(z) for p, mark in marks.items()}
    moving = [z for z in places.values() if isinstance(z, list)]
    return places, [k for k in range(len(values)) if all(math.isfinite(abs(z[k])) for z in moving)]


def _working_run_about(home: int, works: list[int], count: int, turns: bool) -> list[int]:
    """The run of successive working positions about a given one, or the longest where that does not work; in a full
    turn the indices may go past the last or before the first."""
    every = [k + count * turn for turn in ((-1, 0, 1) if turns else (0,)) for k in works]
    if len(works) == count:
        return works
    parts = groupby(enumerate(every), lambda numbered: numbered[1] - numbered[0])
    runs = [[k for _, k in part] for _, part in parts]
    return next((r for r in runs if home in r), max(runs, key=len, default=[]))


def _rounded_places(motion: dict[str, list[complex]]) -> dict[str, list[list[float]]]:
    """Places rounded to the resolution of a picture."""
    seen = [z for places in motion.values() for z in places]
    size = max((abs(z - seen[0]) for z in seen), default=1.0) or 1.0
    digits = 1 - math.floor(math.log10(size / PICTURE_RESOLUTION_PARTS))
    return {p: [[round(z.real, digits), round(z.imag, digits)] for z in places] for p, places in motion.items()}
