"""OpenCV, where it is installed, and what several rooms ask of it."""

from types import ModuleType
from typing import Any

import numpy

from planes.geometry.arrays import Array, Complexes, Greys, Indices
from planes.words import Phrase
from planes.words.errors import PlanesError


def cv() -> ModuleType:
    """OpenCV, or a sentence that says how to get it."""
    try:
        import cv2
    except ImportError:
        raise PlanesError(Phrase("check_needs", what="opencv-python-headless")) from None
    return cv2


def shrunk(picture: Any, factor: float) -> Any:  # of numbers of any kind
    """A picture so many times as large, each pixel the mean of those it stands for."""
    return cv().resize(picture, None, fx=factor, fy=factor, interpolation=cv().INTER_AREA)


def smaller(grey: Greys, longest: float) -> tuple[Greys, float]:
    """The picture with its longer side no longer than that, and by which it was made smaller."""
    factor = min(1.0, longest / max(grey.shape))
    return shrunk(grey, factor) if factor < 1 else grey, factor


def sampled(grey: Greys, places: Complexes) -> Array:
    """Greys at places between pixels; beyond a picture's rim those of the rim."""
    maps = (numpy.ascontiguousarray(part, numpy.float32) for part in (places.real, places.imag))
    greys: Array = cv().remap(grey, *maps, cv().INTER_LINEAR, borderMode=cv().BORDER_REPLICATE).astype(float)
    return greys


def pieces(places: Any, neighbours: int = 8) -> tuple[Indices, Indices]:
    """Places that hang together, by their corners too unless only four ``neighbours`` count: the number of each one's
    piece (0: none), and of each piece its left and upper edge, width, height and area."""
    _, labels, stats, _ = cv().connectedComponentsWithStats(places.astype(numpy.uint8), connectivity=neighbours)
    return labels, stats
