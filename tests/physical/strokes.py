"""A hand on paper: graphite and pens, tremor and bow, overshoot, double lines, erased and smeared lines."""

from __future__ import annotations

import cmath
import math
import random
from itertools import pairwise
from typing import Any

import cv2
import numpy as np

from tests.physical.paper import PX_PER_MM, Paper

STEP_MM = 1.5  # of a hand's path
PENS = ((120, 52, 28), (46, 42, 40), (96, 30, 24))  # blue, black, dark blue


class Hand:
    """A person drawing on a sheet, with the same personal pressure, tremor and pen all over it."""

    def __init__(self, paper: Paper, rng: random.Random) -> None:
        self.paper, self.s, self.rng = paper, paper.setting, rng
        self.ink = self.s.ink if self.s.tool == "pencil" else rng.choice(PENS)

    def path(self, a: complex, b: complex) -> list[complex]:
        """The path along a ruler: a slight bow, and a tremor of low and of high frequency."""
        count = max(14, int(abs(b - a) / STEP_MM))
        across = 1j * (b - a) / abs(b - a)
        bow, tremor = self.s.bow_mm * self.rng.gauss(0, 1), self.s.tremor_mm
        waves = [(tremor * self.rng.gauss(0, 0.6), self.rng.uniform(0, 6.3), wave) for wave in (31.0, 13.0, 5.0)]
        found = []
        for k in range(count + 1):
            t = k / count
            off = bow * math.sin(math.pi * t)
            off += sum(size * math.sin(phase + t * abs(b - a) * 6.28 / wave) for size, phase, wave in waves)
            found.append(a + (b - a) * t + across * off)
        return found

    def pressure(self, length: float, press: float) -> list[float]:
        """The pressure along a line: it varies, and fades where the pencil is lifted."""
        count = max(6, int(length / 3))
        found, slow, over = [], self.rng.gauss(0, self.s.wander), max(min(self.s.fade_mm, length / 2), 1e-6)
        for k in range(count + 1):
            slow = 0.85 * slow + 0.53 * self.rng.gauss(0, self.s.wander)
            left = length * (1 - k / count)
            fade = 1 - (1 - self.s.fade_to) * max(0.0, 1 - left / over)
            set_down = 1 - 0.5 * (1 - self.s.fade_to) * max(0.0, 1 - 2 * (length - left) / over)
            found.append(max(press * (1 + slow) * fade * set_down, 0.05))
        return found

    def line(self, a: complex, b: complex, press: float = 1.0, width: float = 1.0) -> None:
        """One line from a to b."""
        if abs(b - a) < 0.2:
            return
        path, wide = self.path(a, b), self.s.width_mm * width * self.rng.uniform(0.9, 1.1)
        if self.s.tool == "pencil":
            self.paper.lay(path, self.pressure(abs(b - a), press * self.s.press), wide, self.ink)
            return
        for piece in self._written(path):
            self.paper.lay(piece, [1.0, 1.0], wide * 0.85, self.ink, even=0.92)

    def _written(self, path: list[complex]) -> list[list[complex]]:
        """The pieces of a pen's line where it writes."""
        if not self.s.skipping:
            return [path]
        pairs = [list(pair) for pair in pairwise(path)]
        return [pair for pair in pairs if self.rng.random() > self.s.skipping]

    def vector(self, a: complex, b: complex) -> None:
        """A vector with its head; perhaps with its construction line, perhaps twice."""
        u = (b - a) / abs(b - a)
        if self.rng.random() < self.s.over_share:
            before, beyond = (self.s.over_mm * self.rng.uniform(0.3, 1) for _ in range(2))
            self.line(a - before * u * self.rng.choice((0, 1)), b + beyond * u, 0.55, 0.7)
        self.line(a, b)
        if self.rng.random() < self.s.twice:
            jog = 0.25 * complex(self.rng.gauss(0, 1), self.rng.gauss(0, 1))
            self.line(a + jog, b + 0.25 * complex(self.rng.gauss(0, 1), self.rng.gauss(0, 1)))
        if abs(b - a) > 6 and self.s.heads != "none":
            self.head(b, u)
        if self.s.dots:
            self.dot(b)

    def head(self, tip: complex, u: complex) -> None:
        """A hand-drawn arrowhead: two barbs, filled with more strokes or not."""
        size = self.rng.uniform(3, 4)
        spread = [self.rng.uniform(0.17, 0.26) * side for side in (1, -1)]
        barbs = [tip - size * u * cmath.rect(1, angle) for angle in spread]
        for z in barbs:
            self.line(z, tip)
        if self.s.heads == "filled":
            for t in (0.2, 0.4, 0.6, 0.8):
                self.line(barbs[0] + (barbs[1] - barbs[0]) * t, tip, 1.1)

    def dot(self, z: complex) -> None:
        for k in range(5):
            self.line(z + 0.35 * 1j**k, z - 0.35 * 1j**k)

    def rubbed_out(self, near: list[complex]) -> None:
        """A line drawn by mistake and erased: its ghost, its groove and a smear around it."""
        a = self.rng.choice(near)
        b = a + cmath.rect(self.rng.uniform(20, 60), self.rng.uniform(0, 6.28))
        before = self.paper.colour.copy()
        self.line(a, b, 0.9)
        left = self.rng.uniform(0.12, 0.3)
        mixed = before.astype(np.float32) * (1 - left) + self.paper.colour * left
        self.paper.colour = mixed.astype(np.uint8)
        self.smear((a + b) / 2, cmath.phase(b - a), abs(b - a) / 2, self.rng.uniform(0.02, 0.05))

    def smear(self, middle: complex, way: float, long_mm: float, dark: float) -> None:
        """Graphite dust spread over paper by a finger or a sleeve."""
        x, y = self.paper.px(middle)
        h, w = self.paper.colour.shape[:2]
        small = np.zeros((h // 8, w // 8), np.float32)
        axes = (max(2, int(long_mm * PX_PER_MM / 8)), max(2, int(self.rng.uniform(3, 7) * PX_PER_MM / 8)))
        cv2.ellipse(small, (int(x / 8), int(y / 8)), axes, -math.degrees(way), 0, 360, 1.0, -1)
        soft: Any = cv2.resize(cv2.GaussianBlur(small, (0, 0), 5), (w, h))
        self.paper.colour = (self.paper.colour * (1 - dark * soft[..., None])).astype(np.uint8)
