"""What the table of a class shows of each drawing, as plain data that a later run can take up again.

A drawing that nobody could read comes first, then one of which something was not seen or not explained, then a wrong
one, then a right one. Beside a wrong place stands the picture of it, and the right construction there.
"""

from __future__ import annotations

import base64
import io
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, fields, replace
from itertools import islice

from planes.check import STATUS
from planes.check.grading.paper import Box
from planes.check.report import Checked
from planes.check.report.shown import Vector, pair, shown_plans, true_marks
from planes.geometry.plane import corners
from planes.plans.measuring import lettering, say_plan
from planes.words import Lang, say
from planes.words.names import POLE, kind_of, label_of
from planes.words.records import Json

UNREADABLE, UNSURE, WRONG, RIGHT = range(4)
MOST_PLACES = 3  # wrong places shown of a drawing
WINDOW_MM = (18.0, 90.0)  # about a wrong place: at least and at most that to each side
THUMB_PX, PLACE_PX, QUALITY, RIM_MM = 170, 320, 62, 12.0
HEADS = ("check_file", "check_verdict", "check_mark", "check_first")


@dataclass(frozen=True)
class ClassRow:
    """One drawing of a class: whose it is, what was found, the link to its report (or to itself), small pictures."""

    file: str
    verdict: str
    rank: int
    first: str = ""
    said: str = ""
    whose: str = ""
    plan: str = ""
    link: str = ""
    mistake: str = ""  # the sentence without its mark, where the mistake has a name
    picture: str = ""  # as a data: address
    places: list[Json] = field(default_factory=list)
    object: Json = field(default_factory=dict)  # what --json prints
    task: str = ""  # the file of its scene
    lettering: Json = field(default_factory=dict)  # how its sheets letter names

    @classmethod
    def of(cls, one: Checked, lang: Lang) -> ClassRow:
        """The row of what was found."""
        found, said = one.found, one.said(lang)
        said = said.removeprefix(f"{one.read_from}: ").removeprefix(f"{one.file}: ")  # that has a column of its own
        unmarked = said.removeprefix(f"{one.first}: ") if one.first else said
        return cls(
            file=one.file,
            verdict=one.verdict,
            rank=rank(one),
            first=one.first,
            said=said,
            whose=one.whose,
            plan=say_plan(found.bench.asked.plan, lang) if found else "",
            link=one.report,
            mistake=unmarked if found and found.mistake else "",
            picture=address(thumb(one)),
            places=list(islice(wrong_places(one), MOST_PLACES)),
            object=one.as_json(lang),
            lettering=lettering(found.bench.asked.scene, found.bench.plans) if found else {},
        )

    @property
    def names(self) -> list[str]:
        """The names that may stand in what is said of it."""
        return [self.first, *(str(row["mark"]) for row in self.object.get("marks", ()))]

    @property
    def kind(self) -> str:
        """The kind of its plan, "" where that is not known."""
        return kind_of(str(self.object["plan"])) if "plan" in self.object else ""

    def again_in(self, other: ClassRow) -> bool:
        """Whether another sheet is of the same plan of the same task."""
        same = (self.task, self.whose, self.plan) == (other.task, other.whose, other.plan)
        return bool(self.plan) and self.file != other.file and same

    def also(self, more: str) -> ClassRow:
        """The same row with something more said."""
        return replace(self, said=f"{self.said} {more}".strip()) if more else self

    @classmethod
    def read(cls, data: Json) -> ClassRow:
        """The row an earlier run has kept; TypeError or ValueError where it is none."""
        if set(data) != {f.name for f in fields(cls)} or data["verdict"] not in STATUS:
            raise ValueError("no row of a class")
        return cls(**data)


def rank(one: Checked) -> int:
    """How soon a teacher should look at it."""
    if one.verdict == "unreadable" or one.found is None:
        return UNREADABLE
    doubtful = one.found.unseen or (one.verdict == "wrong" and one.found.mistake is None)
    return UNSURE if doubtful else WRONG if one.verdict == "wrong" else RIGHT


def columns(rows: Sequence[ClassRow], lang: Lang) -> tuple[list[str], list[str]]:
    """The keys of a table's columns, and their names: whose only where that is known, which plan where they differ."""
    whose, plans = ({getattr(row, key) for row in rows} - {""} for key in ("whose", "plan"))
    more = ["whose"] * bool(whose) + ["plan"] * (bool(whose) or len(plans) > 1)
    words = {"whose": "check_whose", "plan": "check_plan"}
    keys = ["file", *more, "verdict", "first", "said"]
    names = dict(zip(("file", "verdict", "first", "said"), HEADS, strict=True)) | words
    return keys, [say(names[key], lang) for key in keys]


def cells(row: ClassRow, keys: Sequence[str], lang: Lang) -> list[str]:
    """The cells of a row under those columns."""
    shown = {"verdict": say(f"verdict_{row.verdict}", lang)}
    return [shown.get(key) or str(getattr(row, key)) for key in keys]


def wrong_places(one: Checked) -> Iterable[Json]:
    """Windows about the places where a drawing goes wrong, the first of them first."""
    found = one.found
    if found is None or found.grading is None or one.verdict != "wrong":
        return
    shown, paper = shown_plans(found), found.paper
    free = kind_of(found.bench.asked.plan) == "force"  # there its order is free, and a step leads to where it should be
    truth = {n: b for n, z in shown.marks.items() for a, b in shown.next if a == z} if free else true_marks(found)
    verdicts = found.grading.verdicts
    wrong = [label_of(m) for m, verdict in verdicts.items() if verdict == "wrong"]
    for name in dict.fromkeys([one.first, *wrong]):
        places = [z for z in (shown.marks.get(name), truth.get(name)) if z is not None]
        if name == POLE or not places:
            continue
        middle, apart = sum(places) / len(places), max(abs(z - places[0]) for z in places)
        reach = min(max(WINDOW_MM[0], 0.75 * apart + 6), WINDOW_MM[1])
        box = middle.real - reach, middle.imag - reach, middle.real + reach, middle.imag + reach
        yield {
            "name": name,
            "box": [round(v, 2) for v in box],
            "at": pair(places[0], 2),
            "picture": address(cropped(paper.picture, paper.box, box)),
            "strokes": _vectors(_near(paper.strokes, box)),
            "own": _vectors(shown.own),
            "true": _vectors(shown.true),
            "next": _vectors(shown.next),
            "lines": kind_of(found.bench.asked.plan) == "position",
        }


def _vectors(all_: Iterable[Vector]) -> list[list[float]]:
    return [[*pair(a, 2), *pair(b, 2)] for a, b in all_]


def _near(strokes: Iterable[Vector], box: Box) -> list[Vector]:
    """Strokes that may show in a window."""
    low, high = complex(*box[:2]), complex(*box[2:])

    def beside(a: complex, b: complex) -> bool:
        across = max(a.real, b.real) < low.real or min(a.real, b.real) > high.real
        return across or max(a.imag, b.imag) < low.imag or min(a.imag, b.imag) > high.imag

    return [(a, b) for a, b in strokes if not beside(a, b)]


def address(data: bytes) -> str:
    """A JPEG as an address that holds it."""
    return f"data:image/jpeg;base64,{base64.b64encode(data).decode()}" if data else ""


def thumb(one: Checked) -> bytes:
    """A small picture (JPEG) of a drawing, of the part with its plan if that was read; b"" of one without a picture."""
    paper = one.found.paper if one.found else None
    if not paper or not paper.picture:
        return _jpeg(one.picture, None, THUMB_PX) if one.picture else b""
    ends = [z for v in shown_plans(one.found).own for z in v] if one.found else []
    if len(ends) < 2:
        return _jpeg(paper.picture, None, THUMB_PX)
    low, high = corners(ends)
    box = low.real - RIM_MM, low.imag - RIM_MM, high.real + RIM_MM, high.imag + RIM_MM
    return cropped(paper.picture, paper.box, box, THUMB_PX)


def cropped(picture: bytes, lies: Box | None, box: Box, longest: int = PLACE_PX) -> bytes:
    """What a picture that lies so (mm from the pole) shows in a window."""
    if not picture or lies is None:
        return b""
    x0, y0, x1, y1 = lies
    part = ((box[0] - x0) / (x1 - x0), (y1 - box[3]) / (y1 - y0), (box[2] - x0) / (x1 - x0), (y1 - box[1]) / (y1 - y0))
    return _jpeg(picture, [min(max(share, -1.0), 2.0) for share in part], longest)  # marks may be anywhere


def _jpeg(picture: bytes, part: Sequence[float] | None, longest: int) -> bytes:
    from PIL import Image

    with Image.open(io.BytesIO(picture), formats=("JPEG",)) as opened:
        shown = opened.convert("L")
    if part:
        w, h = shown.size
        left, top, right, low = (round(share * size) for share, size in zip(part, (w, h, w, h), strict=True))
        out = Image.new("L", (max(right - left, 1), max(low - top, 1)), 255)
        out.paste(shown, (-left, -top))
        shown = out
    shown.thumbnail((longest, longest))
    written = io.BytesIO()
    shown.save(written, "JPEG", quality=QUALITY)
    return written.getvalue()
