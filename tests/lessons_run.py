"""Every sample's lesson in Chromium and Firefox: frames, marks against the engine, hands, labels, frames a second.

    python -m tests.lessons_run --browsers chromium firefox --minutes 60

Counted of each page: complaints and requests; frames; the worst mark against the drawing of the engine, at random
places and dimensions, mm (of far marks, of their distance); plan vectors dragged, those that reached their place and
those that said why not; labels upon one another, on a wide screen and on a phone; frames a second; bytes. Ends with 1
where a mark is off, a page complains, labels overlap, or a page is too large.
"""

from __future__ import annotations

import argparse
import json
import math
import random
import sys
import tempfile
import time
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from planes.drafting.drawing import Drawing, draw_program
from planes.lesson.data import lesson_data
from planes.lesson.dimensions import FreeNumbers
from planes.plans import Plans
from planes.plans.scales import plan_scales, plan_sizes_on_format
from planes.scene import load
from planes.solving import plans_and_requested_results
from planes.words.errors import PlanFailure
from tests.helpers import ROOT
from tests.helpers.browser import chromium, watched
from tests.helpers.firefox import firefox
from tests.helpers.lessons import lesson_written

ASSIGNMENTS = (3, 6, 9, 11, 14, 17, 21, 24, 27, 30, 34, 38, 41, 45, 48, 52, 56, 60, 64, 67)
PLACES, DIMENSIONS = 40, 20
FAR_MM = 1e3  # a mark farther out is compared by its distance
NEAR_MM = 1e-6
FIRST = "performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? null"
LARGEST = 250_000  # bytes of a page
SIZES = {"wide": (1280, 900), "phone": (390, 844)}

COUNTS = (ROOT / "tests" / "helpers" / "lesson_counts.js").read_text(encoding="utf-8")


@dataclass
class PageCount:
    """What was found of one page in one browser."""

    complaints: list[str]
    frames: int = 0
    positions: int = 0
    worst: float = 0.0
    unlike: list[str] = field(default_factory=list)
    reached: int = 0
    said: int = 0
    silent: list[str] = field(default_factory=list)
    overlaps: dict[str, list[str]] = field(default_factory=dict)
    fps: float = math.nan
    first_ms: float = math.nan
    size: int = 0

    def __str__(self) -> str:
        laps = ", ".join(f"{size} {len(found)}" for size, found in self.overlaps.items())
        told = f"{self.size // 1000} kB, {self.frames} frames, {self.positions} positions, worst {self.worst:.1e} mm"
        dragged = f"dragged {self.reached} and {self.said} said why not"
        return f"{told}, overlaps {laps}, {dragged}, {self.fps:.0f} fps, first {self.first_ms:.0f} ms"

    @property
    def wrong(self) -> list[str]:
        """What must not be."""
        overlaps = [f"{size}: {one}" for size, all_of in self.overlaps.items() for one in all_of]
        far = [f"a mark is off by {self.worst:.2g}"] * (self.worst > NEAR_MM)
        large = [f"{self.size} bytes"] * (self.size > LARGEST)
        return [*self.complaints, *self.unlike, *far, *large, *self.silent, *overlaps]


class DrawnByEngine:
    """The drawing of the engine itself, of a scene, for whatever is given."""

    def __init__(self, file: Path) -> None:
        scene = load(str(file))
        self.plans: Plans = plans_and_requested_results(scene, shown=True)[0]
        drive = self.plans.mechanism.drive.position
        mus = plan_scales(self.plans, scene.mu, fit_mm=plan_sizes_on_format(scene.sheet))
        self.free = FreeNumbers(self.plans, {**self.plans.given, **self.plans.drive_givens_at(drive), **mus})

    def drawn(self, flat: Mapping[str, float]) -> Drawing | None:
        """The drawing with the numbers a page has, None where it fails."""
        try:
            return draw_program(self.plans.program, self.free.givens_from_free(flat))
        except PlanFailure:
            return None


def off(marks: Mapping[str, Any], drawing: Drawing) -> float:
    """The worst mark, mm; of far ones, of their distance."""
    worst = 0.0
    for name, seen in marks.items():
        if name in drawing and not name.startswith("motion:") and drawing[name] == drawing[name]:
            true = complex(drawing[name])
            apart = abs(complex(*seen) - true) if seen else math.inf
            worst = max(worst, apart / max(1.0, abs(true) / FAR_MM))
    return worst


def numbers(data: Any, count: int, dimensions: int, rng: random.Random) -> Iterator[dict[str, float]]:
    """Random places of the drive, and random dimensions about those of the scene."""
    drive = data["drive"]
    for _ in range(count):
        yield {drive["given"]: rng.uniform(drive["from"], drive["to"])}
    for _ in range(dimensions):
        yield {k["given"]: k["at"] + rng.uniform(-0.1, 0.1) * (k["at"] or k["reach"]) for k in data["knobs"]}


def count(window: Any, file: Path, data: Any, places: int = PLACES, dimensions: int = DIMENSIONS) -> PageCount:
    """All that is counted of the page the window shows."""
    found, rng, engine = PageCount(window.errors), random.Random(file.stem), DrawnByEngine(file)
    found.frames = len(data["frames"])
    window.evaluate(COUNTS)
    for size, (w, h) in SIZES.items():
        window.set_viewport_size({"width": w, "height": h})
        window.evaluate("new Promise(done => setTimeout(done, 60))")
        found.overlaps[size] = window.evaluate("counts.overlaps()")
    for own in numbers(data, places, dimensions, rng):
        state = window.evaluate(f"counts.state({json.dumps(own)})")
        drawing = engine.drawn(state["given"])
        found.positions += 1
        if state["failed"] != (drawing is None):
            found.unlike.append(f"{own}: page {'fails' if state['failed'] else 'draws'}")
        elif drawing is not None:
            found.worst = max(found.worst, off(state["marks"], drawing))
    if data["moves"]:
        drags = window.evaluate(f"counts.dragged({rng.randrange(1, 2**31)})")
        found.reached, found.said, found.silent = drags["reached"], drags["said"], drags["silent"]
    return found


def speed(window: Any, found: PageCount, frames: int) -> None:
    """Frames a second while the crank goes round, and when the first picture was there."""
    window.set_viewport_size({"width": 1280, "height": 900})
    found.fps = window.evaluate(f"counts.spun({frames - 1})")
    found.first_ms = (
        window.evaluate("performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN") or math.nan
    )


@contextmanager
def window(name: str) -> Iterator[Any]:
    """A window of a browser by its name."""
    if name == "firefox":
        with firefox() as one:
            yield one
        return
    with chromium() as started:
        one = started.new_page()
        one.errors = watched(one)
        yield one


def scenes() -> list[Path]:
    """All samples, and twenty assignments."""
    samples = [
        *(ROOT / "samples").glob("*.yaml"),
        *(ROOT / "samples" / "class-three").glob("*.yaml"),
        *(ROOT / "samples" / "class-four").glob("*.yaml"),
    ]
    samples += [*(ROOT / "samples" / "vectors").glob("*.yaml")]
    return [*sorted(samples), *(ROOT / "samples" / "assignments" / f"{n:02}.yaml" for n in ASSIGNMENTS)]


def main() -> int:
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--browsers", nargs="+", default=["chromium", "firefox"])
    asked.add_argument("--minutes", type=float, default=60)
    asked.add_argument("--only", default="")
    asked.add_argument("--places", type=int, default=PLACES)
    asked.add_argument("--dimensions", type=int, default=DIMENSIONS)
    args = asked.parse_args()
    end, bad = time.monotonic() + 60 * args.minutes, 0
    with tempfile.TemporaryDirectory() as folder:
        for name in args.browsers:
            with window(name) as one:
                for file in scenes():
                    if args.only not in file.as_posix() or time.monotonic() > end:
                        continue
                    data = lesson_data(load(str(file)))
                    address = lesson_written(Path(folder), file, data=data)
                    one.errors.clear()
                    one.goto(address)
                    found = count(one, file, data, args.places, args.dimensions)
                    if data["moves"]:
                        speed(one, found, len(data["frames"]))
                    found.size = (Path(folder) / f"{file.stem}.html").stat().st_size
                    bad += bool(found.wrong)
                    print(name, file.stem, found, *(f"\n    {w}" for w in found.wrong[:12]), flush=True)
    return min(bad, 1)


if __name__ == "__main__":
    sys.exit(main())
