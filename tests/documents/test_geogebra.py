"""A plan as a construction of GeoGebra: evaluated by an interpreter of its own, held against the engine's drawing."""

from pathlib import Path
from typing import Any

import pytest

from planes.documents.constructed import LiveFigure, draw_constructed, ggb, live_figure
from planes.documents.constructed._numbers import GivenNumbers
from planes.scene import load
from planes.words.names import SCHEME_PLAN
from tests.helpers import ROOT
from tests.helpers.geogebra import COMMANDS, Page, intersect

SAMPLES = sorted([*(ROOT / "samples").glob("*.yaml"), *(ROOT / "samples" / "vectors").glob("*.yaml")])
QUICK = ("kind-3-rpr", "crank-slider", "vectors")
NEAR = 1e-9


def labels_of(figure: LiveFigure) -> dict[str, str]:
    return ggb.unique_labels(figure, GivenNumbers(figure))


def compared(figure: LiveFigure, page: Page, labels: dict[str, str]) -> int:
    """Every mark that is shown beside the engine's own, from its pole."""
    made: dict[str, Any] = page.points()
    for mark in figure.shown_marks:
        pole = made[labels[mark.plan.pole]]
        own = [abs(figure.place_on_plan(m)) for m in figure.shown_marks if m.plan == mark.plan]
        assert abs(made[labels[mark]] - pole - figure.place_on_plan(mark)) <= NEAR * max(own), mark
    return len(figure.shown_marks)


def held(file: Path, view: str | None = None) -> None:
    scene = load(file)
    figure = live_figure(scene, view, None, "en")
    data, said = ggb.file_and_limitations(figure)
    page, labels = Page(data), labels_of(figure)
    assert compared(figure, page, labels) > 2
    if said:
        assert view is None
        held(file, "acceleration-plan")
    if not scene.mechanism or said:
        return
    drive, counted = scene.mechanism.drive, 0
    for share in (-0.02, 0.01, 0.03):
        value = drive.position + share * (360 if drive.kind == "phi" else drive.position or 1)
        moved = live_figure(scene, view, [value], "en")
        page.set = {
            labels[n]: float(moved.position.scales[n])
            for n in (p.mu_name for p in (*figure.stated_plans.plan_names, SCHEME_PLAN))
            if n in labels
        }
        page.set[labels[drive.coordinate_name]] = value
        counted += compared(moved, page, labels) > 2
    assert counted == 3


@pytest.mark.parametrize("file", [f for f in SAMPLES if f.stem in QUICK], ids=lambda f: f.stem)
def test_every_point_is_where_the_engine_has_it(file: Path) -> None:
    held(file)


@pytest.mark.slow
@pytest.mark.parametrize("file", [f for f in SAMPLES if f.stem not in QUICK], ids=lambda f: f.stem)
def test_every_point_of_the_other_samples(file: Path) -> None:
    held(file)


@pytest.mark.slow
@pytest.mark.parametrize("file", sorted((ROOT / "samples" / "class-three").glob("*.yaml"))[:2], ids=lambda f: f.stem)
def test_what_geogebra_cannot_draw_stays_and_is_said(file: Path, tmp_path: Path) -> None:
    figure = live_figure(load(file), None, None, "en")
    data, (said,) = ggb.file_and_limitations(figure)
    compared(figure, Page(data), labels_of(figure))
    assert "stay where they are" in said and said.count("\n") == 0
    assert draw_constructed(load(file), None, None, str(tmp_path / "a.ggb"), "en") == (said,)


def test_a_length_moves_all_that_hangs_on_it() -> None:
    """A scene with another length, and the slider of that length, draw the same."""
    file = ROOT / "samples" / "kind-3-rpr.yaml"
    figure, scene = live_figure(load(file), "velocity-plan", None, "en"), load(file, l_AB=0.13)
    page, labels = Page(ggb.file_and_limitations(figure)[0]), labels_of(figure)
    moved = live_figure(scene, "velocity-plan", None, "en")
    page.set = {labels["l_AB"]: 0.13} | {labels[n]: float(moved.position.scales[n]) for n in labels if n[:3] == "mu_"}
    compared(moved, page, labels)


def test_the_order_in_which_meetings_are_found_does_not_matter(monkeypatch: pytest.MonkeyPatch) -> None:
    """Which of two meetings is meant is told by its side: GeoGebra may number them as it likes."""
    figure = live_figure(load(ROOT / "samples" / "six-link.yaml"), "velocity-plan", None, "en")
    page, labels = Page(ggb.file_and_limitations(figure)[0]), labels_of(figure)
    monkeypatch.setitem(COMMANDS, "Intersect", lambda a, b, k=0: intersect(a, b, 3 - k if k else 0))
    assert compared(figure, page, labels) > 2


def test_every_thing_has_one_label_and_an_element_of_its_own() -> None:
    figure = live_figure(load(ROOT / "samples" / "crank-slider.yaml"), None, None, "ru")
    data = ggb.file_and_limitations(figure)[0]
    assert data == ggb.file_and_limitations(figure)[0]
    body = Page(data).body
    assert body is not None
    elements = [e.get("label") for e in body if e.tag == "element"]
    made = [e.get("label") for e in body if e.tag == "expression"]
    made += [out.get("a0") for e in body if (out := e.find("output")) is not None]
    assert len({*elements}) == len(elements) and {*made} <= {*elements} and len({*made}) == len(made)
    sliders = [e.get("label") for e in body if e.find("slider") is not None]
    assert {"φ_{1}", "l_{OA}", "l_{AB}"} <= {*sliders}
    captions = {str(c.get("val")) for e in body if (c := e.find("caption")) is not None}
    assert {"$A$", "$v_{BA}$", "$a_{BA}^{n}$"} <= captions


def test_a_number_has_its_value_before_it_is_shown() -> None:
    """GeoGebra gives a number that is shown the limits ±5, and would make φ₁ = 150° of a later value 5°."""
    body = Page(
        ggb.file_and_limitations(live_figure(load(ROOT / "samples" / "six-link.yaml"), None, None, "en"))[0]
    ).body
    numbers = [e for e in body or () if e.tag == "element" and e.find("value") is not None]
    assert any(e.get("label") == "φ_{1}" for e in numbers) and all(e[0].tag == "value" for e in numbers)
