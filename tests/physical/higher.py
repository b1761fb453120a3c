"""`python -m tests.physical.higher [COUNT] [WORDS]`: hand drawings of class III and IV as scans and photographs, counted.

A plan is drawn mark by mark, each with a hand's error that all later ones are drawn from: rightly, or with a mistake
of the catalogue. Where the marks of the right one should be is held by the independent results, elsewhere.
"""

from __future__ import annotations

import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path

from planes.check import Outcome, check
from planes.check.grading.handwork import Variant
from planes.check.grading.paper import Known
from planes.check.grading.polygons import sides_of
from planes.check.grading.prepared_plan import PreparedPlan, prepare, redrawn, variants_of
from planes.check.handed_in import read_paper
from planes.drafting.steps import Step
from planes.geometry.arithmetic import Point
from planes.words.errors import PlanesError
from planes.words.names import POLE, at, kind_of, label_of
from tests import confusion
from tests.confusion import Easel
from tests.helpers import line_drawings
from tests.helpers.drawings import Mistake
from tests.helpers.line_drawings import Stroke
from tests.physical import corpus
from tests.physical.corpus import Picture, Work
from tests.physical.factors import PHONE
from tests.physical.setting import Setting, Spread, varied
from tests.picture_corpus import ROOM, Drawn, pole_of
from tests.sample_oracle import HIGHER

HAND_MM, MOVED_MM, SEEN_MM = 0.15, 4.0, 0.3
CONDITIONS: dict[str, Spread] = {"scan": {}, "phone": PHONE}


@cache
def easels() -> tuple[Easel, ...]:
    """The plans of velocity, acceleration and forces of every sample of class III and IV."""
    found = []
    for sample in HIGHER:
        plans = prepare(confusion.bench(sample, "velocity").asked).plans.drawn
        kinds = [p for p in plans if kind_of(p) in ("velocity", "acceleration", "force")]
        found += [confusion.easel(sample, plan) for plan in kinds]
    return tuple(found)


def mistakes(bench: PreparedPlan) -> list[Variant]:
    """The mistakes of the catalogue that move a mark as far as anybody would see, one of a name and place."""
    right, found = redrawn(bench, None, _as_made) or {}, dict[tuple[str, str], Variant]()
    for one in variants_of(bench, {}, bench.said_mu):
        wrong = redrawn(bench, one, _as_made) or {}
        moved = max((abs(wrong[m] - right[m]) for m in bench.marks if m in wrong), default=0.0)
        if MOVED_MM < moved < ROOM[1] - ROOM[0]:
            found.setdefault((one.mistake, one.blames), one)
    return [*found.values()]


def _as_made(step: Step, made: Point) -> Point:
    return made


def drawn(easel: Easel, mistake: Variant | None, rng: random.Random) -> Drawn | None:
    """One drawing by a hand; None where it leads off the sheet."""
    bench = confusion.bench(easel.sample, easel.plan)

    def by_hand(step: Step, made: Point) -> Point:
        shaky = step.makes in bench.marks
        return made + HAND_MM * complex(rng.gauss(0, 1), rng.gauss(0, 1)) if shaky else made

    things = redrawn(bench, mistake, by_hand)
    if things is None:
        return None
    ends = {label_of(m): complex(things[m]) for m in bench.marks}
    if kind_of(easel.plan) == "force":
        strokes, words = _polygon(bench, things)
    else:
        marks = {POLE: 0j, **ends}
        strokes = [(marks[a], marks[b]) for a, b in bench.vectors if a in marks and b in marks]
        words = line_drawings.labels(marks, rng)
    strokes = [(a, b) for a, b in strokes if abs(b - a) > SEEN_MM]
    pole, (left, right, lower, upper) = pole_of(easel), ROOM
    fits = all(left < (z + pole).real < right and lower < (z + pole).imag < upper for s in strokes for z in s)
    return Drawn(strokes, line_drawings.beside_lines(words, strokes), ends) if fits and strokes else None


def _polygon(bench: PreparedPlan, things: Mapping[str, Point]) -> tuple[list[Stroke], list[tuple[str, complex]]]:
    """The vectors of a force polygon and their names."""
    strokes, words = list[Stroke](), [("p", -3 - 3j)]
    for side in sides_of(bench.plans, bench.asked.plan):
        a, b = (0j if n == POLE else complex(things[at(bench.asked.plan, n)]) for n in (side.start, side.end))
        if abs(b - a) > SEEN_MM:
            strokes.append((a, b))
            words.append((side.name, (a + b) / 2 + 2j))
    return strokes, words


def works(easel: Easel, count: int, rng: random.Random) -> Iterator[Work]:
    """Drawings of a plan, by turns right and with a mistake."""
    every = mistakes(confusion.bench(easel.sample, easel.plan))
    for k in range(count):
        rng.shuffle(every)
        for one in every if k % 2 else [None]:
            made = drawn(easel, one, rng)
            if made is not None:
                yield Work(easel, Mistake(one.mistake, one.blames) if one else None, made)
                break


def looked_at(taken: Picture) -> tuple[Outcome | str, float]:
    """What the checker makes of a picture, or says of one it refuses; and the seconds of processor time it took."""
    bench, start = confusion.bench(taken.work.easel.sample, taken.work.easel.plan), time.process_time()
    try:
        found: Outcome | str = check(bench.asked, read_paper(str(taken.file), bench.asked, Known()))
    except PlanesError as e:
        found = str(e)
    return found, time.process_time() - start


def main(words: list[str]) -> None:
    """Draw, check, print each and count."""
    count, names, table = (
        int(next((w for w in words if w.isdigit()), "2")),
        [w for w in words if not w.isdigit()],
        Counter(),
    )
    for condition, spread in CONDITIONS.items():
        for easel in (e for e in easels() if all(n in f"{condition} {e.sample} {e.plan}" for n in names)):
            rng = random.Random(f"{condition} {easel.sample} {easel.plan}")
            for work in works(easel, count, rng):
                with tempfile.TemporaryDirectory() as folder:
                    made = corpus.picture(
                        work, varied(Setting(), spread, rng), str(rng.random()), Path(folder) / "p.jpg"
                    )
                    if made is None:
                        continue
                    found, seconds = looked_at(made)
                said = found if isinstance(found, str) else f"{found.verdict} {found.first_wrong} {found.mistake}"
                more = "" if isinstance(found, str) else found.sentence.told("en")[:90]
                print(
                    f"{condition:6} {easel.sample:22} {easel.plan:16} {work.mistake and (work.mistake.name, work.mistake.where)} -> {said} {seconds:.1f} s {more}",
                    flush=True,
                )
                verdict = "refused" if isinstance(found, str) else found.verdict
                table[condition, kind_of(easel.plan), "wrong" if work.mistake else "right", verdict] += 1
    for row, times in sorted(table.items()):
        print(*row, times)


if __name__ == "__main__":
    main(sys.argv[1:])
