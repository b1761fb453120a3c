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
    "a tool at rest": "go(data.frames.findIndex(f => f.makes[0] === 'velocity:c')); kit.rest()",
    "a free body": "go(data.frames.findIndex(f => f.plan === 'force:2-3' && f.key === 'cross'))",
    "arms": "go(data.frames.findIndex(f => f.key === 'moments'))",
    "the lever": "go(data.frames.findIndex(f => f.plan === 'lever' && f.key === 'moments'))",
    "dragged": "go(20); drag(plan, 'acceleration:n_B', [9, 9]); draw()",
    "equation": "go(data.frames.findIndex(f => f.key === 'equation'))",
    "sense": "go(data.frames.findIndex(f => f.key === 'sense'))",
    "last": "go(data.frames.length - 1); document.getElementById('colour').click()",
    "numbers": "go(20); document.getElementById('dims').open = true",
    "failed": "turn(40); draw()",
    "practice": "practice.toggle()",
    "practice, a vector": "practice.toggle(); practice.take(asked('velocity:b')); practice.answer([9, 9], '')",
    "practice, an arc": "practice.toggle(); practice.take(asked('position:C')); task.pick('tool', tool('arc'))",
    "practice, crossings": "practice.toggle(); practice.take(asked('position:C')); task.pick('tool', tool('point'))",
    "practice, a sense": "practice.toggle(); practice.take(data.practice.findIndex(t => t.kind === 'sense'))",
    "practice, underlines": "practice.toggle(); practice.take(data.practice.findIndex(t => t.kind === 'known'))",
    "practice, a scale": "practice.toggle(); practice.take(data.practice.findIndex(t => t.kind === 'mu'))",
    "practice, an order": "practice.toggle(); practice.take(data.practice.findIndex(t => t.kind === 'first'))",
    "practice, a turning": "practice.toggle(); practice.take(asked('↺F_21^t'))",
    "practice, an arm": "practice.toggle(); practice.take(asked('h_G_2_C'))",
    "practice done": "practice.toggle(); practice.over = true; draw()",
}


def complaints(page: Any) -> list[str]:
    """What axe finds against it."""
    axe = pytest.importorskip("axe_core_python", reason="install the test extra: pip install -e '.[test]'")
    page.evaluate((Path(axe.__file__).parent / "axe.min.js").read_text(encoding="utf-8"))
    found = page.evaluate("rules => axe.run(document, rules)", RULES)["violations"]
    return [f"{v['id']}: {[n['html'][:90] for n in v['nodes'][:3]]}" for v in found]


@pytest.mark.few(1, slow=6)
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


@pytest.mark.few(2)
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


@pytest.mark.slow
def test_readers_of_the_screen_hear_it_at_rest_alone(page: Any) -> None:
    watch = """() => { window.rest = []; const heard = document.getElementById('heard');
        const look = new MutationObserver(() => rest.push(heard.textContent));
        look.observe(heard, { childList: true, characterData: true }); }"""
    page.wait_for_timeout(500)
    page.evaluate(watch)
    page.evaluate("go(3); go(4); for (let k = 0; k < 20; k++) turn(150 + k)")
    page.wait_for_timeout(700)
    told = page.evaluate("rest")
    assert len(told) == 1 and page.inner_text("#sentence")[:20] in told[0]
    page.evaluate("rest.length = 0; spin(true)")
    page.wait_for_timeout(900)
    assert page.evaluate("rest.length") == 0
    page.evaluate("spin(false)")
    assert page.locator("[aria-live], [role=status]").count() == 1


STROKES = """() => { const t = practice.item, [x, y] = live.at(t.what), trace = data.traces[t.what] || {};
    const degrees = a => (a * 180 / Math.PI).toFixed(3);
    const apart = (p, m) => Math.hypot(live.at(m)[0] - p[0], live.at(m)[1] - p[1]);
    const from = p => desk.marks().find(m => apart(p, m) < 0.05);
    const stroke = (tool, n) => { const [u, v] = live.at(n), start = from([u, v]), r = Math.hypot(x - u, y - v);
        return { tool, start, r: r.toFixed(2), angle: degrees(Math.atan2(y - v, x - u)) }; };
    const lines = (trace.lines || []).map(n => stroke("line", n)), arcs = (trace.arcs || []).map(n => stroke("arc", n));
    const all = [...lines, ...arcs].filter(s => s.start && +s.r > 0.5);
    return all.length > 1 ? all.slice(0, 2) : [stroke("vector", desk.from)]; }"""


class Keys:
    """Hands that have a keyboard alone."""

    def __init__(self, page: Any) -> None:
        self.page = page

    def to(self, selector: str) -> None:
        """Tab until there."""
        for _ in range(80):
            if self.page.evaluate(f"document.activeElement.matches({selector!r})"):
                return
            self.page.keyboard.press("Tab")
        pytest.fail(f"the keys do not come to {selector}")

    def press(self, selector: str) -> None:
        self.to(selector)
        self.page.keyboard.press("Enter")

    def choose(self, selector: str, value: str) -> None:
        """A choice of a list by its arrows."""
        self.to(selector)
        if value == self.page.input_value(selector):
            return
        self.page.keyboard.press("Home")
        for _ in range(80):
            if value == self.page.input_value(selector):
                return
            self.page.keyboard.press("ArrowDown")
        pytest.fail(f"the keys do not choose {value} of {selector}")

    def fill(self, selector: str, text: str) -> None:
        self.to(selector)
        self.page.keyboard.press("Control+A")
        self.page.keyboard.type(text)

    def draw(self, stroke: dict[str, str]) -> None:
        """One line, arc or vector."""
        self.press(f"#tool-{stroke['tool']}")
        self.choose("#from", stroke["start"])
        if stroke["tool"] != "arc":
            self.choose("#along", "angle")
            self.fill("#angle", stroke["angle"])
        if stroke["tool"] != "line":
            self.fill("#mm", stroke["r"])
        self.press("#do-draw")

    def mark(self) -> None:
        """The mark asked for: a vector, or two strokes and their crossing."""
        what, strokes = self.page.evaluate("practice.item.what"), self.page.evaluate(STROKES)
        for stroke in strokes:
            self.draw(stroke)
        if len(strokes) == 2 and self.page.evaluate("practice.item.what") == what:
            self.press("#tool-point")
            near = "desk.crossings().findIndex(p => practice.right(practice.item, p))"
            if self.page.locator("#spot").count():
                self.choose("#spot", str(self.page.evaluate(near)))
            self.press("#do-draw")

    def answer(self) -> None:
        """The question in hand."""
        kind = self.page.evaluate("practice.item.kind")
        if kind == "known":
            for name, times in self.page.evaluate("practice.goal(practice.equation).map(t => [t.name, t.known])"):
                self.to(f'[data-term="{name}"]')
                for _ in range(times):
                    self.page.keyboard.press("Enter")
            self.press("#do-check")
        elif kind in ("mu", "order", "reason", "first"):
            right = "practice.item.offered.findIndex(o => practice.right(practice.item, o.value))"
            self.press(f"#do-choose-{self.page.evaluate(right)}")
        elif kind == "number":
            self.to("#figure")
            self.page.keyboard.type(str(self.page.evaluate("practice.truth(practice.item)")))
            self.page.keyboard.press("Enter")
        elif kind == "sense":
            self.press("#do-ccw" if self.page.evaluate("practice.truth(practice.item)") > 0 else "#do-cw")
        else:
            self.mark()


@pytest.mark.slow
def test_practice_by_keys_alone_from_its_beginning_to_its_end(page: Any) -> None:
    """Every question is answered and every mark drawn with Tab, letters, arrows and Enter; the focus never leaves the
    task, and the whole is right."""
    page.focus("#practise")
    page.keyboard.press("Enter")
    keys = Keys(page)
    for _ in range(page.evaluate("practice.items.length")):
        now = page.evaluate("[practice.item.kind, practice.item.what]")
        keys.answer()
        assert page.evaluate("practice.said[0]") == "yes", now
        assert page.evaluate("practice.over || document.getElementById('task').contains(document.activeElement)"), now
    assert page.evaluate("[practice.over, practice.good]") == [True, page.evaluate("practice.items.length")]
    assert page.input_value("#code").startswith("planes-practice.")
