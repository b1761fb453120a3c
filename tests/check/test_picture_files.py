"""Picture files of every kind, turned, see-through, cut short: read as they are seen, or refused in a sentence."""

from __future__ import annotations

import random
import tracemalloc
from pathlib import Path
from typing import Any

import pytest
from PIL import Image
from reportlab.pdfgen.canvas import Canvas

from planes.check.handed_in import open_picture
from planes.cli import main
from planes.words.errors import PlanesError
from tests import confusion

cv2 = pytest.importorskip("cv2")
import numpy as np  # noqa: E402

from planes.check.reading.opened import MB  # noqa: E402
from planes.check.vision.image.bend import PX_PER_MM  # noqa: E402
from planes.check.vision.image.decoding import MOST_PAGE_PX, load  # noqa: E402
from planes.check.vision.image.no_paper import shows_paper, shows_text_only  # noqa: E402
from planes.check.vision.image.picture import MOST_SHEET_PX, Flat  # noqa: E402
from planes.check.vision.page_parts import split_page  # noqa: E402
from tests import picture_corpus as corpus  # noqa: E402
from tests.helpers import photographs  # noqa: E402

SIX = str(confusion.SAMPLES / "six-link.yaml")


@pytest.fixture(scope="module")
def scan() -> Any:
    """A right velocity plan on its blank, in grey."""
    easel = confusion.easel("six-link", "velocity")
    rng = random.Random(5)
    drawn = corpus.drawn(easel, None, rng)
    assert drawn is not None
    page = photographs.sheet(drawn.strokes, drawn.words, corpus.pole_of(easel), photographs.SCAN, rng)
    return photographs.shot(page, photographs.SCAN, rng)


def see_through(grey: Any) -> Any:
    """Black ink on nothing."""
    out = np.zeros((*grey.shape, 4), np.uint8)
    out[..., 3] = 255 - grey
    return out


def written(kind: str, grey: Any, file: Path) -> Path:
    """The picture as a file of some kind."""
    picture = Image.fromarray(grey)
    match kind:
        case "see-through":
            cv2.imwrite(str(file := file.with_suffix(".png")), see_through(grey))
        case "16-bit, see-through":
            cv2.imwrite(str(file := file.with_suffix(".png")), see_through(grey).astype(np.uint16) * 257)
        case "16-bit":
            cv2.imwrite(str(file := file.with_suffix(".png")), grey.astype(np.uint16) * 257)
        case "palette":
            picture.convert("P").save(file := file.with_suffix(".png"))
        case "CMYK":
            picture.convert("RGB").convert("CMYK").save(file := file.with_suffix(".jpg"), quality=95)
        case "turned in the camera":
            told = Image.Exif()
            told[0x0112] = 6
            picture.rotate(90, expand=True).save(file := file.with_suffix(".jpg"), exif=told, quality=95)
    return file


@pytest.mark.few(1)
@pytest.mark.parametrize(
    "kind", ["see-through", "16-bit", "16-bit, see-through", "palette", "CMYK", "turned in the camera"]
)
def test_a_file_is_read_as_it_is_seen(kind: str, scan: Any, tmp_path: Path) -> None:
    found = load(written(kind, scan, tmp_path / "p")).grey
    assert found.shape == scan.shape and found.dtype == np.uint8
    assert abs(found.astype(int) - scan).mean() < 4


@pytest.mark.parametrize(("dpi", "told"), [(200, True), (72, False), (None, False)])
def test_a_file_tells_its_scale_if_its_paper_is_of_a_likely_size(dpi: int | None, told: bool, tmp_path: Path) -> None:
    """Cameras write 72 into their pictures, whatever they show."""
    file = tmp_path / "p.png"
    Image.new("L", (1654, 1169), 255).save(file, **({"dpi": (dpi, dpi)} if dpi else {}))
    scale = load(file).scale
    assert (scale is not None and abs(scale - 200 / 25.4) < 0.01) if told else scale is None
    exposed = Image.Exif()
    exposed.get_ifd(0x8769)[0x829A] = 0.01
    Image.new("L", (1654, 1169), 255).save(file.with_suffix(".jpg"), dpi=(200, 200), exif=exposed)
    assert load(file.with_suffix(".jpg")).scale is None


@pytest.mark.few(1)
@pytest.mark.parametrize("turn", [90, 180, 270])
def test_a_picture_lying_on_its_side(turn: int, scan: Any, tmp_path: Path) -> None:
    file = tmp_path / "p.jpg"
    Image.fromarray(scan).rotate(turn, expand=True).save(file)
    assert main(["check", SIX, str(file), "--plan", "velocity"]) == 0


@pytest.mark.slow
def test_a_page_and_a_large_picture(scan: Any, tmp_path: Path) -> None:
    Image.fromarray(scan).save(tmp_path / "p.pdf", resolution=200)
    cv2.imwrite(str(tmp_path / "p.jpg"), cv2.resize(scan, (8000, 5657)))
    for name in ("p.pdf", "p.jpg"):
        assert main(["check", SIX, str(tmp_path / name), "--plan", "velocity"]) == 0


def test_a_page_as_large_as_a_house_is_looked_at_from_afar(tmp_path: Path) -> None:
    file = tmp_path / "p.pdf"
    canvas = Canvas(str(file), pagesize=(14400, 14400))
    canvas.line(0, 0, 14400, 14400)
    canvas.save()
    one = load(file)
    assert (
        one.grey.size <= 1.01 * MOST_PAGE_PX
        and one.scale
        and abs(one.grey.shape[0] / one.scale - 14400 * 25.4 / 72) < 1
    )


@pytest.mark.few(3)
@pytest.mark.parametrize("name", ["half.png", "half.jpg", "half.pdf", "start.png", "none.png", "text.jpg", "tiny.png"])
def test_what_is_no_picture_is_refused_in_a_sentence(
    name: str, scan: Any, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    file, whole = tmp_path / name, tmp_path / f"whole{Path(name).suffix}"
    Image.fromarray(scan).save(whole)
    data = whole.read_bytes()
    file.write_bytes(
        {
            "half": data[: len(data) // 2],
            "start": data[:20],
            "none": b"",
            "text": b"a letter",
            "tiny": cv2.imencode(".png", scan[:30, :30])[1].tobytes(),
        }[file.stem]
    )
    assert main(["check", SIX, str(file), "--plan", "velocity", "--lang", "en"]) == 2
    told = capfd.readouterr()
    why = {
        "none": "the file is empty",
        "tiny": "the picture has only 30 × 30 pixels",
        "text": "the picture cannot be read: the file is cut, damaged or of another kind",
    }
    said = why.get(file.stem, "the file ends too early, it was cut when it was sent or copied")
    assert told.out == "" and told.err.startswith(f"{file}: {said}; ") and told.err.count("\n") == 1
    with pytest.raises(PlanesError):
        load(file)


def test_a_locked_page_is_told_to_be_one(tmp_path: Path) -> None:
    file = tmp_path / "p.pdf"
    canvas = Canvas(str(file), encrypt="secret")
    canvas.line(0, 0, 100, 100)
    canvas.save()
    with pytest.raises(PlanesError, match="locked by a password; save it without one"):
        open_picture(str(file))


@pytest.mark.slow
def test_the_largest_page_is_taken_apart_within_500_mb() -> None:
    """Counted, not timed: what is asked for at once, the decoded picture among it."""
    tracemalloc.start()
    grey = np.full((4900, 6900), 255, np.uint8)
    cv2.line(grey, (500, 500), (6000, 4000), 0, 4)
    page = split_page(Flat(grey, PX_PER_MM, by="scale"))
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert grey.size <= MOST_SHEET_PX and len(page.boxes) == 2 and peak < 500 * MB


@pytest.mark.parametrize("kind", ["even", "soft", "pepper"])
def test_noise_is_refused_at_a_glance(kind: str, tmp_path: Path) -> None:
    grain = np.random.default_rng(7)
    noise = {
        "even": grain.integers(0, 255, (900, 1300)),
        "soft": 128 + 400 * cv2.GaussianBlur(grain.normal(0, 1, (900, 1300)), (0, 0), 3),
        "pepper": 255 * (grain.random((900, 1300)) > 0.1),
    }[kind]
    cv2.imwrite(str(tmp_path / "n.png"), np.clip(noise, 0, 255).astype(np.uint8))
    with pytest.raises(PlanesError, match=r"n\.png"):
        load(tmp_path / "n.png")


@pytest.mark.parametrize("kind", ["lawn", "bricks", "clouds"])
def test_what_is_uneven_everywhere_shows_no_paper(kind: str) -> None:
    """Blades of grass, bricks and their mortar, light and dark patches; a lamp's light on paper is even."""
    grain, look = np.random.default_rng(3), np.full((750, 1000), 90, np.uint8)
    if kind == "lawn":
        for x, y, dx, dy, grey in grain.integers(0, 1000, (6000, 5)):
            end = int(x + dx / 50 - 10), int(y - dy / 40)
            cv2.line(look, (int(x), int(y)), end, int(40 + grey // 7), 2)
    if kind == "bricks":
        for k, y in enumerate(range(0, 750, 25)):
            for x in range(-60 + 30 * (k % 2), 1000, 60):
                cv2.rectangle(look, (x + 4, y + 4), (x + 60, y + 25), int(grain.integers(120, 190)), -1)
    if kind == "clouds":
        sizes = [cv2.GaussianBlur(grain.normal(0, 1, look.shape), (0, 0), s) * s for s in (2, 4, 8)]
        look = np.clip(128 + 60 * sum(sizes), 0, 255).astype(np.uint8)
    lit = np.linspace(120, 240, 1000)[None, :] + grain.normal(0, 4, (750, 1000))
    assert not shows_paper(look) and shows_paper(lit.astype(np.uint8))


@pytest.mark.parametrize(("every", "dark"), [(8, 40), (8, 150), (39, 200)])
def test_squared_paper_is_paper(every: int, dark: int) -> None:
    """A millimetre and five apart, at 200 dpi, in lines as dark as print."""
    sheet = np.full((1655, 2339), 240, np.uint8)
    sheet[::every] = sheet[:, ::every] = 240 - dark
    sheet[1::every] = sheet[:, 1::every] = 240 - dark
    assert shows_paper(sheet)


def text_page() -> np.ndarray:
    """A page of print at 150 dpi, letters about 2.5 mm high."""
    page = np.full((1754, 1240), 242, np.uint8)
    words = random.Random(3)
    for y in range(120, 1640, 34):
        line = " ".join("".join(words.choices("abcdefgmnorstuvwk", k=words.randint(2, 9))) for _ in range(14))[:62]
        for k, letter in enumerate(line):
            cv2.putText(page, letter, (90 + 17 * k, y), cv2.FONT_HERSHEY_DUPLEX, 0.6, 40, 1, cv2.LINE_AA)
    return page


def test_a_page_of_text_is_refused_at_a_glance(tmp_path: Path) -> None:
    """In a sentence of its own; not where a line of a drawing is among the letters, faint though it be."""
    page = text_page()
    cv2.imwrite(str(tmp_path / "t.png"), page)
    with pytest.raises(PlanesError, match="page of text"):
        load(tmp_path / "t.png")
    drawn = page.copy()
    cv2.line(drawn, (300, 500), (620, 640), 205, 3, cv2.LINE_AA)
    assert not shows_text_only(drawn)
    assert not shows_text_only(np.full((1754, 1240), 242, np.uint8))
