"""Handwritten names and numbers: distorted single strokes of a drawing lettering, or a script's letters."""

from __future__ import annotations

import cmath
import random
from collections.abc import Iterator

import cv2
import numpy as np

from render.paper.lettering import letter_strokes as pen_paths
from tests.physical.paper import PX_PER_MM
from tests.physical.strokes import Hand

WILD = {"neat": 0.35, "wild": 1.0, "script": 0.5, "indices": 0.7}  # displacement of letters
PIECE = 10  # steps of a letter's line drawn at once: a letter is bent


class Writer:
    """One hand's letters, all with the same slant."""

    def __init__(self, hand: Hand, rng: random.Random) -> None:
        self.hand, self.rng, self.style = hand, rng, hand.s.letters
        self.slant = rng.gauss(0.12, 0.1)
        self.wild = WILD.get(self.style, 0.0)

    def word(self, text: str, corner: complex, height: float = 3.5) -> None:
        """Letters one by one, all different."""
        if self.style == "none":
            return
        tilt, x = cmath.rect(1, self.rng.gauss(0, 0.03 * self.wild)), 0.0
        for char, size, up in self.placed(text):
            start = corner + (x + 1j * up * height) * tilt + 1j * self.rng.gauss(0, 0.25 * self.wild)
            if char.isspace():
                x += 0.6 * height
            elif self.style == "script" and char.isascii():
                x += self.script(char, start, height)
            else:
                x += self.letter(char, start, size * height) + size * height * self.rng.uniform(0.1, 0.22)

    def placed(self, text: str) -> Iterator[tuple[str, float, float]]:
        """Characters, their relative size and height: unchanged, or with indices lowered, parts raised."""
        name, low, index = text.partition("_")
        if self.style != "indices" or not low:
            yield from ((char, 1.0, 0.0) for char in text)
            return
        yield from ((char, 1.0, 0.0) for char in name)
        yield from ((char, 0.65, 0.45 if char in "tn" else -0.3) for char in index)

    def letter(self, char: str, start: complex, height: float) -> float:
        """A letter of single strokes; its width."""
        size = self.rng.uniform(1 - 0.12 * self.wild, 1 + 0.12 * self.wild)
        turn = cmath.rect(size, self.rng.gauss(0, 0.12 * self.wild))
        lines = [[(z + self.slant * z.imag + self._stray()) * turn for z in path] for path in pen_paths(char, height)]
        for line in lines:
            self._lay([start + z for z in line])
        return max(z.real for line in lines for z in line)

    def _stray(self) -> complex:
        return 0.12 * self.wild * complex(self.rng.gauss(0, 1), self.rng.gauss(0, 1))

    def _lay(self, points: list[complex]) -> None:
        hand, paper = self.hand, self.hand.paper
        wide, press = 0.8 * hand.s.width_mm, 0.9 * hand.s.press * self.rng.uniform(0.85, 1.1)
        even = None if hand.s.tool == "pencil" else 0.92
        for k in range(0, max(len(points) - 1, 1), PIECE):
            piece = points[k : k + PIECE + 1]
            paper.lay(piece if len(piece) > 1 else [piece[0], piece[0] + 0.3], [press, press], wide, hand.ink, even)

    def script(self, char: str, start: complex, height: float) -> float:
        """A letter of a script with thick and thin strokes, rotated and stretched; its width."""
        paper, size = self.hand.paper, height * PX_PER_MM / 21 * self.rng.uniform(0.9, 1.15)
        (w, h), _ = cv2.getTextSize(char, cv2.FONT_HERSHEY_SCRIPT_COMPLEX, size, 4)
        pad = h
        image = np.zeros((h + 2 * pad, w + 2 * pad), np.uint8)
        thick = max(2, round(0.25 * PX_PER_MM))
        cv2.putText(image, char, (pad, h + pad), cv2.FONT_HERSHEY_SCRIPT_COMPLEX, size, 255, thick, cv2.LINE_AA)
        turn = cv2.getRotationMatrix2D((pad, h + pad), self.rng.gauss(0, 5), self.rng.uniform(0.95, 1.05))
        turned = cv2.warpAffine(image, turn, image.shape[::-1])
        x, y = (round(v) for v in paper.px(start))
        x, y = x - pad, y - h - pad
        part = paper.colour[max(y, 0) : y + turned.shape[0], max(x, 0) : x + turned.shape[1]]
        cover = turned[max(-y, 0) :, max(-x, 0) :][: part.shape[0], : part.shape[1], None] / 255.0 * 0.8
        part[:] = (part - cover * np.maximum(part - np.array(self.hand.ink, float), 0)).astype(np.uint8)
        return float(w) / PX_PER_MM
