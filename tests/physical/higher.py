"""`python -m tests.physical.higher [COUNT] [WORDS]`: hand drawings of class III and IV in pictures, counted.

A plan is drawn mark by mark, each with a drawing error passed on to all later ones: right, or with a mistake of the
catalogue. The right positions of the marks are verified by independent results elsewhere.
"""

from __future__ import annotations

import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Collection, Container, Iterable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path

from planes.check.grading.paper import Known
from planes.check.grading.polygons import polygon_sides
from planes.check.grading.prepared_plan import PreparedPlan, mistake_variants, prepare
from planes.check.grading.variants import Variant
from planes.check.handed_in import read_paper
from planes.check.outcome import Outcome, check
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Arithmetic, Point
from planes.words.errors import PlanesError
from planes.words.names import POLE_LABEL
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
        plans = prepare(confusion.bench(sample, "velocity").asked).plans.plan_names
        kinds = [p for p in plans if p.kind in ("velocity", "acceleration", "force")]
        found += [confusion.easel(sample, plan) for plan in kinds]
    return tuple(found)


def mistakes(bench: PreparedPlan) -> list[Variant]:
    """The mistakes of the catalogue that move a mark visibly, one for each name and place."""
    right, found = bench.draw_program(None, Tool(Arithmetic())) or {}, dict[tuple[str, str], Variant]()
    for one in mistake_variants(bench, {}, bench.said_mu):
        wrong = bench.draw_program(one, Tool(Arithmetic())) or {}
        moved = max((abs(wrong[m] - right[m]) for m in bench.marks if m in wrong), default=0.0)
        if MOVED_MM < moved < ROOM[1] - ROOM[0]:
            found.setdefault((one.mistake, one.blames), one)
    return [*found.values()]


class _ByHand(Tool):
    """Draws marks slightly off their positions, and continues from there."""

    def __init__(self, marks: Collection[str], rng: random.Random) -> None:
        super().__init__(Arithmetic())
        self.marks, self.rng = marks, rng

    def draw_by_other_steps(self, step: Step, way: Sequence[Step], things: Env) -> Point:
        made = super().draw_by_other_steps(step, way, things)
        if step.makes in self.marks:
            made = things[step.makes] = made + HAND_MM * complex(self.rng.gauss(0, 1), self.rng.gauss(0, 1))
        return made


def drawn(easel: Easel, mistake: Variant | None, rng: random.Random) -> Drawn | None:
    """One drawing by hand; None if it leaves the sheet."""
    bench = confusion.bench(easel.sample, easel.plan)
    things = bench.draw_program(mistake, _ByHand(bench.marks, rng))
    if things is None:
        return None
    ends = {m.label: complex(things[m]) for m in bench.marks}
    if easel.plan.is_force:
        strokes, words = _polygon(bench, things)
    else:
        marks = {POLE_LABEL: 0j, **ends}
        strokes = [(marks[a], marks[b]) for a, b in bench.vector_names if a in marks and b in marks]
        words = line_drawings.labels(marks, rng)
    strokes = [(a, b) for a, b in strokes if abs(b - a) > SEEN_MM]
    pole, (left, right, lower, upper) = pole_of(easel), ROOM
    fits = all(left < (z + pole).real < right and lower < (z + pole).imag < upper for s in strokes for z in s)
    return Drawn(strokes, line_drawings.beside_lines(words, strokes), ends) if fits and strokes else None


def _polygon(bench: PreparedPlan, things: Mapping[str, Point]) -> tuple[list[Stroke], list[tuple[str, complex]]]:
    """The vectors of a force polygon and their names."""
    strokes, words = list[Stroke](), [("p", -3 - 3j)]
    for side in polygon_sides(bench.plans, bench.plan):
        a, b = (0j if n == POLE_LABEL else complex(things[bench.plan.mark(n)]) for n in (side.start, side.end))
        if abs(b - a) > SEEN_MM:
            strokes.append((a, b))
            words.append((side.name, (a + b) / 2 + 2j))
    return strokes, words


def works(easel: Easel, count: int, rng: random.Random) -> Iterator[Work]:
    """Drawings of a plan, alternately right and with a mistake."""
    every = mistakes(confusion.bench(easel.sample, easel.plan))
    for k in range(count):
        rng.shuffle(every)
        for one in every if k % 2 else [None]:
            made = drawn(easel, one, rng)
            if made is not None:
                yield Work(easel, Mistake(one.mistake, one.blames) if one else None, made)
                break


def looked_at(taken: Picture) -> tuple[Outcome | str, float]:
    """The checker's outcome for a picture, or its error message; and the CPU seconds."""
    bench, start = confusion.bench(taken.work.easel.sample, taken.work.easel.plan), time.process_time()
    try:
        found: Outcome | str = check(bench.asked, read_paper(str(taken.file), bench.asked, Known()))
    except PlanesError as e:
        found = str(e)
    return found, time.process_time() - start


def pictures(
    condition: str, names: Iterable[str], count: int, folder: Path, chosen: Container[str] | None = None
) -> Iterator[Picture]:
    """Pictures of drawings of the plans whose words contain all names, ``count`` each, alternately right and wrong."""
    for easel in easels():
        words = f"{condition} {easel.sample} {easel.plan}"
        if not all(n in words for n in names) or (chosen is not None and easel.sample not in chosen):
            continue
        rng = random.Random(words)
        for k, work in enumerate(works(easel, count, rng)):
            setting = varied(Setting(), CONDITIONS[condition], rng)
            made = corpus.picture(work, setting, f"{words} {k}", folder / "page.jpg")
            if made is not None:
                yield made


def row(taken: Picture) -> tuple[str, str]:
    """The content of a picture, and its result: accepted, as seen, false, unread; found, at its step, named."""
    found, mistake = looked_at(taken)[0], taken.work.mistake
    verdict = "unreadable" if isinstance(found, str) else found.verdict
    if mistake is None or verdict != "wrong" or isinstance(found, str):
        return "wrong" if mistake else "right", verdict
    step, named = found.first_wrong == mistake.where, found.mistake == mistake.name
    return "wrong", "found" + " at its step" * step + " and named" * named


def main(words: list[str]) -> None:
    """Draws, checks, prints each and counts."""
    count, table = int(next((w for w in words if w.isdigit()), "2")), Counter[tuple[str, ...]]()
    for condition in CONDITIONS:
        with tempfile.TemporaryDirectory() as folder:
            for taken in pictures(condition, [w for w in words if not w.isdigit()], count, Path(folder)):
                easel, mistake = taken.work.easel, taken.work.mistake
                made = row(taken)
                print(
                    condition,
                    easel.sample,
                    easel.plan,
                    mistake and (mistake.name, mistake.where),
                    "->",
                    made[1],
                    flush=True,
                )
                table[condition, easel.plan.kind, *made] += 1
    for found, times in sorted(table.items()):
        print(*found, times)


if __name__ == "__main__":
    main(sys.argv[1:])
