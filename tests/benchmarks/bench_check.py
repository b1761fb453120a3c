"""How long a picture of a drawing takes to read and judge, and the memory the whole command takes."""

from __future__ import annotations

import random
from collections.abc import Callable
from contextlib import suppress
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from conftest import peak_of
from PIL import Image

from planes.check.grading.paper import Known
from planes.check.handed_in import read_paper
from planes.check.outcome import check
from planes.cli import main
from planes.words.errors import PlanesError
from tests import confusion
from tests.physical import higher
from tests.physical.corpus import Picture, picture, works
from tests.physical.factors import PHONE
from tests.physical.setting import Setting, varied

PAGES = ("scan 200", "scan 300", "phone", "phone, 24 megapixels")


def taken(page: str, folder: Path) -> Picture:
    """A right drawing on a blank, as a scanner or a telephone gives it."""
    rng, work = random.Random(page), next(works(1))
    settings = {"scan 200": Setting(), "scan 300": replace(Setting(), dpi=300.0)}
    made = picture(work, settings.get(page) or varied(Setting(), PHONE, rng), page, folder / "page.jpg")
    assert made is not None
    if "24" in page:
        seen = cv2.imdecode(np.fromfile(made.file, np.uint8), cv2.IMREAD_COLOR)
        cv2.imwrite(str(made.file), cv2.resize(seen, (6000, 4000)))
    return made


@pytest.mark.parametrize("page", PAGES)
def bench_check_of_a_page(benchmark, page: str, tmp_path: Path) -> None:
    made = taken(page, tmp_path)
    easel = made.work.easel
    asked = confusion.bench(easel.sample, easel.plan).asked
    words = ["check", asked.scene.file, str(made.file), "--plan", easel.plan, "--json"]
    benchmark.group, benchmark.extra_info["what"] = "a page checked", page
    benchmark.extra_info |= {"positions": 1, "memory": peak_of(words)}
    benchmark.pedantic(lambda: check(asked, read_paper(str(made.file), asked, Known())), rounds=2)


@pytest.mark.parametrize("plan", ["acceleration", "force:2-3-4-5"])
@pytest.mark.parametrize("sample", ["class-four/tray", "class-three/slider"])
def bench_check_of_a_page_of_class_three_and_four(benchmark, sample: str, plan: str, tmp_path: Path) -> None:
    made = next(higher.pictures("scan", [plan], 1, tmp_path, [sample]))
    asked = confusion.bench(sample, plan).asked
    benchmark.group, benchmark.extra_info["what"] = "a page of class III or IV checked", f"{sample} {plan}"
    benchmark.extra_info |= {"positions": 1}
    benchmark.pedantic(lambda: check(asked, read_paper(str(made.file), asked, Known())), rounds=2)


@pytest.mark.parametrize("count", [1, 40])
def bench_pages_of_a_file(benchmark, count: int, tmp_path: Path) -> None:
    """A class's sheets in one PDF: as many times the time of one page, and hardly more memory."""
    page = Image.open(taken("scan 200", tmp_path).file)
    file, out = tmp_path / "class.pdf", tmp_path / "out.json"
    page.save(file, save_all=True, append_images=[page] * (count - 1), resolution=200, quality=80)
    easel = next(works(1)).easel
    words = ["check", confusion.bench(easel.sample, easel.plan).asked.scene.file, str(file), "--plan", easel.plan]
    benchmark.group, benchmark.extra_info["what"] = "pages of a file checked", count
    benchmark.extra_info |= {"positions": count, "memory": peak_of([*words, "-o", str(out)])}
    benchmark.pedantic(lambda: main([*words, "-o", str(out)]), rounds=1)


PLAIN: dict[str, Callable[[], np.ndarray]] = {
    "100 megapixels of noise": lambda: np.random.default_rng(1).integers(0, 255, (8600, 11600), np.uint8),
    "100 megapixels of white": lambda: np.full((8600, 11600), 255, np.uint8),
}


@pytest.mark.parametrize("what", PLAIN)
def bench_memory_of_a_large_picture(benchmark, what: str, tmp_path: Path) -> None:
    file = tmp_path / "large.png"
    cv2.imwrite(str(file), PLAIN[what]())
    words = ["check", "samples/kind-1-rrr.yaml", str(file), "--plan", "velocity"]
    benchmark.group, benchmark.extra_info["what"] = "a large picture", what
    benchmark.extra_info |= {"positions": 1, "memory": peak_of(words)}
    asked = confusion.bench("kind-1-rrr", "velocity").asked

    def look() -> None:
        with suppress(PlanesError):
            read_paper(str(file), asked, Known())

    benchmark.pedantic(look, rounds=1)
