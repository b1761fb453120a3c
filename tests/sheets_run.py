"""Sheets looked over mark by mark, before any backend: what overlaps, what leaves the field, what is not named.

    python -m tests.sheets_run --samples --assignments --processes 2
    python -m tests.sheets_run samples/kind-3-rpr.yaml --lang en --pictures FOLDER
    python -m tests.sheets_run --random 100 --first 1000

Run by hand it goes through every sample in twelve positions and sheets 1, 2 and the single page of all assignments,
prints each fault in a line, then how full the sheets are, and ends with 1 where anything was wrong. --random draws the
sheets of so many random mechanisms of one to three groups.
"""

from __future__ import annotations

import argparse
import random
import re
import statistics
import sys
import time
from collections.abc import Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, replace
from itertools import combinations
from pathlib import Path
from tempfile import TemporaryDirectory

import shapely

from planes.documents.sheets import sheet_of
from planes.plans.measuring import scene_lettering
from planes.scene import Scene, load
from planes.solving import Position, solve
from planes.words import Lang, say
from planes.words.errors import PlanesError
from planes.words.naming import Naming
from render.paper.marks import Arrow, Line, Mark, Text
from render.paper.typeset import plain_text
from render.sheet import Sheet, stacking_for_paper
from render.views.arms import nonzero_terms
from tests.helpers import ROOT
from tests.helpers.conflicts import conflicts, described
from tests.helpers.mechanisms import KINDS, make, to_yaml
from tests.helpers.sheet_faults import unsightly

SAMPLES = sorted((ROOT / "samples").glob("*.yaml"))
ASSIGNMENTS = sorted((ROOT / "samples" / "assignments").glob("*.yaml"))
NUMBERS = (None, 1, 2)  # the single page, and the two sheets of a project
TWELVE = 12
STILL = 1e-9  # of the largest: nothing


@dataclass(frozen=True)
class Job:
    """One sheet to look over: ``value`` of the drive, None for the scene's own."""

    path: Path
    number: int | None
    value: float | None = None
    variant: str | None = None
    lang: Lang = "ru"

    def __str__(self) -> str:
        at = "" if self.value is None else f" at {self.value:g}"
        variant = f" {self.variant}" if self.variant else ""
        lang = "" if self.lang == "ru" else f" in {self.lang}"
        return f"{self.path.stem}{variant}{at}{lang}, {f'sheet {self.number}' if self.number else 'one page'}"


@dataclass(frozen=True)
class Looked:
    """What was found on a sheet; ``failed`` is the sentence of one that could not be drawn."""

    job: Job
    faults: tuple[str, ...] = ()
    failed: str = ""
    paper: str = ""
    full: float = 0.0
    empty: float = 0.0
    leaders: int = 0
    crossings: int = 0
    seconds: float = 0.0
    said: tuple[str, ...] = ()


def scene_of(job: Job) -> Scene:
    """The scene with twelve positions asked for, as a project shows them."""
    found = load(job.path, job.variant)
    return replace(found, sheet={**found.sheet, "positions": 12.0}, find=None) if job.number else found


def look(job: Job, pictures: str | None = None) -> Looked:
    """Draw one sheet and look it over."""
    scene, start = scene_of(job), time.process_time()
    values = None if job.value is None else [job.value]
    try:
        sheet = sheet_of(scene, values, job.lang, job.number)
    except PlanesError as error:
        return Looked(job, failed=error.told(job.lang))
    seconds = time.process_time() - start
    if pictures:
        sheet.write(Path(pictures) / f"{job.path.stem}-{job.number or 'page'}-{job.value or ''}.png")
    faults = [*clashes(sheet), *off_the_module(sheet), *unlettered(sheet), *untranslated(sheet, job.lang)]
    faults += unsightly(sheet)
    faults += omissions(scene, values, sheet, job)
    led = leaders(sheet.marks)
    return Looked(
        job,
        tuple(faults),
        "",
        sheet.paper.name,
        full(sheet),
        empty(sheet),
        len(led),
        len(crossings(sheet.marks)),
        seconds,
        sheet.warnings,
    )


def unlettered(sheet: Sheet) -> list[str]:
    """Names as the program writes them, which no draughtsman would letter."""
    raw = re.compile(r"omega|epsilon|\bphi|slide_|_drive|_[^{]|vq")
    return [f"{m.text!r} is not lettered" for m in sheet.marks if isinstance(m, Text) and raw.search(m.text)]


def untranslated(sheet: Sheet, lang: Lang) -> list[str]:
    """Russian words on an English sheet."""
    texts = (m.text for m in sheet.marks if isinstance(m, Text))
    return [f"{text!r} is Russian" for text in texts if lang == "en" and re.search("[А-яЁё]", text)]


# overlaps


def clashes(sheet: Sheet) -> list[str]:
    """Labels on labels or strokes, anything outside the frame, views in the title block or on each other."""
    x0, y0, x1, y1 = sheet.paper.field
    inner = [m for m in sheet.marks if m.layer != "frame" and not (isinstance(m, Text) and _in_block(sheet, m))]
    rules = {id(m) for m in sheet.marks if isinstance(m, Line) and m.layer == "text" and not is_leader(m)}
    free = [m for m in inner if id(m) not in rules]
    found = [str(c) for c in conflicts((), free, (x0, y0, x1, y1))]
    found += [f"{a} crosses {b}" for a, b in _leaders_meet(leaders(sheet.marks))]
    return found + _views_meet(sheet)


def off_the_module(sheet: Sheet) -> list[str]:
    """Views that do not begin at the edge of a unit of the sheet."""
    module = stacking_for_paper([], sheet.paper).module
    units = [(v.key, (left - module.left(0)) / module.unit_pitch) for v, left, _ in sheet.views]
    return [f"view {key} begins between units" for key, unit in units if abs(unit - round(unit)) > 1e-6]


def _in_block(sheet: Sheet, text: Text) -> bool:
    x0, y0, x1, y1 = sheet.paper.title_block
    return x0 <= text.place.real <= x1 and y0 <= text.place.imag <= y1


def is_leader(mark: Mark) -> bool:
    """Whether a mark is the thin line from a label to what it names."""
    return isinstance(mark, Line) and mark.name == "leader"


def leaders(marks: Sequence[Mark]) -> list[Line]:
    """All leaders of a sheet."""
    return [m for m in marks if isinstance(m, Line) and is_leader(m)]


def _shape(line: Line) -> shapely.LineString:
    return shapely.LineString([(z.real, z.imag) for z in line.points])


def _leaders_meet(lines: Sequence[Line]) -> list[tuple[str, str]]:
    pairs = combinations(lines, 2)
    return [(described(a), described(b)) for a, b in pairs if _shape(a).intersects(_shape(b))]


def crossings(marks: Sequence[Mark]) -> list[tuple[str, str]]:
    """Leaders and the strokes they cross before their ends."""
    found = []
    others = [m for m in marks if isinstance(m, (Line, Arrow)) and not is_leader(m)]
    shapes = [_shape(m) if isinstance(m, Line) else _shape(Line((m.start, m.end))) for m in others]
    tree = shapely.STRtree(shapes)
    for line in leaders(marks):
        a, b = line.points[0], line.points[-1]
        short = _shape(Line((a, b - 0.3 * (b - a) / abs(b - a))))
        found += [(described(line), described(others[k])) for k in tree.query(short, predicate="intersects")]
    return found


def _views_meet(sheet: Sheet) -> list[str]:
    boxes = [(v.key, (left, top - v.height, left + v.width, top)) for v, left, top in sheet.views]
    boxes += [("form", box) for box in sheet.paper.occupied_areas]
    apart = lambda a, b: max(b[0] - a[2], a[0] - b[2], b[1] - a[3], a[1] - b[3])  # noqa: E731
    pairs = [(i, j) for (i, a), (j, b) in combinations(boxes, 2) if apart(a, b) < 1.0 and (i, j) != ("form", "form")]
    return [f"view {i} meets {j}" for i, j in pairs]


# omissions


def said(sheet: Sheet) -> set[str]:
    """Every name lettered on a sheet, those that share a label apart."""
    texts = [plain_text(m.text) for m in sheet.marks if isinstance(m, Text)]
    return {part for text in texts for part in (text, *re.split(r", | = |; ", text))}


def omissions(scene: Scene, values: list[float] | None, sheet: Sheet, job: Job) -> list[str]:
    """Names of the results that are nowhere on the sheet, unless a sentence says that they were left out."""
    if scene.mechanism is None:
        return []
    position = solve(scene, values, None, job.lang).positions[0]
    naming = Naming(job.lang, **scene_lettering(scene, position.plans))
    there = said(sheet)
    parts = {None: (kinematics, forces), 1: (kinematics,), 2: (forces,)}[job.number]
    named = [pair for part in parts for pair in part(position, naming)]
    begun = {key for _, key in named if key.startswith("…") and any(t.startswith(key[1:]) for t in there)}
    missing = [
        (what, key)
        for what, key in named
        if key not in there and key not in begun and (job.number or not what.endswith(" lever"))
    ]
    silent = not any(say("moments", job.lang) in sentence for sentence in sheet.warnings)
    return [f"{what} is nowhere" for what, _ in missing if silent or not what.startswith("moments")]


def kinematics(p: Position, naming: Naming) -> Iterator[tuple[str, str]]:
    """What sheet 1 must name: points, links, marks of the plans, vectors found, senses."""
    for link in p.plans.mechanism.links.values():
        yield f"link {link.name}", naming.link_number(link.name)
        yield from ((f"point {x}", plain_text(naming.lettered_point(x))) for x in link.points)
    for plan in ("velocity", "acceleration"):
        found = p.results.get("plans", {}).get(plan, {"segments": {}})["segments"]
        longest = max((s["mm"] for s in found.values()), default=0.0)
        for vector, _, segment in p.measured_on(plan) if longest > 1e-6 else ():
            if segment["mm"] > STILL * longest:
                yield f"{plan} {segment['name']}", plain_text(naming.lettered_vector(vector))


def forces(p: Position, naming: Naming) -> Iterator[tuple[str, str]]:
    """What sheet 2 must name: reactions, loads, inertia, moment equations, the balancing moment."""
    sizes = {n: abs(complex(*(r["force"] if isinstance(r, dict) else r))) for n, r in p.results["reactions"].items()}
    for name in sizes:
        yield f"reaction {name}", plain_text(naming.lettered_vector(name))
    for held in p.plans.acting.forces.values():
        for f in held:
            value = abs(float(p.drawing[f.size])) if f.size in p.drawing else 0.0
            if f.spot and value > STILL * max([1e-9, *sizes.values()]):
                yield f"load {f.name}", plain_text(naming.lettered_vector(f.name))
    for m in p.plans.moments:
        if nonzero_terms(p.drawing, m):
            yield f"moments of {'–'.join(m.links)}", f"…ΣM{plain_text(naming.lettered_point(m.about))}"


# how full a sheet is


def full(sheet: Sheet) -> float:
    """The share of the field under views and title block."""
    x0, y0, x1, y1 = sheet.paper.field
    boxes = [shapely.box(left, top - v.height, left + v.width, top) for v, left, top in sheet.views]
    return float(shapely.union_all([*boxes, shapely.box(*sheet.paper.title_block)]).area / ((x1 - x0) * (y1 - y0)))


def empty(sheet: Sheet) -> float:
    """The largest rectangle without any view, as a share of the field."""
    x0, y0, x1, y1 = sheet.paper.field
    boxes = [(left, top - v.height, left + v.width, top) for v, left, top in sheet.views] + [sheet.paper.title_block]
    xs = sorted({x0, x1, *(b[0] for b in boxes), *(b[2] for b in boxes)})
    best = 0.0
    for a, b in combinations(xs, 2):
        inside = sorted((k for k in boxes if k[0] < b - 1e-9 and k[2] > a + 1e-9), key=lambda k: k[1])
        level, gap = y0, 0.0
        for k in inside:
            gap, level = max(gap, k[1] - level), max(level, k[3])
        best = max(best, (b - a) * max(gap, y1 - level))
    return best / ((x1 - x0) * (y1 - y0))


# everything


def jobs(
    samples: bool, assignments: bool, named: Sequence[str] = (), twelve: bool = True, lang: Lang = "ru"
) -> list[Job]:
    """Every sheet of the samples in twelve positions and of the assignments in their own."""
    found = []
    for path in [Path(n) for n in named] or (SAMPLES if samples else []):
        scene = load(path)
        numbers = NUMBERS if scene.mechanism else (None,)
        found += [Job(path, n, lang=lang) for n in numbers]
        if scene.mechanism and twelve:
            found += [Job(path, n, v, lang=lang) for v in positions(scene) for n in numbers]
    return found + [Job(path, n, lang=lang) for path in (ASSIGNMENTS if assignments else []) for n in NUMBERS]


def at_random(count: int, folder: Path, first: int = 0) -> list[Job]:
    """Every sheet of random mechanisms of one to three groups, all with loads, some with friction."""
    found = []
    for seed in range(first, first + count):
        rng = random.Random(f"sheets {seed}")
        made = make(rng, rng.choices(KINDS, k=1 + seed % 3), friction=seed % 4 == 0)
        (path := folder / f"random-{seed}.yaml").write_text(to_yaml(made.scene), encoding="utf-8")
        found += [Job(path, n) for n in NUMBERS]
    return found


def positions(scene: Scene) -> list[float]:
    """Twelve values of the drive: every 30°, or over a sliding driver's stroke about its own place."""
    assert scene.mechanism
    drive = scene.mechanism.drive
    if drive.kind == "phi":
        return [30.0 * k for k in range(TWELVE)]
    return [drive.position * (0.5 + k / (TWELVE - 1)) for k in range(TWELVE)]


def main() -> int:
    """Look over what the command line names."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="*")
    parser.add_argument("--samples", action="store_true")
    parser.add_argument("--assignments", action="store_true")
    parser.add_argument("--one", action="store_true", help="only the position each scene gives")
    parser.add_argument("--lang", choices=("ru", "en"), default="ru")
    parser.add_argument("--pictures", metavar="FOLDER")
    parser.add_argument("--processes", type=int, default=1)
    parser.add_argument("--seed", type=int, help="only some of them, drawn at random")
    parser.add_argument("--count", type=int, default=100, help="how many, with --seed")
    parser.add_argument("--random", type=int, default=0, help="of so many random mechanisms")
    parser.add_argument("--first", type=int, default=0, help="the number of the first of them")
    args = parser.parse_args()
    with TemporaryDirectory() as folder:
        wanted = jobs(args.samples, args.assignments, args.scenes, not args.one, args.lang)
        wanted += at_random(args.random, Path(folder), args.first)
        if args.seed is not None:
            wanted = random.Random(args.seed).sample(wanted, min(args.count, len(wanted)))
        found = []
        with ProcessPoolExecutor(args.processes) as pool:
            for one in pool.map(look, wanted, [args.pictures] * len(wanted), chunksize=1):
                found.append(one)
                print(*told(one), sep="\n", end="\n" if told(one) else "", flush=True)
    return report(found)


def told(one: Looked) -> list[str]:
    """What must be said of a sheet, a line each."""
    said = [*one.faults, *([f"not drawn: {one.failed}"] if one.failed else []), *one.said]
    return [f"{one.job}: {sentence}" for sentence in said]


def report(found: Sequence[Looked]) -> int:
    """Print what was counted; 1 if there was a fault."""
    drawn = [one for one in found if not one.failed]
    for number in NUMBERS:
        some = [one for one in drawn if one.job.number == number]
        if some:
            filled = [one.full for one in some]
            papers = {name: sum(one.paper == name for one in some) for name in ("A4", "A3", "A2", "A1", "A2x3", "A0")}
            print(
                f"{f'sheet {number}' if number else 'one page'}: {len(some)} drawn on {papers}, full "
                f"{min(filled):.2f} … {statistics.median(filled):.2f} … {max(filled):.2f}, largest empty rectangle "
                f"{statistics.median(one.empty for one in some):.2f}, at most {max(one.empty for one in some):.2f}; "
                f"{sum(one.leaders for one in some)} leaders crossing {sum(one.crossings for one in some)} strokes; "
                f"{statistics.median(one.seconds for one in some):.2f} s of processor, at most "
                f"{max(one.seconds for one in some):.2f} s"
            )
    least = sorted(drawn, key=lambda one: one.full)[:3]
    print("emptiest:", "; ".join(f"{one.job} {one.full:.2f} of {one.paper}" for one in least))
    faulty = sum(bool(one.faults) for one in found)
    print(f"{len(found)} sheets, {len(found) - len(drawn)} could not be drawn, {faulty} with faults")
    return 1 if faulty else 0


if __name__ == "__main__":
    sys.exit(main())
