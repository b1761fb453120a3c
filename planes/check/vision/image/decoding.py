"""Decodes pictures and PDF pages within bounds: the header is checked before any memory is allocated.

A picture has one channel: on paper with a coloured grid, the colour in which the grid is lightest.
"""

from __future__ import annotations

import io
import math
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING

import numpy

from planes.check.reading.opened import (
    LARGEST_FILE_BYTES,
    MB,
    file_error,
    hash_of_content,
    read_bounded_bytes,
    silenced_output,
)
from planes.check.vision.image.no_paper import shows_paper, shows_text_only
from planes.check.vision.image.opencv import cv, filled_square
from planes.check.vision.image.picture import find_blanks, isolate_sheet
from planes.geometry.arrays import Array, Booleans, Greys
from planes.words import Phrase
from planes.words.errors import PlanesError, reporting_library_errors
from planes.words.frozen import frozen, replace

if TYPE_CHECKING:
    from PIL import Image

MOST_BYTES = 360 * MB  # of a file and of decoding it: 64 million pixels, half of that where they are held twice
MOST_PAGE_PX = 34_000_000
SMALLEST_SIDE_PX = 40
ROWS_AT_ONCE = 256
PAGE_DPI = 200  # of a rendered page
LEAST_FILE_DPI = 100  # a file with a lower value gives no paper size
# tags of camera data
EXIF_TAG = 0x8769
EXPOSURE_TAG = 0x829A
FILM_FOCAL_LENGTH_TAG = 0xA405
PICTURE_SIZE_TAGS = (0xA002, 0xA003)
# mm of lenses for photographing sheets; tolerance of an uncropped shape
FOCAL_LENGTH_RANGE_MM = (18.0, 80.0)
CROPPING_TOLERANCE = 0.02
LARGEST_PAPER_MM = 900.0  # a resolution that implies larger paper is ignored
MOST_PDF_IMAGES, MOST_PDF_DEPTH = 1000, 5
PNG_START, PNG_END, PDF_START, TIFF_STARTS = b"\x89PNG", b"IEND", b"%PDF-", (b"II*\0", b"MM\0*")
LEAST_COLOUR_DIFFERENCE = 14  # minimum difference of two colours beyond the usual one, on coloured paper
LEAST_COLOURED_SHARE = 0.03  # of all pixels
# minimum darkness of a grid relative to paper, and of a drawing
LEAST_GRID_DARKNESS = 0.08
LEAST_DRAWING_DARKNESS = 0.4
CENTRAL_PART_PX, PARTS_PER_SIDE = 1000, 8
# shares of the parts of a picture that contain a grid, and that may contain a drawing
LEAST_GRID_SHARE = 0.8
MOST_DRAWING_SHARE = 0.4


@frozen
class DecodedPicture:
    """A picture in one channel, with pixels per mm and focal length (in its longer sides), where the file has them."""

    grey: Greys
    scale: float | None = None
    focal: float | None = None

    @property
    def pixel_hash(self) -> str:
        """The hash of its content."""
        return hash_of_content(self.grey.tobytes())


def load(path: str | Path, page: int | None = None) -> DecodedPicture:
    """A picture, or a page of a PDF or TIFF (by default the first), or one of several blanks on another picture.

    :class:`PlanesError` if it is no picture, is too large, or shows no paper.
    """
    cv()  # or a message that it is missing
    data = read_bounded_bytes(path, LARGEST_FILE_BYTES)
    if not data:
        raise file_error("check_empty", path)
    paged = data.startswith((PDF_START, *TIFF_STARTS))
    with reporting_library_errors("check_picture", path), silenced_output():
        decode = _render_pdf_page if data[:5] == PDF_START else _decode_picture
        number = page if page and paged else 0
        picture = decode(data, str(path), number)
    if picture is None:
        raise file_error("check_picture", path)
    height, width = picture.grey.shape
    if min(height, width) < SMALLEST_SIDE_PX:
        raise file_error("check_small_picture", path, size=f"{width} × {height}")
    if not shows_paper(picture.grey):
        raise file_error("check_no_paper", path)
    if shows_text_only(picture.grey):
        raise file_error("check_text_only", path)
    if page is None or paged:
        return picture
    return _single_blank(picture, page, str(path))


def _single_blank(picture: DecodedPicture, number: int, file: str) -> DecodedPicture:
    """One of several blanks on a picture; the picture if there is one blank or none."""
    seen = find_blanks(picture.grey)
    _reject_missing_page(number, max(seen.sheet_count, 1), file)
    if seen.partial_sheet_mark_count and number == len(seen.sheets):
        raise PlanesError(Phrase("check_blank_in_part", count=seen.partial_sheet_mark_count))
    if seen.sheet_count > 1:
        return replace(picture, grey=isolate_sheet(picture.grey, seen.sheets[number]))
    return picture


def _page_as_file(head: Image.Image) -> bytes:
    """A page of a TIFF as a separate file."""
    page = io.BytesIO()
    head.save(page, "TIFF", dpi=head.info.get("dpi", (1, 1)))
    return page.getvalue()


def _decode_picture(data: bytes, file: str, page: int = 0) -> DecodedPicture | None:
    """The pixels in grey, on white paper where transparent; None if the file is no complete picture."""
    see_through, head = _check_header(data, file, page)
    data = _page_as_file(head) if page else data
    cv2 = cv()
    bits = numpy.frombuffer(data, numpy.uint8)
    if data[:4] == PNG_START and PNG_END not in data[-64:]:
        return None  # it was truncated
    log = cv2.utils.logging
    log_level = log.getLogLevel()
    log.setLogLevel(log.LOG_LEVEL_SILENT)
    try:
        pixels: Greys | None = cv2.imdecode(bits, cv2.IMREAD_UNCHANGED) if see_through else None
        solid = pixels is None or pixels.ndim < 3 or pixels.shape[2] != 4
        grey = decode_to_one_channel(cv2, bits) if pixels is None or solid else _on_white_paper(cv2, pixels)
    finally:
        log.setLogLevel(log_level)
    if grey is None:
        return None
    return DecodedPicture(grey, _px_per_mm_of_file(head), _focal_length_of_file(head))


def _check_header(data: bytes, file: str, page: int) -> tuple[bool, Image.Image]:
    """Whether a picture may be transparent, by its header alone, and its image object.

    It is rejected if decoding would take too much memory, or if it lacks the page.
    """
    import warnings

    from PIL import Image

    with warnings.catch_warnings(), reporting_library_errors("check_picture", file):
        warnings.simplefilter("ignore")
        try:
            head = Image.open(io.BytesIO(data), formats=("PNG", "JPEG", "BMP", "TIFF", "WEBP"))
        except Image.DecompressionBombError:
            raise file_error("check_large_picture", file, size="> 10⁸") from None
        _reject_missing_page(page, getattr(head, "n_frames", 1) if head.format == "TIFF" else 1, file)
        head.seek(page)
    see_through = head.format in ("PNG", "WEBP") and ("A" in head.mode or "transparency" in head.info)
    tiles = getattr(head, "tag_v2", {})
    pixels = max(head.width * head.height, int(tiles.get(322, 0)) * int(tiles.get(323, 0)))
    each = 10 if see_through or head.format == "TIFF" or "progressive" in head.info else 5
    if pixels * each + len(data) > MOST_BYTES:
        raise file_error("check_large_picture", file, size=f"{head.width} × {head.height}")
    return bool(see_through), head


def _px_per_mm_of_file(head: Image.Image) -> float | None:
    """The pixels per mm in a file; none from a camera (with an exposure), which does not know the paper."""
    across, down = (float(dpi) for dpi in head.info.get("dpi", (0, 0)))
    true = across > LEAST_FILE_DPI and abs(across - down) < 1 and max(head.size) * 25.4 / across < LARGEST_PAPER_MM
    if true and EXPOSURE_TAG not in head.getexif().get_ifd(EXIF_TAG):
        return across / 25.4
    return None


def _focal_length_of_file(head: Image.Image) -> float | None:
    """The focal length, in the picture's longer sides, from the equivalent for 36 × 24 mm film of equal diagonal.

    None for a cropped picture.
    """
    exif = head.getexif().get_ifd(EXIF_TAG)
    long, short = sorted(head.size, reverse=True)
    try:
        film, size_told = (
            float(exif.get(FILM_FOCAL_LENGTH_TAG, 0)),
            [int(exif.get(tag, long)) for tag in PICTURE_SIZE_TAGS],
        )
    except (TypeError, ValueError, ArithmeticError):  # invalid camera data
        return None
    if (
        not FOCAL_LENGTH_RANGE_MM[0] <= film <= FOCAL_LENGTH_RANGE_MM[1]
        or abs(max(size_told) / max(min(size_told), 1) * short / long - 1) > CROPPING_TOLERANCE
    ):
        return None
    return film / math.hypot(36, 24) * math.hypot(long, short) / long


def _on_white_paper(cv2: ModuleType, pixels: Greys) -> Greys:
    """A transparent picture on white paper in grey, some rows at a time."""
    most = numpy.iinfo(pixels.dtype).max
    out = numpy.empty(pixels.shape[:2], numpy.uint8)
    for top in range(0, len(pixels), ROWS_AT_ONCE):
        rows = pixels[top : top + ROWS_AT_ONCE]
        cover = rows[..., 3].astype(numpy.float32) / most
        grey = cv2.cvtColor(rows[..., :3], cv2.COLOR_BGR2GRAY).astype(numpy.float32) * (255 / most)
        out[top : top + ROWS_AT_ONCE] = (255 - cover * (255 - grey)).round()
    return out


def _reject_missing_page(page: int, count: int, file: str) -> None:
    """Rejects a page that a file does not have."""
    if not 0 <= page < count:
        raise file_error("check_no_page", file, page=page + 1, count=count)


def _render_pdf_page(data: bytes, file: str, number: int = 0) -> DecodedPicture:
    """A page of a PDF at 200 pixels per inch (fewer for a very large one), in one channel."""
    import pypdfium2

    document = pypdfium2.PdfDocument(data)
    _reject_missing_page(number, len(document), file)
    page = document[number]
    images = page.get_objects(filter=[pypdfium2.raw.FPDF_PAGEOBJ_IMAGE], max_depth=MOST_PDF_DEPTH)
    for count, image in enumerate(images):
        width, height = image.get_px_size()
        if width * height * 5 > MOST_BYTES or count > MOST_PDF_IMAGES:
            raise file_error("check_large_picture", file, size=f"{width} × {height}")
    w, h = page.get_size()
    scale = min(PAGE_DPI / 72, (MOST_PAGE_PX / max(w * h, 1.0)) ** 0.5, 30_000 / max(w, h, 1.0))
    if min(w, h) * scale < SMALLEST_SIDE_PX:
        raise file_error("check_small_picture", file, size=f"{w * scale:.0f} × {h * scale:.0f}")
    grey = channel_without_grid(cv(), numpy.ascontiguousarray(page.render(scale=scale).to_numpy()[..., :3]))
    return DecodedPicture(grey, scale * 72 / 25.4)


def decode_to_one_channel(cv2: ModuleType, data: Greys) -> Greys | None:
    """The picture encoded as ``data`` in grey, or in the colour without the grid; None if it is no picture."""
    if not _is_partly_coloured(cv2.imdecode(data, cv2.IMREAD_REDUCED_COLOR_2)):
        grey: Greys | None = cv2.imdecode(data, cv2.IMREAD_GRAYSCALE)
        return grey
    return channel_without_grid(cv2, cv2.imdecode(data, cv2.IMREAD_COLOR))


def _is_partly_coloured(picture: Greys | None) -> bool:
    """Whether part of a picture differs in colour from most of it."""
    if picture is None:
        return False
    some = picture[:: max(1, picture.shape[0] // 400)].astype(numpy.int16)
    apart = (some[..., 0] - some[..., 1], some[..., 2] - some[..., 1])
    far = numpy.maximum(*(abs(d - numpy.median(d)) for d in apart))
    return bool((far > LEAST_COLOUR_DIFFERENCE).mean() > LEAST_COLOURED_SHARE)


def channel_without_grid(cv2: ModuleType, picture: Greys) -> Greys:
    """Grey, or the one of three colours in which a grid over the whole picture fades most and nothing else does."""
    middle = _central_part(picture)
    inked = _darkness_over_paper(cv2, cv2.cvtColor(middle, cv2.COLOR_BGR2GRAY))
    best = None
    most = 0.0
    for k in range(3):
        ink = _darkness_over_paper(cv2, cv2.extractChannel(middle, k))
        faded = (inked > LEAST_GRID_DARKNESS) & (ink < 0.5 * inked)
        lost = _share_of_parts_with((inked > LEAST_DRAWING_DARKNESS) & (ink < LEAST_DRAWING_DARKNESS / 2))
        gain = float((inked - ink)[faded].sum())
        if _share_of_parts_with(faded) > LEAST_GRID_SHARE and not 0 < lost < MOST_DRAWING_SHARE and gain > most:
            best = k
            most = gain
    grey: Greys = cv2.cvtColor(picture, cv2.COLOR_BGR2GRAY) if best is None else cv2.extractChannel(picture, best)
    return grey


def _central_part(picture: Greys) -> Greys:
    """The central part of a picture."""
    h, w = picture.shape[:2]
    high = min(h, CENTRAL_PART_PX) // 2
    wide = min(w, CENTRAL_PART_PX) // 2
    return picture[h // 2 - high : h // 2 + high, w // 2 - wide : w // 2 + wide]


def _darkness_over_paper(cv2: ModuleType, part: Greys) -> Array:
    """The darkness of a picture relative to paper, without its grain."""
    light = cv2.GaussianBlur(cv2.dilate(part, filled_square(25)), (0, 0), 12).astype(numpy.float32)
    dark: Array = 1 - cv2.GaussianBlur(part, (0, 0), 1.0) / numpy.maximum(light, 1)
    return dark


def _share_of_parts_with(places: Booleans) -> float:
    """The share of a picture's parts with such pixels, beyond chance."""
    h, w = (n // PARTS_PER_SIDE for n in places.shape)
    parts = (
        places[: h * PARTS_PER_SIDE, : w * PARTS_PER_SIDE]
        .reshape(PARTS_PER_SIDE, h, PARTS_PER_SIDE, w)
        .mean(axis=(1, 3))
    )
    return float((parts > 0.003).mean())
