"""Pictures of plans on paper as from a scanner or a phone: wobble, light, perspective, noise, letters."""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import dataclass, replace
from typing import Any

import cv2
import numpy as np

from planes.check.fiducials import MARK_SIDE_MM, SHEET_MM, corner_mark_cells, corner_mark_centres

Stroke = tuple[complex, complex]
PAPER, PRINT = 246, 40  # grey of clean paper and of print
HEADED_MM = 6.0  # shorter vectors have no arrowhead


@dataclass(frozen=True)
class Camera:
    """The taking of a picture and its paper; all are shares of one unless they have a unit."""

    dpi: float = 200.0
    perspective: float = 0.0
    shade: float = 0.0
    noise: float = 3.0
    blur: float = 0.6
    wobble_mm: float = 0.1
    letters: bool = True
    grid: str = ""  # "square": 5 mm, "millimetre"
    grid_ink: float = 1.0  # darkness of the grid: less in one colour of a coloured grid than in another
    erased: int = 0  # erased lines
    quality: int = 85
    corners: bool = True  # the blank's corner marks, or only the frame
    turn_deg: float = 0.0  # rotation of the sheet
    curl_mm: float = 0.0  # apparent shift of the curled sheet's middle towards its upper edge
    lens: float = 0.0  # outward (negative: inward) displacement of a picture's corners by the lens


SCAN = Camera()
PHONE = Camera(dpi=230, perspective=0.06, shade=0.35, noise=5, blur=0.9, wobble_mm=0.15, quality=70)


def any_scan(rng: random.Random) -> Camera:
    """A scan of 150 to 300 dots per inch of any paper."""
    return Camera(
        dpi=rng.choice((150, 200, 300)),
        shade=rng.uniform(0, 0.1),
        noise=rng.uniform(1, 4),
        blur=rng.uniform(0.4, 0.8),
        wobble_mm=rng.uniform(0.05, 0.15),
        grid=rng.choice(("", "", "square", "millimetre")),
        erased=rng.randrange(4),
        turn_deg=rng.uniform(-2, 2),
    )


def any_phone(rng: random.Random) -> Camera:
    """A phone's picture of any paper, from somewhere above it, in lamplight."""
    return replace(
        PHONE,
        dpi=rng.choice((190, 230, 270)),
        perspective=rng.uniform(0.02, 0.09),
        shade=rng.uniform(0.1, 0.45),
        noise=rng.uniform(3, 6),
        blur=rng.uniform(0.6, 1.1),
        grid=rng.choice(("", "", "square", "millimetre")),
        erased=rng.randrange(4),
        turn_deg=rng.uniform(-6, 6),
    )


class Page:
    """A sheet seen straight from above, at twice the picture's resolution."""

    def __init__(self, dpi: float, size_mm: tuple[float, float] = SHEET_MM) -> None:
        self.k, self.size = dpi / 25.4 * 2, size_mm
        w, h = (round(s * self.k) for s in size_mm)
        self.grey = np.full((h, w), PAPER, np.uint8)

    def px(self, z: complex) -> tuple[int, int]:
        """Millimetres to sixteenths of a pixel; the centre of the first pixel is at half a pixel."""
        k = self.k
        return round((z.real * k - 0.5) * 16), round(((self.size[1] - z.imag) * k - 0.5) * 16)

    def line(self, points: list[complex], grey: int, width_mm: float) -> None:
        path = np.array([self.px(z) for z in points], np.int32)
        cv2.polylines(self.grey, [path], False, grey, max(1, round(width_mm * self.k)), cv2.LINE_AA, 4)

    def grid(self, kind: str, ink: float = 1.0) -> None:
        w, h = self.size
        step = 1 if kind == "millimetre" else 5
        for along, most in ((1, w), (1j, h)):
            for n in range(0, int(most), step):
                grey = {0: 188, 5: 205}.get(n % 10, 222) if step == 1 else 200
                other = 1j * h if along == 1 else w
                self.line([n * along, n * along + other], round(PAPER - ink * (PAPER - grey)), 0.12)

    def stroke(self, a: complex, b: complex, wobble_mm: float, rng: random.Random) -> None:
        """A pencil line from a to b, slightly bent, with an arrowhead if it is long enough."""
        count = max(2, int(abs(b - a) / 4))
        bend = wobble_mm * rng.gauss(0, 1)
        u = (b - a) / abs(b - a)
        points = [a + (b - a) * t / count + 1j * u * bend * math.sin(math.pi * t / count) for t in range(count + 1)]
        self.line(points, rng.randint(50, 90), rng.uniform(0.35, 0.6))
        if abs(b - a) > HEADED_MM:
            tip = [self.px(b), self.px(b - u * (3.5 + 0.7j)), self.px(b - u * (3.5 - 0.7j))]
            cv2.fillPoly(self.grey, [np.array(tip, np.int32)], 70, cv2.LINE_AA, 4)

    def rubbed(self, strokes: list[Stroke], rng: random.Random) -> None:
        """A line drawn somewhere by mistake and erased: its ghost and a smear."""
        ends = [z for s in strokes for z in s]
        a = rng.choice(ends)
        b = a + cmath.rect(rng.uniform(20, 60), rng.uniform(0, 2 * math.pi))
        self.line([a, (a + b) / 2 + 0.3j * (b - a) / abs(b - a), b], rng.randint(195, 215), rng.uniform(0.4, 0.6))
        smear = self.grey[:]
        x, y = (v // 16 for v in self.px((a + b) / 2))
        r = int(8 * self.k)
        part = smear[max(y - r, 0) : y + r, max(x - r, 0) : x + r]
        if part.size:  # it may leave the sheet
            part[:] = np.minimum(part, cv2.GaussianBlur(part, (0, 0), 3 * self.k).clip(225, 255))

    def word(self, text: str, z: complex) -> None:
        x, y = self.px(z)
        thick = max(1, round(0.35 * self.k))
        cv2.putText(
            self.grey, text, (x // 16, y // 16), cv2.FONT_HERSHEY_SIMPLEX, self.k * 0.12, 60, thick, cv2.LINE_AA
        )

    def square(self, number: int, centre: complex) -> None:
        """A corner mark."""
        step = MARK_SIDE_MM / 7
        for r, row in enumerate(corner_mark_cells(number)):
            for c, black in enumerate(row):
                if black:
                    z = centre + complex(-MARK_SIDE_MM / 2 + c * step, MARK_SIDE_MM / 2 - r * step)
                    one = round(z.real * self.k), round((self.size[1] - z.imag) * self.k)
                    two = round((z.real + step) * self.k) - 1, round((self.size[1] - z.imag + step) * self.k) - 1
                    cv2.rectangle(self.grey, one, two, 25, -1)

    def print_blank(self, pole: complex | None, corners: bool) -> None:
        w, h = self.size
        if corners:
            for number, z in enumerate(corner_mark_centres(self.size)):
                self.square(number, z)
        self.line([20 + 5j, w - 5 + 5j, complex(w - 5, h - 5), complex(20, h - 5), 20 + 5j], PRINT, 0.25)
        if pole is not None:
            for d in (2 + 0j, 2j):
                self.line([pole - d, pole + d], PRINT, 0.25)


def sheet(
    strokes: list[Stroke],
    words: list[tuple[str, complex]],
    pole: complex,
    camera: Camera,
    rng: random.Random,
    size_mm: tuple[float, float] = SHEET_MM,
) -> Any:
    """The sheet of a blank with the plan drawn on it, seen straight from above."""
    page = Page(camera.dpi, size_mm)
    if camera.grid:
        page.grid(camera.grid, camera.grid_ink)
    page.print_blank(pole, camera.corners)
    strokes = [(a + pole, b + pole) for a, b in strokes]
    for _ in range(camera.erased if strokes else 0):
        page.rubbed(strokes, rng)
    for a, b in strokes:
        page.stroke(a, b, camera.wobble_mm, rng)
    for text, z in words if camera.letters else ():
        page.word(text, z + pole)
    return page.grey


def shot(page: Any, camera: Camera, rng: random.Random) -> Any:
    """A picture of the sheet."""
    h, w = page.shape
    small = cv2.resize(page, (w // 2, h // 2), interpolation=cv2.INTER_AREA)
    h, w = small.shape
    if camera.curl_mm:
        small = curled(small, camera.curl_mm * camera.dpi / 25.4)
    p = camera.perspective

    def off() -> list[float]:
        return [rng.uniform(0.01, p) * w, rng.uniform(0.01, p) * h]

    if p or camera.turn_deg:
        a, b, c, d = (off() for _ in range(4)) if p else ([0.0, 0.0] for _ in range(4))
        corners = np.array([[0, 0], [w, 0], [w, h], [0, h]], np.float32)
        seen = np.array([a, [w - b[0], b[1]], [w - c[0], h - c[1]], [d[0], h - d[1]]], np.float32)
        room = 1 - abs(math.sin(math.radians(camera.turn_deg))) * w / h * 0.5  # to avoid cropping
        turn = cv2.getRotationMatrix2D((w / 2, h / 2), camera.turn_deg, min(room, 1.0))
        seen = cv2.transform(seen[None], turn)[0].astype(np.float32)
        small = cv2.warpPerspective(small, cv2.getPerspectiveTransform(corners, seen), (w, h), borderValue=90)
    if camera.lens:
        small = bent(small, camera.lens)
    small = small.astype(np.float32)
    if camera.shade:
        x, y = np.meshgrid(np.linspace(0, 1, w), np.linspace(0, 1, h))
        angle = rng.uniform(0, 6.28)
        small *= 1 - camera.shade * (0.5 + 0.5 * (math.cos(angle) * x + math.sin(angle) * y)).astype(np.float32)
    small = cv2.GaussianBlur(small, (0, 0), camera.blur)
    small += np.random.default_rng(rng.randrange(10**6)).normal(0, camera.noise, small.shape)
    return np.clip(small, 0, 255).astype(np.uint8)


def curled(picture: Any, rise: float) -> Any:
    """The picture of a sheet that curls up between its left and right edges, seen from the front.

    Pixels in its middle appear ``rise`` higher, and those between its middle and its edges slightly nearer to its
    middle.
    """
    h, w = picture.shape
    x, y = np.meshgrid(np.arange(w, dtype=float), np.arange(h, dtype=float))
    arch, slope = np.sin(np.pi * x / w), np.pi / w * np.cos(np.pi * x / w)
    maps = ((x + slope * rise**2 / 4).astype(np.float32), (y + rise * arch).astype(np.float32))
    return cv2.remap(picture, *maps, cv2.INTER_CUBIC, borderValue=90)


def bent(picture: Any, lens: float) -> Any:
    """The picture with lens distortion: a point at r of the half diagonal moves to r (1 + lens r²), uncropped."""
    h, w = picture.shape
    x, y = np.meshgrid(np.arange(w) - w / 2, np.arange(h) - h / 2)
    half = math.hypot(w, h) / 2
    z = (x + 1j * y) / half * (1 + max(lens, 0.0))
    straight = z
    for _ in range(20):
        straight = z / (1 + lens * np.abs(straight) ** 2)
    maps = ((straight.real * half + w / 2).astype(np.float32), (straight.imag * half + h / 2).astype(np.float32))
    return cv2.remap(picture, *maps, cv2.INTER_CUBIC, borderValue=90)


def coloured(
    strokes: list[Stroke],
    words: list[tuple[str, complex]],
    pole: complex,
    camera: Camera,
    seed: int,
    inks: tuple[float, float, float],
) -> Any:
    """A picture of paper with a coloured grid: its darkness in blue, in green and in red light."""
    shades = []
    for ink in inks:
        rng = random.Random(seed)
        one = replace(camera, grid_ink=ink)
        shades.append(shot(sheet(strokes, words, pole, one, rng), one, rng))
    return cv2.merge(shades)


def save(path: str, picture: Any, camera: Camera) -> None:
    cv2.imwrite(path, picture, [cv2.IMWRITE_JPEG_QUALITY, camera.quality])
