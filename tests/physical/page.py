"""A submitted sheet: its print, the drawing, and other content."""

from __future__ import annotations

import random
from functools import cache
from typing import Any

import cv2
import numpy as np

from planes.check.fiducials import SHEET_MM
from planes.documents.check import blank_marks
from planes.words.names import PlanId
from render.files import pdf
from tests import confusion, picture_corpus
from tests.confusion import Easel
from tests.helpers.photographs import curled
from tests.physical import texts
from tests.physical.extras import BLOCK_MM, add
from tests.physical.layout import Page, extent
from tests.physical.letters import Writer
from tests.physical.paper import PX_PER_MM, Paper
from tests.physical.setting import Setting
from tests.physical.strokes import Hand
from tests.picture_corpus import Drawn

PRINT = (42, 40, 40)


def sheet(easel: Easel, one: Drawn, setting: Setting, rng: random.Random) -> Page | None:
    """A drawing on its sheet; None if there is no room for it."""
    paper = Paper(SHEET_MM, setting, rng)
    hand = Hand(paper, rng)
    page = Page(paper, hand, Writer(hand, rng), rng, 0j)
    if setting.title_block:
        page.taken.append((complex(292 - BLOCK_MM[0], 5), complex(292, 5 + BLOCK_MM[1])))
    pole = _pole(page, easel, one)
    if pole is None:
        return None
    page.pole, (low, high) = pole, extent(one)
    page.seen = pole + low, pole + high
    _print(page, easel)
    drawn_on(page, one)
    if setting.text:
        page.seen = texts.add(page, page.seen)
    add(page, easel)
    _spoil(page)
    return page


def _pole(page: Page, easel: Easel, one: Drawn) -> complex | None:
    """The pole: the printed one, otherwise where the drawing fits."""
    low, high = extent(one)
    if page.paper.setting.sheet == "blank":
        pole = _scaled(picture_corpus.pole_of(easel), page.paper.setting.print_scale)
    else:
        corner = page.free(high - low)
        if corner is None:
            return None
        pole = corner - low
    page.taken.append((pole + low, pole + high))
    return pole


def _scaled(z: complex, scale: float) -> complex:
    """A point after printing at a reduced scale about the sheet's middle."""
    middle = complex(*SHEET_MM) / 2
    return middle + (z - middle) * scale


@cache
def _blank(sample: str, plan: PlanId) -> Any:
    """The blank as printed by the program, grey."""
    marks, title = blank_marks(confusion.bench(sample, plan).asked, "ru")
    data = pdf.write_png(marks, SHEET_MM, title, dpi=PX_PER_MM * 25.4)
    return cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_GRAYSCALE)


def _print(page: Page, easel: Easel) -> None:
    """The print on the sheet."""
    s, paper = page.paper.setting, page.paper
    if s.sheet == "frame":
        frame = [20 + 5j, 292 + 5j, 292 + 205j, 20 + 205j, 20 + 5j]
        paper.printed(frame, PRINT, 0.6)
    if s.sheet == "blank":
        printed_on(paper, _blank(easel.sample, easel.plan))


def printed_on(paper: Paper, blank: Any) -> None:
    """A blank, grey, as put on the sheet by a printer."""
    h, w = paper.colour.shape[:2]
    blank = cv2.resize(blank, (w, h), interpolation=cv2.INTER_AREA)
    if paper.setting.print_scale != 1:
        smaller = cv2.getRotationMatrix2D(((w - 1) / 2, (h - 1) / 2), 0, paper.setting.print_scale)
        blank = cv2.warpAffine(blank, smaller, (w, h), flags=cv2.INTER_AREA, borderValue=255)
    blank = cv2.GaussianBlur(blank, (0, 0), 0.5)
    rows, columns = np.nonzero(blank < 250)
    toner, under = 1 - blank[rows, columns, None] / 255.0, paper.colour[rows, columns]
    paper.colour[rows, columns] = (under * (1 - toner) + np.array(PRINT) * toner).astype(np.uint8)


def drawn_on(page: Page, one: Drawn) -> None:
    """The drawing, over erased lines and under smears."""
    s, pole = page.paper.setting, page.pole
    ends = [z + pole for stroke in one.strokes for z in stroke]
    for _ in range(s.rubbed):
        page.hand.rubbed_out(ends)
    if s.sheet == "paper":  # without print, a person marks the pole
        for d in (1.5, 1.5j):
            page.hand.line(pole - d, pole + d)
    for a, b in one.strokes:
        page.hand.vector(a + pole, b + pole)
    for text, z in one.words:
        page.writer.word(text, z + pole)
    for _ in range(s.smudges):
        z = page.rng.choice(ends) + complex(page.rng.gauss(0, 15), page.rng.gauss(0, 15))
        page.hand.smear(z, page.rng.uniform(0, 6.3), page.rng.uniform(8, 25), page.rng.uniform(0.03, 0.1))


def _spoil(page: Page) -> None:
    """Later damage to a sheet: a fold, a cup, a curl."""
    s, paper = page.paper.setting, page.paper
    h, w = paper.colour.shape[:2]
    if s.ticked:
        for _ in range(3):
            z = page.pole + complex(page.rng.uniform(-50, 50), page.rng.uniform(-50, 50))
            paper.lay([z, z + 3 - 4j, z + 10 + 8j], [1.0, 1.0], 0.6, (50, 40, 200), even=0.9)
    if s.thumb:
        tip = complex(page.rng.choice((28, 270)), page.rng.choice((10, 200)))
        start, end = ([round(v) for v in paper.px(z)] for z in (tip, tip + (30 if tip.real > 99 else -30)))
        cv2.line(paper.colour, start, end, (150, 175, 215), round(17 * PX_PER_MM))
    if s.cup:
        middle = int(page.rng.uniform(0.2, 0.8) * w) // 4, int(page.rng.uniform(0.2, 0.8) * h) // 4
        wet: Any = np.zeros((h // 4, w // 4), np.float32)
        cv2.circle(wet, middle, int(10 * PX_PER_MM), 1.0, int(0.5 * PX_PER_MM))
        wet = cv2.resize(cv2.GaussianBlur(wet, (0, 0), 2), (w, h))[..., None]
        paper.colour = (paper.colour * (1 - wet * np.array([0.45, 0.3, 0.18], np.float32))).astype(np.uint8)
    if s.crease:
        off = np.arange(w, dtype=np.float32) - page.rng.uniform(0.4, 0.6) * w
        fold = 1 - s.crease * np.exp(-((off / (0.3 * PX_PER_MM)) ** 2)) - 0.15 * s.crease * (off > 0)
        paper.colour = (paper.colour * fold[None, :, None]).astype(np.uint8)
    if s.curl_mm:
        paper.colour = cv2.merge([curled(one, s.curl_mm * PX_PER_MM) for one in cv2.split(paper.colour)])
