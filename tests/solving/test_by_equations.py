"""A person's own equations of a mechanism as a scene of vectors: drawn by themselves, they give the same vectors."""

from __future__ import annotations

from pathlib import Path

import pytest
import yaml

from planes.cli import main
from planes.lesson.told import SceneLesson
from planes.scene import Scene, loads
from planes.solving import Position, solve
from planes.solving.by_equations import scene_text_by_equations
from planes.solving.own_equations import mechanism_vectors
from planes.words.errors import SceneError
from tests.helpers import ROOT

SIX = ROOT / "samples" / "six-link.yaml"
FOLDERS = (ROOT / "samples", ROOT / "samples" / "assignments")
UNCHAINED = ("carriage", "excavator", "folding-boom", "hinge-motor", "lift")
"""Their cylinders turn about a point of the frame; the program's equations of these do not follow one another."""
SCENES = [p for folder in FOLDERS for p in sorted(folder.glob("*.yaml")) if p.stem not in UNCHAINED]


def beside(file: Path, equations: list[str]) -> tuple[Scene, Position]:
    """A sample with these equations, and its position."""
    text = file.read_text("utf-8") + "\n" + yaml.safe_dump({"equations": equations}, allow_unicode=True, width=1000)
    scene = loads(text, str(file))
    return scene, solve(scene).positions[0]


def drawn(text: str) -> dict[str, complex]:
    """The vectors of a scene of vectors, in SI."""
    (p,) = solve(loads(text)).positions
    ends = {name: span for name, span in p.plans.vectors.items() if span[0].plan != "contour"}
    return {n: (p.drawing[b] - p.drawing[a]) / p.scales[a.plan.mu_name] for n, (a, b) in ends.items()}


@pytest.mark.few(12)
@pytest.mark.parametrize("file", SCENES, ids=lambda p: p.stem)
def test_equations_of_a_textbook_give_the_vectors_of_the_mechanism(file: Path) -> None:
    """The equations that the program states itself, written down by a person."""
    scene = loads(file.read_text("utf-8"), str(file))
    if not scene.mechanism or scene.find is not None:
        return
    (p,) = solve(scene).positions
    known = dict(mechanism_vectors(p.plans, p.drawing, p.scales))
    moved = (e for e in p.plans.equations if e.plan.kind in ("velocity", "acceleration", "force"))
    own = [
        e.equation_text.replace("−", "-")
        for e in moved
        if {t.name for t in e.all_terms} | {e.total or e.all_terms[0].name} <= {*known}
    ]
    if not own:
        return
    again = drawn(scene_text_by_equations(*beside(file, own)))
    assert len(again) > len(own)
    for name, value in again.items():
        most = max(abs(z) for n, z in known.items() if n[0] == name[0])
        assert abs(value - known[name]) <= 1e-9 * most, name


def test_as_little_is_given_as_the_equations_need() -> None:
    """The lines of action stay unknown in length; what a single equation lacks is given whole, and no more."""
    own = ["v_C = v_B + v_CB", "v_C = v_D + v_CD", "v_X = v_B + 2*v_CA"]
    vectors = yaml.safe_load(scene_text_by_equations(*beside(SIX, own)))["vectors"]
    assert vectors["v_CB"] == {"perpendicular_to": "r_BC"} and vectors["v_CD"] == {"perpendicular_to": "r_DC"}
    assert not vectors["v_C"] and not vectors["v_X"] and len(vectors["v_CA"]) == 2
    (p,) = solve(loads(SIX.read_text("utf-8"))).positions
    again = drawn(scene_text_by_equations(*beside(SIX, own)))
    assert again["v_X"] == pytest.approx(p.v["B"] + 2 * p.v["C"], abs=1e-9)


def test_it_is_a_scene_as_any_other() -> None:
    """A lesson asks for its vectors; its order is that of the equations."""
    told = SceneLesson.of(
        loads(scene_text_by_equations(*beside(SIX, ["a_C = a_B + a_CB^n + a_CB^t = a_D + a_CD^n + a_CD^t"])))
    )
    made = [m.rpartition(":")[2] for f in told.frames for m in f.makes if m.startswith("acceleration:")]
    assert made == ["p", "b'", "n_CB", "d'", "n_CD", "c'"]


def test_an_equation_that_does_not_close_is_named_at_its_line() -> None:
    with pytest.raises(SceneError, match=r"six-link\.yaml:\d+: a_C = a_B \+ a_CB\^t: .*a_CB\^n is missing"):
        scene_text_by_equations(*beside(SIX, ["a_C = a_B + a_CB^t"]))


def test_the_command(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    scene, own = tmp_path / "scene.yaml", tmp_path / "own.yaml"
    scene.write_text(SIX.read_text("utf-8") + "\nequations: [v_C = v_B + v_CB]\n", "utf-8")
    assert main(["equations", str(scene), "-o", str(own), "--lang", "en"]) == 0
    assert main(["solve", str(own), "--lang", "en"]) == 0
    assert "by your own equations" in capsys.readouterr().out
    assert main(["equations", str(SIX), "--lang", "en"]) == 2
    assert "equations:" in capsys.readouterr().err
