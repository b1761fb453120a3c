"""The lesson for whoever hears it, types it, turns the lights off, or holds it in a hand: axe finds nothing, nothing is
given away, nothing runs off the page."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from tests.helpers import ROOT

SIX = ROOT / "samples" / "six-link.yaml"
WIDE = {"width": 1280, "height": 900}
RULES = {"runOnly": ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"]}
HELP = "const asked = n => data.practice.findIndex(t => t.what === n), tool = n => ({ dataset: { tool: n } })"
STATES = {
    "first": "go(0)",
    "equation": "go(data.frames.findIndex(f => f.key === 'equation'))",
    "sense": "go(data.frames.findIndex(f => f.key === 'sense'))",
    "last": "go(data.frames.length - 1)",
    "numbers": "go(20); document.getElementById('dims').open = true",
    "failed": "turn(40); draw()",
    "practice": "practice.toggle()",
    "practice, a vector": "practice.toggle(); practice.take(asked('velocity:b')); practice.answer([9, 9], '')",
    "practice, an arc": "practice.toggle(); practice.take(asked('position:C')); task.pick('tool', tool('arc'))",
    "practice, crossings": "practice.toggle(); practice.take(asked('position:C')); task.pick('tool', tool('point'))",
    "practice, a sense": "practice.toggle(); practice.take(data.practice.findIndex(t => t.kind === 'sense'))",
    "practice, underlines": "practice.toggle(); practice.take(data.practice.findIndex(t => t.kind === 'known'))",
    "practice, an arm": "practice.toggle(); practice.take(asked('h_G_2_C'))",
    "practice done": "practice.toggle(); practice.over = true; draw()",
}


def complaints(page: Any) -> list[str]:
    """What axe finds against it."""
    axe = pytest.importorskip("axe_playwright_python", reason="install the test extra: pip install -e '.[test]'")
    page.evaluate((Path(axe.__file__).parent / "axe.min.js").read_text(encoding="utf-8"))
    found = page.evaluate("rules => axe.run(document, rules)", RULES)["violations"]
    return [f"{v['id']}: {[n['html'][:90] for n in v['nodes'][:3]]}" for v in found]


@pytest.mark.few(2)
@pytest.mark.parametrize("state", STATES)
def test_axe_finds_nothing(page: Any, state: str) -> None:
    for scheme in ("light", "dark"):
        page.emulate_media(color_scheme=scheme)
        page.evaluate(f"{HELP}; {STATES[state]}" if scheme == "light" else "draw()")
        assert complaints(page) == []


def test_what_is_heard_is_what_is_seen_and_no_answer(page: Any) -> None:
    page.evaluate("go(data.frames.findIndex(f => f.makes[0] === 'velocity:c'))")
    heard = page.get_attribute("#plan", "aria-label")
    assert "vC" in heard and "vCB" in heard and "vH" not in heard and "_" not in heard
    page.evaluate("practice.toggle(); practice.take(data.practice.findIndex(t => t.what === 'velocity:c'))")
    assert "vCB" not in page.get_attribute("#plan", "aria-label")
    page.evaluate("practice.toggle(); go(data.frames.length - 1)")
    assert "ω" not in page.get_attribute("#scheme", "aria-label")


@pytest.mark.parametrize("size", [(320, 640), (390, 844), (640, 450), (1920, 1080)])
def test_nothing_runs_off_any_screen(page: Any, size: tuple[int, int]) -> None:
    page.set_viewport_size({"width": size[0], "height": size[1]})
    for k in (0, 10, 30, 60):
        page.evaluate(f"go({k})")
        assert page.evaluate("document.documentElement.scrollWidth") <= size[0]
    figure = page.evaluate("document.querySelector('figure').getBoundingClientRect().width")
    assert figure > 0.9 * size[0] - 20 if size[0] < 760 else figure > 0.4 * size[0]


def test_results_are_shown_as_they_are_found(page: Any) -> None:
    page.evaluate("go(0)")
    assert page.inner_text("#rates") == ""
    page.evaluate("go(data.frames.findIndex(f => f.key === 'sense'))")
    assert "ω2" not in page.inner_text("#rates").replace("\\n", "")
    page.evaluate("go(data.frames.length - 1)")
    assert page.locator("#rates span").count() == page.evaluate("data.results.length")


def test_a_group_stands_alone_under_its_forces_as_long_as_on_the_plan(page: Any) -> None:
    page.evaluate("go(data.frames.findIndex(f => f.plan === 'force:2-3' && f.key === 'cross'))")
    drawn = "[...document.querySelectorAll('#scheme .arrow')].map(a => a.dataset.name)"
    assert {"G_2", "I_2", "F_24", "F_21^t", "F_21^n", "F_30^n"} <= set(page.evaluate(drawn))
    away = page.evaluate("[...document.querySelectorAll('#scheme .away')].map(a => a.dataset.name)")
    assert "link:1" in away and not {"link:2", "link:3"} & set(away)
    long = """() => {
        const g = document.querySelector('#scheme .arrow[data-name="F_24"] polygon').getAttribute('points');
        const tip = g.split(' ')[0].split(',').map(Number), from = scheme.px(live.at('position:H'));
        return Math.hypot(tip[0] - from[0], tip[1] - from[1]) / scheme.k; }"""
    there = page.evaluate("Math.abs(live.value('|F_42|')) * live.given['mu_force:2-3']")
    assert page.evaluate(long) == pytest.approx(there, rel=5e-3)
