"""What the sheets write beneath and beside their figures is what is drawn: directions, units, one symbol a quantity."""

from __future__ import annotations

import cmath
import math
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import shapely

from planes.cli import main
from planes.documents.drawn import page_of_view
from planes.documents.sheets import sheet_of
from planes.drafting.steps.reckoning import Drop
from planes.lesson.data import lesson_data
from planes.scene import Scene, load, loads
from planes.solving import Position, solve
from planes.words.errors import PlanesError
from planes.words.naming import Naming
from render.labels.footprints import inked_shapes, overprinted_labels
from render.paper.letters import lettered_pieces
from render.paper.marks import Line, Text
from render.paper.typeset import lay_out_text, plain_text
from render.views import remark_texts
from render.views.arms import Arm, Arms
from render.views.loading import Arrows
from render.views.table_grid import TableGrid
from tests.helpers import ROOT

SAMPLES = {path.stem: path for path in sorted((ROOT / "samples").glob("*.yaml"))}
SAMPLES.pop("vectors")
TWICE = """\
planes: 1
frame: {points: {O: [0, 0]}, guides: {y-y: {x: 0.3}}}
links:
  1: {points: {O: 0}, guides: {r: {through: O, angle: 0}}}
  2: {points: {B: 0}, slides: r, mass: 2}
  3: {points: {B: 0}, slides: y-y, mass: 1}
drive: {link: 1, phi: 30, omega: 10}
"""


@cache
def scene_of(name: str) -> Scene:
    return replace(load(SAMPLES[name]), find=None)


@cache
def drawn(name: str) -> Position:
    return solve(scene_of(name)).positions[0]


def said(scene: Scene, view: str, lang: str = "en") -> set[str]:
    """The texts of one view, as they are read."""
    return {plain_text(m.text) for m in page_of_view(scene, view, None, lang).marks if isinstance(m, Text)}


@pytest.mark.parametrize("name", ["bntu-2", "crank-slider", "kind-2-rrp"])
def test_a_reaction_with_friction_is_written_as_it_leans(name: str) -> None:
    position = drawn(name)
    leaning = [t for e in position.plans.equations for t in e.all_terms if (t.direction or "").startswith("∡")]
    assert leaning
    for term in leaning:
        guide = term.action.partition("∥")[2]
        rho = math.degrees(math.atan(position.plans.mechanism.friction[guide]))
        way, along = complex(position.drawing[term.direction]), complex(position.drawing[f"∥{guide}"])
        assert abs(math.degrees(cmath.phase(way / along)) % 180 - 90) == pytest.approx(rho)
        assert f"∠{rho:.1f}° to ⊥{guide.replace('-', '–')}" in said(scene_of(name), "force-equations")
    terms = [t for e in lesson_data(scene_of(name))["equations"] for side in e["sides"] for t in side]
    assert any(t["action"].startswith("∠ρ ⊥") for t in terms)


@pytest.mark.parametrize(("name", "unit"), [("bntu-1", "N·m"), ("bntu-3", "N·m"), ("six-link", "W")])
def test_the_equation_of_the_lever_is_in_the_unit_of_its_numbers(name: str, unit: str) -> None:
    assert said(scene_of(name), "lever") & {"W", "N·m", "N"} == {unit}


def test_the_lever_of_a_sliding_driver_at_rest_is_in_newtons() -> None:
    scene = scene_of("sliding-driver")
    assert scene.mechanism
    resting = replace(scene.mechanism.drive, velocity=0.0, acceleration=0.0)
    still = replace(scene, mechanism=replace(scene.mechanism, drive=resting))
    assert "N" in said(still, "lever") and not said(still, "lever") & {"W", "N·m"}


@pytest.mark.parametrize("name", list(SAMPLES))
def test_an_arm_has_one_symbol_and_a_symbol_one_arm(name: str) -> None:
    position, naming = drawn(name), Naming("en")
    found: dict[str, set[str]] = {}
    steps = {s.makes: s for s in position.plans.program.steps if isinstance(s, Drop)}
    for equation in position.plans.moments:
        for force, arm in equation.terms:
            if arm in steps:
                symbol = naming.lettered_arm(force, arm)
                assert "".join(p.text for p in lettered_pieces(f"⟨{arm}⟩", naming)) == plain_text(symbol)
                found.setdefault(symbol, set()).add(arm)
    assert all(len(arms) == 1 for arms in found.values())


def test_two_arms_of_one_force_are_told_apart_in_figure_and_equation() -> None:
    figure, equations = (said(scene_of("kind-3-rpr"), view) for view in ("group-2-3", "moments"))
    assert {"hΦ2", "hΦ2B"} <= figure
    assert {"G2hG2", "−G2hG2B", "Φ2hΦ2", "Φ2hΦ2B"} <= equations


def test_a_line_drawn_twice_is_written_as_the_line_it_is() -> None:
    scene = loads(TWICE)
    texts = said(scene, "equations")
    assert "⊥OB" in texts and not any(re.search("[′~]", t) for t in texts)
    exported = lesson_data(scene)
    assert not any("~" in text for frame in exported["frames"] for text in frame["said"].values())
    assert not any("~" in t["action"] for e in exported["equations"] for side in e["sides"] for t in side)


@pytest.mark.slow
@pytest.mark.parametrize(("paper", "number"), [("A4", 1), ("A4", 2), ("A3", 1)])
def test_the_format_a_refusal_advises_does_hold_the_sheet(paper: str, number: int) -> None:
    scene = replace(scene_of("six-link"), sheet={"format": paper})
    with pytest.raises(PlanesError) as refused:
        sheet_of(scene, None, "en", number)
    advised = re.search(r"; (A\d) holds all of it$", refused.value.told("en"))
    assert advised
    assert sheet_of(replace(scene, sheet={"format": advised[1]}), None, "en", number).paper.name == advised[1]


@pytest.mark.slow
def test_a_refusal_blames_one_view_only_where_it_does_not_fit_alone() -> None:
    scene = replace(scene_of("kind-1-rrr"), sheet={"format": "A4"})
    with pytest.raises(PlanesError, match=r"the \d+ views do not all fit"):
        sheet_of(scene, None, "en", 2)


@pytest.mark.few(0)
@pytest.mark.parametrize(("view", "numbers"), [("positions", "0, 1, 2, 3, 4, 2′"), ("velocity-plan", "")])
def test_positions_that_are_left_out_are_told(view: str, numbers: str, tmp_path: Path, capsys: Any) -> None:
    arguments = ["--view", view, "--lang", "en", "-o", str(tmp_path / "x.svg")]
    assert main(["sheet", str(SAMPLES["six-link"]), *arguments]) == 0
    error = [line for line in capsys.readouterr().err.splitlines() if " written: " not in line]
    assert any(f"positions {numbers} are not drawn" in line for line in error) if numbers else not error


def test_vectors_too_short_to_draw_are_told() -> None:
    scene = scene_of("kind-1-rrr")
    assert scene.mechanism
    loads_ = tuple(replace(x, value=x.value * (1e8 if x.kind == "force" else 1)) for x in scene.mechanism.loads)
    heavy = replace(scene, mechanism=replace(scene.mechanism, loads=loads_), mu={})
    (said_,) = page_of_view(heavy, "force-2-3", None, "en").warnings
    assert "G2" in said_
    assert "shorter than 0.05 mm and are not drawn" in said_
    assert page_of_view(scene, "force-2-3", None, "en").warnings == ()


def test_labels_on_labels_and_strokes_are_told() -> None:
    bar = Line((0j, 20 + 0j), "thin", "construction")
    clear, over, struck = Text("AB", 0 + 2j), Text("AB", 1 + 2j), Text("CD", 30 - 2j)
    assert overprinted_labels([bar, clear]) == []
    assert overprinted_labels([bar, clear, over]) == ["AB", "AB"]
    assert overprinted_labels([replace(bar, points=(25 + 0j, 45 + 0j)), clear, struck]) == ["CD"]
    assert overprinted_labels([Line((0j, 20 + 0j), "thin", "text"), Text("AB", 0 - 2j)]) == []  # its own bar


def letters(text: Text) -> shapely.Geometry:
    """The ink of a text's own letters."""
    laid = lay_out_text(text)
    lines = (([(z.real, z.imag) for z in line], pen) for line, pen in zip(laid.strokes, laid.pens, strict=True))
    return shapely.union_all([shapely.LineString(line).buffer(pen / 2) for line, pen in lines if len(line) > 1])


@pytest.mark.parametrize("letter", [2.5, 3.5, 5.0])
@pytest.mark.parametrize("cell", ["a_{E5E}^{k}", "F_{21}^{t}", "12,5", "S_{2}"])
def test_cells_keep_clear_of_the_rules(letter: float, cell: str) -> None:
    marks = TableGrid(letter).drawn_marks(["", "a"], [[cell, "1"], ["G_{2}", cell]])
    rules = inked_shapes([m for m in marks if isinstance(m, Line)])
    for text in (m for m in marks if isinstance(m, Text)):
        assert len(rules.pairs_within(np.array([letters(text)]), 0.3)[0]) == 0


@pytest.mark.parametrize("turn", [0.0, 0.03, 0.05])
def test_forces_that_slant_but_slightly_are_not_drawn_upon_each_other(turn: float) -> None:
    arrows, far = Arrows(), 60 + 0j
    one = arrows.place_force_arrow(0j, 1 + 0j)[:2]
    arrows.upon[0] = one = (one[0], far)  # a long one
    two = arrows.place_force_arrow(10 - 0.2j, cmath.rect(1, turn))[:2]
    lines = [shapely.LineString([(z.real, z.imag) for z in ends]) for ends in (one, two)]
    assert lines[0].buffer(0.3).intersection(lines[1]).length < 4


def test_a_force_keeps_to_its_line_of_action_where_its_arm_is_short() -> None:
    """Three weights on a vertical rod: shifted sideways, they would have other arms, or other signs."""
    rod = (0j, 40j)
    free, kept = Arrows([rod]), Arrows([rod])
    aside = [free.place_force_arrow(20j, -1j) for _ in range(3)]
    along = [kept.place_force_arrow(20j, -1j, arm=3.0) for _ in range(3)]
    assert len({round(start.real, 6) for start, _, _ in aside}) == 3
    assert {round(z.real, 6) for start, end, _ in along for z in (start, end)} == {0.0}
    assert all((end - start).imag < 0 for start, end, _ in along)  # each still points downwards
    lines = sorted((min(s.imag, e.imag), max(s.imag, e.imag)) for s, e, _ in along)
    assert lines[0][1] <= 0.0  # the first clear of the rod


def test_a_reaction_that_is_a_couple_is_drawn_in_its_group() -> None:
    """The guide of slider 5 gives no force, only a moment: the group must show it, or it is not in balance."""
    drawn = sheet_of(load(ROOT / "samples" / "assignments" / "31.yaml"), None, number=2)
    group = next(v for v, *_ in drawn.views if v.key == "group" and "4–5" in plain_text(v.title))
    assert "M(F56)" in {plain_text(m.text) for m in group.marks if isinstance(m, Text)}


def test_an_arm_of_two_forces_is_drawn_once() -> None:
    arms = Arms()
    arms.add_arm(Arm(5 + 5j, 0j, 5 + 0j, "G_2", "h_{G2}"))
    arms.add_arm(Arm(5 + 9j, 0j, 5 + 0j, "G_3", "h_{G3}"))
    arms.add_arm(Arm(5 + 9j, 0j, 9j, "P_3", "h_{P3}"))
    arms.add_arm(Arm(1 + 9j, 0j, 1 + 0j, "Q_3", "h_{Q3}"))
    assert arms.short == ["h_{Q3}"]
    assert [x.text for x in arms.named] == ["h_{G2} = h_{G3}", "h_{P3}"]
    assert [m.layer for m in arms.marks if isinstance(m, Line)].count("dimension") == 2


def test_no_word_of_a_remark_stands_alone_where_lines_can_be_even() -> None:
    narrow = [Line((0j, 20 + 0j), "thin", "plan")]
    lines = [m.text for m in remark_texts("(collinear vectors are drawn side by side)", narrow)]
    assert len(lines) == 2 and max(map(len, lines)) < 1.5 * min(map(len, lines))
