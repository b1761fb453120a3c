"""`python -m tests.tapes_run [SETS]`: every sample's page against the engine, at random numbers, in node.

Of each scene: half of the sets are places of its drive, half change all its dimensions at once. Told are the sets, the
places compared, the refusals (which must be the same), and the worst place as a share of its figure's size. Ends with 1
where one is off by more than 1e-9, or only one of the two refuses.
"""

from __future__ import annotations

import json
import random
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from planes.lesson.data import lesson_data
from planes.scene import load
from render.page import packer
from render.page.lesson_page import whole_lesson_page
from tests.helpers import ROOT
from tests.helpers.lessons import brought
from tests.lessons_run import DrawnByEngine, numbers

FOLDERS = (".", "assignments", "class-three", "class-four")
FAR, SETS = 1e-9, 100


def by_engine(file: Path, data: Any, sets: int, rng: random.Random) -> Iterator[dict[str, Any]]:
    """The marks of each set by the engine, mm from their poles; none where it refuses."""
    engine = DrawnByEngine(file)
    for given in numbers(data, sets // 2, sets - sets // 2, rng):
        flat = {**data["home"], **given}
        for knob in data["knobs"]:
            flat |= {n: flat[n] * flat[knob["given"]] / data["home"][knob["given"]] for n in knob["tied"]}
        drawing = engine.drawn(flat)
        marks = {m: complex(drawing[m]) for m in data["marks"] if drawing and m in drawing and m.plan != "motion"}
        places = {m: [z.real, z.imag] for m, z in marks.items() if z == z}
        yield {"given": given, "marks": places, "failed": drawing is None}


def main(sets: int) -> int:
    """Compare them all; the exit status."""
    node = shutil.which("node") or sys.exit("no node here: apt-get install nodejs")
    totals, worst = dict.fromkeys(("sets", "places", "refused", "unlike"), 0), 0.0
    with tempfile.TemporaryDirectory() as room:
        for script in (*Path(packer.__file__).parent.glob("*.js"), Path(__file__).with_name("tapes_run.mjs")):
            shutil.copy(script, room)
        Path(room, "package.json").write_text('{"type": "module"}', encoding="utf-8")
        for file in sorted(f for folder in FOLDERS for f in (ROOT / "samples" / folder).glob("*.yaml")):
            data = lesson_data(load(str(file)))
            drawn = [*by_engine(file, data, sets, random.Random(f"ten thousand {file.stem}"))]
            text = json.dumps({"held": brought(whole_lesson_page(data, "en")), "drawn": drawn})
            Path(room, "drawn.json").write_text(text, encoding="utf-8")
            command = [node, "tapes_run.mjs", "drawn.json"]
            seen = json.loads(subprocess.run(command, cwd=room, check=True, capture_output=True, text=True).stdout)
            print(file.relative_to(ROOT / "samples"), seen, flush=True)
            totals, worst = {k: n + seen[k] for k, n in totals.items()}, max(worst, seen["worst"])
    print(totals, f"worst {worst:.2g}")
    return int(worst > FAR or totals["unlike"] > 0)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]) if sys.argv[1:] else SETS))
