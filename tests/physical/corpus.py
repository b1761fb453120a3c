"""Factors as data, the drawings they are tried on, and what the checker makes of the pictures.

Every factor is tried on the same drawings, right and with a mistake, so that rows of the table differ by it alone.
"""

from __future__ import annotations

import random
import tempfile
import time
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

from planes.check import Outcome, check
from planes.check.grading.paper import Known
from planes.check.handed_in import read_paper
from planes.words.errors import PlanesError
from planes.words.names import label_of
from tests import confusion, picture_corpus
from tests.confusion import Easel
from tests.helpers.drawings import NONE, Hand, Mistake
from tests.helpers.same_ink import alike_on_paper
from tests.physical import camera, page
from tests.physical.counting import Tally, Truth
from tests.physical.setting import Setting, Spread, varied
from tests.picture_corpus import Drawn

MOVED_MM, READING_MM = 4.0, 0.3  # how far a mistake moves a mark at least; σ of reading one
APART_MM = 6.0  # places of a drawing that stand apart

PHONE: Spread = {"camera": "phone", "noise": 3.0, "quality": 80, "turn_deg": (-4.0, 4.0), "tilt_deg": (2.0, 8.0)}
HARD: Spread = {
    **PHONE,
    "tilt_deg": (8.0, 18.0),
    "lens": (-0.04, 0.04),
    "lamp": (0.2, 0.5),
    "shadow": [0.0, 0.35],
    "motion_px": (0.0, 3.0),
    "width_px": [1280, 2000],
    "quality": 60,
}
PAPERS = [(244, 247, 248), (214, 234, 241), (222, 224, 222)]  # white, cream, grey
FRAME: Spread = {"sheet": "frame", "pole_told": True}
POINTS: Spread = {"sheet": "paper", "pole_told": True}
PEOPLE: Spread = {
    "tool": ["pencil", "pencil", "pencil", "pen"],
    "press": (0.65, 1.1),
    "wander": (0.05, 0.18),
    "fade_mm": (2.0, 10.0),
    "fade_to": (0.5, 0.9),
    "tremor_mm": (0.03, 0.12),
    "bow_mm": (0.0, 0.2),
    "over_mm": (5.0, 25.0),
    "over_share": [0.0, 0.4, 0.7, 1.0],
    "twice": [0.0, 0.0, 0.3],
    "heads": ["filled", "barbs", "barbs"],
    "rubbed": [0, 1, 2],
    "smudges": [0, 0, 2],
    "letters": ["neat", "wild"],
    "tint": PAPERS,
    "turn_deg": (-1.5, 1.5),
}
EXTRAS: Spread = {"title_block": [False, True], "table": [False, True], "name": True, "second_plan": [False, True]}

FACTORS: dict[str, Spread] = {
    "base": {},
    "pen": {"tool": "pen"},
    "light .6": {"press": 0.6},
    "light .45": {"press": 0.45},
    "uneven pressure": {"wander": 0.22},
    "fade 8 mm": {"fade_mm": 8.0, "fade_to": 0.5},
    "fade 15 mm": {"fade_mm": 15.0, "fade_to": 0.35},
    "rough paper": {"tooth": 1.4},
    "tinted paper": {"tint": PAPERS[1:]},
    "tremor": {"tremor_mm": 0.15},
    "bow": {"bow_mm": 0.35},
    "overshoot 12 mm": {"over_mm": 12.0, "over_share": 1.0},
    "overshoot 25 mm": {"over_mm": 25.0, "over_share": 1.0},
    "drawn twice": {"twice": 1.0},
    "barbs": {"heads": "barbs"},
    "no heads": {"heads": "none"},
    "dots": {"dots": True},
    "rubbed out": {"rubbed": 4},
    "smudges": {"smudges": 6},
    "wild letters": {"letters": "wild"},
    "names with indices": {"letters": "indices"},
    "printed at 98.5 %": {"print_scale": 0.985},
    "printed at 97 %": {"print_scale": 0.97},
    "table, names": {"table": True, "name": True},
    "second plan": {"second_plan": True},
    "stamp": {"stamp": True},
    "scan 150": {"dpi": 150.0},
    "scan 300": {"dpi": 300.0},
    "scan askew 2°": {"turn_deg": 2.0},
    "quarter turns": {"quarter": [1, 2, 3]},
    "phone": PHONE,
    "phone, tilt 17°": {**PHONE, "tilt_deg": 17.0},
    "phone, lens": {**PHONE, "lens": [-0.06, 0.06]},
    "phone, lamp": {**PHONE, "lamp": 0.5},
    "phone, shadow": {**PHONE, "shadow": 0.4},
    "phone, motion": {**PHONE, "motion_px": 4.0},
    "phone, 1280 px": {**PHONE, "width_px": 1280},
    "phone, JPEG 40": {**PHONE, "quality": 40},
    "frame": FRAME,
    "frame, pole guessed": {"sheet": "frame"},
    "frame, title block": {**FRAME, "title_block": True},
    "points": POINTS,
    "points, askew 1°": {**POINTS, "turn_deg": 1.0},
    "points, askew 2°": {**POINTS, "turn_deg": 2.0},
    "points, squared": {**POINTS, "grid": "squared"},
    "points, millimetre": {**POINTS, "grid": "millimetre"},
    "points, ruled": {**POINTS, "grid": "ruled"},
    "points, phone": {**POINTS, **PHONE},
    "together: scan": {**PEOPLE, "dpi": [150.0, 200.0, 300.0], "name": [False, True]},
    "together: phone": {**PEOPLE, **HARD, "name": [False, True]},
    "together: frame": {**PEOPLE, **EXTRAS, **FRAME},
    "together: paper": {**PEOPLE, **EXTRAS, **POINTS, "grid": ["", "squared", "millimetre", "ruled"]},
}
HELD: dict[str, Spread] = {  # nobody tunes to these: they are counted once, at the end, by the word "held"
    "folded": {"crease": 0.25},
    "curled, phone": {**PHONE, "curl_mm": 5.0},
    "cup's ring": {"cup": True},
    "photocopy": {"copied": True},
    "pen that skips": {"tool": "pen", "skipping": 0.12},
    "coloured pencil": {"ink": [(60, 60, 200), (190, 90, 50), (70, 140, 60)]},
    "script letters": {"letters": "script"},
    "hard pencil": {"width_mm": 0.25, "press": 0.75},
    "green lamp, tinted": {**PHONE, "tint": (214, 240, 226), "lamp": 0.35},
    "held together": {**PEOPLE, **HARD, "letters": "script", "crease": 0.15, "table": True, "print_scale": (0.96, 1.0)},
}


HELD_NEXT: dict[str, Spread] = {  # thought of after the last mending, counted once, by the words "held next"
    "blunt pencil": {"width_mm": 0.8, "press": 0.8},
    "dim light, phone": {**PHONE, "noise": 11.0, "blur_px": 1.3},
    "thumb on a corner": {**PHONE, "thumb": True},
    "teacher's ticks": {"ticked": True},
    "flickering lamp": {**PHONE, "banding": 0.12},
}


@dataclass(frozen=True)
class Work:
    """A drawing somebody made: which plan, with which mistake."""

    easel: Easel
    mistake: Mistake | None
    one: Drawn


def works(count: int, seed: int = 1) -> Iterator[Work]:
    """Drawings by turns right and with a mistake that shows; three in four of them of motion."""
    every = list(confusion.easels())
    motion = [e for e in every if not e.plan.startswith("force")]
    force = [e for e in every if e.plan.startswith("force")]
    rng, made = random.Random(seed), 0
    while made < count:
        easel = rng.choice(force if made // 2 % 4 == 3 else motion)
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
    """Whether a mistake moves something on paper as far as anybody would see, and leaves other ink than no mistake."""
    right, wrong = (easel.draw(m, Hand(NONE, random.Random(0)))[0] for m in (None, mistake))
    moved = max(abs(wrong.get(n, 0j) - z) for n, z in right.items())
    return moved > MOVED_MM and picture_corpus.seen_on_paper(easel, mistake, one, READING_MM)


@dataclass(frozen=True)
class Picture:
    """A picture of a work as a file, and what a person who hands it in tells of it."""

    work: Work
    file: Path
    setting: Setting
    pole: complex | None = None
    marks: tuple[tuple[str, complex], ...] = ()


def picture(work: Work, setting: Setting, seed: str, file: Path) -> Picture | None:
    """The work on its sheet, taken; None where it finds no room there."""
    rng = random.Random(seed)
    laid = page.sheet(work.easel, work.one, setting, rng)
    if laid is None:
        return None
    seen, view = camera.taken(laid.paper, setting, rng)
    camera.save(seen, file, setting)
    name, told = trusted(work), Picture(work, file, setting)
    if setting.pole_told:
        told = replace(told, pole=view.see(laid.pole) + _clicked(setting, rng))
    if setting.sheet == "paper" and name:
        told = replace(told, marks=((name, view.see(laid.pole + work.one.marks[name]) + _clicked(setting, rng)),))
    return None if setting.sheet == "paper" and not name else told


def trusted(work: Work) -> str | None:
    """The mark a scale is taken from: the first long one without the mistake, which is the driver's if it can be.

    Vectors of a force plan are laid in any order, so there is none whose end is sure.
    """
    if work.easel.plan.startswith("force"):
        return None
    right = confusion.bench(work.easel.sample, work.easel.plan)
    known = {label_of(m) for m in right.marks}
    where = work.mistake.where if work.mistake else ""
    return next((n for n, z in work.one.marks.items() if n in known and n != where and abs(z) > 15), None)


def _clicked(setting: Setting, rng: random.Random) -> complex:
    return setting.clicked_px * complex(rng.gauss(0, 1), rng.gauss(0, 1))


def counted(taken: Picture) -> Tally:
    """One picture checked."""
    work, start = taken.work, time.perf_counter()
    bench = confusion.bench(work.easel.sample, work.easel.plan)
    format_ = "A4" if taken.setting.sheet == "frame" else None
    try:
        read = read_paper(str(taken.file), bench.asked, Known(taken.pole, dict(taken.marks), format_))
        found: Outcome | None = check(bench.asked, read)
    except PlanesError:
        found = None
    seconds = time.perf_counter() - start
    if found is None:
        return Tally.of(Truth("wrong" if work.mistake else "right"), "unreadable", None, None, [], seconds)
    errors = picture_corpus.errors_by_mark(work.easel, work.one, found)
    inside = sum(errors[s.name] <= 2 * s.error_mm for s in found.paper.spots if s.name in errors)
    first, said = found.first_wrong, found.mistake
    return Tally.of(truth(work, found), found.verdict, first, said, [*errors.values()], seconds, inside)


def truth(work: Work, found: Outcome) -> Truth:
    """What the drawing is; what leaves the same ink as its mistake is looked for where something else was found."""
    if work.mistake is None:
        return Truth("right")
    causes = {(work.mistake.name.partition(":")[0], work.mistake.where)}
    if found.verdict == "wrong" and (found.mistake, found.first_wrong) not in causes:
        causes |= alike_on_paper(work.easel, work.mistake, tuple(work.one.marks))
    return Truth("wrong", frozenset(causes))


def of_factor(name: str, spread: Spread, made: list[Work], seed: int = 1) -> Tally:
    """All works in pictures of one factor."""
    whole = Tally()
    with tempfile.TemporaryDirectory() as folder:
        for k, work in enumerate(made):
            drawn = f"{seed} {name} {k}"
            setting = varied(Setting(), spread, random.Random(drawn))
            taken = picture(work, setting, drawn, Path(folder) / "p.jpg")
            if taken is not None:
                whole.add(counted(taken))
    return whole
