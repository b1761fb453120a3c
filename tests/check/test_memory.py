"""However large or hostile a picture is, a whole process that checks it stays within half a gigabyte."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip("cv2")
import cv2
import numpy as np
from PIL import Image

from tests.helpers import ROOT

MOST_MB = 500
MEASURED = (
    "import resource, subprocess, sys; done = subprocess.run(sys.argv[1:], capture_output=True, text=True);"
    "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss // 1024, done.returncode, 'Traceback' in done.stderr)"
)


def drawn(high: int, wide: int, lines: int = 8, shades: int = 1) -> Any:
    """Grainy paper with some long lines on it."""
    rng = np.random.default_rng(1)
    shape = (high // 16, wide // 16) if shades == 1 else (high // 16, wide // 16, shades)
    page = cv2.resize(rng.integers(190, 255, shape, np.uint8), (wide, high), interpolation=cv2.INTER_LINEAR)
    ends = rng.integers(0, (wide, high), (2 * lines, 2)).tolist()
    for a, b in zip(ends[::2], ends[1::2], strict=True):
        cv2.line(page, a, b, (40,) * shades, 9)
    return page


def bomb(file: Path) -> None:
    Image.fromarray(np.zeros((20000, 20000), np.uint8)).save(file)


def see_through(file: Path) -> None:
    cover = np.full((5000, 5800), 200, np.uint8)
    Image.fromarray(np.dstack([drawn(5000, 5800, shades=3), cover])).save(file, compress_level=1)


def sheet(lines: int) -> Callable[[Path], None]:
    """A scan of a sheet as large as any that is looked at."""
    return lambda file: Image.fromarray(drawn(5600, 5800, lines)).save(file, dpi=(200, 200), compress_level=1)


FILES: dict[str, tuple[str, Callable[[Path], None], tuple[str, ...]]] = {
    "64 million pixels": ("p.jpg", lambda f: Image.fromarray(drawn(8000, 8000)).save(f), ()),
    "in colours": ("p.jpg", lambda f: Image.fromarray(drawn(7600, 7800, 200, 3)).save(f), ()),
    "progressive": ("p.jpg", lambda f: Image.fromarray(drawn(5600, 5600, 8, 3)).save(f, progressive=True), ()),
    "transparent": ("p.png", see_through, ()),
    "all black": ("p.png", bomb, ()),
    "few lines on a large sheet": ("p.png", sheet(8), ()),
    "many lines on a large sheet": ("p.png", sheet(200), ()),
    "enlarged": ("p.png", sheet(8), ("--pole", "900,900", "--mark", "c=1440,900")),
    "a page": ("p.pdf", lambda f: Image.fromarray(drawn(4000, 5600)).save(f, resolution=100), ()),
}


@pytest.mark.few(0, slow=4)
@pytest.mark.parametrize("name", FILES)
def test_a_picture_takes_no_more_than_half_a_gigabyte(name: str, tmp_path: Path) -> None:
    """Whatever comes of it, in words."""
    suffix, make, more = FILES[name]
    make(tmp_path / suffix)
    scene = str(ROOT / "samples" / "six-link.yaml")
    checked = (sys.executable, "-m", "planes", "check", scene, str(tmp_path / suffix), "--plan", "velocity", *more)
    done = subprocess.run((sys.executable, "-c", MEASURED, *checked), capture_output=True, text=True, check=True)
    most, status, traceback = done.stdout.split()
    assert int(most) <= MOST_MB and int(status) in (0, 1, 2, 3) and traceback == "False", done.stdout
