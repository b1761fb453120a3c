"""Drawings of all samples' plans as pictures on paper, each right or with one mistake, checked and counted.

`python -m tests.picture_corpus [OF EACH PLAN AND KIND] [failures] [WORDS OF A SAMPLE OR PLAN]` prints the shares, the
errors of the marks and the confusion table; Ctrl+C ends it early with what was counted. The generator shares the scene
with the checker and the printed blank, and nothing else.
"""

from __future__ import annotations

import random
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path

from planes.check.blank import blank_pole
from planes.check.outcome import Outcome, check
from planes.check.vision.photograph import read_picture
from tests import confusion
from tests.confusion import Easel, easels, motion, possible, size
from tests.helpers import line_drawings, photographs
from tests.helpers.drawings import Care, Hand, Mistake
from tests.helpers.line_drawings import Stroke
from tests.helpers.same_ink import alike_on_paper, same_ink, size_on_paper

ROOM = (38.0, 288.0, 10.0, 200.0)  # of a blank: left, right, lower, upper, mm
KINDS: dict[str, Callable[[random.Random], photographs.Camera]] = {
    "scan": photographs.any_scan,
    "phone": photographs.any_phone,
    "scan 200, plain": lambda rng: photographs.SCAN,
}

READING_MM = {"scan": 0.15, "phone": 0.3, "scan 200, plain": 0.15}  # σ asked for of a mark's reading


@dataclass(frozen=True)
class Drawn:
    """A drawing on a blank: strokes and words from the pole, and the places the marks were really put at."""

    strokes: list[Stroke]
    words: list[tuple[str, complex]]
    marks: dict[str, complex]


def drawn(easel: Easel, mistake: Mistake | None, rng: random.Random, care: Care | None = None) -> Drawn | None:
    """One drawing; None where it leads off the sheet."""
    found, _ = easel.draw(mistake, Hand(care or Care(), rng))
    if easel.plan.startswith("force"):
        strokes, marks, z = [], {}, 0j
        for name, v in found.items():
            if abs(v) > 0.3:
                strokes.append((z, z + v))
            z += v
            marks[name] = z
        words = line_drawings.vector_labels([(n, v) for n, v in found.items() if abs(v) > 0.3])
    else:
        marks = found
        strokes = line_drawings.motion_strokes(motion(easel.sample), found, easel.plan == "acceleration")
        words = line_drawings.labels({"p": 0j, **found}, rng)
    pole, (left, right, lower, upper) = pole_of(easel), ROOM
    ends = [z + pole for s in strokes for z in s]
    large = max((abs(z - pole) for z in ends), default=0.0) > LEAST_MM
    fits = large and all(left < z.real < right and lower < z.imag < upper for z in ends)
    return Drawn(strokes, line_drawings.beside_lines(words, strokes), marks) if fits else None


def pole_of(easel: Easel) -> complex:
    return blank_pole(confusion.bench(easel.sample, easel.plan))


def picture(one: Drawn, pole: complex, camera: photographs.Camera, rng: random.Random, file: Path) -> None:
    page = photographs.sheet(one.strokes, one.words, pole, camera, rng)
    photographs.save(str(file), photographs.shot(page, camera, rng), camera)


LEAST_MM = 10.0  # nobody hands in a smaller drawing


def looked_at(easel: Easel, file: Path) -> tuple[Outcome, float]:
    """What the checker finds, and how long it took."""
    start = time.perf_counter()
    b = confusion.bench(easel.sample, easel.plan)
    found = check(b.asked, read_picture(str(file), b))
    return found, time.perf_counter() - start


@dataclass
class Count:
    """What came of pictures."""

    right: int = 0
    accepted: int = 0
    wrong: int = 0
    found: int = 0
    blamed: int = 0
    named: int = 0
    innocent: int = 0  # marks of wrong drawings where no mistake was made
    innocent_blamed: int = 0
    unreadable: Counter[str] = field(default_factory=Counter)  # of right and of wrong drawings
    errors: list[float] = field(default_factory=list)
    marks: int = 0
    slowest: float = 0.0
    table: Counter[tuple[str, str]] = field(default_factory=Counter)
    failures: list[str] = field(default_factory=list)

    def add(self, other: Count) -> None:
        for name, value in vars(other).items():
            if name == "slowest":
                self.slowest = max(self.slowest, value)
            elif isinstance(value, Counter):
                getattr(self, name).update(value)
            else:
                setattr(self, name, getattr(self, name) + value)


def told_of(easel: Easel, mistake: Mistake | None, one: Drawn, found: Outcome, seconds: float) -> Count:
    """One picture counted."""
    out = Count(slowest=seconds)
    true = mistake.name.partition(":")[0] if mistake else "right"
    told = found.verdict if found.verdict != "wrong" else found.mistake or "unclear"
    out.table[true, told] += 1
    blamed = found.first_wrong if found.verdict == "wrong" else None
    if found.verdict == "unreadable":
        out.unreadable["wrong" if mistake else "right"] += 1
    if mistake is None:
        out.right, out.accepted = 1, found.verdict == "right"
        good = bool(out.accepted)
    else:
        same = (found.mistake or "", blamed) in alike_on_paper(easel, mistake, tuple(one.marks))
        out.wrong, out.found = 1, found.verdict == "wrong"
        out.blamed, out.named = blamed == mistake.where or same, found.mistake == true or same
        verdicts = found.grading.verdicts if found.grading and found.verdict == "wrong" else {}
        where = blamed if same else mistake.where
        others = [v for m, v in verdicts.items() if m.label != where and v != "unread"]
        out.innocent, out.innocent_blamed = len(others), others.count("wrong")
        good = bool(out.blamed and out.named)
    if not good:
        out.failures.append(
            f"{easel.sample} {easel.plan} {mistake and (mistake.name, mistake.where, mistake.variant)}"
            f" -> {told} at {blamed}"
        )
    errors = mark_errors(easel, one, found)
    out.errors, out.marks = errors, len(one.marks)
    return out


def mark_errors(easel: Easel, one: Drawn, found: Outcome) -> list[float]:
    """How far the marks were read from where they were put, mm."""
    return [*errors_by_mark(easel, one, found).values()]


def errors_by_mark(easel: Easel, one: Drawn, found: Outcome) -> dict[str, float]:
    """The same by mark, each from its pole (vectors in a force plan)."""
    spots = found.paper.spots
    if not spots:
        return {}
    if easel.plan.startswith("force"):
        ends = {s.name: s.place - spots[0].place for s in spots[1:]}
        pole, places = 0j, [0j, *one.marks.values()]
        return {n: min(abs(z - p) for p in places) for n, z in ends.items()}
    pole = next(s.place for s in spots if s.name == "p")
    return {s.name: abs(s.place - pole - one.marks[s.name]) for s in spots if s.name in one.marks}


def draw_all(each: int, chosen: Iterable[Easel], seed: int = 1) -> Iterator[tuple[str, Easel, Count]]:
    """Every plan ``each`` times in every kind of picture: as many right as wrong, the mistakes in turn."""
    with tempfile.TemporaryDirectory() as folder:
        for easel in chosen:
            rng = random.Random(f"{seed} {easel.sample} {easel.plan}")
            every = possible(easel)
            rng.shuffle(every)
            for k in range(each * len(KINDS)):
                kind = list(KINDS)[k % len(KINDS)]
                mistakes = [m for m in every if size(easel, m, READING_MM[kind]) > 3]
                for mistake in (None, mistakes[(k // len(KINDS) + 7 * k) % len(mistakes)]):
                    one = drawn(easel, mistake, rng)
                    if one is not None and (mistake is None or seen_on_paper(easel, mistake, one, READING_MM[kind])):
                        file = Path(folder) / "p.jpg"
                        picture(one, pole_of(easel), KINDS[kind](rng), rng, file)
                        yield kind, easel, told_of(easel, mistake, one, *looked_at(easel, file))


def seen_on_paper(easel: Easel, mistake: Mistake, one: Drawn, reading: float) -> bool:
    """Whether a mistake shows on paper: in another ink than a right drawing's, by more than 3σ of what is seen."""
    order = tuple(one.marks)
    if same_ink(easel, None, mistake, order):
        return False
    return not easel.plan.startswith("force") or size_on_paper(easel, mistake, order, reading) > 3


def share(a: float, b: float) -> str:
    return f"{a:.0f}/{b:.0f} = {100 * a / max(b, 1):.1f} %"


def told(count: Count) -> str:
    """The shares as text: of all drawings, and of those that could be read."""
    errors = sorted(count.errors) or [0.0]
    lost = count.unreadable
    read = (count.right - lost["right"], count.wrong - lost["wrong"])
    accepted, readable = share(count.accepted, count.right), share(count.accepted, read[0])
    return "\n".join(
        [
            f"  right accepted    {accepted}; of the readable {readable}",
            f"  mistakes found    {share(count.found, count.wrong)}; of the readable {share(count.found, read[1])}",
            f"  right step blamed {share(count.blamed, count.wrong)}; of the readable {share(count.blamed, read[1])}",
            f"  named             {share(count.named, count.wrong)}; of the readable {share(count.named, read[1])}",
            f"  others not blamed {share(count.innocent - count.innocent_blamed, count.innocent)}",
            f"  unreadable        {share(sum(lost.values()), count.right + count.wrong)}",
            f"  marks read        {share(len(count.errors), count.marks)}, off by 50 %: "
            f"{errors[len(errors) // 2]:.2f} mm, 95 %: {errors[int(0.95 * (len(errors) - 1))]:.2f} mm",
            f"  slowest           {count.slowest:.1f} s",
        ]
    )


def main(each: int, failures: bool, chosen: Iterable[Easel]) -> None:
    """Draw, check, count and print; stopped early (Ctrl+C), what was counted so far."""
    sums: dict[tuple[str, str], Count] = defaultdict(Count)
    whole = Count()
    with suppress(KeyboardInterrupt):
        for kind, easel, one in draw_all(each, chosen):
            sums[kind, easel.plan.partition(":")[0]].add(one)
            whole.add(one)
            if failures and one.failures:
                print(kind, one.failures[0], flush=True)
    for (kind, plan), count in sorted(sums.items()):
        print(f"{kind}: {plan}\n{told(count)}")
    print(f"all\n{told(whole)}\n")
    print(table(whole))


def table(count: Count) -> str:
    """The confusion table: what was drawn, and what it was taken for."""
    lines = []
    for name in sorted({n for n, _ in count.table}):
        row = sorted(((c, t) for (n, t), c in count.table.items() if n == name), reverse=True)
        lines.append(f"{name:28}" + "  ".join(f"{t} {c}" for c, t in row))
    return "\n".join(lines)


if __name__ == "__main__":
    WORDS = [w for w in sys.argv[2:] if w != "failures"]
    main(
        int(sys.argv[1]) if len(sys.argv) > 1 else 1,
        "failures" in sys.argv,
        [e for e in easels() if all(w in f"{e.sample} {e.plan}" for w in WORDS)],
    )
