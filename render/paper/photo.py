"""A photograph beneath a drawing: its light evened out, faded so that lines on it are readable, cut to a field."""

from __future__ import annotations

import io
import math
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

from planes.geometry.plane import direction_between
from planes.words.frozen import frozen
from render.paper.marks import Mark, Shape

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from PIL.Image import Image

Box = tuple[float, float, float, float]
"""Left, bottom, right, top in mm."""

BLACK_INK_DARKNESS = 0.58  # how dark black ink remains; overshoots of a JPEG are slightly darker
CLEAN_PAPER_RATIO = 0.96  # as light as this relative to its surroundings is clean paper
GREY_LEVELS = 40  # levels of grey: more are only noise
SHADOW_CELL_PX = 12  # light changes slowly, ink does not
MOST_PENCIL_BRIGHTNESS = 0.72  # of the paper's light: darker is the student's pencil, lighter a printed grid
LEAST_PHOTO_SIDE_PX = 8
DARK_AREA_CELL_MM = 0.8
IGNORED_LINE_REACH_MM = 1.2  # width of a line that is drawn anyway
MOST_PIXELS_PER_MM = 6.0  # pixels to a mm of paper
JPEG_QUALITY = 72


@frozen
class Photo:
    """A picture file and its place."""

    data: bytes
    box: Box


def move_photo(photo: Photo, reduction: float, shift: complex) -> Photo:
    """The same, reduced 1 : ``reduction`` and moved."""
    x0, y0, x1, y1 = (side / reduction for side in photo.box)
    return Photo(photo.data, (x0 + shift.real, y0 + shift.imag, x1 + shift.real, y1 + shift.imag))


def fade_photo(photo: Photo, field: Box) -> Photo | None:
    """The part of it within a field, in pale grey on white; None where there is none."""
    from PIL import Image

    x0, y0, x1, y1 = photo.box
    image = Image.open(io.BytesIO(photo.data)).convert("L")
    kx = image.width / (x1 - x0)
    ky = image.height / (y1 - y0)
    left = math.ceil(max(field[0] - x0, 0) * kx)
    right = math.floor(min(field[2] - x0, x1 - x0) * kx)
    above = math.ceil(max(y1 - field[3], 0) * ky)
    below = math.floor(min(y1 - field[1], y1 - y0) * ky)
    if right - left < LEAST_PHOTO_SIDE_PX or below - above < LEAST_PHOTO_SIDE_PX:
        return None
    box = (x0 + left / kx, y1 - below / ky, x0 + right / kx, y1 - above / ky)
    cut = image.crop((left, above, right, below))
    most = round(MOST_PIXELS_PER_MM * max(box[2] - box[0], box[3] - box[1]))
    cut.thumbnail((most, most))
    out = io.BytesIO()
    Image.fromarray(_pale_pixels(cut)).save(out, format="JPEG", quality=JPEG_QUALITY, optimize=True)
    return Photo(out.getvalue(), box)


def _pale_pixels(grey: Image) -> NDArray[np.uint8]:
    """Pixels in a few pale shades, by their brightness relative to the paper there, whatever the lighting."""
    import numpy as np
    from PIL import ImageFilter

    size = max(grey.width // SHADOW_CELL_PX, 1), max(grey.height // SHADOW_CELL_PX, 1)
    paper = grey.resize(size).filter(ImageFilter.MaxFilter(5)).filter(ImageFilter.GaussianBlur(2)).resize(grey.size)
    share = np.minimum(np.asarray(grey, float) / np.maximum(np.asarray(paper, float), 16) / CLEAN_PAPER_RATIO, 1.0)
    shade = np.round((1 - share) * GREY_LEVELS) / GREY_LEVELS
    pale: NDArray[np.uint8] = (255 * (1 - BLACK_INK_DARKNESS * shade)).astype(np.uint8)
    return pale


def dark_areas(photo: Photo, lines: Sequence[tuple[complex, complex]]) -> Iterator[Mark]:
    """Small areas where a faded picture is dark, the student's letters for instance; ink along ``lines`` is ignored."""
    import numpy as np
    from PIL import Image, ImageFilter

    grey = Image.open(io.BytesIO(photo.data)).convert("L")
    x0, y0, x1, y1 = photo.box
    size = max(round((x1 - x0) / DARK_AREA_CELL_MM), 1), max(round((y1 - y0) / DARK_AREA_CELL_MM), 1)
    reach = max(round(grey.width / size[0]) | 1, 3)
    darkest = np.asarray(grey.filter(ImageFilter.MinFilter(reach)).resize(size, Image.Resampling.NEAREST), float)
    rows, columns = np.nonzero(1 - (255 - darkest) / 255 / BLACK_INK_DARKNESS < MOST_PENCIL_BRIGHTNESS)
    wide = (x1 - x0) / size[0]
    high = (y1 - y0) / size[1]
    cells = x0 + (columns + 0.5) * wide + 1j * (y1 - (rows + 0.5) * high)
    for a, b in lines:
        along = direction_between(a, b) if a != b else 1 + 0j
        local = (cells - a) * np.conj(along)
        beside = (
            (abs(local.imag) < IGNORED_LINE_REACH_MM)
            & (local.real > -IGNORED_LINE_REACH_MM)
            & (local.real < abs(b - a) + IGNORED_LINE_REACH_MM)
        )
        cells = cells[~beside]
    half = complex(wide, high) / 2
    for z in cells.tolist():
        yield Shape((z - half, z + half.conjugate(), z + half, z - half.conjugate()))
