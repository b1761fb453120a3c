"""Plans of stated vectors as others draw them: matplotlib, Inkscape, Illustrator, DXF; right ones and a wrong one."""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import pytest

import planes
from planes.scene import Scene
from planes.words.names import PlanId
from tests.helpers import ROOT, line_drawings

Vectors = dict[tuple[complex, complex], tuple[str, str, str]]
Words = list[tuple[str, complex]]
PLANS = [("friction", "force:2-3"), ("group", "force:2-3"), ("six-link", "velocity"), ("six-link", "acceleration")]
ORIGIN = 100 + 150j


def scene_of(name: str) -> Scene:
    return planes.load(ROOT / "samples" / "vectors" / f"{name}.yaml")


def drawn(scene: Scene, asked: str) -> tuple[Vectors, Words]:
    """The vectors of a plan, mm from its pole, each with its name and its ends; and where the names stand."""
    plan = PlanId.read(asked)
    here, found, marks = planes.solve(scene), Vectors(), dict[str, complex]()
    pole = complex(here.drawing[plan.pole])
    for s in (s for s in here.plans.segments if s.plan == plan):
        a, b = (complex(here.drawing[plan.mark(label)]) - pole for label in (s.start, s.end))
        if abs(b - a) > 0.3:
            found.setdefault((a, b), (s.name, s.start, s.end))
            marks |= {s.start: a, s.end: b}
    words = line_drawings.labels(marks, random.Random(1))
    if plan.is_force:
        words = [("p", -3 - 3j)]
        for (a, b), (name, _, _) in found.items():
            side = (b - a) / abs(b - a) * 3j
            words.append((name, (a + b) / 2 + side - complex(2.5 * len(name), 3.5) / 2))
    return found, line_drawings.beside_lines(words, list(found))


def by_matplotlib(vectors: Vectors, words: Words, file: Path) -> None:
    """Arrows and texts on a page without axes, a unit a millimetre."""
    figure = pytest.importorskip("matplotlib.figure")
    places = [z for ends in vectors for z in ends] + [z for _, z in words]
    low = complex(min(z.real for z in places), min(z.imag for z in places)) - (15 + 15j)
    high = complex(max(z.real for z in places), max(z.imag for z in places)) + (25 + 15j)
    page = figure.Figure(figsize=((high - low).real / 25.4, (high - low).imag / 25.4))
    axes = page.add_axes((0, 0, 1, 1))
    axes.set(xlim=(low.real, high.real), ylim=(low.imag, high.imag))
    axes.axis("off")
    look = {"arrowstyle": "-|>", "lw": 1, "shrinkA": 0, "shrinkB": 0, "mutation_scale": 8, "color": "black"}
    for a, b in vectors:
        axes.annotate("", xy=(b.real, b.imag), xytext=(a.real, a.imag), arrowprops=look)
    for text, z in words:
        axes.text(z.real, z.imag, text, fontsize=10)
    page.savefig(file, dpi=200)


def by(writer: Callable[..., str]) -> Callable[[Vectors, Words, Path], None]:
    return lambda vectors, words, file: file.write_text(writer(list(vectors), words, ORIGIN), "utf-8") and None


WRITERS = {
    "matplotlib.svg": by_matplotlib,
    "matplotlib.pdf": by_matplotlib,
    "inkscape.svg": by(line_drawings.inkscape),
    "illustrator.svg": by(line_drawings.illustrator),
    "other.dxf": by(line_drawings.dxf),
}


@pytest.mark.few(2)
@pytest.mark.parametrize("writer", WRITERS)
@pytest.mark.parametrize(("name", "plan"), PLANS)
def test_a_right_plan_of_another_program_is_right(name: str, plan: str, writer: str, tmp_path: Path) -> None:
    scene = scene_of(name)
    WRITERS[writer](*drawn(scene, plan), tmp_path / writer)
    found = planes.check(scene, tmp_path / writer, plan)
    assert found.verdict == "right", found.sentence


@pytest.mark.slow
@pytest.mark.parametrize(("writer", "verdict"), [("matplotlib.svg", "unreadable"), ("other.dxf", "wrong")])
def test_a_force_drawn_the_other_way_is_wrong(writer: str, verdict: str, tmp_path: Path) -> None:
    """The force of friction is carried to the other side: its vector points against what it should. Where the letters
    are outlines, nothing tells which force is which, and the marks are asked for."""
    scene = scene_of("friction")
    other = planes.loads((ROOT / "samples/vectors/friction.yaml").read_text("utf-8").replace("90 + atan", "90 - atan"))
    WRITERS[writer](*drawn(other, "force:2-3"), tmp_path / writer)
    found = planes.check(scene, tmp_path / writer, "force:2-3")
    assert found.verdict == verdict, found.sentence
    assert verdict != "wrong" or found.first_wrong in ("F_30", "F_21", "T_30", "N_30"), found.sentence


@pytest.mark.slow
def test_a_bare_picture_of_a_force_plan_tells_its_pole(tmp_path: Path) -> None:
    """Nobody said where the polygon begins: it is where its sides, in whatever order, find the ink."""
    scene, file = scene_of("friction"), tmp_path / "plan.png"
    by_matplotlib(*drawn(scene, "force:2-3"), file)
    assert planes.check(scene, file, "force:2-3").verdict != "wrong"
