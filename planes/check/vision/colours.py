"""A picture in one shade: of paper with a coloured grid, the colour in which the grid is lightest."""

from __future__ import annotations

from types import ModuleType

import numpy

from planes.geometry.arrays import Array, Booleans, Greys

COLOURED = 14  # how much farther than usual two colours of a place are apart, on coloured paper
COLOURED_SHARE = 0.03  # of all places
FAINT, DARK = 0.08, 0.4  # how much darker than paper a grid is at least, and what is drawn
LOOK_PX, PARTS = 1000, 8
EVERYWHERE, SOMEWHERE = 0.8, 0.4  # shares of the parts of a picture in which a grid is, and in which a drawing may be


def in_one_shade(cv2: ModuleType, data: Greys) -> Greys | None:
    """The picture encoded as ``data`` in grey, or in the colour that shows no grid; None where it is no picture."""
    small = cv2.imdecode(data, cv2.IMREAD_REDUCED_COLOR_2)
    if small is None or not _coloured(small):
        grey: Greys | None = cv2.imdecode(data, cv2.IMREAD_GRAYSCALE)
        return grey
    return plainest(cv2, cv2.imdecode(data, cv2.IMREAD_COLOR))


def _coloured(picture: Greys) -> bool:
    """Whether some of it differs in colour from most of it."""
    some = picture[:: max(1, picture.shape[0] // 400)].astype(numpy.int16)
    apart = (some[..., 0] - some[..., 1], some[..., 2] - some[..., 1])
    far = numpy.maximum(*(abs(d - numpy.median(d)) for d in apart))
    return bool((far > COLOURED).mean() > COLOURED_SHARE)


def plainest(cv2: ModuleType, picture: Greys) -> Greys:
    """Grey, or that of the three colours in which a grid that is everywhere fades most and nothing else does."""
    middle = _middle(picture)
    inked = _ink(cv2, cv2.cvtColor(middle, cv2.COLOR_BGR2GRAY))
    best, most = None, 0.0
    for k in range(3):
        ink = _ink(cv2, cv2.extractChannel(middle, k))
        faded = (inked > FAINT) & (ink < 0.5 * inked)
        lost = _spread((inked > DARK) & (ink < DARK / 2))
        if _spread(faded) > EVERYWHERE and not 0 < lost < SOMEWHERE and float((inked - ink)[faded].sum()) > most:
            best, most = k, float((inked - ink)[faded].sum())
    grey: Greys = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY) if best is None else cv2.extractChannel(picture, best)
    return grey


def _middle(picture: Greys) -> Greys:
    """The middle of a picture."""
    h, w = picture.shape[:2]
    high, wide = min(h, LOOK_PX) // 2, min(w, LOOK_PX) // 2
    return picture[h // 2 - high : h // 2 + high, w // 2 - wide : w // 2 + wide]


def _ink(cv2: ModuleType, part: Greys) -> Array:
    """How much darker than paper a picture is, its grain aside."""
    light = cv2.GaussianBlur(cv2.dilate(part, numpy.ones((25, 25), numpy.uint8)), (0, 0), 12).astype(numpy.float32)
    dark: Array = 1 - cv2.GaussianBlur(part, (0, 0), 1.0) / numpy.maximum(light, 1)
    return dark


def _spread(places: Booleans) -> float:
    """In which share of its parts a picture has such places, more than by chance."""
    h, w = (n // PARTS for n in places.shape)
    parts = places[: h * PARTS, : w * PARTS].reshape(PARTS, h, PARTS, w).mean(axis=(1, 3))
    return float((parts > 0.003).mean())
