"""Pictures of plans on paper as a scanner or a telephone makes them: wobble, light, perspective, noise, letters."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from planes.check.fiducials import SHEET_MM, SIDE_MM, cells, centres

Stroke = tuple[complex, complex]


@dataclass(frozen=True)
class Camera:
    """How a picture is taken; all shares of one unless they have a unit."""

    dpi: float = 200.0
    perspective: float = 0.0
    shade: float = 0.0
    noise: float = 3.0
    blur: float = 0.6
    wobble_mm: float = 0.1
    letters: bool = True
    grid: bool = False
    quality: int = 85


SCAN = Camera()
PHONE = Camera(dpi=230, perspective=0.06, shade=0.35, noise=5, blur=0.9, wobble_mm=0.15, quality=70)


def sheet(strokes: list[Stroke], words: list[tuple[str, complex]], pole: complex, camera: Camera,
          rng: random.Random) -> Any:
    """The sheet of a blank with the plan drawn on it, seen from straight above."""
    k = camera.dpi / 25.4 * 2
    w, h = (round(s * k) for s in SHEET_MM)
    page = np.full((h, w), 246, np.uint8)

    def px(z: complex) -> tuple[int, int]:
        return round(z.real * k * 16), round((SHEET_MM[1] - z.imag) * k * 16)

    def line(points: list[complex], grey: int, width_mm: float) -> None:
        path = np.array([px(z) for z in points], np.int32)
        cv2.polylines(page, [path], False, grey, max(1, round(width_mm * k)), cv2.LINE_AA, 4)

    if camera.grid:
        for x in range(0, 300, 5):
            line([complex(x, 0), complex(x, 210)], 215, 0.1)
        for y in range(0, 215, 5):
            line([complex(0, y), complex(297, y)], 215, 0.1)
    for number, z in enumerate(centres(SHEET_MM)):
        square(page, number, z, k)
    line([20 + 5j, 292 + 5j, 292 + 205j, 20 + 205j, 20 + 5j], 40, 0.25)
    for d in (2 + 0j, 2j):
        line([pole - d, pole + d], 40, 0.25)
    for a, b in strokes:
        a, b = a + pole, b + pole
        count = max(2, int(abs(b - a) / 4))
        bend = camera.wobble_mm * rng.gauss(0, 1)
        points = [a + (b - a) * t / count + 1j * (b - a) / abs(b - a) * bend * math.sin(math.pi * t / count)
                  for t in range(count + 1)]
        line(points, rng.randint(50, 90), rng.uniform(0.35, 0.6))
        head = (b - a) / abs(b - a)
        if abs(b - a) > 6:
            tip = [px(b), px(b - head * (3.5 + 0.7j)), px(b - head * (3.5 - 0.7j))]
            cv2.fillPoly(page, [np.array(tip, np.int32)], 70, cv2.LINE_AA, 4)
    if camera.letters:
        for text, z in words:
            x, y = px(z + pole)
            width = max(1, round(0.35 * k))
            cv2.putText(page, text, (x // 16, y // 16), cv2.FONT_HERSHEY_SIMPLEX, k * 0.12, 60, width, cv2.LINE_AA)
    return page


def square(page: Any, number: int, centre: complex, k: float) -> None:
    """A corner mark."""
    step = SIDE_MM / 7
    for r, row in enumerate(cells(number)):
        for c, black in enumerate(row):
            if black:
                z = centre + complex(-SIDE_MM / 2 + c * step, SIDE_MM / 2 - r * step)
                one = round(z.real * k), round((SHEET_MM[1] - z.imag) * k)
                two = round((z.real + step) * k) - 1, round((SHEET_MM[1] - z.imag + step) * k) - 1
                cv2.rectangle(page, one, two, 25, -1)


def shot(page: Any, camera: Camera, rng: random.Random) -> Any:
    """A picture of the sheet."""
    h, w = page.shape
    small = cv2.resize(page, (w // 2, h // 2), interpolation=cv2.INTER_AREA)
    h, w = small.shape
    if camera.perspective:
        p = camera.perspective

        def off() -> list[float]:
            return [rng.uniform(0.01, p) * w, rng.uniform(0.01, p) * h]

        a, b, c, d = (off() for _ in range(4))
        corners = np.float32([[0, 0], [w, 0], [w, h], [0, h]])
        seen = np.float32([a, [w - b[0], b[1]], [w - c[0], h - c[1]], [d[0], h - d[1]]])
        small = cv2.warpPerspective(small, cv2.getPerspectiveTransform(corners, seen), (w, h), borderValue=90)
    small = small.astype(np.float32)
    if camera.shade:
        x, y = np.meshgrid(np.linspace(0, 1, w), np.linspace(0, 1, h))
        angle = rng.uniform(0, 6.28)
        small *= 1 - camera.shade * (0.5 + 0.5 * (math.cos(angle) * x + math.sin(angle) * y)).astype(np.float32)
    small = cv2.GaussianBlur(small, (0, 0), camera.blur)
    small += np.random.default_rng(rng.randrange(10**6)).normal(0, camera.noise, small.shape)
    return np.clip(small, 0, 255).astype(np.uint8)


def save(path: str, picture: Any, camera: Camera) -> None:
    cv2.imwrite(path, picture, [cv2.IMWRITE_JPEG_QUALITY, camera.quality])
