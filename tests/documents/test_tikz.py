"""A plan as TikZ: a small reader of the document finds every coordinate where the engine has it."""

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from planes.documents.constructed import live_figure, tex
from planes.documents.drawn import draw_sheet
from planes.scene import load
from planes.words import available_languages
from planes.words.errors import PlanesError
from render.files.tikz import latex_math, latex_text
from tests.helpers import ROOT

SAMPLES = sorted([*(ROOT / "samples").glob("*.yaml"), *(ROOT / "samples" / "class-three").glob("*.yaml")])
COORDINATE = re.compile(r"\\coordinate \(([\w-]+)\) at \(([-\d.]+), ([-\d.]+)\);")
USED = re.compile(r"\(([a-z]+(?:-[\w-]+)+)\)")


def read(text: str) -> dict[str, complex]:
    """The coordinates of a document by name; one is used only after it is there, and braces are closed."""
    found: dict[str, complex] = {}
    for line in text.splitlines():
        if line.startswith("%"):
            continue
        assert line.count("$") % 2 == 0
        if match := COORDINATE.fullmatch(line):
            assert match[1] not in found
            found[match[1]] = complex(float(match[2]), float(match[3]))
        else:
            assert {*USED.findall(line)} <= {*found}, line
    assert text.count("{") == text.count("}")
    return found


def held(file: Path) -> None:
    figure = live_figure(load(file), None, None, "en")
    text = tex.file_and_limitations(figure)[0].decode()
    found = read(text)
    for mark in figure.shown_marks:
        assert abs(found[tex.coordinate_name(mark)] - figure.place_on_picture(mark)) < 1e-8, mark
    assert text.count("\\draw[whole]") + text.count("\\draw[part]") > 0


@pytest.mark.parametrize("name", ["kind-3-rpr", "vectors"])
def test_coordinates_are_where_the_engine_has_them(name: str) -> None:
    held(ROOT / "samples" / f"{name}.yaml")


@pytest.mark.slow
@pytest.mark.parametrize("file", SAMPLES, ids=lambda f: f.stem)
def test_coordinates_of_all_samples(file: Path) -> None:
    held(file)


def test_names_are_mathematics_and_sentences_are_of_each_language() -> None:
    assert latex_math("a_{CB}^{n}") == "a_{CB}^{n}"
    assert latex_math("b_{3}′") == "b_{3}'"
    assert latex_math("M_{ур}^{Ж}") == r"M_{\text{ур}}^{\text{Ж}}"
    assert latex_text("μ_{v} = 5 мм/% · м") == r"$\mu_{v}$ = 5 мм/\% $\cdot$ м"
    scene, told = load(ROOT / "samples" / "kind-3-rpr.yaml"), set()
    for lang in available_languages():
        text = tex.file_and_limitations(live_figure(scene, "velocity-plan", None, lang))[0].decode()
        assert "$v_{B3B}$" in text
        told.add(
            next(line for line in text.splitlines() if line.startswith("% ") and "l_CB" not in line and "A, C" in line)
        )
    assert len(told) == len(available_languages())


def test_a_view_that_is_no_plan_is_refused_with_those_there_are(tmp_path: Path) -> None:
    scene, file = load(ROOT / "samples" / "kind-3-rpr.yaml"), tmp_path / "a.tex"
    with pytest.raises(PlanesError, match="velocity-plan"):
        draw_sheet(scene, None, str(file), "en", view="moments")
    with pytest.raises(PlanesError, match="--sheet"):
        draw_sheet(scene, None, str(file), "en", number=1)
    assert not file.exists()


@pytest.mark.slow
@pytest.mark.skipif(not shutil.which("pdflatex"), reason="pdflatex is not here")
def test_latex_sets_it(tmp_path: Path) -> None:
    draw_sheet(load(ROOT / "samples" / "kind-3-rpr.yaml"), None, str(tmp_path / "plan.tex"), "ru")
    subprocess.run(["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "plan.tex"], cwd=tmp_path, check=True)
