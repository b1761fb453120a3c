"""One view on its own page: every view of every sample, cut to its ink, in each format; pictures for a notebook."""

from __future__ import annotations

from dataclasses import replace

import pytest
import shapely

from planes.cli import main
from planes.documents.drawn import page_of_view, picture
from planes.drafting.instruments import Pencil
from planes.scene import load, loads
from planes.solving import solve
from planes.words.errors import PlanesError
from render.labels import Label
from render.labels.footprints import box_around_marks, overprinted_labels
from render.paper.marks import Arrow, Line, Text
from render.sheet.single import PAGE_MARGIN_MM, traced_plans_page
from render.views.senses import marks_with_labels
from tests.helpers import ROOT
from tests.helpers.conflicts import conflicts

SAMPLES = {path.stem: path for path in sorted((ROOT / "samples").glob("*.yaml"))}


def test_a_line_of_action_far_from_its_links_is_drawn_behind_a_break_with_its_arm():
    text = SAMPLES["kind-2-rrp"].read_text(encoding="utf-8")
    couple = text.replace("gravity: 9.81", "  - {link: 3, moment: 250}\ngravity: 9.81")
    usual, far = (page_of_view(replace(loads(t), find=None), "links-2-3", [15], "ru") for t in (text, couple))
    assert max(far.size) < 1.6 * max(usual.size)
    said = [m.text for m in far.marks if isinstance(m, Text) and m.name == "arm"]
    arm = solve(replace(loads(couple), find=None), [15.0]).positions[0].results["reactions"]["F_30"]["arm"]
    assert abs(arm) > 1 and said == [f"{abs(arm):.4g} м".replace(".", ",")]
    (zigzag,) = (m for m in far.marks if isinstance(m, Line) and m.layer == "axis" and len(m.points) == 4)
    assert zigzag.style == "thin"


def names(scene):
    with pytest.raises(PlanesError) as refused:
        page_of_view(scene, "?", None, "en")
    return str(refused.value).partition("it has ")[2].split(", ")


@pytest.mark.few(1, slow=6)
@pytest.mark.parametrize("name", list(SAMPLES))
def test_every_view_is_cut_to_its_ink(name):
    scene = load(SAMPLES[name])
    for view in names(scene):
        try:
            found = page_of_view(scene, view)
        except PlanesError as error:
            assert "нечего чертить" in error.told("ru")
            continue
        left, low, right, high = box_around_marks(found.marks)
        assert (left, low) == pytest.approx((PAGE_MARGIN_MM, PAGE_MARGIN_MM), abs=1e-6)
        assert (found.size[0] - right, found.size[1] - high) == pytest.approx(
            (PAGE_MARGIN_MM, PAGE_MARGIN_MM), abs=1e-6
        )
        clashes = [str(c) for c in conflicts((), found.marks, (0, 0, *found.size))]
        assert [c for c in clashes if " lies on 'line of text" not in c] == [], view


def test_the_views_of_a_six_link_mechanism():
    found = names(load(SAMPLES["six-link"]))
    assert {"position", "velocity-plan", "acceleration-plan", "force-2-3", "group-4-5", "lever"} <= set(found)
    assert names(load(SAMPLES["vectors"])) == ["velocity-plan", "equations", "asked", "given", "measured", "values"]


@pytest.mark.parametrize("suffix", ["svg", "pdf", "png", "dxf"])
def test_a_view_is_written_in_every_format(suffix, tmp_path):
    target = tmp_path / f"plan.{suffix}"
    assert main(["sheet", str(SAMPLES["six-link"]), "--view", "velocity-plan", "-o", str(target), "--lang", "en"]) == 0
    assert target.stat().st_size > 1000


@pytest.mark.parametrize(("arguments", "said"), [(["--view", "plan"], "velocity-plan"), (["--phi", "0:90:30"], "4")])
def test_an_unknown_view_is_one_sentence_and_no_file(arguments, said, tmp_path, capsys):
    arguments = ["--view", "velocity-plan", *arguments]
    assert main(["sheet", str(SAMPLES["six-link"]), *arguments, "-o", str(tmp_path / "x.svg"), "--lang", "en"]) == 2
    error = capsys.readouterr().err
    assert error.count("\n") == 1
    assert said in error
    assert not list(tmp_path.iterdir())


def test_a_scene_and_a_position_show_themselves():
    scene = load(SAMPLES["kind-1-rrr"])
    assert scene._repr_svg_() == picture(scene)._repr_svg_()
    assert solve(scene).positions[0]._repr_svg_().startswith("<svg ")


def test_a_notebook_shows_a_position_as_it_was_drawn():
    scene = load(SAMPLES["six-link"])
    drawn = solve(scene, None, Pencil(seed=3)).positions[0]
    shown = picture(drawn, "velocity-plan")
    assert shown._repr_svg_().startswith("<svg ")
    assert shown.marks != picture(scene, "velocity-plan").marks
    assert "<svg" in picture(load(SAMPLES["vectors"]))._repr_svg_()


@pytest.mark.parametrize("name", ["six-link", "kind-4-prp", "sliding-driver"])
def test_a_drawing_shows_itself_with_every_plan(name):
    drawing = solve(load(SAMPLES[name])).positions[0].drawing
    page = traced_plans_page(drawing, "en")
    written = {m.text for m in page.marks if isinstance(m, Text)}
    assert {"position plan", "velocity polygon", "acceleration polygon"} <= written
    ends = [z for m in page.marks if isinstance(m, Line) for z in m.points]
    lengths = {round(abs(a - b), 6) for a in ends for b in ends}
    assert round(abs(drawing["velocity:b"]), 6) in lengths  # in mm, as it was drawn
    assert drawing._repr_svg_().startswith("<svg ")


@pytest.mark.parametrize(("view", "corners"), [("velocity-plan", "b c l"), ("acceleration-plan", "b' c' l'")])
def test_the_similar_triangle_of_a_plan_is_hatched_and_its_letters_are_not_struck(view, corners):
    """The strokes keep clear of the triangle's sides, so that none is taken for a side; nothing else is hatched."""
    scene = load(SAMPLES["six-link"])
    found = page_of_view(scene, view)
    drawn = solve(replace(scene, find=None)).positions[0].drawing
    arrows = {m.name: m for m in found.marks if isinstance(m, Arrow)}
    tip, mark = next((m.end, z) for n, z in (("v_B", "b"), ("a_B", "b'")) for k, m in arrows.items() if k == n)
    plan = view.partition("-")[0]
    mu = abs(arrows[f"{plan[0]}_B"].end - arrows[f"{plan[0]}_B"].start) / abs(drawn[f"{plan}:{mark}"])
    ends = [tip + mu * (drawn[f"{plan}:{c}"] - drawn[f"{plan}:{mark}"]) for c in corners.split()]
    inside = shapely.Polygon([(z.real, z.imag) for z in ends]).buffer(-0.9)
    strokes = [m.points for m in found.marks if isinstance(m, Line) and m.layer == "hatch"]
    assert len(strokes) > 5
    assert all(inside.covers(shapely.Point(z.real, z.imag)) for ends in strokes for z in ends)
    letters = [m for m in found.marks if isinstance(m, Text) and m.height == 5.0]
    assert conflicts(letters, [m for m in found.marks if m.layer == "hatch"]) == ()
    assert not [m for m in page_of_view(scene, "force-2-3").marks if m.layer == "hatch"]


@pytest.mark.parametrize(("gap", "height"), [(5.4, 3.5), (9.0, 5.0)])
def test_letters_are_a_step_smaller_where_they_find_no_room(gap: float, height: float) -> None:
    bars = [Line((complex(-150, gap * k), complex(150, gap * k)), "thick") for k in range(-40, 41)]
    drawn = marks_with_labels([Label("B", 0.5j * gap, 5.0)], bars)
    assert [m.height for m in drawn if isinstance(m, Text)] == [height] and overprinted_labels(drawn) == []
