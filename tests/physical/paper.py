"""A sheet of paper as colours on a fine raster: its tint and grain, its printed grid, and ink applied to it."""

from __future__ import annotations

import math
import random
from functools import cache
from typing import Any

import cv2
import numpy as np

from tests.physical.setting import Colour, Setting

PX_PER_MM = 12.0
GRID_INKS: dict[str, Colour] = {"squared": (226, 205, 188), "millimetre": (168, 186, 238), "ruled": (224, 208, 190)}
TILE, SEAM = 1024, 32  # side of the grain's pattern, px; blending width at its edges


@cache
def grain() -> Any:
    """Heights of the paper's tooth, uniform from 0 to 1: fibres and hollows of a tenth to a half of a millimetre."""
    rough = np.random.default_rng(7)
    sum_ = np.zeros((TILE, TILE), np.float32)
    for size_mm, share in ((0.03, 0.8), (0.07, 1.0), (0.16, 0.5)):
        layer: Any = rough.standard_normal((TILE, TILE), np.float32)
        wrapped = cv2.copyMakeBorder(layer, SEAM, SEAM, SEAM, SEAM, cv2.BORDER_WRAP)
        layer = cv2.GaussianBlur(wrapped, (0, 0), size_mm * PX_PER_MM)[SEAM:-SEAM, SEAM:-SEAM]
        sum_ += share * layer / layer.std()
    ranks = np.empty(TILE * TILE, np.float32)
    ranks[np.argsort(sum_, axis=None)] = np.linspace(0, 1, TILE * TILE)
    return ranks.reshape(TILE, TILE)


class Paper:
    """A sheet seen from straight above; millimetres from its lower left corner, y up."""

    def __init__(self, size_mm: tuple[float, float], setting: Setting, rng: random.Random) -> None:
        self.size, self.setting = size_mm, setting
        w, h = (round(s * PX_PER_MM) for s in size_mm)
        self.colour = np.full((h, w, 3), setting.tint, np.uint8)
        self.shift = rng.randrange(TILE), rng.randrange(TILE)
        self._shade()
        if setting.grid:
            self._grid(setting.grid, setting.grid_ink, rng)

    def _shade(self) -> None:
        """Fibres are slightly visible under any drawing."""
        tile = 1 - 0.02 * self.setting.tooth * (grain() - 0.5)
        h, w = self.colour.shape[:2]
        whole = np.tile(tile, (h // TILE + 1, w // TILE + 1))[:h, :w]
        self.colour = (self.colour * whole[..., None]).astype(np.uint8)

    def px(self, z: complex) -> tuple[float, float]:
        """The centre of the first pixel is at half a pixel."""
        return z.real * PX_PER_MM - 0.5, (self.size[1] - z.imag) * PX_PER_MM - 0.5

    def _grid(self, kind: str, ink: float, rng: random.Random) -> None:
        w, h = self.size
        step = {"squared": 5, "millimetre": 1, "ruled": 8}[kind]
        start = rng.uniform(0, step), rng.uniform(0, step)
        for along, across, first in ((w, 1j, start[1]), (h, 1.0, start[0])):
            if kind == "ruled" and across == 1.0:
                continue
            for n in range(int((h if across == 1j else w) / step)):
                place, side = (first + n * step) * across, along * (1.0 if across == 1j else 1j)
                heavy = {0: 1.0, 5: 0.75}.get(n % 10, 0.5) if kind == "millimetre" else 0.85
                self.printed([place, place + side], GRID_INKS[kind], 0.15, ink * heavy)

    def printed(self, points: list[complex], ink: Colour, width_mm: float, cover: float = 1.0) -> None:
        """An even printed line."""
        self.lay(points, [1.0, 1.0], width_mm, ink, even=cover)

    def lay(
        self, points: list[complex], press: list[float], width_mm: float, ink: Colour, even: float | None = None
    ) -> None:
        """A line along points, with this pressure at even steps.

        Graphite stays on the heights of the grain touched by a pencil's point, the more the higher the pressure; an
        ``even`` ink covers everything equally.
        """
        path = np.array([self.px(z) for z in points])
        rows, columns, along, off = self._near(path, width_mm)
        if not len(rows):
            return
        half = width_mm * PX_PER_MM / 2
        if even is not None:
            cover = even * np.clip(half + 0.5 - off, 0, 1)
        else:
            touch = np.interp(along, np.linspace(0, 1, len(press)), press) * np.clip(1.25 - (off / half) ** 2, 0, 1)
            dx, dy = self.shift
            depth = 1 - grain()[(rows + dy) % TILE, (columns + dx) % TILE]
            cover = np.clip((touch - 0.75 * self.setting.tooth * depth + 0.12) / 0.5, 0, 1)
            cover *= np.clip(0.35 + 0.65 * touch, 0, 1)
        under = self.colour[rows, columns].astype(np.float32)
        mixed = under - cover[:, None] * np.maximum(under - np.array(ink, np.float32), 0)
        self.colour[rows, columns] = mixed.astype(np.uint8)

    def _near(self, path: Any, width_mm: float) -> tuple[Any, Any, Any, Any]:
        """Pixels near a path: rows, columns, positions along it (a share), and distances from it (px)."""
        reach = math.ceil(width_mm * PX_PER_MM * 0.7) + 2
        low = np.floor(path.min(axis=0)).astype(int) - reach
        high = np.ceil(path.max(axis=0)).astype(int) + reach
        low, high = np.maximum(low, 0), np.minimum(high, self.colour.shape[1::-1])
        if (high <= low).any():
            nothing = np.zeros(0, int)
            return nothing, nothing, nothing, nothing
        band = np.zeros((high - low)[::-1], np.uint8)
        cv2.polylines(band, [np.round(path - low).astype(np.int32)], False, 1, 2 * reach)
        rows, columns = np.nonzero(band)
        spots = np.stack([columns, rows], axis=1) + low
        steps = np.linalg.norm(np.diff(path, axis=0), axis=1)
        starts, best, along = np.concatenate([[0], np.cumsum(steps)]), np.full(len(rows), 1e9), np.zeros(len(rows))
        if len(path) > 12:  # almost straight: the nearest piece follows from the position along its chord
            return rows + low[1], columns + low[0], *_along_chord(path, spots, starts)
        for a, b, start, length in zip(path, path[1:], starts, steps, strict=False):
            t = np.clip((spots - a) @ (b - a) / max(length**2, 1e-9), 0, 1)
            off = np.linalg.norm(spots - a - t[:, None] * (b - a), axis=1)
            nearer = off < best
            best[nearer], along[nearer] = off[nearer], start + (t * length)[nearer]
        return rows + low[1], columns + low[0], along / max(starts[-1], 1e-9), best


def _along_chord(path: Any, spots: Any, starts: Any) -> tuple[Any, Any]:
    """Positions of pixels along an almost straight path, and distances from it."""
    chord = path[-1] - path[0]
    length = float(np.linalg.norm(chord))
    u = chord / length
    normal = np.array([-u[1], u[0]])
    s, d = (spots - path[0]) @ u, (spots - path[0]) @ normal
    bend = np.interp(s, (path - path[0]) @ u, (path - path[0]) @ normal)
    beyond = np.maximum(np.maximum(-s, s - length), 0)
    return np.clip(s / length, 0, 1), np.hypot(d - bend, beyond)
