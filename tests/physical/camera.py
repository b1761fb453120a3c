"""Takes the picture of a sheet: a scanner's glass or a phone's lens, light, shadow, motion, noise, JPEG."""

from __future__ import annotations

import math
import random
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from planes.check.fiducials import SHEET_MM
from tests.physical.layout import Box
from tests.physical.paper import PX_PER_MM, Paper
from tests.physical.setting import Setting

TABLE = ((92, 118, 140), (60, 62, 66), (150, 160, 165))  # surfaces under a photographed sheet
FILLED = 0.92  # share of a picture filled by the sheet
NEAR_MM = 12.0  # around a drawing photographed at close range
SHEET = 0j, complex(*SHEET_MM)
FOCAL = 0.75  # focal length of a phone, in picture widths


@dataclass
class View:
    """The mapping from points of a sheet (mm, y up) to pixels (y down): a plane through a slightly distorting lens."""

    plane: Any
    size: tuple[int, int]
    lens: float = 0.0
    quarter: int = 0

    def see(self, z: complex) -> complex:
        """The pixel of a point."""
        x, y, depth = (self.plane @ np.array([z.real, z.imag, 1.0])).tolist()
        straight = (complex(x, y) / depth - self._middle) / self._half
        pixel: complex = straight * (1 + self.lens * abs(straight) ** 2) * self._half + self._middle
        w, h = self.size
        for _ in range(self.quarter % 4):
            pixel, w, h = complex(pixel.imag, w - 1 - pixel.real), h, w
        return pixel

    @property
    def _middle(self) -> complex:
        return complex(self.size[0] - 1, self.size[1] - 1) / 2

    @property
    def _half(self) -> float:
        return math.hypot(*self.size) / 2

    def places(self) -> Any:
        """The point on the sheet seen by each pixel, mm, as complex numbers."""
        w, h = self.size
        seen = np.arange(w)[None, :] + 1j * np.arange(h)[:, None]
        seen = ((seen - self._middle) / self._half).astype(np.complex64)
        straight = seen
        for _ in range(8 if self.lens else 0):
            straight = seen / (1 + self.lens * np.abs(straight) ** 2)
        flat = straight * self._half + self._middle
        back = np.linalg.inv(self.plane).astype(np.float32)
        x, y, depth = (row[0] * flat.real + row[1] * flat.imag + row[2] for row in back)
        return (x + np.complex64(1j) * y) / depth


def taken(paper: Paper, setting: Setting, rng: random.Random, drawing: Box = SHEET) -> tuple[Any, View]:
    """The picture of a sheet or, at close range, of its drawing; and the view of its points."""
    aim = _about(drawing) if setting.close else SHEET
    view = scanner(setting, rng) if setting.camera == "scan" else telephone(setting, rng, aim)
    picture = developed(paper, view, setting, rng)
    if setting.camera != "scan":
        picture = lit(picture, setting, rng)
    picture = sensed(picture, setting, rng)
    view.quarter = setting.quarter
    return np.ascontiguousarray(np.rot90(picture, setting.quarter)), view


def scanner(setting: Setting, rng: random.Random) -> View:
    """A sheet on the glass, slightly rotated, with some of the lid around it."""
    scale, margin = setting.dpi / 25.4, rng.uniform(1, 4)
    w, h = SHEET_MM
    turn = math.radians(setting.turn_deg)
    c, s = scale * math.cos(turn), scale * math.sin(turn)
    size = round((w + 2 * margin) * scale), round((h + 2 * margin) * scale)
    plane = np.array([[c, s, 0.0], [s, -c, 0.0], [0.0, 0.0, 1.0]])
    middle = plane @ np.array([w / 2, h / 2, 1.0])
    plane[0, 2], plane[1, 2] = size[0] / 2 - middle[0], size[1] / 2 - middle[1]
    return View(plane, size)


def _about(drawing: Box) -> Box:
    """The field of view at close range, in the shape of a picture: the drawing with a margin."""
    low, high = drawing
    middle, wide = (low + high) / 2, max((high - low).real + 2 * NEAR_MM, ((high - low).imag + 2 * NEAR_MM) / 0.75)
    half = complex(wide, 0.75 * wide) / 2
    return middle - half, middle + half


def telephone(setting: Setting, rng: random.Random, aim: Box) -> View:
    """A phone held over a point of a sheet, tilted about any axis, its picture filled by the target."""
    width, height = setting.width_px, round(setting.width_px * 0.75)
    tilt, way, roll = math.radians(setting.tilt_deg), rng.uniform(0, 6.28), math.radians(setting.turn_deg)
    axis = np.array([math.cos(way), math.sin(way), 0.0]) * tilt
    turn = cv2.Rodrigues(axis)[0] @ cv2.Rodrigues(np.array([0.0, 0.0, roll]))[0]
    (low, high), middle = aim, (aim[0] + aim[1]) / 2
    x, y = (low.real, high.real, high.real, low.real), (low.imag, low.imag, high.imag, high.imag)
    corners = np.array([x, y, np.ones(4)])
    ground = np.array([[1, 0, -middle.real], [0, -1, middle.imag], [0, 0, 0]]) + 0.0
    place, seen = np.array([0.0, 0.0, (high - low).real / FILLED * FOCAL]), ground
    for _ in range(6):  # aimed so that the target fills the picture, centred
        seen = turn @ ground + place[:, None] * np.array([0.0, 0.0, 1.0])
        rim = FOCAL * width * (seen @ corners)[:2] / (seen @ corners)[2]
        place[:2] -= (rim.min(axis=1) + rim.max(axis=1)) / 2 * place[2] / (FOCAL * width)
        place[2] *= max(np.ptp(rim[0]) / width, np.ptp(rim[1]) / height) / FILLED
    lens = np.array([[FOCAL * width, 0, width / 2], [0, FOCAL * width, height / 2], [0, 0, 1]])
    return View(lens @ seen, (width, height), setting.lens)


def developed(paper: Paper, view: View, setting: Setting, rng: random.Random) -> Any:
    """The colour seen by each pixel, blurred by its size and by defocus."""
    places = view.places()
    ratio = float(np.abs(places[0, 1:] - places[0, :-1]).mean()) * PX_PER_MM
    soft = cv2.GaussianBlur(paper.colour, (0, 0), max(0.45 * ratio, 0.3))
    x = (places.real * PX_PER_MM - 0.5).astype(np.float32)
    y = ((SHEET_MM[1] - places.imag) * PX_PER_MM - 0.5).astype(np.float32)
    beyond = (236, 236, 236) if setting.camera == "scan" else rng.choice(TABLE)
    seen = cv2.remap(soft, x, y, cv2.INTER_LINEAR, borderMode=cv2.BORDER_CONSTANT, borderValue=beyond)
    return cv2.GaussianBlur(seen, (0, 0), max(setting.blur_px, 0.3)).astype(np.float32)


def lit(picture: Any, setting: Setting, rng: random.Random) -> Any:
    """A lamp on one side, the shadow of the hand with the phone, a warm or cold light."""
    h, w = picture.shape[:2]
    x, y = np.meshgrid(np.linspace(-1, 1, w, dtype=np.float32), np.linspace(-1, 1, h, dtype=np.float32))
    way = rng.uniform(0, 6.28)
    far = (1 + math.cos(way) * x / 1.42 + math.sin(way) * y / 1.42) / 2
    light = 1 - setting.lamp * far**1.5
    if setting.shadow:
        turn = rng.uniform(0, 6.28)
        along, across = x * math.cos(turn) + y * math.sin(turn), y * math.cos(turn) - x * math.sin(turn)
        hand = ((along > rng.uniform(0.0, 0.4)) & (np.abs(across - 0.2 * np.sin(5 * along)) < 0.5)).astype(np.float32)
        light = light * (1 - setting.shadow * cv2.GaussianBlur(hand, (0, 0), 0.012 * w))
    if setting.banding:
        light = light * (1 - setting.banding * (0.5 + 0.5 * np.sin(25 * y + way)))
    warm = np.array([rng.uniform(0.86, 1.0), 0.96, rng.uniform(0.92, 1.0)], np.float32)
    return picture * light[..., None] * warm


def sensed(picture: Any, setting: Setting, rng: random.Random) -> Any:
    """Motion blur and the noise of a small sensor; or an earlier photocopy."""
    if setting.motion_px > 1:
        size = 2 * math.ceil(setting.motion_px / 2) + 3
        kernel, way = np.zeros((size, size), np.float32), rng.uniform(0, 6.28)
        d = np.array([math.cos(way), math.sin(way)]) * setting.motion_px / 2
        ends = (np.array([size / 2 - 0.5 + d, size / 2 - 0.5 - d]) * 16).astype(int)
        cv2.line(kernel, ends[0].tolist(), ends[1].tolist(), 1.0, 1, cv2.LINE_AA, 4)
        picture = cv2.filter2D(picture, -1, kernel / max(float(kernel.sum()), 1e-6))
    random_ = np.random.default_rng(rng.randrange(10**6))
    grain = random_.standard_normal(picture.shape, np.float32)
    picture = picture + 1.3 * setting.noise * cv2.GaussianBlur(grain, (0, 0), 0.5) * (0.5 + picture / 400)
    if setting.copied:
        dirt = cv2.GaussianBlur((random_.random(picture.shape[:2]) > 0.9997).astype(np.float32), (0, 0), 0.8) * 500
        picture = 255 / (1 + np.exp(-(picture.mean(axis=2) - 165) / 18)) - dirt
        picture = np.repeat(picture[..., None], 3, axis=2)
    return np.clip(picture, 0, 255).astype(np.uint8)


def save(picture: Any, file: Path, setting: Setting) -> None:
    """Saves it as a file; a scanner's includes its resolution."""
    data = bytearray(cv2.imencode(".jpg", picture, [cv2.IMWRITE_JPEG_QUALITY, int(setting.quality)])[1].tobytes())
    if setting.camera == "scan":
        data[13:18] = b"\x01" + 2 * round(setting.dpi).to_bytes(2, "big")
    file.write_bytes(data)
