"""The lesson page in a real browser: stepping, the crank, languages, practice, printing; no error in the console."""

from __future__ import annotations

import re
from functools import partial
from pathlib import Path
from typing import Any

import pytest

from planes.drafting.drawing import draw_program
from planes.lesson import Teller, slot_value
from planes.lesson.data import lesson_data
from planes.lesson.formulas import LESSON_LANGS, fill_slots
from planes.lesson.told import SceneLesson
from planes.plans import plans_of
from planes.plans.scales import plan_scales
from planes.scene import load
from planes.solving import solve_position
from tests.helpers import ROOT
from tests.helpers.browser import until
from tests.helpers.lessons import lesson_opened, lesson_written

HERE = ROOT / "samples"
SIX = HERE / "six-link.yaml"
SAMPLES = [p for p in sorted(HERE.glob("*.yaml")) if p.stem != "vectors"]
WIDE = {"width": 1280, "height": 900}
MOST_CHANGES = 300  # of the page by one drawing of the six links: what is drawn stays, and only what moves is set


def test_step_through_to_the_end(page: Any) -> None:
    count = page.evaluate("data.frames.length")
    said = set()
    for k in range(count):
        assert page.inner_text("#number") == f"{k + 1} / {count}"
        said.add(page.inner_text("#sentence"))
        page.keyboard.press("ArrowRight")
    assert len(said) > 0.9 * count and page.is_disabled("#next")
    until(page, f"location.hash.startsWith('#step={count}&')")
    page.click("#back")
    assert page.inner_text("#number") == f"{count - 1} / {count}"
    page.keyboard.press("Home")
    assert page.is_disabled("#back")


def test_the_address_opens_a_frame(page: Any, lesson: str) -> None:
    page.goto("about:blank")
    page.goto(lesson + "#step=12&at=180&lang=en")
    assert page.inner_text("#number").startswith("12 /") and page.inner_text("#value") == "φ = 180°"
    assert page.inner_text("#sentence").startswith("Measure")


@pytest.mark.slow
def test_play_goes_on_by_itself(page: Any) -> None:
    page.click("#play")
    until(page, "document.getElementById('number').textContent.startsWith('2 /')")
    page.click("#play")
    assert page.inner_text("#play") == "▶▶"


@pytest.mark.few(1)
@pytest.mark.parametrize("value", [140, 150, 163.25, 180.5, 200, 303.125])
def test_what_is_shown_at_any_position_is_what_is_solved(page: Any, value: float) -> None:
    page.evaluate(f"state.frame = data.frames.length - 1; turn({value}); draw()")
    scene = load(str(SIX))
    plans = plans_of(scene.mechanism)
    drawn = solve_position(scene, plans, None, float(value), None, "en")
    mus = plan_scales(plans, scene.mu)
    shown = page.evaluate("Object.fromEntries(data.results.map(r => [r.name, number(live.value(r.value))]))")
    for name in ("2", "3"):
        for key in ("omega", "epsilon"):
            text = shown[f"{key}_{name}"].replace(",", ".").replace("−", "-")
            assert float(text) == pytest.approx(drawn.results["links"][name][key], rel=5.1e-4)
    for point, letter, plan in (("C", "v", "velocity"), ("H", "a", "acceleration"), ("C", "r", "position")):
        marks = plans.points[point]
        mark = {"v": marks.velocity, "a": marks.acceleration, "r": marks.position}[letter]
        x, y = page.evaluate(f'live.at("{mark}")')
        assert abs(complex(x, y) - complex(*drawn.results["points"][point][letter]) * mus[f"mu_{plan}"]) < 1e-6


@pytest.mark.slow
@pytest.mark.parametrize("name", ["six-link", "kind-3-rpr", "sliding-driver"])
def test_every_sentence_at_other_positions_has_the_numbers_reckoned_there(
    browser: Any, tmp_path: Path, name: str
) -> None:
    scene = load(str(HERE / f"{name}.yaml"))
    exported = lesson_data(scene)
    page = browser.new_page()
    page.goto(lesson_written(tmp_path, HERE / f"{name}.yaml", "en", exported))
    plans, drive = plans_of(scene.mechanism), exported["drive"]
    mus = {n: z for n, z in exported["home"].items() if n.startswith("mu_")}
    teller = Teller(plans, draw_program(plans.program, {**plans.given, **mus}))
    frames = SceneLesson.of(scene).frames
    teller.lesson_frames()
    for value in [drive["from"] + k * (drive["to"] - drive["from"]) / 17.3 for k in range(17)]:
        page.evaluate(f"live.set({{[data.drive.given]: {value!r}}})")
        if page.evaluate("live.failed"):
            continue
        there = draw_program(plans.program, {**plans.given, **mus, plans.drive_given_name: value})
        for lang in LESSON_LANGS:
            page.evaluate(f"state.lang = '{lang}'")
            shown = page.evaluate("data.frames.map(f => filled(inWords(f)))")
            read = partial(slot_value, teller=teller, drawing=there)
            assert shown == [fill_slots(f.words_with_rows[lang], read, lang) for f in frames]
    page.close()


@pytest.mark.slow
def test_the_crank_turns_everything(page: Any) -> None:
    page.evaluate("go(27)")
    shown = """["sentence", "scheme", "plan", "rates"].map(id => document.getElementById(id).innerHTML)"""
    before = page.evaluate(shown)
    page.evaluate("document.activeElement.blur()")
    page.focus("#crank")
    for _ in range(10):
        page.keyboard.press("ArrowRight")
    until(page, "document.getElementById('value').textContent === 'φ = 160°'")
    assert all(a != b for a, b in zip(before, page.evaluate(shown), strict=True))
    page.click("#home")
    until(page, "document.getElementById('value').textContent === 'φ = 150°'")


def test_where_the_method_fails_the_page_says_why(page: Any) -> None:
    assert page.locator("#zones i.bad").count() == 2 and page.locator("#zones i.blunt").count() >= 3
    page.evaluate("turn(250)")
    until(page, "document.getElementById('zone').textContent.includes('сходятся под углом')")
    page.evaluate("turn(40)")
    until(page, "document.getElementById('zone').className === 'bad'")
    assert "φ = 40°" in page.inner_text("#zone")


def test_a_number_that_is_typed_changes_everything(page: Any) -> None:
    page.evaluate("go(27)")
    page.click("#dims summary")
    before = page.inner_html("#plan")
    page.fill('#knobs input[type=text][data-given="l_BC"]', "0,32")
    until(page, "live.value('l_BC') === 0.32")
    page.fill("#exact", "163,25")
    page.keyboard.press("Enter")
    until(page, "document.getElementById('value').textContent === 'φ = 163,3°'")
    assert page.inner_html("#plan") != before
    until(page, "location.hash.includes('&at=163.25&') && location.hash.endsWith('&l_BC=0.32')")
    page.fill('#knobs input[type=text][data-given="l_BC"]', "0,05")
    until(page, "document.getElementById('zone').className === 'bad'")
    assert "l_BC" in page.inner_text("#zone") and not re.search("NaN|undefined", page.inner_text("main"))
    page.fill('#knobs input[type=text][data-given="l_BC"]', "-1")
    assert page.evaluate("live.given.l_BC") == 0.05
    until(page, "live.zones.some(z => z.kind === 'bad' && z.from <= live.drive && live.drive <= z.to)")  # looked at
    page.click("#home")
    until(page, "live.at_home && document.getElementById('zone').className === ''")


@pytest.mark.few(2)
@pytest.mark.parametrize(
    ("figure", "frame", "mark", "by", "free"),
    [
        ("scheme", 27, "position:C", (14, -9), ""),
        ("scheme", 27, "position:D", (-8, 11), ""),
        ("plan", 27, "acceleration:c'", (-12, 25), ""),
        ("plan", 15, "velocity:c", (9, 7), "l_DC"),
        ("plan", 58, "force:2-3:G_2", (0, -15), ""),
    ],
)
def test_the_mechanism_follows_what_is_dragged(page: Any, figure, frame, mark, by, free) -> None:
    page.evaluate(f"go({frame}); document.getElementById('free').value = '{free}'")
    box = page.locator(f"#{figure}").bounding_box()
    x, y = page.evaluate(f"{figure}.px(live.at({mark!r}))")
    page.mouse.move(box["x"] + x, box["y"] + y)
    page.mouse.down()
    for k in range(1, 9):
        page.mouse.move(box["x"] + x + by[0] * k / 8, box["y"] + y + by[1] * k / 8)
    wanted = page.evaluate(f"{figure}.mm([{x + by[0]}, {y + by[1]}])")
    page.mouse.up()
    found = page.evaluate(f"live.at({mark!r})")
    assert abs(complex(*found) - complex(*wanted)) < 0.01
    assert "изменяем" in page.inner_text("#follow") and not page.evaluate("live.at_home")


def test_what_cannot_follow_says_by_how_much(page: Any) -> None:
    page.evaluate("go(15); document.getElementById('free').value = 'm_5'")
    short = page.evaluate("drag(plan, 'velocity:c', live.at('velocity:c').map(v => v + 40))")
    assert short > 0.01 and "не хватает" in page.inner_text("#follow")
    assert str(round(short, 2)).replace(".", ",") in page.inner_text("#follow")
    assert "стоит на месте" in page.evaluate(
        "drag(plan, 'velocity:p', [9, 9]), document.getElementById('follow').innerText"
    )


def test_near_a_dead_point_another_scale_is_offered(page: Any) -> None:
    page.evaluate("go(56); turn(304.5); draw()")
    assert "другой масштаб" in page.inner_text("#large")
    longest = "Math.max(...plan.own('force:2-3').map(n => Math.hypot(...live.at(n))))"
    before = page.evaluate(longest)
    page.click("#large button")
    until(page, "document.getElementById('large').innerText === ''")
    assert page.evaluate(longest) < before / 100


def test_the_language_switches_everything(page: Any) -> None:
    page.evaluate("go(15)")
    assert page.inner_text("#lang") == "English" and re.search("[а-я]", page.inner_text("main"))
    page.click("#lang")
    assert page.evaluate("document.documentElement.lang") == "en" and page.title() == "Six-link lever mechanism"
    until(page, "!/[а-яА-ЯёЁ]/.test(document.querySelector('main').innerText)")  # what is read aloud waits a little
    assert page.get_attribute("#next", "aria-label") == "Next"


def test_a_name_lights_its_term_its_segment_and_its_link(page: Any) -> None:
    page.evaluate("go(24)")
    page.hover('#equations [data-name="a_CB^n"]')
    until(page, "document.querySelectorAll('#plan .arrow.hover').length === 1")
    page.evaluate("draw()")  # as a change of size does
    assert page.locator("#plan .arrow.hover").count() == 1
    assert page.locator('#scheme [data-name="link:2"].hover').count() >= 2
    page.mouse.move(2, 2)
    until(page, "!document.querySelector('.hover')")


def test_labels_keep_clear_of_each_other(page: Any) -> None:
    crowded = page.evaluate("""() => {
        let bad = 0;
        for (let k = 0; k < data.frames.length; k++) {
            go(k);
            for (const f of [scheme, plan]) (f.taken || []).forEach((a, i) => f.taken.slice(0, i).forEach(b => {
                if (Math.abs(a[0] - b[0]) < a[2] + b[2] - 2 && Math.abs(a[1] - b[1]) < 13) bad++;
            }));
        }
        return bad;
    }""")
    assert crowded <= 2


@pytest.mark.slow
def test_it_prints_a_page_a_plan_at_the_position_shown(page: Any, tmp_path: Path) -> None:
    import pypdfium2

    target = tmp_path / "handout.pdf"
    page.evaluate("turn(170); handout()")
    page.pdf(path=str(target), prefer_css_page_size=True)
    paper = pypdfium2.PdfDocument(str(target))
    size = paper[0].get_size()
    assert size[0] == pytest.approx(595, abs=2) and size[1] == pytest.approx(842, abs=2)
    plans = page.evaluate("new Set(data.frames.map(f => f.plan)).size")
    assert page.locator("#handout article").count() == plans == len(paper)
    assert page.locator("#handout li").count() == page.evaluate("data.frames.length")
    long = """() => {
        const plan = document.querySelector('#handout article:nth-child(2)');
        const at = n => plan.querySelector(`.arrow[data-name~="${n}"] polygon`);
        const tip = n => at(n).getAttribute('points').split(' ')[0].split(',').map(Number);
        const [b, c] = ['v_B', 'v_C'].map(tip);
        return Math.hypot(b[0] - c[0], b[1] - c[1]) / 96 * 25.4; }"""
    true = "Math.hypot(...[0, 1].map(k => live.at('velocity:b')[k] - live.at('velocity:c')[k]))"
    assert page.evaluate(long) == pytest.approx(page.evaluate(true), abs=0.1)  # in the paper's own millimetres
    text = "".join(p.get_textpage().get_text_range() for p in paper)
    assert "план ускорений" in text.lower() and "φ = 170°" in text


@pytest.mark.slow
def test_on_a_telephone_nothing_runs_off_the_page(page: Any) -> None:
    page.set_viewport_size({"width": 390, "height": 844})
    for k in (5, 20, 34, 43, 50):
        page.evaluate(f"go({k})")
        assert page.evaluate("document.documentElement.scrollWidth") <= 390
        box = page.locator("#sentence").bounding_box()
        assert box and box["y"] < 700


@pytest.mark.few(0, slow=5)
@pytest.mark.parametrize("path", SAMPLES, ids=[p.stem for p in SAMPLES])
def test_every_sample_steps_and_turns_without_complaint(browser: Any, tmp_path: Path, path: Path) -> None:
    with lesson_opened(browser, lesson_written(tmp_path, path, "en")) as page:
        page.evaluate("data.frames.forEach((_, k) => go(k))")
        page.evaluate(
            "const { from, to } = data.drive; "
            "for (let k = 0; k < 72; k++) { turn(from + k * (to - from) / 71.7); draw(); }"
        )
        page.evaluate(
            "practice.toggle(); data.practice.forEach((_, k) => { practice.take(k); "
            "for (const n of TOOLS) task.pick('tool', { dataset: { tool: n } }); })"
        )
        page.evaluate("practice.toggle(); handout()")
        assert not page.evaluate("/NaN|undefined/.test(document.querySelector('main').innerHTML)")


@pytest.mark.slow
def test_a_turn_of_the_crank_draws_little(browser: Any, lesson: str) -> None:
    """One position makes so few new nodes and attributes that any machine turns the crank smoothly."""
    page = browser.new_page()
    page.goto(lesson)
    made = page.evaluate("""async () => {
        go(24);
        let work = 0;
        const looker = new MutationObserver(seen => seen.forEach(r => { work += r.addedNodes.length || 1; }));
        looker.observe(document.body, { childList: true, subtree: true, attributes: true });
        for (let k = 0; k < 20; k++) { turn(5 * k); draw(); await new Promise(done => setTimeout(done)); }
        return work / 20;
    }""")
    page.close()
    assert 0 < made < MOST_CHANGES


def test_where_nothing_can_be_drawn_no_step_is_told(page: Any) -> None:
    page.evaluate("go(40); turn(40); draw()")
    assert "не собирается" in page.inner_text("#sentence") and not page.inner_text("#why")
    page.evaluate("turn(150); draw()")
    assert page.inner_text("#why")
