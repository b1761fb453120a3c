"""The way from a scene's text to its plans, tape, lesson and practice needs neither numpy nor what draws on paper."""

import json
import subprocess
import sys

import pytest

from planes.lesson.data import lesson_data
from planes.scene import load
from tests.sample_oracle import SAMPLES

BLOCKED = ("numpy", "shapely", "matplotlib", "svgwrite", "reportlab", "ezdxf", "fontTools", "segno", "pypdfium2")
FAST = ("six-link", "vectors", "class-three/press")
SEARCHED = "class-three/three-basic-links"  # by many places at once: arrays
SCRIPT = """
import json, sys
for name in {blocked!r}: sys.modules[name] = None
import planes
from planes.lesson.data import lesson_data
scene = planes.load(sys.argv[1])
data = lesson_data(scene)
print(json.dumps(data))
if "--solve" in sys.argv: str(planes.solve(scene))
"""


def alike(path: str, *more: str) -> None:
    run = [sys.executable, "-c", SCRIPT.format(blocked=BLOCKED), path, *more]
    told = subprocess.run(run, capture_output=True, text=True, check=False)
    assert told.returncode == 0, told.stderr
    assert json.loads(told.stdout) == json.loads(json.dumps(lesson_data(load(path))))


@pytest.mark.parametrize("name", FAST)
def test_a_lesson_is_the_same_without_numpy(name: str) -> None:
    alike(str(SAMPLES / f"{name}.yaml"), *["--solve"] * (name != "vectors"))


@pytest.mark.few(0, slow=12)
@pytest.mark.parametrize("path", [p for p in sorted(SAMPLES.rglob("*.yaml")) if "links:" in p.read_text("utf-8")])
def test_every_lesson_is_the_same_without_numpy(path) -> None:  # type: ignore[no-untyped-def]
    if path.stem != SEARCHED.split("/")[1] and "crank_slider:" not in path.read_text("utf-8"):
        alike(str(path))
