"""Force polygons close: terms stand head to tail at their places, what lies on one line is told by numbered ends."""

from __future__ import annotations

import re
from dataclasses import replace

import pytest

from planes.documents.sheets import sheet_of
from planes.plans.measuring import scene_lettering
from planes.scene import load
from planes.solving import solve
from planes.words.naming import Naming
from render.paper.hues import DETAIL_NAME_SUFFIX
from render.paper.marks import Arrow, Text
from render.sheet.composer import drawn_plans
from render.views.plotted import plot_position
from render.views.polygon import Polygon, tick_ends
from tests.helpers import ROOT

FEW = ["samples/shaper.yaml", "samples/six-link.yaml", *(f"samples/assignments/{k}.yaml" for k in (16, 31, 50, 61))]
ALL = sorted(str(p.relative_to(ROOT)) for p in (ROOT / "samples").rglob("*.yaml") if p.parent.name != "course")


def polygons(path):
    """The force polygons of a scene, drawn."""
    scene = load(ROOT / path)
    if scene.mechanism is None:
        return
    position = solve(replace(scene, find=None)).positions[0]
    plotted, naming = plot_position(position), Naming("ru", **scene_lettering(scene, position.plans))
    for plan in (p for p in drawn_plans(plotted, position) if p.is_force):
        yield Polygon(plotted, plan, naming)


@pytest.mark.parametrize("path", [*FEW, *(pytest.param(p, marks=pytest.mark.slow) for p in ALL if p not in FEW)])
def test_terms_stand_head_to_tail(path):
    for polygon in polygons(path):
        arrows = {
            m.name: m for m in polygon.drawn_marks() if isinstance(m, Arrow) and not m.name.endswith(DETAIL_NAME_SUFFIX)
        }
        for equation in (e for e in polygon.plotted.equations if e.plan == polygon.plan):
            for term in equation.all_terms:
                for ends in (term.start, term.end), (term.end, term.start):
                    for drawn in (arrows[names[0]] for names in (polygon.arrows.get(ends),) if names):
                        off = [
                            abs(z - polygon.mark(end)) for z, end in zip((drawn.start, drawn.end), ends, strict=True)
                        ]
                        assert max(off) < 1e-9, (polygon.plan, term.name)


def test_ends_of_forces_in_one_line_are_numbered():
    (polygon,) = (p for p in polygons("samples/assignments/31.yaml") if p.plan == "force:4-5")
    marks = polygon.drawn_marks()
    texts = {m.name: m.text for m in marks if isinstance(m, Text)}
    assert texts["G_5"] == "G_{5} (1–2)" and texts["P_5"] == "P_{5} (3–4)"
    assert texts["F_54"] == "F_{54} = F_{43} (4–1) = −F_{45}"
    assert {"p, 1", "2", "3", "4"} <= {m.text for m in marks if isinstance(m, Text)}
    assert not any(re.search(r"раздвинут", m.text) for m in marks if isinstance(m, Text))


def test_a_sum_stands_beside_its_forces_with_ticks_at_its_ends():
    (polygon,) = (p for p in polygons("samples/assignments/16.yaml") if p.plan == "force:2-3")
    polygon.drawn_marks()
    *ticks, arrow = polygon.aside[-3:]
    assert arrow.name == "F_32" and len(ticks) == 2
    true = [polygon.mark(label) for label in next(k for k, names in polygon.arrows.items() if "F_32" in names)]
    assert [t.points for t in ticks] == [tick_ends(true[0], arrow.start), tick_ends(true[1], arrow.end)]
    assert abs(arrow.start - true[0]) in (pytest.approx(2.0), pytest.approx(4.0))


@pytest.mark.parametrize("sample", ["six-link", "kind-1-rrr", "bntu-3"])
def test_the_pole_of_a_force_polygon_has_its_letter(sample: str) -> None:
    for polygon in polygons(f"samples/{sample}.yaml"):
        texts = [m.text for m in polygon.drawn_marks() if isinstance(m, Text)]
        assert any(text.split(", ")[0] in ("p", "π") for text in texts), polygon.plan


@pytest.mark.parametrize("path", ["samples/bntu-2.yaml", "samples/class-four/press.yaml"])
def test_a_reaction_with_friction_leans_on_its_normal_force_and_its_friction(path):
    """A right triangle head to tail: its legs are N and T of the results, T against the motion along the guide."""
    polygon = next(p for p in polygons(path) if p.plotted.leaning)
    (reaction,) = polygon.plotted.leaning
    arrows = {m.name: m for m in polygon.drawn_marks() if isinstance(m, Arrow)}
    normal, friction, whole_force = arrows["N_30"], arrows["T_30"], arrows["F_30"]
    assert abs(normal.end - friction.start) < 1e-9
    assert abs(normal.start - whole_force.start) < 1e-9 and abs(friction.end - whole_force.end) < 1e-9
    way = complex(polygon.plotted.drawing[f"∥{reaction.pair.guide}"])
    assert abs(((normal.end - normal.start) * way.conjugate()).real) < 1e-9
    mu, made = polygon.plotted.plan_mu(polygon.plan), polygon.plotted.drawing
    assert abs(normal.end - normal.start) == pytest.approx(mu * abs(float(made[reaction.normal])))
    assert abs(friction.end - friction.start) == pytest.approx(mu * abs(float(made[reaction.friction])))


def test_friction_has_its_table_on_sheet_2():
    scene = load(ROOT / "samples/friction-circles.yaml")
    said = [m.text for m in sheet_of(scene, None, "en", 2).marks if isinstance(m, Text)]
    assert "Friction" in said and {"N_{30}", "T_{30}", "P_{T30}", "M_{T21}", "P_{T21}"} <= {*said}
