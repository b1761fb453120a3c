"""`python -m tests.physical.handwriting [FOLDER OF FONTS …]`: trains the net of handwritten letters.

Letters are drawn with variations: distorted strokes of a drawing lettering, OpenCV's pen fonts, and font files (those
in matplotlib, and handwritings from the folders); bent, slanted, torn by the paper's grain, blurred. One font file in
five is kept out of the training; its recognition rates are printed by certainty.
"""

from __future__ import annotations

import math
import random
import sys
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import Any

import cv2
import matplotlib
import numpy as np
from PIL import Image, ImageDraw, ImageFont

from planes.check.evidence import letter_net
from planes.check.evidence.letter_net import LETTER_SHAPES, letter_features
from render.paper.lettering import letter_strokes as pen_paths

EACH, HIDDEN, ROUNDS, BATCH = 600, 64, 20, 256
HERSHEY = ["SIMPLEX", "PLAIN", "DUPLEX", "COMPLEX", "TRIPLEX", "SCRIPT_SIMPLEX", "SCRIPT_COMPLEX"]
FACES = (
    "DejaVuSans.ttf",
    "DejaVuSerif.ttf",
    "DejaVuSans-Oblique.ttf",
    "STIXGeneral.ttf",
    "STIXGeneralItalic.ttf",
    "cmmi10.ttf",
)
CHARS = {
    "|": "I|lІ1"[:4],
    "0": "0OО",
    "P": "PРp",
    "t": "tτт",
    "K": "Kк",
    "Ф": "ФΦ",
    "π": "πп",
    "M": "MМ",
    "T": "TТ",
    "5": "5S",
    "N": "NИИ",
}
"""Characters of equal shape, for shapes with more than one."""
Drawing = Callable[[str, random.Random], Any]  # a character, large, light on dark


def by_strokes(char: str, rng: random.Random) -> Any:
    """A single-stroke letter with all its points slightly displaced."""
    wild = rng.choice([0.3, 0.7, 1.0])
    page, stray = np.zeros((160, 200), np.uint8), 0.12 * wild
    tool, jump = rng.uniform(3, 9), rng.random() < 0.3
    for path in pen_paths(char, 3.5):
        off = complex(rng.gauss(0, 0.1), rng.gauss(0, 0.1)) * wild * jump
        ends = [z + off + stray * complex(rng.gauss(0, 1), rng.gauss(0, 1)) for z in path]
        points = np.array([(40 + 25 * z.real, 120 - 25 * z.imag) for z in ends])
        cv2.polylines(page, [np.round(points).astype(np.int32)], False, 255, max(2, round(tool)), cv2.LINE_AA)
    return page


def by_hershey(char: str, rng: random.Random) -> Any:
    """A letter of OpenCV's pen fonts."""
    page = np.zeros((160, 200), np.uint8)
    face = getattr(cv2, f"FONT_HERSHEY_{rng.choice(HERSHEY)}") | rng.choice([0, 0, cv2.FONT_ITALIC])
    cv2.putText(page, char, (50, 115), face, 3.2, 255, rng.randint(3, 8), cv2.LINE_AA)
    return page


def by_font(file: str) -> Drawing:
    """Letters of a font file."""
    font = ImageFont.truetype(file, 100)

    def draw(char: str, rng: random.Random) -> Any:
        page = Image.new("L", (200, 180))
        ImageDraw.Draw(page).text((50, 20), char, 255, font)
        held: Any = np.array(page)
        thick = rng.choice([0, 0, 1, 2, 3])
        return cv2.dilate(held, np.ones((thick, thick), np.uint8)) if thick else held

    return draw


def scrap(rng: random.Random) -> Any:
    """A sample without a letter: pieces of lines and arcs, heads, barbs, specks, two letters in one."""
    page = np.zeros((160, 200), np.uint8)
    kind, wide = rng.randrange(6), rng.randint(3, 9)
    x, y, turn = 100, 80, rng.uniform(0, 6.3)
    if kind == 0:
        for side in (1, -1) if rng.random() < 0.6 else (1,):
            a, r = turn + side * rng.uniform(0.15, 0.4), rng.uniform(30, 70)
            cv2.line(page, (x, y), (round(x + r * math.cos(a)), round(y + r * math.sin(a))), 255, wide, cv2.LINE_AA)
    elif kind == 1:
        ends = [
            (x + 60 * math.cos(turn + k) * s, y + 60 * math.sin(turn + k) * s)
            for k, s in ((0, 1), (0.25, 0.1), (0.5, 1))
        ]
        cv2.fillPoly(page, [np.array(ends, np.int32)], 255)
    elif kind == 2:
        cv2.ellipse(
            page,
            (x, y),
            (rng.randint(10, 60), rng.randint(5, 40)),
            math.degrees(turn),
            0,
            rng.randint(40, 200),
            255,
            wide,
        )
    elif kind == 3:
        for _ in range(rng.randint(2, 4)):
            start, end = [(rng.randint(50, 150), rng.randint(40, 120)) for _ in range(2)]
            cv2.line(page, start, end, 255, wide, cv2.LINE_AA)
    elif kind == 4:
        page = by_strokes(rng.choice(LETTER_SHAPES[:-2]), rng)
        across = np.flatnonzero(page.any(axis=0))
        half = round(across[0] + (across[-1] - across[0]) * rng.uniform(0.3, 0.7))
        page[:, slice(0, half) if rng.random() < 0.5 else slice(half, None)] = 0
    else:
        two = [by_strokes(rng.choice(LETTER_SHAPES[:-2]), rng) for _ in range(2)]
        shift = np.array([[1, 0, rng.uniform(45, 70)], [0, 1, rng.uniform(-25, 25)]], np.float32)
        page = np.maximum(two[0], cv2.warpAffine(two[1], shift, (200, 160)))
    return page


def as_seen(page: Any, rng: random.Random) -> Any:
    """A letter rotated, slanted, bent, and as small as on a sheet, with the paper's grain."""
    h, w = page.shape
    slant, turn, scale = rng.gauss(0.1, 0.15), rng.gauss(0, 0.12), rng.uniform(0.13, 0.4)
    across, up = scale * rng.uniform(0.75, 1.25), scale
    by = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]]) @ np.array(
        [[across, -slant * up], [0, up]]
    )
    small = max(24, round(0.8 * max(h, w) * scale + 16))
    move = np.array([small / 2, small / 2]) - by @ np.array([w / 2, h / 2])
    page = cv2.GaussianBlur(page, (0, 0), 0.35 / scale)
    seed = np.random.default_rng(rng.randrange(1 << 30))
    size = rng.uniform(0, 5)
    bend = [
        cv2.resize(seed.standard_normal((5, 5), np.float32) * size, (w, h), interpolation=cv2.INTER_CUBIC) for _ in "xy"
    ]
    y, x = np.mgrid[0:h, 0:w].astype(np.float32)
    page = cv2.remap(page, x + bend[0], y + bend[1], cv2.INTER_LINEAR)
    seen = cv2.warpAffine(page, np.hstack([by, move[:, None]]).astype(np.float32), (small, small)).astype(np.float32)
    grain = cv2.GaussianBlur(seed.standard_normal((small, small), np.float32), (0, 0), 0.7)
    seen *= 1 + rng.uniform(0, 0.9) * grain
    seen = cv2.GaussianBlur(seen, (0, 0), rng.uniform(0.5, 1.0)).clip(0, 255)
    inked = (seen > 0.28 * seen.max()).astype(np.uint8)
    inked = cv2.morphologyEx(inked, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
    _, labels, stats, _ = cv2.connectedComponentsWithStats(inked)
    if len(stats) < 2:
        return seen.astype(np.uint8)
    k = 1 + int(np.argmax(stats[1:, 4]))
    x0, y0, bw, bh = stats[k, :4]
    return np.where(labels == k, seen, 0)[y0 : y0 + bh, x0 : x0 + bw].astype(np.uint8)


def letters(sources: Sequence[Drawing], each: int, rng: random.Random) -> tuple[Any, Any]:
    """Features of letters, equally many of every shape, and their shapes."""
    rows, told = [], []
    for number, shape in enumerate(LETTER_SHAPES):
        for _ in range(each if shape != "*" else 4 * each):
            char = rng.choice(CHARS.get(shape, shape))
            draw = rng.choice(sources)
            if draw is by_hershey and not char.isascii():
                draw = by_strokes
            page = scrap(rng) if shape == "*" else draw(char, rng)
            rows.append(as_seen(page if page.any() else by_strokes(char, rng), rng))
            told.append(number)
    return np.array([letter_features(row) for row in rows]), np.array(told)


def trained(x: Any, y: Any, rng: Any) -> list[Any]:
    """Weights of a net with one hidden layer, by Adam."""
    n, count = x.shape[1], len(LETTER_SHAPES)
    held = [
        rng.standard_normal((n, HIDDEN)) * (2 / n) ** 0.5,
        np.zeros(HIDDEN),
        rng.standard_normal((HIDDEN, count)) * 0.1,
        np.zeros(count),
    ]
    held = [w.astype(np.float32) for w in held]
    m, v, step = [0 * w for w in held], [0 * w for w in held], 0
    for turn in range(ROUNDS):
        rate = 2e-3 * (1 - turn / ROUNDS) + 1e-5
        order = rng.permutation(len(x))
        for k in range(0, len(order), BATCH):
            rows = order[k : k + BATCH]
            a, step = x[rows], step + 1
            h = np.maximum(a @ held[0] + held[1], 0)
            z = h @ held[2] + held[3]
            p = np.exp(z - z.max(1, keepdims=True))
            p /= p.sum(1, keepdims=True)
            p[np.arange(len(rows)), y[rows]] -= 0.97
            p -= 0.03 / count
            p /= len(rows)
            back = (p @ held[2].T) * (h > 0)
            for i, g in enumerate((a.T @ back, back.sum(0), h.T @ p, p.sum(0))):
                m[i], v[i] = 0.9 * m[i] + 0.1 * g, 0.999 * v[i] + 0.001 * g * g
                held[i] -= rate * (m[i] / (1 - 0.9**step) / (np.sqrt(v[i] / (1 - 0.999**step)) + 1e-8) + 1e-4 * held[i])
    return held


def calibration(x: Any, y: Any) -> str:
    """Recognition rates by certainty."""
    p = np.exp(letter_net.shape_log_probabilities(x))
    best, sure = p.argmax(1), p.max(1)
    lines = [f"{(best == y).mean():.3f} of {len(y)} rightly told"]
    for low, high in ((0, 0.5), (0.5, 0.7), (0.7, 0.85), (0.85, 0.95), (0.95, 1.01)):
        those = (sure >= low) & (sure < high)
        if those.any():
            lines.append(
                f"  said {sure[those].mean():.2f}: right {(best[those] == y[those]).mean():.2f} of {those.sum()}"
            )
    return "\n".join(lines)


def main(folders: list[str]) -> None:
    """Draws, trains, saves and counts."""
    rng = random.Random(1)
    own = Path(matplotlib.get_data_path()) / "fonts" / "ttf"
    found = sorted(f for folder in folders for f in Path(folder).rglob("*.[ot]tf"))
    files = [*(own / f for f in FACES), *found]
    fonts = [by_font(str(f)) for f in files]
    kept = fonts[3::5]
    used = [f for f in fonts if f not in kept]
    x, y = letters([by_strokes] * len(used) + [by_hershey] * 4 + used, EACH, rng)
    weights = trained(x, y, np.random.default_rng(1))
    place = Path(letter_net.__file__).with_suffix(".npz")
    np.savez_compressed(
        place, **{k: w.astype(np.float16) for k, w in zip(("w1", "b1", "w2", "b2"), weights, strict=True)}
    )
    letter_net._net_weights.cache_clear()
    print(f"strokes: {calibration(*letters([by_strokes], 20, random.Random(2)))}")
    print(f"fonts not seen: {calibration(*letters(kept, 40, random.Random(3)))}")
    print(f"{place.stat().st_size} bytes")


if __name__ == "__main__":
    main(sys.argv[1:])
