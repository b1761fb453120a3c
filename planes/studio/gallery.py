"""The gallery: scenes with a small picture that moves, and where each of their points is as the driver goes round."""

import math
from collections.abc import Iterable, Iterator
from pathlib import Path

from planes.drafting.drawing import run
from planes.drafting.instruments import InLists
from planes.geometry.listed import Listed
from planes.lesson.told import drive_of
from planes.plans import structure_of
from planes.scene import Scene, loads
from planes.scene.source import read
from planes.solving import plans_of
from planes.studio.sketches import sketch_of
from planes.words.errors import PlanesError
from planes.words.names import at
from planes.words.records import Json

PLACES = 36  # of the driver in a picture that moves
PARTS = 500  # of the size of a picture: no place is told finer
OWN = (Path(__file__).with_name("classics"), Path(__file__).parents[1] / "templates")
"""Where the scenes are that come with the program."""


def scenes_in(folders: Iterable[Path]) -> Iterator[Path]:
    """The scene files of folders, those of folders within them too."""
    for folder in folders:
        for path in sorted(folder.rglob("*.yaml")):
            if "\nlinks:" in path.read_text("utf-8"):
                yield path


def shelved(paths: Iterable[Path]) -> list[Json]:
    """What the gallery shows of every scene that has a mechanism and works; names are those of files, each once."""
    found: dict[str, Json] = {}
    for path in paths:
        try:
            text = read(path)
            scene = loads(text, path.name)
            own = {**sketch_of(scene), **motion_of(scene)}
            plans, _ = plans_of(scene, shown=True)
            formula = structure_of(plans.mechanism, scene.file).formula_as(scene.frame_number)
        except PlanesError:
            continue
        name = path.stem if path.stem not in found and not path.stem.isdigit() else f"{path.parent.name}-{path.stem}"
        one = {"name": name, "title": dict(scene.title), "formula": formula.replace("->", "→"), "text": text}
        found[name] = {**one, "sketch": own}
    return list(found.values())


def motion_of(scene: Scene) -> Json:
    """The places of every point at places of the driver one after another, where it can be drawn; ``round``: it goes
    round without end."""
    plans, _ = plans_of(scene, shown=True)
    drive, m = drive_of(plans), plans.mechanism
    marks = {p: at("position", p) for p in m.names if at("position", p) in plans.program.made}
    program = plans.program.sliced([*marks.values()])
    start, reach = drive["from"], drive["to"] - drive["from"]
    count = PLACES if reach and not drive["held"] else 1
    values = Listed(start + reach * k / PLACES if count > 1 else drive["at"] for k in range(count))
    drawn = run(program, {**plans.given, plans.drive_given: values, "mu_position": 1.0}, InLists())
    places = {p: [*drawn[mark]] for p, mark in marks.items() if isinstance(drawn[mark], Listed)}
    works = [k for k in range(len(values)) if all(math.isfinite(abs(z[k])) for z in places.values())]
    still = {p: [z.real, z.imag] for p, mark in marks.items() if not isinstance(z := drawn[mark], Listed)}
    runs = _longest(works, len(values))
    seen = [z[k] for z in places.values() for k in runs]
    size = max((abs(z - seen[0]) for z in seen), default=1.0) or 1.0
    digits = 1 - math.floor(math.log10(size / PARTS))
    motion = {p: [[round(z[k].real, digits), round(z[k].imag, digits)] for k in runs] for p, z in places.items()}
    motion |= {p: [z] * len(runs) for p, z in still.items()}
    return {"motion": motion if len(runs) > 1 else {}, "round": drive["symbol"] == "φ" and len(runs) == len(values)}


def _longest(works: list[int], count: int) -> list[int]:
    """The longest run of places that work, one after another; a turn has no end."""
    if len(works) == count:
        return works
    best: list[int] = []
    for start in works:
        run_of = [start]
        while (run_of[-1] + 1) % count in works and len(run_of) < len(works):
            run_of.append((run_of[-1] + 1) % count)
        best = max(best, run_of, key=len)
    return best
