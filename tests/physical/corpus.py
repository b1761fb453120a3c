"""The drawings on which factors are tested, their pictures, and the checker's findings.

Every factor has separate drawings, right and with a mistake, so that rows are independent.
"""

from __future__ import annotations

import random
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from planes.check.grading.paper import Known
from planes.check.handed_in import read_paper
from planes.check.outcome import Outcome, check
from planes.words.errors import PlanesError
from tests import confusion, picture_corpus
from tests.confusion import Easel
from tests.helpers.drawings import NONE, Hand, Mistake
from tests.helpers.same_ink import alike_on_paper
from tests.physical import camera, page
from tests.physical.counting import Tally, Truth
from tests.physical.kept import Kept
from tests.physical.setting import Setting, Spread, varied
from tests.picture_corpus import Drawn

MOVED_MM, READING_MM = 4.0, 0.3  # least displacement of a mark by a mistake; σ of reading a mark
APART_MM = 6.0  # distance of separate points of a drawing


@dataclass(frozen=True)
class Work:
    """A drawing by a person: its plan and its mistake."""

    easel: Easel
    mistake: Mistake | None
    one: Drawn


def works(count: int, seed: int | str = 1, before: int = 0) -> Iterator[Work]:
    """Drawings alternately right and with a visible mistake; three in four of them (and of those before) of motion."""
    every = list(confusion.easels())
    motion = [e for e in every if not e.plan.startswith("force")]
    force = [e for e in every if e.plan.startswith("force")]
    rng, made = random.Random(seed), 0
    while made < count:
        easel = rng.choice(force if (before + made) // 2 % 4 == 3 else motion)
        mistake = rng.choice(confusion.possible(easel) or [None]) if made % 2 else None
        if made % 2 and mistake is None:
            continue
        one = picture_corpus.drawn(easel, mistake, rng)
        if one is not None and spread_out(one) and (mistake is None or shows(easel, mistake, one)):
            made += 1
            yield Work(easel, mistake, one)


def spread_out(one: Drawn) -> bool:
    """Whether a drawing is more than one line there and back."""
    places: list[complex] = []
    for z in (z for stroke in one.strokes for z in stroke):
        if all(abs(z - other) > APART_MM for other in places):
            places.append(z)
    return len(places) > 2


def shows(easel: Easel, mistake: Mistake, one: Drawn) -> bool:
    """Whether a mistake moves a mark visibly on paper, and leaves other ink than no mistake."""
    right, wrong = (easel.draw(m, Hand(NONE, random.Random(0)))[0] for m in (None, mistake))
    moved = max(abs(wrong.get(n, 0j) - z) for n, z in right.items())
    return moved > MOVED_MM and picture_corpus.seen_on_paper(easel, mistake, one, READING_MM)


@dataclass(frozen=True)
class Picture:
    """A picture of a work as a file, and the data given by the person who submits it."""

    work: Work
    file: Path
    setting: Setting
    pole: complex | None = None
    marks: tuple[tuple[str, complex], ...] = ()


def picture(work: Work, setting: Setting, seed: str, file: Path) -> Picture | None:
    """The picture of the work on its sheet; None if it has no room there."""
    rng = random.Random(seed)
    laid = page.sheet(work.easel, work.one, setting, rng)
    if laid is None:
        return None
    seen, view = camera.taken(laid.paper, setting, rng, laid.seen)
    camera.save(seen, file, setting)
    name, told = trusted(work), Picture(work, file, setting)
    if setting.pole_told:
        told = replace(told, pole=view.see(laid.pole) + _clicked(setting, rng))
    if setting.sheet == "paper" and name:
        told = replace(told, marks=((name, view.see(laid.pole + work.one.marks[name]) + _clicked(setting, rng)),))
    return None if setting.sheet == "paper" and not name else told


def trusted(work: Work) -> str | None:
    """The mark that sets a scale: the first long one without the mistake, preferably the driver's.

    Vectors of a force plan are laid in any order, so none has a certain end.
    """
    if work.easel.plan.startswith("force"):
        return None
    right = confusion.bench(work.easel.sample, work.easel.plan)
    known = {m.label for m in right.marks}
    where = work.mistake.where if work.mistake else ""
    return next((n for n, z in work.one.marks.items() if n in known and n != where and abs(z) > 15), None)


def _clicked(setting: Setting, rng: random.Random) -> complex:
    return setting.clicked_px * complex(rng.gauss(0, 1), rng.gauss(0, 1))


def counted(taken: Picture) -> Tally:
    """The result of checking one picture."""
    return read(taken)[0]


def read(taken: Picture) -> tuple[Tally, dict[str, Any]]:
    """The result of checking one picture; the drawing, the findings, and the error and σ of each mark."""
    work, start = taken.work, time.perf_counter()
    bench = confusion.bench(work.easel.sample, work.easel.plan)
    format_ = "A4" if taken.setting.sheet == "frame" else None
    made = [work.mistake.name, work.mistake.where] if work.mistake else None
    what: dict[str, Any] = {"plan": f"{work.easel.sample} {work.easel.plan}", "made": made}
    try:
        paper = read_paper(str(taken.file), bench.asked, Known(taken.pole, dict(taken.marks), format_))
        found = check(bench.asked, paper)
    except PlanesError as e:
        seconds = time.perf_counter() - start
        tally = Tally.of(Truth("wrong" if work.mistake else "right"), "unreadable", None, None, [], seconds)
        return tally, {**what, "verdict": "unreadable", "said": str(e)}
    seconds = time.perf_counter() - start
    errors = picture_corpus.errors_by_mark(work.easel, work.one, found)
    sigmas = {s.name: s.error_mm for s in found.paper.spots if s.name in errors}
    inside = sum(errors[n] <= 2 * sigma for n, sigma in sigmas.items())
    first, said = found.first_wrong, found.mistake
    tally = Tally.of(truth(work, found), found.verdict, first, said, [*errors.values()], seconds, inside)
    off = {n: [round(errors[n], 3), round(sigma, 3)] for n, sigma in sigmas.items()}
    return tally, {**what, "verdict": found.verdict, "found": [said, first], "unseen": [*found.unseen], "marks": off}


def truth(work: Work, found: Outcome) -> Truth:
    """The true content of a drawing; if the findings differ, with mistakes that leave the same ink."""
    if work.mistake is None:
        return Truth("right")
    causes = {(work.mistake.name.partition(":")[0], work.mistake.where)}
    if found.verdict == "wrong" and (found.mistake, found.first_wrong) not in causes:
        causes |= alike_on_paper(work.easel, work.mistake, tuple(work.one.marks))
    return Truth("wrong", frozenset(causes))


def of_factor(name: str, spread: Spread, made: list[Work], seed: int, kept: Kept) -> Tally:
    """All works in pictures of one factor; those counted before are skipped."""
    whole = Tally()
    for k, work in enumerate(made):
        drawn = f"{seed} {name} {k}"
        tally = kept.tally(drawn)
        taken = None if tally else kept_picture(work, varied(Setting(), spread, random.Random(drawn)), drawn, kept)
        if taken is not None:
            tally, what = read(taken)
            kept.add(drawn, tally, {"factor": name, **what})
        whole.add(tally or Tally())
    return whole


def kept_picture(work: Work, setting: Setting, drawn: str, kept: Kept) -> Picture | None:
    """A work's picture, made now or before."""
    told = kept.told(drawn)
    if told is None:
        made = picture(work, setting, drawn, kept.file(drawn))
        kept.tell(drawn, _told(made))
        return made
    if not told:
        return None
    pole = complex(*told["pole"]) if told["pole"] else None
    return Picture(work, kept.file(drawn), setting, pole, tuple((n, complex(*z)) for n, z in told["marks"]))


def _told(made: Picture | None) -> dict[str, Any]:
    """The data of a picture from its maker, for the record; empty for a picture that was not made."""
    if made is None:
        return {}
    pole = [made.pole.real, made.pole.imag] if made.pole is not None else None
    return {"pole": pole, "marks": [[n, [z.real, z.imag]] for n, z in made.marks]}
