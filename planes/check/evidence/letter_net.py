"""A small net that tells the shapes of letters written by hand (`letter_net.npz`, trained by `python -m
tests.physical.handwriting`)."""

from functools import cache
from pathlib import Path

import numpy

from planes.check.vision.image.opencv import cv
from planes.geometry.arrays import Array, Greys

SHAPES = "0123456789FRGPNФABDEHKTMabdefghknqrtπ_|*"  # Cyrillic and Latin letters of one shape are one; * is none
SIDE_PX, RIM_PX, CELLS = 24, 2, 6  # of a letter's picture as the net sees it, and of what it takes means of


@cache
def _net() -> tuple[Array, ...]:
    """The net's weights."""
    with numpy.load(Path(__file__).with_suffix(".npz")) as held:
        return tuple(held[k].astype(numpy.float32) for k in ("w1", "b1", "w2", "b2"))


def odds(seen: Array) -> Array:
    """The logarithms of how likely what the net sees is each of the shapes: a row each."""
    w1, b1, w2, b2 = _net()
    z = numpy.maximum(seen @ w1 + b1, 0) @ w2 + b2
    log_odds: Array = z - numpy.log(numpy.exp(z).sum(axis=1, keepdims=True))
    return log_odds


def features(picture: Greys) -> Array:
    """What the net sees of a letter's picture (ink is light): its ink and which way it gets darker, part by part."""
    cv2, (h, w) = cv(), picture.shape
    scale = (SIDE_PX - 2 * RIM_PX) / max(h, w)
    size, how = (max(round(w * scale), 1), max(round(h * scale), 1)), cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR
    letter = numpy.zeros((SIDE_PX, SIDE_PX), numpy.float32)
    top, left = (SIDE_PX - size[1]) // 2, (SIDE_PX - size[0]) // 2
    letter[top : top + size[1], left : left + size[0]] = cv2.resize(picture, size, interpolation=how)
    letter = cv2.GaussianBlur(letter / max(float(letter.max()), 1.0), (0, 0), 0.8)
    gx, gy = cv2.Sobel(letter, cv2.CV_32F, 1, 0), cv2.Sobel(letter, cv2.CV_32F, 0, 1)
    ways = (sign * g for g in (gx, gy, (gx + gy) * 0.7, (gx - gy) * 0.7) for sign in (1, -1))
    planes = [letter, *(numpy.maximum(way, 0) for way in ways)]
    return numpy.concatenate([cv2.resize(p, (CELLS, CELLS), interpolation=cv2.INTER_AREA).ravel() for p in planes])
