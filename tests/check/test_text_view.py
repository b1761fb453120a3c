"""How a page is seen, told by its lines of text; against a camera worked out in `test_sheet_view`."""

import io
import math
from pathlib import Path
from typing import Any

import numpy
import pytest

cv2 = pytest.importorskip("cv2")

from PIL import Image, ImageDraw  # noqa: E402

from planes.check.vision.image.decoding import load  # noqa: E402
from planes.check.vision.image.lens import PHONE_FOCAL_LENGTH  # noqa: E402
from planes.check.vision.image.sheet_view import sheet_view  # noqa: E402
from planes.check.vision.image.text_view import tilt_by_text  # noqa: E402
from tests.check.test_sheet_view import PLACES, PX_PER_MM, SIZE, camera, pixel  # noqa: E402
from tests.physical.texts import WORDS, face  # noqa: E402

SHEET_MM, FINE = complex(150, 110), 10.0  # half a page of text, and its pixels to a mm


def page(rows: tuple[int, ...] = (-44, -38, -32, -26, 26, 32, 38)) -> Any:
    """A page with rows of print above and beneath its middle, so many mm from it."""
    image = Image.new("L", (round(2 * SHEET_MM.real * FINE), round(2 * SHEET_MM.imag * FINE)), 240)
    for k, y in enumerate(rows):
        text = " ".join(WORDS[(5 * k + n) % len(WORDS)] for n in range(7))
        x = (SHEET_MM.real - 58) * FINE, (SHEET_MM.imag + y) * FINE
        ImageDraw.Draw(image).text(x, text, 50, face("DejaVuSerif.ttf", 25), anchor="ls")
    return numpy.array(image)


def taken(sheet: Any, view: Any) -> Any:
    """The page by a camera, with a little grain."""
    put = numpy.array([[1 / FINE, 0, -SHEET_MM.real], [0, 1 / FINE, -SHEET_MM.imag], [0, 0, 1]])
    seen = cv2.warpPerspective(cv2.GaussianBlur(sheet, (0, 0), 1.0), view @ put, SIZE, borderValue=240)
    noise = numpy.random.default_rng(1).normal(0, 2.0, seen.shape)
    return numpy.clip(seen + noise, 0, 255).astype(numpy.uint8)


def farthest(seen: list[complex]) -> float:
    """How far places are off, to the scale and direction of the first two."""
    share = (PLACES[1] - PLACES[0]) / (seen[1] - seen[0])
    return max(abs((s - seen[0]) * share - z) for s, z in zip(seen, PLACES, strict=True))


@pytest.mark.slow
@pytest.mark.parametrize(("tilt", "way", "turn"), [(13.0, 70.0, 3.0), (9.0, 200.0, -4.0)])
def test_a_page_is_seen_by_its_lines_of_text(tilt: float, way: float, turn: float) -> None:
    """As surely as it says: places are then three times nearer to where they should be, by the scale of one vector."""
    view = camera(tilt, way, turn)
    found = sheet_view(taken(page(), view), PX_PER_MM, False)
    assert found is not None and found.by == "text"
    lens = numpy.array([[0.73 * SIZE[0], 0, SIZE[0] / 2], [0, 0.73 * SIZE[0], SIZE[1] / 2], [0, 0, 1]])
    right, down, _ = (numpy.linalg.inv(lens) @ view).T
    x, y, depth = numpy.cross(right, down)
    off = complex(x / depth, y / depth) - found.held.slopes
    assert max(abs((off * way.conjugate()).real / abs(way) ** 2) for way in found.held.loose) < 2.5
    assert max(abs(way) for way in found.held.loose) < math.tan(math.radians(2))
    seen = [complex(found.bend.to_rectified(pixel(view, z))) for z in PLACES]
    bare = [pixel(view, z) for z in PLACES]
    assert 3 * farthest(seen) < farthest(bare)


@pytest.mark.slow
def test_text_never_bends_a_straight_picture() -> None:
    """It tells that the picture is straight; of a page with a few words, nothing."""
    found = sheet_view(taken(page(), camera(0.0, 0.0, 1.5)), PX_PER_MM, False)
    assert found is not None and found.by == "text" and found.held.slopes == 0
    assert max(abs(way) for way in found.held.loose) < math.tan(math.radians(2.5))
    assert sheet_view(taken(page((-44,)), camera(9.0, 70.0, 0.0))[:, 300:700], PX_PER_MM, False) is None


def test_dashed_lines_are_no_rows_of_letters() -> None:
    """Two of them that run together on paper tell no tilt."""
    drawn = numpy.full((900, 1200), 240, numpy.uint8)
    for x in range(100, 1100, 30):
        for slope, y in ((0.05, 300), (-0.05, 500), (0.0, 700)):
            a, b = (x, round(y + slope * x)), (x + 18, round(y + slope * (x + 18)))
            cv2.line(drawn, a, b, 60, 3, cv2.LINE_AA)
    assert tilt_by_text(drawn, PHONE_FOCAL_LENGTH) is None


def test_a_camera_that_tells_its_lens_is_believed(tmp_path: Path) -> None:
    """By the film's diagonal; not of a picture that was cut out of another."""
    for size, focal in (((400, 300), 26 / math.hypot(36, 24) * 1.25), ((400, 200), None)):
        image, told = Image.new("L", size, 240), Image.Exif()
        told.get_ifd(0x8769).update({0xA405: 26, 0xA002: 4000, 0xA003: 3000})
        data = io.BytesIO()
        image.save(data, "JPEG", exif=told)
        (tmp_path / "p.jpg").write_bytes(data.getvalue())
        found = load(tmp_path / "p.jpg").focal
        assert found == focal or (
            found and focal and abs(found - focal) < 1e-9 and abs(found - PHONE_FOCAL_LENGTH) < 0.05
        )


@pytest.mark.parametrize("tags", [{0xA405: "abc"}, {0xA405: 26, 0xA002: "wide"}])
def test_a_picture_whose_lens_is_told_in_no_number_is_read_all_the_same(
    tags: dict[int, object], tmp_path: Path
) -> None:
    told = Image.Exif()
    told.get_ifd(0x8769).update(tags)
    Image.new("L", (400, 300), 240).save(tmp_path / "p.jpg", exif=told)
    found = load(tmp_path / "p.jpg")
    assert (found.focal, found.grey.shape) == (None, (300, 400))
