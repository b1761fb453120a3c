"""Text on a sheet around its drawing: a printed task, handwritten lines of a solution, a form with its rules."""

from __future__ import annotations

import cmath
import math
import random
from functools import cache
from itertools import pairwise
from pathlib import Path
from typing import Any

import cv2
import matplotlib
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from tests.physical.layout import Box, Page
from tests.physical.paper import PX_PER_MM

TASK = """Для заданного положения механизма построить план скоростей и ускорений определить угловые скорости звеньев
кривошип вращается равномерно длины масштаб принять направление точки шатуна ползуна найти силу реакции
the crank turns evenly find velocity of point draw a plan to scale and measure its segments linkage slider"""
WORDS = TASK.split()
SOLVED = ("v_B = ω1·l_AB = 2,4 м/с", "v_C = v_B + v_CB", "pb = v_B / μ = 60 мм", "μ = 0,04 м/с/мм", "v_C = 1,32 м/с")
FACES = ("DejaVuSans.ttf", "DejaVuSerif.ttf", "STIXGeneral.ttf", "DejaVuSans-Oblique.ttf")
INK = (50, 46, 44)
APART_MM = 7.0  # of a text from the drawing


def add(page: Page, drawing: Box) -> Box:
    """Texts above and below a drawing or beside it, all of one kind; the box of all."""
    kind, rng = page.paper.setting.text, page.rng
    low, high, placed = *drawing, 0
    for where in rng.sample(("above", "beneath"), 2) + rng.sample(("left", "right"), 2):
        rows, wide = rng.randint(2, 6), rng.uniform(80, 165)
        pitch = rng.uniform(5.0, 6.5) if kind == "printed" else rng.uniform(7.5, 9.5)
        size = complex(wide, rows * pitch)
        corner = _beside(drawing, size, where, rng)
        box = corner, corner + size
        if not _inside(box) or any(_touch(box, one) for one in page.taken):
            continue
        page.taken.append(box)
        {"printed": _printed, "written": _written, "form": _form}[kind](page, box, rows)
        low = complex(min(low.real, corner.real), min(low.imag, corner.imag))
        high = complex(max(high.real, box[1].real), max(high.imag, box[1].imag))
        placed += 1
        if placed > rng.choice((0, 1, 1)):
            break
    return low, high


def _beside(drawing: Box, size: complex, where: str, rng: random.Random) -> complex:
    """The lower left corner of a box of this size on a side of a drawing."""
    (low, high), along = drawing, rng.uniform(-0.2, 0.2)
    x, y = (low + high).real / 2 - size.real / 2, high.imag - size.imag
    if where in ("above", "beneath"):
        y = high.imag + APART_MM if where == "above" else low.imag - APART_MM - size.imag
        return complex(min(max(x + along * size.real, 8), 289 - size.real), y)
    return complex(high.real + APART_MM if where == "right" else low.real - APART_MM - size.real, max(y, 6))


def _inside(box: Box) -> bool:
    return box[0].real > 4 and box[0].imag > 4 and box[1].real < 293 and box[1].imag < 206


def _touch(one: Box, two: Box) -> bool:
    apart = (one[0] - two[1], two[0] - one[1])
    return not any(z.real > -APART_MM / 2 or z.imag > -APART_MM / 2 for z in apart)


@cache
def face(name: str, height_px: int) -> Any:
    """A font with this x-height."""
    file = Path(matplotlib.get_data_path()) / "fonts" / "ttf" / name
    x = ImageFont.truetype(str(file), 400).getbbox("x")
    return ImageFont.truetype(str(file), round(400 * height_px / (x[3] - x[1])))


def _print(page: Page, text: str, corner: complex, font: Any, most_mm: float = 1e9) -> None:
    """Words in a printer's ink, their baseline at a point; as many as fit."""
    while text and font.getlength(text) > most_mm * PX_PER_MM:
        text = text.rpartition(" ")[0]
    if not text:
        return
    w, up, down = math.ceil(font.getlength(text)) + 8, *(math.ceil(m) for m in font.getmetrics())
    image = Image.new("L", (w, up + down + 8), 0)
    ImageDraw.Draw(image).text((4, up + 4), text, 255, font, anchor="ls")
    x, y = (round(v) for v in page.paper.px(corner))
    part = page.paper.colour[max(y - up - 4, 0) : y + down + 4, max(x - 4, 0) : x + w - 4]
    cover = cv2.GaussianBlur(np.array(image), (0, 0), 0.6)[: part.shape[0], : part.shape[1], None] / 255.0
    part[:] = (part * (1 - cover) + np.array(INK) * cover).astype(np.uint8)


def _sentence(rng: random.Random, count: int = 40) -> str:
    return " ".join(rng.choice(WORDS) for _ in range(count))


def _printed(page: Page, box: Box, rows: int) -> None:
    """A paragraph of a font; sometimes with a title in a larger one."""
    (low, high), rng = box, page.rng
    pitch, name = (high - low).imag / rows, rng.choice(FACES)
    size = rng.uniform(0.28, 0.36) * pitch
    for k in range(rows):
        title = k == 0 and rows > 2 and rng.random() < 0.4
        wide = (high - low).real * (rng.uniform(0.3, 0.9) if k == rows - 1 else 0.6 if title else 1.0)
        place = complex(low.real, high.imag - pitch * (k + 0.75))
        font = face(name, round(size * (1.3 if title else 1) * PX_PER_MM))
        _print(page, _sentence(rng), place, font, wide)


def _written(page: Page, box: Box, rows: int) -> None:
    """Handwritten rows: none quite straight, none quite parallel to another, all drifting slightly."""
    (low, high), rng = box, page.rng
    pitch, height = (high - low).imag / rows, rng.uniform(0.4, 0.5) * (high - low).imag / rows
    way, drift = rng.gauss(0, 0.012), rng.gauss(0, 0.003)
    for k in range(rows):
        row = cmath.rect(1, way + drift * k + rng.gauss(0, 0.007))
        at, end = complex(low.real + rng.gauss(0, 0.8), high.imag - pitch * (k + 0.75)), (high - low).real
        text, x, wave = " ".join([rng.choice(SOLVED), _sentence(rng, 30)]), 0.0, rng.uniform(0, 6.3)
        for word in text.split(" "):
            wide = 0.95 * height * len(word)
            if x + wide > end * (0.8 if k == rows - 1 else 1.0):
                break
            off = 0.35 * math.sin(wave + x / 25) + rng.gauss(0, 0.15)
            page.writer.word(word, at + (x + 1j * off) * row, height)
            x += wide + 0.7 * height


def _form(page: Page, box: Box, rows: int) -> None:
    """A printed form: rules both ways, printed column names, handwritten entries."""
    (low, high), rng, columns = box, page.rng, page.rng.randint(3, 6)
    size, name = high - low, page.rng.choice(FACES)
    at = [0.0, *sorted(rng.uniform(0.15, 0.9) for _ in range(columns - 1)), 1.0]
    for y in range(rows + 1):
        z = low + 1j * size.imag * y / rows
        page.paper.printed([z, z + size.real], INK, 0.3)
    for x in at:
        page.paper.printed([low + size.real * x, low + size.real * x + 1j * size.imag], INK, 0.3)
    for r in range(rows):
        for left, right in pairwise(at):
            wide, corner = (
                size.real * (right - left) - 3,
                low + complex(size.real * left + 1.5, size.imag * r / rows + 2.5),
            )
            if r == rows - 1 or left == 0:
                _print(page, _sentence(rng, 3), corner, face(name, round(1.9 * PX_PER_MM)), wide)
            elif wide > 12:
                page.writer.word(f"{rng.uniform(1, 99):.1f}", corner - 0.5j, 3.5)
