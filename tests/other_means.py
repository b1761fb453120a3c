"""`python -m tests.other_means COUNT seed=K into=DIR fonts=DIR`: blanks drawn on by other means, and their count.

Strokes by Pillow, letters of whatever fonts a folder holds, mistakes of any size, two at once, whole plans mirrored or
at another scale; folds, coffee, red pen, a ruler, a second drawing, cream and ruled paper. It shares the printed blank
and the program's steps with the checker, and nothing of how ink is laid or seen. Kept for counting: nobody tunes to it.
"""

from __future__ import annotations

import cmath
import json
import math
import random
import sys
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import cv2
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from planes.check.blank import blank_pole, plan_fitting_blank
from planes.check.fiducials import SHEET_MM
from planes.check.grading.paper import Known
from planes.check.grading.polygons import polygon_sides
from planes.check.grading.prepared_plan import Asked, PreparedPlan, mistake_variants, prepare
from planes.check.grading.variants import Variant
from planes.check.handed_in import read_paper
from planes.check.outcome import check
from planes.documents.check import blank_marks
from planes.drafting.drawing import draw_steps
from planes.drafting.steps import Step
from planes.drafting.tools import Env, Tool
from planes.geometry.arithmetic import Arithmetic, Point
from planes.scene import load
from planes.words.errors import PlanesError
from planes.words.names import POLE_LABEL
from render.files import pdf
from tests.helpers import ROOT

PX = 10.0  # of a sheet, a millimetre
SCENES = ("six-link", "bntu-1", "bntu-3", "kind-1-rrr", "kind-3-rpr", "shaper", "assignments/05", "assignments/11")
SPOILS = ("scan", "scan", "phone", "phone", "night", "folds", "coffee", "red", "smear", "ruler", "turned", "second")
SPOILS = (*SPOILS, "squared", "lined", "cream")
MISTAKES = ("catalogue", "length", "angle", "offset", "mirrored", "scale", "two")
MOVED_MM = 5.0  # what a mistake moves at least
SHOWN_MM = 25.0  # what is drawn at least: a polygon without its only force is an empty sheet


@dataclass(frozen=True)
class Spoilt:
    """A mistake: its kind, at which marks, how each is moved, what is done to the whole plan."""

    kind: str = "right"
    marks: tuple[str, ...] = ()
    nudges: tuple[complex, ...] = ()
    variant: Variant | None = None
    whole: tuple[complex, bool] = (1 + 0j, False)


class Nudging(Tool):
    """Draws the program's steps with a hand's errors, some marks moved."""

    def __init__(self, by: Mapping[str, complex], rng: random.Random | None) -> None:
        super().__init__(Arithmetic())
        self.by, self.rng = by, rng

    def draw_by_other_steps(self, step: Step, way: Sequence[Step], things: Env) -> Point:
        made = super().draw_by_other_steps(step, way, things)
        if step.makes in self.by:
            made = made + self.by[step.makes]
            if self.rng:
                made += complex(self.rng.gauss(0, 0.2), self.rng.gauss(0, 0.2))
            things[step.makes] = made
        return made


def places(bench: PreparedPlan, spoilt: Spoilt, rng: random.Random | None) -> dict[str, complex] | None:
    """The marks of a drawing by label, mm from the pole."""
    by = dict.fromkeys(bench.marks, 0j) | {
        m: z for m in bench.marks for n, z in zip(spoilt.marks, spoilt.nudges, strict=True) if n == m.label
    }
    things = {**bench.given, **(spoilt.variant.givens if spoilt.variant else {})}
    try:
        draw_steps(bench.program.steps, things, Nudging(by, rng), spoilt.variant.swaps if spoilt.variant else {})
    except (PlanesError, ZeroDivisionError):
        return None
    turn, mirrored = spoilt.whole
    out = {m.label: complex(things[m]) for m in bench.marks}
    return {n: (z.conjugate() if mirrored else z) * turn for n, z in out.items()}


@cache
def benches() -> list[PreparedPlan]:
    """Every plan of the scenes that fills some of a blank."""
    out = []
    for name in SCENES:
        scene = load(ROOT / "samples" / f"{name}.yaml")
        for plan in prepare(Asked(scene, "velocity")).plans.plan_names:
            if plan in ("lever", "motion"):
                continue
            bench = plan_fitting_blank(prepare(Asked(scene, plan)))
            at = {POLE_LABEL: 0j, **bench.true_marks}
            ends = [at[n] for line in lines_of(bench) for n in line]
            if len(bench.marks) > 1 and max(abs(z - w) for z in ends for w in ends) > 25:
                out.append(bench)
    return out


def lines_of(bench: PreparedPlan) -> list[tuple[str, str]]:
    """What is drawn, by the ends; heads at the second ones, but of links."""
    known, plan = {POLE_LABEL, *(m.label for m in bench.marks)}, bench.plan
    if plan.kind == "position":
        out = []
        for link in bench.plans.mechanism.links.values():
            points = [n for n in link.points if n in known and n != link.centre]
            out += list(pairwise(points))
        return out
    if plan.is_force:
        equations = [e for e in bench.plans.equations if e.plan == plan]
        polygon = max(equations, key=lambda e: len(e.all_terms))
        sides = [(t.start, t.end) if t.sign > 0 else (t.end, t.start) for t in polygon.all_terms]
        return [s for s in sides if {*s} <= known] or [(s.start, s.end) for s in polygon_sides(bench.plans, plan)]
    return [v for v in bench.vector_names if {*v} <= known]


def spoiled(bench: PreparedPlan, kind: str, rng: random.Random) -> Spoilt | None:
    """A mistake of a kind that shows; None where none was hit upon."""
    true = places(bench, Spoilt(), None) or {}
    fixed = bench.plans.mechanism.frame.points if bench.kind == "position" else ()
    free = [n for n, z in true.items() if n not in fixed and abs(z) > 8]
    before = {b: a for a, b in reversed(lines_of(bench))}
    for _ in range(30):
        found = _spoiled(bench, kind, rng, true, free, before)
        drawn = found and places(bench, found, None)
        moved = max(abs(drawn[n] - true[n]) for n in true) if drawn else 0.0
        if found and drawn and moved > MOVED_MM and all(abs(z) < 110 for z in drawn.values()):
            return found
    return None


def _spoiled(
    bench: PreparedPlan,
    kind: str,
    rng: random.Random,
    true: dict[str, complex],
    free: list[str],
    before: dict[str, str],
) -> Spoilt | None:
    if kind == "catalogue":
        variants = mistake_variants(bench, {}, bench.said_mu)
        return Spoilt(kind, (), (), v) if variants and (v := rng.choice(variants)) else None
    if kind in ("mirrored", "scale"):
        if bench.kind == "position":
            return None
        k = rng.choice((0.5, 0.7, 0.8, 1.25, 1.4)) if kind == "scale" else rng.choice((1, -1))
        return Spoilt(kind, (), (), None, (complex(k), kind == "mirrored"))
    marks = rng.sample(free, min(2 if kind == "two" else 1, len(free)))
    nudges = []
    for mark in marks:
        v = true[mark] - true.get(before.get(mark, POLE_LABEL), 0j)
        v = v if abs(v) > 3 else 20 * cmath.rect(1, rng.uniform(0, 6.28))
        how = rng.choice(("length", "angle", "offset")) if kind == "two" else kind
        if how == "length":
            nudges.append(v * rng.choice((-1, 1)) * rng.uniform(0.15, 0.6))
        elif how == "angle":
            nudges.append(v * (cmath.rect(1, rng.choice((-1, 1)) * math.radians(rng.uniform(10, 90))) - 1))
        else:
            nudges.append(cmath.rect(rng.uniform(6, 20), rng.uniform(0, 6.28)))
    return Spoilt(kind, tuple(marks), tuple(nudges)) if marks else None


# --- the sheet


class Sheet:
    """A blank that is drawn upon by Pillow."""

    def __init__(self, bench: PreparedPlan, rng: random.Random, fonts: Sequence[Path]) -> None:
        marks, title = blank_marks(
            bench.asked if bench.asked.mu else bench.at_scale(bench.said_mu, fixed=True).asked, "en"
        )
        data = np.frombuffer(pdf.write_png(marks, SHEET_MM, title, dpi=PX * 25.4), np.uint8)
        grey = cv2.imdecode(data, cv2.IMREAD_GRAYSCALE)
        size = round(SHEET_MM[0] * PX), round(SHEET_MM[1] * PX)
        self.paper = Image.fromarray(cv2.resize(grey, size, interpolation=cv2.INTER_AREA)).convert("RGB")
        self.rng, self.font = rng, rng.choice(fonts)
        self.ink = rng.choice(((70, 70, 78), (95, 92, 95), (40, 40, 120), (30, 30, 30)))
        self.width = rng.uniform(0.3, 0.7)
        self.shake, self.heads = rng.uniform(0.02, 0.12), rng.choice(("open", "filled", "open"))

    def px(self, z: complex) -> tuple[float, float]:
        """Pixels of a place in mm."""
        return z.real * PX, self.paper.height - z.imag * PX

    def stroke(self, a: complex, b: complex, ink: tuple[int, int, int] | None = None, width: float = 0.0) -> None:
        """A line that shakes, laid on with a pressure that wanders."""
        n = max(4, int(abs(b - a) / 1.5))
        layer = Image.new("L", self.paper.size, 0)
        draw, side = ImageDraw.Draw(layer), 1j * (b - a) / max(abs(b - a), 1e-6)
        bow, phase = self.rng.gauss(0, 0.12), self.rng.uniform(0, 6)
        at = [
            a + (b - a) * k / n + side * (bow * math.sin(math.pi * k / n) + self.rng.gauss(0, self.shake))
            for k in range(n + 1)
        ]
        at[0], at[-1] = a, b
        for k, (p, q) in enumerate(pairwise(at)):
            press = 200 + 40 * math.sin(phase + 0.4 * k) + self.rng.gauss(0, 12)
            draw.line(
                [self.px(p), self.px(q)],
                fill=int(min(max(press, 90), 255)),
                width=max(2, round((width or self.width) * PX)),
            )
        box = layer.getbbox()
        if box:
            self.paper.paste(Image.new("RGB", self.paper.size, ink or self.ink), (0, 0), layer)

    def vector(self, a: complex, b: complex, head: bool = True) -> None:
        """A line with its head."""
        if abs(b - a) < 0.5:
            return
        over = self.rng.choice((0, 0, 0, self.rng.uniform(2, 12)))
        way = (b - a) / abs(b - a)
        self.stroke(a, b + over * way if not head else b)
        if not head or abs(b - a) < 4:
            return
        size, half = self.rng.uniform(2.8, 4.5), self.rng.uniform(0.17, 0.3)
        wings = [b - size * way * cmath.rect(1, s * half) for s in (1, -1)]
        if self.heads == "open":
            for w in wings:
                self.stroke(b, w)
        else:
            ImageDraw.Draw(self.paper).polygon([self.px(z) for z in (b, *wings)], fill=self.ink)

    def point(self, z: complex, hinge: bool) -> None:
        """A hinge as a circle, a centre of mass as a dot."""
        r, pen = (1.3 if hinge else 0.7) * PX, ImageDraw.Draw(self.paper)
        x, y = self.px(z)
        inside, width = (255, 255, 255) if hinge else self.ink, round(self.width * PX)
        pen.ellipse([x - r, y - r, x + r, y + r], fill=inside, outline=self.ink, width=width)

    def word(self, text: str, z: complex, height: float = 4.0, ink: tuple[int, int, int] | None = None) -> None:
        """A word in a font."""
        font = ImageFont.truetype(str(self.font), round(height * PX * self.rng.uniform(0.9, 1.3)))
        tile = Image.new("L", (round(len(text) * height * PX) + 60, round(2.2 * height * PX)), 0)
        ImageDraw.Draw(tile).text((15, 5), text, fill=220, font=font)
        tile = tile.rotate(self.rng.uniform(-8, 8), expand=True)
        x, y = self.px(z)
        self.paper.paste(Image.new("RGB", tile.size, ink or self.ink), (round(x), round(y - tile.height / 2)), tile)


def sheet(bench: PreparedPlan, drawn: dict[str, complex], spoil: str, rng: random.Random, fonts: Sequence[Path]) -> Any:
    """The sheet, BGR."""
    page, pole, at = Sheet(bench, rng, fonts), blank_pole(bench), {POLE_LABEL: 0j, **drawn}
    kind, width = bench.kind, SHEET_MM[0]
    if spoil in ("squared", "lined"):
        pen = ImageDraw.Draw(page.paper)
        step = 5 if spoil == "squared" else 8
        for k in range(0, 300, step):
            pen.line([(0, k * PX), (page.paper.width, k * PX)], fill=(190, 205, 225), width=2)
            if spoil == "squared":
                pen.line([(k * PX, 0), (k * PX, page.paper.height)], fill=(190, 205, 225), width=2)
    for a, b in lines_of(bench):
        page.vector(pole + at[a], pole + at[b], kind != "position")
    centres = {link.centre for link in bench.plans.mechanism.links.values()}
    for n, z in drawn.items() if kind == "position" else ():
        page.point(pole + z, n not in centres)
    for n, z in drawn.items():
        if rng.random() < 0.9:
            page.word(n, pole + z + cmath.rect(rng.uniform(2, 4), rng.uniform(0, 6.28)))
    if spoil == "second":
        z = complex(rng.uniform(60, 90), rng.uniform(40, 160))
        for _ in range(4):
            w = z + cmath.rect(rng.uniform(8, 25), rng.uniform(0, 6.28))
            page.vector(z, w)
            z = w
    if spoil == "red":
        red = (205, 30, 40)
        for _ in range(rng.randint(2, 4)):
            z = pole + complex(rng.uniform(-45, 45), rng.uniform(-45, 45))
            page.stroke(z, z + 4 - 5j, red, 0.6)
            page.stroke(z + 4 - 5j, z + 12 + 9j, red, 0.6)
        page.word("see me", pole + complex(rng.uniform(-60, 20), rng.uniform(-60, 60)), 7, red)
    colour = cv2.cvtColor(np.array(page.paper), cv2.COLOR_RGB2BGR).astype(np.float32)
    h, w = colour.shape[:2]
    if spoil == "smear":
        for _ in range(5):
            x, y = (rng.uniform(0.2, 0.8) * w, rng.uniform(0.2, 0.8) * h)
            blot: Any = np.zeros((h, w), np.float32)
            cv2.ellipse(
                blot,
                (int(x), int(y)),
                (int(rng.uniform(60, 200)), int(rng.uniform(15, 50))),
                rng.uniform(0, 180),
                0,
                360,
                1,
                -1,
            )
            colour *= 1 - rng.uniform(0.1, 0.25) * cv2.GaussianBlur(blot, (0, 0), 15)[..., None]
    if spoil == "folds":
        for across in (True, False):
            off = np.arange(w if across else h, dtype=np.float32) - rng.uniform(0.35, 0.65) * (w if across else h)
            line = (
                1
                - 0.28 * np.exp(-((off / (0.25 * PX)) ** 2))
                + 0.1 * np.exp(-(((off - 6) / 5) ** 2))
                - 0.08 * (off > 0)
            )
            colour *= line[None, :, None] if across else line[:, None, None]
    if spoil == "coffee":
        blot = np.zeros((h, w), np.float32)
        where = int(rng.uniform(0.3, 0.7) * w), int(rng.uniform(0.3, 0.7) * h)
        cv2.circle(blot, where, int(38 * PX), 0.35, -1)
        cv2.circle(blot, where, int(38 * PX), 1.0, int(1.2 * PX))
        colour *= 1 - cv2.GaussianBlur(blot, (0, 0), 6)[..., None] * np.array([0.4, 0.25, 0.15], np.float32)
    if spoil == "ruler":
        x = rng.uniform(30, width - 60)
        corners = np.array(
            [
                page.px(complex(x, 2)),
                page.px(complex(x + 25, 2)),
                page.px(complex(x + 45, 60)),
                page.px(complex(x + 20, 60)),
            ],
            np.int32,
        )
        cv2.fillConvexPoly(colour, corners, (150.0, 190.0, 205.0))
        shade = np.ones((h, w), np.float32)
        cv2.fillConvexPoly(shade, corners + np.array([40, -30]), 0.8)
        colour *= cv2.GaussianBlur(shade, (0, 0), 12)[..., None]
    if spoil == "cream":
        colour *= np.array([0.78, 0.92, 0.97], np.float32)
    return np.clip(colour + np.random.default_rng(rng.randrange(1 << 30)).normal(0, 3, colour.shape), 0, 255).astype(
        np.uint8
    )


def taken(colour: Any, spoil: str, rng: random.Random) -> Any:
    """The sheet as its picture shows it."""
    h, w = colour.shape[:2]
    phone = spoil in ("phone", "night", "ruler", "cream", "turned", "folds", "coffee") and rng.random() < 0.75
    if not phone:
        small = cv2.resize(colour, None, fx=0.8, fy=0.8, interpolation=cv2.INTER_AREA)
        turn = cv2.getRotationMatrix2D((small.shape[1] / 2, small.shape[0] / 2), rng.uniform(-1.2, 1.2), 1)
        return cv2.warpAffine(small, turn, small.shape[1::-1], borderValue=(250, 250, 250))
    W, H = 2200, 1650
    rim = [rng.uniform(40, 170) for _ in range(8)]
    to = np.float32([[rim[0], rim[1]], [W - rim[2], rim[3]], [W - rim[4], H - rim[5]], [rim[6], H - rim[7]]])
    warp = cv2.getPerspectiveTransform(np.float32([[0, 0], [w, 0], [w, h], [0, h]]), to)
    out = cv2.warpPerspective(colour, warp, (W, H), flags=cv2.INTER_AREA, borderValue=(70, 95, 120)).astype(np.float32)
    y, x = np.mgrid[0:H, 0:W].astype(np.float32)
    angle = rng.uniform(0, 6.28)
    dim = rng.uniform(0.25, 0.45) if spoil == "night" else rng.uniform(0.75, 1.0)
    fall = 0.5 if spoil == "night" else 0.25
    out *= (dim * (1 - fall * ((x / W - 0.5) * math.cos(angle) + (y / H - 0.5) * math.sin(angle) + 0.5)))[..., None]
    out = cv2.GaussianBlur(out, (0, 0), rng.uniform(0.5, 1.1))
    out += np.random.default_rng(rng.randrange(1 << 30)).normal(0, 6 if spoil == "night" else 3, out.shape)
    out = np.clip(out, 0, 255).astype(np.uint8)
    return np.rot90(out, rng.choice((1, 2, 3))).copy() if spoil == "turned" else out


def _mm(at: Mapping[str, complex], bench: PreparedPlan) -> float:
    """How much is drawn, mm."""
    return sum(abs(at[a] - at[b]) for a, b in lines_of(bench))


def made(k: int, seed: str, folder: Path, fonts: Sequence[Path]) -> dict[str, Any]:
    """The picture of a number, made now or before, with what it shows."""
    file = folder / f"{seed}-{k:04}.jpg"
    told = file.with_suffix(".json")
    if told.is_file():
        return dict(json.loads(told.read_text("utf-8")))
    rng = random.Random(f"other means {seed} {k}")
    while True:
        bench, kind = rng.choice(benches()), "right" if k % 2 else rng.choice(MISTAKES)
        spoilt = Spoilt() if kind == "right" else spoiled(bench, kind, rng)
        drawn = spoilt and places(bench, spoilt, rng)
        if (
            spoilt
            and drawn
            and all(abs(z) < 100 for z in drawn.values())
            and _mm({POLE_LABEL: 0j, **drawn}, bench) > SHOWN_MM
        ):
            break
    spoil = rng.choice(SPOILS)
    cv2.imwrite(
        str(file),
        taken(sheet(bench, drawn, spoil, rng, fonts), spoil, rng),
        [cv2.IMWRITE_JPEG_QUALITY, rng.choice((60, 80, 90))],
    )
    blames = [spoilt.variant.blames] if spoilt.variant else [*spoilt.marks]
    scene = Path(bench.asked.scene.file).relative_to(ROOT / "samples").with_suffix("")
    row = {"file": file.name, "scene": str(scene), "plan": bench.asked.plan, "mu": bench.asked.mu, "kind": kind,
           "spoil": spoil, "marks": blames, "mistake": spoilt.variant.mistake if spoilt.variant else None,
           "places": {n: [z.real, z.imag] for n, z in drawn.items()}}  # fmt: skip
    told.write_text(json.dumps(row, ensure_ascii=False), "utf-8")
    return row


def main(words: list[str]) -> None:
    """Make, check and count."""
    told = dict(w.split("=", 1) for w in words if "=" in w)
    count, folder = int(words[0]), Path(told["into"])
    folder.mkdir(parents=True, exist_ok=True)
    fonts, table, start = sorted(Path(told["fonts"]).glob("*.ttf")), Counter[tuple[str, str]](), time.process_time()
    for k in range(count):
        row = made(k, told.get("seed", "1"), folder, fonts)
        asked = Asked(load(ROOT / "samples" / f"{row['scene']}.yaml"), row["plan"], mu=row["mu"])
        try:
            outcome = check(asked, read_paper(str(folder / row["file"]), asked, Known()))
            verdict, first = outcome.verdict, outcome.first_wrong
        except PlanesError as error:
            verdict, first = f"unreadable {error}"[:10], None
        step = verdict == "wrong" and (first in row["marks"] or row["kind"] in ("mirrored", "scale"))
        group = row["plan"].kind if row["plan"].kind in ("position", "force") else "motion"
        truth = "right" if row["kind"] == "right" else "wrong"
        for name in (truth, f"{truth} {group}", f"{row['kind']}", f"{truth} {row['spoil']}"):
            table[name, verdict] += 1
            table[name, "step"] += step
    for name in sorted({n for n, _ in table}):
        print(
            f"{name:18}",
            *(f"{v} {table[name, v]:3}" for v in ("right", "right_as_seen", "wrong", "step", "unreadable")),
        )
    print(f"{(time.process_time() - start) / count:.2f} s a picture")


if __name__ == "__main__":
    main(sys.argv[1:])
