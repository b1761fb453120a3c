"""A small neural net for the shapes of handwritten letters.

`letter_net.npz` was trained by `python -m tests.physical.handwriting`.
"""

from functools import cache
from pathlib import Path

import numpy

from planes.check.vision.image.opencv import cv
from planes.geometry.arrays import Array, Greys

LETTER_SHAPES = "0123456789FRGPNФABDEHKTMabdefghknqrtπ_|*"  # Cyrillic and Latin letters of one shape are one; * is none
# of a letter's picture as input, and the averaging cells
LETTER_PICTURE_SIDE_PX = 24
LETTER_PICTURE_MARGIN_PX = 2
FEATURE_CELLS_PER_SIDE = 6


@cache
def _net_weights() -> tuple[Array, ...]:
    """The weights of the net."""
    with numpy.load(Path(__file__).with_suffix(".npz")) as held:
        return tuple(held[k].astype(numpy.float32) for k in ("w1", "b1", "w2", "b2"))


def shape_log_probabilities(seen: Array) -> Array:
    """The log probabilities of the shapes, one row for each input."""
    w1, b1, w2, b2 = _net_weights()
    z = numpy.maximum(seen @ w1 + b1, 0) @ w2 + b2
    log_odds: Array = z - numpy.log(numpy.exp(z).sum(axis=1, keepdims=True))
    return log_odds


def letter_features(picture: Greys) -> Array:
    """The input for a letter's picture (light ink): its ink and the direction of its gradient, cell by cell."""
    cv2 = cv()
    h, w = picture.shape
    scale = (LETTER_PICTURE_SIDE_PX - 2 * LETTER_PICTURE_MARGIN_PX) / max(h, w)
    size = (max(round(w * scale), 1), max(round(h * scale), 1))
    how = cv2.INTER_AREA if scale < 1 else cv2.INTER_LINEAR
    letter = numpy.zeros((LETTER_PICTURE_SIDE_PX, LETTER_PICTURE_SIDE_PX), numpy.float32)
    top = (LETTER_PICTURE_SIDE_PX - size[1]) // 2
    left = (LETTER_PICTURE_SIDE_PX - size[0]) // 2
    letter[top : top + size[1], left : left + size[0]] = cv2.resize(picture, size, interpolation=how)
    letter = cv2.GaussianBlur(letter / max(float(letter.max()), 1.0), (0, 0), 0.8)
    gx = cv2.Sobel(letter, cv2.CV_32F, 1, 0)
    gy = cv2.Sobel(letter, cv2.CV_32F, 0, 1)
    ways = (sign * g for g in (gx, gy, (gx + gy) * 0.7, (gx - gy) * 0.7) for sign in (1, -1))
    planes = [letter, *(numpy.maximum(way, 0) for way in ways)]
    return numpy.concatenate(
        [
            cv2.resize(p, (FEATURE_CELLS_PER_SIDE, FEATURE_CELLS_PER_SIDE), interpolation=cv2.INTER_AREA).ravel()
            for p in planes
        ]
    )
