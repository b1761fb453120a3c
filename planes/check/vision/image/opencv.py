"""OpenCV, if installed, and functions of it used in several modules."""

from types import ModuleType
from typing import Any

import numpy

from planes.geometry.arrays import Array, Complexes, Greys, Indices
from planes.words import Phrase
from planes.words.errors import PlanesError


def cv() -> ModuleType:
    """OpenCV, or a message on how to install it."""
    try:
        import cv2
    except ImportError:
        raise PlanesError(Phrase("check_needs", what="opencv-python-headless")) from None
    return cv2


def resize_by_factor(picture: Any, factor: float) -> Any:  # of any number type
    """A picture resized by a factor, each pixel the mean of those it replaces."""
    return cv().resize(picture, None, fx=factor, fy=factor, interpolation=cv().INTER_AREA)


def reduce_to_longest_side(grey: Greys, longest: float) -> tuple[Greys, float]:
    """The picture with its longer side limited, and the factor of reduction."""
    factor = min(1.0, longest / max(grey.shape))
    return resize_by_factor(grey, factor) if factor < 1 else grey, factor


def filled_square(side_px: int) -> Greys:
    """A square window for morphology, all of it counting."""
    return numpy.ones((side_px, side_px), numpy.uint8)


def pairs(z: Complexes) -> Array:
    """Places as rows of x and y."""
    return numpy.stack([z.real, z.imag], axis=1)


def sample_greys(grey: Greys, places: Complexes) -> Array:
    """Grey levels between pixels; beyond a picture's border, those of the border."""
    maps = (numpy.ascontiguousarray(part, numpy.float32) for part in (places.real, places.imag))
    greys: Array = cv().remap(grey, *maps, cv().INTER_LINEAR, borderMode=cv().BORDER_REPLICATE).astype(float)
    return greys


def connected_components(places: Any, neighbours: int = 8) -> tuple[Indices, Indices]:
    """Connected components, across corners, too, unless only four ``neighbours`` count.

    Each pixel has the number of its component (0: none), and each component its left, top, width, height and area.
    """
    _, labels, stats, _ = cv().connectedComponentsWithStats(places.astype(numpy.uint8), connectivity=neighbours)
    return labels, stats
